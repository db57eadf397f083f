"""Simulated tests for a fit whose goal is a small parameter such as A: some to optimise the table,
and others to judge the result.

Both sets are simulated as predictions are, from separate random draws. The prediction is a third
set, which confirms or contradicts the result.
"""

from __future__ import annotations

from typing import Final, Literal

import numpy as np

from compwright.planning.simulated_repeat_tests import END_MARGIN, FreshTests, generator
from compwright.planning.wanted_correction import MeasuredError
from compwright.prediction.active_corrections import Correction
from compwright.prediction.fresh_scatter import fresh_scatter
from compwright.prediction.positioning import dithered_targets
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.estimate import ErrorEstimate, Scenarios
from compwright.records.fitted_table import FittedTable
from compwright.records.result import PositioningResult
from compwright.records.rounding import rounded

#: Different sets of new targets, and tests at each: so many sets that targets of one or
#: another lie everywhere in each half of them, and few enough tests for a linear program.
_SETS: Final = 48
_TESTS_EACH: Final = 2
#: Targets of all tests together, at most.
_MOST: Final = 8000
#: Share of a parameter that another set of targets gives or takes: less is no gain.
_LEAST_GAIN: Final = 0.01
#: What a goal asks for, by the first of these that the test has: of both directions, of the one
#: that was measured, or of VDI/DGQ 3441.
_SHOWN_BY: Final = {
    "A": ("A", "A_positive", "A_negative", "P"),
    "E": ("E", "E_positive", "E_negative", "P"),
    "M": ("M", "E_positive", "E_negative", "Pa"),
}


def scenarios_of(
    result: PositioningResult, posterior: MeasuredError, estimate: ErrorEstimate, axis: Axis
) -> Scenarios:
    """Return simulated repetitions of the test ``result`` at new random targets. Their values are
    the deviations minus the ``estimate`` of the error.
    """
    test = result.test
    m = test.targets.size
    sets = max(4, min(_SETS, _MOST // (_TESTS_EACH * m)))
    rng = generator(axis.name, test.name, "scenarios")
    runs = [int(np.max(test.readings(way), initial=0.0)) for way in Direction]
    names = ("positions", "positive", "negative", "half_positive", "half_negative")
    parts: dict[str, list[FloatArray]] = {name: [] for name in names}
    for _ in range(sets):
        targets = dithered_targets(axis.travel, m, rng, END_MARGIN[axis.kind])
        draws = posterior.draw(targets, _TESTS_EACH, rng)
        scatter = fresh_scatter(draws.noise, targets, runs[0], runs[1], rng)
        parts["positions"].append(np.tile(targets, _TESTS_EACH))
        for way, drawn, mean, s in (
            (Direction.POSITIVE, draws.positive, scatter.mean_positive, scatter.s_positive),
            (Direction.NEGATIVE, draws.negative, scatter.mean_negative, scatter.s_negative),
        ):
            name = way.name.lower()
            relative = drawn - np.interp(targets, estimate.positions, estimate.mean(way)) + mean
            half = np.where(np.isfinite(s), result.coverage * s, 0.0)
            measured = np.all(np.isfinite(mean))
            parts[name].append(relative.ravel() if measured else np.empty(0))
            parts[f"half_{name}"].append(half.ravel() if measured else np.empty(0))
    joined = {name: rounded(np.concatenate(blocks)) for name, blocks in parts.items()}
    return Scenarios(count=sets * _TESTS_EACH, **joined)


def goal_improves(
    goal: Literal["A", "E", "M"], with_it: Correction, without: Correction, fresh: FreshTests
) -> bool:
    """Return whether the median of ``goal`` over the ``fresh`` tests is clearly smaller after the
    change ``with_it`` than after ``without``.
    """
    one, other = fresh.quantiles(with_it), fresh.quantiles(without)
    name = next(name for name in _SHOWN_BY[goal] if name in one)
    return one[name].median < (1.0 - _LEAST_GAIN) * other[name].median


def same_tables(one: FittedTable, other: FittedTable) -> bool:
    """Return whether two tables have the same values."""
    mine, usual = one.compensation, other.compensation
    return (
        np.array_equal(mine.positive, usual.positive)
        and np.array_equal(mine.negative, usual.negative)
        and mine.backlash == usual.backlash
    )
