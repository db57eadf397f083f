"""Parts of a figure: how a direction looks, curves with their bands, labels, legend, and the
plotting library itself.
"""

from __future__ import annotations

import io
import math
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final, Literal, cast

from compwright.foundations.errors import Fault, UsageError
from compwright.reporting.extra import need
from compwright.reporting.numbers import number, position_unit, standard_text, symbol, unit_text

PlotFormat = Literal["svg", "png", "pdf"]
Document = Mapping[str, Any]

_FORMATS: Final = ("svg", "png", "pdf")
_WIDTH: Final = 7.2  # inch: the text width of A4
# Inches round panels that `arrange` places: the label beside the numbers, one digit, the margin
# on the right, between panels, and below them position, legend and its title.
_BESIDE: Final = 0.36
_DIGIT: Final = 0.068
_EDGE: Final = 0.12
_GAP: Final = 0.24
_BELOW: Final = 0.97
_FINE: Final = 4.0  # a range of numbers below which they have decimals
_PNG_DPI: Final = 160
_PNG_LARGEST: Final = 60000  # pixels; the rasteriser ends at 65536
_INK: Final = "#222222"
_FAINT: Final = "#8a8a8a"
_STYLE: Final[dict[str, object]] = {
    "font.family": "DejaVu Sans",  # ships with matplotlib
    "font.size": 8.0,
    "text.parse_math": False,  # names of the user may hold a $
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.titley": 1.0,  # nothing stands above a panel: no need to look what the title must clear
    "axes.labelsize": 8.0,
    "axes.labelcolor": _INK,
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
    "xtick.labelcolor": _INK,
    "ytick.labelcolor": _INK,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "legend.handlelength": 3.0,
    "legend.columnspacing": 1.8,
    "svg.fonttype": "path",  # letters as outlines: the same everywhere
    "svg.hashsalt": "compwright",
    "pdf.fonttype": 42,
    "text.color": _INK,
}


@dataclass(frozen=True, slots=True)
class _Look:
    """How one approach direction is drawn."""

    key: str
    sign: str
    marker: str
    line: Any
    colour: str


LOOKS: Final = (
    _Look("positive", "+", "^", "-", "#0b4a82"),
    _Look("negative", "−", "v", (0, (4, 1.6)), "#c2590c"),
)


# --- parts of a panel
# --------------------------------------------------------------------------------------------------


def draw_result(panel: Any, result: Document) -> None:
    """Draw one positioning result: for each direction single readings, means and mean ± k s over
    the targets.
    """
    zero_line(panel)
    targets = result.get("targets", [])
    coverage = float(result.get("coverage") or 2.0)
    positions = [_number(target.get("position")) for target in targets]
    for look in LOOKS:
        means = [_number(target.get(f"mean_{look.key}")) for target in targets]
        if not any(math.isfinite(value) for value in means):
            continue
        spread = [coverage * _number(target.get(f"s_{look.key}")) for target in targets]
        band(panel, positions, means, spread, look, label=f"mean ± {coverage:g} s ({look.sign})")
        points = [
            (position, _number(reading))
            for position, target in zip(positions, targets, strict=True)
            for reading in target.get(f"deviations_{look.key}") or []
        ]
        if points:
            x, y = zip(*points, strict=True)
            panel.plot(
                x, y, linestyle="none", marker=look.marker, markersize=2.6, markerfacecolor="none",
                markeredgecolor=look.colour,
                markeredgewidth=0.4, alpha=0.75, label=f"single readings ({look.sign})",
            )  # fmt: skip
        panel.plot(
            positions, means, color=look.colour, linestyle=look.line, linewidth=1.4,
            marker=look.marker, markersize=4.2,
            label=f"mean ({look.sign})",
        )  # fmt: skip


def draw_expected(panel: Any, predicted: Document, coverage: float) -> None:
    """Draw the expected means of each direction with ± ``coverage`` times the one ``s`` of a single
    reading.
    """
    zero_line(panel)
    spread = coverage * _number(predicted.get("s"))
    for look in LOOKS:
        means = curve(predicted.get(look.key))
        if not any(math.isfinite(value) for value in means):
            continue
        positions = curve(predicted["positions"])
        band(
            panel,
            positions,
            means,
            [spread] * len(means),
            look,
            label=f"mean ± {coverage:g} s ({look.sign})",
        )
        panel.plot(
            positions, means, color=look.colour, linestyle=look.line, linewidth=1.4,
            marker=look.marker, markersize=4.2,
            markerfacecolor="white", label=f"expected mean ({look.sign})",
        )  # fmt: skip


