"""Check whether the test after loading is credible, by comparison with the first test of its axis.

A named fault (`measurement_fault`) is certain, because only a fault of the measurement gives such
readings. A doubt (`doubts_of_test`) states that a proof is missing, and which measurement would
give it. All lengths are in mm or deg.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Final, Literal

import numpy as np

from compwright.evaluation.copied_runs import copied_runs
from compwright.evaluation.plausibility import (
    FEWEST_TARGETS,
    certain_fault,
    wrong_target_unit,
)
from compwright.evaluation.pooled_scatter import pooled_scatter, reading_range
from compwright.evaluation.reading_checks import position_text, text_of
from compwright.evaluation.statistics import mean_deviation
from compwright.foundations.dates import day_of
from compwright.foundations.findings import Finding
from compwright.foundations.serial_numbers import other_serials, serials
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.circular import CircularTest
from compwright.records.positioning import SAME_READING, PositioningTest
from compwright.records.verification import MeasurementFault
from compwright.words.sentences import Amount, Sentence, say

#: Honest tests of one axis scatter differently: another day, another averaging of the instrument.
#: Up to three times as quiet or as loud is believed; beyond, the ratio of the pooled variances has
#: to be as improbable as 1 in 1000 (normal score 3.09).
BELIEVED: Final = 3.0
IMPROBABLE: Final = 3.09
#: Readings rounded to a step scatter by 0.29 of it: a first test as coarse as that cannot say that
#: another one is too quiet.
_ROUNDED: Final = 0.5
#: The scatter of two tests has nothing to do with each other. Beyond this correlation, with so many
#: degrees of freedom, it was copied.
_COPIED: Final = 0.95
_ENOUGH: Final = 15
#: How much wider than the widest gap of the first test's targets a gap may be: targets dithered by
#: 0.3 of an interval give 1.6.
_GAP: Final = 2.0
_THOUSAND: Final = 1000.0
#: Degrees of freedom from which repeated readings say what is usual between them.
_FEW_REPEATS: Final = 5


@dataclass(frozen=True, slots=True)
class NamedFault:
    """A fault that the measurement certainly has: its name in the JSON (``of``), and the
    ``sentence`` with evidence and next step.
    """

    of: MeasurementFault
    sentence: Sentence


def measurement_fault(
    after: PositioningTest, first: PositioningTest, travel: tuple[float, float]
) -> NamedFault | None:
    """Return the fault that the test after loading certainly has, by comparison with the ``first``
    test of the axis, or None if no fault is certain.
    """
    spread = reading_range(after)
    if spread <= SAME_READING or any(finding.code == "CW-R009" for finding in after.findings):
        return NamedFault("zeros", say("CW-V026.zeros"))
    copy = _copied(after, first)
    if copy is not None:
        return NamedFault("copied", copy)
    unit = wrong_target_unit(after, travel) if not wrong_target_unit(first, travel) else ""
    if unit:
        return NamedFault("unit", say("CW-V026.targets", unit=unit))
    scale = _thousand(after, first)
    if scale is not None:
        return NamedFault("unit", scale)
    return None


def _copied(after: PositioningTest, first: PositioningTest) -> Sentence | None:
    """Return the sentence that readings of the test ``after`` are copies (of the ``first`` test, or
    of one run), or None if no copy is found.
    """
    for way, positive, negative in (
        ("same", first.positive, first.negative),
        ("sign", -first.positive, -first.negative),
        ("direction", first.negative, first.positive),
    ):
        if _shifted(after, first, positive, negative):
            return say("CW-V026.copied", test=first.name, way=way)
    groups = copied_runs(after)
    every = all(
        len(groups[side]) == 1 and len(groups[side][0]) == after.deviations(side).shape[1]
        for side in _measured(after)
    )
    if every and not any(copied_runs(first).values()) and after.positive.shape[0] > 3:
        return say("CW-V026.one_run")
    correlation = copied_scatter(after, first)
    if correlation is not None:
        return say("CW-V026.scatter", test=first.name, correlation=correlation)
    return None


def _measured(test: PositioningTest) -> list[Direction]:
    return [side for side in Direction if test.readings(side).any()]


def _shifted(
    after: PositioningTest, first: PositioningTest, positive: FloatArray, negative: FloatArray
) -> bool:
    """Return whether the readings of ``after`` equal the arrays ``positive`` and ``negative``,
    which are made from the ``first`` test, except for a constant offset.
    """
    if after.positive.shape != positive.shape or after.negative.shape != negative.shape:
        return False
    if not np.allclose(after.targets, first.targets, rtol=0.0, atol=1e-6):
        return False
    gaps = np.concatenate(
        [(after.positive - positive).ravel(), (after.negative - negative).ravel()]
    )
    known = gaps[np.isfinite(gaps)]
    return bool(known.size > 3 and np.ptp(known) <= SAME_READING)


def copied_scatter(one: PositioningTest, other: PositioningTest) -> float | None:
    """Return the correlation of the scatter in two tests if it proves that one test is a copy of
    the other, else None.
    """
    correlation, dof = _scatter_alike(one, other)
    return correlation if dof >= _ENOUGH and correlation > _COPIED else None


def _scatter_alike(after: PositioningTest, first: PositioningTest) -> tuple[float, int]:
    """Return the correlation of the scatter in two tests at the same targets, with its degrees of
    freedom; 0, 0 if undefined.

    The scatter is the readings minus the mean of their target and minus the straight line of their
    run. The line is removed because a drift over the runs may be the same in two true tests.
    """
    pairs = []
    for side in Direction:
        one, other = after.deviations(side), first.deviations(side)
        if one.shape == other.shape and one.shape[1] > 1 and one.shape[0] > 3:
            pairs.append((_scatter(one), _scatter(other)))
    if not pairs or not np.allclose(after.targets, first.targets, rtol=0.0, atol=1e-6):
        return 0.0, 0
    one, other = (np.concatenate([pair[side].ravel() for pair in pairs]) for side in (0, 1))
    known = np.isfinite(one) & np.isfinite(other)
    size = float(np.sqrt(np.sum(one[known] ** 2) * np.sum(other[known] ** 2)))
    dof = sum((pair[0].shape[0] - 2) * (pair[0].shape[1] - 1) for pair in pairs)
    return (abs(float(np.sum((one * other)[known]))) / size if size > 0.0 else 0.0), dof


def _scatter(block: FloatArray) -> FloatArray:
    left = block - mean_deviation(block)[:, np.newaxis]
    along = np.linspace(-1.0, 1.0, block.shape[0])
    for run in range(block.shape[1]):
        known = np.isfinite(left[:, run])
        if np.count_nonzero(known) > 2:
            left[known, run] -= np.polyval(
                np.polyfit(along[known], left[known, run], 1), along[known]
            )
    return left


def _thousand(after: PositioningTest, first: PositioningTest) -> Sentence | None:
    """Return the sentence that the readings, by their scatter, are 1000 times too small or too
    large, or None if they are not.
    """
    certain = certain_fault(after)
    if certain:
        return say("CW-V026.certain", why=certain)
    (s, dof), (s_first, dof_first) = pooled_scatter(after), pooled_scatter(first)
    if min(s, s_first) <= SAME_READING:
        return None
    for factor, small in ((_THOUSAND, True), (1.0 / _THOUSAND, False)):
        if noise_odds(s, dof, s_first, dof_first) and not noise_odds(
            s * factor, dof, s_first, dof_first
        ):
            return say(
                "CW-V026.thousand",
                scatter=text_of(s, after),
                first=text_of(s_first, first),
                small=small,
            )
    return None


def noise_odds(
    s: float, dof: float, s_first: float, dof_first: float
) -> Literal["", "quiet", "loud"]:
    """Return ``quiet`` if the scatter ``s`` is implausibly small compared with that of the first
    test, ``loud`` if it is implausibly large, else an empty text.

    Too small means: even if the noise were a third of that of the first test, a scatter this small
    would occur less than once in 1000 tests (ratio of two variances, Paulson's normal score). Too
    large is defined in the same way with three times the noise. With few degrees of freedom neither
    is possible.
    """
    if min(dof, dof_first) < 1.0 or s_first <= 0.0:
        return ""
    if s <= 0.0 or normal_score((s_first / BELIEVED / s) ** 2, dof_first, dof) > IMPROBABLE:
        return "quiet" if dof >= 4.0 else ""
    return (
        "loud" if normal_score((s / BELIEVED / s_first) ** 2, dof, dof_first) > IMPROBABLE else ""
    )


def normal_score(ratio: float, dof: float, noise_dof: float) -> float:
    """Return the standard normal value that is as improbable as a variance ratio (F) of ``dof`` and
    ``noise_dof`` degrees of freedom.

    The cube root of F is nearly normal (Paulson, Ann. Math. Statist. 13, 1942, 233). If the noise
    is exactly known, this is the approximation of Wilson and Hilferty for chi-square / dof.
    """
    a, b = 2.0 / (9.0 * dof), 2.0 / (9.0 * noise_dof)
    root = math.cbrt(max(ratio, 0.0))
    return ((1.0 - b) * root - (1.0 - a)) / math.sqrt(b * root**2 + a)


def proof_findings(
    after: PositioningTest, first: PositioningTest, serial: str = ""
) -> list[Finding]:
    """Return the findings that a test after loading is only weak evidence: targets of the ``first``
    test are missing (CW-V020), the noise is implausible compared with the ``first`` test (CW-V021),
    a file is older than one of the ``first`` test (CW-V029), or it is of another machine than that
    with the ``serial`` number of the job (CW-V032).
    """
    origin = origin_findings(after, first, serial)
    return [*_coverage(after, first), *_noise(after, first), *origin]


def _coverage(after: PositioningTest, first: PositioningTest) -> Iterable[Finding]:
    wanted = first.targets.size
    interval = float(first.targets[-1] - first.targets[0]) / max(first.targets.size - 1, 1)
    widest = float(np.max(np.diff(first.targets), initial=interval))
    lacks = []
    fewest = FEWEST_TARGETS[after.kind]
    if after.targets.size < fewest:
        lacks.append(say("CW-V020.fewest", targets=after.targets.size, fewest=fewest))
        wanted = max(fewest, wanted)
    elif after.targets.size < first.targets.size:
        lacks.append(say("CW-V020.fewer", targets=after.targets.size))
    ends = (
        after.targets[0] > first.targets[0] + interval
        or after.targets[-1] < first.targets[-1] - interval
    )
    if ends and not (_full_turn(after) and _full_turn(first)):
        lacks.append(say("CW-V020.range", range=_ends(after)))
    elif np.max(np.diff(after.targets), initial=0.0) > _GAP * widest:
        gap = position_text(float(np.max(np.diff(after.targets))), after)
        lacks.append(say("CW-V020.gap", gap=gap))
    for side in _measured(first):
        runs, before = (int(np.max(test.readings(side), initial=0.0)) for test in (after, first))
        if runs < min(before, 5):
            lacks.append(say("CW-V020.approaches", runs=runs, direction=side.value, first=before))
    if lacks:
        yield Finding.of("CW-V020", "warning", gaps=lacks, targets=wanted, range=_ends(first))


def _full_turn(test: PositioningTest) -> bool:
    """Return whether the targets cover a full turn, so that the first target does not matter."""
    span = float(test.targets[-1] - test.targets[0])
    return (
        test.kind is AxisKind.ROTARY and span + 2.0 * span / max(test.targets.size - 1, 1) >= 360.0
    )


def _ends(test: PositioningTest) -> Sentence:
    low, high = (position_text(float(test.targets[end]), test) for end in (0, -1))
    return say("range", low=low, high=high)


def _noise(after: PositioningTest, first: PositioningTest) -> Iterable[Finding]:
    scatters = pooled_scatter(after), pooled_scatter(first)
    return scatter_findings(*scatters, first.step, partial(text_of, test=first))


def scatter_findings(
    scatter: tuple[float, float],
    first: tuple[float, float],
    step: float,
    text: Callable[[float], Amount],
    circle: str = "",
) -> Iterable[Finding]:
    """Yield the finding CW-V021 if the ``scatter`` of a test after loading is implausible compared
    with that of the ``first`` test (mm or deg, each with its degrees of freedom).

    ``step``: of the readings of the first test. ``text``: writes a scatter. ``circle``: its name.
    """
    (s, dof), (s_first, dof_first) = scatter, first
    odds = noise_odds(s, dof, s_first, dof_first)
    if not odds or (odds == "quiet" and s_first < _ROUNDED * step):
        return
    ratio = s / s_first if odds == "loud" else s_first / s if s > 0.0 else math.inf
    yield Finding.of(
        "CW-V021",
        "warning",
        circle=circle,
        scatter=text(s),
        ratio=min(ratio, _THOUSAND),
        beyond=ratio > _THOUSAND,
        less=odds == "quiet",
        first=text(s_first),
        factor=BELIEVED,
    )


def origin_findings(
    after: PositioningTest | CircularTest,
    first: PositioningTest | CircularTest,
    serial: str,
    circle: str = "",
) -> Iterable[Finding]:
    """Yield the finding CW-V029 if a file of the test ``after`` loading has an older date than one
    of the ``first`` test, and CW-V032 if it has another serial number of the machine than the job
    (``serial``) and the ``first`` test. ``circle``: name of a circle.
    """
    earliest, latest = min(_days(after), default=""), max(_days(first), default="")
    both = min(len(earliest), len(latest))  # a day without a time of day is compared as a day
    if both and earliest[:both] < latest[:both]:
        yield Finding.of("CW-V029", "warning", date=earliest, first=latest, circle=circle)
    known = list(dict.fromkeys((*serials({"serial": serial}), *serials(first.header))))
    for found in other_serials(after.header, known):
        yield Finding.of("CW-V032", "warning", found=found, known=known, circle=circle)


def _days(test: PositioningTest | CircularTest) -> list[str]:
    """Return the dates of the files of a test that are not ambiguous."""
    dates = next((text for key, text in test.header.items() if key.lower() == "date"), "")
    return [day for day in map(day_of, dates.split("\n")) if day]


def file_disagreement(parts: Sequence[PositioningTest]) -> tuple[PositioningTest, str] | None:
    """Return the file whose mean deviations differ most from those of the first file of the same
    test, with the difference as text; None if all files agree.

    Two files differ if their means at the same targets and directions differ by more than
    `BELIEVED` times the scatter of a reading within the files. They then have another datum or
    another correction, and their common mean would describe no existing machine. Files without
    repeated readings are not compared.
    """
    scatter = [pooled_scatter(part) for part in parts]
    dof = sum(each for _, each in scatter)
    if dof < _FEW_REPEATS:
        return None
    s = math.sqrt(sum(each * one**2 for one, each in scatter) / dof)
    gaps = [_apart(parts[0], part) for part in parts[1:]]
    far = max(gaps, default=0.0)
    if far <= BELIEVED * max(s, SAME_READING):
        return None
    part = parts[1 + gaps.index(far)]
    return part, f"{text_of(far, part)} rms, and repeated readings scatter by {text_of(s, part)}"


def _apart(one: PositioningTest, other: PositioningTest) -> float:
    """Return the rms difference between the mean deviations of two tests at the targets that both
    have, mm or deg.
    """
    _, mine, theirs = np.intersect1d(
        _places(one.targets), _places(other.targets), return_indices=True
    )
    gaps = [
        mean_deviation(one.deviations(side))[mine] - mean_deviation(other.deviations(side))[theirs]
        for side in Direction
        if side in _measured(one) and side in _measured(other)
    ]
    apart = np.concatenate([*gaps, np.zeros(0)])
    apart = apart[np.isfinite(apart)]
    return float(np.sqrt(np.mean(apart**2))) if apart.size else 0.0


def _places(targets: FloatArray) -> FloatArray:
    """Return the targets, rounded so that the same position is the same number."""
    rounded: FloatArray = np.round(targets, 6)
    return rounded
