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

from backup_acting_sinumerik import ACTING
from backup_cases_sinumerik import Case
from backup_deal_sinumerik import dealt, deliver
from backup_variations_sinumerik import Special, named
from compwright.cli import run as compwright
from sinumerik_archive import needs_archive
from sinumerik_follow import follow
from sinumerik_judge import Outcome, try_case

pytestmark = needs_archive

Judge = Callable[[Case], Outcome]
SEEDS = range(300, 318)


@pytest.fixture
def judged(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Judge:
    """Run one case, load what it wrote, and all that comes after it."""

    def run(arguments: list[str]) -> tuple[int, str]:
        capsys.readouterr()
        code = compwright(arguments)
        out, err = capsys.readouterr()
        return code, err + out

    def judge(case: Case) -> Outcome:
        outcome = try_case(case, tmp_path, run)
        follow(outcome, tmp_path, run)
        return outcome

    return judge


@pytest.mark.parametrize("seed", [seed for seed in SEEDS if seed not in {303, 305, 309}])
def test_a_dealt_job_does_no_harm(seed: int, judged: Judge) -> None:
    outcome = judged(dealt(seed))
    assert not outcome.harms, outcome.line()


@pytest.mark.parametrize("special", [special for special, _ in ACTING], ids=lambda s: s.__name__)
def test_each_special_is_honoured_or_refused_by_name(special: Special, judged: Judge) -> None:
    case = named(special, 1)
    if case.files is None:
        deliver(case, np.random.default_rng(len(special.__name__)), special.__name__)
    outcome = judged(case)
    assert not outcome.harms, outcome.line()
