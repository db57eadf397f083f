"""Style and drawing of all figures with the plotting library matplotlib."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, Final, Literal, cast

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.extras import need
from compwright.foundations.one_thread import warnings_ignored
from compwright.reporting.charts import INK, LEGEND_TITLE, Chart, ChartCurve, covered, legend_of

PlotFormat = Literal["svg", "png", "pdf"]

_FORMATS: Final = ("svg", "png", "pdf")
_WIDTH: Final = 7.2  # inch: the text width of A4
_PNG_DPI: Final = 160
_PNG_LARGEST: Final = 60000  # pixels; the rasteriser ends at 65536
_STYLE: Final[dict[str, object]] = {
    "font.family": "DejaVu Sans",  # ships with matplotlib
    "font.size": 8.0,
    "text.parse_math": False,  # names of the user may hold a $
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.titley": 1.0,  # nothing stands above a panel: no need to look what the title must clear
    "axes.labelsize": 8.0,
    "axes.labelcolor": INK,
    "axes.edgecolor": "#555555",
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e3e3e3",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "axes.unicode_minus": True,
    "axes.formatter.useoffset": False,
    "xtick.color": "#555555",
    "ytick.color": "#555555",
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "legend.handlelength": 3.0,
    "legend.columnspacing": 1.8,
    "svg.fonttype": "path",  # letters as outlines: the same everywhere
    "svg.hashsalt": "compwright",
    "pdf.fonttype": 42,
    "text.color": INK,
}


# --- charts
# --------------------------------------------------------------------------------------------------


def draw_chart(panel: Any, chart: Chart) -> None:
    """Draw a chart into matplotlib axes, in English."""
    chart = chart.written("en")
    panel.axhline(0.0, color="#777777", linewidth=0.8, zorder=1.0)
    for band in chart.bands:
        panel.fill_between(
            band.x, band.low, band.high, facecolor=band.look.colour, alpha=0.13, linewidth=0.0,
            label=band.label or None,
        )  # fmt: skip
    for curve in chart.curves:
        _draw_curve(panel, curve)
    for mark in chart.marks:
        panel.plot([mark.x], [mark.y], "o", color=INK, fillstyle="none", markersize=6.0)
        panel.annotate(
            mark.text, (mark.x, mark.y), (4.0, 3.0), textcoords="offset points", fontweight="bold"
        )
    panel.set_title(chart.title, fontweight="bold")
    panel.set_title(chart.right, loc="right", fontsize=8.0)
    panel.set_xlabel(chart.x_label)
    panel.set_ylabel(chart.y_label)
    if chart.degrees:  # 30, 45 and 90 rather than 50 and 100
        panel.xaxis.set_major_locator(
            need("matplotlib.ticker").MaxNLocator(nbins=9, steps=[1, 1.5, 3, 4.5, 6, 9, 10])
        )
    across, up = covered([chart])
    panel.set_xlim(*across)
    panel.set_ylim(*up)


def draw_on_axes(panel: Any, chart: Chart) -> Any:
    """Draw a chart into the matplotlib axes ``panel``; None makes new axes. Returns the axes.

    Raises UsageError if the extra ``report`` is not installed.
    """
    axes = need("matplotlib.pyplot").subplots()[1] if panel is None else panel
    draw_chart(axes, chart)
    if legend_of([chart]):
        axes.legend(fontsize="small", frameon=False)
    return axes


def _draw_curve(panel: Any, curve: ChartCurve) -> None:
    dashes = () if curve.whole else curve.look.dashes
    panel.plot(
        curve.x, curve.y, color=curve.look.colour, alpha=curve.opacity,
        linestyle=((0, dashes) if dashes else "-") if curve.width else "none",
        linewidth=curve.width, marker=curve.marker or curve.look.marker,
        markersize=curve.size, markerfacecolor=curve.face or "none", markeredgewidth=curve.edge,
        label=curve.label or None,
    )  # fmt: skip


def legend(figure: Any, charts: Sequence[Chart], panels: Sequence[Any]) -> None:
    """Draw one legend for all charts below them."""
    names = list(legend_of([chart.written("en") for chart in charts]))
    handles: dict[str, Any] = {}
    for panel in panels:
        for handle, label in zip(*panel.get_legend_handles_labels(), strict=True):
            handles.setdefault(label, handle)
    if names:
        figure.legend(
            [handles[name] for name in names], names, loc="outside lower center",
            ncols=max(1, (len(names) + 1) // 2), title=str(LEGEND_TITLE), title_fontsize=7.5,
        )  # fmt: skip


# --- the plotting library
# --------------------------------------------------------------------------------------------------


def known_format(format_: str) -> PlotFormat:
    """Return the file format of a plot: svg, png or pdf. Raises UsageError for any other."""
    ending = format_.lower().removeprefix(".")
    if ending not in _FORMATS:
        raise UsageError(
            Fault(
                message="the name of the plot has an unknown ending",
                expected="a name that ends in .svg, .png or .pdf",
                found=repr(format_),
                hint="give `--plot` a name that ends in .svg, .png or .pdf",
            )
        )
    return cast("PlotFormat", ending)


@contextmanager
def style() -> Iterator[None]:
    """Provide a context with the style of all figures; only one thread at a time can be in it.
    Raises UsageError without matplotlib.
    """
    matplotlib = need("matplotlib")
    # a name in a script that the font lacks shows boxes
    with warnings_ignored("Glyph"), matplotlib.rc_context(_STYLE):
        yield


#: A number of a figure, such as one in the outline of a star, that is zero with a sign.
_MINUS_ZERO: Final = re.compile(r"(?<![\w.])-0(?:\.0+)?(?![\w.])")


def new_figure(height: float) -> Any:
    """Return an empty figure with the width of a page and ``height`` in inches."""
    figure_module = need("matplotlib.figure")
    return figure_module.Figure(figsize=(_WIDTH, height), layout="constrained")


def render(figure: Any, kind: PlotFormat) -> bytes:
    """Return the bytes of the figure without a date, so that the same input gives the same
    bytes.
    """
    metadata: dict[str, dict[str, str | None]] = {
        "svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
        "png": {"Software": None},
        "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    }
    height_in_inches = float(figure.get_figheight())
    if kind == "svg":  # savefig would draw everything twice
        canvas, text = (
            need("matplotlib.backends.backend_svg").FigureCanvasSVG(figure),
            io.StringIO(),
        )
        canvas.print_svg(text, metadata=metadata[kind])
        return _MINUS_ZERO.sub("0", text.getvalue()).encode()
    buffer = io.BytesIO()
    dpi = min(_PNG_DPI, _PNG_LARGEST / height_in_inches) if kind == "png" else 72.0
    figure.savefig(buffer, format=kind, dpi=dpi, metadata=metadata[kind])
    return buffer.getvalue()
