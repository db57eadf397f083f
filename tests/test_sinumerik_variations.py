"""A fixed deal of random jobs on variations of the real archive, before a virtual control that
shares nothing with the package: container and texts, small files and patched ones, the way back,
what is read back, the test after loading.

``benchmarks/bench_backups_sinumerik.py`` deals some hundred more.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import backup_acting_sinumerik as acting
from backup_cases_sinumerik import Case
from backup_deal_sinumerik import dealt, deliver
from backup_variations_sinumerik import Special, named
from compwright.cli import run as compwright
from sinumerik_archive import ARCHIVE, needs_archive, whole_container
from sinumerik_follow import follow
from sinumerik_judge import Outcome, Run, try_case

pytestmark = needs_archive

Judge = Callable[[Case], Outcome]


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Run:
    def command(arguments: list[str]) -> tuple[int, str]:
        capsys.readouterr()
        code = compwright(arguments)
        out, err = capsys.readouterr()
        return code, err + out

    return command


@pytest.fixture
def judged(tmp_path: Path, run: Run) -> Judge:
    """Run one case, load what it wrote, and all that comes after it."""

    def judge(case: Case) -> Outcome:
        outcome = try_case(case, tmp_path, run)
        follow(outcome, tmp_path, run)
        return outcome

    return judge


@pytest.mark.parametrize("seed", [300, 302, 304, 306, 307, 311])
def test_a_dealt_job_does_no_harm(seed: int, judged: Judge) -> None:
    """Written well or refused by name; what is exported afterwards is what was planned, a slip is
    noticed, the test after loading says whether the table acts.
    """
    outcome = judged(dealt(seed))
    assert not outcome.harms, outcome.line()


@pytest.mark.parametrize(
    ("special", "seed"),
    [
        (acting.products_into_the_axis, 1),
        (acting.odd_tables_into_the_axis, 1),
        (acting.own_odd_table, 1),
        (acting.own_product, 1),
        (acting.step_that_does_not_divide, 2),
        (acting.step_that_does_not_divide, 3),
        (acting.inch_with_builders_tables, 1),
        (acting.units_of_the_users_own, 1),
        (acting.second_gantry, 1),
        (acting.work_on_the_follower, 1),
        (acting.programs_in_the_container, 1),
        (acting.small_files_over_the_container, 1),
        (acting.damaged_container, 1),
        (acting.copies_that_differ, 1),
        (acting.pair_of_the_828d, 1),
        (acting.limits_told_from_the_other_end, 1),
    ],
)
def test_what_acts_is_honoured_or_refused_by_name(
    special: Special, seed: int, tmp_path: Path, run: Run
) -> None:
    case = named(special, seed)
    if case.files is None:
        deliver(case, np.random.default_rng(len(special.__name__)), special.__name__)
    outcome = try_case(case, tmp_path, run)
    assert not outcome.harms, outcome.line()


def test_the_real_container_with_its_own_texts_is_itself() -> None:
    """The writer of variations against the file of the control: sizes, padding, header sums."""
    assert whole_container({"MD.INI": ""}) == ARCHIVE.read_bytes()
