"""Figures in the pages of tests: a test, its residual, before and after, the table, the estimate.
Each takes plain documents (deviations in µm or arcsec, positions in mm or deg) and returns an SVG
picture as text, the same for the same input; ``description`` is what a screen reader says.
"""

from __future__ import annotations

from typing import Final

from compwright.reporting.chart_svg import chart_svg
from compwright.reporting.charts import (
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

_HEIGHT: Final = 176.0  # points
_LOW: Final = 104.0
_BESIDE_EACH_OTHER: Final = 234.0


def result_figure(result: Document, description: str) -> str:
    """Return readings, means and mean ± k s of one positioning result over the targets."""
    chart = result_chart(result)
    chart.title, chart.right = title_of(result), parameter_line(result)
    return chart_svg([chart], _HEIGHT, description)


def reversal_figure(result: Document, description: str) -> str:
    """Return the reversal B_i over the targets."""
    return chart_svg([reversal_chart(result)], _LOW, description)


def residual_figure(result: Document, description: str) -> str | None:
    """Return what the causes of a circular result leave of its runs; None without a fit."""
    charts = residual_charts(result)
    return chart_svg(charts, _LOW, description) if charts else None


def before_after_figure(
    before: Document, predicted: Document | None, description: str, after: Document | None = None
) -> str:
    """Return before, predicted and after side by side on one scale; ``predicted`` or ``after`` may
    be None.

    ``before`` and ``after`` are positioning results. ``predicted`` holds ``positions`` (m),
    ``positive``, ``negative`` (m) or None: the expected deviations after loading, ``s``: the
    standard deviation of one reading, and, where known, ``parameters`` as in the prediction
    document (median, p05, p95); unit as in ``before``.
    """
    charts = [result_chart(before)]
    most = 2 if predicted is not None and after is not None else 4  # what fits above a panel
    charts[0].title, charts[0].note = "Before", parameter_line(before, most)
    if predicted is not None:
        chart = expected_chart(predicted, float(before.get("coverage") or 2.0))
        chart.name_axes(before.get("unit"))
        chart.title = "Predicted"
        chart.note = prediction_line(predicted.get("parameters") or {}, before, most // 2)
        charts.append(chart)
    if after is not None:
        chart = result_chart(after)
        chart.title, chart.note = "After", parameter_line(after, most)
        charts.append(chart)
    return chart_svg(charts, _BESIDE_EACH_OTHER, description)


def table_figure(entry: Document, description: str) -> str:
    """Return the correction over position beside the one that was wanted, as `table_chart`."""
    return chart_svg([table_chart(entry)], _HEIGHT, description)


def estimate_figure(estimate: Document, result: Document, description: str) -> str:
    """Return the estimated deviation and the measured means, as `estimate_chart`."""
    return chart_svg([estimate_chart(estimate, result)], _HEIGHT, description)
