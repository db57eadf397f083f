"""Build the axes of a HEIDENHAIN control from the tables and parameters in its files."""

from __future__ import annotations

from collections.abc import Sequence

from compwright.controllers.heidenhain.elements import ITNC530, Generation, Parameter, Quantity
from compwright.controllers.heidenhain.loaded_contents import AxisAssignment, LoadedContents, filled
from compwright.controllers.heidenhain.sheet import JudgedSheet
from compwright.controllers.heidenhain.table import Content
from compwright.controllers.heidenhain.tables import CorrectionCurve, HeidenhainAxis, OwnTableLoader
from compwright.controllers.request import Request
from compwright.foundations.errors import Fault
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption


class Loader:
    """Builds the axes of a control; assumptions, notes and faults are added to ``given``."""

    def __init__(
        self,
        generation: Generation,
        request: Request,
        sheets: Sequence[JudgedSheet],
        contents: Sequence[Content],
    ) -> None:
        self.given = LoadedContents(
            generation=generation,
            request=request,
            sheets=sheets,
            coms=[com for content in contents for com in content.coms],
            cmas=[cma for content in contents for cma in content.cmas],
            parameters=[p for content in contents for p in content.parameters]
            + [p for s in sheets for p in s.parameters],
            notes=[note for content in contents for note in content.notes],
        )
        self.tables = OwnTableLoader(self.given)

    @property
    def crossed(self) -> dict[tuple[str, str], CorrectionCurve]:
        """The cross-axis tables: a correction curve for each pair (moving axis, corrected axis)."""
        return self.tables.crossed

    @property
    def faults(self) -> list[Fault]:
        """The faults found in the control's files."""
        return self.given.faults

    def axes(self) -> dict[str, HeidenhainAxis]:
        """Return every axis that the files correct, by tables, entry sheets or parameters, and the
        axes of the job that the active line of the .CMA gives no table.
        """
        spoken: dict[str, None] = {}
        for com, moving in AxisAssignment(self.given).moving_axes():
            spoken.update(dict.fromkeys(filled(com)))
            if moving is not None:
                self.tables.load_com(com, moving)
        under_work = self.given.request.axes_under_work
        for cma in self.given.cmas if under_work else ():
            listed = () if cma.active is None else cma.axes
            spoken.update(dict.fromkeys(filter(self.given.request.is_under_work, listed)))
        for sheet in self.given.sheets:
            spoken[sheet.address] = None
            self.tables.load_sheet(sheet)
        for parameter in self.given.parameters:
            if parameter.quantity is not Quantity.NONLINEAR:  # a bit alone corrects nothing
                spoken[parameter.address] = None
        return {address: self._axis(address) for address in spoken}

    def _axis(self, address: str) -> HeidenhainAxis:
        table = self.tables.one_table(address)
        nonlinear = self._nonlinear(
            address,
            tabled=table is not None or any(out == address for _, out in self.tables.crossed),
        )
        backlash = self._parameter(address, Quantity.BACKLASH)
        name = self.given.generation.parameter(Quantity.BACKLASH)
        if backlash is None:
            self.given.assumed.append(Assumption(f"{name} of {address}", "0", "not in the files"))
        elif backlash.value != 0.0:
            self._check_unit(backlash)
            self.given.assumed.append(
                Assumption(
                    f"zero state of {name} of {address}",
                    "arriving in the referencing direction",
                    "unconfirmed",
                )
            )
            if self.given.generation.name != ITNC530.name and table is not None:
                self.given.notes.append(
                    f"{address}: the control adds backLash also where only the table reverses the"
                    " motion; not judged"
                )
        returning, assumption = self.given.request.returning(address)
        error = self._linear_error(address, nonlinear=nonlinear)
        reference, where = self.given.request.referenced(address)
        self.given.assumed += [
            found for found in (assumption, where if error != 0.0 else None) if found is not None
        ]
        return HeidenhainAxis(
            table=table,
            nonlinear=nonlinear,
            linear_error=error,
            reference=reference,
            backlash=0.0 if backlash is None else backlash.value,
            reference_return=returning,
        )

    def _nonlinear(self, address: str, *, tabled: bool) -> bool:
        """Return whether an axis is corrected by tables and not by its linear error parameter.
        ``tabled``: the files contain a table that corrects the axis.
        """
        unsaid = (
            tabled and not self.given.cmas if self.given.generation.name != ITNC530.name else tabled
        )
        answer = self.given.request.active if unsaid else None  # where the files leave it open
        if self.given.generation.name != ITNC530.name:
            return tabled and answer is not False
        bit = self._parameter(address, Quantity.NONLINEAR)
        if bit is None:
            if answer is not None:
                return answer
            if tabled:
                self.given.assumed.append(
                    Assumption(f"MP730 of {address}", "1", "not in the files: counted as selected")
                )
            return tabled
        if bit.value == 0.0 and answer is True:
            return True
        if tabled and bit.value == 0.0:
            self.given.notes.append(f"{address}: the bit of MP730 is 0: its tables do not act")
        elif not tabled and bit.value == 1.0:
            self.given.notes.append(
                f"{address}: the bit of MP730 is 1 and no table was given: MP720 is not active, old"
                " tables may act"
            )
        return bit.value == 1.0

    def _linear_error(self, address: str, *, nonlinear: bool) -> float:
        """Return the linear error parameter that is active on the axis, mm/m; 0 if tables correct
        the axis instead (``nonlinear``), or if it is a rotary axis.
        """
        given = self._parameter(address, Quantity.LINEAR)
        name = self.given.generation.parameter(Quantity.LINEAR)
        rotary = self.given.kind(address) is AxisKind.ROTARY
        if given is None or given.value == 0.0:
            if given is None and not nonlinear and not rotary:
                self.given.assumed.append(
                    Assumption(f"{name} of {address}", "0", "not in the files")
                )
            return 0.0
        if nonlinear or rotary:
            why = "the nonlinear tables act instead" if nonlinear else "a rotary axis has none"
            self.given.notes.append(f"{given.place}: {name} of {address} has no effect: {why}")
            return 0.0
        if self.given.generation.name != ITNC530.name:
            self.given.assumed.append(
                Assumption(
                    f"{name} of {address}",
                    "mm/m, positive travels too far",
                    "as MP720; unconfirmed",
                )
            )
        return given.value

    def _check_unit(self, backlash: Parameter) -> None:
        unit = self.given.kind(backlash.address).unit
        if backlash.unit not in {"", unit}:
            self.given.faults.append(
                backlash.place.fault(
                    f"unit of the backlash of {backlash.address}",
                    expected=unit,
                    found=backlash.unit,
                )
            )

    def _parameter(self, address: str, quantity: Quantity) -> Parameter | None:
        """Return a parameter of an axis; different values or a value out of range are faults."""
        given = [
            p for p in self.given.parameters if p.address == address and p.quantity is quantity
        ]
        name = self.given.generation.parameter(quantity)
        for other in given[1:]:
            if other.value != given[0].value:
                message = f"{name} of {address} contradicts {given[0].place}"
                self.given.faults.append(
                    other.place.fault(
                        message, expected=f"{given[0].value:g}", found=f"{other.value:g}"
                    )
                )
        largest = self.given.generation.largest
        if (
            given
            and largest is not None
            and quantity is not Quantity.NONLINEAR
            and abs(given[0].value) > largest
        ):
            self.given.faults.append(
                given[0].place.fault(
                    f"{name} of {address}",
                    expected=f"-{largest:g} to {largest:g}",
                    found=f"{given[0].value:g}",
                )
            )
        return given[0] if given else None
