"""Collect all faults of one file, so that the user sees them all at once. Of many faults of the
same kind only the first few are listed.
"""

from __future__ import annotations

import re
import shlex
from collections import Counter

from compwright.foundations.errors import Fault, InputError

#: Faults of one kind that are listed one by one; the rest are counted.
SHOWN_PER_KIND = 10
_SHOWN_CHARACTERS = 60
_LINE = re.compile(r"line ([0-9]{1,9})")


class FaultList:
    """The faults found in ``file``, grouped by message."""

    def __init__(self, file: str) -> None:
        self.file = file
        self._shown: list[Fault] = []
        self._count: Counter[str] = Counter()

    def __bool__(self) -> bool:
        """Whether there is any fault."""
        return bool(self._shown)

    def add(
        self,
        message: str,
        *,
        place: str = "",
        expected: str = "",
        found: str = "",
        hint: str = "",
    ) -> None:
        """Add a fault. Of faults with the same message only the first `SHOWN_PER_KIND` are listed.

        ``place`` is the place in the file. If ``hint`` is empty, the next step of the message is to
        correct this place.
        """
        self._count[message] += 1
        if self._count[message] <= SHOWN_PER_KIND:
            self._shown.append(
                Fault(
                    message=message,
                    file=self.file,
                    place=place,
                    expected=expected,
                    found=found,
                    hint=hint
                    or f"correct {place or 'the file'} in a copy, or export the file again",
                )
            )

    def raise_if_any(self) -> None:
        """Raise InputError with the faults in the order of their lines, if there are any."""
        if not self._shown:
            return
        more = [
            Fault(
                message=f"{message}: {count - SHOWN_PER_KIND} more places with this fault",
                file=self.file,
                hint="correct them in the same way",
            )
            for message, count in self._count.items()
            if count > SHOWN_PER_KIND
        ]
        raise InputError(*sorted(self._shown, key=_line), *more)


def _line(fault: Fault) -> float:
    """The line number of a fault, for sorting. Faults without a line come last."""
    match = _LINE.match(fault.place)
    return int(match[1]) if match else float("inf")


def by_profile(file: str) -> str:
    """Return, as text for the user, the commands that make a mapping profile for a file and read
    the file with that profile.
    """
    return f"`compwright profile {shlex.quote(file)} --out P.yaml`, then `--profile P.yaml`"


def shown(text: str) -> str:
    """Return ``text`` for messages: quoted, on one line, cut to a readable length."""
    flat = " ".join(text.split())
    printable = "".join(character if character.isprintable() else "?" for character in flat)
    return (
        f"'{printable}'"
        if len(printable) <= _SHOWN_CHARACTERS
        else f"'{printable[:_SHOWN_CHARACTERS]}...'"
    )
