"""Circular tests in the reports of ``run`` and ``verify``: figure and values before and after."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

from compwright.reporting import paper, sections
from compwright.reporting.causes import findings_in_words, ranked_causes
from compwright.reporting.circle_figures import polar_figure
from compwright.reporting.circular_parameters import parameter_words, squareness_limit
from compwright.reporting.numbers import MISSING, decimals_of_unit, number, plain
from compwright.reporting.page import inline_figure
from compwright.reporting.sections import Document
from compwright.words.sentences import Language, Sentence, say

_PARAMETERS: Final = (
    "G_ccw",
    "G_cw",
    "G_bidirectional",
    "H",
    "D",
    "F_max_ccw",
    "F_min_ccw",
    "F_max_cw",
    "F_min_cw",
)
#: Causes of which a plain table names the largest.
_MOST_CAUSES: Final = 8


def circle_blocks(
    circles: Mapping[str, Document],
    before: Document | None,
    after: Document | None = None,
    *,
    stated: Mapping[str, Mapping[str, str | Sentence]] | None = None,
) -> list[dict[str, Any]]:
    """Return a report section for each predicted or verified circular test. ``before``, ``after``:
    the evaluations before and after loading; ``stated``: what the job states about each test, by
    its name.

    The picture and the conditions are those of the test after loading if there is one, else of the
    test before.
    """
    results = {"before": _by_name(before), "after": _by_name(after)}
    blocks = []
    for index, (name, circle) in enumerate(circles.items(), 1):
        result = results["before"].get(name)
        shown = results["after"].get(name, result)
        blocks.append(
            {
                "name": plain(name),
                "anchor": f"circle-{index}",
                "figure": (None if shown is None else CircleFigure(shown, f"circle{index}", name)),
                "table": _table(circle, result),
                "sheet": (
                    None if shown is None else paper.sheet(shown, (stated or {}).get(name) or {})
                ),
                "rule": rules(circle),
                "findings": sections.findings(findings_in_words({**(result or {}), **circle})),
            }
        )
    return blocks


@dataclass(frozen=True, slots=True)
class CircleFigure:
    """The figure of a circular test in an HTML page. Its element ids begin with ``prefix``, so that
    they are unique in the page.
    """

    result: Document
    prefix: str
    name: str

    def svg(self, language: Language) -> str:
        """Return the SVG picture, with its texts in the language."""
        described = say("chart.described", what="circle", name=self.name).text(language)
        drawn = polar_figure(self.result, language=language)
        return str(inline_figure(drawn, prefix=self.prefix, description=described))


def limit_rows(circles: Mapping[str, Document]) -> list[dict[str, Any]]:
    """Return a table row for each limit of each predicted or verified circular test, and one for
    each squareness and scale that was corrected and measured again.
    """
    return [
        _limit_row(index, name, circle, key, limit)
        for index, (name, circle) in enumerate(circles.items(), 1)
        for key, limit in {
            **(circle.get("accept") or {}),
            **squareness_limit(circle),
            **_scales(circle),
        }.items()
    ]


def _scales(circle: Document) -> dict[str, Document]:
    """Return the check of each scale correction of a verified circle in the form of a limit, by the
    name of the cause; a scale has no limit and no decision.
    """
    scales, axes = circle.get("scales") or {}, circle.get("axes") or ()
    causes = zip(("scale_error_first", "scale_error_second"), axes, strict=False)
    return {
        key: {**scales[axis], "axis": axis, "limit": MISSING, "decision": None}
        for key, axis in causes
        if axis in scales
    }


def _limit_row(
    index: int, name: str, circle: Document, key: str, limit: Document
) -> dict[str, Any]:
    before, band = circle["before"].get(key), circle["predicted"].get(key)
    after = (circle.get("after") or {}).get(key)
    if "verdict" in limit:
        decimals = decimals_of_unit("µm/m")
        return {
            "axis": say("report.circle", plane=plain(name), name=""),
            "anchor": f"circle-{index}",
            "loading": sections.loading_mark(limit["verdict"]),
            "symbol": say(
                "cause.kind",
                kind="scale_error" if "axis" in limit else key,
                first="",
                second="",
                axis=limit.get("axis", ""),
            ),
            "before": number(before, decimals),
            "unit": "µm/m",
            "median": number((band or {}).get("median"), decimals),
            "spread": sections.spread_text(band, decimals),
            "after": number(after, decimals),
            "limit": limit["limit"],
            "mark": sections.decision_mark(limit["decision"]),
            "bar": None,
        }
    # The table of a verification has a column for the unit.
    unit = "" if "after" in circle else "µm"
    return {
        "axis": say("report.circle", plane=plain(name), name=""),
        "anchor": f"circle-{index}",
        "loading": {"tone": "none", "text": say("label.circular_test")},
        "symbol": parameter_words(key),
        "before": _with_unit(number(before), unit),
        "unit": "µm",
        "median": _with_unit(sections.median_text(band), unit),
        "spread": sections.spread_text(band),
        "after": number(after),
        "limit": _with_unit(number(limit["limit"]), unit),
        "mark": sections.decision_mark(limit["decision"]),
        "bar": sections.bar(before, band, limit["limit"], after),
    }


def _with_unit(text: str, unit: str) -> str | Sentence:
    return say("label.with_unit", value=text, unit=unit) if unit else text


def rules(circle: Document) -> list[Sentence]:
    """Return the sentence on the decision rule for the limits of a circular test; an empty list if
    it has no limits.
    """
    return sections.rule_lines(circle.get("accept") or {}, "µm", after="after" in circle)


def _by_name(evaluation: Document | None) -> dict[str, Document]:
    results = (evaluation or {}).get("results", [])
    return {
        str(result.get("name")): result for result in results if result.get("kind") == "circular"
    }


def _table(circle: Document, result: Document | None) -> dict[str, Any]:
    before, predicted, after = (
        circle.get("before") or {},
        circle.get("predicted") or {},
        circle.get("after"),
    )
    accept = circle.get("accept") or {}
    limits, stated = {**accept, **squareness_limit(circle)}, (result or {}).get("uncertainty") or {}
    causes = [] if result is None else ranked_causes(result)[:_MOST_CAUSES]
    names = [
        (name, parameter_words(name), "µm")
        for name in dict.fromkeys((*_PARAMETERS, *accept))
        if before.get(name) is not None
    ]
    names += [(cause.name, cause.short_words, cause.unit_text) for cause in causes]
    rows = []
    for name, words, unit in names:
        band, decimals = predicted.get(name) or {}, decimals_of_unit(unit)
        spread = sections.spread_text(band, decimals)
        row: list[str | Sentence] = [words, unit, number(before.get(name), decimals)]
        row += [number(stated[name]["U"], decimals) if name in stated else ""] if stated else []
        row += [number(band.get("median"), decimals), spread]
        row += [] if after is None else [number(after.get(name), decimals)]
        rows.append([*row, *_decision(limits.get(name))] if limits else row)
    heads = [
        *sections.heads(say("head.quantity"), say("head.unit"), (say("head.before"), "")),
        *(sections.heads(("U", "k = 2")) if stated else []),
        *sections.heads(
            (say("head.predicted"), say("label.median")), (say("head.predicted"), "5–95 %")
        ),
    ]
    heads = heads if after is None else [*heads, *sections.heads((say("head.after"), ""))]
    heads += sections.heads((say("head.limit"), ""), say("head.decision")) if limits else []
    return {"title": "", "heads": heads, "rows": rows}


def _decision(limit: Document | None) -> list[str | Sentence]:
    if limit is None:
        return ["", ""]
    value = limit["limit"]
    return [
        value if isinstance(value, Sentence) else number(value),
        sections.decision_mark(limit["decision"])["text"],
    ]
