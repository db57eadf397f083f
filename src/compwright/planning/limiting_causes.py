"""Causes that limit the accuracy of an axis, with the contribution of each cause to the predicted
parameter.

Each cause is computed from the same draws with and without it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any, Final, Protocol

import numpy as np

from compwright.planning.axis_work import AxisWork
from compwright.planning.predicted_gain import judged_parameter, parameter_spread
from compwright.planning.shortfalls import as_curve, shortfalls, unheld_period
from compwright.planning.simulated_repeat_tests import FreshTests
from compwright.prediction.active_corrections import Correction, difference
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.limits import LimitingCause, LimitingCauses
from compwright.records.noise import NoisePart
from compwright.records.prediction import Quantiles

#: What scatters from reading to reading, or from traverse to traverse; what changes over the test;
#: and what readings did not tell of the error.
NOISE: Final = "noise"
OUTLIERS: Final = "single outliers"
TRAVERSES: Final = "shifts between traverses"
DRIFT: Final = "drift"
_SCATTERING: Final[Mapping[str, tuple[NoisePart, ...]]] = {
    OUTLIERS: ("tails",),
    TRAVERSES: ("traverses",),
    DRIFT: ("drift",),
}
WARM: Final = "temperature within its uncertainty"
UNKNOWN: Final = "error that the test leaves open"
HIDDEN: Final = "periods that the test leaves open"
NO_TABLE: Final = "no table is written"
NEVER_APPLIED: Final = "steps that the control never applies"
#: A cause below this share of the parameter is not worth a word, unless the fit has named it.
_WORTH_SAYING: Final = 0.005


def what_limits(work: AxisWork, new: Correction, fresh: FreshTests) -> LimitingCauses | None:
    """Return how much each cause contributes to one predicted parameter, such as A, of an axis with
    the correction ``new``. ``fresh``: simulated repetitions of the first test at new targets. None:
    no parameter can be judged.

    The parameter is the first of A, E, ... that the first test has. The contribution of a cause is
    the change of the parameter when this cause alone is removed.

    The causes that `shortfalls` names add up to that part of the known error that the table does
    not correct. The median of the prediction does not contain the periods that the test leaves open
    (`FreshTests.band`): the contribution of these is the amount that they would add.
    """
    name = judged_parameter(work.results[0])
    if name is None:
        return None
    change = difference(new, work.active)
    shown = partial(_shown, fresh, name)
    then, now = shown(change), shown(difference(work.as_found, work.active))
    least = shown(change, known=False, unknown=False, warm=False)
    without_outliers = shown(change, cured=("tails",))
    causes = [
        # Scatter without the few outliers, which are given in units of the same scatter: the
        # outliers are removed first.
        LimitingCause(
            cause=NOISE, value=without_outliers.median - shown(change, cured=("scatter",)).median
        ),
        *(
            LimitingCause(cause=cause, value=then.median - without.median, rms=rms)
            for cause, without, rms in _without(work, fresh, change, shown, without_outliers)
        ),
    ]
    waves = fresh.open_waves()
    if waves is not None:
        causes.append(
            LimitingCause(cause=HIDDEN, value=shown(change, waves=waves).median - then.median)
        )
    worth = [
        cause
        for cause in causes
        if cause.rms is not None or abs(cause.value) > _WORTH_SAYING * abs(then.median)
    ]
    return LimitingCauses(
        parameter=name,
        now=now.median,
        then=then.median,
        least=least.median,
        spread=parameter_spread(then),
        causes=tuple(sorted(worth, key=lambda cause: -cause.value)),
    )


class _ShownParameter(Protocol):
    """A function that returns one parameter of the simulated tests, with the arguments of
    `FreshTests.quantiles`.
    """

    def __call__(self, change: Correction, **taken: Any) -> Quantiles:
        """Return the quantiles of the parameter after a ``change`` of the correction."""


def _shown(fresh: FreshTests, name: str, change: Correction, **taken: Any) -> Quantiles:
    return fresh.quantiles(change, only=name, **taken)[name]


def _without(
    work: AxisWork,
    fresh: FreshTests,
    change: Correction,
    shown: _ShownParameter,
    without_outliers: Quantiles,
) -> Iterator[tuple[str, Quantiles, float | None]]:
    """Yield each cause with two results: the parameter of simulated tests without this cause
    (``without_outliers``: the parameter without outlying readings), and the rms error (mm or deg)
    by this cause, None where that is unknown.
    """
    for cause, parts in _SCATTERING.items():
        if fresh.has(parts):
            yield cause, without_outliers if cause == OUTLIERS else shown(change, cured=parts), None
    if np.any(fresh.slopes):
        yield WARM, shown(change, warm=False), None
    yield UNKNOWN, shown(change, unknown=False), None
    wanted, fitted, capacity = work.planned.wanted, work.planned.fitted, work.capacity
    if wanted is None or capacity is None:
        yield NO_TABLE, shown(change, known=False), None
        return
    if fitted is None:
        short = unheld_period(wanted, capacity, work.planned.request)
        if short is None:
            yield NO_TABLE, shown(change, known=False), None
            return
        # A table could take away all but the period.
        lack, known = short[0], difference(work.as_found, as_curve(wanted))
        yield lack.cause, shown(difference(change, lack.curve)), lack.rms
        yield NO_TABLE, shown(difference(change, difference(known, lack.curve))), None
        return
    applied = applied_compensation(fitted.compensation, work.planned.axis)
    if applied is not fitted.compensation:
        lost = difference(applied.at, fitted.compensation.at)
        yield NEVER_APPLIED, shown(difference(change, lost)), None
    for lack in shortfalls(wanted, fitted, capacity):
        yield lack.cause, shown(difference(change, lack.curve)), lack.rms
