"""The gate over a definition: its sample can be read, hand-worked corrections come out, what is
written is read back.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from compwright.formats.card import card_steps
from compwright.formats.control_format import control_format
from compwright.formats.definition.options import ENCODER_SYSTEM
from compwright.formats.definition.schema import Definition, Expectation
from compwright.formats.families.card_words import UNKNOWN
from compwright.formats.gate.limits import unenforced_limits
from compwright.foundations.errors import CompwrightError, Fault
from compwright.foundations.units import TO_INSIDE
from compwright.records.axis import Axis, Direction, Encoder
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

#: Hand-worked corrections and decoded ones agree to this many µm or arcsec: far below every quantum
#: in use (0.0001 µm), far above the rounding of double precision.
AGREEMENT = 1e-6


def check_definition(definition: Definition) -> tuple[Fault, ...]:
    """Return what a definition gets wrong; nothing when it passes.

    Its keys were checked when it was loaded. Here: each hand-worked expectation holds; the sample
    can be read; its tables can be written, give the same bytes twice and are read back as the same
    numbers; a table beyond any limit is refused; the card knows all its fields.
    """
    faults: list[Fault] = []
    if not definition.expect:
        faults.append(
            Fault(
                message="there is no hand-worked expectation",
                place="expect",
                expected="at least one",
            )
        )
    for expectation in definition.expect:
        try:
            faults.extend(_expectation(definition, expectation))
        except CompwrightError as error:
            faults.extend(
                Fault(message=str(fault), place=f"expect, {expectation.name}")
                for fault in error.faults
            )
    try:
        faults.extend(_round_trip(definition))
    except CompwrightError as error:
        faults.extend(Fault(message=str(fault), place="sample") for fault in error.faults)
    return tuple(fault.in_file(definition.file) for fault in faults)


def _files(texts: Mapping[str, str]) -> list[ControlFile]:
    return [ControlFile(name, text.encode("utf-8")) for name, text in texts.items()]


def _expectation(definition: Definition, expectation: Expectation) -> Iterator[Fault]:
    axis = Axis(
        name=expectation.axis,
        kind=expectation.kind,
        travel=(0.0, 1.0),
        address=expectation.axis,
        reference_return=expectation.reference_return,
        encoder=Encoder(system=_system(definition, expectation)),
    )
    state = control_format(definition, expectation.options).read(_files(expectation.files), [axis])
    compensation = next(iter(state.axes.values()))
    factor = TO_INSIDE[expectation.unit][1]
    for point in expectation.at:
        for direction, expected in (
            (Direction.POSITIVE, point.positive),
            (Direction.NEGATIVE, point.negative),
        ):
            found = float(compensation.at(np.array([point.position]), direction)[0]) / factor
            if not abs(found - expected) <= AGREEMENT:
                yield Fault(
                    message=(
                        f"the correction at {point.position:g} arriving in {direction.value} is not"
                        " the one worked by hand"
                    ),
                    place=f"expect, {expectation.name}",
                    expected=f"{expected:g} {expectation.unit}",
                    found=f"{found:.9g} {expectation.unit}",
                )


def _system(definition: Definition, expectation: Expectation) -> int:
    control = control_format(definition, expectation.options)
    state = control.read(_files(expectation.files), address=expectation.axis)
    return int(next(iter(state.facts.values())).get(ENCODER_SYSTEM, 1))


def _round_trip(definition: Definition) -> Iterator[Fault]:
    control = control_format(definition, definition.sample_options)
    state = control.read(_files(definition.sample_files))
    compensations = [
        compensation for compensation in state.axes.values() if compensation.positions.size >= 2
    ]
    axes = [_axis_of(state, compensation) for compensation in compensations]
    files = control.write(compensations, axes)
    if files != control.write(compensations, axes):
        yield Fault(message="writing the sample twice gives different bytes", place="sample")
    again = control.read(files, axes)
    for address, compensation in ((one.address, one) for one in compensations):
        if not same_compensation(compensation, again.axes[address]):
            yield Fault(
                message=f"axis {address}: what is written is not what was read", place="sample"
            )
    for axis, compensation in zip(axes, compensations, strict=True):
        yield from unenforced_limits(control, axis, compensation)
        values = control.card_values(
            axis, compensation, again.facts[axis.address], compensation.positions
        )
        for step in card_steps(definition, axis, values):
            if UNKNOWN in step.text:
                yield Fault(
                    message=f"the step {step.title!r} uses a field that does not exist",
                    place="card",
                    found=step.text,
                )


def _axis_of(state: ControlState, compensation: AxisCompensation) -> Axis:
    return Axis(
        name=compensation.address,
        kind=compensation.kind,
        travel=(float(compensation.positions[0]), float(compensation.positions[-1])),
        address=compensation.address,
        modulo=compensation.period,
        reference_return=compensation.reference_return,
        encoder=Encoder(system=int(state.facts[compensation.address].get(ENCODER_SYSTEM, 1))),
    )


def same_compensation(one: AxisCompensation, other: AxisCompensation) -> bool:
    """Return whether two compensations are the same numbers, exactly."""
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
