"""Write numbers, units and parameter names as text, in the same way in plots, pages and cards."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

from compwright.words.sentences import NumberText, Sentence, say

#: Stands where a quantity is not defined or was not measured.
MISSING: Final = "—"

#: Decimals of a deviation in µm or arcsec: a tenth of what the standards print.
DEVIATION_DECIMALS: Final = 2
#: Decimals of what is not a deviation, on every page: a servo mismatch, a squareness or a scale.
_DECIMALS: Final = {"ms": 3, "um/m": 1, "µm/m": 1}

_UNITS: Final = {"um": "µm", "um/m": "µm/m", "arcsec": "arcsec", "mm": "mm", "deg": "deg"}

#: Parameter by its name in the documents -> (symbol, what it is called in the standard; `term`: the
#: English words of an edition). The order is that of the tables.
PARAMETERS: Final[dict[str, tuple[str, Sentence]]] = {
    "A": ("A", say("parameter.A", term="")),
    "A_positive": ("A+", say("parameter.A_positive", term="")),
    "A_negative": ("A−", say("parameter.A_negative", term="")),
    "E": ("E", say("parameter.E", term="")),
    "E_positive": ("E+", say("parameter.E_positive", term="")),
    "E_negative": ("E−", say("parameter.E_negative", term="")),
    "M": ("M", say("parameter.M", term="")),
    "R": ("R", say("parameter.R", term="")),
    "R_positive": ("R+", say("parameter.R_positive", term="")),
    "R_negative": ("R−", say("parameter.R_negative", term="")),
    "B": ("B", say("parameter.B", term="")),
    "B_mean": ("mean B", say("parameter.B_mean", term="")),
    "P": ("P", say("parameter.P", term="")),
    "Pa": ("Pa", say("parameter.Pa", term="")),
    "Ps_max": ("Ps max", say("parameter.Ps_max", term="")),
    "Ps_mean": ("Ps mean", say("parameter.Ps_mean", term="")),
    "U_max": ("U max", say("parameter.U_max", term="")),
    "U_mean": ("U mean", say("parameter.U_mean", term="")),
}

_STANDARDS: Final = {
    "iso230-2": "ISO 230-2",
    "iso230-3": "ISO 230-3",
    "gost27843": "GOST 27843",
    "vdi3441": "VDI/DGQ 3441",
    "iso230-4": "ISO 230-4",
}


def number(value: object, decimals: int = DEVIATION_DECIMALS) -> str:
    """Return ``value`` with fixed decimals and a true minus sign; `MISSING` for None and NaN."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        return MISSING
    text = f"{value:.{decimals}f}"
    if text.startswith("-") and not text.strip("-0."):
        text = text[1:]
    return NumberText(text.replace("-", "−"))


def decimals_of(values: Iterable[object], most: int = 4) -> int:
    """Return the fewest decimals, at most ``most``, with which all ``values`` are exact."""
    finite = [
        float(value) for value in values if isinstance(value, int | float) and math.isfinite(value)
    ]
    for decimals in range(most):
        if all(abs(round(value, decimals) - value) < 0.5 * 10.0**-most for value in finite):
            return decimals
    return most


def plain(value: object) -> str:
    """Return a value as short exact text (10 digits), `MISSING` for None."""
    if value is None:
        return MISSING
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        if not math.isfinite(value):
            return MISSING
        return NumberText((f"{value:.10g}" if value else "0").replace("-", "−"))
    if isinstance(value, int):
        return str(value).replace("-", "−")
    return value if isinstance(value, str) else str(value)


def decimals_of_unit(unit: str) -> int:
    """Return the number of decimals with which values in a unit are printed."""
    return _DECIMALS.get(unit, DEVIATION_DECIMALS)


def with_unit(value: object, unit: str) -> Sentence:
    """Return a value as text with its unit, as short as `plain` writes it."""
    return say("label.with_unit", value=plain(value), unit=unit)


def unit_text(unit: object) -> str:
    """Return a unit as it is printed, such as ``µm`` for ``um``; unknown units are unchanged."""
    return _UNITS.get(str(unit), str(unit))


def position_unit(unit: object) -> str:
    """Return the unit of positions (mm or deg) that belongs to deviations in ``unit`` (um or
    arcsec).
    """
    return "deg" if str(unit) == "arcsec" else "mm"


def symbol(parameter: str) -> str:
    """Return the symbol of a parameter (``A_positive`` -> ``A+``)."""
    return PARAMETERS[parameter][0] if parameter in PARAMETERS else parameter.replace("_", " ")


def standard_text(standard: object) -> str:
    """Return the name of a standard from its id (``iso230-2:2014`` -> ``ISO 230-2:2014``)."""
    name, colon, year = str(standard).partition(":")
    return _STANDARDS.get(name, name) + colon + year
