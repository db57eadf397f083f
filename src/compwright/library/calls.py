"""The functions of the library. Each call has its own session, so calls in several threads share
nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from compwright.documents.evaluation import result_document
from compwright.evaluation.standards import DEFAULT_STANDARD
from compwright.evaluation.standards import evaluate as evaluate_positioning
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.session import Session
from compwright.foundations.units import outside_unit
from compwright.library.argument_names import in_argument_names
from compwright.library.results import (
    Comparison,
    DecodedFiles,
    EstimatedError,
    Evaluation,
    JobPlan,
    LoadedJob,
    Verification,
)
from compwright.records.axis import PositionMap
from compwright.records.circular import CircularTest
from compwright.records.positioning import PositioningTest, to_machine
from compwright.workflow.commands.evaluate import all_tests
from compwright.workflow.inputs.file_evaluation import tests_in
from compwright.workflow.inputs.measurement_files import load_profile

if TYPE_CHECKING:
    PathName = str | Path
    MeasuredTest = PositioningTest | CircularTest


@in_argument_names
def read(source: PathName | Any, *, profile: PathName | None = None) -> list[MeasuredTest]:
    """Read the tests of a measurement file, of every file of a folder, or of a pandas table; return
    them as a list.

    A pandas table has the columns of the plain CSV form, and the comment keys of that form in
    ``attrs``. Deviations are measured minus target in mm or deg, as in the file: not yet in machine
    coordinates. ``profile``: the mapping profile of a table of another program. Raises InputError
    with every fault of every file.
    """
    session = Session()
    mapping = None if profile is None else load_profile(session, Path(profile))
    if not isinstance(source, str | Path):
        keys = "".join(f"# {key}: {value}\n" for key, value in source.attrs.items())
        return list(tests_in(f"{keys}{source.to_csv(index=False)}".encode(), "table", mapping))
    return all_tests(session, Path(source), mapping)


@in_argument_names
def evaluate(
    test: MeasuredTest | Sequence[MeasuredTest] | PathName,
    standard: str | None = None,
    *,
    spread: Literal["std", "range"] = "std",
) -> Evaluation:
    """Evaluate a test, or a list or file with one test, to a standard. ``spread``: standard
    deviations are calculated from all readings (``std``) or from their range (``range``).

    ``standard``: an id such as ``iso230-2:2014`` (the default of positioning tests), ``gost27843``,
    ``vdi3441`` or ``iso230-4:2005`` (of circular tests). Parameters are in um or arcsec. Raises
    InputError for a test that cannot be evaluated. Raises UsageError for an unknown standard, for a
    standard of the other kind of test, and for a file with several tests.
    """
    if not isinstance(test, PositioningTest | CircularTest):
        tests = test if isinstance(test, list | tuple) else read(test)
        if len(tests) != 1:
            listed = isinstance(test, list | tuple)
            raise UsageError(
                Fault(
                    message="one test is evaluated at a time",
                    file="" if listed else str(test),
                    found=str(len(tests)),
                    hint="give one of its tests: `evaluate(read(path)[0])`",
                )
            )
        test = tests[0]
    if isinstance(test, CircularTest):
        from compwright.documents.circular import circular_document
        from compwright.evaluation.circular import (
            DEFAULT_CIRCULAR_STANDARD,
            circular_standard_by_id,
        )
        from compwright.planning.circle_diagnosis import diagnose_circle

        edition = circular_standard_by_id(standard or DEFAULT_CIRCULAR_STANDARD).id
        return Evaluation(circular_document(diagnose_circle(test, edition)))
    result = evaluate_positioning(test, standard or DEFAULT_STANDARD, spread=spread)
    return Evaluation(result_document(result))


@in_argument_names
def estimate(
    tests: MeasuredTest | Sequence[MeasuredTest],
    *,
    travel: tuple[float, float] | None = None,
    screw_pitch: Sequence[float] = (),
    sense: Literal[1, -1] = 1,
    offset: float = 0.0,
) -> EstimatedError:
    """Estimate the error of an axis (measured minus target) with its uncertainty from its tests.

    ``travel``: mm or deg, machine coordinates; default: from the first to the last target.
    ``screw_pitch``: known periods of the error, mm or deg. ``sense`` and ``offset`` convert the
    instrument's coordinates: machine = sense * instrument + offset. A ``sense`` of -1 also
    exchanges the directions of approach and the sign of the deviations. Compensation that was
    active during the tests is part of the error.

    Raises UsageError if there is no test, for circular tests, for tests of several axes and for an
    empty travel. Raises InputError for readings at fewer than two targets.
    """
    from compwright.estimation.axis import estimate_axis
    from compwright.estimation.noise import infer_noise
    from compwright.estimation.observed_test import ObservedTest

    measured = _several(tests)
    given = [test for test in measured if isinstance(test, PositioningTest)]
    if len(given) < len(measured):
        raise UsageError(
            Fault(
                message="a circular test does not show the error at each position of an axis",
                hint="give positioning tests; for a circular test "
                "`evaluate(test).diagnosis` contains the causes of its deviations",
            )
        )
    axes = sorted({test.axis for test in given})
    if len(axes) > 1:
        raise UsageError(
            Fault(
                message="the tests belong to several axes",
                found=", ".join(axes),
                hint='give the tests of one axis: `[test for test in tests if test.axis == "X"]`',
            )
        )
    mapped = [to_machine(test, PositionMap(sense, offset)) for test in given]
    span = travel
    if span is None and mapped:
        ends = [target for test in mapped for target in (test.targets[0], test.targets[-1])]
        span = (float(min(ends)), float(max(ends)))
    posterior = estimate_axis(
        [ObservedTest(test=test, noise=infer_noise(test)) for test in mapped],
        travel=span or (0.0, 0.0),
        periods=tuple(screw_pitch),
    )
    unit = outside_unit(posterior.kind.unit)
    return EstimatedError(axes[0], unit, posterior.measured, posterior)


@in_argument_names
def load_job(path: PathName) -> LoadedJob:
    """Read and check a job file. Raises UsageError with all faults, or InputError."""
    from compwright.workflow.inputs.jobs import default_folder, read_job_file

    session, file = Session(), Path(path)
    return LoadedJob(file, default_folder(session, file), read_job_file(session, file))


@in_argument_names
def plan(job: LoadedJob | PathName, *, accept_worse: bool = False) -> JobPlan:
    """Run a job: evaluate its tests, fit and write tables, read the written files back, predict the
    next test. ``accept_worse``: also make a table that would not improve its axis.

    Raises UsageError, InputError and CapacityError.
    """
    from compwright.workflow.commands.run import planned

    session = Session()
    loaded = job if isinstance(job, LoadedJob) else load_job(job)
    done = planned(
        session, loaded.record, loaded.path.parent, loaded.out, accept_worse=accept_worse
    )
    return JobPlan(done.results.prediction, loaded, done.exit_code, done)


@in_argument_names
def verify(
    job: LoadedJob | PathName,
    after: PathName | MeasuredTest | Sequence[PathName | MeasuredTest],
    *,
    plan: PathName | None = None,
    loaded: PathName | Sequence[PathName] = (),
) -> Verification:
    """Compare the tests after loading (``after``) with the plan, and with ``loaded``, the files
    read back from the control. No file is written.

    ``after``: the tests, or their files, each a path or ``"TEST=FILE"``. ``plan``: the folder of a
    run or its ``plan.json``; default: that of the job. Raises UsageError and InputError, also if
    the plan belongs to another job.
    """
    from compwright.workflow.commands.verify import plan_path, verification_of

    session = Session()
    given = job if isinstance(job, LoadedJob) else load_job(job)
    file = plan_path(session, None if plan is None else Path(plan), given.out)
    tests = [str(one) if isinstance(one, Path) else one for one in _several(after)]
    return Verification(verification_of(session, given.record, tests, file, _paths(loaded)))


@in_argument_names
def decode(
    files: PathName | Sequence[PathName],
    format: str,  # noqa: A002 - the word of the command line and of the job file
    *,
    options: Mapping[str, object] | None = None,
    axis: str | None = None,
) -> DecodedFiles:
    """Return the corrections that a control makes after the given files are loaded.

    ``format``: an id of ``compwright formats list`` or the path of a definition. ``options``: as
    ``controller.options`` of a job. ``axis``: the address of the only axis to decode; default: all
    axes. Raises UsageError and InputError.
    """
    from compwright.workflow.commands.decode import decoded_files

    session = Session()
    state, kinds, document = decoded_files(
        session, _paths(files), format, dict(options or {}), axis=axis
    )
    return DecodedFiles(document, state, kinds.unknown)


@in_argument_names
def compare(plan: PathName, loaded: PathName | Sequence[PathName]) -> Comparison:
    """Compare the control's files, read back after loading (``loaded``), with a plan.

    ``plan``: the folder of a run or its ``plan.json``. Raises UsageError for a plan without tables,
    InputError for files that cannot be read.
    """
    from compwright.workflow.commands.compare import compare_plan
    from compwright.workflow.commands.verify import plan_path

    session = Session()
    file = plan_path(session, Path(plan), Path(plan))
    return Comparison(compare_plan(session, file, _paths(loaded)).document)


@in_argument_names
def simulate(
    machine: PathName, *, tables: PathName | None = None, seed: int = 0
) -> list[MeasuredTest]:
    """Measure every axis and circle of a virtual machine. ``tables``: a folder with the files that
    its control loads. The same ``seed`` gives the same tests.

    ``machine``: a machine file. Raises UsageError with every fault of the machine file, InputError
    for files that cannot be read.
    """
    from compwright.workflow.commands.simulate import load_machine, simulated

    session = Session()
    virtual = load_machine(session, Path(machine))
    folder = None if tables is None else Path(tables)
    measured = simulated(session, virtual, seed=seed, tables=folder, file=str(machine))
    return [
        replace(test if isinstance(test, PositioningTest) else test.test, name=name)
        for name, test in measured.items()
    ]


def _several(given: Any) -> list[Any]:
    return list(given) if isinstance(given, list | tuple) else [given]


def _paths(paths: PathName | Sequence[PathName]) -> list[Path]:
    return [Path(path) for path in _several(paths)]
