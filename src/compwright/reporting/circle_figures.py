"""Figures of circular tests: magnified path (ISO 230-4, figures 4 and 5) and ranked causes.

A result is an entry ``kind: circular`` of the evaluation document: deviations in µm, angles in deg,
radius in mm. The two directions differ by line, width and lightness, so that a print without
colours can be read. This module evaluates nothing: it only draws paths and zones around the centre
that the document gives.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

from compwright.foundations.errors import Fault, UsageError
from compwright.reporting.causes import CircleCause, ranked_causes
from compwright.reporting.charts import Document
from compwright.reporting.panels import known_format, new_figure, render, style
from compwright.reporting.polar_words import (
    centre_text,
    grouped,
    run_text,
    setting,
    signed,
    title,
    zone_text,
)
from compwright.words.sentences import Language, number_text, say

#: Height of the picture of one test, inches.
TEST_HEIGHT: Final = 4.55

_MICROMETRES: Final = 1000.0  # per mm
#: The largest deviation is drawn at most this part of the radius long.
_MOST_DRAWN: Final = 0.32
#: Far from nominal (so many times the form) the form could not be seen: the path is then drawn
#: about its mean circle.
_FAR: Final = 4.0
_MOST_CAUSES: Final = 9
_FEWEST_ROWS: Final = 7
_INK: Final = "#222222"
_FAINT: Final = "#9a9a9a"
_TURN: Final = 360.0
_RING_LABELS: Final = math.radians(117.0)  # away from the axes and from 45°, where starts often lie


@dataclass(frozen=True, slots=True)
class _Way:
    """The line style of the runs in one direction: thick for ccw, thin and broken for cw."""

    key: str
    line: Any
    width: float
    colour: str


_WAYS: Final = (_Way("ccw", "-", 1.3, "#0b4a82"), _Way("cw", (0, (4.5, 1.4)), 0.9, "#c2590c"))
_ZONE: Final = "#3d7a3d"
_ZONE_STEPS: Final = 360


@dataclass(frozen=True, slots=True)
class Path:
    """One run to be drawn: ``angles`` (rad) and ``radial`` deviations from nominal (µm)."""

    way: _Way
    angles: tuple[float, ...]
    radial: tuple[float, ...]
    evaluated: bool


def polar_figure(
    result: Document,
    *,
    format: str = "svg",  # noqa: A002 - the plotting library's own word
    language: Language = "en",
) -> bytes:
    """Return the figure of a circular test: the magnified path, and the causes if diagnosed.

    ``result`` needs ``runs`` (``direction``, ``number``, ``angles`` deg, ``deviations`` µm as
    measured), ``axes``, ``nominal_radius``, ``arc``, ``calibrated``, ``centre``,
    ``mean_radius_deviation``, ``parameters``, ``minimum_zone``, and ``diagnosis`` or null. If it
    has ``fitted`` (like ``runs``), this is drawn over the runs. Raises UsageError for an unknown
    format, if the result has no runs, and if the extra ``report`` is not installed.
    """
    kind = known_format(format)
    if not result.get("runs"):
        raise UsageError(
            Fault(
                message="there is no circular test to plot",
                expected="the angles and deviations of a circular test",
                hint="give a circular test with samples",
            )
        )
    with style():
        figure = new_figure(TEST_HEIGHT)
        draw_test(figure, result, language)
        return render(figure, kind)


def draw_test(figure: Any, result: Document, language: Language = "en") -> None:
    """Draw a circular test: path and legend on the left, ranked causes on the right."""
    causes = [cause for cause in ranked_causes(result) if cause.shown][:_MOST_CAUSES]
    grid = figure.add_gridspec(1, 2 if causes else 1, width_ratios=(1.5, 1.0) if causes else None)
    figure.suptitle(
        title(result).text(language), x=0.012, ha="left", fontsize=8.5, fontweight="bold"
    )
    panel = figure.add_subplot(grid[0, 0])
    draw_path(panel, result, language)
    if causes:
        draw_causes(figure.add_subplot(grid[0, 1]), causes, language)
    handles, labels = panel.get_legend_handles_labels()
    figure.legend(
        handles, labels, loc="outside lower left", ncols=2, fontsize=7.0, handlelength=3.6
    )


# --- the path
# --------------------------------------------------------------------------------------------------


def paths_of(result: Document, centre: tuple[float, float], runs: Sequence[Document]) -> list[Path]:
    """Return the runs as paths around ``centre`` (µm). Of each direction, the first path is the run
    that was evaluated.

    A bar measures from its set-up centre, but the commanded angle is an angle around the programmed
    centre. Therefore each sample is drawn from the set-up centre in the direction of its commanded
    point, as in the evaluation.
    """
    radius = float(result["nominal_radius"])
    x, y = (coordinate / _MICROMETRES for coordinate in centre)
    paths = []
    for way in _WAYS:
        of_way = sorted(
            (run for run in runs if run["direction"] == way.key),
            key=lambda run: int(run["number"]),
        )
        for order, run in enumerate(of_way):
            angles = tuple(math.radians(angle) for angle in run["angles"])
            radial = tuple(
                _MICROMETRES
                * (_distance(angle, radius, radius + deviation / _MICROMETRES, (x, y)) - radius)
                for angle, deviation in zip(angles, run["deviations"], strict=True)
            )
            paths.append(Path(way, angles, radial, evaluated=order == 0))
    return paths


def _distance(angle: float, radius: float, length: float, centre: tuple[float, float]) -> float:
    """Return the distance (mm) from the centre of the figure to a measured point, which lies at
    ``length`` from the set-up centre, towards the commanded point at ``angle`` and ``radius`` about
    ``centre``.
    """
    towards = (centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle))
    scale = length / math.hypot(*towards)
    return math.hypot(scale * towards[0] - centre[0], scale * towards[1] - centre[1])


def magnification_of(largest: float, radius: float) -> float:
    """Return a round magnification, such as 200, for deviations up to ``largest`` µm."""
    most = (
        _MOST_DRAWN * radius * _MICROMETRES / max(largest, 0.1)
    )  # 0.1 µm: finer than an instrument resolves
    power = 10.0 ** math.floor(math.log10(most))
    return power * max(step for step in (1.0, 2.0, 5.0) if step * power <= most * (1.0 + 1e-9))


def picture_centre(result: Document) -> tuple[str, tuple[float, float]]:
    """Return name and position (µm) of the figure's centre: that of the least-squares circle."""
    centres = result.get("centre") or {}
    for name in ("common", "ccw", "cw"):
        if centres.get(name) is not None:
            return name, (float(centres[name][0]), float(centres[name][1]))
    return "set-up", (0.0, 0.0)


