"""One contract for every control: inject a known error, measure, fit, write, load into the virtual
control, measure again.

With a mistake in the definition (sign, direction, start, unit) the same demand fails: that is tried
for each.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from card_files import wrong_files
from compwright.cli import run as compwright
from compwright.controllers.virtual_control import virtual_control
from compwright.formats.definition.inheritance import found_in, texts_of
from compwright.formats.definition.options import resolve_options
from compwright.formats.definitions import definition_of
from compwright.formats.families.shapes import control_format
from compwright.foundations import storage
from compwright.foundations.errors import CapacityError, CompwrightError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.plan import Texts
from loop import Floats, Machine, accuracy, allowed, csv_of

pytestmark = pytest.mark.short_estimate

FORMATS = (
    "siemens-840d-sl",
    "siemens-828d",
    "siemens-840d-pl",
    "siemens-one",
    "linuxcnc",
    "fanuc-30i",
    "fanuc-0i-16i",
    "fanuc-0i-d",
    "fanuc-0i-f",
    "heidenhain-itnc530",
    "heidenhain-nck",
    "isg-kernel",
    "pmac",
)
#: All but relatives by words alone (test_siemens_relatives.py).
DISTINCT = tuple(name for name in FORMATS if name not in ("siemens-840d-pl", "siemens-one"))
#: One control of each form of files; the others differ from it in facts that other tests go
#: through, and read their own tables again in test_grid_stays.py.
FORMS = tuple(name for name in DISTINCT if name not in ("siemens-828d", "fanuc-0i-d", "fanuc-0i-f"))
#: The same controls met otherwise: tables of their own that are filled, an option that they have.
#: The name before + is the format.
MET_OTHERWISE = ("heidenhain-nck+filled", "heidenhain-itnc530+filled", "siemens-840d-sl+cec")
ADDRESS = {
    "siemens-840d-sl": "AX1",
    "siemens-828d": "AX1",
    "siemens-840d-pl": "AX1",
    "siemens-one": "AX1",
    "linuxcnc": "0",
    "fanuc-30i": "1",
    "fanuc-0i-16i": "1",
    "fanuc-0i-d": "1",
    "fanuc-0i-f": "1",
    "heidenhain-itnc530": "X",
    "heidenhain-nck": "X",
    "isg-kernel": "1",
    "pmac": "1",
}
#: Controls whose table holds the reversal, in a curve for each direction.
TWO_CURVES = ("linuxcnc", "isg-kernel", "pmac")
#: What nobody can know but the user.
OPTIONS: dict[str, dict[str, object]] = {
    "fanuc-30i": {"detection_unit": 0.001, "first_point": 0},
    "fanuc-0i-16i": {"detection_unit": 0.001, "first_point": 0},
    "fanuc-0i-d": {"detection_unit": 0.001, "first_point": 0},
    "fanuc-0i-f": {"detection_unit": 0.001, "first_point": 0},
    "pmac": {"counts_per_unit": 62500.0},  # a table value of 1 is 1e-6 mm
}
#: What a control met otherwise has.
MORE_OPTIONS = {
    "siemens-840d-sl+cec": {"cec": "available", "cec_tables": "3,8", "cec_sign": "correction"}
}
#: Controls that hold whole steps of 1 µm which come out in the middle of a section.
STEPS = ("fanuc-30i", "fanuc-0i-16i", "fanuc-0i-d", "fanuc-0i-f")
#: Decimal places of a table value in mm, where it is not 6.
DIGITS = {
    "fanuc-30i": 3,
    "fanuc-0i-16i": 3,
    "fanuc-0i-d": 3,
    "fanuc-0i-f": 3,
    "heidenhain-itnc530": 4,
    "heidenhain-nck": 4,
    "isg-kernel": 4,
}
MACHINES = {
    "plain": Machine(),
    "negative travel, referenced in -": Machine(
        low=-500, high=0, slope=-40e-6, lost=0.003, reference_return=-1
    ),
    "short axis": Machine(low=-20, high=130, slope=60e-6, bow=0.002, lost=0.008, noise=0.0003),
}


def loaded(
    files: list[ControlFile] | tuple[ControlFile, ...], format_id: str, machine: Machine
) -> Callable[[Floats, int], Floats]:
    """The correction that the virtual control applies with ``files`` loaded."""
    format_id = format_of(format_id)
    address = ADDRESS[format_id]
    returns = Direction.POSITIVE if machine.reference_return > 0 else Direction.NEGATIVE
    control = virtual_control(
        format_id, files, reference_return={address: returns}, options=OPTIONS.get(format_id)
    )
    assert address in control.addresses()
    return lambda x, sign: control.correction(
        address, x, Direction.POSITIVE if sign > 0 else Direction.NEGATIVE
    )


def allowed_by(format_id: str, machine: Machine, targets: Floats, spacing: float) -> float:
    """What A may be on this control: as `allowed`; steps add at both ends of the range half a step
    of rounding, and what the error climbs in half a section."""
    limit = allowed(machine, targets, spacing)
    if format_id not in STEPS:
        return limit
    steepest = abs(machine.slope) + machine.bow * 2.3 * np.pi / (machine.high - machine.low)
    return limit + 2 * (0.0005 + steepest * spacing / 2)


def run_arguments(folder: Path, format_id: str, machine: Machine, *states: str) -> list[str]:
    more = MORE_OPTIONS.get(format_id, {})
    format_id = format_of(format_id)
    state = [word for name in states for word in ("--state", name)]
    option = [
        f"address={ADDRESS[format_id]}",
        f"reference_return={'+' if machine.reference_return > 0 else '-'}",
        *(f"{name}={value}" for name, value in {**OPTIONS.get(format_id, {}), **more}.items()),
    ]
    return [
        "run", str(folder / "x.csv"), "--format", format_id, "--axis", "X", "--travel", f"{machine.low}:{machine.high}", *state,
        *(word for entry in option for word in ("--option", entry)), "--out", str(folder / "out"),
    ]  # fmt: skip


def format_of(name: str) -> str:
    return name.split("+", maxsplit=1)[0]


def start_of(name: str, folder: Path, machine: Machine) -> list[str]:
    """What is in the control at the beginning: nothing, or its own exported tables with a column of
    another axis, all written.
    """
    if not name.endswith("+filled"):
        return ["none"]
    folder.mkdir(exist_ok=True)
    count = 17
    step = (machine.high - machine.low) / (count - 1)
    places = [machine.low + step * index for index in range(count)]
    if name.startswith("heidenhain-nck"):
        rows = "".join(
            f"{k:<3d} {x:<+10g} +0.0000    +0.00{10 + k}\n" for k, x in enumerate(places)
        )
        table = f"BEGIN X.COM MM\nNR  AXISPOS    X          Y\n{rows}[END]\n"
        lines = "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X      Y\n0   *       X.COM\n[END]\n"
        play = "# axis: X\n# value: error\npoint,position,value,unit\nbackLash,,0.0000,mm\n"
        files = {"X.COM": table, "CONFIG.CMA": lines, "entry_X.csv": play}
    else:
        rows = "".join(f"{k:<4d} +0         +0.00{10 + k}\n" for k in range(count))
        head = f"BEGIN X      .COM MM DATUM:{machine.low:g} DIST:{step:g}\nNR   1=F()      2=F()\n"
        files = {
            "X.COM": f"{head}{rows}END   X      .COM\n",
            "MP.TXT": "MP710.0 : 0.0000\nMP730 : %00001\n",
        }
    for file, text in files.items():
        (folder / file).write_text(text)
    return [str(folder / file) for file in files]


def tables_in(folder: Path, format_id: str) -> list[ControlFile]:
    return [
        ControlFile(path.name, path.read_bytes())
        for path in sorted((folder / "out" / "tables" / format_of(format_id)).iterdir())
    ]


def one_round(
    folder: Path,
    format_id: str,
    machine: Machine,
    targets: Floats,
    seed: int,
    states: list[str],
    now: object,
) -> list[ControlFile]:
    """Measure with ``now`` active in the control, run compwright, return the new files."""
    folder.mkdir()
    readings = machine.measure(targets, seed, now)  # type: ignore[arg-type]  # a correction or None
    (folder / "x.csv").write_text(csv_of(targets, readings))
    code = compwright(run_arguments(folder, format_id, machine, *states))
    assert code == 0
    assert wrong_files(folder / "out") == []
    return tables_in(folder, format_id)


def spacing_of(files: list[ControlFile], format_id: str) -> float:
    format_id = format_of(format_id)
    nodes = virtual_control(format_id, files, options=OPTIONS.get(format_id)).points(
        ADDRESS[format_id]
    )
    return float(np.max(np.diff(nodes)))


@pytest.mark.parametrize("name", [name for name in MACHINES if name != "plain"])
@pytest.mark.parametrize("format_id", DISTINCT + MET_OTHERWISE)
def test_accuracy_falls_to_the_noise_floor(format_id: str, name: str, tmp_path: Path) -> None:
    """The plain machine is that of the next test."""
    machine = MACHINES[name]
    targets = machine.targets()
    before = accuracy(machine.measure(targets, seed=1))
    start = start_of(format_id, tmp_path / "control", machine)
    files = one_round(tmp_path / "first", format_id, machine, targets, 1, start, None)
    fresh = machine.targets(seed=8)  # new targets: what the old ones hide would show
    after = accuracy(machine.measure(fresh, 2, loaded(files, format_id, machine)))
    limit = allowed_by(format_id, machine, fresh, spacing_of(files, format_id))
    assert before > 3 * limit, "the machine must be bad enough for the demand to mean something"
    assert after <= limit  # mm


@pytest.mark.parametrize("format_id", FORMS + MET_OTHERWISE)
def test_a_wrong_old_table_is_replaced_in_one_round_and_stays_so_after_a_second(
    format_id: str, tmp_path: Path
) -> None:
    machine = Machine()
    targets = machine.targets()
    # A table from another machine, loaded by mistake: 15 µm of bow and 12 µm of backlash too much.
    wrong = Machine(slope=-30e-6, bow=0.015, lost=0.012)
    start = start_of(format_id, tmp_path / "control", wrong)
    old = one_round(tmp_path / "other", format_id, wrong, targets, 5, start, None)
    active = loaded(old, format_id, machine)
    assert accuracy(machine.measure(targets, 6, active)) > accuracy(machine.measure(targets, 6))

    old_files = [
        str(tmp_path / "other" / "out" / "tables" / format_of(format_id) / file.name)
        for file in old
    ]
    new = one_round(tmp_path / "first", format_id, machine, targets, 6, old_files, active)
    spacing = max(spacing_of(old, format_id), spacing_of(new, format_id))
    limit = allowed_by(format_id, machine, targets, spacing)
    first = loaded(new, format_id, machine)
    assert accuracy(machine.measure(targets, 7, first)) <= limit

    new_files = [
        str(tmp_path / "first" / "out" / "tables" / format_of(format_id) / file.name)
        for file in new
    ]
    folder = tmp_path / "second"
    folder.mkdir()
    (folder / "x.csv").write_text(csv_of(targets, machine.measure(targets, 8, first)))
    code = compwright([*run_arguments(folder, format_id, machine, *new_files), "--accept-worse"])
    assert code == 0
    second = loaded(tables_in(folder, format_id), format_id, machine)
    assert accuracy(machine.measure(targets, 9, second)) <= limit


def test_rollback_holds_the_old_files_byte_by_byte(tmp_path: Path) -> None:
    machine = Machine()
    old = one_round(
        tmp_path / "a", "siemens-840d-sl", machine, machine.targets(), 1, ["none"], None
    )
    folder = tmp_path / "a" / "out" / "tables" / "siemens-840d-sl"
    active = loaded(old, "siemens-840d-sl", machine)
    shifted = replace(machine, slope=machine.slope + 50e-6)
    one_round(
        tmp_path / "b", "siemens-840d-sl", shifted, machine.targets(), 2, [str(folder)], active
    )
    rollback = tmp_path / "b" / "out" / "rollback" / "siemens-840d-sl"
    kept = {path.name: path.read_bytes() for path in rollback.iterdir()}
    small = {name for name in kept if name.startswith("BACK_")}  # small files beside the copies
    assert small == {f"BACK_{file.name}" for file in old}
    assert {name: kept[name] for name in kept.keys() - small} == {
        file.name: file.content for file in old
    }
    assert not (tmp_path / "a" / "out" / "rollback").exists()


# The definition, made wrong on purpose
# --------------------------------------------------------------------------------------

#: What to change in the text of a definition -> (old, new); each is a mistake that a hand-written
#: definition can have.
MUTATIONS = {
    "siemens-840d-sl": {
        "flipped sign of the table": ("    sign: error", "    sign: correction"),
        "wrong unit of the table": (
            "unit: {linear: {option: units}, rotary: deg}\n    sign: error",
            "unit: {linear: um, rotary: deg}\n    sign: error",
        ),
        "start and end exchanged": (
            "$AA_ENC_COMP_MIN[{system},{axis}]={value}",
            "$AA_ENC_COMP_MAX[{system},{axis}]={value}",
        ),
        "backlash on the other measuring system": (
            "$MA_BACKLASH[{system},{axis}]=0",
            "$MA_BACKLASH[1,{axis}]=0",
        ),
    },
    "linuxcnc": {
        "flipped sign of the table": (
            "actual: actual_position, trim: correction",
            "actual: correction, trim: actual_position",
        ),
        "columns exchanged": (
            'form: "{position} {positive} {negative}"',
            'form: "{position} {negative} {positive}"',
        ),
        "wrong unit of one column": (
            "field: positive\n    unit: {linear: {option: units}, rotary: deg}",
            "field: positive\n    unit: {linear: inch, rotary: deg}",
        ),
        "forms exchanged": ('values: {"0": actual, "1": trim}', 'values: {"0": trim, "1": actual}'),
    },
    "fanuc-30i": {
        "flipped sign of the data": (
            'default: "+"\n    choices: ["+", "-"]',
            'default: "-"\n    choices: ["+", "-"]',
        ),
        "reference and first number exchanged": ("N#03620Q1(A", "N#03621Q1(A"),
        "magnification in the place of the reference": ('form: "N#03623Q1(A', 'form: "N#03620Q1(A'),
        "backlash in mm": (
            "unit: {linear: pulse, rotary: pulse}\n    sign: lost_motion",
            "unit: {linear: mm, rotary: pulse}\n    sign: lost_motion",
        ),
        "backlash of rapid instead": ('form: "N#01851Q1(A', 'form: "N#01852Q1(A'),
    },
    "fanuc-0i-16i": {
        "interval in the place of the turn": ('form: "N#03624(A', 'form: "N#03625(A'),
        "flipped sign of the data": (
            'default: "+"\n    choices: ["+", "-"]',
            'default: "-"\n    choices: ["+", "-"]',
        ),
        "last number in the place of the first": ('form: "N#03621(A', 'form: "N#03622(A'),
    },
    "heidenhain-itnc530": {
        "flipped sign of the table": (
            "{table_form: {error: error, correction: correction}}",
            "{table_form: {error: correction, correction: error}}",
        ),
    },
    "heidenhain-nck": {
        "flipped sign of the table": (
            "{table_form: {error: error, correction: correction}}",
            "{table_form: {error: correction, correction: error}}",
        ),
    },
    "isg-kernel": {
        "flipped sign of the table": ("default: error", "default: correction"),
        "columns exchanged": (
            "].pos         {value}",
            "].neg         {value}",
        ),
        "values in the place of positions": ("].setpoint    {value}", "].pos    {value}"),
        "a list in increments": ('writes: "1"', 'writes: "0"'),
        "one column for both directions": (
            'values: {"0": "no", "1": "yes"}\n    writes: "1"',
            'values: {"0": "no", "1": "yes"}\n    writes: "0"',
        ),
        "a number of entries that says nothing": (
            'form: "kw.ssfk.kw_nr_max ',
            'form: "kw.ssfk.max_points ',
        ),
    },
    "pmac": {
        "flipped sign of the table": (
            "sign: correction\n    digits: 0\n    range: [-8388607, 8388607]",
            "sign: error\n    digits: 0\n    range: [-8388607, 8388607]",
        ),
        "length and number of entries exchanged": (
            'DEFINE COMP {entries},#{source}D,{length}"',
            'DEFINE COMP {length},#{source}D,{entries}"',
        ),
        "backlash in the place of its rate": ('form: "I{axis}86', 'form: "I{axis}85'),
        "ends switched off": ('footer: ["I51=1"]', 'footer: ["I51=0"]'),
    },
}


def axis_of(machine: Machine, format_id: str) -> Axis:
    return Axis(
        name="X",
        kind=AxisKind.LINEAR,
        travel=(machine.low, machine.high),
        address=ADDRESS[format_id],
    )


def perfect_table(machine: Machine, format_id: str) -> AxisCompensation:
    """The table that knows the truth, on 41 nodes, zero in the zero state (reference 0)."""
    nodes = np.linspace(machine.low, machine.high, 41)
    zero = float(machine.error(np.array([0.0]), machine.reference_return)[0])
    digits = DIGITS.get(format_id, 6)
    positive, negative = (
        np.round(-(machine.error(nodes, sign) - zero), digits) for sign in (1, -1)
    )
    one_curve = format_id not in TWO_CURVES
    return AxisCompensation(
        address=ADDRESS[format_id],
        kind=AxisKind.LINEAR,
        positions=nodes,
        positive=positive,
        negative=positive if one_curve else negative,
        backlash=machine.lost if one_curve else 0.0,
        below=control_format(definition_of(definition_texts(format_id)), OPTIONS.get(format_id, {}))
        .capacity(axis_of(machine, format_id))
        .below,
        interpolation="step" if format_id in STEPS else "linear",
    )


def accuracy_with(texts: Texts, format_id: str, table: AxisCompensation | None = None) -> float:
    """A after loading what a definition writes for the perfect table (or ``table``), by the virtual
    control; mm.
    """
    machine = MACHINES["plain"]
    definition = definition_of(texts)
    options = resolve_options(definition, OPTIONS.get(format_id, {}))
    files = control_format(definition, options).write(
        [table or perfect_table(machine, format_id)], [axis_of(machine, format_id)]
    )
    fresh = machine.targets(seed=8)
    return accuracy(machine.measure(fresh, 2, loaded(files, format_id, machine)))


def definition_texts(format_id: str, old: str = "", new: str = "") -> Texts:
    """A definition that ships, with what it extends; ``old`` -> ``new`` where it stands first."""
    files = dict(storage.definition_files(Session()))
    name = f"{format_id}.yaml"
    texts = texts_of(files[name], name, found_in(files))
    hit = [name for name, text in texts if old.encode() in text]
    assert hit, "the mutation must hit something"
    return tuple(
        (name, text.replace(old.encode(), new.encode(), 1) if name == hit[0] else text)
        for name, text in texts
    )


@pytest.mark.parametrize("format_id", FORMATS)
def test_the_definition_as_it_is_keeps_the_demand(format_id: str) -> None:
    machine = MACHINES["plain"]
    assert accuracy_with(definition_texts(format_id), format_id) <= allowed_by(
        format_id, machine, machine.targets(seed=8), 20.0
    )


@pytest.mark.parametrize(
    ("format_id", "name"),
    [(format_id, name) for format_id, changes in MUTATIONS.items() for name in changes],
)
def test_a_mistake_in_the_definition_breaks_the_demand(format_id: str, name: str) -> None:
    old, new = MUTATIONS[format_id][name]
    texts = definition_texts(format_id, old, new)
    machine = MACHINES["plain"]
    limit = allowed_by(format_id, machine, machine.targets(seed=8), 20.0)
    try:
        after = accuracy_with(texts, format_id)
    except (CompwrightError, AssertionError):
        return  # refused by the writer, or by the virtual control that cannot read it
    assert after > limit


@pytest.mark.parametrize("format_id", FORMATS)
def test_a_table_one_node_off_breaks_the_demand(format_id: str) -> None:
    machine = Machine()
    table = perfect_table(machine, format_id)
    shifted = replace(
        table, positive=np.roll(table.positive, 3), negative=np.roll(table.negative, 3)
    )
    # Refused by the writer: its table is no longer zero at the reference.
    if format_id in (*STEPS, "pmac"):
        with pytest.raises(CapacityError, match=r"at the reference, arriving|not zero at the ref"):
            accuracy_with(definition_texts(format_id), format_id, shifted)
        return
    assert accuracy_with(definition_texts(format_id), format_id, shifted) > allowed_by(
        format_id, machine, machine.targets(seed=8), 20.0
    )


@pytest.mark.parametrize("format_id", FORMATS)
def test_exchanged_directions_break_the_demand(format_id: str) -> None:
    machine = Machine()
    table = perfect_table(machine, format_id)
    swapped = replace(
        table, positive=table.negative, negative=table.positive, backlash=-table.backlash
    )
    if format_id == "pmac":  # it holds nothing against the lost motion at motor zero
        with pytest.raises(CapacityError, match=r"backlash at motor zero|arriving in"):
            accuracy_with(definition_texts(format_id), format_id, swapped)
        return
    assert accuracy_with(definition_texts(format_id), format_id, swapped) > allowed_by(
        format_id, machine, machine.targets(seed=8), 20.0
    )
