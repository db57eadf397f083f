"""Round numbers so that they are the same on every processor.

The last bits of a result depend on the processor and on the number of its threads, because of the
order of a sum, fused products, and series of the exponential (Higham, Accuracy and Stability of
Numerical Algorithms, 2nd ed. 2002, chapters 3 and 4). Rounding removes these bits.

Each package rounds the estimated or simulated values that it returns, so that decisions, tables and
files depend on the same numbers everywhere. Values that are measured or contained in a control are
never changed.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: Lengths to a picometre, angles to a nanodegree, both far below any instrument: mm and deg.
PICO: Final = 9
#: Residues of certificates, which are zero but for arithmetic: a thousandth of that.
RESIDUE: Final = 12
#: Reported values of circles, in µm, ms, µm/m: as fine as a picometre.
OUTSIDE: Final = 6
#: Logarithms of odds, degrees of freedom.
LOGARITHM: Final = 6


def rounded(values: FloatArray, digits: int = PICO) -> FloatArray:
    """Return ``values`` rounded to ``digits`` decimals, with 0 instead of -0."""
    result: FloatArray = np.round(values, digits) + 0.0
    return result


def rounded_number(value: float, digits: int = PICO) -> float:
    """Return one rounded value, as `rounded` does."""
    return round(float(value), digits) + 0.0
