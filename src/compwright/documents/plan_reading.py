"""A plan from its JSON, checked like a job: see `checked_json`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from statistics import mode
from typing import Any, Final, cast

import numpy as np

from compwright.documents.checked_json import FAULTY, Form, Reader, below, is_number
from compwright.documents.plan_rules import RULES, contradictions
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, Encoder
from compwright.records.circular import CircularTest
from compwright.records.correction import ControlFile
from compwright.records.estimate import AxisPeriod, ErrorEstimate, WantedCorrection
from compwright.records.fitted import FittedTable, TableRequest
from compwright.records.job import Acceptance, Thermal, UncertaintyBudget
from compwright.records.plan import Plan, PlannedAxis, PlannedTest
from compwright.records.positioning import PositioningTest


def plan_of(data: Mapping[str, Any]) -> tuple[Plan | None, list[Fault]]:
    """Return the plan that a document holds, and everything that is wrong with it; None where
    something is.
    """
    reader = Reader("plans", FORMS, RULES)
    plan = reader.record(data, Plan, "")
    faults = reader.faults or list(contradictions(plan))
    return (None if faults else cast("Plan", plan)), faults


def _estimate(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    """The periods of an estimate stand beside it."""
    periods: Any = ()
    if "periods" in data:
        beside = f"{place.removesuffix('estimate')}periods"
        periods = reader.value(data["periods"], tuple[AxisPeriod, ...], beside)
    estimate = reader.record(data["estimate"], ErrorEstimate, place)
    if estimate is FAULTY or periods is FAULTY:
        return FAULTY
    return replace(estimate, periods=periods)


def _axis(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    """The unit beside an axis is that of its kind."""
    axis = reader.record(data["axis"], Axis, place)
    said = data.get("unit")
    if axis is not FAULTY and said not in (None, axis.kind.unit):
        return reader.wrong(f"{place.removesuffix('axis')}unit", axis.kind.unit, said)
    return axis


def _acted(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    value = data["acted"]
    if value is None:
        return None
    if not isinstance(value, dict) or set(value) != {"positive", "negative"}:
        return reader.wrong(place, "null, or the keys positive and negative", value)
    sides = tuple(
        reader.value(value[key], np.ndarray[Any, Any], below(place, key))
        for key in ("positive", "negative")
    )
    return FAULTY if any(side is FAULTY for side in sides) else sides


def _positive(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    return _readings(reader, data["positive"], place)


def _negative(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    return _readings(reader, data["negative"], place)


def _readings(reader: Reader, rows: Any, place: str) -> Any:
    """Rows of numbers, each as long; null is a reading that is missing."""
    if not isinstance(rows, list) or not all(isinstance(row, list) for row in rows):
        return reader.wrong(place, "a list of rows, one for each target", rows)
    width = mode(len(row) for row in rows) if rows else 0
    for index, row in enumerate(rows):
        odd = [one for one in row if one is not None and not is_number(one)]
        if odd or len(row) != width:
            expected = f"{width} readings, each a number or null"
            return reader.wrong(f"{place}[{index}]", expected, odd[0] if odd else row)
    filled = [[np.nan if one is None else float(one) for one in row] for row in rows]
    return np.array(filled, dtype=np.float64).reshape(len(rows), width)


def _definition(reader: Reader, data: Mapping[str, Any], place: str) -> Any:
    entries = data["definition"]
    if not isinstance(entries, list):
        return reader.wrong(place, "a list of files with name and text", entries)
    for index, entry in enumerate(entries):
        texts = isinstance(entry, dict) and [entry.get(key) for key in ("name", "text")]
        if not texts or len(entry) > len(texts) or not all(isinstance(one, str) for one in texts):
            return reader.wrong(f"{place}[{index}]", "the keys name and text, both text", entry)
    try:
        return tuple((entry["name"], entry["text"].encode("utf-8")) for entry in entries)
    except UnicodeEncodeError as error:
        return reader.wrong(place, "text that UTF-8 has", str(error))


#: How the JSON of each record of a plan is written.
FORMS: Final[Mapping[type, Form]] = {
    Plan: Form(
        keys={"budgets": "uncertainty"},
        beside=frozenset({"schema"}),
        absent=frozenset(
            {"decision_rule", "budgets", "definition", "active", "cross", "circles", "results"}
            | {"untested"}
        ),
        read={"definition": _definition},
    ),
    PlannedAxis: Form(
        beside=frozenset({"unit", "periods"}), read={"axis": _axis, "estimate": _estimate}
    ),
    PlannedTest: Form(
        inline="test",
        absent=frozenset({"motion", "backlash_more", "slope_std", "acted"}),
        read={"acted": _acted},
    ),
    PositioningTest: Form(
        constant={"frame": "machine"},
        absent=frozenset({"thermal"}),
        read={"positive": _positive, "negative": _negative},
    ),
    ControlFile: Form(
        keys={"content": "base64"}, constant={"folder": "", "leader": b"", "trailer": b""}
    ),
    CircularTest: Form(constant={"vendor": {}}),
    ErrorEstimate: Form(constant={"periods": ()}),
    WantedCorrection: Form(absent=frozenset({"scenarios"})),
    FittedTable: Form(constant={"keeps_grid": False}),
    Axis: Form(
        absent=frozenset(
            {"suggested_period", "motion", "gantry_table", "moves_alone"}
            | {"unapplied_steps", "zero_at_reference", "counts_turns"}
        )
    ),
    Encoder: Form(absent=frozenset({"stated"})),
    TableRequest: Form(absent=frozenset({"gain"})),
    Thermal: Form(absent=frozenset({"rise_m", "rise_d"})),
    UncertaintyBudget: Form(absent=frozenset({"setup", "E_VE"})),
    Acceptance: Form(absent=frozenset({"test"})),
}
