"""Charts as plain SVG inside a page, without a plotting library, side by side on one scale.

A page with many axes is drawn quickly. The charts use the fonts of the page. Lengths are points,
for a picture as wide as the text of an A4 page.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from html import escape
from itertools import count
from typing import Final

from compwright.foundations.utf8 import visible
from compwright.reporting.charts import (
    INK,
    LEGEND_TITLE,
    Band,
    Chart,
    ChartCurve,
    covered,
    legend_of,
)
from compwright.words.sentences import Language, Sentence, number_text

_WIDTH: Final = 518.4
# Around the panels: the label next to the numbers, one digit, the margin on the right, between
# panels, and below them position, legend and its title.
_LABEL_WIDTH: Final = 27.0
_DIGIT: Final = 4.9
_EDGE: Final = 9.0
_GAP: Final = 17.0
_BELOW: Final = 70.0
_NO_LEGEND: Final = 30.0
_LEGEND_ROW: Final = 11.0
_TOP: Final = 6.0  # above panels
_HEAD: Final = 18.0  # with a line of words
_LINE: Final = 12.0  # and another one
_TITLE: Final = 8.5  # sizes of letters
_TEXT: Final = 8.0
_SMALL: Final = 7.5
_LETTER: Final = 0.6  # a letter's width, of its size: that of wide ones
_APART: Final = 1.4  # from number to number along an axis, of a number's width
_ROW: Final = 21.0  # from number to number up an axis
_MOST_NUMBERS: Final = 9
_STEPS: Final = (1.0, 2.0, 2.5, 5.0)
_STEPS_OF_A_TURN: Final = (1.0, 1.5, 3.0, 4.5, 6.0, 9.0)  # 30, 45 and 90 rather than 50 and 100
_HANDLE: Final = 22.0  # what stands before a name in the legend
_FREE: Final = 12.0  # behind it
_RING: Final = 3.6  # radius of a mark
#: What keeps the name of a mark readable on the curves that it is drawn over.
_HALO: Final = 'stroke="#fff" stroke-width="2.4" stroke-linejoin="round" paint-order="stroke"'
_SOFT: Final = "#555555"
#: Points of a line beyond which it is thinned: two to each point of the picture.
_MOST_POINTS: Final = 1000


@dataclass(frozen=True, slots=True)
class _Scale:
    """A linear scale: values ``low`` to ``high`` are drawn at ``first`` to ``last`` (points)."""

    low: float
    high: float
    first: float
    last: float

    def at(self, values: Sequence[float]) -> list[float]:
        """Return the coordinates of values in the drawing, in points."""
        by = (self.last - self.first) / (self.high - self.low)
        start = self.first - by * self.low
        return [start + by * value for value in values]


@dataclass(frozen=True, slots=True)
class Drawing:
    """Several charts side by side on one scale. ``description``: the text for screen readers."""

    charts: tuple[Chart, ...]
    height: float
    description: Sentence

    def svg(self, language: Language) -> str:
        """Return the SVG picture, with its texts in the language."""
        charts = [chart.written(language) for chart in self.charts]
        across, up = covered(charts)
        head = _HEAD if any(chart.title or chart.right or chart.note for chart in charts) else _TOP
        head += _LINE if any(chart.note for chart in charts) else 0.0
        columns, _ = _legend_columns(charts)
        more = max(map(len, columns), default=0) - 2
        below = _BELOW + _LEGEND_ROW * max(more, 0) if columns else _NO_LEGEND
        bottom = self.height - below
        fitting = count(int((bottom - head) / _ROW))
        every = (_ticks(*up, most, _STEPS) for most in fitting)
        rows, decimals = next(ticks for ticks in every if len(ticks[0]) > 1)  # one has no scale
        numbers = [_written(value, decimals, language) for value in rows]
        left = _LABEL_WIDTH + _DIGIT * max(map(len, numbers), default=0)
        each = (_WIDTH - left - _EDGE - _GAP * (len(charts) - 1)) / len(charts)
        y = _Scale(*up, bottom, head)
        parts = []
        for index, chart in enumerate(charts):
            start = left + index * (each + _GAP)
            x = _Scale(*across, start, start + each)
            labels = numbers if index == 0 else [""] * len(rows)
            parts += [
                *_frame(chart, x, y, list(zip(rows, labels, strict=True)), language),
                *_content(chart, x, y),
            ]
            parts += _words(chart, x, y, named=index == 0)
        parts += _legend(charts, bottom, language)
        described = _text(self.description.text(language))
        return (
            f'<svg viewBox="0 0 {_WIDTH:g} {self.height:g}" role="img" font-size="{_SMALL:g}"'
            f' fill="{INK}" aria-label="{described}">{"".join(parts)}</svg>'
        )


# --- axes
# --------------------------------------------------------------------------------------------------


def _frame(
    chart: Chart, x: _Scale, y: _Scale, rows: list[tuple[float, str]], language: Language
) -> Iterator[str]:
    """Yield a chart's grid lines, axis lines and the numbers at its axes. ``rows``: value and text
    of each number at the vertical axis.
    """
    columns, decimals = _along(x, _STEPS_OF_A_TURN if chart.degrees else _STEPS)
    rows_at, below = y.at([value for value, _ in rows]), x.at(columns)
    grid = "".join(f"M{x.first:.2f},{at:.2f}H{x.last:.2f}" for at in rows_at)
    grid += "".join(f"M{at:.2f},{y.first:.2f}V{y.last:.2f}" for at in below)
    yield _path(grid, "#e3e3e3", 0.5)
    marks = "".join(f"M{x.first:.2f},{at:.2f}h-3.5" for at in rows_at)
    marks += "".join(f"M{at:.2f},{y.first:.2f}v3.5" for at in below)
    yield _path(f"M{x.first:.2f},{y.last:.2f}V{y.first:.2f}H{x.last:.2f}{marks}", _SOFT, 0.6)
    for at, (_, written) in zip(rows_at, rows, strict=True):
        if written:
            yield _word(x.first - 6.0, at + 2.7, written, anchor="end")
    for at, value in zip(below, columns, strict=True):
        yield _word(at, y.first + 12.0, _written(value, decimals, language), anchor="middle")


def _along(x: _Scale, steps: Sequence[float]) -> tuple[list[float], int]:
    """Return the values that are printed at the horizontal axis, as many as there is room for, and
    their number of decimals. ``steps``: the possible distances between two values, times any power
    of 10.
    """
    for most in range(_MOST_NUMBERS, 1, -1):
        columns, decimals = _ticks(x.low, x.high, most, steps)
        wide = max((len(_written(value, decimals)) for value in columns), default=0)
        if len(columns) * wide * _LETTER * _SMALL * _APART <= x.last - x.first:
            break
    return columns, decimals


def _ticks(low: float, high: float, most: int, steps: Sequence[float]) -> tuple[list[float], int]:
    """Return about ``most`` round numbers from low to high, and how many decimals they have.
    ``steps``: the possible distances between two numbers, times any power of 10.
    """
    least = (high - low) / max(most, 1)
    power = 10.0 ** math.floor(math.log10(least))
    step = next(
        size * power for size in (*steps, 10.0 * steps[0]) if size * power >= least * (1 - 1e-9)
    )
    decimals = next((d for d in range(12) if abs(round(step, d) - step) < 1e-6 * step), 12)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [round(place * step, decimals) for place in range(first, last + 1)], decimals


def _written(value: float, decimals: int, language: Language = "en") -> str:
    return number_text(value, f".{decimals}f", language).replace("-", "−")


# --- curves and bands
# --------------------------------------------------------------------------------------------------


def _content(chart: Chart, x: _Scale, y: _Scale) -> Iterator[str]:
    for band in chart.bands:
        yield from _filled(band, x, y)
    (zero,) = y.at([0.0])
    yield _path(f"M{x.first:.2f},{zero:.2f}H{x.last:.2f}", "#777777", 0.8)
    for curve in chart.curves:
        yield _drawn(curve, x, y)
    yield from _rings(chart, x, y)


def _rings(chart: Chart, x: _Scale, y: _Scale) -> Iterator[str]:
    """Yield a ring around each marked point and its name. Marks that coincide share one text."""
    places: dict[tuple[float, float], list[str]] = {}
    for mark in chart.marks:
        (across,), (up,) = x.at([mark.x]), y.at([mark.y])
        near = (
            place
            for place in places
            if abs(place[0] - across) < _RING and abs(place[1] - up) < _SMALL
        )
        places.setdefault(next(near, (across, up)), []).append(mark.text)
        r = _RING
        ring = f"M{across - r:.2f},{up:.2f}a{r:g},{r:g} 0 1 0 {2 * r:g},0"
        yield _path(f"{ring}a{r:g},{r:g} 0 1 0 {-2 * r:g},0", INK, 0.9)
    taken: list[_Box] = []
    for (across, up), names in places.items():
        word = ", ".join(dict.fromkeys(names))
        box = _free_box(across, up, _LETTER * _TEXT * len(word), x, y, [*_boxes(places), *taken])
        taken.append(box)
        yield _word(box[0], box[3], word, size=_TEXT, more=f' font-weight="bold" {_HALO}')


#: Left, top, right and bottom of an area, in points.
_Box = tuple[float, float, float, float]


def _boxes(places: Iterable[tuple[float, float]]) -> list[_Box]:
    """Return the rectangles that the rings around marked points occupy."""
    r = _RING
    return [(across - r, up - r, across + r, up + r) for across, up in places]


def _free_box(
    across: float, up: float, width: float, x: _Scale, y: _Scale, taken: Sequence[_Box]
) -> _Box:
    """Return the rectangle, ``width`` wide, for the name of the point marked at (``across``,
    ``up``): of several places near the point, the one that overlaps the ``taken`` rectangles least.
    """
    sides = [1.0, -1.0] if across < (x.first + x.last) / 2 else [-1.0, 1.0]
    boxes = []
    for lift in (2.0, 12.0, -8.0, 22.0, -18.0):
        for side in (*sides, 0.0):
            middle = across + side * (_RING + 2.0 + width / 2)
            left = min(max(middle - width / 2, x.first), x.last - width)
            bottom = min(max(up - lift + 4.0 * (side == 0.0), y.last + _TEXT), y.first)
            boxes.append((left, bottom - 0.75 * _TEXT, left + width, bottom))
    return min(boxes, key=lambda box: sum(_common(box, other) for other in taken))


def _common(one: _Box, other: _Box) -> float:
    """Return the area in which two rectangles overlap."""
    wide = min(one[2], other[2]) - max(one[0], other[0])
    high = min(one[3], other[3]) - max(one[1], other[1])
    return max(wide, 0.0) * max(high, 0.0)


def _filled(band: Band, x: _Scale, y: _Scale) -> Iterator[str]:
    """Yield the filled area between the two limits of a band. Where values are missing (NaN), the
    area is interrupted.
    """
    for first, last in _stretches(
        [low + high for low, high in zip(band.low, band.high, strict=True)]
    ):
        where = band.x[first:last]
        lower = _thinned(where, band.low[first:last])
        upper = _thinned(where, band.high[first:last])
        outline = [_points(x.at(line[0]), y.at(line[1])) for line in (lower, upper)]
        back = " ".join(reversed(outline[1].split(" ")))
        yield (
            f'<polygon points="{outline[0]} {back}" fill="{band.look.colour}"'
            ' fill-opacity="0.13"></polygon>'
        )


def _drawn(curve: ChartCurve, x: _Scale, y: _Scale) -> str:
    """Return a curve: its line and its markers, all in one path."""
    look, parts = curve.look, []
    if curve.width:
        line = ""
        for first, last in _stretches(curve.y):
            where, values = _thinned(curve.x[first:last], curve.y[first:last])
            line += f"M{_points(x.at(where), y.at(values))}"
        dashes = () if curve.whole else look.dashes
        parts.append(_path(line, look.colour, curve.width, curve.opacity, dashes))
    if curve.size:
        known = [at for at in zip(curve.x, curve.y, strict=True) if math.isfinite(at[1])]
        if known:
            across, up = zip(*known, strict=True)
            parts.append(_markers(curve, x.at(across), y.at(up)))
    return "".join(parts)


def _markers(curve: ChartCurve, x: Sequence[float], y: Sequence[float]) -> str:
    half, size = 0.5 * curve.size, curve.size
    right, down, shape = {
        "^": (0.0, -half, f"l{half:g},{size:g}h{-size:g}z"),
        "v": (0.0, half, f"l{-half:g},{-size:g}h{size:g}z"),
        "_": (-half, 0.0, f"h{size:g}"),
    }[curve.marker or curve.look.marker]
    path = "".join(f"M{at + right:.2f},{up + down:.2f}{shape}" for at, up in zip(x, y, strict=True))
    return _path(path, curve.look.colour, curve.edge, curve.opacity, fill=curve.face or "none")


def _stretches(values: Sequence[float]) -> Iterator[tuple[int, int]]:
    """Yield start and end index of each range without gaps (NaN)."""
    first = None
    if all(map(math.isfinite, values)):
        yield from [(0, len(values))] if values else []
        return
    for index, value in enumerate([*values, math.nan]):
        if math.isfinite(value):
            first = index if first is None else first
        elif first is not None:
            yield first, index
            first = None


def _thinned(x: Sequence[float], y: Sequence[float]) -> tuple[Sequence[float], Sequence[float]]:
    """Reduce a line to at most `_MOST_POINTS` points: of each group of neighbouring points, only
    the lowest and the highest are kept.
    """
    if len(y) <= _MOST_POINTS:
        return x, y
    few = -(-2 * len(y) // _MOST_POINTS)
    kept = {0, len(y) - 1}
    for first in range(0, len(y), few):
        piece = y[first : first + few]
        kept |= {first + piece.index(min(piece)), first + piece.index(max(piece))}
    places = sorted(kept)
    return [x[place] for place in places], [y[place] for place in places]


def _points(x: Sequence[float], y: Sequence[float]) -> str:
    return " ".join(f"{at:.2f},{up:.2f}" for at, up in zip(x, y, strict=True))


def _path(
    path: str,
    colour: str,
    width: float,
    opacity: float = 1.0,
    dashes: Sequence[float] = (),
    fill: str = "none",
) -> str:
    lengths = ",".join(f"{width * length:g}" for length in dashes)
    dashed = f' stroke-dasharray="{lengths}"' if dashes else ""
    faint = f' opacity="{opacity:g}"' if opacity < 1.0 else ""
    return (
        f'<path d="{path}" fill="{fill}" stroke="{colour}" stroke-width="{width:g}"{dashed}{faint}>'
        "</path>"
    )


# --- words
# --------------------------------------------------------------------------------------------------


def _words(chart: Chart, x: _Scale, y: _Scale, *, named: bool) -> Iterator[str]:
    """Yield title and other texts around a chart. ``named``: also name the vertical axis."""
    above = y.last - 5.0
    if chart.note:
        yield _word(x.first, above, chart.note)
        above -= _LINE
    if chart.title:
        yield _word(x.first, above, chart.title, size=_TITLE, more=' font-weight="bold"')
    if chart.right:
        yield _word(x.last, above, chart.right, size=_TEXT, anchor="end")
    yield _word((x.first + x.last) / 2, y.first + 23.0, chart.x_label, size=_TEXT, anchor="middle")
    if named:
        # A name longer than its panel begins at the edge of the picture.
        middle = max((y.first + y.last) / 2, len(str(chart.y_label)) * _LETTER * _TEXT / 2)
        turned = f' transform="rotate(-90 9 {middle:g})"'
        yield _word(9.0, middle, chart.y_label, size=_TEXT, anchor="middle", more=turned)


def _legend(charts: Sequence[Chart], bottom: float, language: Language) -> Iterator[str]:
    """Yield the common legend of all charts; the entry for approach + is above the entry for −."""
    columns, wide = _legend_columns(charts)
    if not columns:
        return
    yield _word(_WIDTH / 2, bottom + 37.0, LEGEND_TITLE.text(language), anchor="middle")
    at = (_WIDTH - sum(wide) - _FREE * (len(columns) - 1)) / 2
    for column, width in zip(columns, wide, strict=True):
        for row, (name, part) in enumerate(column):
            up = bottom + 49.0 + _LEGEND_ROW * row
            yield _handle(part, at, up - 2.6)
            yield _word(at + _HANDLE + 6.0, up, name)
        at += width + _FREE


def _legend_columns(
    charts: Sequence[Chart],
) -> tuple[list[list[tuple[str, Band | ChartCurve]]], list[float]]:
    """Return the columns of the legend and their widths. A column has two names, or more if the
    columns would be wider than the figure.
    """
    entries = list(legend_of(charts).items())
    height = 1
    while True:
        height += 1
        columns = [entries[first : first + height] for first in range(0, len(entries), height)]
        wide = [
            _HANDLE + 6.0 + _LETTER * _SMALL * max(len(name) for name, _ in column)
            for column in columns
        ]
        if len(columns) < 2 or sum(wide) + _FREE * (len(wide) - 1) <= _WIDTH:
            return columns, wide


def _handle(part: Band | ChartCurve, at: float, up: float) -> str:
    ends = _Scale(0.0, 1.0, at, at + _HANDLE)
    level = _Scale(-1.0, 1.0, up + 3.0, up - 3.0)
    if isinstance(part, Band):
        return "".join(
            _filled(Band(x=(0, 1), low=(-1, -1), high=(1, 1), look=part.look), ends, level)
        )
    line = ChartCurve(
        x=(0, 1), y=(0, 0), look=part.look, width=part.width, whole=part.whole, opacity=part.opacity
    )
    mark = ChartCurve(
        x=(0.5,), y=(0.0,), look=part.look, size=part.size, marker=part.marker, face=part.face,
        edge=part.edge, opacity=part.opacity,
    )  # fmt: skip
    return _drawn(line, ends, level) + _drawn(mark, ends, level)


def _word(
    x: float,
    y: float,
    words: str | Sentence,
    *,
    size: float = _SMALL,
    anchor: str = "start",
    more: str = "",
) -> str:
    own = "" if size == _SMALL else f' font-size="{size:g}"'
    where = "" if anchor == "start" else f' text-anchor="{anchor}"'
    return f'<text x="{x:.2f}" y="{y:.2f}"{own}{where}{more}>{_text(words)}</text>'


def _text(words: str | Sentence) -> str:
    return escape(visible(str(words))).replace("  ", "\u00a0\u00a0")  # blanks count, as in a table