def draw_path(panel: Any, result: Document, language: Language = "en") -> None:
    """Draw the figure of a circular test: the magnified runs with their start points, the nominal
    circle, the minimum zone and the machine axes.
    """
    name, centre = picture_centre(result)
    paths = paths_of(result, centre, result["runs"])
    radius = float(result["nominal_radius"])
    values = [value for path in paths for value in path.radial]
    base = _base(result, values)
    most, least = max(values) - base, min(values) - base
    magnification = magnification_of(max(most, -least), radius)
    place = _Place(radius, magnification / _MICROMETRES, base)
    panel.set_aspect("equal")
    panel.axis("off")
    _rings(panel, place, most, least, language)
    reach = 1.1 * (radius + place.scale * max(most, 0.0))
    if base:
        words = say("circle.least_squares", base=signed(base)).text(language)
        panel.plot(
            *place.circle(base),
            color="#555555",
            linewidth=0.9,
            linestyle=(0, (7, 2, 1, 2, 1, 2)),
            label=words,
        )
    if abs(base) * place.scale <= _MOST_DRAWN * radius:
        panel.plot(
            *place.circle(0.0),
            color="#555555",
            linewidth=0.9,
            linestyle=(0, (7, 2, 1, 2)),
            label=say("circle.nominal").text(language),
        )
        reach = max(reach, 1.1 * (radius - place.scale * base))
    _axes(panel, result, reach)
    _zones(panel, result, centre, place, language)
    for path in paths:
        _run(panel, path, place, result, language)
    label: str | None = say("circle.fit").text(language)
    for path in paths_of(result, centre, result.get("fitted") or ()):
        if path.evaluated:
            panel.plot(
                *place(path.angles, path.radial), color=_INK, linewidth=0.45, label=label, zorder=4
            )
            label = None
    panel.plot(
        [0.0],
        [0.0],
        marker="+",
        markersize=9,
        color=_INK,
        linestyle="none",
        label=centre_text(name, centre, result).text(language),
    )
    panel.set_title(
        say("circle.magnified", setting=setting(result), magnification=grouped(magnification)).text(
            language
        ),
        fontsize=7.5,
    )
    panel.set_xlim(-1.1 * reach, 1.1 * reach)
    panel.set_ylim(-1.1 * reach, 1.1 * reach)


