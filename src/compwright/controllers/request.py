"""What a virtual control is asked for beside its files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TypeVar

from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import Assumption

Entry = TypeVar("Entry")


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """Facts by axis address that no file of the control holds; an address is found whatever its case.

    ``reference_return``: direction in which the reference is approached; ``encoder``: active measuring system, 1 or 2; ``kinds``:
    linear or rotary; ``options``: the controller's options by name, as the job gives them.
    """

    reference_return: Mapping[str, Direction] = field(default_factory=dict)
    encoder: Mapping[str, int] = field(default_factory=dict)
    kinds: Mapping[str, AxisKind] = field(default_factory=dict)
    options: Mapping[str, object] = field(default_factory=dict)

    def returning(self, address: str) -> tuple[Direction, Assumption | None]:
        """Return the referencing direction of an axis, and the assumption where nobody said it (option, else ``+``).

        Raises UsageError when the option ``reference_return`` is neither ``+`` nor ``-``.
        """
        given = by_address(self.reference_return, address)
        if given is not None:
            return given, None
        option = self.options.get("reference_return", Direction.POSITIVE)
        if option not in {"+", "-"}:
            raise UsageError(Fault(message="option reference_return", expected="+ or -", found=repr(option)))
        direction = Direction(str(option))
        evidence = "option" if "reference_return" in self.options else "default"
        return direction, Assumption(f"reference_return of {address}", direction.value, evidence)


def by_address(table: Mapping[str, Entry], address: str) -> Entry | None:
    """Return the entry of an address, exact spelling first, then whatever its case; None without one."""
    if address in table:
        return table[address]
    return next((value for key, value in table.items() if key.casefold() == address.casefold()), None)


def unknown_axis(address: str, known: tuple[str, ...]) -> UsageError:
    """Return the error for an axis that the files do not speak of."""
    return UsageError(
        Fault(
            message=f"the control's files say nothing about axis {address}", expected=" or ".join(known) or "an axis", found=address
        )
    )
