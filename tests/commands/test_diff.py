"""diff: of two backups of one machine every change is named in the control's words, and nothing
else is.

Known single changes are made to two real backups and to complete examples of every control. What a
change does to the correction is worked out by hand from the facts of the control.
"""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.formats.definition.schema import Definition
from compwright.formats.families.shapes import control_format
from compwright.formats.text.file_values import changes, texts_of
from compwright.records.correction import ControlFile
from fanuc_backup import parameters, pitch_data
from format_samples import DEFINITIONS
from places import REAL
from sinumerik_archive import ARCHIVE, cec_text, eec_text, machine_data, needs_archive

pytestmark = pytest.mark.short_estimate

FANUC = REAL / "fanuc"
needs_backup = pytest.mark.skipif(
    not FANUC.is_dir(), reason="the real FANUC backup is not beside the project"
)
Files = Mapping[str, bytes]


def diff(
    folder: Path, old: Files, new: Files, control: str, options: Mapping[str, Any] | None = None
) -> tuple[int, dict[str, Any]]:
    for name, files in (("old", old), ("new", new)):
        (folder / name).mkdir(parents=True)
        for file, content in files.items():
            (folder / name / file).write_bytes(content)
    words = ["diff", str(folder / "old"), "--with", str(folder / "new"), "--format", control]
    for key, value in (options or {}).items():
        words += ["--option", f"{key}={value}"]
    answer = folder / "diff.json"
    code = compwright([*words, "--json", str(answer)])
    document: dict[str, Any] = json.loads(answer.read_text()) if answer.exists() else {}
    return code, document


def entries(document: dict[str, Any]) -> dict[str, tuple[str | None, str | None]]:
    """Every entry that is named, with its old and its new value."""
    listed = [
        *(entry for axis in document["axes"].values() for entry in axis["entries"]),
        *document["machine"],
        *(entry for group in document["other"] for entry in group["examples"]),
    ]
    return {entry["quantity"]: (entry["old"], entry["new"]) for entry in listed}


def changed(files: Files, name: str, old: str, new: str) -> dict[str, bytes]:
    content = files[name]
    assert content.count(old.encode()) == 1, f"{old} stands {content.count(old.encode())} times"
    return {**files, name: content.replace(old.encode(), new.encode())}


# --- the real backup of a FANUC: detection unit 0.0001 mm, magnification 10 on X (axis 1)


@pytest.fixture(scope="module")
def fanuc() -> dict[str, bytes]:
    return {name: (FANUC / name).read_bytes() for name in ("CNC-PARA.TXT", "PITCH.TXT")}


@needs_backup
def test_line_ends_order_and_blanks_are_no_difference(
    fanuc: dict[str, bytes], tmp_path: Path
) -> None:
    lines = fanuc["CNC-PARA.TXT"].split(b"\n")
    turned = [lines[0], *reversed(lines[1:-1]), lines[-1]]
    new = {
        "PITCH.TXT": fanuc["PITCH.TXT"].replace(b"\n", b"\n\r\r"),
        "CNC-PARA.TXT": b"\r\n".join(line.rstrip() + b"\r\n" for line in turned),
    }
    code, answer = diff(tmp_path, fanuc, new, "fanuc-30i")
    assert (code, answer["schema"], answer["same"]) == (0, "compwright/diff/1", True)
    assert (answer["axes"], answer["machine"], answer["other"], answer["cross"]) == ({}, [], [], [])


def point(number: int, new: int) -> Callable[[Files], dict[str, bytes]]:
    def change(files: Files) -> dict[str, bytes]:
        pattern = rf"(?m)^N1{number:04d}Q0P-?\d+".encode()
        text, count = re.subn(
            pattern, f"N1{number:04d}Q0P{new}".encode(), files["PITCH.TXT"], count=1
        )
        assert count == 1
        return {**files, "PITCH.TXT": text}

    return change


