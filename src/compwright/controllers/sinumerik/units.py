"""The unit of lengths in the files of a SINUMERIK.

MD10240 (basic system: 1 mm, 0 inch) or a line ``METRIC`` or ``INCH`` before the values states the
unit. It scales all data loaded, compensation values included (840Di manual 06.03 p. 10-283; 808D
ADVANCED parameter manual 08/2013 p. 33).

MD10250 is the length of an inch. MD10220 applies a user's factor (MD10230) to physical quantities.
Its bits: 0 linear positions, 1 angular positions, 11 linear and 12 angular compensation values
(Siemens' texts of these data).
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field

_UNITS = re.compile(
    r"""\s*(?:N\d+\s*)?
        (?:\$MN_SCALING_SYSTEM_IS_METRIC\s*=\s*(?P<metric>[^\s;]+)
          |(?P<word>METRIC|INCH)
          |\$MN_SCALING_VALUE_INCH\s*=\s*(?P<inch>[0-9.]{1,20})
          |\$MN_SCALING_USER_DEF_MASK\s*=\s*'H(?P<mask>[0-9A-F]{1,8})'
          |\$MN_SCALING_FACTORS_USER_DEF\s*\[\s*(?P<bit>[0-9]{1,2})\s*\]\s*=\s*(?P<factor>[0-9.]{1,20}))
        (?:\s+'[0-9A-F]{4})?\s*""",
    re.VERBOSE | re.IGNORECASE,
)
_TRUTH = {"METRIC": 1.0, "INCH": 0.0, "TRUE": 1.0, "FALSE": 0.0}
_BASED = re.compile(r"'(?:H(?P<hex>[0-9A-F]{1,8})|B(?P<binary>[01]{1,32}))'")
_REAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:E[+-]?[0-9]{1,2})?", re.ASCII)


@dataclass(slots=True)
class UnitLines:
    """The statements about length units in a file, each with its line number.

    ``metric``: whether the basic system is metric. ``inch``: MD10250 in mm. ``own``: MD10220.
    ``factors``: index and value of MD10230.
    """

    metric: list[tuple[int, bool]] = field(default_factory=list)
    inch: list[tuple[int, float]] = field(default_factory=list)
    own: list[tuple[int, int]] = field(default_factory=list)
    factors: list[tuple[int, tuple[int, float]]] = field(default_factory=list)

    def read(self, code: str, number: int) -> None:
        """Record the length unit that a line of the file (without its comment) sets."""
        match = _UNITS.fullmatch(code)
        if match is None:
            return
        if word := match["word"] or match["metric"]:
            if (value := truth(word)) in (0.0, 1.0):
                self.metric.append((number, value == 1.0))
        elif match["mask"]:
            self.own.append((number, int(match["mask"], 16)))
        elif match["inch"]:
            self.inch.append((number, _decimal(match["inch"])))
        else:
            self.factors.append((number, (int(match["bit"]), _decimal(match["factor"]))))


def truth(text: str) -> float | None:
    """Return the number of a literal such as ``1``, ``TRUE``, ``'H1'``; None for other text.

    Source: Programming manual Job Planning 07/2010, 6FC5398-2BP40-0BA0, pages 54 and 73. An INT or
    REAL value can be used as BOOL; 0 is FALSE.
    """
    word = text.upper()
    if based := _BASED.fullmatch(word):
        return float(int(based["hex"], 16) if based["hex"] else int(based["binary"], 2))
    word = word.replace("EX", "E")
    return float(word) if _REAL.fullmatch(word) else _TRUTH.get(word)


def _decimal(text: str) -> float:
    """Return the number in a text of digits and points; NaN for any other text."""
    try:
        return float(text)
    except ValueError:
        return math.nan
