"""Lines of a control's files that hold addresses, numbers and keywords and nothing else: whatever
compwright reads of them, nobody is named in them.
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
    """Expressions for the lines of one shape of tables, blanks around a line left out.

    ``whole``: lines that may stay as they are. ``naming``: lines of numbers, marks and names, which
    are somebody's where they are none of an axis. ``first``: first lines that tell of the shape by
    themselves, whatever else stands on them.
    """

    whole: tuple[str, ...]
    naming: str = "(?!)"
    first: str = "(?!)"

    def stays(self, line: str) -> bool:
        """Whether a line may stay as it is."""
        return _compiled(self.whole).fullmatch(line) is not None

    def holds_names(self, line: str) -> bool:
        """Whether names are all in a line that may be somebody's."""
        return _compiled((self.naming,)).fullmatch(line) is not None

    def begins(self, content: bytes) -> bool:
        """Whether the first line of a file tells that it is of this shape."""
        return _compiled((self.first,)).match(content[:1000].decode("latin-1")) is not None


@cache
def _compiled(lines: tuple[str, ...]) -> re.Pattern[str]:
    return re.compile("|".join(f"(?:{line})" for line in lines), re.IGNORECASE | re.ASCII)
