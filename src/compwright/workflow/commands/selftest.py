"""``selftest``: evaluate reference data, and compare the results with expected values."""

from __future__ import annotations

import csv
import platform
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from io import StringIO
from pathlib import Path
from typing import Any, Final

import numpy as np

from compwright import __version__
from compwright.controls.checked_definitions import checked_definitions, hand_worked
from compwright.documents.circular import circular_document
from compwright.documents.evaluation import result_document
from compwright.documents.json_text import to_json
from compwright.evaluation.circular_fit import least_squares_circle
from compwright.evaluation.standards import Spread, evaluate
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError
from compwright.foundations.extras import installed_version
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.utf8 import encoded
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.records.positioning import PositioningTest
from compwright.workflow.inputs.file_evaluation import tests_in
from compwright.workflow.results.single_files import refuse_other_kinds

SCHEMA: Final = "compwright/selftest/1"
_EXPECTED: Final = "expected.csv"
_CIRCLES: Final = "nist-circles.csv"
#: Corrections worked by hand come out to this many µm or arcsec.
_AGREEMENT: Final = 1e-6
_PACKAGES: Final = ("numpy", "scipy", "cvxpy", "osqp", "PyYAML", "pydantic", "click", "rich")


@dataclass(frozen=True, slots=True)
class Check:
    """One comparison of the self-test: expected and obtained value, with the permitted limit.

    ``group``: the file of reference data, or the control. ``subject``: the standard, or the table
    of the control. ``obtained``: None if there is no value; ``note`` then gives the reason.
    """

    group: str
    subject: str
    quantity: str
    expected: float
    obtained: float | None
    limit: float
    unit: str
    source: str
    note: str = ""

    @property
    def good(self) -> bool:
        """Whether there is a result and it differs from the expected value by at most the limit."""
        return self.obtained is not None and bool(abs(self.obtained - self.expected) <= self.limit)


def selftest(session: Session) -> dict[str, Any]:
    """Return the JSON document of the self-test: all comparisons, the platform, the versions of the
    libraries, and the SHA-256 of the reference data.
    """
    files = storage.reference_files(session)
    checks = [*_values(files), *_controls(session)]
    return {
        "schema": SCHEMA,
        "good": bool(checks) and all(check.good for check in checks),
        "version": __version__,
        "platform": platform.platform(),
        "python": platform.python_version(),
        "packages": {name: installed_version(name) for name in _PACKAGES},
        "reference_data": {name: fingerprint(content) for name, content in files.items()},
        "checks": [{**asdict(check), "good": check.good} for check in checks],
    }


def write_selftest(
    session: Session,
    document: Mapping[str, Any],
    pages: Iterable[Path],
    answers: Iterable[Path],
    *,
    force: bool,
) -> list[Path]:
    """Write the self-test as pages to be signed (to the paths ``pages``) and as JSON documents (to
    the paths ``answers``), all or none. Returns the written paths.

    Raises StorageError, and UsageError if the extra ``report`` is not installed.
    """
    files = dict.fromkeys(answers, encoded(to_json(document)))
    for path in pages:
        from compwright.reporting.selftest_report import selftest_report

        files[path] = selftest_report(document)
    refuse_other_kinds(session, files, force=force)
    return storage.write_files(session, Path(), {}, elsewhere=files, force=force)


def _values(files: Mapping[str, bytes]) -> Iterator[Check]:
    """Yield the comparisons from the table of expected values."""
    results: dict[tuple[str, str], tuple[Mapping[str, float], str]] = {}
    for row in _rows(files[_EXPECTED]):
        place = (row["file"], row["standard"])
        if place not in results:
            results[place] = _evaluated(files[row["file"]], *place)
        values, note = results[place]
        yield Check(
            group=row["file"],
            subject=row["standard"],
            quantity=row["quantity"],
            expected=float(row["expected"]),
            obtained=values.get(row["quantity"]),
            limit=float(row["limit"]),
            unit=row["unit"],
            source=row["source"],
            note=note,
        )


def _rows(content: bytes) -> list[dict[str, str]]:
    lines = [line for line in content.decode("utf-8").splitlines() if not line.startswith("#")]
    return list(csv.DictReader(StringIO("\n".join(lines))))


def _evaluated(content: bytes, file: str, standard: str) -> tuple[Mapping[str, float], str]:
    """Return the results for a file of reference data, or the reason why there are none."""
    try:
        if file == _CIRCLES:
            return _fitted(content, standard.removeprefix("set ")), ""
        (test,) = tests_in(content, file, None)
        if isinstance(test, PositioningTest):
            name, _, spread = standard.partition(" ")
            estimated: Spread = "range" if spread else "std"
            document = result_document(evaluate(test, name, spread=estimated))
            return _given(document["parameters"]), ""
        document = circular_document(diagnose_circle(test, standard))
        causes = {name: one["value"] for name, one in (document["diagnosis"] or {}).items()}
        return _given({**document["parameters"], **causes}), ""
    except CompwrightError as error:
        return {}, str(error)


def _given(values: Mapping[str, float | None]) -> dict[str, float]:
    return {name: value for name, value in values.items() if value is not None}


def _fitted(content: bytes, name: str) -> Mapping[str, float]:
    points = [(float(row["x"]), float(row["y"])) for row in _rows(content) if row["set"] == name]
    (x, y), radius = least_squares_circle(np.array(points))
    return {"x": x, "y": y, "diameter": 2.0 * radius}


def _controls(session: Session) -> Iterator[Check]:
    """Yield the checks of each control definition: hand-worked corrections as both readers decode
    them, and sample files written again.
    """
    definitions = list(checked_definitions(session, ()))
    if not definitions:
        yield _faults("controls", "definitions", 1, "none was found: install compwright again")
    for checked in definitions:
        group = checked.file if checked.definition is None else checked.definition.id
        try:
            for one in hand_worked(checked):
                yield Check(
                    group=group,
                    subject=one.expectation,
                    quantity=f"{one.reader}: largest of {one.count} differences",
                    expected=0.0,
                    obtained=one.difference,
                    limit=_AGREEMENT,
                    unit=one.unit,
                    source="worked by hand",
                )
        except CompwrightError as error:
            yield _faults(group, "tables worked by hand", 1, str(error))
        notes = "; ".join(str(fault) for fault in checked.faults)
        yield _faults(group, "sample, exported and read back", len(checked.faults), notes)


def _faults(group: str, subject: str, count: int, note: str) -> Check:
    return Check(
        group=group,
        subject=subject,
        quantity="number of faults",
        expected=0.0,
        obtained=float(count),
        limit=0.0,
        unit="",
        source="definition of the control",
        note=note,
    )
