"""``evaluate``: evaluate positioning and circular tests from measurement files and folders."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from compwright import __version__
from compwright.documents.evaluation import evaluation_document
from compwright.documents.findings import finding_documents
from compwright.documents.json_text import to_json
from compwright.evaluation.standards import DEFAULT_STANDARD, STANDARDS, by_id, standard_by_id
from compwright.foundations import storage
from compwright.foundations.errors import (
    CompwrightError,
    Fault,
    InputError,
    UsageError,
    collect,
    raise_all,
)
from compwright.foundations.input_sizes import MEASUREMENT
from compwright.foundations.own_faults import OWN_FAULT
from compwright.foundations.parallel_work import Crew, alone, in_order
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded, shown_path
from compwright.words.sentences import Language
from compwright.workflow.inputs.file_evaluation import (
    CirclesEvaluator,
    Evaluated,
    EvaluationRequest,
    FilesEvaluator,
    FileToEvaluate,
    Noted,
    Why,
    ready,
    tests_in,
)
from compwright.workflow.inputs.measurement_files import (
    FoundMeasurements,
    load_profile,
    measurement_files,
)
from compwright.workflow.results.report_file import as_named, require_report_form

if TYPE_CHECKING:  # positioning tests, the common case, start without the circular records
    from compwright.instruments.profile import Profile
    from compwright.records.circular import CircularTest
    from compwright.records.positioning import PositioningTest

_DEFAULT_CIRCULAR = "iso230-4:2005"  # of evaluation.circular, which positioning tests do not load


#: From more files or tests than this on, a line each and a summary are shown instead of a page
#: each: what a machine with its axes and circles has still fits.
_PAGES: Final = 10

#: Tests in one picture, one below the other: more are refused.
_PLOTTED: Final = 40

#: Called with progress: what is counted (files, or circles), how many are done, of how many.
Watch = Callable[[str, int, int], None]


@dataclass(frozen=True, slots=True, kw_only=True)
class EvaluationRun:
    """The result of ``evaluate``. ``many``: there are too many tests for a report page for each
    test.

    ``exit_code``: 0 if all is well; 3 if a file cannot be read; 2 if the requested standard does
    not fit a test and everything else is read; 70 if compwright itself failed at a file.
    """

    document: Mapping[str, Any]
    many: bool
    exit_code: int


def _unwatched(what: str, done: int, count: int) -> None:
    pass


def evaluate_files(
    session: Session,
    paths: Sequence[Path],
    standards: Sequence[str] = (),
    spread: str = "std",
    *,
    profile: Path | None = None,
    whole: bool = True,
    crew: Crew = alone,
    watch: Watch = _unwatched,
) -> EvaluationRun:
    """Evaluate every file of ``paths`` by the standard for its kind of test, in the order of the
    files. ``spread``: the formula for the scatter s of repeated readings; ``watch``: a function
    that is called with the progress.

    - ``paths``: files and folders. Of a folder every file is read except hidden ones.
    - ``standards``: at most one for positioning and one for circular tests; default: that of the
      kind of test.
    - ``profile``: the mapping profile for tables of other programs.
    - ``whole``: whether the entries of many files contain targets and readings too; else only what
      a summary and a table need (`in_short`).
    - ``crew``: the processes that share the work.

    Two files that contain one direction each of the same circular test are one test
    (`circular_pairs.paired`). A measurement file that cannot be read becomes an entry in
    ``errors``, and the rest is evaluated. So does a file in a folder without any measurement file.
    Other files in a folder of measurements (plots, JSON, jobs) are skipped and listed in
    ``skipped``, and its folders in ``folders``.

    Raises UsageError for an unknown standard, for two standards of one kind, for a range method
    that the standard or the only test does not have, and if no path is given.
    """
    positioning, circular = _standards(standards, spread)
    if not paths:
        raise UsageError(
            Fault(
                message="no measurement file was given",
                expected="at least one measurement file or folder",
                hint="give at least one measurement file or folder",
            )
        )
    mapping = None if profile is None else load_profile(session, profile)
    found, faults = _files(session, paths)
    files = found.files
    request = EvaluationRequest(
        positioning=positioning,
        circular=circular,
        spread=spread,
        profile=mapping,
        whole=whole or len(files) <= _PAGES,
    )
    tests, noted = _evaluated(session, files, request, crew, watch)
    why = _by_reason(noted)
    machines: list[dict[str, Any]] = []
    circles = [one.circle for one in tests if one.circle is not None]
    if len(circles) > 1:
        from compwright.workflow.inputs.circles import machines_of

        machines, own = machines_of(circles)
        why["own"].extend(own)
    faults += [*why["unread"], *why["refused"]]
    if why["unfit"] and not (tests or faults or why["own"]):
        raise UsageError(*why["unfit"])
    document = {
        **evaluation_document((), [*faults, *why["unfit"], *why["own"]]),
        "results": _with_repeats(tests),
    }
    if len(circles) > 1:
        document["machines"] = machines
    if found.skipped:
        document["skipped"] = [shown_path(path) for path in found.skipped]
    if found.folders:
        document["folders"] = [shown_path(path) for path in found.folders]
    gravest = (
        (OWN_FAULT, why["own"]),
        (InputError.exit_code, faults),
        (UsageError.exit_code, why["unfit"]),
    )
    return EvaluationRun(
        document=document,
        many=max(len(files), len(tests)) > _PAGES,
        exit_code=next((code for code, some in gravest if some), 0),
    )


def all_tests(
    session: Session, path: Path, profile: Profile | None
) -> list[PositioningTest | CircularTest]:
    """Return the tests of a measurement file, or of all files in a folder. Raises InputError with
    all faults.
    """
    from compwright.workflow.inputs.circles import pairs_joined

    tests: list[PositioningTest | CircularTest] = []
    errors: list[CompwrightError] = []
    for file in measurement_files(session, path).files:
        try:
            content = storage.read_bytes(session, file, MEASUREMENT)
            tests += tests_in(content, shown_path(file), profile)
        except InputError as error:
            errors.append(error)
    raise_all(InputError, collect(errors))
    return pairs_joined(tests)


def _by_reason(noted: Sequence[Noted]) -> Mapping[Why, list[Fault]]:
    reasons: dict[Why, list[Fault]] = {"unread": [], "refused": [], "unfit": [], "own": []}
    for one in noted:
        reasons[one.why].append(one.fault)
    return reasons


def evaluation_renderables(document: Mapping[str, Any], *, targets: bool = False) -> list[Any]:
    """Return the terminal output for an evaluation, as rich renderables."""
    from compwright.reporting.terminal import evaluation_tables

    shown: list[Any] = []
    for kind, results in groupby(document["results"], key=lambda result: str(result["kind"])):
        if kind == "circular":
            from compwright.reporting.circular_tables import circular_tables

            shown += circular_tables(list(results))
        else:
            shown += evaluation_tables({"results": list(results), "errors": []}, targets=targets)
    for machine in document.get("machines", ()):
        from compwright.reporting.circular_tables import machine_table

        shown.append(machine_table(machine))
    return [*shown, *evaluation_tables({"results": [], "errors": document["errors"]})]


def many_renderables(document: Mapping[str, Any]) -> list[Any]:
    """Return the terminal output for an evaluation of many tests: one line each, and a summary."""
    from compwright.documents.evaluation_summary import summary_document
    from compwright.reporting.evaluation_list import evaluation_list

    return evaluation_list(document, summary_document(document))


def write_evaluation(
    session: Session,
    document: Mapping[str, Any],
    *,
    json_path: Path | None = None,
    plot_path: Path | None = None,
    table_path: Path | None = None,
    report_path: Path | None = None,
    language: Language = "en",
    command: str = "",
    force: bool = False,
) -> list[Path]:
    """Write the outputs of ``evaluate``: JSON, plot, table and report, all or none. Returns the
    written paths.

    The formats follow from the file name extensions: svg, png or pdf for the plot, csv or xlsx for
    the table, html or pdf for the report. ``command``: the command line that makes the report
    again.

    Raises StorageError if a file exists (unless ``force``) or cannot be written. Raises UsageError
    for another extension, for one file name for two outputs, and if there is nothing to plot or
    more than fits in a picture.
    """
    require_report_form(report_path, ".html", ".pdf")
    files: dict[Path, bytes] = {}
    makers: tuple[tuple[str, Path | None, Callable[[Path], bytes]], ...] = (
        ("--plot", plot_path, lambda path: _plot(_with_pages(document), path)),
        ("--table", table_path, lambda path: _table(document, path)),
        (
            "--report",
            report_path,
            lambda path: _report(_with_pages(document), path, language, command),
        ),
        ("--json", json_path, lambda path: encoded(to_json(document))),  # noqa: ARG005
    )
    named: dict[Path, str] = {}
    for option, path, make in makers:
        if path is None:
            continue
        if path in files:
            raise UsageError(
                Fault(
                    message=f"this file name is already used for {named[path]}",
                    file=shown_path(path),
                    place=option,
                    expected="another file",
                    hint="give two different files",
                )
            )
        named[path] = option
        try:
            files[path] = make(path)
        except UsageError as error:
            raise UsageError(
                *(fault.within(option).in_file(shown_path(path)) for fault in error.faults)
            ) from error
    if files:
        from compwright.workflow.results.single_files import refuse_other_kinds

        refuse_other_kinds(session, files, force=force)
    return storage.write_files(session, Path(), {}, elsewhere=files, force=force)


#: Kinds of tests with targets or a plane.
_WITH_PAGES: Final = ("positioning", "circular")


def _with_pages(document: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the document with only those tests that get a report page and a figure.

    Stand-still tests and tests of lost motion over distance or speed are left out.
    """
    tests = [result for result in document["results"] if result["kind"] in _WITH_PAGES]
    if document["results"] and not tests:
        raise UsageError(
            Fault(
                message=(
                    "--plot and --report show neither a stand-still test (axis at rest) nor a table"
                    " of lost motion"
                ),
                hint="give a positioning or circular test too, or leave these two options out",
            )
        )
    return {**document, "results": tests}


