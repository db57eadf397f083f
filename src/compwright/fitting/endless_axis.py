"""Mapping of the wanted correction of an endless axis to one period from the reference."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.estimate import WantedCorrection


def over_one_period(wanted: WantedCorrection, period: float) -> WantedCorrection:
    """Return ``wanted`` over one ``period`` (mm or deg) from its reference, with equal end values.

    Turns that cover the same position are averaged with equal weights. Positions that no turn
    covers are bridged by a straight line.
    """
    begin = wanted.reference
    inside = begin + np.mod(wanted.positions - begin, period)
    where = np.unique(np.round(np.concatenate([[begin], inside, [begin + period]]), 9))
    return replace(
        wanted,
        positions=where,
        positive=_averaged(where, wanted.positions, wanted.positive, period),
        negative=_averaged(where, wanted.positions, wanted.negative, period),
    )


def _averaged(
    where: FloatArray, positions: FloatArray, values: FloatArray, period: float
) -> FloatArray:
    first = int(np.floor((positions[0] - where[-1]) / period))
    last = int(np.ceil((positions[-1] - where[0]) / period))
    total, turns = np.zeros(where.size), np.zeros(where.size)
    hair = 1e-9 * period
    for turn in range(first, last + 1):
        here = where + turn * period
        covered = (here >= positions[0] - hair) & (here <= positions[-1] + hair)
        total += np.where(covered, np.interp(here, positions, values), 0.0)
        turns += covered
    known = turns > 0
    averaged: FloatArray = np.interp(
        where, where[known], total[known] / turns[known], period=period
    )
    return averaged
