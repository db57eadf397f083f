"""What lies in the folder of a backup and is none of the control's: `new` names it and takes the
rest; what a control could take for data is never left aside.
"""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from compwright.cli import run as compwright
from compwright.controls.control import decode, open_control
from compwright.controls.control_files import read_files
from compwright.controls.definitions import definition_named
from compwright.formats.text.other_files import holds_no_data, without_other_files
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from fanuc_backup import parameters, pitch_data

#: As a control lists its hardware and software, between its own marks.
HARDWARE = (
    "%\nSYSTEM CONFIGURATION\n\n MAIN BOARD   00493 B0 1 70000203\n EMBED ETHER    658A     20.0\n%"
)


def backup(folder: Path, **more: str) -> Path:
    folder.mkdir()
    texts = {"CNC-PARA.TXT": parameters(lines=20), "PITCH.TXT": pitch_data()} | more
    for name, text in texts.items():
        (folder / name).write_bytes(text.encode("latin-1"))
    return folder


def new(folder: Path) -> tuple[int, Path]:
    out = folder.parent / "job.yaml"
    said = ["--option", "detection_unit=0.001", "--out", str(out)]
    return compwright(["new", "--from", str(folder), "--format", "fanuc-30i", *said]), out


def test_a_list_of_the_hardware_is_left_aside_and_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, job = new(backup(tmp_path / "control", **{"SYS-CONF.TXT": HARDWARE}))
    said = capsys.readouterr().err
    assert code == 0, said
    assert "SYS-CONF.TXT is left aside" in said
    taken = yaml.safe_load(job.read_text())["states"]["as_found"]
    assert taken == ["control/CNC-PARA.TXT", "control/PITCH.TXT"]


def test_a_folder_of_which_all_is_taken_stays_one(tmp_path: Path) -> None:
    code, job = new(backup(tmp_path / "control"))
    assert code == 0
    assert yaml.safe_load(job.read_text())["states"]["as_found"] == ["control"]


def test_what_looks_like_data_is_refused_by_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, job = new(backup(tmp_path / "control", **{"MORE.TXT": HARDWARE + "\nN03620Q1A1Pxx\n"}))
    assert code == 3
    assert "MORE.TXT" in capsys.readouterr().err
    assert not job.exists()


def test_the_folder_of_a_memory_card_is_a_state_as_it_is(tmp_path: Path) -> None:
    """The second reader refuses the list of the hardware by its first line that looks like a
    block; only files that were named themselves stay whatever they hold.
    """
    card = backup(tmp_path / "card", **{"SYS-CONF.TXT": HARDWARE})
    control = open_control(Session(), "fanuc-30i", {"detection_unit": 0.001})
    read = decode(control, read_files(Session(), [card]), address="1")
    assert [file.name for file in read.files] == ["CNC-PARA.TXT", "PITCH.TXT"]
    told = [one.message for one in read.state.findings if one.code == "CW-S084"]
    assert len(told) == 1
    assert told[0].startswith("SYS-CONF.TXT: ")
    with pytest.raises(InputError, match="SYS-CONF"):
        decode(control, read_files(Session(), sorted(card.iterdir())), address="1")


def test_no_command_is_left_out_of_a_folder(tmp_path: Path) -> None:
    """A line without a number is nothing to a FANUC, and deletes a table of a PMAC."""
    (tmp_path / "a.pmc").write_text("#1 DEFINE COMP 1,1000\n0\nI186=0\n")
    (tmp_path / "b.pmc").write_text("#2 DELETE COMP\n")
    files = read_files(Session(), [tmp_path])
    for format_id, left in (("pmac", 2), ("fanuc-30i", 1)):
        assert (
            len(without_other_files(definition_named(Session(), format_id, Path()), files)[0])
            == left
        )


@pytest.mark.parametrize(
    ("control", "text", "nothing"),
    [
        ("fanuc-30i", HARDWARE, True),
        ("fanuc-30i", "n 5711 p1", False),  # another parameter, as nobody writes it
        ("fanuc-30i", HARDWARE.replace("%", "\x00"), False),
        ("siemens-840d-sl", "Machine 7\nsaved by hand in the spring\n", True),
        ("siemens-840d-sl", "$MA_ENC_COMP_ENABLE[0,AX1]=1\n", False),
        ("siemens-840d-sl", "anything = 1", False),
        ("linuxcnc", "0.0 0.01 0.02\n", False),
        ("pmac", "#1\nDELETE COMP\n", False),  # every line of a script is a command
        ("pmac", "$$$***\n", False),
        ("heidenhain-itnc530", "notes\n", True),
        ("heidenhain-itnc530", "  1  -12,5\t0.003 \n", False),
        ("fanuc-30i", "", False),
    ],
)
def test_only_prose_says_nothing(control: str, text: str, nothing: bool) -> None:
    file = ControlFile("OTHER.TXT", text.encode("latin-1"))
    assert holds_no_data(definition_named(Session(), control, Path()), file) is nothing


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le"])
def test_other_characters_are_no_prose(encoding: str) -> None:
    file = ControlFile("PITCH.TXT", pitch_data(highest=20).encode(encoding))
    assert not holds_no_data(definition_named(Session(), "fanuc-30i", Path()), file)
