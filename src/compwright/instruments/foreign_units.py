"""Units that instruments and spreadsheets print, with their factors to mm or deg."""

from __future__ import annotations

import math
from typing import Final

from compwright.foundations.units import (
    ARCSECONDS_PER_DEGREE,
    MICROMETRES_PER_MILLIMETRE,
    MILLIMETRES_PER_INCH,
)

_DEGREES_PER_RADIAN = 180.0 / math.pi

LENGTHS: Final[dict[str, float]] = {
    "um": 1.0 / MICROMETRES_PER_MILLIMETRE,
    "mm": 1.0,
    "nm": 1e-6,
    "m": 1e3,
    "in": MILLIMETRES_PER_INCH,
}
ANGLES: Final[dict[str, float]] = {
    "arcsec": 1.0 / ARCSECONDS_PER_DEGREE,
    "deg": 1.0,
    "arcmin": 1.0 / 60.0,
    "urad": _DEGREES_PER_RADIAN * 1e-6,
    "mrad": _DEGREES_PER_RADIAN * 1e-3,
    "rad": _DEGREES_PER_RADIAN,
}
