"""Differences between the families of FANUC controls: limits, number formats, parameter numbers.

The word practice marks a fact that no manual page confirms.

- 30i, 31i, 32i: points 0 to 1535, increments greater than 7 are possible (a real backup, software
  D4G3: N10000Q0P0 to N11535Q0P0, increments up to 10). Lengths are real numbers (the same backup).
- 0i-D: increments -7 to 7. 8135#0 (NPE) = 1 switches stored pitch error compensation off
  (connection manual, function, B-64303CM-1/01 p. 26). Q1 and real lengths are reported from the
  backups of eleven machines. The points 0 to 1023 are practice. Everything about 0i-F is practice.
- 0i-A to C, 16i, 18i, 21i: no Q and no decimal point, reported from the backups of eight 18i
  machines. Everything else is practice.
- 15i: parameters without Q (B-63330EN/03 p. 21, 25). Its pitch parameters have numbers of their
  own, 5420 to 5427. Unknown are the bit that selects two sets, and the meaning of 5428 to 5499. All
  this is practice, no page was found.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

#: The pitch parameters as this room calls them.
PITCH = range(3620, 3628)
#: Parameters that a series with its own numbers has like the others: inch machine, backlash.
_COMMON = frozenset({1001, 1851, 1852})


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)  # one object for each series
class ControlSeries:
    """A family of FANUC controls with its limits, number formats and parameter numbers.

    - ``whole_lengths``: 3624 without a decimal point counts least input increments (16i and older).
    - ``systems``: parameters that can state the increment system. The first one in the files
      applies.
    - ``switched_by``: parameter whose bit 0 switches the pitch data off.
    - ``own``: for a series with parameter numbers of its own, the standard number of each.
    - ``unknown``: parameters that may correct an axis and whose meaning is unknown.
    """

    name: str
    highest_point: int
    increment_limit: int
    whole_lengths: bool = False
    systems: tuple[int, ...] = (1013,)
    switched_by: int | None = None
    own: Mapping[int, int] = field(default_factory=dict)
    unknown: range = range(0)

    def number_here(self, number: int) -> int | None:
        """Return the standard number of a parameter that has another number on this series.

        Returns None for a number that has another meaning on this series.
        """
        if not self.own or number in _COMMON:
            return number
        return self.own.get(number)

    def with_own_numbers(self, text: str) -> str:
        """Return a sentence with its parameter numbers replaced by those of this series."""
        if not self.own:
            return text
        back = {str(known): str(number) for number, known in self.own.items()}
        return re.sub(r"\b362[0-7]\b", lambda match: back[match[0]], text)


SERIES_30I = ControlSeries(name="30i", highest_point=1535, increment_limit=127)
SERIES_0I_16I = ControlSeries(
    name="0i/16i",
    highest_point=1023,
    increment_limit=7,
    whole_lengths=True,
    systems=(1013, 1004),
)
SERIES_0I_D = ControlSeries(name="0i-D", highest_point=1023, increment_limit=7, switched_by=8135)
#: Whether it has more points than 1023 is not known: more are read, where a file holds them.
SERIES_0I_F = ControlSeries(name="0i-F", highest_point=1535, increment_limit=7, switched_by=8135)
SERIES_15I = ControlSeries(
    name="15i",
    highest_point=1023,
    increment_limit=7,
    systems=(),
    own={5420 + i: number for i, number in enumerate(PITCH)},
    unknown=range(5428, 5500),
)
