"""Single values of one axis in the files, and the length unit (inch or metric) of linear axes.

The unit is stated by a number (SINUMERIK's MD10240, LinuxCNC's LINEAR_UNITS) or by a word on a line
of its own. If the files contain both, they must agree.
"""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal

from compwright.formats.definition.schema import Choice
from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.notes import CORRECT_VALUE, KEEP_ONE, NOT_COUNTED, Notes
from compwright.formats.text.values import Values, bit_mask


@dataclass(frozen=True, slots=True)
class GridAxisValues(Values):
    """Single values of one axis and its measuring system (``system``) in the ``gathered`` files."""

    gathered: Gathered
    address: str
    system: str | None

    def places(self, quantity: str) -> list[FoundValue]:
        """Return each value that the files state for a quantity of the axis, with its file and
        line.
        """
        return self.gathered.found(quantity, self.address, self.system)

    def single(self, quantity: str, *, quiet: bool = True) -> FoundValue | None:
        """Return the value of a quantity that is in effect; unless ``quiet``, repetitions are
        reported.
        """
        return self.one(quantity, self.places(quantity), quiet=quiet)

    def stated_word(self, quantity: str) -> str | None:
        """Return the meaning, such as "no", of a setting with a few possible values; None if no
        file states the setting.
        """
        return self.word(quantity, self.single(quantity))

    def choice(self, quantity: str) -> str | None:
        """Return the meaning, such as "no", of a setting with a few possible values, or the
        default; None if the control has no such setting.
        """
        if quantity not in self.definition.bindings:
            return None
        if self.single(quantity, quiet=False) is not None:
            return self.stated_word(quantity)
        return self.absent(quantity, quantity.replace("_", " "))


#: What says it: by number, by word.
SAYING = ("length_unit", "unit_word")
_INCH = Decimal("25.4")
#: Linear and angular positions, and their compensation values, among the units of the user's own.
_USERS_LENGTHS = 1 << 0 | 1 << 1 | 1 << 11 | 1 << 12


def basic_system(gathered: Gathered, notes: Notes) -> str | None:
    """Return the length unit of the files, mm or inch. None if they do not state it.

    It is a fault if the files contradict each other, or if an inch is not 25.4 mm long. It is also
    a fault if positions or compensation values are in a user-defined unit (MD10220).
    """
    by_word = _places(gathered)
    if "unit_word" in gathered.definition.bindings and {"mm", "inch"} <= by_word.keys():
        notes.refuse(
            "basic system",
            f"this line says inch, {by_word['mm'].where} says metric (MD10240, METRIC, INCH)",
            by_word["inch"],
            expected="inch or metric in all files",
            hint=KEEP_ONE,
        )
    lengths = gathered.singles.get((None, None), {}).get("inch_length", [])
    if "inch" in by_word and lengths and Decimal(lengths[-1].text) != _INCH:
        notes.refuse(
            "basic system",
            "the control works in inch, and MD10250 $MN_SCALING_VALUE_INCH gives its inch a"
            " different length",
            lengths[-1],
            expected=f"{_INCH} mm",
            hint=CORRECT_VALUE,
        )
    masks = gathered.singles.get((None, None), {}).get("unit_mask", [])
    if masks and ((bits := bit_mask(masks[-1].text)) is None or bits & _USERS_LENGTHS):
        notes.refuse(
            "basic system",
            "positions or compensation values are in a user-defined unit (MD10220"
            " $MN_SCALING_USER_DEF_MASK)",
            masks[-1],
            expected="a mask without the bits 0, 1, 11 and 12",
            hint=NOT_COUNTED,
        )
    return next(iter(by_word), None)


def _places(gathered: Gathered) -> dict[str, FoundValue]:
    """Return for each length unit (mm, inch) the first line in the files that states it."""
    definition = gathered.definition
    places: dict[str, FoundValue] = {}
    values = Values(definition, "basic system", Notes())
    for quantity in SAYING:
        binding = definition.bindings.get(quantity)
        if isinstance(binding, Choice):
            for found in gathered.singles.get((None, None), {}).get(quantity, ()):
                word = values.known_word(binding, found.text)
                if word is not None:
                    places.setdefault(word, found)
    return places
