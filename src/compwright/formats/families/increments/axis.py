"""One axis of a control with increments by section (FANUC): parameters and points -> its
compensation and facts.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.definition.options import (
    DETECTION_UNIT,
    REFERENCE,
    REFERENCE_RETURN,
    axis_options,
)
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.families.increments import acting
from compwright.formats.families.increments import parameters as known
from compwright.formats.families.increments.parameters import Parameters
from compwright.formats.families.increments.points import POINTS_FROM, fault_at, number_list
from compwright.formats.families.travel_limits import check_travel
from compwright.formats.text.gathering import Found, Gathered
from compwright.formats.text.notes import Notes
from compwright.formats.text.scale import Scale
from compwright.formats.text.values import Values
from compwright.foundations.errors import Fault, UsageError
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, Interpolation
from compwright.records.facts import Fact

#: Quantities that say where an axis' table lies.
GRID = ("reference_number", "first_number", "last_number", "magnification", "table_spacing")
#: Quantities of a path or of the machine: parameter, bit, neutral words for 0 and 1.
_BY_PATH = {
    "length_unit": (known.INCH, 0, ("mm", "inch")),
    "separate_rapid": (known.BACKLASH_BITS, 4, ("no", "yes")),
}
#: Detection units are the same within this part: what the job says in few digits.
_SAME_UNIT = 1e-4
#: Two positions are the same below this many mm or deg: a control counts in 0.0001 at the finest.
_SAME_PLACE = 1e-6


@dataclass(frozen=True, slots=True)
class Numbers:
    """Where an axis' table lies: numbers of the reference, the first and the last section, interval
    in mm or deg, magnification.

    ``negative``: first number of the set for travel in -; None: one set for both directions.
    """

    reference: int
    first: int
    last: int
    interval: float
    magnification: int
    negative: int | None = None


class IncrementReader:
    """Reads one axis. ``axis``: what the job knows of it, None without a job; not ``asked``: only
    its facts are wanted.
    """

    def __init__(
        self,
        definition: Definition,
        gathered: Gathered,
        points: Mapping[int, Found],
        parameters: Parameters,
        address: str,
        axis: Axis | None,
        options: Mapping[str, object],
        notes: Notes,
        *,
        asked: bool = True,
    ) -> None:
        self.definition = definition
        self.gathered = gathered
        self.points = points
        self.parameters = parameters
        self.address = address
        self.axis = axis
        self.notes = notes
        self.label = f"axis {address}"
        self.values = Values(definition, self.label, notes)
        self.said: dict[str, Found] = {}
        self.options = (
            self._settled(options) if asked else {**options, DETECTION_UNIT: 1.0}
        )  # only what is odd is asked of others

    # --- single values

    def found(self, quantity: str) -> Found | None:
        """Return where a quantity stands, for this axis or for the whole machine."""
        if quantity not in self.definition.bindings:
            return None
        places = self.gathered.found(quantity, self.address, None)
        found = self.values.one(quantity, places)
        if found is not None:
            self.said[quantity] = found
        return found

    def integer(self, quantity: str) -> int | None:
        """Return a whole number; None where the files do not hold it."""
        found = self.found(quantity)
        return None if found is None else int(Decimal(found.text))

    def word(self, quantity: str) -> str | None:
        """Return the neutral word of a choice; None where the files do not hold it."""
        if quantity in _BY_PATH:  # these may belong to a path: that of the axis counts
            number, bit, words = _BY_PATH[quantity]
            value = self.parameters.axis(number, self.address)
            return None if value is None else words[value.bit(bit)]
        found, binding = self.found(quantity), self.definition.bindings.get(quantity)
        return (
            binding.values.get(found.text)
            if found is not None and isinstance(binding, Choice)
            else None
        )

    def length(self, quantity: str, kind: AxisKind) -> Decimal | None:
        """Return a length in mm or deg: M metric, I inch, P the machine's unit; without a point in
        the control's own small unit.
        """
        found = self.found(quantity)
        if found is None:
            return None
        number = Decimal(found.text)
        inch = kind is AxisKind.LINEAR and self._in_inches(found.occurrence.tokens["key"].text)
        if "." not in found.text and number != 0:
            if not thousandths(self.definition):
                self.notes.faults.append(
                    fault_at(
                        found,
                        f"{self.label}: parameter {self.values.name(quantity)} is a length and"
                        " needs a decimal point",
                        "a number such as 50.0",
                        found.text,
                    )
                )
                return None
            number *= Decimal("0.0001") if inch else Decimal("0.001")
        return number * (Decimal("25.4") if inch else Decimal(1))

    # --- the axis

    def _settled(self, options: Mapping[str, object]) -> Mapping[str, object]:
        """Return the options of the axis; its files say the detection unit where the job does not,
        and must not contradict it.
        """
        said = acting.detection_unit(self.parameters, self.address, self.kind(quiet=True))
        mine = self.axis.options if self.axis is not None else {}
        given = mine.get(DETECTION_UNIT, options.get(DETECTION_UNIT))
        if said is None:
            silent = self.axis is None and given is None and not self._does_anything()
            if self.axis is not None and given is None:  # a contradiction comes before a question
                self._check_diameter(self.axis.kind)
                silent = bool(self.notes.faults)
                odd = acting.unread_unit(self.parameters, self.address)
                if odd is not None and not silent:
                    raise UsageError(
                        odd.fault(
                            f"{self.label}: the detection unit cannot be told from this value; give"
                            f" the option {DETECTION_UNIT}",
                            "mm or deg, such as 0.001; read are 1820 = 2 to 96 with IS-A, IS-B or"
                            " IS-C in 1013 and 1006#3 = 0",
                        )
                    )
            return axis_options(
                self.definition, {**options, DETECTION_UNIT: 1.0} if silent else options, self.axis
            )
        if given is None:
            self.notes.assume(
                f"{self.label}: detection unit",
                f"{said.size:g} {self.kind(quiet=True).unit}",
                f"read: {said.evidence}",
            )
            return axis_options(self.definition, {**options, DETECTION_UNIT: said.size}, self.axis)
        settled = axis_options(self.definition, options, self.axis)
        unit = float(str(settled[DETECTION_UNIT]))
        if abs(unit - said.size) > _SAME_UNIT * said.size and (
            self.axis is not None or self._does_anything()
        ):
            value = self.parameters.axis(known.MULTIPLIER, self.address)
            message = (
                f"{self.label}: the detection unit of the control's files is another than the"
                " option detection_unit"
            )
            fault = Fault(message=message) if value is None else value.fault(message)
            unit_name = self.kind(quiet=True).unit
            self.notes.faults.append(
                replace(
                    fault,
                    expected=f"{said.size:g} {unit_name} by {said.evidence}",
                    found=f"detection_unit: {unit:g}",
                )
            )
        return settled

    def _does_anything(self) -> bool:
        """Whether the axis has a table that is on, or a backlash value."""
        first, last = self.integer("first_number"), self.integer("last_number")
        return bool((self.integer("magnification") and first != last) or self.integer("backlash"))

    def _more_facts(self) -> dict[str, Fact]:
        """Return what other parameters say of the axis: detection unit, feed, whether it is endless
        and its turn.
        """
        kind = self.kind(quiet=True)
        facts: dict[str, Fact] = {}
        unit = acting.detection_unit(self.parameters, self.address, kind)
        if unit is not None:
            facts |= {"detection_unit": unit.size, "detection_unit_evidence": unit.evidence}
        rapid = self.parameters.axis(known.RAPID, self.address)
        if rapid is not None and rapid.acts:
            inch = kind is AxisKind.LINEAR and self._in_inches(rapid.key)
            facts["rapid_feed"] = float(Decimal(rapid.text) * (Decimal("25.4") if inch else 1))
        wraps = acting.wraps(self.parameters, self.address)
        if wraps is not None:
            facts |= {"endless": wraps, "turn": self._turn(kind)}
        home = self._home()
        if home is not None:
            facts["reference_return"] = home.value
        return facts

    def _home(self) -> Direction | None:
        """Return the direction of the reference return that the files say (1006#5); None where 1006
        is not in them.
        """
        bits = self.parameters.axis(known.KIND, self.address)
        return None if bits is None else Direction.NEGATIVE if bits.bit(5) else Direction.POSITIVE

    def _check_return(self, *, two: bool) -> None:
        """Hold 1006#5 against the job. It decides the sign of 3627, so two sets are refused; one
        set differs by a constant only.
        """
        home, job = self._home(), None if self.axis is None else self.axis.reference_return
        bits = self.parameters.axis(known.KIND, self.address)
        if home is None or bits is None or job is None or home is job:
            return
        message = (
            f"{self.label}: the reference return is towards {home.value} by 1006#5, towards"
            f" {job.value} in the job"
        )
        if two:
            expected = (
                f'reference_return: "{home.value}" in the job: with two sets it decides what 3627'
                " means"
            )
            self.notes.faults.append(bits.fault(message, expected))
            return
        self.notes.find(
            "CW-S044",
            "warning",
            f"{message}; with one set of data it only moves the zero by the backlash, so the job is"
            " followed; two sets are refused until they agree",
        )

    def _in_inches(self, key: str) -> bool:
        """Whether a length is in inches: M metric, I inch, P the machine's unit."""
        return {"M": False, "I": True}.get(key.upper(), self.word("length_unit") == "inch")

    def facts(self) -> dict[str, Fact]:
        """Return what the files say of this axis, by neutral name."""
        facts: dict[str, Fact] = {}
        for quantity in (
            "reference_number",
            "first_number",
            "last_number",
            "magnification",
            "negative_first",
            "negative_offset",
        ):
            value = self.integer(quantity)
            if value is not None:
                facts[quantity] = value
        for name, number in (("backlash_rapid", "backlash_rapid"), ("backlash_count", "backlash")):
            value = self.integer(number)
            if value is not None:
                facts[name] = value
        facts |= self._more_facts()
        facts["enabled"] = bool(facts.get("magnification", 0)) and facts.get(
            "first_number"
        ) != facts.get("last_number")
        for quantity in (
            "rotary",
            "diameter",
            "length_unit",
            "absolute_encoder",
            "separate_rapid",
            "bidirectional",
        ):
            word = self.word(quantity)
            if word is not None:
                facts[quantity] = word
        code = self.integer("axis_name")
        if code is not None and ord("A") <= code <= ord("Z"):
            facts["axis_name"] = chr(code)
        for quantity in ("limit_low", "limit_high", "reference_coordinate"):
            found = self.found(quantity)
            if found is not None and "." in found.text:
                facts[quantity] = float(self.length(quantity, self.kind(quiet=True)) or 0)
        return facts

    def kind(self, *, quiet: bool = False) -> AxisKind:
        """Return linear or rotary: from the job, else the files, else linear, which is noted unless
        ``quiet``.
        """
        word = self.word("rotary")
        if self.axis is None:
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
        if word is not None and word != self.axis.kind and not quiet:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"{self.label}: the job and the control's files disagree about its kind"
                        " (1006#0)"
                    ),
                    file=self.said["rotary"].occurrence.file,
                    place=self.said["rotary"].occurrence.place,
                    expected=self.axis.kind,
                    found=word,
                )
            )
        return self.axis.kind

    def read(self) -> AxisCompensation | None:
        """Return what acts on the axis; None where something is wrong (then the notes have
        faults).
        """
        kind = self.kind()
        self.notes.faults.extend(self.parameters.contradictions(self.address))
        self.notes.faults.extend(acting.refusals(self.parameters, self.address, self.label))
        if self.axis is not None or self._does_anything():
            self.notes.faults.extend(
                acting.unclear_path(self.parameters, self.address, self.label, kind)
            )
        for remark in acting.remarks(self.parameters, self.address, self.label):
            self.notes.find("CW-S040", "warning", remark)
        systems = acting.two_systems(self.parameters, self.address)
        if systems:
            self.notes.find(
                "CW-S043", "warning", f"{self.label}: {systems}; check the detection unit"
            )
        self._check_wrapping(kind)
        self._check_travel(kind)
        backlash = self._backlash(kind)
        numbers = self._numbers(kind)
        self._check_reference(kind, has_table=numbers is not None)
        self._check_return(two=numbers is not None and numbers.negative is not None)
        self._check_diameter(kind)
        if numbers is None:
            none = np.empty(0)
            return self._compensation(kind, none, none, none, backlash)
        self.notes.faults.extend(
            acting.meets(
                self.parameters, self.address, self.label, range(numbers.first, numbers.last + 1)
            )
        )
        values = self._increments(range(numbers.first, numbers.last + 1))
        other = None
        if numbers.negative is not None:
            count = numbers.last - numbers.first
            other = self._increments(range(numbers.negative, numbers.negative + count + 1))
        if values is None or (numbers.negative is not None and other is None):
            return None
        if self._repeats(kind, numbers):
            return self._endless(kind, numbers, values, backlash)
        reference = self._reference()
        steps = np.arange(numbers.first - 1, numbers.last + 1) - numbers.reference
        positions = np.round(reference + steps * numbers.interval, 9)
        scale = float(self._unit(kind)) * numbers.magnification * self._sign("pitch_sign")
        positive = totals(values, numbers) * scale
        negative = positive if other is None else totals(other, numbers) * scale
        if other is not None:
            positive, negative = self._offset(positive, negative, numbers, kind)
        return self._compensation(kind, positions, positive, negative, backlash)

    def _compensation(
        self,
        kind: AxisKind,
        positions: FloatArray,
        positive: FloatArray,
        negative: FloatArray,
        backlash: float,
        period: float | None = None,
    ) -> AxisCompensation:
        returns = (
            self.axis.reference_return
            if self.axis
            else Direction(str(self.options[REFERENCE_RETURN]))
        )
        interpolation: Interpolation = "linear" if self.options.get("output") == "ramp" else "step"
        return AxisCompensation(
            address=self.address,
            kind=kind,
            positions=positions,
            positive=positive + 0.0,
            negative=negative + 0.0,
            backlash=backlash,
            reference_return=returns,
            interpolation=interpolation,
            period=period,
        )

    def _check_reference(self, kind: AxisKind, *, has_table: bool) -> None:
        """Hold 1240 against the job's reference, and say what a reference beside zero rests on."""
        told = self.found("reference_coordinate")
        where = None
        if told is not None and ("." in told.text or thousandths(self.definition)):
            where = self.length("reference_coordinate", kind)
        job = None if self.axis is None else self.axis.reference
        if job is not None and where is not None and abs(float(where) - job) > _SAME_PLACE:
            message = "the job and the control's files disagree about the reference position (1240)"
            self._wrong(
                "reference_coordinate",
                message,
                f"{job:g}, as the job says",
                self.said["reference_coordinate"].text,
            )
        if has_table and (self._reference() != 0 or where):
            self.notes.find(
                "CW-S018",
                "warning",
                f"{self.label}: the reference position is not machine zero (1240); the points are"
                f" counted from the position {self._reference():g} (reference), which is"
                " unconfirmed: check the correction at two positions",
            )

    def _check_travel(self, kind: AxisKind) -> None:
        """Hold 1321 and 1320, the limits of the stroke, against the job's travel; where 1320 is not
        above 1321 none are set.
        """
        if self.axis is None or (
            kind is AxisKind.ROTARY and acting.wraps(self.parameters, self.address) != "no"
        ):
            return
        told = [self.found(name) for name in ("limit_low", "limit_high")]
        if any(one is None or "." not in one.text for one in told):
            return
        said = [self.length(name, kind) for name in ("limit_low", "limit_high")]
        if said[0] is None or said[1] is None:
            return
        limits = float(said[0]), float(said[1])
        check_travel(
            self.axis,
            limits,
            self.label,
            "1320, 1321",
            self.notes,
            lambda *words: self._wrong("limit_high", *words),
        )

    def _check_diameter(self, kind: AxisKind) -> None:
        """An axis in diameter programming: the job and 1006#3 must agree, else everything may be
        wrong by 2.
        """
        if kind is AxisKind.ROTARY:
            return
        said, job = self.word("diameter"), None if self.axis is None else self.axis.programmed
        if said == "yes" and job == "radius":
            self._wrong(
                "diameter",
                "1006#3 says diameter programming, the job does not",
                "programmed: diameter in the job",
                "radius",
            )
        if said == "no" and job == "diameter":
            self._wrong(
                "diameter",
                "1006#3 says radius programming, the job diameter",
                "programmed: radius in the job",
                "diameter",
            )
        if said != "yes" and job != "diameter":
            return
        if said is None:
            raise UsageError(
                Fault(
                    message=(
                        f"{self.label}: no file says whether the control counts the axis in"
                        " diameter (1006#3)"
                    ),
                    place="programmed",
                    expected=(
                        "the parameter file with 1006, or radius, in which everything of a job"
                        " counts"
                    ),
                    found="diameter",
                )
            )
        self.notes.find(
            "CW-S019",
            "warning",
            f"{self.label}: diameter programming (1006#3): positions, interval and corrections are"
            " taken in radius (unconfirmed); wrong by 2 is the usual fault, so check one position"
            " after loading",
        )

    def _check_wrapping(self, kind: AxisKind) -> None:
        """Whether the axis is endless, and its turn: the job and the files must say the same."""
        wraps, bits = (
            acting.wraps(self.parameters, self.address),
            self.parameters.axis(known.KIND, self.address),
        )
        if kind is not AxisKind.ROTARY or self.axis is None or wraps is None or bits is None:
            return
        modulo = self.axis.modulo
        if (modulo is not None) != (wraps == "yes"):
            says = (
                "endless (1006#0 = 1, 1006#1 = 0)"
                if wraps == "yes"
                else "one with ends (1006#0 = 1, 1006#1 = 1)"
            )
            expected = (
                f"modulo: {self._turn(kind):g} in the job"
                if wraps == "yes"
                else "no modulo in the job"
            )
            self.notes.faults.append(
                bits.fault(
                    f"{self.label}: the control takes the rotary axis for {says}, the job does not",
                    expected,
                )
            )
        elif modulo is not None and abs(self._turn(kind) - modulo) > _SAME_PLACE:
            message = (
                f"{self.label}: the turn of the control's files (3625, else 1260) is not the modulo"
                " of the job"
            )
            self.notes.faults.append(bits.fault(message, f"modulo: {self._turn(kind):g}"))

    def _unit(self, kind: AxisKind) -> Decimal:
        return Scale(self.definition, kind, self.options, {}).factor("value")

    def _sign(self, option: str) -> int:
        return -1 if self.options.get(option) == "-" else 1

    def _reference(self) -> float:
        return self.axis.reference if self.axis else float(str(self.options[REFERENCE]))

    def _turn(self, kind: AxisKind) -> float:
        """Return the travel per turn of a rotary axis, deg: 3625, else 1260, else what the job
        says, else 360.
        """
        turn = self.length("turn", kind)
        if turn:
            return float(turn)
        shown = self.parameters.axis(known.TURN, self.address)
        if shown is not None and shown.acts and "." in shown.text:
            return float(shown.text)
        return 360.0 if self.axis is None or self.axis.modulo is None else float(self.axis.modulo)

    def _repeats(self, kind: AxisKind, numbers: Numbers) -> bool:
        """Whether the axis is endless: the job says so, or the table of a rotary axis starts at the
        reference and spans a turn.

        Not where the files say that it has ends (1006#1): there a turn need not close.
        """
        if (
            kind is not AxisKind.ROTARY
            or numbers.negative is not None
            or acting.wraps(self.parameters, self.address) == "no"
        ):
            return False
        if self.axis is not None and self.axis.modulo is not None:
            return True
        return numbers.first - numbers.reference in (0, 1) and self._goes_round(kind, numbers)

    def _goes_round(self, kind: AxisKind, numbers: Numbers) -> bool:
        span = (numbers.last - numbers.reference) * numbers.interval
        return abs(span - self._turn(kind)) < _SAME_PLACE

    def _backlash(self, kind: AxisKind) -> float:
        found = self.found("backlash")
        if found is None:
            self.values.absent("backlash", "backlash")
            return 0.0
        low, high = self.definition.measure("backlash").range
        value = int(Decimal(found.text))
        if not low <= value <= high:
            self.notes.faults.append(
                fault_at(
                    found,
                    f"{self.label}: a backlash that the control cannot hold",
                    f"{low:g} .. {high:g}",
                    found.text,
                )
            )
        rapid = self.integer("backlash_rapid")
        if self.word("separate_rapid") != "no" and rapid is not None and rapid != value:
            self.notes.find(
                "CW-S015",
                "warning",
                f"{self.label}: cutting feed and rapid have different backlash values ({value} and"
                f" {rapid}"
                + (
                    "; 1800#4 = 1"
                    if self.word("separate_rapid") == "yes"
                    else "; 1800#4 is not in the files"
                )
                + "): what is shown here is cutting feed; a new table changes both values alike, so"
                " that their difference stays",
            )
        return float(value * self._unit(kind))

    def _numbers(self, kind: AxisKind) -> Numbers | None:
        """Return where the table lies; None where there is none, or where something is wrong (then
        the notes have faults).
        """
        present = {name: self.found(name) for name in GRID}
        if not any(present.values()):
            self.notes.assume(
                f"{self.label}: table",
                "none",
                "unconfirmed: no file that was given holds its parameters 3620 to 3624",
            )
            self.notes.no_table(self.label)
            return None
        magnification = self.integer("magnification")
        if magnification == 0:
            self.notes.switched_off(self.label, "3623 is 0, the table is off")
            return None
        missing = [self.values.name(name) for name, found in present.items() if found is None]
        if missing:
            first = next(name for name, found in present.items() if found is not None)
            self._wrong(
                first,
                "parameters of the table are missing",
                ", ".join(missing),
                "no such line in the files",
            )
            return None
        return self._checked(kind, int(magnification or 0))

    def _checked(self, kind: AxisKind, magnification: int) -> Numbers | None:
        reference, first, last = (
            int(self.integer(name) or 0)
            for name in ("reference_number", "first_number", "last_number")
        )
        highest = self.definition.limit_number("max_number") or 0
        most = self.definition.limit_number("max_magnification") or 100
        before = len(self.notes.faults)
        round_from_next = kind is AxisKind.ROTARY and first == reference + 1 and first < last
        if not first <= reference <= last and not round_from_next:
            self._wrong(
                "first_number",
                "the numbers are not in order",
                "3621 <= 3620 <= 3622",
                f"{first}, {reference}, {last}",
            )
        if last > highest:
            self._wrong(
                "last_number",
                "a number beyond those of the control",
                f"at most {highest}",
                str(last),
            )
        if not 0 <= magnification <= most:
            self._wrong(
                "magnification",
                "the magnification does not exist",
                f"0 .. {most}",
                str(magnification),
            )
        if first == last and len(self.notes.faults) == before:
            self.notes.switched_off(self.label, f"3621 = 3622 = {first}, the table has no section")
            return None
        interval = self.length("table_spacing", kind)
        if interval is not None and interval <= 0:
            self._wrong(
                "table_spacing", "the interval is not positive", "more than 0", str(interval)
            )
        negative = self._negative_first(first, last, highest)
        if len(self.notes.faults) > before or interval is None:
            return None
        numbers = Numbers(reference, first, last, float(interval), magnification, negative)
        if round_from_next:
            return self._next_to_reference(kind, numbers)
        return numbers

    def _next_to_reference(self, kind: AxisKind, numbers: Numbers) -> Numbers | None:
        """A full turn whose first number is that behind the reference's: real controls live with
        it, the manual has 3621 = 3620.
        """
        if not self._goes_round(kind, numbers) or numbers.negative is not None:
            expected = f"3621 <= 3620 <= 3622, or a full turn of {self._turn(kind):g} deg"
            found = f"{numbers.first}, {numbers.reference}, {numbers.last}"
            self._wrong("first_number", "the numbers are not in order", expected, found)
            return None
        self.notes.find(
            "CW-S041",
            "warning",
            f"{self.label}: 3621 = {numbers.first} is 3620 + 1 on a full turn, where the manual has"
            f" 3621 = 3620: numbers {numbers.first} to {numbers.last} are read as its sections, and"
            f" number {numbers.reference} is kept for the axis too",
        )
        return numbers

    def _wrong(self, quantity: str, message: str, expected: str, found: str = "") -> None:
        name = self.values.name(quantity)
        named = message if name in f"{message} {expected}" else f"{message} (parameter {name})"
        self.notes.faults.append(
            fault_at(self.said[quantity], f"{self.label}: {named}", expected, found)
        )

    def _negative_first(self, first: int, last: int, highest: int) -> int | None:
        """Return the first number of the set for travel in -, None with one set (or without its
        number: then there is a fault).
        """
        if self.word("bidirectional") != "yes":
            return None
        negative = self.integer("negative_first")
        if negative is None:
            self._wrong(
                "bidirectional",
                "bidirectional compensation is on (3605#0), but 3626 is missing",
                "3626",
            )
            return None
        end = negative + last - first
        if negative < 0 or end > highest:
            self._wrong(
                "negative_first",
                "the set for travel in - leaves the control's numbers",
                f"0 .. {highest}",
                f"{negative} .. {end}",
            )
        elif negative <= last and first <= end:
            self._wrong(
                "negative_first",
                "the two sets overlap",
                f"clear of {first} .. {last}",
                f"{negative} .. {end}",
            )
        return negative

    def _increments(self, numbers: range) -> FloatArray | None:
        missing = [number for number in numbers if number not in self.points]
        if missing:
            where = self.said["last_number"]
            what = f"{numbers.start} to {numbers.stop - 1}, without {number_list(missing)}"
            message = (
                f"{self.label}: point data are missing ({len(missing)} of {len(numbers)}); missing"
                " is not zero"
            )
            if not self.points:
                message = (
                    f"{self.label}: its table is on, and no file that was given holds pitch data;"
                    " the control saves them apart from its parameters"
                )
            self.notes.faults.append(
                fault_at(
                    where, message, f"the pitch data N{POINTS_FROM + missing[0]} and so on", what
                )
            )
            return None
        limit = increment_limit(self.options)
        values = []
        for number in numbers:
            row = self.points[number]
            value = int(row.occurrence.tokens["value"].text)
            if abs(value) > limit:
                message = (
                    f"{self.label}: an increment that the control cannot hold (option"
                    " increment_limit)"
                )
                self.notes.faults.append(fault_at(row, message, f"-{limit} .. {limit}", str(value)))
                return None
            values.append(value)
        return np.array(values, dtype=np.float64)

    def _offset(
        self, positive: FloatArray, negative: FloatArray, numbers: Numbers, kind: AxisKind
    ) -> tuple[FloatArray, FloatArray]:
        """Put 3627, the value at the reference against its return direction, on the curve that is
        not the zero state's.
        """
        found = self.found("negative_offset")
        if found is None:
            where = self.said["bidirectional"]
            self.notes.faults.append(
                fault_at(
                    where,
                    f"{self.label}: bidirectional compensation is on (3605#0), but 3627 is missing",
                    "3627",
                )
            )
        count = 0 if found is None else int(Decimal(found.text))
        magnified = numbers.magnification if self.options.get("offset_magnified") == "yes" else 1
        shift = float(count * magnified * self._unit(kind)) * self._sign("offset_sign")
        returns = (
            self.axis.reference_return
            if self.axis
            else Direction(str(self.options[REFERENCE_RETURN]))
        )
        self.notes.assume(
            f"{self.label}: bidirectional compensation",
            "as 3605#0, 3626 and 3627 are understood",
            "unconfirmed: no manual page",
        )
        return (
            (positive, negative + shift)
            if returns is Direction.POSITIVE
            else (positive + shift, negative)
        )

    def _endless(
        self, kind: AxisKind, numbers: Numbers, values: FloatArray, backlash: float
    ) -> AxisCompensation | None:
        turn = self._turn(kind)
        sections = numbers.last - numbers.reference
        where = self.said["last_number"]
        skipped = 1 - (
            numbers.first - numbers.reference
        )  # the number of the reference itself owns no section of its own
        if skipped not in (0, 1) or not self._goes_round(kind, numbers):
            self.notes.faults.append(
                fault_at(
                    where,
                    f"{self.label}: the table of an endless axis must span one turn (3622 = 3620 +"
                    " turn / interval)",
                    f"{turn:g} deg in whole sections",
                    f"{sections} sections of {numbers.interval:g} deg",
                )
            )
            return None
        creep = float(np.sum(values[skipped:]))
        unit = float(self._unit(kind)) * numbers.magnification
        if creep != 0:
            message = (
                f"{self.label}: the increments of one turn do not add up to zero: the axis creeps"
                f" by {creep * unit:g} deg each turn"
            )
            self.notes.faults.append(fault_at(where, message, "sum 0", f"{creep:g}"))
            return None
        if skipped and values[0] != values[-1]:
            self.notes.find(
                "CW-S016",
                "warning",
                f"{self.label}: point {numbers.reference} should hold the same value as point"
                f" {numbers.last} ({values[-1]:g})",
            )
        curve = (
            np.concatenate([[0.0], np.cumsum(values[skipped:])]) * unit * self._sign("pitch_sign")
        )
        positions = np.round(self._reference() + np.arange(sections + 1) * numbers.interval, 9)
        return self._compensation(kind, positions, curve, curve, backlash, turn)


def totals(values: FloatArray, numbers: Numbers) -> FloatArray:
    """Return the sums (k + 1,) of the increments (k,) ``first`` .. ``last`` at the nodes, zero at
    the reference.
    """
    sums = np.concatenate([[0.0], np.cumsum(values)])
    zero: FloatArray = sums - sums[numbers.reference - numbers.first + 1]
    return zero


def thousandths(definition: Definition) -> bool:
    """Return whether lengths without a decimal point count thousandths (0i-A to C, 16i), or are not
    allowed (30i).
    """
    return definition.measure("table_spacing").linear_unit == "um"


def increment_limit(options: Mapping[str, object]) -> int:
    """Return the largest increment of the control."""
    return int(str(options["increment_limit"]))
