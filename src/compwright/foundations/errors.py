"""One error class per cause, with its exit code. An error lists all faults found, one per line.

A fault states what is wrong, in which file and where (line, column or key path). It also states
what was expected, what was found and what to do next. Nothing here prints; the command line prints
the faults as lines on standard error.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

#: What was found is quoted up to so many characters: enough to recognise it, and one line stays one
#: line.
MOST_QUOTED = 240


def _short(text: str) -> str:
    return text if len(text) <= MOST_QUOTED else f"{text[:MOST_QUOTED]}..."


#: What leads to the next step.
_NEXT = ". Next: "
#: The beginning of a message without a subject: its subject is the place.
_PREDICATE = re.compile(
    r"(is|has|does|do|holds|contains|names|states|covers|goes|cannot|belongs|extends|may"
    r"|disagrees) "
)
#: Equal faults of lines up to which each one is a line of its own, and places that are listed.
_LISTED = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Fault:
    """One fault of an input: its message, its file and place, what was expected, what was found,
    and the next step.
    """

    message: str
    file: str = ""
    place: str = ""
    expected: str = ""
    found: str = ""
    #: The next step: an imperative with the option, key or command to copy, without full stop.
    hint: str = ""

    def __str__(self) -> str:
        """Return the fault as one line: ``file: place: message; expected ..., found .... Next:
        ...``.
        """
        head = ": ".join(part for part in (self.file, self.place) if part)
        tail = ", ".join(
            part
            for part in (
                f"expected {self.expected}" if self.expected else "",
                f"found {_short(self.found)}" if self.found else "",
            )
            if part
        )
        subject = self.place and _PREDICATE.match(self.message)
        line = f"{head}{' ' if subject else ': '}{self.message}" if head else self.message
        line = f"{line}; {tail}" if tail else line
        if self.hint and _NEXT not in line:  # the next step of a fault inside this one
            line += _NEXT + self.hint
        return " ".join(line.split())

    def in_file(self, file: str) -> Fault:
        """Return the fault with ``file`` as its file, unless it already names one."""
        return self if self.file else replace(self, file=file)

    def within(self, place: str) -> Fault:
        """Return the fault with ``place`` put in front of the place that the fault already has."""
        return replace(self, place=f"{place}, {self.place}" if self.place else place)


def _together(faults: Sequence[Fault]) -> str:
    first, *others = faults
    places = ", ".join(fault.place.removeprefix("line ") for fault in others[:_LISTED])
    more = ", ..." if len(others) > _LISTED else ""
    message = f"{first.message} (and {len(others)} more such lines: {places}{more})"
    return str(replace(first, message=message))


class CompwrightError(Exception):
    """Base of all errors that compwright raises on purpose; its message is one line per fault."""

    exit_code: ClassVar[int] = 70

    def __init__(self, *faults: Fault) -> None:
        self.faults: tuple[Fault, ...] = tuple(dict.fromkeys(faults))
        super().__init__("\n".join(self.lines()))

    def lines(self) -> list[str]:
        """Return the faults as lines. Many faults that differ only in their line number are joined
        into one line.
        """
        groups: dict[object, list[Fault]] = {}
        for i, fault in enumerate(self.faults):
            same = (fault.message, fault.file, fault.expected)
            of_a_line = fault.file and re.fullmatch(r"line \d+", fault.place)
            groups.setdefault(same if of_a_line else i, []).append(fault)
        found: list[str] = []
        for group in groups.values():
            found += [_together(group)] if len(group) > _LISTED else map(str, group)
        return found

    def __reduce__(self) -> tuple[type[CompwrightError], tuple[Fault, ...]]:
        """Return the class and the faults, from which copying and pickling make the error again."""
        return type(self), self.faults


class UsageError(CompwrightError):
    """A wrong option, or an incomplete or wrong job (exit code 2)."""

    exit_code = 2


class InputError(CompwrightError):
    """Input that is unreadable or contradicts itself (exit code 3)."""

    exit_code = 3


class CapacityError(CompwrightError):
    """The correction exceeds the control's limits, or it cannot be proved that a table is the best
    one (exit code 4).

    The fault states which limit is exceeded, by how much, and what would help.
    """

    exit_code = 4


class StorageError(CompwrightError):
    """A file cannot be written: it exists, no permission, or a full disk (exit code 5)."""

    exit_code = 5


def raise_all(kind: type[CompwrightError], faults: Sequence[Fault]) -> None:
    """Raise ``kind`` with all ``faults``; do nothing when there are none."""
    if faults:
        raise kind(*faults)


def collect(errors: Iterable[CompwrightError]) -> tuple[Fault, ...]:
    """Return the faults of several errors in one list."""
    return tuple(fault for error in errors for fault in error.faults)
