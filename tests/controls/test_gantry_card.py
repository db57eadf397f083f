"""A table on one axis of a gantry alone racks the bridge: the card of every control names the other
axis and its numbers.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()


@pytest.mark.parametrize(
    ("control", "address", "partner", "options", "words"),
    [
        ("linuxcnc", "0", "1", "{}", ["joint_0.ini", "joint_1.ini", "JOINT_"]),
        ("fanuc-30i", "1", "5", "{detection_unit: 0.001, first_point: 1}", ["axis 5"]),
        # V is the second axis of the letters UVW, which have no place among X, Y, Z, A, B, C: its
        # bit is nobody's guess
        ("heidenhain-itnc530", "X", "Y", "{}", ["entry_X.csv", "entry_Y.csv", "MP710"]),
        ("heidenhain-nck", "X", "V", "{}", ["entry_X.csv", "entry_V.csv"]),
        ("siemens-840d-sl", "AX1", "AX5", "{}", ["synchronised axis AX5"]),
        ("isg-kernel", "1", "5", "{}", ["synchronised axis 5", "achs_kw_log_ax_nr"]),
    ],
)
def test_the_card_names_both_axes(
    tmp_path: Path, control: str, address: str, partner: str, options: str, words: list[str]
) -> None:
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    (tmp_path / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: {control}, options: {options}}}\nstates: {{as_found:"
        " none}\n"
        f'axes:\n  X: {{travel: [0, 800], address: "{address}", gantry: "{partner}", before:'
        " [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    card = (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
    steps = card[: card.index("## Axis X")]
    assert "racks the bridge" in steps
    assert partner in steps
    for word in words:
        assert word in steps


def test_the_number_of_the_leading_axis_is_not_that_of_the_other(tmp_path: Path) -> None:
    """MP710 and the bit of MP730 count axes: with X as axis 1, Y is axis 2, index and bit 1 (TNC
    426/430 p366: MP710.1-8).
    """
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: heidenhain-itnc530}\nstates: {as_found: none}\n"
        "axes:\n  X: {travel: [0, 800], axis_number: 1, gantry: Y, before: [x.csv]}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    card = (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
    assert "  - [ ] X: MP710.0 = " in card
    (line,) = [line for line in card.splitlines() if "X (Y): MP710.1 = " in line]
    assert "MP730 bit 1 = 1" in line


@pytest.mark.parametrize(
    ("kind", "reserved", "no_gantry", "room"),
    [("0", 500, True, True), ("0", 3, True, False), (None, None, False, False)],
)
def test_the_card_asks_only_what_the_files_leave_open(
    tmp_path: Path, kind: str | None, reserved: int | None, no_gantry: bool, room: bool
) -> None:
    """MD37100 = 0: no gantry; MD38000 with room enough: nothing to reserve (Extended Functions
    03/2013 p242).
    """
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, 1)))
    lines = [
        *([f"$MA_GANTRY_AXIS_TYPE[AX1]={kind}"] if kind else []),
        *([f"$MA_MM_ENC_COMP_MAX_POINTS[0,AX1]={reserved}"] if reserved else []),
        "$MA_BACKLASH[0,AX1]=0",
    ]
    (tmp_path / "MD.INI").write_text("\n".join(["CHANDATA(1)", *lines, "M17", ""]))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl, options: {points: 500}}\n"
        "states: {as_found: MD.INI}\n"
        "axes: {X: {travel: [0, 800], address: AX1, before: [x.csv]}}\n"
        "acknowledged: {CW-S008: no table was ever loaded}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    card = (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
    assert ("No gantry: MD37100 = 0" in card) == no_gantry
    assert ("is not a gantry master axis" in card) == (not no_gantry)
    assert ("The control must have room for at least" in card) == (not room)
