"""What holds for every table and every damage: written and read back the same; damaged, refused or
the same table.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.formats.definition.inheritance import found_in
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import load_definition
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import InputError, UsageError
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile
from format_samples import CONTENT, DEFINITIONS, LINUXCNC, SIEMENS, axis_of

#: The controls with values by index and with rows by position; the others have properties of their
#: own.
INDEXED_AND_ROWS = ("siemens-840d-sl", "linuxcnc")

COUNTS = st.integers(-40_000, 40_000)  # values in quanta: up to 40 µm and 4 µm


@st.composite
def tables(
    draw: st.DrawFn, definition: Definition
) -> tuple[AxisCompensation, Axis, dict[str, object]]:
    """A table that the control can hold: whole quanta, the control's spacing rule, its ends and
    curves.
    """
    kind = draw(st.sampled_from(list(AxisKind)))
    address = draw(st.sampled_from(["AX1", "Q_2"] if definition is SIEMENS else ["0", "15"]))
    returns = draw(st.sampled_from(list(Direction)))
    axis = axis_of(address, system=draw(st.sampled_from([1, 2])), kind=kind, returns=returns)
    options: dict[str, object] = {}
    if definition is LINUXCNC:
        options = {
            "comp_file_type": draw(st.sampled_from(["0", "1"])),
            "units": draw(st.sampled_from(["mm", "inch"])),
        }
    capacity = control_format(definition, options).capacity(axis)
    count = draw(st.integers(2, 12))
    start = draw(st.integers(-(10**9), 10**9))
    if capacity.spacing == "equidistant":
        step = draw(st.integers(1, 10**8))
        places = [start + i * step for i in range(count)]
    else:
        places = list(
            np.cumsum(
                [
                    start,
                    *draw(st.lists(st.integers(1, 10**9), min_size=count - 1, max_size=count - 1)),
                ]
            )
        )
    positive = draw(st.lists(COUNTS, min_size=count, max_size=count))
    negative = (
        draw(st.lists(COUNTS, min_size=count, max_size=count)) if capacity.curves == 2 else positive
    )
    backlash = draw(COUNTS) * capacity.backlash_quantum if capacity.backlash_quantum else 0.0
    compensation = AxisCompensation(
        address=address,
        kind=kind,
        positions=np.array(places, dtype=np.float64) * capacity.position_quantum,
        positive=np.array(positive, dtype=np.float64) * capacity.quantum,
        negative=np.array(negative, dtype=np.float64) * capacity.quantum,
        backlash=backlash,
        reference_return=returns,
        below=capacity.below,
        above=capacity.above,
    )
    return compensation, axis, options


@pytest.mark.parametrize("name", INDEXED_AND_ROWS)
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_written_and_read_back_the_same(name: str, data: st.DataObject) -> None:
    definition = DEFINITIONS[name]
    compensation, axis, options = data.draw(tables(definition))
    files = control_format(definition, options).write([compensation], [axis])
    assert files == control_format(definition, options).write([compensation], [axis])
    again = control_format(definition, options).read(files, [axis]).axes[axis.address]
    capacity = control_format(definition, options).capacity(axis)
    # a thousandth of the quantum: what double precision leaves of 1 000 mm in steps of 1e-7 mm
    np.testing.assert_allclose(
        again.positions, compensation.positions, rtol=0, atol=1e-3 * capacity.position_quantum
    )
    for direction in Direction:
        np.testing.assert_allclose(
            again.curve(direction),
            compensation.curve(direction),
            rtol=0,
            atol=1e-3 * capacity.quantum,
        )
    assert again.backlash == pytest.approx(compensation.backlash, abs=1e-9)
    assert (again.kind, again.below, again.above, again.reference_return) == (
        compensation.kind,
        compensation.below,
        compensation.above,
        compensation.reference_return,
    )
    # what was read is exactly what the files can say: writing it again gives the same bytes
    assert control_format(definition, options).write([again], [axis]) == files


def sample(name: str) -> list[ControlFile]:
    return [
        ControlFile(file, text.encode()) for file, text in DEFINITIONS[name].sample_files.items()
    ]


@pytest.mark.parametrize("name", INDEXED_AND_ROWS)
@given(data=st.data())
@settings(deadline=None, max_examples=100)
def test_a_damaged_file_is_refused_or_read_never_worse(name: str, data: st.DataObject) -> None:
    files = sample(name)
    which = data.draw(st.integers(0, len(files) - 1))
    content = files[which].content
    for _ in range(data.draw(st.integers(1, 3))):
        place = data.draw(st.integers(0, len(content)))
        length = data.draw(st.integers(0, 12))
        piece = data.draw(
            st.one_of(
                st.binary(max_size=6),
                st.sampled_from([b"\n", b";", b",", b"=", b"[", b"]", b" ", b"#", b"$AA_ENC_COMP"]),
            )
        )
        content = content[:place] + piece + content[place + length :]
    files[which] = ControlFile(files[which].name, content)
    try:
        state = control_format(DEFINITIONS[name], {}).read(files)
    except (InputError, UsageError):  # refused, or asked whether all of it was carried out
        return
    for axis in state.axes.values():
        assert axis.positions.shape == axis.positive.shape == axis.negative.shape
        assert np.all(np.isfinite(axis.positive))
        assert np.all(np.diff(axis.positions) > 0)


@pytest.mark.parametrize("name", INDEXED_AND_ROWS)
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_a_lost_or_repeated_line_never_gives_another_table(name: str, data: st.DataObject) -> None:
    """Values by index notice every lost line; rows by position cannot (a row fewer is a table too),
    so only its keys are tried.
    """
    files = sample(name)
    which = 0 if name == "siemens-840d-sl" else 1
    lines = files[which].content.splitlines(keepends=True)
    place = data.draw(st.integers(0, len(lines) - 1))
    changed = (
        lines[:place] + lines[place + 1 :]
        if data.draw(st.booleans())
        else [*lines[: place + 1], *lines[place:]]
    )
    right = next(iter(control_format(DEFINITIONS[name], {}).read(sample(name)).axes.values()))
    files[which] = ControlFile(files[which].name, b"".join(changed))
    try:
        state = control_format(DEFINITIONS[name], {}).read(files)
    except InputError:
        return
    for axis in state.axes.values():
        if axis.positions.size:
            np.testing.assert_array_equal(axis.positions, right.positions)
            np.testing.assert_array_equal(axis.positive, right.positive)
        else:
            assert (
                name == "linuxcnc"
            )  # without COMP_FILE or its section the control has no table, and none is read


@given(
    content=st.binary(max_size=300), name=st.sampled_from(["a.ini", "joint_0.comp", "X_EEC.INI"])
)
@settings(deadline=None, max_examples=100)
def test_any_bytes(content: bytes, name: str) -> None:
    for definition in DEFINITIONS.values():
        try:
            control_format(definition, {}).read([ControlFile(name, content)])
        except InputError:
            continue


@given(text=st.text(alphabet="0123456789.-+eE \n\t", max_size=120))
@settings(deadline=None, max_examples=100)
def test_any_rows_of_numbers(text: str) -> None:
    try:
        state = control_format(LINUXCNC, {}).read([ControlFile("joint_0.comp", text.encode())])
    except InputError:
        return
    rows = [[float(piece) for piece in line.split()[:3]] for line in text.rstrip().split("\n")]
    np.testing.assert_allclose(
        state.axes["0"].positions, [row[0] for row in rows], rtol=1e-15, atol=1e-12
    )
    np.testing.assert_allclose(
        state.axes["0"].positive, [row[0] - row[1] for row in rows], rtol=0, atol=1e-9
    )
    np.testing.assert_allclose(
        state.axes["0"].negative, [row[0] - row[2] for row in rows], rtol=0, atol=1e-9
    )


@pytest.mark.parametrize("name", list(CONTENT))
@given(data=st.data())
@settings(deadline=None, max_examples=20)
def test_a_damaged_definition_is_refused_or_read(name: str, data: st.DataObject) -> None:
    lines = CONTENT[name].splitlines(keepends=True)
    place = data.draw(st.integers(0, len(lines) - 1))
    words = [
        b"",
        b"x: 1\n",
        b"  - 3\n",
        b"\n",
        b"null\n",
        b"  evidence: {state: confirmed, source: 1}\n",
        lines[place].replace(b": ", b": [", 1),
    ]
    lines[place] = data.draw(st.sampled_from(words))
    try:
        definition = load_definition(b"".join(lines), name, found_in(CONTENT))
    except InputError:
        return
    assert definition.id
