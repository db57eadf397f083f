"""Every fact of the FANUC definitions decides something: removed or turned, one of a few checks
falls.

The checks hold what is read and written against the tests' own virtual control and against figures
worked by hand. Where the real backup is beside the project it is one of them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from backup_files_fanuc import FOLDER, Backup
from compwright.formats.definition.inheritance import DefinitionText
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import load_definition
from compwright.formats.families.family import Family
from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.shapes import control_format
from compwright.formats.gate import check_definition
from compwright.foundations.errors import CapacityError, InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from mutants import Check, as_yaml, falls, merged_definition, mutants
from virtual_fanuc import Floats, VirtualFanuc, differing, loaded

UP, DOWN = Direction.POSITIVE, Direction.NEGATIVE
#: Agreement in mm or deg: a thousandth of the finest quantum that occurs, 0.0001.
SAME = 1e-7

#: Five axes with something of everything: X ramps up from a reference inside, magnified, with 1852
#: of its own; Y two sets; Z an interval in inches and no table that acts; B endless; C with ends.
PARAMETERS = """%
N00981Q1A1P1A2P1A3P1A4P1A5P2
N01001Q1L1P00000000L2P00000000
N01006Q1A1P00000000A2P00100000A3P00001000A4P00000001A5P00000011
N01013Q1A1P00000000A2P00000010A3P00000000A4P00000000A5P00000000
N01020Q1A1P88A2P89A3P90A4P66A5P67
N01240Q1A1P0.0A2P0.0A3P12.5A4P0.0A5P0.0
N01260Q1A1P0.0A2P0.0A3P0.0A4P360.0A5P360.0
N01320Q1A1P250.0A2P310.0A3I1.0A4P0.0A5P95.0
N01321Q1A1P-160.0A2P-10.0A3M-500.0A4P0.0A5P-95.0
N01420Q1A1P24000.0A2P15000.0A3P15000.0A4P3600.0A5P3600.0
N01800Q1L1P00010000L2P00000000
N01815Q1A1P00100000A2P00000000A3P00000000A4P00100000A5P00000000
N01820Q1A1P20A2P20A3P2A4P20A5P2
N01821Q1A1P60000A2P0A3P0A4P0A5P0
N01851Q1A1P4A2P0A3P7A4P-3A5P2
N01852Q1A1P6A2P0A3P0A4P-3A5P2
N03605Q1A1P00000010A2P00000001A3P00000000A4P00000000A5P00000000
N03620Q1A1P40A2P100A3P300A4P200A5P400
N03621Q1A1P37A2P100A3P301A4P200A5P399
N03622Q1A1P44A2P103A3P304A4P208A5P402
N03623Q1A1P2A2P3A3P0A4P1A5P1
N03624Q1A1M50.0A2P100.0A3I2.0A4P45.0A5P30.0
N03625Q1A1P0.0A2P0.0A3P0.0A4P360.0A5P0.0
N03626Q1A1P0A2P110A3P0A4P0A5P0
N03627Q1A1P0A2P-5A3P0A4P0A5P0
N10342Q1P7
%
"""
POINTS = {
    37: 1, 38: 0, 39: -2, 40: 1, 41: 2, 42: 1, 43: 0, 44: -1,
    100: 0, 101: 3, 102: -1, 103: 2, 110: 0, 111: -2, 112: 4, 113: 1,
    200: 1, 201: 1, 202: -2, 203: 1, 204: 3, 205: -1, 206: -1, 207: -2, 208: 1,
    399: 2, 400: -1, 401: 3, 402: 1, 700: 9,
}  # fmt: skip
GRID = {"1": (40, 37, 44), "2": (100, 100, 103), "4": (200, 200, 208), "5": (400, 399, 402)}


ROWS = "".join(f"N{10000 + number}Q0P{value}\n" for number, value in POINTS.items())
PITCH = f"%\n{ROWS}%\n"


BACKUP = (
    ControlFile("CNC-PARA.TXT", PARAMETERS.encode()),
    ControlFile("PITCH.TXT", PITCH.encode()),
)


@cache
def virtual(files: tuple[ControlFile, ...]) -> VirtualFanuc:
    return VirtualFanuc(loaded(file.content for file in files))


def control(definition: Definition, **options: object) -> Family:
    return control_format(definition, options)


def axis(address: str, **more: Any) -> Axis:
    kind = AxisKind.ROTARY if address in ("4", "5") else AxisKind.LINEAR
    travel = {"1": (-160.0, 250.0), "2": (-10.0, 310.0), "4": (0.0, 360.0), "5": (-60.0, 60.0)}
    given = {"reference_return": DOWN if address == "2" else UP} | more
    return Axis(
        name=dict(zip("12345", "XYZBC", strict=True))[address],
        kind=kind,
        travel=given.pop("travel", travel.get(address, (-500.0, 25.4))),
        address=address,
        modulo=360.0 if address == "4" else None,
        **given,
    )


def agrees(read: AxisCompensation, judge: VirtualFanuc, places: np.ndarray, home: int) -> None:
    for direction in (UP, DOWN):
        sign = 1 if direction is UP else -1
        there = judge.correction(int(read.address), places, sign, home=home)
        assert np.abs(read.at(places, direction) - there).max() < SAME, (read.address, direction)


#: Positions off every place where a step could come out, mm or deg.
PLACES = np.arange(-400.0, 500.0, 7.3) + 0.1


def gate(definition: Definition) -> None:
    assert check_definition(definition) == ()


def decode(definition: Definition) -> None:
    """Each axis as the virtual control has it, with the job's direction of the reference return."""
    files = BACKUP
    state = control(definition).read(files, [axis(address) for address in GRID])
    for address in GRID:
        agrees(state.axes[address], virtual(files), PLACES, -1 if address == "2" else 1)


