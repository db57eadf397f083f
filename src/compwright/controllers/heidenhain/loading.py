"""From what HEIDENHAIN files say to what each axis does: which table acts under which axis, units,
signs, and what is assumed.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import numpy as np

from compwright.controllers.heidenhain.curve import (
    TURN,
    Curve,
    HeidenhainAxis,
    OwnTable,
    leaves_turn,
    whole_turn,
)
from compwright.controllers.heidenhain.sheet import Sheet
from compwright.controllers.heidenhain.table import Cma, Com, Content
from compwright.controllers.heidenhain.words import (
    ITNC530,
    LETTERS,
    Generation,
    Parameter,
    Place,
    Quantity,
)
from compwright.controllers.request import Request, by_address
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.correction import Assumption

_MM_PER_INCH = 25.4
#: Spacing 2^n times this many mm (deg): TNC 407 technical manual p. 153. The 306/360 count in 1 µm
#: and are another control.
_EXPONENT_UNIT = 1e-4
_LARGEST_EXPONENT = 23
#: Positions of a sheet may be rounded to 0.001 mm (deg); twice the half of that decides whether
#: they lie on a regular grid.
_SHEET_POSITION = 1e-3
#: Two statements of one table agree to less than the last digit of a value, 0.0001 mm (deg).
_SAME_VALUE = 5e-5


class Loader:
    """Builds the axes and gathers what is assumed, worth a note, or wrong."""

    def __init__(
        self,
        generation: Generation,
        request: Request,
        sheets: Sequence[Sheet],
        contents: Sequence[Content],
    ) -> None:
        self.generation = generation
        self.request = request
        self.sheets = sheets
        self.coms = [com for content in contents for com in content.coms]
        self.cmas = [cma for content in contents for cma in content.cmas]
        self.parameters = [p for content in contents for p in content.parameters] + [
            p for s in sheets for p in s.parameters
        ]
        self.notes = [note for content in contents for note in content.notes]
        self.assumed: list[Assumption] = []
        self.faults: list[Fault] = []
        self.own: dict[str, list[tuple[Place, OwnTable]]] = defaultdict(list)
        self.crossed: dict[tuple[str, str], Curve] = {}
        self.spoken: dict[str, None] = {}

    def axes(self) -> dict[str, HeidenhainAxis]:
        """Return every axis that the files correct, in order of tables, sheets, parameters."""
        for com, moving in self._moving_axes():
            self.spoken.update(dict.fromkeys(_filled(com)))
            if moving is not None:
                self._load_com(com, moving)
        for sheet in self.sheets:
            self._load_sheet(sheet)
        for parameter in self.parameters:
            if parameter.quantity is not Quantity.NONLINEAR:  # a bit alone corrects nothing
                self.spoken[parameter.address] = None
        return {address: self._axis(address) for address in self.spoken}

    # --- which table acts under which axis ---

    def _moving_axes(self) -> list[tuple[Com, str | None]]:
        """Return every .COM with the axis that moves it, None where it does not act; one that acts
        twice comes twice.
        """
        if len(self.cmas) > 1:
            self.faults += [
                cma.place.fault("a second .CMA; only one is active", found=str(cma.place))
                for cma in self.cmas[1:]
            ]
            return []
        if not self.cmas:
            return [(com, axis) for com in self.coms if (axis := self._named_axis(com)) is not None]
        cma = self.cmas[0]
        if cma.active is None:
            self.notes.append(f"{cma.place}: no line of the .CMA is active: its tables do not act")
        elif not cma.marked:
            self.assumed.append(
                Assumption("active line of the .CMA", "the only one", "it bears no mark")
            )
        self._check_keys(cma)
        found: list[tuple[Com, str | None]] = []
        for moving, name in (cma.active or {}).items():
            held = [com for com in self.coms if name in com.names]
            if len(held) == 1:
                found.append((held[0], moving))
            else:
                message = f"the table {name}.COM under {moving} " + (
                    "was given twice" if held else "was not given"
                )
                self.faults.append(
                    cma.place.fault(message, expected="each .COM of the active line once")
                )
        acting = {id(com) for com, _ in found}
        for com in self.coms:
            if id(com) not in acting:
                found.append((com, None))
                self.notes.append(
                    f"{com.place}: {com.name}.COM does not act: the active line of the .CMA does"
                    " not name it"
                )
        return found

    def _check_keys(self, cma: Cma) -> None:
        """NCK: the columns of .COM and .CMA bear the same axis keys (CfgAxes/axisList)."""
        if self.generation.name == ITNC530.name:
            return
        for com in self.coms:
            self.faults += [
                com.place.fault(
                    "column of an axis that the .CMA does not know",
                    expected=" or ".join(cma.axes),
                    found=axis,
                )
                for axis in _filled(com)
                if axis not in cma.axes
            ]

    def _named_axis(self, com: Com) -> str | None:
        """Without a .CMA: the axis that the name in the table's head or the file's name says, else
        the only axis asked for.
        """
        known = dict.fromkeys(
            [
                *LETTERS,
                "U",
                "V",
                "W",
                *(a for one in self.coms for a in one.columns),
                *(s.address for s in self.sheets),
            ]
        )
        axes = {self._by_case(name, known) for name in com.names} - {None}
        asked = self.request.options.get("axis")
        if not axes and len(self.coms) == 1 and asked:
            axes = {self.generation.address(str(asked))}
        if len(axes) != 1:
            self.faults.append(
                com.place.fault(
                    "nothing says which axis moves this table",
                    expected="its .CMA, or one axis as its name",
                    found=" and ".join(sorted(com.names)),
                )
            )
            return None
        moving = axes.pop()
        if sum(1 for other in self.coms if other.names & com.names) > 1:
            self.faults.append(
                com.place.fault("two tables of one name", expected="each .COM once", found=com.name)
            )
        self.assumed.append(
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

    # --- tables ---

    def _load_com(self, com: Com, moving: str) -> None:
        nodes = self._nodes(com, moving)
        sign = self._sign(com, moving)
        if nodes is None:
            return
        for index, output in enumerate(com.columns):
            if output in _filled(com):
                values = sign * com.values[:, index] * self._length(com, output)
                curve = self._curve(moving, nodes, values, com.place)
                if output == moving:
                    negative = self._second_curve(com, moving, nodes, sign) or curve
                    self.own[moving].append((com.place, OwnTable(curve, negative)))
                else:
                    self.crossed[moving, output] = curve
        if (
            moving not in _filled(com)
            and com.negative is not None
            and not np.all(np.isnan(com.negative))
        ):
            self.faults.append(
                com.place.fault(
                    "BACKLASH without a column of the moving axis", expected=f"a column {moving}"
                )
            )

    def _nodes(self, com: Com, moving: str) -> FloatArray | None:
        """Return the positions (k,) of all rows, mm or deg; None with a fault when they are no
        grid.
        """
        factor = self._length(com, moving)
        if com.listed is not None:
            return np.asarray(com.listed * factor, dtype=np.float64)
        distance = com.distance * factor
        rule = self._choice("spacing_rule", ("free", "power_of_two"), moving)
        evidence = "option" if "spacing_rule" in self.request.options_of(moving) else "default"
        self.assumed.append(Assumption(f"spacing_rule of {com.name}.COM", rule, evidence))
        if rule == "power_of_two":
            if com.distance != int(com.distance) or not 0 <= com.distance <= _LARGEST_EXPONENT:
                expected = f"an exponent from 0 to {_LARGEST_EXPONENT}"
                self.faults.append(
                    com.place.fault(
                        "DIST by the rule 2^n", expected=expected, found=f"{com.distance:g}"
                    )
                )
                return None
            distance = 2.0 ** int(com.distance) * _EXPONENT_UNIT
        nodes = com.datum * factor + distance * np.arange(len(com.values))
        if distance <= 0.0 or not np.all(np.diff(nodes) > 0.0):
            self.faults.append(
                com.place.fault("DIST", expected="a spacing above 0", found=f"{com.distance:g}")
            )
            return None
        return np.asarray(nodes, dtype=np.float64)

    def _length(self, com: Com, address: str) -> float:
        """Return mm per unit of a table for a linear axis; angles are in degrees whatever the
        table's unit.
        """
        if not com.inch or self.kind(address) is AxisKind.ROTARY:
            return 1.0
        self.assumed.append(
            Assumption(
                f"lengths in {com.name}.COM, DATUM, DIST and AXISPOS too",
                "inch",
                "its head says INCH",
            )
        )
        return _MM_PER_INCH

    def _sign(self, com: Com, moving: str) -> float:
        """Return the factor from a table's value to the correction."""
        chosen = self._choice("table_values", ("error", "correction"), moving)
        sheet = next(
            (one for one in self.sheets if one.address == moving and not one.nodes.size), None
        )
        if sheet is not None:  # the parameters beside the table say it
            self.assumed.append(
                Assumption(
                    f"values of {com.name}.COM",
                    "error" if sheet.errors else "correction",
                    str(sheet.place),
                )
            )
            return -1.0 if sheet.errors else 1.0
        evidence = (
            "option"
            if "table_values" in self.request.options_of(moving)
            else "default, unconfirmed"
        )
        self.assumed.append(Assumption(f"values of {com.name}.COM", chosen, evidence))
        return -1.0 if chosen == "error" else 1.0

    def _second_curve(self, com: Com, moving: str, nodes: FloatArray, sign: float) -> Curve | None:
        """Return the curve arriving in - (NCK, column BACKLASH), None where one curve serves
        both.
        """
        chosen = self._choice("backlash_column", ("second_curve", "absent"), moving)
        if com.negative is None or np.all(np.isnan(com.negative)):
            return None
        if chosen == "second_curve":
            if np.isnan(com.negative[0]) or np.isnan(com.negative[-1]):
                self.faults.append(
                    com.place.fault(
                        "column BACKLASH is blank at an end of the table", expected="a value"
                    )
                )
                return None
            self.assumed.append(
                Assumption(
                    f"BACKLASH in {com.name}.COM",
                    "the whole curve arriving in -",
                    "MANUALplus 620 technical manual p. 715",
                )
            )
            return self._curve(
                moving, nodes, sign * com.negative * self._length(com, moving), com.place
            )
        own = com.values[:, com.columns.index(moving)]
        filled = ~np.isnan(com.negative)
        if not np.array_equal(com.negative[filled], own[filled]):
            self.faults.append(
                com.place.fault(
                    "the column BACKLASH is not blank; the option backlash_column says absent",
                    expected=(
                        f"blank, or the values of {moving}, or the option"
                        " backlash_column=second_curve"
                    ),
                    found="other values",
                )
            )
        return None

    def _load_sheet(self, sheet: Sheet) -> None:
        self.spoken[sheet.address] = None
        if sheet.nodes.size == 0:
            return
        self._check_grid(sheet)
        curve = self._curve(
            sheet.address, sheet.nodes, -sheet.values if sheet.errors else sheet.values, sheet.place
        )
        self.own[sheet.address].append((sheet.place, OwnTable(curve, curve)))

    def _check_grid(self, sheet: Sheet) -> None:
        """iTNC 530: only DATUM and a spacing can be typed in, so the positions lie on a regular
        grid.
        """
        if self.generation.name != ITNC530.name or sheet.nodes.size < 2:
            return
        steps = np.arange(sheet.nodes.size)
        spacing = float(sheet.nodes[-1] - sheet.nodes[0]) / float(steps[-1])
        rule = self._choice("spacing_rule", ("free", "power_of_two"), sheet.address)
        if rule == "power_of_two":
            spacing = 2.0 ** round(np.log2(spacing / _EXPONENT_UNIT)) * _EXPONENT_UNIT
        off = float(np.max(np.abs(sheet.nodes - (sheet.nodes[0] + spacing * steps))))
        if off > _SHEET_POSITION:
            expected = "one spacing" if rule == "free" else "a spacing of 2^n * 0.0001"
            self.faults.append(
                sheet.place.fault(
                    "positions are no regular grid", expected=expected, found=f"off by {off:g}"
                )
            )

    def _curve(self, moving: str, nodes: FloatArray, values: FloatArray, place: Place) -> Curve:
        """Return the curve over the rows with a value; a rotary axis is endless when told, or when
        its table spans the turn.
        """
        filled = ~np.isnan(values)
        nodes, values = nodes[filled], values[filled] + 0.0
        self.assumed.append(
            Assumption(f"outside the table of {moving}", "the end values hold", "unconfirmed")
        )
        if self.kind(moving) is not AxisKind.ROTARY:
            return Curve(nodes, values)
        turn = by_address(self.request.modulo, moving)
        if turn is not None and turn != TURN:
            raise UsageError(
                Fault(message=f"turn of {moving}", expected=f"{TURN:g}", found=f"{turn:g}")
            )
        if turn is None and whole_turn(nodes):
            self.assumed.append(
                Assumption(f"turn of {moving}", f"{TURN:g}", "its table reaches from 0 to 360 deg")
            )
        endless = turn is not None or whole_turn(nodes)
        curve = Curve(
            nodes,
            values,
            endless=endless,
            one_turn=not endless and self.generation.name == ITNC530.name,
        )
        jump = float(np.interp(TURN, nodes, values) - np.interp(0.0, nodes, values))
        if endless and abs(jump) > _SAME_VALUE:
            self.notes.append(
                f"{place}: the table of {moving} jumps by {jump:g} (mm or deg) at every turn: 0 and"
                " 360 deg differ"
            )
        if curve.one_turn and leaves_turn(nodes):
            self.notes.append(f"{place}: entries of {moving} outside 0 to 360 deg are not used")
        return curve

    # --- axes ---

    def kind(self, address: str) -> AxisKind:
        """Return whether an axis is linear or rotary: as told, by the units of its sheet, by its
        turn, else by its letter.
        """
        told = by_address(self.request.kinds, address)
        by_unit = next(
            (sheet for sheet in self.sheets if sheet.address == address and sheet.kind is not None),
            None,
        )
        if told is not None and by_unit is not None and by_unit.kind is not told:
            fault = by_unit.place.fault(
                f"unit of {address}",
                expected=told.unit,
                found=by_unit.kind.unit if by_unit.kind else "",
            )
            self.faults += [] if fault in self.faults else [fault]
        given = told or (by_unit.kind if by_unit is not None else None)
        if given is not None:
            return given
        if by_address(self.request.modulo, address) is not None:
            return AxisKind.ROTARY
        letter = address.rstrip("0123456789").upper()
        kind = AxisKind.ROTARY if letter in {"A", "B", "C"} else AxisKind.LINEAR
        if letter not in {"X", "Y", "Z", "U", "V", "W"}:
            self.assumed.append(Assumption(f"kind of {address}", kind.value, "by its name"))
        return kind

    def _axis(self, address: str) -> HeidenhainAxis:
        table = self._one_table(address)
        nonlinear = self._nonlinear(
            address, tabled=table is not None or any(out == address for _, out in self.crossed)
        )
        backlash = self._parameter(address, Quantity.BACKLASH)
        name = self.generation.parameter(Quantity.BACKLASH)
        if backlash is None:
            self.assumed.append(Assumption(f"{name} of {address}", "0", "not in the files"))
        elif backlash.value != 0.0:
            self._check_unit(backlash)
            self.assumed.append(
                Assumption(
                    f"zero state of {name} of {address}",
                    "arriving in the referencing direction",
                    "unconfirmed",
                )
            )
            if self.generation.name != ITNC530.name and table is not None:
                self.notes.append(
                    f"{address}: the control adds backLash also where only the table reverses the"
                    " motion; not judged"
                )
        returning, assumption = self.request.returning(address)
        error = self._linear_error(address, nonlinear=nonlinear)
        reference, where = self.request.referenced(address)
        self.assumed += [
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

    def _one_table(self, address: str) -> OwnTable | None:
        """Return the axis' own table; two statements of it (a .COM and the sheet typed into it)
        must agree.
        """
        stated = self.own.get(address, [])
        for place, table in stated[1:]:
            first = stated[0][1]
            for mine, other in ((table.positive, first.positive), (table.negative, first.negative)):
                same = mine.nodes.size == other.nodes.size and (
                    bool(np.all(np.abs(mine.nodes - other.nodes) <= _SHEET_POSITION))
                    and bool(np.all(np.abs(mine.values - other.values) < _SAME_VALUE))
                )
                fault = place.fault(
                    f"the table of {address} differs from that of {stated[0][0]}",
                    expected="one table",
                )
                self.faults += [] if same or fault in self.faults else [fault]
        return stated[0][1] if stated else None

    def _nonlinear(self, address: str, *, tabled: bool) -> bool:
        """Return whether the tables of an axis act, and not its linear error."""
        unsaid = tabled and not self.cmas if self.generation.name != ITNC530.name else tabled
        answer = self.request.active if unsaid else None  # where the files leave it open
        if self.generation.name != ITNC530.name:
            return tabled and answer is not False
        bit = self._parameter(address, Quantity.NONLINEAR)
        if bit is None:
            if answer is not None:
                return answer
            if tabled:
                self.assumed.append(
                    Assumption(f"MP730 of {address}", "1", "not in the files: counted as selected")
                )
            return tabled
        if bit.value == 0.0 and answer is True:
            return True
        if tabled and bit.value == 0.0:
            self.notes.append(f"{address}: the bit of MP730 is 0: its tables do not act")
        elif not tabled and bit.value == 1.0:
            self.notes.append(
                f"{address}: the bit of MP730 is 1 and no table was given: MP720 is dead, old"
                " tables may act"
            )
        return bit.value == 1.0

    def _linear_error(self, address: str, *, nonlinear: bool) -> float:
        """Return the linear error that acts, mm/m."""
        given = self._parameter(address, Quantity.LINEAR)
        name = self.generation.parameter(Quantity.LINEAR)
        rotary = self.kind(address) is AxisKind.ROTARY
        if given is None or given.value == 0.0:
            if given is None and not nonlinear and not rotary:
                self.assumed.append(Assumption(f"{name} of {address}", "0", "not in the files"))
            return 0.0
        if nonlinear or rotary:
            why = "the nonlinear tables act instead" if nonlinear else "a rotary axis has none"
            self.notes.append(f"{given.place}: {name} of {address} has no effect: {why}")
            return 0.0
        if self.generation.name != ITNC530.name:
            self.assumed.append(
                Assumption(
                    f"{name} of {address}",
                    "mm/m, positive travels too far",
                    "as MP720; unconfirmed",
                )
            )
        return given.value

    def _check_unit(self, backlash: Parameter) -> None:
        unit = self.kind(backlash.address).unit
        if backlash.unit not in {"", unit}:
            self.faults.append(
                backlash.place.fault(
                    f"unit of the backlash of {backlash.address}",
                    expected=unit,
                    found=backlash.unit,
                )
            )

    def _parameter(self, address: str, quantity: Quantity) -> Parameter | None:
        """Return a parameter of an axis; a repetition must agree, and the control's range is
        kept.
        """
        given = [p for p in self.parameters if p.address == address and p.quantity is quantity]
        name = self.generation.parameter(quantity)
        for other in given[1:]:
            if other.value != given[0].value:
                message = f"{name} of {address} contradicts {given[0].place}"
                self.faults.append(
                    other.place.fault(
                        message, expected=f"{given[0].value:g}", found=f"{other.value:g}"
                    )
                )
        largest = self.generation.largest
        if (
            given
            and largest is not None
            and quantity is not Quantity.NONLINEAR
            and abs(given[0].value) > largest
        ):
            self.faults.append(
                given[0].place.fault(
                    f"{name} of {address}",
                    expected=f"-{largest:g} to {largest:g}",
                    found=f"{given[0].value:g}",
                )
            )
        return given[0] if given else None

    def _choice(self, name: str, allowed: tuple[str, str], address: str) -> str:
        """Return an option of the moving axis; the first of ``allowed`` is the default. Raises
        UsageError for another value.
        """
        value = self.request.options_of(address).get(name, allowed[0])
        if value not in allowed:
            raise UsageError(
                Fault(message=f"option {name}", expected=" or ".join(allowed), found=repr(value))
            )
        return str(value)


def _filled(com: Com) -> tuple[str, ...]:
    """Return the columns of a .COM that hold any value."""
    return tuple(
        axis for index, axis in enumerate(com.columns) if not np.all(np.isnan(com.values[:, index]))
    )
