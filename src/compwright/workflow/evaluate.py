"""``evaluate``: measurement files and folders to evaluations, one per test and standard."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, cast

from compwright.documents.evaluation import evaluation_document
from compwright.documents.json_text import to_json
from compwright.evaluation.standards import DEFAULT_STANDARD, STANDARDS, evaluate, standard_by_id
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, UsageError, collect, raise_all
from compwright.instruments.reading import read_positioning
from compwright.records.positioning import PositioningTest
from compwright.records.result import PositioningResult

_CIRCULAR = "iso230-4:"


@dataclass(frozen=True, slots=True, kw_only=True)
class EvaluationRun:
    """``document`` is the JSON of ``evaluate``, ``results`` the same as records, ``exit_code`` 0, or 3 for an unreadable file."""

    document: Mapping[str, Any]
    results: tuple[PositioningResult, ...]
    exit_code: int


def evaluate_files(paths: Sequence[Path], standards: Sequence[str] = (), spread: str = "std") -> EvaluationRun:
    """Evaluate every file of ``paths`` (folders: every file in them, hidden ones left out) to every standard.

    Without ``standards`` to the default. A file that cannot be read, also one in a folder that is no measurement file, becomes an
    entry in ``errors`` and the rest is evaluated. Raises UsageError for unknown standards, circular ones, a range method
    that a standard does not have, or no path at all.
    """
    chosen = _standards(standards, spread)
    if not paths:
        raise UsageError(Fault(message="nothing to evaluate", expected="at least one measurement file or folder"))
    files, faults = _files(paths)
    results: list[PositioningResult] = []
    for file in files:
        try:
            test = read_positioning(storage.read_bytes(file), str(file))
            results.extend(_evaluated(test, standard, spread, file) for standard in chosen)
        except InputError as error:
            faults.extend(fault.in_file(str(file)) for fault in error.faults)
    document = evaluation_document(results, faults)
    return EvaluationRun(document=document, results=tuple(results), exit_code=InputError.exit_code if faults else 0)


def evaluation_json(document: Mapping[str, Any]) -> str:
    """Return the text that ``--json`` gives."""
    return to_json(document)


def evaluation_renderables(document: Mapping[str, Any], *, targets: bool = False) -> list[Any]:
    """Return what a terminal shows of an evaluation document, as rich renderables."""
    from compwright.reporting.terminal import evaluation_tables

    return [*evaluation_tables(document, targets=targets)]


def write_evaluation(
    document: Mapping[str, Any], *, json_path: Path | None = None, plot_path: Path | None = None, force: bool = False
) -> list[Path]:
    """Write the JSON document and the plot (svg, png or pdf by its ending), all or none; returns the paths written.

    Raises StorageError when a file exists (unless ``force``) or cannot be written, UsageError for another ending of the plot
    or when there is nothing to plot.
    """
    files: dict[Path, bytes] = {}
    if plot_path is not None:
        files[plot_path] = _plot(document, plot_path)
    if json_path is not None and json_path == plot_path:
        raise UsageError(Fault(message="is the file of --plot too", file=str(json_path), place="--json", expected="another file"))
    if json_path is not None:
        files[json_path] = to_json(document).encode("utf-8")
    return storage.write_files(Path(), {}, elsewhere=files, force=force)


def _plot(document: Mapping[str, Any], path: Path) -> bytes:
    from compwright.reporting.plots import evaluation_plot

    try:
        return evaluation_plot(dict(document), format=path.suffix.lower().removeprefix("."))
    except UsageError as error:
        raise UsageError(*(fault.within("--plot").in_file(str(path)) for fault in error.faults)) from error


def _standards(names: Sequence[str], spread: str) -> tuple[str, ...]:
    errors: list[CompwrightError] = []
    for name in names:
        if name.startswith(_CIRCULAR):
            fault = Fault(message="circular tests: not yet", place="--standard", expected=", ".join(STANDARDS), found=name)
            errors.append(UsageError(fault))
            continue
        try:
            standard_by_id(name, spread)
        except UsageError as error:
            errors.append(error)
    if not names:
        standard_by_id(DEFAULT_STANDARD, spread)
    raise_all(UsageError, collect(errors))
    return tuple(dict.fromkeys(names)) or (DEFAULT_STANDARD,)


def _files(paths: Sequence[Path]) -> tuple[list[Path], list[Fault]]:
    """Return the files of all paths, each once, in their order, and the faults of paths that hold none."""
    files: dict[Path, None] = {}
    faults: list[Fault] = []
    for path in paths:
        try:
            found = storage.list_files(path)
        except InputError as error:
            faults.extend(error.faults)
            continue
        if not found:
            faults.append(Fault(message="the folder holds no files", file=str(path)))
        files |= dict.fromkeys(found)
    return list(files), faults


def _evaluated(test: PositioningTest, standard: str, spread: str, file: Path) -> PositioningResult:
    try:
        return evaluate(test, standard, spread=cast("Literal['std', 'range']", spread))
    except UsageError as error:
        raise UsageError(*(fault.in_file(str(file)) for fault in error.faults)) from error