def facts(definition: Definition) -> None:
    """What the files say beside the table, figure by figure."""
    state = control(definition, detection_unit=None).read(BACKUP, [axis("1"), axis("2")])
    one, two = state.facts["1"], state.facts["2"]
    said = {
        address: (each.name, each.kind, each.limits, each.endless, each.reference, each.diameter)
        for address, each in state.facts.items()
    }
    linear, rotary = AxisKind.LINEAR, AxisKind.ROTARY
    assert said == {
        "1": ("X", linear, (-160.0, 250.0), None, 0.0, False),
        "2": ("Y", linear, (-10.0, 310.0), None, 0.0, False),
        "3": ("Z", linear, (-250.0, 12.7), None, 12.5, True),  # 1320 and 1321 in diameter
        "4": ("B", rotary, (0.0, 0.0), 360.0, 0.0, False),
        "5": ("C", rotary, (-95.0, 95.0), None, 0.0, False),
    }
    assert (one.absolute_encoder, two.absolute_encoder) == (True, False)
    assert (one.reference_return, two.reference_return) == (UP, DOWN)
    assert [state.facts[each].enabled for each in "12345"] == [True, True, False, True, True]
    more = increments_of(one)
    assert (more.backlash, more.backlash_rapid, more.separate_rapid) == (4, 6, True)
    assert (more.inch, more.rapid_feed, more.magnification) == (False, 24000.0, 2)
    assert (increments_of(two).negative_first, increments_of(two).negative_offset) == (110, -5)
    assert (more.two_sets, increments_of(two).two_sets) == (False, True)
    assert 700 in state.reserved
    assert one.lead == 6.0  # 60000 detection units of 0.0001 mm
    assert increments_of(state.facts["5"]).separate_rapid is False  # of its own path
    assert [each.code for each in state.findings].count("CW-S040") == 1  # 3605#1 of X
    assert increments_of(state.facts["4"]).rapid_feed == 3600.0


def new_table(address: str, unit: float) -> AxisCompensation:
    """A table on the axis' own grid, whole units, zero at the reference, two curves on Y."""
    reference, first, last = GRID[address]
    step = {"1": 50.0, "2": 100.0, "4": 45.0, "5": 30.0}[address]
    low = 0 if address == "4" else first - 1 - reference
    nodes: Floats = np.arange(low if address != "2" else 0, last - reference + 1.0)
    counts = np.round(6 * np.sin(nodes * np.pi / 4)) * (1 if address != "1" else 3)
    positive = negative = (counts - counts[nodes == 0]) * unit
    if address == "2":  # referenced in -: there it is zero, and in + it is the reversal
        negative, positive = positive, positive + np.where(nodes % 2, 4.0, 3.0) * unit
    return AxisCompensation(
        address=address,
        kind=axis(address).kind,
        positions=nodes * step,
        positive=positive,
        negative=negative,
        backlash=0.0 if address == "2" else 5 * unit,
        reference_return=axis(address).reference_return,
        interpolation="step",
        period=360.0 if address == "4" else None,
    )


