"""Machines on which a real LinuxCNC does other things than add a table: it homes on a switch, its
ramp leaves steps out, it keeps large corrections in single precision.
"""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation
from linuxcnc_control import REAL_LINUXCNC, Session, measure, run_session, switch_at
from loop import Machine, csv_of

pytestmark = [*REAL_LINUXCNC, pytest.mark.short_estimate]

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
WHOLE = """[KINS]
KINEMATICS = trivkins coordinates=X
JOINTS = 1
[EMCMOT]
SERVO_PERIOD = 1000000
[TRAJ]
LINEAR_UNITS = mm
"""


def run(folder: Path, machine: Machine, state: dict[str, bytes], job: str = "") -> int:
    """A test of ``machine``, with what its job says in addition, in the state ``state``."""
    targets = machine.targets()
    (folder / "x.csv").write_text(csv_of(targets, machine.measure(targets, 1)))
    (folder / "control").mkdir()
    for name, content in state.items():
        (folder / "control" / name).write_bytes(content)
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: [control]}\naxes:\n"
        f"  X: {{travel: [{machine.low}, {machine.high}], address: 0, before: [x.csv]}}\n{job}"
    )
    return compwright(["run", str(folder / "job.yaml"), "--accept-worse"])


def tables(folder: Path) -> dict[str, bytes]:
    found = sorted((folder / "job" / "tables" / "linuxcnc").iterdir())
    return {path.name: path.read_bytes() for path in found}


# --- homing on a switch that is not at the reference


HOMING = """HOME = 0
HOME_OFFSET = -40
HOME_SEARCH_VEL = -20
HOME_LATCH_VEL = 0.1
MAX_VELOCITY = 200
MAX_ACCELERATION = 2000
"""
#: A correction that is nowhere zero, least of all at the switch.
OLD = b"-100 0.012 0.004\n0 0.006 -0.002\n400 -0.010 -0.018\n"


def homed_places(files: dict[str, bytes], stops: list[list[float]]) -> dict[float, float]:
    """Where the motor really stands at stops in +, mm from the place where the control started."""
    session = run_session(files, {"0": AxisKind.LINEAR}, stops, hal=switch_at(0, -0.5))
    assert session.messages == ()
    return {stop.target: stop.place for stop in session.of("0", UP)}


def test_fixed_positions_move_as_the_card_says_where_the_axis_homes_on_a_switch(
    tmp_path: Path,
) -> None:
    joint = "[JOINT_0]\nCOMP_FILE = old.comp\nCOMP_FILE_TYPE = 1\nTYPE = LINEAR\n" + HOMING
    state = {"machine.ini": (WHOLE + joint).encode(), "old.comp": OLD}
    machine = Machine(low=-60.0, high=400.0, slope=60e-6, lost=0.008)
    fixed = "fixed_positions: {tool: {X: 0}, pallet: {X: 300}}\n"
    assert run(tmp_path, machine, state, fixed) == 0
    card = (tmp_path / "job" / "card" / "card.md").read_text(encoding="utf-8")
    printed = {
        float(row[1]): float(row[2].replace("\N{MINUS SIGN}", "-"))
        for row in re.findall(r"^\| (tool|pallet) +\| (\S+) +\| (\S+) +\|", card, re.MULTILINE)
    }
    stops = [[-60.0], [-40.0], [0.0], [300.0], [350.0]]
    written = tables(tmp_path)
    written["joint_0.ini"] += HOMING.encode()
    before = homed_places({"joint_0.ini": joint.encode(), "old.comp": OLD}, stops)
    after = homed_places(written, stops)
    for place in (0.0, 300.0):
        # the switch is seen up to one servo period late, 0.1 µm, in each of both
        assert printed[place] == pytest.approx((after[place] - before[place]) * 1e3, abs=0.15)
    assert abs(printed[300.0]) > 10.0


# --- steps that the ramp never takes


#: mm: curve by position, reversal; one machine on each joint. 8000 mm/s² and 1 ms: 2 to 4 µm.
CASES = (
    (0.0, 0.0019),
    (0.0, 0.0030),
    (0.0, 0.0041),
    (12e-6, 0.0030),
    (-30e-6, 0.0035),
    (5e-6, 0.0022),
)
NODES = np.arange(0.0, 401.0, 50.0)


