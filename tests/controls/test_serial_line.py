"""Files as they came over a serial line or from a paper tape: a leader of NUL, DC codes, Ctrl-Z at
the end. They are read as the text alone, and what is written keeps every byte around it.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
import yaml
from test_fanuc_backup_honoured import Bench

from compwright.cli import run as compwright
from compwright.records.serial_line import from_line
from format_samples import DEFINITIONS

pytestmark = pytest.mark.short_estimate

AROUND = [
    (b"\x00" * 40, b"\x1a"),
    (b"\x11\x12\r\n\x00\x00", b"\r\n\x14\x13\x00\x00\x00"),
    (b"", b"\x1a\x1a\x1a\x00\x00"),
]


@pytest.fixture(scope="module")
def plain_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a job on files with nothing around their text, run once."""
    folder = tmp_path_factory.mktemp("plain")
    assert Bench(folder).run("X") == 0
    return folder


@pytest.mark.parametrize("around", AROUND)
def test_the_patch_keeps_every_byte_around_the_text(
    around: tuple[bytes, bytes], plain_run: Path, tmp_path: Path
) -> None:
    folders = [plain_run, tmp_path / "dump"]
    folders[1].mkdir()
    bench = Bench(folders[1])
    for name in ("CNC-PARA.TXT", "PITCH.TXT"):
        path = folders[1] / name
        path.write_bytes(around[0] + path.read_bytes() + around[1])
    assert bench.run("X") == 0
    for name in ("CNC-PARA.TXT", "PITCH.TXT"):
        tables, back = ("job/tables/fanuc-30i", "job/rollback/fanuc-30i")
        plain, dump = ((folder / tables / name).read_bytes() for folder in folders)
        assert dump == around[0] + plain + around[1]
        assert (folders[1] / back / name).read_bytes() == (folders[1] / name).read_bytes()
    plan, out = str(tmp_path / "dump" / "job" / "plan.json"), tmp_path / "exported"
    assert compwright(["export", plan, "--format", "fanuc-30i", "--out", str(out)]) == 0
    loaded = tmp_path / "dump" / "job" / "tables" / "fanuc-30i"
    assert compwright(["compare", plan, "--loaded", str(loaded)]) == 0


@pytest.mark.parametrize("around", AROUND)
@pytest.mark.parametrize("format_id", sorted(set(DEFINITIONS) - {"linuxcnc"}))
def test_every_control_whose_files_are_text(
    format_id: str, around: tuple[bytes, bytes], tmp_path: Path
) -> None:
    """The sample of each definition, as it is and with the bytes around it: the same answer."""
    definition = DEFINITIONS[format_id]
    options = [f"--option={key}={value}" for key, value in definition.sample_options.items()]
    answers = []
    for folder, (leader, trailer) in {"plain": (b"", b""), "dump": around}.items():
        (tmp_path / folder).mkdir()
        words = []
        for name, text in definition.sample_files.items():
            sheet = name.startswith("entry_")
            raw = text.encode("latin-1")
            (tmp_path / folder / name).write_bytes(raw if sheet else leader + raw + trailer)
            words.append(str(tmp_path / folder / name))
        answer = tmp_path / f"{folder}.json"
        assert (
            compwright(["decode", *words, f"--format={format_id}", *options, f"--json={answer}"])
            == 0
        )
        answers.append(json.loads(answer.read_text())["axes"])
    assert answers[0] == answers[1]


def test_what_is_no_text_stays_as_it_is() -> None:
    for raw in (
        b"\x00a\x00b\x00",
        b"\x00\x00",
        b"",
        b"@@MMCIBN.002\x00\x00text\x00\x00",
        b"PK\x03\x04\x00",
    ):
        assert from_line("x", raw).content == raw
    found = from_line("x", b"\x00\x00%\r\nN1\r\n%\x1a")
    assert (found.leader, found.content, found.trailer) == (b"\x00\x00", b"%\r\nN1\r\n%", b"\x1a")


def test_many_bytes_in_the_middle_take_no_time() -> None:
    raw = b"a" + b"\x00" * 2_000_000 + b"a"
    assert from_line("x", raw).content == raw


def test_the_travel_of_a_diameter_axis_is_half(tmp_path: Path) -> None:
    """1321 = -352 on an axis with 1006#3: positions of such an axis are shown in diameter
    (B-62754EN/01 page 104), a job counts in radius.
    """
    edits = {(1006, "1"): "00001000", (1321, "1"): "-352.0", (1320, "1"): "0.0"}
    Bench(tmp_path, edits)
    out = tmp_path / "job.yaml"
    words = [f"--from={tmp_path / name}" for name in ("CNC-PARA.TXT", "PITCH.TXT")]
    assert compwright(["new", *words, "--format", "fanuc-30i", "--out", str(out)]) == 0
    axes = yaml.safe_load(re.sub(r": \[path[^\n]*", ": []", out.read_text()))["axes"]
    assert axes["X"]["travel"] == [-176, 0]
    assert axes["X"]["programmed"] == "diameter"
    assert "Y" not in axes or axes["Y"]["travel"] == [-1101, 1]
