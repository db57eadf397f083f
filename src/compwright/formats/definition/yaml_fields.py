"""Walk a definition's data against a fixed set of keys: every fault is kept with its line, so
that all are told at once.

A reader that meets a fault notes it and returns a harmless value; the caller raises before that
value is used.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, TypeVar, cast, get_args

from compwright.formats.definition.extends import DefinitionText
from compwright.foundations.errors import Fault
from compwright.foundations.key_faults import KeyPath

Word = TypeVar("Word", bound=str)

_NAMES = {
    dict: "a mapping",
    list: "a list",
    str: "text",
    bool: "true or false",
    int: "a whole number",
    float: "a number",
}


def _found(value: object) -> str:
    if value is None:
        return "nothing"
    if isinstance(value, (dict, list)):
        return _NAMES[type(value)]
    return repr(value) if isinstance(value, str) else f"{value} ({_NAMES[type(value)]})"


@dataclass(frozen=True, slots=True)
class Node:
    """A place in the document, with the list to which faults go."""

    source: DefinitionText
    faults: list[Fault]
    path: KeyPath
    data: Any

    def fault(self, message: str, *, expected: str = "", found: str = "") -> None:
        """Note a fault at this place."""
        self.faults.append(self.source.fault(self.path, message, expected=expected, found=found))

    def child(self, part: str | int, data: object) -> Node:
        """Return the place one step further down."""
        return Node(self.source, self.faults, (*self.path, part), data)

    def entries(self) -> Iterator[tuple[str, Node]]:
        """Yield name and place of a mapping whose keys are free."""
        if not isinstance(self.data, dict):
            self.fault("has the wrong form", expected="a mapping", found=_found(self.data))
            return
        for name, data in self.data.items():
            yield name, self.child(name, data)

    def items(self) -> Iterator[Node]:
        """Yield the places of a list."""
        if not isinstance(self.data, list):
            self.fault("has the wrong form", expected="a list", found=_found(self.data))
            return
        for index, data in enumerate(self.data):
            yield self.child(index, data)

    def keys(self, *names: str, besides: Collection[str] = ()) -> dict[str, Node]:
        """Return the places of exactly these keys, and of those of ``besides`` that are there. A
        missing and an unknown key are faults.
        """
        data = self.data
        if isinstance(data, dict):
            names = (*names, *(name for name in besides if name in data))
        if not isinstance(data, dict):
            self.fault(
                "has the wrong form",
                expected=f"a mapping with the keys {', '.join(names)}",
                found=_found(data),
            )
            data = {}
        else:
            for name in data:
                if name not in names:
                    near = get_close_matches(name, names, 1)
                    self.child(name, None).fault(
                        "unknown key", expected=near[0] if near else f"one of {', '.join(names)}"
                    )
            for name in names:
                if name not in data:
                    self.child(name, None).fault("key is missing")
        return {
            name: self.child(name, data[name]) if name in data else _silent(self, name)
            for name in names
        }

    @property
    def is_null(self) -> bool:
        """Whether the value is an explicit null."""
        return self.data is None

    def text(self) -> str:
        """Return text."""
        if isinstance(self.data, str) and self.data:
            return self.data
        self.fault(
            "has the wrong type",
            expected="text (in quotation marks where it looks like a number)",
            found=_found(self.data),
        )
        return ""

    def optional_text(self) -> str | None:
        """Return text or None for an explicit null."""
        return None if self.is_null else self.text()

    def texts(self) -> tuple[str, ...]:
        """Return a list of texts."""
        return tuple(node.text() for node in self.items())

    def number(self) -> float:
        """Return a finite number."""
        if isinstance(self.data, (int, float)) and not isinstance(self.data, bool):
            value = float(self.data) if abs(self.data) < 10**15 else math.inf
            if math.isfinite(value):
                return value
        self.fault("has the wrong type", expected="a finite number", found=_found(self.data))
        return 0.0

    def integer(self, low: int, high: int) -> int:
        """Return a whole number from ``low`` to ``high``."""
        if (
            isinstance(self.data, int)
            and not isinstance(self.data, bool)
            and low <= self.data <= high
        ):
            return self.data
        self.fault(
            "has the wrong value",
            expected=f"a whole number from {low} to {high}",
            found=_found(self.data),
        )
        return low

    def one_of(self, words: Collection[str]) -> str:
        """Return one word of a closed list."""
        if isinstance(self.data, str) and self.data in words:
            return self.data
        self.fault(
            "is not known here", expected=f"one of {', '.join(words)}", found=_found(self.data)
        )
        return next(iter(words))

    def literal(self, kind: type[Word] | Any) -> Any:
        """Return one word of a ``Literal`` type."""
        return self.one_of(cast("tuple[str, ...]", get_args(kind)))


def _silent(node: Node, name: str) -> Node:
    """Return the place of a missing key, whose faults are not told again."""
    return Node(node.source, [], (*node.path, name), None)
