"""How the benchmark counts periods: what it asks is what was asked, no less."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from quality_summary import found


def record(*named: float, source: str = "found") -> dict[str, object]:
    periods = [{"period": period, "probability": 0.9, "source": source} for period in named]
    return {"periods": periods, "truth": [10.0], "told": [], "length": 600.0}


@pytest.mark.parametrize(
    ("named", "right", "wrong"),
    [
        ((10.0,), True, 0),
        ((10.19,), True, 0),
        ((10.3,), False, 1),
        ((5.0,), False, 1),
        ((20.0,), False, 1),
        ((10.0, 10.0 / 3), True, 1),
        ((), False, 0),
    ],
)
def test_only_the_true_period_is_right(named: tuple[float, ...], right: bool, wrong: int) -> None:
    """Within 2 % or 0.3 P²/L (0.05 mm here) of it; half, a third and twice are wrong names."""
    assert found(record(*named)) == ([right], wrong)


def test_what_the_job_tells_is_no_name() -> None:
    assert found({**record(10.0, source="job"), "told": [10.0]}) == ([False], 0)


def test_less_than_one_half_is_no_name() -> None:
    shy = record(13.0)
    shy["periods"] = [{"period": 13.0, "probability": 0.5, "source": "found"}]
    assert found(shy) == ([False], 0)
