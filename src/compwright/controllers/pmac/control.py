"""PMAC and Turbo PMAC virtual control: leadscrew and backlash tables, constant backlash.

The rules are taken from the manuals (PMAC and Turbo PMAC, software reference and user manual),
independently of the definition that writes the scripts:

- ``DEFINE COMP``: a table of corrections, which are added. Their unit is 1/16 count of the target
  motor. Entry i is at i * length / entries counts of the source motor from motor zero, where the
  correction is 0. It is linear between entries and repeats after the length. ``I51`` enables all
  tables.
- ``DEFINE BLCOMP`` and ``Ixx86``: backlash, subtracted while the last commanded direction is
  negative. ``Ixx85`` = 0 switches both off.
- An axis is a motor, named by its number. The encoder counts per mm or deg are an option. Motor
  zero is the reference position.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.pmac.motor import Judged, Motor, MotorScale, looked_up
from compwright.controllers.pmac.script import Card, CardTable, run_scripts
from compwright.controllers.request import Request, finite_number, unknown_axis
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile


@dataclass(frozen=True, slots=True)
class PmacControl:
    """A PMAC after executing its scripts, all motors homed; interface
    ``controllers.virtual_control.VirtualControl``.

    The address of an axis is its motor number as text.
    """

    motors: Mapping[int, Motor]
    tables: Mapping[tuple[int, int], Sequence[CardTable]]
    scales: Mapping[int, MotorScale]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the numbers of the motors in the scripts, ascending."""
        return tuple(str(number) for number in self.motors)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of the entries of a motor's own tables, active or not, mm or
        deg.
        """
        number, motor = self._motor(address)
        return self._scale(number).points(motor.tables) if motor.tables else np.empty(0)

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction added to the command at ``positions`` (any shape) approached in
        ``direction``, mm or deg.
        """
        number, motor = self._motor(address)
        x = np.asarray(positions, dtype=np.float64)
        if motor.idle:
            return np.zeros(x.shape)
        scale = self._scale(number)
        negative = direction.sign * scale.counts < 0.0
        return motor.added(scale.motor(x), negative=negative) / scale.counts

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return (source motor, target motor) of the active tables between two motors."""
        return tuple((str(source), str(target)) for source, target in self.tables)

    def cross_correction(
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,  # noqa: ARG002
    ) -> FloatArray:
        """Return the correction of ``output`` with ``input`` at ``positions`` (any shape), mm or
        deg.

        The correction is the same in both directions. Raises UsageError for a pair of motors
        without a table.
        """
        pair = next(
            (one for one in self.tables if (str(one[0]), str(one[1])) == (input, output)), None
        )
        if pair is None:
            raise UsageError(
                Fault(
                    message=f"the scripts contain no table that corrects motor {output} over the "
                    f"position of motor {input}",
                    expected=" or ".join(f"{b} over {a}" for a, b in self.tables) or "a table",
                    hint=(
                        "correct the entry `cross` of the job, or give the script with this table"
                    ),
                )
            )
        where = self._scale(pair[0]).motor(np.asarray(positions, dtype=np.float64))
        total = np.zeros(where.shape)
        for table in self.tables[pair]:
            total = total + looked_up(table, where)
        return total / self._scale(pair[1]).counts

    def _motor(self, address: str) -> tuple[int, Motor]:
        number = int(address) if address.isdecimal() and len(address) < 10 else 0
        motor = self.motors.get(number)
        if motor is None:
            raise unknown_axis(address, self.addresses())
        return number, motor

    def _scale(self, number: int) -> MotorScale:
        scale = self.scales.get(number)
        if scale is None:
            raise _without_counts(number, None)
        return scale


def pmac_control(files: Sequence[ControlFile], request: Request) -> PmacControl:
    """Return the control after executing the scripts ``files`` in their order.

    Raises InputError for commands that the card would refuse, for contradictions, and for unknown
    commands that may compensate. Raises InputError also if an active compensation of an axis of the
    job cannot be evaluated. Raises UsageError if the option ``counts_per_unit`` of a corrected
    motor is missing or 0.
    """
    card = run_scripts(files)
    raise_all(InputError, [*card.faults, *_not_sent(card, request)])
    assumed: list[Assumption] = []
    judged = Judged(card, request, assumed)
    motors = judged.motors()
    crossing = judged.crossing() if judged.enabled else {}
    notes = _raised_or_noted(card, judged, request)
    faulty = {number for number, _ in judged.faults}
    motors = {number: motor for number, motor in motors.items() if number not in faulty}
    crossing = {pair: found for pair, found in crossing.items() if pair[1] not in faulty}
    needed = {number for number, motor in motors.items() if not motor.idle}
    scales = _scales(
        needed | {one for pair in crossing for one in pair}, crossing, request, assumed, card
    )
    _looked_up_by(card, assumed)
    tables = {pair: found for pair, found in crossing.items() if set(pair) <= scales.keys()}
    notes += [
        f"what motor {a} does to motor {b} is not given: option counts_per_unit"
        for a, b in crossing.keys() - tables.keys()
    ]
    return PmacControl(motors, tables, scales, tuple(assumed), tuple(notes))


def _not_sent(card: Card, request: Request) -> list[Fault]:
    """Return a fault for each command on the job's motors that may not have been sent to the card.

    If the job states that all were sent, return a fault for commands that exclude each other.
    """
    if request.carried_out:
        return [
            place.fault(f"{why}: not all of it was sent")
            for motor, place, why in card.not_both
            if not motor or request.is_under_work(str(motor))
        ]
    return [
        place.fault("is in a conditional block: state with `active` whether it was sent")
        for motor, place in card.left_out
        if not motor or request.is_under_work(str(motor))
    ]


def _raised_or_noted(card: Card, judged: Judged, request: Request) -> list[str]:
    """Raise the faults of motors of the job, and return those of other motors as notes."""
    faults = [
        fault for number, fault in judged.faults if not number or request.is_under_work(str(number))
    ]
    raise_all(InputError, list(dict.fromkeys(faults)))
    return [*card.notes, *(str(fault) for _, fault in judged.faults)]


def _scales(
    numbers: set[int],
    crossing: Mapping[tuple[int, int], Sequence[CardTable]],
    request: Request,
    assumed: list[Assumption],
    card: Card,
) -> dict[int, MotorScale]:
    """Return the encoder counts per mm or deg of each motor for which the job states them. They are
    required for the job's own motors, and for the source motors of their tables (``crossing``).
    """
    wanted = {number for number in numbers if request.is_under_work(str(number))}
    wanted |= {source for source, target in crossing if target in wanted}
    scales = {}
    for number in sorted(numbers):
        given = request.options_of(str(number)).get("counts_per_unit")
        counts = finite_number(given)
        if counts:
            if number in wanted:
                _agrees(number, counts, card)
            zero, why = request.referenced(str(number))
            assumed += [why] if why is not None else []
            scales[number] = MotorScale(counts, zero)
        elif number in wanted:
            raise _without_counts(number, given)
    return scales


def _agrees(number: int, counts: float, card: Card) -> None:
    """Raise InputError if a script's axis definition states different counts per unit.

    ``counts``: the option ``counts_per_unit``, counts per mm or deg. A definition of 1 count per
    unit is accepted, because the axis then counts in counts. A definition in counts per inch is
    accepted too.
    """
    for defined, place in card.axis_scales.get(number, ()):
        quotients = (defined / counts, defined / counts / MILLIMETRES_PER_INCH)
        if abs(defined) == 1.0 or any(0.999 < one < 1.001 for one in quotients):
            continue
        raise InputError(
            place.fault(
                f"counts_per_unit {counts:g} of motor {number}",
                expected=f"{defined:g} counts per unit of its axis",
            )
        )


def _without_counts(number: int, given: object) -> UsageError:
    return UsageError(
        Fault(
            message=f"the option counts_per_unit of motor {number} is missing or wrong",
            expected="counts per mm or deg, negative where the motor counts against the axis",
            found="none" if given is None else repr(given),
            hint=("give `--option counts_per_unit=1000` with the value of this motor"),
        )
    )


def _looked_up_by(card: Card, assumed: list[Assumption]) -> None:
    for table in card.tables.values():
        if table.kind == "COMP" and not table.desired:
            fact = f"position that the table of motor {table.motor} is looked up by"
            assumed.append(
                Assumption(fact, "the commanded one", "actual, without D: they are close")
            )
