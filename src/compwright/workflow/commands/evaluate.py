"""``evaluate``: measurement files and folders to evaluations, one per test: positioning and
circular.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from compwright.documents.evaluation import evaluation_document, result_document
from compwright.documents.json_text import to_json
from compwright.evaluation.standards import DEFAULT_STANDARD, evaluate, standard_by_id
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
from compwright.foundations.utf8 import encoded, shown_path
from compwright.instruments.profile import Profile
from compwright.instruments.reading import read_tests
from compwright.records.positioning import PositioningTest
from compwright.records.result import PositioningResult
from compwright.workflow.stages.measurement_files import load_profile, measurement_files

if TYPE_CHECKING:  # positioning tests, the common case, start without the circular records
    from compwright.records.circular import CircularResult, CircularTest

_CIRCULAR = "iso230-4:"
_DEFAULT_CIRCULAR = "iso230-4:2005"  # of evaluation.circular, which positioning tests do not load


@dataclass(frozen=True, slots=True, kw_only=True)
class EvaluationRun:
    """``document`` is the JSON of ``evaluate``, ``results`` the same as records.

    ``exit_code`` is 0, 3 for a file that cannot be read, 2 where the standard asked for does not
    fit a test and all else is read.
    """

    document: Mapping[str, Any]
    results: tuple[PositioningResult | CircularResult, ...]
    exit_code: int


def evaluate_files(
    paths: Sequence[Path],
    standards: Sequence[str] = (),
    spread: str = "std",
    *,
    profile: Path | None = None,
) -> EvaluationRun:
    """Evaluate every file of ``paths`` (folders: every file in them, hidden ones left out), each
    kind of test to its standard.

    ``profile``: of tables of other programs. ``standards``: at most one for positioning and one
    for circular tests; without one the default of the kind. Two files that hold one direction
    each of the same circular test are one test (`circular_pairs.paired`). A file that cannot be
    read, also one in a folder that is no measurement file, becomes an entry in ``errors`` and
    the rest is evaluated; what lies beside measurements in a folder (plots, JSON, jobs) is
    skipped and named in ``skipped``. Raises UsageError for unknown standards, two of one kind,
    a range method that the standard or the only test does not have, or no path at all.
    """
    positioning, circular = _standards(standards, spread)
    if not paths:
        raise UsageError(
            Fault(message="nothing to evaluate", expected="at least one measurement file or folder")
        )
    mapping = None if profile is None else load_profile(profile)
    files, skipped, faults = _files(paths)
    unfit: list[UsageError] = []
    results: list[PositioningResult | CircularResult] = []
    for test in _tests(files, mapping, faults):
        try:
            if isinstance(test, PositioningTest):
                results.append(_evaluated(test, positioning, spread))
            else:
                results.append(_evaluated_circle(test, circular))
        except InputError as error:
            faults.extend(fault.in_file(test.sources[0].file) for fault in error.faults)
        except UsageError as error:  # the method does not fit this test; it may fit the others
            unfit.append(error)
    if unfit and not results and not faults:
        raise UsageError(*collect(unfit))
    exit_code = InputError.exit_code if faults else UsageError.exit_code if unfit else 0
    results = _with_repeats(results)
    document = {
        **evaluation_document((), [*faults, *collect(unfit)]),
        "results": [_entry(result) for result in results],
    }
    if skipped:
        document["skipped"] = [shown_path(path) for path in skipped]
    return EvaluationRun(document=document, results=tuple(results), exit_code=exit_code)


def evaluation_renderables(document: Mapping[str, Any], *, targets: bool = False) -> list[Any]:
    """Return what a terminal shows of an evaluation document, as rich renderables."""
    from compwright.reporting.terminal import evaluation_tables

    shown: list[Any] = []
    for kind, results in groupby(document["results"], key=lambda result: str(result["kind"])):
        if kind == "circular":
            from compwright.reporting.circular_tables import circular_tables

            shown += circular_tables(list(results))
        else:
            shown += evaluation_tables({"results": list(results), "errors": []}, targets=targets)
    return [*shown, *evaluation_tables({"results": [], "errors": document["errors"]})]


def write_evaluation(
    document: Mapping[str, Any],
    *,
    json_path: Path | None = None,
    plot_path: Path | None = None,
    force: bool = False,
) -> list[Path]:
    """Write the JSON document and the plot (svg, png or pdf by its ending), all or none; returns
    the paths written.

    Raises StorageError when a file exists (unless ``force``) or cannot be written, UsageError for
    another ending of the plot or when there is nothing to plot.
    """
    files: dict[Path, bytes] = {}
    if plot_path is not None:
        files[plot_path] = _plot(document, plot_path)
    if json_path is not None and json_path == plot_path:
        raise UsageError(
            Fault(
                message="is the file of --plot too",
                file=str(json_path),
                place="--json",
                expected="another file",
            )
        )
    if json_path is not None:
        files[json_path] = encoded(to_json(document))
    return storage.write_files(Path(), {}, elsewhere=files, force=force)


def _plot(document: Mapping[str, Any], path: Path) -> bytes:
    from compwright.reporting.plots import evaluation_plot

    try:
        return evaluation_plot(dict(document), format=path.suffix.lower().removeprefix("."))
    except UsageError as error:
        raise UsageError(
            *(fault.within("--plot").in_file(str(path)) for fault in error.faults)
        ) from error


def _standards(names: Sequence[str], spread: str) -> tuple[str, str]:
    """Return the standards of positioning and of circular tests."""
    errors: list[CompwrightError] = []
    kinds: dict[str, list[str]] = {"positioning": [], "circular": []}
    for name in names:
        try:
            if name.startswith(_CIRCULAR):
                kinds["circular"].append(_circular_standard(name))
            else:
                kinds["positioning"].append(standard_by_id(name, spread).id)
        except UsageError as error:
            errors.append(error)
    for kind, chosen in kinds.items():
        if len(chosen) > 1:
            message = f"more than one for {kind} tests"
            fault = Fault(
                message=message,
                place="--standard",
                expected="one per kind of test",
                found=", ".join(chosen),
            )
            errors.append(UsageError(fault))
    if not names:
        standard_by_id(DEFAULT_STANDARD, spread)
    raise_all(UsageError, collect(errors))
    return (*kinds["positioning"], DEFAULT_STANDARD)[0], (*kinds["circular"], _DEFAULT_CIRCULAR)[0]


def _circular_standard(name: str) -> str:
    from compwright.evaluation.circular import circular_standard_by_id

    return circular_standard_by_id(name).id


def _files(paths: Sequence[Path]) -> tuple[list[Path], list[Path], list[Fault]]:
    """Return the files of all paths, each once, what was skipped beside them, and the faults of
    paths without any.
    """
    files: dict[Path, None] = {}
    skipped: dict[Path, None] = {}
    faults: list[Fault] = []
    for path in paths:
        try:
            found = measurement_files(path)
        except InputError as error:
            faults.extend(error.faults)
            continue
        files |= dict.fromkeys(found.files)
        skipped |= dict.fromkeys(found.skipped)
    return list(files), [path for path in skipped if path not in files], faults


def _tests(
    files: Sequence[Path], profile: Profile | None, faults: list[Fault]
) -> list[PositioningTest | CircularTest]:
    """Return the tests in the files, those of one circular test joined; what cannot be read goes to
    ``faults``.
    """
    tests: list[PositioningTest | CircularTest] = []
    for file in files:
        try:
            tests.extend(_read(storage.read_bytes(file, MEASUREMENT), shown_path(file), profile))
        except InputError as error:
            faults.extend(fault.in_file(shown_path(file)) for fault in error.faults)
    if all(isinstance(test, PositioningTest) for test in tests):
        return tests
    from compwright.workflow.stages.circles import pairs_joined

    return pairs_joined(tests)


def _read(
    content: bytes, file: str, profile: Profile | None
) -> Sequence[PositioningTest | CircularTest]:
    try:
        return read_tests(content, file, profile)
    except InputError:
        from compwright.workflow.stages.circles import (
            read_if_circular,
        )  # only now: the way of a positioning test stays short

        test = read_if_circular(content, file)
        if test is None:
            raise
        return (test,)


def _with_repeats(
    results: list[PositioningResult | CircularResult],
) -> list[PositioningResult | CircularResult]:
    """Return the results, positioning tests that repeat another one's measurement with a
    finding.
    """
    places = [
        index for index, result in enumerate(results) if isinstance(result, PositioningResult)
    ]
    if len(places) < 2:
        return results
    from compwright.evaluation.repeats import repeat_findings

    found = list(results)
    tested = [cast("PositioningResult", results[index]) for index in places]
    for index, result, repeated in zip(
        places, tested, repeat_findings([result.test for result in tested]), strict=True
    ):
        if repeated is not None:
            found[index] = replace(result, findings=(*result.findings, repeated))
    return found


def _evaluated_circle(test: CircularTest, standard: str) -> CircularResult:
    from compwright.planning.diagnosed import diagnosed_circle

    return diagnosed_circle(test, standard)


def _entry(result: PositioningResult | CircularResult) -> dict[str, Any]:
    if isinstance(result, PositioningResult):
        return result_document(result)
    from compwright.documents.circular import circular_document

    return circular_document(result)


def _evaluated(test: PositioningTest, standard: str, spread: str) -> PositioningResult:
    try:
        return evaluate(test, standard, spread=cast("Literal['std', 'range']", spread))
    except UsageError as error:
        raise UsageError(
            *(fault.in_file(test.sources[0].file) for fault in error.faults)
        ) from error
