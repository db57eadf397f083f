"""Convert a compensation to the parameters and pitch error data of one FANUC axis."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families.family import AxisTable, Family
from compwright.formats.families.increments.axis_reading import increment_limit
from compwright.formats.families.increments.axis_values import INCH, length_text, thousandths
from compwright.formats.families.increments.backlash import both_backlashes, covers
from compwright.formats.families.increments.inclination_and_cyclic import (
    InclinationAndCyclic,
    line_parameters,
    repeats_alone,
    second_table,
)
from compwright.formats.families.increments.increment_facts import (
    IncrementFacts,
    PointNumber,
    increments_of,
)
from compwright.formats.families.increments.moved_grid import check_sets, moved_numbers
from compwright.formats.families.increments.numbering import (
    NoRoom,
    NumberPlace,
    find_place,
    kept_place,
    used_numbers,
)
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.scale import NotHeld, NumberScale
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation

#: How far a point may be from its place on the grid, in spacings: arithmetic dust, not a wrong
#: grid.
_ON_GRID = 1e-6
#: 3627 is a 16-bit number.
OFFSETS = (-32767, 32767)


@dataclass(frozen=True, slots=True)
class Entries:
    """The values to enter for one axis: parameters by quantity, and increments by point number.

    - ``cleared``: point numbers that the axis no longer uses.
    - ``interval``: the distance of the table points, mm or deg.
    - ``switches``: whether 3605#0 (one or two data sets) has to be set for this table.
    - ``inch``: whether the files state that the machine is in inches (1001#0).
    - ``kept``: interval, reference and point numbers are the existing ones, so functions that refer
      to them stay valid; False: they change.
    - ``moved``: point numbers in the parameters of other functions, with their new values.
    - ``added``: parameters, as text, of an inclination line or second (cyclic) table that
      compwright adds. The increments of the second table are in ``points``.
    """

    address: str
    axis: Axis
    parameters: Mapping[str, str | Decimal]
    points: Mapping[int, int]
    cleared: tuple[int, ...]
    interval: float
    place: NumberPlace
    switches: bool
    inch: bool | None
    kept: bool
    moved: tuple[tuple[PointNumber, int], ...]
    added: Mapping[int, str]


def all_entries(family: Family, tables: Sequence[AxisTable]) -> tuple[Entries, ...]:
    """Return the values to enter for each axis, with point numbers that no two axes share.

    Raises UsageError if the free numbers are unknown, and CapacityError with every value that the
    control cannot hold.
    """
    start = _first_point(family, tables)
    faults: list[Fault] = []
    given: list[range] = []
    entries: list[Entries] = []
    leading = {
        normal_text(family.definition, axis.gantry): address
        for address, axis, _ in tables
        if axis.gantry is not None and axis.gantry_table == "same"
    }
    for address, axis, compensation in tables:
        # The old numbers of another axis of the job stay its own: tables may be loaded one by one.
        used = [*used_numbers(family.state, [address]), *given]
        try:
            rapid = increments_of(family.state.facts_of(leading.get(address, address)))
            entry = _WholeNumbers(family, address, axis, compensation, rapid).entries(used, start)
        except NotHeld as error:
            faults.append(
                Fault(
                    message=f"axis {axis.name} ({address}): the table cannot be written: {error}",
                    hint=(
                        f"correct the setting in the control, or `table` of axis {axis.name} in"
                        " the job"
                    ),
                )
            )
            continue
        given.extend((*entry.place.ranges, *(range(one, one + 1) for one in entry.points)))
        entries.append(entry)
    raise_all(CapacityError, faults)
    others = used_numbers(family.state, [address for address, _, _ in tables])
    taken = {
        number for numbers in (*others, *(entry.points for entry in entries)) for number in numbers
    }
    cleared = []
    for entry in entries:
        claimed = increments_of(family.state.facts_of(entry.address)).claimed
        # The number of the reference itself may hold something, though it owns no section.
        own = claimed[1:] if entry.kept else claimed
        left = tuple(number for numbers in own for number in numbers if number not in taken)
        taken.update(left)
        cleared.append(replace(entry, cleared=left))
    return tuple(cleared)


def _first_point(family: Family, tables: Sequence[AxisTable]) -> int:
    """Return the lowest point number to use, from the options of the controller or the axes.

    It is enough if one axis has this option: the tables of the other axes get the next free
    numbers. Raises UsageError if neither the control's files nor the job state which numbers are
    free.
    """
    if family.options.get("first_point") is not None:
        return first_point(family.options)
    own = [axis.options for _, axis, _ in tables if axis.options.get("first_point") is not None]
    if own or not tables or family.state.facts:
        return min(map(first_point, own), default=0)
    raise UsageError(free_numbers_question(family.definition))


def free_numbers_question(definition: Definition) -> Fault:
    """Return the question to the user which point numbers are free."""
    return Fault(
        message=(
            f"{definition.id}: the free point numbers are unknown. All axes share one "
            "array, so a number in use by another axis would change that axis"
        ),
        place="first_point",
        expected=(
            "the first free number (look at 3621 and 3622 of all axes), such as --option"
            " first_point=1, or the control's own parameter and pitch files (`states` or"
            " `--state`)"
        ),
        found="nothing",
        hint=(
            "look at 3621 and 3622 of all axes, then give the first free number: "
            "`--option first_point=1`, or `first_point: 1` in the options of the job"
        ),
    )


class _WholeNumbers:
    """The table of one axis, rounded to the whole increments that the control can store.

    ``rapid``: facts of the axis that has the existing backlashes. The difference between its two
    backlashes is kept.
    """

    def __init__(
        self,
        family: Family,
        address: str,
        axis: Axis,
        compensation: AxisCompensation,
        rapid: IncrementFacts,
    ) -> None:
        self.rapid = rapid
        self.definition = family.definition
        self.address = address
        self.axis = axis
        self.compensation = compensation
        self.axis_facts = family.state.facts_of(address)
        self.facts = increments_of(self.axis_facts)
        self.scale = family.scale_of(axis)
        self.options = self.scale.options
        self.unit = self.scale.quantum("value")
        existing = family.state.axes.get(address)
        self.others = 0 if existing is None else len(existing.others)

    def entries(self, used: Sequence[range], start: int) -> Entries:
        """Return the parameters and increments to enter for the table of the axis. ``used``: point
        numbers that are not free; ``start``: the lowest number for an axis without point numbers.

        Raises NotHeld if the control cannot hold the table.
        """
        steps, interval = self._grid()
        home = self.compensation.reference_return
        own, other = (self._counts(self.compensation.curve(side)) for side in (home, home.opposite))
        two = not np.array_equal(own, other)
        self._check_pair(own, steps, two=two)
        # The positive set comes first in the numbers, whichever direction is the zero state's.
        sets = [own] if not two else [own, other] if home is Direction.POSITIVE else [other, own]
        magnification = self._magnification([np.diff(counts) for counts in sets])
        low, high = int(steps[0]), int(steps[-1])
        kept = self._kept(low, high, interval, used, two=two)
        place = kept or self._place(low, high, used, start, two=two)
        points: dict[int, int] = {}
        for counts, numbers in zip(sets, place.ranges, strict=True):
            shift = numbers.start - place.first
            each = self._points(counts, steps, place, magnification)
            points |= {number + shift: value for number, value in each.items()}
        mine = self._added_functions(steps, place, [*used, *place.ranges], start)
        moved = moved_numbers(self.axis, self.facts, place, interval, magnification)
        parameters = self._parameters(place, magnification, interval)
        if self.axis.modulo is not None and kept is None:
            parameters["turn"] = self._length(float(self.axis.modulo))
        if two:
            parameters["negative_first"] = str(place.negative_first)
            parameters["negative_offset"] = self._offset(other[steps == 0][0], magnification)
        return Entries(
            address=self.address,
            axis=self.axis,
            parameters=parameters,
            points=dict(sorted((points | dict(mine.points)).items())),
            cleared=(),
            interval=interval,
            place=place,
            switches=two or self.facts.two_sets,
            inch=self.facts.inch,
            kept=kept is not None,
            moved=moved,
            added=mine.parameters,
        )

    def _parameters(
        self, place: NumberPlace, magnification: int, interval: float
    ) -> dict[str, str | Decimal]:
        parameters: dict[str, str | Decimal] = {
            "reference_number": str(place.reference),
            "first_number": str(place.first),
            "last_number": str(place.last),
            "magnification": str(magnification),
            "table_spacing": self._length(interval),
        }
        if "bidirectional" in self.definition.bindings:
            parameters["bidirectional"] = "0" if place.negative_first is None else "1"
        count = int(self.scale.write("backlash", self.compensation.backlash))
        for name, value in both_backlashes(self.axis, self.rapid, count).items():
            old = self.facts.backlash if name == "backlash" else self.facts.backlash_rapid
            parameters[name] = self._backlash(value, old)
        return parameters

    def _added_functions(
        self, steps: FloatArray, place: NumberPlace, used: Sequence[range], start: int
    ) -> InclinationAndCyclic:
        """Return the parameters and increments of the new inclination line and second (cyclic)
        table. ``steps``: the table points, counted in intervals from the reference; ``place``:
        their point numbers.
        """
        parameters: dict[int, str] = {}
        points: dict[int, int] = {}
        sign = -1 if self.options.get("pitch_sign") == "-" else 1
        for other in self.compensation.others[self.others :]:
            counts = self._counts(other.positive) * sign
            if not repeats_alone(other, self.compensation):
                numbers = [place.reference + int(steps[k]) for k in (1, -1)]
                parameters |= line_parameters(numbers, [int(counts[k]) for k in (1, -1)])
                continue
            section = self._length(float(other.positions[1] - other.positions[0]))
            interval = length_text(section, whole=thousandths(self.definition))
            highest = self.definition.limit_number("max_number") or 0
            second = second_table(counts, interval, [*used, *self.facts.claimed], start, highest)
            parameters |= second.parameters
            points |= second.points
        return InclinationAndCyclic(parameters, points)

    def _backlash(self, count: int, old: int | None) -> str:
        stage = self.facts.first_stage
        if covers(old, stage) and not covers(count, stage):
            raise NotHeld(
                f"1848 = {stage} is the part of the backlash that comes out at once (smooth"
                f" backlash); a new backlash of {count} instead of {old} does not contain it: set"
                " 1848 to 0 and measure again"
            )
        low, high = self.definition.measure("backlash").range
        if not low <= count <= high:
            raise NotHeld(
                "the backlash at cutting feed or rapid traverse (1851, 1852), whose difference"
                f" stays, would be {count}; the control can store {low:g} to {high:g}"
            )
        return str(count)

    def _grid(self) -> tuple[FloatArray, float]:
        """Return the distances of the table points from the reference as numbers of intervals (k,),
        and the interval in mm or deg.
        """
        positions = self.compensation.positions
        interval = float(positions[-1] - positions[0]) / (positions.size - 1)
        ratio = (positions - self.axis.reference) / interval
        steps: FloatArray = np.round(ratio)
        worst = float(np.max(np.abs(ratio - steps)))
        if worst > _ON_GRID:
            raise NotHeld(
                f"the points must lie at the reference position ({self.axis.reference:g}) plus"
                f" whole intervals of {interval:.9g}; one lies {worst * interval:.6g}"
                f" {self.axis.kind.unit} away"
            )
        if not steps[0] <= 0 <= steps[-1]:
            raise NotHeld(
                "the table must reach from the reference position, from which the control counts"
            )
        return steps, interval

    def _counts(self, curve: FloatArray) -> FloatArray:
        counts: FloatArray = np.round(curve / self.unit)
        worst = int(np.argmax(np.abs(curve / self.unit - counts)))
        if abs(curve[worst] / self.unit - counts[worst]) > 1e-3:
            raise NotHeld(
                f"{curve[worst]:.9g} {self.axis.kind.unit} is not a multiple of the detection unit"
                f" {self.unit:g}"
            )
        return counts

    def _check_pair(self, own: FloatArray, steps: FloatArray, *, two: bool) -> None:
        if own[steps == 0][0] != 0:
            raise NotHeld(
                "the table is not zero at the reference position in the direction of the reference"
                " return"
            )
        if two and self.compensation.backlash != 0:
            raise NotHeld(
                "two tables and a backlash value at once would compensate the reversal twice"
            )
        if two and self.axis.modulo is not None:
            raise NotHeld(
                "two tables on an endless axis: it is not known how the control joins their ends"
            )
        if self.axis.modulo is not None and own[0] != own[-1]:
            raise NotHeld(
                f"the two ends of the table of an endless axis must be equal: they differ by"
                f" {own[-1] - own[0]:g} detection units"
            )
        check_sets(self.facts, two=two)
        stated, home = self.axis_facts.reference_return, self.compensation.reference_return
        if two and stated is not None and stated is not home:
            raise NotHeld(
                "two tables need the direction of the reference return, which decides what 3627"
                f" means: the control's files say {stated.value} (1006#5), the job {home.value}"
            )

    def _magnification(self, differences: Sequence[FloatArray]) -> int:
        """Return the existing magnification if the control can store every increment with it, else
        the smallest one with which it can. ``differences``: the increments of each data set, in
        detection units.

        A magnification is possible if it divides every increment and each quotient is within the
        control's limit.
        """
        steps = np.concatenate(differences).astype(np.int64)
        limit = increment_limit(self.options)
        there = [self.facts.magnification] if self.facts.magnification else []
        candidates = [*there, *magnifications(self.definition, self.facts)]
        divisor = int(np.gcd.reduce(np.abs(steps))) or 1
        largest = int(np.max(np.abs(steps), initial=0))
        for candidate in candidates:
            if divisor % candidate == 0 and largest <= limit * candidate:
                return candidate
        raise NotHeld(
            f"an increment of {largest} detection units is more than the control can store: at"
            f" most {limit} times the magnification, which must divide all increments (their"
            f" greatest common divisor is {divisor}); a smaller spacing would help"
        )

    def _kept(
        self, low: int, high: int, interval: float, used: Sequence[range], *, two: bool
    ) -> NumberPlace | None:
        """Return the axis' existing point numbers if the new table has exactly the existing
        sections; else None. ``low``, ``high``: its ends in intervals from the reference; ``two``:
        it has one data set per direction.
        """
        now = self.facts.interval
        if now is None or abs(now - interval) > _ON_GRID * interval:
            return None
        highest = self.definition.limit_number("max_number") or 0
        endless = self.axis.modulo is not None
        return kept_place(
            low, high, self.facts, highest=highest, used=used, two=two, endless=endless
        )

    def _place(
        self, low: int, high: int, used: Sequence[range], start: int, *, two: bool
    ) -> NumberPlace:
        stated = self.axis.options.get("first_point") is not None
        try:
            return find_place(
                low,
                high,
                highest=self.definition.limit_number("max_number") or 0,
                used=used,
                two=two,
                reference=self.facts.reference_number if self.facts.claimed else None,
                negative=self.facts.negative_first if len(self.facts.claimed) > 1 else None,
                claimed=self.facts.claimed,
                start=first_point(self.options) if stated else start,
            )
        except NoRoom as error:
            raise NotHeld(str(error)) from error

    def _points(
        self, counts: FloatArray, steps: FloatArray, place: NumberPlace, magnification: int
    ) -> dict[int, int]:
        """Return the increments by point number, from the corrections ``counts`` at the points
        ``steps`` (intervals from the reference). A second set (travel towards -) gets the point
        numbers of the first set.
        """
        reference = place.reference
        sign = -1 if self.options.get("pitch_sign") == "-" else 1
        increments = (np.diff(counts) / magnification).astype(np.int64) * sign
        points = {
            reference + int(step): int(value)
            for step, value in zip(steps[1:], increments, strict=True)
        }
        if steps[0] == 0 and place.first == reference:
            # round a turn it stands for the last; else the travel starts at the reference
            last = points[reference + int(steps[-1])]
            points[reference] = last if self.axis.modulo is not None else 0
        if steps[-1] == 0 and place.last > reference:  # travel that ends at the reference
            points[place.last] = 0
        return points

    def _offset(self, count: float, magnification: int) -> str:
        sign = -1 if self.options.get("offset_sign") == "-" else 1
        if self.options.get("offset_magnified") == "yes":
            if count % magnification:
                raise NotHeld(
                    f"3627 counts in steps of the magnification {magnification}; {count:g} is none"
                )
            count /= magnification
        low, high = OFFSETS
        if not low <= count <= high:
            raise NotHeld(
                f"the reversal at the reference (3627) is {count:g} detection units; the control"
                f" can store {low} to {high}"
            )
        return str(int(count) * sign)

    def _length(self, value: float) -> Decimal:
        """Return a length (mm or deg) as a decimal. Raises NotHeld if the control rounds it."""
        count, unit = Decimal(repr(round(value, 9))), self.axis.kind.unit
        step, (low, high) = length_step(self.scale, self.facts), self.scale.range("table_spacing")
        if count % step:
            inch = (
                f" ({step / INCH:f} inch: the control counts in inches, 1001#0)"
                if self.facts.inch and self.axis.kind is AxisKind.LINEAR
                else ""
            )
            raise NotHeld(f"{value:.9g} {unit} is not a multiple of {step} {unit}{inch}")
        if not low <= value <= high:
            raise NotHeld(f"{value:.9g} {unit} is outside {low:g} .. {high:g} {unit}")
        return count


def magnifications(definition: Definition, facts: IncrementFacts) -> tuple[int, ...]:
    """Return the possible magnifications (parameter 3623) of an axis, ascending.

    If another function depends on the table, only the existing one is possible: it is not known
    whether the magnification also multiplies this function.
    """
    if facts.hung and facts.magnification:
        return (facts.magnification,)
    return tuple(range(1, (definition.limit_number("max_magnification") or 1) + 1))


def length_step(scale: NumberScale, facts: IncrementFacts) -> Decimal:
    """Return the value (mm or deg) of the last digit in which an axis' lengths are written.

    On a control in inches, lengths of a linear axis are written in inches, with one more decimal
    place.
    """
    step = Decimal(repr(scale.quantum("table_spacing")))
    return step * INCH / 10 if scale.kind is AxisKind.LINEAR and facts.inch else step


def first_point(options: Mapping[str, object]) -> int:
    """Return the lowest point number that the options allow; 0 without the option."""
    given = options.get("first_point")
    return 0 if given is None else int(str(given))
