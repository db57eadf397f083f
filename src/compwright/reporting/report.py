"""The reports of ``run`` and ``verify``: one self-contained HTML page each, made of documents.
Computes nothing.

The view of ``run_report`` holds ``title``, ``machine`` (name -> text), ``format`` (``id``,
``title``), ``evaluation`` and ``prediction`` (the documents), ``axes``, ``assumed``, ``findings``,
``files`` (relative names), ``no_tables`` (None or why) and ``version``. Each of ``axes`` (by name)
holds ``address``, ``kind``, ``unit``, ``estimate``, ``wanted``, ``mode``, ``mode_reason``,
``certificate``, ``state``, ``predicted_targets`` and ``findings``. The view of ``verify_report``
holds ``verification``, ``evaluation_before`` and ``evaluation_after`` instead of the first two
documents. Deviations are in µm or arcsec as ``unit`` says, positions in mm or deg.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Final

from compwright.foundations.side_by_side import Each, in_turn
from compwright.reporting import sections
from compwright.reporting.card import changes_content
from compwright.reporting.circles import circle_blocks
from compwright.reporting.extra import need
from compwright.reporting.limiting import limits_block
from compwright.reporting.numbers import (
    SIMPLE,
    decimals_of,
    number,
    plain,
    position_unit,
    standard_text,
    symbol,
    unit_text,
)
from compwright.reporting.page import inline_figure, render_page
from compwright.reporting.periods import periods_block
from compwright.reporting.plots import (
    before_after_plot,
    estimate_plot,
    positioning_plot,
    table_plot,
)
from compwright.reporting.sections import Document, TextTable
from compwright.reporting.worth import worth_block

_CHUNK: Final = 24  # rows of the table in numbers before a second column is begun


def run_report(view: Document, each: Each = in_turn) -> bytes:
    """Return the report of ``run``: the verdict first, then each axis, assumptions, findings, raw
    data, files. ``each`` works on the axes.

    Raises UsageError when the report extra is missing.
    """
    prediction = view.get("prediction") or {}
    axes = {str(name): axis for name, axis in (view.get("axes") or {}).items()}
    predicted = {str(name): axis for name, axis in (prediction.get("axes") or {}).items()}
    tasks = [
        (index, name, axis, predicted.get(name) or {}, _of_axis(name, view))
        for index, (name, axis) in enumerate(axes.items(), 1)
    ]
    blocks = each(_run_block, tasks)
    return render_page(
        "run.html",
        {
            **_common(view, [("", view.get("evaluation"))]),
            "doubts": sections.doubts(prediction.get("doubts")),
            "done": _what_was_done(view, axes),
            "verdict": _run_verdict(view, axes, predicted),
            "axes": blocks,
            "findings": _remaining(view, blocks, view.get("evaluation")),
            "circles": circle_blocks(prediction.get("circles") or {}, view.get("evaluation")),
            "cross": [_cross(entry) for entry in prediction.get("cross") or []],
            "changes": changes_content(view.get("changes")),
            "assumed": sections.assumed(view.get("assumed")),
            "files": [str(file) for file in view.get("files") or []],
            "card": next(
                (
                    str(file)
                    for file in view.get("files") or []
                    if "card" in str(file) and str(file).endswith(".html")
                ),
                None,
            ),
        },
    )


def load_plotting() -> None:
    """Load what draws figures. Raises UsageError when the report extra is missing."""
    need("matplotlib.figure")


def verify_report(view: Document) -> bytes:
    """Return the report of ``verify``: the verdict first, then each axis before, predicted and
    after loading, side by side.

    Raises UsageError when the report extra is missing.
    """
    verification = view.get("verification") or {}
    axes = {str(name): axis for name, axis in (verification.get("axes") or {}).items()}
    tones = {
        "good": ("good", "Good: the tables act and the limits are met"),
        "bad": ("bad", "Bad: see the axes below"),
    }
    tone, text = tones.get(
        str(verification.get("verdict")), ("open", "Undecided: the tests do not tell")
    )
    rows = [
        row
        for index, (name, axis) in enumerate(axes.items(), 1)
        for row in _verify_rows(index, name, axis, _verify_unit(name, view))
    ]
    blocks = [
        _verify_axis(index, name, axis, view) for index, (name, axis) in enumerate(axes.items(), 1)
    ]
    evaluations = (view.get("evaluation_before"), view.get("evaluation_after"))
    return render_page(
        "verify.html",
        {
            **_common(view, list(zip(("before", "after"), evaluations, strict=True))),
            "doubts": sections.doubts(verification.get("doubts")),
            "verdict": {"tone": tone, "text": text, "rows": rows},
            "axes": blocks,
            "circles": circle_blocks(verification.get("circles") or {}, *evaluations),
            "findings": _remaining(view, blocks, *evaluations),
        },
    )


def _common(view: Document, evaluations: Sequence[tuple[str, Document | None]]) -> dict[str, Any]:
    title = plain(view.get("title") or "compwright")
    results = [
        (label, result)
        for label, evaluation in evaluations
        for result in (evaluation or {}).get("results", [])
    ]
    return {
        "page_title": title,
        "title": title,
        "machine": sections.pairs(view.get("machine")),
        "format": {
            "id": plain((view.get("format") or {}).get("id", "")),
            "title": plain((view.get("format") or {}).get("title", "")),
        },
        "tests": [
            sections.result_block(result, label)
            for label, result in results
            if result.get("kind", "positioning") == "positioning"
        ],
        "sources": sections.sources(*(evaluation for _, evaluation in evaluations)),
        "version": plain(view.get("version", "")),
    }


def _remaining(
    view: Document, blocks: Iterable[Document], *evaluations: Document | None
) -> list[dict[str, Any]]:
    """The findings that stand in no axis' section, and the files that could not be read."""
    shown = {(item["code"], item["message"]) for block in blocks for item in block["findings"]}
    every = sections.findings(sections.unreadable(*evaluations), view.get("findings"))
    return [item for item in every if (item["code"], item["message"]) not in shown]


