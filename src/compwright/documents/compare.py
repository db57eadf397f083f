"""The JSON document of ``compare``: each difference between the control and the plan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from compwright.documents.decode import assumed_documents
from compwright.documents.diff import MOST_EXAMPLES, EntryDifference, others_document
from compwright.documents.findings import finding_documents
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption
from compwright.records.verification import ReadBack

SCHEMA = "compwright/compare/1"


@dataclass(frozen=True, slots=True)
class Difference:
    """One value that differs from the plan, as the control's text or in ``unit`` (um, arcsec).

    ``axis``: name of an axis of the plan, or address of another axis; empty for no axis.
    ``planned``, ``loaded``: the two values; None if the files do not contain the value.
    """

    axis: str
    quantity: str
    planned: float | str | None
    loaded: float | str | None
    unit: str = ""


@dataclass(frozen=True, slots=True)
class ComparedAxis:
    """The comparison of one axis with the plan: the correction read back and differing values.

    ``read_back``: the comparison of the correction; a text states why the correction read back is
    unknown. ``look_at``: sentences on what to check on the control.
    """

    address: str
    kind: AxisKind
    read_back: ReadBack | str
    differences: tuple[Difference, ...]
    look_at: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Others:
    """Differences between control and plan that belong to no axis of the plan.

    - ``differences``: values that compensate other axes or the machine.
    - ``elsewhere``: differing values that are not known to compensate.
    - ``not_read_back``: names of values that compensate and are missing in the files read back.
    """

    differences: tuple[Difference, ...] = ()
    elsewhere: tuple[EntryDifference, ...] = ()
    not_read_back: tuple[str, ...] = ()


def compare_document(
    format_id: str,
    axes: Mapping[str, ComparedAxis],
    others: Others,
    assumed: Sequence[Assumption],
    findings: Sequence[Finding],
    doubts: Sequence[Finding],
) -> dict[str, Any]:
    """Return the document with all differences, and the verdict: same, different or undecided."""
    own = (difference for axis in axes.values() for difference in axis.differences)
    differences = [*own, *others.differences]
    unreadable = any(isinstance(axis.read_back, str) for axis in axes.values())
    different = bool(differences or unreadable)
    return {
        "schema": SCHEMA,
        "format": format_id,
        "verdict": "different" if different else "undecided" if doubts else "same",
        "doubts": finding_documents(doubts),
        "axes": {name: _axis(axis) for name, axis in axes.items()},
        "differences": [
            {
                "axis": entry.axis,
                "quantity": entry.quantity,
                "planned": entry.planned,
                "loaded": entry.loaded,
                "unit": entry.unit or None,
            }
            for entry in differences
        ],
        "elsewhere": others_document(others.elsewhere),
        "not_looked_at": {
            "values": len(others.not_read_back),
            "such_as": list(others.not_read_back[:MOST_EXAMPLES]),
        },
        "assumed": assumed_documents(assumed),
        "findings": finding_documents(findings),
    }


def _axis(axis: ComparedAxis) -> dict[str, Any]:
    unit = axis.kind.unit
    comparison = axis.read_back
    compared: dict[str, Any] = {
        "verdict": "unreadable",
        "message": comparison,
        "largest_difference": None,
        "at": None,
        "direction": None,
    }
    if not isinstance(comparison, str):
        compared = {
            "verdict": comparison.verdict,
            "message": comparison.message,
            "largest_difference": comparison.worst * outside_factor(unit),
            "at": comparison.position,
            "direction": comparison.direction.value,
        }
    return {
        "address": axis.address,
        **compared,
        "unit": outside_unit(unit),
        "look_at": list(axis.look_at),
        "differences": len(axis.differences),
    }
