"""Copies without names, serial numbers and remarks: nothing of a secret that stood anywhere is left,
and every number is.

Judged from outside: the bytes of the copies are searched in every usual encoding, workbooks are
opened by openpyxl and zipfile, numbers are compared by the csv module and by the second readers.
"""

from __future__ import annotations

import csv
import html
import json
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from io import BytesIO
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.foundations.redaction import Cuts, Names, left_over
from compwright.instruments.redaction import measurement
from compwright.instruments.redaction.cutting import redacted_lines
from compwright.instruments.spans import SpansOf
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile
from compwright.workflow.commands.redact import RedactedFile, RedactOutcome, redaction_lines
from one_test import read_positioning
from places import REAL, needs_shared
from redaction_cases import case, samples
from redaction_samples import (
    BALLBAR,
    CONTROLS,
    FOREIGN,
    NAMED,
    NAMED_PROFILE,
    PLAIN,
    SECRETS,
    filled,
)
from sinumerik_container import ACTIVE, container

openpyxl = pytest.importorskip("openpyxl")


def readable(content: bytes) -> Iterator[str]:
    """Everything that somebody could read in a file."""
    parts = [content]
    if content.startswith(b"PK"):
        with zipfile.ZipFile(BytesIO(content)) as archive:
            parts += [
                part for name in archive.namelist() for part in (name.encode(), archive.read(name))
            ]
            parts.append(archive.comment)
    for part in parts:
        for encoding in ("utf-8", "cp1252", "utf-16-le", "utf-16-be"):
            text = part.decode(encoding, errors="replace")
            yield from (text.casefold(), html.unescape(text).casefold(), unquote(text).casefold())


def told(content: bytes) -> list[str]:
    """The secrets that stand in a file."""
    texts = list(readable(content))
    return [secret for secret in SECRETS if any(secret in text for text in texts)]


def visible(folder: Path) -> list[str]:
    """The names of the files in a folder, hidden ones left out."""
    return sorted(path.name for path in folder.iterdir() if not path.name.startswith("."))


def workbook() -> bytes:
    """A workbook with a secret at every place of it."""
    from openpyxl.comments import Comment
    from openpyxl.workbook.defined_name import DefinedName

    free, word = filled("{S}").decode(), filled("{W}").decode()
    book = openpyxl.Workbook()
    sheet = book.active
    sheet.title = word
    for row in (
        [f"# machine: {free}"], ["# serial", word], ["# axis: X"],
        ["target_mm", "direction", "run", "deviation_um", free],
        [0.5, "+", 1, 0.4, free], [100.25, "+", 1, 2.125, 48151623],
        [100.25, "-", 1, -1.6, word], [0.5, "-", 1, -2.9, "x"], [f"# {free}"],
    ):  # fmt: skip
        sheet.append(row)
    sheet["A5"].comment = Comment(free, word)
    sheet["A5"].hyperlink = f"https://{word}.example/x"
    sheet["B5"].number_format = f'0.0" {word}"'
    sheet.oddHeader.center.text = free
    hidden = book.create_sheet(f"x {word}"[:31])
    hidden.sheet_state = "hidden"
    hidden["A1"] = free
    book.defined_names[word] = DefinedName(word, attr_text="$A$1")
    for key in ("creator", "title", "description", "keywords", "lastModifiedBy", "category"):
        setattr(book.properties, key, free)
    out = BytesIO()
    book.save(out)
    return out.getvalue()


