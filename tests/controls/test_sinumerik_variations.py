"""A fixed deal of random jobs on variations of the real archive, before a virtual control that
shares nothing with the package: container and texts, small files and patched ones, the way back,
what is read back, the test after loading.

``benchmarks/bench_backups_sinumerik.py`` deals some hundred more.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import backup_active_sinumerik as specials
from backup_cases_sinumerik import Case
from backup_deal_sinumerik import dealt, deliver
from backup_variations_sinumerik import Special, named
from compwright.cli import run as compwright
from sinumerik_archive import ARCHIVE, needs_archive, whole_container
from sinumerik_container import Packing
from sinumerik_follow import exported, follow
from sinumerik_judge import (
    Outcome,
    Run,
    control_before,
    entries_of_others,
    foreign_registers,
    moved_grid,
    try_case,
    way_back,
)

pytestmark = [needs_archive, pytest.mark.short_estimate]

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


# 21068: two idle tables, and the files do not show which one would be switched on.
@pytest.mark.parametrize("seed", [300, 304, 307, 311, 21068])
def test_a_dealt_job_does_no_harm(seed: int, judged: Judge) -> None:
    """Written well or refused by name; what is exported afterwards is what was planned, a slip is
    noticed, the test after loading says whether the table is active.
    """
    outcome = judged(dealt(seed))
    assert not outcome.harms, outcome.line()


@pytest.mark.parametrize(
    "seed",
    [
        166,  # a pair, points reserved for one of its tables only (MD18342)
        1129,  # a container, and a builder's product whose partner puts out to no axis
        1424,  # a builder's product whose partner is switched off by SD41300
        1473,  # a pair with one table in the control's own file, the other in a new one
    ],
)
def test_a_product_or_a_split_pair_is_written_well(seed: int, tmp_path: Path, run: Run) -> None:
    outcome = try_case(dealt(seed), tmp_path, run)
    assert outcome.written
    assert not outcome.harms, outcome.line()


@pytest.mark.parametrize(
    ("special", "seed"),
    [
        (specials.products_into_the_axis, 1),
        (specials.odd_tables_into_the_axis, 1),
        (specials.own_odd_table, 1),
        (specials.own_product, 1),
        (specials.step_that_does_not_divide, 1),
        (specials.step_that_does_not_divide, 2),
        (specials.step_that_does_not_divide, 3),
        (specials.stale_points_behind_the_end, 1),
        (specials.inch_with_builders_tables, 1),
        (specials.units_of_the_users_own, 1),
        (specials.second_gantry, 1),
        (specials.work_on_the_follower, 1),
        (specials.programs_in_the_container, 1),
        (specials.small_files_over_the_container, 1),
        (specials.damaged_container, 1),
        (specials.copies_that_differ, 1),
        (specials.pair_of_the_828d, 1),
        (specials.limits_told_from_the_other_end, 1),
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


@pytest.fixture
def written(tmp_path: Path, run: Run) -> Outcome:
    """A container's job that went well."""
    case = named(specials.builders_tables_into_the_axis, 2)
    case.packing = Packing()
    outcome = try_case(case, tmp_path, run)
    assert not outcome.harms, outcome.line()
    return outcome


def test_the_judge_sees_what_is_wrong(written: Outcome, tmp_path: Path) -> None:
    """A moved grid, an entry of another axis, an old value that comes back changed by a digit, a
    neighbour that moved.
    """
    case, after = written.case, written.loaded
    assert after is not None
    before, out = control_before(case), tmp_path / "out"

    moved = after.copy()
    moved.load(f"$AA_ENC_COMP_STEP[1,{case.axis}]=7", protected=False)
    assert moved_grid(written, before, moved)
    assert not moved_grid(written, before, after)

    more = written.files["X1_MD.INI"].replace(b"M17", b"$MA_BACKLASH[1,AX2]=0\nM17")
    files = written.files | {"X1_MD.INI": more}
    assert entries_of_others(case, after, files)

    neighbour = after.copy()
    neighbour.load("$AA_ENC_COMP[1,1,AX2]=0.001", protected=False)
    assert foreign_registers(case, before, neighbour)

    (back,) = (out / "rollback").glob("*/BACK_X1_EEC.INI")
    text = back.read_text()
    point = re.search(r"\$AA_ENC_COMP\[1,1,AX1\]=(\S+)", text)
    assert point is not None
    back.write_text(text.replace(point[0], point[0] + "1"))
    assert way_back(written, before, after, out)


def test_what_the_judge_exports_is_what_the_control_holds(written: Outcome) -> None:
    """Loaded into a control that knows nothing yet, it gives the same corrections."""
    case, after = written.case, written.loaded
    assert after is not None
    (whole,) = exported(case, after).values()
    fresh = replace(control_before(case), registers={})
    for head in ("AX_EEC.INI", "NC_CEC.INI", "INITIAL.INI"):
        at = whole.index(f"_N_{head.replace('.', '_')}")
        size = int(whole[at + 124 : at + 136].rstrip("\0"))
        fresh.load(whole[at + 512 : at + 512 + size], protected=False)
    x = np.linspace(*case.travel, 40)
    for direction in (1, -1):
        assert fresh.correction(case.axis, x, direction) == pytest.approx(
            after.correction(case.axis, x, direction), abs=1e-12
        )