# --- run
# --------------------------------------------------------------------------------------------------


def _what_was_done(view: Document, axes: Document) -> str:
    results = (view.get("evaluation") or {}).get("results", [])
    standards = sorted({standard_text(result.get("standard", "")) for result in results})
    names = _list_of(axes)
    control = plain((view.get("format") or {}).get("title", "the control"))
    tests, verb = ("1 test", "was") if len(results) == 1 else (f"{len(results)} tests", "were")
    axis = "axis" if len(axes) == 1 else "axes"
    start = (
        f"{tests} of {axis} {names} {verb} evaluated to {' and '.join(standards) or 'no standard'}."
    )
    if view.get("no_tables"):
        return (
            f"{start} The error was estimated over the travel. No table was written: predicted is"
            " the next test without one."
        )
    return (
        f"{start} The error was estimated over the travel; the best table that {control} can hold"
        " was fitted, written in the control's own form, and read back from the files to predict"
        " the next test. Nothing has been loaded yet: load the table with the commissioning card,"
        " measure again, and run compwright verify."
    )


def _list_of(names: Iterable[object]) -> str:
    words = [str(name) for name in names]
    return " and ".join(filter(None, [", ".join(words[:-1]), *words[-1:]])) or "none"


def _run_verdict(view: Document, axes: Document, predicted: Document) -> dict[str, Any]:
    rows = [
        row
        for index, name in enumerate(axes, 1)
        for row in _run_rows(index, name, axes[name], predicted.get(name) or {}, view)
    ]
    decisions = [
        entry.get("decision")
        for name in axes
        for entry in ((predicted.get(name) or {}).get("accept") or {}).values()
    ]
    refused = {name: plain(axis["refused"]) for name, axis in axes.items() if axis.get("refused")}
    why = " ".join(f"Axis {name}: {reason.rstrip('.')}." for name, reason in refused.items())
    if view.get("no_tables"):
        tone, text, why = "bad", "No table was written", plain(view["no_tables"])
    elif refused:
        tone, text = "bad", f"No table was written for axis {_list_of(refused)}"
    elif "reject" in decisions:
        tone, text = "bad", "At least one limit is predicted to be missed"
    elif "undecided" in decisions:
        tone, text = "open", "At least one limit may or may not be met"
    elif any(
        doubt["code"] == "CW-P131" for doubt in (view.get("prediction") or {}).get("doubts") or ()
    ):
        tone, text = "open", "Undecided: a circle is predicted to get worse"
    elif decisions and (view.get("prediction") or {}).get("doubts"):
        tone, text = (
            "open",
            "All limits are predicted to be met, if what is to be settled first turns out well",
        )
    elif decisions:
        tone, text = "good", "All limits are predicted to be met"
    else:
        tone, text = "open", "Predicted result; no limits were given to decide against"
    return {"tone": tone, "text": text, "why": why, "rows": rows, "rule": _rule(predicted)}


def _rule(predicted: Document) -> str:
    """Return by which rule the limits were decided, with the guard bands of every axis."""
    limits = {name: axis.get("accept") or {} for name, axis in predicted.items()}
    guarded = [
        line
        for name, accept in limits.items()
        for line in sections.rule_lines(accept, unit_text(predicted[name].get("unit", "um")))
    ]
    return " ".join(guarded) or f"{SIMPLE}."