def draw_means(panel: Any, result: Document) -> None:
    """Draw only the means of a positioning result, as markers."""
    targets = result.get("targets", [])
    for look in LOOKS:
        means = [_number(target.get(f"mean_{look.key}")) for target in targets]
        if any(math.isfinite(value) for value in means):
            positions = [_number(target.get("position")) for target in targets]
            panel.plot(
                positions, means, linestyle="none", marker=look.marker, markersize=4.2,
                color=look.colour,
                label=f"measured mean ({look.sign})",
            )  # fmt: skip


def band(
    panel: Any,
    x: Sequence[float],
    y: Sequence[float],
    half: Sequence[float],
    look: _Look,
    *,
    label: str = "",
    edge: bool = True,
) -> None:
    """Fill y ± half; nothing where half is not known."""
    if not any(math.isfinite(value) for value in half):
        return
    low = [value - width for value, width in zip(y, half, strict=True)]
    high = [value + width for value, width in zip(y, half, strict=True)]
    panel.fill_between(
        x, low, high, facecolor=look.colour, alpha=0.13, linewidth=0.0, label=label or None
    )
    if edge:
        for limit in (low, high):
            panel.plot(
                x,
                limit,
                color=look.colour,
                linestyle=look.line,
                linewidth=0.55,
                alpha=0.8,
                marker="_",
                markersize=3.5,
            )


def zero_line(panel: Any) -> None:
    """Draw the line of no deviation."""
    panel.axhline(0.0, color="#777777", linewidth=0.8, zorder=1.0)


def label_axes(
    panel: Any, unit: object, *, with_y: bool = True, quantity: str = "Deviation"
) -> None:
    """Name both axes with their units, and keep a flat curve flat."""
    panel.set_xlabel(f"Position in {unit_text(position_unit(unit))}")
    panel.margins(x=0.03)
    if position_unit(unit) == "deg":  # 30, 45 and 90 rather than 50 and 100
        panel.xaxis.set_major_locator(
            need("matplotlib.ticker").MaxNLocator(nbins=9, steps=[1, 1.5, 3, 4.5, 6, 9, 10])
        )
    low, high = panel.get_ylim()
    if high - low < 0.2:  # a flat curve: do not magnify what no instrument resolves
        panel.set_ylim((low + high) / 2 - 0.1, (low + high) / 2 + 0.1)
    if with_y:
        panel.set_ylabel(f"{quantity} in {unit_text(unit)}")


def head(panel: Any, name: str, line: str) -> None:
    """Write a panel's name and, below it, its parameters."""
    panel.set_title(f"{name}\n", fontweight="bold")
    panel.annotate(
        line,
        (0.0, 1.0),
        xycoords="axes fraction",
        xytext=(0, 5),
        textcoords="offset points",
        fontsize=7.5,
        color=_INK,
    )


def arrange(figure: Any, panels: Sequence[Any], *, head: float) -> None:
    """Place panels side by side under ``head`` inches of words and over the legend.

    The places are worked out from the numbers along the axis, which takes a hundredth of the time
    that measuring every word takes.
    """
    width, height = figure.get_size_inches()
    low, high = panels[0].get_ylim()
    digits = max(len(f"{value:.0f}") for value in (low, high)) + (2 if high - low < _FINE else 0)
    left = _BESIDE + _DIGIT * digits
    each = (width - left - _EDGE - _GAP * (len(panels) - 1)) / len(panels)
    figure.subplots_adjust(
        left=left / width,
        right=1.0 - _EDGE / width,
        top=1.0 - head / height,
        bottom=_BELOW / height,
        wspace=_GAP / each,
    )


