"""The loop after loading on variations of a real FANUC backup: compare, verify and new; and what
the tests' own control makes of functions whose amount no page tells.
"""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_real_fanuc_backup import EXAMPLE, NODES, TOTALS, near

from backup_deal_fanuc import make
from backup_files_fanuc import FOLDER, PARAMETERS, PITCH
from judge_fanuc import Played, control_of, judge, run_job
from judge_loaded_fanuc import judge_loaded, judge_new
from virtual_fanuc import Registers, VirtualFanuc, loaded

pytestmark = pytest.mark.short_estimate

needs_backup = pytest.mark.skipif(
    not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
)
UM = 1e-3
LINES = b"%\nN13381Q1L1P1\n%"


def changed(text: bytes, **numbers: bytes) -> Registers:
    """The example of the page with a function of 13381; ``n3623=b"2"``: another value for axis 1."""
    for name, value in numbers.items():
        text, count = re.subn(
            rb"(N0%sQ1A1[PMI])[-0-9.]+" % name[1:].encode(), rb"\g<1>" + value, text
        )
        assert count == 1
    return loaded([text, LINES])


@pytest.mark.parametrize(
    "moved",
    [
        {"n3620": b"41"},
        {"n3621": b"38"},
        {"n3622": b"43"},
        {"n3623": b"2"},
        {"n3624": b"49.0"},
    ],
    ids=str,
)
def test_a_function_that_no_page_tells_stays_with_the_grid_and_goes_with_it(
    moved: dict[str, bytes],
) -> None:
    """New increments leave it alone; another number, interval or magnification makes another."""
    before = VirtualFanuc(changed(EXAMPLE), hidden=5)
    beside = before.correction(1, NODES, 1) - TOTALS
    assert np.ptp(beside) > 0.5 * UM
    new = VirtualFanuc(loaded([EXAMPLE, LINES, b"N10041Q0P7\n"]), hidden=5)
    table = VirtualFanuc(loaded([EXAMPLE, b"N10041Q0P7\n"]))
    assert near(new.correction(1, NODES, 1) - table.correction(1, NODES, 1), beside)
    other = VirtualFanuc(changed(EXAMPLE, **moved), hidden=5)
    plain = replace(other, hidden=0)
    found = other.correction(1, NODES, 1) - plain.correction(1, NODES, 1)
    assert np.abs(found - beside).max() > 0.1 * UM


@pytest.mark.parametrize(
    ("bits", "code", "unit"),
    [
        (b"00000000", b"2", 1e-3),
        (b"00000000", b"1", 2e-3),
        (b"00000000", b"101", 1e-3),
        (b"00000000", b"110", 1e-2),
        (b"00000010", b"20", 1e-5),
        (b"00000001", b"40", 5e-4),
        (b"00000100", b"105", 5e-5),
    ],
)
def test_the_detection_unit_of_both_codings(bits: bytes, code: bytes, unit: float) -> None:
    """1820 = 2 CMR or 100 + 1/CMR; IS-A 0.01, IS-B 0.001, IS-C 0.0001, IS-D 0.00001 mm."""
    text = EXAMPLE.replace(b"N01013Q1A1P00000000", b"N01013Q1A1P" + bits)
    control = VirtualFanuc(loaded([text.replace(b"N01820Q1A1P2A", b"N01820Q1A1P" + code + b"A")]))
    assert control.detection_unit(1) == pytest.approx(unit, rel=1e-12)


# --- the loop
# --------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Played:
    """X, Y or Z of a backup with an inclination, on the grid that is there."""
    return run_job(make("inclination", 100), tmp_path_factory.mktemp("kept"))


@needs_backup
def test_what_is_loaded_is_as_planned_and_good(kept: Played, tmp_path: Path) -> None:
    outcome = judge(kept)
    judge_loaded(outcome, kept)
    assert outcome.faults == [], str(outcome)
    assert outcome.written
    assert [word.split(": ")[0] for word in outcome.verdicts] == ["loaded", "nothing loaded"]


@needs_backup
def test_new_makes_a_job_that_runs(tmp_path: Path) -> None:
    played = run_job(make("units_of_both_codings", 101), tmp_path)
    outcome = judge(played)
    judge_new(outcome, played)
    assert outcome.faults == [], str(outcome)


@needs_backup
def test_a_judge_sees_a_grid_that_moves_and_what_hangs_on_it(kept: Played, tmp_path: Path) -> None:
    """Points, first and last a number further on, reference too: the table is the same, the
    inclination is not.
    """
    shutil.copytree(kept.out, tmp_path / "out")
    spoilt = replace(kept, out=tmp_path / "out")
    axis = kept.job.axes[0].address
    after = control_of(kept.job, loaded(path.read_bytes() for path in kept.tables.iterdir()))
    grid = after.grid(axis)
    path = spoilt.tables / PARAMETERS
    text = path.read_bytes()
    for number, value in ((3620, grid.reference), (3621, grid.first), (3622, grid.last)):
        text = re.sub(
            rb"(?m)^(N0%d.*?A%dP)%d(?=A)" % (number, axis, value),
            rb"\g<1>%d" % (value + 700),
            text,
        )
    path.write_bytes(text)
    pitch = spoilt.tables / PITCH
    lines = {10700 + n: after.registers.pitch[n].encode() for n in range(grid.first, grid.last + 1)}
    pitch.write_bytes(
        re.sub(
            rb"(?m)^N(1\d{4})Q0P-?\d+",
            lambda found: (
                b"N%sQ0P%s" % (found[1], lines[int(found[1])])
                if int(found[1]) in lines
                else found[0]
            ),
            pitch.read_bytes(),
        )
    )
    faults = judge(spoilt).faults
    assert any("moved without a word" in fault for fault in faults), faults
    assert any("HARM" in fault for fault in faults), faults


@needs_backup
def test_a_judge_sees_a_neighbour_that_moves(kept: Played, tmp_path: Path) -> None:
    shutil.copytree(kept.out, tmp_path / "out")
    spoilt = replace(kept, out=tmp_path / "out")
    path = spoilt.tables / PARAMETERS
    text = path.read_bytes()
    path.write_bytes(re.sub(rb"(?m)^(N01851.*?A4P)(-?\d+)", rb"\g<1>77", text))
    assert path.read_bytes() != text
    assert any("HARM axis 4" in fault for fault in judge(spoilt).faults)
