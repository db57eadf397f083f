"""The whole loop on a real control: what compwright exports is loaded by LinuxCNC itself, and
LinuxCNC judges it.

The applied correction must agree with the plan below 1e-6 mm (deg): the files hold seven decimals
(5e-8), the control keeps single precision (6e-8 relative) and stands still up to 1e-4 of its speed
before a stop (3e-7 measured).
"""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.documents.plan import read_plan
from compwright.records.axis import AxisKind, Direction
from compwright.records.plan import Plan
from linuxcnc_control import (
    REAL_LINUXCNC,
    Session,
    applied_corrections,
    measure_joints,
    run_session,
)
from loop import Floats, Machine, accuracy, allowed, csv_of

pytestmark = [*REAL_LINUXCNC, pytest.mark.short_estimate]

AGREES = 1e-6  # mm, deg
KINDS = {"0": AxisKind.LINEAR, "1": AxisKind.LINEAR, "2": AxisKind.ROTARY}
#: X: plain; Y: negative travel, referenced in -; a rotary axis in deg with 20 arcsec of error and
#: 11 arcsec of lost motion.
MACHINES = {
    "0": Machine(),
    "1": Machine(low=-500, high=0, slope=-40e-6, lost=0.003, reference_return=-1),
    "2": Machine(low=-90, high=90, slope=30e-6, bow=0.004, lost=0.003, noise=0.0003),
}
NAMES = {"0": "X", "1": "Y", "2": "A"}


def error_of(machine: Machine, positions: Floats, direction: Direction) -> Floats:
    return machine.error(positions, direction.sign)


ERRORS = {joint: partial(error_of, machine) for joint, machine in MACHINES.items()}


def write_job(folder: Path, states: str) -> Path:
    axes = []
    for joint, machine in MACHINES.items():
        axes.append(
            f"  {NAMES[joint]}: {{kind: {KINDS[joint].value}, travel: [{machine.low},"
            f" {machine.high}], address: {joint}, reference_return:"
            f" '{'+' if machine.reference_return > 0 else '-'}', before: [{NAMES[joint]}.csv]}}"
        )
    text = (
        f"compwright: 1\ncontroller: {{format: linuxcnc}}\nstates: {{as_found: {states}}}\naxes:\n"
        + "\n".join(axes)
        + "\n"
    )
    job = folder / "job.yaml"
    job.write_text(text)
    return job


def measured(
    files: dict[str, bytes], seed: int, targets: dict[str, Floats]
) -> dict[str, dict[int, Floats]]:
    """A test of all joints with ``files`` loaded in the real control, the machines' errors behind
    its motor positions.
    """
    found = {}
    means = measure_joints(files, KINDS, ERRORS, targets, runs=5)
    rng = np.random.default_rng(seed)
    for joint, (positive, negative) in means.items():
        noise = MACHINES[joint].noise
        found[joint] = {
            1: positive + rng.normal(0, noise, positive.shape),
            -1: negative + rng.normal(0, noise, negative.shape),
        }
    return found


def one_round(
    folder: Path, active: dict[str, bytes], states: str, seed: int
) -> tuple[dict[str, bytes], Plan, dict[str, float]]:
    """Measure on the real control, run compwright; return the new files, the plan and A before (mm
    or deg).
    """
    folder.mkdir()
    targets = {joint: machine.targets() for joint, machine in MACHINES.items()}
    before = measured(active, seed, targets)
    for joint, readings in before.items():
        unit = "deg" if KINDS[joint] is AxisKind.ROTARY else "mm"
        (folder / f"{NAMES[joint]}.csv").write_text(
            csv_of(targets[joint], readings, axis=NAMES[joint], unit=unit)
        )
    code = compwright(["run", str(write_job(folder, states)), "--out", str(folder / "out")])
    tables = {
        path.name: path.read_bytes()
        for path in sorted((folder / "out" / "tables" / "linuxcnc").iterdir())
    }
    plan = read_plan((folder / "out" / "plan.json").read_bytes(), "plan.json")
    # An axis that is good already may keep its table: then, and only then, the run ends with 1.
    assert code == (0 if all(axis.fitted for axis in plan.axes.values()) else 1)
    return tables, plan, {joint: accuracy(readings) for joint, readings in before.items()}