@pytest.fixture(scope="module")
def copied(tmp_path_factory: pytest.TempPathFactory) -> dict[str, tuple[Path, Path]]:
    """Every sample redacted: (folder of the originals, folder of the copies) by kind."""
    top = tmp_path_factory.mktemp("redact")
    files = {
        "plain": {f"{name}.csv": filled(text) for name, text in PLAIN.items()},
        "foreign": {"a.csv": filled(FOREIGN), "b.csv": filled(FOREIGN, "cp1252"),
                    "c.csv": filled(FOREIGN, "utf-16")},
        "named": {"n.csv": filled(NAMED)},
        "ballbar": {"a.b5r": filled(BALLBAR)},
        "excel": {"x.xlsx": workbook()},
        **{
            kind: {name: filled(text, "utf-8" if kind == "sheet" else "latin-1")
                   for name, text in texts.items()}
            for kind, texts in CONTROLS.items()
        },
    }  # fmt: skip
    (top / "p.yaml").write_bytes(filled(NAMED_PROFILE))
    folders = {}
    for kind, contents in files.items():
        folder, out = top / kind, top / f"{kind}-out"
        folder.mkdir()
        for name, content in contents.items():
            (folder / name).write_bytes(content)
        profile = ["--profile", str(top / "p.yaml")] if kind == "named" else []
        assert compwright(["redact", str(folder), "--out", str(out), *profile]) == 0, kind
        folders[kind] = (folder, out)
    return folders


KINDS = ["plain", "foreign", "named", "ballbar", "excel", *CONTROLS]


@pytest.mark.parametrize("kind", KINDS)
def test_no_secret_is_left_in_a_copy_and_none_lacks(
    copied: dict[str, tuple[Path, Path]], kind: str
) -> None:
    folder, out = copied[kind]
    originals = {path.name for path in folder.iterdir()}
    copies = {path.name: path.read_bytes() for path in out.iterdir()}  # the hidden list too
    assert originals <= copies.keys()
    assert all(told((folder / name).read_bytes()) for name in originals)  # the search finds them
    assert {name: told(content) for name, content in copies.items() if told(content)} == {}


def numbers(path: Path, columns: tuple[str, ...]) -> list[tuple[str, ...]]:
    lines = [
        line for line in path.read_text("utf-8").splitlines() if not line.startswith(("#", '"#'))
    ]
    mark = ";" if ";" in lines[0] else ","
    return [
        tuple(row[column] for column in columns) for row in csv.DictReader(lines, delimiter=mark)
    ]


@pytest.mark.parametrize(
    ("name", "columns"),
    [
        ("long", ("target_mm", "direction", "run", "deviation_um")),
        ("quoted", ("target_mm", "direction", "run", "deviation_um")),
        ("wide", ("target_mm", "+1", "-1", "+2", "-2")),
        ("circle", ("direction", "angle_deg", "deviation_um")),
        ("still", ("time_min", "deviation_um")),
    ],
)
def test_every_number_of_a_csv_stays_as_it_was_written(
    copied: dict[str, tuple[Path, Path]], name: str, columns: tuple[str, ...]
) -> None:
    folder, out = copied["plain"]
    assert numbers(out / f"{name}.csv", columns) == numbers(folder / f"{name}.csv", columns)


def test_key_lines_that_count_stay(copied: dict[str, tuple[Path, Path]]) -> None:
    text = (copied["plain"][1] / "circle.csv").read_text("utf-8")
    for line in ("# plane: XY", "# nominal_radius_mm: 150", "# centre: 1, 2, 3"):
        assert line in text.splitlines()


def test_the_profile_beside_a_copy_reads_it_without_a_name(
    copied: dict[str, tuple[Path, Path]], tmp_path: Path
) -> None:
    out = copied["named"][1]
    profile = out / "n.profile.yaml"
    answer = tmp_path / "a.json"
    words = ["evaluate", str(out / "n.csv"), "--profile", str(profile), "--json", str(answer)]
    assert compwright(words) == 0
    (result,) = json.loads(answer.read_text())["results"]
    assert [entry["deviations_positive"] for entry in result["targets"]] == [[0.4], [2.1]]
    assert [entry["deviations_negative"] for entry in result["targets"]] == [[-2.9], [-0.8]]