def _run_rows(
    index: int, name: str, axis: Document, predicted: Document, view: Document
) -> list[dict[str, Any]]:
    limits = predicted.get("accept") or {}
    before, quantiles = _decided_test(name, predicted, view)
    unit = unit_text(axis.get("unit"))
    return [
        {
            "axis": name,
            "anchor": _anchor(index),
            "symbol": symbol(key),
            "before": _with_unit(before.get(key), unit),
            "median": _with_unit((quantiles.get(key) or {}).get("median"), unit),
            "spread": sections.spread_text(quantiles.get(key)),
            "limit": _with_unit((limits.get(key) or {}).get("limit"), unit),
            "mark": sections.decision_mark((limits.get(key) or {}).get("decision")),
            "bar": sections.bar(
                before.get(key), quantiles.get(key), (limits.get(key) or {}).get("limit")
            ),
        }
        for key in sections.main_parameters({**quantiles, **before}, limits)
    ]


def _decided_test(name: str, predicted: Document, view: Document) -> tuple[Document, Document]:
    """Before and predicted of the test that the limits are about (their key ``test``), else of the
    first one.
    """
    about = next(
        (limit["test"] for limit in (predicted.get("accept") or {}).values() if limit.get("test")),
        None,
    )
    test = next(
        (
            test
            for test in predicted.get("tests") or []
            if about is not None and test.get("name") == about
        ),
        predicted,
    )
    result = sections.result_of(view.get("evaluation"), name, about) or {}
    return test.get("before") or result.get("parameters") or {}, test.get("predicted") or {}


def _of_axis(name: str, view: Document) -> Document:
    """Return what the part of one axis needs of the view: the results of its own tests."""
    results = (view.get("evaluation") or {}).get("results", [])
    return {"evaluation": {"results": [one for one in results if str(one.get("axis")) == name]}}


def _run_block(task: tuple[int, str, Document, Document, Document]) -> dict[str, Any]:
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
    table = predicted.get("table")
    prefix = f"x{index}"
    return {
        "name": name,
        "anchor": _anchor(index),
        "facts": _axis_facts(axis, predicted),
        "figure": _before_figure(prefix, name, result, axis, predicted),
        "caption": (
            "Before and, on the same scale, what a test at the same targets is expected to show."
            if axis.get("predicted_targets") and result
            else ""
        ),
        "parameters": (
            _run_parameters(tests[0], result, unit) if result or tests[0].get("before") else None
        ),
        "findings": sections.findings(
            axis.get("findings"), predicted.get("findings"), (result or {}).get("findings")
        ),
        "mode": _mode(axis),
        "table": _table(prefix, name, table, axis, predicted) if table else None,
        "refused": plain(axis.get("refused") or ""),
        "limits": limits_block(predicted, unit),
        "worth": worth_block(predicted, unit),
        "periods": periods_block(predicted, unit),
        "state": _state(axis.get("state")),
        "estimate": (
            _figure(
                f"{prefix}e",
                f"estimated error of axis {name}",
                estimate_plot(axis["estimate"], result),
            )
            if axis.get("estimate") and result
            else None
        ),
        "certificate": _certificate(axis.get("certificate")),
        "others": [
            _other_test(f"{prefix}t{count}", test, name, unit, view)
            for count, test in enumerate(tests[1:], 1)
        ],
    }


def _axis_facts(axis: Document, predicted: Document) -> list[tuple[str, str]]:
    unit = axis.get("unit", "um")
    facts = {
        "control address": axis.get("address"),
        "kind": axis.get("kind"),
        "unit of deviations": unit_text(unit),
    }
    quantum = predicted.get("quantum")
    if quantum is not None:
        facts["resolution of the table"] = f"{plain(quantum)} {unit_text(unit)}"
    return sections.pairs(facts)


def _before_figure(
    prefix: str, name: str, result: Document | None, axis: Document, predicted: Document
) -> Any:
    if result is None:
        return None
    expected = axis.get("predicted_targets")
    if not expected:
        return _figure(f"{prefix}b", f"deviations of axis {name}", positioning_plot(result))
    with_numbers = {**expected, "parameters": predicted.get("predicted")}
    return _figure(
        f"{prefix}b",
        f"deviations of axis {name} before and predicted",
        before_after_plot(result, with_numbers),
    )


