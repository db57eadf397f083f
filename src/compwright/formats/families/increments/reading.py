"""Read the files of a FANUC control as compensation.

All axes share one array of point numbers, and every axis has a range of it. Let r be the number of
the reference position and b the interval. Number n then belongs to the section ((n - r - 1) b, (n -
r) b).

The correction at a table point is the sum of the increments between it and the reference. They
count with their own sign to the right of the reference, with the opposite sign to the left. Source:
FANUC 0i-PB parameter manual B-63980EN/01 p100; numbering inferred from its listing. The definition
lists what is unconfirmed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from compwright.formats.definition.options import known_kind
from compwright.formats.definition.schema import Definition
from compwright.formats.families.coupled_axes import check_couplings, with_couplings
from compwright.formats.families.family import Family, require_files
from compwright.formats.families.increments.axis_facts import facts_of, name_of, with_neighbours
from compwright.formats.families.increments.axis_reading import IncrementReader
from compwright.formats.families.increments.axis_values import IncrementAxisValues
from compwright.formats.families.increments.coupling import couplings_of
from compwright.formats.families.increments.detection_unit import resolved_options
from compwright.formats.families.increments.increment_facts import increments_of
from compwright.formats.families.increments.parameter_checks import pointed_numbers
from compwright.formats.families.increments.parameters import (
    MULTIPLIER,
    AxisParameters,
    Parameters,
    ParameterValue,
)
from compwright.formats.families.increments.points import points_by_number
from compwright.formats.families.increments.sections import GRID, read_sections
from compwright.formats.families.increments.sheet_lines import parameter_lines
from compwright.formats.families.increments.straightness import straightness_pairs
from compwright.formats.text.addresses import normal_text
from compwright.formats.text.entry_sheet import is_entry_sheet
from compwright.formats.text.gathering import gather
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import ReadText, text_reader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Axis, partner_of
from compwright.records.correction import (
    AxisCompensation,
    ControlFile,
    ControlState,
    CrossCompensation,
)
from compwright.records.facts import AxisFacts
from compwright.records.options import DETECTION_UNIT, REFERENCE, REFERENCE_RETURN

#: What makes an axis one that the files say something of: its limits, name and kind alone do not.
_COMPENSATION = {*GRID, "turn", "negative_first", "negative_offset", "bidirectional", "backlash"}


class StateReader:
    """Reads the state of a control from its ``files``; see `Family.read` for the arguments."""

    def __init__(
        self,
        family: Family,
        files: Sequence[ControlFile],
        axes: Sequence[Axis],
        address: str | None,
    ) -> None:
        self.family = family
        self.files = files
        self.axes = axes
        self.notes = Notes()
        self.highest = family.definition.limit_number("max_number") or 0
        texts = read_texts(family.definition, files, self.notes.faults)
        raise_all(InputError, self.notes.faults)
        self.gathered = gather(family.definition, texts)
        self.notes.findings.extend(finding for text in texts for finding in text.findings)
        self.points = points_by_number(family.definition, self.gathered, files, self.notes)
        lines = [_as_lines(file, family.definition.id) for file in self.files]
        self.parameters = Parameters(lines, family.definition.parameters)
        self.notes.faults.extend(self.parameters.unread)
        self.partners = {
            normal_text(family.definition, axis.gantry): axis
            for axis in axes
            if axis.gantry is not None
        }
        self.wanted = self._wanted(address)
        self.compensations: dict[str, AxisCompensation] = {}
        self.facts: dict[str, AxisFacts] = {}

    def read(self) -> ControlState:
        """Return the state of the control; raises errors as `Family.read`."""
        named = [
            address
            for address in self.gathered.addresses()
            if address != "0"
            and not _COMPENSATION.isdisjoint(self.gathered.singles.get((address, None), {}))
        ]
        for address in dict.fromkeys((*self.wanted, *named)):
            if address not in named:
                expected = f"parameters with A{address}"
                self.notes.no_data(f"axis {address}", self.files, named, expected)
            elif address in self.wanted or not self.wanted:
                self._read_axis(address)
            else:
                self._leave_alone(address)
        self._check_names()
        self._note_unknown()
        self.notes.faults.extend((*self._refuse_partners(), *self._refuse_one_unit()))
        couplings = couplings_of(self.parameters, self._numbers())
        wanted = {name: axis for name, axis in self.wanted.items() if axis in self.axes and axis}
        check_couplings(couplings, wanted, self.notes)
        cross = tuple(self._cross())
        raise_all(InputError, self.notes.faults)
        raise_all(UsageError, self.notes.questions)
        self._note_overlaps()
        unknown = self._unknown()
        if None in self.wanted.values() or not self.wanted:
            options, why = self.family.options, "option or its default"
            self.notes.assume(REFERENCE, f"{options[REFERENCE]:g}", why)
            self.notes.assume(REFERENCE_RETURN, str(options[REFERENCE_RETURN]), why)
        return ControlState(
            format=self.family.definition.id,
            axes=self.compensations,
            cross=cross,
            facts={
                address: with_couplings(
                    replace(facts, of_family=replace(increments_of(facts), unread=unknown)),
                    couplings,
                    address,
                )
                for address, facts in self.facts.items()
            },
            assumed=tuple(self.notes.assumed),
            findings=tuple(dict.fromkeys(self.notes.findings)),
            reserved=self._filled() | pointed_numbers(self.parameters) | unknown,
        )

    def names(self) -> dict[str, str]:
        """Return the name of each axis in the files, by address; axes without a name are left
        out.
        """
        names = {
            address: name_of(self._values(address, Notes()))
            for address in self.gathered.addresses()
            if address not in (None, "0")
        }
        return {address: name for address, name in names.items() if name is not None}

    def _cross(self) -> Iterator[CrossCompensation]:
        """Yield the corrections between axes by straightness compensation, if an option includes
        it.
        """
        if self.family.options.get("straightness") != "available":
            return
        faults = self.notes.faults
        for pair in straightness_pairs(self.parameters, self._numbers(), faults):
            moving, bent = (self._values(each, Notes()) for each in (pair.moving, pair.bent))
            sections = read_sections(moving, moving.kind(quiet=True))
            unit = resolved_options(bent, self.family.options).get(DETECTION_UNIT)
            if sections is None or moving.wraps() or not isinstance(unit, float):
                message = f"{pair.place.label}: straightness compensation cannot be counted"
                expected = "a moving axis with a table and ends, a detection unit of the other"
                faults.append(pair.place.fault(message, expected))
                continue
            axis = self.wanted.get(pair.moving)
            zero = axis.reference if axis else float(str(self.family.options[REFERENCE]))
            points = sections.points(zero, round_turn=False)
            numbers = np.arange(sections.first - 1, sections.last + 1, dtype=np.float64)
            moved = pair.at(numbers, sections.reference) * unit
            self.notes.assume(
                f"straightness of axis {pair.bent} by axis {pair.moving}",
                f"counted by {pair.place.label}",
                "unconfirmed: parameters and sign from general knowledge, detection units",
            )
            yield CrossCompensation(
                input=pair.moving,
                output=pair.bent,
                input_kind=moving.kind(quiet=True),
                output_kind=bent.kind(quiet=True),
                positions=points,
                positive=moved,
                negative=moved,
            )

    def _wanted(self, address: str | None) -> dict[str, Axis | None]:
        wanted: dict[str, Axis | None] = {}
        if address is not None:
            wanted[normal_text(self.family.definition, address)] = None
        for axis in self.axes:
            name, assumption = self.family.address(axis)
            wanted[name] = axis
            if assumption is not None:
                self.notes.assumed.append(assumption)
                self.notes.taken_for(axis.name, name)
        for partner, axis in self.partners.items():
            wanted.setdefault(partner, partner_of(axis, partner))
        return wanted

    def _numbers(self) -> list[str]:
        """Return the axis numbers of all axes in the files."""
        return [address for address in self.gathered.addresses() if address != "0"]

    def _values(self, address: str, notes: Notes) -> IncrementAxisValues:
        own = AxisParameters(self.parameters, address)
        return IncrementAxisValues(
            self.family.definition,
            own.label,
            notes,
            self.gathered,
            own=own,
            axis=self.wanted.get(address),
            known_kind=known_kind(self.family.options, address),
        )

    def _read_axis(self, address: str) -> None:
        values = self._values(address, self.notes)
        try:
            options = resolved_options(values, self.family.options)
        except UsageError as error:  # asked together with all other questions
            self.notes.questions.extend(error.faults)
            return
        # a gantry goes as far as its leading axis may
        leads = address not in self.partners
        reader = IncrementReader(values, self.points, options, checks_travel=leads)
        compensation = reader.read()
        facts = replace(facts_of(values), rapid_more=reader.rapid_more())
        self.facts[address] = with_neighbours(facts, values.own, options)
        if compensation is not None:
            self.compensations[address] = compensation

    def _leave_alone(self, address: str) -> None:
        """Read an axis that the job does not name; its faults become a warning, so that the job's
        axes can be read all the same.
        """
        notes = Notes()
        values = self._values(address, notes)
        facts = with_neighbours(facts_of(values), values.own, self.family.options)
        self.facts[address] = facts
        if self.points:
            options = {**self.family.options, DETECTION_UNIT: 1.0}
            IncrementReader(values, self.points, options).read()
        odd = [finding for finding in notes.findings if finding.code == "CW-S041"]
        self.notes.findings.extend(odd)
        if notes.faults and facts.enabled:
            reasons = (f"{fault.message} ({fault.place}: {fault.found})" for fault in notes.faults)
            self.notes.find("CW-S042", "warning", axis=address, reasons=dict.fromkeys(reasons))

    def _filled(self) -> frozenset[int]:
        """Return the point numbers whose values are not zero; new tables must not use these
        numbers.
        """
        texts = {number: row.occurrence.tokens["value"].text for number, row in self.points.items()}
        return frozenset(number for number, text in texts.items() if text.strip("-0"))

    def _unknown(self) -> frozenset[int]:
        """Return the point numbers below the user's ``first_point`` that are in no file.

        These numbers do not count as free, because the pitch file may have been cut short or not
        given.
        """
        options = [axis.options for axis in self.axes] + [self.family.options]
        stated = [each.get("first_point") for each in options]
        first = min((int(str(one)) for one in stated if one is not None), default=self.highest + 1)
        return frozenset(number for number in range(first) if number not in self.points)

    def _refuse_partners(self) -> Iterator[Fault]:
        """Yield a fault if the two axes of a gantry differ in kind or in detection unit."""
        for axis in self.axes:
            if axis.gantry is None or axis.gantry not in self.facts:
                continue
            partner, place = self.facts[axis.gantry], f"axes.{axis.name}.gantry"
            if partner.kind is not None and partner.kind is not axis.kind:
                yield Fault(
                    message=(
                        f"axes {axis.address} and {axis.gantry} cannot form a gantry: one "
                        "is linear, the other rotary (1006#0)"
                    ),
                    place=place,
                    expected=f"a {axis.kind.value} axis",
                    found=f"{axis.gantry}, {partner.kind.value}",
                    hint=f"correct `gantry` of axis {axis.address} in the job",
                )
            leading = self.facts.get(axis.address, AxisFacts())
            own, other = (facts.stated.get(DETECTION_UNIT) for facts in (leading, partner))
            if own is not None and other is not None and own != other:
                yield Fault(
                    message=(
                        f"axes {axis.address} and {axis.gantry} of a gantry have different"
                        " detection units (1820, 1013)"
                    ),
                    place=place,
                    expected=f"{own:g}",
                    found=f"{other:g}",
                    hint="correct `gantry` in the job, or work on the two axes in two jobs",
                )

    def _refuse_one_unit(self) -> Iterator[Fault]:
        """Yield a fault if axes share the job's detection unit but have different multipliers
        (1820).
        """
        shared: dict[object, ParameterValue] = {}
        for address in filter(self.facts.__contains__, self.wanted):
            own, axis = AxisParameters(self.parameters, address), self.wanted[address]
            multiplier = own.get(MULTIPLIER)
            if multiplier is None or DETECTION_UNIT in self.facts[address].stated:
                continue
            options = {**self.family.options, **(axis.options if axis else {})}
            first = shared.setdefault(options.get(DETECTION_UNIT), multiplier)
            if first.whole != multiplier.whole:
                yield replace(
                    multiplier.fault(
                        f"the 1820 of {own.label} differs, so one detection_unit does not fit both"
                        " axes",
                        f"{first.label}, or the increment system (1013) among the files",
                    ),
                    hint=(
                        "give the whole parameter file; or give `detection_unit` under the options"
                        " of each axis, and work on the axes of a gantry in two jobs"
                    ),
                )

    def _check_names(self) -> None:
        """Check that the letter of an axis in the job is not that of another axis of the control
        (1020).
        """
        for address, axis in self.wanted.items():
            own = self.facts.get(address, AxisFacts()).name
            if axis is None or own is None or own == axis.name:
                continue
            others = [other for other, facts in self.facts.items() if facts.name == axis.name]
            if others:
                self.notes.faults.append(
                    Fault(
                        message=(
                            f"axis {address} of the control is called {own} (1020), not {axis.name}"
                        ),
                        place=f"axes.{axis.name}.address",
                        expected=" or ".join(others),
                        found=address,
                        hint=f"set `address: {others[0]}` for this axis in the job",
                    )
                )

    def _note_unknown(self) -> None:
        """Report once the parameters whose number has an unknown meaning on this series of
        controls.
        """
        definition, values = self.family.definition, self.parameters.unknown
        numbers = sorted({value.number for value in values})
        if numbers:
            self.notes.find(
                "CW-S057",
                "warning",
                format=definition.id,
                parameters=map(str, numbers),
                place=values[0].place,
            )

    def _note_overlaps(self) -> None:
        owners: dict[int, list[str]] = {}
        for address, facts in self.facts.items():
            for numbers in increments_of(facts).claimed if facts.enabled else ():
                for number in range(max(numbers.start, 0), min(numbers.stop, self.highest + 1)):
                    owners.setdefault(number, []).append(address)
        shared: dict[tuple[str, ...], list[int]] = {}
        for number, names in owners.items():
            shared.setdefault(tuple(names), []).append(number)
        for sharing, each in shared.items():
            if len(sharing) > 1:
                self.notes.find(
                    "CW-S014", "warning", addresses=sharing, first=min(each), last=max(each)
                )


def read_texts(
    definition: Definition, files: Sequence[ControlFile], faults: list[Fault]
) -> list[ReadText]:
    """Return the statements of all files, entry sheets included. Unreadable files are added to
    ``faults``.
    """
    require_files(files)
    reader = text_reader(definition)
    texts = []
    for number, file in enumerate(files):
        source = file
        if is_entry_sheet(file):
            source = ControlFile(file.name, parameter_lines(file, definition.id, faults))
        text = reader.read(source, faults, number)
        if text is not None:
            texts.append(text)
    if not faults and not any(text.occurrences for text in texts):
        faults.append(
            Fault(
                message=f"the files contain no compensation data of {definition.id}",
                file=", ".join(file.name for file in files),
                expected="lines such as N03620Q1A1P40 and N10037Q0P1",
                hint=(
                    "give the parameter and pitch files that the control punches out, or "
                    "correct `format`"
                ),
            )
        )
    return texts


def _as_lines(file: ControlFile, format_id: str) -> ControlFile:
    """Return an entry sheet converted to parameter lines, or any other file unchanged."""
    if not is_entry_sheet(file):
        return file
    return ControlFile(file.name, parameter_lines(file, format_id, []))
