"""Convert encoder counts of a motor to mm or deg of its axis and back, without rounding."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from compwright.formats.definition.schema import Definition
from compwright.formats.families.coupled_axes import CouplingStatement
from compwright.formats.text.scale import EXACTNESS, NotHeld
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import Axis, Direction, FloatArray

#: The option that states how many counts of the motor a mm or a degree has; negative where the
#: motor counts against its axis.
COUNTS = "counts_per_unit"
#: Parts of a count in an entry.
PARTS = 16
#: Counts that differ by less are the same: a definition may hold a small correction of the scale.
_SAME_COUNTS = 1e-3
_SIGN = {"correction": 1, "error": -1, "lost_motion": -1}


@dataclass(frozen=True, slots=True)
class Counts:
    """A motor's encoder counts per mm or degree of its axis, negative if it counts against the
    axis.
    """

    definition: Definition
    per_unit: float

    @property
    def quantum(self) -> float:
        """The correction in mm or deg that the table value 1 means."""
        return 1.0 / (PARTS * abs(self.per_unit))

    @property
    def count(self) -> float:
        """The travel of the axis, mm or deg, for one encoder count."""
        return 1.0 / abs(self.per_unit)

    @property
    def forward(self) -> Direction:
        """The axis direction in which the motor counts up; the control adds the backlash in the
        opposite direction.
        """
        return Direction.POSITIVE if self.per_unit > 0 else Direction.NEGATIVE

    def added(self, quantity: str, numbers: FloatArray) -> FloatArray:
        """Return the axis' correction (k,), mm or deg, for the table entries ``numbers`` (k,)."""
        return numbers * (_SIGN[self._sign(quantity)] / (PARTS * self.per_unit)) + 0.0

    def entries(self, quantity: str, added: FloatArray, what: str) -> list[int]:
        """Return the table entries (k,) that give the correction ``added`` (k,), mm or deg.

        An entry is a whole number of 1/16 count. Raises NotHeld for a correction that is not a
        multiple of this, or beyond the range of ``quantity``.
        """
        low, high = self.definition.measure(quantity).range
        ratio = added * (_SIGN[self._sign(quantity)] * PARTS * self.per_unit)
        numbers = np.round(ratio)
        for value, number, exact in zip(added, numbers, ratio, strict=True):
            if abs(exact - number) > EXACTNESS:
                raise NotHeld(
                    f"{what}: {value:.9g} is not a multiple of {self.quantum:.9g} (1/16 count)"
                )
            if not low <= number <= high:
                raise NotHeld(
                    f"{what}: {number:.0f} (1/16 count) is outside {low:.0f} to {high:.0f}; a"
                    " smaller correction would help"
                )
        return [int(number) for number in numbers]

    def _sign(self, quantity: str) -> str:
        return str(self.definition.measure(quantity).sign)


def counts_of(definition: Definition, options: Mapping[str, object], name: str) -> Counts:
    """Return a motor's counts per unit of its axis. Raises UsageError if they are unknown."""
    given = options[COUNTS]
    if isinstance(given, (int, float)) and given != 0:
        return Counts(definition, float(given))
    raise UsageError(counts_question(name, given))


def wrong_counts(counts: Counts, defined: float, place: CouplingStatement) -> Iterator[Fault]:
    """Yield a fault if the option for a motor's ``counts`` contradicts the axis definition in the
    script: ``defined`` counts per axis unit, at ``place``.
    """
    ratios = (defined / counts.per_unit / unit for unit in (1.0, MILLIMETRES_PER_INCH))
    if all(abs(ratio - 1.0) > _SAME_COUNTS for ratio in ratios):
        yield Fault(
            message=f"{COUNTS} contradicts the axis definition in this line of the script",
            file=place.file,
            place=f"line {place.line}",
            expected=f"{defined:g} ({defined / MILLIMETRES_PER_INCH:g} if the axis is in inches)",
            found=f"{counts.per_unit:g} ({place.words} in the script)",
            hint=(
                f"correct `{COUNTS}`: counts per mm or deg, negative where the motor counts against"
                " the axis; if this line counts in another unit, remove the line from the script"
            ),
        )


def counts_question(name: str, given: object) -> Fault:
    """Return the question how many counts a motor has per unit of the axis ``name``. ``given``: the
    option's unusable value; None if it is not given.
    """
    return Fault(
        message=f"axis {name}: the counts per mm or deg of its motor are not given, and the "
        "scripts do not state them with certainty",
        place=COUNTS,
        expected=(
            f"counts per mm or deg, such as --option {COUNTS}=1000; negative where the motor "
            "counts against the axis"
        ),
        found="nothing" if given is None else f"{given}",
        hint=(
            "find the counts per unit of the motor in the control, then give "
            f"`{COUNTS}` in the options of the axis"
        ),
    )


def around(axis: Axis | None, zero: float, step: float) -> tuple[float, int]:
    """Return the position of the table point at which a compensation begins, and the number of this
    point counted from motor zero. ``zero``: the axis position at motor zero; ``step``: the distance
    of points.

    For an axis with ends this is the last point at or below its travel, for an endless axis motor
    zero.
    """
    if axis is None or axis.modulo is not None:
        return zero, 0
    number = int(np.floor((axis.travel[0] - zero) / step + 1e-9))
    return zero + number * step, number


def turned_about(curve: FloatArray, first: int, counts: Counts) -> FloatArray:
    """Return table values (n + 1,) ordered by motor position, beginning at motor zero. ``curve``:
    the values by axis position; ``first``: the number of its first point, counted from motor zero.
    """
    size = curve.size - 1
    along = first + np.arange(size + 1)
    places = along if counts.forward is Direction.POSITIVE else -along
    turned: FloatArray = curve[np.mod(places, size)]
    return turned
