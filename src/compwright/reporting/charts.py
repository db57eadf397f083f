"""The contents of figures as data: curves, bands and texts, in the units of the documents.

Deviations are in µm or arcsec, positions in mm or deg. `chart_svg` draws them in pages, and `plots`
in separate files. The directions of approach differ by marker, line and lightness, so that a print
without colours can be read.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final, Literal

from compwright.reporting.numbers import number, position_unit, standard_text, symbol, unit_text
from compwright.words.sentences import Language, Sentence, in_language, say

Document = Mapping[str, Any]
Marker = Literal["^", "v", "_"]

INK: Final = "#222222"
LEGEND_TITLE: Final = say("chart.legend")
#: Share of the range of positions and of deviations that is left free on either side.
_MARGIN_X: Final = 0.03
_MARGIN_Y: Final = 0.05
#: Least height of a panel (µm, arcsec): a flat curve does not magnify what no instrument resolves.
_LEAST_HEIGHT: Final = 0.2
_MOST_MARKED: Final = 150  # points of a table that markers can still tell apart


@dataclass(frozen=True, slots=True)
class CurveLook:
    """The style of the curves of one approach direction: marker, dashes and colour."""

    key: str
    sign: str
    marker: Marker
    dashes: tuple[float, ...]
    colour: str


LOOKS: Final = (
    CurveLook("positive", "+", "^", (), "#0b4a82"),
    CurveLook("negative", "−", "v", (4.0, 1.6), "#c2590c"),
)
#: What belongs to both approach directions.
NEUTRAL: Final = CurveLook("both", "±", "^", (), INK)


@dataclass(frozen=True, slots=True, kw_only=True)
class ChartCurve:
    """One curve: ``y`` over ``x``, with the style of its line and markers. NaN is a gap.

    ``width``: of the line in points, 0 for no line. ``size``: of the markers in points, 0 for none.
    ``face``: the colour inside a marker, none for an empty marker. ``edge``: the width of its edge
    in points. A curve without a ``label`` is not in the legend.
    """

    x: Sequence[float]
    y: Sequence[float]
    look: CurveLook
    label: str | Sentence = ""
    width: float = 0.0
    whole: bool = False
    opacity: float = 1.0
    size: float = 0.0
    marker: Marker | None = None
    face: str | None = None
    edge: float = 1.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Band:
    """The area between ``low`` and ``high`` over ``x``."""

    x: Sequence[float]
    low: Sequence[float]
    high: Sequence[float]
    look: CurveLook
    label: str | Sentence = ""


@dataclass(frozen=True, slots=True)
class ChartMark:
    """A point to be marked with a ring and the name ``text``."""

    x: float
    y: float
    text: str


@dataclass(slots=True, kw_only=True)
class Chart:
    """One chart: its title, texts, curves, bands and marked points. ``degrees``: the positions are
    angles in degrees.

    ``right``: text to the right of the chart. ``note``: text in a line below it.
    """

    title: str | Sentence = ""
    right: str | Sentence = ""
    note: str | Sentence = ""
    x_label: str | Sentence = ""
    y_label: str | Sentence = ""
    degrees: bool = False
    bands: list[Band] = field(default_factory=list)
    curves: list[ChartCurve] = field(default_factory=list)
    marks: list[ChartMark] = field(default_factory=list)

    def named(self) -> Iterator[Band | ChartCurve]:
        """Yield the bands and curves of the chart that have an entry in the legend."""
        parts: list[Band | ChartCurve] = [*self.bands, *self.curves]
        yield from (part for part in parts if part.label)

    def written(self, language: Language) -> Chart:
        """Return the chart with its texts translated."""
        return replace(
            self,
            title=in_language(self.title, language),
            right=in_language(self.right, language),
            note=in_language(self.note, language),
            x_label=in_language(self.x_label, language),
            y_label=in_language(self.y_label, language),
            bands=[replace(one, label=in_language(one.label, language)) for one in self.bands],
            curves=[replace(one, label=in_language(one.label, language)) for one in self.curves],
            marks=[replace(one, text=in_language(one.text, language)) for one in self.marks],
        )

    def name_axes(self, unit: object, quantity: str = "deviation") -> None:
        """Set the names of both chart axes, with their units."""
        self.degrees = position_unit(unit) == "deg"
        self.x_label = say("chart.position", unit=unit_text(position_unit(unit)))
        self.y_label = say("chart.quantity", quantity=quantity, unit=unit_text(unit))


# --- charts
# --------------------------------------------------------------------------------------------------


def result_chart(result: Document) -> Chart:
    """Return the chart of a positioning test: readings, means, ± k s (ISO 230-2:1997, figure 2).

    ``result``: an entry of ``results`` of an evaluation document. If it has ``deviations_positive``
    and ``deviations_negative`` per target, they are drawn as points. ``coverage`` (default 2) is k.
    """
    chart = Chart()
    targets = result.get("targets", [])
    coverage = float(result.get("coverage") or 2.0)
    positions = [_number(target.get("position")) for target in targets]
    for look in LOOKS:
        means = [_number(target.get(f"mean_{look.key}")) for target in targets]
        if not _any_known(means):
            continue
        spread = [coverage * _number(target.get(f"s_{look.key}")) for target in targets]
        _add_band(
            chart,
            positions,
            means,
            spread,
            look,
            say("chart.spread", coverage=coverage, sign=look.sign),
        )
        points = [
            (position, _number(reading))
            for position, target in zip(positions, targets, strict=True)
            for reading in target.get(f"deviations_{look.key}") or []
        ]
        if points:
            x, y = zip(*points, strict=True)
            label = say("chart.readings", sign=look.sign)
            chart.curves.append(
                ChartCurve(x=x, y=y, look=look, label=label, size=2.6, edge=0.4, opacity=0.75)
            )
        label = say("chart.mean", sign=look.sign)
        chart.curves.append(_means(positions, means, look, label, face=look.colour))
    both = [_number(target.get("mean")) for target in targets]
    if _any_known(both):
        label = say("chart.mean", sign=NEUTRAL.sign)
        chart.curves.append(ChartCurve(x=positions, y=both, look=NEUTRAL, label=label, width=1.0))
    chart.marks = [
        ChartMark(_number(end.get("position")), _number(end.get("value")), symbol(name))
        for name, ends in (result.get("extremes") or {}).items()
        if name in ("A", "E", "M", "R")
        for end in ends
    ]
    chart.name_axes(result.get("unit"))
    return chart


def reversal_chart(result: Document) -> Chart:
    """Return the chart of a test's reversal B_i over the targets, with its extreme marked."""
    targets = result.get("targets", [])
    positions = [_number(target.get("position")) for target in targets]
    values = [_number(target.get("reversal")) for target in targets]
    chart = Chart(
        curves=[ChartCurve(x=positions, y=values, look=NEUTRAL, width=1.2, size=4.2, face=INK)]
    )
    at = (result.get("at") or {}).get("B")
    chart.marks = [
        ChartMark(x, y, symbol("B")) for x, y in zip(positions, values, strict=True) if x == at
    ]
    chart.name_axes(result.get("unit"), "reversal")
    return chart


