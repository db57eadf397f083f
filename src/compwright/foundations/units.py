"""Units and their factors. Internally positions and deviations are in mm or deg."""

from __future__ import annotations

from typing import Final, Literal

PositionUnit = Literal["mm", "deg"]
DeviationUnit = Literal["um", "arcsec"]

MICROMETRES_PER_MILLIMETRE: Final = 1000.0
ARCSECONDS_PER_DEGREE: Final = 3600.0
MILLIMETRES_PER_INCH: Final = 25.4

#: Units in which a deviation or a reading may be given -> (unit inside, factor to it).
TO_INSIDE: Final[dict[str, tuple[PositionUnit, float]]] = {
    "mm": ("mm", 1.0),
    "um": ("mm", 1.0 / MICROMETRES_PER_MILLIMETRE),
    "µm": ("mm", 1.0 / MICROMETRES_PER_MILLIMETRE),  # U+00B5, micro sign
    "μm": ("mm", 1.0 / MICROMETRES_PER_MILLIMETRE),  # U+03BC, Greek mu
    "deg": ("deg", 1.0),
    "arcsec": ("deg", 1.0 / ARCSECONDS_PER_DEGREE),
}


def outside_factor(unit: PositionUnit) -> float:
    """Return the factor from mm or deg to the unit of evaluations and reports (um, arcsec)."""
    return MICROMETRES_PER_MILLIMETRE if unit == "mm" else ARCSECONDS_PER_DEGREE


def outside_unit(unit: PositionUnit) -> DeviationUnit:
    """Return the unit of deviations in evaluations and reports: um for mm, arcsec for deg."""
    return "um" if unit == "mm" else "arcsec"


def shown_unit(unit: PositionUnit) -> str:
    """Return the printed unit of deviations: µm for mm, arcsec for deg."""
    return "µm" if unit == "mm" else "arcsec"