UNITS = {"1": 0.0001, "2": 0.00001, "4": 0.0001, "5": 0.001}


def patch(definition: Definition) -> None:
    """New tables into the backup: the virtual control has them, and nobody else's entry differs."""
    files = BACKUP
    for address, unit in UNITS.items():
        mine, table = axis(address), new_table(address, unit)
        bound = control(definition)
        state = bound.read(files, [mine])
        written = bound.in_state(state).write([table], [with_unit(mine, unit)], files)
        assert {file.name for file in written} == {"CNC-PARA.TXT", "PITCH.TXT"}
        now = VirtualFanuc(loaded(file.content for file in written))
        agrees(table, now, PLACES, 1 if mine.reference_return is UP else -1)
        changed, _ = differing(virtual(files).registers, now.registers)
        assert {group for _, group in changed} == {f"A{address}"}
        for old, new in zip(files, written, strict=True):
            assert old.content.count(b"\n") == new.content.count(b"\n")
            assert new.content.endswith(b"%\n")


def with_unit(mine: Axis, unit: float) -> Axis:
    return replace(mine, options={"detection_unit": unit})


# --- how a file may be written
# --------------------------------------------------------------------------------------------------


def unmarked(text: str) -> str:
    """The same without Q, as older series have it; then no parameter stands above 10000."""
    return re.sub("^N10342Q1P7\n", "", text, flags=re.MULTILINE).replace("Q1", "").replace("Q0", "")


WRITINGS: dict[str, Callable[[str], str]] = {
    "without Q": unmarked,
    "blanks everywhere": lambda text: re.sub("(?<=[0-9])(?=[APLQM])", " ", text),
    "blanks behind P": lambda text: re.sub("(?<=[APL])(?=[0-9-])", " ", text),
    "no leading zeros": lambda text: re.sub("^N0+", "N", text, flags=re.MULTILINE),
    "CR LF": lambda text: text.replace("\n", "\r\n"),
    "LF CR CR": lambda text: text.replace("\n", "\n\r\r"),
    "small letters": str.lower,
    "comments": lambda text: text.replace("Q0P1\n", "Q0P1 (TYPED)\n").replace("%\n", "%(ID)\n", 1),
    "empty lines": lambda text: text.replace("\n", "\n\n"),
}


def virtual_limits(address: str) -> tuple[float, float]:
    judge = virtual(BACKUP)
    return judge.length(1321, int(address)), judge.length(1320, int(address))


def writings(definition: Definition) -> None:
    """The same values however they are written; a blank line, a comment and an id hide nothing."""
    judge = virtual(BACKUP)
    for how, write in WRITINGS.items():
        files = [ControlFile(each.name, write(each.content.decode()).encode()) for each in BACKUP]
        state = control(definition).read(files, [axis(address) for address in "124"])
        for address in "124":
            agrees(state.axes[address], judge, PLACES, 1 if address != "2" else -1)
            said = state.facts[address]
            assert (said.name, said.absolute_encoder) == (axis(address).name, address != "2"), how
            assert said.limits == virtual_limits(address), how
            assert (said.reference, said.kind) == (0.0, axis(address).kind), how
        assert increments_of(state.facts["4"]).backlash_rapid == -3, how
        assert [state.facts[each].diameter for each in "13"] == [False, True], how


#: Parameters of which every line has to be readable.
CLAIMED = (1006, 1020, 1240, 1320, 1321, 1815, 1851, 1852, 3605, *range(3620, 3628))
#: Lines of which nobody can know what they mean, one for each parameter: each has to be refused
#: with its place.
DAMAGED = (
    ("N10040Q0Px", *(f"N{number:05d}Q1A1Px" for number in CLAIMED)),
    ("N10040Q0P1 more", *(f"N{number:05d}Q1A1P00000000 more" for number in CLAIMED)),
    ("N10040Q0P+-1", "N03624Q1A1P50.0 A", "N01851Q1A1P4.5", "N01006Q1A1P000"),
)
FLIPPED = str.maketrans("01", "10")


