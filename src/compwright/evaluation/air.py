"""The refractive index of air by the equation of Ciddor and by the modified Edlén equation.

Sources: P. E. Ciddor, Appl. Opt. 35 (1996), no. 9; B. Edlén, Metrologia 2 (1966) 71; K. P. Birch
and M. J. Downs, Metrologia 30 (1993) 155 and 31 (1994) 315. Saturation vapour pressure over water:
IAPWS (2007); over ice: Wexler (1977). All formulas are those of J. A. Stone and J. H. Zimmerman,
Engineering Metrology Toolbox (NIST), appendix A. Both equations agree with its check values within
1e-9.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.records.axis import FloatArray

#: µm, in vacuum: the red line of the helium-neon laser.
HELIUM_NEON: Final = 0.632990577
#: µmol/mol, carbon dioxide in indoor air.
_CO2: Final = 450.0
_KELVIN: Final = 273.15


def ciddor(
    air_c: FloatArray,
    pressure_hpa: FloatArray,
    humidity_percent: FloatArray,
    wavelength: float = HELIUM_NEON,
) -> FloatArray:
    """Return the refractive index n (k,) of air by Ciddor (1996), for 450 µmol/mol of carbon
    dioxide. ``air_c`` (°C), ``pressure_hpa`` (hPa) and ``humidity_percent`` are (k,),
    ``wavelength`` (µm, 0.3 to 1.7) is in vacuum. Valid from -40 to 100 °C and from 80 to 120 kPa.
    """
    S = wavelength**-2
    t, T, p = air_c, air_c + _KELVIN, 100.0 * pressure_hpa
    # refractivity of dry air at 15 °C, 101 325 Pa, and of water vapour at 20 °C, 13.33 hPa
    r_air = 1e-8 * (5792105.0 / (238.0185 - S) + 167917.0 / (57.362 - S))
    r_vapour = 1.022e-8 * (295.235 + 2.6422 * S - 0.03238 * S**2 + 0.004028 * S**3)
    R, M_vapour = 8.314472, 0.018015
    M_air = 0.0289635 + 1.2011e-8 * (_CO2 - 400.0)
    x = _vapour_fraction(t, p, humidity_percent)
    # compressibility of moist air (BIPM 1981/91)
    Z = (
        1.0
        - p
        / T
        * (
            1.58123e-6
            - 2.9331e-8 * t
            + 1.1043e-10 * t**2
            + (5.707e-6 - 2.051e-8 * t) * x
            + (1.9898e-4 - 2.376e-6 * t) * x**2
        )
        + (p / T) ** 2 * (1.83e-11 - 0.765e-8 * x**2)
    )
    density_air = (1.0 - x) * p * M_air / (Z * R * T)
    density_vapour = x * p * M_vapour / (Z * R * T)
    standard_air = 101325.0 * M_air / (0.9995922115 * R * 288.15)
    index: FloatArray = (
        1.0 + density_air / standard_air * r_air + density_vapour / 0.00985938 * r_vapour
    )
    return index


def edlen(
    air_c: FloatArray,
    pressure_hpa: FloatArray,
    humidity_percent: FloatArray,
    wavelength: float = HELIUM_NEON,
) -> FloatArray:
    """Return the refractive index n of air by the modified Edlén equation (arguments: `ciddor`).

    Near 20 °C both equations agree within 1e-8. At other temperatures and at high humidity, the
    equation of Ciddor is more accurate.
    """
    S = wavelength**-2
    t, p = air_c, 100.0 * pressure_hpa
    standard = 1e-8 * (8342.54 + 2406147.0 / (130.0 - S) + 15998.0 / (38.9 - S))
    X = (1.0 + 1e-8 * (0.601 - 0.00972 * t) * p) / (1.0 + 0.003661 * t)
    vapour = humidity_percent / 100.0 * saturation_pressure(t)
    moist = 1e-10 * 292.75 / (t + _KELVIN) * (3.7345 - 0.0401 * S) * vapour
    index: FloatArray = 1.0 + p * standard * X / 96095.43 - moist
    return index


def saturation_pressure(air_c: FloatArray) -> FloatArray:
    """Return the saturation pressure (Pa) of water vapour: over water, and below 0 °C over ice."""
    T = np.asarray(air_c) + _KELVIN
    omega = T - 0.238555575678 / (T - 650.175348448)
    A = omega**2 + 1167.05214528 * omega - 724213.167032
    B = -17.0738469401 * omega**2 + 12020.8247025 * omega - 3232555.03223
    C = 14.9151086135 * omega**2 - 4823.26573616 * omega + 405113.405421
    water = 1e6 * (2.0 * C / (-B + np.sqrt(B**2 - 4.0 * A * C))) ** 4
    theta = T / 273.16
    ice = 611.657 * np.exp(-13.928169 * (1.0 - theta**-1.5) + 34.7078238 * (1.0 - theta**-1.25))
    pressure: FloatArray = np.where(T >= _KELVIN, water, ice)
    return pressure


def _vapour_fraction(t: FloatArray, p: FloatArray, humidity_percent: FloatArray) -> FloatArray:
    """Return the mole fraction of water vapour in air of temperature ``t`` (°C) and pressure ``p``
    (Pa) (enhancement factor: Ciddor, 1996).
    """
    enhancement = 1.00062 + 3.14e-8 * p + 5.6e-7 * t**2
    fraction: FloatArray = humidity_percent / 100.0 * enhancement * saturation_pressure(t) / p
    return fraction
