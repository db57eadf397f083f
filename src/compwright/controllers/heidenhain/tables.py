"""HEIDENHAIN tables and entry sheets as corrections by position, in mm or deg."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import dataclass

import numpy as np

from compwright.controllers.heidenhain.elements import ITNC530, LinePlace
from compwright.controllers.heidenhain.loaded_contents import LoadedContents, filled
from compwright.controllers.heidenhain.sheet import JudgedSheet
from compwright.controllers.heidenhain.table import Com
from compwright.controllers.request import by_address
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import Assumption

#: A turn of a rotary axis, deg: only entries from 0 to 360 are used (TNC 407 technical manual p.
#: 156).
TURN = 360.0
#: Positions meet 0 and 360 deg to this many deg: multiples of a spacing in binary numbers.
_MEETS = 1e-6


@dataclass(frozen=True, slots=True)
class CorrectionCurve:
    """A correction curve: ``values`` (k,) at ``points`` (k,), linear in between, constant outside.

    ``endless``: positions count modulo 360 deg. ``one_turn``: the curve is used from 0 to 360 deg
    only; outside, its value at 0 or 360 deg applies.
    """

    points: FloatArray
    values: FloatArray
    endless: bool = False
    one_turn: bool = False

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the correction at ``positions`` (any shape)."""
        if self.endless:
            positions = np.mod(positions, TURN)
        elif self.one_turn:
            positions = np.clip(positions, 0.0, TURN)
        return np.asarray(np.interp(positions, self.points, self.values), dtype=np.float64)


@dataclass(frozen=True, slots=True)
class OwnTable:
    """The corrections of an axis by its own position: one curve for each direction of approach."""

    positive: CorrectionCurve
    negative: CorrectionCurve

    def at(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape) approached in ``direction``."""
        return (self.positive if direction is Direction.POSITIVE else self.negative).at(positions)

    def points(self) -> FloatArray:
        """Return the positions of the points of both curves, ascending."""
        return np.union1d(self.positive.points, self.negative.points)


@dataclass(frozen=True, slots=True)
class HeidenhainAxis:
    """The compensation of one axis.

    Either the tables or the linear error are active, never both (TNC 407 technical manual p. 151).

    ``nonlinear``: the tables are active. ``linear_error``: the active linear error, mm/m, positive
    when the axis travels too far; 0 with active tables. ``backlash``: mm or deg, positive when the
    encoder runs ahead and the travel is too short.
    """

    table: OwnTable | None
    nonlinear: bool
    linear_error: float
    reference: float
    backlash: float
    reference_return: Direction

    def correction(self, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.
        """
        total = np.zeros(positions.shape)
        if self.nonlinear and self.table is not None:
            total = total + self.table.at(positions, direction)
        total = total - self.linear_error * (positions - self.reference) / 1000.0
        if direction is not self.reference_return:
            total = total + direction.sign * self.backlash
        return total


def whole_turn(points: FloatArray) -> bool:
    """Return whether the table of a rotary axis covers 0 to 360 deg."""
    return bool(points[0] <= _MEETS and points[-1] >= TURN - _MEETS)


def leaves_turn(points: FloatArray) -> bool:
    """Return whether the table of a rotary axis has entries outside 0 to 360 deg."""
    return bool(points[0] < -_MEETS or points[-1] > TURN + _MEETS)


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


