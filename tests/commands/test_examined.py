"""Statistics seen from outside: virtual machines, the command line, and nothing of the package."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from bench_examiner import run_job, second_test
from examiner_axes import (
    Axis,
    constant,
    fresh,
    jump,
    scatter,
    smooth,
    spread_targets,
    together,
)

SHIFTS = np.array([0.0, 1.3, -0.7, 2.2, 0.4])
STEP = 403.0


@pytest.fixture(scope="module")
def first_round(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[Axis], Path, Any]:
    """An axis whose runs are shifted and nothing else, one with a jump, one that is plain."""
    rng = np.random.default_rng(4)
    targets = spread_targets(21, rng=rng)
    shifted = Axis("S", smooth(rng, 6), constant(-2), scatter(0, SHIFTS.std(ddof=1)), targets)
    shifted.readings = shifted.means(targets)[:, None, :] + SHIFTS[:, None]
    parts = together(smooth(rng, 4), jump(STEP, 60.0))
    stepped = Axis("J", parts, constant(-1), scatter(0.3, 0.2), spread_targets(17, rng=rng))
    plain = Axis("P", smooth(rng, 10), constant(-2), scatter(0.4), spread_targets(21, rng=rng))
    for axis in (stepped, plain):
        axis.readings = axis.test(rng, axis.targets)
    place = tmp_path_factory.mktemp("first")
    _, answer = run_job(place, [shifted, stepped, plain], {})
    return [shifted, stepped, plain], place, answer


def test_spread_between_runs_counts_as_it_was(first_round: tuple[list[Axis], Path, Any]) -> None:
    """Fresh tests with new shifts of the same spread stay below the band's end."""
    (shifted, *_), _, answer = first_round
    values = fresh(shifted, answer["axes"]["S"]["table"], 5, new_targets=False)
    band = answer["axes"]["S"]["predicted"]["A"]
    assert (values > band["p95"]).mean() < 0.1
    assert band["median"] > 0.7 * np.median(values)


def test_jump_is_named_and_no_worse_than_interpolation(
    first_round: tuple[list[Axis], Path, Any],
) -> None:
    """The finding has the two targets around the jump; new targets are not worse off."""
    _, stepped, _ = first_round[0]
    answer = first_round[2]["axes"]["J"]
    said = next(f["message"] for f in answer["findings"] if f["code"] == "CW-E030")
    below, above = stepped.targets[stepped.targets < STEP][-1], stepped.targets.searchsorted(STEP)
    assert f"{below:g}" in said
    assert f"{stepped.targets[above]:g}" in said
    table = fresh(stepped, answer["table"], 5, new_targets=True).mean()
    means = fresh(stepped, stepped.readings.mean(axis=1), 5, new_targets=True).mean()
    assert table < 1.1 * means


def test_the_test_that_made_the_table_makes_no_second_one(
    first_round: tuple[list[Axis], Path, Any], tmp_path: Path
) -> None:
    """Rounded and with another datum, it does not go with the table that it led to."""
    (*_, plain), place, answer = first_round
    control = tmp_path / "control"
    control.mkdir()
    for name in ("joint_2.comp", "joint_2.ini"):
        table = place / "out" / "tables" / "linuxcnc" / name
        (control / name.replace("2", "0")).write_bytes(table.read_bytes().replace(b"_2", b"_0"))
    again = Axis("P", plain.error, plain.reversal, plain.noise, plain.targets)
    again.readings = plain.readings
    second_test(again, "datum", answer["axes"]["P"]["table"], np.random.default_rng(1))
    code, now = run_job(tmp_path / "second", [again], {"P": 100.0}, "[../control]")
    assert code == 1
    assert now["axes"]["P"]["accept"]["A"]["decision"] == "undecided"
    assert not (tmp_path / "second" / "out" / "tables").exists()
