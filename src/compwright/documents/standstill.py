"""The JSON of ``evaluate`` for stand-still tests (axis at rest) and for lost motion."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import PurePath
from typing import Any

from compwright.documents.findings import finding_documents
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.drift import DriftTest, LostMotionTest


def stand_still_document(
    drift: DriftTest, E_VE: float, findings: Iterable[Finding]
) -> dict[str, Any]:
    """Return the JSON entry of a stand-still test: its range ``E_VE`` (µm, arcsec) and readings."""
    unit = drift.kind.unit
    factor = outside_factor(unit)
    return {
        "kind": "environment",
        "name": PurePath(drift.source.file).stem,
        "sources": [{"file": drift.source.file, "sha256": drift.source.sha256}],
        "axis": drift.header.get("axis", ""),
        "axis_kind": str(drift.kind),
        "standard": "iso230-3",
        "unit": outside_unit(unit),
        "n_readings": int(drift.minutes.size),
        "duration_min": float(drift.minutes[-1] - drift.minutes[0]),
        "parameters": {"E_VE": round(E_VE, 9)},
        "not_applicable": {},
        "readings": [
            {"time_min": float(minute), "deviation": round(float(value) * factor, 9)}
            for minute, value in zip(drift.minutes, drift.deviations, strict=True)
        ],
        "header": dict(drift.header),
        "findings": finding_documents(findings),
    }


def lost_motion_document(
    test: LostMotionTest,
    constant: float,
    left: float,
    *,
    depends: bool,
    findings: Iterable[Finding],
) -> dict[str, Any]:
    """Return the JSON entry of a lost motion test: its constant, the largest deviation ``left``
    from the constant, and the readings. ``depends``: the lost motion depends on the distance or
    speed of the moves.
    """
    return {
        "kind": "lost_motion",
        "name": PurePath(test.source.file).stem,
        "sources": [{"file": test.source.file, "sha256": test.source.sha256}],
        "axis": test.header.get("axis", ""),
        "axis_kind": "linear",
        "standard": None,
        "unit": "um",
        "n_readings": int(test.moves.size),
        "over": test.over,
        "depends": depends,
        "parameters": {"constant": round(constant, 9), "left": round(left, 9)},
        "not_applicable": {},
        "readings": [
            {"move": float(move), "lost_motion": round(1000.0 * float(value), 9)}
            for move, value in zip(test.moves, test.lost_motion, strict=True)
        ],
        "header": dict(test.header),
        "findings": finding_documents(findings),
    }
