"""Read YAML strictly: no duplicate keys, octal numbers or yes/no; each key has its line.

YAML 1.1 reads ``010`` as 8, ``1:30`` as 90 and ``no`` as false. Here they stay text. A schema that
expects a number then reports a fault with the line. The result is plain data only: dict, list, str,
int, float, bool, None.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import yaml
from yaml.composer import Composer

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.input_sizes import MOST_YAML_LEVELS, MOST_YAML_WORDS
from compwright.foundations.key_faults import KeyFault, KeyPath, key_path_text


@dataclass(frozen=True, slots=True)
class YamlDocument:
    """Plain data read from YAML, with the line of each key path, such as ("axes", "X")."""

    data: Any
    lines: dict[KeyPath, int] = field(default_factory=dict)

    def line(self, path: KeyPath) -> int:
        """Return the line number of a key path; if it is unknown, that of the nearest parent with a
        known line; else 0.
        """
        while path and path not in self.lines:
            path = path[:-1]
        return self.lines.get(path, 0)

    def place(self, path: KeyPath) -> str:
        """Return the place of a key path in messages, such as ``line 7: a.b[2]``."""
        line = self.line(path)
        name = key_path_text(path)
        return ", ".join(part for part in (f"line {line}" if line else "", name) if part)

    def faults(self, found: Iterable[KeyFault], file: str) -> list[Fault]:
        """Return key faults with their file and line, in the order of the lines."""
        ordered = sorted(found, key=lambda fault: self.line(fault.path))
        return [fault.in_file(file, self.place) for fault in ordered]


_LONE_SURROGATE = re.compile("[\ud800-\udfff]")  # cannot be written to any file or terminal
#: What libyaml reads but the parser in Python refuses: tabs, marks of byte order, a comment
#: directly behind > or |.
_READ_BY_LIBYAML_ONLY = re.compile("[\t\ufeff]|[>|]\\S*#")


class _PlainData:
    """For a YAML loader: plain data only, of limited depth and length."""

    file: str
    depth = 0
    words = 0

    def get_event(self) -> yaml.Event:
        """Return the next YAML event. Raises InputError for aliases, tags or deep nesting."""
        event: yaml.Event = super().get_event()  # type: ignore[misc]  # that of the parser
        self.depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(
            event, yaml.CollectionEndEvent
        )
        self.words += isinstance(event, yaml.ScalarEvent)
        expected = ""
        if isinstance(event, yaml.AliasEvent):
            message, hint = "aliases (*name) are not accepted", "write the value itself"
        elif getattr(event, "tag", None) is not None:
            message, hint = "tags (!name) are not accepted", "write the value without its tag"
        elif self.depth > MOST_YAML_LEVELS:  # composing recurses
            message, hint = "is nested too deeply", "write fewer levels"
            expected = f"at most {MOST_YAML_LEVELS} levels"
        elif self.words > MOST_YAML_WORDS:
            message, hint = "is too long", "remove keys"
            expected = f"at most {MOST_YAML_WORDS} keys and values"
        else:
            return event
        raise InputError(
            Fault(
                message=message,
                file=self.file,
                place=f"line {event.start_mark.line + 1}" if event.start_mark else "",
                expected=expected,
                hint=hint,
            )
        )


class _StrictLoader(_PlainData, yaml.SafeLoader):
    """A YAML loader for plain data only, with few forms of numbers and truth values."""

    def __init__(self, text: str, file: str) -> None:
        super().__init__(text)
        self.file = file


_StrictLoader.yaml_implicit_resolvers = {}
_SCALARS = (
    ("tag:yaml.org,2002:null", r"^(?:~|null|)$", ["~", "n", ""]),
    ("tag:yaml.org,2002:bool", r"^(?:true|false)$", list("tf")),
    ("tag:yaml.org,2002:int", r"^[-+]?(?:0|[1-9][0-9]*)$", list("-+0123456789")),
    (
        "tag:yaml.org,2002:float",
        r"^[-+]?(?:(?:0|[1-9][0-9]*)\.[0-9]*|\.[0-9]+|(?:0|[1-9][0-9]*)(?=[eE]))(?:[eE][-+]?[0-9]+)?$",
        list("-+.0123456789"),
    ),
)
for _tag, _pattern, _first in _SCALARS:
    _StrictLoader.add_implicit_resolver(_tag, re.compile(_pattern), _first)

if yaml.__with_libyaml__:

    class _FastLoader(_PlainData, Composer, yaml.CSafeLoader):
        """The same with the parser of libyaml, which needs a tenth of the time."""

        yaml_implicit_resolvers = _StrictLoader.yaml_implicit_resolvers

        def __init__(self, text: str, file: str) -> None:
            yaml.CSafeLoader.__init__(self, text)
            self.anchors: dict[str, yaml.Node] = {}
            self.file = file

        def get_event(self) -> yaml.Event:
            """Return the next YAML event. Raises YAMLError for a word with ``?``, which the parser
            in Python refuses between brackets.
            """
            event = super().get_event()
            if isinstance(event, yaml.ScalarEvent) and event.implicit[0] and "?" in event.value:
                raise yaml.YAMLError
            return event


def _top_node(text: str, file: str) -> yaml.Node | None:
    """Return the node of the document. Faults, and what only libyaml reads, are left to the parser
    in Python: the same text is read, or refused with the same words, on every computer.
    """
    if yaml.__with_libyaml__ and not _READ_BY_LIBYAML_ONLY.search(text):
        with suppress(yaml.YAMLError, InputError, ValueError, OverflowError):
            return _FastLoader(text, file).get_single_node()
    return _StrictLoader(text, file).get_single_node()


class _YamlReader:
    def __init__(self, file: str) -> None:
        self.file = file
        self.lines: dict[KeyPath, int] = {}
        self.faults: list[Fault] = []
        self.loader = _StrictLoader("", file)

    def value(self, node: yaml.Node, path: KeyPath) -> Any:
        if isinstance(node, yaml.MappingNode):
            return self.mapping(node, path)
        if isinstance(node, yaml.SequenceNode):
            items = []
            for index, child in enumerate(node.value):
                self.lines[(*path, index)] = child.start_mark.line + 1
                items.append(self.value(child, (*path, index)))
            return items
        if _LONE_SURROGATE.search(node.value):
            self.fault(
                node,
                path,
                "contains an escape that is not a character (a lone surrogate)",
                "write the character itself instead of the escape",
            )
            return None
        try:
            return self.loader.construct_object(node, deep=True)
        except (yaml.YAMLError, ValueError, OverflowError) as error:
            found = str(error).split("\n", 1)[0]
            self.fault(node, path, "cannot be read as a value", "put it in quotes", found)
            return None

    def mapping(self, node: yaml.MappingNode, path: KeyPath) -> dict[str, Any]:
        result: dict[str, Any] = {}
        for key_node, child in node.value:
            if not isinstance(key_node, yaml.ScalarNode) or _LONE_SURROGATE.search(key_node.value):
                self.fault(key_node, path, "a key must be a single word", "rename this key")
                continue
            key = str(key_node.value)  # keys stay text: axis "1", address "0"
            here = (*path, key)
            if key in result:
                message = f"key given twice (first on line {self.lines[here]})"
                self.fault(key_node, here, message, "remove one of the two lines")
                continue
            self.lines[here] = key_node.start_mark.line + 1
            result[key] = self.value(child, here)
        return result

    def fault(
        self, node: yaml.Node, path: KeyPath, message: str, hint: str, found: str = ""
    ) -> None:
        place = f"line {node.start_mark.line + 1}"
        name = key_path_text(path)
        self.faults.append(
            Fault(
                message=message,
                file=self.file,
                place=f"{place}, {name}" if name else place,
                found=found,
                hint=hint,
            )
        )


def read_yaml(content: bytes, file: str) -> YamlDocument:
    """Read one YAML document from UTF-8 bytes (with or without BOM).

    Aliases, tags and several documents are refused: a small file must not grow when it is read, and
    the result must be plain data. Raises InputError with every fault: not UTF-8, not YAML (with
    line and column), a duplicate key.
    """
    document, faults = read_yaml_with_faults(content, file)
    if faults:
        raise InputError(*faults)
    return document


def read_yaml_with_faults(content: bytes, file: str) -> tuple[YamlDocument, tuple[Fault, ...]]:
    """Read YAML as `read_yaml` does, but do not raise faults of single keys: return them together
    with the data.

    A schema can then report its own faults together with these. If a key is given twice, its first
    value is used. A value that cannot be read is None. Raises InputError if there is no document at
    all.
    """
    text = _decoded(content, file)
    try:
        node = _top_node(text, file)
        if node is None:
            raise InputError(
                Fault(
                    message="the file is empty",
                    file=file,
                    expected="a YAML document",
                    hint="write its keys and values into it",
                )
            )
        reader = _YamlReader(file)
        data = reader.value(node, ())
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        tab = "'\\t'" in str(error.problem)
        raise InputError(
            Fault(
                message=f"the text is not valid YAML ({error.problem or error.context})",
                file=file,
                place=f"line {mark.line + 1}, column {mark.column + 1}" if mark else "",
                hint="replace each tab of the file by blanks"
                if tab
                else "correct this line; text with special characters needs quotes",
            )
        ) from error
    except yaml.YAMLError as error:
        raise InputError(
            Fault(
                message=f"the text is not valid YAML ({str(error).splitlines()[0]})",
                file=file,
                hint="correct the file; text with special characters needs quotes",
            )
        ) from error
    except (
        ValueError,
        OverflowError,
    ) as error:  # an escape such as "\UFFFFFFFF" beyond the last character of Unicode
        raise InputError(
            Fault(
                message="the text contains an escape sequence that is not a character",
                file=file,
                found=str(error),
                hint="write the character itself instead of the escape sequence",
            )
        ) from error
    return YamlDocument(data=data, lines=reader.lines), tuple(reader.faults)


def _decoded(content: bytes, file: str) -> str:
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(
            Fault(
                message="the file is not UTF-8 text",
                file=file,
                place=f"byte {error.start + 1}",
                expected="a YAML text file",
                hint="save the file as UTF-8",
            )
        ) from error
