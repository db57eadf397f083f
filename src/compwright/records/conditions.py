"""The conditions of a measurement that the job states: temperatures and uncertainty contributors.

These records are separate from the job, because the evaluation of a file needs nothing else of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

#: °C in which a machine is measured; 68 is a hall in °F, 293 one in K.
PLAUSIBLE_TEMPERATURES = (-20.0, 60.0)
#: µm/(m K): below the least is a coefficient in 1/K, above the most no metal. Zerodur has 0.05,
#: Invar 1.2, glass 8, steel 11.5, aluminium 23.8, zinc 30.
LEAST_EXPANSION, MOST_EXPANSION = 0.01, 40.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Thermal:
    """Differential expansion of scale (or workpiece) and instrument: µm/(m K) and °C.

    Temperatures are means of start and end of the test. ``rise_m`` and ``rise_d``: temperature at
    the end minus temperature at the start, K.
    """

    alpha_m: float
    T_m: float
    alpha_d: float = 0.0
    T_d: float = 20.0
    rise_m: float = 0.0
    rise_d: float = 0.0
    x_fix: float = 0.0
    refer_to: Literal["scale", "workpiece"] = "scale"

    @property
    def slope(self) -> float:
        """The differential expansion per distance from the fixed point ``x_fix``, mm/mm."""
        return 1e-6 * (self.alpha_m * (self.T_m - 20.0) - self.alpha_d * (self.T_d - 20.0))


@dataclass(frozen=True, slots=True, kw_only=True)
class UncertaintyBudget:
    """Contributors to uncertainty (ISO 230-2:2006, annex A) as expanded uncertainties (k = 2).

    Two contributors are ranges as in the annex. ``misalignment_mm`` is the lateral range of the
    beam over the measured length. ``E_VE`` is the range of a stand-still test that is as long as
    the run.
    """

    device: float = 0.0
    device_per_m: float = 0.0
    misalignment_mm: float = 0.0
    U_theta: float = 0.0
    U_alpha: float = 0.0
    setup: float = 0.0
    E_VE: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class CircularBudget:
    """Contributors to the uncertainty of circular tests, as expanded uncertainties (k = 2).

    In µm: ``U`` of the instrument for a change in length, the calibrated ``length`` of the bar, and
    ``setup``. ``U_theta`` is in K, ``U_alpha`` in µm/(m K). ``E_VE`` is a range, µm.
    """

    U: float = 0.0
    length: float = 0.0
    setup: float = 0.0
    E_VE: float = 0.0
    U_theta: float = 0.0
    U_alpha: float = 0.0
