"""What did the control do after loading? The test after it against every way in which a table may
be loaded (`verification.hypotheses`), by joint likelihood of the tests before and after.

The deviation before stands as a belief that the tests before left, with its uncertainty; so the
noise of both sides counts (a plain regression of after minus before on the correction is biased,
because the noise of the before test is in both). The instrument's datum is free, once per test: an
offset of its own for each direction would hide a fault in the backlash. Whatever is not known is
integrated, never chosen to fit (Kass and Raftery, J. Am. Stat. Assoc. 90, 1995): a name wins by
probability, not by having more to adjust.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.verification import Candidate, LoadingName, LoadingVerdict
from compwright.verification.hypotheses import UNKNOWN_FACTOR, Hypothesis
from compwright.verification.likelihood import AfterMeans, Curves, fits_of
from compwright.verification.loading_words import (
    Shown,
    named_message,
    neither_message,
    open_message,
    slope_text,
    straight_line_message,
    thermal_message,
)
from compwright.verification.views import View

#: A name is given from this probability on, those that no test could tell from it counted with it.
CLEAR: Final = 0.99
#: A test that fits is refused in 1 of 1000 cases by what is left over, and by a slope beyond what
#: is declared: normal score.
_REFUSED: Final = 3.09
#: Standard deviation of a slope of any size, mm/mm: 3 K of steel.
_ANY_SLOPE: Final = 35e-6
#: No two tests are closer in temperature, mm/mm: 0.03 K of steel.
_LEAST_SLOPE: Final = 0.3e-6
#: Prior odds of all faults of loading on an axis that is longer or shorter now, two faults at once,
#: against a loaded table, and of a loaded table on one. Shared among them: a slope takes away what
#: a curve has of its own, and among hundreds of curves one always fits by chance.
_SLOPED: Final = 0.002
_THERMAL: Final = 0.2
#: Logarithm of odds beyond which nobody asks: a second name there is none.
_CERTAIN: Final = 1e6
#: Distance from the loaded table and the old control, in standard errors, from which a fault counts
#: in full.
_SEEN: Final = 3.0
#: Part of what the prediction and the old control leave that a fault may leave besides, where it
#: explains all the rest: a table's own detail, a cut elsewhere between two nodes.
_EXPLAINED: Final = 0.15
#: Distance between two names, in standard errors, from which nearly every test tells them apart.
_TELLING: Final = 8.0
#: From which probability on a candidate is told.
_TOLD: Final = 0.005


def judge_loading(
    after: AfterMeans,
    views: Sequence[View],
    *,
    declared_slope: float | None,
    further: Callable[[], Sequence[View]] = tuple,
) -> LoadingVerdict:
    """Return what the test ``after`` shows of the loading, by the hypotheses of all ``views``, and
    of those that ``further`` makes where the test fits neither the loaded table nor the control as
    it was before.

    The first view is the test as it stands; its first hypothesis of the name ``loaded`` and of the
    name ``not_active`` are what the message measures by. ``declared_slope``: standard deviation,
    mm/mm, of a slope between the tests by what is declared of temperature; None where no
    temperature makes a slope (angles).

    A name is given where its variants, with those within one standard error of it (norm of the
    difference of the noise-free tests, each less its mean, over s √(2/n)), have `CLEAR` of the
    probability and the test fits it. Else the verdict is ``undecided``; where nothing fits, with
    the finding CW-V001.
    """
    if after.count < 3:  # one value is the datum's: too little would be left to contradict
        return LoadingVerdict(
            verdict="undecided",
            margin=0.0,
            message="Cannot tell: the after test has fewer than 3 measured means.",
        )
    slope = None if declared_slope is None else math.hypot(declared_slope, _LEAST_SLOPE)
    rated, effect = _rated(after, views, slope)
    if not any(_stands(each) for each in rated):
        more = further()
        if more:
            rated, effect = _rated(after, [*views, *more], slope)
    return _decided(after, views[0], rated, effect, declared_slope)


@dataclass(frozen=True, slots=True)
class _Rated:
    """One hypothesis with what a test says of it: ``expected`` (2, m) the noise-free test by what
    fits best, ``probability``, ``score`` of what is left over, slope and factor with their
    standard errors.
    """

    hypothesis: Hypothesis
    name: LoadingName
    expected: FloatArray
    probability: float
    log: float
    score: float
    slope: tuple[float, float]
    amount: tuple[float, float]
    base: FloatArray


def _stands(each: _Rated) -> bool:
    """Return whether the test fits the loaded table, or the old control, as it stands."""
    return each.hypothesis.name in ("loaded", "not_active") and each.score <= _REFUSED


def _rated(
    after: AfterMeans, views: Sequence[View], slope: float | None
) -> tuple[list[_Rated], tuple[float, float]]:
    """Return all hypotheses with what the test says of them, and the part of the planned effect
    that it shows, 1 loaded and 0 not active, with its standard error (inf: there is none).
    """
    found: list[_Rated] = []
    effect = (0.0, math.inf)
    along = after.targets - after.targets.mean()
    for view in views:
        ways = view.hypotheses
        part = _effect(view.hypotheses)
        measured = ways if part is None else [*ways, part]
        sloped = slope is not None and all(each.name != "measurement" for each in ways)
        more = (0.0, _ANY_SLOPE) if sloped else (0.0,)
        fits = fits_of(after, view.belief, curves_of(measured), slope or 0.0, more)
        if part is not None and fits.amount[len(ways), 1] > 0.0:
            effect = (float(fits.amount[len(ways), 0]), float(fits.amount[len(ways), 1]))
        rows = [(index, way) for index, way in enumerate(ways)]
        if sloped:
            share = _SLOPED / max(1.0, sum(each.weight for each in ways if each.name != "loaded"))
            rows += [
                (len(measured) + index, _on_slope(way, share)) for index, way in enumerate(ways)
            ]
        for index, way in rows:
            expected = view.belief.mean + way.change
            amount = float(fits.amount[index, 0]) if way.free is not None else 0.0
            if way.free is not None:
                expected = expected + amount * way.free
            if way.sloped:
                expected = expected + fits.slope[index, 0] * along
            found.append(
                _Rated(
                    hypothesis=way,
                    name="thermal" if way.sloped and way.name == "loaded" else way.name,
                    expected=expected,
                    probability=0.0,
                    log=math.log(way.weight) + float(fits.log_likelihood[index]),
                    score=float(fits.score[index]),
                    slope=(float(fits.slope[index, 0]), float(fits.slope[index, 1])),
                    amount=(amount, float(fits.amount[index, 1])),
                    base=view.belief.mean,
                )
            )
    found = _relevant(after, found)
    logs = np.array([each.log for each in found])
    shares = np.exp(logs - logs.max())
    shares = shares / shares.sum()
    rated = [replace(each, probability=float(p)) for each, p in zip(found, shares, strict=True)]
    return rated, effect


def _relevant(after: AfterMeans, rated: Sequence[_Rated]) -> list[_Rated]:
    """Return the hypotheses, those that this test can hardly tell from a table that acts as
    planned, or not at all, with less weight, by the square of the distance up to `_SEEN` standard
    errors: they change nothing that the test could show.
    """
    ends = [
        next((each for each in rated if each.name == name), None)
        for name in ("loaded", "not_active")
    ]
    off = np.full(len(rated), math.inf)
    for end in ends:
        if end is not None:
            off = np.minimum(off, _distances(after, end, rated))
    counts = np.log(np.clip((off / _SEEN) ** 2, 1e-6, 1.0))
    return [
        each
        if each.name in ("loaded", "thermal", "not_active") or each.hypothesis.free is not None
        else replace(each, log=each.log + float(less))
        for each, less in zip(rated, counts, strict=True)
    ]


def _effect(ways: Sequence[Hypothesis]) -> Hypothesis | None:
    """Return the old control with any part of the planned effect; None where it is not asked."""
    loaded = next((each for each in ways if each.name == "loaded"), None)
    inactive = next((each for each in ways if each.name == "not_active"), None)
    if loaded is None or inactive is None:
        return None
    return replace(inactive, free=loaded.change - inactive.change, slack=0.0)


def _on_slope(way: Hypothesis, share: float) -> Hypothesis:
    """Return a way of loading on an axis that is longer or shorter now; ``share``: prior odds of a
    fault there against the fault alone.
    """
    odds = _THERMAL if way.name == "loaded" else share
    return replace(way, sloped=True, weight=odds * way.weight)


def curves_of(ways: Sequence[Hypothesis]) -> Curves:
    """Return the curves of hypotheses as the likelihood takes them."""
    return Curves(
        change=np.stack([each.change for each in ways], axis=2),
        free={number: each.free for number, each in enumerate(ways) if each.free is not None},
        slack=np.array([each.slack for each in ways]),
    )


# ---------------------------------------------------------------- names


def _decided(
    after: AfterMeans,
    view: View,
    rated: Sequence[_Rated],
    effect: tuple[float, float],
    declared_slope: float | None,
) -> LoadingVerdict:
    totals: dict[LoadingName, float] = {}
    for each in rated:
        totals[each.name] = totals.get(each.name, 0.0) + each.probability
    name = max(totals, key=lambda one: totals[one])
    if name in ("loaded", "thermal"):
        name = _acting(rated, declared_slope)
    best = max((each for each in rated if each.name == name), key=lambda each: each.log)
    far = _distances(after, best, rated)
    fits = best.score <= _REFUSED
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
    candidates = _candidates(rated, totals)
    told: set[LoadingName] = {*counted, *equivalent}
    if fits and any(each.hypothesis.read in counted for each in rated):
        told.add("measurement")
    margin = 0.0 if hidden else _margin(rated, counted, told)
    shown = Shown.of(after, view.belief, view.hypotheses, effect)
    clear = together >= CLEAR and not hidden and (fits or _explains(shown, best))
    verdict: LoadingName = name if clear else "undecided"
    nothing_fits = not clear and not any(each.score <= _REFUSED for each in rated)
    if nothing_fits:  # the least unlikely of what does not fit is no lead
        candidates, margin = (), 0.0
        text = neither_message(shown)
    elif clear:
        text = _named(shown, best, rated, equivalent, declared_slope or 0.0)
    else:
        text = open_message(shown, candidates, None if fits else best.expected)
    found: list[Finding] = []
    if nothing_fits:
        found.append(Finding("CW-V001", "warning", text))
    if verdict == "thermal":
        found.append(Finding("CW-V027", "warning", text))
    elif verdict not in ("loaded", "measurement", "undecided"):
        found.append(Finding("CW-V028", "warning", text))
    way = best.hypothesis
    return LoadingVerdict(
        verdict=verdict,
        margin=margin,
        message=text,
        equivalent=equivalent if clear else (),
        factor=_factor(best) if clear else 1.0,
        shift_nodes=way.shift_nodes if clear else 0,
        of=way.of if clear else None,
        detail=way.detail if clear else "",
        near=tuple(one for one in _near(far, rated) if one != name),
        candidates=candidates,
        slope=best.slope if way.sloped and not nothing_fits else None,
        findings=tuple(found),
    )


def _explains(shown: Shown, best: _Rated) -> bool:
    """Return whether a fault of the table explains nearly all of what neither the loaded table nor
    the old control does.
    """
    if best.name in ("loaded", "not_active", "thermal", "measurement"):
        return False
    if shown.loaded is None or shown.inactive is None:
        return False
    mine, *ends = (
        float(np.nanstd(shown.left(each))) for each in (best.expected, shown.loaded, shown.inactive)
    )
    return mine <= _EXPLAINED * min(ends)


def _margin(
    rated: Sequence[_Rated], names: Collection[LoadingName], told: Collection[LoadingName]
) -> float:
    """Return the logarithm of the odds for these names over the likeliest that is not ``told`` with
    them.
    """

    def together(chosen: Collection[LoadingName]) -> float:
        logs = np.array([each.log for each in rated if each.name in chosen])
        return float(logs.max() + np.log(np.sum(np.exp(logs - logs.max()))))

    others = {each.name for each in rated} - set(told)
    return (
        min(together(names) - max(map(together, ((one,) for one in others))), _CERTAIN)
        if (others)
        else _CERTAIN
    )


def _named(
    shown: Shown,
    best: _Rated,
    rated: Sequence[_Rated],
    equivalent: Sequence[LoadingName],
    declared: float,
) -> str:
    """Return what is said of a name that is given."""
    slope = slope_text(*best.slope, declared) if best.hypothesis.sloped else ""
    if best.name == "thermal":
        if "scaled" in equivalent:
            free = [each for each in rated if each.hypothesis.free is not None]
            return straight_line_message(slope, _factor(max(free, key=lambda each: each.log)))
        return thermal_message(shown, best.expected, slope)
    text = named_message(
        shown, best.name, best.hypothesis, best.expected, _factor(best), equivalent
    )
    return f"{text} {slope}".strip()


def _acting(rated: Sequence[_Rated], declared_slope: float | None) -> LoadingName:
    """Return ``loaded`` or ``thermal`` for a table that acts: thermal where the slope beside it is
    beyond what is declared.
    """
    plain = next(each for each in rated if each.name == "loaded")
    if declared_slope is None:
        return "loaded"
    slope, error = plain.slope
    beyond = abs(slope) > _REFUSED * math.hypot(error, math.hypot(declared_slope, _LEAST_SLOPE))
    return "thermal" if beyond else "loaded"


def _factor(best: _Rated) -> float:
    way = best.hypothesis
    if way.name != "scaled" or way.free is None:
        return way.factor
    size = float(np.sum(way.free**2))
    return 1.0 + best.amount[0] * UNKNOWN_FACTOR if size > 0.0 else 1.0


def _distances(after: AfterMeans, best: _Rated, rated: Sequence[_Rated]) -> FloatArray:
    """Return how far (H,) the noise-free tests of the hypotheses lie from that of the best, in
    standard errors; what is free in them takes the value that comes nearest.
    """
    used = np.isfinite(after.plain)
    along = np.broadcast_to(after.targets - after.targets.mean(), after.plain.shape)

    def flat(values: FloatArray) -> FloatArray:
        kept: FloatArray = values[used] - values[used].mean()
        return kept

    goal, slope = flat(best.expected), flat(along)
    off = []
    for each in rated:
        way = each.hypothesis
        left = goal - flat(each.base + way.change)
        if way.free is not None:
            columns = [flat(way.free), *([slope] if way.sloped else [])]
            matrix = np.column_stack(columns)
            left = left - matrix @ np.linalg.lstsq(matrix, left, rcond=None)[0]
        elif way.sloped:
            left = left - slope * (float(slope @ left) / float(slope @ slope))
        off.append(float(np.linalg.norm(left)))
    return np.array(off) / after.std_error


def _equivalent(best: _Rated, far: FloatArray, rated: Sequence[_Rated]) -> tuple[LoadingName, ...]:
    """Return the names that no test could tell from the best. What has the loaded table, or none,
    as its limit (a factor near one, a cut near an end, a small slope) is no other name there; nor
    is an unknown factor beside an inverted table, whose factor is -1.
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


def _near(far: FloatArray, rated: Sequence[_Rated]) -> tuple[LoadingName, ...]:
    """Return the names whose test lies so close to the best that this one says little of them.
    Variants that can come as close as they like (a cut near an end, an unknown factor or slope)
    are no question of it, nor is how the test was measured.
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


def _candidates(rated: Sequence[_Rated], totals: dict[LoadingName, float]) -> tuple[Candidate, ...]:
    ordered = sorted(totals, key=lambda one: -totals[one])
    told = [one for one in ordered if totals[one] >= _TOLD] or ordered[:1]
    return tuple(
        Candidate(
            verdict=one,
            probability=totals[one],
            detail=max((e for e in rated if e.name == one), key=lambda e: e.log).hypothesis.detail,
        )
        for one in told
    )
