"""Figures of the documents: deviations over position as in ISO 230-2 figure 2, circles, before and
after, table, estimate.

Every function takes plain documents (deviations in µm or arcsec, positions in mm or deg) and
returns the bytes of one file. The approach directions differ by marker, line and lightness, so that
a print without colours can be read. The same input gives the same bytes.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from compwright.foundations.errors import Fault, UsageError
from compwright.reporting.panels import (
    LOOKS,
    Document,
    arrange,
    band,
    curve,
    draw_expected,
    draw_means,
    draw_result,
    head,
    known_format,
    label_axes,
    legend,
    new_figure,
    parameter_line,
    prediction_line,
    render,
    style,
    title_of,
    zero_line,
)
from compwright.reporting.polar import TEST_HEIGHT, draw_test

_ROW_HEIGHT = 2.9  # inches, of one positioning result
_MOST_MARKED = 150  # nodes of a table that markers can still tell apart


# the plotting library's own word
def positioning_plot(result: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return the figure of one positioning result: readings, means and mean ± k s of each direction
    over the targets.

    ``result`` is an entry of ``results`` of an evaluation document. Its ``deviations_positive`` /
    ``deviations_negative`` per target, where given, are drawn as points; ``coverage`` (default 2)
    is k. After ISO 230-2:1997 figure 2. Raises UsageError for an unknown format or when the report
    extra is missing.
    """
    return evaluation_plot({"results": [result]}, format=format)


def evaluation_plot(document: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return one figure with a panel for each positioning result, one below the other, and below
    them each circular result.

    A circular result with its samples is drawn as by `polar.polar_figure`. Raises UsageError when
    there is nothing to draw, for an unknown format, or when the report extra is missing.
    """
    kind = known_format(format)
    results = document.get("results", [])
    straight = [result for result in results if result.get("kind", "positioning") == "positioning"]
    round_ = [
        result for result in results if result.get("kind") == "circular" and result.get("runs")
    ]
    if not straight and not round_:
        raise UsageError(
            Fault(message="nothing to plot", expected="a test that could be evaluated")
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
    for panel, result in zip(panels, results, strict=True):
        draw_result(panel, result)
        panel.set_title(title_of(result), fontweight="bold")
        panel.set_title(parameter_line(result), loc="right", fontsize=8.0)
        label_axes(panel, result.get("unit"))
    figure.align_ylabels(list(panels))
    legend(figure, panels)


def before_after_plot(
    before: Document,
    predicted: Document | None,
    after: Document | None = None,
    *,
    format: str = "svg",  # noqa: A002
) -> bytes:
    """Return before, predicted and after side by side on one scale; ``predicted`` or ``after`` may
    be None.

    ``before`` and ``after`` are positioning results. ``predicted`` holds ``positions`` (m),
    ``positive``, ``negative`` (m) or None: the expected deviations after loading, ``s``: the
    standard deviation of one reading, and, where known, ``parameters`` as in the prediction
    document (median, p05, p95); unit as in ``before``. Raises UsageError as `positioning_plot`.
    """
    kind = known_format(format)
    with style():
        figure = new_figure(3.25, measured=False)
        panels = figure.subplots(
            1,
            1 + (predicted is not None) + (after is not None),
            sharex=True,
            sharey=True,
            squeeze=False,
        )[0]
        rest = iter(panels)
        first = next(rest)
        draw_result(first, before)
        most = 4 if len(panels) < 3 else 2  # of the parameters: what fits above a panel
        head(first, "Before", parameter_line(before, most))
        if predicted is not None:
            panel = next(rest)
            draw_expected(panel, predicted, float(before.get("coverage") or 2.0))
            head(
                panel,
                "Predicted",
                prediction_line(predicted.get("parameters") or {}, before, most // 2),
            )
        if after is not None:
            panel = next(rest)
            draw_result(panel, after)
            head(panel, "After", parameter_line(after, most))
        for index, panel in enumerate(panels):
            label_axes(panel, before.get("unit"), with_y=index == 0)
        arrange(figure, panels, head=0.43)
        legend(figure, panels, place="lower center")
        return render(figure, kind)


def table_plot(entry: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return the correction over position for both directions, nodes marked, beside the correction
    that was wanted.

    ``entry`` holds ``table`` (``positions``, ``correction_positive``, ``correction_negative``,
    ``unit``) as in the prediction document, and ``wanted`` (``positions``, ``positive``,
    ``negative``) or None in the same unit. Raises UsageError as `positioning_plot`.
    """
    kind = known_format(format)
    table = entry["table"]
    wanted = entry.get("wanted") or {}
    with style():
        figure = new_figure(2.9, measured=False)
        panel = figure.subplots()
        zero_line(panel)
        same = curve(table.get("correction_positive")) == curve(table.get("correction_negative"))
        for look in LOOKS:
            if len(curve(wanted.get(look.key))):
                panel.plot(
                    curve(wanted["positions"]), curve(wanted[look.key]), color=look.colour,
                    alpha=0.35, linewidth=2.6,
                    solid_capstyle="butt", label=f"wanted ({look.sign})",
                )  # fmt: skip
        shown = LOOKS[:1] if same else LOOKS
        for look in shown:
            positions = curve(table["positions"])
            size = (
                4.0 if len(positions) <= 60 else 2.0 if len(positions) <= _MOST_MARKED else 0.0
            )  # too dense: the line alone
            panel.plot(
                positions, curve(table[f"correction_{look.key}"]), color=look.colour,
                linestyle=look.line, linewidth=1.0,
                marker=look.marker, markersize=size,
                label="table (+ and −)" if same else f"table ({look.sign})",
            )  # fmt: skip
        panel.set_title("Correction that the control adds to the command", fontweight="bold")
        label_axes(panel, table.get("unit", entry.get("unit")), quantity="Correction")
        arrange(figure, [panel], head=0.25)
        legend(figure, [panel], place="lower center")
        return render(figure, kind)


def estimate_plot(estimate: Document, result: Document, *, format: str = "svg") -> bytes:  # noqa: A002
    """Return the estimated deviation with its ± 2 standard deviations, and the measured means as
    markers.

    ``estimate`` holds ``positions`` (g), ``mean_positive``, ``mean_negative``, ``std_positive``,
    ``std_negative`` (g) in the unit of the positioning result ``result``. Raises UsageError as
    `positioning_plot`.
    """
    kind = known_format(format)
    with style():
        figure = new_figure(2.9, measured=False)
        panel = figure.subplots()
        zero_line(panel)
        for look in LOOKS:
            means = curve(estimate.get(f"mean_{look.key}"))
            if not means:
                continue
            positions = curve(estimate["positions"])
            band(
                panel,
                positions,
                means,
                [2.0 * value for value in curve(estimate[f"std_{look.key}"])],
                look,
                edge=False,
            )
            panel.plot(
                positions,
                means,
                color=look.colour,
                linestyle=look.line,
                linewidth=1.2,
                label=f"estimate ({look.sign})",
            )
        draw_means(panel, result)
        panel.set_title("Estimated deviation with ± 2 standard deviations", fontweight="bold")
        label_axes(panel, result.get("unit"))
        arrange(figure, [panel], head=0.25)
        legend(figure, [panel], place="lower center")
        return render(figure, kind)
