"""The noise of a test as equally likely random draws, from its repeated readings.

A reading is the error of its cell (a target approached in one direction) plus noise. For given
noise, the likelihood of the readings is a product of two factors. The first is a normal density of
the errors of the cells. The second does not contain these errors (restricted likelihood: Patterson
and Thompson, Biometrika 58, 1971; Harville, Biometrika 61, 1974). It gives the information about
the noise, whatever the error is. The first factor contains all other information.
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

    ``mean``, ``precision`` (count, 2 * m): weighted mean of the readings and its inverse variance,
    first all targets approached in +, then in -. Both are 0 without a reading. The means do not
    contain the drift with the runs. ``columns`` (count, 2 * m, q): errors common to several means,
    from offsets and tilts of traverses, as columns of unit variance. For draw k, the means are
    normally distributed about the error of the axis, with covariance columns columns' + 1 /
    precision. ``fresh``: noise of a new test, with equally many draws for each draw in ``draws``,
    in their order. ``sigma``: standard deviation of one reading, with ``dof`` degrees of freedom.
    """

    draws: NoiseDraws
    fresh: NoiseDraws
    mean: FloatArray
    precision: FloatArray
    columns: FloatArray
    sigma: float
    dof: float
    findings: tuple[Finding, ...] = ()