def _run_parameters(test: Document, result: Document | None, unit: object) -> dict[str, Any]:
    result = result or {}
    columns: list[dict[str, Any]] = [
        {
            "title": "Before",
            "values": test.get("before") or result.get("parameters"),
            "uncertainty": result.get("uncertainty"),
        },
        {"title": "Predicted, same targets", "quantiles": test.get("predicted")},
    ]
    if test.get("predicted_new_targets"):
        columns.append(
            {"title": "Predicted, new targets", "quantiles": test["predicted_new_targets"]}
        )
    return sections.parameter_block(
        unit, result.get("standard", ""), result.get("not_applicable"), columns
    )


def _other_test(
    prefix: str, test: Document, axis: str, unit: object, view: Document
) -> dict[str, Any]:
    result = sections.result_of(view.get("evaluation"), axis, test.get("name"))
    return {
        "name": plain(test.get("name")),
        "figure": (
            _figure(prefix, f"deviations of axis {axis}", positioning_plot(result))
            if result
            else None
        ),
        "parameters": _run_parameters(test, result, unit),
    }


def _table(
    prefix: str, name: str, table: Document, axis: Document, predicted: Document
) -> dict[str, Any]:
    unit = table.get("unit", axis.get("unit", "um"))
    positions, positive, negative = (
        list(table[key]) for key in ("positions", "correction_positive", "correction_negative")
    )
    digits, places = decimals_of([*positive, *negative]), decimals_of(positions)
    title = [
        ("Position", position_unit(unit)),
        ("Correction +", unit_text(unit)),
        ("Correction −", unit_text(unit)),
    ]
    rows = [
        [number(where, places), number(up, digits), number(down, digits)]
        for where, up, down in zip(positions, positive, negative, strict=True)
    ]
    height = max(_CHUNK, -(-len(rows) // 3))
    caption = f"{len(rows)} nodes, as read back from the files."
    if axis.get("wanted"):
        caption += " Broad line: what was wanted before rounding and limits."
    return {
        "figure": _figure(
            f"{prefix}c",
            f"correction of axis {name}",
            table_plot({"table": table, "wanted": axis.get("wanted"), "unit": unit}),
        ),
        "caption": caption,
        "count": len(rows),
        "chunks": [
            {"heads": sections.heads(*title), "rows": rows[start : start + height]}
            for start in range(0, len(rows), height)
        ],
        "quantum": plain(predicted.get("quantum")),
    }


def _mode(axis: Document) -> str:
    words = {
        "single": "one curve and one reversal value",
        "bidirectional": "one curve for each direction of approach",
    }
    text = plain(axis.get("mode_reason") or words.get(str(axis.get("mode")), ""))
    return text[:1].upper() + text[1:]


def _state(state: object) -> str:
    if state is None:
        return (
            "Not said. Without it no table is written: the new table would not know what acts"
            " already."
        )
    if isinstance(state, str):
        return (
            "None: nothing was active in the control when the axis was measured."
            if state == "none"
            else state
        )
    files = [str(file) for file in state] if isinstance(state, Iterable) else []
    return (
        f"As in {', '.join(files)}; the table is the total of what was there and what is to be"
        " added."
    )


def _certificate(values: Document | None) -> TextTable | None:
    if not values:
        return None
    rows = [
        [
            str(name).replace("_", " "),
            f"{value:.3g}".replace("-", "−") if isinstance(value, float) else plain(value),
        ]
        for name, value in values.items()
    ]
    return {"heads": sections.heads("Residual", ("Value", "")), "rows": rows}


def _cross(entry: Document) -> TextTable:
    unit = entry.get("unit", "um")
    rows = [
        [plain(where), number(value)]
        for where, value in zip(entry["positions"], entry["correction"], strict=True)
    ]
    heads = sections.heads(("Position", position_unit(unit)), ("Correction", unit_text(unit)))
    return {
        "title": f"{plain(entry.get('input'))} bends {plain(entry.get('output'))}",
        "heads": heads,
        "rows": rows,
    }


# --- verify
# --------------------------------------------------------------------------------------------------


def _verify_unit(name: str, view: Document) -> str:
    extra = (view.get("axes") or {}).get(name) or {}
    result = (
        sections.result_of(view.get("evaluation_after"), name)
        or sections.result_of(view.get("evaluation_before"), name)
        or {}
    )
    return str(extra.get("unit") or result.get("unit", "um"))


def _verify_rows(index: int, name: str, axis: Document, unit: str) -> list[dict[str, Any]]:
    before, after, quantiles = (
        axis.get("before") or {},
        axis.get("after") or {},
        axis.get("predicted") or {},
    )
    limits = axis.get("accept") or {}
    return [
        {
            "axis": name,
            "anchor": _anchor(index),
            "loading": sections.loading_mark(
                (axis.get("loading") or {}).get("verdict", "undecided")
            ),
            "symbol": symbol(key),
            "before": number(before.get(key)),
            "unit": unit_text(unit),
            "median": sections.median_text(quantiles.get(key)),
            "spread": sections.spread_text(quantiles.get(key)),
            "after": number(after.get(key)),
            "limit": number((limits.get(key) or {}).get("limit")),
            "mark": sections.decision_mark((limits.get(key) or {}).get("decision")),
            "bar": sections.bar(
                before.get(key),
                quantiles.get(key),
                (limits.get(key) or {}).get("limit"),
                after.get(key),
            ),
        }
        for key in sections.main_parameters({**before, **after}, limits)
    ]


def _verify_axis(index: int, name: str, axis: Document, view: Document) -> dict[str, Any]:
    extra = (view.get("axes") or {}).get(name) or {}
    before = sections.result_of(view.get("evaluation_before"), name)
    after = sections.result_of(view.get("evaluation_after"), name)
    unit = _verify_unit(name, view)
    measured = after or before or {}
    columns = [
        {
            "title": "Before",
            "values": axis.get("before"),
            "uncertainty": (before or {}).get("uncertainty"),
        },
        {"title": "Predicted", "quantiles": axis.get("predicted")},
        {
            "title": "After",
            "values": axis.get("after"),
            "uncertainty": (after or {}).get("uncertainty"),
        },
    ]
    within = {True: "within", False: "outside"}
    notes = {
        key: within.get(value, "") for key, value in (axis.get("within_prediction") or {}).items()
    }
    if any(notes.values()):
        columns.append({"title": "5–95 %", "notes": notes})
    return {
        "name": name,
        "anchor": _anchor(index),
        "loading": _loading(axis.get("loading") or {}),
        "figure": _after_figure(index, name, before, after, extra, axis),
        "parameters": sections.parameter_block(
            unit, measured.get("standard", ""), measured.get("not_applicable"), columns
        ),
        "accept": _acceptance(axis.get("accept") or {}, unit),
        "findings": sections.findings(
            extra.get("findings"), axis.get("findings"), (after or {}).get("findings")
        ),
    }


def _after_figure(
    index: int,
    name: str,
    before: Document | None,
    after: Document | None,
    extra: Document,
    axis: Document,
) -> Any:
    if before is None:
        return (
            _figure(
                f"x{index}a", f"deviations of axis {name} after loading", positioning_plot(after)
            )
            if after
            else None
        )
    expected = extra.get("predicted_targets")
    with_numbers = {**expected, "parameters": axis.get("predicted")} if expected else None
    return _figure(
        f"x{index}a",
        f"axis {name} before, predicted and after",
        before_after_plot(before, with_numbers, after),
    )


def _loading(loading: Document) -> dict[str, Any]:
    verdict = loading.get("verdict", "undecided")
    facts: dict[str, Any] = {}
    if loading.get("equivalent"):
        facts["cannot be told from"] = ", ".join(
            str(name).replace("_", " ") for name in loading["equivalent"]
        )
    if verdict == "scaled":
        facts["factor"] = loading.get("factor")
    if verdict == "shifted":
        facts["shift in nodes"] = loading.get("shift_nodes")
    if verdict == "wrong_axis":
        facts["table of axis"] = loading.get("of")
    return {
        "mark": sections.loading_mark(verdict),
        "message": plain(loading.get("message") or ""),
        "look_at": [plain(sentence) for sentence in loading.get("look_at") or ()],
        "facts": sections.pairs(facts),
    }


def _acceptance(limits: Document, unit: object) -> TextTable | None:
    if all(entry.get("U") is None for entry in limits.values()):
        return None  # the verdict above says it all
    word = unit_text(unit)
    rows = [
        [
            symbol(key),
            *(number(entry.get(part)) for part in ("value", "U", "limit")),
            sections.decision_mark(entry.get("decision"))["text"],
        ]
        for key, entry in limits.items()
    ]
    return {
        "heads": sections.heads(
            "Limit on", ("After", word), ("U", word), ("Limit", word), "Decision"
        ),
        "rows": rows,
    }


# --- small things
# --------------------------------------------------------------------------------------------------


def _anchor(index: int) -> str:
    return f"axis-{index}"


def _with_unit(value: object, unit: str) -> str:
    text = number(value)
    return f"{text} {unit}" if value is not None else text


def _figure(prefix: str, description: str, svg: bytes) -> Any:
    return inline_figure(svg, prefix=prefix, description=description)