@dataclass(frozen=True, slots=True)
class _Place:
    """Converts angles (rad) and radial deviations (µm) to coordinates. The deviation ``base`` is
    drawn at the radius ``radius``.
    """

    radius: float
    scale: float
    base: float

    def __call__(
        self, angles: Sequence[float], radial: Sequence[float]
    ) -> tuple[list[float], list[float]]:
        lengths = [self.radius + self.scale * (value - self.base) for value in radial]
        return (
            [length * math.cos(angle) for length, angle in zip(lengths, angles, strict=True)],
            [length * math.sin(angle) for length, angle in zip(lengths, angles, strict=True)],
        )

    def circle(self, radial: float) -> tuple[list[float], list[float]]:
        around = [math.radians(step) for step in range(361)]
        return self(around, [radial] * len(around))


def _base(result: Document, values: Sequence[float]) -> float:
    """Return the radial deviation (µm) that is drawn on the nominal circle: 0, or the mean
    deviation if it is far from 0.
    """
    means = result.get("mean_radius_deviation") or {}
    given = [result["parameters"].get("D"), means.get("ccw"), means.get("cw")]
    mean = float(next((value for value in given if value is not None), 0.0))
    near = abs(mean) <= _FAR * max(max(values) - min(values), 0.1)
    return 0.0 if near and result["calibrated"] else mean


def _rings(panel: Any, place: _Place, most: float, least: float, language: Language) -> None:
    """Draw faint circles at round deviations between ``least`` and ``most`` (µm), with the values
    written next to the second axis.
    """
    step = _round_step(max(most, -least, 0.05))
    box = {"boxstyle": "square,pad=0.12", "facecolor": "white", "edgecolor": "none", "alpha": 0.8}
    for count in range(
        math.floor(least / step + 0.2), math.floor(most / step + 0.8) + 1
    ):  # a ring a little beyond helps to read
        if count == 0:
            continue
        radial = place.base + count * step
        panel.plot(*place.circle(radial), color="#d9d9d9", linewidth=0.5, zorder=0.5)
        (x,), (y,) = place([_RING_LABELS], [radial])
        words = number_text(count * step, "+.3g", language).replace("-", "−")
        panel.text(
            x, y, words, fontsize=6.0, color="#666666", ha="center", va="center", zorder=6, bbox=box
        )


def _round_step(largest: float) -> float:
    """Return the distance between faint circles in the figure, a round deviation (1, 2 or 5 times
    10^n) that gives one to three circles.
    """
    power = 10.0 ** math.floor(math.log10(largest / 1.2))
    return power * max(
        step for step in (1.0, 2.0, 5.0) if step * power <= largest / 1.2 * (1.0 + 1e-9)
    )


