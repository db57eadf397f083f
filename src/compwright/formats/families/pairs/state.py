"""Read the compensation of axes and between axes from files with cross-axis tables (CEC).

If two members of a commissioning archive state the same value, they must agree.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from functools import lru_cache

from compwright.formats.definition.options import known_kind
from compwright.formats.definition.schema import Choice
from compwright.formats.families.activity import Activity
from compwright.formats.families.control_texts import texts_of
from compwright.formats.families.coupled_axes import Coupling
from compwright.formats.families.family import Family
from compwright.formats.families.grid.axis_reading import AxisReading
from compwright.formats.families.grid.reading import GridReader
from compwright.formats.families.grid.tables import value_fields
from compwright.formats.families.pairs.coupling import couplings_of
from compwright.formats.families.pairs.lines import Units
from compwright.formats.families.pairs.options import (
    allowed_tables,
    scale_of_pairs,
    sign_known,
    sign_question,
)
from compwright.formats.families.pairs.places import last, of_axis, places_of
from compwright.formats.families.pairs.programs import check_programs
from compwright.formats.families.pairs.reading import CecReader, Writable
from compwright.formats.families.pairs.sums import (
    cross_tables,
    staying,
    with_own_tables,
    without_cut_sums,
)
from compwright.formats.families.pairs.tables import CecTable
from compwright.formats.text.container import is_container, opened
from compwright.formats.text.gathering import FoundValue, Gathered, same_value
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation, ControlFile, CrossCompensation
from compwright.records.facts import PairTables
from compwright.words.sentences import control_text


class PairsReader(GridReader):
    """Reads the files of a control, including its cross-axis tables."""

    export_instead = (
        "the tables and the machine data as text (AX_EEC.INI, NC_CEC.INI, INITIAL.INI), or the"
        " commissioning archive of the NC that begins with @@MMCIBN"
    )

    def __init__(
        self,
        control: Family,
        files: Sequence[ControlFile],
        axes: Sequence[Axis],
        address: str | None,
        activity: Activity,
    ) -> None:
        super().__init__(control, files, axes, address, activity)
        self.archives = [file for file in files if is_container(file)]
        for archive in self.archives:
            for fault in contradictions(archive):
                self.notes.once(fault)
            self.notes.find("CW-S072", "info", file=archive.name)
        check_programs(
            self.gathered, self.loaded, self.wanted, self.unit, self.activity, self.notes
        )
        scale = scale_of_pairs(control, AxisKind.LINEAR)
        units = Units(self.unit == "inch", self._kind)
        self.sign_known = sign_known(control)
        given = {
            one: allowed_tables(self.definition, control.options_of(axis))
            for one, axis in self.wanted.items()
            if axis is not None
        }
        writable = Writable(
            given,
            self.sign_known,
            allowed_tables(self.definition, control.options) if control.drafting else None,
        )
        cec = CecReader(
            self.gathered,
            scale,
            self.notes,
            self.wanted,
            activity,
            units,
            writable,
        ).read()
        self.cec = without_cut_sums(
            cec,
            self.notes,
            lambda table: (
                (table.stays or table.input != table.output)
                and writable.not_ours(table.index, table.output)
            ),
            self.wanted,
        )

    def named(self) -> list[str]:
        """Return the axis addresses in the files, including axes with a cross-axis table on
        themselves.
        """
        return list(dict.fromkeys((*super().named(), *self.cec.own_axes())))

    def couplings(self) -> Sequence[Coupling]:
        """Return the axes that move together by the files (gantry, synchronised axes)."""
        texts = texts_of(self.definition, self.files, [])
        return couplings_of(texts, self.gathered.axis, list(self.wanted) or self.named())

    def between(self) -> Collection[str]:
        """Return the input and output axes of all cross-axis tables."""
        return {
            name for table in self.cec.tables if table.input != table.output for name in table.pair
        }

    def elsewhere(self, address: str) -> bool:
        """Return whether cross-axis tables correct an axis by its own position.

        If the sign of their values is unknown, the question for it is added to the notes.
        """
        active = self.cec.active((address, address))
        if active and not self.sign_known:
            named = " and ".join(str(table.index) for table in active)
            why = f"axis {address}: CEC table {named} corrects the axis over itself"
            self.notes.ask(sign_question(why))
        return bool(active) or bool(self.cec.uncounted(address))

    def axis(self, address: str, axis: Axis | None) -> AxisReading:
        """Return the compensation of an axis, including cross-axis tables by its own position."""
        own = super().axis(address, axis)
        pairs = self.cec.facts(address, sign_known=self.sign_known)
        compensation = with_own_tables(self.cec, own.compensation)
        stated = dict(own.facts.stated)
        system = own.facts.encoder_system
        others = self._others_protected(address, system)
        if others:
            stated["others_protected"] = others
        if self.archives and system is not None:
            unit = "deg" if compensation.kind is AxisKind.ROTARY else self.unit
            stated["archive"] = compared(self.gathered, address, str(system - 1), unit)
        tables = self.cec.uncounted(address), self.cec.unknown(address)
        other_functions = "; ".join(filter(None, (own.facts.other_functions, *tables)))
        return AxisReading(
            compensation,
            replace(own.facts, pairs=pairs, other_functions=other_functions, stated=stated),
        )

    def _others_protected(self, address: str, system: int | None) -> str:
        """Return as text the activation parameters of other tables in the same file as an axis' own
        table that no file deactivates: these are possibly active while the file is loaded.

        The control rejects new values of a table that is active.
        """
        own = None if system is None else str(system - 1)
        ours = {row.number for row in self.gathered.rows.get((address, own), ())}
        rows: dict[tuple[str, str, str | None], list[FoundValue]] = {
            ("enabled", name or "", index): found
            for (name, index), found in self.gathered.rows.items()
            if (name, index) != (address, own)
        }
        for places in places_of(self.gathered).values():
            output = last("cross_output", places)
            if output is not None:
                switch = ("cross_axis_enabled", self.gathered.axis(output.text), None)
                rows[switch] = [*rows.get(switch, ()), *places.get("cross_value", ())]
        return ";".join(
            name_of(self.definition, switch) + f"[{','.join(filter(None, (index, name)))}]"
            for (switch, name, index), found in rows.items()
            if ours & {row.number for row in found}
            and not any(
                same_value(place.text, "0")
                for place in self.gathered.found(switch, name, index)[-1:]
            )
        )

    def staying(self, compensation: AxisCompensation) -> tuple[AxisCompensation, ...]:
        """Return the cross-axis tables by which an axis corrects itself and that stay unchanged."""
        return staying(self.cec, compensation)

    def cross(self) -> tuple[CrossCompensation, ...]:
        """Return the corrections between axes, without tables of unknown sign (these stay
        unchanged).
        """
        cross = cross_tables(self.cec, self._kind)
        if self.sign_known or not cross:
            return cross
        pairs = dict.fromkeys(
            control_text("{output} over {input}", output=entry.output, input=entry.input)
            for entry in cross
        )
        self.notes.find("CW-S051", "warning", pairs=pairs)
        return ()

    def pair_tables(self) -> PairTables:
        """Return the axes, reserved points and curves of the cross-axis tables, which of them stay,
        and which take no correction.
        """
        between = [one for one in self.cec.tables if one.input != one.output]
        curves = {
            one.index: (tuple(one.positions.tolist()), tuple(one.values.tolist()))
            for one in between
        }
        obstacles = {one.index: tuple(self._obstacles(one)) for one in between}
        obstacles |= {one.index: ((one.why, _CORRECT),) for one in self.cec.odd}
        off = frozenset(one.index for one in between if not one.active and one.values.any())
        return PairTables(
            self.cec.occupied, self.cec.reserved, self.cec.stay(), curves, obstacles, off
        )

    def _obstacles(self, one: CecTable) -> Iterator[tuple[str, str]]:
        """Yield each reason why no correction can be added to a table, with its next step.

        A table takes one if it is one curve for both directions, is switched on by SD41300 and
        MD32710 in the files, has the weight 1 there, and is a factor of no table.
        """
        every, output = places_of(self.gathered), of_axis(self.gathered, one.output)
        for parameter, quantity, places, key in (
            ("SD41300", "cross_table_enabled", every[one.index], one.index),
            ("SD41310", "cross_weight", every[one.index], one.index),
            ("MD32710", "cross_axis_enabled", output, one.output),
        ):
            name = f"{name_of(self.definition, quantity)}[{key}]"
            found = last(quantity, places)
            if found is None:
                step = control_text(
                    "add the file with {name} to the control's files (`states` or `--state`)",
                    name=name,
                )
                reason = control_text(
                    "{parameter} ({name}) is in no given file, needed: 1",
                    parameter=parameter,
                    name=name,
                )
                yield reason, step
            elif not same_value(found.text, "1"):
                then = control_text("measure again")
                if quantity == "cross_weight":
                    then = control_text(
                        "multiply the values of table {index} by {value}",
                        index=str(one.index),
                        value=found.text,
                    )
                step = control_text(
                    "set {name} to 1 in the control, {then}, and export the files again",
                    name=name,
                    then=then,
                )
                reason = control_text(
                    "{parameter} ({name}) is {value}, needed: 1",
                    parameter=parameter,
                    name=name,
                    value=found.text,
                )
                yield reason, step
        for quantity, wrong in (
            ("cross_direction", len(one.directions) != len(Direction)),
            ("cross_repeats", one.period is not None),
        ):
            found = last(quantity, every[one.index])
            if wrong and found is not None:
                name = name_of(self.definition, quantity)
                reason = control_text(
                    "{name} is {value}, needed: 0",
                    name=f"{name}[{one.index}]",
                    value=found.text,
                )
                yield reason, ""
        for index, places in every.items():
            found = last("cross_multiplier", places)
            if index != one.index and found is not None and int(found.text) - 1 == one.index:
                name = name_of(self.definition, "cross_multiplier")
                reason = control_text(
                    "{name} is {value}: table {index} is multiplied by it",
                    name=f"{name}[{index}]",
                    value=found.text,
                    index=str(index),
                )
                yield reason, ""

    def active_lines(self) -> dict[str, FoundValue]:
        """Return, by axis name, one line that shows an active correction of the axis, or a value of
        a cross-axis table by which the axis corrects itself.
        """
        lines = super().active_lines()
        for places in places_of(self.gathered).values():
            base, corrected = (last(name, places) for name in ("cross_input", "cross_output"))
            active = [row for row in places.get("cross_value", ()) if Decimal(row.text) != 0]
            if base is None or corrected is None or not active:
                continue
            name = self.gathered.axis(corrected.text)
            if self.gathered.axis(base.text) == name:
                lines.setdefault(name, active[-1])
        return lines

    def _kind(self, address: str) -> AxisKind:
        """Return the kind of an axis (linear, rotary) by the job, else the files, else linear."""
        axis = self.wanted.get(address)
        if axis is not None:
            return axis.kind
        binding = self.definition.bindings.get("rotary")
        places = self.gathered.singles.get((address, None), {}).get("rotary", [])
        if not isinstance(binding, Choice) or not places:
            return known_kind(self.control.options, address) or AxisKind.LINEAR
        return AxisKind(binding.values.get(places[-1].text, "linear"))


_CORRECT = control_text("correct this table in the control and export the files again")
_LINE = re.compile(
    rb"^[ \t]*(?:N\d+[ \t]+)?(\$\w+(?:[ \t]*\[[^\]\r\n]*\])?)[ \t]*=[ \t]*([^;\r\n]*?)"
    rb"[ \t]*(?:;[^\r\n]*)?\r?$",
    re.MULTILINE,
)
#: What a member does at the beginning of a load, and not what it leaves behind.
_PASSING = frozenset({"$MN_INIT_MD"})
#: Values by index and quantities of an axis that somebody compares with the control's display.
_SHOWN = 2


@lru_cache(maxsize=8)
def contradictions(file: ControlFile) -> tuple[Fault, ...]:
    """Return a fault for each variable with different values in two members of an archive."""
    container, _ = opened(file)
    seen: dict[str, tuple[str, str, int]] = {}
    faults = []
    for member in () if container is None else container.state:
        for name, (value, line) in _assigned(member.content).items():
            first, where, at = seen.setdefault(name, (value, member.name, line))
            if not same_value(first, value):
                faults.append(
                    Fault(
                        message=(
                            f"{name} contradicts {where}, line {at}. The control writes one "
                            "value into both files of its archive, so one of the two was "
                            "changed"
                        ),
                        file=member.name,
                        place=f"line {line}",
                        expected=first,
                        found=value,
                        hint="export the archive from the control again",
                    )
                )
    return tuple(faults)


def _assigned(content: bytes) -> dict[str, tuple[str, int]]:
    """Return the last value of each system variable in an archive member, with its line."""
    found: dict[str, tuple[str, int]] = {}
    line, place = 1, 0
    for match in _LINE.finditer(content):
        line += content.count(b"\n", place, match.start())
        place = match.start()
        name = re.sub(r"\s", "", match[1].decode("latin-1")).upper()
        if name not in _PASSING:
            found[name] = match[2].decode("latin-1").partition(" '")[0].strip(), line
    return found


def compared(gathered: Gathered, address: str, system: str, unit: str) -> str:
    """Return values of an axis, as text, to compare with the control's display, in ``unit``.

    The values are those in the archive, among them the largest and the smallest value of the table
    and the backlash.
    """
    definition = gathered.definition
    rows = gathered.rows.get((address, system), [])
    field = value_fields(definition)[0]
    by_value = sorted(rows, key=lambda row: Decimal(row.occurrence.tokens[field].text))
    points = {row.occurrence.line: row for row in (*by_value[-1:], *by_value[:1], *rows[-1:])}
    shown = [
        f"{name_of(definition, 'value')}[{system},{row.occurrence.tokens['index'].text},{address}]"
        f" = {row.occurrence.tokens[field].text} {unit}"
        for row in list(points.values())[:_SHOWN]
    ]
    quantities = ("backlash", "table_end", "table_spacing", "enabled")
    places = (gathered.found(quantity, address, system)[-1:] for quantity in quantities)
    shown += [
        _single(gathered, found, f"[{system},{address}]", unit)
        for group in places
        for found in group
    ]
    return ", ".join(shown[: _SHOWN + 1])


def _single(gathered: Gathered, found: FoundValue, index: str, unit: str) -> str:
    name = gathered.definition.statements[found.occurrence.statement].form.partition("[")[0]
    counted = "" if "ENABLE" in name else f" {unit}"
    return f"{name}{index} = {found.text}{counted}"
