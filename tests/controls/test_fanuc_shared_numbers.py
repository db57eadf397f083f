"""Two axes of a FANUC on one row of point numbers: the axis under work gets numbers of its own, the
other one keeps what it has, and where none are free the row that is missing is named.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from backup_files_fanuc import FOLDER, Backup
from backup_jobs_fanuc import Job, axis_job
from judge_fanuc import Outcome, play, quietly, reloaded
from virtual_fanuc import Grid, VirtualFanuc

pytestmark = [
    pytest.mark.skipif(
        not FOLDER.is_dir(), reason="the real FANUC backup is not beside the project"
    ),
    pytest.mark.short_estimate,
]
#: What X, Y, Z and B of the real backup claim; Y claims the numbers of X in these tests.
CLAIMED = {*range(1, 42), *range(201, 242), *range(300, 313)}


def shared(free: Sequence[int] | None = None) -> Backup:
    """The real backup with Y on the numbers of X; ``free``: the only other ones without data."""
    backup = Backup.real()
    for number in (3620, 3621, 3622, 3624):
        backup.set(number, "A2", backup.get(number, "A1"))
    if free is not None:
        held = set(range(1536)) - CLAIMED - set(free)
        backup.points(dict.fromkeys(held, 1))
    return backup


def played(backup: Backup, folder: Path, *numbers: int) -> tuple[Outcome, dict[int, Grid]]:
    rng = np.random.default_rng(3)
    axes = tuple(axis_job(rng, number) for number in numbers)
    outcome = play(Job("shared", 1, "answerable", axes, backup.files(), names=("row",)), folder)
    tables = folder / "out" / "tables" / "fanuc-30i"
    if not tables.is_dir():
        return outcome, {}
    after = VirtualFanuc(reloaded(backup.files(), tables))
    return outcome, {number: after.grid(number) for number in (1, 2, 3, 4)}


def test_the_axis_under_work_moves_and_the_other_one_keeps_its_numbers(tmp_path: Path) -> None:
    """The judge of the tests demands too that no entry of Y and no shared point differs."""
    outcome, grids = played(shared(), tmp_path, 1)
    assert outcome.written == ["X"]
    assert outcome.faults == []
    assert (grids[2].reference, grids[2].first, grids[2].last) == (40, 1, 41)
    assert not grids[1].numbers() & CLAIMED
    assert grids[1].interval == 40.0  # the grid that is there stays
    assert grids[1].last - grids[1].first == 40


def test_both_under_work_get_rows_apart(tmp_path: Path) -> None:
    outcome, grids = played(shared(), tmp_path, 1, 2)
    assert outcome.written == ["X", "Y"]
    assert not grids[1].numbers() & grids[2].numbers()
    for number in (1, 2):
        assert not grids[number].numbers() & {*range(201, 242), *range(300, 313)}


def test_what_is_left_is_divided(tmp_path: Path) -> None:
    """20 free numbers are too few for two grids of 41: coarser ones go there side by side."""
    outcome, grids = played(shared(range(500, 520)), tmp_path, 1, 2)
    assert outcome.written == ["X", "Y"], str(outcome)
    assert grids[1].numbers() | grids[2].numbers() <= set(range(500, 520))


def test_no_free_number_refuses_with_the_longest_row(tmp_path: Path) -> None:
    outcome, _ = played(shared([700]), tmp_path, 1)
    assert outcome.code == 4
    assert "the longest row that no other axis uses has 1" in outcome.said
    outcome, grids = played(shared([]), tmp_path / "other", 3)
    assert outcome.written == ["Z"]  # a neighbour of both has nothing to do with it
    assert (grids[3].first, grids[3].last) == (201, 241)


def test_decode_shows_both_and_says_that_they_share(tmp_path: Path) -> None:
    files = []
    for name, content in shared().files().items():
        (tmp_path / name).write_bytes(content)
        files.append(str(tmp_path / name))
    code, said, shown = quietly(["decode", *files, "--format", "fanuc-30i"])
    assert code == 0, said
    assert "axes 1 and 2 share the compensation point numbers 1 to 41" in " ".join(
        (shown + said).split()
    )


def test_numbers_of_ones_own_are_shared_with_nobody(tmp_path: Path) -> None:
    """Every number holds something: X may choose among its own 41, whatever the spacings that Y and
    Z name need of theirs.
    """
    backup = Backup.real()
    own = {*range(1, 42), *range(101, 142), *range(201, 242), *range(300, 313)}
    backup.points(dict.fromkeys(set(range(1536)) - own, 1))
    rng = np.random.default_rng(4)
    spacings = {1: "auto", 2: "27.5", 3: "auto"}
    axes = tuple(
        axis_job(rng, number, words={"table": f"{{spacing: {spacing}}}"})
        for number, spacing in spacings.items()
    )
    job = Job("own", 1, "answerable", axes, backup.files())
    outcome = play(job, tmp_path)
    assert outcome.written == ["X", "Y", "Z"], str(outcome)
    assert outcome.faults == []
    after = VirtualFanuc(reloaded(backup.files(), tmp_path / "out" / "tables" / "fanuc-30i"))
    for number, first in ((1, 1), (2, 101), (3, 201)):
        numbers = after.grid(number).numbers()
        assert numbers <= set(range(first, first + 41))
        assert len(numbers) > 10