def test_a_workbook_holds_its_cells_and_nothing_else(
    copied: dict[str, tuple[Path, Path]],
) -> None:
    copy = copied["excel"][1] / "x.xlsx"
    with zipfile.ZipFile(copy) as archive:
        assert sorted(archive.namelist()) == [
            "[Content_Types].xml", "_rels/.rels", "xl/_rels/workbook.xml.rels", "xl/workbook.xml",
            "xl/worksheets/sheet1.xml",
        ]  # fmt: skip
    book = openpyxl.load_workbook(copy)
    assert len(book.worksheets) == 1
    rows = list(book.worksheets[0].iter_rows(min_row=4, max_row=8, max_col=4, values_only=True))
    assert rows == [
        ("target_mm", "direction", "run", "deviation_um"),
        (0.5, "+", 1, 0.4), (100.25, "+", 1, 2.125), (100.25, "-", 1, -1.6), (0.5, "-", 1, -2.9),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("kind", "control", "options", "address", "where"),
    [
        ("fanuc", "fanuc-30i", {"detection_unit": 0.001}, "1", (-260.0, -100.0, 30.0)),
        ("sinumerik", "siemens-840d-sl", {}, "AX1", (-50.0, 10.0, 50.0)),
        ("linuxcnc", "linuxcnc", {}, "0", (-200.0, 50.0, 200.0)),
        ("pmac", "pmac", {"counts_per_unit": 1000}, "1", (0.0, 55.0, 210.0)),
    ],
)
def test_a_control_would_do_the_same_with_the_copies(
    copied: dict[str, tuple[Path, Path]],
    kind: str,
    control: str,
    options: dict[str, object],
    address: str,
    where: tuple[float, ...],
) -> None:
    old, new = (
        virtual_control(
            control,
            [ControlFile(name, (folder / name).read_bytes()) for name in visible(folder)],
            options=options,
            axes_under_work=(address,),
        )
        for folder in copied[kind]
    )
    for direction in Direction:
        before, after = (one.correction(address, np.array(where), direction) for one in (old, new))
        assert np.any(before != 0.0)
        assert np.array_equal(before, after)


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("heidenhain", ["--format", "heidenhain-itnc530"]),
        ("isg", ["--format", "isg-kernel", "--option", "encoder_increment=0.0001"]),
        ("sinumerik", ["--format", "siemens-840d-sl"]),
    ],
)
def test_what_is_decoded_of_a_copy_is_what_its_original_says(
    copied: dict[str, tuple[Path, Path]],
    capsys: pytest.CaptureFixture[str],
    kind: str,
    words: list[str],
) -> None:
    answers = []
    for folder in copied[kind]:
        assert compwright(["decode", str(folder), *words, "--json", "-"]) == 0
        answers.append(json.loads(capsys.readouterr().out)["axes"])
    assert answers[0] == answers[1]
    assert any(any(axis["correction_positive"]) for axis in answers[0].values())


def test_the_same_name_gets_the_same_word_in_all_files(tmp_path: Path) -> None:
    for name, machine in (("a", "VMC Halle 3"), ("b", "vmc  halle 3"), ("c", "Other")):
        text = f"# machine: {machine}\ntarget_mm,+1,-1\n" + "# unit: um\n"
        (tmp_path / f"{name}.csv").write_text(text + "0,1,2\n100,1,3\n")
    words = [str(tmp_path / f"{name}.csv") for name in "abc"]
    assert compwright(["redact", *words, "--out", str(tmp_path / "out")]) == 0
    said = [(tmp_path / "out" / f"{name}.csv").read_text().splitlines()[0] for name in "abc"]
    assert said == ["# machine: redacted_1", "# machine: redacted_1", "# machine: redacted_2"]


def test_a_second_copy_is_the_same(copied: dict[str, tuple[Path, Path]], tmp_path: Path) -> None:
    folder, out = copied["fanuc"]
    assert compwright(["redact", str(folder), "--out", str(tmp_path / "again")]) == 0
    for path in out.iterdir():
        assert (tmp_path / "again" / path.name).read_bytes() == path.read_bytes()


