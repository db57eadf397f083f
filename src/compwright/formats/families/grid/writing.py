"""Tables on one axis -> files: the control's own ones where they have a place for them, else those
of the definition.

A fresh file is a patch of the definition's skeleton (header and footer); see `own_files` for the
control's own.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from compwright.formats.definition.consistency import curves, grid, has_cross
from compwright.formats.definition.options import axis_options
from compwright.formats.definition.schema import Choice, Definition, When, WrittenFile
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.families.axis_names import gathered_files
from compwright.formats.families.grid.beside import MODULO_START, RANGE_START
from compwright.formats.families.grid.capacity import scale_for_writing, written_text
from compwright.formats.families.grid.tables import WrittenTable, write_table
from compwright.formats.families.grid.turns import RANGE_QUANTITY, in_range_of
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.families.pairs.capacity import cec_available
from compwright.formats.families.pairs.writing import CecWriter, word_text
from compwright.formats.text.gathering import Found, first_set
from compwright.formats.text.own_files import OwnFiles, TablePlaces, rows_by_index
from compwright.formats.text.patching import fresh_file, set_field
from compwright.formats.text.scale import NotHeld, Scale
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.axis import Axis
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

AxisTable = tuple[str, Axis, AxisCompensation]


def holds_two_curves(
    definition: Definition, options: Mapping[str, object], compensation: AxisCompensation
) -> bool:
    """Return whether a compensation goes into a pair of tables between axes, one for each
    direction.
    """
    return cec_available(definition, options) and not np.array_equal(
        compensation.positive, compensation.negative
    )


def write_table_files(
    definition: Definition,
    tables: Sequence[AxisTable],
    options: Mapping[str, object],
    state: ControlState | None,
    files: Sequence[ControlFile],
    faults: list[Fault],
) -> tuple[ControlFile, ...]:
    """Return the files of tables (address, axis, table) within the limits; what the text cannot say
    exactly goes to ``faults``.
    """
    asked = list(
        dict.fromkeys(
            (*(state.axes if state is not None else ()), *(address for address, _, _ in tables))
        )
    )
    own = (
        OwnFiles(definition, files, gathered_files(definition, files, asked))
        if files and definition.limit("no_patching") is None
        else None
    )
    writer = _Writer(definition, options, own, CecWriter(definition, options, own, state))
    fresh: list[ControlFile] = []
    for address, axis, compensation in tables:
        inexact: list[Fault] = []
        fresh.extend(writer.write(address, axis, compensation, inexact))
        faults.extend(_first_few(inexact, address))
    return (*writer.own_files([address for address, _, _ in tables]), *fresh)


def _first_few(faults: list[Fault], address: str) -> list[Fault]:
    """One wrong rounding spoils every row: three of them say it."""
    rest = len(faults) - 3
    return (
        faults
        if rest <= 0
        else [*faults[:3], Fault(message=f"axis {address}: {rest} more values like these")]
    )


@dataclass(frozen=True, slots=True)
class _Text:
    """What goes into the control for one axis, as text: rows by field, single values by quantity;
    ``when``: for which tables.
    """

    address: str
    named: Mapping[str, str]
    rows: tuple[Mapping[str, str], ...]
    singles: Mapping[str, str]
    when: When


class _Writer:
    def __init__(
        self,
        definition: Definition,
        options: Mapping[str, object],
        own: OwnFiles | None,
        cec: CecWriter,
    ) -> None:
        self.facts = cec.facts
        self.definition = definition
        self.shared = options
        self.options = options
        self.own = own
        self.cec = cec

    def write(
        self, address: str, axis: Axis, compensation: AxisCompensation, faults: list[Fault]
    ) -> list[ControlFile]:
        """Put one axis into the control's own files and return new files with what has no place
        there.
        """
        fresh: list[ControlFile] = []
        switches: list[str] = []
        self.options = axis_options(self.definition, self.shared, axis)
        compensation = self._turned(address, axis, compensation, faults)
        self.cec.allow(self.options)
        text = self._text(address, axis, compensation, faults)
        if text.when == "two_curves":
            left = self.cec.own_pair(address, axis, compensation, faults)
            fresh = [self.cec.new_file("two_curves", address, left)] if left else []
            switches = self.cec.switches(left)
        if has_cross(self.definition):
            self.cec.empty_own(address, axis.name, faults)
        placed = self._put(address, text)
        files = [
            file
            for file in self.definition.writing
            if file.when in ("always", text.when) and not self._pair_file(file)
        ]
        made = [
            _file(self.definition, file, text, placed, switches, faults)
            for file in files
            if not file.optional
        ]
        return [
            *fresh,
            *(file for file in made if file is not None),
        ]  # what switches tables on is loaded last

    def _turned(
        self, address: str, axis: Axis, compensation: AxisCompensation, faults: list[Fault]
    ) -> AxisCompensation:
        """Return the table of an endless axis over the control's own range: from its beginning,
        once around.
        """
        if compensation.period is None or RANGE_QUANTITY not in self.definition.bindings:
            return compensation
        said = self.facts.get(address, {}).get(RANGE_START)
        ahead = float(np.mod(axis.reference - MODULO_START, compensation.period))
        if said is None and min(ahead, compensation.period - ahead) > SAME_TURN:
            message = (
                f"axis {axis.name}: no file says that the control wraps this axis (MD30310) and"
                f" where its turn begins (MD30340), and its reference is at {axis.reference:g} deg:"
                " whether the control finds its way into the table is not known"
            )
            expected = (
                "the machine data of the axis with MD30310 and MD30340 among the files of the state"
            )
            faults.append(Fault(message=message, expected=expected, found="in no file"))
            return compensation
        return in_range_of(
            compensation,
            float(said) if isinstance(said, (int, float)) else MODULO_START,
            axis.name,
            faults,
        )

    def _pair_file(self, file: WrittenFile) -> bool:
        return file.when == "two_curves" and file.rows is not None

    def _text(
        self, address: str, axis: Axis, compensation: AxisCompensation, faults: list[Fault]
    ) -> _Text:
        scale = scale_for_writing(self.definition, axis, self.options)
        spelled = address if self.own is None else self.own.gathered.spelled(address)
        named = {"axis": spelled, "system": str(axis.encoder.system - 1)}
        two = holds_two_curves(self.definition, self.options, compensation)
        table = (
            WrittenTable((), {})
            if two
            else write_table(self.definition, compensation, scale, faults)
        )
        singles = _singles(self.definition, compensation, table, scale, named, faults)
        if two:  # so that nothing acts twice
            singles["enabled"] = word_text(self.definition, "enabled", "no")
        elif compensation.period is not None and "repeats" in singles:
            singles["repeats"] = word_text(self.definition, "repeats", "yes")
        when: When = "two_curves" if two else "one_curve"
        return _Text(address, named, table.rows, singles, when)

    def _put(self, address: str, text: _Text) -> set[str]:
        """Put what has a place in the control's own files there; return these quantities."""
        if self.own is None:
            return set()
        said = self.own.gathered.singles.get((address, text.named["system"]), {})
        whole = self.own.gathered.singles.get((address, None), {})
        placed = (
            {"backlash"}
            if self.own.put("backlash", said.get("backlash", ()), text.singles["backlash"])
            else set()
        )
        self.own.put(
            "backlash_factor",
            first_set(said.get("backlash_factor", whole.get("backlash_factor", ()))),
            "1",
        )
        if text.when == "two_curves":
            if whole.get("cross_axis_enabled"):
                placed = placed | {"cross_axis_enabled"}
            return placed | (
                {"enabled"}
                if self.own.put("enabled", said.get("enabled", ()), text.singles["enabled"])
                else set()
            )
        if placed or said.get(
            "enabled"
        ):  # beside a backlash that stays in its place no file is made for the switch alone
            placed = placed | {"enabled"}
        value = curves(self.definition)[0]
        names = [
            *grid(self.definition),
            *(["repeats"] if "repeats" in self.definition.bindings else []),
        ]
        rows = rows_by_index(self.own.gathered.rows.get((address, text.named["system"]), ()))
        singles = {name: said[name] for name in names if name in said}
        places = TablePlaces(
            rows, singles, value, {**text.named, "axis": _spelled(rows, singles, address)}
        )
        self._switch_on(said.get("enabled", ()), places)
        self._reserve(said.get("max_points", ()), len(text.rows))
        if not places.anywhere:
            return placed
        field = self.definition.bindings[value].field
        self.own.put_table(
            places, [row[field] for row in text.rows], {name: text.singles[name] for name in names}
        )
        return placed | {value, *names}

    def _switch_on(self, switches: Sequence[Found], table: TablePlaces) -> None:
        """Make the table act where the files end with it switched off; a load sequence counts by
        its last value.

        In a file that holds the values too the switch is off before them, as in a maker's program,
        and on behind them: a table that is on is protected, and the control would take none of the
        values.
        """
        if self.own is None or not switches:
            return
        first: dict[int, int] = {}
        for found in (found for group in table.rows.values() for found in group):
            first[found.number] = min(
                first.get(found.number, found.occurrence.line), found.occurrence.line
            )
        before = [
            switch for switch in switches if switch.occurrence.line < first.get(switch.number, 0)
        ]
        behind = [switch for switch in switches if switch not in before]
        self.own.put("enabled", behind, word_text(self.definition, "enabled", "yes"))
        for number in dict.fromkeys(switch.number for switch in before):
            last = [switch for switch in before if switch.number == number][-1:]
            self.own.put("enabled", last, word_text(self.definition, "enabled", "no"))
            if number not in {switch.number for switch in behind}:
                self.own.put_behind(
                    table, number, "enabled", word_text(self.definition, "enabled", "yes")
                )

    def _reserve(self, places: Sequence[Found], count: int) -> None:
        """Reserve the points where the files say fewer than the table has: what the option
        promises, or where none were reserved as many as it has; files that say less would take the
        room away again when they are loaded.
        """
        promised = self.options.get("points")
        needed = promised if isinstance(promised, int) else count
        if self.own is not None and any(int(place.text) < count for place in places):
            self.own.put("max_points", places, str(needed))

    def own_files(self, addresses: Sequence[str]) -> tuple[ControlFile, ...]:
        """Return the control's own files that say something of the axes, with all changes made."""
        if self.own is None:
            return ()
        gathered = self.own.gathered
        speaking = {
            place.number
            for (address, _), singles in gathered.singles.items()
            if address in addresses
            for places in singles.values()
            for place in places
        }
        speaking |= {
            row.number
            for (address, _), rows in gathered.rows.items()
            if address in addresses
            for row in rows
        }
        forms = set(addresses) | {
            form for each in addresses for form in gathered.spellings.get(each, ())
        }
        if len(forms) > len(
            set(addresses)
        ):  # more than one name for an axis: the file that lists them belongs to the set
            speaking |= gathered.naming
        for index, places in self.cec.places.items():
            pair = self.cec.in_use.get(index)
            if index in self.cec.kept or (
                pair is not None and pair[0] == pair[1] and pair[1] in addresses
            ):
                speaking |= {place.number for found in places.values() for place in found}
        return self.own.patched(speaking)


