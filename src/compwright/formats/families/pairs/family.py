"""SINUMERIK family of controls: a table for each axis, and cross-axis tables (CEC)."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import ClassVar

import numpy as np

from compwright.formats.definition.statements import Occurrence
from compwright.formats.families.activity import Activity
from compwright.formats.families.axis_pairs import Between, BetweenRequest
from compwright.formats.families.card_texts import (
    CURVES,
    AxisCard,
    CardRequest,
    and_joined,
    loading_order,
    named_files,
    numbered_files,
    table_values,
)
from compwright.formats.families.control_texts import is_listing, texts_of
from compwright.formats.families.family import Family, Listing
from compwright.formats.families.grid.family import GridFamily
from compwright.formats.families.pairs.axis_pairs import pairs_between
from compwright.formats.families.pairs.capacity import PairLimits
from compwright.formats.families.pairs.file_values import file_values, value_location
from compwright.formats.families.pairs.options import (
    allowed_tables,
    available,
    reserving,
    tables_in_words,
)
from compwright.formats.families.pairs.program_flow import scanned
from compwright.formats.families.pairs.programs import not_carried_out
from compwright.formats.families.pairs.small_files import SmallFiles
from compwright.formats.families.pairs.state import PairsReader
from compwright.formats.families.pairs.writing import PairsWriter
from compwright.formats.text.container import is_container
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity
from compwright.records.correction import Assumption, AxisCompensation, ControlFile, ControlState
from compwright.records.delivery import Delivery
from compwright.words.sentences import control_text, unconfirmed


def with_sign_unknown(state: ControlState) -> ControlState:
    """Return the state; if it has cross-axis tables, add the assumption that their values are
    corrections, not errors.
    """
    if not state.tables.used:
        return state
    assumption = Assumption(
        control_text("option {name}", name="cec_sign"),
        "correction",
        unconfirmed(
            control_text("one manual of Siemens says error; no readings depend on it here")
        ),
    )
    return replace(
        state,
        assumed=(*state.assumed, assumption),
        findings=(*state.findings, Finding.of("CW-S055", "warning")),
    )


_ARCHIVE = (
    "an archive in a container, which is never written: a control may refuse an archive that was"
    " edited"
)
_PROGRAM = "a program of which the control may not execute every line, such as a changed one"
_BLANK = "a file with a blank in place of the equals sign, a form that no manual shows"
_LISTING = "a listing with decimal commas, which the control does not take"


def _shown(control: Family) -> Family:
    """Return ``control``, or a copy for displaying files in which table values of unknown sign
    count as corrections.
    """
    if control.options.get("cec_sign", "") is not None:
        return control
    shown = PairsFamily(control.definition, {**control.options, "cec_sign": "correction"})
    shown.sign_assumed = True
    return shown


def _drafted(control: Family) -> Family:
    """Return a copy of ``control`` for reading the files from which a job file is drafted."""
    shown = _shown(control)
    draft = PairsFamily(control.definition, shown.options)
    draft.sign_assumed, draft.drafting = shown is not control, True
    return draft


def _alone(control: Family, files: Sequence[ControlFile]) -> Sequence[str]:
    """Return the addresses of all axes in the files, because each axis can be read alone if another
    one is faulty.
    """
    return PairsReader(_shown(control), files, (), None, Activity()).named()


class PairsFamily(GridFamily):
    """Controls with a table for each axis and with cross-axis tables (SINUMERIK).

    ``sign_assumed``: no option states the sign of the values in cross-axis tables. They are then
    read as corrections, which is allowed only to display files or to draft a job.
    """

    reader = PairsReader
    writer = PairsWriter
    listing: ClassVar[Listing] = Listing(
        file_values=file_values,
        value_location=value_location,
        readable_alone=_alone,
        executed=not_carried_out,
        for_display=_shown,
        for_draft=_drafted,
    )
    sign_assumed = False

    def read(
        self,
        files: Sequence[ControlFile],
        axes: Sequence[Axis] = (),
        *,
        address: str | None = None,
        activity: Activity = Activity(),  # noqa: B008 - frozen
    ) -> ControlState:
        """Return the state of a control from its ``files``; see `Family.read`."""
        state = super().read(files, axes, address=address, activity=activity)
        return with_sign_unknown(state) if self.sign_assumed else state

    def write(
        self,
        compensations: Sequence[AxisCompensation],
        axes: Sequence[Axis],
        files: Sequence[ControlFile] = (),
    ) -> tuple[ControlFile, ...]:
        """Return the files that load ``compensations`` into the control; see `Family.write`."""
        self._check_form(files)
        return super().write(compensations, axes, files)

    def delivered(
        self,
        files: Sequence[ControlFile],
        own: Sequence[ControlFile],
        axes: Sequence[Axis],
    ) -> Delivery:
        """Return the files to load, small ones or the changed own files; see `Family.delivered`."""
        self._check_form(own)
        faults: list[Fault] = []
        texts = texts_of(self.definition, own, faults)
        raise_all(InputError, faults)
        if not (files and texts) or "files" not in self.options:
            return Delivery(tuple(files))
        small = SmallFiles(self, texts, files, axes)
        if self._small_files(own):
            return Delivery(small.files(), small.back(), own=False)
        return Delivery(tuple(files), small.back())

    def _small_files(self, own: Sequence[ControlFile]) -> bool:
        """Return whether changes to the control's ``own`` files are written as small files."""
        form = self.options.get("files")
        if any(self._unpatched(file) for file in own) or form == "patched":
            return form != "patched"
        return bool(own) and (form == "small" or any(map(self._holds_others, own)))

    def _holds_others(self, file: ControlFile) -> bool:
        """Return whether a file contains tables that are activated by different parameters.

        If such a file is loaded as a whole, it also assigns values to active tables, which the
        control rejects. Cross-axis tables of one axis, such as one for each direction, share the
        activation parameter of the axis that they correct.
        """
        own, output = self._statements_of("value"), self._statements_of("cross_output")
        between = self._statements_of("cross_value")
        found = self._statements_in(file)
        corrected = {
            one.tokens["table"].text: one.tokens["value"].text
            for one in found
            if one.statement in output
        }
        switches = {
            (one.statement, one.tokens["axis"].text, one.tokens["system"].text)
            for one in found
            if one.statement in own
        } | {
            (one.statement, corrected.get(index, ""), "" if index in corrected else index)
            for one in found
            if one.statement in between
            for index in [one.tokens["table"].text]
        }
        return len(switches) > 1

    def _statements_in(self, file: ControlFile) -> Sequence[Occurrence]:
        text = text_reader(self.definition).read(file, [])
        return () if text is None else text.occurrences

    def _statements_of(self, *quantities: str) -> set[str]:
        return {self.definition.bindings[name].statement for name in quantities}

    def _check_form(self, own: Sequence[ControlFile]) -> None:
        """Raise UsageError if the option ``files: patched`` requires a change of the control's
        ``own`` files in a form that the control would not load.
        """
        if self.options.get("files") != "patched":
            return
        reasons = {file.name: why for file in own if (why := self._unpatched(file))}
        raise_all(
            UsageError,
            [
                Fault(
                    message=f"the option `files: patched` is impossible, because {name} is {why}",
                    place="files",
                    expected="files: small, or no such option",
                    found="files: patched",
                    hint="set `files: small`, or leave the option `files` out",
                )
                for name, why in reasons.items()
            ],
        )

    def _unpatched(self, file: ControlFile) -> str:
        """Return why the control would not load a file after changes; empty if it would."""
        if is_container(file):
            return _ARCHIVE
        if is_listing(self.definition, file):
            return _LISTING
        if scanned(self.definition, file).leaves_out:
            return _PROGRAM
        statements = self.definition.statements
        blank = any(
            one.variant and "=" not in statements[one.statement].also_read[one.form - 1]
            for one in self._statements_in(file)
        )
        return _BLANK if blank else ""

    def capacity(self, axis: Axis, *, one_curve: bool = False) -> Capacity:
        """Return the limits of an axis' single table, or of its two tables by direction; see
        `Family.capacity`.
        """
        if one_curve or not available(self.options_of(axis)):
            return super().capacity(axis)
        return PairLimits(self, axis).capacity()

    def between(self, request: BetweenRequest) -> Between:
        """Return cross-axis tables for the corrections, if the control has them; see
        `Family.between`.
        """
        if not available(self.options):
            return super().between(request)
        return pairs_between(self, request, small=self._small_files(request.found))

    def _named_files(self, request: CardRequest) -> dict[str, str]:
        """Return the names of files for the card: of the written table and of tables set to zero.

        A single table can replace two cross-axis tables by which the axis corrects itself; these
        are then set to zero. Of a pair of tables, one can be in a new file and the other in the
        control's own files.
        """
        axis, files = request.axis, request.files
        names, written = named_files(self, axis, files), [file.name for file in files]
        table, emptied = names.get("file_1", ""), names.get("file_3", "")
        if table in written and emptied in written:
            names["file_1"] = and_joined([emptied, table])
        fresh = numbered_files(self.definition, replace(axis, address=self.address(axis)[0]))
        if fresh["file_3"] in written:
            allowed = allowed_tables(self.definition, self.options_of(axis))
            indices = "|".join(map(str, request.facts.pairs.own or allowed))
            row = re.compile(rb"\$AN_CEC\s*\[\s*(?:%b)\s*," % indices.encode())
            own = [file for file in files if indices and file.name not in fresh.values()]
            with_rows = [file for file in own if row.search(file.content)]
            if with_rows:
                also = ", ".join(loading_order(self.definition, with_rows))
                names["file_3"] = control_text(
                    "{file}, then your own patched {files}", file=fresh["file_3"], files=also
                )
        return names

    def _around_emptied(self, axis: Axis) -> dict[str, str]:
        """Return the card's text about an axis' old cross-axis tables, which the new table
        replaces.

        They must be switched off before the files are loaded, because the control protects the
        values of an active table.
        """
        address = self.address(axis)[0]
        allowed = allowed_tables(self.definition, self.options_of(axis))
        mine = [
            str(one) for one, pair in self.state.tables.used.items() if pair == (address, address)
        ]
        mine = [one for one in mine if int(one) in allowed]
        if not mine:
            return {}
        which = tables_in_words(mine)
        switch = f"MD32710 $MA_CEC_ENABLE[{address}]"
        return {
            "emptied": control_text(
                " Set {switch} = 0 (note what it was) and SD41300 $SN_CEC_TABLE_ENABLE = 0 for the"
                " {which}, NEW CONF: what the new table takes the place of is emptied, and"
                " protected while it is on.",
                switch=switch,
                which=which,
            ),
            "woken": control_text(
                "If MD32710 was on: set {switch} = 1 again, NEW CONF. ", switch=switch
            ),
        }

    def card(self, request: CardRequest) -> AxisCard:
        """Return the contents of the commissioning card for a written table; see `Family.card`."""
        axis, compensation = request.axis, request.table
        values = {**super().card(request).values, **self._named_files(request)}
        if axis.gantry is None and request.facts.stated.get("gantry_type") == 0:
            values["gantry"] = control_text("No gantry: MD37100 = 0 in the control's files.")
        if not np.array_equal(compensation.positive, compensation.negative):
            values[CURVES] = "2"
        else:
            values |= self._around_emptied(axis)
        known = self.state.facts_of(self.address(axis)[0])
        protected = str(known.stated.get("others_protected", ""))
        if self.options.get("files") == "patched" and protected:
            off, on = (protected.replace(";", f" = {state}, ") for state in ("0", "1"))
            values["others"] = control_text(
                " The patched files assign other tables again, which a control protects while they"
                " are on. Set {switches} = 0 too and activate it (NEW CONF).",
                switches=off,
            )
            values["others_back"] = control_text(
                " Then set {switches} = 1 again and activate it (NEW CONF).", switches=on
            )
        archive = known.stated.get("archive")
        if archive is not None:
            values["archive"] = control_text(
                "The contents of the archive are not verified. Compare on the control, before"
                " anything is changed: {archive}. If one differs, load nothing: export the archive"
                " again, and run again.",
                archive=str(archive),
            )
        own = request.facts.pairs.own
        if own is not None:
            if CURVES in values:  # a CEC table counts in its own unit, whatever the control's is
                scale = self.scale_of(axis)
                values |= table_values(self.definition, scale, compensation, "cross_start")
            which = control_text("the tables {tables}", tables=and_joined([*map(str, own)]))
            values["room"] = reserving(self.definition, int(compensation.positions.size), which)
            names = ("table_positive", "table_negative")
            values |= dict(zip(names, map(str, own), strict=True))
        return AxisCard(values)
