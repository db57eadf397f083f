"""Points that somebody types by hand: the fewest of which a test shows next to nothing more than of
the best table. A table that is loaded as a file, and one whose spacing is named, stay as they are.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate


@pytest.fixture(scope="module")
def test_file(tmp_path_factory: pytest.TempPathFactory) -> str:
    """A slow wave of 6 µm and a slope: straight lines over 90 mm hold it to 0.2 µm."""
    rng = np.random.default_rng(3)
    targets = np.round((np.arange(26) + 0.5 + rng.uniform(-0.3, 0.3, 26)) * 1260 / 26, 3)
    rows = ["# axis: X", "target_mm,direction,run,deviation_um"]
    for run in range(1, 6):
        for sign, lost in (("+", 0.0), ("-", 2.5)):
            for x in targets:
                value = 0.02 * x + 6 * np.sin(x / 180) + 1.5 * np.sin(x / 50) + lost
                rows.append(f"{x},{sign},{run},{value + rng.normal(0, 0.7):.3f}")
    path = tmp_path_factory.mktemp("typed") / "x.csv"
    path.write_text("\n".join(rows) + "\n")
    return str(path)


def outcome(test_file: str, format_id: str, out: Path, *options: str) -> dict[str, Any]:
    words = ["--format", format_id, "--axis", "X", "--travel", "0:1260", "--state", "none"]
    words += [f"--option={option}" for option in options]
    assert compwright(["run", test_file, *words, "--out", str(out)]) == 0
    axis: dict[str, Any] = json.loads((out / "prediction.json").read_text())["axes"]["X"]
    return axis


def medians(axis: dict[str, Any]) -> np.ndarray[Any, Any]:
    return np.array([axis[key]["A"]["median"] for key in ("predicted", "predicted_new_targets")])


@pytest.mark.parametrize("format_id", ["heidenhain-itnc530", "heidenhain-nck"])
def test_the_fewest_points_within_a_tenth_are_typed(
    format_id: str, test_file: str, tmp_path: Path
) -> None:
    """The other choice, taken as the finding says it, is what is compared with; one with spacings
    that are a quarter wider loses more.
    """
    few = outcome(test_file, format_id, tmp_path / "few", "table_values=error")
    (values,) = (one["values"] for one in few["findings"] if one["code"] == "CW-P144")
    positions = np.array(few["table"]["positions"])
    sheet = (tmp_path / "few" / "card" / "entry_X.csv").read_text().splitlines()
    typed = [line for line in sheet if line.split(",")[0].isdigit()]
    assert len(typed) == positions.size == values["few"]["points"]
    mine = values["mine"]
    assert (mine["name"], mine["unit"]) == ("A", "um")
    np.testing.assert_allclose([mine["value"], mine["elsewhere"]], medians(few), atol=0.2)
    spacing = values["spacing"]
    many = outcome(
        test_file, format_id, tmp_path / "many", "table_values=error", f"spacing={spacing:g}"
    )
    assert len(many["table"]["positions"]) > 1.2 * positions.size
    assert np.all(medians(few) < medians(many) + 0.11)
    assert not any(one["code"] == "CW-P144" for one in many["findings"])
    wide = 1.25 * (positions[1] - positions[0])
    fewer = outcome(
        test_file, format_id, tmp_path / "fewer", "table_values=error", f"spacing={wide:g}"
    )
    assert np.any(medians(fewer) > medians(many) + 0.1)
    assert positions[0] <= -(positions[1] - positions[0]) + 1e-6  # a spacing beyond the travel
    assert positions[-1] >= 1260 + (positions[1] - positions[0]) - 1e-6


def test_what_is_loaded_as_a_file_has_the_points_that_it_needs(
    test_file: str, tmp_path: Path
) -> None:
    axis = outcome(test_file, "siemens-840d-sl", tmp_path / "out", "address=AX1")
    assert not any(one["code"] == "CW-P144" for one in axis["findings"])