def _plot(document: Mapping[str, Any], path: Path) -> bytes:
    from compwright.reporting.plots import evaluation_plot

    count = len(document["results"])
    if count > _PLOTTED:
        raise UsageError(
            Fault(
                message="one picture cannot show this number of tests",
                expected=f"at most {_PLOTTED} tests",
                found=str(count),
                hint="give fewer files, or `--table PATH.csv` instead of `--plot`",
            )
        )
    return evaluation_plot(dict(document), format=path.suffix.lower().removeprefix("."))


def _table(document: Mapping[str, Any], path: Path) -> bytes:
    from compwright.reporting.evaluation_table import table_bytes

    return table_bytes(document, path.suffix)


def _report(document: Mapping[str, Any], path: Path, language: Language, command: str) -> bytes:
    from compwright.reporting.evaluation_report import evaluation_report

    if not document["results"]:
        raise UsageError(
            Fault(
                message="no test could be evaluated, so there is nothing to report",
                expected="at least one test without a fault",
                hint="correct the faults of the tests first, or leave `--report` out",
            )
        )
    view = {
        "evaluation": document,
        "report": {},
        "language": language,
        "command": command,
        "version": __version__,
    }
    return as_named(evaluation_report(view), path)


def _standards(names: Sequence[str], spread: str) -> tuple[str, str]:
    """Return the standards for positioning and for circular tests."""
    errors: list[CompwrightError] = []
    kinds: dict[str, list[str]] = {"positioning": [], "circular": []}
    for name in names:
        try:
            if name in STANDARDS:
                kinds["positioning"].append(standard_by_id(name, spread).id)
            else:
                from compwright.evaluation.circular import CIRCULAR_STANDARDS

                by_id(name, {**STANDARDS, **CIRCULAR_STANDARDS}, "standard")
                kinds["circular"].append(name)
        except UsageError as error:
            errors.append(error)
    for kind, chosen in kinds.items():
        if len(chosen) > 1:
            fault = Fault(
                message=f"`--standard` is given more than once for {kind} tests",
                place="--standard",
                expected="one per kind of test",
                found=", ".join(chosen),
                hint="give one `--standard` for each kind of test",
            )
            errors.append(UsageError(fault))
    if not names:
        standard_by_id(DEFAULT_STANDARD, spread)
    raise_all(UsageError, collect(errors))
    return (*kinds["positioning"], DEFAULT_STANDARD)[0], (*kinds["circular"], _DEFAULT_CIRCULAR)[0]


