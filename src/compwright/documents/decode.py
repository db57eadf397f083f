"""The answer of ``decode`` (``compwright/decode/1``)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from compwright.documents.prediction import table_outside
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption, AxisCompensation

SCHEMA = "compwright/decode/1"


def decode_document(
    axes: Mapping[str, AxisCompensation],
    positions: Mapping[str, FloatArray],
    assumed: Iterable[Assumption],
    findings: Iterable[Finding],
) -> dict[str, Any]:
    """Return what the control does on each axis at ``positions[address]`` (mm or deg, kept in their order)."""
    return {
        "schema": SCHEMA,
        "axes": {address: _axis(axis, positions[address]) for address, axis in axes.items()},
        "cross": [],
        "assumed": assumed_documents(assumed),
        "findings": finding_documents(findings),
    }


def assumed_documents(assumed: Iterable[Assumption]) -> list[dict[str, str]]:
    """Return assumptions, each once, in their order."""
    unique = dict.fromkeys(assumed)
    return [{"fact": entry.fact, "value": entry.value, "evidence": entry.evidence} for entry in unique]


def finding_documents(findings: Iterable[Finding]) -> list[dict[str, str]]:
    """Return findings, each once, in their order."""
    unique = dict.fromkeys(findings)
    return [{"code": entry.code, "severity": entry.severity, "message": entry.message} for entry in unique]


def _axis(axis: AxisCompensation, where: FloatArray) -> dict[str, Any]:
    factor = outside_factor(axis.kind.unit)
    positive = axis.at(where, Direction.POSITIVE) * factor
    negative = axis.at(where, Direction.NEGATIVE) * factor
    return table_outside(where, positive, negative, axis.kind)
