"""Which parameters beside the table a FANUC series has: 1004 says the increment system on the older
series only (a real backup of a D4G3 holds it beside 1013), and of the 15i no page was found.
"""

from __future__ import annotations

import re
from copy import deepcopy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from test_fanuc_series import LINEAR, TOTALS, one_file, run_15i

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import definition_in
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import AxisKind
from compwright.records.correction import ControlState
from format_samples import CONTENT, DEFINITIONS
from mutants import merged_definition

pytestmark = pytest.mark.short_estimate

#: What the other series read as detection unit 0.00005 mm, path, totals, further compensation, and
#: a smooth backlash that reaches 5 mm.
STRANGE = {
    1013: "A1P00000010",
    1820: "A1P4",
    1004: "P00000010",
    981: "A1P2",
    1420: "A1P24000",
    1800: "A1P00010000",
    1847: "A1P5000",
    3602: "P00000001",
    3605: "A1P00000010",
    5711: "P1",
    5721: "P2",
    5861: "A1P31",
    5871: "A1P40",
}

EVIDENCE = {"state": "inferred", "source": "F1"}


def read(format_id: str, more: str, **options: object) -> ControlState:
    files = [one_file(format_id, more=more)]
    return control_format(DEFINITIONS[format_id], options).read(files, [LINEAR])


@pytest.mark.parametrize("format_id", ["fanuc-30i", "fanuc-0i-d", "fanuc-0i-f"])
def test_1004_says_no_increment_system_where_1013_does(format_id: str) -> None:
    """Without its line of 1013 an IS-C axis would be taken for IS-B: a unit ten times too large."""
    more = "N01004Q1P00000000 N01820Q1A1P2"
    with pytest.raises(UsageError, match="detection unit"):
        read(format_id, more)
    state = read(format_id, more, detection_unit=0.0001)
    assert state.axes["1"].backlash == pytest.approx(0.0002)
    assert state.facts["1"].stated == {}


def test_1004_says_the_increment_system_on_the_older_series() -> None:
    more = "N01004P00000010 N01820A1P2"
    with pytest.raises(
        InputError,
        match=r"differs from the option.*delete the option `detection_unit`, or set it to",
    ):
        read("fanuc-0i-16i", more, detection_unit=0.001)
    pointed = one_file("fanuc-0i-16i", more=more)
    pointed = type(pointed)(pointed.name, pointed.content.replace(b"P10000\n", b"P10.0\n", 1))
    state = control_format(DEFINITIONS["fanuc-0i-16i"], {}).read([pointed], [LINEAR])
    assert state.facts["1"].stated == {"detection_unit": 0.0001}


def definition_with(name: str, said: dict[str, object]) -> Definition:
    """The 30i with one parameter said otherwise."""
    text = merged_definition("fanuc-30i")
    data = deepcopy(text.data)
    data["parameters"][name] = said
    return definition_in(replace(text, data=data))


def strange() -> str:
    return " ".join(f"N{number:05d}{text}" for number, text in STRANGE.items())


def test_15i_numbers_of_other_series_count_for_nothing_and_are_named_once() -> None:
    state = read("fanuc-15i", strange(), detection_unit=0.001)
    bare = read("fanuc-15i", "", detection_unit=0.001)
    table = state.axes["1"]
    assert np.round(table.positive * 1000, 9).tolist() == list(TOTALS)
    assert (table.backlash, table.others) == (0.002, ())
    own, other = (replace(increments_of(facts.facts["1"]), hung=()) for facts in (state, bare))
    assert replace(state.facts["1"], of_family=own) == replace(bare.facts["1"], of_family=other)
    # what may compensate by the grid holds the grid
    held = {re.search("[0-9]{4}", each.label)[0] for each in increments_of(state.facts["1"]).hung}  # type: ignore[index]
    assert held == {"3602", "3605", "5711", "5721", "5861", "5871"}
    new = [each for each in state.findings if each not in bare.findings]
    assert [(each.code, each.severity) for each in new] == [("CW-S057", "warning")]
    assert all(f"{number}" in new[0].message for number in STRANGE)
    asleep = " ".join(f"N{number:05d}A1P00000000" for number in STRANGE)
    assert read("fanuc-15i", asleep, detection_unit=0.001).findings == bare.findings


