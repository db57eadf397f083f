"""The statements of the job that a virtual control needs in addition to the control's files."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import Assumption

Entry = TypeVar("Entry")


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """What the job states about the axes of a control, by address in any letter case.

    - ``reference_return``: direction in which the reference is approached.
    - ``encoder``: active measuring system, 1 or 2.
    - ``kinds``: linear or rotary.
    - ``modulo``: travel per turn of an endless axis, deg.
    - ``reference``: machine coordinate of the reference position, mm or deg.
    - ``active``: whether tables were active that the files switch off or do not mention; None:
      unknown.
    - ``carried_out``: every assignment of a program was executed.
    - ``options``: the options of the control by name, as in the job. ``axis_options`` override them
      for one axis.
    - ``axes_under_work``: the axes of the job; empty for all axes. Faults of other axes are not
      errors.
    - ``axis_number``: the control's number of an axis, from 1, if the job states it.
    """

    reference_return: Mapping[str, Direction] = field(default_factory=dict)
    encoder: Mapping[str, int] = field(default_factory=dict)
    kinds: Mapping[str, AxisKind] = field(default_factory=dict)
    modulo: Mapping[str, float] = field(default_factory=dict)
    reference: Mapping[str, float] = field(default_factory=dict)
    active: bool | None = None
    carried_out: bool = False
    options: Mapping[str, object] = field(default_factory=dict)
    axis_options: Mapping[str, Mapping[str, object]] = field(default_factory=dict)
    axes_under_work: tuple[str, ...] = ()
    axis_number: Mapping[str, int] = field(default_factory=dict)

    def is_under_work(self, address: str) -> bool:
        """Return whether an axis is part of the job; true for every axis if the job lists none."""
        return not self.axes_under_work or address.casefold() in {
            one.casefold() for one in self.axes_under_work
        }

    def is_active(self, switches: Sequence[float | None]) -> bool:
        """Return whether a table is active by ``switches``, the values of the parameters that
        activate it (None: not in the files). If one is 0 or None, the job's ``active`` decides, if
        the job states it.

        If the job does not state ``active``, the table is active unless one of the values is 0.
        """
        if self.active is not None and any(switch is None or switch == 0.0 for switch in switches):
            return self.active
        return all(switch is None or switch != 0.0 for switch in switches)

    def options_of(self, address: str) -> Mapping[str, object]:
        """Return the options of an axis: the controller's, overridden by those of the axis."""
        return {**self.options, **(by_address(self.axis_options, address) or {})}

    def returning(self, address: str) -> tuple[Direction, Assumption | None]:
        """Return the direction of an axis' reference return (default ``+``), with an assumption if
        an option or the default states it.

        Raises UsageError if the option ``reference_return`` is neither ``+`` nor ``-``.
        """
        given = by_address(self.reference_return, address)
        if given is not None:
            return given, None
        options = self.options_of(address)
        option = options.get("reference_return", Direction.POSITIVE)
        if option not in ("+", "-"):
            raise wrong_choice("reference_return", option, ("+", "-"))
        direction = Direction(str(option))
        evidence = "option" if "reference_return" in options else "default"
        return direction, Assumption(f"reference_return of {address}", direction.value, evidence)

    def referenced(self, address: str) -> tuple[float, Assumption | None]:
        """Return an axis' reference position, mm or deg (default 0), with an assumption if an
        option or the default states it.

        Raises UsageError if the given position is not a finite number.
        """
        known = by_address(self.reference, address)
        options = self.options_of(address)
        given = options.get("reference", 0.0) if known is None else known
        position = finite_number(given)
        if position is None:
            raise UsageError(
                Fault(
                    message=f"the reference position of axis {address} is not a number",
                    expected="a position in mm or deg",
                    found=repr(given),
                    hint=("give the reference position as one number, such as `reference: 0`"),
                )
            )
        if known is not None:
            return position, None
        evidence = "option" if "reference" in options else "default"
        return position, Assumption(f"reference of {address}", f"{position:g}", evidence)


def finite_number(value: object) -> float | None:
    """Return the number in an option (number or text); None if it is not a finite number."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return None
    try:
        number = float(value)
    except (ValueError, OverflowError):
        return None
    return number if math.isfinite(number) else None


def by_address(table: Mapping[str, Entry], address: str) -> Entry | None:
    """Return a table's entry for an address, in exact spelling or else in any letter case."""
    if address in table:
        return table[address]
    return next(
        (value for key, value in table.items() if key.casefold() == address.casefold()), None
    )


def wrong_choice(name: str, found: object, choices: Iterable[str], owner: str = "") -> UsageError:
    """Return the error for an option whose value is none of ``choices``. ``owner``: which axis has
    the option, as text.
    """
    return UsageError(
        Fault(
            message=f"the option {name}{owner} has a wrong value",
            expected=" or ".join(choices),
            found=repr(found),
            hint="give " + " or ".join(f"`--option {name}={one}`" for one in choices),
        )
    )


def unknown_axis(address: str, known: tuple[str, ...]) -> UsageError:
    """Return the error for an axis that is not in the files."""
    return UsageError(
        Fault(
            message=f"the control's files contain no data of axis {address}",
            expected=" or ".join(known) or "an axis",
            found=address,
            hint=("use one of these addresses, or give the file with the data of this axis"),
        )
    )