def parameter(old: str, new: str) -> Callable[[Files], dict[str, bytes]]:
    return lambda files: changed(files, "CNC-PARA.TXT", old, new)


#: A change -> the axis, the entry with its values, the largest change of the correction in µm (None:
#: none), and a word of its meaning.
FANUC_CHANGES: dict[
    str,
    tuple[Callable[[Files], dict[str, bytes]], str, str, tuple[str, str], float | None, str],
] = {
    # five steps more, times 10, times 0.1 µm
    "a point of X": (point(5, 4), "1", "N10005Q0", ("-1", "4"), 5.0, "point"),
    "the backlash of X": (
        parameter("N01851Q1A1P40A2", "N01851Q1A1P41A2"),
        *("1", "N01851Q1A1", ("40", "41"), 0.1, "backlash"),
    ),
    "inclination of Y": (
        parameter("N05861Q1A1P0A2P0", "N05861Q1A1P0A2P120"),
        *("2", "N05861Q1A2", ("0", "120"), None, "inclination"),
    ),
    "a cyclic table of Z": (
        parameter("N14986Q1A1P0A2P0A3P0", "N14986Q1A1P0A2P0A3P9"),
        *("3", "N14986Q1A3", ("0", "9"), None, "cyclic"),
    ),
    "the reference of Z": (
        parameter("N01240Q1A1P0.0A2P0.0A3P0.0", "N01240Q1A1P0.0A2P0.0A3P1.0"),
        *("3", "N01240Q1A3", ("0.0", "1.0"), None, "reference"),
    ),
}


@needs_backup
@pytest.mark.parametrize("name", FANUC_CHANGES)
def test_a_change_in_a_real_backup_is_named_and_nothing_else_is(
    fanuc: dict[str, bytes], tmp_path: Path, name: str
) -> None:
    change, axis, entry, values, most, meaning = FANUC_CHANGES[name]
    code, answer = diff(tmp_path, fanuc, change(fanuc), "fanuc-30i")
    assert (code, answer["same"]) == (1, False)
    assert entries(answer) == {entry: values}
    (found,) = answer["axes"][axis]["entries"]
    assert meaning in found["meaning"]
    if most is not None:
        assert list(answer["axes"]) == [axis]
        assert abs(answer["axes"][axis]["correction"]["max_change_um"]) == pytest.approx(most)


@needs_backup
def test_a_point_stands_at_its_position(fanuc: dict[str, bytes], tmp_path: Path) -> None:
    """Number 5 of X, 35 intervals of 40 mm before the reference's 40."""
    _, answer = diff(tmp_path, fanuc, point(5, 4)(fanuc), "fanuc-30i")
    assert answer["axes"]["1"]["entries"][0]["at"] == pytest.approx(-1400)
    assert answer["axes"]["1"]["name"] == "X"


@needs_backup
def test_what_compensates_nothing_is_counted_apart(fanuc: dict[str, bytes], tmp_path: Path) -> None:
    new = parameter("N00100Q1P00001100", "N00100Q1P00001101")(fanuc)
    code, answer = diff(tmp_path, fanuc, new, "fanuc-30i")
    assert code == 1
    assert answer["axes"] == {}
    (group,) = answer["other"]
    assert (group["quantity"], group["changed"], group["only_old"], group["only_new"]) == (
        *("100", 1, 0, 0),
    )


