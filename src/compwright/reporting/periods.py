"""The periodic errors of an axis in a report: a table of them, the evidence for each period, and
the least amplitude that the test can detect.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

from compwright.reporting.numbers import position_unit, unit_text
from compwright.words.sentences import NumberText, say

Document = Mapping[str, Any]

#: The picture, in its own units: width and height of the curve's field, margin on the left, above.
_WIDTH: Final = 620.0
_HEIGHT: Final = 150.0
_LEFT: Final = 64.0
_TOP: Final = 36.0
_TICKS: Final = (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)
#: Odds that are drawn at least: a thousand to one either way.
_LEAST_ODDS: Final = 3.0
#: Below this the curve is cut off: how clearly a period is not there is no news.
_LOWEST: Final = -2.0
#: Log odds of a period that the search leaves out: at the targets it looks like the smooth error.
_LEFT_OUT: Final = -10.0
#: Larger amplitudes, µm or arcsec, are not drawn.
_LARGEST: Final = 10.0
#: Zeros of a number that is written out, at most.
_LONGEST: Final = 6
_RAISED: Final = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")


def periods_block(predicted: Document, unit: object) -> dict[str, Any] | None:
    """Return table and figures of an axis's periodic errors, or None if none were searched for.

    They show ``periods`` and ``period_search`` of an axis of the prediction document.
    """
    periods, search = predicted.get("periods") or [], predicted.get("period_search")
    if not periods and not search:
        return None
    where = position_unit(unit)
    return {
        "unit": where,
        "rows": [
            {
                "period": NumberText(f"{each['period']:.5g}"),
                "probability": _percent(each["probability"]),
                "source": say("period.source", source=each["source"]),
            }
            for each in periods
        ],
        "alike": [
            say(
                "period.alike",
                periods=[NumberText(f"{period:.4g}") for period in sorted(group, reverse=True)],
                unit=where,
            )
            for group in (search or {}).get("alike", [])
        ],
        "odds": _odds_picture(search, periods) if search and search["periods"] else None,
        "least": _amplitude_picture(search) if search and search["periods"] else None,
        "size": unit_text(unit),
    }


def _percent(probability: float) -> str:
    if probability > 0.999:
        return NumberText("> 99.9 %")
    return NumberText(f"{100.0 * probability:.3g} %")


def _odds_picture(search: Document, periods: Sequence[Document]) -> dict[str, Any]:
    """Return the curve of log10 odds for a periodic error over the logarithm of its period.
    ``search``: the evidence for each possible period; ``periods``: the periodic errors, to be
    marked.
    """
    sizes = search["periods"]
    odds = [
        max(float(each) / math.log(10.0), _LOWEST) if each > _LEFT_OUT else None
        for each in search["log_odds"]
    ]
    top = 1.08 * max((each for each in odds if each is not None), default=0.0)
    top = max(_LEAST_ODDS, top)
    step = max(1, math.ceil(top / 5.0))
    field = _Field(sizes, _LOWEST, top)
    return {
        **field.picture(odds),
        "gaps": None in odds,
        "levels": [
            {"y": field.up(level), "text": _power(level)} for level in range(0, int(top) + 1, step)
        ],
        "found": [
            {"x": field.across(each["period"]), "text": NumberText(f"{each['period']:.4g}")}
            for each in periods
            if sizes[0] <= each["period"] <= sizes[-1] and each["probability"] > 0.5
        ],
    }


def _amplitude_picture(search: Document) -> dict[str, Any]:
    """Return the least detectable amplitude over the logarithm of the period, as a curve.
    ``search``: the evidence for each possible period.
    """
    shown = [
        each if each is not None and each <= _LARGEST else None for each in search["detectable"]
    ]
    top = 1.08 * max((each for each in shown if each is not None), default=1.0)
    step = 10.0 ** math.floor(math.log10(top))
    step *= 0.5 if top < 3.0 * step else 1.0
    field = _Field(search["periods"], 0.0, top)
    levels = [step * each for each in range(int(top / step) + 1)]
    return {
        **field.picture(shown),
        "levels": [{"y": field.up(one), "text": NumberText(f"{one:.3g}")} for one in levels],
        "found": [],
    }


@dataclass(frozen=True, slots=True)
class _Field:
    """The two scales of a figure: ``periods`` along the horizontal axis (logarithmic), values from
    ``low`` to ``top`` along the vertical axis.
    """

    periods: Sequence[float]
    low: float
    top: float

    def across(self, period: float) -> float:
        low, high = math.log(self.periods[0]), math.log(self.periods[-1])
        return round(_LEFT + _WIDTH * (math.log(period) - low) / (high - low), 1)

    def up(self, value: float) -> float:
        return round(_TOP + _HEIGHT * (self.top - value) / (self.top - self.low), 1)

    def picture(self, values: Sequence[float | None]) -> dict[str, Any]:
        """Return the frame and the curves through ``values``, with gaps at None."""
        lines: list[list[str]] = [[]]
        for period, value in zip(self.periods, values, strict=True):
            if value is None:
                lines.append([])
            else:
                lines[-1].append(f"{self.across(period)},{self.up(value)}")
        return {
            "width": _LEFT + _WIDTH + 12.0,
            "height": _TOP + _HEIGHT + 38.0,
            "left": _LEFT,
            "right": _LEFT + _WIDTH,
            "top": _TOP,
            "bottom": _TOP + _HEIGHT,
            "even": self.up(0.0),
            "lines": [" ".join(line) for line in lines if line],
            "ticks": [
                {"x": self.across(tick), "text": NumberText(f"{tick:g}")}
                for tick in _TICKS
                if self.periods[0] <= tick <= self.periods[-1]
            ],
        }


def _power(exponent: int) -> str:
    """Return 10 to the ``exponent`` as text: 1 000 000, beyond that 10⁷."""
    if exponent > _LONGEST:
        return "10" + str(exponent).translate(_RAISED)
    return f"{10**exponent:,}".replace(",", "\u00a0")
