"""The file ``plan.json``: corrections before rounding (mm or deg), and copies of control files.

Its schema is ``compwright/plan/1``.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Mapping
from dataclasses import asdict, replace
from typing import Any, TypeVar

import numpy as np

from compwright.documents.findings import planned_finding
from compwright.documents.json_text import read_json
from compwright.documents.plan_reading import plan_of
from compwright.foundations.errors import Fault, InputError
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.conditions import UncertaintyBudget
from compwright.records.correction import (
    AxisCompensation,
)
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable
from compwright.records.plan import (
    Acted,
    Plan,
    PlannedAxis,
    PlannedCircle,
    Texts,
)
from compwright.records.positioning import PositioningTest
from compwright.records.serial_line import from_line

SCHEMA = "compwright/plan/1"
_AS_WRITTEN = "give plan.json as `compwright run` wrote it, or make it again with `compwright run`"
_T = TypeVar("_T")


def plan_document(plan: Plan) -> dict[str, Any]:
    """Return a plan as plain data without dates, so that equal inputs give equal bytes."""
    untested = {name: _record_out(axis) for name, axis in plan.untested.items()}
    return {
        "schema": SCHEMA,
        "version": plan.version,
        "format": plan.format,
        **_definition_out(plan.definition),
        "options": dict(plan.options),
        "standard": plan.standard,
        "decision_rule": plan.decision_rule,
        **_budgets_out(plan.budgets),
        "machine": dict(plan.machine),
        "axes": {name: _axis_out(axis) for name, axis in plan.axes.items()},
        "states": {
            name: [
                {"name": file.name, "base64": base64.b64encode(file.raw).decode("ascii")}
                for file in files
            ]
            for name, files in plan.states.items()
        },
        "active": dict(plan.active),
        "sources": [asdict(source) for source in plan.sources],
        "assumed": [asdict(entry) for entry in plan.assumed],
        "cross": [{**asdict(entry), "added": _arrays_out(entry.added)} for entry in plan.cross],
        "circles": {name: _circle_out(circle) for name, circle in plan.circles.items()},
        "results": dict(plan.results),
        **({"untested": untested} if untested else {}),
    }


def _budgets_out(budgets: Mapping[AxisKind, UncertaintyBudget] | None) -> dict[str, Any]:
    if budgets is None:
        return {}
    return {"uncertainty": {str(kind): asdict(budget) for kind, budget in budgets.items()}}


def carried_definition(content: bytes) -> Texts:
    """Return the files (name and contents) of the user's own control definition that a plan
    contains; empty if it contains none or cannot be read.
    """
    try:
        return _definition_in(json.loads(content))
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return ()


def _definition_out(texts: Texts) -> dict[str, Any]:
    """Return the plan's entry ``definition`` with the files of the user's own control definition,
    ``texts`` (name and contents); empty if there are none.
    """
    entries = [{"name": name, "text": content.decode("utf-8")} for name, content in texts]
    return {"definition": entries} if entries else {}


def _definition_in(data: Mapping[str, Any]) -> Texts:
    entries = data.get("definition", ())
    return tuple((str(entry["name"]), entry["text"].encode("utf-8")) for entry in entries)


def listed_files(content: bytes) -> Mapping[str, str]:
    """Return the SHA-256 of each result file listed in a plan, by relative name."""
    try:
        listed = json.loads(content)["results"]
        return {str(name): str(digest) for name, digest in listed.items()}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}


def read_plan(content: bytes, file: str) -> Plan:
    """Read a plan. Raises InputError with every fault at once (file, key path, expected, found).

    Faults are a file that is no plan, a newer schema, and contents that violate the rules of a
    plan.
    """
    data = read_json(content, file, SCHEMA, "plan", "plan.json of a run")
    try:
        plan, faults = plan_of(data)
    except RecursionError as error:
        raise InputError(
            Fault(
                message="the JSON of the file is nested too deeply to be a plan",
                file=file,
                expected="the plan.json of a run",
                hint=_AS_WRITTEN,
            )
        ) from error
    if plan is None:
        raise InputError(*(replace(fault.in_file(file), hint=_AS_WRITTEN) for fault in faults))
    states = {
        name: tuple(from_line(each.name, each.content) for each in files)
        for name, files in plan.states.items()
    }
    return replace(plan, states=states)


def _circle_out(circle: PlannedCircle) -> dict[str, Any]:
    test = circle.test
    return {
        "measured_in": circle.measured_in,
        "centre": list(circle.centre),
        **({} if circle.accept is None else {"accept": asdict(circle.accept)}),
        **({} if circle.budget is None else {"uncertainty": asdict(circle.budget)}),
        "test": {
            "name": test.name,
            "plane": test.plane,
            "axes": list(test.axes),
            "nominal_radius": float(test.nominal_radius),
            "feed": float(test.feed),
            "arc": list(test.arc),
            "calibrated": test.calibrated,
            "centre": None if test.centre is None else list(test.centre),
            "runs": [_arrays_out(run) for run in test.runs],
            "sources": [asdict(source) for source in test.sources],
            "header": dict(test.header),
            "findings": [planned_finding(finding) for finding in test.findings],
        },
    }


def _axis_out(axis: PlannedAxis) -> dict[str, Any]:
    return {
        "axis": _record_out(axis.axis),
        "unit": axis.axis.kind.unit,
        "tests": [
            {
                "measured_in": entry.measured_in,
                "motion": entry.motion,
                "backlash_more": entry.backlash_more,
                "slope_std": entry.slope_std,
                "acted": _optional(entry.acted, _active_out),
                **_test_out(entry.test),
            }
            for entry in axis.tests
        ],
        "periods": [asdict(period) for period in axis.estimate.periods],
        "estimate": {
            key: value for key, value in _arrays_out(axis.estimate).items() if key != "periods"
        }
        | {"findings": [planned_finding(finding) for finding in axis.estimate.findings]},
        "active": _optional(axis.active, _compensation_out),
        "wanted": _optional(axis.wanted, _wanted_out),
        "request": asdict(axis.request),
        "fitted": _optional(axis.fitted, _fitted_out),
        "accept": _optional(axis.accept, asdict),
    }


def _record_out(axis: Axis) -> dict[str, Any]:
    return {**asdict(axis), "options": dict(axis.options)}


def _active_out(active: Acted) -> dict[str, list[float]]:
    return {"positive": active[0].tolist(), "negative": active[1].tolist()}


def _test_out(test: PositioningTest) -> dict[str, Any]:
    return {
        "name": test.name,
        "axis": test.axis,
        "kind": test.kind.value,
        "cycle": test.cycle,
        "targets": test.targets.tolist(),
        "positive": _readings_out(test.positive),
        "negative": _readings_out(test.negative),
        "runs_positive": list(test.runs_positive),
        "runs_negative": list(test.runs_negative),
        "sources": [asdict(source) for source in test.sources],
        "header": dict(test.header),
        "findings": [planned_finding(finding) for finding in test.findings],
        **({} if test.thermal is None else {"thermal": asdict(test.thermal)}),
        **(
            {}
            if test.removed is None
            else {"removed": [_readings_out(removed) for removed in test.removed]}
        ),
    }


def _readings_out(readings: FloatArray) -> list[list[float | None]]:
    return [[float(value) if np.isfinite(value) else None for value in row] for row in readings]


def _arrays_out(record: Any) -> dict[str, Any]:
    return {
        key: value.tolist() if isinstance(value, np.ndarray) else value
        for key, value in asdict(record).items()
    }


def _wanted_out(wanted: WantedCorrection) -> dict[str, Any]:
    """Return the wanted correction as plain data, with simulated tests if it has any."""
    out = _arrays_out(replace(wanted, scenarios=None))
    del out["scenarios"]
    if wanted.scenarios is None:
        return out
    return {**out, "scenarios": _arrays_out(wanted.scenarios)}


def _compensation_out(compensation: AxisCompensation) -> dict[str, Any]:
    return {
        **_arrays_out(compensation),
        "others": [_compensation_out(other) for other in compensation.others],
    }


def _fitted_out(fitted: FittedTable) -> dict[str, Any]:
    return {
        "compensation": _compensation_out(fitted.compensation),
        "mode": fitted.mode,
        "mode_reason": fitted.mode_reason,
        "certificate": dict(fitted.certificate),
        "limits": [asdict(limit) for limit in fitted.limits],
        "findings": [planned_finding(finding) for finding in fitted.findings],
    }


def _optional(value: Any, convert: Callable[[Any], _T]) -> _T | None:
    return None if value is None else convert(value)
