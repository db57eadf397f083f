"""What the FANUC series have of their own: limits, forms, numbers; by the facts pages and manuals."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, InputError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from format_samples import DEFINITIONS

pytestmark = pytest.mark.short_estimate

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
#: B-64303CM-1/01 page 26: points 31 to 37, reference 33.
EXAMPLE = dict(zip(range(31, 38), (-3, 1, 1, 1, 2, -1, -3), strict=True))
#: Totals at the nodes of 30 to 37 by its figure, detection units: from -2 to 3.
TOTALS = (1, -2, -1, 0, 1, 3, 2, -1)
LINEAR = Axis(name="X", kind=AxisKind.LINEAR, travel=(-30.0, 40.0), address="1")


def one_file(format_id: str, *, spaced: bool = False, more: str = "") -> ControlFile:
    """The example as a series writes it, parameters and pitch data between one pair of %."""
    first = 5420 if format_id == "fanuc-15i" else 3620
    mark, point = ("", "") if format_id in ("fanuc-15i", "fanuc-0i-16i") else ("Q1", "Q0")
    interval = "10000" if format_id == "fanuc-0i-16i" else "10.0"
    values = ("33", "31", "37", "1", interval)
    lines = [f"N{first + n:05d}{mark}A1P{value}" for n, value in enumerate(values)]
    lines = [f"N01851{mark}A1P2", *lines, *more.split()]
    if spaced:
        lines = [re.sub("A1P", " A1 P ", line).replace("N0", "N") for line in lines]
    lines += [f"N{10000 + number}{point}P{value}" for number, value in EXAMPLE.items()]
    return ControlFile("ALL.TXT", "\n".join(["%", *lines, "%", ""]).encode())


def table(count: int = 1) -> AxisCompensation:
    curve = np.array([0.0, 0.0, 0.0, 0.0, 0.001 * count, 0.0, 0.0, 0.0])
    return AxisCompensation(
        address="1",
        kind=AxisKind.LINEAR,
        positions=np.arange(-30.0, 50.0, 10.0),
        positive=curve,
        negative=curve,
        backlash=0.003,
        interpolation="step",
    )


FANUC = sorted(name for name in DEFINITIONS if name.startswith("fanuc"))


@pytest.mark.parametrize("spaced", [False, True])
@pytest.mark.parametrize("format_id", FANUC)
def test_the_example_of_the_manual_in_one_file(format_id: str, spaced: bool) -> None:
    """Both readers, in the spaced form of old machines too."""
    files = [one_file(format_id, spaced=spaced)]
    options = {"detection_unit": 0.001}
    state = control_format(DEFINITIONS[format_id], options).read(files, [LINEAR])
    read = state.axes["1"]
    assert read.positions.tolist() == list(range(-30, 50, 10))
    assert np.round(read.positive * 1000, 9).tolist() == list(TOTALS)
    assert read.backlash == 0.002
    judge = virtual_control(format_id, files, options=options, kinds={"1": AxisKind.LINEAR})
    for direction, lost in ((UP, 0.0), (DOWN, -2.0)):
        there = judge.correction("1", read.positions, direction)
        assert np.round(there * 1000, 6).tolist() == [total + lost for total in TOTALS]


@pytest.mark.parametrize("format_id", FANUC)
def test_an_increment_beyond_the_series_is_refused(format_id: str) -> None:
    """-7 to 7 (B-64303CM-1/01 page 26) except where a real control holds 10."""
    most = 127 if format_id == "fanuc-30i" else 7
    text = one_file(format_id).content.decode()
    control = control_format(DEFINITIONS[format_id], {"detection_unit": 0.001})
    for value in (most, most + 1):
        changed = re.sub("(?<=N10034)(Q?0?P)1", rf"\g<1>{value}", text)
        files = [ControlFile("ALL.TXT", changed.encode())]
        if value <= most:
            control.read(files, [LINEAR])
            continue
        with pytest.raises(InputError, match="cannot store") as refused:
            control.read(files, [LINEAR])
        larger = "set the option `increment_limit` to `127`" in str(refused.value)
        assert larger == (most == 7)
        assert ("export its pitch data again" in str(refused.value)) == (most == 127)


@pytest.mark.parametrize("format_id", ["fanuc-0i-d", "fanuc-0i-f"])
def test_a_control_without_the_function_gets_no_table(format_id: str) -> None:
    """8135#0 = 1 (NPE) switches stored pitch error compensation off (B-64303CM-1/01 page 26)."""
    control = control_format(DEFINITIONS[format_id], {"detection_unit": 0.001})
    off = one_file(format_id, more="N08135Q1P00000001")
    with pytest.raises(InputError, match=r"8135#0 = 0 \(it needs the option\)"):
        control.read([off], [LINEAR])
    read = control.read([off], address="1")
    assert read.axes["1"].positions.size == 0
    assert "CW-S007" in [finding.code for finding in read.findings]
    assert control.read([one_file(format_id, more="N08135Q1P11111110")], [LINEAR]).axes


