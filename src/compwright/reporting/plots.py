"""Write figures of positioning tests (ISO 230-2:1997, figure 2) and circular tests to a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from compwright.foundations.errors import Fault, UsageError
from compwright.reporting.charts import Document, parameter_line, result_chart, title_of
from compwright.reporting.circle_figures import TEST_HEIGHT, draw_test
from compwright.reporting.panels import draw_chart, known_format, legend, new_figure, render, style

_ROW_HEIGHT = 2.9  # inches, of one positioning result


# the plotting library's own word
def evaluation_plot(document: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return one figure with a chart per positioning test, and the circular tests below.

    A circular result with its samples is drawn by `circle_figures.polar_figure`. Raises UsageError
    if there is nothing to draw, for an unknown format, and if the extra ``report`` is not
    installed.
    """
    kind = known_format(format)
    results = document.get("results", [])
    straight = [result for result in results if result.get("kind", "positioning") == "positioning"]
    round_ = [
        result for result in results if result.get("kind") == "circular" and result.get("runs")
    ]
    if not straight and not round_:
        raise UsageError(
            Fault(
                message="there is no test to plot",
                expected="a test that could be evaluated",
                hint="correct the faults of the tests first, or leave `--plot` out",
            )
        )
    heights = [_ROW_HEIGHT * len(straight) + 0.35] * bool(straight) + [TEST_HEIGHT] * len(round_)
    with style():
        figure = new_figure(sum(heights))
        parts = (
            list(figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0])
            if round_
            else [figure]
        )
        if straight:
            _draw_positioning(parts[0], straight)
        for part, result in zip(parts[len(parts) - len(round_) :], round_, strict=True):
            draw_test(part, result)
        return render(figure, kind)


def _draw_positioning(figure: Any, results: Sequence[Document]) -> None:
    panels = figure.subplots(len(results), 1, squeeze=False)[:, 0]
    charts = [result_chart(result) for result in results]
    for panel, chart, result in zip(panels, charts, results, strict=True):
        chart.title, chart.right = title_of(result), parameter_line(result)
        draw_chart(panel, chart)
    figure.align_ylabels(list(panels))
    legend(figure, charts, panels)
