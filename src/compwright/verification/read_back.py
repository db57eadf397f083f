"""Exact comparison of the correction read back from a control with the plan, no test needed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.verification import ReadBack

Correction = Callable[[FloatArray, Direction], FloatArray]
_Curves = dict[Direction, FloatArray]
#: Two corrections are the same below this many mm or deg: far under every quantum of a control, far
#: over rounding.
SAME = 1e-6
#: Most nodes by which a loaded table may be shifted and still be recognised.
_MOST_SHIFT = 5
#: Factors with a known cause.
_FACTORS = {
    2.0: "twice: radius and diameter mixed up, loaded on top of itself, or twice the magnification",
    0.5: "half: radius and diameter mixed up",
    10.0: "ten times: another detection unit or increment system",
    0.1: "a tenth: another detection unit or increment system",
    25.4: "25.4 times: inch taken for mm",
    1000.0: "a thousand times: mm taken for µm",
    0.001: "a thousandth: µm taken for mm",
}


def judge_read_back(
    planned: Correction, loaded: Correction, old: Correction, nodes: FloatArray, spacing: float
) -> ReadBack:
    """Return the verdict on the values read back (``loaded``) compared with the plan, mm or deg.
    ``old``: the values in the control before.

    The first explanation that is exact (within `SAME`) everywhere counts; a table of zeros explains
    nothing.
    """
    where = nodes if nodes.size > 1 else np.array([-100.0, 0.0, 100.0])
    wish = {side: planned(where, side) for side in Direction}
    found = {side: loaded(where, side) for side in Direction}
    gaps = {side: np.abs(wish[side] - found[side]) for side in Direction}
    side = max(Direction, key=lambda one: float(np.max(gaps[one])))
    index = int(np.argmax(gaps[side]))
    worst = float(gaps[side][index])
    if worst <= SAME:
        return ReadBack(
            worst,
            float(where[index]),
            side,
            "loaded",
            "the table in the control is the planned table",
        )
    for verdict, message in _explanations(wish, found, where, planned, old, spacing):
        return ReadBack(worst, float(where[index]), side, verdict, message)
    off = sum(int(np.sum(gaps[side] > SAME)) for side in Direction)
    return ReadBack(
        worst,
        float(where[index]),
        side,
        "other",
        f"the values differ at {off} of {2 * where.size} nodes, directions counted apart; no single"
        " mistake explains all of them",
    )


@dataclass(frozen=True, slots=True)
class _Mistake:
    """A possible mistake of loading: the correction after it, and the sentences that state it."""

    verdict: str
    curves: _Curves
    exact: str
    apart: str


def _causes(
    wish: _Curves, where: FloatArray, planned: Correction, old: Correction, spacing: float
) -> Iterator[_Mistake]:
    yield _Mistake(
        "not_active",
        {side: old(where, side) for side in Direction},
        "what was in the control before is still there",
        "the table that was in the control before is still there; only the backlash differs from"
        " before",
    )
    yield _Mistake(
        "not_active",
        {side: np.zeros(where.shape) for side in Direction},
        "nothing is active: the table is off or empty",
        "no table is active: it is off or empty; only backlash is",
    )
    before = {side: old(where, side) for side in Direction}
    if any(np.any(np.abs(values) > SAME) for values in before.values()):
        yield _Mistake(
            "increment",
            {side: wish[side] - before[side] for side in Direction},
            "only the change to the existing table was loaded: load the total",
            "only the change to the existing table was loaded, apart from the backlash: load the"
            " total",
        )
        yield _Mistake(
            "on_top",
            {side: wish[side] + before[side] for side in Direction},
            "the new total was added to the existing table: clear the table and load it again",
            "the new total was added to the existing table, apart from the backlash: clear the"
            " table and load it again",
        )
    yield _Mistake(
        "inverted",
        {side: -wish[side] for side in Direction},
        "every value has the opposite sign",
        "every value of the table has the opposite sign, apart from the backlash",
    )
    for factor, says in _FACTORS.items():
        yield _Mistake(
            "scaled",
            {side: factor * wish[side] for side in Direction},
            f"every value is {says}",
            f"every value of the table, apart from the backlash, is {says}",
        )
    for nodes in (shift * sign for shift in range(1, _MOST_SHIFT + 1) for sign in (1, -1)):
        points = "1 point" if abs(nodes) == 1 else f"{abs(nodes)} points"
        sits = f"the table sits {points} too far to {'+' if nodes > 0 else '-'}"
        yield _Mistake(
            "shifted",
            {side: _shifted(planned, where, side, nodes * spacing) for side in Direction},
            sits,
            f"{sits} and counts from its own zero: another number or position of the reference",
        )


def _explanations(
    wish: _Curves,
    found: _Curves,
    where: FloatArray,
    planned: Correction,
    old: Correction,
    spacing: float,
) -> Iterator[tuple[str, str]]:
    causes = list(_causes(wish, where, planned, old, spacing))
    for cause in causes:
        if all(
            float(np.max(np.abs(found[side] - cause.curves[side]))) <= SAME for side in Direction
        ):
            yield cause.verdict, cause.exact
    yield from _one_side(wish, found)
    if all(_constant(wish[side]) for side in Direction):
        return
    # Shapes only: backlash adds a constant per direction, and a control may count the table from a
    # zero of its own.
    for cause in causes:
        if all(_constant(found[side] - cause.curves[side]) for side in Direction):
            yield cause.verdict, cause.apart


def _constant(values: FloatArray) -> bool:
    return float(np.ptp(values)) <= SAME


def _one_side(wish: _Curves, found: _Curves) -> Iterator[tuple[str, str]]:
    same = [side for side in Direction if float(np.max(np.abs(found[side] - wish[side]))) <= SAME]
    if len(same) != 1:
        return
    other = same[0].opposite
    if float(np.ptp(found[other] - wish[other])) <= SAME:
        yield (
            "backlash",
            f"arriving in {other.value} everything is off by one constant: another backlash value",
        )
    theirs = np.abs(found[other] - wish[other]) <= SAME
    if 2 * int(np.sum(theirs)) < theirs.size:  # else single values differ, not the direction
        arriving = f"only the values for arriving in {same[0].value} equal the planned values"
        yield "one_direction", arriving


def _shifted(planned: Correction, where: FloatArray, side: Direction, by: float) -> FloatArray:
    """Return the planned correction shifted by ``by`` towards + (mm or deg)."""
    return planned(where - by, side)
