"""Read a plan from its JSON, with the same checks as a job; see `record_schemas`."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from statistics import mode
from typing import Any, Final, cast

import numpy as np
from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.documents.findings import read_sentence
from compwright.documents.plain_values import PLAIN, is_number
from compwright.documents.plan_rules import RULES, contradictions
from compwright.foundations.findings import Finding
from compwright.foundations.key_faults import KeyFault, shown
from compwright.foundations.record_schemas import RecordForm, RecordSchemas, mapping
from compwright.foundations.validation import checked, refuse
from compwright.records.axis import Axis, Encoder, FloatArray
from compwright.records.circular import CircularTest
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.correction import ControlFile
from compwright.records.estimate import AxisPeriod, ErrorEstimate, WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.job import Acceptance
from compwright.records.plan import Plan, PlannedAxis, PlannedCircle, PlannedTest
from compwright.records.positioning import PositioningTest


def plan_of(data: Mapping[str, Any]) -> tuple[Plan | None, list[KeyFault]]:
    """Return the plan made from a JSON document, and no faults; or None and all faults."""
    plan, faults = checked(plan_validator(Plan), data)
    faults = faults or list(contradictions(plan))
    return (None if faults else cast("Plan", plan)), faults


@cache
def plan_validator(cls: type) -> SchemaValidator:
    """Return the pydantic validator of a record class in a plan."""
    return RecordSchemas(FORMS, RULES, PLAIN).validator(cls)


def _periods(values: dict[str, Any]) -> dict[str, Any]:
    """Return the values of an axis in a plan, with its key ``periods`` (periodic errors) also
    entered into its ``estimate``.
    """
    estimate = replace(values["estimate"], periods=values.get("periods", ()))
    return {**values, "estimate": estimate}


def _finding(values: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a finding; its text can be translated if this version of compwright
    knows the text.
    """
    return {**values, "sentence": read_sentence(values.get("sentence"), values["message"])}


def _unit(unit: Any, info: cs.ValidationInfo) -> None:
    """Check that the unit of an axis belongs to its kind."""
    axis = info.data.get("axis")
    if axis is not None and unit not in (None, axis.kind.unit):
        refuse(KeyFault((), "is not the unit of this axis", axis.kind.unit, shown(unit)))


def _readings(rows: Any) -> FloatArray:
    """Return rows of readings as an array; all rows have equal length, and null is no reading."""
    if not isinstance(rows, list) or not all(isinstance(row, list) for row in rows):
        refuse(KeyFault((), "is not a table", "a list of rows, one for each target", shown(rows)))
    width = mode(len(row) for row in rows) if rows else 0
    for index, row in enumerate(rows):
        odd = [one for one in row if one is not None and not is_number(one)]
        if odd or len(row) != width:
            expected = f"{width} readings, each a number or null"
            found = shown(odd[0] if odd else row)
            refuse(KeyFault((index,), "is not a row of readings", expected, found))
    filled = [[np.nan if one is None else float(one) for one in row] for row in rows]
    return np.array(filled, dtype=np.float64).reshape(len(rows), width)


def _definition(entries: Any) -> Any:
    if not isinstance(entries, list):
        expected = "a list of files with name and text"
        refuse(KeyFault((), "is not a list", expected, shown(entries)))
    for index, entry in enumerate(entries):
        texts = isinstance(entry, dict) and [entry.get(key) for key in ("name", "text")]
        if not texts or len(entry) > len(texts) or not all(isinstance(one, str) for one in texts):
            expected = "the keys name and text, both text"
            refuse(KeyFault((index,), "is not a file", expected, shown(entry)))
    try:
        return tuple((entry["name"], entry["text"].encode("utf-8")) for entry in entries)
    except UnicodeEncodeError as error:
        return refuse(
            KeyFault((), "contains something that is not text", "text that UTF-8 has", str(error))
        )


def _both(sides: Any) -> Any:
    """Return an active correction unchanged, after checking that its keys are exactly ``positive``
    and ``negative``.
    """
    if not isinstance(sides, dict) or set(sides) != {"positive", "negative"}:
        expected = "null, or the keys positive and negative"
        refuse(KeyFault((), "is not an accepted value", expected, shown(sides)))
    return sides


_ARRAY: Final = PLAIN[np.ndarray]
_READINGS: Final = cs.no_info_plain_validator_function(_readings)
_ACTIVE: Final = cs.no_info_before_validator_function(
    _both,
    mapping(
        {"positive": _ARRAY, "negative": _ARRAY}, lambda both: (both["positive"], both["negative"])
    ),
)
#: How the JSON of each record of a plan is written.
FORMS: Final[Mapping[type, RecordForm]] = {
    Plan: RecordForm(
        keys={"budgets": "uncertainty"},
        more={"schema": cs.any_schema()},
        absent=frozenset(
            {"decision_rule", "budgets", "definition", "active", "cross", "circles", "results"}
            | {"untested", "schema"}
        ),
        types={"definition": cs.no_info_plain_validator_function(_definition)},
    ),
    PlannedAxis: RecordForm(
        absent=frozenset({"unit", "periods"}),
        more={
            "unit": cs.with_info_plain_validator_function(_unit),
            "periods": tuple[AxisPeriod, ...],
        },
        build=_periods,
    ),
    PlannedTest: RecordForm(
        inline="test",
        absent=frozenset({"motion", "backlash_more", "slope_std", "acted"}),
        types={"acted": cs.nullable_schema(_ACTIVE)},
    ),
    Finding: RecordForm(
        more={"message": str},
        absent=frozenset({"sentence"}),
        types={"sentence": cs.any_schema()},
        build=_finding,
    ),
    PositioningTest: RecordForm(
        constant={"frame": "machine", "times": None},
        absent=frozenset({"thermal", "removed"}),
        types={
            "positive": _READINGS,
            "negative": _READINGS,
            "removed": cs.nullable_schema(cs.tuple_schema([_READINGS, _READINGS])),
        },
    ),
    ControlFile: RecordForm(
        keys={"content": "base64"}, constant={"folder": "", "leader": b"", "trailer": b""}
    ),
    CircularTest: RecordForm(constant={"vendor": {}}),
    PlannedCircle: RecordForm(
        keys={"budget": "uncertainty"}, absent=frozenset({"accept", "budget"})
    ),
    ErrorEstimate: RecordForm(constant={"periods": ()}),
    WantedCorrection: RecordForm(absent=frozenset({"scenarios"})),
    FittedTable: RecordForm(constant={"keeps_grid": False}),
    Axis: RecordForm(
        absent=frozenset(
            {"suggested_period", "motion", "gantry_table", "moves_alone"}
            | {"unapplied_steps", "zero_at_reference", "counts_turns"}
        )
    ),
    Encoder: RecordForm(absent=frozenset({"stated"})),
    TableRequest: RecordForm(absent=frozenset({"gain"})),
    Thermal: RecordForm(absent=frozenset({"rise_m", "rise_d"})),
    UncertaintyBudget: RecordForm(absent=frozenset({"setup", "E_VE"})),
    Acceptance: RecordForm(absent=frozenset({"test"})),
}
