"""Read scripts as the active compensation of every motor that they name.

The position of the source motor before correction selects the table entry. The table repeats after
its length, and the correction at motor zero is 0. Towards decreasing counts the control subtracts
the constant backlash and the backlash table (PMAC manuals; sources in the definition).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.definition.options import axis_options, known_kind
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.families.activity import Activity
from compwright.formats.families.coupled_axes import check_couplings, with_couplings
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.families.wrapped.card_memory import (
    MemoryTable,
    Word,
    number_of,
    order_dependent_values,
    over_itself,
)
from compwright.formats.families.wrapped.counts import (
    Counts,
    around,
    counts_of,
    turned_about,
    wrong_counts,
)
from compwright.formats.families.wrapped.coupling import axis_letters, axis_scales, couplings_of
from compwright.formats.families.wrapped.script import read_script
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from compwright.records.options import REFERENCE, REFERENCE_RETURN


class WrappedStateReader:
    """Reads the state of a control from its scripts; see `Family.read` for arguments and errors."""

    def __init__(
        self,
        definition: Definition,
        options: Mapping[str, object],
        files: Sequence[ControlFile],
        axes: Sequence[Axis],
        address: str | None,
        activity: Activity,
    ) -> None:
        self.definition = definition
        self.options = options
        self.activity = activity
        self.notes = Notes()
        self.files = files
        self.axes: dict[str, Axis | None] = {}
        self.axes.update((normal_address(definition, axis)[0], axis) for axis in axes)
        self.wanted = list(self.axes)
        self.leading = {address: axis for address, axis in self.axes.items() if axis is not None}
        for axis in axes:
            if axis.gantry is not None:
                self.wanted.append(normal_text(definition, axis.gantry))
                self.axes.setdefault(self.wanted[-1], axis)
        if address is not None:
            self.wanted.append(normal_text(definition, address))
        for file in files:
            text = text_reader(definition).read(file, self.notes.faults)
            self.notes.findings.extend(text.findings if text is not None else ())
        raise_all(InputError, self.notes.faults)  # no text at all
        self.scales, self.letters = axis_scales(files), axis_letters(files)
        self.script = read_script(definition, files)
        self.notes.faults.extend(self.script.faults)
        self.notes.faults.extend(order_dependent_values(self.script))

    def read(self) -> ControlState:
        """Return the existing compensation in the control's files."""
        raise_all(InputError, self.notes.faults)
        self._ask_about_blocks()
        self._check_tables()
        raise_all(InputError, self.notes.faults)
        compensations: dict[str, AxisCompensation] = {}
        facts: dict[str, AxisFacts] = {}
        named, between = self._named(), self._between()
        if not self.wanted and not named and not between:
            self.notes.faults.append(
                Fault(
                    message="the scripts contain no compensation of any motor",
                    file=", ".join(file.name for file in self.files),
                    hint=(
                        "give the scripts with the compensation tables of this control, or correct "
                        "`format`"
                    ),
                )
            )
        for address in dict.fromkeys(self.wanted or named):
            if address not in named and address in between:
                continue
            if address not in named:
                lines = f"a table of #{address}, or its backlash (`I{address}86=0` without both)"
                self.notes.no_data(f"motor {address}", self.files, named, lines)
                continue
            compensations[address], facts[address] = self._motor(int(address))
        cross = tuple(
            found
            for table in self.script.of("COMP")
            if not table.plane and table.source != table.target
            if (found := self._cross(table)) is not None
        )
        couplings = couplings_of(self.files)
        check_couplings(couplings, self.leading, self.notes)
        facts = {
            address: with_couplings(stated, couplings, address) for address, stated in facts.items()
        }
        self.notes.ask_contradicted()
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        if any(self.axes.get(address) is None for address in compensations):
            source = "option or its default"
            self.notes.assume(REFERENCE, f"{self.options[REFERENCE]:g}", source)
            self.notes.assume(REFERENCE_RETURN, str(self.options[REFERENCE_RETURN]), source)
        return ControlState(
            format=self.definition.id,
            axes=compensations,
            cross=cross,
            facts=facts,
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def _ask_about_blocks(self) -> None:
        """Ask whether commands for the job's motors in conditional blocks were sent."""

        def concerns(motor: int) -> bool:
            return not self.wanted or not motor or str(motor) in self.wanted

        ours = [(word, block) for motor, word, block in self.script.conditional if concerns(motor)]
        if not ours:
            return
        if self.activity.carried_out:
            for motor, word, earlier in self.script.apart:
                if concerns(motor):
                    message = (
                        "active: yes, but this is in a different branch of a conditional block than"
                        f" line {earlier.line}: not both are sent"
                    )
                    expected = "the script as it was sent, without conditional blocks"
                    self.notes.faults.append(word.fault(message, expected=expected))
            for word, _ in ours:
                fact = f"{word.file}, line {word.line}: in a conditional block"
                self.notes.assume(fact, "sent to the card", "the job's answer (active)")
            return
        (word, block), more = ours[0], len(ours) - 1
        self.notes.ask(
            Fault(
                message=(
                    f"this conditional block contains compensation (line {word.line}"
                    f"{f' and {more} more' if more else ''}), and may not have been sent to the "
                    "control"
                ),
                file=word.file,
                place=f"line {block.line}",
                expected=(
                    "the script as it was sent, without conditional blocks; or states: {as_found:"
                    " {files: [...], active: yes}}"
                ),
                found=repr(block.text[:60]),
                hint=(
                    "give the script as it was sent, or answer `active: yes` in this entry of "
                    "`states` in the job if all of it was sent"
                ),
            )
        )

    def _named(self) -> list[str]:
        motors = {table.motor for table in self.script.of("BLCOMP")}
        motors |= {table.target for table in self.script.of("COMP") if table.source == table.target}
        motors |= {motor for name, motor in self.script.settings if name == "backlash"}
        return [str(motor) for motor in sorted(motors - {0})]

    def _between(self) -> set[str]:
        tables = self.script.of("COMP")
        return {str(motor) for table in tables for motor in (table.source, table.target)}

    def _check_tables(self) -> None:
        for table in (*self.script.of("COMP"), *self.script.of("BLCOMP")):
            if table.plane and any(table.numbers):
                message = (
                    f"{table.label}: a table over two motors is active, which compwright does not"
                )
                self.notes.faults.append(
                    table.word.fault(f"{message} read", expected="one motor, or all entries 0")
                )
            elif not table.plane and table.numbers[-1]:
                message = (
                    f"{table.label}: the last entry is not 0; it stands at motor zero, where the"
                    " correction is 0 by definition"
                )
                self.notes.faults.append(table.values[-1].fault(message, expected="0"))

    # --- one motor

    def _counts(self, motor: int) -> Counts:
        axis = self.axes.get(str(motor))
        options = axis_options(self.definition, self.options, axis)
        counts = counts_of(self.definition, options, axis.name if axis else str(motor))
        for defined, place in self.scales.get(motor, ()):
            for fault in wrong_counts(counts, defined, place):
                self.notes.once(fault)
        return counts

    def _motor(self, motor: int) -> tuple[AxisCompensation, AxisFacts]:
        axis, label = self.axes.get(str(motor)), f"motor {motor}"
        reversal = self.script.tables.get(("BLCOMP", motor))
        tables = over_itself(self.script, motor)
        constant = self._constant(motor, with_table=reversal is not None)
        self._check_programs(label, motor)
        both = [*tables, *([reversal] if reversal is not None else [])]
        on = self._on(label, needed=any(any(table.numbers) for table in both))
        taken = reversal is not None and on and any(reversal.numbers)
        lost = self._takes_up(label, motor, needed=bool(constant) or taken)
        for table in tables:
            if not table.desired and any(table.numbers):
                self._by_actual(table)
        rate = self.script.setting("take_up_rate", motor)
        stated = {} if rate is None else {"take_up_rate": number_of(rate)}
        named, idle = self.letters.get(motor, AxisFacts()), self._idle_points(motor, both)
        facts = replace(named, enabled=on, grid=idle, stated=stated)
        grids: dict[tuple[int, int], tuple[FloatArray, FloatArray]] = {}
        if (on and any(any(table.numbers) for table in both)) or (lost and constant):
            try:
                counts = self._counts(motor)
            except UsageError as error:
                for fault in error.faults:
                    self.notes.ask(fault)
                return _empty(motor, self._kind(str(motor), axis)), facts
            for table in tables if on else []:
                _add(grids, table, counts.added("value_positive", _closed(table)), both=True)
            if reversal is not None and on and lost:
                _add(grids, reversal, counts.added("value_negative", _closed(reversal)), both=False)
            step = counts.added("backlash", np.array([float(constant)]))[0] if lost else 0.0
            if grids:
                lost_motion = counts.forward.opposite.sign * float(step)
                facts = replace(facts, stated={**stated, "backlash_in_curves": lost_motion})
            return self._compensation(motor, axis, counts, grids, float(step)), facts
        return _empty(motor, self._kind(str(motor), axis)), facts

    def _kind(self, address: str, axis: Axis | None) -> AxisKind:
        known = axis.kind if axis else known_kind(self.options, address)
        return known or AxisKind.LINEAR

    def _compensation(
        self,
        motor: int,
        axis: Axis | None,
        counts: Counts,
        grids: Mapping[tuple[int, int], tuple[FloatArray, FloatArray]],
        step: float,
    ) -> AxisCompensation:
        """Return a motor's tables (``grids``, summed by their points) as one compensation."""
        parts: list[AxisCompensation] = []
        for (needed, length), (ahead, back) in grids.items():
            against = back + (0.0 if parts else step)
            place, where = around(axis, self._zero(axis), length / needed * counts.count)
            self._check_turn(motor, axis, length * counts.count)
            values = [turned_about(curve, where, counts) for curve in (ahead, against)]
            if counts.forward is Direction.NEGATIVE:
                values.reverse()
            parts.append(
                AxisCompensation(
                    address=str(motor),
                    kind=self._kind(str(motor), axis),
                    positions=place + np.arange(needed + 1) * length / needed * counts.count,
                    positive=values[0],
                    negative=values[1],
                    reference_return=counts.forward,
                    period=length * counts.count,
                )
            )
        if not parts:
            empty = _empty(motor, self._kind(str(motor), axis))
            amount = counts.forward.opposite.sign * step
            return replace(empty, backlash=amount, reference_return=counts.forward)
        return replace(parts[0], others=tuple(parts[1:]))

    def _idle_points(self, motor: int, tables: Sequence[MemoryTable]) -> tuple[float, ...]:
        """Return an inactive table's positions over one period, mm or deg; empty if unknown."""
        axis = self.axes.get(str(motor))
        if not tables or axis is None:
            return ()
        try:
            counts = self._counts(motor)
        except UsageError:
            return ()
        needed, length = tables[0].needed, tables[0].counts * counts.count
        begin, _ = around(axis, self._zero(axis), length / needed)
        return tuple(float(point) for point in begin + np.arange(needed + 1) * length / needed)

    def _zero(self, axis: Axis | None) -> float:
        return axis.reference if axis is not None else float(str(self.options[REFERENCE]))

    def _check_turn(self, motor: int, axis: Axis | None, period: float) -> None:
        turn = axis.modulo if axis is not None else None
        if turn is None or abs(turn / period - max(1, round(turn / period))) * period <= SAME_TURN:
            return
        self.notes.faults.append(
            Fault(
                message=f"motor {motor}: the table must repeat once per turn of the endless axis, "
                "or a whole number of times",
                expected=f"a table length of {turn:g}, or {turn:g} divided by a whole number",
                found=f"a table length of {period:.10g}",
                hint="correct the length of the table in the control and save its script again",
            )
        )

    # --- what switches

    def _on(self, label: str, *, needed: bool) -> bool:
        """Return whether tables are active, by the variable that activates all tables. ``needed``:
        a table has values, so the job's answer matters as well.
        """
        place = self.script.setting("enabled")
        binding = self.definition.bindings["enabled"]
        name = "I51"
        word = None
        if place is not None and isinstance(binding, Choice):
            word = binding.values.get(str(number_of(place)))
            if word is None:
                fault = place.fault(f"{name} is neither on nor off", expected="0 or 1")
                self.notes.faults.append(fault)
        if not needed:
            return word != "no"
        found = None if place is None else place.found
        stated = self.activity.was_active(label, name, word, found, self.notes)
        if stated is not None:
            return stated
        if word is None:
            absent = binding.when_absent
            self.notes.assume(f"{name}: tables act", "1", str(absent.evidence if absent else ""))
        else:
            self.notes.switched_off(label, f"{name} = 0")
        return word is None

    def _takes_up(self, label: str, motor: int, *, needed: bool) -> bool:
        """Return whether a motor's backlash compensation is active, because its rate is not 0.
        ``needed``: the motor has a backlash; without one the result is False.
        """
        if not needed:
            return False
        name, place = f"I{motor}85", self.script.setting("take_up_rate", motor)
        if place is not None:
            if self._ranged(place, name) != 0:
                return True
            if not self.activity.stated:
                self.notes.switched_off(label, f"{name} = 0 switches its backlash off")
                return False
        if self.activity.stated is not None:
            answer = "on" if self.activity.stated else "off"
            self.notes.assume(f"{name}: backlash is taken up", answer, "the job's answer (active)")
            return self.activity.stated
        self.notes.faults.append(
            Fault(
                message=f"{label} has backlash, but no script states whether the control "
                f"compensates it ({name})",
                file=", ".join(file.name for file in self.files),
                expected=f"{name} as it is in the control (0 switches backlash off)",
                found="nothing",
                hint="give the file that contains it with the control's other files",
            )
        )
        return False

    def _constant(self, motor: int, *, with_table: bool) -> int:
        """Return a motor's backlash in fractions of a count; ``with_table``: it must be stated."""
        name, place = f"I{motor}86", self.script.setting("backlash", motor)
        if place is not None:
            return self._ranged(place, name)
        if with_table:
            table = self.script.tables["BLCOMP", motor]
            message = f"{table.label} is added to {name}, which no script says"
            expected = f"{name} as it is in the control"
            self.notes.faults.append(table.word.fault(message, expected=expected, found="nothing"))
        else:
            absent = self.definition.bindings["backlash"].when_absent
            self.notes.assume(f"{name}: backlash", "0", str(absent.evidence if absent else ""))
        return 0

    def _ranged(self, place: Word, name: str) -> int:
        low, high = self.definition.measure("backlash").range
        number = number_of(place)
        if not low <= number <= high:
            limits = f"{low:.0f} to {high:.0f}"
            self.notes.faults.append(place.fault(f"{name} is out of its range", expected=limits))
        return number

    def _check_programs(self, label: str, motor: int) -> None:
        for (_, of), word in self.script.programs.items():
            if of in (0, motor):
                message = (
                    f"{label}: a program sets {word.text.rstrip('= ')}: what is active then is not"
                )
                expected = "the assignment outside the program, as it was during the test"
                self.notes.faults.append(word.fault(f"{message} known", expected=expected))

    def _by_actual(self, table: MemoryTable) -> None:
        self.notes.assume(
            f"{table.label}: looked up by the actual position",
            "counted as the commanded one",
            "inferred: they differ by the following error",
        )

    # --- tables between motors

    def _cross(self, table: MemoryTable) -> CrossCompensation | None:
        if not any(table.numbers):
            return None
        pair = [self.axes.get(str(motor)) for motor in (table.source, table.target)]
        label = f"motor {table.target} by motor {table.source}"
        self._check_programs(label, table.target)
        if not self._on(label, needed=True):
            return None
        try:
            source, target = self._counts(table.source), self._counts(table.target)
        except UsageError as error:
            for fault in error.faults:
                self.notes.ask(fault)
            return None
        if not table.desired:
            self._by_actual(table)
        step = float(table.counts / table.needed * source.count)
        place, where = around(pair[0], self._zero(pair[0]), step)
        curve = turned_about(target.added("value_positive", _closed(table)), where, source)
        kinds = [
            self._kind(str(motor), axis)
            for motor, axis in zip((table.source, table.target), pair, strict=True)
        ]
        return CrossCompensation(
            input=str(table.source),
            output=str(table.target),
            input_kind=kinds[0],
            output_kind=kinds[1],
            positions=place + np.arange(table.needed + 1, dtype=np.float64) * step,
            positive=curve,
            negative=curve,
            period=table.counts * source.count,
        )


def _closed(table: MemoryTable) -> FloatArray:
    """Return the table entries (n + 1,), beginning with the value 0 at motor zero."""
    return np.array([0, *table.numbers], dtype=np.float64)


def _add(
    grids: dict[tuple[int, int], tuple[FloatArray, FloatArray]],
    table: MemoryTable,
    added: FloatArray,
    *,
    both: bool,
) -> None:
    """Add a table's correction to the sum in ``grids`` of the tables with the same points: for both
    directions (``both``), or only against the counting direction.
    """
    none = (np.zeros(table.needed + 1), np.zeros(table.needed + 1))
    ahead, back = grids.get((table.needed, table.counts), none)
    grids[table.needed, table.counts] = (ahead + added if both else ahead, back + added)


def _empty(motor: int, kind: AxisKind) -> AxisCompensation:
    none = np.empty(0)
    return AxisCompensation(
        address=str(motor),
        kind=kind,
        positions=none,
        positive=none,
        negative=none,
    )
