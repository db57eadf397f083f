"""What the INI of a LinuxCNC says of how a joint homes and which steps of its correction it leaves
out. Numbers: homing.c and control.c of the control, seen on a real one
(test_real_linuxcnc_machines.py).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controls.control import decode, open_control
from compwright.foundations.session import Session
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.facts import AxisFacts
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
SWITCH = "HOME_OFFSET = -40\nHOME_SEARCH_VEL = -20\nHOME_LATCH_VEL = -2\n"
RAMP = "MAX_VELOCITY = 200\nMAX_ACCELERATION = 8000\n"


def ini(keys: str, unit: str = "mm") -> str:
    return (
        f"[EMCMOT]\nSERVO_PERIOD = 1000000\n[TRAJ]\nLINEAR_UNITS = {unit}\n"
        f"[JOINT_0]\nBACKLASH = 0.01\n{keys}"
    )


def facts(text: str) -> AxisFacts:
    state = decode(
        open_control(Session(), "linuxcnc", {}), [ControlFile("machine.ini", text.encode())]
    ).state
    return state.facts_of("0")


@pytest.mark.parametrize(
    ("keys", "homing", "place"),
    [
        (SWITCH, "relative", (-40.0, DOWN)),
        (SWITCH.replace("-2\n", "2 # slow\n"), "relative", (-40.0, UP)),
        (SWITCH + "HOME_USE_INDEX = YES\n", "absolute", (None, None)),
        (
            SWITCH + "HOME_USE_INDEX = 1\nHOME_INDEX_NO_ENCODER_RESET = TRUE\n",
            "relative",
            (-40.0, DOWN),
        ),
        (SWITCH + "HOME_ABSOLUTE_ENCODER = 2\n", "absolute", (None, None)),
        ("HOME_OFFSET = -40\n", "absolute", (None, None)),  # homes in place
        ("", "absolute", (None, None)),  # a whole INI without homing: in place
    ],
)
def test_where_homing_counts_the_correction_as_zero(
    keys: str, homing: str, place: tuple[float | None, Direction | None]
) -> None:
    found = facts(ini(keys))
    assert (found.homing, (found.reference, found.reference_return)) == (homing, place)


def test_a_part_of_an_ini_does_not_say_how_the_joint_homes() -> None:
    assert facts("[JOINT_0]\nBACKLASH = 0.01\n").homing == ""


def test_the_place_of_an_inch_machine_stands_in_mm() -> None:
    assert facts(ini(SWITCH, "inch")).reference == pytest.approx(-1016.0)


@pytest.mark.parametrize(
    ("text", "zone"),
    [
        (ini(RAMP), (0.002, 0.004)),
        (ini(RAMP, "inch"), (0.0508, 0.1016)),
        (ini(RAMP).replace("1000000", "500000"), (0.0005, 0.001)),
        (ini(RAMP.replace("200", "4")), (0.002, 0.0015)),  # the velocity starts the ramp earlier
        ("[JOINT_0]\nBACKLASH = 0.01\n", None),
    ],
)
def test_steps_that_are_never_applied(text: str, zone: tuple[float, float] | None) -> None:
    found = facts(text).unapplied_steps
    if zone is None or zone[0] >= zone[1]:
        assert found is None
    else:
        assert found == pytest.approx(zone)


@pytest.mark.parametrize(("reversal", "left"), [(1.9, 1.9), (2.1, 0.0), (3.9, 0.0), (4.1, 4.1)])
def test_a_reversal_within_the_zone_stays(reversal: float, left: float) -> None:
    axis = Axis(
        name="X",
        kind=AxisKind.LINEAR,
        travel=(0.0, 100.0),
        address="0",
        unapplied_steps=(0.002, 0.004),
    )
    flat = np.zeros(2)
    table = AxisCompensation(
        address="0",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 100.0]),
        positive=flat,
        negative=flat - reversal / 1000.0,
    )
    applied = applied_compensation(table, axis)
    where = np.array([0.0, 35.0, 100.0])
    gap = applied.at(where, UP) - applied.at(where, DOWN)
    assert gap * 1000.0 == pytest.approx(np.full(3, left))


@pytest.mark.parametrize("mirrored", [False, True])
def test_behind_the_zone_the_table_is_applied_at_once(mirrored: bool) -> None:
    """By hand: reversal 4 µm up to the middle, then to 10 µm at the end; steps of 2 to 6 µm are left
    out. From the turn at 0 nothing is applied until the table is 6 µm away, at 66.67 mm; there the
    control takes the table's value. Back from 10 µm the table is applied from the turn on.
    """
    axis = Axis(
        name="X",
        kind=AxisKind.LINEAR,
        travel=(0.0, 100.0),
        address="0",
        unapplied_steps=(0.002, 0.006),
    )
    rising, flat = np.array([0.004, 0.004, 0.010]), np.zeros(3)
    table = AxisCompensation(
        address="0",
        kind=AxisKind.LINEAR,
        positions=np.array([0.0, 50.0, 100.0]),
        positive=flat if mirrored else rising,
        negative=rising[::-1] if mirrored else flat,
    )
    applied = applied_compensation(table, axis)
    where = np.array([10.0, 60.0, 66.0, 67.0, 80.0, 95.0])
    stuck = np.array([0.0, 0.0, 0.0, 6.04, 7.6, 9.4])
    there, back = (DOWN, UP) if mirrored else (UP, DOWN)
    along = 100.0 - where if mirrored else where
    assert 1000.0 * applied.at(along, there) == pytest.approx(stuck, abs=1e-9)
    assert 1000.0 * applied.at(along, back) == pytest.approx(np.zeros(6), abs=1e-9)


def run(folder: Path, keys: str, axis: str = "", more: str = "", state: str = "machine.ini") -> int:
    machine = Machine(low=0.0, high=200.0)
    targets = machine.targets()
    (folder / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (folder / "machine.ini").write_text(ini(keys))
    (folder / "job.yaml").write_text(
        f"compwright: 1\ncontroller: {{format: linuxcnc}}\nstates: {{as_found: {state}}}\n"
        f"axes:\n  X: {{travel: [0, 200], address: 0, before: [x.csv]{axis}}}\n{more}"
    )
    return compwright(["run", str(folder / "job.yaml"), "--force"])


FIXED = "fixed_positions: {tool: {X: 0}}\n"


@pytest.mark.parametrize(
    ("axis", "keys", "word"),
    [
        (", reference: 0", SWITCH, "axes.X.reference"),
        (", reference: -40, reference_return: '+'", SWITCH, "axes.X.reference_return"),
    ],
)
def test_a_job_that_contradicts_the_homing_is_asked(
    tmp_path: Path, axis: str, keys: str, word: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, keys, axis) == 2
    message = capsys.readouterr().err
    assert word in message


def test_the_reference_comes_from_the_ini_and_the_table_is_zero_there(tmp_path: Path) -> None:
    assert run(tmp_path, SWITCH.replace("-40", "100"), more=FIXED) == 0
    table = tmp_path / "job" / "tables" / "linuxcnc" / "joint_0.comp"
    rows = np.array([line.split() for line in table.read_text().splitlines()], dtype=float)
    downward = rows[:, 0] - rows[:, 2]  # the switch is left in -
    assert np.interp(100.0, rows[:, 0], downward) == pytest.approx(0.0, abs=2e-7)
    assert abs(np.interp(100.0, rows[:, 0], rows[:, 0] - rows[:, 1])) > 1e-3


def test_fixed_positions_need_to_know_where_the_axis_homes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(tmp_path, "", more=FIXED, state="none") == 2
    assert "axes.X.reference" in capsys.readouterr().err
    assert run(tmp_path, "", axis=", reference: 0", more=FIXED, state="none") == 0


def test_nine_millimetres_are_read_alike(tmp_path: Path) -> None:
    """The control keeps single precision: 9 mm are rounded to 5e-7 mm."""
    rows = "".join(
        f"{x} {x + 2.2e-3 * x:.7f} {x + 2.2e-3 * x + 3e-3:.7f}\n" for x in range(0, 4001, 37)
    )
    files = [ControlFile("joint_0.comp", rows.encode())]
    assert (
        decode(open_control(Session(), "linuxcnc", {}), files).state.axes["0"].positions.size > 100
    )


def test_a_turn_is_repeated_over_the_travel_within_the_rows(tmp_path: Path) -> None:
    targets = np.arange(0.0, 360.0, 15.0)
    rng = np.random.default_rng(4)
    error = 0.004 * np.sin(np.deg2rad(targets))[:, np.newaxis]
    readings = {
        sign: error + (0.001 * (sign < 0)) + rng.normal(0, 1e-5, (24, 3)) for sign in (1, -1)
    }
    (tmp_path / "a.csv").write_text(csv_of(targets, readings, axis="A", unit="deg"))

    def write(travel: str) -> int:
        (tmp_path / "job.yaml").write_text(
            "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\naxes:\n"
            f"  A: {{kind: rotary, travel: {travel}, address: 3, before: [a.csv]}}\n"
        )
        return compwright(["run", str(tmp_path / "job.yaml"), "--force"])

    assert write("[-1000, 800]") == 0
    text = (tmp_path / "job" / "tables" / "linuxcnc" / "joint_3.comp").read_text()
    rows = np.array([line.split() for line in text.splitlines()], dtype=float)
    assert rows[0, 0] <= -1000.0
    assert rows[-1, 0] >= 800.0
    assert rows.shape[0] <= 256
    places = np.arange(-1000.0, 440.0, 7.0)
    for column in (1, 2):
        curve = rows[:, 0] - rows[:, column]
        one, later = (np.interp(places + turn, rows[:, 0], curve) for turn in (0.0, 360.0))
        assert later == pytest.approx(one, abs=2e-7)
    assert write("[-20000, 20000]") == 4
