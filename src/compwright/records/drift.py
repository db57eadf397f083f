"""Tests of two columns: a stand-still test, that is readings of the instrument over time while the
axis does not move (environmental temperature variation error, ISO 230-3); lost motion over the
distance or the speed of the move.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

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
class LostMotionTest:
    """Lost motion (k,), mm, after ``moves`` (k,) ascending: their distance, mm, or speed, mm/min,
    by ``over``; ``header``: what the file says about the test, as text.
    """

    over: Literal["distance", "speed"]
    moves: FloatArray
    lost_motion: FloatArray
    source: Source
    header: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, kw_only=True)
class DriftRequest:
    """The file of a stand-still test, and the duration (min) of a positioning test of the job;
    None: not given.
    """

    file: str
    duration_min: float | None = None
