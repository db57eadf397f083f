"""A real commissioning archive in which digits were changed at equal length: it is never believed in
silence. It is refused, or it is said that nothing verifies its contents, and the card has the values
to compare before anything is loaded.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from harm_command import REFUSED, card_of, command
from harm_measuring import Axis, measure, write_csv
from places import REAL, needs_shared

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages, needs_shared]

ARCHIVE = REAL / "siemens" / "dmu_840d_sl.arc"
FORMAT = "siemens-840d-sl"
#: The finding that the contents are not verified.
UNVERIFIED = "CW-S072"
MACHINE = Axis(0.0, 360.0, bow=5, wave=2, lost=2, scatter=0.2, full_turn=True)


def edited(member: bytes, old: bytes, new: bytes) -> bytes:
    """Change the first place behind the name of a member, at equal length."""
    data = ARCHIVE.read_bytes()
    at = data.index(old, data.index(member) if member else 0)
    assert len(old) == len(new)
    return data[:at] + new + data[at + len(old) :]


EDITS = {
    "a value of the table": (b"_N_AX_EEC_INI", b"[1,11,AX4]=0.0054", b"[1,11,AX4]=0.0354"),
    "a sign of the table": (b"_N_AX_EEC_INI", b"[1,22,AX4]=-0.0001", b"[1,22,AX4]=10.0001"),
    "the step of the table": (b"_N_AX_EEC_INI", b"STEP[1,AX4]=15", b"STEP[1,AX4]=12"),
    "the backlash": (b"", b"$MA_BACKLASH[1,AX4]=0\n", b"$MA_BACKLASH[1,AX4]=3\n"),
    "the switch": (
        b"",
        b"N32700 $MA_ENC_COMP_ENABLE[1,AX4]=1",
        b"N32700 $MA_ENC_COMP_ENABLE[1,AX4]=0",
    ),
    "the kind, in one of two members": (
        b"",
        b"N30300 $MA_IS_ROT_AX[AX4]=1",
        b"N30300 $MA_IS_ROT_AX[AX4]=0",
    ),
}


@pytest.mark.parametrize("case", ["", "a value of the table", "the step of the table"])
def test_it_is_said_that_the_contents_are_not_verified(case: str, tmp_path: Path) -> None:
    path = tmp_path / "backup.arc"
    path.write_bytes(edited(*EDITS[case]) if case else ARCHIVE.read_bytes())
    answer = command("decode", path, "--format", FORMAT, "--json", "-")
    if case and answer.code == REFUSED:
        return
    assert answer.code == 0, answer.first
    assert UNVERIFIED in {finding["code"] for finding in answer.json()["findings"]}


def job(folder: Path, data: bytes) -> Path:
    (folder / "backup.arc").write_bytes(data)
    write_csv(folder / "r.csv", "R", measure(MACHINE, count=12), rotary=True)
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {FORMAT}}}\nstates: {{as_found: [backup.arc]}}\naxes:\n"
        "  R: {kind: rotary, travel: [0, 360], modulo: 360, address: AX4, before: [r.csv]}\n",
        encoding="utf-8",
    )
    return folder / "job.yaml"


@pytest.mark.parametrize(
    "case", ["", "a value of the table", "a sign of the table", "the backlash"]
)
def test_the_card_compares_before_it_loads(case: str, tmp_path: Path) -> None:
    """Three values of the axis under work, as the archive holds them, before the first change."""
    data = edited(*EDITS[case]) if case else ARCHIVE.read_bytes()
    answer = command("run", job(tmp_path, data))
    if case and answer.declined:
        return
    assert answer.code in ({0, 1} if case else {0}), answer.first  # 1: the edit is a doubt as well
    assert UNVERIFIED in answer.text
    assert UNVERIFIED in (tmp_path / "job" / "report.html").read_text(encoding="utf-8")
    card = card_of(tmp_path / "job")
    before = card[: card.index("_EEC.INI")]
    entries = re.findall(r"(\$[AM]A_[A-Z_]+\[[\d,]+AX4\]) = (-?[\d.]+\d|\d)(?: |,|\.)", before)
    text = data.decode("latin-1")
    told = {name: value for name, value in entries if "ENABLE" not in name}
    assert len(told) >= 3
    for name, value in told.items():
        assert re.search(rf"{re.escape(name)}={re.escape(value)}\s", text), (name, value)
    if case:
        name, _, value = EDITS[case][2].decode().strip().rpartition("=")
        assert any(
            entry.endswith(name[name.index("[") :]) and float(held) == float(value)
            for entry, held in told.items()
        )


@pytest.mark.parametrize("case", ["the kind, in one of two members"])
def test_members_that_contradict_each_other_are_refused(case: str, tmp_path: Path) -> None:
    answer = command("run", job(tmp_path, edited(*EDITS[case])))
    assert answer.code == REFUSED, answer.first


def test_a_switch_that_was_edited_is_asked_about(tmp_path: Path) -> None:
    assert command("run", job(tmp_path, edited(*EDITS["the switch"]))).declined
