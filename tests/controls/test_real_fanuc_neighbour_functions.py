"""The real FANUC backup with functions switched on beside its tables: the axis is worked on, and the
virtual control, which counts them with figures of its own, finds the predicted accuracy.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from backup_deal_fanuc import make
from backup_files_fanuc import FOLDER
from judge_fanuc import play

pytestmark = [
    pytest.mark.skipif(
        not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
    ),
    pytest.mark.short_estimate,
]


@pytest.mark.parametrize(
    ("name", "seed"),
    [
        ("inclination", 100),
        ("inclination_points_here", 101),
        ("straightness", 102),
        ("straightness_further", 100),
        ("cyclic", 101),
    ],
)
def test_what_stays_beside_the_table_is_honoured(name: str, seed: int, tmp_path: Path) -> None:
    job = make(name, seed)
    outcome = play(job, tmp_path)
    assert outcome.faults == [], str(outcome)
    assert outcome.code == 0
    assert outcome.written == [axis.name for axis in job.axes]


def test_a_cyclic_table_of_a_neighbour_in_the_own_numbers_is_refused_by_name(
    tmp_path: Path,
) -> None:
    """The points are both tables' data: a new value for one would change the other."""
    outcome = play(make("neighbour_cyclic_here", 100), tmp_path)
    assert outcome.code == 3
    assert outcome.written == []
    assert "parameter 14985 of axis 4" in outcome.said