def legend(figure: Any, panels: Sequence[Any], *, place: str = "outside lower center") -> None:
    """One legend for all panels, below them, each entry once."""
    entries: dict[str, Any] = {}
    for panel in panels:
        for handle, label in zip(*panel.get_legend_handles_labels(), strict=True):
            entries.setdefault(label, handle)
    if not entries:
        return
    order = list(dict.fromkeys(_quantity(label) for label in entries))
    names = sorted(
        entries, key=lambda label: order.index(_quantity(label))
    )  # stable: + stands over −
    figure.legend(
        [entries[name] for name in names], names, loc=place, ncols=max(1,
        (len(names) + 1) // 2),
        title="(+) and (−): approach in the positive and in the negative direction",
        title_fontsize=7.5,
    )  # fmt: skip


def _quantity(label: str) -> str:
    return label.rpartition(" (")[0]


# --- words in a figure
# --------------------------------------------------------------------------------------------------


def title_of(result: Document) -> str:
    """Return axis, test, standard and number of runs as one line."""
    runs = result.get("n_runs") or {}
    counts = sorted({int(runs[key]) for key in ("positive", "negative") if runs.get(key)})
    count = "–".join(str(value) for value in counts)
    name = str(result.get("name") or "")
    axis = str(result.get("axis") or "?")
    parts = [
        f"Axis {_one_line(axis, 10)}",
        _one_line(name, 20),
        standard_text(result.get("standard", "")),
        f"n = {count}" if count else "",
    ]
    return "   ".join(part for part in parts if part)


def parameter_line(result: Document, most: int = 4) -> str:
    """The parameters of the corner: both directions together, or those of the one direction that
    was measured.
    """
    given = {
        key: value for key, value in (result.get("parameters") or {}).items() if value is not None
    }
    for keys in (
        ("A", "E", "R", "B"),
        ("P", "Pa", "Ps_max", "U_max"),
        _single("positive"),
        _single("negative"),
    ):
        shown = [key for key in keys if key in given][:most]
        if shown:
            text = "   ".join(f"{symbol(key)} {number(given[key])}" for key in shown)
            return f"{text} {unit_text(result.get('unit'))}"
    return ""


def _single(direction: str) -> tuple[str, ...]:
    return tuple(f"{letter}_{direction}" for letter in "AER")


def prediction_line(predicted: Document, before: Document, most: int) -> str:
    """Medians and 5-95 % of the first parameters of those that the panel before names."""
    given = before.get("parameters") or {}
    order = [
        key
        for key in ("A", "E", "P", "Pa", *_single("positive"), *_single("negative"))
        if given.get(key) is not None
    ]
    shown = [
        (symbol(key), predicted[key]) for key in order if isinstance(predicted.get(key), Mapping)
    ][:most]
    text = "   ".join(
        f"{name} {number(q.get('median'))} ({number(q.get('p05'))} to {number(q.get('p95'))})"
        for name, q in shown
    )
    return f"{text} {unit_text(before.get('unit'))}" if text else ""


def _one_line(text: str, most: int) -> str:
    line = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return line if len(line) <= most else f"{line[: most - 1]}…"


# --- numbers of a document
# --------------------------------------------------------------------------------------------------


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else math.nan


def curve(values: Sequence[object] | None) -> list[float]:
    """Return the numbers of a list of a document; null, which is a gap in the curve, as NaN."""
    return [_number(value) for value in values or []]


# --- the plotting library
# --------------------------------------------------------------------------------------------------


def known_format(format_: str) -> PlotFormat:
    """Return ``format_`` as a known format. Raises UsageError, which names it, for any other."""
    ending = format_.lower().removeprefix(".")
    if ending not in _FORMATS:
        raise UsageError(
            Fault(
                message="unknown format of a plot",
                expected="a name that ends in .svg, .png or .pdf",
                found=repr(format_),
            )
        )
    return cast("PlotFormat", ending)


@contextmanager
def style() -> Iterator[None]:
    """Set the look of all figures while one is drawn and written. Raises UsageError when the report
    extra is missing.
    """
    matplotlib = need("matplotlib")
    with warnings.catch_warnings(), matplotlib.rc_context(_STYLE):
        warnings.filterwarnings(
            "ignore", message="Glyph"
        )  # a name in a script that the font lacks shows boxes
        yield


def new_figure(height: float, *, measured: bool = True) -> Any:
    """Return an empty figure of the width of a page and ``height`` in inches. ``measured``: every
    word is measured to place the panels, else they are placed by `arrange`.
    """
    figure_module = need("matplotlib.figure")
    layout = "constrained" if measured else None
    return figure_module.Figure(figsize=(_WIDTH, height), layout=layout)


def render(figure: Any, kind: PlotFormat) -> bytes:
    """Return the bytes of the figure, without a date, so that the same input gives the same
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
        return text.getvalue().encode()
    buffer = io.BytesIO()
    dpi = min(_PNG_DPI, _PNG_LARGEST / height_in_inches) if kind == "png" else 72.0
    figure.savefig(buffer, format=kind, dpi=dpi, metadata=metadata[kind])
    return buffer.getvalue()
