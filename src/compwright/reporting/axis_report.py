"""The section of one axis in the report of ``run``: its results, what limits it, its periodic
errors, its table, and its estimated error.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Final

from compwright.reporting import paper, sections
from compwright.reporting.axis_figures import (
    before_after_figure,
    estimate_figure,
    table_figure,
)
from compwright.reporting.chart_svg import Drawing
from compwright.reporting.limiting import limits_block
from compwright.reporting.numbers import (
    decimals_of,
    number,
    plain,
    position_unit,
    unit_text,
    with_unit,
)
from compwright.reporting.page_parts import anchor
from compwright.reporting.periods import periods_block
from compwright.reporting.point_count_figure import worth_block
from compwright.reporting.sections import Document, TextTable
from compwright.words.sentences import Sentence, say

_CHUNK: Final = 24  # rows of the table in numbers before a second column is begun


def axis_block(task: tuple[int, str, Document, Document, Document]) -> dict[str, Any]:
    """Return the report section of an axis. ``task``: its number on the page, its name, what the
    view contains on it, its prediction, and the parts of the view on all axes.
    """
    return _run_axis(*task)


def _run_axis(
    index: int, name: str, axis: Document, predicted: Document, view: Document
) -> dict[str, Any]:
    unit = axis.get("unit", "um")
    tests = predicted.get("tests") or [
        {
            "name": None,
            **{key: predicted.get(key) for key in ("before", "predicted", "predicted_new_targets")},
        }
    ]
    result = sections.result_of(view.get("evaluation"), name, tests[0].get("name"))
    stated = view.get("stated") or {}
    table = predicted.get("table")
    return {
        "name": name,
        "anchor": anchor(index),
        "facts": _axis_facts(axis, predicted),
        "both": _before_figure(name, result, axis, predicted),
        "measured": (
            paper.measured_block(result, stated.get(str(tests[0].get("name"))) or {})
            if result
            else None
        ),
        "parameters": (
            _run_parameters(tests[0], result, unit) if result or tests[0].get("before") else None
        ),
        "findings": sections.findings(
            axis.get("findings"), predicted.get("findings"), (result or {}).get("findings")
        ),
        "mode": _mode(axis),
        "table": _table(name, table, axis, predicted) if table else None,
        "refused": plain(axis.get("refused") or ""),
        "limits": limits_block(predicted, unit),
        "worth": worth_block(predicted, unit),
        "periods": periods_block(predicted, unit),
        "state": _state(axis.get("state")),
        "estimate": (
            estimate_figure(axis["estimate"], result, name)
            if axis.get("estimate") and result
            else None
        ),
        "certificate": _certificate(axis.get("certificate")),
        "others": [_other_test(test, name, unit, view) for test in tests[1:]],
    }


def _axis_facts(axis: Document, predicted: Document) -> list[tuple[Sentence, str | Sentence]]:
    unit = unit_text(axis.get("unit", "um"))
    facts: list[tuple[Sentence, str | Sentence]] = []
    if axis.get("address") not in (None, ""):
        facts.append((say("fact.address"), plain(axis["address"])))
    if axis.get("kind"):
        facts.append((say("fact.kind"), say("label.kind", kind=str(axis["kind"]))))
    facts.append((say("fact.unit"), unit))
    quantum = predicted.get("quantum")
    if quantum is not None:
        facts.append((say("fact.quantum"), with_unit(quantum, unit)))
    return facts


def _before_figure(
    name: str, result: Document | None, axis: Document, predicted: Document
) -> Drawing | None:
    expected = axis.get("predicted_targets")
    if result is None or not expected:
        return None
    with_numbers = {**expected, "parameters": predicted.get("predicted")}
    return before_after_figure(result, with_numbers, name)


def _run_parameters(test: Document, result: Document | None, unit: object) -> dict[str, Any]:
    result = result or {}
    columns: list[dict[str, Any]] = [
        {
            "title": say("head.before"),
            "values": test.get("before") or result.get("parameters"),
            "uncertainty": result.get("uncertainty"),
        },
        {"title": say("head.predicted_same"), "quantiles": test.get("predicted")},
    ]
    if test.get("predicted_new_targets"):
        columns.append(
            {"title": say("head.predicted_new"), "quantiles": test["predicted_new_targets"]}
        )
    return sections.parameter_block(
        unit, result.get("standard", ""), result.get("not_applicable"), columns
    )


def _other_test(test: Document, axis: str, unit: object, view: Document) -> dict[str, Any]:
    result = sections.result_of(view.get("evaluation"), axis, test.get("name"))
    return {
        "name": plain(test.get("name")),
        "measured": (
            paper.measured_block(
                result, (view.get("stated") or {}).get(str(test.get("name"))) or {}
            )
            if result
            else None
        ),
        "parameters": _run_parameters(test, result, unit),
    }


def _table(name: str, table: Document, axis: Document, predicted: Document) -> dict[str, Any]:
    unit = table.get("unit", axis.get("unit", "um"))
    positions, positive, negative = (
        list(table[key]) for key in ("positions", "correction_positive", "correction_negative")
    )
    digits, places = decimals_of([*positive, *negative]), decimals_of(positions)
    title = [
        (say("head.position"), position_unit(unit)),
        (say("head.correction", sign="+"), unit_text(unit)),
        (say("head.correction", sign="−"), unit_text(unit)),
    ]
    rows = [
        [number(where, places), number(up, digits), number(down, digits)]
        for where, up, down in zip(positions, positive, negative, strict=True)
    ]
    height = max(_CHUNK, -(-len(rows) // 3))
    return {
        "figure": table_figure(
            {"table": table, "wanted": axis.get("wanted"), "unit": unit},
            name,
        ),
        "caption": say("run.table", count=len(rows), wanted=bool(axis.get("wanted"))),
        "count": len(rows),
        "chunks": [
            {"heads": sections.heads(*title), "rows": rows[start : start + height]}
            for start in range(0, len(rows), height)
        ],
        "quantum": plain(predicted.get("quantum")),
    }


def _mode(axis: Document) -> str | Sentence:
    reason = plain(axis.get("mode_reason") or "")
    if reason:
        return reason
    words = {"single": say("run.single"), "bidirectional": say("run.bidirectional")}
    return words.get(str(axis.get("mode")), "")


def _state(state: object) -> str | Sentence:
    if state is None:
        return say("run.state_not_given")
    if isinstance(state, str):
        return say("run.state_none") if state == "none" else state
    files = [str(file) for file in state] if isinstance(state, Iterable) else []
    return say("run.state_files", files=files)


def _certificate(values: Document | None) -> TextTable | None:
    if not values:
        return None
    rows = [
        [
            say("certificate.name", key=str(name), name=str(name).replace("_", " ")),
            f"{value:.3g}".replace("-", "−") if isinstance(value, float) else plain(value),
        ]
        for name, value in values.items()
    ]
    return {"heads": sections.heads(say("head.residual"), (say("head.value"), "")), "rows": rows}