@pytest.fixture(scope="module")
def first_round(
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[Path, dict[str, bytes], Plan, dict[str, float]]:
    folder = tmp_path_factory.mktemp("loop") / "first"
    return folder, *one_round(folder, {}, "none", seed=1)


def planned(plan: Plan, joint: str, position: float, direction: Direction) -> float:
    fitted = plan.axes[NAMES[joint]].fitted
    assert fitted is not None
    return float(fitted.compensation.at(np.array(position), direction))


def stops_over(plan: Plan) -> list[list[float]]:
    """Stops that show each table: nodes, between, outside on both sides, and reversals in
    mid-travel.
    """
    ways = {}
    for joint, name in NAMES.items():
        fitted = plan.axes[name].fitted
        assert fitted is not None
        nodes = fitted.compensation.positions
        step = float(np.mean(np.diff(nodes)))
        shown = nodes[np.linspace(0, nodes.size - 1, 12).astype(int)]
        between = shown[:-1] + 0.37 * step
        up = np.sort(
            np.concatenate([shown, between, [nodes[0] - 1.7 * step, nodes[-1] + 1.7 * step]])
        )
        middle = float(nodes[nodes.size // 2])
        turns = [middle + 0.2 * step, middle - 0.3 * step, middle + 0.1 * step, middle - 0.1 * step]
        ways[joint] = np.concatenate([up, up[::-1], turns])
    return [
        [float(value) for value in row] for row in np.column_stack([ways[joint] for joint in NAMES])
    ]


def test_the_control_applies_what_the_plan_says(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]],
) -> None:
    _, files, plan, _ = first_round
    stops = [
        stop
        for stop in applied_corrections(files, KINDS, stops_over(plan))
        if stop.direction is not None
    ]
    worst = max(
        abs(stop.correction - planned(plan, stop.joint, stop.target, stop.direction))
        for stop in stops
        if stop.direction is not None
    )
    assert len(stops) > 3 * 50
    assert worst < AGREES


def test_accuracy_falls_to_the_noise_floor_on_the_real_control(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]],
) -> None:
    _, files, plan, before = first_round
    targets = {joint: machine.targets(seed=8) for joint, machine in MACHINES.items()}  # new ones
    after = measured(files, 2, targets)
    for joint, machine in MACHINES.items():
        fitted = plan.axes[NAMES[joint]].fitted
        assert fitted is not None
        limit = allowed(
            machine, targets[joint], float(np.max(np.diff(fitted.compensation.positions)))
        )
        assert before[joint] > 3 * limit
        assert accuracy(after[joint]) <= limit


def test_verify_says_loaded(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]], tmp_path: Path
) -> None:
    folder, files, _, _ = first_round
    targets = {joint: machine.targets() for joint, machine in MACHINES.items()}
    words = []
    for joint, readings in measured(files, 3, targets).items():
        unit = "deg" if KINDS[joint] is AxisKind.ROTARY else "mm"
        path = tmp_path / f"{NAMES[joint]}.csv"
        path.write_text(csv_of(targets[joint], readings, axis=NAMES[joint], unit=unit))
        words += ["--after", str(path)]
    code = compwright(
        [
            "verify",
            str(folder / "job.yaml"),
            *words,
            "--plan",
            str(folder / "out"),
            "--out",
            str(tmp_path / "out"),
            "--json",
            str(tmp_path / "v.json"),
        ]
    )
    verdict = json.loads((tmp_path / "v.json").read_text())
    assert {
        name: axis["loading"]["verdict"] for name, axis in verdict["axes"].items()
    } == dict.fromkeys(NAMES.values(), "loaded")
    assert (code, verdict["verdict"]) == (0, "good")


def test_an_old_table_in_the_control_is_taken_into_account(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]], tmp_path: Path
) -> None:
    """The table of the first round, made wrong by 40 µm/m and 5 µm of lost motion, is active while
    the axis is measured.
    """
    _, files, _, _ = first_round
    old = dict(files)
    rows = [
        [float(word) for word in line.split()]
        for line in files["joint_0.comp"].decode().splitlines()
    ]
    old["joint_0.comp"] = "".join(
        f"{x:.7f} {a + 40e-6 * x:.7f} {b + 40e-6 * x - 0.005:.7f}\n" for x, a, b in rows
    ).encode()
    control = tmp_path / "control"
    control.mkdir()
    for name, content in old.items():
        (control / name).write_bytes(content)
    new, plan, before = one_round(tmp_path / "second", old, f"[{control}]", seed=4)
    targets = {joint: machine.targets(seed=9) for joint, machine in MACHINES.items()}
    after = accuracy(measured({**old, **new}, 5, targets)["0"])
    fitted = plan.axes["X"].fitted
    assert fitted is not None
    limit = allowed(
        MACHINES["0"], targets["0"], float(np.max(np.diff(fitted.compensation.positions)))
    )
    assert before["0"] > 3 * limit
    assert after <= limit


# Faults between the export and the control
# -------------------------------------------------------------------------------------


