"""``simulate``: make measurement files of a virtual machine, with or without loaded tables."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from compwright.controls.control import JOB_PLACE, Origin, decode, open_control
from compwright.controls.control_files import read_control
from compwright.controls.judged_corrections import active_corrections
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.input_sizes import MACHINE
from compwright.foundations.session import Session
from compwright.prediction.active_corrections import NO_CORRECTIONS, ActiveCorrections
from compwright.prediction.circular import moved_test
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularRun
from compwright.records.positioning import PositioningTest
from compwright.simulation.circular import CircleRecording, Traverse
from compwright.simulation.circular_files import to_b5r, to_circular_csv
from compwright.simulation.files import to_csv
from compwright.simulation.machine import VirtualMachine
from compwright.simulation.reading import read_machine
from compwright.workflow.results.own_files import write_listed

#: What every simulated CSV says of itself: it proves nothing of a machine.
SIMULATED = {"simulated": "by compwright, not measured on a machine"}


def load_machine(session: Session, path: Path) -> VirtualMachine:
    """Read the file of a virtual machine. Raises UsageError with all faults, or InputError."""
    return read_machine(storage.read_bytes(session, path, MACHINE), str(path))


def simulate_files(
    session: Session,
    machine: VirtualMachine,
    out: Path,
    *,
    seed: int = 0,
    tables: Path | None = None,
    force: bool = False,
    file: str = "",
) -> list[Path]:
    """Measure every axis and every circle of a virtual machine, and write a measurement file for
    each axis and circle into ``out``. ``tables``: the folder with the tables that are loaded in its
    control, None for no tables.

    ``file``: the name of the machine file in messages. Noise depends on ``seed`` alone, so the same
    seed gives the same bytes.
    """
    measured = simulated(session, machine, seed=seed, tables=tables, file=file)
    files = dict(_file_of(machine, name, test) for name, test in measured.items())
    return write_listed(session, out, files, command="simulate", force=force, as_set=True)


def simulated(
    session: Session,
    machine: VirtualMachine,
    *,
    seed: int = 0,
    tables: Path | None = None,
    file: str = "",
) -> dict[str, PositioningTest | CircleRecording]:
    """Return the simulated test of every axis and circle by name. ``tables``: the folder with the
    tables that are loaded in the machine's control, None for no tables. Raises UsageError,
    InputError.
    """
    loaded = NO_CORRECTIONS if tables is None else _loaded(session, machine, tables, file)
    tests: dict[str, PositioningTest | CircleRecording] = {}
    for number, name in enumerate(machine.axes):
        rng = np.random.default_rng([seed, number])
        tests[name] = machine.measure(name, rng=rng, correction=loaded.along.get(name))
    between = replace(loaded, along={})
    for number, name in enumerate(machine.circles, start=len(machine.axes)):
        recording = machine.record_circle(
            name,
            seed=int(np.random.SeedSequence([seed, number]).generate_state(1)[0]),
            corrections=loaded.along,
        )
        tests[name] = _bent(recording, between)
    return tests


def _file_of(
    machine: VirtualMachine, name: str, test: PositioningTest | CircleRecording
) -> tuple[str, bytes]:
    """Return name and contents of the measurement file for a simulated test."""
    if isinstance(test, PositioningTest):
        return f"{name.lower()}.csv", to_csv(test, SIMULATED)
    about = {
        key: text for key, text in (("machine", machine.name), ("serial", machine.serial)) if text
    }
    form = machine.circles[name].format
    return (
        f"{name.lower()}.{form}",
        to_b5r(test, about)
        if form == "b5r"
        else to_circular_csv(test.test, {**about, **SIMULATED}),
    )


def _bent(recording: CircleRecording, between: ActiveCorrections) -> CircleRecording:
    """Return the recording of a circle after the active cross-axis corrections of its two axes have
    displaced the path.
    """
    plan = recording.plan
    step = plan.arc[1] / plan.samples
    whole = []
    for traverse in recording.traverses:
        along: FloatArray = (
            np.arange(traverse.readings.size, dtype=np.float64) - traverse.start + 0.5
        ) * step
        angles = recording.test.arc[0] + (
            along if traverse.run.sense == "ccw" else plan.arc[1] - along
        )
        whole.append(replace(traverse.run, angles=angles, deviations=traverse.readings))
    moved = moved_test(
        replace(recording.test, runs=tuple(whole)), plan.centre, between.displacement(plan.axes)
    )
    traverses = tuple(
        _rerecorded(*pair) for pair in zip(recording.traverses, moved.runs, strict=True)
    )
    runs = sorted((traverse.run for traverse in traverses), key=lambda run: (run.sense, run.number))
    return replace(recording, test=replace(recording.test, runs=tuple(runs)), traverses=traverses)


def _rerecorded(traverse: Traverse, moved: CircularRun) -> Traverse:
    within = moved.deviations[traverse.start : traverse.end + 1]
    return replace(
        traverse, readings=moved.deviations, run=replace(traverse.run, deviations=within)
    )


def _loaded(
    session: Session, machine: VirtualMachine, tables: Path, file: str
) -> ActiveCorrections:
    """Return the corrections that the control of the virtual machine makes with the tables in a
    folder, along axes and between axes.
    """
    if not machine.format:
        raise UsageError(
            Fault(
                message="the machine file contains no control",
                file=file,
                place=JOB_PLACE,
                expected="the key `controller`, which states the format of the tables",
                hint="add `controller: {format: ID}` to the machine file",
            )
        )
    origin = Origin(file, JOB_PLACE, "controller.options.", Path(file).parent)
    control = open_control(session, machine.format, machine.options, origin)
    axes = {
        name: replace(virtual.axis, address=control.format.address(virtual.axis)[0])
        for name, virtual in machine.axes.items()
    }
    known = [axis.address for axis in axes.values()]
    decoded = decode(control, read_control(session, control, [tables]), list(axes.values()))
    unknown = sorted(set(decoded.state.axes) - set(known))
    raise_all(
        InputError,
        [
            Fault(
                message=(f"there is a table for axis {address}, which this machine does not have"),
                file=str(tables),
                expected=", ".join(known),
                hint="give tables for the axes of this machine",
            )
            for address in unknown
        ],
    )
    return active_corrections(decoded, axes)
