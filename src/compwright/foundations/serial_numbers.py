"""Serial numbers of machines, as headers of measurement files and jobs state them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Final

_KEYS: Final = ("serial", "serial_no")


def serials(header: Mapping[str, str]) -> list[str]:
    """Return the serial numbers of the machine in a header of one or several files."""
    texts = (text for key, text in header.items() if key.lower() in _KEYS)
    return [line for text in texts for line in text.splitlines() if _plain(line)]


def other_serials(header: Mapping[str, str], known: Iterable[str]) -> list[str]:
    """Return the serial numbers in a header that are none of the ``known``; empty if none is known.

    Blanks, signs, and upper and lower case do not matter.
    """
    own = set(map(_plain, known)) - {""}
    return [serial for serial in serials(header) if own and _plain(serial) not in own]


def _plain(serial: str) -> str:
    """Return a serial number without blanks and signs, in lower case; "" for what `compwright new`
    (`not given`) and `redact` (`redacted_1`) write in its place.
    """
    text = re.sub(r"[\W_]+", "", serial).casefold()
    return "" if re.fullmatch(r"notgiven|redacted[0-9]*", text) else text
