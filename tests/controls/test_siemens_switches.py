"""SINUMERIK: what switches CEC tables on, in files and on the card: nothing foreign wakes, nothing
acts before its sign check.
"""

from __future__ import annotations

import io
import re
from contextlib import redirect_stdout
from pathlib import Path

import pytest
from test_siemens_honoured import NAMES, OPTIONS, TWO, cec, eec, pair_into

from card_files import card_values
from compwright.cli import run as compwright
from compwright.controls.control import decode, open_control
from compwright.formats.card import card_steps
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError
from compwright.foundations.findings import DOUBTS_FIRST
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from compwright.records.facts import AxisFacts
from format_samples import SIEMENS, axis_of, table
from virtual_sinumerik import VirtualSinumerik

pytestmark = pytest.mark.short_estimate

AXIS = axis_of("AX1")


def fresh_pair() -> dict[str, str]:
    return {
        file.name: file.content.decode()
        for file in control_format(SIEMENS, OPTIONS).write([TWO], [AXIS])
    }


@pytest.mark.parametrize("said", ["", "$SN_CEC_TABLE_ENABLE[0]=1\n"])
def test_a_foreign_table_of_which_no_file_says_that_it_is_awake_is_not_woken(said: str) -> None:
    """MD32710 in no file: it may be 0 (the default), and its 1 would wake table 0 whatever SD41300
    says.
    """
    foreign = cec(0, ("AX3", "AX1"), step=85)
    with pytest.raises(CapacityError, match=r"(?s)MD32710.*: 0;.*in no file"):
        pair_into(eec() + foreign + said)
    awake = "$MA_CEC_ENABLE[AX1]=1\n"
    assert awake in pair_into(eec() + foreign + awake)  # it acts already
    for quiet in (
        foreign + "$SN_CEC_TABLE_ENABLE[0]=0\n",
        cec(0, ("AX3", "AX1"), "0", 85),
        cec(0, ("AX3", "AX2"), step=85),
    ):
        assert "$AN_CEC_DIRECTION[21]=-1" in pair_into(NAMES + eec() + quiet)


def test_new_files_do_not_wake_what_sleeps_on_the_axis() -> None:
    """The builder's table of 0.1 mm sleeps by MD32710 = 0, and no file was given: only the card's
    last step switches it on.
    """
    control = VirtualSinumerik(cec_sign=1.0)
    control.load(cec(0, ("AX3", "AX1"), step=85), protected=False)
    control.load("$MA_CEC_ENABLE[AX1]=0\n$SN_CEC_TABLE_ENABLE[0]=1\n", protected=False)
    for text in fresh_pair().values():
        control.load(text, protected=False)
    assert not control.flag("MA_CEC_ENABLE", "AX1")


def test_the_switches_stand_in_the_last_file_alone() -> None:
    written = fresh_pair()
    assert list(written) == ["AX1_CEC.INI", "AX1_MD.INI"]
    assert "ENABLE" not in written["AX1_CEC.INI"]
    assert (
        written["AX1_MD.INI"]
        == "CHANDATA(1)\n$MA_BACKLASH[0,AX1]=0.000000\n$MA_ENC_COMP_ENABLE[0,AX1]=0\n; by hand:"
        " $MA_CEC_ENABLE[AX1]=1\n$SN_CEC_TABLE_ENABLE[20]=1\n$SN_CEC_TABLE_ENABLE[21]=1\nM17\n"
    )


def test_a_set_of_ours_says_that_it_acts_to_both_readers() -> None:
    """What the card has somebody set by hand counts as said: the next round need not ask whether
    the pair acted.
    """
    given = [ControlFile(name, text.encode()) for name, text in fresh_pair().items()]
    back = decode(
        open_control(Session(), "siemens-840d-sl", OPTIONS), given, [AXIS], asking=True
    ).state
    assert back.axes["AX1"].negative.tolist() == TWO.negative.tolist()
    assert not [note for note in back.assumed if "CEC_ENABLE" in note.fact]


def test_the_card_checks_the_sign_first_and_switches_on_last() -> None:
    state = control_format(SIEMENS, OPTIONS).read(
        control_format(SIEMENS, OPTIONS).write([TWO], [AXIS]), [AXIS]
    )
    steps = card_steps(
        SIEMENS,
        AXIS,
        card_values(control_format(SIEMENS, OPTIONS), AXIS, TWO, state.facts["AX1"], TWO.positions),
    )
    titles = [step.title for step in steps]
    text = {step.title: step.text for step in steps}
    assert (
        titles.index("Check the sign")
        < titles.index("Load the table")
        < titles.index("Set the backlash and switch the table on")
    )
    loads = {
        title: re.findall(r"AX1_\w+\.INI", said) for title, said in text.items() if "INI" in said
    }
    assert loads == {
        "Load the table": ["AX1_CEC.INI"],
        "Set the backlash and switch the table on": ["AX1_MD.INI"],
    }
    for title in ("Switch the old table off", "Set the backlash and switch the table on"):
        assert "what else is inactive on axis AX1" in text[title]
    assert "load nothing" in text["Check the sign"]
    single = card_steps(
        SIEMENS,
        AXIS,
        card_values(
            control_format(SIEMENS, OPTIONS),
            AXIS,
            table("AX1", [0.0, 1.0], [0.0, 0.1]),
            AxisFacts(),
            table("AX1", [0.0, 1.0], [0.0, 0.1]).positions,
        ),
    )
    assert "AX1_MD.INI" in single[-3].text
    assert "MD32700 $MA_ENC_COMP_ENABLE[0,AX1] = 1" in single[-3].text


