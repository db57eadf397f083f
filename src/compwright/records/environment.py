"""The environment of a machine over time, and the times of its readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from compwright.foundations.provenance import Source
from compwright.records.axis import FloatArray

#: How times are given: two that are given differently cannot be compared.
Clock = Literal["date and time", "date and time with zone", "time of day", "number"]
#: The columns from which the refractive index of air comes.
AIR: Final = ("air_c", "pressure_hpa", "humidity_percent")
#: The column of the temperature of scale or workpiece, °C.
MATERIAL: Final = "material_c"


@dataclass(frozen=True, slots=True, kw_only=True)
class ReadingTimes:
    """The times of a test's readings, an array (m, n) for each direction, in s or as plain counts;
    NaN if unknown.
    """

    clock: Clock
    positive: FloatArray
    negative: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class EnvironmentRecord:
    """Air and material of a machine: ``values`` (k,) of each quantity at the ``times`` (k,).

    The times are like those of `ReadingTimes`. The quantities are either all three of `AIR` (°C,
    hPa, %) or none of them, and `MATERIAL` (°C).
    """

    clock: Clock
    times: FloatArray
    values: dict[str, FloatArray]
    sources: tuple[Source, ...]

    @property
    def has_air(self) -> bool:
        """Whether the record contains temperature, pressure and humidity of the air."""
        return AIR[0] in self.values and AIR[1] in self.values and AIR[2] in self.values


@dataclass(frozen=True, slots=True, kw_only=True)
class InstrumentAir:
    """The air (°C, hPa, %) for which the laser converts wavelengths to lengths. ``stated``: the job
    states it; else it is assumed.
    """

    air_c: float = 20.0
    pressure_hpa: float = 1013.25
    humidity_percent: float = 50.0
    stated: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class EnvironmentRequest:
    """The job's environment files, and how readings are corrected by the refractive index."""

    files: tuple[str, ...]
    equation: Literal["ciddor", "edlen"] = "ciddor"
    instrument_air: InstrumentAir | None = InstrumentAir()


@dataclass(frozen=True, slots=True, kw_only=True)
class Environment:
    """The environment record that corrects a test, the equation for the refractive index of air,
    and the air that the instrument assumed.

    ``needs_time``: whether the readings must have times, because the record covers other tests too.
    """

    record: EnvironmentRecord
    equation: Literal["ciddor", "edlen"]
    instrument_air: InstrumentAir | None
    needs_time: bool = False