def residual_charts(result: Document) -> list[Chart]:
    """Return charts of the residuals of a circular test over the angle, one chart for each
    direction that was fitted.
    """
    fitted = result.get("fitted") or ()
    charts = []
    for key, look in zip(("ccw", "cw"), LOOKS, strict=True):
        curves = []
        for run in fitted:
            if run["direction"] == key:
                x, y = zip(*sorted(zip(run["angles"], run["residuals"], strict=True)), strict=True)
                curves.append(ChartCurve(x=x, y=y, look=look, width=0.6, whole=True))
        if curves:
            charts.append(
                Chart(
                    title=say("chart.residual", sense=key),
                    x_label=say("chart.angle"),
                    y_label=say("chart.radius"),
                    degrees=True,
                    curves=curves,
                )
            )
    return charts


def expected_chart(predicted: Document, coverage: float) -> Chart:
    """Return the chart of the expected mean deviations in each direction, each with a band of ±
    ``coverage`` times the scatter ``s``.

    ``predicted`` has ``positions`` (m), ``positive`` and ``negative`` (m) or None, and ``s``.
    """
    chart = Chart()
    spread = coverage * _number(predicted.get("s"))
    for look in LOOKS:
        means = numbers(predicted.get(look.key))
        if not _any_known(means):
            continue
        positions = numbers(predicted["positions"])
        label = say("chart.spread", coverage=coverage, sign=look.sign)
        _add_band(chart, positions, means, [spread] * len(means), look, label)
        chart.curves.append(
            _means(positions, means, look, say("chart.expected", sign=look.sign), face="#ffffff")
        )
    return chart


