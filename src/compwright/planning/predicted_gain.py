"""Prediction of the next positioning test, and the decision whether a table is worth loading."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache, partial

from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.simulated_repeat_tests import (
    BAND,
    FIRST,
    FreshTests,
    RepeatConditions,
    draws_like,
    fresh_tests,
    generator,
)
from compwright.planning.wanted_correction import MeasuredError
from compwright.prediction.active_corrections import Correction
from compwright.prediction.fresh_scatter import FreshScatter, fresh_scatter
from compwright.prediction.positioning import fresh_slopes, predict_test
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.prediction import Quantiles, TestPrediction
from compwright.records.result import PositioningResult
from compwright.words.sentences import Amount, Sentence, say


def predict(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
    axis: Axis,
    like: RepeatConditions = FIRST,
    fresh: FreshTests | None = None,
) -> TestPrediction:
    """Return the prediction of a repeated test after a ``change`` of the correction, at the same
    targets and at new targets. ``like``: the conditions of the repetition; ``fresh``: simulated
    tests at new targets, if they exist already.
    """
    drawn = fresh or fresh_tests(result, posterior, axis, like)
    return TestPrediction(
        name=result.test.name,
        before=result,
        predicted=predict_same_targets(result, posterior, change, axis, like),
        predicted_new_targets=drawn.band(change),
    )


def predict_same_targets(
    result: PositioningResult,
    posterior: MeasuredError,
    change: Correction,
    axis: Axis,
    like: RepeatConditions = FIRST,
) -> Mapping[str, Quantiles]:
    """Return the prediction of a repeated test after a ``change`` of the correction, at the same
    targets. ``like``: the conditions of the repetition.
    """
    targets = result.test.targets
    positive, negative, scatter = _drawn(result, posterior, axis.name, like)
    predicted = predict_test(
        positive,
        negative,
        scatter,
        change_positive=change(targets, Direction.POSITIVE),
        change_negative=change(targets, Direction.NEGATIVE),
        coverage=result.coverage,
        vdi=result.standard == "vdi3441",
    )
    return {
        name: value for name, value in predicted.items() if result.parameters.get(name) is not None
    }


@lru_cache(maxsize=1)  # tables are compared one after the other
def _drawn(
    result: PositioningResult, posterior: MeasuredError, axis: str, like: RepeatConditions
) -> tuple[FloatArray, FloatArray, FreshScatter]:
    """Return random draws (s, m) of the deviation at the targets in + and −, and of the scatter of
    the readings, in a repetition of the test under the conditions ``like``.
    """
    targets = result.test.targets
    rng = generator(axis, result.test.name, "draws")
    count = draws_like(result)
    draws = posterior.draw(targets, count, rng, like.place)
    runs = [result.test.readings(direction) for direction in Direction]
    scatter = fresh_scatter(draws.noise, targets, runs[0], runs[1], rng)
    slopes = fresh_slopes(targets, count, like.slope_std, rng)
    return draws.positive + slopes, draws.negative + slopes, scatter


def why_not_better(
    before: PositioningResult,
    after: PositioningResult,
    old: Mapping[str, Quantiles],
    new: Mapping[str, Quantiles],
) -> Sentence | None:
    """Return the reason why a table would not improve the axis, or None if the table improves it.
    Compared are the measured test (evaluated with the present correction ``before`` and with the
    new one ``after``) and quantiles of simulated tests at new targets (``old``, ``new``).

    Only one parameter is compared: the first of A, E, ... that the test has.
    """
    name = judged_parameter(before)
    if name is None:
        return None
    amount = partial(_amount, before)
    was, becomes = before.parameters[name], after.parameters[name]
    if was is not None and becomes is not None and abs(becomes) >= abs(was):
        return say(
            "CW-P001.measured", parameter=name, with_table=amount(becomes), without=amount(was)
        )
    if name in new and name in old and abs(new[name].median) >= abs(old[name].median):
        return say(
            "CW-P001.new_targets",
            parameter=name,
            with_table=amount(new[name].median),
            without=amount(old[name].median),
        )
    return None


def why_not_seen(
    before: PositioningResult, old: Mapping[str, Quantiles], new: Mapping[str, Quantiles]
) -> Sentence | None:
    """Return the reason why no test would show the gain of a table, or None if a test would show
    it. ``old``, ``new``: quantiles of simulated tests with the present and with the new correction.

    The parameter that judges tables must fall by more than its standard deviation from test to
    test. The arguments are those of `why_not_better`, which must have found the table better.
    """
    name = judged_parameter(before)
    if name is None or name not in new or name not in old:
        return None
    was, becomes = (abs(each[name].median) for each in (old, new))
    spread = parameter_spread(new[name])
    if was - becomes > spread:
        return None
    amount = partial(_amount, before)
    return say(
        "CW-P001.not_seen",
        parameter=name,
        with_table=amount(becomes),
        without=amount(was),
        spread=amount(spread),
    )


def _amount(result: PositioningResult, value: float) -> Amount:
    unit = result.test.kind.unit
    return Amount(value * outside_factor(unit), shown_unit(unit))


def parameter_spread(shown: Quantiles) -> float:
    """Return the standard deviation of a parameter between tests, from its quantiles ``shown``:
    only those below the median, because outliers widen the upper half.
    """
    return 2.0 * (shown.median - shown.p05) / BAND


def judged_parameter(result: PositioningResult) -> str | None:
    """Return the name of the parameter by which tables are compared, such as A or E."""
    names = ("A", "E", "A_positive", "A_negative", "E_positive", "E_negative", "P", "R", "B_mean")
    return next((name for name in names if result.parameters.get(name) is not None), None)
