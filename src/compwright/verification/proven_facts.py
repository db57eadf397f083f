"""Facts about a control that a verification with the verdict ``good`` proves, and facts that it
leaves unproven.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from compwright.records.axis import FloatArray

#: Natural logarithm of the odds against a turned sign that proof needs: 100 000 to 1.
SURE: Final = math.log(1e5)
#: Each fact with the fault of loading that would show if it were otherwise.
_FACTS: Final = (
    ("size and unit of the values", "scaled"),
    ("their places", "shifted"),
    ("their order", "mirrored"),
)


@dataclass(frozen=True, slots=True)
class ProvenAxis:
    """What the tests of one axis prove about the control, and what they leave unproven, as text."""

    axis: str
    proven: tuple[str, ...]
    unproven: tuple[str, ...]


def proven_axis(
    axis: str,
    loading: Mapping[str, Any],
    sign_odds: float,
    *,
    others: bool,
    backlash: bool,
    two_curves: bool,
) -> ProvenAxis:
    """Return the facts about the loaded table of an axis that its tests prove: if a fact were
    wrong, the test after loading would differ clearly. ``others``: the plan has more axes;
    ``backlash``: the plan changed the backlash value; ``two_curves``: the table has one curve for
    each direction.

    ``loading``: the loading verdict as in its document. ``sign_odds``: the result of the function
    `sign_odds`. A fact that is only probable beforehand is not proven.
    """
    doubted = {
        *loading["equivalent"],
        *loading["near"],
        *(one["verdict"] for one in loading.get("candidates", ())),
    }
    facts = [
        ("sign of the values", sign_odds >= SURE and "inverted" not in doubted),
        *((fact, fault not in doubted) for fact, fault in _FACTS),
        *([("the axis that they belong to", "wrong_axis" not in doubted)] if others else []),
        ("two curves, one for each direction", two_curves and "one_direction" not in doubted),
        ("sign and size of the backlash value", backlash and "backlash" not in doubted),
    ]
    return ProvenAxis(
        axis,
        tuple(fact for fact, sure in facts if sure),
        tuple(fact for fact, sure in facts if not sure),
    )


def sign_odds(
    curves: Sequence[tuple[FloatArray, FloatArray, FloatArray]], scatter: FloatArray
) -> float:
    """Return the logarithm of the odds that the planned sign of the table is right. ``curves``: for
    each measured direction, the means expected with the table, those without it, and those measured
    after loading; ``scatter``: the standard deviation of a measured mean.

    All arrays are (m,). With the opposite sign, the test would show twice the means without the
    table minus the expected ones. A free datum common to both directions is subtracted from both.
    The variance of that expectation is taken as five times as large, which is the upper bound for
    doubling the mean of the test before. Therefore the odds are too small rather than too large.
    """
    if not curves:
        return 0.0
    expected, before, found = (np.concatenate(parts) for parts in zip(*curves, strict=True))
    sigma = np.tile(scatter, len(curves))
    kept = np.isfinite(expected) & np.isfinite(before) & np.isfinite(found) & (sigma > 0.0)
    if np.count_nonzero(kept) < 3:
        return 0.0
    planned = _misfit(found - expected, sigma, kept)
    turned = _misfit(found - (2.0 * before - expected), sigma, kept)
    return (turned - planned) / (2.0 * 5.0)


def _misfit(residual: FloatArray, sigma: FloatArray, kept: FloatArray) -> float:
    weights = 1.0 / sigma[kept] ** 2
    rest = residual[kept]
    rest = rest - float(weights @ rest) / float(weights.sum())
    return float(weights @ rest**2)
