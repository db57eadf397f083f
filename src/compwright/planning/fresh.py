"""Fresh tests of one axis at newly dithered targets, all from the same draws: what changes between
two answers is what was asked to change, not the luck of the draw.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from compwright.estimation.axis import Draws
from compwright.planning.outlook import DRAWS, END_MARGIN, generator
from compwright.planning.wanted import MeasuredError
from compwright.prediction.acting import Correction
from compwright.prediction.positioning import dithered_targets, predict_test
from compwright.prediction.scatter import fresh_scatter
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.noise import ALL_PARTS, without
from compwright.records.prediction import Quantiles
from compwright.records.result import PositioningResult

#: From 5 to 95 % a normal law is so many standard deviations wide.
BAND: Final = 3.29


@dataclass(frozen=True, slots=True, kw_only=True)
class FreshTests:
    """Draws of the deviation at new ``targets`` (m,), mm or deg, and the state of the generator
    from which the readings of the tests like ``result`` follow.
    """

    result: PositioningResult
    targets: FloatArray
    draws: Draws
    state: Any

    def quantiles(
        self,
        change: Correction,
        *,
        known: bool = True,
        unknown: bool = True,
        noise: bool = True,
    ) -> dict[str, Quantiles]:
        """Return the parameters of the tests after a ``change`` of the correction, by name.

        ``known``: whether the estimated error and the change are there, ``unknown`` whether what
        the estimate leaves open is, ``noise`` whether readings scatter.
        """
        rng = np.random.default_rng()
        rng.bit_generator.state = self.state
        deviations = {}
        for direction, drawn in (
            (Direction.POSITIVE, self.draws.positive),
            (Direction.NEGATIVE, self.draws.negative),
        ):
            mean = drawn.mean(axis=0)
            there = mean + change(self.targets, direction) if known else np.zeros_like(mean)
            deviations[direction] = there + (drawn - mean if unknown else np.zeros_like(drawn))
        runs = [
            int(np.max(self.result.test.readings(direction), initial=0.0))
            for direction in Direction
        ]
        shown = self.draws.noise if noise else without(self.draws.noise, *ALL_PARTS)
        still = np.zeros_like(self.targets)
        found = predict_test(
            deviations[Direction.POSITIVE],
            deviations[Direction.NEGATIVE],
            fresh_scatter(shown, self.targets, runs[0], runs[1], rng),
            change_positive=still,
            change_negative=still,
            coverage=self.result.coverage,
            vdi=self.result.standard == "vdi3441",
        )
        return {
            name: value
            for name, value in found.items()
            if self.result.parameters.get(name) is not None
        }


def fresh_tests(result: PositioningResult, posterior: MeasuredError, axis: Axis) -> FreshTests:
    """Return the tests that `planning.outlook` predicts at new targets, the same draws and
    readings.
    """
    name = result.test.name
    targets = dithered_targets(
        axis.travel,
        result.test.targets.size,
        generator(axis.name, name, "targets"),
        END_MARGIN[axis.kind],
    )
    rng = generator(axis.name, name, "draws")
    draws = posterior.draw(targets, DRAWS, rng)
    return FreshTests(result=result, targets=targets, draws=draws, state=rng.bit_generator.state)