def damage(definition: Definition) -> None:
    """A line that belongs to a table and cannot be read is refused, not passed over; so is one that
    says something else than another, and a table of which a part is missing.
    """
    whole = PARAMETERS + PITCH
    for lines in DAMAGED:
        text = whole
        for line in lines:
            text = re.sub(f"^{line[:6]}.*$", line, text, flags=re.MULTILINE)
        said = refusal(definition, text)
        for line in lines:
            assert re.search(rf"line {text.split(line)[0].count(chr(10)) + 1}\b", said), line
    numbers = [number for number in CLAIMED if number != 3625]
    twice = "".join(map(contradicting, numbers))
    said = refusal(definition, f"{PARAMETERS}{twice}{PITCH}N10040Q0P5\n")
    for what in ("point 40", *(f"axis 1: {number}" for number in numbers)):
        assert f"{what} contradicts" in said, what
    assert "contradicts" in refusal(definition, f"{PARAMETERS}{contradicting(3625)}{PITCH}", "4")
    for number in (*range(3620, 3625), 3626, 3627):
        gone = re.sub(f"^N{number:05d}.*\n", "", whole, flags=re.MULTILINE)
        assert str(number) in refusal(definition, gone, "2"), number
    for text, code in (
        (PARAMETERS.rstrip("%\n") + "\n" + PITCH.rstrip("%\n") + "\n", "CW-S002"),
        (re.sub("^N01851.*\n", "", whole, flags=re.MULTILINE), "CW-S005"),
    ):
        state = control(definition).read([ControlFile("ALL.TXT", text.encode())], [axis("1")])
        assert code in [each.code for each in state.findings], code


def contradicting(number: int) -> str:
    """A second line of a parameter that says something else of X, of the turn of B."""
    line = next(one for one in PARAMETERS.splitlines() if one.startswith(f"N{number:05d}"))
    group = re.findall(f"A{4 if number == 3625 else 1}[PM][-0-9.]+", line)[0]
    if re.search("P[01]{8}$", group):
        return f"N{number:05d}Q1{group[:3]}{group[3:].translate(FLIPPED)}\n"
    return f"N{number:05d}Q1{group[:-1]}{int(group[-1] != '1')}\n"


def refusal(definition: Definition, text: str, address: str = "1") -> str:
    """What a file is refused with; empty where it is read."""
    try:
        control(definition).read([ControlFile("ALL.TXT", text.encode())], [axis(address)])
    except InputError as error:
        return "; ".join(map(str, error.faults))
    return ""


# --- limits
# --------------------------------------------------------------------------------------------------


def refused(definition: Definition, table: AxisCompensation, mine: Axis, **options: object) -> bool:
    try:
        control(definition, **options).write([table], [mine])
    except CapacityError:
        return True
    return False


def limits(definition: Definition) -> None:
    """The largest that the control takes is written, one more is refused."""
    most = SERIES[definition.id]
    mine = with_unit(axis("1", travel=(0.0, 100.0)), 0.001)

    def table(
        count: int, *, points: int = 3, step: float = 50.0, backlash: int = 0
    ) -> AxisCompensation:
        curve = np.zeros(points)
        curve[1:] = count * 0.001
        nodes: Floats = np.arange(float(points)) * step
        return replace(
            new_table("1", 0.001),
            positions=nodes, positive=curve, negative=curve, backlash=backlash * 0.001,
        )  # fmt: skip

    def writes(tried: AxisCompensation, **options: object) -> bool:
        return not refused(definition, tried, mine, **{"first_point": 0, **options})

    largest = most.increment * 100 + 1  # odd: only the magnification 1 divides it with 1
    assert writes(table(most.increment))
    assert not writes(table(largest))
    assert writes(table(most.increment * 100))
    assert not writes(table(most.increment * 101))
    assert writes(table(0, points=most.number + 1, step=1.0))
    assert not writes(table(0, points=most.number + 3, step=1.0))
    assert writes(table(1), first_point=most.number - 2)
    assert not writes(table(1), first_point=most.number - 1)
    assert writes(table(1, backlash=9999))
    assert not writes(table(1, backlash=10000))
    assert writes(table(1, backlash=-9999))
    assert not writes(table(1, backlash=-10000))
    assert writes(table(1, step=0.001))
    assert not writes(table(1, step=0.0005))
    assert writes(table(1, step=99999.999))
    assert not writes(table(1, step=100000.001))
    assert writes(table(1, step=10.0), max_feed=75000)
    assert not writes(table(1, step=9.999), max_feed=75000)
    assert writes(table(1, step=0.9), max_feed="6750.0")
    assert not writes(table(1, step=0.9), max_feed=6751.5)
    assert writes(table(1, points=2))
    # What a control holds in one number it also reads, and not one more.
    for value, held in ((most.increment, True), (most.increment + 1, False)):
        text = re.sub("(?<=^N10041Q0P)2$", str(value), PARAMETERS + PITCH, flags=re.MULTILINE)
        assert bool(refusal(definition, text)) is not held, value


