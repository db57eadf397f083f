"""Compare the contents read back from a control with the contents expected by the plan.

The expected contents are the control's old files in which the files of the plan replace the old
ones.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import numpy as np

from compwright.controls.control import Control
from compwright.controls.decoded_state import SingleReader
from compwright.controls.differences import (
    ComparedSide,
    CorrectionChange,
    Differences,
    Placed,
    differences,
)
from compwright.controls.reader_comparison import SINGLE_PRECISION
from compwright.documents.compare import Difference, Others
from compwright.documents.diff import EntryDifference
from compwright.formats.text.file_values import same_text
from compwright.foundations import storage
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedCross

#: Half of the last decimal place of a typed value, mm or deg. The engineer interpolates and rounds
#: the rows of the table between those of the sheet.
_TYPED_ROUNDING = 0.5e-4 + 1e-9


@dataclass(frozen=True, slots=True)
class ReadBackDifferences:
    """The values read back that are not as expected.

    - ``own``: differences by the name of an axis of the plan.
    - ``others``: differences that belong to no axis of the plan.
    - ``doubts``: findings on cross-axis tables and switches that were not read back, and on new
      couplings of axes.
    """

    own: Mapping[str, tuple[Difference, ...]]
    others: Others
    findings: tuple[Finding, ...] = ()
    doubts: tuple[Finding, ...] = ()


def not_read_back(plan_file: Path, loaded: Sequence[Path]) -> Iterator[Finding]:
    """Yield a warning for each of the paths ``loaded`` that is in the output folder ``tables`` of
    `run`, because such a file was not read from the control.
    """
    own = storage.resolved(plan_file.parent / "tables")
    for path in loaded:
        if own in (there := storage.resolved(path), *there.parents):
            yield Finding.of("CW-S085", "warning", path=path)


@dataclass(frozen=True, slots=True)
class TypedCorrection:
    """A correction between axes that is typed in from a sheet, compared with the values read back.

    ``change``: from the planned to the held value, where they differ most; None if no table was
    read back. ``largest``: the largest planned value, mm or deg.
    """

    entry: PlannedCross
    change: CorrectionChange | None
    largest: float

    @property
    def differs(self) -> bool:
        """Whether the values read back are not those of the sheet, or are unknown."""
        if self.change is None:
            return True
        rounding = 1e-3 / outside_factor(self.change.kind.unit)
        return abs(self.change.most) > rounding + SINGLE_PRECISION * self.largest

    @property
    def not_read_back(self) -> Finding | None:
        """The finding that no table was read back; None if there is one."""
        names = self.entry.output, self.entry.input
        if self.change is not None:
            return None
        return Finding.of("CW-S087.typed", "warning", output=names[0], input=names[1])


def typed_corrections(
    planned: Iterable[PlannedCross], before: ControlState, found: ControlState
) -> Iterator[TypedCorrection]:
    """Yield each of the ``planned`` corrections that is typed in, compared with the state that was
    read back (``found``). ``before``: the state that the sheet changes.
    """
    old, held = SingleReader(before), SingleReader(found)
    for entry in planned:
        if not entry.typed:
            continue
        where, way = _compared_positions(entry, before, found), list(Direction)
        wanted = np.stack(
            [
                old.cross_correction(*entry.addresses, where, d) + entry.added.at(where, d)
                for d in way
            ]
        )
        largest, change = float(np.max(np.abs(wanted))), None
        if entry.addresses in found.pairs:
            now = np.stack([held.cross_correction(*entry.addresses, where, d) for d in way])
            rounded = ~np.isin(where, entry.added.positions) & (
                abs(now - wanted) <= _TYPED_ROUNDING
            )
            now = np.where(rounded, wanted, now)
            side, place = np.unravel_index(int(np.argmax(np.abs(now - wanted))), now.shape)
            change = CorrectionChange(
                entry.added.output_kind,
                float(wanted[side, place]),
                float(now[side, place]),
                float(where[place]),
                way[int(side)],
            )
        yield TypedCorrection(entry, change, largest)


def _compared_positions(
    entry: PlannedCross, before: ControlState, found: ControlState
) -> FloatArray:
    """Return the positions of a typed correction, and the points between them of the tables of the
    same axes in both states. Between these positions all of them are straight.
    """
    sheet = entry.added.positions
    tables = [
        one for one in (*before.cross, *found.cross) if entry.addresses == (one.input, one.output)
    ]
    rows = (np.clip(one.positions, sheet[0], sheet[-1]) for one in tables)
    return np.unique(np.concatenate([sheet, *rows]))


def pairs_not_read_back(
    planned: Iterable[PlannedCross], whole: Differences, found: ComparedSide
) -> dict[tuple[str, str], Finding]:
    """Return, by axis pair, a finding for each written cross-axis table that was not completely
    read back; it names a missing value. ``whole``: the differences between the planned files and
    the files read back (``found``).

    ``planned``: the plan's corrections between axes. A control may name only one of the two axes in
    a value, or none. Such values are considered only if no table of the pair was read back.
    """
    lost = _not_read(whole)
    missing = {}
    for entry in planned:
        pair = set(entry.addresses)
        values = [one for one in lost if pair <= set(one.axes)]
        if found.state is not None and entry.addresses not in found.state.pairs:
            values = values or [one for one in lost if entry.added.output in one.axes]
            values = values or [one for one in lost if not one.axes]
        names = [one.entry.name for one in values]
        if entry.written and names:
            missing[entry.addresses] = Finding.of(
                "CW-S087",
                "warning",
                input=entry.input,
                output=entry.output,
                value=names[0],
                more=len(names) - 1,
            )
    return missing


def newly_coupled(
    planned: Iterable[PlannedCross],
    axes: Mapping[str, Axis],
    expected: ComparedSide,
    found: ComparedSide,
) -> tuple[Finding, ...]:
    """Return a finding for each axis of a written cross-axis table that a parameter couples with
    another axis in the ``found`` files, and not in those of the plan, nor by the job's ``gantry``.

    ``planned``: the plan's corrections between axes. ``axes``: the axes of the job by name.
    ``expected``: the files of the plan.
    """
    coupled = {}
    for entry in planned:
        for address, axis in zip(entry.addresses, (entry.input, entry.output), strict=True):
            was, now = (
                {} if side.state is None else side.state.facts_of(address).couplings
                for side in (expected, found)
            )
            gantry = axes[axis].gantry if axis in axes else None
            new = [one for one, follows in now.items() if one not in was and follows != gantry]
            if not entry.written or not new:
                continue
            parameter = new[0]
            old = [one for one in was if _parameter(one) == _parameter(parameter)]
            coupled[address] = Finding.of(
                "CW-S088.coupled", "warning", axis=axis, parameter=parameter
            )
            if old:
                coupled[address] = Finding.of(
                    "CW-S088.changed", "warning", axis=axis, parameter=parameter, was=old[0]
                )
    return tuple(coupled.values())


def _parameter(words: str) -> str:
    """Return a parameter without its value."""
    return words.rpartition("=" if "=" in words else " ")[0].strip()


def read_back_differences(
    control: Control,
    expected: ComparedSide,
    found: ComparedSide,
    names: Mapping[str, str],
    planned: Sequence[PlannedCross] = (),
    axes: Mapping[str, Axis] = MappingProxyType({}),
) -> ReadBackDifferences:
    """Return the differences between read-back and expected contents. ``names``: names of the job's
    axes by address; ``planned``: the plan's corrections between axes; ``axes``: these axes by name.

    Files that were not read back are ignored. A value that was not expected is reported only if it
    is not 0 and the plan has a file of the same name. The missing part of a table of another axis
    is a difference if the rest was read back. A missing value of a cross-axis table is a difference
    if its file was read back.
    """
    whole = differences(control, expected, found)
    known = {entry.file for entry in expected.entries.values()}
    lost, read = _not_read(whole), {entry.file for entry in found.entries.values()}
    torn = [one for one in _partly_read(control, whole, found) if not names.keys() & set(one.axes)]
    torn += [one for one in lost if one not in torn and _between_axes(one, read)]
    compensating = [one for one in whole.entries if one.entry.relevant and _compared(one, known)]
    compensating += torn
    typed: list[TypedCorrection] = []
    if expected.state is not None and found.state is not None:
        typed = list(typed_corrections(planned, expected.state, found.state))
    pairs = {each.entry.addresses for each in typed if each.change is not None}
    compensating = [one for one in compensating if not _typed_in(one, whole, pairs)]
    ignored = [one for one in lost if one not in torn]
    own: dict[str, list[Difference]] = {}
    others: list[Difference] = []
    for one in compensating:
        mine = dict.fromkeys(names[address] for address in one.axes if address in names)
        for name in mine:
            own.setdefault(name, []).append(_difference(one, name))
        if not mine:
            others.append(_difference(one, one.axes[0] if one.axes else ""))
    others += _corrections(whole, compensating, names, {each.entry.addresses for each in typed})
    for each in typed:
        if each.change is not None and each.differs:
            bent, given = each.entry.output, each.entry.input
            what = f"correction of {bent} over {given}"
            others.append(_largest(bent, what, f"{given} ", each.change))
    return ReadBackDifferences(
        {name: tuple(found) for name, found in own.items()},
        Others(tuple(others), tuple(_elsewhere(whole)), tuple(one.entry.name for one in ignored)),
        tuple(dict.fromkeys((*whole.findings, *_ignored(whole, known, len(ignored))))),
        (
            *pairs_not_read_back(planned, whole, found).values(),
            *newly_coupled(planned, axes, expected, found),
            *assumed_instead(whole, expected, found),
            *(each.not_read_back for each in typed if each.not_read_back is not None),
        ),
    )


def _typed_in(placed: Placed, whole: Differences, pairs: Collection[tuple[str, str]]) -> bool:
    """Return whether a value differs because a correction between axes was typed in, which is
    compared as a whole. ``pairs``: the axes of these corrections.

    It is a value in the table of such a pair, a new one of no axis, or the name of a table that is
    new for the moving axis; and no other correction differs.
    """
    axes = {address for pair in pairs for address in pair}
    if not pairs or whole.cross.keys() - set(pairs) or axes & whole.corrections.keys():
        return False
    tables = {one.entry.file for one in whole.entries if any(set(one.axes) == {*p} for p in pairs)}
    inside = placed.entry.file in tables and set(placed.axes) <= axes
    if inside or placed.change.old is not None:
        return inside
    named = {Path(one.entry.file).stem for one in whole.entries}
    assigned = placed.axes[:1] in [(moving,) for moving, _ in pairs]
    return not placed.axes or (assigned and Path(placed.entry.text).stem in named)


def assumed_instead(
    whole: Differences, expected: ComparedSide, found: ComparedSide
) -> Iterator[Finding]:
    """Yield a warning for each fact, such as a switch, that the plan's files state and the files
    read back leave to an assumption. ``whole``: the differences between both.
    """
    if expected.state is None or found.state is None or not _not_read(whole):
        return
    known = {one.fact for one in expected.state.assumed}
    for one in found.state.assumed:
        if one.fact not in known:
            yield Finding.of(
                "CW-S087.assumed",
                "warning",
                fact=one.fact,
                value=one.value,
                evidence=one.evidence,
            )


def _compared(placed: Placed, known: set[str]) -> bool:
    """Return whether a difference is reported: the value was read back, and the plan's files
    contain it, or it is new in one of these files and not 0. ``known``: names of the plan's files.
    """
    change = placed.change
    if change.new is None:
        return False
    if change.old is not None:
        return True
    return change.new.file in known and not same_text(change.new.text, "0")


def _between_axes(placed: Placed, read: set[str]) -> bool:
    """Return, for a value that was not read back, whether it belongs to several axes (a cross-axis
    table) and its file was read back. ``read``: names of the files that were read back.
    """
    old = placed.change.old
    return len(set(placed.axes)) > 1 and old is not None and old.file in read


def _difference(placed: Placed, axis: str) -> Difference:
    entry, change = placed.entry, placed.change
    was = change.old.text if change.old is not None else None
    return Difference(axis, entry.name, was, change.new.text if change.new else None)


def _corrections(
    whole: Differences,
    compensating: list[Placed],
    names: Mapping[str, str],
    typed: Collection[tuple[str, str]],
) -> Iterator[Difference]:
    """Yield the changed corrections of axes outside the plan and of axis pairs, if one of the
    values ``compensating`` belongs to these axes. ``whole``: all differences; ``names``: names of
    the job's axes by address. ``typed``: pairs that are compared with an entry sheet.
    """
    touched = [set(one.axes) for one in compensating]
    for address, change in whole.corrections.items():
        if address not in names and any(address in axes for axes in touched):
            yield _largest(address, "correction", "", change)
    for (moving, output), change in whole.cross.items():
        if (moving, output) in typed:
            continue
        if any({moving, output} <= axes for axes in touched):
            what = f"correction of {names.get(output, output)} over {names.get(moving, moving)}"
            yield _largest(names.get(output, output), what, f"{moving} ", change)


def _largest(axis: str, what: str, moving: str, change: CorrectionChange) -> Difference:
    unit = change.kind.unit
    factor = outside_factor(unit)
    quantity = (
        f"{what}, largest change: at {moving}{change.at:.10g} arriving in {change.direction.value}"
    )
    return Difference(axis, quantity, change.was * factor, change.now * factor, outside_unit(unit))


def _elsewhere(whole: Differences) -> Iterator[EntryDifference]:
    for one in whole.entries:
        change, entry = one.change, one.entry
        if not entry.relevant and change.old is not None and change.new is not None:
            yield EntryDifference(
                quantity=entry.name,
                group=entry.group,
                addresses=one.axes,
                old=change.old.text,
                new=change.new.text,
                meaning=entry.meaning,
                compensates=False,
                at=one.at,
            )


def _not_read(whole: Differences) -> list[Placed]:
    return [one for one in whole.entries if one.entry.relevant and one.change.new is None]


def _partly_read(control: Control, whole: Differences, found: ComparedSide) -> list[Placed]:
    """Return the values that were not read back although other values of the same table or list
    were read back. ``whole``: all differences; ``found``: the files that were read back.
    """
    missing = _not_read(whole)
    groups = {one.entry.group for one in missing}
    whereabouts = control.format.listing.value_location
    there = {
        (entry.group, axis)
        for entry in found.entries.values()
        if entry.relevant and entry.group in groups
        for axis in whereabouts(control.definition, entry, found.entries, found.state)[0]
    }
    return [one for one in missing if any((one.entry.group, axis) in there for axis in one.axes)]


def _ignored(whole: Differences, known: set[str], missing: int) -> Iterator[Finding]:
    new = sum(
        one.entry.relevant and one.change.old is None and not _compared(one, known)
        for one in whole.entries
    )
    if missing:
        yield Finding.of("CW-S083.not_read", "info", missing=missing)
    if new:
        yield Finding.of("CW-S083.new", "info", new=new)
