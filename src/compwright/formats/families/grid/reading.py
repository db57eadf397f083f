"""Read a control's files as the active compensation of every axis that they name.

A missing value does not count as zero. These are errors: a grid without values, a table that is
switched on but was not given, and an axis of the job that no file names. Every assumption is
listed.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

from compwright.formats.definition.consistency import curves
from compwright.formats.definition.statements import readable
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_names import axis_names
from compwright.formats.families.control_texts import is_listing, texts_of
from compwright.formats.families.coupled_axes import (
    Coupling,
    check_couplings,
    find_partners,
    parameters_of,
)
from compwright.formats.families.family import Family, require_files
from compwright.formats.families.grid.axis_reading import AxisReading, AxisSource, GridAxisReader
from compwright.formats.families.grid.axis_settings import AxisSettingsReader
from compwright.formats.families.grid.axis_values import basic_system
from compwright.formats.families.grid.joints import joined_joints
from compwright.formats.families.grid.modulo_range import check_turn
from compwright.formats.families.grid.table_files import (
    TableFiles,
    changed_at_run_time,
    offset_at_run_time,
    unused_table_files,
)
from compwright.formats.families.travel_limits import check_limits
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.container import (
    is_container,
    programs_setting,
    unknown_container,
)
from compwright.formats.text.gathering import FoundValue, Gathered, gather
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import BINARY, ReadText, no_text, text_reader
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, partner_of
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import PairTables
from compwright.records.options import REFERENCE, REFERENCE_RETURN
from compwright.words.sentences import control_text, say

#: A line of a listing in columns: a name, then one value for each axis; more than a few make one.
_COLUMNS = re.compile(rb"^\$\w+(?:\[[0-9]+\])?\t[^\t\n]*\t", re.MULTILINE)
_FEW = 2
#: The statement by which a control names the axis of each joint.
_JOINTS = "kinematics"
#: What corrects an axis, or switches that on, where it is not zero.
_CORRECTING = ("backlash", "enabled", "cross_axis_enabled", "dynamic_backlash", "temperature_slope")


class GridReader:
    """Reads the files of one control; see `Family.read` for the arguments and errors.

    A derived class can read more than the axes' own tables. It overrides the methods without an
    underscore.
    """

    #: What the user gives instead of a container that cannot be opened.
    export_instead = "text as the control exports it, in ASCII or another 8-bit character set"

    def __init__(
        self,
        control: Family,
        files: Sequence[ControlFile],
        axes: Sequence[Axis],
        address: str | None,
        activity: Activity,
    ) -> None:
        self.control = control
        self.files, self.axes = files, axes
        self.definition = control.definition
        self.activity = activity
        self.notes = Notes()
        self.wanted: dict[str, Axis | None] = {}
        self.partners: dict[str, str] = {}
        self.loaded: tuple[ControlFile, ...] = ()
        if address is not None:
            self.wanted[normal_text(self.definition, address)] = None
        for axis in axes:
            self._add_requested(axis)
        for leading, partner in self.partners.items():
            leader = self.wanted[leading]
            self.wanted.setdefault(partner, None if leader is None else partner_of(leader, partner))
        self.reader = text_reader(self.definition)
        self.texts = self._texts(files)
        names = axis_names(self.definition, self.texts, list(self.wanted))
        self.gathered = gather(self.definition, self.texts, names)
        self.unit = basic_system(self.gathered, self.notes) or str(control.options.get("units"))
        raise_all(InputError, self.notes.faults)
        for text in self.texts:
            self.notes.findings.extend(text.findings)
        self.tables = TableFiles(self.gathered, self.texts, self.notes)
        self.mentioned = self._mentioned_axes()

    def _add_requested(self, axis: Axis) -> None:
        name, assumption = self.control.address(axis)
        self.wanted[name] = axis
        if axis.gantry is not None:
            self.partners[name] = normal_text(self.definition, axis.gantry)
        if assumption is not None:
            self.notes.assumed.append(assumption)
            self.notes.taken_for(axis.name, name)

    def read(self) -> ControlState:
        """Return the state of the control from its files. Raises InputError and UsageError."""
        named = self.named()
        if not self.wanted and not named and not self.between():
            self._note_no_axis()
        readings: dict[str, AxisReading] = {}
        for address, axis in (self.wanted or dict.fromkeys(named)).items():
            if address in named or (len(self.wanted) == 1 and self.tables.alone()):
                readings[address] = self.axis(address, axis)
                if axis is not None:
                    check_turn(axis, readings[address].compensation, self.notes)
            elif address not in self.between():
                # else the files tell what it does to another axis; whether they must tell more is
                # for who asks
                self._refuse_unnamed(address, named)
        self._same_systems(readings)
        wanted = {name: axis for name, axis in self.wanted.items() if axis in self.axes and axis}
        couplings = self.couplings()
        check_couplings(couplings, wanted, self.notes)
        cross = self.cross()
        self.notes.ask_contradicted()
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        axes = {address: reading.compensation for address, reading in readings.items()}
        find_partners(
            self.gathered,
            self.partners,
            axes,
            self.notes,
            of_job=bool(self.wanted),
            single=[one for one in axes if readings[one].facts.stated.get("gantry_type") == 0],
        )
        self._note_files()
        return ControlState(
            format=self.definition.id,
            axes=axes,
            cross=cross,
            facts={
                address: replace(
                    one.facts,
                    couplings={**one.facts.couplings, **parameters_of(couplings, address)},
                )
                for address, one in readings.items()
            },
            tables=self.pair_tables(),
            stays={address: found for address in axes if (found := self.staying(axes[address]))},
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def named(self) -> list[str]:
        """Return the axis addresses that appear in lines, section names or names of table files."""
        return list(dict.fromkeys((*self.mentioned, *self.tables.named())))

    def between(self) -> Collection[str]:
        """Return the axes of cross-axis tables: none, because these files have no such tables."""
        return ()

    def couplings(self) -> Sequence[Coupling]:
        """Return possible couplings of joints that are homed together, because several joints that
        drive one axis are homed in this way.
        """
        return tuple(joined_joints(self.files)) if _JOINTS in self.definition.statements else ()

    def elsewhere(self, address: str) -> bool:
        """Return whether tables of another family, such as cross-axis tables, correct an axis,
        which then needs no table of this family.
        """
        del address
        return False

    def cross(self) -> tuple[CrossCompensation, ...]:
        """Return the corrections between axes in the control's files."""
        return ()

    def staying(self, compensation: AxisCompensation) -> tuple[AxisCompensation, ...]:
        """Return the tables of an axis that stay unchanged when a new table is written."""
        del compensation
        return ()

    def pair_tables(self) -> PairTables:
        """Return the cross-axis tables in the files."""
        return PairTables()

    def active_lines(self) -> dict[str, FoundValue]:
        """Return, by axis name, one line that shows an active correction of the axis: a value other
        than zero, or an activation parameter that is on.
        """
        return _active_lines(self.gathered)

    def axis(self, address: str, axis: Axis | None) -> AxisReading:
        """Return the active compensation of one axis, and facts about it."""
        self._one_name(address, axis)
        source = AxisSource(
            address=address,
            axis=axis,
            rows=self.tables.rows(address, mentioned=address in self.mentioned),
            elsewhere=self.elsewhere(address),
        )
        own = GridAxisReader(self.control, self.gathered, source, self.activity, self.notes).read()
        facts = AxisSettingsReader(self.gathered, address, self.notes).facts(
            own.facts, axis, self.partners
        )
        if axis is not None and address not in self.partners.values():
            # a gantry goes as far as its leading axis may
            check_limits(self.gathered, address, axis, facts, self.notes)
        return replace(own, facts=facts)

    def _one_name(self, address: str, axis: Axis | None) -> None:
        """Add a fault if it is unclear whether values under another name in the files, such as X1
        in addition to AX1, belong to this axis.

        This is unclear if no file contains the list of axis names.
        """
        if axis is None or "machine_axis" not in self.definition.bindings:
            return
        active = self.active_lines()
        others = self.gathered.names.unplaced(address, active)
        if not others:
            return
        names = ", ".join(others)
        self.notes.refuse(
            f"axis {address}",
            f"the files contain active values of {names} too. {names} may be another name of"
            " this axis: the list of names (MD10000 $MN_AXCONF_MACHAX_NAME_TAB) is in no file",
            active[others[0]],
            expected="the machine data with MD10000 among the files",
            found=names,
            hint=(
                "give the file with MD10000 with the control's other files; or set"
                f" `address: {others[0]}` in the job, if {others[0]} is the axis"
            ),
        )

    def _same_systems(self, readings: Mapping[str, AxisReading]) -> None:
        """Check that both axes of a gantry use the same measuring system."""
        for leading, partner in self.partners.items():
            used = [
                readings[address].facts.encoder_system
                for address in (leading, partner)
                if address in readings
            ]
            if len(used) == 2 and None not in used and used[0] != used[1]:
                self.notes.refuse(
                    f"axes {leading} and {partner}",
                    "the two axes of the gantry use different measuring systems",
                    None,
                    expected="the same measuring system for both, or the key `encoder` in the job",
                    found=f"{used[0]} and {used[1]}",
                    hint=(
                        "select the same measuring system for both in the control; or set"
                        " `encoder: {system: 1}` or `encoder: {system: 2}` for both axes in the job"
                    ),
                )

    def _texts(self, files: Sequence[ControlFile]) -> list[ReadText]:
        require_files(files)
        files = self._loaded(files)
        self._refuse_unknown(files)
        whole = texts_of(self.definition, files, self.notes.faults)
        texts = [
            self.reader.read(file, self.notes.faults, number) for number, file in enumerate(whole)
        ]
        raise_all(InputError, self.notes.faults)
        self.loaded = whole
        self._note_sources(files)
        read = [text for text in texts if text is not None]
        if not any(text.occurrences or text.sections for text in read):
            row = self.definition.bindings[curves(self.definition)[0]].statement
            form = self.definition.statements[row].form.replace("{", "<").replace("}", ">")
            raise InputError(
                Fault(
                    message=f"the files contain no compensation data of {self.definition.id}",
                    file=", ".join(text.file for text in read),
                    expected=f"lines such as {form}",
                    hint=(
                        "give the file with the compensation tables of this control, or correct "
                        "`format`"
                    ),
                )
            )
        return read

    def _loaded(self, files: Sequence[ControlFile]) -> list[ControlFile]:
        """Return the files that the control loads, and report files that it does not load."""
        aside = unused_table_files(self.definition, files)
        if "table_file" in self.definition.bindings:
            self.notes.faults.extend(changed_at_run_time(files))
            self.notes.faults.extend(offset_at_run_time(files, [one.name for one in self.axes]))
        if aside:
            more = max(0, len(aside) - 3)
            self.notes.idle_file(say("CW-S012.no_table", files=aside[:3], more=more))
        return [file for file in files if file.name not in aside]

    def _refuse_unknown(self, files: Sequence[ControlFile]) -> None:
        """Refuse files that cannot be opened or read as text; say which export to give instead."""
        for file in files:
            what = "" if is_container(file) else unknown_container(file.content)
            if len(_COLUMNS.findall(file.content)) > _FEW:
                what = "a listing in columns, without the values of the tables,"
            message = f"is {what} which cannot be read" if what else ""
            opened = is_container(file) and "files" in self.definition.options
            if not (message or opened) and BINARY.search(file.content):
                message = no_text(file.content)
            if message:
                self.notes.faults.append(
                    Fault(
                        message=message,
                        file=file.name,
                        expected=self.export_instead,
                        hint="leave this file out, and give the file as the control exports it",
                    )
                )
        raise_all(InputError, self.notes.faults)

    def _note_sources(self, files: Sequence[ControlFile]) -> None:
        """Report printed listings, and archives with programs that contain statements to load,
        activate or deactivate tables.
        """
        kinds = self.definition.texts.values()
        words = tuple(sorted({claim for kind in kinds for claim in kind.claims_anywhere}))
        for file in files:
            if is_listing(self.definition, file):
                self.notes.find("CW-S071", "warning", file=file.name)
            named = programs_setting(file, words) if is_container(file) else ()
            if named:
                self.notes.find("CW-S070", "info", file=file.name, programs=named)

    def _mentioned_axes(self) -> list[str]:
        """Return the axis addresses that appear in lines or section names."""
        found = self.gathered.addresses()
        for name in self.gathered.sections:
            for matcher in self.reader.matchers.values():
                match = matcher.section.fullmatch(name) if matcher.section is not None else None
                if match is not None and "axis" in match.groupdict():
                    found.append(normal_text(self.definition, match["axis"]))
        return list(dict.fromkeys(found))

    def _note_no_axis(self) -> None:
        name = self.tables.template.replace("{axis}", "<number>")
        old = [each for each in self.gathered.sections if re.fullmatch(r"AXIS_[0-9]", each)]
        if old:
            self.notes.faults.append(
                Fault(
                    message=f"sections such as [{old[0]}] belong to LinuxCNC releases before 2.8",
                    file=", ".join(text.file for text in self.texts),
                    expected="sections [JOINT_<number>], as update_ini of LinuxCNC 2.8 makes them",
                    hint=(
                        "convert the configuration with `update_ini` of LinuxCNC, then give the "
                        "new INI"
                    ),
                )
            )
            return
        self.notes.faults.append(
            Fault(
                message="the files do not show to which axis this table belongs",
                file=", ".join(text.file for text in self.texts),
                expected=f"a table that names its axis, a file with the name {name}, or the "
                "file that refers to the table",
                hint=(
                    f"set `address` of the axis in the job, rename the file to {name}, or add the "
                    "file that refers to it"
                ),
            )
        )

    def _refuse_unnamed(self, address: str, named: Sequence[str]) -> None:
        """Refuse an axis of which the files contain no compensation, but possibly settings."""
        definition, lines = self.definition, []
        for quantity in (curves(definition)[0], "backlash", "enabled"):
            if quantity in definition.bindings:
                statement = definition.statements[definition.bindings[quantity].statement]
                form = readable(statement.form).replace("<axis>", address)
                lines += [form] if "axis" in statement.fields else []
        expected = f"lines such as {', '.join(lines)}" if lines else f"lines for {address}"
        settings = self.gathered.singles.get((address, None), {})
        if settings:
            only = dict.fromkeys(name_of(definition, one) for one in settings)
            named = [*named, f"{address} (only {', '.join(only)})"]
        self.notes.no_data(f"axis {address}", self.loaded, named, expected)

    def _note_files(self) -> None:
        """Report findings on whole files, and the options assumed for axes outside a job."""
        self.tables.note_idle(self.wanted)
        for text in self.texts:
            variants = [occurrence.line for occurrence in text.occurrences if occurrence.variant]
            if variants:
                self.notes.find(
                    "CW-S013", "warning", file=text.file, line=variants[0], lines=len(variants)
                )
        if None in self.wanted.values() or not self.wanted:
            options = self.control.options
            self.notes.assume(
                REFERENCE, f"{options[REFERENCE]:g}", control_text("option or its default")
            )
            self.notes.assume(
                REFERENCE_RETURN,
                str(options[REFERENCE_RETURN]),
                control_text("option or its default"),
            )


def _active_lines(gathered: Gathered) -> dict[str, FoundValue]:
    lines: dict[str, FoundValue] = {}
    for (name, _), rows in gathered.rows.items():
        active = [row for row in rows if Decimal(row.occurrence.tokens["value"].text) != 0]
        if name is not None and active:
            lines[name] = active[-1]
    for (name, _), values in gathered.singles.items():
        active = [
            place
            for quantity in _CORRECTING
            for place in values.get(quantity, ())
            if Decimal(place.text) != 0
        ]
        if name is not None and active:
            lines[name] = active[-1]
    return lines
