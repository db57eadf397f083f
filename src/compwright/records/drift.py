"""Stand-still tests (readings over time without motion) and lost motion over distance or speed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.foundations.provenance import Source
from compwright.records.axis import AxisKind, FloatArray


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftTest:
    """Readings of an axis at rest: ``minutes`` (k,) ascending, ``deviations`` (k,) mm or deg.

    ``kind``: linear (mm) or rotary (deg). ``header``: what the file states about the test, as text.
    """

    kind: AxisKind
    minutes: FloatArray
    deviations: FloatArray
    source: Source
    header: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class LostMotionTest:
    """Lost motion (k,) in mm after moves of different distance (mm) or speed (mm/min).

    ``over``: whether the moves differ in distance or in speed. ``header``: what the file states
    about the test, as text.
    """

    over: Literal["distance", "speed"]
    moves: FloatArray
    lost_motion: FloatArray
    source: Source
    header: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftRequest:
    """The file of a stand-still test, and how long a positioning test takes (min; None if not
    given).
    """

    file: str
    duration_min: float | None = None
