"""Find where compwright's two file readers decode different corrections from a control's files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import numpy as np

from compwright.controllers.virtual_control import VirtualControl
from compwright.controls.decoded_state import judge_knows_axis
from compwright.foundations.errors import Fault
from compwright.prediction.active_corrections import Correction
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import ControlState, CrossCompensation

#: Largest difference of the two readers, mm or deg, of values that are nothing ...
AGREEMENT = 2e-7
#: ... and for each mm or deg of the largest value: a control may keep values, their differences and
#: slopes in single precision, each rounded to 2^-24 of itself.
SINGLE_PRECISION = 4.0 * 2.0**-24
#: Positions of tables of which only one reader knows, mm or deg: every 5 mm of the longest
#: machines.
EVERYWHERE = np.linspace(-5000.0, 5000.0, 2001)
#: The findings of tables that were left out: their axis was not requested, they cannot be read, or
#: their sign is unknown.
LEFT_OUT = frozenset({"CW-S011", "CW-S050", "CW-S051"})
_HINT = (
    "send this line and the control's files to the developers of compwright; until this is"
    " corrected, give another file of the control that contains the same tables"
)


def disagreements(state: ControlState, judge: VirtualControl) -> list[Fault]:
    """Return a fault for each axis and axis pair for which the independent file reader ``judge``
    finds a different correction.
    """
    faults = []
    unseen = sorted(
        address for address in state.axes if not judge_knows_axis(judge, address)
    )  # others: axes that were not requested
    if unseen:
        faults.append(
            Fault(
                message=(
                    "the files can be read in two ways: the two independent file readers of"
                    " compwright find different axes in them"
                ),
                expected=", ".join(unseen),
                found=", ".join(sorted(judge.addresses())) or "no axis",
                hint=_HINT,
            )
        )
    alone = "the two independent file readers of compwright do not agree on them"
    for address in sorted(set(state.axes) - set(unseen)):
        axis = state.axes[address]
        faults += _apart(
            axis.at,
            partial(judge.correction, address),
            probe_positions(axis.positions),
            (
                f"axis {address}",
                alone,
                axis.kind.unit,
            ),
        )
    return [*faults, *_cross_disagreements(state, judge)]


def _apart(
    mine: Correction, theirs: Correction, where: FloatArray, table: tuple[str, str, str]
) -> Iterator[Fault]:
    """Yield a fault for each direction in which two readings of a table (``mine``, ``theirs``)
    differ at one of the positions ``where``; the fault names the worst position.

    ``table``: name of the table, text of the message, unit.
    """
    name, words, unit = table
    for direction in Direction:
        values = mine(where, direction)
        off = np.abs(values - theirs(where, direction))
        if not np.all(off <= AGREEMENT + SINGLE_PRECISION * float(np.max(np.abs(values)))):
            worst = int(np.argmax(off))
            yield Fault(
                message=f"the files can be read in two ways: {words}",
                place=f"{name}, position {where[worst]:g}, direction {direction.value}",
                found=f"a difference of {off[worst]:.3g} {unit}",
                hint=_HINT,
            )


def _cross_disagreements(state: ControlState, judge: VirtualControl) -> list[Fault]:
    """Return a fault for each axis pair whose cross-axis tables differ between the readers."""
    between = "the two independent file readers of compwright do not agree on a cross-axis table"
    mine: dict[tuple[str, str], list[CrossCompensation]] = {}
    for entry in state.cross:
        mine.setdefault((entry.input, entry.output), []).append(entry)
    theirs = {
        (base.casefold(), corrected.casefold()): (base, corrected)
        for base, corrected in judge.cross()
    }
    seen = {(base.casefold(), corrected.casefold()) for base, corrected in mine}
    faults = [
        Fault(
            message=(
                "the files can be read in two ways: the two independent file readers of "
                "compwright find different cross-axis tables"
            ),
            place=" on ".join(pair),
            hint=_HINT,
        )
        for pair in sorted(seen - set(theirs))
    ]
    if not any(
        finding.code in LEFT_OUT for finding in state.findings
    ):  # what the judge alone sees must be switched off
        mine.update({pair: [] for key, pair in theirs.items() if key not in seen})
    for (base, corrected), entries in mine.items():
        if (base.casefold(), corrected.casefold()) not in theirs:
            continue
        where = np.concatenate(
            [EVERYWHERE, *(probe_positions(entry.positions) for entry in entries)]
        )
        faults += _apart(
            partial(_total, entries),
            partial(judge.cross_correction, base, corrected),
            where,
            (f"{base} on {corrected}", between, "mm or deg"),
        )
    return faults


def _total(
    entries: Sequence[CrossCompensation], where: FloatArray, direction: Direction
) -> FloatArray:
    return sum((entry.at(where, direction) for entry in entries), np.zeros(where.size))


def probe_positions(points: FloatArray) -> FloatArray:
    """Return positions at which to compare two tables: at the points, between the points, and
    beyond both ends.
    """
    if points.size == 0:
        return np.array([-1000.0, 0.0, 1000.0])
    step = float(points[-1] - points[0]) / max(points.size - 1, 1) or 1.0
    between = points[:-1] + 0.3 * np.diff(points)
    outside = np.array(
        [
            points[0] - 0.7 * step,
            points[0] - 3 * step,
            points[-1] + 0.7 * step,
            points[-1] + 3 * step,
        ]
    )
    return np.concatenate([points, between, outside])


def table_positions(points: FloatArray, travel: tuple[float, float]) -> FloatArray:
    """Return the positions at which two tables are compared: the probe positions between the
    outermost ends of table and travel, and both ends of the travel.

    ``points`` (k,): points of the table. ``travel``: lower and upper end, mm or deg. Positions
    outside are not compared, because a planned table keeps its end value there, while the control's
    table may repeat.
    """
    ends = np.concatenate([points, travel])
    where = probe_positions(points)
    return np.concatenate([where[(where >= ends.min()) & (where <= ends.max())], travel])
