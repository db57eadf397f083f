"""Lost motion over distance or speed: logs of a real machine, and axes whose lost motion is known.

The logs: a placement machine, X axis, measured by camera (`jkoelker/lumenpnp-configs@49b6cee`,
`openpnp/machine.xml`): after moves straight into position, and after a slow last approach.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright

DISTANCES = (0.06, 0.12, 0.17, 0.24, 0.34, 0.48, 0.68, 0.96, 1.36, 1.92, 2.72, 3.84, 5.43, 7.68)
STRAIGHT = (13.2, 26.3, 29.6, 26.3, 32.9, 39.5, 39.5, 56.0, 62.5, 62.5, 65.8, 65.8, 59.2, 65.8)
SLOW = (75.7, 82.3, 82.3, 79.0, 79.0, 79.0, 75.7, 85.6, 85.6, 85.6, 85.6, 82.3, 82.3, 79.0)


def evaluated(folder: Path, moves: Any, values: Any, column: str = "distance_mm") -> dict[str, Any]:
    rows = "".join(f"{at:g},{value:.3f}\n" for at, value in zip(moves, values, strict=True))
    file = folder / "lost.csv"
    file.write_text(f"# axis: X\n{column},lost_motion_um\n{rows}", encoding="utf-8")
    assert compwright(["evaluate", str(file), "--json", str(folder / "a.json"), "--force"]) == 0
    [result] = json.loads((folder / "a.json").read_text(encoding="utf-8"))["results"]
    return dict(result)


def test_a_real_log_whose_lost_motion_grows_with_the_distance(tmp_path: Path) -> None:
    result = evaluated(tmp_path, DISTANCES, STRAIGHT)
    assert (result["kind"], result["over"], result["depends"]) == ("lost_motion", "distance", True)
    assert result["parameters"] == {"constant": 39.5, "left": 26.3}  # between 13.2 and 65.8
    assert [finding["code"] for finding in result["findings"]] == ["CW-T040"]
    assert all(word in result["findings"][0]["message"] for word in ("0.06 mm", "±26.30 µm"))


def test_a_real_log_that_a_slow_approach_makes_nearly_one_constant(tmp_path: Path) -> None:
    result = evaluated(tmp_path, DISTANCES, SLOW)
    assert not result["depends"]
    assert result["parameters"]["left"] == pytest.approx(4.95)


def test_what_a_constant_leaves_is_not_rounded_to_nothing(tmp_path: Path) -> None:
    """Means of 3.40, 3.45 and 3.42 µm: a constant leaves half their range, 0.025 µm."""
    values = (3.39, 3.41, 3.44, 3.46, 3.41, 3.43)
    [finding] = evaluated(tmp_path, (1.0, 1.0, 10.0, 10.0, 100.0, 100.0), values)["findings"]
    assert re.search("±0.0[23] µm", finding["message"])


def test_a_constant_lost_motion_is_seldom_taken_for_another(tmp_path: Path) -> None:
    """With repeats and without: the test is to err once in 1000 cases, here at most once in 40."""
    wrong = 0
    for seed in range(40):
        moves = np.repeat(DISTANCES, 3) if seed % 2 else DISTANCES
        values = 20.0 + np.random.default_rng(seed).normal(0.0, 1.0, len(moves))
        wrong += evaluated(tmp_path, moves, values)["depends"]
    assert wrong <= 1


def test_repeats_show_a_lost_motion_that_is_largest_in_between(tmp_path: Path) -> None:
    speeds = np.repeat([100.0, 500.0, 1000.0, 2000.0, 5000.0], 4)
    values = np.repeat([5.0, 8.0, 9.0, 8.0, 5.0], 4) + np.tile([0.3, -0.3, 0.2, -0.2], 5)
    result = evaluated(tmp_path, speeds, values, "speed_mm_min")
    assert (result["over"], result["depends"]) == ("speed", True)
    assert result["parameters"] == {"constant": 7.0, "left": 2.0}


def test_few_values_say_that_they_are_few(tmp_path: Path) -> None:
    result = evaluated(tmp_path, [1, 2, 5], [5.0, 8.0, 9.0], "speed_mm_min")
    assert not result["depends"]
    assert "eight values" in result["findings"][0]["message"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("distance_mm,lost_motion_um\n1,5\n2,6\n", "3 at least"),
        ("distance_mm,lost_motion_um\n-1,5\n2,6\n3,5\n", "above zero"),
        ("speed_mm_min,lost_motion_um\n1,a\n2,6\n3,5\n", "line 2"),
        ("distance_mm,lost_motion_um\n", "3 at least"),
        ("distance_mm,speed_mm_min,lost_motion_mm\n1,2,5\n", "lost.csv"),
    ],
)
def test_broken_tables_are_refused_with_their_place(
    tmp_path: Path, text: str, said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "lost.csv"
    file.write_text(text, encoding="utf-8")
    assert compwright(["evaluate", str(file)]) == 3
    assert said in " ".join(capsys.readouterr().err.split())