class OwnTableLoader:
    """Builds correction curves from tables; faults and notes are added to ``given``.

    ``own``: for each axis, every version of the table that corrects it by its own position, with
    its place in the files. ``crossed``: curves that correct another axis, by moving and corrected
    axis.
    """

    def __init__(self, given: LoadedContents) -> None:
        self.given = given
        self.own: dict[str, list[tuple[LinePlace, OwnTable]]] = defaultdict(list)
        self.crossed: dict[tuple[str, str], CorrectionCurve] = {}

    def load_com(self, com: Com, moving: str) -> None:
        """Load each column of a .COM table as the correction of its axis over the position of the
        axis ``moving``.
        """
        points = self._points(com, moving)
        sign = self._sign(com, moving)
        if points is None:
            return
        for index, output in enumerate(com.columns):
            if output in filled(com):
                values = sign * com.values[:, index] * self._length(com, output)
                curve = self._curve(moving, points, values, com.place)
                if output == moving:
                    negative = self._second_curve(com, moving, points, sign) or curve
                    self.own[moving].append((com.place, OwnTable(curve, negative)))
                else:
                    self.crossed[moving, output] = curve
        if (
            moving not in filled(com)
            and com.negative is not None
            and not np.all(np.isnan(com.negative))
        ):
            self.given.faults.append(
                com.place.fault(
                    "the table has a column BACKLASH but no column of the moving axis",
                    expected=f"a column {moving}",
                )
            )

    def _points(self, com: Com, moving: str) -> FloatArray | None:
        """Return the positions (k,) of all rows, mm or deg; None, with a fault, if unequally
        spaced.
        """
        factor = self._length(com, moving)
        if com.listed is not None:
            return np.asarray(com.listed * factor, dtype=np.float64)
        distance = com.distance * factor
        rule = self.given.choice("spacing_rule", ("free", "power_of_two"), moving)
        evidence = (
            "option" if "spacing_rule" in self.given.request.options_of(moving) else "default"
        )
        self.given.assumed.append(Assumption(f"spacing_rule of {com.name}.COM", rule, evidence))
        if rule == "power_of_two":
            if com.distance != int(com.distance) or not 0 <= com.distance <= _LARGEST_EXPONENT:
                expected = f"an exponent from 0 to {_LARGEST_EXPONENT}"
                self.given.faults.append(
                    com.place.fault(
                        "DIST by the rule 2^n", expected=expected, found=f"{com.distance:g}"
                    )
                )
                return None
            distance = 2.0 ** int(com.distance) * _EXPONENT_UNIT
        points = com.datum * factor + distance * np.arange(len(com.values))
        if distance <= 0.0 or not np.all(np.diff(points) > 0.0):
            self.given.faults.append(
                com.place.fault("DIST", expected="a spacing above 0", found=f"{com.distance:g}")
            )
            return None
        return np.asarray(points, dtype=np.float64)

    def _length(self, com: Com, address: str) -> float:
        """Return the factor from the length unit of a table to mm; 1 for angles."""
        if not com.inch or self.given.kind(address) is AxisKind.ROTARY:
            return 1.0
        self.given.assumed.append(
            Assumption(
                f"lengths in {com.name}.COM, DATUM, DIST and AXISPOS too",
                "inch",
                "its head says INCH",
            )
        )
        return _MM_PER_INCH

    def _sign(self, com: Com, moving: str) -> float:
        """Return the factor (1 or -1) from a table value to the correction."""
        chosen = self.given.choice("table_values", ("error", "correction"), moving)
        sheet = next(
            (one for one in self.given.sheets if one.address == moving and not one.points.size),
            None,
        )
        if sheet is not None:  # the sheet with the parameters of the table states it
            self.given.assumed.append(
                Assumption(
                    f"values of {com.name}.COM",
                    "error" if sheet.errors else "correction",
                    str(sheet.place),
                )
            )
            return -1.0 if sheet.errors else 1.0
        evidence = (
            "option"
            if "table_values" in self.given.request.options_of(moving)
            else "default, unconfirmed"
        )
        self.given.assumed.append(Assumption(f"values of {com.name}.COM", chosen, evidence))
        return -1.0 if chosen == "error" else 1.0

    def _second_curve(
        self, com: Com, moving: str, points: FloatArray, sign: float
    ) -> CorrectionCurve | None:
        """Return the curve for approaches towards -; None if one curve applies to both directions.

        The curve is the column BACKLASH of a table of an NCK control. ``moving``: the axis whose
        position selects the rows. ``points`` (k,): positions of the rows, mm or deg. ``sign``: 1 or
        -1, factor from a table value to the correction.
        """
        chosen = self.given.choice("backlash_column", ("second_curve", "absent"), moving)
        if com.negative is None or np.all(np.isnan(com.negative)):
            return None
        if chosen == "second_curve":
            if np.isnan(com.negative[0]) or np.isnan(com.negative[-1]):
                self.given.faults.append(
                    com.place.fault(
                        "column BACKLASH is blank at an end of the table", expected="a value"
                    )
                )
                return None
            self.given.assumed.append(
                Assumption(
                    f"BACKLASH in {com.name}.COM",
                    "the whole curve arriving in -",
                    "MANUALplus 620 technical manual p. 715",
                )
            )
            return self._curve(
                moving, points, sign * com.negative * self._length(com, moving), com.place
            )
        own = com.values[:, com.columns.index(moving)]
        filled = ~np.isnan(com.negative)
        if not np.array_equal(com.negative[filled], own[filled]):
            self.given.faults.append(
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

    def load_sheet(self, sheet: JudgedSheet) -> None:
        """Load the points of an entry sheet, if it has any."""
        if sheet.points.size == 0:
            return
        self._check_grid(sheet)
        curve = self._curve(
            sheet.address,
            sheet.points,
            -sheet.values if sheet.errors else sheet.values,
            sheet.place,
        )
        self.own[sheet.address].append((sheet.place, OwnTable(curve, curve)))

    def _check_grid(self, sheet: JudgedSheet) -> None:
        """Check that an entry sheet's positions are equally spaced, as an iTNC 530 requires."""
        if self.given.generation.name != ITNC530.name or sheet.points.size < 2:
            return
        steps = np.arange(sheet.points.size)
        spacing = float(sheet.points[-1] - sheet.points[0]) / float(steps[-1])
        rule = self.given.choice("spacing_rule", ("free", "power_of_two"), sheet.address)
        if rule == "power_of_two":
            spacing = 2.0 ** round(np.log2(spacing / _EXPONENT_UNIT)) * _EXPONENT_UNIT
        off = float(np.max(np.abs(sheet.points - (sheet.points[0] + spacing * steps))))
        if off > _SHEET_POSITION:
            expected = "one spacing" if rule == "free" else "a spacing of 2^n * 0.0001"
            self.given.faults.append(
                sheet.place.fault(
                    "the positions are not equally spaced",
                    expected=expected,
                    found=f"off by {off:g}",
                )
            )

    def _curve(
        self, moving: str, points: FloatArray, values: FloatArray, place: LinePlace
    ) -> CorrectionCurve:
        """Return the curve through the rows that have a value.

        ``moving``: the axis whose position selects the rows. ``points`` (k,): positions, mm or deg.
        ``values`` (k,): corrections, NaN where blank. A rotary axis is endless if the job states
        its turn, or if its table covers 0 to 360 deg. Raises UsageError for a stated turn other
        than 360 deg.
        """
        filled = ~np.isnan(values)
        points, values = points[filled], values[filled] + 0.0
        self.given.assumed.append(
            Assumption(f"outside the table of {moving}", "the end values hold", "unconfirmed")
        )
        if self.given.kind(moving) is not AxisKind.ROTARY:
            return CorrectionCurve(points, values)
        turn = by_address(self.given.request.modulo, moving)
        if turn is not None and turn != TURN:
            raise UsageError(
                Fault(
                    message=f"axis {moving} has a wrong `modulo` (length of one turn)",
                    expected=f"{TURN:g} degrees",
                    found=f"{turn:g}",
                    hint=f"set `modulo: {TURN:g}` for this axis",
                )
            )
        if turn is None and whole_turn(points):
            self.given.assumed.append(
                Assumption(f"turn of {moving}", f"{TURN:g}", "its table reaches from 0 to 360 deg")
            )
        endless = turn is not None or whole_turn(points)
        curve = CorrectionCurve(
            points,
            values,
            endless=endless,
            one_turn=not endless and self.given.generation.name == ITNC530.name,
        )
        jump = float(np.interp(TURN, points, values) - np.interp(0.0, points, values))
        if endless and abs(jump) > _SAME_VALUE:
            self.given.notes.append(
                f"{place}: the table of {moving} jumps by {jump:g} (mm or deg) at every turn: 0 and"
                " 360 deg differ"
            )
        if curve.one_turn and leaves_turn(points):
            self.given.notes.append(
                f"{place}: entries of {moving} outside 0 to 360 deg are not used"
            )
        return curve

    def one_table(self, address: str) -> OwnTable | None:
        """Return the axis' own table, None without one; if the files contain several, a difference
        between them is a fault.
        """
        stated = self.own.get(address, [])
        for place, table in stated[1:]:
            first = stated[0][1]
            for mine, other in ((table.positive, first.positive), (table.negative, first.negative)):
                same = mine.points.size == other.points.size and (
                    bool(np.all(np.abs(mine.points - other.points) <= _SHEET_POSITION))
                    and bool(np.all(np.abs(mine.values - other.values) < _SAME_VALUE))
                )
                fault = place.fault(
                    f"the table of {address} differs from that of {stated[0][0]}",
                    expected="one table",
                )
                self.given.faults += [] if same or fault in self.given.faults else [fault]
        return stated[0][1] if stated else None