@dataclass(frozen=True)
class Series:
    """Largest increment and point number of a series, and how it writes: marks of parameters and of
    pitch data, an interval of 50 mm, one of 45 deg and a turn, the line that begins a program.
    """

    increment: int
    number: int
    parameter: str = "Q1"
    point: str = "Q0"
    interval: str = "M50.0"
    angles: tuple[str, str] = ("45.0", "360.0")
    program: str = "G10L52"
    #: 8135#0 switches the function off.
    switch: bool = False


SERIES = {
    "fanuc-30i": Series(127, 1535),
    "fanuc-0i-d": Series(7, 1023, switch=True),
    "fanuc-0i-f": Series(7, 1535, switch=True),
    "fanuc-0i-16i": Series(7, 1023, "", "", "P50000", ("45000", "360000"), "G10L50"),
}


# --- files of its own
# --------------------------------------------------------------------------------------------------


def fresh(definition: Definition) -> None:
    """Without files of the control: two files with the axis' own numbers, byte by byte."""
    series = SERIES[definition.id]
    own = with_unit(axis("5"), 0.0001)
    sections = replace(
        new_table("5", 0.0001), positions=new_table("5", 0.0001).positions / 30 * 0.001
    )
    assert not refused(definition, sections, own, first_point=0)
    narrow = replace(sections, positions=sections.positions / 2)
    assert refused(definition, narrow, own, first_point=0)
    linear = replace(
        new_table("1", 0.001),
        positions=np.array([-100.0, -50.0, 0.0, 50.0]),
        positive=np.array([0.002, -0.001, 0.0, 0.004]),
        negative=np.array([0.002, -0.001, 0.0, 0.004]),
    )
    rows = ("3620 8", "3621 7", "3622 9", "3623 1", "1851 5", f"3624 {series.interval}")
    points = ("10007 -3", "10008 1", "10009 4")
    mine = with_unit(axis("1", travel=(-100.0, 50.0)), 0.001)
    assert written_fresh(definition, linear, mine) == {
        "PARAM_1.TXT": page(f"N0{{}}{series.parameter}A1{{}}", rows),
        "PITCH_1.TXT": page(f"N{{}}{series.point}P{{}}", points, "{}"),
        "G10_1.NC": "%\nO9101\n"
        + series.program
        + "\nN3620P1R8\nN3621P1R7\nN3622P1R9\nN3623P1R1\nN3624P1R"
        + series.interval[1:]
        + "\nN1851P1R5\nN10007R-3\nN10008R1\nN10009R4\nG11\nM30\n%\n",
    }
    turn = replace(new_table("4", 0.001), backlash=-0.003)
    more = ("3620 7", "3621 7", "3622 15", "3623 1", f"3625 P{series.angles[1]}", "1851 -3",
            f"3624 P{series.angles[0]}")  # fmt: skip
    written = written_fresh(definition, turn, with_unit(axis("4"), 0.001))
    assert written["PARAM_4.TXT"] == page(f"N0{{}}{series.parameter}A4{{}}", more)


def written_fresh(definition: Definition, table: AxisCompensation, mine: Axis) -> dict[str, str]:
    family = control(definition, first_point=7, program="g10")
    files = (*family.write([table], [mine]), *family.sheets([table], [mine]))
    return {file.name: file.content.decode() for file in files if not file.name.endswith(".csv")}


def page(form: str, rows: Sequence[str], value: str = "P{}") -> str:
    """``rows``: number and value; a value without a letter gets ``value``'s."""
    pairs = [row.split() for row in rows]
    lines = [form.format(one, two if two[0] in "MP" else value.format(two)) for one, two in pairs]
    return "\n".join(["%", *lines, "%", ""])


# --- options
# --------------------------------------------------------------------------------------------------


