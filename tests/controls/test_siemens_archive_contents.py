"""SINUMERIK: a commissioning archive whose contents were edited at equal length. No checksum speaks
of them: members that repeat a value are compared, for all others the user is told to compare.
"""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from compwright.cli import run as compwright
from compwright.controllers.sinumerik.loading import active_files
from compwright.controls.control import decode, open_control
from compwright.formats.families.pairs.state import contradictions
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from compwright.words.sentences import say
from sinumerik_archive import ARCHIVE, needs_archive
from sinumerik_container import ACTIVE, container

pytestmark = pytest.mark.short_estimate

EEC = (
    "METRIC\nCHANDATA(1)\n$AA_ENC_COMP[1,0,AX1]=0\n$AA_ENC_COMP[1,1,AX1]=0.0123\n"
    "$AA_ENC_COMP[1,2,AX1]=-0.0045\n$AA_ENC_COMP[1,3,AX1]=0.0001\n$AA_ENC_COMP_STEP[1,AX1]=100\n"
    "$AA_ENC_COMP_MIN[1,AX1]=0\n$AA_ENC_COMP_MAX[1,AX1]=300\n$AA_ENC_COMP_IS_MODULO[1,AX1]=0\nM17\n"
)
MD = (
    "CHANDATA(1)\nN10000 $MN_AXCONF_MACHAX_NAME_TAB[0]=\"X1\"\nN11200 $MN_INIT_MD='H0'\n"
    "N19100 $MN_OTHER[3]=7\nN30200 $MA_NUM_ENCS[AX1]=2\nN32450 $MA_BACKLASH[1,AX1]=0.0021\n"
    "N32700 $MA_ENC_COMP_ENABLE[1,AX1]=1\nN36100 $MA_POS_LIMIT_MINUS[AX1]=0\n"
    "N36110 $MA_POS_LIMIT_PLUS[AX1]=300\nN38000 $MA_MM_ENC_COMP_MAX_POINTS[1,AX1]=25\nM17\n"
)
CFG = (
    "CHANDATA(1)\nN11200 $MN_INIT_MD='H2f'\nN19100 $MN_OTHER[3]=7\n"
    "N38000 $MA_MM_ENC_COMP_MAX_POINTS[1,AX1]=25\nM17\n"
)


def archive(eec: str = EEC, cfg: str = CFG, md: str = MD) -> ControlFile:
    members = {"CFG_GLOBAL.INI": cfg, "AX_EEC.INI": eec, "INITIAL.INI": md}
    packed = container([(ACTIVE, name, text.encode()) for name, text in members.items()])
    return ControlFile("backup.arc", packed)


@pytest.mark.parametrize(
    ("name", "old", "new", "lines"),
    [
        ("points", "POINTS[1,AX1]=25", "POINTS[1,AX1]=24", ("line 4", "line 10")),
        ("what nobody reads", "OTHER[3]=7", "OTHER[3]=8", ("line 3", "line 4")),
    ],
)
def test_members_that_contradict_each_other_are_refused_with_both_lines(
    name: str, old: str, new: str, lines: tuple[str, str]
) -> None:
    del name
    (ours,) = contradictions(archive(cfg=CFG.replace(old, new)))
    (judged,) = active_files(archive(cfg=CFG.replace(old, new))).faults
    for fault in (ours, judged):
        assert (fault.file, fault.place) == ("backup.arc: INITIAL.INI", lines[1])
        assert f"backup.arc: CFG_GLOBAL.INI, {lines[0]}" in fault.message
    with pytest.raises(InputError):
        decode(open_control(Session(), "siemens-840d-sl", {}), [archive(cfg=CFG.replace(old, new))])


@pytest.mark.parametrize(
    "cfg",
    [CFG, CFG.replace("=25", "=25.0"), CFG.replace("=25", " = 25 ; points"), CFG.replace("=25", "=25 '0a1b")],
)  # fmt: skip
def test_the_same_value_in_two_members_is_no_contradiction(cfg: str) -> None:
    assert contradictions(archive(cfg=cfg)) == ()
    assert active_files(archive(cfg=cfg)).faults == []


@needs_archive
def test_the_members_of_a_real_archive_agree() -> None:
    """And an edit of one digit at equal length, in a value that stands in two of them, is found."""
    content = ARCHIVE.read_bytes()
    assert contradictions(ControlFile("a.arc", content)) == ()
    assert active_files(ControlFile("a.arc", content)).faults == []
    line = b"N38000 $MA_MM_ENC_COMP_MAX_POINTS[1,AX1]=25"
    at = content.rindex(line) + len(line) - 1
    edited = ControlFile("a.arc", content[:at] + b"6" + content[at + 1 :])
    assert "MAX_POINTS[1,AX1]" in str(contradictions(edited)[0])
    assert "MAX_POINTS[1,AX1]" in str(active_files(edited).faults[0])


@pytest.mark.real_pages
def test_that_the_contents_are_not_verified_is_said_and_compared(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """`new`, `decode` and `run` say it; the card compares the largest and the smallest value of the
    table and the backlash; the decisions stay what they are.
    """
    given = tmp_path / "backup.arc"
    given.write_bytes(archive().content)
    noise = random.Random(1)  # noqa: S311 - of a measurement
    rows = [
        f"{x},{way},{run},{x * (300 - x) / 1500 + noise.gauss(0, 0.4):.4f}"
        for x in (10, 61, 118, 177, 233, 290)
        for way in "+-"
        for run in range(1, 6)
    ]
    (tmp_path / "x.csv").write_text("target_mm,direction,run,deviation_um\n" + "\n".join(rows))
    of = ["--format", "siemens-840d-sl"]
    assert compwright(["new", "--from", str(given), *of, "--out", str(tmp_path / "j.yaml")]) == 0
    assert str(say("CW-S072", file="backup.arc")) in capsys.readouterr().err
    assert compwright(["decode", str(given), *of]) == 0
    assert "CW-S072" in capsys.readouterr().out
    out = tmp_path / "out"
    words = ["--axis", "X", "--travel", "0:300", "--option", "address=X1", "--out", str(out)]
    assert compwright(["run", str(tmp_path / "x.csv"), *of, *words, "--state", str(given)]) == 0
    assert "CW-S072" in capsys.readouterr().out
    assert "changed after the export" in (out / "report.html").read_text()
    card = (out / "card" / "card.md").read_text().replace("\\", "")
    step = re.search(r"\*\*Compare the archive\*\*(.*?)- \[ \]", card, re.DOTALL)
    assert step is not None
    for shown in (
        "$AA_ENC_COMP[1,1,X1] = 0.0123 mm",
        "$AA_ENC_COMP[1,2,X1] = -0.0045 mm",
        "$MA_BACKLASH[1,X1] = 0.0021 mm",
    ):
        assert shown in step[1]
    assert card.index("Compare the archive") < card.index("**Load the table**")


def test_text_files_have_no_such_step(tmp_path: Path) -> None:
    files = [ControlFile("AX_EEC.INI", EEC.encode()), ControlFile("MD.INI", MD.encode())]
    state = decode(open_control(Session(), "siemens-840d-sl", {}), files).state
    assert "CW-S072" not in {finding.code for finding in state.findings}
    assert all("archive" not in facts.stated for facts in state.facts.values())
