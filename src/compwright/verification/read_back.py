"""Exact comparison of the correction in the files read back from a control with the plan, without a
measurement.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from compwright.records.axis import Direction, FloatArray
from compwright.records.verification import ReadBack
from compwright.verification.whole_table_faults import FACTORS, factor_text
from compwright.words.sentences import SentenceText, say

Correction = Callable[[FloatArray, Direction], FloatArray]
_Curves = dict[Direction, FloatArray]
#: Two corrections are the same below this many mm or deg: far under every quantum of a control, far
#: over rounding.
SAME = 1e-6
#: Most points by which a loaded table may be shifted and still be recognised.
_MOST_SHIFT = 5


def judge_read_back(
    planned: Correction, loaded: Correction, old: Correction, points: FloatArray, spacing: float
) -> ReadBack:
    """Return the verdict on the values read back (``loaded``) compared with the plan, mm or deg.
    ``old``: the values in the control before.

    The mistakes of loading are tried in a fixed order. The verdict is the first one that explains
    the values exactly (within `SAME`) at all positions. A table of zeros explains nothing.
    ``points``, ``spacing``: the planned table points and their interval.
    """
    where = points if points.size > 1 else np.array([-100.0, 0.0, 100.0])
    wish = {side: planned(where, side) for side in Direction}
    found = {side: loaded(where, side) for side in Direction}
    gaps = {side: np.abs(wish[side] - found[side]) for side in Direction}
    side = max(Direction, key=lambda one: float(np.max(gaps[one])))
    index = int(np.argmax(gaps[side]))
    worst = float(gaps[side][index])
    if worst <= SAME:
        return ReadBack(worst, float(where[index]), side, "loaded", _cause("loaded"))
    for verdict, message in _explanations(wish, found, where, planned, old, spacing):
        return ReadBack(worst, float(where[index]), side, verdict, message)
    off = sum(int(np.sum(gaps[side] > SAME)) for side in Direction)
    message = SentenceText(say("read_back.other", off=off, number=2 * where.size))
    return ReadBack(worst, float(where[index]), side, "other", message)


def _cause(cause: str, *, backlash: bool = True) -> SentenceText:
    """Return the sentence that states the cause of a difference. ``backlash``: the cause explains
    the difference of the backlash value too.
    """
    return SentenceText(say("read_back.cause", cause=cause, apart=not backlash))


@dataclass(frozen=True, slots=True)
class _Mistake:
    """A possible mistake of loading: the correction after it, and the sentences that state it.

    ``apart``: the sentence that is used if the mistake explains the values except for a constant in
    each direction.
    """

    verdict: str
    curves: _Curves
    exact: SentenceText
    apart: SentenceText


def _mistake(verdict: str, curves: _Curves, cause: str) -> _Mistake:
    return _Mistake(verdict, curves, _cause(cause), _cause(cause, backlash=False))


def _causes(
    wish: _Curves, where: FloatArray, planned: Correction, old: Correction, spacing: float
) -> Iterator[_Mistake]:
    before = {side: old(where, side) for side in Direction}
    yield _mistake("not_active", before, "before")
    yield _mistake("not_active", {side: np.zeros(where.shape) for side in Direction}, "nothing")
    if any(np.any(np.abs(values) > SAME) for values in before.values()):
        change = {side: wish[side] - before[side] for side in Direction}
        yield _mistake("increment", change, "increment")
        both = {side: wish[side] + before[side] for side in Direction}
        yield _mistake("on_top", both, "on_top")
    yield _mistake("inverted", {side: -wish[side] for side in Direction}, "inverted")
    for factor in FACTORS:
        multiplied = {side: factor * wish[side] for side in Direction}
        known = factor_text(factor)
        yield _Mistake(
            "scaled",
            multiplied,
            *(
                SentenceText(say("read_back.scaled", factor=known, apart=apart))
                for apart in (False, True)
            ),
        )
    for points in (shift * sign for shift in range(1, _MOST_SHIFT + 1) for sign in (1, -1)):
        yield _Mistake(
            "shifted",
            {side: _shifted(planned, where, side, points * spacing) for side in Direction},
            *(
                SentenceText(
                    say(
                        "read_back.shifted",
                        points=abs(points),
                        towards="+" if points > 0 else "-",
                        apart=apart,
                    )
                )
                for apart in (False, True)
            ),
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
        yield "backlash", SentenceText(say("read_back.backlash", direction=other.value))
    theirs = np.abs(found[other] - wish[other]) <= SAME
    if 2 * int(np.sum(theirs)) < theirs.size:  # else single values differ, not the direction
        yield "one_direction", SentenceText(say("read_back.one_side", direction=same[0].value))


def _shifted(planned: Correction, where: FloatArray, side: Direction, by: float) -> FloatArray:
    """Return the planned correction at the positions ``where`` in one direction, shifted by ``by``
    towards + (mm or deg).
    """
    return planned(where - by, side)