@pytest.mark.parametrize("system", ["00000001", "00000010"])
def test_a_whole_interval_of_another_increment_system_is_refused(system: str) -> None:
    """3624 counts least input increments on these series: 0.001 mm by IS-B. Taken for 0.001 by IS-C
    the grid would be wrong by ten.
    """
    control = control_format(DEFINITIONS["fanuc-0i-16i"], {"detection_unit": 0.001})
    given = one_file("fanuc-0i-16i", more=f"N01004P{system}")
    with pytest.raises(InputError, match="3624 has no decimal point, and the increment system is"):
        control.read([given], [LINEAR])
    pointed = ControlFile("ALL.TXT", given.content.replace(b"P10000\n", b"P10.0\n", 1))
    assert control.read([pointed], [LINEAR]).axes["1"].positions[0] == -30.0
    plain = one_file("fanuc-0i-16i", more="N01004P00000000")
    assert control.read([plain], [LINEAR]).axes["1"].positions[0] == -30.0


@pytest.mark.parametrize("limits", [("1.0", "-1.0"), ("0.0", "0.0")])
def test_limits_that_a_control_ships_are_no_travel(limits: tuple[str, str]) -> None:
    """1320 below or at 1321 switches the limit off: 31 of 31 backups of machines hold -1 and 1."""
    low, high = limits
    more = f"N01320Q1A1P{high} N01321Q1A1P{low}"
    control = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001})
    state = control.read([one_file("fanuc-30i", more=more)], [LINEAR])
    assert "CW-S045" not in [finding.code for finding in state.findings]
    said = state.facts["1"].limits
    assert said is not None
    assert not said[0] < said[1]


# --- 15i: numbers that no page confirms
# --------------------------------------------------------------------------------------------------


def run_15i(folder: Path, files: Sequence[str]) -> int:
    rows = "".join(
        f"{x},{sign},{run},{0.01 * x + (3 if sign == '-' else 0)}\n"
        for run in (1, 2, 3)
        for sign in "+-"
        for x in range(-28, 40, 7)
    )
    (folder / "x.csv").write_text(f"# axis: X\ntarget_mm,direction,run,deviation_um\n{rows}")
    state = f"[{', '.join(files)}]" if files else "none"
    (folder / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: fanuc-15i, options: {detection_unit: 0.001,"
        f" first_point: 0}}}}\nstates: {{as_found: {state}}}\naxes:\n  X: {{kind: linear, travel:"
        " [-30, 40], address: 1, before: [x.csv]}\n"
    )
    return compwright(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])


def test_15i_is_written_into_files_that_hold_its_numbers(tmp_path: Path) -> None:
    (tmp_path / "ALL.TXT").write_bytes(one_file("fanuc-15i").content)
    assert run_15i(tmp_path, ["ALL.TXT"]) in (0, 1)
    written = sorted(path.name for path in (tmp_path / "out" / "tables" / "fanuc-15i").iterdir())
    assert written == ["ALL.TXT"]
    card = (tmp_path / "out" / "card" / "card.md").read_text()
    assert "5420 = 33" in card
    assert "3620" not in card.replace("3620 to 3627", "")


def test_15i_without_files_of_its_own_is_refused_by_name(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run_15i(tmp_path, []) == 4
    said = capsys.readouterr().err
    assert "fanuc-15i can be written only into lines of the control's own files" in said
    assert "5420" in said
    assert not (tmp_path / "out" / "tables").exists()


def test_15i_has_no_second_table_and_takes_nothing_from_3620() -> None:
    control = control_format(DEFINITIONS["fanuc-15i"], {"detection_unit": 0.001, "first_point": 0})
    assert control.capacity(LINEAR).curves == 1
    files = [one_file("fanuc-15i", more="N03620A1P1 N03621A1P1 N03622A1P9 N03605A1P00000001")]
    state = control.read(files, [LINEAR])
    assert state.axes["1"].positions.tolist() == list(range(-30, 50, 10))
    written = control.in_state(state).write([table()], [LINEAR], files)
    assert b"N03620A1P1\n" in written[0].content
    two = replace(table(), negative=table().positive + 0.001, backlash=0.0)
    with pytest.raises(CapacityError, match="one table for both"):
        control.in_state(state).write([two], [LINEAR], files)
