"""The parts of a line in a measurement file with their meaning, such as key, row or remark.

A reader returns the spans of each line. The meaning of a part that no span covers is unknown.
`redaction` decides from the spans what it keeps and what it replaces, so the sections and keys of a
form need not be listed a second time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

#: What a part of a line, or a value of an element, is: of the form itself, or free text; a value
#: that the form knows; somebody's.
Meaning = Literal[
    "key",
    "comment",
    "remark",
    "row",
    "cell",
    "numbers",
    "quantity",
    "keywords",
    "result",
    "feature",
    "date",
    "axis",
    "axis in words",
    "plane",
    "view",
    "sense",
    "product",
    "version",
    "release",
    "form",
    "machine",
    "serial number",
    "operator",
    "instrument",
    "program",
    "place",
    "title",
    "section",
    "column",
    "other cell",
    "name",
]


@dataclass(frozen=True, slots=True)
class TextSpan:
    """A part of a line with its meaning: characters from ``start`` to before ``end``."""

    start: int
    end: int
    meaning: Meaning


#: The spans of one line, in their order.
Spans = Sequence[TextSpan]
#: The lines of a file to the spans of each.
SpansOf = Callable[[Sequence[str]], Iterator[Spans]]


def by_key(keys: Mapping[Meaning, Sequence[str]]) -> Mapping[str, Meaning]:
    """Return a mapping from each key to its meaning. ``keys``: the keys of each meaning."""
    return {key: meaning for meaning, names in keys.items() for key in names}


def whole(line: str, meaning: Meaning) -> Spans:
    """Return one span with the given meaning that covers the whole line."""
    return (TextSpan(0, len(line), meaning),)


@dataclass(frozen=True, slots=True)
class Elements:
    """The meaning of the texts and of the attributes in an XML file, by the name of the element or
    attribute.

    ``tags``: the meaning of the text of an element, by the element's name. ``attributes``: the
    meaning of an attribute, by its name in capitals. ``names``: the meaning of the attribute NAME
    in elements that are not results.
    """

    tags: Mapping[str, Meaning]
    attributes: Mapping[str, Meaning]
    names: Mapping[str, Meaning]


#: What a form consists of, as its reader understands it.
Grammar = SpansOf | Elements
