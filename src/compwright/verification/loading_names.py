"""Choice of the name of a loading verdict (such as ``loaded`` or ``inverted``) by the probabilities
of the hypotheses, and the other names that remain possible.

The other names are those that no test can distinguish from the most probable one, and those that
this test does not distinguish.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.verification import Candidate, LoadingName
from compwright.verification.hypothesis import UNKNOWN_FACTOR
from compwright.verification.hypothesis_rating import RatedHypothesis, distances
from compwright.verification.likelihood import AfterMeans

#: A test that fits is refused in 1 of 1000 cases by what is left over, and by a slope beyond what
#: is declared: normal score.
REFUSED: Final = 3.09
#: No two tests are closer in temperature, mm/mm: 0.03 K of steel.
LEAST_SLOPE: Final = 0.3e-6
#: Largest logarithm of odds that is given; also used where there is no second name.
_CERTAIN: Final = 1e6
#: Distance between two names, in standard errors, from which nearly every test tells them apart.
_TELLING: Final = 8.0
#: Least probability of a candidate that is listed.
_LISTED: Final = 0.005
#: Names of a table that is as planned, or as before.
_NO_FAULT: Final = ("loaded", "thermal", "not_active", "measurement")


@dataclass(frozen=True, slots=True)
class NamedLoading:
    """The name of a loading verdict that a test supports, and the other names that the test does
    not exclude.

    - ``best``: the most probable hypothesis of the most probable name. ``fits``: whether the test
      fits it.
    - ``equivalent``: the names of all hypotheses within one standard error of it. ``together``: the
      probability of all these.
    - ``near``: names that this test hardly distinguishes from it.
    - ``margin``: logarithm of the odds against the most probable other name.
    - ``hidden``: the test would be the same whether the table is loaded or not.
    """

    best: RatedHypothesis
    fits: bool
    together: float
    equivalent: tuple[LoadingName, ...]
    near: tuple[LoadingName, ...]
    candidates: tuple[Candidate, ...]
    margin: float
    hidden: bool


def name_loading(
    after: AfterMeans, rated: Sequence[RatedHypothesis], declared_slope: float | None
) -> NamedLoading:
    """Return the name of the loading verdict from the ``rated`` hypotheses, with its odds and
    equivalent names.

    ``declared_slope``: as in `judge_loading`.
    """
    totals: dict[LoadingName, float] = {}
    for each in rated:
        totals[each.name] = totals.get(each.name, 0.0) + each.probability
    name = max(totals, key=lambda one: totals[one])
    if name in ("loaded", "thermal"):
        name = _loaded_or_thermal(rated, declared_slope)
    best = max((each for each in rated if each.name == name), key=lambda each: each.log)
    far = _distances_from(after, best, rated)
    fits = best.score <= REFUSED
    counted: set[LoadingName] = {name}
    if name in ("loaded", "thermal"):
        counted = {"loaded", "thermal"}
    # A test that fits as it stands, and better than turned, has values that turning hardly changes.
    together = sum(
        each.probability
        for each, off in zip(rated, far, strict=True)
        if each.name in counted or off <= 1.0 or (fits and each.hypothesis.read in counted)
    )
    equivalent = _equivalent(best, far, rated)
    hidden = {"loaded", "not_active"} <= {name, *equivalent}
    excluded: set[LoadingName] = {*counted, *equivalent}
    if fits and any(each.hypothesis.read in counted for each in rated):
        excluded.add("measurement")
    return NamedLoading(
        best=best,
        fits=fits,
        together=together,
        equivalent=equivalent,
        near=tuple(one for one in _near(far, rated) if one != name),
        candidates=_candidates(rated, totals),
        margin=0.0 if hidden else _margin(rated, counted, excluded),
        hidden=hidden,
    )


def _distances_from(
    after: AfterMeans, best: RatedHypothesis, rated: Sequence[RatedHypothesis]
) -> FloatArray:
    """Return the distance of each of the ``rated`` hypotheses, in standard errors, from the
    ``best`` one; that of another possible fault from the nearest possible variant of the best name,
    because it may be the same test as this variant.
    """
    far = distances(after, best, rated)
    if best.name in _NO_FAULT:
        return far
    possible = [index for index, each in enumerate(rated) if each.probability >= _LISTED]
    others = [i for i in possible if rated[i].name not in (best.name, *_NO_FAULT)]
    for each in (rated[index] for index in possible):
        way = each.hypothesis
        limit = way.inner or way.sloped or way.free is not None
        if each.name == best.name and not limit:
            near = distances(after, each, [rated[index] for index in others])
            far[others] = np.minimum(far[others], near)
    return far


def _margin(
    rated: Sequence[RatedHypothesis],
    names: Collection[LoadingName],
    excluded: Collection[LoadingName],
) -> float:
    """Return the logarithm of the odds that one of ``names`` is right, compared with the most
    probable name that is not ``excluded``.
    """

    def together(chosen: Collection[LoadingName]) -> float:
        logs = np.array([each.log for each in rated if each.name in chosen])
        return float(logs.max() + np.log(np.sum(np.exp(logs - logs.max()))))

    others = {each.name for each in rated} - set(excluded)
    return (
        min(together(names) - max(map(together, ((one,) for one in others))), _CERTAIN)
        if others
        else _CERTAIN
    )


def _loaded_or_thermal(
    rated: Sequence[RatedHypothesis], declared_slope: float | None
) -> LoadingName:
    """Return the name ``loaded``, or ``thermal`` if the slope of the test is larger than the
    declared uncertainty explains.
    """
    plain = next(each for each in rated if each.name == "loaded")
    if declared_slope is None:
        return "loaded"
    slope, error = plain.slope
    beyond = abs(slope) > REFUSED * math.hypot(error, math.hypot(declared_slope, LEAST_SLOPE))
    return "thermal" if beyond else "loaded"


def _equivalent(
    best: RatedHypothesis, far: FloatArray, rated: Sequence[RatedHypothesis]
) -> tuple[LoadingName, ...]:
    """Return the names of verdicts that no test could distinguish from the ``best`` hypothesis.
    ``far``: the distance of each ``rated`` hypothesis from the best one, in standard errors.

    Two kinds are left out. One is a hypothesis near its limit, where it equals a loaded table or no
    table (a factor near one, a cut near an end, a small slope). The other is an unknown factor of
    about -1 if the best hypothesis is an inverted table.
    """
    limit = best.name in ("loaded", "not_active")
    found: dict[LoadingName, None] = {}
    for each, off in zip(rated, far, strict=True):
        if each.name in (best.name, "measurement") or off > 1.0:
            continue
        if limit and (each.hypothesis.inner or each.hypothesis.sloped):
            continue
        if each.hypothesis.sloped and each.name != "thermal":
            continue
        if best.name == "inverted" and each.hypothesis.free is not None:
            continue
        found[each.name] = None
    return tuple(found)


def _near(far: FloatArray, rated: Sequence[RatedHypothesis]) -> tuple[LoadingName, ...]:
    """Return the names of those verdicts that this test hardly distinguishes from the most probable
    one. ``far``: the distance of each ``rated`` hypothesis from the most probable one, in standard
    errors.

    Variants that can come arbitrarily close (a cut near an end, an unknown factor or slope) and
    faults of measurement are left out.
    """
    return tuple(
        dict.fromkeys(
            each.name
            for each, off in zip(rated, far, strict=True)
            if off < _TELLING
            and each.name != "measurement"
            and each.hypothesis.free is None
            and not (each.hypothesis.inner or each.hypothesis.sloped)
        )
    )


def _candidates(
    rated: Sequence[RatedHypothesis], totals: dict[LoadingName, float]
) -> tuple[Candidate, ...]:
    ordered = sorted(totals, key=lambda one: -totals[one])
    excluded = [one for one in ordered if totals[one] >= _LISTED] or ordered[:1]
    return tuple(
        Candidate(
            verdict=one,
            probability=totals[one],
            detail=max((e for e in rated if e.name == one), key=lambda e: e.log).hypothesis.detail,
        )
        for one in excluded
    )


def factor_of(best: RatedHypothesis) -> float:
    """Return the factor by which the planned table is multiplied under a hypothesis; if the
    hypothesis leaves the factor open, as estimated from the test.
    """
    way = best.hypothesis
    if way.name != "scaled" or way.free is None:
        return way.factor
    size = float(np.sum(way.free**2))
    return 1.0 + best.amount[0] * UNKNOWN_FACTOR if size > 0.0 else 1.0