def test_what_is_not_known_is_refused_by_name_and_the_rest_is_copied(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.csv").write_bytes(filled(PLAIN["long"]))
    (tmp_path / "letter.txt").write_bytes(filled("Dear {S}, the machine is fine.\n"))
    (tmp_path / "all.arc").write_bytes(b"@@MMCIBN.002" + b"\0" * 512)
    (tmp_path / "x.zip").write_bytes(b"7z\xbc\xaf\x27\x1c" + b"\0" * 99)
    words = [str(tmp_path / name) for name in ("a.csv", "letter.txt", "all.arc", "x.zip")]
    assert compwright(["redact", *words, "--out", str(tmp_path / "out")]) == 3
    assert visible(tmp_path / "out") == ["a.csv"]
    said = [line for line in capsys.readouterr().err.splitlines() if line.startswith("error")]
    for name in ("letter.txt", "all.arc", "x.zip"):
        assert len([line for line in said if name in line]) == 1
    assert "AX_EEC" in next(line for line in said if "all.arc" in line)


def test_an_archive_gives_its_texts_and_they_read_as_the_archive(tmp_path: Path) -> None:
    texts = CONTROLS["sinumerik"]
    axes = texts["AX_EEC.INI"].replace("%_N_AX_EEC_INI\n", "")
    packed = container(
        [
            (ACTIVE, "AX_EEC.INI", filled(axes, "latin-1")),
            (ACTIVE, "INITIAL.INI", filled(texts["AX1_MD.INI"], "latin-1")),
            ("\\MPF.DIR\\", "SECRET.MPF", filled("G1 X1 ;{S}\n", "latin-1")),
        ]
    )
    (tmp_path / "nc.arc").write_bytes(packed)
    for name, text in CONTROLS["fanuc"].items():  # of another control, and more of it
        (tmp_path / name).write_bytes(
            filled(text.replace("%\n(", "N10100Q0P1\n" * 99 + "("), "latin-1")
        )
    out = tmp_path / "out"
    assert told(packed) != []
    words = [str(tmp_path / name) for name in ("CNC-PARA.TXT", "PITCH.TXT", "nc.arc")]
    assert compwright(["redact", *words, "--out", str(out)]) == 0
    assert visible(out / "nc") == ["AX_EEC.INI", "INITIAL.INI"]
    assert [told((out / "nc" / name).read_bytes()) for name in visible(out / "nc")] == [[], []]
    answers = []
    for number, given in enumerate((tmp_path / "nc.arc", out / "nc")):
        answer = tmp_path / f"{number}.json"
        words = ["decode", str(given), "--format", "siemens-840d-sl", "--json", str(answer)]
        assert compwright(words) == 0
        answers.append(json.loads(answer.read_text())["axes"])
    assert answers[0] == answers[1]
    assert any(answers[0]["AX1"]["correction_positive"])


def test_names_of_files_that_hold_a_text_or_a_serial_number_change(tmp_path: Path) -> None:
    text = "# machine: Kranich\n# unit: um\ntarget_mm,+1,-1\n0,1,2\n100,1,3\n"
    for name in ("kranich_x.csv", "sn4711081.csv", "x_20260302.csv", "y.csv"):
        (tmp_path / name).write_text(text)
    assert compwright(["redact", str(tmp_path), "--out", str(tmp_path / "out")]) == 0
    assert visible(tmp_path / "out") == [
        "redacted_2.csv",
        "redacted_3.csv",
        "x_20260302.csv",
        "y.csv",
    ]


def test_a_table_of_bare_numbers_stays(tmp_path: Path) -> None:
    rows = b"-200 -200.0080 -199.9960\n0 0.0000 0.0120\n200 200.0100 200.0230\n"
    (tmp_path / "x.comp").write_bytes(rows)
    assert compwright(["redact", str(tmp_path / "x.comp"), "--out", str(tmp_path / "out")]) == 0
    assert (tmp_path / "out" / "x.comp").read_bytes() == rows


def test_a_file_that_another_names_is_found_under_its_new_name(tmp_path: Path) -> None:
    folder, out = tmp_path / "control", tmp_path / "out"
    folder.mkdir()
    texts = CONTROLS["linuxcnc"]
    (folder / "Vogt.comp").write_bytes(filled(texts["x.comp"]))
    ini = texts["machine.ini"].replace("{W}/x.comp", "{W}/Vogt.comp")
    (folder / "machine.ini").write_bytes(filled(ini))
    assert compwright(["redact", str(folder), "--out", str(out)]) == 0
    (table,) = [name for name in visible(out) if name.endswith(".comp")]
    assert "vogt" not in table.casefold()
    assert f"COMP_FILE = {table}\n" in (out / "machine.ini").read_text()
    assert compwright(["decode", str(out), "--format", "linuxcnc"]) == 0


def test_the_answer_names_kinds_and_counts_and_never_the_texts(
    copied: dict[str, tuple[Path, Path]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, _ = copied["plain"]
    file = folder / "long.csv"
    assert compwright(["redact", str(file), "--out", str(tmp_path / "a"), "--json", "-"]) == 0
    said = capsys.readouterr().out
    (entry,) = json.loads(said)["files"]
    assert entry["removed"]["machine"] == entry["removed"]["serial number"] == 1
    assert compwright(["redact", str(file), "--out", str(tmp_path / "b")]) == 0
    plain = capsys.readouterr().out
    assert "1 serial number" in plain
    assert "Look at the names" in plain
    assert not [secret for secret in SECRETS if secret in (said + plain).casefold()]
    assert compwright(["redact", str(file), "--out", str(tmp_path / "c"), "--show"]) == 0
    assert "Mühlbauer" in capsys.readouterr().out


def test_originals_are_never_touched(tmp_path: Path) -> None:
    file = tmp_path / "a.csv"
    file.write_bytes(filled(PLAIN["long"]))
    before = file.read_bytes()
    assert compwright(["redact", str(file), "--out", str(tmp_path), "--force"]) == 5
    assert [path.name for path in tmp_path.iterdir()] == ["a.csv"]
    assert file.read_bytes() == before


def test_copies_are_replaced_with_force_alone(tmp_path: Path) -> None:
    file, out = tmp_path / "a.csv", tmp_path / "out"
    file.write_bytes(filled(PLAIN["long"]))
    words = ["redact", str(file), "--out", str(out)]
    assert compwright(words) == 0
    assert compwright(words) == 5
    assert compwright([*words, "--force"]) == 0
    (out / "a.csv").write_text("my own notes")  # not what redact wrote
    assert compwright([*words, "--force"]) == 5
    assert (out / "a.csv").read_text() == "my own notes"


@pytest.mark.parametrize("broken", ["a number", "a cycle", "a text"])
def test_a_copy_that_does_not_prove_right_is_not_written(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    broken: str,
) -> None:
    right = redacted_lines

    def wrong(lines: Sequence[str], spans_of: SpansOf, cuts: Cuts) -> list[str]:
        made = right(lines, spans_of, cuts)
        if broken == "a number":
            return [line.replace("2.1", "2.2") for line in made]
        if broken == "a cycle":
            return [made[0], "# cycle: step", *made[2:]]
        return [*made[:-1], "# m%C3%BChlbauer"]

    monkeypatch.setattr(measurement, "redacted_lines", wrong)
    file = tmp_path / "a.csv"
    file.write_bytes(filled(PLAIN["long"]))
    assert compwright(["redact", str(file), "--out", str(tmp_path / "out")]) == 3
    assert not (tmp_path / "out").exists()
    where = "a.csv: " if broken != "a text" else "a.csv: line 18: "
    assert f"{where}the file was not copied" in capsys.readouterr().err


@pytest.mark.parametrize(
    "copy",
    [
        "x MÜHLBAUER y".encode(), "m\xfchlbauer".encode("cp1252"), "Mühlbauer".encode("utf-16"),
        b"M&#xfc;hlbauer", b"M%C3%BChlbauer", b"no 48151623!",
    ],
)  # fmt: skip
def test_what_is_left_over_is_found_in_any_form(copy: bytes) -> None:
    company = "Fa. Mühlbauer, 48151623"
    assert left_over([company], [copy], frozenset()) == [company]
    assert left_over([company], [b"deviation of 2026"], frozenset()) == []


def test_a_name_has_one_number_whatever_its_case() -> None:
    names = Names()
    cuts = Cuts(names)
    assert [cuts.name(text) for text in ("A b", "a  B", "c")] == [
        "redacted_1", "redacted_1", "redacted_2",
    ]  # fmt: skip


@pytest.fixture(scope="module")
def sets() -> dict[str, Mapping[str, str]]:
    return samples()


@pytest.mark.parametrize("number", range(24))
def test_a_secret_at_any_place_is_in_no_copy(
    sets: dict[str, Mapping[str, str]], number: int
) -> None:
    outcome, about = case(sets, number)
    assert outcome in {"clean", "refused"}, about


#: Names, places and numbers that stand in the real files.
_REAL = {
    "ballbar": (
        "6gae75",
        "2cme78",
        "31928",
        "vorlage",
        "volumetric examples",
        "mock",
        "watchtower",
    ),
    "positioning": ("ioc_test", "m0s00", "sandst", "/afs", "psi.ch", "github", "ecatmc", "ild"),
}


@needs_shared
@pytest.mark.parametrize("kind", sorted(_REAL))
def test_real_files_lose_what_names_somebody(tmp_path: Path, kind: str) -> None:
    files = sorted(p for p in (REAL / kind).iterdir() if p.suffix in {".b5r", ".dat"})
    assert compwright(["redact", *map(str, files), "--out", str(tmp_path / "out")]) == 0
    copies = visible(tmp_path / "out")
    assert len(copies) == len(files)
    for copy in copies:
        texts = list(readable((tmp_path / "out" / copy).read_bytes()))
        assert [word for word in _REAL[kind] if any(word in text for text in texts)] == []


@needs_shared
def test_real_parameters_stay_to_the_last_digit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("CNC-PARA.TXT", "PITCH.TXT"):
        whole = (REAL / "fanuc" / name).read_bytes()
        (tmp_path / name).write_bytes(whole[: whole.rfind(b"\n", 0, 40_000) + 1])  # lines enough
    words = ["CNC-PARA.TXT", "PITCH.TXT", "--format", "fanuc-30i", "--out", "out"]
    monkeypatch.chdir(tmp_path)
    assert compwright(["redact", *words]) == 0
    for name in words[:2]:
        assert (tmp_path / "out" / name).read_bytes() == (tmp_path / name).read_bytes()


def test_readings_of_a_copy_are_those_of_its_original(
    copied: dict[str, tuple[Path, Path]],
) -> None:
    for name in ("rtl", "pos", "ren", "tgt"):
        old, new = (
            read_positioning((folder / f"{name}.csv").read_bytes(), name)
            for folder in copied["plain"]
        )
        for one in ("targets", "positive", "negative"):
            assert np.array_equal(getattr(old, one), getattr(new, one)), name


def test_what_was_taken_out_is_counted_in_words() -> None:
    removed = {"comment": 1, "row next to the table": 3, "serial number": 2}
    removed["text behind a value"] = 1
    one = RedactedFile(file=Path("a"), copy=Path("b"), taken_for="measurement", removed=removed)
    first, *_ = redaction_lines(RedactOutcome(files=(one,), faults=(), written=()))
    assert first.endswith(
        "taken out: 1 comment, 3 rows next to the table, 2 serial numbers, 1 text behind a value"
    )
