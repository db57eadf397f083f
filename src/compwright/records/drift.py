"""A stand-still test: what the instrument reads over time while the axis stands (environmental
temperature variation error, ISO 230-3).
"""

from __future__ import annotations

from dataclasses import dataclass

from compwright.foundations.provenance import Source
from compwright.records.axis import AxisKind, FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftTest:
    """Readings over time: ``minutes`` (k,) strictly ascending, ``deviations`` (k,) mm or deg by
    ``kind``.
    """

    kind: AxisKind
    minutes: FloatArray
    deviations: FloatArray
    source: Source


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftRequest:
    """The file of a stand-still test, and how long (min) a positioning test of the job takes; None:
    not said.
    """

    file: str
    duration_min: float | None = None
