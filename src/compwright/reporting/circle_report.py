"""The page of one circular test in a report: picture, parameters, causes and conditions. Computes
nothing.
"""

from __future__ import annotations

from typing import Any

from compwright.reporting import paper, sections
from compwright.reporting.causes import ranked_causes
from compwright.reporting.circles import circle_figure
from compwright.reporting.numbers import number, plain
from compwright.reporting.sections import Document


def circle_page(result: Document, index: int) -> dict[str, Any]:
    """Return the page of a circular result, the ``index``-th test of its report."""
    name = plain(result.get("name") or "")
    return {
        "figure": circle_figure(result, f"test{index}", name),
        "parameters": {
            "heads": sections.heads("Parameter", ("Value", "µm")),
            "rows": [
                [key.replace("_", " "), number(value)]
                for key, value in (result.get("parameters") or {}).items()
                if value is not None
            ],
        },
        "causes": {
            "heads": sections.heads(
                "Cause", ("Value ± standard error", ""), "Unit", ("Effect on the radius", "µm")
            ),
            "rows": [
                [cause.words, cause.value_text, cause.unit_text, number(cause.effect)]
                for cause in ranked_causes(result)
            ],
        },
        "reasons": [
            (plain(key).replace("_", " "), plain(reason))
            for key, reason in (result.get("not_applicable") or {}).items()
        ],
        "sheet": paper.sheet(result, {}),
    }
