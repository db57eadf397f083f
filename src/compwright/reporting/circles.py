"""Circular tests in the reports of ``run`` and ``verify``: the picture, and a table of what was, is
expected, and was found.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from compwright.reporting import sections
from compwright.reporting.causes import ranked_causes
from compwright.reporting.numbers import number, plain
from compwright.reporting.page import inline_figure
from compwright.reporting.polar import polar_figure
from compwright.reporting.sections import Document

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
    circles: Mapping[str, Document], before: Document | None, after: Document | None = None
) -> list[dict[str, Any]]:
    """Return a block for each circle of a prediction or verification document.

    ``before`` and ``after``: the evaluation documents with their results; the picture is that of
    the last test.
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
                "figure": (None if shown is None else circle_figure(shown, f"circle{index}", name)),
                "table": _table(circle, result),
                "findings": sections.findings(
                    circle.get("findings") or (result or {}).get("findings")
                ),
            }
        )
    return blocks


def circle_figure(result: Document, prefix: str, name: str) -> Any:
    """Return the picture of a circular result as markup; ``prefix`` makes its ids its own."""
    return inline_figure(polar_figure(result), prefix=prefix, description=f"circular test {name}")


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
    causes = [] if result is None else ranked_causes(result)[:_MOST_CAUSES]
    names = [
        (name, name.replace("_", " "), "µm") for name in _PARAMETERS if before.get(name) is not None
    ]
    names += [(cause.name, cause.words, cause.unit_text) for cause in causes]
    rows = []
    for name, words, unit in names:
        band = predicted.get(name) or {}
        spread = f"{number(band.get('p05'))} to {number(band.get('p95'))}" if band else ""
        row = [words, unit, number(before.get(name)), number(band.get("median")), spread]
        rows.append(row if after is None else [*row, number(after.get(name))])
    heads = sections.heads(
        "Quantity", "Unit", ("Before", ""), ("Predicted", "median"), ("Predicted", "5–95 %")
    )
    heads = heads if after is None else [*heads, *sections.heads(("After", ""))]
    return {"title": "", "heads": heads, "rows": rows}
