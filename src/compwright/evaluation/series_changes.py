"""Search a series of tests of one axis or plane for changes that exceed the uncertainty."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, timedelta
from itertools import pairwise
from typing import Final

import numpy as np

from compwright.evaluation.change_significance import (
    UNDECLARED_SLOPE,
    Change,
    UncertainValue,
    difference,
    scatter_changed,
)
from compwright.evaluation.forecasts import Ahead, error_curve, reached
from compwright.evaluation.trends import Trend, TrendJump, trend_of
from compwright.records.axis import FloatArray
from compwright.records.history import (
    HistoryEntry,
    NotedChange,
    NotedJump,
    NotedTrend,
    SameTable,
)

#: Judged parameters. The others follow from these (E, R), or depend on single readings (G).
JUDGED = ("A", "B", "B_mean", "s", "squareness")
#: They depend on the targets: judged only between tests at the same targets, to one standard.
_OF_TARGETS = frozenset({"A", "E", "M", "R", "B"})
#: Targets are the same within this share of the measured length.
_SAME_TARGET = 1e-3
#: Two tests are copies from this many means on, equal to the last digits of a record, µm or arcsec.
_ENOUGH_MEANS: Final = 10
_SAME_VALUE: Final = 1e-6
#: Comparisons from which the scatter from test to test is taken.
_LEAST_COMPARISONS: Final = 4
#: Share of each measured length that has to be common to both.
_COMMON = 0.8


def noted_changes(
    entries: Sequence[HistoryEntry], trends: Sequence[NotedTrend]
) -> list[NotedChange]:
    """Return the changes between the tests of one axis or plane that exceed the uncertainty.
    ``entries``: the tests, in order of time. ``trends``: trends of the same tests by
    `noted_trends`.

    Each test is compared with the last comparable test before it. The scatter from test to test is
    taken from the other comparisons of the same parameter, as far as they exceed their standard
    errors. The threshold allows for the number of comparisons. A change between the tests of a jump
    in ``trends`` counts as the only comparison, so it needs less evidence.
    """
    jumped = {
        (trend.parameter, jump.before, jump.after) for trend in trends for jump in trend.jumps
    }
    pairs_of_jumps = {(before, after) for _, before, after in jumped}
    compared = {
        parameter: [
            (earlier, place)
            for place in range(len(entries))
            if (earlier := _last_comparable(entries, place, parameter)) is not None
        ]
        for parameter in JUDGED
    }
    comparisons = sum(map(len, compared.values()))
    found = []
    for parameter, pairs in compared.items():
        usual = {
            pair: _compared(entries[pair[0]], entries[pair[1]], parameter)[0]
            for pair in pairs
            if (parameter, *pair) not in jumped
        }
        for pair in pairs:
            others = [other for each, other in usual.items() if not set(each) & set(pair)]
            one, entry = entries[pair[0]], entries[pair[1]]
            change, undeclared = _compared(one, entry, parameter, _between_tests(others))
            if change.clear(1 if pair in pairs_of_jumps else comparisons):
                found.append(
                    NotedChange(
                        parameter=parameter,
                        before=pair[0],
                        after=pair[1],
                        value_before=one.values[parameter],
                        value_after=entry.values[parameter],
                        size=change.size,
                        std_error=change.std_error,
                        score=change.score,
                        chance=change.chance,
                        table=same_table(one, entry),
                        undeclared=undeclared,
                    )
                )
    return sorted(found, key=lambda change: change.after)


def _between_tests(others: Sequence[Change]) -> tuple[float, float]:
    """Return the variance from test to test, and its degrees of freedom. ``others``: changes of the
    same parameter between other tests.

    The variance is the part of the squared changes that exceeds their standard errors. With fewer
    than four changes, it is 0 and the degrees of freedom are infinite. Otherwise the degrees of
    freedom are two thirds of the number of changes, because neighbouring changes share a test.
    """
    if len(others) < _LEAST_COMPARISONS:
        return 0.0, math.inf
    excess = [change.size**2 - change.std_error**2 for change in others]
    return max(0.0, math.fsum(excess) / len(others)), 2.0 * len(others) / 3.0


#: Parameters whose rate per year is estimated.
_TRENDS: Final = ("A", "E", "M", "R", "B", "B_mean", "s", "slope", "squareness", "G_bidirectional")
#: What no compensation table changes: the scatter of the machine.
_SCATTER: Final = frozenset({"R", "s"})
#: What depends on the length of the scale, so on temperature and instrument.
_OF_LENGTH: Final = frozenset({"A", "E", "M", "slope"})
#: Prior probability of a jump between two tests: the same table, files that do not say, another
#: instrument; and where another parameter jumped, as after a collision.
_SAME, _UNKNOWN, _INSTRUMENT, _OTHER_JUMPED = 0.02, 0.2, 0.3, 0.5
#: Parameters that are estimated first: the reversal does not depend on temperature and shows a jump
#: best, the slope next.
_FIRST: Final = ("B_mean", "B", "slope")
#: A rate is clear if its opposite sign is less probable than this: 0.7 % in both directions for
#: the parameters that show wear first, 0.1 % for the others. The two of these and the six others of
#: an axis are thus clear on at most 2 % of stable machines.
_OPPOSITE: Final = {"B_mean": 0.0035, "slope": 0.0035, "squareness": 0.0035}
_OPPOSITE_OF_OTHERS: Final = 0.0005
#: Probability that a jump of these parameters is an adjustment, which takes back what has grown:
#: as likely as all other events together.
_SET_BACK: Final = 0.5
_DAYS: Final = 365.25


def noted_trends(entries: Sequence[HistoryEntry]) -> Iterator[NotedTrend]:
    """Yield the rate per year of each parameter, from the dated tests that can be compared with the
    last one. ``entries``: the tests, in order of time.

    A jump of one parameter makes jumps of the other parameters between the same tests likely.
    Otherwise a collision could look like growth: it may tilt the error curve by less than the
    temperature uncertainty.
    """
    found: dict[str, _Course] = {}
    for parameter in (*_FIRST, *(name for name in _TRENDS if name not in _FIRST)):
        jumps = [jump for tests, trend in found.values() for jump in tests.noted(trend.jumps)]
        compared = _compared_tests(entries, parameter, jumps)
        trend = None if compared is None else compared.trend()
        if compared is not None and trend is not None:
            found[parameter] = (compared, trend)
    for parameter in _TRENDS:
        if parameter in found:
            yield _noted(parameter, found)


@dataclass(frozen=True, slots=True, kw_only=True)
class _ComparedTests:
    """The tests of one parameter that were made in the same way as its last test.

    ``places``: indices of these tests in the whole series. ``odds``: prior probability of a jump
    after each test.
    """

    parameter: str
    entries: Sequence[HistoryEntry]
    places: Sequence[int]
    days: Sequence[datetime]
    odds: Sequence[float]

    def values(self, name: str) -> FloatArray:
        """Return the parameter ``name`` of each test, 0 where a test lacks it."""
        return np.array([entry.values.get(name, 0.0) for entry in self.entries])

    def trend(self, by_curve: FloatArray | None = None) -> Trend | None:
        """Return the trend of the parameter. ``by_curve``, the part of the parameter that follows
        from the error curve, is subtracted first.
        """
        name = self.parameter
        of_temperature = [_stated(entry, name) for entry in self.entries]
        return trend_of(
            np.array([_years(self.days[0], day) for day in self.days]),
            self.values(name) - (0.0 if by_curve is None else by_curve),
            np.array([entry.errors.get(name, (0.0, 1.0))[0] for entry in self.entries]),
            np.array(of_temperature) * (by_curve is None),
            self.odds,
            _OPPOSITE.get(name, _OPPOSITE_OF_OTHERS),
            _SET_BACK if name in _OPPOSITE else 0.0,
        )

    def noted(self, jumps: Sequence[TrendJump]) -> tuple[NotedJump, ...]:
        """Return the ``jumps`` of a trend, with the test indices of the whole series instead of
        those of the compared tests.
        """
        return tuple(
            NotedJump(
                before=self.places[jump.before],
                after=self.places[jump.before + 1],
                size=jump.size,
                std_error=jump.std_error,
            )
            for jump in jumps
        )


#: Comparable tests of a parameter, and their trend.
_Course = tuple[_ComparedTests, Trend]


def _compared_tests(
    entries: Sequence[HistoryEntry], parameter: str, jumps: Sequence[NotedJump]
) -> _ComparedTests | None:
    """Return the tests of one parameter that can be compared with its last test, or None if there
    are fewer than two. ``jumps``: jumps already found in the trends of other parameters.
    """
    having = [
        place for place, entry in enumerate(entries) if entry.day and parameter in entry.values
    ]
    places = [place for place in having if _alike(entries[place], entries[having[-1]], parameter)]
    if len(places) < 2:
        return None
    found = [entries[place] for place in places]
    odds = [
        max(
            _jump_odds(entries[one], entries[other], parameter),
            _OTHER_JUMPED if any(one < jump.after <= other for jump in jumps) else 0.0,
        )
        for one, other in pairwise(places)
    ]
    return _ComparedTests(
        parameter=parameter,
        entries=found,
        places=places,
        days=[datetime.fromisoformat(entry.day) for entry in found],
        odds=odds,
    )


def _years(one: datetime, other: datetime) -> float:
    return (other - one).total_seconds() / 86400.0 / _DAYS


def _forecast(limit: float, found: Mapping[str, _Course], parameter: str) -> Ahead:
    """Return when a parameter reaches its limit, from the trends of the parameter, of the slope and
    of the mean reversal error. ``found``: comparable tests and trend of each parameter.

    The error curve is averaged over the tests since the last event (another table, a jump). All
    dates are None if none of the three trends is clear.
    """
    tests, own = found[parameter]
    if not any(found[name][1].clear for name in (parameter, "slope", "B_mean") if name in found):
        return (None, None, None)
    events = [place + 1 for place, odds in enumerate(tests.odds) if odds >= _OTHER_JUMPED]
    curve = error_curve(parameter, tests.entries[max(events, default=0) :])
    # A limit is one of the size: lost motion makes the mean reversal value negative.
    toward = -1.0 if tests.entries[-1].values[parameter] < 0.0 else 1.0
    random = np.random.default_rng(0)
    if curve is None:
        return reached(limit, toward * own.lines(random))
    by_curve = curve.value(tests.values("slope"), tests.values("B_mean"))
    rest = tests.trend(by_curve) or own
    slope, reversal = (
        found[name][1].lines(random, _years(found[name][0].days[-1], tests.days[-1]))
        if name in found
        else np.zeros(2)
        for name in ("slope", "B_mean")
    )
    left = rest.lines(random)
    # All tests share this part: the date is that of the machine, not that of the instrument.
    U, coverage = tests.entries[-1].declared.get("slope", (0.0, 1.0))
    level = slope[0] + U / coverage * random.standard_normal(left.shape[1])
    return reached(limit, left, curve, np.stack([level, np.zeros_like(level) + slope[1]]), reversal)


def _noted(parameter: str, found: Mapping[str, _Course]) -> NotedTrend:
    tests, trend = found[parameter]
    limit = tests.entries[-1].limits.get(parameter)
    ahead = (None, None, None) if limit is None else _forecast(limit, found, parameter)
    earliest, day, latest = (
        "" if years is None else (tests.days[-1] + timedelta(days=years * _DAYS)).date().isoformat()
        for years in ahead
    )
    return NotedTrend(
        parameter=parameter,
        rate=trend.rate,
        interval=trend.interval,
        std_error=trend.std_error,
        clear=trend.clear,
        tests=tuple(tests.places),
        jumps=tests.noted(trend.jumps),
        limit=limit,
        reached=day,
        earliest=earliest,
        latest=latest,
    )


def _stated(entry: HistoryEntry, parameter: str) -> float:
    """Return the standard uncertainty of a parameter due to temperature: the declared uncertainty
    or, if none is declared, the effect of 1 K on a linear axis of steel.
    """
    if entry.kind == "circular" or parameter not in _OF_LENGTH:
        return 0.0
    length = max(entry.targets, default=0.0) - min(entry.targets, default=0.0)
    per_metre = 1000.0 / length if parameter == "slope" and length else 1.0
    U, coverage = entry.declared.get("E" if parameter == "slope" else parameter, (0.0, 1.0))
    if U:
        return per_metre * U / coverage
    return 0.0 if entry.rotary else per_metre * UNDECLARED_SLOPE * length / 1000.0


def _jump_odds(one: HistoryEntry, other: HistoryEntry, parameter: str) -> float:
    """Return the prior probability that an event other than wear changed the parameter between two
    tests.
    """
    if parameter not in _SCATTER:
        table = same_table(one, other)
        if table == "changed":
            return 1.0
        if table == "unknown":
            return _UNKNOWN
    if parameter in _OF_LENGTH and one.instrument != other.instrument:
        return _INSTRUMENT
    return _SAME


def _last_comparable(entries: Sequence[HistoryEntry], of: int, parameter: str) -> int | None:
    for place in reversed(range(of)):
        if _comparable(entries[place], entries[of], parameter):
            return place
    return None


def _comparable(one: HistoryEntry, other: HistoryEntry, parameter: str) -> bool:
    have = all(parameter in each.values and parameter in each.errors for each in (one, other))
    return have and _alike(one, other, parameter)


def _alike(one: HistoryEntry, other: HistoryEntry, parameter: str) -> bool:
    """Return whether two tests measured a parameter in the same way."""
    if one.unit != other.unit:
        return False
    if one.kind == "circular":
        return True
    if parameter in _OF_TARGETS:
        return one.standard == other.standard and _same_targets(one.targets, other.targets)
    return _common_length(one.targets, other.targets)


def _same_targets(one: Sequence[float], other: Sequence[float]) -> bool:
    if len(one) != len(other) or not one:
        return False
    allowed = _SAME_TARGET * (max(one) - min(one))
    return bool(np.all(np.abs(np.sort(one) - np.sort(other)) <= allowed))


def _common_length(one: Sequence[float], other: Sequence[float]) -> bool:
    if not one or not other:
        return False
    common = min(max(one), max(other)) - max(min(one), min(other))
    return all(common >= _COMMON * (max(each) - min(each)) for each in (one, other))


def _compared(
    one: HistoryEntry,
    other: HistoryEntry,
    parameter: str,
    scatter: tuple[float, float] = (0.0, math.inf),
) -> tuple[Change, bool]:
    """Return the change of a parameter between two tests, and whether the uncertainty of this
    change includes an assumed slope.

    ``scatter``: variance from test to test, with its degrees of freedom; by default there is none.
    The slope is the expansion of steel for 1 K. It is assumed for A of a linear axis if one of the
    tests declares no uncertainty.
    """
    before, after = _parameter_value(one, parameter), _parameter_value(other, parameter)
    if parameter == "s":
        return scatter_changed(before, after), False
    undeclared = (
        parameter == "A"
        and not other.rotary
        and not (one.declared.get("A") and other.declared.get("A"))
    )
    length = max(other.targets) - min(other.targets) if undeclared else 0.0
    assumed = UNDECLARED_SLOPE * length / 1000.0
    return difference(before, after, assumed, scatter), undeclared


def _parameter_value(entry: HistoryEntry, parameter: str) -> UncertainValue:
    error, dof = entry.errors[parameter]
    U, coverage = entry.declared.get(parameter, (0.0, 1.0))
    return UncertainValue(entry.values[parameter], error, dof, U / coverage)


def same_table(one: HistoryEntry, other: HistoryEntry) -> SameTable:
    """Return whether the same compensation table was active in two tests, as far as their files
    show.
    """
    if not one.acting or not other.acting:
        return "unknown"
    if one.acting == other.acting:
        return "same"
    if one.folder == other.folder or "none" in (one.acting, other.acting):
        return "changed"
    return "unknown"  # a backup saved later is another file with the same table


def same_readings(one: HistoryEntry, other: HistoryEntry) -> bool:
    """Return whether two positioning tests with scatter agree in scatter and in the mean deviations
    at all targets, except for a constant (the instrument's zero).
    """
    scatter = [entry.values.get("s", 0.0) for entry in (one, other)]
    if min(scatter) <= _SAME_VALUE or abs(scatter[0] - scatter[1]) > _SAME_VALUE:
        return False
    means = [np.concatenate(entry.means) for entry in (one, other)]
    if one.targets != other.targets or not means[0].size == means[1].size >= _ENOUGH_MEANS:
        return False
    return float(np.ptp(means[0] - means[1])) <= _SAME_VALUE


def without_repeats(entries: Sequence[HistoryEntry]) -> Iterator[HistoryEntry]:
    """Yield the tests of one axis or plane, each test only once, even if several jobs used it.

    An entry that states which table was active takes precedence over one that does not.
    """
    kept: dict[tuple[str, ...], HistoryEntry] = {}
    for entry in entries:
        key = tuple(sorted(entry.sources)) or (entry.folder, str(entry.number))
        known = kept.get(key)
        if known is None or (known.taken == "before" and entry.taken == "after"):
            kept[key] = entry
    yield from kept.values()
