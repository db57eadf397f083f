"""Convert numbers in the control's text to mm or deg and back, without rounding.

Numbers are read as decimals and written as whole multiples of the last decimal place. So a number
that is written is read back unchanged.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import cast

from compwright.formats.definition.schema import Definition, Measure, OptionValue
from compwright.formats.definition.vocabulary import Sign
from compwright.records.axis import AxisKind
from compwright.records.options import DETECTION_UNIT

_FACTORS = {
    "mm": Decimal(1),
    "um": Decimal("0.001"),
    "deg": Decimal(1),
    "mdeg": Decimal("0.001"),
    "inch": Decimal("25.4"),
    "mm/m": Decimal("0.001"),
}
#: A number counts as a multiple of the quantum when it misses one by less than this part of it.
#: Doubles of 5 000 mm with a quantum of 1e-7 mm are good to 1e-5 of it; a value that was not
#: rounded misses by up to one half.
EXACTNESS = 1e-3


class NotHeld(ValueError):  # noqa: N818 - it says what is the matter, and never leaves the room
    """Raised if a control cannot store a value exactly, or if its files have no line or column for
    the value.
    """


@dataclass(frozen=True, slots=True)
class NumberScale:
    """Unit, sign and decimal places of the numbers of one axis in the control's text.

    ``choices``: the settings in the files on which signs depend, each with the meaning of its
    value.
    """

    definition: Definition
    kind: AxisKind
    options: Mapping[str, object]
    choices: Mapping[str, str]

    def unit(self, quantity: str) -> str:
        """Return the unit of numbers in the control's text: mm, inch or deg."""
        binding = self.definition.measure(quantity)
        if self.kind is AxisKind.ROTARY:
            return binding.rotary_unit
        unit = binding.linear_unit
        return str(self.options[unit.option]) if isinstance(unit, OptionValue) else unit

    def factor(self, quantity: str) -> Decimal:
        """Return the factor from the control's unit to mm or deg."""
        unit = self.unit(quantity)
        return Decimal(str(self.options[DETECTION_UNIT])) if unit == "pulse" else _FACTORS[unit]

    def quantum(self, quantity: str) -> float:
        """Return the value of the last decimal place in mm or deg."""
        return float(self._step(quantity) * self.factor(quantity))

    def range(self, quantity: str) -> tuple[float, float]:
        """Return the smallest and largest value of a quantity in mm or deg.

        If the control stores errors, the range is that of the correction, which has the opposite
        sign.
        """
        binding = self.definition.measure(quantity)
        factor = float(self.factor(quantity))
        low, high = binding.range[0] * factor, binding.range[1] * factor
        return (-high, -low) if self.sign(quantity) == "error" else (low, high)

    def sign(self, quantity: str) -> Sign:
        """Return what the numbers of a quantity mean, such as a correction or a position."""
        binding = self.definition.measure(quantity)
        if binding.sign_option is not None:
            return cast("Sign", self.options[binding.sign_option])
        if binding.sign_by is not None:
            return binding.signs[self.choices[binding.sign_by]]
        return binding.sign if binding.sign is not None else "position"

    def read(self, quantity: str, text: str, position: Decimal = Decimal(0)) -> Decimal:
        """Return a number in the control's text as a position, correction or backlash in mm or deg.
        ``position``: that of the table point, because some tables contain actual positions instead
        of corrections.
        """
        number = Decimal(text) * self.factor(quantity)
        sign = self.sign(quantity)
        if sign == "error":
            return -number
        return position - number if sign == "actual_position" else number

    def write(self, quantity: str, value: float, position: float = 0.0) -> str:
        """Return a value in mm or deg as text, in the unit and with the sign that the control uses.
        ``position``: that of the table point, because some tables contain actual positions instead
        of corrections.

        Raises NotHeld if the value needs more decimal places or is outside the range.
        """
        binding = self.definition.measure(quantity)
        count = self._count(quantity, value)
        low, high = self.range(quantity)
        slack = EXACTNESS * self.quantum(quantity)
        if not low - slack <= value <= high + slack:
            raise NotHeld(
                f"{value:.9g} {self.kind.unit} is outside {low:g} .. {high:g} {self.kind.unit}"
            )
        sign = self.sign(quantity)
        if sign == "error":
            count = -count
        elif sign == "actual_position":
            count = self._count(quantity, position) - count
        return f"{Decimal(count).scaleb(-binding.digits):f}"

    def _step(self, quantity: str) -> Decimal:
        return Decimal(1).scaleb(-self.definition.measure(quantity).digits)

    def _count(self, quantity: str, value: float) -> int:
        quantum = self.quantum(quantity)
        ratio = value / quantum
        count = round(ratio)
        if abs(ratio - count) > EXACTNESS:
            raise NotHeld(
                f"{value:.9g} {self.kind.unit} is not a multiple of {quantum:.9g} {self.kind.unit}"
            )
        return count


def in_range(measure: Measure, scale: NumberScale, value: Decimal) -> bool:
    """Return whether a value in mm or deg is within the range that the definition allows."""
    low, high = scale.range(measure.quantity)
    return low <= value <= high