def turned(definition: Definition) -> None:
    """Options that turn a sign or the way of a step turn what is read, of one axis or of all."""
    files = BACKUP
    plain = virtual(files)
    for address, options, judge in (
        ("1", {"pitch_sign": "-"}, replace(plain, pitch_sign=-1)),
        ("1", {"output": "ramp"}, replace(plain, output="ramp")),
        ("2", {"offset_sign": "-"}, replace(plain, offset_sign=-1)),
        ("2", {"offset_magnified": "yes"}, replace(plain, offset_magnified=True)),
    ):
        for given, own in ((options, {}), ({}, options)):
            mine = replace(axis(address), options=own)
            state = control(definition, **given).read(files, [mine])
            agrees(state.axes[address], judge, PLACES, -1 if address == "2" else 1)
    for limit in ("7", "127"):
        text = re.sub("(?<=^N10041Q0P)2$", "8", PARAMETERS + PITCH, flags=re.MULTILINE)
        one = ControlFile("ALL.TXT", text.encode())
        mine = replace(axis("1"), options={"increment_limit": limit})
        try:
            control(definition).read([one], [mine])
        except InputError:
            assert limit == "7"
        else:
            assert limit == "127"


def choices(definition: Definition) -> None:
    """What holds for the whole control cannot be an axis' own, and a program comes on request."""
    mine = with_unit(axis("1"), 0.001)
    beside = ("straightness", "inclination", "cyclic")
    for name in (*beside, "program"):
        try:
            control(definition).scale_of(replace(mine, options={name: "absent"}))
        except UsageError as error:
            assert "whole control" in str(error)  # noqa: PT017
        else:
            raise AssertionError(name)
    for name in beside:
        assert control(definition).options[name] == "absent"
        assert control(definition, **{name: "available"}).options[name] == "available"
    for given, written in (({}, False), ({"inclination": "available"}, True)):
        slope = control(definition, first_point=0, **given).capacity(mine).slope
        assert (slope is not None) is written
    turning = with_unit(axis("4"), 0.001)
    for given, written in (({}, False), ({"cyclic": "available"}, True)):
        wave = control(definition, first_point=0, **given).capacity(turning).wave
        assert (wave is not None) is written
    try:
        control(definition).write([new_table("1", 0.001)], [mine])
    except UsageError as error:
        assert "first_point" in str(error)  # noqa: PT017
    else:
        raise AssertionError("first_point is asked for")
    own = replace(mine, options={**mine.options, "first_point": 3, "max_feed": 7500.5})
    table = replace(new_table("1", 0.001), positions=new_table("1", 0.001).positions / 50)
    assert refused(definition, table, own)
    assert not refused(definition, table, replace(own, options={**own.options, "max_feed": 7499.5}))
    assert len(control(definition, first_point=0).sheets([table], [mine])) == 1


def off(definition: Definition) -> None:
    """Where a series switches the whole function off, no table is read for an axis under work."""
    switch = SERIES[definition.id].switch
    for mark in ("Q1", ""):
        for bits, expected in (("00000001", switch), ("11111110", False)):
            said = refusal(definition, f"{PARAMETERS}N08135{mark}P{bits}\n{PITCH}")
            assert ("8135#0" in said, bool(said)) == (expected, expected), (mark, bits)
    if switch:
        damaged = refusal(definition, f"{PARAMETERS}N08135Q1P00000000 more\n{PITCH}")
        assert re.search(rf"line {PARAMETERS.count(chr(10)) + 1}\b", damaged)
        text = f"{PARAMETERS}N08135Q1P00000000\nN08135Q1P00000001\n{PITCH}"
        assert "8135 contradicts" in refusal(definition, text)
        text = f"{PARAMETERS}N08135Q1P00000001\n{PITCH}"
        state = control(definition).read([ControlFile("ALL.TXT", text.encode())], address="1")
        assert state.axes["1"].positions.size == 0


# --- the real backup
# --------------------------------------------------------------------------------------------------


@cache
def real_backup() -> tuple[ControlFile, ...]:
    return tuple(ControlFile(name, text) for name, text in Backup.real().files().items())


def real(definition: Definition) -> None:
    """X, Y, Z and B of the real backup as the virtual control has them, by series that hold it."""
    if SERIES[definition.id].increment < 10:
        return
    travel = {"1": (-1000.0, 1.0), "2": (-1101.0, 1.0), "3": (-781.0, 30.0)}
    axes = [axis(each, reference_return=UP, travel=low) for each, low in travel.items()]
    state = control(definition).read(real_backup(), [*axes, axis("4")])
    for address in (*travel, "4"):
        agrees(state.axes[address], virtual(real_backup()), PLACES, 1)


