"""A stand-still test: readings of the instrument over time while the axis does not move
(environmental temperature variation error, ISO 230-3).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.foundations.provenance import Source
from compwright.records.axis import AxisKind, FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftTest:
    """Readings over time: ``minutes`` (k,) strictly ascending, ``deviations`` (k,) mm or deg by
    ``kind``; ``header``: what the file says about the test, as text.
    """

    kind: AxisKind
    minutes: FloatArray
    deviations: FloatArray
    source: Source
    header: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftRequest:
    """The file of a stand-still test, and the duration (min) of a positioning test of the job;
    None: not given.
    """

    file: str
    duration_min: float | None = None