def _spelled(
    rows: Mapping[int, Sequence[Found]], singles: Mapping[str, Sequence[Found]], address: str
) -> str:
    """Return how the files write the axis."""
    found = [place for places in (*rows.values(), *singles.values()) for place in places]
    return (
        found[0].occurrence.tokens["axis"].text
        if found and "axis" in found[0].occurrence.tokens
        else address
    )


def _file(
    definition: Definition,
    file: WrittenFile,
    text: _Text,
    placed: set[str],
    switches: Sequence[str],
    faults: list[Fault],
) -> ControlFile | None:
    """Return one file: the skeleton of the definition with its single values set and the rows put
    in.

    ``placed``: quantities that stand in the control's own files and are left out; None when nothing
    is left. ``switches``: lines before the end of a file without rows.
    """
    name = print_form(file.name, {**text.named, "axis": text.address})
    rows: list[str] = []
    left = 0
    if file.rows is not None and curves(definition)[0] not in placed:
        form = definition.statements[file.rows].form
        rows = [print_form(form, {**text.named, **row}) for row in text.rows]
        _check_lines(definition, name, rows, faults)
        left += 1
    made = fresh_file(definition, file, name, text.named, rows)
    if switches and file.rows is None:
        end = len(made.files[0].content) - len(definition.dialect.newline)
        made.add_lines(0, end, switches, before=True)
        left += 1
    for place in _statements(definition, made.files[0]):
        here = [
            quantity
            for quantity, binding in definition.bindings.items()
            if binding.statement == place.statement
        ]
        if placed.intersection(here):
            made.cut_line(0, next(iter(place.tokens.values())).start)
            continue
        left += 1
        for quantity in here:
            if quantity in text.singles:
                field = definition.bindings[quantity].field
                made.replace(0, *set_field(place, field, text.singles[quantity]))
    return made.patched([0])[0] if left or not placed else None


