"""Compensation -> what has to be entered for one axis of a control with increments by section
(FANUC): numbers and places.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import axis_options
from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments.axis import increment_limit, thousandths
from compwright.formats.families.increments.numbering import NoRoom, Place, find_place
from compwright.formats.families.increments.reading import claimed_numbers, used_numbers
from compwright.formats.text.scale import NotHeld, Scale
from compwright.foundations.errors import CapacityError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlState
from compwright.records.facts import Fact

#: How far a node may be from its place on the grid, in spacings: arithmetic dust, not a wrong grid.
_ON_GRID = 1e-6
#: 3627 is a 16-bit number.
OFFSETS = (-32767, 32767)


@dataclass(frozen=True, slots=True)
class Entries:
    """What goes into the control for one axis: parameters by quantity, as text, and increments by
    point number.

    ``cleared``: numbers that the axis no longer uses. ``kind`` decides the letter of a length.
    ``switches``: whether 3605#0 has to change for it, as far as the control's files say.
    ``unit_known``, ``inch``: what the control's files say of its unit (1001#0).
    """

    address: str
    name: str
    kind: AxisKind
    parameters: Mapping[str, str]
    points: Mapping[int, int]
    cleared: tuple[int, ...]
    interval: float
    reference: float
    place: Place
    switches: bool
    unit_known: bool = False
    inch: bool = False


def all_entries(
    definition: Definition,
    pairs: Sequence[tuple[str, Axis, AxisCompensation]],
    options: Mapping[str, object],
    state: ControlState | None,
) -> tuple[Entries, ...]:
    """Return what has to be entered for each axis; the axes get point numbers apart from each other
    and from all others'.

    Raises UsageError where nobody says which numbers are free, CapacityError with everything that
    the control cannot hold.
    """
    facts = {} if state is None else {one: said.said for one, said in state.facts.items()}
    others = used_numbers(state, [address for address, _, _ in pairs])
    given: list[range] = []
    stated = [
        first_point(axis.options)
        for _, axis, _ in pairs
        if axis.options.get("first_point") is not None
    ]
    start = (
        first_point(options) if options.get("first_point") is not None else min(stated, default=0)
    )
    ask_first_point(definition, [axis for _, axis, _ in pairs], options, state)
    faults: list[Fault] = []
    entries: list[Entries] = []
    for address, axis, compensation in pairs:
        try:
            own = axis_options(definition, options, axis)
            # The old numbers of another axis of the job stay its own: tables may be loaded one by
            # one.
            used = [*used_numbers(state, [address]), *given]
            entry = _Axis(definition, address, axis, compensation, own, facts).entries(used, start)
        except NotHeld as error:
            faults.append(Fault(message=f"axis {axis.name} ({address}): {error}"))
            continue
        except CapacityError as error:
            faults.extend(error.faults)
            continue
        given.extend(entry.place.ranges)
        entries.append(entry)
    raise_all(CapacityError, faults)
    taken = {number for entry in entries for number in entry.points}
    cleared = []
    for entry in entries:
        cleared.append(
            replace(entry, cleared=_cleared(facts.get(entry.address, {}), taken, others))
        )
        taken |= set(cleared[-1].cleared)
    return tuple(cleared)


def ask_first_point(
    definition: Definition,
    axes: Sequence[Axis],
    options: Mapping[str, object],
    state: ControlState | None,
) -> None:
    """Raise UsageError where neither the control's files nor the job say which point numbers are
    free.

    One axis' ``first_point`` is enough: the others follow on from it.
    """
    if (state is not None and state.facts) or options.get("first_point") is not None or not axes:
        return
    if any(axis.options.get("first_point") is not None for axis in axes):
        return
    raise UsageError(
        Fault(
            message=(
                f"{definition.id}: nobody says which point numbers are free; all axes share one"
                " array, and a number that another axis uses would change that axis"
            ),
            place="first_point",
            expected=(
                "the first free number (look at 3621 and 3622 of all axes), or the control's own"
                " parameter and pitch files as the state, which say it"
            ),
            found="nothing",
        )
    )


def _cleared(
    said: Mapping[str, Fact], taken: Collection[int], others: Sequence[range]
) -> tuple[int, ...]:
    """Return the numbers that an axis had and nobody uses any more."""
    return tuple(
        number
        for numbers in claimed_numbers(said)
        for number in numbers
        if number not in taken and not any(number in other for other in others)
    )


class _Axis:
    """One axis' table as whole numbers."""

    def __init__(
        self,
        definition: Definition,
        address: str,
        axis: Axis,
        compensation: AxisCompensation,
        options: Mapping[str, object],
        facts: Mapping[str, Mapping[str, Fact]],
    ) -> None:
        self.definition = definition
        self.address = address
        self.axis = axis
        self.compensation = compensation
        self.options = options
        self.facts = facts.get(address, {})
        self.scale = Scale(definition, axis.kind, options, {})
        self.unit = self.scale.quantum("value")

    def entries(self, used: Sequence[range], start: int) -> Entries:
        """Return what is entered; ``start``: the lowest number for an axis that has none and says
        none itself.
        """
        steps, interval = self._grid()
        home = self.compensation.reference_return
        own, other = (self._counts(self.compensation.curve(side)) for side in (home, home.opposite))
        two = not np.array_equal(own, other)
        self._check_pair(own, steps, two=two)
        said = self.facts.get("reference_return")
        if two and said is not None and said != home.value:
            raise NotHeld(
                "two tables need the direction of the reference return, which decides what 3627"
                f" means: the control's files say {said} (1006#5), the job {home.value}"
            )
        sets = [own, other] if two else [own]
        magnification = self._magnification([np.diff(counts) for counts in sets])
        place = self._place(int(steps[0]), int(steps[-1]), used, start, two=two)
        # The positive set comes first in the numbers, whichever direction is the zero state's.
        positive, negative = (own, other) if home is Direction.POSITIVE else (other, own)
        points = self._points(positive, steps, place.first, place.reference, magnification)
        if two and place.negative_first is not None:
            shift = place.negative_first - place.first
            points |= {
                number + shift: value
                for number, value in self._points(
                    negative, steps, place.first, place.reference, magnification
                ).items()
            }
        parameters = {
            "reference_number": str(place.reference),
            "first_number": str(place.first),
            "last_number": str(place.last),
            "magnification": str(magnification),
            "table_spacing": self._length(interval),
            "backlash": self.scale.write("backlash", self.compensation.backlash),
            "bidirectional": "1" if two else "0",
        }
        rapid, backlash = self.facts.get("backlash_rapid"), self.facts.get("backlash_count", 0)
        if (
            isinstance(rapid, int)
            and isinstance(backlash, int)
            and self.facts.get("separate_rapid") != "no"
        ):
            parameters["backlash_rapid"] = self._rapid(
                rapid + int(parameters["backlash"]) - backlash
            )
        if self.axis.modulo is not None:
            parameters["turn"] = self._length(float(self.axis.modulo))
        if two:
            parameters["negative_first"] = str(place.negative_first)
            parameters["negative_offset"] = self._offset(other[steps == 0][0], magnification)
        return Entries(
            address=self.address,
            name=self.axis.name,
            kind=self.axis.kind,
            parameters=parameters,
            points=dict(sorted(points.items())),
            cleared=(),
            interval=interval,
            reference=self.axis.reference,
            place=place,
            switches=two or self.facts.get("bidirectional") == "yes",
            unit_known="length_unit" in self.facts,
            inch=self.facts.get("length_unit") == "inch",
        )

    def _rapid(self, count: int) -> str:
        """Return 1852, which acts at rapid traverse where 1800#4 is 1: it changes as 1851 does, so
        that their difference stays.
        """
        low, high = self.definition.measure("backlash").range
        if not low <= count <= high:
            raise NotHeld(
                f"the backlash at rapid traverse (1852) would be {count}; the control holds {low:g}"
                f" to {high:g}"
            )
        return str(count)

    def _grid(self) -> tuple[FloatArray, float]:
        """Return the nodes as whole spacings from the reference, and the spacing."""
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
        if self.axis.modulo is not None:
            if two:
                raise NotHeld(
                    "two tables on an endless axis: nothing confirmed is known about how the"
                    " control closes them"
                )
            if own[0] != own[-1]:
                raise NotHeld(
                    f"the table of an endless axis must close: it creeps by {own[-1] - own[0]:g}"
                    " detection units each turn"
                )

    def _magnification(self, differences: Sequence[FloatArray]) -> int:
        """Return the smallest magnification that divides every increment and keeps it within the
        limit.
        """
        steps = np.concatenate(differences).astype(np.int64)
        limit = increment_limit(self.options)
        most = self.definition.limit_number("max_magnification") or 1
        divisor = int(np.gcd.reduce(np.abs(steps))) or 1
        largest = int(np.max(np.abs(steps), initial=0))
        for candidate in range(1, most + 1):
            if divisor % candidate == 0 and largest <= limit * candidate:
                return candidate
        raise NotHeld(
            f"an increment of {largest} detection units is more than the control holds: at most"
            f" {limit} times the magnification, which must divide all increments (their greatest"
            f" common divisor is {divisor}); a smaller spacing would help"
        )

    def _place(self, low: int, high: int, used: Sequence[range], start: int, *, two: bool) -> Place:
        own = self.facts.get("reference_number")
        try:
            return find_place(
                low,
                high,
                highest=self.definition.limit_number("max_number") or 0,
                used=used,
                two=two,
                reference=own if isinstance(own, int) and claimed_numbers(self.facts) else None,
                start=(
                    start
                    if self.axis.options.get("first_point") is None
                    else first_point(self.options)
                ),
            )
        except NoRoom as error:
            raise NotHeld(str(error)) from error

    def _points(
        self, counts: FloatArray, steps: FloatArray, first: int, reference: int, magnification: int
    ) -> dict[int, int]:
        sign = -1 if self.options.get("pitch_sign") == "-" else 1
        increments = (np.diff(counts) / magnification).astype(np.int64) * sign
        points = {
            reference + int(step): int(value)
            for step, value in zip(steps[1:], increments, strict=True)
        }
        if self.axis.modulo is not None:
            points[reference] = points[reference + int(steps[-1])]
        elif steps[0] == 0:  # travel that starts at the reference: 3621 must not lie above 3620
            points[first] = 0
        if steps[-1] == 0:  # travel that ends at the reference: 3622 must lie above 3620
            points[reference + 1] = 0
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
                f" holds {low} to {high}"
            )
        return str(int(count) * sign)

    def _length(self, value: float) -> str:
        """Return a length in mm or deg exactly, as the control's text wants it."""
        count = Decimal(repr(round(value, 9)))
        digits = length_step(self.axis.kind, self.facts)
        if count % digits:
            inch = (
                " (0.0001 inch: the control counts in inches, 1001#0)"
                if digits != Decimal("0.001")
                else ""
            )
            raise NotHeld(
                f"{value:.9g} {self.axis.kind.unit} is not a multiple of {digits}"
                f" {self.axis.kind.unit}{inch}"
            )
        if thousandths(self.definition) and not count % Decimal("0.001"):
            return str(int(count / Decimal("0.001")))
        return real_text(count)


def length_step(kind: AxisKind, facts: Mapping[str, Fact]) -> Decimal:
    """Return the smallest step of a length, mm or deg: 0.001, and 0.0001 inch for the linear axes
    of a control in inches.
    """
    return (
        Decimal("0.00254")
        if kind is AxisKind.LINEAR and facts.get("length_unit") == "inch"
        else Decimal("0.001")
    )


def first_point(options: Mapping[str, object]) -> int:
    """Return the lowest point number that may be used; 0 where the control's files say which are
    free.
    """
    given = options.get("first_point")
    return 0 if given is None else int(str(given))


def real_text(value: Decimal) -> str:
    """Return a number as the control's own files write it: a decimal point and at least one decimal
    (``50.0``).
    """
    text = f"{value.normalize():f}"
    return text if "." in text else f"{text}.0"