def test_15i_both_readers_take_the_unit_of_the_user() -> None:
    files = [one_file("fanuc-15i", more=strange())]
    options = {"detection_unit": 0.001}
    mine = control_format(DEFINITIONS["fanuc-15i"], options).read(files, [LINEAR])
    judge = virtual_control("fanuc-15i", files, options=options, kinds={"1": AxisKind.LINEAR})
    assert mine.axes["1"].positive.tolist() == pytest.approx(
        judge.correction("1", mine.axes["1"].positions, LINEAR.reference_return).tolist()
    )
    with pytest.raises(UsageError, match="detection unit"):
        read("fanuc-15i", strange())


def test_15i_a_job_among_numbers_of_other_series(tmp_path: Path) -> None:
    (tmp_path / "ALL.TXT").write_bytes(one_file("fanuc-15i", more=strange()).content)
    assert run_15i(tmp_path, ["ALL.TXT"]) in (0, 1)
    written = (tmp_path / "out" / "tables" / "fanuc-15i" / "ALL.TXT").read_text()
    assert all(f"N{number:05d}{text}\n" in written for number, text in STRANGE.items())


def test_15i_the_grid_stays_where_something_nobody_knows_may_hang_on_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """5873 may be inclination there as elsewhere: by a moved grid it would bend the axis."""
    (tmp_path / "ALL.TXT").write_bytes(one_file("fanuc-15i", more="N05873A1P400").content)
    assert run_15i(tmp_path, ["ALL.TXT"]) in (0, 1)
    job = tmp_path / "job.yaml"
    job.write_text(job.read_text().replace("before:", "table: {spacing: 5}, before:"))
    moved = ["run", str(job), "--out", str(tmp_path / "moved")]
    assert compwright(moved) == 4
    assert "parameter 5873 of axis 1 = 400" in capsys.readouterr().err
    assert not (tmp_path / "moved" / "tables").exists()
    (tmp_path / "ALL.TXT").write_bytes(one_file("fanuc-15i").content)
    assert compwright([*moved, "--force"]) in (0, 1)


def test_15i_new_asks_for_the_unit(tmp_path: Path) -> None:
    (tmp_path / "ALL.TXT").write_bytes(one_file("fanuc-15i", more=strange()).content)
    made = tmp_path / "job.yaml"
    call = ["new", "--from", str(tmp_path / "ALL.TXT"), "--format", "fanuc-15i", "--out", str(made)]
    assert compwright(call) == 0
    assert "detection_unit:   # FILL IN" in made.read_text()


@pytest.mark.parametrize("option", ["inclination", "cyclic", "straightness"])
def test_15i_writes_nothing_whose_numbers_nobody_knows(option: str) -> None:
    with pytest.raises(UsageError, match="no option"):
        control_format(DEFINITIONS["fanuc-15i"], {option: "available"})


@pytest.mark.parametrize("here", ["another", "unknown"])
def test_what_a_definition_says_of_a_parameter_decides(here: str) -> None:
    """1820 of a 30i: read it settles the unit; else the user is asked."""
    more = "N01013Q1A1P00000000 N01820Q1A1P2"
    assert read("fanuc-30i", more).axes["1"].backlash == pytest.approx(0.002)
    other = definition_with("command_multiplier", {"here": here, "evidence": EVIDENCE})
    with pytest.raises(UsageError, match="detection unit"):
        control_format(other, {}).read([one_file("fanuc-30i", more=more)], [LINEAR])


def test_a_definition_says_of_every_parameter_what_it_is() -> None:
    with pytest.raises(InputError, match=r"parameters, weather|parameters\.weather"):
        definition_with("weather", {"here": "read", "evidence": EVIDENCE})
    assert b"parameters:" not in CONTENT["linuxcnc.yaml"]
