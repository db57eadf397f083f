"""A simulated test as plain long CSV, like the file of an instrument."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import Direction
from compwright.records.positioning import PositioningTest


def to_csv(test: PositioningTest, extra: Mapping[str, str] | None = None) -> bytes:
    """Return ``test`` as plain long CSV (UTF-8, LF), deviations in um or arcsec with four decimals.
    ``extra``: further comment keys with their values.

    The comment keys are those of the test's header, overridden by ``extra``, and axis, cycle and
    sign, which the test itself determines. The rows come traverse by traverse in the order of the
    run numbers. Readings that were not taken (NaN) are left out.
    """
    unit = test.kind.unit
    keys = {**test.header, **(extra or {})}
    own = {"axis": test.axis, "cycle": test.cycle, "deviation": "measured minus target"}
    lines = [f"# {key}: {_one_line(text)}" for key, text in {**keys, **own}.items()]
    lines.append(f"target_{unit},direction,run,deviation_{outside_unit(unit)}")
    factor = outside_factor(unit)
    width = max(test.positive.shape[1], test.negative.shape[1])
    for column in range(width):
        for direction, runs in (
            (Direction.POSITIVE, test.runs_positive),
            (Direction.NEGATIVE, test.runs_negative),
        ):
            block = test.deviations(direction)
            if column >= block.shape[1]:
                continue
            run = runs[column] if runs else column + 1
            rows = zip(test.targets, block[:, column], strict=True)
            if direction is Direction.NEGATIVE:
                rows = zip(test.targets[::-1], block[::-1, column], strict=True)
            lines.extend(
                f"{_target(target)},{direction.value},{run},{_number(deviation * factor, 4)}"
                for target, deviation in rows
                if np.isfinite(deviation)
            )
    return ("\n".join(lines) + "\n").encode()


def _target(value: float) -> str:
    """Return a target as text with three decimals, or with six if three decimals are not exact."""
    return _number(value, 6).removesuffix("000")


def _number(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def _one_line(text: str) -> str:
    return " ".join(text.split())
