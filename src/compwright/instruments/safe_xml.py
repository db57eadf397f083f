"""Read the XML of a measurement file safely as a plain tree: no entities, no external files,
bounded size.

The parser is expat of the standard library. It stops at a document type declaration, before an
entity can be defined or an external file fetched.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Final
from xml.parsers import expat

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import MOST_ELEMENTS, MOST_LEVELS, XML, in_words

#: What the parser says of a document that ends before its root element does.
_CUT_SHORT: Final = frozenset(
    {
        expat.errors.XML_ERROR_NO_ELEMENTS,
        expat.errors.XML_ERROR_UNCLOSED_TOKEN,
        expat.errors.XML_ERROR_PARTIAL_CHAR,
        expat.errors.XML_ERROR_UNCLOSED_CDATA_SECTION,
    }
)


@dataclass(slots=True)
class Element:
    """An XML element: name, attributes, its own stripped text, children, and the line on which it
    starts.
    """

    tag: str
    attributes: dict[str, str]
    line: int
    text: str = ""
    children: list[Element] = field(default_factory=list)

    def all(self, *path: str) -> Iterator[Element]:
        """Yield every element at ``path`` below this element."""
        if not path:
            yield self
            return
        for child in self.children:
            if child.tag == path[0]:
                yield from child.all(*path[1:])

    def first(self, *path: str) -> Element | None:
        """Return the first element at ``path``, or None if there is none."""
        return next(self.all(*path), None)

    def anywhere(self, tag: str) -> Iterator[Element]:
        """Yield every element with this name below this element, at any depth."""
        for child in self.children:
            if child.tag == tag:
                yield child
            yield from child.anywhere(tag)


class _Refused(Exception):  # noqa: N818 - leaves the parser, never this module
    def __init__(self, message: str, expected: str) -> None:
        super().__init__(message)
        self.message, self.expected = message, expected


class _Builder:
    def __init__(self) -> None:
        self.parser = expat.ParserCreate()
        self.parser.buffer_text = True
        self.parser.StartDoctypeDeclHandler = self.document_type
        self.parser.StartElementHandler = self.start
        self.parser.EndElementHandler = self.end
        self.parser.CharacterDataHandler = self.characters
        self.root: Element | None = None
        self.open: list[tuple[Element, list[str]]] = []
        self.count = 0

    def document_type(self, *_: object) -> None:
        raise _Refused(
            "declares a document type (DOCTYPE), in which entities could grow without end",
            "XML without DOCTYPE",
        )

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        self.count += 1
        if self.count > MOST_ELEMENTS or len(self.open) >= MOST_LEVELS:
            raise _Refused(
                "has more elements than any measurement",
                f"{MOST_ELEMENTS} elements, {MOST_LEVELS} levels at most",
            )
        element = Element(tag, attributes, self.parser.CurrentLineNumber)
        if self.open:
            self.open[-1][0].children.append(element)
        else:
            self.root = element
        self.open.append((element, []))

    def end(self, _: str) -> None:
        element, text = self.open.pop()
        element.text = "".join(text).strip()

    def characters(self, text: str) -> None:
        self.open[-1][1].append(text)


def read_xml(content: bytes, file: str) -> Element:
    """Return the root element of ``content``.

    Raises InputError for XML that is cut short or broken (with line and column), for a document
    type declaration, for an unknown encoding, and for a file larger than any measurement.
    """
    if len(content) > XML.most_bytes:
        raise InputError(
            Fault(
                message="the file is too large",
                file=file,
                expected=f"at most {in_words(XML.most_bytes)}",
                found=in_words(len(content)),
                hint="give the measurement of one test per file",
            )
        )
    builder = _Builder()
    parser = builder.parser
    try:
        parser.Parse(content, True)  # noqa: FBT003 - the parser's own signature
    except _Refused as refused:
        place = f"line {parser.CurrentLineNumber}"
        raise InputError(
            Fault(
                message=f"the XML of the file is refused: it {refused.message}",
                file=file,
                place=place,
                expected=refused.expected,
                hint="export the file from the instrument again",
            )
        ) from refused
    except expat.ExpatError as error:
        place = f"line {error.lineno}, column {error.offset + 1}"
        reason = expat.ErrorString(error.code)
        raise InputError(
            Fault(
                message=(
                    f"the file is cut off: its XML ends too early ({reason})"
                    if reason in _CUT_SHORT
                    else f"the file is not whole XML ({reason})"
                ),
                file=file,
                place=place,
                expected=(
                    f"</{builder.open[-1][0].tag[:60]}>" if builder.open else "one XML document"
                ),
                hint="export the file from the instrument again",
            )
        ) from error
    except (
        ValueError,
        LookupError,
    ) as error:  # an encoding that Python knows as no single-byte one, or not at all
        raise InputError(
            Fault(
                message="the file is XML in an unknown encoding",
                file=file,
                place="line 1",
                expected="UTF-8 or UTF-16",
                found=str(error),
                hint="save the file as UTF-8",
            )
        ) from error
    if builder.root is None:
        raise InputError(
            Fault(
                message="the file contains no XML element",
                file=file,
                expected="an XML document",
                hint="export the file from the instrument again",
            )
        )
    return builder.root
