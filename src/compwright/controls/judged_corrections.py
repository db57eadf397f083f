"""The active corrections of a job's axes and axis pairs, as the independent file reader (virtual
control) decodes them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import partial

import numpy as np

from compwright.controls.decoded_state import DecodedState, judged_values
from compwright.prediction.active_corrections import (
    NO_CORRECTIONS,
    ActiveCorrections,
    Correction,
    no_correction,
)
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import CrossCompensation


def judged_correction(decoded: DecodedState | None, axis: Axis) -> Correction:
    """Return the correction of an axis as the independent file reader decodes it; zero if there are
    no files.
    """
    return no_correction if decoded is None else partial(judged_values, decoded, axis.address)


def applied_correction(decoded: DecodedState | None, axis: Axis) -> Correction:
    """Return an axis' correction without the reversal steps that are in its table but that the
    control leaves out.
    """
    correction = judged_correction(decoded, axis)
    held = None if decoded is None else decoded.state.axes.get(axis.address)
    if held is None or axis.unapplied_steps is None:
        return correction
    points = held.positions
    judged_table = replace(
        held,
        positive=correction(points, Direction.POSITIVE),
        negative=correction(points, Direction.NEGATIVE),
    )
    applied = applied_compensation(judged_table, axis)
    return correction if applied is judged_table else applied.at


def active_corrections(decoded: DecodedState | None, axes: Mapping[str, Axis]) -> ActiveCorrections:
    """Return the active corrections of axes and axis pairs as the independent file reader decodes
    them; none without files.
    """
    if decoded is None or decoded.judge is None:
        return NO_CORRECTIONS
    names = {axis.address: name for name, axis in axes.items()}
    pairs = dict.fromkeys((entry.input, entry.output) for entry in decoded.state.cross)
    return ActiveCorrections(
        along={name: applied_correction(decoded, axis) for name, axis in axes.items()},
        across={
            (names[pair[0]], names[pair[1]]): _across(decoded, pair)
            for pair in pairs
            if pair[0] in names and pair[1] in names
        },
    )


def _across(decoded: DecodedState, pair: tuple[str, str]) -> Correction:
    return (
        no_correction if decoded.judge is None else partial(decoded.judge.cross_correction, *pair)
    )


def judged_cross(
    decoded: DecodedState, at: FloatArray | None = None
) -> tuple[CrossCompensation, ...]:
    """Return each axis pair's correction as the independent file reader decodes it, at the
    positions ``at`` or, without them, at the table points.

    Each pair of axes occurs once, with the sum of all its active tables.
    """
    pairs: dict[tuple[str, str], list[CrossCompensation]] = {}
    for entry in decoded.state.cross:
        pairs.setdefault((entry.input, entry.output), []).append(entry)
    found = []
    for pair, entries in pairs.items():
        where = (
            np.unique(np.concatenate([entry.positions for entry in entries])) if at is None else at
        )
        positive, negative = (_across(decoded, pair)(where, direction) for direction in Direction)
        found.append(replace(entries[0], positions=where, positive=positive, negative=negative))
    return tuple(found)
