"""A control's own files -> the compensation that acts in it, for every axis that they name.

Missing is not zero: a grid without values, a table that is switched on but was not given, an axis
that no file names are errors. What had to be assumed is listed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from decimal import Decimal

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.options import (
    ENCODER_SYSTEM,
    REFERENCE,
    REFERENCE_RETURN,
    axis_options,
)
from compwright.formats.definition.schema import Choice, Definition
from compwright.formats.definition.statements import field_matches
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_names import axis_names
from compwright.formats.families.gantry import find_partners, partner_of
from compwright.formats.families.grid.axis_reading import AxisReader
from compwright.formats.families.grid.beside import beside, check_unit
from compwright.formats.families.limits import SAME_TURN
from compwright.formats.families.pairs.reading import CEC_UNTOLD, read_cec, sign_question
from compwright.formats.families.pairs.sums import check_sums, cross_tables, with_own_tables
from compwright.formats.families.travel_limits import check_limits
from compwright.formats.text.addresses import normal_address, normal_text
from compwright.formats.text.gathering import Found, Gathered, gather
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import ReadText, TextReader, text_reader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import AxisCompensation, ControlFile, ControlState, Fact

#: What corrects an axis, or switches that on, where it is not zero.
_ACTING = ("backlash", "enabled", "cross_axis_enabled", "dynamic_backlash", "temperature_slope")


def read_grid(
    definition: Definition,
    options: Mapping[str, object],
    files: Sequence[ControlFile],
    axes: Sequence[Axis],
    address: str | None,
    activity: Activity,
) -> ControlState:
    """Return what a control does with ``files``; arguments and errors as `Family.read`."""
    return _StateReader(definition, options, axes, address, activity).read(files)


class _StateReader:
    def __init__(
        self,
        definition: Definition,
        options: Mapping[str, object],
        axes: Sequence[Axis],
        address: str | None,
        activity: Activity,
    ) -> None:
        self.definition = definition
        self.activity = activity
        self.options = options
        self.notes = Notes()
        self.wanted: dict[str, Axis | None] = {}
        self.partners: dict[str, str] = {}
        if address is not None:
            self.wanted[normal_text(definition, address)] = None
        for axis in axes:
            name, assumption = normal_address(definition, axis)
            self.wanted[name] = axis
            if axis.gantry is not None:
                self.partners[name] = normal_text(definition, axis.gantry)
            if assumption is not None:
                self.notes.assumed.append(assumption)
                self.notes.taken_for(axis.name, name)
        for leading, partner in self.partners.items():
            leader = self.wanted[leading]
            self.wanted.setdefault(partner, None if leader is None else partner_of(leader, partner))
        self.used_files: set[int] = set()

    def read(self, files: Sequence[ControlFile]) -> ControlState:
        texts, reader = self._texts(files)
        names = axis_names(self.definition, texts, list(self.wanted))
        gathered = gather(self.definition, texts, names)
        check_unit(gathered, self.wanted, self.notes)
        for text in texts:
            self.notes.findings.extend(text.findings)
        cec = read_cec(gathered, self.options, self.notes, self.wanted, self.activity)
        check_sums(cec, self.notes, self.wanted)
        named = list(dict.fromkeys((*self._named(gathered, texts, reader), *cec.own_axes())))
        if not self.wanted and not named and not cec.tables:
            template = next(file.name for file in self.definition.writing if file.rows is not None)
            self.notes.faults.append(
                Fault(
                    message="nothing says to which axis this table belongs",
                    file=", ".join(text.file for text in texts),
                    expected=(
                        f"the axis named, the file called {template.replace('{axis}', '<number>')},"
                        " or the file that names it"
                    ),
                )
            )
        between = {
            name for table in cec.tables if table.input != table.output for name in table.pair
        }
        compensations: dict[str, AxisCompensation] = {}
        facts: dict[str, Mapping[str, Fact]] = {}
        for address, axis in (self.wanted or dict.fromkeys(named)).items():
            if address not in named and address in between:
                # the files tell what it does to another axis; whether they must tell more is for
                # who asks
                continue
            if address not in named and not self._only_table(texts):
                self.notes.faults.append(
                    Fault(
                        message=f"no file says anything about axis {address}; missing is not zero",
                        file=", ".join(text.file for text in texts),
                        expected=f"lines for {address}, or the state `none`",
                        found=f"axes {', '.join(named)}" if named else "no axis at all",
                    )
                )
                continue
            self._one_axis(gathered, address, axis)
            rows = self._rows(
                gathered, texts, address, spoken_of=address in self._spoken_of(gathered, reader)
            )
            elsewhere = bool(cec.acting((address, address)))
            if (
                elsewhere
                and self.options.get("cec_sign") is None
                and "cec_sign" in self.definition.options
            ):
                self.notes.ask(sign_question(address, cec.acting((address, address))))
            options = axis_options(self.definition, self.options, axis)
            reader_of = AxisReader(
                gathered,
                address,
                axis,
                options,
                self.notes,
                rows,
                elsewhere=elsewhere,
                activity=self.activity,
            )
            reading = reader_of.read()
            compensations[address] = with_own_tables(cec, reading.compensation)
            more = beside(gathered, address, axis, self.partners, self.notes)
            untold = cec.untold(address, sign_known=self.options.get("cec_sign") is not None)
            more |= {CEC_UNTOLD: untold} if untold else {}
            if (
                "units" in self.definition.options
            ):  # limits in machine units: the axis' own reading has them in mm
                more = {name: fact for name, fact in more.items() if name not in reading.facts}
            facts[address] = {**reading.facts, **cec.facts(address), **more}
            check_limits(gathered, address, axis, facts[address], self.partners, self.notes)
            if axis is not None:
                self._check_turn(axis, compensations[address])
        self._same_systems(facts)
        cross = cross_tables(cec, lambda name: self._kind(name, gathered))
        if cross and self.options.get("cec_sign") is None and "cec_sign" in self.definition.options:
            pairs = ", ".join(
                dict.fromkeys(f"{entry.output} over {entry.input}" for entry in cross)
            )
            self.notes.find(
                "CW-S051",
                "warning",
                f"the tables between axes ({pairs}) are left as they are and not shown: the sign of"
                " CEC values is not known; give the option cec_sign after the check on the card",
            )
            cross = ()
        self.notes.ask_contradicted()
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        find_partners(gathered, self.partners, compensations, self.notes, asked=bool(self.wanted))
        self._after(texts)
        return ControlState(
            format=self.definition.id,
            axes=compensations,
            cross=cross,
            facts=facts,
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def _one_axis(self, gathered: Gathered, address: str, axis: Axis | None) -> None:
        """Refuse an axis on which lines of another name may act too: X1 beside AX1, and no list
        says which of them are one.
        """
        if axis is None or "machine_axis" not in self.definition.bindings:
            return
        acting = _acting_lines(gathered)
        others = gathered.names.unplaced(address, acting)
        if not others:
            return
        names = ", ".join(others)
        self.notes.refuse(
            f"axis {address}",
            f"the files speak of {names} too, with something that acts and may be meant for the"
            " same axis: no list of names is among them (MD10000 $MN_AXCONF_MACHAX_NAME_TAB)",
            acting[others[0]],
            expected=(
                "the machine data with MD10000 among the files, or address: "
                f"{' or '.join(others)} in the job where that is the axis"
            ),
            found=names,
        )

    def _same_systems(self, facts: Mapping[str, Mapping[str, Fact]]) -> None:
        """Both axes of a gantry are written for one measuring system."""
        for leading, partner in self.partners.items():
            used = [facts.get(address, {}).get(ENCODER_SYSTEM) for address in (leading, partner)]
            if None not in used and used[0] != used[1]:
                self.notes.refuse(
                    f"axes {leading} and {partner}",
                    "the two axes of the gantry use different measuring systems",
                    None,
                    expected="the same one, or encoder.system in the job",
                    found=f"{used[0]} and {used[1]}",
                )

    def _texts(self, files: Sequence[ControlFile]) -> tuple[list[ReadText], TextReader]:
        if not files:
            raise UsageError(
                "no file of the control was given; expected its own files, or the state `none`"
            )
        reader = text_reader(self.definition)
        texts = [reader.read(file, self.notes.faults, number) for number, file in enumerate(files)]
        raise_all(InputError, self.notes.faults)
        read = [text for text in texts if text is not None]
        if not any(text.occurrences or text.sections for text in read):
            forms = [
                self.definition.statements[self.definition.bindings[name].statement].form
                for name in curves(self.definition)
            ]
            raise InputError(
                Fault(
                    message=f"nothing in it is compensation data of {self.definition.id}",
                    file=", ".join(text.file for text in read),
                    expected=f"lines like {forms[0].replace('{', '<').replace('}', '>')}",
                )
            )
        return read, reader

    def _spoken_of(self, gathered: Gathered, reader: TextReader) -> list[str]:
        """Return the addresses that lines or sections name."""
        found = gathered.addresses()
        for name in gathered.sections:
            for matcher in reader.matchers.values():
                match = matcher.section.fullmatch(name) if matcher.section is not None else None
                if match is not None and "axis" in match.groupdict():
                    found.append(normal_text(self.definition, match["axis"]))
        return list(dict.fromkeys(found))

    def _named(
        self, gathered: Gathered, texts: Sequence[ReadText], reader: TextReader
    ) -> list[str]:
        """Return the addresses that lines, sections or the names of table files name."""
        found = self._spoken_of(gathered, reader)
        for text in self._table_texts(texts):
            address = self._address_in_name(text.file)
            if address is not None:
                found.append(address)
        return list(dict.fromkeys(found))

    def _table_texts(self, texts: Sequence[ReadText]) -> list[ReadText]:
        """Return the files whose rows do not name an axis."""
        row = self.definition.statements[
            self.definition.bindings[curves(self.definition)[0]].statement
        ]
        if "axis" in row.fields:
            return []
        return [text for text in texts if text.kind == row.text]

    def _address_in_name(self, file: str) -> str | None:
        template = next(
            written.name for written in self.definition.writing if written.rows is not None
        )
        before, after = template.split("{axis}")
        match = re.fullmatch(re.escape(before) + "(.+)" + re.escape(after), file)
        if match is None or not field_matches(self.definition.addresses.type, match[1]):
            return None
        return normal_text(self.definition, match[1])

    def _only_table(self, texts: Sequence[ReadText]) -> bool:
        """Whether one table file was given alone: then the axis that was asked for is meant."""
        return len(texts) == len(self._table_texts(texts)) == len(self.wanted) == 1

    def _rows(
        self, gathered: Gathered, texts: Sequence[ReadText], address: str, *, spoken_of: bool
    ) -> list[Found] | None:
        """Return the rows of the axis' table file; None where rows name their axis themselves."""
        candidates = self._table_texts(texts)
        if "table_file" not in self.definition.bindings:
            return None
        if spoken_of:
            named = gathered.found("table_file", address, None)
            if not named:
                return []
            base = re.split(r"[/\\]", named[0].text)[-1]
            matching = [text for text in candidates if text.file == base]
            if not matching:
                self.notes.faults.append(
                    Fault(
                        message=f"axis {address}: the table file that it names was not given",
                        file=named[0].occurrence.file,
                        place=named[0].occurrence.place,
                        expected=base,
                        found=", ".join(text.file for text in candidates) or "no table file",
                    )
                )
                return []
        else:
            matching = [
                text for text in candidates if self._address_in_name(text.file) == address
            ] or candidates
        self.used_files.update(text.number for text in matching)
        if len(matching) > 1:
            self.notes.faults.append(
                Fault(
                    message=f"axis {address}: its table file was given {len(matching)} times",
                    file=matching[0].file,
                )
            )
        rows = gathered.file_rows.get(matching[0].number, [])
        if not rows:
            self.notes.faults.append(
                Fault(
                    message=(
                        f"axis {address}: the table file holds no rows: this is contradictory, not"
                        " an empty table"
                    ),
                    file=matching[0].file,
                )
            )
        return rows

    def _check_turn(self, axis: Axis, compensation: AxisCompensation) -> None:
        """The job and the control's files must mean the same turn; a table that does not fit the
        job's axis is told.
        """
        for table in (compensation, *compensation.others):
            if table.positions.size == 0:
                continue
            if axis.modulo is None and table.period is not None:
                self.notes.find(
                    "CW-S033",
                    "warning",
                    f"axis {table.address}: its table repeats every {table.period:g}, but the job"
                    " gives no modulo; a new table will have ends",
                )
            elif axis.modulo is not None and table.period is None:
                self.notes.find(
                    "CW-S033",
                    "warning",
                    f"axis {table.address} is endless, but its table does not repeat: it ends at"
                    " both sides",
                )
            elif (
                axis.modulo is not None
                and table.period is not None
                and abs(table.period - axis.modulo) > SAME_TURN
            ):
                self.notes.faults.append(
                    Fault(
                        message=(
                            f"axis {table.address}: the period of its table is not the modulo of"
                            " the job"
                        ),
                        expected=f"{axis.modulo:g}",
                        found=f"{table.period:g}",
                    )
                )

    def _kind(self, address: str, gathered: Gathered) -> AxisKind:
        """Return the kind of an axis of a table between axes: the job's, the files', else linear,
        which changes units only.
        """
        axis = self.wanted.get(address)
        if axis is not None:
            return axis.kind
        binding = self.definition.bindings.get("rotary")
        places = gathered.singles.get((address, None), {}).get("rotary", [])
        if not isinstance(binding, Choice) or not places:
            return AxisKind.LINEAR
        return AxisKind(binding.values.get(places[-1].text, "linear"))

    def _after(self, texts: Sequence[ReadText]) -> None:
        """Note what concerns the files as a whole."""
        binding = self.definition.bindings.get("table_file")
        named = {
            re.split(r"[/\\\\]", occurrence.tokens[binding.field].text.strip())[-1]
            for text in texts
            for occurrence in text.occurrences
            if binding is not None
            and occurrence.statement == binding.statement
            and binding.field is not None
        }
        for text in self._table_texts(texts):
            if text.number not in self.used_files and (not self.wanted or text.file not in named):
                self.notes.idle_file(
                    f"{text.file} is not named by any axis: the control does not load it"
                )
        for text in texts:
            variants = [occurrence.line for occurrence in text.occurrences if occurrence.variant]
            if variants:
                self.notes.find(
                    "CW-S013",
                    "warning",
                    f"{text.file}, line {variants[0]}: read, although no manual shows this form"
                    f" ({len(variants)} lines)",
                )
        if any(axis is None for axis in self.wanted.values()) or not self.wanted:
            self.notes.assume(REFERENCE, f"{self.options[REFERENCE]:g}", "option or its default")
            self.notes.assume(
                REFERENCE_RETURN, str(self.options[REFERENCE_RETURN]), "option or its default"
            )


def _acting_lines(gathered: Gathered) -> dict[str, Found]:
    """Return, by the name that they give to the axis, a line that corrects something: a value that
    is not zero, or a switch on.
    """
    lines: dict[str, Found] = {}
    for (name, _), rows in gathered.rows.items():
        acting = [row for row in rows if Decimal(row.occurrence.tokens["value"].text) != 0]
        if name is not None and acting:
            lines[name] = acting[-1]
    for (name, _), said in gathered.singles.items():
        acting = [
            place
            for quantity in _ACTING
            for place in said.get(quantity, ())
            if Decimal(place.text) != 0
        ]
        if name is not None and acting:
            lines[name] = acting[-1]
    return lines
