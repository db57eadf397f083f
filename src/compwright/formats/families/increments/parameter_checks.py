"""Checks of the parameters of a FANUC axis on which the meaning of its table depends.

Functions of the axis that stay active in addition to its table are in `neighbour_functions`.
Functions of other axes only need point numbers that stay reserved for them. Sources: `parameters`
and docs/controllers/fanuc.md.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import (
    AxisParameters,
    Parameters,
)
from compwright.formats.text.notes import ADD_FILE, Notes
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind


def refusals(own: AxisParameters) -> Iterator[Fault]:
    """Yield a fault for each of an axis' parameters ``own`` that makes the meaning of its table
    data uncertain.
    """
    totals = own.get(known.TOTALS)
    if totals is not None and totals.nonzero:
        yield totals.fault(
            f"{own.label}: the pitch data may be totals instead of increments",
            "0 (increments): how the control counts totals is unknown",
            "leave the axis out of the job; never change 3602 for this",
        )


def pointed_numbers(parameters: Parameters) -> frozenset[int]:
    """Return the point numbers to which inclination, straightness and cyclic compensation refer."""
    numbers = (*known.INCLINATION_POINTS, *known.STRAIGHTNESS_POINTS, *known.STRAIGHTNESS_MORE)
    values = parameters.of(numbers)
    cyclic = (number for _, numbers in parameters.second_tables for number in numbers)
    return frozenset((*(value.whole for value in values if value.nonzero), *cyclic))


def meets(own: AxisParameters, numbers: range) -> Iterator[Fault]:
    """Yield a fault if a second (cyclic) table uses the axis' own point ``numbers``.

    Both tables would then use the same data. Inclination and straightness compensation are no such
    fault: they only refer to sections by their numbers.
    """
    users = (
        value for value, others in own.all.second_tables if not set(numbers).isdisjoint(others)
    )
    for value in islice(users, 1):
        yield value.fault(
            f"{own.label}: another function uses its point numbers {numbers.start} to"
            f" {numbers.stop - 1}",
            "point numbers that only this table uses",
        )


def note_unconfirmed_bits(own: AxisParameters, notes: Notes) -> None:
    """Report bits of 3605 that are set in an axis' parameters ``own`` and stay unchanged; their
    meaning is not confirmed.
    """
    bits = own.get(known.PITCH_BITS)
    names = [] if bits is None else [f"3605#{bit}" for bit in range(1, 8) if bits.bit(bit)]
    if bits is not None and names:
        notes.find("CW-S040", "warning", label=own.label, bits=names, value=bits.text)


def _deciding_bits(own: AxisParameters, kind: AxisKind) -> dict[int, tuple[int, ...]]:
    """Return the bits, by parameter, on which the meaning of the axis' table data depends."""
    return {
        known.INCH: (0,) if kind is AxisKind.LINEAR else (),
        known.BACKLASH_BITS: () if own.get(known.BACKLASH_RAPID) is None else (4,),
        known.SYSTEM: (0, 1, 2, 3),
        known.SYSTEM_OF_MACHINE: (0, 1) if own.get(known.SYSTEM) is None else (),
    }


def unread_bits(own: AxisParameters, kind: AxisKind) -> Iterator[Fault]:
    """Yield a fault for each bit parameter of the table, in an axis' parameters ``own``, that is
    not written as eight bits.
    """
    for number, bits in _deciding_bits(own, kind).items():
        value = own.get(number)
        if bits and value is not None and value.nonzero and not value.is_bits:
            names = ", ".join(f"{number}#{bit}" for bit in bits)
            yield value.fault(
                f"{own.label}: {names} cannot be read",
                "eight binary digits",
                "export the parameters from the control again",
            )


def unclear_path(own: AxisParameters, kind: AxisKind) -> Iterator[Fault]:
    """Yield a fault for each of an axis' parameters ``own`` that differs between paths, if the
    axis' path is unknown.

    The path is unknown if parameter 981 is in no file. Three parameters are checked:

    - 1001#0 (inches) decides lengths and detection unit of a linear axis.
    - 1004 decides the increment system of an axis without 1013.
    - 1800#4 decides whether 1852 is active, if 1852 is in the files.
    """
    for number, bits in {**_deciding_bits(own, kind), known.TOTALS: tuple(range(8))}.items():
        rivals = own.rivals(number, bits)
        odd = [bit for bit in bits if len({value.bit(bit) for value in rivals}) > 1]
        described = "; ".join(
            ", ".join(f"{number}#{bit} = {int(value.bit(bit))}" for bit in odd)
            + f" of path {value.index}"
            for value in rivals
        )
        for value in rivals[-1:]:
            yield value.fault(
                f"{own.label}: the paths differ ({described}), and no file says to which of them"
                " the axis belongs (parameter 981)",
                f"the line of parameter 981 of axis {own.address} among the files",
                ADD_FILE,
            )
