"""Read the compensation from the files of a control with user-made tables (HEIDENHAIN).

A table belongs to the axis that moves. Each of its columns is the correction of one axis by that
motion. The axis' own column corrects the axis itself; the column of another axis corrects the other
axis. Sources: TNC 407 technical manual p153, MANUALplus 620 p716 and p718. Entry sheets contain
what is typed in at the control. Parameters are in sheets or in lines of a text: backlash, linear
error, and whether line or table is active.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.families.activity import Activity
from compwright.formats.families.columns.axis_reading import ColumnAxisReader
from compwright.formats.families.columns.source_files import find_sources
from compwright.formats.families.columns.sources import LETTERS, PARAMETERS, AxisNumbers
from compwright.formats.families.columns.table import POSITION, SECOND
from compwright.formats.families.columns.values import TableValues
from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    check_couplings,
    statements_in,
    whole_number,
    with_couplings,
)
from compwright.formats.families.family import Family, require_files
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.notes import Notes
from compwright.formats.text.values import name_of
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, partner_of
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from compwright.records.options import REFERENCE, REFERENCE_RETURN
from compwright.words.sentences import control_text, say

_LINE = re.compile(
    r"^[ \t]*MP[ \t]*850\.([0-9]{1,2})(?![0-9])[ \t]*[:=]?[ \t]*([^\s;]*)",
    re.MULTILINE | re.IGNORECASE,
)
_REMARK = re.compile(r";[^\r\n]*")


def couplings_of(
    files: Sequence[ControlFile],
    numbers: AxisNumbers,
    wanted: Sequence[str],
    known: Collection[str],
) -> Iterator[Coupling]:
    """Yield each coupling of axes, such as that of a gantry, stated in the files by axis
    ``numbers``. ``wanted``: addresses of the axes to be read; ``known``: axes that the job names.
    """
    last = {found.match[1]: found for found in statements_in(files, _LINE, _REMARK)}
    for index, found in last.items():
        follows, master = numbers.follower(int(index) + 1, known), whole_number(found.match[2])
        if master is None or master < 0:
            others = tuple(one for one in wanted if one != follows)
            yield found.coupling(others, follows, unlike=UNREAD)
        elif master:
            yield found.coupling((numbers.address(master),), follows)


def read_columns(
    control: Family,
    files: Sequence[ControlFile],
    axes: Sequence[Axis] = (),
    *,
    address: str | None = None,
    activity: Activity = Activity(),  # noqa: B008 - frozen
) -> ControlState:
    """Return the compensation in ``files``; arguments and errors as `Family.read`.

    ``facts`` of the result state for every axis: ``enabled`` (its table is active), ``own_column``
    (its own table is among the files and has a column for it), and ``second_column`` (this table
    has a column for travel towards -).
    """
    require_files(files)
    known = {control.address(axis)[0]: axis for axis in axes}
    wanted = [*known, *([] if address is None else [normal_text(control.definition, address)])]
    notes = Notes()
    sources = find_sources(control.definition, files, axes, notes.faults)
    raise_all(InputError, notes.faults)
    notes.findings.extend(sources.findings)
    named = {*wanted, *(axis.gantry for axis in axes if axis.gantry is not None)}
    couplings = tuple(couplings_of(files, sources.numbers, wanted, named))
    check_couplings(couplings, known, notes)
    mentioned = sources.mentioned()
    raise_all(UsageError, list(_number_faults(axes, mentioned)))
    for axis in axes:
        if axis.gantry is None:
            continue
        partner = normal_text(control.definition, axis.gantry)
        known.setdefault(partner, partner_of(axis, partner))
        if partner in mentioned:
            wanted.append(partner)
        else:  # its table would come out of the control by itself, as that of every axis
            notes.no_table(f"axis {partner}")
    values = TableValues(control, sources, known, notes)
    state = _ColumnStateReader(values, files, wanted, activity).read()
    facts = {name: with_couplings(one, couplings, name) for name, one in state.facts.items()}
    return replace(state, facts=facts)


def _number_faults(axes: Sequence[Axis], mentioned: Sequence[str]) -> Iterator[Fault]:
    """Yield a fault for every ``axis_number`` of the job that is used twice or does not fit the
    files.
    """
    free = [int(name) for name in mentioned if name.isdigit() and int(name) <= len(LETTERS)]
    numbered = [axis for axis in axes if axis.axis_number is not None]
    numbers = [axis.axis_number for axis in numbered]
    for index, axis in enumerate(numbered):
        place, found = f"axes.{axis.name}.axis_number", str(axis.axis_number)
        for other in numbered[:index]:
            if other.axis_number == axis.axis_number:
                yield Fault(
                    message=f"axes {other.name} and {axis.name} have the same axis number",
                    place=place,
                    found=found,
                    hint="give each axis the number that the control's list of axes shows",
                )
        letter = axis.address.strip().upper()
        usual = [*LETTERS].index(letter) + 1 if letter in [*LETTERS] else 0
        other_letter = dict(enumerate(LETTERS, start=1)).get(axis.axis_number or 0, "U")
        if usual in free and axis.axis_number not in numbers[:index]:
            yield Fault(
                message=f"the files use axis number {usual}, which no axis of the job has",
                place=place,
                expected=f"{usual} for {letter} (default: X is 1, Y 2, .. C 6)",
                found=f"axis_number: {found}",
                hint=f"remove `axis_number: {found}` if the control's list of axes shows "
                f"{letter} as number {usual}; otherwise add `address: {other_letter}` to "
                f"{axis.name}, with the letter that the control gives to number {found}",
            )


class _ColumnStateReader:
    def __init__(
        self,
        values: TableValues,
        files: Sequence[ControlFile],
        wanted: Sequence[str],
        activity: Activity,
    ) -> None:
        self.values = values
        self.sources = values.sources
        self.notes = values.notes
        self.files = files
        self.wanted = wanted
        self.activity = activity

    def read(self) -> ControlState:
        sources = self.sources
        mentioned = sources.mentioned()
        compensations: dict[str, AxisCompensation] = {}
        facts: dict[str, AxisFacts] = {}
        for address in self.wanted or mentioned:
            if address not in mentioned and not sources.idle:
                expected = self._data_of(address)
                self.notes.no_data(f"axis {address}", self.files, mentioned, expected)
            reader = ColumnAxisReader(self.values, address, self.wanted, self.activity)
            if reader.is_mentioned:
                compensations[address] = reader.read()
            if reader.is_mentioned or address in self.wanted:
                facts[address] = AxisFacts(
                    kind=self.values.stated_kind(address),
                    enabled=bool(reader.facts["enabled"]),
                    grid=reader.idle,
                    stated=reader.facts,
                )
        cross = self._cross()
        if not compensations and not cross and not sources.idle and not self.notes.faults:
            self.notes.faults.append(
                Fault(
                    message="the files contain no compensation data of any axis",
                    file=", ".join(file.name for file in self.files),
                    hint=(
                        "add the files with tables and compensation parameters, or give `none` "
                        "instead of files if the control has no compensation"
                    ),
                )
            )
        self.notes.ask_contradicted()
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        self._general(compensations)
        return ControlState(
            format=self.values.definition.id,
            axes=compensations,
            cross=cross,
            facts=facts,
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
        )

    def _cross(self) -> tuple[CrossCompensation, ...]:
        found = []
        layout = self.values.definition.layout
        for moving, table in self.sources.tables.items():
            for name in table.others(self.sources.column_of(moving), POSITION, SECOND):
                positions = self.values.positions(table, moving)
                output = self.sources.axis_of(name)
                values = (
                    None
                    if positions is None
                    else self.values.values(table, name, positions, output, moving)
                )
                if positions is None or values is None:
                    continue
                points, curve, period = self.values.turned(
                    moving, np.array([float(one) for one in positions]), values, table.file
                )
                if self._off(output):  # no table is active on this axis, but it has a column
                    curve = np.zeros(points.size)
                found.append(
                    CrossCompensation(
                        input=moving,
                        output=output,
                        input_kind=self.values.kind(moving),
                        output_kind=self.values.kind(output),
                        positions=points,
                        positive=curve,
                        negative=curve,
                        below=layout.below,
                        above=layout.above,
                        period=period,
                    )
                )
        return tuple(found)

    def _off(self, address: str) -> bool:
        """Return whether no table is active on an axis, by the parameter bit in the files or,
        without one, by the job.
        """
        bits = self.sources.given.get((address, "enabled"), [])
        if bits:
            return bits[0].text == "0" and self.activity.stated is not True
        return self.activity.stated is False and not self.sources.starred

    def _general(self, compensations: Mapping[str, AxisCompensation]) -> None:
        """Add findings about all axes to the notes: missing files, inactive tables, assumptions."""
        sources = self.sources
        for file, address in sources.assumed.items():
            self.notes.assume(
                control_text("{file}: moving axis", file=file),
                address,
                control_text("inferred from its name: no table of assignments (.CMA) was given"),
            )
        for table in sources.idle:
            self.notes.idle_file(say("CW-S012.assignments", file=table.file))
        for address, name in sources.missing.items():
            if address not in self.wanted:
                self.notes.idle_file(say("CW-S012.not_given", file=name, axis=address))
        if any(one.positions.size for one in compensations.values()):
            self.notes.assume(
                control_text("outside the tables"),
                control_text("the end values hold"),
                self.values.definition.layout.evidence.text,
            )
        options = self.values.control.options
        if any(address not in self.values.axes for address in compensations):
            self.notes.assume(
                REFERENCE, f"{options[REFERENCE]:g}", control_text("option or its default")
            )
            self.notes.assume(
                REFERENCE_RETURN,
                str(options[REFERENCE_RETURN]),
                control_text("option or its default"),
            )

    def _data_of(self, address: str) -> str:
        """Return as text what files can contain of an axis."""
        definition = self.values.definition
        names = [name_of(definition, name) for name in PARAMETERS if name in definition.bindings]
        return (
            f"a .CMA or .COM with a column of {address}, or a list of machine parameters or an"
            f" entry sheet with {' or '.join(names)} of {address}"
        )
