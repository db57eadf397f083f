"""Fresh tests that may come, for a goal of the fit to be judged by: drawn as predictions are, from
draws of their own.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.planning.fresh import END_MARGIN, generator
from compwright.planning.wanted import MeasuredError
from compwright.prediction.positioning import dithered_targets
from compwright.prediction.scatter import fresh_scatter
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.estimate import ErrorEstimate, Scenarios
from compwright.records.result import PositioningResult
from compwright.records.settled import settled

#: Different sets of new targets, and tests at each: so many that targets of one or another lie
#: everywhere, and few enough for a linear program.
_SETS: Final = 12
_TESTS_EACH: Final = 8
#: Targets of all tests together, at most.
_MOST: Final = 8000


def scenarios_of(
    result: PositioningResult, posterior: MeasuredError, estimate: ErrorEstimate, axis: Axis
) -> Scenarios:
    """Return fresh tests like ``result`` at newly dithered targets, as far as they lie beside the
    ``estimate``.
    """
    test = result.test
    m = test.targets.size
    each = max(2, min(_TESTS_EACH, _MOST // (_SETS * m)))
    rng = generator(axis.name, test.name, "scenarios")
    runs = [int(np.max(test.readings(way), initial=0.0)) for way in Direction]
    names = ("positions", "positive", "negative", "half_positive", "half_negative")
    parts: dict[str, list[FloatArray]] = {name: [] for name in names}
    for _ in range(_SETS):
        targets = dithered_targets(axis.travel, m, rng, END_MARGIN[axis.kind])
        draws = posterior.draw(targets, each, rng)
        scatter = fresh_scatter(draws.noise, targets, runs[0], runs[1], rng)
        parts["positions"].append(np.tile(targets, each))
        for way, drawn, mean, s in (
            (Direction.POSITIVE, draws.positive, scatter.mean_positive, scatter.s_positive),
            (Direction.NEGATIVE, draws.negative, scatter.mean_negative, scatter.s_negative),
        ):
            name = way.name.lower()
            beside = drawn - np.interp(targets, estimate.positions, estimate.mean(way)) + mean
            half = np.where(np.isfinite(s), result.coverage * s, 0.0)
            measured = np.all(np.isfinite(mean))
            parts[name].append(beside.ravel() if measured else np.empty(0))
            parts[f"half_{name}"].append(half.ravel() if measured else np.empty(0))
    joined = {name: settled(np.concatenate(blocks)) for name, blocks in parts.items()}
    return Scenarios(count=_SETS * each, **joined)
