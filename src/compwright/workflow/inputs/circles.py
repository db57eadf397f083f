"""Read circular tests from their files, and join the two files of one test.

``evaluate`` loads this module only if a file is not a positioning test, so that positioning tests
are evaluated quickly.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, TypeVar

from compwright.documents.circular import machine_document
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, InputError, collect, raise_all
from compwright.foundations.input_sizes import MEASUREMENT
from compwright.foundations.own_faults import own_fault
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.instruments.circular_pairs import paired
from compwright.instruments.circular_reading import merge_circular, read_circular
from compwright.instruments.other_files import is_circular
from compwright.records.circular import CircularResult, CircularTest
from compwright.workflow.inputs.measurement_files import measurement_files

if TYPE_CHECKING:  # a single circle starts without the records of jobs and plans
    from compwright.records.job import Job

T = TypeVar("T")
#: Keys of a header that name its machine.
_STATED: Final = ("machine", "serial")
#: Kinds of values of several circles, by their names in JSON.
_CAUSES: Final = {
    "squareness": "squareness",
    "scale": "scale_error",
    "lost motion": "backlash",
    "servo mismatch": "servo_mismatch",
}


def pairs_joined(tests: Sequence[T | CircularTest]) -> list[T | CircularTest]:
    """Return all tests in their order; the two files of one circular test become one test."""
    joined = paired([test for test in tests if isinstance(test, CircularTest)])
    by_source = {source: test for test in joined for source in test.sources}
    kept: dict[int, T | CircularTest] = {}
    for test in tests:
        whole = by_source[test.sources[0]] if isinstance(test, CircularTest) else test
        kept.setdefault(id(whole), whole)
    return list(kept.values())


def machines_of(circles: Sequence[CircularResult]) -> tuple[list[dict[str, Any]], list[Fault]]:
    """Return, for each machine with several circular tests, the JSON document about the errors that
    explain all of its tests together (such as squareness and scale errors), and the faults.
    """
    machines: dict[tuple[str | None, ...], list[CircularResult]] = {}
    seen: set[str] = set()
    for result in circles:
        own = {source.sha256 for source in result.test.sources}
        copied = not seen.isdisjoint(own)
        seen |= own
        if result.diagnosis is not None and not copied:
            stated = tuple(result.test.header.get(key) for key in _STATED)
            machines.setdefault(stated, []).append(result)
    documents, faults = [], []
    for stated, results in machines.items():
        if len(results) < 2:
            continue
        try:
            documents.append(_machine(dict(zip(_STATED, stated, strict=True)), results))
        except Exception as error:  # noqa: BLE001 - the circles are evaluated one by one
            files = (source.file for result in results for source in result.test.sources)
            faults.append(own_fault(error, ", ".join(files)))
    return documents, faults


def _machine(stated: Mapping[str, str | None], results: Sequence[CircularResult]) -> dict[str, Any]:
    from compwright.planning.circle_network import (
        machine_findings,
        solve_network,
        squareness_findings,
    )

    network = solve_network(results)
    values = {
        _CAUSES[kind]: network.values_of(kind) for kind in ("squareness", "scale", "lost motion")
    }
    return machine_document(
        stated,
        network.circles,
        {
            cause: {name: (each.value, each.std_error) for name, each in found.items()}
            for cause, found in (*values.items(), ("position_loop", network.position_loops()))
        },
        [
            (
                _CAUSES[kind],
                [(one.circle, str(one.axes), one.found.value, one.found.std_error) for one in seen],
            )
            for (kind, _), seen in network.contradictions.items()
        ],
        (*machine_findings(network), *squareness_findings(network)),
    )


def read_circles(session: Session, job: Job, folder: Path) -> tuple[CircularTest, ...]:
    """Read the circular tests of a job in its order. Raises InputError with the faults of all
    files.
    """
    errors: list[CompwrightError] = []
    tests = []
    for request in job.circles:
        try:
            tests.append(
                read_circle(
                    session,
                    [storage.named_from(folder, file) for file in request.files],
                    request.name,
                )
            )
        except InputError as error:
            errors.append(error)
    raise_all(InputError, collect(errors))
    return tuple(tests)


def read_circle(session: Session, paths: Sequence[Path | CircularTest], name: str) -> CircularTest:
    """Read one circular test from files or tests in memory. Raises InputError."""
    errors: list[CompwrightError] = []
    parts = []
    for given in paths:
        if isinstance(given, CircularTest):
            parts.append(given)
            continue
        try:
            files = measurement_files(session, given).files
        except InputError as error:
            errors.append(error)
            continue
        for path in files:
            try:
                parts.append(_read_part(session, path))
            except InputError as error:
                errors.append(error)
    raise_all(InputError, collect(errors))
    return merge_circular(parts, name)


def _read_part(session: Session, path: Path) -> CircularTest:
    content, file = storage.read_bytes(session, path, MEASUREMENT), shown_path(path)
    if not is_circular(content, file):
        raise InputError(
            Fault(
                message="the file is not a circular test",
                file=file,
                expected="a .b5r file or CSV with angle_deg",
                hint="give a .b5r file, or CSV with the column angle_deg",
            )
        )
    return read_circular(content, file)
