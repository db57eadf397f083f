"""What was around a machine over time, and when its readings were taken."""

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
    """When the readings of a test were taken, by direction (m, n); s, or what the file's own
    numbers count; NaN where no reading is.
    """

    clock: Clock
    positive: FloatArray
    negative: FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class EnvironmentRecord:
    """A record of the environment: ``times`` (k,) strictly ascending, as those of `ReadingTimes`;
    ``values`` (k,) by column: all three of `AIR` (°C, hPa, %) or none, and `MATERIAL` (°C).
    """

    clock: Clock
    times: FloatArray
    values: dict[str, FloatArray]
    sources: tuple[Source, ...]

    @property
    def has_air(self) -> bool:
        """Whether the refractive index of the air is known."""
        return AIR[0] in self.values and AIR[1] in self.values and AIR[2] in self.values


@dataclass(frozen=True, slots=True, kw_only=True)
class InstrumentAir:
    """The air (°C, hPa, %) for which the display of a laser counts; ``stated``: by the job."""

    air_c: float = 20.0
    pressure_hpa: float = 1013.25
    humidity_percent: float = 50.0
    stated: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class EnvironmentRequest:
    """The files of a record, the equation of the refractive index, and the air for which the
    instrument counts; None: it counts in wavelengths of vacuum.
    """

    files: tuple[str, ...]
    equation: Literal["ciddor", "edlen"] = "ciddor"
    instrument_air: InstrumentAir | None = InstrumentAir()


@dataclass(frozen=True, slots=True, kw_only=True)
class Environment:
    """The record by which a test is reduced, and how: see `EnvironmentRequest`. ``needs_time``:
    the readings have to say when they were taken, because the record holds other tests too.
    """

    record: EnvironmentRecord
    equation: Literal["ciddor", "edlen"]
    instrument_air: InstrumentAir | None
    needs_time: bool = False
