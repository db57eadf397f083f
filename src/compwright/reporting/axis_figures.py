"""Figures in reports: a test and its residuals, tests before and after loading, the table, and the
estimated error.

Each function takes plain documents (deviations in µm or arcsec, positions in mm or deg) and returns
a drawing for a page in its language. The same input always gives the same drawing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from compwright.reporting.chart_svg import Drawing
from compwright.reporting.charts import (
    Chart,
    Document,
    estimate_chart,
    expected_chart,
    parameter_line,
    prediction_line,
    residual_charts,
    result_chart,
    reversal_chart,
    table_chart,
    title_of,
)
from compwright.words.sentences import say

_HEIGHT: Final = 176.0  # points
_LOW: Final = 104.0
_SIDE_BY_SIDE: Final = 234.0


def result_figure(result: Document, axis: str) -> Drawing:
    """Return the figure of one positioning test: readings, means and mean ± k s over the
    targets.
    """
    chart = result_chart(result)
    chart.title, chart.right = title_of(result), parameter_line(result)
    return _drawing([chart], _HEIGHT, "marked" if chart.marks else "deviations", axis)


def reversal_figure(result: Document, axis: str) -> Drawing:
    """Return the figure of the reversal B_i over the targets."""
    return _drawing([reversal_chart(result)], _LOW, "reversal", axis)


def residual_figure(result: Document, name: str) -> Drawing | None:
    """Return the figure of a circular test's residuals in each run, or None if no model of causes
    was fitted.
    """
    charts = residual_charts(result)
    return _drawing(charts, _LOW, "residual", name) if charts else None


def before_after_figure(
    before: Document, predicted: Document | None, axis: str, after: Document | None = None
) -> Drawing:
    """Return the figures of the test before, predicted and after, side by side on one scale.

    ``before``, ``after``: positioning results. ``predicted``: the expected test after loading, in
    the unit of ``before``, with ``positions`` (m), the expected deviations ``positive`` and
    ``negative`` (m) or None, and ``s``, the standard deviation of one reading. It may also have
    ``parameters`` as in the prediction document (median, p05, p95). ``predicted`` or ``after`` may
    be None; its figure is then left out.
    """
    charts = [result_chart(before)]
    most = 2 if predicted is not None and after is not None else 4  # what fits above a panel
    charts[0].title, charts[0].note = say("head.before"), parameter_line(before, most)
    if predicted is not None:
        chart = expected_chart(predicted, float(before.get("coverage") or 2.0))
        chart.name_axes(before.get("unit"))
        chart.title = say("head.predicted")
        chart.note = prediction_line(predicted.get("parameters") or {}, before, most // 2)
        charts.append(chart)
    if after is not None:
        chart = result_chart(after)
        chart.title, chart.note = say("head.after"), parameter_line(after, most)
        charts.append(chart)
    return _drawing(charts, _SIDE_BY_SIDE, "comparison", axis)


def table_figure(entry: Document, axis: str) -> Drawing:
    """Return the figure of a table's correction over position, with the wanted correction."""
    return _drawing([table_chart(entry)], _HEIGHT, "correction", axis)


def estimate_figure(estimate: Document, result: Document, axis: str) -> Drawing:
    """Return the figure of the estimated deviation and the measured means."""
    return _drawing([estimate_chart(estimate, result)], _HEIGHT, "estimate", axis)


def _drawing(charts: Sequence[Chart], height: float, what: str, name: str) -> Drawing:
    return Drawing(tuple(charts), height, say("chart.described", what=what, name=name))
