"""The JSON document of ``decode`` (``compwright/decode/1``)."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from compwright.documents.findings import finding_documents
from compwright.documents.prediction import cross_outside, table_outside
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import Assumption, CrossCompensation

SCHEMA = "compwright/decode/1"


@dataclass(frozen=True, slots=True)
class DecodedAxis:
    """The corrections (k,) of one axis at ``positions`` (k,), mm or deg, per approach direction."""

    kind: AxisKind | None
    positions: FloatArray
    positive: FloatArray
    negative: FloatArray


def decode_document(
    axes: Mapping[str, DecodedAxis],
    assumed: Iterable[Assumption],
    findings: Iterable[Finding],
    cross: Iterable[CrossCompensation] = (),
    unknown: Container[str] = (),
) -> dict[str, Any]:
    """Return the JSON document with the corrections of each axis, by its address and at its
    positions in their given order. ``unknown``: the addresses of axes of unknown kind (linear or
    rotary).

    ``assumed``: facts that the files do not state. ``cross``: corrections of one axis by the
    position of another. Corrections of an axis of unknown kind are in thousandths of the unit of
    its positions, and their ``unit`` is null.
    """
    return {
        "schema": SCHEMA,
        "axes": {address: _axis(axis) for address, axis in axes.items()},
        "cross": [_cross(entry, known=entry.output not in unknown) for entry in cross],
        "assumed": assumed_documents(assumed),
        "findings": finding_documents(findings),
    }


def assumed_documents(assumed: Iterable[Assumption]) -> list[dict[str, str]]:
    """Return the assumptions for JSON in their order, without repetitions of the same fact with the
    same value.
    """
    unique = {(entry.fact, entry.value): entry for entry in reversed(list(assumed))}
    return [
        {"fact": entry.fact, "value": entry.value, "evidence": entry.evidence}
        for entry in reversed(unique.values())
    ]


def _cross(entry: CrossCompensation, *, known: bool) -> dict[str, Any]:
    if known:
        return cross_outside(entry)
    return {**cross_outside(replace(entry, output_kind=AxisKind.LINEAR)), "unit": None}


def _axis(axis: DecodedAxis) -> dict[str, Any]:
    kind = axis.kind or AxisKind.LINEAR
    factor = outside_factor(kind.unit)
    table = table_outside(axis.positions, axis.positive * factor, axis.negative * factor, kind)
    return table if axis.kind is not None else {**table, "unit": None}
