"""Decision whether the table was loaded: the test after loading is compared with every hypothesis
(`verification.loading_hypotheses`), by the joint likelihood of the tests before and after.

The deviation before loading is estimated from the tests before, with its uncertainty, so that the
noise of both tests is counted. A simple regression of after minus before on the correction would be
biased, because the noise of the test before is in both.

The instrument's datum is one unknown per test. One unknown per direction would hide a fault of the
backlash. All unknowns are integrated and none is fitted (Kass and Raftery, J. Am. Stat. Assoc. 90,
1995). Therefore a hypothesis with more adjustable values has no advantage.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.records.verification import LoadingName, LoadingVerdict
from compwright.verification.hypothesis_rating import RatedHypothesis, rate_hypotheses
from compwright.verification.likelihood import AfterMeans
from compwright.verification.loading_messages import (
    ShownTest,
    declared_slope_text,
    named_message,
    neither_message,
    open_message,
    slope_text,
    straight_line_message,
    thermal_message,
)
from compwright.verification.loading_names import (
    LEAST_SLOPE,
    REFUSED,
    NamedLoading,
    factor_of,
    name_loading,
)
from compwright.verification.measurement_cases import MeasurementCase
from compwright.words.sentences import Sentence, say

#: A name is given from this probability on, those that no test could tell from it counted with it.
CLEAR: Final = 0.99
#: Part of what the prediction and the old control leave that a fault may leave besides, where it
#: explains all the rest: a table's own detail, a cut elsewhere between two points.
_EXPLAINED: Final = 0.15


def judge_loading(
    after: AfterMeans,
    views: Sequence[MeasurementCase],
    *,
    declared_slope: float | None,
    further: Callable[[], Sequence[MeasurementCase]] = tuple,
    read_back: bool = False,
) -> LoadingVerdict:
    """Return the verdict on how the table was loaded, from the mean readings ``after`` loading.
    Each of the ``views`` contains an expected deviation and the hypotheses that start from it;
    ``further`` makes more of them, used if no hypothesis without a fault fits.

    The first view is the test as given. Its first hypotheses with the names ``loaded`` and
    ``not_active`` give the numbers of the message. ``declared_slope``: standard deviation, mm/mm,
    of a slope between the tests from the declared temperature uncertainty; None if temperature
    makes no slope (angles). ``read_back``: whether the values read back from the control are those
    of the plan.

    A name is given if the test fits it, and if its variants, together with all hypotheses within
    one standard error of them, have the probability `CLEAR`. The distance is the norm of the
    difference of the noise-free tests, each minus its mean, in units of s √(2/n). Otherwise the
    verdict is ``undecided``. If no hypothesis fits, there is also the finding CW-V001.
    """
    if after.count < 3:  # one value is the datum's: too little would be left to contradict
        return LoadingVerdict(
            verdict="undecided",
            margin=0.0,
            sentence=say("loading.too_few"),
        )
    slope = None if declared_slope is None else math.hypot(declared_slope, LEAST_SLOPE)
    found, effect = rate_hypotheses(after, views, slope)
    if not any(_fits_unchanged(each) for each in found):
        more = further()
        if more:
            found, effect = rate_hypotheses(after, [*views, *more], slope)
    first = views[0]
    shown = ShownTest.of(after, first.belief, first.hypotheses, effect, read_back=read_back)
    return _verdict(shown, name_loading(after, found, declared_slope), found, declared_slope)


def _fits_unchanged(each: RatedHypothesis) -> bool:
    """Return whether a hypothesis without any fault fits the test: the table is loaded, or the old
    correction is still active.
    """
    return each.hypothesis.name in ("loaded", "not_active") and each.score <= REFUSED


def _verdict(
    shown: ShownTest,
    names: NamedLoading,
    ways: Sequence[RatedHypothesis],
    declared_slope: float | None,
) -> LoadingVerdict:
    best = names.best
    clear = names.together >= CLEAR and not names.hidden and (names.fits or _explains(shown, best))
    if not clear and not any(each.score <= REFUSED for each in ways):
        return _neither(shown, names)
    if not clear:
        return LoadingVerdict(
            verdict="undecided",
            margin=names.margin,
            sentence=open_message(shown, names.candidates, None if names.fits else best.expected),
            near=names.near,
            candidates=names.candidates,
            slope=best.slope if best.hypothesis.sloped else None,
        )
    sentence = _sentence(shown, names, ways, declared_slope)
    way = best.hypothesis
    return LoadingVerdict(
        verdict=best.name,
        margin=names.margin,
        sentence=sentence,
        equivalent=names.equivalent,
        factor=factor_of(best),
        shift_nodes=way.shift_nodes,
        of=way.of,
        detail=way.detail,
        near=names.near,
        candidates=names.candidates,
        slope=best.slope if way.sloped else None,
        findings=_findings(best.name, sentence),
    )


def _neither(shown: ShownTest, names: NamedLoading) -> LoadingVerdict:
    """Return the verdict ``undecided`` for a test that fits no hypothesis, because the name of the
    most probable one would mislead. ``names``: this name, and the other names that are possible.
    """
    sentence = neither_message(shown)
    return LoadingVerdict(
        verdict="undecided",
        margin=0.0,
        sentence=sentence,
        near=names.near,
        findings=(Finding.of("CW-V001", "warning", verdict=sentence),),
    )


def _findings(verdict: LoadingName, sentence: Sentence) -> tuple[Finding, ...]:
    if verdict in ("loaded", "measurement"):
        return ()
    if verdict == "thermal":
        return (Finding.of("CW-V027", "warning", verdict=sentence),)
    return (Finding.of("CW-V028", "warning", verdict=sentence),)


def _explains(shown: ShownTest, best: RatedHypothesis) -> bool:
    """Return whether the ``best`` hypothesis, a faulty table, explains nearly all of the difference
    between the test and both the loaded table and the old correction.
    """
    if best.name in ("loaded", "not_active", "thermal", "measurement"):
        return False
    if shown.loaded is None or shown.inactive is None:
        return False
    mine, *ends = (
        float(np.nanstd(shown.left(each))) for each in (best.expected, shown.loaded, shown.inactive)
    )
    return mine <= _EXPLAINED * min(ends)


def _sentence(
    shown: ShownTest,
    names: NamedLoading,
    ways: Sequence[RatedHypothesis],
    declared_slope: float | None,
) -> Sentence:
    """Return the sentence that states a loading verdict. ``names``: the name of the verdict, and
    the other names that are possible; ``ways``: all hypotheses with their probabilities.
    """
    best, declared = names.best, declared_slope or 0.0
    if best.name == "thermal":
        slope = slope_text(*best.slope, declared)
        if "scaled" in names.equivalent:
            free = [each for each in ways if each.hypothesis.free is not None]
            return straight_line_message(
                shown, slope, factor_of(max(free, key=lambda each: each.log))
            )
        return thermal_message(shown, best.expected, slope)
    rise = None
    if best.name == "loaded":
        rise = declared_slope_text(*best.slope, declared)
    elif best.hypothesis.sloped:
        rise = slope_text(*best.slope, declared)
    sentences = named_message(
        shown, best.name, best.hypothesis, best.expected, factor_of(best), names.equivalent
    )
    return say("paragraph", sentences=[*sentences, *([] if rise is None else [rise])])