def case(slope: float, reversal: float) -> tuple[FloatArray, FloatArray]:
    curve = slope * NODES + 0.0005 * np.sin(NODES / 60.0)
    return curve, curve - reversal


def test_what_the_ramp_leaves_out_is_what_the_prediction_leaves_out() -> None:
    files = {}
    for joint, one in enumerate(CASES):
        rows = zip(NODES, *case(*one), strict=True)
        files[f"joint_{joint}.comp"] = "".join(
            f"{x} {a:.7f} {b:.7f}\n" for x, a, b in rows
        ).encode()
        files[f"joint_{joint}.ini"] = (
            f"[JOINT_{joint}]\nCOMP_FILE = joint_{joint}.comp\nCOMP_FILE_TYPE = 1\n"
            "MAX_ACCELERATION = 8000\nMAX_VELOCITY = 200\n"
        ).encode()
    places = np.arange(10.0, 400.0, 20.0)
    way = [*places, 400.0, *places[::-1], 0.0, *places, 400.0, *places[::-1]]
    kinds = {str(joint): AxisKind.LINEAR for joint in range(len(CASES))}
    session = run_session(files, kinds, [[float(x)] * len(CASES) for x in (-0.0, *way)])
    left_out = 0
    for joint, one in enumerate(CASES):
        axis = Axis(
            name="X",
            kind=AxisKind.LINEAR,
            travel=(0.0, 400.0),
            address=str(joint),
            unapplied_steps=(0.002, 0.004),
        )
        positive, negative = case(*one)
        table = AxisCompensation(
            address=str(joint),
            kind=AxisKind.LINEAR,
            positions=NODES,
            positive=positive,
            negative=negative,
        )
        applied = applied_compensation(table, axis)
        later_stops = [stop for stop in session.of(str(joint)) if stop.number > 2 * places.size]
        assert len(later_stops) > 2 * places.size
        for stop in later_stops:
            assert stop.direction is not None
            where = np.array([stop.target])
            assert stop.correction == pytest.approx(
                float(applied.at(where, stop.direction)[0]), abs=2e-7
            )
            left_out += abs(stop.correction - float(table.at(where, stop.direction)[0])) > 1e-3
    assert left_out > 20  # stops at which a table is not applied


def test_a_reversal_that_stays_is_predicted_to_stay(tmp_path: Path) -> None:
    """3 µm at 8000 mm/s² and 1 ms."""
    keys = "MAX_VELOCITY = 200\nMAX_ACCELERATION = 8000\n"
    state = {"machine.ini": f"{WHOLE}[JOINT_0]\nTYPE = LINEAR\n{keys}".encode()}
    machine = Machine(low=0.0, high=400.0, slope=0.0, bow=0.0, lost=0.003, noise=0.0002)
    assert run(tmp_path, machine, state) == 0
    predicted = json.loads((tmp_path / "job" / "prediction.json").read_text())["axes"]["X"]
    written = tables(tmp_path)
    written["joint_0.ini"] += keys.encode()
    up, down = measure(
        written, lambda x, side: machine.error(x, side.sign), machine.targets(), runs=1
    )
    left = float(np.mean(up - down)) * 1e3
    assert abs(left) > 2.5
    assert predicted["predicted"]["B_mean"]["p05"] < left < predicted["predicted"]["B_mean"]["p95"]
    causes = {cause["cause"]: cause["value"] for cause in predicted["limits"]}
    assert causes["steps that the control never applies"] > 2.0
    assert "CW-P156" in {finding["code"] for finding in predicted["findings"]}


# --- large corrections