@needs_backup
def test_a_file_that_is_missing_is_a_difference_and_stays_a_page(
    fanuc: dict[str, bytes], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    new = {"PITCH.TXT": fanuc["PITCH.TXT"]}
    code, answer = diff(tmp_path, fanuc, new, "fanuc-30i")
    assert code == 1
    assert all(group["only_old"] and not group["changed"] for group in answer["other"])
    assert all(axis["correction"] is None for axis in answer["axes"].values())
    assert len(capsys.readouterr().out.splitlines()) < 60


# --- the real archive of a SINUMERIK, in its container


#: Variables of a container, each with the values before and after and a word of its meaning.
CONTAINER_CHANGES = {
    "$AA_ENC_COMP[1,5,AX2]": ("0", "1", "EEC: value"),
    "$AN_CEC[6,14]": ("0", "1", "CEC: value"),
    "$MA_BACKLASH[0,AX2]": ("0", "1", "MD32450"),
    "$SN_CEC_TABLE_ENABLE[3]": ("1", "0", "SD41300"),
}


@needs_archive
def test_changes_in_a_container_are_named_and_nothing_else_is(tmp_path: Path) -> None:
    whole = edited = ARCHIVE.read_bytes()
    for name, (old, new, _) in CONTAINER_CHANGES.items():
        assert whole.count(f"{name}={old}\n".encode()) == 1
        edited = edited.replace(f"{name}={old}\n".encode(), f"{name}={new}\n".encode())
    code, answer = diff(tmp_path, {"a.arc": whole}, {"b.arc": edited}, "siemens-840d-sl")
    assert code == 1
    assert entries(answer) == {name: change[:2] for name, change in CONTAINER_CHANGES.items()}
    listed = [entry for axis in answer["axes"].values() for entry in axis["entries"]]
    told = {entry["quantity"]: entry["meaning"] for entry in (*listed, *answer["machine"])}
    assert all(words in told[name] for name, (_, _, words) in CONTAINER_CHANGES.items())
    own = {entry["quantity"] for entry in answer["axes"]["AX2"]["entries"]}
    assert {"$AA_ENC_COMP[1,5,AX2]", "$MA_BACKLASH[0,AX2]"} <= own


@needs_archive
def test_the_texts_of_an_archive_and_the_names_of_its_axes(tmp_path: Path) -> None:
    """X1 is AX1 by MD10000; block numbers, order and line ends say nothing."""
    old = {"MD.INI": machine_data().encode(), "EEC.INI": eec_text().encode()}
    lines = machine_data().splitlines()
    new = {
        "EEC.INI": eec_text().replace(",AX1]", ",X1]").replace("\n", "\r\n").encode(),
        "MD.INI": "\n".join(
            [*lines[:3], *(re.sub(r"^N\d+ ", "", line) for line in reversed(lines[3:-1])), "M17\n"]
        ).encode(),
    }
    assert diff(tmp_path / "same", old, new, "siemens-840d-sl")[0] == 0
    cec = {**old, "CEC.INI": cec_text().encode()}
    code, answer = diff(tmp_path / "more", old, cec, "siemens-840d-sl")
    assert code == 1
    assert all(before is None for before, _ in entries(answer).values())


@needs_archive
def test_names_that_only_one_backup_lists_hold_for_both(tmp_path: Path) -> None:
    old = {"MD.INI": machine_data().encode(), "EEC.INI": eec_text().encode()}
    new = {"EEC.INI": eec_text().replace(",AX1]", ",X1]").encode()}
    _, answer = diff(tmp_path, old, new, "siemens-840d-sl")
    assert all(after is None for _, after in entries(answer).values())
    assert not [one for one in entries(answer) if one.startswith("$AA_ENC_COMP[")]


# --- any value of the real files


@pytest.mark.parametrize(
    ("control", "paths", "value", "count"),
    [
        ("fanuc-30i", ["fanuc/CNC-PARA.TXT", "fanuc/PITCH.TXT"], r"[PM](-?\d+(?:\.\d+)?)", 5),
        ("siemens-840d-sl", ["siemens/dmu_840d_sl.arc"], r"(?m)=\s*(-?\d+(?:\.\d+)?)\s*$", 3),
    ],
)
@needs_backup
@needs_archive
def test_any_changed_value_is_one_entry(
    control: str, paths: list[str], value: str, count: int
) -> None:
    rng = random.Random(11)  # noqa: S311 - a test
    files = [ControlFile(Path(path).name, (REAL / path).read_bytes()) for path in paths]
    texts = texts_of(files)
    family = control_format(DEFINITIONS[control], {})
    old = family.listing.file_values(family.definition, texts, ())
    for _ in range(count):
        place = rng.choice([k for k, one in enumerate(texts) if len(one.content) > 3000])
        text = texts[place].content.decode("latin-1")
        found = rng.choice(list(re.finditer(value, text)))
        new = text[: found.start(1)] + f"{rng.randint(100, 900)}.5" + text[found.end(1) :]
        edited = list(texts)
        edited[place] = ControlFile(texts[place].name, new.encode("latin-1"))
        (change,) = changes(old, family.listing.file_values(family.definition, edited, ()))
        assert change.new is not None
        assert change.new.text.endswith(".5") or " in " in change.new.name


# --- complete examples of every control


def sample(definition: Definition) -> dict[str, bytes]:
    return {name: text.encode() for name, text in definition.sample_files.items()}


@pytest.mark.parametrize("name", sorted(DEFINITIONS))
def test_a_sample_is_the_same_as_itself(name: str, tmp_path: Path) -> None:
    definition = DEFINITIONS[name]
    files = sample(definition)
    ends = "\r\n" if "\r\n" in definition.dialect.newlines_read else "\n"
    new = {file: text.replace(b"\n", ends.encode()) for file, text in reversed(files.items())}
    options = definition.sample_options
    assert diff(tmp_path, files, new, name, options)[0] == 0


@pytest.mark.parametrize(
    ("control", "file", "old", "new", "most"),
    [
        ("linuxcnc", "joint_0.comp", "0 0.0000 0.0120", "0 0.0010 0.0120", 1.0),
        ("linuxcnc", "joint_0.ini", "COMP_FILE_TYPE = 0", "COMP_FILE_TYPE = 1", None),
        ("isg-kernel", "achskw1.lis", "[3].pos              84", "[3].pos              94", 1.0),
        ("pmac", "comp.pmc", "-32 -48 16 0", "-32 -64 16 0", 1.0),
        ("heidenhain-itnc530", "Y.COM", "-0.0012", "-0.0022", 1.0),
        ("heidenhain-itnc530", "MP.TXT", "MP710.1 : 0.0010", "MP710.1 : 0.0020", 1.0),
        ("heidenhain-nck", "X.COM", "+0.0007", "-0.0003", 1.0),
    ],
)
def test_one_change_of_a_sample_is_found(
    control: str, file: str, old: str, new: str, most: float | None, tmp_path: Path
) -> None:
    """Each by 1 µm: 0.001 mm, 10 times 0.1 µm, 16 sixteenths of a count of 0.001 mm."""
    files = sample(DEFINITIONS[control])
    options = DEFINITIONS[control].sample_options
    code, answer = diff(tmp_path, files, changed(files, file, old, new), control, options)
    assert code == 1
    assert len(entries(answer)) == 1
    if most is not None:
        (axis,) = answer["axes"].values()
        assert abs(axis["correction"]["max_change_um"]) == pytest.approx(most)


@pytest.mark.parametrize(
    ("control", "file", "renamed", "old", "new"),
    [
        ("isg-kernel", "achskw1.lis", "KW1.LIS", "[3].pos              84", "[3].pos 94 # 9.4 um"),
        ("pmac", "comp.pmc", "back.txt", "-32 -48 16 0", "-32,\r\n-64,16 , 0"),
    ],
)
def test_one_change_is_found_in_a_file_of_another_name_and_form(
    control: str, file: str, renamed: str, old: str, new: str, tmp_path: Path
) -> None:
    files = sample(DEFINITIONS[control])
    options = DEFINITIONS[control].sample_options
    found = changed(files, file, old, new)
    found[renamed] = found.pop(file)
    code, answer = diff(tmp_path, files, found, control, options)
    assert (code, len(entries(answer))) == (1, 1)


# --- what cannot be compared


def test_a_backup_that_the_control_would_refuse_is_compared_by_its_entries(tmp_path: Path) -> None:
    old = {"P.TXT": parameters(lines=50).encode(), "Q.TXT": pitch_data().encode()}
    new = changed(old, "P.TXT", "N03624Q1A1M50.0", "N03624Q1A1M0.0")  # points without an interval
    code, answer = diff(tmp_path, old, new, "fanuc-30i", {"detection_unit": 0.001})
    assert code == 1
    assert entries(answer) == {"N03624Q1A1": ("50.0", "0.0")}
    assert not answer["corrections_compared"]


def test_the_scale_of_a_joint_is_no_other_line(tmp_path: Path) -> None:
    old = sample(DEFINITIONS["linuxcnc"])
    more = old["joint_0.ini"] + b"SCALE = 1000\nMAX_VELOCITY = 10\nMAX_LIMIT = 300\n"
    old["joint_0.ini"] = more
    faster = more.replace(b"= 10\n", b"= 12\n").replace(b"300", b"310")
    code, answer = diff(tmp_path / "a", old, {**old, "joint_0.ini": faster}, "linuxcnc")
    assert (code, answer["machine"], list(answer["axes"])) == (1, [], ["0"])
    (entry,) = answer["axes"]["0"]["entries"]  # the speed decides how steep a correction may be
    assert (entry["quantity"], entry["old"], entry["new"]) == ("MAX_VELOCITY", "10", "12")
    assert [one["quantity"] for one in answer["other"]] == ["max_limit"]
    scaled = more.replace(b"= 1000", b"= 1001")
    _, answer = diff(tmp_path / "b", old, {**old, "joint_0.ini": scaled}, "linuxcnc")
    assert [one["quantity"] for one in answer["machine"]] == ["joint_0.ini: [JOINT_0] SCALE"]


def test_tables_of_tools_in_a_backup_are_counted_apart(tmp_path: Path) -> None:
    """tool.t of an NCK control stands beside the .COM files (form: github drunsinn/pyLSV2)."""
    tool = "BEGIN TOOL.T MM Version: 'Update:110.24'\nT   NAME  L\n1   MILL  +{}\n[END]\n"
    old = {**sample(DEFINITIONS["heidenhain-nck"]), "tool.t": tool.format(30).encode()}
    new = {**old, "tool.t": tool.format(31).encode()}
    code, answer = diff(tmp_path, old, new, "heidenhain-nck")
    assert (code, answer["axes"], answer["machine"]) == (1, {}, [])
    assert answer["corrections_compared"]
    assert len(answer["other"]) == 2


@pytest.mark.parametrize(
    ("content", "says"), [(b"\x00\x01\x02", "no data of"), (b"no data\n", "no data of")]
)
def test_files_without_data_are_refused(
    content: bytes, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    old = {"P.TXT": parameters(lines=50).encode()}
    assert diff(tmp_path, old, {"X.BIN": content}, "fanuc-30i")[0] == 3
    assert says in capsys.readouterr().err


def test_the_other_backup_has_to_be_given(tmp_path: Path) -> None:
    (tmp_path / "P.TXT").write_text(parameters(lines=50))
    assert compwright(["diff", str(tmp_path / "P.TXT"), "--format", "fanuc-30i"]) == 2


def test_the_page_says_it_in_words(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    old = {"P.TXT": parameters(lines=50).encode(), "Q.TXT": pitch_data().encode()}
    new = changed(old, "P.TXT", "N01851Q1A1P4A2", "N01851Q1A1P7A2")
    assert diff(tmp_path, old, new, "fanuc-30i", {"detection_unit": 0.001})[0] == 1
    words = [
        "diff",
        str(tmp_path / "old"),
        "--with",
        str(tmp_path / "new"),
        "--format",
        "fanuc-30i",
    ]
    capsys.readouterr()
    assert compwright([*words, "--option", "detection_unit=0.001"]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert "axis 1 (X): the correction changes by up to −3.00 µm" in said
    assert "N01851Q1A1 backlash at cutting feed 4 7" in said