def _axes(panel: Any, result: Document, reach: float) -> None:
    """Draw both machine axes through the centre, with their names at the positive ends. ``reach``:
    their length from the centre, in the figure's units.
    """
    first, second = result["axes"]
    arrow = {
        "arrowstyle": "-|>",
        "color": _FAINT,
        "linewidth": 0.6,
        "mutation_scale": 7,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    for end, words in (((reach, 0.0), first), ((0.0, reach), second)):
        panel.annotate("", xy=end, xytext=(-end[0], -end[1]), arrowprops=arrow, zorder=0.6)
        panel.text(
            end[0] * 1.05, end[1] * 1.05, f"+{words}", ha="center", va="center", fontsize=8.0
        )


def _zones(
    panel: Any,
    result: Document,
    centre: tuple[float, float],
    place: _Place,
    language: Language,
) -> None:
    """Draw the circles of the minimum zone: one pair for both directions together, or a pair for
    each direction.
    """
    zones, values = result.get("minimum_zone") or {}, result["parameters"]
    both = "both" in zones and values.get("G_bidirectional") is not None
    arc = result["arc"]
    around = [
        math.radians(arc["start"] + arc["extent"] * step / _ZONE_STEPS)
        for step in range(_ZONE_STEPS + 1)
    ]
    for key in ("both",) if both else [way.key for way in _WAYS if way.key in zones]:
        zone = zones[key]
        dx, dy = zone["centre"][0] - centre[0], zone["centre"][1] - centre[1]
        line = (0, (1.2, 1.4)) if key != "cw" else (0, (3, 1.2, 1, 1.2))
        words = zone_text(key, values).text(language)
        for limit, label in ((zone["inner"], words), (zone["outer"], None)):
            radial = [limit + dx * math.cos(angle) + dy * math.sin(angle) for angle in around]
            panel.plot(
                *place(around, radial), color=_ZONE, linewidth=0.8, linestyle=line, label=label
            )


def _run(panel: Any, path: Path, place: _Place, result: Document, language: Language) -> None:
    """Draw one run, with a star at its start and an arrow in the direction of motion. Runs that
    were not evaluated are drawn pale.
    """
    x, y = place(path.angles, path.radial)
    closed = path.evaluated and result["arc"]["extent"] >= _TURN
    if closed:
        x, y = [*x, x[0]], [*y, y[0]]
    label = run_text(path.way.key, result).text(language) if path.evaluated else None
    width, strength = (path.way.width, 1.0) if path.evaluated else (0.5, 0.45)
    panel.plot(
        x,
        y,
        color=path.way.colour,
        linestyle=path.way.line,
        linewidth=width,
        alpha=strength,
        label=label,
        zorder=3,
    )
    if not path.evaluated:
        return
    filled = path.way.colour if path.way.key == "ccw" else "white"
    panel.plot(
        x[:1], y[:1], marker="*", markersize=8.5, markerfacecolor=filled,
        markeredgecolor=path.way.colour, markeredgewidth=0.8,
        linestyle="none", zorder=5, label=say("circle.start", sense=path.way.key).text(language),
    )  # fmt: skip
    _travel(panel, path, result, language)


def _travel(panel: Any, path: Path, result: Document, language: Language) -> None:
    """Draw an arrow inside the circle, near the start, in the direction of travel."""
    radius = float(result["nominal_radius"]) * (0.60 if path.way.key == "ccw" else 0.53)
    begin = path.angles[0]
    turn = math.radians(24.0) * (1.0 if path.way.key == "ccw" else -1.0)
    steps = [begin + turn * step / 12.0 for step in range(13)]
    x, y = (
        [radius * math.cos(angle) for angle in steps],
        [radius * math.sin(angle) for angle in steps],
    )
    panel.plot(x, y, color=path.way.colour, linestyle=path.way.line, linewidth=path.way.width)
    arrow = {
        "arrowstyle": "-|>",
        "color": path.way.colour,
        "linewidth": 0.8,
        "mutation_scale": 8,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    panel.annotate("", xy=(x[-1], y[-1]), xytext=(x[-2], y[-2]), arrowprops=arrow)
    panel.text(
        0.84 * x[6], 0.84 * y[6], say("circle.sense", sense=path.way.key).text(language),
        fontsize=6.5, color=path.way.colour, ha="center", va="center",
    )  # fmt: skip


# --- the causes
# --------------------------------------------------------------------------------------------------


def draw_causes(panel: Any, causes: Sequence[CircleCause], language: Language) -> None:
    """Draw the effects of causes as bars by falling size, with values and 95 % intervals."""
    reach = 1.75 * max(
        cause.effect for cause in causes
    )  # a whisker may be much longer than any effect: it ends there, with an arrow
    for row, cause in enumerate(causes):
        colour = "#5b7f9f" if cause.significant else "#c9d3dc"
        panel.barh(row, cause.effect, height=0.4, color=colour, edgecolor="#33536e", linewidth=0.5)
        low, high = cause.limits
        panel.plot([low, min(high, reach)], [row, row], color=_INK, linewidth=0.9)
        for end in (low, high):
            if end <= reach:
                panel.plot([end, end], [row - 0.12, row + 0.12], color=_INK, linewidth=0.9)
        if high > reach:
            panel.plot([reach], [row], marker=">", markersize=3.5, color=_INK, clip_on=False)
        panel.text(
            0.0,
            row - 0.43,
            say(
                "circle.cause",
                cause=cause.short_words,
                value=cause.value_text,
                unit=cause.unit_text,
            ).text(language),
            fontsize=7.0,
            va="center",
        )
        panel.text(reach * 1.03, row, f"{100.0 * cause.share:.0f} %", fontsize=7.0, va="center")
    panel.set_xlim(0.0, reach)
    panel.set_ylim(max(len(causes), _FEWEST_ROWS) - 0.6, -0.75)
    panel.set_yticks([])
    panel.locator_params(axis="x", nbins=5)
    panel.grid(visible=False, axis="y")
    panel.set_xlabel(say("circle.effects").text(language))
    panel.set_title(say("circle.shares").text(language), fontsize=7.5)
