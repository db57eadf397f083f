"""What the next test will show: quantiles of its parameters."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Quantiles:
    """Median, 5 % and 95 % quantile of a parameter in a fresh test, in the unit of its draws (inside: mm or deg)."""

    median: float
    p05: float
    p95: float
