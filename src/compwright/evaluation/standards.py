"""Evaluation of a positioning test to a standard: the parameters that each edition defines, for
which tests, and with which coverage factor.

The texts of 1988, 1997 and GOST 27843-2006 were available, and clauses 1 to 7 of 2006. The text of
2014 was not. It keeps the formulas of 2006 under other words ("error" for "deviation"), so the
definitions of 2006 are used. Its clause 6.2 (as quoted by GOST ISO 230-2-2016) leaves out s, R and
A for one approach per direction. VDI/DGQ 3441 is evaluated with the formulas in common use.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Final, Literal, TypeVar

import numpy as np

from compwright.evaluation.plan_checks import plan_findings
from compwright.evaluation.plausibility import plausibility_findings
from compwright.evaluation.reading_checks import position_text, reading_findings, sign_text, text_of
from compwright.evaluation.statistics import (
    ISO_NAMES,
    RANGE_FACTORS_1988,
    RANGE_FACTORS_GOST,
    VDI_NAMES,
    mean_deviation,
    parameters,
    repeatability,
    standard_deviation,
    standard_deviation_from_range,
    vdi_parameters,
    vdi_positional_scatter,
)
from compwright.evaluation.uncertainty import contributions, expanded_uncertainties
from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.foundations.findings import Finding
from compwright.foundations.key_faults import nearest
from compwright.records.axis import Direction, FloatArray
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.positioning import PositioningTest
from compwright.records.result import Extreme, PositioningResult, TargetColumns
from compwright.words.sentences import Sentence, SentenceText, say

Spread = Literal["std", "range"]
Entry = TypeVar("Entry")

DEFAULT_STANDARD: Final = "iso230-2:2014"


@dataclass(frozen=True, slots=True, kw_only=True)
class Standard:
    """One edition of a standard. ``coverage``: its factor k on s. ``undefined``: the reason for
    each parameter that it does not define.

    ``single_approach``: the clause that leaves out s, R and A for n = 1. ``range_factors``: by n,
    the factor of s = W * factor(n); None: it has no range method.
    """

    id: str
    title: str
    coverage: float
    single_approach: str
    names: tuple[str, ...] = ISO_NAMES
    undefined: Mapping[str, str] = field(default_factory=dict)
    range_factors: Mapping[int, float] | None = None


_NOT_IN_1988: Final = dict.fromkeys(
    ("E", "E_positive", "E_negative", "M", "B"),
    SentenceText(say("reason.undefined_1988")),
)

#: The standards by the ids of the command line.
STANDARDS: Final[Mapping[str, Standard]] = {
    standard.id: standard
    for standard in (
        Standard(
            id="iso230-2:1988",
            title="ISO 230-2:1988",
            coverage=3.0,
            single_approach="clause 4.3.3",
            undefined=_NOT_IN_1988,
            range_factors=RANGE_FACTORS_1988,
        ),
        Standard(
            id="iso230-2:1997", title="ISO 230-2:1997", coverage=2.0, single_approach="clause 5.2"
        ),
        Standard(
            id="iso230-2:2006", title="ISO 230-2:2006", coverage=2.0, single_approach="clause 5.2"
        ),
        Standard(
            id=DEFAULT_STANDARD,
            title="ISO 230-2:2014",
            coverage=2.0,
            single_approach="clause 6.2; in 2006 clause 5.2",
        ),
        Standard(
            id="gost27843:2006",
            title="GOST 27843-2006",
            coverage=2.0,
            single_approach="clause 6.2",
            range_factors=RANGE_FACTORS_GOST,
        ),
        Standard(
            id="vdi3441",
            title="VDI/DGQ 3441",
            coverage=3.0,
            single_approach="no standard deviation from one",
            names=VDI_NAMES,
        ),
    )
}

_NEED_S: Final = frozenset(
    {"A", "A_positive", "A_negative", "R", "R_positive", "R_negative", "P", "Ps_max", "Ps_mean"}
)
_MOST_LISTED: Final = 20  # targets that a finding names
_BOTH: Final = (Direction.POSITIVE, Direction.NEGATIVE)


def by_id(name: str, standards: Mapping[str, Entry], kind: str) -> Entry:
    """Return the standard with the id ``name``, or raise UsageError; ``kind``: for the message."""
    if name not in standards:
        family = nearest(name.partition(":")[0], {each.partition(":")[0] for each in standards})
        near = family and nearest(name, [each for each in standards if family in each], 0.0)
        raise UsageError(
            Fault(
                message=f"unknown {kind}",
                place="--standard",
                expected=", ".join(standards),
                found=name,
                hint=f"give `--standard {near}`" if near else "give one of these standards",
            )
        )
    return standards[name]


def standard_by_id(name: str, spread: str = "std") -> Standard:
    """Return the standard with the id ``name``. Raises UsageError for an unknown id, and for a
    ``spread`` (estimator of s) that the standard does not have.
    """
    standard = by_id(name, STANDARDS, "standard")
    if spread not in {"std", "range"}:
        raise UsageError(
            Fault(
                message="the estimator of the standard deviation s is unknown",
                place="--spread",
                expected="std or range",
                found=spread,
                hint="give `--spread std` or `--spread range`",
            )
        )
    if spread == "range" and standard.range_factors is None:
        having = ", ".join(
            other.id for other in STANDARDS.values() if other.range_factors is not None
        )
        raise UsageError(
            Fault(
                message=f"{standard.title} does not define the range method for the standard "
                "deviation s",
                place="--spread",
                expected=f"`--spread std`, or a standard with the range method: {having}",
                found=spread,
                hint="give `--spread std`, or `--standard` with one of these standards",
            )
        )
    return standard


def evaluate(
    test: PositioningTest,
    standard: str = DEFAULT_STANDARD,
    *,
    spread: Spread = "std",
    travel: tuple[float, float] | None = None,
    periods: Sequence[float] = (),
    budget: UncertaintyBudget | None = None,
    thermal: Thermal | None = None,
    reported: Collection[str] = (),
    other_tests: Sequence[PositioningTest] = (),
    checked: bool = True,
) -> PositioningResult:
    """Evaluate ``test`` (mm or deg) to ``standard``; the result is in mm or deg.

    ``spread``: "range" computes s from the range of the readings (1988 and GOST only). ``travel``,
    ``periods`` (mm or deg, machine coordinates) and ``other_tests`` of the axis are used by the
    test checks, ``budget`` and ``thermal`` by the uncertainty. ``reported``: codes of reading
    checks that the noise estimate reports already (`reading_findings`). ``checked``: run the test
    checks.

    A parameter is None if the standard does not define it, the approach direction was not measured,
    or a target lacks the two readings that s needs. ``not_applicable`` gives the reason. No
    parameter is formed over fewer targets than were measured. If targets lack readings, a finding
    gives R and A of the other targets.

    Raises UsageError for an unknown standard or a range method that does not exist for it or this
    n, InputError if the test holds no reading or its arrays do not fit together.
    """
    chosen = standard_by_id(standard, spread)
    _require_sound(test)
    columns = _columns(test, chosen, spread)
    measured = np.isfinite(columns.mean_positive) | np.isfinite(columns.mean_negative)
    values = _values(columns, chosen, measured)
    reasons = {
        name: chosen.undefined.get(name) or _reason(name, test, chosen, measured)
        for name, value in values.items()
        if name in chosen.undefined or not np.isfinite(value)
    }
    given = {name: None if name in reasons else float(value) for name, value in values.items()}

    def compare(other: PositioningTest) -> Sentence | None:
        return _comparison(test, given, other, chosen, spread)

    findings: list[Finding] = []
    if checked:
        findings += [*test.findings, *_target_findings(test, columns, chosen, measured)]
        findings += plausibility_findings(test)
        findings += plan_findings(test, chosen.id, travel, periods, other_tests)
        findings += reading_findings(test, compare, reported)
    uncertainty = None
    if budget is not None:
        uncertainty, remarks = expanded_uncertainties(
            test, given, chosen.coverage, budget, thermal, _estimator(chosen, spread)
        )
        findings += remarks
    return PositioningResult(
        test=test,
        standard=chosen.id,
        coverage=chosen.coverage,
        parameters=given,
        targets=columns,
        at=(at := _located(test, columns, given)),
        extremes=_extremes(test, columns, given, at, chosen.coverage),
        uncertainty=uncertainty,
        budget=(
            contributions(test, budget, thermal)
            if budget is not None and uncertainty is not None
            else ()
        ),
        not_applicable=reasons,
        findings=tuple(findings),
        spread=spread,
    )


def _require_sound(test: PositioningTest) -> None:
    m = test.targets.size
    faults = []
    if (
        test.positive.ndim != 2
        or test.negative.ndim != 2
        or test.positive.shape[0] != m
        or test.negative.shape[0] != m
    ):
        found = f"{m} targets, {test.positive.shape} in +, {test.negative.shape} in −"
        faults.append(
            Fault(
                message="the test does not have one row of readings for each target",
                file=test.name,
                expected="one row per target",
                found=found,
                hint="correct the file: one row of readings per target",
            )
        )
    elif not np.any(np.isfinite(test.positive)) and not np.any(np.isfinite(test.negative)):
        faults.append(
            Fault(
                message="the test contains no readings",
                file=test.name,
                hint="give a file with readings",
            )
        )
    if not np.all(np.isfinite(test.targets)) or np.any(np.diff(test.targets) <= 0.0):
        faults.append(
            Fault(
                message="target positions are not in ascending order",
                file=test.name,
                hint="sort the rows by target position",
            )
        )
    if faults:
        raise InputError(*faults)


def _estimator(standard: Standard, spread: str) -> Callable[[FloatArray], FloatArray]:
    """Return the function that computes s (..., m) from deviations (..., m, n)."""
    if spread == "range" and standard.range_factors is not None:
        return partial(standard_deviation_from_range, factors=standard.range_factors)
    return standard_deviation


def _columns(test: PositioningTest, standard: Standard, spread: str) -> TargetColumns:
    s = _estimator(standard, spread)
    mean_positive, mean_negative = mean_deviation(test.positive), mean_deviation(test.negative)
    s_positive, s_negative = s(test.positive), s(test.negative)
    reversal = mean_positive - mean_negative
    r_positive, r_negative, r = repeatability(reversal, s_positive, s_negative, standard.coverage)
    if standard.names is VDI_NAMES:  # VDI has no R_i; its 6 s of both directions together is used
        r_positive = r_negative = np.full(test.targets.size, np.nan)
        r = vdi_positional_scatter(s_positive, s_negative)
    return TargetColumns(
        mean_positive=mean_positive,
        mean_negative=mean_negative,
        s_positive=s_positive,
        s_negative=s_negative,
        reversal=reversal,
        mean=0.5 * (mean_positive + mean_negative),
        repeatability_positive=r_positive,
        repeatability_negative=r_negative,
        repeatability=r,
    )


def _values(
    columns: TargetColumns, standard: Standard, use: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]
) -> dict[str, float]:
    """Return all parameters from the targets marked in ``use``, NaN where data are missing."""
    if not np.any(use):
        return dict.fromkeys(standard.names, float("nan"))
    arguments = (
        columns.mean_positive[use],
        columns.s_positive[use],
        columns.mean_negative[use],
        columns.s_negative[use],
    )
    values = (
        vdi_parameters(*arguments)
        if standard.names is VDI_NAMES
        else parameters(*arguments, standard.coverage)
    )
    return {name: float(values[name]) for name in standard.names}


def _needed(name: str) -> tuple[Direction, ...]:
    if name.endswith("_positive"):
        return (Direction.POSITIVE,)
    return (Direction.NEGATIVE,) if name.endswith("_negative") else _BOTH


def _reason(
    name: str,
    test: PositioningTest,
    standard: Standard,
    measured: np.ndarray[tuple[int, ...], np.dtype[np.bool_]],
) -> str:
    """Return why the parameter ``name`` cannot be computed; ``measured``: targets with readings."""
    return SentenceText(_why(name, test, standard, measured))


def _why(
    name: str,
    test: PositioningTest,
    standard: Standard,
    measured: np.ndarray[tuple[int, ...], np.dtype[np.bool_]],
) -> Sentence:
    for direction in _needed(name):
        if not np.any(np.isfinite(test.deviations(direction))):
            return say("reason.not_measured", direction=sign_text(direction))
    for direction in _needed(name):
        number = test.readings(direction)
        if np.any(number[measured] == 0):
            where = position_text(float(test.targets[measured & (number == 0)][0]), test)
            return say("reason.no_reading", direction=sign_text(direction), position=where)
    counts = {direction: test.readings(direction)[measured] for direction in _needed(name)}
    if name in _NEED_S and all(number.max() == 1 for number in counts.values()):
        return say("reason.one_approach", clause=standard.single_approach)
    for direction, number in counts.items():
        if name in _NEED_S and number.min() < 2:
            where = position_text(float(test.targets[measured][number < 2][0]), test)
            return say("reason.one_reading", direction=sign_text(direction), position=where)
    return say("reason.cannot_be_formed")


def _located(
    test: PositioningTest, columns: TargetColumns, given: Mapping[str, float | None]
) -> dict[str, float]:
    """Return the target where each parameter has its extreme value (the first of equal targets)."""
    sources = {
        "R": columns.repeatability,
        "R_positive": columns.repeatability_positive,
        "R_negative": columns.repeatability_negative,
        "B": np.abs(columns.reversal),
        "Ps_max": columns.repeatability,
        "U_max": np.abs(columns.reversal),
    }
    return {
        name: float(test.targets[int(np.nanargmax(column))])
        for name, column in sources.items()
        if given.get(name) is not None
    }


def _extremes(
    test: PositioningTest,
    columns: TargetColumns,
    given: Mapping[str, float | None],
    at: Mapping[str, float],
    coverage: float,
) -> dict[str, tuple[Extreme, Extreme]]:
    """Return the highest and lowest values that determine A, E, M, R. ``at``: target of each R."""
    means = dict(zip(_BOTH, (columns.mean_positive, columns.mean_negative), strict=True))
    both = zip(_BOTH, (columns.s_positive, columns.s_negative), strict=True)
    spread = [(way, means[way] + coverage * s, means[way] - coverage * s) for way, s in both]
    sides: dict[str, list[tuple[Direction | None, FloatArray, FloatArray]]] = {
        "A": list(spread),
        "E": [(way, means[way], means[way]) for way in _BOTH],
        "M": [(None, columns.mean, columns.mean)],
    }
    for name in ("R", "R_positive", "R_negative"):
        there = np.where(test.targets == at.get(name), 0.0, np.nan)
        sides[name] = [(w, up + there, low + there) for w, up, low in spread if w in _needed(name)]
    return {
        name: (
            _extreme(test, [(way, high) for way, high, _ in bounds], 1.0),
            _extreme(test, [(way, low) for way, _, low in bounds], -1.0),
        )
        for name, bounds in sides.items()
        if given.get(name) is not None
    }


def _extreme(
    test: PositioningTest, bounds: Sequence[tuple[Direction | None, FloatArray]], sense: float
) -> Extreme:
    """Return the highest of all values of the curves ``bounds``; the lowest if ``sense`` is -1."""
    places = [(int(np.nanargmax(sense * values)), way, values) for way, values in bounds]
    index, way, values = max(places, key=lambda one: float(sense * one[2][one[0]]))
    return Extreme(float(values[index]), float(test.targets[index]), way)


def _target_findings(
    test: PositioningTest,
    columns: TargetColumns,
    standard: Standard,
    measured: np.ndarray[tuple[int, ...], np.dtype[np.bool_]],
) -> list[Finding]:
    """Return the finding CW-T015 if targets have no reading, and CW-T016 if targets have no s.
    CW-T016 states the parameters from the other targets.
    """
    findings = []
    if not np.all(measured):
        where = _listed(test.targets[~measured], test)
        findings.append(Finding.of("CW-T015", "warning", targets=where))
    directions = [d for d in _BOTH if np.any(np.isfinite(test.deviations(d)))]
    complete = measured & np.all([test.readings(d) >= 2 for d in directions], axis=0)
    if np.array_equal(complete, measured) or not np.any(complete):
        return findings
    where = _listed(test.targets[measured & ~complete], test)
    others = _values(columns, standard, complete)
    parameters = [
        say("parameter", parameter=name, value=text_of(value, test))
        for name, value in others.items()
        if name in {"A", "R", "P", "Ps_max"} and np.isfinite(value)
    ]
    findings.append(Finding.of("CW-T016", "warning", targets=where, others=parameters))
    return findings


def _listed(targets: FloatArray, test: PositioningTest) -> Sentence:
    shown = [position_text(float(x), test) for x in targets[:_MOST_LISTED]]
    return say("listed_places", items=shown, more=max(0, targets.size - _MOST_LISTED))


def _comparison(
    test: PositioningTest,
    given: Mapping[str, float | None],
    other: PositioningTest,
    standard: Standard,
    spread: str,
) -> Sentence | None:
    """Return a text that compares parameters with and without the readings that ``other`` lacks,
    such as "A 5.00 µm with it, 4.00 µm without". None if no parameter can be compared.
    """
    try:
        columns = _columns(other, standard, spread)
    except UsageError:  # fewer readings than the range method has factors for
        return None
    measured = np.isfinite(columns.mean_positive) | np.isfinite(columns.mean_negative)
    values = _values(columns, standard, measured)
    compared = []
    for name in ("A", "A_positive", "A_negative", "R", "R_positive", "R_negative", "P", "Ps_max"):
        value = given.get(name)
        one_way = name.endswith(("_positive", "_negative"))
        if (
            value is None
            or not np.isfinite(values[name])
            or (one_way and given.get(name[0]) is not None)
        ):
            continue
        compared.append(
            say(
                "with_and_without",
                parameter=name,
                value=text_of(value, test),
                without=text_of(values[name], test),
            )
        )
    return say("compared_not_removed", parameters=compared) if compared else None
