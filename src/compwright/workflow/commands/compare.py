"""``compare``: what was read back from the control against the plan, each difference named."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from compwright.documents.compare import ComparedAxis, Difference, compare_document
from compwright.documents.plan import read_plan
from compwright.formats.text.diff import compare_files
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.job import AS_FOUND
from compwright.records.plan import PlannedAxis
from compwright.verification.read_back import SAME, judge_read_back
from compwright.workflow.stages.acting import correction_of
from compwright.workflow.stages.control import (
    DecodedState,
    decode,
    open_control,
    plan_origin,
    read_files,
)
from compwright.workflow.stages.two_readers import probe_positions
from compwright.workflow.stages.written import write_fitted


@dataclass(frozen=True, slots=True)
class CompareOutcome:
    """The document, and 0 where the control holds what was planned, else 1."""

    exit_code: int
    document: Mapping[str, Any]


def compare_plan(plan_file: Path, loaded: Sequence[Path]) -> CompareOutcome:
    """Hold files that were read back from the control against a plan.

    Raises UsageError for a plan without tables, InputError for files that cannot be read,
    contradict themselves or say nothing of an axis of the plan.
    """
    plan = read_plan(storage.read_bytes(plan_file), str(plan_file))
    control = open_control(plan.format, plan.options, plan_origin(plan, plan_file))
    planned = [entry for entry in plan.axes.values() if entry.fitted is not None]
    if not planned:
        raise UsageError(
            Fault(message="the plan holds no table to compare with", file=str(plan_file))
        )
    axes = [entry.axis for entry in planned]
    as_found = decode(
        control, plan.states.get(AS_FOUND, ()), axes, active=plan.active.get(AS_FOUND)
    )
    control = control.in_state(as_found.state)
    fitted = [(entry.axis, entry.fitted) for entry in planned if entry.fitted is not None]
    files, wish = write_fitted(control, fitted, as_found)
    found = decode(control, read_files(loaded), axes)
    raise_all(InputError, list(_unsaid(axes, found, loaded)))
    entries = (
        compare_files(control.definition, files, found.files).changes if wish is not None else ()
    )
    compared: dict[str, ComparedAxis] = {}
    for entry in planned:
        read_back = judge_read_back(
            correction_of(wish, entry.axis),
            correction_of(found, entry.axis),
            correction_of(as_found, entry.axis),
            *_nodes(entry),
        )
        values = tuple(_values(entry, wish, found))
        texts = tuple(
            Difference(entry.axis.name, change.entry, change.old, change.new)
            for change in entries
            # A record that names no axis (a point, a row) is told where the axis' correction
            # differs.
            if change.old is not None
            and (
                change.address == entry.axis.address
                or (change.address is None and read_back.verdict != "loaded")
            )
        )
        same = read_back.verdict == "loaded"
        compared[entry.axis.name] = ComparedAxis(
            entry.axis.address,
            entry.axis.kind,
            read_back,
            () if same and not _matters(texts) else (*texts, *values),
        )
    findings = (*control.findings, *found.state.findings)
    document = compare_document(plan.format, compared, found.state.assumed, findings)
    return CompareOutcome(0 if document["verdict"] == "same" else 1, document)


def _matters(texts: Sequence[Difference]) -> bool:
    """Whether entries differ although the same correction comes out: another number of the
    reference, say, still does its work.
    """
    return any(entry.loaded is not None for entry in texts)


def _unsaid(axes: Sequence[Axis], found: DecodedState, loaded: Sequence[Path]) -> Iterator[Fault]:
    for axis in axes:
        if axis.address not in found.state.axes:
            yield Fault(
                message=(
                    f"the files say nothing of axis {axis.name} (address {axis.address}); missing"
                    " is not zero"
                ),
                file=", ".join(map(str, loaded)),
                expected="what was read back from the control",
            )


def _nodes(entry: PlannedAxis) -> tuple[FloatArray, float]:
    positions = entry.fitted.compensation.positions if entry.fitted is not None else np.empty(0)
    if positions.size < 2:
        return positions, 0.0
    return probe_positions(positions), float(positions[1] - positions[0])


def _values(
    entry: PlannedAxis, wish: DecodedState | None, found: DecodedState
) -> Iterator[Difference]:
    """Yield each node and direction at which the correction differs."""
    axis = entry.axis
    if entry.fitted is None:
        return
    factor, unit = outside_factor(axis.kind.unit), outside_unit(axis.kind.unit)
    positions = entry.fitted.compensation.positions
    if positions.size == 0:
        positions = np.array(axis.travel)
    for direction in Direction:
        mine, theirs = (
            correction_of(wish, axis)(positions, direction),
            correction_of(found, axis)(positions, direction),
        )
        for position, planned, loaded in zip(positions, mine, theirs, strict=True):
            if abs(planned - loaded) > SAME:
                quantity = (
                    f"correction at {position:.10g} {axis.kind.unit} arriving in {direction.value}"
                )
                yield Difference(
                    axis.name, quantity, float(planned * factor), float(loaded * factor), unit
                )