def table_chart(entry: Document) -> Chart:
    """Return the chart of a table: its correction in each direction, the points of the table, and
    the wanted correction.

    ``entry`` holds ``table`` (``positions``, ``correction_positive``, ``correction_negative``,
    ``unit``) as in the prediction document, and ``wanted`` (``positions``, ``positive``,
    ``negative``) or None in the same unit.
    """
    chart = Chart(title=say("chart.correction"))
    table, wanted = entry["table"], entry.get("wanted") or {}
    for look in LOOKS:
        if wanted.get(look.key):
            x, y = numbers(wanted["positions"]), numbers(wanted[look.key])
            label = say("chart.wanted", sign=look.sign)
            chart.curves.append(
                ChartCurve(x=x, y=y, look=look, label=label, width=2.6, whole=True, opacity=0.35)
            )
    positions = numbers(table["positions"])
    values = {look.key: numbers(table.get(f"correction_{look.key}")) for look in LOOKS}
    same = values["positive"] == values["negative"]
    dense = len(positions) > _MOST_MARKED  # the line alone
    size = 0.0 if dense else 4.0 if len(positions) <= 60 else 2.0
    for look in LOOKS[:1] if same else LOOKS:
        label = say("chart.table_both") if same else say("chart.table", sign=look.sign)
        chart.curves.append(
            ChartCurve(
                x=positions, y=values[look.key], look=look, label=label, width=1.0, size=size,
                face=look.colour,
            )
        )  # fmt: skip
    chart.name_axes(table.get("unit", entry.get("unit")), "correction")
    return chart


def estimate_chart(estimate: Document, result: Document) -> Chart:
    """Return the chart of the estimated deviation ± 2 standard deviations, and the measured means.

    ``estimate`` holds ``positions`` (g), ``mean_positive``, ``mean_negative``, ``std_positive``,
    ``std_negative`` (g) in the unit of the positioning result ``result``.
    """
    chart = Chart(title=say("chart.estimated"))
    positions = numbers(estimate["positions"])
    for look in LOOKS:
        means = numbers(estimate.get(f"mean_{look.key}"))
        if not means:
            continue
        spread = [2.0 * value for value in numbers(estimate[f"std_{look.key}"])]
        _add_band(chart, positions, means, spread, look)
        label = say("chart.estimate", sign=look.sign)
        chart.curves.append(ChartCurve(x=positions, y=means, look=look, label=label, width=1.2))
    targets = result.get("targets", [])
    where = [_number(target.get("position")) for target in targets]
    for look in LOOKS:
        means = [_number(target.get(f"mean_{look.key}")) for target in targets]
        if _any_known(means):
            label = say("chart.measured", sign=look.sign)
            chart.curves.append(
                ChartCurve(x=where, y=means, look=look, label=label, size=4.2, face=look.colour)
            )
    chart.name_axes(result.get("unit"))
    return chart


def _means(
    x: Sequence[float], y: Sequence[float], look: CurveLook, label: Sentence, *, face: str
) -> ChartCurve:
    return ChartCurve(x=x, y=y, look=look, label=label, width=1.4, size=4.2, face=face)


def _add_band(
    chart: Chart,
    x: Sequence[float],
    y: Sequence[float],
    half: Sequence[float],
    look: CurveLook,
    label: str | Sentence = "",
) -> None:
    """Add the band y ± ``half`` with the style ``look`` to a chart if ``half`` has values. With a
    ``label`` the limits of the band are drawn as lines too.
    """
    if not _any_known(half):
        return
    low = [value - width for value, width in zip(y, half, strict=True)]
    high = [value + width for value, width in zip(y, half, strict=True)]
    chart.bands.append(Band(x=x, low=low, high=high, look=look, label=label))
    if label:
        chart.curves.extend(
            ChartCurve(x=x, y=limit, look=look, width=0.55, opacity=0.8, marker="_", size=3.5)
            for limit in (low, high)
        )


# --- what a figure covers
# --------------------------------------------------------------------------------------------------


