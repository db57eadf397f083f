"""Find the axes of a FANUC that move together, by its parameters.

These parameters state it; the definition gives the evidence of each:

- 8311: number of the master axis in axis synchronous control, simple synchronous control and twin
  table.
- 1817#6: tandem control; the master has the odd servo number (1023).
- 8180, 8183 and 8186: number of the other axis in synchronous, composite and superimposed control
  of several paths.
- 5660 to 5667: axis numbers in flexible synchronous control.
- 8200#0 with 8211 and 8212: angular axis control, with the numbers of its axes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from compwright.formats.families.coupled_axes import Coupling, CouplingParameter
from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import (
    AxisParameters,
    Parameters,
    ParameterValue,
)

_TANDEM_BIT, _ANGULAR_BIT = 6, 0
#: 8312 from here on: the slave moves against the master.
_MIRRORED = 100
#: Numbers from here on are a path and the axis in it: 201 is the first axis of path 2.
_BY_PATH = 100
_NO_AXIS = "a parameter couples axes by a number that names no axis of the files"
_NO_BITS = "a parameter that may couple it with another axis is not written as eight bits"
_UNLIKE = {
    known.COMPOSITE: "composite control exchanges it with another axis",
    known.SUPERIMPOSED: "superimposed control adds the motion of another axis to it",
}


def couplings_of(parameters: Parameters, addresses: Sequence[str]) -> tuple[Coupling, ...]:
    """Return the couplings of the axes that move together, as the parameters state them.

    ``addresses``: the axis numbers in the control's files. If a parameter states a number that is
    none of these, it may mean any axis. Then no axis is compensated.
    """
    every = [one for values in parameters.values.values() for one in values if one.owner == "A"]
    known = list(dict.fromkeys((*addresses, *(str(one.index) for one in every))))
    return (
        *_mastered(parameters, known),
        *_tandem(parameters, known),
        *_flexible(parameters, known),
        *_angular(parameters, known),
    )


def _mastered(parameters: Parameters, addresses: Sequence[str]) -> Iterator[Coupling]:
    """Yield the couplings by 8311, 8180, 8183 and 8186, whose value is the number of the master
    axis.
    """
    for value in parameters.of(known.MASTERS):
        own_number = value.owner == "A" and value.whole in (0, value.index)
        if not value.nonzero or own_number:
            continue
        if value.owner != "A":
            yield from _every(addresses, value, _NO_AXIS, switched=True)
            continue
        leads = _masters(parameters, value, addresses)
        own = AxisParameters(parameters, str(value.index))
        mirror = own.get(known.MIRRORED) if value.number == known.SYNCHRONOUS else None
        unlike = _UNLIKE.get(value.number, "")
        if mirror is not None and mirror.whole >= _MIRRORED:
            unlike = f"synchronous control moves both axes against each other ({mirror.label})"
        if not leads:
            leads, unlike = _others(addresses, value), _NO_AXIS
        yield _parameter(value).coupling(leads, str(value.index), switched=True, unlike=unlike)


def _every(
    addresses: Sequence[str], value: ParameterValue, unlike: str, *, switched: bool = False
) -> Iterator[Coupling]:
    """Yield a possible coupling of each axis by the parameter ``value``, which does not name the
    axes that it couples. ``unlike``, ``switched``: see `Coupling`.
    """
    for each in addresses:
        yield _parameter(value).coupling((), each, switched=switched, unlike=unlike)


def _others(addresses: Sequence[str], value: ParameterValue) -> tuple[str, ...]:
    return tuple(one for one in addresses if one != str(value.index))


def _masters(
    parameters: Parameters, value: ParameterValue, addresses: Sequence[str]
) -> tuple[str, ...]:
    """Return the axes that a master axis number possibly means, because it is counted by machine or
    within a path.
    """
    number = value.whole
    path = AxisParameters(parameters, str(value.index)).path
    if number >= _BY_PATH:
        path, number = divmod(number, _BY_PATH)
    held = parameters.by_owner(known.PATH_OF_AXIS)
    mates = sorted(index for (_, index), one in held.items() if path and one.whole == path)
    found = [*mates[number - 1 : number]] if number > 0 else []
    if value.whole < _BY_PATH:
        found.insert(0, number)
    others = (str(one) for one in found if one != value.index)
    return tuple(dict.fromkeys(one for one in others if one in addresses))


def _tandem(parameters: Parameters, addresses: Sequence[str]) -> Iterator[Coupling]:
    """Yield the tandem axes by 1817#6: the master has an odd servo number, and its slave the next
    one.
    """
    bits: dict[int, ParameterValue] = {}
    for value in parameters.of([known.TANDEM]):
        if value.nonzero and not value.is_bits:
            yield from _every(addresses, value, _NO_BITS)
        elif value.bit(_TANDEM_BIT) and value.owner != "A":
            yield from _every(addresses, value, _NO_AXIS)
        elif value.bit(_TANDEM_BIT):
            bits[value.index] = value
    servo = {
        index: one.whole
        for (owner, index), one in parameters.by_owner(known.SERVO_NUMBER).items()
        if owner == "A"
    }
    by_servo = {number: index for index, number in servo.items() if index in bits and number > 0}
    for index, value in bits.items():
        number = servo.get(index, 0)
        partner = by_servo.get(number + 1 if number % 2 else number - 1)
        if partner is None:
            yield _parameter(value).coupling(_others(addresses, value), str(index), unlike=_NO_AXIS)
        elif number % 2 == 0:
            yield _parameter(value).coupling((str(partner),), str(index))


def _flexible(parameters: Parameters, addresses: Sequence[str]) -> Iterator[Coupling]:
    """Yield the masters and slaves in parameters 5660 to 5667; the slave follows at a ratio."""
    unlike = "flexible synchronous control moves it in a ratio with another axis"
    for master_number, slave_number in zip(known.FLEXIBLE[::2], known.FLEXIBLE[1::2], strict=True):
        for whose, slave in parameters.by_owner(slave_number).items():
            master = parameters.by_owner(master_number).get(whose)
            if master is None or not (master.nonzero and slave.nonzero):
                continue
            leads, follows = (_named(parameters, one, addresses) for one in (master, slave))
            if not (leads and follows):
                yield from _every(addresses, slave, _NO_AXIS, switched=True)
            for each in follows:
                yield _parameter(slave).coupling(leads, each, switched=True, unlike=unlike)


def _angular(parameters: Parameters, addresses: Sequence[str]) -> Iterator[Coupling]:
    """Yield the axes of angular axis control: the axes named by 8211 and 8212, or every linear axis
    if these name none.
    """
    unlike = "angular axis control moves it together with another axis"
    for value in parameters.of([known.ANGULAR]):
        if value.nonzero and not value.is_bits:
            yield from _every(addresses, value, _NO_BITS)
        if not value.bit(_ANGULAR_BIT):
            continue
        pair = [parameters.by_owner(number).get(value.whose) for number in known.ANGULAR_AXES]
        named = [
            _named(parameters, one, addresses) for one in pair if one is not None and one.nonzero
        ]
        concerned = [one for found in named for one in found]
        if len(named) < len(pair) or not all(named):
            all_axes = (AxisParameters(parameters, each) for each in addresses)
            linear = (own for own in all_axes if not own.bit(known.KIND, 0))
            concerned = [own.address for own in linear if own.get(known.ANGULAR) is value]
        for each in dict.fromkeys(concerned):
            yield _parameter(value).coupling((), each, unlike=unlike)


def _named(
    parameters: Parameters, value: ParameterValue, addresses: Sequence[str]
) -> tuple[str, ...]:
    """Return the axes that an axis number (``value``) possibly means, because it is counted over
    the machine or within a path.
    """
    return tuple(each for each in addresses if AxisParameters(parameters, each).named_by(value))


def _parameter(value: ParameterValue) -> CouplingParameter:
    return CouplingParameter(value.label, value.file, value.line)
