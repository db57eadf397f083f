"""The refractive index of air against printed values."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.evaluation.air import ciddor, edlen, saturation_pressure

#: °C, % relative humidity, kPa, nm in vacuum, n by Ciddor, n by the modified Edlén equation: the
#: table of check values of J. A. Stone and J. H. Zimmerman, "Index of Refraction of Air",
#: Engineering Metrology Toolbox, NIST.
NIST = (
    (20, 0, 101.325, 633, 1.000271800, 1.000271799),
    (20, 0, 60, 633, 1.000160924, 1.000160920),
    (20, 0, 120, 633, 1.000321916, 1.000321918),
    (50, 0, 100, 633, 1.000243285, 1.000243270),
    (5, 0, 100, 633, 1.000282756, 1.000282750),
    (-40, 0, 100, 633, 1.000337580, 1.000337471),
    (50, 100, 120, 633, 1.000287924, 1.000287864),
    (40, 75, 120, 633, 1.000299418, 1.000299406),
    (20, 100, 100, 633, 1.000267394, 1.000267394),
    (40, 100, 110, 1700, 1.000270247, 1.000270237),
    (20, 0, 101.325, 1700, 1.000268479, 1.000268483),
    (40, 100, 110, 300, 1.000289000, 1.000288922),
    (20, 0, 101.325, 300, 1.000286581, 1.000286579),
    (-40, 0, 120, 300, 1.000427233, 1.000427072),
)
#: °C, kPa, % relative humidity, 1e8 (n - 1) at 633 nm: Ciddor, Appl. Opt. 35 (1996) 1566, tables 1
#: (dry air, values of the measurements) and 3 (moist air). Of the row of table 3 at 40 °C, 80 kPa
#: the paper prints 19996.5; the difference that it prints beside it (-12.9) belongs to 19896.5.
CIDDOR: tuple[tuple[float, float, float, float], ...] = (
    (20, 80, 0, 21458.0),
    (20, 100, 0, 26824.4),
    (20, 120, 0, 32191.6),
    (10, 100, 0, 27774.7),
    (30, 100, 0, 25937.2),
    (20, 80, 75, 21394.0),
    (20, 120, 75, 32127.8),
    (40, 80, 75, 19896.5),
    (40, 120, 75, 29941.8),
    (50, 80, 100, 19058.4),
    (50, 120, 100, 28792.4),
)


@pytest.mark.parametrize(("t", "humidity", "kpa", "nm", "by_ciddor", "by_edlen"), NIST)
def test_check_values_of_nist(
    t: float, humidity: float, kpa: float, nm: float, by_ciddor: float, by_edlen: float
) -> None:
    state = (np.array([float(t)]), np.array([10.0 * kpa]), np.array([float(humidity)]))
    assert ciddor(*state, nm / 1000.0)[0] == pytest.approx(by_ciddor, abs=1e-9, rel=0)
    assert edlen(*state, nm / 1000.0)[0] == pytest.approx(by_edlen, abs=1e-9, rel=0)


@pytest.mark.parametrize(("t", "kpa", "humidity", "refractivity"), CIDDOR)
def test_tables_of_the_paper(t: float, kpa: float, humidity: float, refractivity: float) -> None:
    n = ciddor(np.array([float(t)]), np.array([10.0 * kpa]), np.array([float(humidity)]), 0.633)
    assert 1e8 * (n[0] - 1.0) == pytest.approx(refractivity, abs=0.06)


def test_saturation_pressure() -> None:
    """Over water 2339 Pa at 20 °C and 7384.9 Pa at 40 °C (steam tables), over ice 1.032 hPa at
    -20 °C (Smithsonian meteorological tables).
    """
    found = saturation_pressure(np.array([20.0, 40.0, -20.0]))
    assert found == pytest.approx([2339.0, 7384.9, 103.2], abs=0.5)
    assert found[2] == pytest.approx(103.2, abs=0.1)
