"""Single values of one FANUC axis in the files, and the form in which the files write lengths."""

from __future__ import annotations

from dataclasses import dataclass
from decimal import Decimal

from compwright.formats.definition.schema import Definition
from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import AxisParameters
from compwright.formats.text.gathering import FoundValue, Gathered
from compwright.formats.text.notes import CORRECT_VALUE, EXPORT_AGAIN
from compwright.formats.text.values import Values
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import Axis, AxisKind, Direction

#: One inch, mm.
INCH = Decimal(str(MILLIMETRES_PER_INCH))


def thousandths(definition: Definition) -> bool:
    """Return whether lengths without a decimal point count thousandths (0i-A to C, 16i)."""
    return definition.measure("table_spacing").linear_unit == "um"


@dataclass(frozen=True, slots=True)
class IncrementAxisValues(Values):
    """The single values that the files state for one axis, such as backlash and turn.

    ``own``: parameters of the axis other than those of its table. ``axis``: the axis in the job,
    None without a job. ``known_kind``: the kind of the axis (linear, rotary) if the files do not
    state it.
    """

    gathered: Gathered
    own: AxisParameters
    axis: Axis | None
    known_kind: AxisKind | None = None

    def found(self, quantity: str) -> FoundValue | None:
        """Return the line that states a quantity for this axis or for the whole machine; None if
        there is none.
        """
        if quantity not in self.definition.bindings:
            return None
        return self.one(quantity, self.gathered.found(quantity, self.own.address, None))

    def integer(self, quantity: str) -> int | None:
        """Return a quantity that is a whole number; None if it is not in the files."""
        found = self.found(quantity)
        return None if found is None else int(Decimal(found.text))

    def yes(self, quantity: str) -> bool | None:
        """Return a quantity that is yes or no as a truth value; None if it is not in the files."""
        word = self.word(quantity, self.found(quantity))
        return None if word is None else word == "yes"

    def length(self, quantity: str, kind: AxisKind) -> Decimal | None:
        """Return a quantity that is a length, in mm or deg.

        The letter before the number states the unit: M metric, I inch, P the machine's unit. On
        some controls with increment system IS-B, a number without a decimal point counts 0.001 mm
        or deg, or 0.0001 inch. Elsewhere such a number is a fault.
        """
        found = self.found(quantity)
        if found is None:
            return None
        inch = self.in_inches(found.occurrence.tokens["key"].text, kind)
        number = Decimal(found.text) * (INCH if inch else 1)
        if "." in found.text or number == 0:
            return number
        if not thousandths(self.definition):
            message = f"parameter {self.name(quantity)} is a length and needs a decimal point"
            self.notes.refuse(
                self.label, message, found, expected="a number such as 50.0", hint=EXPORT_AGAIN
            )
            return None
        system = self.own.system
        if system is not None and (system.bit(0) or system.bit(1)):
            message = (
                f"parameter {self.name(quantity)} has no decimal point, and the increment system is"
                f" not IS-B ({system.label}): no page says what such a number counts then"
            )
            self.notes.refuse(
                self.label,
                message,
                found,
                expected="IS-B, or a number such as 50.0",
                hint=EXPORT_AGAIN,
            )
            return None
        return number * (Decimal("0.0001") if inch else Decimal("0.001"))

    def in_inches(self, key: str, kind: AxisKind) -> bool:
        """Return whether a length is in inches by the letter ``key`` before its number: M metric, I
        inch, P the machine's unit.
        """
        machine = bool(self.own.bit(known.INCH, 0))
        return kind is AxisKind.LINEAR and {"M": False, "I": True}.get(key.upper(), machine)

    def separate_rapid(self) -> bool | None:
        """Return whether rapid traverse has a separate backlash (1800#4); None if no file states
        it.
        """
        return self.own.bit(known.BACKLASH_BITS, 4)

    def does_anything(self) -> bool:
        """Return whether the axis has an active table or a backlash value."""
        first, last = self.integer("first_number"), self.integer("last_number")
        return bool((self.integer("magnification") and first != last) or self.integer("backlash"))

    def kind(self, *, quiet: bool = False) -> AxisKind:
        """Return the kind of the axis (linear, rotary) by the job, else the files, else an option,
        else a guess; the guess is reported unless ``quiet``.
        """
        place = self.found("rotary")
        word = self.word("rotary", place)
        if self.axis is not None:
            if word is not None and word != self.axis.kind and not quiet:
                message = "the job and the control's files disagree about its kind (1006#0)"
                self.notes.refuse(
                    self.label,
                    message,
                    place,
                    expected=self.axis.kind.value,
                    found=word,
                    hint=f"set `kind: {word}` for the axis in the job, if the control is right",
                )
                return AxisKind(word)  # as another kind its table would have faults too
            return self.axis.kind
        if word is None and self.known_kind is not None:
            return self.known_kind
        turn = self.found("turn")
        turns = turn is not None and Decimal(turn.text) != 0
        guess = "rotary" if turns else "linear"
        if word is None and not quiet:
            why = (
                "inferred: 3625 holds a travel per turn"
                if turns
                else "unconfirmed: neither a job nor the files say so"
            )
            self.notes.assume(f"{self.label}: kind", guess, why)
        return AxisKind(word or guess)

    def turn(self, kind: AxisKind) -> float:
        """Return the travel per turn of a rotary axis, deg: 3625, else 1260, else the job's, else
        360.
        """
        turn = self.length("turn", kind)
        if turn:
            return float(turn)
        shown = self.own.get(known.TURN)
        if shown is not None and shown.nonzero and "." in shown.text:
            return float(shown.text)
        return 360.0 if self.axis is None or self.axis.modulo is None else float(self.axis.modulo)

    def wraps(self) -> bool | None:
        """Return whether a rotary axis is endless (1006#0 = 1, 1006#1 = 0); None if linear or
        unknown.
        """
        bits = self.own.get(known.KIND)
        return not bits.bit(1) if bits is not None and bits.bit(0) else None

    def returning(self) -> Direction | None:
        """Return the reference return's direction in the files (1006#5); None if not stated."""
        negative = self.own.bit(known.KIND, 5)
        if negative is None:
            return None
        return Direction.NEGATIVE if negative else Direction.POSITIVE

    def wrong(
        self,
        quantity: str,
        message: str,
        expected: str,
        found: str = "",
        *,
        hint: str = CORRECT_VALUE,
    ) -> None:
        """Add a fault at the line of a quantity; the message contains the quantity's parameter
        number.
        """
        name = self.name(quantity)
        named = message if name in f"{message} {expected}" else f"{message} (parameter {name})"
        place = self.found(quantity)
        self.notes.refuse(self.label, named, place, expected=expected, found=found, hint=hint)


def length_text(value: Decimal, *, inch: bool = False, whole: bool = False) -> str:
    """Return a length (mm or deg) as text for the control's files. ``inch``: convert it to inches;
    ``whole``: write it without a decimal point, in thousandths of a mm or deg, or ten thousandths
    of an inch.

    Text with a decimal point has at least one decimal place (``50.0``).
    """
    if inch:
        value /= INCH
    if whole:
        return str(int(value / Decimal("0.0001" if inch else "0.001")))
    text = f"{value.normalize():f}"
    return text if "." in text else f"{text}.0"
