"""Refuse a job whose existing table was made from the same test as the new table would be, because
the error would be corrected twice.

A fit adds the error that a test shows to the correction that was active in that test. A test that
was measured before a table was loaded does not show the machine with this table. If the job states
that the test was measured with the table that an earlier run made *from this very test*, the fit
would add that table once more, and again in every further run.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from compwright.controls.decoded_state import DecodedState, judged_values
from compwright.controls.reader_comparison import table_positions
from compwright.documents.plan import read_plan
from compwright.evaluation.rounded_copies import is_coarse, is_rounded_copy, last_digit
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.provenance import fingerprint, share_a_file
from compwright.foundations.session import Session
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.circular import CircularTest
from compwright.records.job import Job
from compwright.records.plan import Plan, PlannedAxis, PlannedTest
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.verification.read_back import SAME
from compwright.workflow.inputs.job_inputs import JobInputs

PLAN = "plan.json"
#: Folders of a result that a run replaces as a whole or fills: what lies there is what it makes,
#: not what it starts from.
_MADE = ("tables", "rollback", "card")
#: From a file of the control up to the folder of the run that made it: tables/<format>/<file>.
_LEVELS_UP = 3
#: The last digit of a control's values, mm (deg), at its coarsest: its files may hold fewer digits
#: than the plan.
_CONTROL_DIGIT = 1e-4
#: Two tables differ in shape where, but for a constant, they are so many steps of the readings
#: apart at more than the rest of the targets.
_MANY = 0.7
_SEEN = 2.5
#: Of two tests that agree in so many readings to the last digit one was made from the other.
_NEARLY_ALL = 0.9
#: A folder with more folders than a machine has jobs is no machine's.
_MOST_SISTERS = 30


@dataclass(frozen=True, slots=True)
class _Earlier:
    """A plan of an earlier run, the path of the plan, and the SHA-256 of the control files that
    this run made.
    """

    plan: Plan
    path: Path
    made: frozenset[str]


def refuse_own_output(
    session: Session,
    job: Job,
    inputs: JobInputs,
    circles: Sequence[tuple[CircularTest, str]],
    folder: Path,
    out: Path,
) -> None:
    """Raise UsageError if a state of the control contains the tables that an earlier run made from
    a test of this job, or if ``as_found`` is in a folder that this run replaces.

    ``circles``: circular tests, each with the name of the state in which it was measured.
    ``folder``: the folder of the job's relative paths. ``out``: the folder to which this run
    writes.
    """
    faults = list(_inside_out(job, folder, out))
    raise_all(UsageError, faults)
    near = [
        (path, storage.earlier_bytes(session, path)) for path in _near(session, job, folder, out)
    ]
    near += [(path, storage.bytes_as_they_are(path)) for path in _of_other_days(folder)]
    for earlier in earlier_plans(near):
        faults.extend(_counted_twice(job, inputs, circles, earlier))
    raise_all(UsageError, list({fault.place: fault for fault in faults}.values()))


def _inside_out(job: Job, folder: Path, out: Path) -> Iterator[Fault]:
    made = [storage.resolved(out / name) for name in _MADE]
    for text in job.states.get("as_found", ()):
        path = storage.resolved(storage.named_from(folder, text))
        if any(below == path or below in path.parents for below in made):
            yield Fault(
                message="this entry is an output of this run, so it cannot be an input",
                file=job.file,
                place="states.as_found",
                expected=(
                    "the control's own files (read back from the control, or a copy) in a separate"
                    " folder, and a test that was measured while they were loaded"
                ),
                found=f"{text}, inside {out}",
                hint=(
                    "copy the files that are read back from the control into a "
                    "folder of their own, and give that folder under `states`"
                ),
            )


def _near(session: Session, job: Job, folder: Path, out: Path) -> Iterator[Path]:
    """Yield the paths where plans of earlier runs may be, near the output and the input files."""
    yield out / PLAN
    yield storage.resolved(out).parent / PLAN  # that of the round before
    for texts in job.states.values():
        for text in texts:
            path = storage.named_from(folder, text)
            yield path / PLAN
            yield from (above / PLAN for above in list(storage.resolved(path).parents)[:_LEVELS_UP])
    measured = (
        storage.named_from(folder, file).parent
        for entry in job.axes.values()
        for request in entry.before
        for file in request.files
    )
    for place in dict.fromkeys((folder, *measured)):
        yield place / PLAN
        yield from storage.in_folders_of(session, place, PLAN)
    yield from storage.in_folders_of(session, storage.resolved(out).parent, PLAN)


def _of_other_days(folder: Path) -> Iterator[Path]:
    """Yield the paths of possible plans in the folders next to the job's folder, where earlier jobs
    of the same machine may be.

    Folders one level below these are searched too. They belong to other jobs, so they are neither
    locked nor repaired.
    """
    sisters = storage.folders_in(storage.resolved(folder).parent)
    for sister in sisters if len(sisters) <= _MOST_SISTERS else ():
        yield sister / PLAN
        inner = storage.folders_in(sister)
        yield from (below / PLAN for below in inner if len(inner) <= _MOST_SISTERS)


def earlier_plans(contents: Iterable[tuple[Path, bytes]]) -> Iterator[_Earlier]:
    """Yield the readable plans among pairs of path and contents, each file once."""
    seen: set[Path] = set()
    for path, content in contents:
        whole = storage.resolved(path)
        if whole in seen:
            continue
        seen.add(whole)
        try:
            plan = read_plan(content, str(path)) if content else None
        except InputError:
            plan = None
        if plan is not None:
            yield _Earlier(plan, path, made_for_the_control(plan))


def made_for_the_control(plan: Plan) -> frozenset[str]:
    """Return the hashes of the control files that a run made, without those files that the run left
    unchanged.
    """
    before = {fingerprint(file.raw) for files in plan.states.values() for file in files}
    return frozenset(
        digest
        for name, digest in plan.results.items()
        if name.startswith("tables/") and digest not in before
    )


def _counted_twice(
    job: Job, inputs: JobInputs, circles: Sequence[tuple[CircularTest, str]], earlier: _Earlier
) -> Iterator[Fault]:
    plan = earlier.plan
    for name, tests in inputs.tests.items():
        for planned in tests:
            state = inputs.states.get(planned.measured_in)
            pairs = [
                (
                    axis,
                    old,
                    last_digit(planned.test)
                    if not same and is_coarse(planned.test, old.test)
                    else 0.0,
                )
                for axis in plan.axes.values()
                for old in axis.tests
                if (same := _same(planned.test, old.test))
                or is_rounded_copy(planned.test, old.test)
            ]
            if state is None or not pairs:
                continue
            made = any(fingerprint(file.raw) in earlier.made for file in state.files)
            if any(_is_own_table(*each, state, job.axes[name].axis, made=made) for each in pairs):
                yield _fault(
                    job, f"axes.{name}.before", planned.test.name, planned.measured_in, earlier
                )
    for test, measured_in in circles:
        state = inputs.states.get(measured_in)
        known = any(share_a_file(test.sources, old.test.sources) for old in plan.circles.values())
        if (
            state is not None
            and known
            and any(fingerprint(file.raw) in earlier.made for file in state.files)
        ):
            yield _fault(job, "circles", test.name, measured_in, earlier)


def _same(test: PositioningTest, old: PositioningTest) -> bool:
    """Return whether two tests are the same measurement, because their files or nearly all of their
    readings are equal.

    A test stays the same measurement if rows are deleted or added. A test with the new table loaded
    has other readings.
    """
    if share_a_file(test.sources, old.sources):
        return True
    mine, theirs = _readings(test), _readings(old)
    known = mine.keys() & theirs.keys()
    same = sum(abs(mine[key] - theirs[key]) <= SAME_READING for key in known)
    return len(known) > 0 and same >= _NEARLY_ALL * min(len(mine), len(theirs))


def _readings(test: PositioningTest) -> dict[tuple[Direction, float, int], float]:
    """Return the readings by direction, target and run."""
    found = {}
    for direction, runs in (
        (Direction.POSITIVE, test.runs_positive),
        (Direction.NEGATIVE, test.runs_negative),
    ):
        block = test.deviations(direction)
        for row, column in np.argwhere(np.isfinite(block)):
            run = int(runs[column]) if column < len(runs) else int(column) + 1
            found[direction, round(float(test.targets[row]), 6), run] = float(block[row, column])
    return found


def _is_own_table(
    planned: PlannedAxis,
    test: PlannedTest,
    digit: float,
    state: DecodedState,
    axis: Axis,
    *,
    made: bool,
) -> bool:
    """Return whether a state of the control contains the table that a plan made from ``test``.
    ``digit``: the last digit of the readings if the job's test is a coarsely rounded copy of that
    test, else 0; ``made``: whether the run of the plan wrote a file of this state.

    It does if the state's correction of the axis differs from the correction that was active during
    the plan's ``test``, and if this difference is the correction that the plan wanted.

    Differences within ``digit`` (mm or deg) are ignored. A state whose files the run did not write
    may contain the same table in another form (a whole backup, fewer digits, without the backlash
    value).
    """
    if planned.fitted is None:
        return False
    new = planned.fitted.compensation
    where = (
        table_positions(new.positions, planned.axis.travel)
        if new.positions.size > 1
        else np.linspace(*planned.axis.travel, 11)
    )
    gaps = [
        judged_values(state, axis.address, where, direction) - new.at(where, direction)
        for direction in Direction
    ]
    change = _change(planned, test, state, axis)
    bent = _bent(change, max(digit, _CONTROL_DIGIT))
    changed = bent if digit else max(float(np.max(np.abs(gap))) for gap in change) > SAME
    as_planned = max(float(np.max(np.abs(gap))) for gap in gaps) <= SAME
    alike = bent and max(float(np.ptp(gap)) for gap in gaps) <= 2.0 * _CONTROL_DIGIT
    return changed and (made or as_planned or alike)


def _bent(curves: Sequence[FloatArray], step: float) -> bool:
    """Return whether one of the ``curves`` is not flat: at many positions it differs from its
    median by several times ``step``.
    """
    return any(
        float(np.quantile(np.abs(curve - np.median(curve)), _MANY)) > _SEEN * step
        for curve in curves
    )


def _change(
    planned: PlannedAxis, test: PlannedTest, state: DecodedState, axis: Axis
) -> list[FloatArray]:
    """Return, for each direction, the correction that the state makes minus the correction that was
    active during ``test``.

    A correction that was active during ``test`` and is unknown counts as zero.
    """
    targets, before, active = test.test.targets, test.acted, planned.active
    if before is None and active is not None and test.measured_in == planned.tests[0].measured_in:
        before = active.at(targets, Direction.POSITIVE), active.at(targets, Direction.NEGATIVE)
    if before is None:
        return [np.zeros_like(targets)]
    return [
        judged_values(state, axis.address, targets, direction) - then
        for direction, then in zip(Direction, before, strict=True)
    ]


def _fault(job: Job, place: str, test: str, state: str, earlier: _Earlier) -> Fault:
    return Fault(
        message=(
            f"an earlier run computed the tables of `states: {state}` from this same test, so the"
            " same correction would be added a second time"
        ),
        file=job.file,
        place=place,
        expected="a test taken with these tables loaded",
        found=f"test {test!r}, which is also in {earlier.path}",
        hint=(
            f"give a test taken with these tables loaded, or set `measured_in` of the test "
            f"{test!r} to the entry of `states` that was active when it was measured"
        ),
    )


def refuse_added_again(plan: Plan, path: Path, state: DecodedState) -> None:
    """Raise UsageError if the control's files already contain the plan's tables between axes."""
    made: Mapping[str, str] = {fingerprint(file.raw): file.name for file in state.files}
    again = [made[digest] for digest in made_for_the_control(plan) if digest in made]
    if again and any(entry.written for entry in plan.cross):
        raise UsageError(
            Fault(
                message="the run that wrote this plan also made these files, so the same "
                "correction between axes would be added a second time",
                file=str(path),
                place="--state",
                expected="the files that were in the control before, or the word none",
                found=", ".join(again),
                hint="give the files that were in the control before the run, or `--state none`",
            )
        )
