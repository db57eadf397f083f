"""``plan.json`` (``compwright/plan/1``): mm or deg, totals before rounding, the control's own files
byte by byte.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, replace
from typing import Any, TypeVar

import numpy as np

from compwright.documents.json_text import read_json
from compwright.documents.plan_check import plan_faults
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source
from compwright.records.axis import Axis, AxisKind, Direction, Encoder, FloatArray
from compwright.records.circular import CircularRun, CircularTest
from compwright.records.correction import (
    Assumption,
    AxisCompensation,
    ControlFile,
    CrossCompensation,
)
from compwright.records.estimate import AxisPeriod, ErrorEstimate, Scenarios, WantedCorrection
from compwright.records.fitted import FittedTable, Limit, TableRequest
from compwright.records.job import Acceptance, Thermal, UncertaintyBudget
from compwright.records.plan import (
    Acted,
    Plan,
    PlannedAxis,
    PlannedCircle,
    PlannedCross,
    PlannedTest,
    Texts,
)
from compwright.records.positioning import PositioningTest

SCHEMA = "compwright/plan/1"
_T = TypeVar("_T")


def plan_document(plan: Plan) -> dict[str, Any]:
    """Return a plan as plain data. It carries no dates: same input, same bytes."""
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
                {"name": file.name, "base64": base64.b64encode(file.content).decode("ascii")}
                for file in files
            ]
            for name, files in plan.states.items()
        },
        "active": dict(plan.active),
        "sources": [asdict(source) for source in plan.sources],
        "assumed": [asdict(entry) for entry in plan.assumed],
        "cross": [_cross_out(entry) for entry in plan.cross],
        "circles": {name: _circle_out(circle) for name, circle in plan.circles.items()},
        "results": dict(plan.results),
        **({"untested": untested} if untested else {}),
    }


def _budgets_out(budgets: Mapping[AxisKind, UncertaintyBudget] | None) -> dict[str, Any]:
    if budgets is None:
        return {}
    return {"uncertainty": {str(kind): asdict(budget) for kind, budget in budgets.items()}}


def _budgets_in(
    data: Mapping[str, Mapping[str, float]] | None,
) -> dict[AxisKind, UncertaintyBudget] | None:
    if data is None:
        return None
    return {
        AxisKind(kind): UncertaintyBudget(**{name: float(value) for name, value in entry.items()})
        for kind, entry in data.items()
    }


def carried_definition(content: bytes) -> Texts:
    """Return the definition of one's own that a plan carries; empty where it has none, or is no
    plan.
    """
    try:
        return _definition_in(json.loads(content))
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return ()


def _definition_out(texts: Texts) -> dict[str, Any]:
    """Return nothing for a control that ships: every installation has its definition."""
    entries = [{"name": name, "text": content.decode("utf-8")} for name, content in texts]
    return {"definition": entries} if entries else {}


def _definition_in(data: Mapping[str, Any]) -> Texts:
    entries = data.get("definition", ())
    return tuple((str(entry["name"]), entry["text"].encode("utf-8")) for entry in entries)


def listed_files(content: bytes) -> Mapping[str, str]:
    """Return the results (relative name -> SHA-256) that an earlier plan lists, empty where there
    is no such list.
    """
    try:
        listed = json.loads(content)["results"]
        return {str(name): str(digest) for name, digest in listed.items()}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return {}


def read_plan(content: bytes, file: str) -> Plan:
    """Read a plan. Raises InputError when it is not one, is of a newer schema, or lacks a key
    (file, key, expected, found).
    """
    data = read_json(content, file, SCHEMA, "plan", "plan.json of a run")
    try:
        plan = _plan_in(data)
    except KeyError as error:
        raise InputError(
            Fault(message="lacks a key", file=file, expected=str(error.args[0]))
        ) from error
    except (
        TypeError,
        ValueError,
        AttributeError,
        IndexError,
        OverflowError,
        RecursionError,
    ) as error:
        raise InputError(
            Fault(message="does not fit the schema", file=file, expected=SCHEMA, found=str(error))
        ) from error
    raise_all(InputError, [fault.in_file(file) for fault in plan_faults(plan)])
    return plan


def _plan_in(data: Mapping[str, Any]) -> Plan:
    return Plan(
        version=str(data["version"]),
        format=str(data["format"]),
        definition=_definition_in(data),
        options=dict(data["options"]),
        standard=str(data["standard"]),
        decision_rule=str(data.get("decision_rule", "")),
        budgets=_budgets_in(data.get("uncertainty")),
        machine=dict(data["machine"]),
        axes={str(name): _axis_in(axis) for name, axis in data["axes"].items()},
        states={
            name: tuple(
                ControlFile(entry["name"], base64.b64decode(entry["base64"], validate=True))
                for entry in files
            )
            for name, files in data["states"].items()
        },
        active={name: bool(active) for name, active in data.get("active", {}).items()},
        sources=tuple(Source(**entry) for entry in data["sources"]),
        assumed=tuple(Assumption(**entry) for entry in data["assumed"]),
        cross=tuple(_cross_in(entry) for entry in data.get("cross", ())),
        circles={str(name): _circle_in(circle) for name, circle in data.get("circles", {}).items()},
        results={str(name): str(digest) for name, digest in data.get("results", {}).items()},
        untested={str(name): _record_in(axis) for name, axis in data.get("untested", {}).items()},
    )


def _cross_out(cross: PlannedCross) -> dict[str, Any]:
    return {**asdict(cross), "added": _arrays_out(cross.added)}


def _cross_in(data: Mapping[str, Any]) -> PlannedCross:
    added = data["added"]
    return PlannedCross(
        input=str(data["input"]),
        output=str(data["output"]),
        added=CrossCompensation(
            input=str(added["input"]),
            output=str(added["output"]),
            input_kind=AxisKind(added["input_kind"]),
            output_kind=AxisKind(added["output_kind"]),
            positions=_array(added, "positions"),
            positive=_array(added, "positive"),
            negative=_array(added, "negative"),
            below=added["below"],
            above=added["above"],
            period=_optional(added["period"], float),
        ),
        source=data["source"],
        tests=tuple(str(name) for name in data["tests"]),
        squareness=float(data["squareness"]),
        std_error=_optional(data["std_error"], float),
        written=bool(data["written"]),
    )


def _circle_out(circle: PlannedCircle) -> dict[str, Any]:
    test = circle.test
    return {
        "measured_in": circle.measured_in,
        "centre": list(circle.centre),
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
            "findings": [asdict(finding) for finding in test.findings],
        },
    }


def _circle_in(data: Mapping[str, Any]) -> PlannedCircle:
    test = data["test"]
    first, second = test["axes"]
    start, extent = test["arc"]
    return PlannedCircle(
        test=CircularTest(
            name=str(test["name"]),
            plane=str(test["plane"]),
            axes=(str(first), str(second)),
            nominal_radius=float(test["nominal_radius"]),
            feed=float(test["feed"]),
            arc=(float(start), float(extent)),
            calibrated=bool(test["calibrated"]),
            centre=_optional(
                test["centre"], lambda values: tuple(float(value) for value in values)
            ),
            runs=tuple(
                CircularRun(
                    sense=run["sense"],
                    angles=_array(run, "angles"),
                    deviations=_array(run, "deviations"),
                    number=int(run["number"]),
                )
                for run in test["runs"]
            ),
            sources=tuple(Source(**entry) for entry in test["sources"]),
            header=dict(test["header"]),
            findings=tuple(Finding(**entry) for entry in test["findings"]),
        ),
        measured_in=str(data["measured_in"]),
        centre=(float(data["centre"][0]), float(data["centre"][1])),
    )


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
                "acted": _optional(entry.acted, _acted_out),
                **_test_out(entry.test),
            }
            for entry in axis.tests
        ],
        "periods": [asdict(period) for period in axis.estimate.periods],
        "estimate": {
            key: value for key, value in _arrays_out(axis.estimate).items() if key != "periods"
        },
        "active": _optional(axis.active, _compensation_out),
        "wanted": _optional(axis.wanted, _wanted_out),
        "request": asdict(axis.request),
        "fitted": _optional(axis.fitted, _fitted_out),
        "accept": _optional(axis.accept, asdict),
    }


def _record_out(axis: Axis) -> dict[str, Any]:
    return {**asdict(axis), "options": dict(axis.options)}


def _record_in(data: Mapping[str, Any]) -> Axis:
    raw = dict(data)
    raw["kind"] = AxisKind(raw["kind"])
    raw["reference_return"] = Direction(raw["reference_return"])
    raw["encoder"] = Encoder(**raw["encoder"])
    raw["travel"] = (float(raw["travel"][0]), float(raw["travel"][1]))
    raw["screw_pitch"] = tuple(raw["screw_pitch"])
    return Axis(**raw)


def _axis_in(data: Mapping[str, Any]) -> PlannedAxis:
    return PlannedAxis(
        axis=_record_in(data["axis"]),
        tests=tuple(
            PlannedTest(
                test=_test_in(entry),
                measured_in=str(entry["measured_in"]),
                motion=entry.get("motion", "feed"),
                backlash_more=float(entry.get("backlash_more", 0.0)),
                slope_std=float(entry.get("slope_std", 0.0)),
                acted=_optional(entry.get("acted"), _acted_in),
            )
            for entry in data["tests"]
        ),
        estimate=_estimate_in(data["estimate"], data.get("periods", ())),
        active=_optional(data["active"], _compensation_in),
        wanted=_optional(data["wanted"], _wanted_in),
        request=TableRequest(**data["request"]),
        fitted=_optional(data["fitted"], _fitted_in),
        accept=_optional(data["accept"], lambda entry: Acceptance(**entry)),
    )


def _acted_out(acted: Acted) -> dict[str, list[float]]:
    return {"positive": acted[0].tolist(), "negative": acted[1].tolist()}


def _acted_in(data: Mapping[str, Any]) -> Acted:
    return _array(data, "positive"), _array(data, "negative")


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
        "findings": [asdict(finding) for finding in test.findings],
        **({} if test.thermal is None else {"thermal": asdict(test.thermal)}),
    }


def _test_in(data: Mapping[str, Any]) -> PositioningTest:
    targets = np.array(data["targets"], dtype=np.float64)
    return PositioningTest(
        name=str(data["name"]),
        axis=str(data["axis"]),
        kind=AxisKind(data["kind"]),
        cycle=data["cycle"],
        targets=targets,
        positive=_readings_in(data["positive"], targets.size),
        negative=_readings_in(data["negative"], targets.size),
        runs_positive=tuple(data["runs_positive"]),
        runs_negative=tuple(data["runs_negative"]),
        frame="machine",
        sources=tuple(Source(**entry) for entry in data["sources"]),
        header=dict(data["header"]),
        findings=tuple(Finding(**entry) for entry in data["findings"]),
        thermal=_optional(data.get("thermal"), lambda entry: Thermal(**entry)),
    )


def _readings_out(readings: FloatArray) -> list[list[float | None]]:
    return [[float(value) if np.isfinite(value) else None for value in row] for row in readings]


def _readings_in(rows: list[list[float | None]], count: int) -> FloatArray:
    filled = [[np.nan if value is None else float(value) for value in row] for row in rows]
    return np.array(filled, dtype=np.float64).reshape(count, len(filled[0]) if filled else 0)


def _arrays_out(record: Any) -> dict[str, Any]:
    return {
        key: value.tolist() if isinstance(value, np.ndarray) else value
        for key, value in asdict(record).items()
    }


def _array(data: Mapping[str, Any], key: str) -> FloatArray:
    return np.array(data[key], dtype=np.float64)


def _estimate_in(data: Mapping[str, Any], periods: Iterable[Mapping[str, Any]]) -> ErrorEstimate:
    names = ("positions", "mean_positive", "mean_negative", "std_positive", "std_negative")
    return ErrorEstimate(
        kind=AxisKind(data["kind"]),
        noise=float(data["noise"]),
        noise_dof=float(data["noise_dof"]),
        measured=(float(data["measured"][0]), float(data["measured"][1])),
        findings=tuple(Finding(**entry) for entry in data["findings"]),
        periods=tuple(AxisPeriod(**entry) for entry in periods),
        **{name: _array(data, name) for name in names},
    )


def _wanted_out(wanted: WantedCorrection) -> dict[str, Any]:
    """Return what is wanted; the tests that judge a goal only where the job has one."""
    out = _arrays_out(replace(wanted, scenarios=None))
    del out["scenarios"]
    if wanted.scenarios is None:
        return out
    return {**out, "scenarios": _arrays_out(wanted.scenarios)}


def _scenarios_in(data: Mapping[str, Any]) -> Scenarios:
    names = ("positions", "positive", "negative", "half_positive", "half_negative")
    return Scenarios(count=data["count"], **{name: _array(data, name) for name in names})


def _wanted_in(data: Mapping[str, Any]) -> WantedCorrection:
    return WantedCorrection(
        kind=AxisKind(data["kind"]),
        positions=_array(data, "positions"),
        positive=_array(data, "positive"),
        negative=_array(data, "negative"),
        reference=float(data["reference"]),
        reference_return=Direction(data["reference_return"]),
        noise=float(data["noise"]),
        reversal_log_odds=float(data["reversal_log_odds"]),
        periods=tuple(float(period) for period in data["periods"]),
        scenarios=_optional(data.get("scenarios"), _scenarios_in),
    )


def _compensation_in(data: Mapping[str, Any]) -> AxisCompensation:
    return AxisCompensation(
        address=str(data["address"]),
        kind=AxisKind(data["kind"]),
        positions=_array(data, "positions"),
        positive=_array(data, "positive"),
        negative=_array(data, "negative"),
        backlash=float(data["backlash"]),
        reference_return=Direction(data["reference_return"]),
        below=data["below"],
        above=data["above"],
        interpolation=data["interpolation"],
        period=_optional(data["period"], float),
        slope=float(data["slope"]),
        origin=float(data["origin"]),
        others=tuple(_compensation_in(entry) for entry in data["others"]),
    )


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
        "findings": [asdict(finding) for finding in fitted.findings],
    }


def _fitted_in(data: Mapping[str, Any]) -> FittedTable:
    return FittedTable(
        compensation=_compensation_in(data["compensation"]),
        mode=data["mode"],
        mode_reason=str(data["mode_reason"]),
        certificate=dict(data["certificate"]),
        limits=tuple(Limit(**entry) for entry in data["limits"]),
        findings=tuple(Finding(**entry) for entry in data["findings"]),
    )


def _optional(value: Any, convert: Callable[[Any], _T]) -> _T | None:
    return None if value is None else convert(value)
