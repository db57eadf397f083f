"""Print a page as PDF with typst. It is the same page as the HTML, on A4.

There is no separate report: the PDF is made from the page's markup, which is well-formed XML with
the few elements and classes in ``templates/style.css``. `pdf_of_page` reads the markup into a tree
and gives it to ``templates/page.typ`` as JSON, so that no text of a document can become typst code.

The file is PDF/A-2b and PDF/UA-1; typst refuses to write a file that breaks one of them. The file
has the date of the test, not of today, so that the same page always gives the same bytes.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, Final
from xml.etree import ElementTree as ET

from compwright.foundations.extras import need
from compwright.reporting.page import template_text

_INLINE: Final = frozenset({"a", "b", "code", "small", "span"})
_HEADINGS: Final = {"h1": 1, "h2": 2, "h3": 3}
_SPACE: Final = re.compile(r"[ \t\r\n]+")
#: PDF/A wants a date. Where no test states one, the file carries the first that PDF readers know.
_NO_DATE: Final = "1970-01-01"
#: A long word may break behind one of its own marks, or after so many letters (of code: later).
_LONG_WORD: Final = re.compile(r"\S{25,}")
_BREAKS: Final = {
    length: re.compile(rf"(?:[/_\\.,;:=\])}}-]|\S{{{length}}})(?=\S)") for length in (16, 64)
}
_NO_WIDTH: Final = "\u200b"
#: A column of words as long as this shares the width of the page; others take what they need.
_LONG_COLUMN: Final = 26
_LONGEST_COLUMN: Final = 90
#: A cell with more letters may break over two pages.
_LONGEST_CELL: Final = 1000
#: Why some letters are printed by their codes, with those codes.
_NOTE: Final = (
    "The font of this PDF does not hold every letter of this report. Missing letters are printed by"
    " their Unicode number, for example {code}. The HTML report shows them."
)
_SVG: Final = "http://www.w3.org/2000/svg"


def require_pdf() -> Any:
    """Return the library typst, which makes PDF pages. Raises UsageError when the pdf extra is
    missing.
    """
    for module in ("jinja2", "matplotlib"):
        need(module, "pdf", "PDF reports")
    return need("typst", "pdf", "PDF reports")


def pdf_of_page(page: bytes) -> bytes:
    """Return a page of `render_page` as PDF. Raises UsageError when the pdf extra is missing."""
    typst = require_pdf()
    letters = _Letters()
    root = ET.fromstring(page)  # noqa: S314 - a page of our own
    (body,) = root.iterfind("body")
    ids = {str(node.get("href", ""))[1:] for node in body.iter("a")}
    tree = _Tree(letters, ids & {str(node.get("id")) for node in body.iter()})
    children = tree.children(body)
    if letters.missing:
        children.insert(0, _note(sorted(letters.missing)))
    year, month, day = (body.get("data-date") or _NO_DATE).split("-")
    content = {
        "lang": root.get("lang", "en"),
        "title": letters.shown(root.findtext("head/title") or ""),
        "page": body.get("data-page", "Page"),
        "of": body.get("data-of", "of"),
        "footer": letters.shown(body.get("data-footer", "")),
        "date": {"year": int(year), "month": int(month), "day": int(day)},
        "children": children,
    }
    written: bytes = typst.compile(
        template_text("page.typ").encode(),
        format="pdf",
        font_paths=[str(_font_folder())],
        ignore_system_fonts=True,
        sys_inputs={"page": json.dumps(content)},
        pdf_standards=["a-2b", "ua-1"],
        timestamp=0,
    )
    return written


class _Letters:
    """The characters that the font of the PDF has, and the characters of the page that this font
    lacks (``missing``).
    """

    def __init__(self) -> None:
        self.missing: set[str] = set()
        self._known = _known_letters()

    def shown(self, text: str) -> str:
        """Return ``text`` with each white space as one blank, and each character that the font
        lacks replaced by its code.
        """
        line = _SPACE.sub(" ", text)
        unknown = {letter for letter in line if ord(letter) not in self._known}
        self.missing |= unknown
        for letter in unknown:
            line = line.replace(letter, _code(letter))
        return line


def _known_letters() -> frozenset[int]:
    """Return the code points in DejaVu Sans, the font of every page and figure."""
    font = need("matplotlib.ft2font").FT2Font(str(_font_folder() / "DejaVuSans.ttf"))
    return frozenset(font.get_charmap()) - frozenset(range(0xE000, 0xF900))


def _font_folder() -> Path:
    """Return the folder of the fonts, which belong to matplotlib."""
    return Path(need("matplotlib").get_data_path()) / "fonts" / "ttf"


def _code(letter: str) -> str:
    return f"[U+{ord(letter):04X}]"


def _note(missing: list[str]) -> dict[str, Any]:
    return _made("p", [_NOTE.format(code=_code(missing[0]))])


def _made(tag: str, children: list[Any], **more: Any) -> dict[str, Any]:
    return {"tag": tag, "class": [], "id": None, "href": None, "children": children, **more}


class _Tree:
    """Converts the HTML of a page into nested lists for typst. ``ids``: targets of its links."""

    def __init__(self, letters: _Letters, ids: set[str]) -> None:
        self._letters = letters
        self._ids = ids
        self._level = 0

    def children(self, element: ET.Element) -> list[Any]:
        """Return the nodes inside an element: texts, and elements as mappings."""
        breaks = _BREAKS[64 if element.tag == "code" else 16]
        parts: list[Any] = [self._text(element.text, breaks)]
        for child in element:
            if not _left_out(child):
                parts.append(self._node(child))
            parts.append(self._text(child.tail, breaks))
        return _trimmed(parts)

    def _text(self, text: str | None, breaks: re.Pattern[str]) -> str:
        line = self._letters.shown(text or "")
        return _LONG_WORD.sub(lambda word: breaks.sub(_with_break, word[0]), line)

    def _node(self, element: ET.Element) -> dict[str, Any]:
        if element.tag == "svg":
            return self._picture(element)
        if element.tag == "img":
            return self._logo(element)
        href = element.get("href", "")
        node = _made(
            element.tag,
            [],
            id=element.get("id") if element.get("id") in self._ids else None,
            href=href[1:] if href.startswith("#") and href[1:] in self._ids else None,
        )
        node["class"] = element.get("class", "").split()
        if element.tag in _HEADINGS:
            self._level = min(_HEADINGS[element.tag], self._level + 1)
            node["level"] = self._level
        if element.tag == "table":
            return {**node, **self._table(element)}
        children = self.children(element)
        if "badge" in node["class"]:
            children = list(map(_unbroken, children))
        return {**node, "children": children}

    def _table(self, element: ET.Element) -> dict[str, Any]:
        head = [self._row(row) for row in element.iterfind("thead/tr")]
        rows = [self._row(row) for row in element.iterfind("tbody/tr")]
        narrow = "narrow" in element.get("class", "")
        return {"head": head, "rows": rows, "columns": _columns([*head, *rows], narrow=narrow)}

    def _row(self, row: ET.Element) -> list[dict[str, Any]]:
        return [self._cell(cell, marked="open-row" in row.get("class", "")) for cell in row]

    def _cell(self, cell: ET.Element, *, marked: bool) -> dict[str, Any]:
        children = self.children(cell)
        names = cell.get("class", "").split()
        length = sum(map(len, _texts(children)))
        if cell.tag == "td" and set(names) & {"n", "range"} and length < _LONG_COLUMN:
            children = list(map(_unbroken, children))
        more = {
            "span": int(cell.get("colspan", "1")),
            "marked": marked,
            "whole": length < _LONGEST_CELL,
        }
        return {**_made(cell.tag, children, **more), "class": names}

    def _picture(self, element: ET.Element) -> dict[str, Any]:
        element.set("xmlns", _SVG)
        element.set("font-family", "DejaVu Sans")
        for node in element.iter():
            if node.text and node.text.strip():
                node.text = self._letters.shown(node.text)
        element.tail = None
        drawn = ET.tostring(element, encoding="unicode")
        return _made("svg", [], svg=drawn, alt=element.get("aria-label", ""))

    def _logo(self, element: ET.Element) -> dict[str, Any]:
        picture = ET.Element("svg", {"xmlns": _SVG, "viewBox": "0 0 450 220"})
        size = {"width": "450", "height": "220", "preserveAspectRatio": "xMaxYMin meet"}
        ET.SubElement(picture, "image", {**size, "href": element.get("src", "")})
        node = self._picture(picture)
        return {**node, "tag": "logo", "children": [{**node, "alt": element.get("alt", "")}]}


def _left_out(element: ET.Element) -> bool:
    """Return whether an element is not printed: navigation links, and collapsed details."""
    return element.tag in {"nav", "style"} or (
        element.tag == "details" and element.get("open") is None
    )


def _unbroken(child: Any) -> Any:
    """Return a text or element whose spaces are replaced by no-break spaces, so that its line is
    not broken in the PDF.
    """
    if isinstance(child, str):
        return child.replace(" ", "\u00a0")
    return {**child, "children": list(map(_unbroken, child["children"]))}


def _with_break(found: re.Match[str]) -> str:
    return found[0] + _NO_WIDTH


def _trimmed(parts: list[Any]) -> list[Any]:
    """Return text and elements without the white space next to blocks and at the ends."""

    def inline(place: int) -> bool:
        if not 0 <= place < len(parts):
            return False
        part = parts[place]
        return bool(part) if isinstance(part, str) else part["tag"] in _INLINE

    kept = []
    for place, part in enumerate(parts):
        if not isinstance(part, str):
            kept.append(part)
            continue
        text = part if inline(place - 1) else part.lstrip(" ")
        text = text if inline(place + 1) else text.rstrip(" ")
        if text:
            kept.append(text)
    return kept


def _columns(rows: list[list[dict[str, Any]]], *, narrow: bool) -> list[dict[str, int]]:
    """Return, for each column, how its width is set: by its ``share`` of the table, by a number of
    ``letters``, or automatically. ``narrow``: the table has the class ``narrow``, so that no column
    gets a share.
    """
    shares: list[int] = []
    letters: list[int] = []
    for row in rows:
        place = 0
        for cell in row:
            missing = [0] * (place + cell["span"] - len(shares))
            shares, letters = shares + missing, letters + missing
            if cell["span"] == 1:
                text = "".join(_texts(cell["children"]))
                longest = max(map(len, re.split("[ \u200b]", text)), default=0)
                if {"pen", "bar"} & set(cell["class"]):
                    shares[place] = _LONG_COLUMN  # room to write or to draw
                elif {"n", "range"} & set(cell["class"]) and len(text) < _LONG_COLUMN:
                    lines = 2 if cell["tag"] == "th" else 1
                    letters[place] = max(letters[place], longest, len(text) // lines)
                else:
                    needed = max(min(len(text), _LONGEST_COLUMN), int(1.4 * longest))
                    shares[place] = max(shares[place], needed)
            place += cell["span"]
    return [
        {"share": share}
        if share >= _LONG_COLUMN and not narrow
        else {"letters": count}
        if count and not share
        else {}
        for share, count in zip(shares, letters, strict=True)
    ]


def _texts(children: Iterable[Any]) -> Iterator[str]:
    for child in children:
        if isinstance(child, str):
            yield child
        else:
            yield from _texts(child["children"])
