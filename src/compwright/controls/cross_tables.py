"""Write cross-axis tables into a control's files, read them back, and describe them on the card."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import product

import numpy as np

from compwright.controls.control import Control, decode
from compwright.controls.decoded_state import DecodedState
from compwright.controls.file_replacement import with_new_tables
from compwright.controls.judged_corrections import judged_cross
from compwright.formats.families.axis_pairs import (
    Between,
    BetweenRequest,
    cannot_hold,
    combined_answer,
    error_label,
    merged_files,
    not_corrected,
)
from compwright.formats.families.control_texts import texts_of
from compwright.foundations.errors import CompwrightError, Fault, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.own_faults import SEND_JOB
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import ControlFile, ControlState, CrossCompensation
from compwright.records.plan import PlannedCross
from compwright.words.sentences import SentenceText, say

#: Reading back may differ from what was planned by half a step of the value at either point, mm or
#: deg.
READ_BACK_WITHIN = 2e-6


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossOutcome:
    """The result of writing corrections between axes: all files to load, and the new state.

    - ``planned``: the planned corrections; those that could not be written are marked.
    - ``after``: the written files, decoded; None if nothing was written, so that the old
      corrections remain.
    - ``totals``: the resulting corrections between the axes of ``planned``, as the independent file
      reader decodes them, with the axis names of the job.
    - ``steps``: further steps of the card. ``sheets``: entry sheets, in addition to the card.
    """

    files: tuple[ControlFile, ...]
    planned: tuple[PlannedCross, ...] = ()
    written: bool = False
    after: DecodedState | None = None
    totals: tuple[CrossCompensation, ...] = ()
    findings: tuple[Finding, ...] = ()
    steps: tuple[Mapping[str, str], ...] = ()
    sheets: tuple[ControlFile, ...] = ()


def write_planned(
    control: Control,
    planned: Sequence[PlannedCross],
    tables: tuple[ControlFile, ...],
    as_found: DecodedState,
    axes: Mapping[str, Axis],
    tabled: Collection[str] = (),
) -> CrossOutcome:
    """Write the ``planned`` cross-axis tables into the control's files, together with the files
    ``tables`` that contain the new axis tables, and read all files back. ``as_found``: the
    control's files before; ``tabled``: names of the axes with a new axis table.

    ``control``: the control with the options of the state ``as_found``. ``axes``: axes of the job
    by name. A correction that the control cannot store is not written. A finding and a step of the
    card report it with a remedy. Raises CompwrightError (an internal error) if the files read back
    differ from the plan.
    """
    if not planned:
        return CrossOutcome(files=tables)
    between = {name for entry in planned for name in (entry.input, entry.output)}
    own = texts_of(control.definition, as_found.files, [])  # read before
    base = with_new_tables(control, own, tables, [axes[name].address for name in tabled])

    @cache  # the family reads what is compared here
    def read(files: tuple[ControlFile, ...], *, written: bool = False) -> DecodedState:
        # Of a control without files only the axes are known whose tables were written just now.
        named = {*axes} if as_found.files else {*tabled, *(between if written else ())}
        known = [  # nor has the slave of a gantry a table, if its master has none
            axis if as_found.files or name in tabled else replace(axis, gantry=None)
            for name, axis in axes.items()
            if name in named
        ]
        return decode(control, files, known, written=written, carried_out=True)

    def state(files: tuple[ControlFile, ...], *, written: bool = False) -> ControlState:
        return read(files, written=written).state

    def answered(entries: Sequence[PlannedCross]) -> Between:
        request = BetweenRequest(
            planned=tuple(entries),
            axes=axes,
            tabled=tabled,
            tables=tables,
            base=base,
            read=state,
            found=as_found.files,
        )
        return control.format.between(request)

    whole = planned
    idle = [entry for entry in planned if _unlike(entry, as_found, state(base).cross)]
    planned = [entry for entry in planned if entry not in idle]
    answer = answered(planned) if planned else Between()
    refused = [_of_unclear_switch(entry, active=bool(as_found.active)) for entry in idle]
    partners = _gantry_partners(axes)
    racked = [entry for entry in planned if entry.output in partners]
    if racked and (answer.files is not None or answer.sheets):
        planned = [entry for entry in planned if entry not in racked]
        answer = answered(planned) if planned else Between()
        refused += [_racked(entry, partners) for entry in racked]
    more = combined_answer(refused)
    remarks, steps = (*answer.remarks, *more.remarks), (*answer.steps, *more.steps)
    answer = replace(answer, remarks=remarks, steps=steps)
    sheets = {entry.addresses: replace(entry, typed=True) for entry in answer.typed}
    outcome = CrossOutcome(
        files=tables,
        planned=tuple(replace(sheets.get(one.addresses, one), written=False) for one in whole),
        findings=tuple(Finding("CW-P113", how, sentence) for how, sentence in answer.remarks),
        steps=answer.steps,
        sheets=answer.sheets,
    )
    if answer.files is None:
        return outcome
    held = tuple(planned) if answer.held is None else answer.held
    between = {name for entry in held for name in (entry.input, entry.output)}
    after = read(merged_files(base, answer.files), written=True)
    raise_all(CompwrightError, _wrong(planned, held, read(base), after, answer.quantum))
    files, totals = merged_files(tables, answer.files), _totals(held, after, axes)
    pairs = {(entry.input, entry.output) for entry in held}
    rest = [entry for entry in outcome.planned if (entry.input, entry.output) not in pairs]
    return replace(
        outcome, planned=(*held, *rest), written=True, files=files, after=after, totals=totals
    )


def _unlike(
    entry: PlannedCross, as_found: DecodedState, filed: Sequence[CrossCompensation]
) -> bool:
    """Return whether the table of the axes of ``entry`` that was active during the test, by the
    job's answer, is not the one that the control's files switch on (``filed``).

    So is a numbered table of either axis over the other that contradicts the answer.
    """
    pair = entry.added.input, entry.added.output
    if frozenset(pair) in as_found.contradicted:
        return True
    first, second = (
        [each for each in tables if (each.input, each.output) == pair]
        for tables in (as_found.state.cross, filed)
    )
    where = np.concatenate([entry.added.positions, *(each.positions for each in (*first, *second))])
    return any(
        np.max(np.abs(_sum(first, where, way) - _sum(second, where, way))) > READ_BACK_WITHIN
        for way in Direction
    )


def _of_unclear_switch(entry: PlannedCross, *, active: bool) -> Between:
    """Return the answer that a correction is not written, because the job's answer ``active`` and
    the switches in the control's files differ: the new table replaces the old one or is added to
    it.
    """
    why = say(
        "CW-P113.switches",
        what=error_label(entry),
        output=entry.output,
        input=entry.input,
        active=active,
    )
    return not_corrected([entry], why, SentenceText(why))


def _gantry_partners(axes: Mapping[str, Axis]) -> dict[str, tuple[str, str]]:
    """Return, for each of the job's ``axes`` in a gantry, the name of the gantry's master, and the
    other axis: the master's name for a slave, the slave's address for a master.
    """
    masters = {axis.gantry: name for name, axis in axes.items() if axis.gantry is not None}
    led = {name: masters[a.address] for name, a in axes.items() if a.address in masters}
    partners = {name: (master, master) for name, master in led.items()}
    return partners | {name: (name, slave) for slave, name in masters.items()}


def _racked(entry: PlannedCross, partners: Mapping[str, tuple[str, str]]) -> Between:
    """Return the answer that the correction of a gantry axis is not written, because a table on one
    of its two axes alone racks the machine. ``partners``: see `_gantry_partners`.

    A squareness can be corrected by moving the other axis, a straightness cannot.
    """
    master, partner = partners[entry.output]
    plane = "".join(sorted((entry.input, master)))
    instead = f"apply: {{squareness: {{{plane}: {entry.input}}}}}"
    if entry.source == "cross":
        instead = f"cross: [{{input: {master}, output: {entry.input}, ...}}]"
    added = entry.added
    line = np.interp(added.positions, added.positions[[0, -1]], added.positive[[0, -1]])
    why = say(
        "between.racked",
        output=entry.output,
        partner=partner,
        input=entry.input,
        squareness=bool(np.max(np.abs(added.positive - line)) <= READ_BACK_WITHIN),
        instead="" if entry.input in partners else instead,
    )
    return cannot_hold([entry], SentenceText(why))


def _wrong(
    planned: Sequence[PlannedCross],
    held: Sequence[PlannedCross],
    before: DecodedState,
    after: DecodedState,
    quantum: float,
) -> list[Fault]:
    """Return a fault for each axis pair whose written correction (``after``) is not the sum of its
    old (``before``) and its new correction. Rounding by half a ``quantum`` is allowed.

    The new correction is that of ``held`` everywhere and, independently of the family that returned
    ``held``, that of ``planned`` at its positions.
    """
    old, new = (
        {(entry.input, entry.output): [entry] for entry in judged_cross(decoded)}
        for decoded in (before, after)
    )
    added, wanted = (_by_pair(entries) for entries in (held, planned))
    faults = []
    for pair in dict.fromkeys((*old, *new, *added)):
        first, found = old.get(pair, []), new.get(pair, [])
        checks = [(added.get(pair, []), [*first, *added.get(pair, []), *found])]
        checks += [(wanted.get(pair, []), wanted.get(pair, []))] if pair in added else []
        for (entries, places), direction in product(checks, Direction):
            where = np.unique(np.concatenate([np.zeros(0), *(one.positions for one in places)]))
            apart = _sum(found, where, direction) - _sum([*first, *entries], where, direction)
            worst = float(np.max(np.abs(apart), initial=0.0 if places else np.inf))
            if worst > READ_BACK_WITHIN + 0.5 * quantum:
                faults.append(
                    Fault(
                        message=(
                            f"an internal error of compwright: the written table of {pair[1]} "
                            f"over {pair[0]} differs from the planned table"
                        ),
                        place=f"direction {direction.value}",
                        found=f"a difference of {worst:.3g}",
                        hint=f"load nothing of this run, and {SEND_JOB}",
                    )
                )
    return faults


def _by_pair(entries: Sequence[PlannedCross]) -> dict[tuple[str, str], list[CrossCompensation]]:
    """Return the corrections of ``entries`` by the addresses of input and output axis."""
    found: dict[tuple[str, str], list[CrossCompensation]] = {}
    for entry in entries:
        found.setdefault((entry.added.input, entry.added.output), []).append(entry.added)
    return found


def _sum(
    entries: Sequence[CrossCompensation], where: FloatArray, direction: Direction
) -> FloatArray:
    return sum((entry.at(where, direction) for entry in entries), np.zeros(where.size))


def _totals(
    planned: Sequence[PlannedCross], after: DecodedState, axes: Mapping[str, Axis]
) -> tuple[CrossCompensation, ...]:
    names = {axis.address: name for name, axis in axes.items()}
    mine = {(entry.added.input, entry.added.output) for entry in planned}
    return tuple(
        replace(
            entry,
            input=names.get(entry.input, entry.input),
            output=names.get(entry.output, entry.output),
        )
        for entry in judged_cross(after)
        if (entry.input, entry.output) in mine
    )