CROSS_JOB = """compwright: 1
controller: {format: siemens-840d-sl, options: {cec: available, cec_tables: [3], cec_sign: error}}
states: {as_found: [CEC.INI]}
axes: {X: {travel: [0, 1760], address: AX1, before: []}, Z: {travel: [0, 1000], address: AX3, before: []}}
cross: [{input: Z, output: X, positions: [0, 500, 1000], deviations: [0, 4, 9], unit: um}]
"""


def test_the_card_of_a_table_between_axes_names_our_table_alone_and_checks_its_sign_first(
    tmp_path: Path,
) -> None:
    """Table 0 of the same two axes is the builder's: overwriting or switching it off would take his
    correction away.
    """
    foreign = (
        cec(0, ("AX3", "AX1"), step=85)
        + "$MA_CEC_ENABLE[AX1]=1\n$MA_BACKLASH[0,AX1]=0\n$MA_BACKLASH[0,AX3]=0\nM17\n"
    )
    (tmp_path / "CEC.INI").write_text(foreign, encoding="ascii")
    (tmp_path / "job.yaml").write_text(CROSS_JOB, encoding="utf-8")
    with redirect_stdout(io.StringIO()):
        assert compwright(["run", str(tmp_path / "job.yaml"), "--out", str(tmp_path / "out")]) == 0
    card = (tmp_path / "out" / "card" / "card.md").read_text(encoding="utf-8")
    assert (
        str(DOUBTS_FIRST) not in card
    )  # neither axis gets a table of its own: what acts there stays
    steps = re.findall(r"\*\*X over Z: (.+?)\*\*\n(.+)", card)
    assert [title for title, _ in steps] == [
        "reserve and switch off",
        "check the sign",
        "load",
        "switch on",
    ]
    text = dict(steps)
    for title in ("reserve and switch off", "check the sign", "switch on"):
        assert "table 3" in text[title]
    assert not [title for title, said in steps if re.search(r"tables? (\d+ and )?0\b", said)]
    assert "0.1 mm" in text["check the sign"]
    assert "load nothing" in text["check the sign"]
    assert "AX1_CROSS.INI" in text["load"]
    assert not re.search(r"\. [a-z]", " ".join(text.values()))


def test_a_table_between_axes_is_loaded_only_after_its_sign_check(tmp_path: Path) -> None:
    """Not among the files of the axis that has a pair of its own, whose step comes first."""
    rows = [
        f"{x},{way},{run},{0.03 * x + 1.5 * (way == '-') * (1 + x / 600) + 0.3 * (run - 2)}"
        for run in (1, 2, 3, 4, 5)
        for way in "+-"
        for x in range(-590, 0, 58)
    ]
    head = "# axis: X\ntarget_mm,direction,run,deviation_um\n"
    (tmp_path / "x.csv").write_text(head + "\n".join(rows) + "\n", encoding="utf-8")
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl, options: {cec: available,"
        " cec_tables: [3, 4, 5], cec_sign: correction}}\nstates: {as_found: none}\naxes:\n"
        "  X: {travel: [-600, 0], address: AX1, before: [x.csv], table: {mode: bidirectional}}\n"
        "  Y: {travel: [-400, 0], address: AX2, before: []}\ncross:\n"
        "  - {input: X, output: Y, positions: [-500, -250, 0], deviations: [-15, -7.5, 0],"
        " unit: um}\n",
        encoding="utf-8",
    )
    with redirect_stdout(io.StringIO()):
        compwright(["run", str(tmp_path / "job.yaml"), "--out", str(tmp_path / "out")])
    card = (tmp_path / "out" / "card" / "card.md").read_text(encoding="utf-8")
    steps = [title for title, text in re.findall(r"\*\*(.+?)\*\*\n(.+)", card) if "_CROSS" in text]
    assert steps == ["Y over X: check the sign", "Y over X: load"]


def test_that_no_file_holds_a_table_is_said_of_its_axis_alone() -> None:
    """Of the axis, not of its measuring system: a doubt about one axis leaves others decided."""
    given = [ControlFile("MD.INI", b"$MA_BACKLASH[0,AX1]=0\n$MA_BACKLASH[0,AX3]=0\nM17\n")]
    axes = [AXIS, axis_of("AX3")]
    found = decode(
        open_control(Session(), "siemens-840d-sl", OPTIONS), given, axes, asking=True
    ).state.findings
    assert [one.axes for one in found if one.code == "CW-S008"] == [("AX1",), ("AX3",)]