def _singles(
    definition: Definition,
    compensation: AxisCompensation,
    table: WrittenTable,
    scale: Scale,
    named: Mapping[str, str],
    faults: list[Fault],
) -> dict[str, str]:
    texts = dict(table.singles)
    for quantity, binding in definition.bindings.items():
        if isinstance(binding, Choice) and quantity in definition.layout.singles:
            texts[quantity] = written_text(binding, scale.options)
    if "table_file" in definition.bindings:
        texts["table_file"] = next(
            print_form(file.name, named) for file in definition.writing if file.rows is not None
        )
    if "backlash" in definition.bindings and definition.limit("no_backlash_beside_table") is None:
        try:
            texts["backlash"] = scale.write("backlash", compensation.backlash)
        except NotHeld as error:
            faults.append(Fault(message=f"axis {compensation.address}, backlash: {error}"))
    return texts


def _statements(definition: Definition, skeleton: ControlFile) -> tuple[Occurrence, ...]:
    """Return the places of the single values in a skeleton."""
    faults: list[Fault] = []
    read = text_reader(definition).read(skeleton, faults)
    raise_all(InputError, faults)
    return () if read is None else read.occurrences


def _check_lines(
    definition: Definition, name: str, rows: Sequence[str], faults: list[Fault]
) -> None:
    longest = definition.limit_number("line_length")
    worst = max((len(row) for row in rows), default=0)
    if longest is not None and worst > longest:
        faults.append(
            Fault(
                message="a line is too long",
                file=name,
                expected=f"at most {longest} characters",
                found=str(worst),
            )
        )
