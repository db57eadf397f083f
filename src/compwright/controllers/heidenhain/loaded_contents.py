"""The contents of HEIDENHAIN files, and which table is active for the motion of which axis.

The active line of the .CMA table decides which tables are active, and for which moving axis.
Without a .CMA table, the name of each table states its moving axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from compwright.controllers.heidenhain.elements import ITNC530, LETTERS, Generation, Parameter
from compwright.controllers.heidenhain.sheet import JudgedSheet
from compwright.controllers.heidenhain.table import Cma, Com
from compwright.controllers.request import Request, by_address, wrong_choice
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption


@dataclass(slots=True)
class LoadedContents:
    """The entry sheets, tables and parameters of all files, in their order."""

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
        """Return whether an axis is linear or rotary: by the job, its entry sheet, a stated travel
        per turn, or its letter.
        """
        requested = by_address(self.request.kinds, address)
        by_unit = next(
            (sheet for sheet in self.sheets if sheet.address == address and sheet.kind is not None),
            None,
        )
        if requested is not None and by_unit is not None and by_unit.kind is not requested:
            fault = by_unit.place.fault(
                f"the unit of axis {address} is unclear",
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
        """Return an option of the moving axis; the first of ``allowed`` is the default.

        ``name``: the option. ``allowed``: its two possible values. ``address``: the moving axis.
        Raises UsageError for another value.
        """
        value = self.request.options_of(address).get(name, allowed[0])
        if value not in allowed:
            raise wrong_choice(name, value, allowed)
        return str(value)


def filled(com: Com) -> tuple[str, ...]:
    """Return the columns of a .COM table that contain any value."""
    return tuple(
        axis for index, axis in enumerate(com.columns) if not np.all(np.isnan(com.values[:, index]))
    )


class AxisAssignment:
    """Finds the moving axis of each .COM table; faults and notes are added to ``given``."""

    def __init__(self, given: LoadedContents) -> None:
        self.given = given

    def moving_axes(self) -> list[tuple[Com, str | None]]:
        """Return each .COM table with the axis whose position selects its rows; None for a table
        that is not active.

        A .COM table that is active for two axes is listed twice.
        """
        if len(self.given.cmas) > 1:
            self.given.faults += [
                cma.place.fault(
                    "the files contain a second .CMA file, but only one is active",
                    found=str(cma.place),
                )
                for cma in self.given.cmas[1:]
            ]
            return []
        if not self.given.cmas:
            return [
                (com, axis)
                for com in self.given.coms
                if (axis := self._named_axis(com)) is not None
            ]
        cma = self.given.cmas[0]
        if cma.active is None:
            self.given.notes.append(
                f"{cma.place}: no line of the .CMA is active: its tables do not act"
            )
        elif not cma.marked:
            self.given.assumed.append(
                Assumption("active line of the .CMA", "the only one", "it bears no mark")
            )
        self._check_keys(cma)
        found: list[tuple[Com, str | None]] = []
        for moving, name in (cma.active or {}).items():
            held = [com for com in self.given.coms if name in com.names]
            if len(held) == 1:
                found.append((held[0], moving))
            else:
                message = f"the table {name}.COM under {moving} " + (
                    "was given twice" if held else "was not given"
                )
                self.given.faults.append(
                    cma.place.fault(message, expected="each .COM of the active line once")
                )
        assigned = {id(com) for com, _ in found}
        for com in self.given.coms:
            if id(com) not in assigned:
                found.append((com, None))
                self.given.notes.append(
                    f"{com.place}: {com.name}.COM does not act: the active line of the .CMA does"
                    " not name it"
                )
        return found

    def _check_keys(self, cma: Cma) -> None:
        """Check that the .COM and .CMA tables of an NCK control have columns for the same axes."""
        if self.given.generation.name == ITNC530.name:
            return
        for com in self.given.coms:
            self.given.faults += [
                com.place.fault(
                    "the column belongs to an axis that the .CMA file does not contain",
                    expected=" or ".join(cma.axes),
                    found=axis,
                )
                for axis in filled(com)
                if axis not in cma.axes
            ]

    def _named_axis(self, com: Com) -> str | None:
        """Return the moving axis of a .COM table if there is no .CMA table; None, with a fault, if
        it is unclear.

        The name in the head of the table or the file name states the axis. If neither does, the
        option ``axis`` states it for the only .COM table.
        """
        known = dict.fromkeys(
            [
                *LETTERS,
                "U",
                "V",
                "W",
                *(a for one in self.given.coms for a in one.columns),
                *(s.address for s in self.given.sheets),
            ]
        )
        axes = {self._by_case(name, known) for name in com.names} - {None}
        option = self.given.request.options.get("axis")
        if not axes and len(self.given.coms) == 1 and option:
            axes = {self.given.generation.address(str(option))}
        if len(axes) != 1:
            self.given.faults.append(
                com.place.fault(
                    "no file states by which axis this table is moved",
                    expected="its .CMA, or one axis as its name",
                    found=" and ".join(sorted(com.names)),
                )
            )
            return None
        moving = axes.pop()
        if sum(1 for other in self.given.coms if other.names & com.names) > 1:
            self.given.faults.append(
                com.place.fault(
                    "two tables have the same name", expected="each .COM once", found=com.name
                )
            )
        self.given.assumed.append(
            Assumption(
                f"axis that moves {com.name}.COM", str(moving), "no .CMA was given: by its name"
            )
        )
        return moving

    def _by_case(self, name: str, known: dict[str, None]) -> str | None:
        found = [axis for axis in known if axis == name] or [
            axis for axis in known if axis.upper() == name
        ]
        return found[0] if len(found) == 1 else None
