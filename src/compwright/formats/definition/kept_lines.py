"""Lines of a control's files that hold only addresses, numbers and keywords: they cannot name a
person or company, whatever compwright reads of them.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from typing import Final

NUMBER: Final = r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:EX?[+-]?[0-9]{1,3})?"
#: What may stand where a control names an axis.
AXIS: Final = r"(?:[A-Za-z]{1,2}|AX|M[AXSC]_?[A-Z]?|CA_?[A-Z]|SP)[0-9]{0,2}"


@dataclass(frozen=True, slots=True)
class KeptLines:
    """Expressions for the lines of one shape of tables, without blanks around a line.

    ``whole``: lines that may stay unchanged. ``naming``: lines of numbers, marks and names; a name
    is private unless it is an axis name. ``first``: first lines that identify the shape, whatever
    else they contain.
    """

    whole: tuple[str, ...]
    naming: str = "(?!)"
    first: str = "(?!)"

    def stays(self, line: str) -> bool:
        """Return whether a line may stay unchanged."""
        return _compiled(self.whole).fullmatch(line) is not None

    def holds_names(self, line: str) -> bool:
        """Return whether a line has only names that may be private."""
        return _compiled((self.naming,)).fullmatch(line) is not None

    def begins(self, content: bytes) -> bool:
        """Return whether the first line of a file identifies this shape."""
        return _compiled((self.first,)).match(content[:1000].decode("latin-1")) is not None


@cache
def _compiled(lines: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{line})" for line in lines), re.IGNORECASE | re.ASCII)