def test_corrections_of_nine_millimetres_are_written_and_applied(tmp_path: Path) -> None:
    machine = Machine(low=0.0, high=4000.0, slope=2.2e-3, bow=0.5, lost=0.003)
    state = {"machine.ini": f"{WHOLE}[JOINT_0]\nTYPE = LINEAR\nBACKLASH = 0\n".encode()}
    assert run(tmp_path, machine, state) in (0, 1)  # 1: deviations this large are a doubt
    files = tables(tmp_path)
    rows = np.array([line.split() for line in files["joint_0.comp"].split(b"\n")[:-1]], dtype=float)
    planned = rows[:, :1] - rows[:, 1:]
    assert np.max(np.abs(planned)) > 8.5
    shown = rows[:: len(rows) // 20, 0]
    stops = [[float(x)] for x in (-5.0, *shown, 4005.0, *shown[::-1])]
    session: Session = run_session(files, {"0": AxisKind.LINEAR}, stops)
    for stop in session.of("0"):
        curve = planned[:, 0 if stop.direction is UP else 1]
        # frozen 2e-3 mm before the stop, at a slope of 3e-3
        assert stop.correction == pytest.approx(
            float(np.interp(stop.target, rows[:, 0], curve)), abs=1e-5
        )


# --- a rotary axis over several turns


def turning_error(positions: FloatArray, direction: Direction) -> FloatArray:
    """A table's error: the same after every turn, deg."""
    u = np.deg2rad(positions)
    lost = 0.0015 if direction is DOWN else 0.0
    return 0.004 * np.sin(u + 0.4) + 0.001 * np.cos(2.0 * u) + lost


@pytest.mark.parametrize(
    ("travel", "rows", "close"), [((-720.0, 720.0), 256, 1e-4), ((-10000.0, 10000.0), 256, 0.002)]
)
def test_one_measured_turn_serves_every_turn(
    tmp_path: Path, travel: tuple[float, float], rows: int, close: float
) -> None:
    rng = np.random.default_rng(5)
    targets = np.round(np.arange(6.0, 360.0, 12.0) + rng.uniform(-2.0, 2.0, 30), 3)
    readings = {
        side.sign: turning_error(targets, side)[:, np.newaxis] + rng.normal(0.0, 1e-5, (30, 5))
        for side in (UP, DOWN)
    }
    (tmp_path / "a.csv").write_text(csv_of(targets, readings, axis="A", unit="deg"))
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: linuxcnc}\nstates: {as_found: none}\naxes:\n"
        f"  A: {{kind: rotary, travel: {list(travel)}, address: 0, before: [a.csv]}}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 0
    files = tables(tmp_path)
    assert files["joint_0.comp"].count(b"\n") <= rows
    way = (-719.0, -360.0, -90.3, 0.0, 359.9, 360.1, 719.0, 360.1, 359.9, 0.0, -0.1, -360.0, -720.0)
    session = run_session(
        files, {"0": AxisKind.ROTARY}, [[max(travel[0], -720.0)], *([x] for x in way)]
    )
    assert session.messages == ()
    stops = [stop for stop in session.of("0") if stop.number > 0]
    zero = float(turning_error(np.array([0.0]), UP)[0])
    for stop in stops:
        assert stop.direction is not None
        wanted = zero - float(turning_error(np.array([stop.target]), stop.direction)[0])
        assert stop.correction == pytest.approx(wanted, abs=close)
    by_place = {(stop.target, stop.direction): stop.correction for stop in stops}
    # across the seam nothing jumps, and a turn later all is the same
    for side in (UP, DOWN):
        assert by_place[359.9, side] == pytest.approx(by_place[360.1, side], abs=5e-5)
    assert by_place[-360.0, DOWN] == pytest.approx(by_place[0.0, DOWN], abs=1e-6)
    assert by_place[-720.0, DOWN] == pytest.approx(by_place[0.0, DOWN], abs=1e-6)
    after, words = (
        tmp_path / "after.csv",
        ["--loaded", str(tmp_path / "job" / "tables" / "linuxcnc")],
    )
    nominal, *actual = np.array(
        [line.split() for line in files["joint_0.comp"].split(b"\n")[:-1]], dtype=float
    ).T
    loaded = {
        side.sign: turning_error(targets, side)[:, np.newaxis]
        + np.interp(targets, nominal, nominal - column)[:, np.newaxis]
        + rng.normal(0.0, 1e-5, (30, 5))
        for side, column in zip((UP, DOWN), actual, strict=True)
    }
    after.write_text(csv_of(targets, loaded, axis="A", unit="deg"))
    words += ["--after", str(after), "--out", str(tmp_path / "v")]
    assert compwright(["verify", str(tmp_path / "job.yaml"), *words]) == 0
    verdict = json.loads((tmp_path / "v" / "verification.json").read_text())
    assert verdict["axes"]["A"]["loading"]["verdict"] == "loaded"
