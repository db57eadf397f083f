"""Files that were cut off at any place: either an error, or a finding, or nothing was lost."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.records.positioning import PositioningTest
from laser_files import compensation_file, laser_file, mean_file
from one_test import read_positioning

TARGETS = (0.0, 100.5, 200.25, 300.75)
BY_RUN = [(t, d, r) for r in (1, 2, 3) for d in "+-" for t in TARGETS]
IN_TURN = [(t, d, r) for r in (1, 2, 3) for t in TARGETS for d in "+-"]
BY_TARGET = [(t, d, r) for t in TARGETS for d in "+-" for r in (1, 2, 3)]
CUT = {"CW-R006", "CW-R007", "CW-R050", "CW-R051", "CW-R053"}


def text(rows: list[tuple[float, str, int]], *keys: str) -> str:
    lines = [*keys, "target_mm,direction,run,deviation_um"]
    lines += [f"{t},{d},{r},{r + t / 100:.3f}" for t, d, r in rows]
    return "\n".join([*lines, ""])


def read(content: str) -> PositioningTest:
    return read_positioning(content.encode(), "x.csv")


def messages_by_code(test: PositioningTest) -> dict[str, str]:
    return {finding.code: finding.message for finding in test.findings}


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (BY_RUN, "The last rows belong to run -3"),
        (BY_TARGET, "The last rows belong to target 300.75 mm"),
    ],
)
def test_the_last_run_or_target_lacks_readings(
    rows: list[tuple[float, str, int]], words: str
) -> None:
    assert not CUT & messages_by_code(read(text(rows))).keys()
    assert words in messages_by_code(read(text(rows[:-2])))["CW-R053"]


@pytest.mark.parametrize("lost", [1, 2, 3, 4])
def test_the_last_run_lacks_readings_where_each_target_is_approached_from_both_sides(
    lost: int,
) -> None:
    assert not CUT & messages_by_code(read(text(IN_TURN))).keys()
    message = messages_by_code(read(text(IN_TURN[:-lost])))["CW-R053"]
    assert f"The last rows belong to run 3, which lacks {lost} of 8 readings" in message


@pytest.mark.parametrize(
    ("rows", "hole"), [(BY_RUN, 5), (BY_RUN, -3), (BY_TARGET, 11), (IN_TURN, 5), (IN_TURN, -3)]
)
def test_a_hole_elsewhere_is_no_cut(rows: list[tuple[float, str, int]], hole: int) -> None:
    """Also a hole in the last run: a file that ends there would lack the rows behind it too."""
    assert "CW-R053" not in messages_by_code(read(text([row for row in rows if row != rows[hole]])))


@pytest.mark.parametrize(
    ("key", "words"),
    [("# targets: 5", "has 5 targets"), ("# Number of runs: 4", "has 4 runs"), ("# runs: 3", "")],
)
def test_less_than_a_key_says(key: str, words: str) -> None:
    message = messages_by_code(read(text(BY_RUN, key))).get("CW-R053", "")
    assert words in message
    assert bool(words) == bool(message)


def same(one: PositioningTest, other: PositioningTest) -> bool:
    return (
        np.array_equal(one.targets, other.targets)
        and np.array_equal(one.positive, other.positive, equal_nan=True)
        and np.array_equal(one.negative, other.negative, equal_nan=True)
    )


LASER = {
    (run, index): f"{run}.{index}" for run in (1, 2, 3, 4) for index in range(1, len(TARGETS) + 1)
}
MEANS = [(str(target), f"{0.001 + target * 1e-5:.4f}") for target in TARGETS]
TABLE = [["1", "-250", "0", "-0.0002"], ["2", "-225", "0.0013", "0.0008"]]
FILES = {
    "by run": text(BY_RUN, "# axis: X", f"# targets: {len(TARGETS)}", "# runs: 3"),
    "in turn": text(IN_TURN, "# axis: X", f"# targets: {len(TARGETS)}", "# runs: 3"),
    "by target": text(BY_TARGET, "# axis: X", f"# targets: {len(TARGETS)}", "# runs: 3"),
    "runs of a laser": laser_file([str(target) for target in TARGETS], LASER),
    "means of a laser": mean_file({"Forward Directional": MEANS, "Reverse Directional": MEANS}),
    "compensation": compensation_file(TABLE, end="-225 mm"),
}


@pytest.mark.parametrize("form", FILES)
def test_cut_at_every_byte(form: str) -> None:
    whole = FILES[form]
    full = read(whole)
    assert not CUT & messages_by_code(full).keys()
    for end in range(len(whole)):
        try:
            test = read(whole[:end])
        except InputError:
            continue
        assert same(test, full) or CUT & messages_by_code(test).keys(), whole[:end][-60:]
