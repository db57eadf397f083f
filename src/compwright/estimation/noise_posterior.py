"""The noise of a test as equally likely random draws, from its repeated readings.

A reading is the error of its cell (a target approached in one direction) plus noise. Given the
noise, the likelihood of the readings as a function of the errors of the cells is a normal density
times a factor that does not contain them (restricted likelihood: Patterson and Thompson, Biometrika
58, 1971; Harville, Biometrika 61, 1974). The factor informs about the noise, whatever the error is;
the density holds all other information.
"""

from __future__ import annotations

from dataclasses import dataclass

from compwright.foundations.findings import Finding
from compwright.records.axis import FloatArray
from compwright.records.noise import NoiseDraws


@dataclass(frozen=True, slots=True, kw_only=True)
class NoisePosterior:
    """Equally likely random draws of the noise of a test, each with the means at its m targets; mm
    or deg.

    ``mean``, ``precision`` (count, 2m): weighted mean of the readings and its inverse variance,
    first all targets approached in +, then in -; both 0 without a reading. ``columns`` (count, 2m,
    q): errors common to several means, from offsets and tilts of traverses, as columns of unit
    variance. Given draw k the means are normal about the error of the axis with covariance columns
    columns' + 1 / precision. Drift with the runs is removed from the means. ``fresh``: noise of a
    new test, equally many draws for each of ``draws``, in their order. ``sigma``: standard
    deviation of one reading, with ``dof`` degrees of freedom.
    """

    draws: NoiseDraws
    fresh: NoiseDraws
    mean: FloatArray
    precision: FloatArray
    columns: FloatArray
    sigma: float
    dof: float
    findings: tuple[Finding, ...] = ()
