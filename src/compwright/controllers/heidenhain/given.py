"""Contents of HEIDENHAIN files and of the request, with the assumptions, notes and faults that the
parts of the loader add.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.controllers.heidenhain.sheet import JudgedSheet
from compwright.controllers.heidenhain.table import Cma, Com
from compwright.controllers.heidenhain.words import Generation, Parameter
from compwright.controllers.request import Request, by_address
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption


@dataclass(slots=True)
class Given:
    """Sheets, tables and parameters of all files, in their order."""

    generation: Generation
    request: Request
    sheets: Sequence[JudgedSheet]
    coms: list[Com]
    cmas: list[Cma]
    parameters: list[Parameter]
    notes: list[str]
    assumed: list[Assumption] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)

    def kind(self, address: str) -> AxisKind:
        """Return whether an axis is linear or rotary: as requested, else by the units of its sheet,
        its turn, or its letter.
        """
        requested = by_address(self.request.kinds, address)
        by_unit = next(
            (sheet for sheet in self.sheets if sheet.address == address and sheet.kind is not None),
            None,
        )
        if requested is not None and by_unit is not None and by_unit.kind is not requested:
            fault = by_unit.place.fault(
                f"unit of {address}",
                expected=requested.unit,
                found=by_unit.kind.unit if by_unit.kind else "",
            )
            self.faults += [] if fault in self.faults else [fault]
        given = requested or (by_unit.kind if by_unit is not None else None)
        if given is not None:
            return given
        if by_address(self.request.modulo, address) is not None:
            return AxisKind.ROTARY
        letter = address.rstrip("0123456789").upper()
        kind = AxisKind.ROTARY if letter in {"A", "B", "C"} else AxisKind.LINEAR
        if letter not in {"X", "Y", "Z", "U", "V", "W"}:
            self.assumed.append(Assumption(f"kind of {address}", kind.value, "by its name"))
        return kind

    def choice(self, name: str, allowed: tuple[str, str], address: str) -> str:
        """Return an option of the moving axis; the first of ``allowed`` is the default. Raises
        UsageError for another value.
        """
        value = self.request.options_of(address).get(name, allowed[0])
        if value not in allowed:
            raise UsageError(
                Fault(
                    message=f"option {name}",
                    expected=" or ".join(allowed),
                    found=repr(value),
                    hint=f"give one of these values for `{name}`",
                )
            )
        return str(value)


def filled(com: Com) -> tuple[str, ...]:
    """Return the columns of a .COM that hold any value."""
    return tuple(
        axis for index, axis in enumerate(com.columns) if not np.all(np.isnan(com.values[:, index]))
    )
