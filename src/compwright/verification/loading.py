"""Did the loaded table act? The test after loading against what it would show with the table active
and with it not active.

Both expectations come from the same estimate of the error, so its uncertainty is common to them and
stands in one covariance together with the noise of the after test (a plain regression of after
minus before on the correction is biased, because the noise of the before test is in both). The
instrument's datum is free, once per test: an offset of its own for each direction would hide a
fault in the backlash.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.evaluation.statistics import count_readings, mean_deviation
from compwright.foundations.findings import Finding
from compwright.foundations.units import PositionUnit
from compwright.records.axis import FloatArray
from compwright.records.verification import LoadingName, LoadingVerdict, MeasurementFault
from compwright.verification.comparison import Comparison, after_noise, compare_readings
from compwright.verification.loading_words import (
    Words,
    inactive_message,
    inactive_slope_message,
    loaded_message,
    neither_message,
    open_message,
    open_slope_message,
    slope_text,
    straight_line_message,
    thermal_message,
)

__all__ = ["LoadingVerdict", "judge_loading"]

# Odds of 100:1. With equal doubt before, the wrong one of two candidates passes in less than 0.2 %
# of the tests.
_CLEAR: Final = math.log(100.0)
# A test that fits is refused in about 1 of 1000 cases by its residuals, in 1 of 1000 by the size of
# the effect.
_FITS: Final = 3.09
# No fault of loading changes the effect by so little; a machine that has warmed up by a fraction of
# a degree does.
_AS_PLANNED: Final = 0.05
#: A slope is named where it is so many of its standard errors, and 100 times likelier than none.
_SLOPE: Final = 3.0


def judge_loading(
    after_positive: FloatArray,
    after_negative: FloatArray,
    expected_loaded_positive: FloatArray,
    expected_loaded_negative: FloatArray,
    expected_inactive_positive: FloatArray,
    expected_inactive_negative: FloatArray,
    covariance: FloatArray,
    noise: float,
    *,
    noise_dof: float = math.inf,
    positions: FloatArray | None = None,
    unit: PositionUnit = "mm",
    declared_slope: float | None = None,
) -> LoadingVerdict:
    """Return whether the after test shows the table as loaded, as not active, as loaded on an axis
    that is longer or shorter now (``thermal``), or cannot tell.

    ``after_*`` (m, n): deviations of the after test, NaN for readings not made, width 0 for a
    direction not measured. ``expected_*`` (m,): mean deviations expected with the new table active
    and with the control as it was before. ``covariance`` (2m, 2m): uncertainty of the expected
    means, + then -, common to both; whatever else may change between the tests (set-up,
    temperature) belongs in it. ``noise``: standard deviation of a single reading, with
    ``noise_dof`` degrees of freedom; used where the after test has too few repeats of its own. All
    in mm or deg by ``unit``; ``positions`` (m,) for the slope and the message; ``declared_slope``:
    standard deviation (mm/mm) of a slope between the tests beside ``covariance``, by what is
    declared of temperature; None where no temperature makes a slope (angles).

    ``loaded`` (``not_active``) needs all of: the measured part of the effect is 1 (0) within its
    error or within 0.05, what is left besides is noise alone, and it is 100 times likelier than the
    other and than a table that acts by half. Where the test contradicts both, the same is asked of
    the test without a slope over the positions (`_with_slope`). Anything else is ``undecided``;
    when the test contradicts every name, a finding CW-V001 says by how much and where.
    """
    loaded = np.concatenate([expected_loaded_positive, expected_loaded_negative])
    inactive = np.concatenate([expected_inactive_positive, expected_inactive_negative])
    means = np.concatenate([mean_deviation(after_positive), mean_deviation(after_negative)])
    used = np.isfinite(means) & np.isfinite(loaded) & np.isfinite(inactive)
    if (
        np.count_nonzero(used) < 3
    ):  # one value is the datum's, one the effect's: nothing would be left to contradict
        return LoadingVerdict(
            verdict="undecided",
            margin=0.0,
            message="Cannot tell: the after test has fewer than 3 measured means.",
        )
    sigma, dof = after_noise(after_positive, after_negative, noise, noise_dof)
    tilted = covariance
    if positions is not None and declared_slope:
        tilt = declared_slope * np.tile(positions - positions.mean(), 2)
        tilted = covariance + np.outer(tilt, tilt)

    def compare(up: FloatArray, down: FloatArray) -> Comparison:
        return compare_readings(up, down, loaded, inactive, tilted, sigma, dof)

    compared = compare(after_positive, after_negative)
    words = Words(np.flatnonzero(used), after_positive.shape[0], positions, unit)
    verdict = _verdict(compared, words)
    turned = _turned(after_positive, after_negative, compare)
    if positions is None or declared_slope is None:
        return verdict if turned is None else _turned_verdict(verdict, *turned)
    along = np.tile(positions, 2)
    # two positions are a straight line whatever they show
    if np.unique(along[used]).size > 2 and compared.count > 3:
        sloped = compare_readings(
            after_positive, after_negative, loaded, inactive, covariance, sigma, dof, along
        )
        readings = np.concatenate([count_readings(after_positive), count_readings(after_negative)])
        error = sigma * math.sqrt(2.0 / float(readings[used].mean()))
        acts_by = _acts_by((loaded - inactive)[used], sloped.slope[0] * along[used], error)
        found = _with_slope(verdict, compared, sloped, acts_by, declared_slope)
        gain = sloped.log_likelihood(1.0) - compared.log_likelihood(1.0)
        if found is not verdict and (turned is None or turned[1] - gain < _CLEAR):
            return found
    return verdict if turned is None else _turned_verdict(verdict, *turned)


def _beyond(sloped: Comparison, declared_slope: float) -> bool:
    """Return whether the slope is more than the job declares, by 1 in 1000.

    Only where it declares something: what a test shows that fits as it stands needs no name.
    """
    slope, own = sloped.slope
    error = math.hypot(own, declared_slope)
    return declared_slope > 0.0 and normal_score((slope / error) ** 2, 1.0, sloped.dof) > _FITS


def _with_slope(
    verdict: LoadingVerdict,
    plain: Comparison,
    sloped: Comparison,
    acts_by: float | None,
    declared_slope: float,
) -> LoadingVerdict:
    """Return the verdict ``thermal`` where the test is the loaded table's but for a slope over the
    positions, ``not_active`` where it is the old control's but for one; else ``verdict``.

    ``plain``, ``sloped``: without and with the slope removed; ``acts_by``: by how much of itself a
    table would act whose test is the same (the correction is a straight line), None where there is
    none. A table that acts by any part of itself has to be 100 times less likely.
    """
    stands = _fits(plain, 1.0) or _fits(plain, 0.0)
    if stands and not _beyond(sloped, declared_slope):
        return verdict
    slope, own_error = sloped.slope
    if abs(slope) < _SLOPE * math.hypot(own_error, declared_slope):
        return verdict
    found = replace(verdict, slope=(slope, own_error))
    text = slope_text(slope, own_error, declared_slope)
    if acts_by is not None and _fits(sloped, 1.0):
        return _thermal(
            found,
            sloped.log_likelihood(1.0) - plain.log_likelihood(1.0),
            straight_line_message(text, acts_by),
            equivalent=("scaled",),
        )
    first, margin = _likeliest(sloped)
    scaled = plain.log_likelihood(plain.factor) if _fits(plain, plain.factor) else -math.inf
    if first == "half" or not _fits(sloped, 1.0 if first == "loaded" else 0.0):
        return verdict
    margin = min(margin, sloped.log_likelihood(1.0 if first == "loaded" else 0.0) - scaled)
    if margin < _CLEAR:
        return replace(found, findings=(), message=open_slope_message(sloped, text))
    if first == "loaded":
        return _thermal(found, margin, thermal_message(sloped, text))
    message = f"{inactive_slope_message(sloped)} {text}"
    return replace(found, verdict="not_active", margin=margin, message=message, findings=())


def _thermal(
    found: LoadingVerdict,
    margin: float,
    message: str,
    equivalent: tuple[LoadingName, ...] = (),
) -> LoadingVerdict:
    finding = Finding("CW-V027", "warning", message)
    return replace(
        found,
        verdict="thermal",
        margin=margin,
        message=message,
        equivalent=equivalent,
        findings=(finding,),
    )


def _acts_by(step: FloatArray, tilt: FloatArray, error: float) -> float | None:
    """Return by how much of itself a table would act whose test, free of noise, is that of the
    loaded table with ``tilt`` within one standard ``error``; None where none is.

    ``step`` (k,): loaded less inactive; both less their means.
    """
    step, tilt = step - step.mean(), tilt - tilt.mean()
    square = float(step @ step)
    if square <= 0.0:
        return None
    more = float(step @ tilt) / square
    return 1.0 + more if float(np.linalg.norm(tilt - more * step)) <= error else None


def _turned(
    positive: FloatArray,
    negative: FloatArray,
    compare: Callable[[FloatArray, FloatArray], Comparison],
) -> tuple[MeasurementFault, float] | None:
    """Return what was turned in the readings, and by which log-likelihood the loaded table explains
    them better turned back.

    None where the readings fit the loaded table as they stand, or are not 100 times less likely
    than turned back: what a well fitted table leaves may be too little to tell, and the noise of
    the first test then favours either way by chance.
    """

    def likelihood(up: FloatArray, down: FloatArray) -> tuple[float, bool]:
        compared = compare(up, down)
        # Without the factor 1 of the loaded table nothing else may be turned: the size of the
        # effect counts in the likelihood.
        return compared.log_likelihood(1.0), _fits(compared, 1.0)

    straight, stands = likelihood(positive, negative)
    if stands:
        return None
    ways: list[tuple[MeasurementFault, FloatArray, FloatArray]] = [("sign", -positive, -negative)]
    if np.isfinite(positive).any() and np.isfinite(negative).any():
        ways.append(("direction", negative, positive))
    found = [(of, *likelihood(up, down)) for of, up, down in ways]
    fitting = [
        (value - straight, of) for of, value, fits in found if fits and value - straight >= _CLEAR
    ]
    if not fitting:
        return None
    margin, of = max(fitting)
    return of, margin


def _turned_verdict(verdict: LoadingVerdict, of: MeasurementFault, margin: float) -> LoadingVerdict:
    what = (
        "the sign of its deviations is turned"
        if of == "sign"
        else "its directions + and − are exchanged"
    )
    message = (
        f"The after test fits the loaded table when {what}, and not as it stands (log-likelihood"
        f" better by {margin:.1f}). Check sign and directions of the instrument and export the test"
        " again."
    )
    return replace(
        verdict, verdict="measurement", of=of, margin=margin, message=message, findings=()
    )


def _fits(compared: Comparison, factor: float) -> bool:
    """Return whether a table that acts by ``factor`` explains the after test but for noise."""
    off, dof = abs(compared.factor - factor), compared.dof
    size_fits = off <= _AS_PLANNED or normal_score((compared.effect * off) ** 2, 1.0, dof) <= _FITS
    free = compared.count - compared.removed - 1
    return size_fits and normal_score(compared.chi2 / free, free, dof) <= _FITS


def normal_score(ratio: float, dof: float, noise_dof: float) -> float:
    """Return the standard normal value as improbable as a variance ratio F of ``dof`` and
    ``noise_dof`` degrees of freedom.

    Paulson, Ann. Math. Statist. 13 (1942) 233: the cube root of F is nearly normal. With exactly
    known noise this is the approximation of Wilson and Hilferty for chi-square / dof.
    """
    a, b = 2.0 / (9.0 * dof), 2.0 / (9.0 * noise_dof)
    root = math.cbrt(max(ratio, 0.0))
    return ((1.0 - b) * root - (1.0 - a)) / math.sqrt(b * root**2 + a)


def _likeliest(compared: Comparison) -> tuple[str, float]:
    """Return ``loaded``, ``half`` or ``not_active``, and its log-likelihood less that of the
    next.
    """
    likelihoods = {
        "loaded": compared.log_likelihood(1.0),
        "half": compared.log_likelihood(0.5),
        "not_active": compared.log_likelihood(0.0),
    }
    first, second = sorted(likelihoods, key=lambda name: likelihoods[name], reverse=True)[:2]
    return first, likelihoods[first] - likelihoods[second]


def _verdict(compared: Comparison, words: Words) -> LoadingVerdict:
    first, margin = _likeliest(compared)
    fits_loaded, fits_inactive = _fits(compared, 1.0), _fits(compared, 0.0)
    verdict: LoadingName = "undecided"
    findings: tuple[Finding, ...] = ()
    if margin >= _CLEAR and first == "loaded" and fits_loaded:
        verdict, message = "loaded", loaded_message(compared, words)
    elif margin >= _CLEAR and first == "not_active" and fits_inactive:
        verdict, message = "not_active", inactive_message(compared, words)
    elif fits_loaded or fits_inactive:
        message = open_message(
            compared, words, fits_loaded=fits_loaded, fits_inactive=fits_inactive
        )
    else:
        message = neither_message(compared, words)
        findings = (Finding("CW-V001", "warning", message),)
    return LoadingVerdict(verdict=verdict, margin=margin, message=message, findings=findings)
