"""A ballbar's XML without private data: known elements and attributes stay, with values of the
expected kind; all other elements, remarks and instructions are left out.
"""

from __future__ import annotations

from xml.sax.saxutils import escape, quoteattr

from compwright.foundations.redaction import Cuts
from compwright.instruments.redaction.cutting import kept_or_cut
from compwright.instruments.safe_xml import Element, read_xml
from compwright.instruments.spans import Elements, Meaning


def redacted_xml(content: bytes, file: str, known: Elements, cuts: Cuts) -> bytes:
    """Return an XML file without private data, in UTF-8.

    Raises InputError for invalid XML.
    """
    root = read_xml(content, file)
    lines = ['<?xml version="1.0" encoding="utf-8"?>', *_lines(root, 0, known, cuts), ""]
    return "\n".join(lines).encode()


def _lines(element: Element, depth: int, known: Elements, cuts: Cuts) -> list[str]:
    indent = "  " * depth
    start = "".join(
        f" {name}={quoteattr(kept_or_cut(value, meaning, cuts))}"
        for name, value in element.attributes.items()
        if (meaning := _meaning(element.tag, name, value, known, cuts)) is not None
    )
    text = escape(kept_or_cut(element.text, known.tags[element.tag], cuts))
    if not element.children:
        return [f"{indent}<{element.tag}{start}>{text}</{element.tag}>"]
    lines = [f"{indent}<{element.tag}{start}>{text}"]
    for child in element.children:
        if child.tag in known.tags:
            lines += _lines(child, depth + 1, known, cuts)
        else:
            _leave_out(child, cuts)
    return [*lines, f"{indent}</{element.tag}>"]


def _meaning(tag: str, name: str, value: str, known: Elements, cuts: Cuts) -> Meaning | None:
    """Return the meaning of an attribute; None for an unknown one, which is left out."""
    if name == "NAME":
        return known.names.get(tag, "result")
    meaning = known.attributes.get(name.upper())
    if meaning is None:
        cuts.remark(value, "attribute")
    return meaning


def _leave_out(element: Element, cuts: Cuts) -> None:
    cuts.removed.append(("element", element.tag))
    for text in (element.text, *element.attributes.values()):
        cuts.remark(text, "element")
    for child in element.children:
        _leave_out(child, cuts)
