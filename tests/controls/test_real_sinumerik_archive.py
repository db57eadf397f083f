"""Jobs on variations of a real SINUMERIK archive, before a virtual control that shares nothing with
the package: none does harm.

``benchmarks/bench_backups_sinumerik.py`` runs several hundred of the same jobs, these among them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import backup_variations_sinumerik as variations
from backup_cases_sinumerik import MUST_REFUSE, PLAIN, Case
from backup_variations_sinumerik import Special, case_of, named
from compwright.cli import run as compwright
from sinumerik_archive import (
    ARCHIVE,
    cec_lines,
    cec_text,
    eec_text,
    machine_data,
    needs_archive,
    put,
    replace_cec,
)
from sinumerik_container import container
from sinumerik_judge import Outcome, control_before, foreign_bytes, fresh, load_by_card, try_case

pytestmark = [needs_archive, pytest.mark.short_estimate]

#: Of the first 150 random jobs the first of each kind that no case below plays by its name, and one
#: more for each form of text that these do not have.
SEEDS = (2, 9, 11, 13, 15, 16, 22, 32, 33, 37, 57, 71, 95, 145)
SHARES = 2
INCH_SEEDS = (0, 1, 2)  # both say it, the line alone, MD10240 alone


@pytest.fixture
def judged(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Callable[[Case], Outcome]:
    """Run one case in a folder of its own."""

    def run(arguments: list[str]) -> tuple[int, str]:
        capsys.readouterr()
        code = compwright(arguments)
        out, err = capsys.readouterr()
        return code, err + out

    def judge(case: Case) -> Outcome:
        folder = tmp_path / f"{case.seed}-{'-'.join(case.told)[:60].replace(' ', '_')}"
        folder.mkdir()
        return try_case(case, folder, run)

    return judge


Judge = Callable[[Case], Outcome]


def good(outcome: Outcome, *, written: bool | None = None) -> Outcome:
    assert not outcome.harms, outcome.line()
    assert written is None or outcome.written is written, outcome.line()
    return outcome


# -- random jobs
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("share", range(SHARES))
def test_no_job_does_harm(share: int, judged: Judge) -> None:
    """Every job is right or refused by name, what nothing else acts on is written, and so are
    most that need not be refused.
    """
    outcomes = [judged(case_of(seed)) for seed in SEEDS[share::SHARES]]
    harms = [outcome.line() for outcome in outcomes if outcome.harms]
    assert not harms, "\n".join(harms)
    may = [outcome.written for outcome in outcomes if outcome.case.mark != MUST_REFUSE]
    assert sum(may) >= 0.5 * len(may)


# -- the archive in its container
# --------------------------------------------------------------------------------------------------


class Packed(Case):
    """A case whose job is given the archive in its container: the whole real one, or the texts of
    the case in one."""

    whole = False

    @classmethod
    def of(cls, case: Case, *, whole: bool = False) -> Packed:
        packed = cls(**vars(case))
        packed.whole = whole
        packed.truth = [machine_data(), eec_text(), cec_text()] if whole else case.holds()
        return packed

    def given(self) -> dict[str, str]:
        if self.whole:
            return {"backup.arc": ARCHIVE.read_bytes().decode("latin-1")}
        members = {"AX_EEC.INI": self.eec, "NC_CEC.INI": self.cec, "INITIAL.INI": self.md}
        texts = [
            ("\\_NC_ACT.DIR\\", name, text.encode("latin-1"))
            for name, text in members.items()
            if text is not None
        ]
        return {"backup.arc": container(texts).decode("latin-1")}


@pytest.mark.parametrize("axis", ["AX1", "AX4"])
def test_a_linear_and_a_rotary_axis_of_the_whole_archive(
    axis: str, judged: Judge, tmp_path: Path
) -> None:
    """A job on the archive alone: small files, loaded by the card; those of the way back bring the
    old corrections back.
    """
    case = Packed.of(named(variations.nothing, axis=axis), whole=True)
    outcome = good(judged(case), written=True)
    name = {"AX1": "X1", "AX4": "C1"}[axis]
    small = [f"{name}_EEC.INI", f"{name}_MD.INI"]
    assert sorted(outcome.files) == small
    forward, _, way_back = outcome.card.replace("\\", "").partition("## Way back")
    assert [forward.index(file) for file in small] == sorted(forward.index(file) for file in small)
    assert f"load BACK_{small[0]}, then BACK_{small[1]}" in way_back

    before, control = control_before(case), control_before(case)
    load_by_card(control, outcome)
    (folder,) = tmp_path.glob("*/out/rollback/*")
    control.load(f"$MA_ENC_COMP_ENABLE[{case.system},{axis}]=0")
    for file in small:
        control.load((folder / f"BACK_{file}").read_text(encoding="ascii"))
    x = np.linspace(*case.travel, 50)
    for direction in (1, -1):
        assert np.array_equal(
            control.correction(axis, x, direction), before.correction(axis, x, direction)
        )


@pytest.mark.parametrize(
    "special",
    [
        variations.half_by_name,
        variations.stale_table_in_the_idle_system,
        variations.pair_is_wanted,
        variations.others_act_between_others,
        variations.gantry_named,
    ],
)
def test_what_stands_in_a_container_counts_as_in_text(special: Special, judged: Judge) -> None:
    case = named(special)
    good(judged(Packed.of(case)), written=True)


@pytest.mark.parametrize("packed", [False, True], ids=["text", "container"])
@pytest.mark.parametrize("seed", [0, 1])
def test_one_table_in_the_place_of_tables_of_the_axis_over_itself(
    packed: bool, seed: int, judged: Judge
) -> None:
    """The card has them switched off before they are emptied, and the sum on again behind that:
    while MD32710 is on the control takes no value of them.
    """
    case = named(variations.table_over_itself, seed)
    case.options |= {"cec": "available", "cec_tables": "[9, 10]"}
    case.table["mode"] = "single"
    case.written_tables = {"9", "10"}
    outcome = good(judged(Packed.of(case) if packed else case), written=True)
    assert outcome.after < 1.2 * outcome.predicted


class Listed(Case):
    """A case whose job is given the tables as a listing with decimal commas."""

    def given(self) -> dict[str, str]:
        commas = re.sub(r"(=[ \t]*[-+]?[0-9]+)\.([0-9]+)", r"\1,\2", self.eec)
        return {**super().given(), "AX_EEC.INI": commas}


def test_a_listing_with_decimal_commas(judged: Judge) -> None:
    case = named(variations.nothing, axis="AX2")
    listed = Listed(**vars(case))
    listed.truth = case.holds()
    outcome = good(judged(listed), written=True)
    assert sorted(outcome.files) == ["Y1_EEC.INI", "Y1_MD.INI"]


@pytest.mark.parametrize("seed", [2, 5, 12])
def test_small_files_instead_of_patched_ones(seed: int, judged: Judge) -> None:
    case = case_of(seed)
    case.options["files"] = "small"
    outcome = good(judged(case), written=True)
    assert not set(outcome.files) & set(case.given())


# -- inches, names, foreign tables
# ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", INCH_SEEDS)
def test_an_inch_control_is_honoured_or_refused(seed: int, judged: Judge) -> None:
    """MD10240 = 0, the line INCH, or both."""
    good(judged(named(variations.inch_control, seed, "AX3")))


def test_units_that_disagree_are_refused(judged: Judge) -> None:
    good(judged(named(variations.units_that_disagree, 1)), written=False)


@pytest.mark.parametrize(
    ("special", "seed"),
    [(variations.known_by_two_names, n) for n in range(4)] + [(variations.half_by_name, 0)],
)
def test_x1_and_ax1_are_one_axis(special: Special, seed: int, judged: Judge) -> None:
    good(judged(named(special, seed)), written=True)


@pytest.mark.parametrize("seed", range(3))
def test_names_without_their_table_are_honoured_or_refused(seed: int, judged: Judge) -> None:
    good(judged(named(variations.names_without_their_table, seed, "AX3")))


def test_two_names_and_a_sleeping_table_of_the_axis(judged: Judge) -> None:
    """The table of 100 µm that says X1 must not be woken by work on AX1."""
    case = named(variations.sleeping_table_over_itself)
    assert case.cec is not None
    case.cec = case.cec.replace("(AX1)", "(X1)")
    good(judged(case), written=True)


@pytest.mark.parametrize("axis", ["AX1", "AX2", "AX3", "AX4", "AX5"])
def test_foreign_tables_of_the_archive_are_kept(axis: str, judged: Judge) -> None:
    """Their range is no multiple of the step, one has STEP 0 and the output (X); none is
    touched.
    """
    outcome = good(judged(named(variations.nothing, axis=axis)), written=True)
    assert outcome.case.cec is not None
    assert outcome.files.get("NC_CEC.INI", outcome.case.cec.encode()) == outcome.case.cec.encode()


def test_the_makers_own_program(judged: Judge) -> None:
    good(judged(named(variations.the_makers_program)), written=True)


def test_foreign_tables_with_products_and_weights_are_kept(judged: Judge) -> None:
    good(judged(named(variations.others_act_between_others)), written=True)


@pytest.mark.parametrize("special", [variations.pair_of_others, variations.pair_beside_a_sleeper])
def test_work_that_touches_foreign_tables_is_refused(special: Special, judged: Judge) -> None:
    good(judged(named(special)), written=False)


# -- measuring systems, compensation on or off
# ------------------------------------------------------------------------------------


def test_two_measuring_systems_only_the_second_is_on(judged: Judge) -> None:
    """No word in the job; the idle system holds a stale table."""
    case = named(variations.stale_table_in_the_idle_system)
    case.job_system = None
    outcome = good(judged(case), written=True)
    text = b"".join(outcome.files.values()).decode("latin-1")
    assert re.search(r"\$AA_ENC_COMP\[1,1,AX1\]", text)


@pytest.mark.parametrize(
    "special",
    [
        variations.neither_is_on,
        variations.both_are_on,
        variations.no_such_system,
        variations.job_names_the_idle_system,
    ],
)
@pytest.mark.parametrize("seed", range(2))
def test_a_measuring_system_is_never_guessed(special: Special, seed: int, judged: Judge) -> None:
    good(judged(named(special, seed)))


@pytest.mark.parametrize("seed", range(3))
def test_a_loader_that_ends_with_compensation_off_asks(seed: int, judged: Judge) -> None:
    assert good(judged(named(variations.loader_without_an_answer, seed)), written=False).code == 2


@pytest.mark.parametrize("seed", range(2))
def test_a_loader_against_the_machine_data_is_not_guessed(seed: int, judged: Judge) -> None:
    good(judged(named(variations.loader_beside_the_machine_data, seed)), written=False)


@pytest.mark.parametrize("answer", ["yes", "no", "true", "false"])
@pytest.mark.parametrize("loader", [True, False], ids=["loader", "table alone"])
def test_the_answer_whether_compensation_acted(answer: str, loader: bool, judged: Judge) -> None:
    seed = next(
        n
        for n in range(100)
        if ("G_LAS.MPF" in named(variations.stated_active, n).given()) is loader
    )
    case = named(variations.stated_active, seed)
    case.active, case.enabled = answer, answer in {"yes", "true"}
    good(judged(case), written=True)


def test_nothing_is_asked_where_the_table_is_zero(judged: Judge) -> None:
    good(judged(named(variations.zero_and_silent)), written=True)


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("answer", [None, "yes"])
def test_a_sleeping_table_is_left_asleep_beside_one_that_acts(
    seed: int, answer: str | None, judged: Judge
) -> None:
    """The EEC acted, and the job may say so; the CEC table of 100 µm slept."""
    case = named(variations.sleeping_table_over_itself, seed)
    case.active, case.options["cec_sign"] = answer, "correction"
    good(judged(case), written=True)


# -- the sign of CEC
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "special", [variations.pair_without_a_sign, variations.table_over_itself_without_a_sign]
)
def test_the_sign_of_cec_has_no_default(special: Special, judged: Judge) -> None:
    """Where a table is to be written, or is ours and goes out of its readings."""
    case = named(special)
    case.options.setdefault("cec_tables", "[9]")
    outcome = judged(case)
    assert (outcome.code, outcome.written) == (2, False), outcome.line()
    good(outcome)


def test_a_table_of_unknown_sign_that_nobody_gave_to_be_written_stays(judged: Judge) -> None:
    good(judged(named(variations.table_over_itself_without_a_sign)), written=True)


@pytest.mark.parametrize("sign", [1.0, -1.0], ids=["correction", "error"])
def test_a_pair_is_right_in_both_worlds(sign: float, judged: Judge) -> None:
    """And its card reserves and switches what the plan needs, in the order that the control takes,
    and names only files written.
    """
    case = named(variations.pair_is_wanted)
    case.cec_sign, case.options["cec_sign"] = sign, "correction" if sign > 0 else "error"
    outcome = good(judged(case), written=True)
    card = outcome.card.replace("\\", "")
    assert "MD18342" in card
    off, load = (re.search(pattern, card) for pattern in (r"SD41300[^.\n]*= 0", r"\*\*Load"))
    assert off, "SD41300 is not switched off"
    assert load
    assert off.start() < load.start()
    sign_check, on = (
        re.search(pattern, card) for pattern in (r"\*\*Check the sign", r"SD41300[^.\n]*= 1")
    )
    assert sign_check
    assert on
    assert sign_check.start() < on.start(), "the sign is checked after the table is active"
    forward, _, _ = card.partition("## Way back")  # the way back names the copies in rollback/
    for name in re.findall(r"\b[\w-]+\.(?:INI|MPF|SPF)\b", forward):
        assert name in outcome.files, f"the card names {name}, which was not written"


@pytest.mark.parametrize("sign", [1.0, -1.0], ids=["correction", "error"])
@pytest.mark.parametrize("seed", range(3))
def test_a_table_of_the_axis_over_itself_in_both_worlds(
    sign: float, seed: int, judged: Judge
) -> None:
    case = named(variations.table_over_itself, seed)
    case.cec_sign, case.options["cec_sign"] = sign, "correction" if sign > 0 else "error"
    good(judged(case))


def test_tables_of_others_need_no_sign(judged: Judge) -> None:
    """Tables between other axes, over another axis itself too, and none is said to have a sign."""
    case = named(variations.others_act_between_others)
    assert "cec_sign" not in case.options
    good(judged(case), written=True)


@pytest.mark.parametrize("sign", [1.0, -1.0], ids=["correction", "error"])
def test_a_wrong_word_about_tables_of_others_does_no_harm(sign: float, judged: Judge) -> None:
    case = named(variations.others_act_between_others)
    case.cec_sign, case.options["cec_sign"] = sign, "error" if sign > 0 else "correction"
    good(judged(case), written=True)


def test_a_pair_without_room(judged: Judge) -> None:
    good(judged(named(variations.pair_without_room)))


# -- rotary axes, gantries
# --------------------------------------------------------------------------------------------------


def test_a_turned_reference_stays_inside_the_turn(judged: Judge) -> None:
    """Reference at 90 on a table of 0 to 360: never 90 to 450."""
    outcome = good(judged(named(variations.turned_reference, axis="AX4")))
    for content in outcome.files.values():
        for found in re.finditer(rb"\$AA_ENC_COMP_MAX\[\d,(?:AX4|C1)\]\s*=\s*([-\d.]+)", content):
            assert float(found[1]) <= 360


@pytest.mark.parametrize("special", [variations.gantry_named, variations.gantry_unnamed])
def test_a_gantry_of_the_machine_data_is_never_racked(special: Special, judged: Judge) -> None:
    good(judged(named(special)))


# -- the judge itself
# --------------------------------------------------------------------------------------------------


def after_of(outcome: Outcome, **turned: float) -> float:
    """A after loading into a control on which one thing is turned."""
    control = control_before(outcome.case)
    for name, value in turned.items():
        setattr(control, name, value)
    load_by_card(control, outcome)
    return fresh(control, outcome, 17)


def test_the_judge_notices_what_is_turned(judged: Judge) -> None:
    """Signs, the measuring system, inches, a byte of another axis, a step of the card that is left
    out.
    """
    case = named(variations.nothing)
    case.md = put(case.md, "$MA_BACKLASH[1,AX1]", "0.004")
    outcome = good(judged(case), written=True)
    limit = 1.4 * outcome.predicted + 1
    assert after_of(outcome) < limit
    for turned in (
        {"eec_turned": -1.0},
        {"eec_turned": 2.0},
        {"backlash_turned": -1.0},
        {"system_turned": 1},
    ):
        assert after_of(outcome, **turned) > limit, turned

    control = control_before(case)
    control.refused.clear()
    outcome.card = re.sub(r"(ENC_COMP_ENABLE\\\[1,AX1\\\] = )0", r"\g<1>1", outcome.card)
    load_by_card(control, outcome)
    assert any(refused.mattered for refused in control.refused)

    given = {name: text.encode("latin-1") for name, text in case.given().items()}
    for damage in (
        (b"$AA_ENC_COMP[1,3,AX2]=0", b"$AA_ENC_COMP[1,3,AX2]=0.001"),
        (b"\nM17", b"\r\nM17"),
        (b"METRIC\n", b""),
    ):
        changed = {name: content.replace(*damage) for name, content in given.items()}
        assert any(
            "differs" in harm for harm in foreign_bytes(case, changed, given, Path("nowhere"))
        ), damage


def test_the_judge_notices_the_sign_of_cec(judged: Judge) -> None:
    case = named(variations.pair_is_wanted)
    outcome = judged(case)
    assert outcome.written
    assert (
        after_of(outcome) < 1.4 * outcome.predicted + 1 < after_of(outcome, cec_sign=-case.cec_sign)
    )


def test_the_judge_notices_inches() -> None:
    case = named(variations.inch_control)
    x = np.linspace(0, 900, 7)
    true, turned = control_before(case), control_before(case)
    turned.inch_turned = 1 / 25.4
    assert np.ptp(true.correction("AX1", x, 1) - turned.correction("AX1", x, 1)) > 0.002


def test_the_marks_hold_enough_of_each() -> None:
    cases = [case_of(seed) for seed in SEEDS]
    marks = [case.mark for case in cases]
    assert marks.count(PLAIN) >= 0.3 * len(marks)
    assert marks.count(MUST_REFUSE) >= 3
    specials = {special.__name__ for special, _ in variations.SPECIALS}
    dealt = {word for case in cases for word in case.told} & specials
    named_below = set(re.findall(r"variations\.(\w+)", Path(__file__).read_text(encoding="utf-8")))
    assert specials <= dealt | named_below


def test_a_sleeping_table_that_is_woken_is_noticed() -> None:
    """What MD32710 = 1 would wake shifts the axis by 0.1 mm here."""
    case = named(variations.nothing)
    assert case.cec is not None
    case.cec = replace_cec(case.cec, 9, cec_lines(9, "AX1", "AX1", 0, 450, [0, 0.1, 0]))
    case.md = put(put(case.md, "$SN_CEC_TABLE_ENABLE[9]", "1"), "$MA_CEC_ENABLE[AX1]", "0")
    asleep, woken = control_before(case), control_before(case)
    woken.load("$MA_CEC_ENABLE[AX1]=1")
    x = np.array([450.0])
    assert woken.correction("AX1", x, 1)[0] - asleep.correction("AX1", x, 1)[0] == pytest.approx(
        0.1, abs=1e-9
    )