#: In the order in which most mutants fall soonest.
CHECKS: dict[str, Check] = {
    each.__name__: each
    for each in (
        *(choices, facts, fresh, damage, limits, off),
        *(writings, turned, patch, decode, gate),
    )
}
if FOLDER.is_dir():
    CHECKS["real"] = real

#: Facts that decide nothing here -> why. Whatever else survives is a hole in the checks, or a dead
#: key of the definition.
DECIDES_NOTHING = {
    r"addresses\.case": "an axis is a number",
    r"texts\.data\.blank_lines": "lines that say nothing are passed over, empty ones too",
    r"bindings\.\w+\.when_absent": "whole steps never count a missing value as zero, whatever the"
    " definition says; `damage` leaves each out",
    r"bindings\.value\.(field|repeated)": "points are read by number, and held against each other",
    r"bindings\.value\.range": "the option increment_limit counts",
    r"bindings\.table_spacing\.range: bound 0 -> -5": "an interval is more than 0 anyway",
    r"bindings\.\w+\.writes": "only 3605#0 is written, as the table asks",
    r"bindings\.(rotary|diameter)\.repeated": "1006 as a whole is held against each other",
    r"diameter\.tables": "decides a question of the job: tests/controls/test_fanuc_backup_honoured.py",
    r"options\.points_from": "decides a question of the job: tests/controls/test_fanuc_backup_honoured.py",
    r"limits\[0\]: removed": "fewer than two points are no table anywhere",
}
#: One fact in twelve is turned here, all of them by benchmarks/bench_facts.py.
EVERY, SHARES = 12, 1
BESIDE = {
    "fanuc-30i": "",
    "fanuc-0i-d": "fanuc-30i",
    "fanuc-0i-f": "fanuc-30i",
    "fanuc-0i-16i": "fanuc-30i",
}


@cache
def turned_facts(format_id: str) -> tuple[tuple[str, DefinitionText], ...]:
    return tuple(mutants(format_id, beside=BESIDE[format_id]))


@pytest.mark.parametrize("format_id", BESIDE)
def test_the_definition_as_it_is_keeps_every_check(format_id: str) -> None:
    assert falls(merged_definition(format_id), CHECKS) == ""


@pytest.mark.parametrize("share", range(SHARES))
@pytest.mark.parametrize("format_id", BESIDE)
def test_a_fact_removed_or_turned_makes_a_check_fall(format_id: str, share: int) -> None:
    assert silent_facts(format_id, share * EVERY, SHARES * EVERY) == []


def silent_facts(format_id: str, first: int, every: int) -> list[str]:
    """The facts that no check notices when they are turned, of ``every`` so many from ``first``
    on.
    """
    return [
        name
        for name, text in turned_facts(format_id)[first::every]
        if not any(re.match(each, name) for each in DECIDES_NOTHING) and not falls(text, CHECKS)
    ]


#: Parameters that are read by their numbers wherever they stand, not by the definition.
NUMBERS = ("PATH_OF_AXIS", "INCH", "KIND", "SYSTEM", "RAPID", "BACKLASH_BITS", "ENCODER",
           "MULTIPLIER", "REFERENCE_COUNTER", "PITCH_BITS")  # fmt: skip


@pytest.mark.parametrize("name", NUMBERS)
def test_a_parameter_read_under_another_number_makes_a_check_fall(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    number = getattr(known, name)
    assert falls(merged_definition("fanuc-30i"), {"facts": facts, "decode": decode}) == ""
    monkeypatch.setattr(known, "NAMES", {**known.NAMES, number + 500: "path"})
    monkeypatch.setattr(known, name, number + 500)
    assert falls(merged_definition("fanuc-30i"), {"facts": facts, "decode": decode}) != ""


def test_what_decides_nothing_is_a_fact_that_is_there() -> None:
    names = [name for name, _ in turned_facts("fanuc-30i")]
    assert len(names) > 400
    for pattern in DECIDES_NOTHING:
        assert any(re.match(pattern, name) for name in names), pattern


def test_a_mutant_is_a_definition_that_a_command_can_read(tmp_path: Path) -> None:
    name, text = turned_facts("fanuc-30i")[-1]
    path = tmp_path / "mine.yaml"
    path.write_bytes(as_yaml(text, "mine"))
    assert load_definition(path.read_bytes(), path.name).id == "mine", name
