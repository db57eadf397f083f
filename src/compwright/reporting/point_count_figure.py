"""A figure, as plain SVG, of a predicted parameter over the number of table points."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any, Final

from compwright.reporting.numbers import number, plain, position_unit, symbol, unit_text
from compwright.words.sentences import Language, Sentence, number_text, say

Document = Mapping[str, Any]

_WIDTH, _HEIGHT = 720.0, 230.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 52.0, 700.0, 14.0, 182.0
#: Numbers below the picture stay so far apart.
_APART: Final = 34.0
_INK: Final = "#0b4a82"
_OTHER: Final = "#c2590c"


def worth_block(predicted: Document, unit: object) -> dict[str, Any] | None:
    """Return the figure of a parameter over the number of table points, or None if it is not
    predicted.

    It shows ``points_worth`` of an axis of the prediction document.
    """
    sizes, limited = predicted.get("points_worth") or [], predicted.get("limited")
    if len(sizes) < 3 or not limited:
        return None
    name, small = symbol(limited["parameter"]), unit_text(unit)
    place = unit_text(position_unit(unit))
    words = [
        say(
            "worth.points",
            points=one["points"],
            spacing=plain(round(one["spacing"], 4)),
            place=place,
            symbol=name,
            median=number(one["median"]),
            p05=number(one["p05"]),
            p95=number(one["p95"]),
            unit=small,
        )
        for one in sizes
    ]
    marked = any(one["there"] and not one["written"] for one in sizes)
    there = any(one["there"] for one in sizes)
    return {
        "figure": WorthFigure(tuple(sizes), say("worth.quantity", symbol=name, unit=small)),
        "caption": say(
            "worth.caption", symbol=name, grid="ring" if marked else "on_it" if there else ""
        ),
        "words": words,
    }


@dataclass(frozen=True, slots=True)
class WorthFigure:
    """The figure of the predicted ``quantity`` over the number of table points."""

    sizes: Sequence[Document]
    quantity: Sentence

    def svg(self, language: Language) -> str:
        """Return the SVG picture, with its texts in the language."""
        described = say("worth.described", quantity=self.quantity)
        quantity, description, over = (
            escape(one.text(language)) for one in (self.quantity, described, say("worth.over"))
        )
        return _picture(self.sizes, quantity, description, over, language)


def _picture(
    sizes: Sequence[Document], quantity: str, described: str, over: str, language: Language
) -> str:
    first, last = (math.log(sizes[index]["points"]) for index in (0, -1))
    largest = max(one["p95"] for one in sizes)
    step = _step(largest)
    top = step * math.ceil(largest / step) or step

    def x(one: Document) -> float:
        share = (math.log(one["points"]) - first) / (last - first) if last > first else 0.5
        return round(_LEFT + 12.0 + share * (_RIGHT - _LEFT - 24.0), 1)

    def y(value: float) -> float:
        return round(float(_BOTTOM - value / top * (_BOTTOM - _TOP)), 1)

    band = [(x(one), y(one["p95"])) for one in sizes]
    band += [(x(one), y(one["p05"])) for one in reversed(sizes)]
    line = [(x(one), y(one["median"])) for one in sizes]
    middle = (_TOP + _BOTTOM) / 2
    return (
        f'<svg viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" role="img" font-size="11" fill="#222222"'
        f' aria-label="{described}">'
        + "".join(_grid(step, top, y, language))
        + f'<polygon points="{_points(band)}" fill="{_INK}" fill-opacity="0.14"></polygon>'
        f'<polyline points="{_points(line)}" fill="none" stroke="{_INK}" stroke-width="1.6">'
        "</polyline>"
        + "".join(_mark(one, x(one), y(one["median"])) for one in sizes)
        + "".join(_numbers(sizes, x))
        + f'<text x="{(_LEFT + _RIGHT) / 2:g}" y="{_HEIGHT - 8:g}" text-anchor="middle">'
        f"{over}</text>"
        f'<text x="14" y="{middle:g}" text-anchor="middle"'
        f' transform="rotate(-90 14 {middle:g})">{quantity}</text></svg>'
    )


def _grid(step: float, top: float, y: Callable[[float], float], language: Language) -> list[str]:
    lines = []
    for index in range(round(top / step) + 1):
        value = index * step
        lines.append(
            f'<line x1="{_LEFT:g}" x2="{_RIGHT:g}" y1="{y(value)}" y2="{y(value)}"'
            f' stroke="{"#777777" if index == 0 else "#e3e3e3"}" stroke-width="0.8"></line>'
            f'<text x="{_LEFT - 6:g}" y="{y(value) + 4:g}" text-anchor="end">'
            f"{number_text(value, 'g', language)}</text>"
        )
    return lines


def _mark(one: Document, x: float, y: float) -> str:
    radius, fill, stroke = 3.0, "#ffffff", _INK
    if one["written"]:
        radius, fill = 5.5, _INK
    elif one["there"]:
        radius, stroke = 5.5, _OTHER
    return (
        f'<circle cx="{x}" cy="{y}" r="{radius}" fill="{fill}" stroke="{stroke}"'
        ' stroke-width="1.8"></circle>'
    )


def _numbers(sizes: Sequence[Document], x: Callable[[Document], float]) -> list[str]:
    """Return the numbers of table points that are printed below the figure. Where two overlap, the
    number of a marked table is kept.
    """
    marked = [one for one in sizes if one["written"] or one["there"]]
    placed: list[float] = []
    texts = []
    for one in [*marked, *(one for one in sizes if one not in marked)]:
        if any(abs(x(one) - other) < _APART for other in placed):
            continue
        placed.append(x(one))
        weight = ' font-weight="bold"' if one["written"] else ""
        texts.append(
            f'<text x="{x(one)}" y="{_BOTTOM + 16:g}" text-anchor="middle"{weight}>'
            f"{one['points']}</text>"
        )
    return texts


def _step(largest: float) -> float:
    """Return a round step that divides a range up to ``largest`` into about five parts."""
    if not largest > 0.0:
        return 1.0
    size = 10.0 ** math.floor(math.log10(largest / 4.0))
    return next((size * one for one in (1.0, 2.0, 5.0) if size * one >= largest / 5.0), 10.0 * size)


def _points(places: Sequence[tuple[float, float]]) -> str:
    return " ".join(f"{x},{y}" for x, y in places)
