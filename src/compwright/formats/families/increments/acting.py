"""What else acts on an axis of a FANUC, or points to the numbers that its table uses, and what its
files say of unit and kind.

Whatever acts and is not counted refuses the axis with the parameter by name; what acts on other
axes only keeps its point numbers. Sources: ``increments_parameters`` and docs/controllers/fanuc.md.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from typing import Literal

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import Parameters, Value
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind

#: Largest setting of 1820 whose coding is known: 2 x CMR for a CMR of 1 to 48.
_LARGEST_MULTIPLIER = 96


def refusals(parameters: Parameters, address: str, label: str) -> Iterator[Fault]:
    """Yield what acts on the axis beside its table and backlash and is not counted: each by its
    parameter.
    """
    for value in _once(_acting(parameters, address)):
        yield value.fault(
            f"{label}: {_NAMES[_kind_of(value.number)]}",
            "0: this acts on the axis and is not counted here",
        )


_NAMES = {
    "totals": "the pitch data may be totals instead of increments",
    "inclination": "inclination compensation acts beside the pitch data",
    "cyclic": "the second (cyclic) pitch error compensation acts beside the pitch data",
    "straightness": "straightness compensation acts between this axis and another",
    "spatial": "three-dimensional error compensation acts on the axis",
    "smooth": "smooth backlash compensation divides 1851 into stages",
}


def _kind_of(number: int) -> str:
    groups = {
        "totals": (known.TOTALS,),
        "inclination": known.INCLINATION_AMOUNTS,
        "cyclic": range(known.CYCLIC_FIRST, known.CYCLIC_INTERVAL + 1),
        "spatial": known.SPATIAL,
        "smooth": known.SMOOTH_BACKLASH,
    }
    return next((name for name, numbers in groups.items() if number in numbers), "straightness")


def _acting(parameters: Parameters, address: str) -> Iterator[Value]:
    for number in (known.TOTALS, *known.INCLINATION_AMOUNTS, *known.SMOOTH_BACKLASH):
        value = parameters.axis(number, address)
        if value is not None and value.acts:
            yield value
    cyclic = [
        parameters.axis(number, address)
        for number in range(known.CYCLIC_FIRST, known.CYCLIC_INTERVAL + 1)
    ]
    yield from (value for value in cyclic if value is not None and value.acts)
    for value in parameters.of(
        (*known.STRAIGHTNESS_MOVING, *known.STRAIGHTNESS_BENT, *known.SPATIAL)
    ):
        if value.acts and parameters.names(value, address):
            yield value
    # Which axes the further pairs mean is not known: they may mean this one.
    yield from (value for value in parameters.of(known.STRAIGHTNESS_MORE) if value.acts)


def _once(values: Iterator[Value]) -> list[Value]:
    """Return the first value of each kind: one reason by name is enough."""
    return list({_kind_of(value.number): value for value in reversed(list(values))}.values())[::-1]


def pointed_numbers(parameters: Parameters) -> frozenset[int]:
    """Return the point numbers to which inclination, straightness and cyclic compensation of any
    axis point.
    """
    values = parameters.of((*known.INCLINATION_POINTS, *known.STRAIGHTNESS_POINTS))
    numbers = {value.whole for value in values if value.acts}
    for first in parameters.of([known.CYCLIC_FIRST]):
        last = parameters.axis(known.CYCLIC_LAST, str(first.index))
        if last is not None and first.acts | last.acts:
            numbers.update(range(first.whole, min(last.whole, first.whole + 10_000) + 1))
    return frozenset(numbers)


def meets(parameters: Parameters, address: str, label: str, numbers: range) -> Iterator[Fault]:
    """Yield a fault for what uses the axis' own numbers beside it: straightness, another axis'
    inclination or cyclic table.
    """
    straight = any(value.acts for value in parameters.of(known.STRAIGHTNESS_MOVING))
    points = [
        value for value in parameters.of(known.STRAIGHTNESS_POINTS) if straight and value.acts
    ]
    points += [
        value
        for value in parameters.of(known.INCLINATION_POINTS)
        if value.acts and str(value.index) != address
    ]
    for first in parameters.of([known.CYCLIC_FIRST]):
        last = parameters.axis(known.CYCLIC_LAST, str(first.index))
        if (
            first.acts
            and last is not None
            and str(first.index) != address
            and set(range(first.whole, last.whole + 1)) & set(numbers)
        ):
            points.append(first)
    for value in points:
        if value.number == known.CYCLIC_FIRST or value.whole in numbers:
            yield value.fault(
                f"{label}: another function uses its point numbers {numbers.start} to"
                f" {numbers.stop - 1}",
                "numbers of its own",
            )
            return


def remarks(parameters: Parameters, address: str, label: str) -> Iterator[str]:
    """Yield what is in use on the axis and left as it is, because its meaning is not confirmed."""
    bits = parameters.axis(known.PITCH_BITS, address)
    if bits is not None and any(bits.bit(bit) for bit in range(1, 8)):
        names = ", ".join(f"3605#{bit}" for bit in range(1, 8) if bits.bit(bit))
        yield (
            f"{label}: {names} = 1 ({bits.text}): in use on real machines, meaning not confirmed"
            " (perhaps interpolated compensation: then give the option output: ramp); it is left"
            " as it is"
        )


@dataclass(frozen=True, slots=True)
class DetectionUnit:
    """Detection unit in mm or deg, and the parameters that say it."""

    size: float
    evidence: str


def detection_unit(parameters: Parameters, address: str, kind: AxisKind) -> DetectionUnit | None:
    """Return the least command increment / CMR; None where the files do not say it, or in a way
    that is not known.

    1820 = 2 x CMR for a CMR of 1 and more (B-63943EN-1/02 page 109). The least command increment is
    0.001 mm or deg by IS-B (0.01 by IS-A, 0.0001 by IS-C), a tenth of that in inches on an inch
    machine (1001#0). 1013 by axis says the system, on older series 1004. What diameter programming
    (1006#3) makes of it is not known.
    """
    multiplier, bits = (
        parameters.axis(known.MULTIPLIER, address),
        parameters.axis(known.KIND, address),
    )
    system = parameters.axis(known.SYSTEM, address) or parameters.axis(
        known.SYSTEM_OF_MACHINE, address
    )
    if multiplier is None or system is None or not 2 <= multiplier.whole <= _LARGEST_MULTIPLIER:
        return None
    if kind is AxisKind.LINEAR and bits is not None and bits.bit(3):
        return None
    power = _power(system)
    if power is None:
        return None
    least = Decimal(1).scaleb(power)
    unit = kind.unit
    machine = parameters.axis(known.INCH, address)
    inch = kind is AxisKind.LINEAR and machine is not None and machine.bit(0)
    if inch:
        least *= Decimal("2.54")
    factor = Decimal(multiplier.whole) / 2
    size = least / factor
    evidence = (
        f"1820 = {multiplier.text} (CMR {factor.normalize():f}) and {system.number} = {system.text}"
        f" (least command increment {least.normalize():f}"
        f" {unit}{', inch machine by 1001#0' if inch else ''})"
    )
    return DetectionUnit(float(size), evidence)


def _power(system: Value) -> int | None:
    """Return the power of ten of the least command increment by 1013 or 1004; None for a system
    that no page at hand explains.
    """
    said = tuple(bit for bit in range(4 if system.number == known.SYSTEM else 2) if system.bit(bit))
    return {(): -3, (0,): -2, (1,): -4}.get(said)


def unread_unit(parameters: Parameters, address: str) -> Value | None:
    """Return the parameter because of which the files do not tell the detection unit although they
    hold its coding.
    """
    multiplier = parameters.axis(known.MULTIPLIER, address)
    system = parameters.axis(known.SYSTEM, address) or parameters.axis(
        known.SYSTEM_OF_MACHINE, address
    )
    if system is not None and _power(system) is None:
        return system
    if multiplier is not None and not 2 <= multiplier.whole <= _LARGEST_MULTIPLIER:
        return multiplier
    bits = parameters.axis(known.KIND, address)
    return (
        bits
        if bits is not None and bits.bit(3) and multiplier is not None and system is not None
        else None
    )


def two_systems(parameters: Parameters, address: str) -> str:
    """Return in words that 1013 and 1004 name different increment systems; empty where they do not.
    1013 is the one that counts.
    """
    own, older = (
        parameters.axis(known.SYSTEM, address),
        parameters.axis(known.SYSTEM_OF_MACHINE, address),
    )
    if (
        own is None
        or older is None
        or _power(own) == _power(older)
        or not any(older.bit(bit) for bit in (0, 1))
    ):
        return ""
    return (
        f"1004 = {older.text} names another increment system than 1013 = {own.text}; 1013 is"
        " counted (1004 is that of older series)"
    )


Wraps = Literal["yes", "no"]


def wraps(parameters: Parameters, address: str) -> Wraps | None:
    """Return whether a rotary axis is endless: 1006#0 = 1 with 1006#1 = 0; None where 1006 is not
    in the files or it is linear.
    """
    bits = parameters.axis(known.KIND, address)
    if bits is None or not bits.bit(0):
        return None
    return "no" if bits.bit(1) else "yes"


def unclear_path(
    parameters: Parameters, address: str, label: str, kind: AxisKind
) -> Iterator[Fault]:
    """Yield a fault for each parameter of a path that the axis' table hangs on, where the paths
    differ and 981 is in no file.

    Inches (1001#0) decide lengths and detection unit of a linear axis, the increment system (1004)
    that of an axis without 1013; 1800#4 decides whether 1852 acts, where that is in the files.
    """
    asked: list[tuple[int, tuple[int, ...]]] = []
    if kind is AxisKind.LINEAR:
        asked.append((known.INCH, (0,)))
    if parameters.axis(known.BACKLASH_RAPID, address) is not None:
        asked.append((known.BACKLASH_BITS, (4,)))
    if parameters.axis(known.SYSTEM, address) is None:
        asked.append((known.SYSTEM_OF_MACHINE, (0, 1)))
    asked.append((known.TOTALS, tuple(range(8))))
    for number, bits in asked:
        rivals = parameters.rivals(number, bits, address)
        if rivals:
            odd = [bit for bit in bits if len({value.bit(bit) for value in rivals}) > 1]
            told = "; ".join(
                ", ".join(f"{number}#{bit} = {int(value.bit(bit))}" for bit in odd)
                + f" of path {value.index}"
                for value in rivals
            )
            message = (
                f"{label}: the paths differ ({told}), and no file says to which of them the axis"
                " belongs (parameter 981)"
            )
            yield rivals[-1].fault(
                message, f"the line of parameter 981 of axis {address} among the files"
            )
