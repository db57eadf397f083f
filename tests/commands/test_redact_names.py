"""What gives somebody away beside the texts of a file: its name, the answer among the copies, a
number behind a letter. And what an engineer needs of a copy: dates, the air, tables under names of
their own.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from compwright.foundations.redaction import Names, left_over
from compwright.workflow.redact.redacted_names import names_of_copies

_TEST = "# axis: X\n# unit: um\ntarget_mm,+1,-1\n0,1,2\n100,1,3\n"


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("4711_X.csv", "4711"), ("X4711.csv", "4711"), ("SN-47 118 15.csv", "4711815"),
        ("MustermannErika.csv", "Erika Mustermann"), ("Muster_mann.csv", "Mustermann"),
        ("DMU50kundenfirmaX.csv", "Kundenfirma DMU50"), ("X.Kundenfirma", "Kundenfirma"),
        ("Mueller_X.csv", "M\u00fcller"), ("muller.csv", "M\u00dcLLER"), ("Mu\u0308ller.csv", "M\u00fcller"),
        ("20264711.csv", ""), ("x_99999999.csv", ""), ("20260302-990000.csv", ""),
    ],
)  # fmt: skip
def test_a_name_that_tells_who_it_was_is_another(file: str, text: str) -> None:
    (name,) = names_of_copies([file], [("comment", text)], Names())
    assert not [piece for piece in ("4711", "ller", "muster", "firma") if piece in name.casefold()]
    assert name not in {file, ""}


@pytest.mark.parametrize(
    "file",
    [
        "XY 360deg 100mm 20091029-150241.b5r", "x_2026-03-02.csv", "x_20260302.csv", "X 0-1500.csv",
        "CNC-PARA.TXT", "PITCH.TXT", "AX_EEC.INI", "y_before_1800.csv", "Achse X 2026.csv",
    ],
)  # fmt: skip
def test_a_name_that_tells_when_and_what_stays(file: str) -> None:
    removed = [
        ("comment", "Test before 2026, axis X from 0 to 1500 at 1800 mm/min, parameters and pitch"),
        ("machine", "VMC 850"),
        ("line", "N9000 AX_EEC PITCH G1 X1500"),
    ]
    assert names_of_copies([file], removed, Names()) == [file]


def test_no_two_copies_have_one_name() -> None:
    names = Names()
    assert names.of("Vogt") == "redacted_1"
    files = ["redacted_1.csv", "Vogt.csv", "REDACTED_1.CSV"]
    made = names_of_copies(files, [("operator", "Vogt")], names)
    assert len({name.casefold() for name in made}) == 3


@pytest.mark.parametrize("place", ["out/r.json", "out/deep/r.json", "out/../out/r.json"])
def test_the_answer_never_lies_among_the_copies(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], place: str
) -> None:
    folder = tmp_path / "Kundenfirma"
    folder.mkdir()
    (folder / "x.csv").write_text(_TEST)
    words = ["redact", str(folder), "--out", str(tmp_path / "out"), "--json"]
    assert compwright([*words, str(tmp_path / place)]) == 2
    assert "contains the original names" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    assert compwright([*words, str(tmp_path / "r.json")]) == 0
    assert [entry["renamed"] for entry in json.loads((tmp_path / "r.json").read_text())["files"]]


def test_a_number_is_found_behind_the_letter_of_its_address() -> None:
    for text in ("SN 4711815", "SN4711815", "Laser-4711815/B"):
        assert left_over([text], [b"N13150Q1P4711815\n"], frozenset()) == [text]
    for text in ("3605 is 00000010", "from 2400000", "on 20260302"):
        copy = b"N03605Q1A1P00000010\nN01420Q1P2400000\nN00300P20260302\n"
        assert left_over([text], [copy], frozenset()) == []


def test_a_serial_number_that_is_a_parameter_too_is_refused_with_its_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "CNC-PARA.TXT"
    file.write_text("%\n(SERIAL 4711815)\nN03620Q1A1P40A2P0\nN13150Q1P4711815\n%\n")
    assert compwright(["redact", str(file), "--out", str(tmp_path / "out")]) == 3
    said = capsys.readouterr().err
    assert "CNC-PARA.TXT: line 4: the file was not copied" in said
    assert "4711815" not in said
    assert not (tmp_path / "out").exists()


_RUNS = "".join(
    f"   {run}     {n}     {0.1 * n + 0.2 * run:.1f}\r\n"
    for run in (1, 2, 3, 4)
    for n in ((1, 2, 3) if run % 2 else (3, 2, 1))
)
#: The sections and keys of the facts about such files, with the date as the software writes it.
_LASER = (
    "HEADER::\r\nFile type  : rtl\r\nOwner      : Linear\r\nVersion no : V20.02.02\r\n"
    "TARGET DATA::\r\nFiletype  : ISO\r\nTarget-count: 3\r\nTargets :\r\n0.0 100.0 200.0\r\n"
    "Flags: 0 0 2 0\r\nUSER-TEXT::\r\nMachine: Kundenfirma\r\nSerial No: 4711815\r\n"
    "Date: 10:23 Mar 02 2026\r\nBy: Erika\r\nAxis: X\r\nLocation: Geheimstadt\r\nTITLE: Abnahme\r\n"
    f"RUNS::\r\nRun-count: 4\r\nDEVIATIONS::\r\nRun Target Data:\r\n{_RUNS}"
    "EQUIPMENT::\r\nENVIRONMENT::\r\nAir temp : 20.1\r\nAir Press : 1013.2\r\nAir Humid : 40\r\n"
    "Mat temp 1 : 20.5\r\nEnv factor : 0.9997\r\nExp coeff : 11.7\r\n"
    "Date Time : 2026-03-02 10:23\r\nEOF::\r\n"
)


def test_dates_and_the_air_of_a_laser_file_stay(tmp_path: Path) -> None:
    (tmp_path / "x.rtl").write_bytes(_LASER.encode())
    assert compwright(["redact", str(tmp_path / "x.rtl"), "--out", str(tmp_path / "out")]) == 0
    old, new = _LASER.split("\r\n"), (tmp_path / "out" / "x.rtl").read_bytes().decode()
    changed = [a.partition(":")[0] for a, b in zip(old, new.split("\r\n"), strict=True) if a != b]
    assert changed == ["Machine", "Serial No", "By", "Location", "TITLE"]


_TABLE = (
    "BEGIN {name} .COM MM DATUM:-400 DIST:200\nNR   1=F()     2=F()\n0    +0        +0\n"
    "1    -0.0012   +0.0003\n2    -0.0021   +0.0006\nEND {name} .COM\n"
)
_SETTINGS = (
    "[TRAJ]\nLINEAR_UNITS = mm\nCOORDINATES = X\n[KINS]\nKINEMATICS = trivkins\n[JOINT_0]\n"
    "COMP_FILE = xscrew.txt\nCOMP_FILE_TYPE = 0\nBACKLASH = 0\nMIN_LIMIT = -200\nMAX_LIMIT = 200\n"
)


@pytest.mark.parametrize(
    ("control", "files"),
    [
        ("heidenhain-itnc530", {"X.COM": _TABLE.format(name="X"), "C.CMA": "0    X"}),
        ("heidenhain-itnc530", {"V.COM": _TABLE.format(name="VOGTX"), "C.CMA": "0    VOGTX"}),
        ("linuxcnc", {"m.ini": _SETTINGS, "xscrew.txt": "-200 -200.008 -200\n200 200.01 200.02\n"}),
    ],
)
def test_tables_that_another_file_names_are_copied_with_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], control: str, files: dict[str, str]
) -> None:
    folder, out = tmp_path / "control", tmp_path / "out"
    folder.mkdir()
    for name, text in files.items():
        said = f"BEGIN CONFIG .CMA MM\nNR   1             2\n{text}\nEND CONFIG .CMA\n"
        (folder / name).write_text(said if name == "C.CMA" else text)
    assert compwright(["redact", str(folder), "--out", str(out)]) == 0
    assert not [path for path in out.iterdir() if b"vogt" in path.read_bytes().lower()]
    answers = []
    for given in (folder, out):
        capsys.readouterr()
        assert compwright(["decode", str(given), "--format", control, "--json", "-"]) == 0
        answers.append(list(json.loads(capsys.readouterr().out)["axes"].values()))
    assert any(answers[0][0]["correction_positive"])
    assert answers[0] == answers[1]


def test_a_file_that_is_given_twice_is_copied_once_and_folders_in_folders_are_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "backup"
    (folder / "axes").mkdir(parents=True)
    (folder / "x.csv").write_text(_TEST)
    words = ["redact", str(folder), str(folder / "x.csv"), "--out", str(folder / "out")]
    assert compwright(words) == 0
    said = capsys.readouterr().err
    assert "axes: a folder in a folder" in said
    assert compwright([*words, "--force"]) == 0  # the copies are no such folder
    assert "out:" not in capsys.readouterr().err


def test_what_cannot_be_read_in_a_folder_costs_no_other_file_its_copy(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "backup"
    folder.mkdir()
    (folder / "x.csv").write_text(_TEST)
    try:
        (folder / "gone.csv").symlink_to(tmp_path / "nowhere.csv")
    except OSError:
        pytest.skip("no links here")
    assert compwright(["redact", str(folder), "--out", str(tmp_path / "out")]) == 3
    assert "gone.csv" in capsys.readouterr().err
    assert (tmp_path / "out" / "x.csv").read_text() == _TEST


def test_a_workbook_with_programs_becomes_one_without_that_opens(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for row in (["# axis: X"], ["target_mm", "direction", "run", "deviation_um"],
                [0, "+", 1, 1.5], [0, "-", 1, 2.5], [100, "+", 1, 1.5], [100, "-", 1, 2.5]):  # fmt: skip
        book.active.append(row)
    book.save(tmp_path / "x.xlsm")
    assert compwright(["redact", str(tmp_path / "x.xlsm"), "--out", str(tmp_path / "out")]) == 0
    assert [path.name for path in (tmp_path / "out").glob("*.xls*")] == ["x.xlsx"]
    rows = list(openpyxl.load_workbook(tmp_path / "out" / "x.xlsx").active.values)
    assert [row[3] for row in rows[2:]] == [1.5, 2.5, 1.5, 2.5]


_FOREIGN = (
    "Kundenfirma GmbH;;;\nPrüfer: Erika, geb. 12.03.1984;Datum: 02.03.2026;Nr. 4711815;\n"
    "Datum;03.03.2026 14:05;;\nLieferung am 01.02.2003;;;\nAchse: Y;;;\n"
    "Soll [mm];Richtung;Lauf;Abweichung (Ist - Soll) [µm]\n"
    "0,0;auf;1;0,4\n100,0;auf;1;2,1\n100,0;ab;1;-0,8\n0,0;ab;1;-2,9\n"
)


def test_when_it_was_measured_stays_and_no_other_date_does(tmp_path: Path) -> None:
    plain = "# Datum: 02.03.2026\n# date: 3.3.2026 14:05 Uhr\n# Erika, geb. 12.03.1984\n"
    (tmp_path / "y.csv").write_text(_FOREIGN, encoding="utf-8")
    (tmp_path / "x.csv").write_text(f"{plain}# Temperatur: 20,5\n{_TEST}")
    words = [str(tmp_path / "y.csv"), str(tmp_path / "x.csv"), "--out", str(tmp_path / "out")]
    assert compwright(["redact", *words]) == 0
    foreign = (tmp_path / "out" / "y.csv").read_text("utf-8").splitlines()
    assert foreign[:5] == [
        "redacted", "Datum: 02.03.2026", "Datum;03.03.2026 14:05;;", "redacted", "Achse: Y;;;",
    ]  # fmt: skip
    assert foreign[6:] == _FOREIGN.splitlines()[6:]
    assert (tmp_path / "out" / "x.csv").read_text().splitlines()[:4] == [
        "# Datum: 02.03.2026", "# date: 3.3.2026 14:05 Uhr", "# redacted", "# Temperatur: 20,5",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("header", "said"),
    [
        ("Abweichung [µm]", None),
        ("Abweichung (Ist - Soll) [µm]", "measured minus target"),
        ("Abweichung (Soll - Ist) [µm]", "target minus measured"),
    ],
)
def test_a_sign_that_nobody_stated_is_not_stated_beside_the_copy(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], header: str, said: str | None
) -> None:
    text = _FOREIGN.replace("Abweichung (Ist - Soll) [µm]", header)
    (tmp_path / "y.csv").write_text(text, encoding="utf-8")
    out = tmp_path / "out"
    assert compwright(["redact", str(tmp_path / "y.csv"), "--out", str(out)]) == 0
    profile, answer = out / "y.profile.yaml", tmp_path / "a.json"
    words = ["evaluate", str(out / "y.csv"), "--json", str(answer), "--profile"]
    if said is None:
        assert compwright([*words, str(profile)]) == 2
        assert "must be filled in" in capsys.readouterr().err
        return
    assert compwright([*words, str(profile)]) == 0
    (result,) = json.loads(answer.read_text())["results"]
    sign = 1 if said == "measured minus target" else -1
    assert result["targets"][0]["deviations_positive"] == [0.4 * sign]
