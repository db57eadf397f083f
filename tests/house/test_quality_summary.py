"""How the benchmark counts periods: what it asks is what was asked, no less."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from quality_summary import found, summary


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


def axis(a_fresh: list[float], right: float) -> dict[str, object]:
    """Return an axis with a band of A from 2 to 4, whose table is as good as half the truth's."""
    same = {"A": [2.0, 3.0, 4.0]}
    fresh = {"same": {"A": a_fresh}, "new": {"A": [9.0]}}
    merit = {"new": dict.fromkeys(("informed", "interpolation", "spline", "minimax"), 3.0)}
    merit["new"] |= {"ours": 2.0, "oracle": 1.0}
    return {
        "kind": "k",
        "seconds": 1.0,
        "merit": merit,
        "fresh": fresh,
        "bands": {"same": same, "new": same},
        "informed": {"same": {"A": [2.5, 3.0, 3.5]}, "new": {"A": [1.0, 3.0, 5.0]}},
        **record(right),
    }


def test_the_numbers_of_a_kind_are_those_counted_by_hand() -> None:
    """Held: 1 of 4 and 4 of 4. Widths: 2/1 and 2/4. One of two periods is found, one axis has a
    wrong name; a run that failed is not counted.
    """
    some = [axis([1.0, 3.0, 5.0, 6.0], 10.0), axis([2.0, 3.0, 3.5, 4.0], 13.0)]
    assert summary("k", [*some, {"kind": "k", "failed": "x"}]) == {
        "kind": "k",
        "axes": 2,
        "same": [62.0, 62.0],
        "new": [0.0, 0.0],
        "width": [1.25, 1.25],
        "A": [2.0, 3.0, 3.0, 3.0, 3.0],
        "periods": [1, 2],
        "wrong": 1,
    }


def test_the_evidence_of_the_readme_is_that_of_the_page() -> None:
    project = Path(__file__).resolve().parents[2]
    kept = json.loads((project / "docs" / "quality.json").read_text(encoding="utf-8"))
    readme = (project / "README.md").read_text(encoding="utf-8")
    whole, faults = kept["tables"]["rows"][0], kept["faults"]
    for words in (
        f"held for {whole['same'][0]:.0f} % of the parameters of fresh tests at the same targets",
        f"and {whole['new'][0]:.0f} % at new ones, on {whole['axes']} virtual axes",
        f"was {whole['A'][0]:.2f} times that of a table that knows the truth",
        f"reach {whole['A'][2]:.2f}",
        f"{faults['cases']} loading faults",
        "{} of {} named".format(*faults["far"]),
    ):
        assert words in readme, words
    assert faults["wrong"] == 0, "README: no wrong name"


def test_who_must_find_the_period_agrees_with_who_knows_it_on_many_targets() -> None:
    """60 targets show 3 µm: both judges expect the same error. None of it at 7 targets: the one
    who must find the period expects less than half the wave.
    """
    from informed import inform, without_period
    from machine_kinds import machine_of
    from machines import dithered, name_seed

    machine = machine_of("pitch unknown", 0)
    x = np.linspace(machine.low, machine.high, 1000)
    gaps = []
    for count in (60, 7):
        rng = name_seed("who must find the period", count)
        targets = dithered(rng, machine.low, machine.length, count)
        axis = replace(machine, targets=targets)
        readings = axis.measure(targets, rng)
        other = without_period(axis, readings, x)
        gaps.append(float(np.std(other - inform(axis, [readings]).error(x))))
    assert gaps[0] < 0.05
    assert gaps[1] > 0.35
