"""What the next positioning test will show, and whether a table is worth loading."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.wanted import MeasuredError
from compwright.prediction.acting import Correction
from compwright.prediction.positioning import dithered_targets, fresh_slopes, predict_test
from compwright.prediction.scatter import fresh_scatter
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.prediction import Quantiles, TestPrediction
from compwright.records.result import PositioningResult

DRAWS = 2000
#: Newly dithered targets stay this far from the ends of the travel: mm, and for rotary axes deg.
END_MARGIN = {AxisKind.LINEAR: 4.0, AxisKind.ROTARY: 0.0}


@dataclass(frozen=True, slots=True)
class Like:
    """How a fresh test is taken: with the noise of which test of the axis (its ``place`` among
    them), and with which standard deviation of its slope, mm/mm, from a temperature that is not
    known better.
    """

    place: int = 0
    slope_std: float = 0.0


def predict(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
    axis: Axis,
    like: Like = Like(),
) -> TestPrediction:
    """Return what a fresh test like ``result`` will show with the changed correction, at its
    targets and at new ones.
    """
    return TestPrediction(
        name=result.test.name,
        before=result,
        predicted=_predict_at(result, posterior, change, result.test.targets, axis, like),
        predicted_new_targets=predict_new_targets(result, posterior, change, axis, like),
    )


def predict_new_targets(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
    axis: Axis,
    like: Like = Like(),
) -> Mapping[str, Quantiles]:
    """Return what a fresh test like ``result`` will show with the changed correction at newly
    dithered targets.
    """
    test = result.test
    new_targets = dithered_targets(
        axis.travel,
        test.targets.size,
        generator(axis.name, test.name, "targets"),
        END_MARGIN[axis.kind],
    )
    return _predict_at(result, posterior, change, new_targets, axis, like)


def why_not_better(
    before: PositioningResult,
    after: PositioningResult,
    old: Mapping[str, Quantiles],
    new: Mapping[str, Quantiles],
) -> str:
    """Return why a table would not improve the axis, or an empty text when it does.

    ``before``, ``after``: the measured test re-evaluated with what the control does now and with
    what the new files give; ``old``, ``new``: what newly dithered targets will show, from the same
    draws. Judged by the first of A, E, ... that the test has.
    """
    name = yardstick(before)
    if name is None:
        return ""
    factor = outside_factor(before.test.kind.unit)
    unit = shown_unit(before.test.kind.unit)
    was, becomes = before.parameters[name], after.parameters[name]
    if was is not None and becomes is not None and abs(becomes) >= abs(was):
        return (
            f"the measured test re-evaluated with the table gives {name} {becomes * factor:.2f}"
            f" {unit}, without it {was * factor:.2f} {unit}"
        )
    if name in new and name in old and abs(new[name].median) >= abs(old[name].median):
        return (
            f"at new targets {name} is expected to be {new[name].median * factor:.2f} {unit} with"
            f" the table, {old[name].median * factor:.2f} {unit} without it"
        )
    return ""


def _predict_at(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
    targets: FloatArray,
    axis: Axis,
    like: Like,
) -> Mapping[str, Quantiles]:
    rng = generator(axis.name, result.test.name, "draws")
    draws = posterior.draw(targets, DRAWS, rng, like.place)
    same = targets is result.test.targets
    runs: list[int | FloatArray] = [
        readings if same else int(np.max(readings, initial=0.0))
        for readings in map(result.test.readings, Direction)
    ]
    scatter = fresh_scatter(draws.noise, targets, runs[0], runs[1], rng)
    slopes = fresh_slopes(targets, DRAWS, like.slope_std, rng)
    predicted = predict_test(
        draws.positive + slopes,
        draws.negative + slopes,
        scatter,
        change_positive=change(targets, Direction.POSITIVE),
        change_negative=change(targets, Direction.NEGATIVE),
        coverage=result.coverage,
        vdi=result.standard == "vdi3441",
    )
    return {
        name: value for name, value in predicted.items() if result.parameters.get(name) is not None
    }


def yardstick(result: PositioningResult) -> str | None:
    """Return the first of A, E, ... that a test has: by it tables are judged."""
    names = ("A", "E", "A_positive", "A_negative", "E_positive", "E_negative", "P", "R", "B_mean")
    return next((name for name in names if result.parameters.get(name) is not None), None)


def generator(*names: str) -> np.random.Generator:
    """Return a generator that depends on the names only: the same job predicts the same numbers."""
    digest = hashlib.sha256("\x1f".join(names).encode("utf-8", "surrogatepass")).digest()
    return np.random.default_rng(int.from_bytes(digest[:8], "big"))
