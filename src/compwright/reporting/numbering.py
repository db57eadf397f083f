"""A small drawing of the numbered sections into which a control divides its table along an axis, as
text and as SVG.

The numbering in the card's document has these keys: ``unit``, ``reference``, ``sections``
(``number``, ``from``, ``to``, ascending), ``marks`` (``number``, ``name``), ``second`` (number of
the first section in the set for travel in -, or None) and ``words``. If there are many sections,
the drawing shows the first two, the last two and those next to the reference.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any, Final, NamedTuple

from compwright.words.sentences import Language, in_language, say

#: That many sections are all shown.
_ALL: Final = 8
_INK: Final = "#222222"
_SOFT: Final = "#6a6a6a"
#: Of the picture, in its own units: width, column of words, height of a row, width of a gap.
_WIDE: Final = 760
_LEFT: Final = 92
_ROW: Final = 18
_GAP: Final = 60


class _SectionCell(NamedTuple):
    """The texts of one drawn table section: its number, its two ends, its name, and its number in
    the second table (for travel in −).

    ``gap``: whether sections before this one are left out of the drawing.
    """

    number: str
    low: str
    high: str
    name: str
    second: str
    gap: bool


class _Edge(NamedTuple):
    """The edge between two drawn sections. ``zero``: it is at the reference position."""

    place: int
    position: str
    zero: bool


class _Drawing(NamedTuple):
    """The places of sections, edges and gaps in the drawing (characters or points)."""

    cells: list[tuple[int, _SectionCell]]
    edges: list[_Edge]
    gaps: list[int]


def numbering_text(numbering: Mapping[str, Any], language: Language = "en") -> list[str]:
    """Return the drawing as lines of text, for a font of fixed width."""
    cells = _cells(numbering)
    widest = max(len(text) for cell in cells for text in cell[:5]) + 3
    widest += widest % 2  # a middle has a column
    drawing = _laid_out(
        cells, _position(numbering["reference"]), 12 + widest // 2, widest, widest + 2
    )
    labels = {
        "name": say("numbering.parameter"),
        "number": say("numbering.number"),
        "second": say("numbering.travel_negative"),
        "line": "",
        "position": say("numbering.position"),
    }
    rows = {key: [*in_language(label, language).ljust(200)] for key, label in labels.items()}
    for middle, cell in drawing.cells:
        _put(rows["name"], middle, cell.name)
        _put(rows["number"], middle, cell.number)
        _put(rows["second"], middle, cell.second)
        _put(rows["line"], middle, "-" * (widest - 1))
    for edge in drawing.edges:
        _put(rows["line"], edge.place, "#" if edge.zero else "|")
        _put(rows["position"], edge.place, edge.position)
    for gap in drawing.gaps:
        _put(rows["line"], gap, "...")
    if numbering["second"] is None:
        del rows["second"]
    lines = ["".join(row).rstrip() for row in rows.values()]
    unit = in_language(numbering["unit"], language)
    return [*lines[:-1], f"{lines[-1]}  {unit}", f"# {say('numbering.mark').text(language)}"]


def numbering_svg(numbering: Mapping[str, Any], language: Language = "en") -> str:
    """Return the drawing as markup inside a page."""
    cells = _cells(numbering)
    gaps = sum(cell.gap for cell in cells)
    width = (_WIDE - _LEFT - 40 - gaps * _GAP) // len(cells)
    drawing = _laid_out(cells, _position(numbering["reference"]), _LEFT + 24, width, _GAP)
    second = numbering["second"] is not None
    line = (4 if second else 3) * _ROW
    heads = [say("numbering.parameter"), say("numbering.number")]
    heads += [say("numbering.travel_negative")] if second else []
    parts = [
        _words(4, row * _ROW, head.text(language), "start") for row, head in enumerate(heads, 1)
    ]
    position = say("numbering.position_unit", unit=numbering["unit"])
    parts.append(_words(4, line + 26, position.text(language), "start"))
    for middle, cell in drawing.cells:
        half = width // 2
        parts.append(_stroke(f"M{middle - half} {line}H{middle + half}", 1.4))
        parts.append(_words(middle, _ROW, cell.name, "middle", bold=True))
        parts.append(_words(middle, 2 * _ROW, cell.number, "middle", bold=bool(cell.name)))
        if second:
            parts.append(_words(middle, 3 * _ROW, cell.second, "middle"))
    zero = say("numbering.reference").text(language)
    for edge in drawing.edges:
        reach, stroke = (11, 3.2) if edge.zero else (6, 1.0)
        parts.append(_stroke(f"M{edge.place} {line - reach}V{line + reach}", stroke))
        parts.append(_words(edge.place, line + 26, edge.position, "middle", bold=edge.zero))
        if edge.zero:
            parts.append(_words(edge.place, line + 42, zero, "middle"))
    label = say("numbering.label").text(language)
    parts += [_words(gap, line + 4, "\u2026", "middle") for gap in drawing.gaps]
    return (
        f'<svg viewBox="0 0 {_WIDE} {line + 48}" role="img" aria-label="{escape(label)}"'
        ' font-family="sans-serif" font-size="12" fill="none">' + "".join(parts) + "</svg>"
    )


def _cells(numbering: Mapping[str, Any]) -> list[_SectionCell]:
    """Return the sections that are drawn: all of them if they are few, else two at each end of the
    table and those next to the reference.
    """
    sections: Sequence[Mapping[str, Any]] = numbering["sections"]
    names: dict[int, list[str]] = {}
    for mark in numbering["marks"]:
        names.setdefault(int(mark["number"]), []).append(str(mark["name"]))
    zero = _position(numbering["reference"])
    count, first = len(sections), int(sections[0]["number"])
    neighbours = [
        place
        for place, one in enumerate(sections)
        if zero in (_position(one["from"]), _position(one["to"]))
    ]
    shown = range(count) if count <= _ALL else sorted({0, 1, *neighbours, count - 2, count - 1})
    cells, before = [], -1
    for place in shown:
        one = sections[place]
        number = int(one["number"])
        second = "" if numbering["second"] is None else str(numbering["second"] + number - first)
        low, high = _position(one["from"]), _position(one["to"])
        name = " ".join(names.get(number, ()))
        cells.append(_SectionCell(str(number), low, high, name, second, place != before + 1))
        before = place
    return cells


def _laid_out(
    cells: Sequence[_SectionCell], zero: str, start: int, width: int, gap: int
) -> _Drawing:
    """Return the places of sections, edges and gaps in the drawing, in the units of ``width``,
    ``gap`` and ``start`` (where the first section begins). ``zero``: the position of the reference,
    as text.
    """
    drawing = _Drawing([], [_Edge(start, cells[0].low, cells[0].low == zero)], [])
    place = start
    for cell in cells:
        if cell.gap:
            drawing.gaps.append(place + gap // 2)
            place += gap
            drawing.edges.append(_Edge(place, cell.low, cell.low == zero))
        drawing.cells.append((place + width // 2, cell))
        place += width
        drawing.edges.append(_Edge(place, cell.high, cell.high == zero))
    return drawing


def _position(value: Any) -> str:
    return f"{float(value) + 0.0:.10g}"


def _put(row: list[str], middle: int, text: str) -> None:
    """Write a text into a row of characters, centred on the column ``middle``."""
    start = middle - len(text) // 2
    row[start : start + len(text)] = text


def _stroke(path: str, width: float) -> str:
    return f'<path d="{path}" stroke="{_INK}" stroke-width="{width}"/>'


def _words(x: int, y: int, text: str, anchor: str, *, bold: bool = False) -> str:
    if not text:
        return ""
    look = f'text-anchor="{anchor}" fill="{_SOFT if anchor == "start" else _INK}"'
    weight = ' font-weight="bold"' if bold else ""
    return f'<text x="{x}" y="{y}" {look}{weight}>{escape(text)}</text>'
