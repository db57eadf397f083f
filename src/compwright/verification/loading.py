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
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.evaluation.statistics import count_readings, mean_deviation, standard_deviation
from compwright.foundations.findings import Finding
from compwright.foundations.units import PositionUnit, outside_factor
from compwright.records.axis import FloatArray
from compwright.records.verification import LoadingName, LoadingVerdict, MeasurementFault

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
# Effect in its own standard errors from which 95 % of the tests tell all of it from half of it at
# odds of 100:1: D^2 / 8 - 1.645 D / 2 = ln 100.
_VISIBLE: Final = 10.2
_OWN_NOISE_DOF: Final = (
    5.0  # from here on the after test's own scatter is better known than that of the before test
)
# mm or deg: repeated readings that are all equal show the instrument's resolution, not a perfect
# axis
_LEAST_NOISE: Final = 1e-5


@dataclass(frozen=True, slots=True)
class _Comparison:
    """After-test means (k,) against both expectations, the datum removed.

    ``residual_loaded``, ``residual_inactive`` (k,): measured minus expected, mm or deg. ``effect``:
    length of loaded minus inactive in standard errors. ``factor``: measured part of it, 1 loaded, 0
    not active, with standard error 1 / effect. ``chi2``: squared length of the residuals when that
    part is taken out. ``noise`` (mm or deg) of a reading with ``dof`` degrees of freedom; ``size``:
    rms of loaded minus inactive, mm or deg.
    """

    residual_loaded: FloatArray
    residual_inactive: FloatArray
    effect: float
    factor: float
    chi2: float
    dof: float
    noise: float
    size: float

    @property
    def count(self) -> int:
        return int(self.residual_loaded.size)

    def log_likelihood(self, factor: float) -> float:
        """Return the log-likelihood of a table that acts by ``factor``, up to a constant; of the t
        law where noise is estimated.
        """
        chi2 = self.chi2 + (self.effect * (self.factor - factor)) ** 2
        if math.isinf(self.dof):
            return -0.5 * chi2
        return -0.5 * (self.dof + self.count - 1) * math.log1p(chi2 / self.dof)

    def fits(self, factor: float) -> bool:
        """Return whether a table that acts by ``factor`` explains the after test but for noise."""
        off = abs(self.factor - factor)
        size_fits = (
            off <= _AS_PLANNED or normal_score((self.effect * off) ** 2, 1.0, self.dof) <= _FITS
        )
        return (
            size_fits
            and normal_score(self.chi2 / (self.count - 2), self.count - 2, self.dof) <= _FITS
        )


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
) -> LoadingVerdict:
    """Return whether the after test shows the table as loaded, as not active, or cannot tell.

    ``after_*`` (m, n): deviations of the after test, NaN for readings not made, width 0 for a
    direction not measured. ``expected_*`` (m,): mean deviations expected with the new table active
    and with the control as it was before. ``covariance`` (2m, 2m): uncertainty of the expected
    means, + then -, common to both; whatever else may change between the tests (set-up,
    temperature) belongs in it. ``noise``: standard deviation of a single reading, with
    ``noise_dof`` degrees of freedom; used where the after test has too few repeats of its own. All
    in mm or deg by ``unit``; ``positions`` (m,) for the message.

    ``loaded`` (``not_active``) needs all of: the measured part of the effect is 1 (0) within its
    error or within 0.05, what is left besides is noise alone, and it is 100 times likelier than the
    other and than a table that acts by half. Anything else is ``undecided``; when the test
    contradicts both, a finding CW-V001 says by how much and where.
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
    sigma, dof = _after_noise(after_positive, after_negative, noise, noise_dof)

    def compare(up: FloatArray, down: FloatArray) -> _Comparison:
        return _compare_readings(up, down, loaded, inactive, covariance, sigma, dof)

    compared = compare(after_positive, after_negative)
    verdict = _verdict(
        compared, _Words(np.flatnonzero(used), after_positive.shape[0], positions, unit)
    )
    turned = _turned(after_positive, after_negative, compare)
    return verdict if turned is None else _turned_verdict(verdict, *turned)


def _compare_readings(
    positive: FloatArray,
    negative: FloatArray,
    loaded: FloatArray,
    inactive: FloatArray,
    covariance: FloatArray,
    sigma: float,
    dof: float,
) -> _Comparison:
    """Compare readings (m, n) of both directions with both expectations (2m,) where all three
    exist.
    """
    means = np.concatenate([mean_deviation(positive), mean_deviation(negative)])
    readings = np.concatenate([count_readings(positive), count_readings(negative)])
    used = np.isfinite(means) & np.isfinite(loaded) & np.isfinite(inactive)
    spread = covariance[np.ix_(used, used)] + np.diag(sigma**2 / readings[used])
    return _compare(means[used], loaded[used], inactive[used], spread, sigma, dof)


def _turned(
    positive: FloatArray,
    negative: FloatArray,
    compare: Callable[[FloatArray, FloatArray], _Comparison],
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
        return compared.log_likelihood(1.0), compared.fits(1.0)

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


def _after_noise(
    positive: FloatArray, negative: FloatArray, noise: float, noise_dof: float
) -> tuple[float, float]:
    """Return the standard deviation of a single reading of the after test and its degrees of
    freedom.
    """
    squares, dof = 0.0, 0.0
    for block in (positive, negative):
        s = standard_deviation(block)
        degrees = np.where(np.isfinite(s), count_readings(block) - 1.0, 0.0)
        squares += float(np.sum(degrees * np.where(np.isfinite(s), s, 0.0) ** 2))
        dof += float(degrees.sum())
    if dof >= _OWN_NOISE_DOF:
        return max(math.sqrt(squares / dof), _LEAST_NOISE), dof
    return max(noise, _LEAST_NOISE), noise_dof


def _compare(
    means: FloatArray,
    loaded: FloatArray,
    inactive: FloatArray,
    covariance: FloatArray,
    sigma: float,
    dof: float,
) -> _Comparison:
    """Whiten by the covariance (k, k), remove the datum, and measure lengths."""
    root = np.linalg.cholesky(0.5 * (covariance + covariance.T))
    white = np.linalg.solve(
        root, np.column_stack([np.ones(means.size), means - inactive, loaded - inactive])
    )
    datum = white[:, 0]
    shift = (
        datum @ white[:, 1:] / (datum @ datum)
    )  # generalised least squares offset of each column
    residual, step = (white[:, 1:] - datum[:, np.newaxis] * shift).T
    effect2 = float(step @ step)
    factor = float(step @ residual) / effect2 if effect2 > 0.0 else 0.0
    return _Comparison(
        residual_loaded=means - loaded - (shift[0] - shift[1]),
        residual_inactive=means - inactive - shift[0],
        effect=math.sqrt(effect2),
        factor=factor,
        chi2=float(np.sum((residual - factor * step) ** 2)),
        dof=dof,
        noise=sigma,
        size=float(np.std(loaded - inactive)),
    )


def normal_score(ratio: float, dof: float, noise_dof: float) -> float:
    """Return the standard normal value as improbable as a variance ratio F of ``dof`` and
    ``noise_dof`` degrees of freedom.

    Paulson, Ann. Math. Statist. 13 (1942) 233: the cube root of F is nearly normal. With exactly
    known noise this is the approximation of Wilson and Hilferty for chi-square / dof.
    """
    a, b = 2.0 / (9.0 * dof), 2.0 / (9.0 * noise_dof)
    root = math.cbrt(max(ratio, 0.0))
    return ((1.0 - b) * root - (1.0 - a)) / math.sqrt(b * root**2 + a)


@dataclass(frozen=True, slots=True)
class _Words:
    """What the message needs to name a place: index (k,) of each mean in + then -, m targets, their
    positions.
    """

    index: NDArray[np.intp]
    m: int
    positions: FloatArray | None
    unit: PositionUnit

    def length(self, value: float) -> str:
        """Return a deviation with its unit, in µm or arcsec, two significant digits or more."""
        outside = abs(value) * outside_factor(self.unit)
        decimals = 1 if outside >= 1.0 else 2
        return f"{outside:.{decimals}f} {'µm' if self.unit == 'mm' else 'arcsec'}"

    def place(self, which: int) -> str:
        """Return where the ``which``-th mean was measured."""
        index = int(self.index[which])
        direction = "+" if index < self.m else "-"
        target = index % self.m
        where = (
            f"target {target + 1}"
            if self.positions is None
            else f"{self.positions[target]:g} {self.unit}"
        )
        return f"{where} approached in {direction}"

    def between_directions(self, residual: FloatArray) -> float:
        """Return mean(+) minus mean(-) of a residual (k,), 0 when one direction alone was
        measured.
        """
        positive = self.index < self.m
        if positive.all() or not positive.any():
            return 0.0
        return float(residual[positive].mean() - residual[~positive].mean())


def _verdict(compared: _Comparison, words: _Words) -> LoadingVerdict:
    likelihoods = {
        "loaded": compared.log_likelihood(1.0),
        "half": compared.log_likelihood(0.5),
        "not_active": compared.log_likelihood(0.0),
    }
    first, second = sorted(likelihoods, key=lambda name: likelihoods[name], reverse=True)[:2]
    margin = likelihoods[first] - likelihoods[second]
    fits_loaded, fits_inactive = compared.fits(1.0), compared.fits(0.0)
    verdict: LoadingName = "undecided"
    findings: tuple[Finding, ...] = ()
    if margin >= _CLEAR and first == "loaded" and fits_loaded:
        verdict, message = "loaded", _loaded_message(compared, words)
    elif margin >= _CLEAR and first == "not_active" and fits_inactive:
        verdict, message = "not_active", _inactive_message(compared, words)
    elif fits_loaded or fits_inactive:
        message = _open_message(
            compared, words, fits_loaded=fits_loaded, fits_inactive=fits_inactive
        )
    else:
        message = _neither_message(compared, words)
        findings = (Finding("CW-V001", "warning", message),)
    return LoadingVerdict(verdict=verdict, margin=margin, message=message, findings=findings)


def _rms(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _effect_text(compared: _Comparison) -> str:
    return f"{compared.factor:.2f} ± {1.0 / compared.effect:.2f} of the planned effect"


def _loaded_message(compared: _Comparison, words: _Words) -> str:
    return (
        f"The table acts as planned: the after test shows {_effect_text(compared)} and lies within "
        f"{words.length(_rms(compared.residual_loaded))} rms of the prediction."
    )


def _inactive_message(compared: _Comparison, words: _Words) -> str:
    return (
        f"The table does not act: the after test shows {_effect_text(compared)} and lies within "
        f"{words.length(_rms(compared.residual_inactive))} rms of what the control did before."
    )


def _open_message(
    compared: _Comparison, words: _Words, *, fits_loaded: bool, fits_inactive: bool
) -> str:
    text = (
        "Cannot tell: with and without the new table the targets differ by"
        f" {words.length(compared.size)} rms, and the noise of a reading is"
        f" {words.length(compared.noise)}"
    )
    if compared.effect > 0.0:
        needed = compared.size * _VISIBLE / compared.effect
        if needed > compared.size:
            text += (
                f"; the correction is smaller than the {words.length(needed)} rms that this test"
                " can tell for sure"
            )
        text += f". Measured: {_effect_text(compared)}"
    candidates = [
        name for name, fits in (("loaded", fits_loaded), ("not active", fits_inactive)) if fits
    ]
    return f"{text}. Possible: {', '.join([*candidates, 'acting in part'])}."


def _neither_message(compared: _Comparison, words: _Words) -> str:
    parts = [
        "The after test fits neither the loaded table nor the control as it was before.",
        _off_text("Against the prediction", compared.residual_loaded, words),
        _off_text("Against no change", compared.residual_inactive, words),
    ]
    offset = words.between_directions(compared.residual_loaded)
    if offset:
        sign = "above" if offset > 0.0 else "below"
        parts.append(
            f"Against the prediction the + approaches lie {words.length(offset)} {sign} the -"
            " approaches on average."
        )
    if compared.effect > 0.0:
        parts.append(f"Measured: {_effect_text(compared)}.")
    return " ".join(parts)


def _off_text(against: str, residual: FloatArray, words: _Words) -> str:
    worst = int(np.argmax(np.abs(residual)))
    return (
        f"{against} it is off by {words.length(_rms(residual))} rms and at worst by"
        f" {words.length(float(residual[worst]))} ({words.place(worst)})."
    )