def lines_of(files: dict[str, bytes]) -> list[str]:
    return files["joint_0.comp"].decode().splitlines()


def with_lines(files: dict[str, bytes], lines: list[str]) -> dict[str, bytes]:
    return {**files, "joint_0.comp": ("\n".join(lines) + "\n").encode()}


def swapped(line: str) -> str:
    position, positive, negative = line.split()
    return f"{position} {negative} {positive}"


FAULTS: dict[str, Callable[[dict[str, bytes]], dict[str, bytes]]] = {
    "a header line": lambda files: with_lines(
        files, ["position forward reverse", *lines_of(files)]
    ),
    "a blank line in the middle": lambda files: with_lines(
        files, [*lines_of(files)[:5], "", *lines_of(files)[5:]]
    ),
    "columns exchanged": lambda files: with_lines(
        files, [swapped(line) for line in lines_of(files)]
    ),
    "the wrong type": lambda files: {
        **files,
        "joint_0.ini": files["joint_0.ini"].replace(b"COMP_FILE_TYPE = 0", b"COMP_FILE_TYPE = 1"),
    },
    "a lost row": lambda files: with_lines(files, [*lines_of(files)[:7], *lines_of(files)[8:]]),
    "300 rows": lambda files: with_lines(
        files, [f"{x:.3f} {x:.7f} {x:.7f}" for x in np.linspace(0, 800, 300)]
    ),
}


def as_joint(number: int, files: dict[str, bytes]) -> dict[str, bytes]:
    """The files of joint 0 under the name of another joint, for several cases in one session."""
    name, section = f"joint_{number}", f"[JOINT_{number}]".encode()
    own = (
        files["joint_0.ini"]
        .replace(b"[JOINT_0]", section)
        .replace(b"joint_0.comp", f"{name}.comp".encode())
    )
    assert own.count(section) == 1
    return {f"{name}.ini": own, f"{name}.comp": files["joint_0.comp"]}


@pytest.fixture(scope="module")
def faulty_joints(first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]]) -> Session:
    """One session in which each joint has the files of X with one of the faults; behind them one
    with the files as they are.
    """
    _, files, plan, _ = first_round
    cases = [fault(files) for fault in FAULTS.values()] + [files]
    given = {
        name: content
        for number, case in enumerate(cases)
        for name, content in as_joint(number, case).items()
    }
    # more than six joints: the others are rotary ones, with the same numbers in deg
    kinds = {
        str(number): AxisKind.LINEAR if number < 6 else AxisKind.ROTARY
        for number in range(len(cases))
    }
    return run_session(given, kinds, [[stop[0]] * len(cases) for stop in stops_over(plan)])


def worst_of(session: Session, joint: int, plan: Plan) -> float:
    """Return how far the control is from the plan of X, mm."""
    stops = [stop for stop in session.of(str(joint)) if stop.direction is not None]
    assert len(stops) > 50
    return max(
        abs(stop.correction - planned(plan, "0", stop.target, stop.direction))
        for stop in stops
        if stop.direction
    )


def test_files_without_a_fault_are_applied_in_the_same_session(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]], faulty_joints: Session
) -> None:
    assert worst_of(faulty_joints, len(FAULTS), first_round[2]) < AGREES
    assert not [message for message in faulty_joints.messages if f"joint {len(FAULTS)}" in message]


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_on_the_way_to_the_control_is_caught(
    first_round: tuple[Path, dict[str, bytes], Plan, dict[str, float]],
    faulty_joints: Session,
    name: str,
    tmp_path: Path,
) -> None:
    """The real control does something else with the faulty file, and reading it back says so before
    anything is measured.
    """
    folder, files, plan, _ = first_round
    faulty = FAULTS[name](files)
    joint = list(FAULTS).index(name)
    said = [message for message in faulty_joints.messages if f"joint {joint}:" in message]
    assert said or worst_of(faulty_joints, joint, plan) > AGREES
    words = []
    for file, content in faulty.items():
        (tmp_path / file).write_bytes(content)
        words += ["--loaded", str(tmp_path / file)]
    after = [word for axis in NAMES.values() for word in ("--after", str(folder / f"{axis}.csv"))]
    code = compwright(
        [
            "verify",
            str(folder / "job.yaml"),
            *after,
            "--plan",
            str(folder / "out"),
            "--out",
            str(tmp_path / "out"),
            *words,
        ]
    )
    if code == 3:
        return  # the file is refused: the control would cut it silently
    verdict = json.loads((tmp_path / "out" / "verification.json").read_text())
    codes = [finding["code"] for finding in verdict["axes"]["X"]["findings"]]
    assert code == 1
    assert "CW-V011" in codes
