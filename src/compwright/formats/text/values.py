"""Select the value that is in effect from several lines in the files, or else the default."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.definition.statements import name_in_form
from compwright.formats.text.gathering import FoundValue, same_value
from compwright.formats.text.notes import CORRECT_VALUE, KEEP_ONE, Notes
from compwright.foundations.findings import Finding
from compwright.words.sentences import control_text

#: A fraction that a user wrote with a few digits (0.03937 for 1 / 25.4) differs by less than this.
_ROUNDING = 1e-5


def name_of(definition: Definition, quantity: str) -> str:
    """Return the control's name of a quantity: a parameter number, or the name of a variable."""
    return name_in_form(definition.statements[definition.bindings[quantity].statement].form)


@dataclass(frozen=True, slots=True)
class Values:
    """Selects the values of one axis or table.

    ``label``: the name of this axis or table in messages.
    """

    definition: Definition
    label: str
    notes: Notes

    def name(self, quantity: str) -> str:
        """Return the control's name of a quantity, such as a parameter number."""
        return name_of(self.definition, quantity)

    def one(
        self, quantity: str, places: Sequence[FoundValue], *, quiet: bool = False
    ) -> FoundValue | None:
        """Return the line whose value of a quantity is in effect; all files must state the same
        value. Unless ``quiet``, report a value that one file states repeatedly and differently.

        The definition states which value of one file is in effect: the first, the last, or any if
        all must be the same. None is returned if there is no value. If values contradict each
        other, None is returned and a fault is added with file and line of the second one.
        """
        if len(places) < 2:
            return places[0] if places else None
        rule = self.definition.bindings[quantity].repeated
        by_file: dict[int, list[FoundValue]] = {}
        for place in places:
            by_file.setdefault(place.number, []).append(place)
        chosen = [group[0] if rule == "first" else group[-1] for group in by_file.values()]
        first = chosen[0]
        for rival in places if rule == "same" else chosen:
            if not self._same(quantity, rival.text, first.text):
                message = f"{self.name(quantity)} contradicts {first.where}"
                self.notes.refuse(self.label, message, rival, expected=first.text, hint=KEEP_ONE)
                return None
        if not quiet and any(not self._same(quantity, one.text, first.text) for one in places):
            self.notes.findings.append(
                Finding.of(
                    "CW-S003",
                    "info",
                    label=self.label,
                    quantity=self.name(quantity),
                    rule=rule,
                    value=first.text,
                    where=first.where,
                )
            )
        return first

    def _same(self, quantity: str, one: str, other: str) -> bool:
        """Return whether two texts of a quantity are equal as numbers, or have the same meaning for
        a setting with a few possible values.
        """
        binding = self.definition.bindings[quantity]
        if isinstance(binding, Choice) and (word := self.known_word(binding, one)) is not None:
            return word == self.known_word(binding, other)
        return same_value(one, other)

    def word(self, quantity: str, found: FoundValue | None) -> str | None:
        """Return the meaning, such as "no", of the value that the files state for a setting with a
        few possible values; None if unknown.

        If the definition does not list the value, a fault is added at its line.
        """
        binding = self.definition.bindings.get(quantity)
        if found is None or not isinstance(binding, Choice):
            return None
        word = self.known_word(binding, found.text)
        if word is None:
            self.notes.refuse(
                self.label,
                f"{self.name(quantity)} has a value that is not known",
                found,
                expected=f"one of {', '.join(binding.values)}",
                found=found.text[:40],
                hint=CORRECT_VALUE,
            )
        return word

    def known_word(self, binding: Choice, text: str) -> str | None:
        """Return the meaning of a text for a setting with a few possible values, upper or lower
        case; None if the definition does not list the text.

        A number in the definition's list also matches a text that is the same number rounded.
        """
        for known, word in binding.values.items():
            if same_value(known, text):
                return word
        for known, word in binding.values.items():
            if known.upper() == text.upper() or _nearly(known, text):
                return word
        return None

    def absent(self, quantity: str, meaning: str = "", *, tell: bool = True) -> str | None:
        """Return the default of a quantity that is in no file; None if it has no default. If the
        definition requires a report (and ``tell``), list the default as an assumption; ``meaning``:
        the quantity in words.

        The definition requires no report, an assumption, or an assumption with a warning.
        """
        absent = self.definition.bindings[quantity].when_absent
        if absent is None:
            return None
        name = self.name(quantity)
        if not tell:
            return absent.value
        if absent.say != "nothing":
            shown = f"{name} ({meaning})" if meaning else name
            self.notes.assume(
                control_text("{label}: {fact}", label=self.label, fact=shown),
                absent.value,
                absent.evidence.text,
            )
        if absent.say == "warning":
            self.notes.counted_as(self.label, name, absent.value)
        return absent.value


def _nearly(known: str, text: str) -> bool:
    """Return whether two texts are numbers that differ only by rounding, and the first has
    decimals.
    """
    if "." not in known:
        return False
    try:
        return math.isclose(float(known), float(text), rel_tol=_ROUNDING)
    except ValueError:
        return False


def bit_mask(text: str) -> int | None:
    """Return a bit mask as the control writes it (``'H3'``, ``'B11'``, 3); None for anything
    else.
    """
    word = text.strip("'\"").upper()
    for letter, base in (("H", 16), ("B", 2)):
        if word.startswith(letter):
            word, radix = word[1:], base
            break
    else:
        radix = 10
    try:
        return int(word, radix)
    except ValueError:
        return None