def _files(session: Session, paths: Sequence[Path]) -> tuple[FoundMeasurements, list[Fault]]:
    """Return the measurement files of all paths (each once) with the skipped files, and a fault for
    each path that cannot be read.
    """
    found: list[FoundMeasurements] = []
    faults: list[Fault] = []
    for path in paths:
        try:
            found.append(measurement_files(session, path))
        except InputError as error:
            faults.extend(error.faults)
    files = dict.fromkeys(file for one in found for file in one.files)
    skipped = dict.fromkeys(file for one in found for file in one.skipped if file not in files)
    folders = dict.fromkeys(
        folder for one in found for folder in one.folders if folder not in paths
    )
    return FoundMeasurements(tuple(files), tuple(skipped), tuple(folders)), faults


def _evaluated(
    session: Session, files: Sequence[Path], request: EvaluationRequest, crew: Crew, watch: Watch
) -> tuple[list[Evaluated], list[Noted]]:
    """Return the evaluated tests in the files, and the faults of files and tests. The two files of
    one circular test become one test.
    """
    found: list[Evaluated | CircularTest] = []
    noted: list[Noted] = []
    given = (_given(session, file) for file in files)
    work = in_order(
        FilesEvaluator(request),
        given,
        crew=crew,
        ready=ready,
        count=len(files),
        weight=lambda one: len(one.content),
    )
    for done, one in enumerate(work, start=1):
        found += one.tests
        noted += one.noted
        watch("files", done, len(files))
    if all(isinstance(test, Evaluated) for test in found):
        return [test for test in found if isinstance(test, Evaluated)], noted
    return _with_circles(found, noted, request, crew, watch)