def covered(charts: Sequence[Chart]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the ranges (low, high) of positions and of deviations that several charts cover."""
    positions, deviations = [math.inf, -math.inf], [0.0, 0.0]
    for chart in charts:
        for curve in chart.curves:
            _stretch(positions, curve.x)
            _stretch(deviations, curve.y)
        for band in chart.bands:
            _stretch(deviations, band.low)
            _stretch(deviations, band.high)
    if positions[0] > positions[1]:
        positions = [0.0, 0.0]
    low, high = _with_margin(deviations, _MARGIN_Y)
    lacking = max(0.0, _LEAST_HEIGHT - (high - low)) / 2
    return _with_margin(positions, _MARGIN_X, least=1.0), (low - lacking, high + lacking)


def _stretch(limits: list[float], values: Sequence[float]) -> None:
    low, high = min(values, default=math.nan), max(values, default=math.nan)
    if not (math.isfinite(low) and math.isfinite(high)):
        known = [value for value in values if math.isfinite(value)]
        low, high = min(known, default=limits[0]), max(known, default=limits[1])
    limits[0], limits[1] = min(limits[0], low), max(limits[1], high)


def _with_margin(limits: Sequence[float], share: float, least: float = 0.0) -> tuple[float, float]:
    low, high = limits
    free = share * (high - low) or least / 2
    return low - free, high + free


def legend_of(charts: Sequence[Chart]) -> dict[str, Band | ChartCurve]:
    """Return the curves and bands of all charts by their name in the legend, each name once."""
    entries: dict[str, Band | ChartCurve] = {}
    for chart in charts:
        for part in chart.named():
            entries.setdefault(str(part.label), part)
    order = list(dict.fromkeys(_quantity(label) for label in entries))
    # stable: + stays before −
    names = sorted(entries, key=lambda label: order.index(_quantity(label)))
    return {name: entries[name] for name in names}


def _quantity(label: str) -> str:
    return label.rpartition(" (")[0]


# --- words in a figure
# --------------------------------------------------------------------------------------------------


def title_of(result: Document) -> Sentence:
    """Return axis, test, standard and number of runs as one line."""
    runs = result.get("n_runs") or {}
    counts = sorted({int(runs[key]) for key in ("positive", "negative") if runs.get(key)})
    count = "–".join(str(value) for value in counts)
    name = str(result.get("name") or "")
    axis = str(result.get("axis") or "")
    parts: list[str | Sentence] = [
        say("report.axis", axis=_one_line(axis, 10), name=""),
        _one_line(name, 20),
        standard_text(result.get("standard", "")),
        f"n = {count}" if count else "",
    ]
    return say("chart.line", parts=[part for part in parts if part], unit="")


def parameter_line(result: Document, most: int = 4) -> str | Sentence:
    """Return, as one line, at most ``most`` main parameters (such as A, E, R, B) for both
    directions together; for a test in one direction, those of that direction.
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
            parts = [say("parameter", parameter=symbol(k), value=number(given[k])) for k in shown]
            return say("chart.line", parts=parts, unit=unit_text(result.get("unit")))
    return ""


def _single(direction: str) -> tuple[str, ...]:
    return tuple(f"{letter}_{direction}" for letter in "AER")


def prediction_line(predicted: Document, before: Document, most: int) -> str | Sentence:
    """Return the predicted medians and 5-95 % ranges of at most ``most`` main parameters (such as A
    and E) as text.
    """
    given = before.get("parameters") or {}
    order = [
        key
        for key in ("A", "E", "P", "Pa", *_single("positive"), *_single("negative"))
        if given.get(key) is not None
    ]
    parts = [
        quantiles(symbol(key), predicted[key])
        for key in [key for key in order if isinstance(predicted.get(key), Mapping)][:most]
    ]
    return say("chart.line", parts=parts, unit=unit_text(before.get("unit"))) if parts else ""


def quantiles(name: str, one: Document) -> Sentence:
    """Return as text the name of a parameter with its predicted median and 5-95 % range, which
    ``one`` contains.
    """
    return say(
        "chart.quantiles",
        symbol=name,
        median=number(one.get("median")),
        p05=number(one.get("p05")),
        p95=number(one.get("p95")),
    )


def _one_line(text: str, most: int) -> str:
    line = " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
    return line if len(line) <= most else f"{line[: most - 1]}…"


# --- numbers of a document
# --------------------------------------------------------------------------------------------------


def _number(value: object) -> float:
    return float(value) if isinstance(value, int | float) else math.nan


def numbers(values: Sequence[object] | None) -> list[float]:
    """Return the numbers in a list of a JSON document; null becomes NaN, a gap in the curve."""
    return [_number(value) for value in values or []]


def _any_known(values: Sequence[float]) -> bool:
    return any(math.isfinite(value) for value in values)
