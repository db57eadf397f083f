"""Check a definition: read its sample, compare its hand-worked examples, and check that tables
beyond its limits are refused.

Files that are written from the sample are read back too, and must give the same tables.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.card import card_steps
from compwright.formats.definition.schema import Definition, Expectation
from compwright.formats.families.card_texts import UNKNOWN, CardRequest
from compwright.formats.families.family import Family
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError, CompwrightError, Fault
from compwright.foundations.units import TO_INSIDE
from compwright.records.axis import Axis, Direction, Encoder, FloatArray
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

#: Hand-worked corrections and decoded ones agree to this many µm or arcsec: far below every quantum
#: in use (0.0001 µm), far above the rounding of double precision.
AGREEMENT = 1e-6


def check_definition(definition: Definition) -> tuple[Fault, ...]:
    """Return the faults of a definition, such as a sample that cannot be read, corrections other
    than the hand-worked ones, or a limit that writing ignores.

    The keys of the definition were checked when it was loaded. These conditions are checked here:

    - There are hand-worked examples, they show more than zeros at table points, and each of them is
      met.
    - The sample can be read.
    - Its tables can be written, give the same bytes twice, and are read back as the same numbers.
    - A table beyond any limit is refused.
    - The card has all its fields.
    """
    faults: list[Fault] = []
    shown: list[AxisCompensation] = []
    for index, expectation in enumerate(definition.expect):
        try:
            shown.append(read_expectation(definition, expectation))
            faults += disagreements(
                definition,
                index,
                shown[-1].at,
                "the correction at {} is not the one worked by hand",
            )
        except CompwrightError as error:
            place = f"expect, {expectation.name}"
            faults += (
                definition.text.fault(("expect", index), str(fault), place=place)
                for fault in error.faults
            )
    if len(shown) == len(definition.expect):
        faults += (
            definition.text.fault(("expect",), what) for what in _unproven(definition, shown)
        )
    try:
        faults.extend(_round_trip(definition))
    except CompwrightError as error:
        faults += (definition.text.fault(("sample",), str(fault)) for fault in error.faults)
    return tuple(faults)


def disagreements(
    definition: Definition,
    index: int,
    correction: Callable[[FloatArray, Direction], FloatArray],
    says: str,
) -> Iterator[Fault]:
    """Yield a fault for each correction in the hand-worked example number ``index`` that differs
    from ``correction``, a function that computes it, in mm or deg. ``says``: the message, with {}
    in place of position and direction.

    The arguments of ``correction`` are positions, mm or deg, and the direction in which they are
    approached.
    """
    expectation = definition.expect[index]
    for row, direction, expected, found in _worked_by_hand(expectation, correction):
        if not abs(found - expected) <= AGREEMENT:
            yield definition.text.fault(
                ("expect", index, "at", row),
                says.format(f"{expectation.at[row].position:g} arriving in {direction.value}"),
                expected=f"{expected:g} {expectation.unit}",
                found=f"{found:.9g} {expectation.unit}",
                place=f"expect, {expectation.name}",
                hint="check sign and unit in the definition against the manual of the control",
            )


def _worked_by_hand(
    expectation: Expectation, correction: Callable[[FloatArray, Direction], FloatArray]
) -> Iterator[tuple[int, Direction, float, float]]:
    """Yield each hand-worked correction: the row of its position, the direction, the expected
    value, and the computed value.
    """
    factor = TO_INSIDE[expectation.unit][1]
    for row, point in enumerate(expectation.at):
        for direction, expected in (
            (Direction.POSITIVE, point.positive),
            (Direction.NEGATIVE, point.negative),
        ):
            found = float(correction(np.array([point.position]), direction)[0]) / factor
            yield row, direction, expected, found


def largest_difference(
    expectation: Expectation, correction: Callable[[FloatArray, Direction], FloatArray]
) -> float:
    """Return the largest difference between ``correction`` and the hand-worked values, in their
    unit.
    """
    pairs = _worked_by_hand(expectation, correction)
    return max(abs(found - expected) for _, _, expected, found in pairs)


def _files(texts: Mapping[str, str]) -> list[ControlFile]:
    return [ControlFile(name, text.encode("utf-8")) for name, text in texts.items()]


def read_expectation(definition: Definition, expectation: Expectation) -> AxisCompensation:
    """Return the compensation that is read from the files of a hand-worked example."""
    axis = Axis(
        name=expectation.axis,
        kind=expectation.kind,
        travel=(0.0, 1.0),
        address=expectation.axis,
        reference_return=expectation.reference_return,
        encoder=Encoder(system=_system(definition, expectation)),
    )
    state = control_format(definition, expectation.options).read(_files(expectation.files), [axis])
    return next(iter(state.axes.values()))


def _unproven(definition: Definition, shown: Sequence[AxisCompensation]) -> Iterator[str]:
    """Yield as texts the properties of the control's tables, such as sign or backlash, that no
    hand-worked example tests. ``shown``: the compensation read from each example's files.

    Examples with zeros only do not test the sign. Examples at table points only do not test the
    correction between and beyond the points. Examples with the same correction in both directions
    do not test the backlash.
    """
    pairs = [
        (compensation, point)
        for compensation, expectation in zip(shown, definition.expect, strict=True)
        for point in expectation.at
    ]
    if not pairs:
        yield "there is no hand-worked expectation: files, and what the control does with them"
        return
    if not any(point.positive or point.negative for _, point in pairs):
        yield "nothing but zeros is worked by hand: this shows no sign"
    if all(point.position in table.positions for table, point in pairs):
        yield "only table points are worked by hand: add a position between two, or beyond the ends"
    two = definition.layout.pairing == "two_columns" or "backlash" in definition.bindings
    if two and all(point.positive == point.negative for _, point in pairs):
        yield "no position is worked by hand at which the two directions differ"


def _system(definition: Definition, expectation: Expectation) -> int:
    control = control_format(definition, expectation.options)
    state = control.read(_files(expectation.files), address=expectation.axis)
    return next(iter(state.facts.values())).encoder_system or 1


def _round_trip(definition: Definition) -> Iterator[Fault]:
    control = control_format(definition, definition.sample_options)
    state = control.read(_files(definition.sample_files))
    compensations = [
        compensation for compensation in state.axes.values() if compensation.positions.size >= 2
    ]
    axes = [_axis_of(state, compensation) for compensation in compensations]
    own = _files(definition.sample_files) if definition.limit("only_patching") is not None else []
    files = control.write(compensations, axes, own)
    if files != control.write(compensations, axes, own):
        yield definition.text.fault(("sample",), "writing the sample twice gives different bytes")
    again = control.read(files, axes)
    for address, compensation in ((one.address, one) for one in compensations):
        if not same_compensation(compensation, again.axes[address]):
            message = f"axis {address}: what is written is not what was read"
            yield definition.text.fault(("sample",), message)
    for axis, compensation in zip(axes, compensations, strict=True):
        yield from unenforced_limits(control, axis, compensation)
        request = CardRequest(
            axis=axis,
            table=compensation,
            facts=again.facts[axis.address],
            check_at=compensation.positions,
            files=files,
        )
        for step in card_steps(definition, axis, control.card(request).values):
            if UNKNOWN in step.text:
                message = f"the step {step.title!r} uses a field that does not exist"
                yield definition.text.fault(("card",), message, found=step.text)


def _axis_of(state: ControlState, compensation: AxisCompensation) -> Axis:
    return Axis(
        name=compensation.address,
        kind=compensation.kind,
        travel=(float(compensation.positions[0]), float(compensation.positions[-1])),
        address=compensation.address,
        modulo=compensation.period,
        reference_return=compensation.reference_return,
        encoder=Encoder(system=state.facts[compensation.address].encoder_system or 1),
    )


def same_compensation(one: AxisCompensation, other: AxisCompensation) -> bool:
    """Return whether two compensations have exactly the same numbers."""
    return (
        np.array_equal(one.positions, other.positions)
        and np.array_equal(one.positive, other.positive)
        and np.array_equal(one.negative, other.negative)
        and one.backlash == other.backlash
        and (one.kind, one.below, one.above, one.period)
        == (other.kind, other.below, other.above, other.period)
        and (one.interpolation, one.slope, one.origin)
        == (other.interpolation, other.slope, other.origin)
    )


#: Largest table that is tried: some limits are too large to be reached.
_MOST_POINTS = 20_000


def unenforced_limits(
    control: Family, axis: Axis, compensation: AxisCompensation
) -> Iterator[Fault]:
    """Yield a fault for every limit of the definition if a table beyond the limit is written, or
    refused for another reason.
    """
    capacity = control.capacity(axis)
    for name, broken, its_axis in _broken(control.definition, axis, compensation, capacity):
        try:
            control.write([broken], [its_axis])
        except CapacityError:
            continue
        except CompwrightError as error:
            message = f"the limit {name} is refused in the wrong way: {error}"
            yield control.definition.text.fault(("limits",), message)
            continue
        message = f"a table that breaks the limit {name} is written all the same"
        yield control.definition.text.fault(("limits",), message)


def _broken(
    definition: Definition, axis: Axis, table: AxisCompensation, capacity: Capacity
) -> Iterator[tuple[str, AxisCompensation, Axis]]:
    for name, broken in _beyond(axis, table, capacity):
        yield name, broken, axis
    step = float(np.min(np.diff(table.positions)))
    feed, per_spacing = (
        definition.limit_number("feed_per_spacing"),
        definition.limit_number("spacing_per_step"),
    )
    if feed is not None and "max_feed" in definition.options:
        yield (
            "feed_per_spacing",
            table,
            replace(axis, options={**axis.options, "max_feed": 2.0 * feed * step}),
        )
    if per_spacing is not None:
        yield (
            "spacing_per_step",
            _with_value(
                table, 0, float(np.round(2.0 * step / per_spacing, 3)) + float(table.positive[1])
            ),
            axis,
        )
    if definition.limit("no_endless_axis") is not None:
        yield "no_endless_axis", table, replace(axis, modulo=360.0)


def _beyond(
    axis: Axis, table: AxisCompensation, capacity: Capacity
) -> Iterator[tuple[str, AxisCompensation]]:
    point = int(np.argmax(np.abs(table.positions - axis.reference)))
    yield (
        "min_points",
        replace(
            table,
            positions=table.positions[:1],
            positive=table.positive[:1],
            negative=table.negative[:1],
        ),
    )
    yield (
        "resolution of a value",
        _with_value(table, point, float(table.positive[point]) + 0.4 * capacity.quantum),
    )
    for side, bound in zip(("lowest", "highest"), capacity.value_range, strict=True):
        if np.isfinite(bound):
            beyond = bound + np.sign(bound) * capacity.quantum * 10
            yield f"{side} value", _with_value(table, point, float(beyond))
    if capacity.curves == 1:
        yield (
            "one curve for both directions",
            replace(table, negative=table.negative + 10 * capacity.quantum),
        )
    if capacity.backlash_quantum is None:
        yield "no backlash in addition to the table", replace(table, backlash=0.001)
    else:
        beyond = capacity.backlash_range[1] + capacity.backlash_quantum * 10
        yield "backlash range", replace(table, backlash=float(beyond))
        yield (
            "resolution of the backlash",
            replace(table, backlash=table.backlash + 0.4 * capacity.backlash_quantum),
        )
    if capacity.max_points is not None and capacity.max_points < _MOST_POINTS:
        yield "max_points", _longer(table, capacity)
    if capacity.spacing == "equidistant" and table.positions.size > 2:
        moved = table.positions.copy()
        moved[1] += 0.3 * (moved[2] - moved[1])
        yield "equal spacing", replace(table, positions=moved)
    if capacity.lattice is not None:
        largest = capacity.lattice.increments[1] * capacity.lattice.magnifications[-1]
        yield "largest increment", _with_value(table, point, (largest + 1) * capacity.quantum * 10)


def _with_value(table: AxisCompensation, point: int, value: float) -> AxisCompensation:
    def changed(curve: FloatArray) -> FloatArray:
        result = curve.copy()
        result[point] = value
        return result

    return replace(table, positive=changed(table.positive), negative=changed(table.negative))


def _longer(table: AxisCompensation, capacity: Capacity) -> AxisCompensation:
    """Return a table of zeros with more points, at the same spacing, than the control allows."""
    step = float(table.positions[1] - table.positions[0])
    count = int(capacity.max_points or 0) + 2
    positions = table.positions[0] + step * np.arange(count)
    return replace(table, positions=positions, positive=np.zeros(count), negative=np.zeros(count))