def _given(session: Session, file: Path) -> FileToEvaluate:
    try:
        return FileToEvaluate(shown_path(file), storage.read_bytes(session, file, MEASUREMENT))
    except InputError as error:
        return FileToEvaluate(shown_path(file), faults=error.faults)


def _with_circles(
    found: Sequence[Evaluated | CircularTest],
    noted: Sequence[Noted],
    request: EvaluationRequest,
    crew: Crew,
    watch: Watch,
) -> tuple[list[Evaluated], list[Noted]]:
    """Return all evaluated tests in their order, and the faults, those ``noted`` earlier first.
    Circular tests are evaluated here, after the two files of one test have been joined.
    """
    from compwright.workflow.inputs.circles import pairs_joined

    joined = pairs_joined(found)
    circles = [test for test in joined if not isinstance(test, Evaluated)]
    work = in_order(
        CirclesEvaluator(request),
        circles,
        crew=crew,
        ready=ready,
        count=len(circles),
        weight=lambda test: 16 * sum(run.angles.size for run in test.runs),
    )
    tests: list[Evaluated] = []
    more = list(noted)
    done = 0
    for test in joined:
        if isinstance(test, Evaluated):
            tests.append(test)
            continue
        one = next(work)
        tests += [each for each in one.tests if isinstance(each, Evaluated)]
        more += one.noted
        done += 1
        watch("circles", done, len(circles))
    return tests, more


def _with_repeats(tests: Sequence[Evaluated]) -> list[dict[str, Any]]:
    """Return the JSON entries of tests. A test with the same readings as an earlier test gets a
    finding.
    """
    readings = [one.test for one in tests if one.test is not None]
    circles = [one.circle.test for one in tests if one.circle is not None]
    if max(len(readings), len(circles)) < 2:
        return [one.entry for one in tests]
    from compwright.evaluation.duplicate_measurements import repeat_findings, repeated_files

    repeated = iter(repeat_findings(readings))
    copied = iter(repeated_files([test.sources for test in circles]))
    for one in tests:
        if one.test is None and one.circle is None:
            continue
        finding = next(repeated if one.circle is None else copied)
        if finding is not None:
            one.entry["findings"] += finding_documents([finding])
    return [one.entry for one in tests]
