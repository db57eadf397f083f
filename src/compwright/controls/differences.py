"""Compare two sets of a control's files: the corrections of the axes, and each value under the name
that the control uses for it.

If one axis cannot be read, the other axes are compared all the same.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from compwright.controls.control import Control, decode
from compwright.controls.reader_comparison import EVERYWHERE, probe_positions
from compwright.formats.text.container import is_container
from compwright.formats.text.file_values import FileValue, FileValueChange, FileValues, changes
from compwright.foundations.errors import CompwrightError, Fault, InputError, UsageError
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile, ControlState


@dataclass(frozen=True, slots=True)
class AxisReadings:
    """The compensation (``state``) of those axes that could be read; ``state`` is None if no axis
    could be read.

    ``refused``: for each other axis, by address, the error because of which it could not be read.
    """

    state: ControlState | None
    refused: Mapping[str, InputError | UsageError]


def read_axis_by_axis(
    control: Control,
    files: Sequence[ControlFile],
    read: Callable[[str], ControlState],
    among: Collection[str] | None = None,
    caught: type[InputError] | tuple[type[InputError], type[UsageError]] = InputError,
) -> AxisReadings:
    """Return the compensation in ``files`` after reading each axis separately (with ``among`` only
    these axes); axes for which ``read`` raises an error of the type ``caught`` are listed with it.

    ``read``: the function that reads one axis by its address. An axis is skipped if the axes read
    before it show that nothing is active on it.
    """
    refused: dict[str, InputError | UsageError] = {}
    state: ControlState | None = None
    listing = control.format.listing
    for address in listing.readable_alone(control.format, files):
        idle = state is not None and listing.is_idle(state, address)
        if idle or (among is not None and address not in among):
            continue
        try:
            one = read(address)
        except caught as error:
            refused[address] = error
        else:
            state = one if state is None else _together(state, one)
    return AxisReadings(state, refused)


def _together(one: ControlState, other: ControlState) -> ControlState:
    """Return the axes from two readings of the same files together, as one state."""
    axes, facts = {**one.axes, **other.axes}, {**one.facts, **other.facts}
    return replace(one, axes=axes, facts=facts)


#: Two corrections are the same below this many mm or deg: far below every quantum of a control.
SAME = 1e-6
#: Faults of files that a finding names.
_MOST_FAULTS = 2


@dataclass(frozen=True, slots=True)
class ComparedSide:
    """One of two compared sets of files: all its values, and its state if it can be read.

    ``state``: None if no axis can be read; ``findings`` state the reason. ``unread``: the axes that
    could not be read although others could.
    """

    files: tuple[ControlFile, ...]
    entries: FileValues
    state: ControlState | None
    findings: tuple[Finding, ...] = ()
    unread: frozenset[str] = frozenset()

    def knows(self, address: str) -> bool:
        """Return whether the correction of an axis could be read."""
        return self.state is not None and address not in self.unread


@dataclass(frozen=True, slots=True)
class Placed:
    """One value that differs, with the addresses of its axes and its position in the table."""

    change: FileValueChange
    axes: tuple[str, ...]
    at: float | None

    @property
    def entry(self) -> FileValue:
        """The new value, or the old one if the new files do not contain it."""
        return self.change.entry


@dataclass(frozen=True, slots=True)
class CorrectionChange:
    """The largest change of an axis' correction: position, direction, old and new value, mm or deg.

    ``at``: position of the axis that moves. ``direction``: direction in which it approaches this
    position. ``was``: old correction. ``now``: new correction.
    """

    kind: AxisKind
    was: float
    now: float
    at: float
    direction: Direction

    @property
    def most(self) -> float:
        """The change with its sign: new minus old."""
        return self.now - self.was


@dataclass(frozen=True, slots=True)
class Differences:
    """The differences between two sets of files: single values, then corrections by axis address.

    - ``entries``: the differing values; values that compensate are first.
    - ``cross``: changed corrections between axes, by moving and corrected axis.
    - ``complete``: all axes of both sets could be read, so the list of differences is complete.
    - ``uncompared``: axes with differing values whose correction could not be compared.
    """

    entries: tuple[Placed, ...]
    corrections: Mapping[str, CorrectionChange] = field(default_factory=dict)
    cross: Mapping[tuple[str, str], CorrectionChange] = field(default_factory=dict)
    complete: bool = False
    uncompared: frozenset[str] = frozenset()
    findings: tuple[Finding, ...] = ()


def compared_side(
    control: Control,
    files: Sequence[ControlFile],
    name: str,
    naming: Sequence[ControlFile] = (),
) -> ComparedSide:
    """Return one set of files for a comparison, read as far as possible. ``name``: the set's name
    in findings; ``naming``: the other set of files, which may contain the names of the axes.

    Raises InputError if the files contain no value of the control, or cannot be opened.
    """
    entries = control.format.listing.file_values(control.definition, files, naming)
    if not entries:
        raise InputError(*_nothing(control, files))
    files, idle = _with_data(control, files, entries)
    left = (Finding.of("CW-S082", "info", files=name, idle=idle),) if idle else ()
    try:
        state, findings = _viewed(control, files, name)
    except (InputError, UsageError) as error:
        return _in_part(control, ComparedSide(files, entries, None, left), name, error)
    return ComparedSide(files, entries, state, (*left, *findings))


def _in_part(
    control: Control, unread: ComparedSide, name: str, error: InputError | UsageError
) -> ComparedSide:
    """Return a compared set of files, which as a whole cannot be read, with the state of those axes
    that can be read separately.
    """
    named = {entry.axis for entry in unread.entries.values() if entry.relevant}
    seen: list[Finding] = []

    def view(address: str) -> ControlState:
        state, findings = _viewed(control, unread.files, name, address)
        seen.extend(findings)
        return state

    found = read_axis_by_axis(control, unread.files, view, named, (InputError, UsageError))
    if found.state is None:
        return replace(unread, findings=(*unread.findings, _unread_finding(name, None, error)))
    unread_axes = [_unread_finding(name, each, why) for each, why in found.refused.items()]
    findings = tuple(dict.fromkeys((*unread.findings, *seen, *unread_axes)))
    return replace(unread, state=found.state, findings=findings, unread=frozenset(found.refused))


def _unread_finding(name: str, axis: str | None, error: InputError | UsageError) -> Finding:
    faults = [str(fault) for fault in error.faults[:_MOST_FAULTS]]
    more = len(error.faults[_MOST_FAULTS:])
    return Finding.of("CW-S080", "warning", files=name, axis=axis, faults=faults, more=more)


def _with_data(
    control: Control, files: Sequence[ControlFile], entries: FileValues
) -> tuple[tuple[ControlFile, ...], str]:
    """Return the files that contain compensation, and the names (one text) of the files that
    contain no value of the control.

    ``entries``: all values of the files. A file whose values all occur again in a later file is not
    named among them.
    """
    relevant = {entry.file for entry in entries.values() if entry.relevant}
    used = {entry.file for entry in entries.values()}
    kept: list[ControlFile] = []
    idle: list[str] = []
    for file in files:
        if file.name in relevant or is_container(file):
            kept.append(file)
            continue
        own = control.format.listing.file_values(control.definition, [file], ())
        if any(one.relevant for one in own.values()):
            kept.append(file)
        elif file.name not in used and not own:
            idle.append(file.name)
    return tuple(kept), ", ".join(idle)


def _viewed(
    control: Control, files: Sequence[ControlFile], name: str, address: str | None = None
) -> tuple[ControlState, tuple[Finding, ...]]:
    """Return the compensation in the files, checked by both file readers; if they disagree or one
    fails, that of one reader with a warning.
    """
    try:
        return decode(control, files, address=address).state, ()
    except CompwrightError as error:
        state = control.format.listing.for_display(control.format).read(files, address=address)
        why = "; ".join(str(fault) for fault in error.faults[:1])
        return state, (Finding.of("CW-S081", "warning", files=name, why=why),)


def _nothing(control: Control, files: Sequence[ControlFile]) -> list[Fault]:
    return [
        Fault(
            message=f"the files contain no data of {control.id}",
            file=", ".join(file.name for file in files),
            expected="files as the control exports them",
            hint=("give the files as the control exports them, or correct `--format`"),
        )
    ]


def differences(control: Control, old: ComparedSide, new: ComparedSide) -> Differences:
    """Return the differences between two sets of files."""
    placed = [_placed(control, change, old, new) for change in changes(old.entries, new.entries)]
    placed.sort(key=lambda one: not one.entry.relevant)
    corrections: dict[str, CorrectionChange] = {}
    cross: dict[tuple[str, str], CorrectionChange] = {}
    if old.state is not None and new.state is not None:
        corrections = _corrections(old, new, old.state, new.state)
        cross = _cross(old.state, new.state)
    findings = (*old.findings, *new.findings)
    named = {address for one in placed for address in one.axes}
    uncompared = frozenset(one for one in named if not (old.knows(one) and new.knows(one)))
    complete = not (uncompared or old.unread or new.unread or None in (old.state, new.state))
    return Differences(tuple(placed), corrections, cross, complete, uncompared, findings)


def _placed(
    control: Control, change: FileValueChange, old: ComparedSide, new: ComparedSide
) -> Placed:
    axes: tuple[str, ...] = ()
    at = None
    for one in (old, new):
        named, position = control.format.listing.value_location(
            control.definition, change.entry, one.entries, one.state
        )
        axes = tuple(dict.fromkeys((*axes, *named)))
        at = position if position is not None else at
    return Placed(change, axes, at)


def _corrections(
    before: ComparedSide, after: ComparedSide, old: ControlState, new: ControlState
) -> dict[str, CorrectionChange]:
    """Return, for each axis that is in both sets of files and could be read, the largest change of
    its correction. ``before``, ``after``: the two sets of files; ``old``, ``new``: their states.
    """
    stated = [
        {entry.axis for entry in side.entries.values() if entry.relevant} | set(state.axes)
        for side, state in ((before, old), (after, new))
    ]
    found = {}
    for address in dict.fromkeys((*old.axes, *new.axes)):
        was, now = (state.axes.get(address) for state in (old, new))
        known = now or was
        if known is None or not all(address in axes for axes in stated):
            continue
        if not (before.knows(address) and after.knows(address)):
            continue
        sides = [probe_positions(one.positions) for one in (was, now) if one is not None]
        where = np.unique(np.concatenate(sides))
        change = _most(known.kind, where, _curve(was, where), _curve(now, where))
        if change is not None:
            found[address] = change
    return found


def _curve(axis: AxisCompensation | None, where: FloatArray) -> dict[Direction, FloatArray]:
    if axis is None:
        return {side: np.zeros(where.size) for side in Direction}
    return {side: axis.at(where, side) for side in Direction}


def _most(
    kind: AxisKind,
    where: FloatArray,
    was: Mapping[Direction, FloatArray],
    now: Mapping[Direction, FloatArray],
) -> CorrectionChange | None:
    gaps = {side: now[side] - was[side] for side in Direction}
    side = max(Direction, key=lambda one: float(np.max(np.abs(gaps[one]))))
    index = int(np.argmax(np.abs(gaps[side])))
    if abs(gaps[side][index]) <= SAME:
        return None
    values = float(was[side][index]), float(now[side][index])
    return CorrectionChange(kind, *values, float(where[index]), side)


def _cross(old: ControlState, new: ControlState) -> dict[tuple[str, str], CorrectionChange]:
    pairs = dict.fromkeys((entry.input, entry.output) for entry in (*old.cross, *new.cross))
    found = {}
    for pair in pairs:
        tables = [
            [entry for entry in state.cross if (entry.input, entry.output) == pair]
            for state in (old, new)
        ]
        known = [*tables[0], *tables[1]]
        where = np.unique(
            np.concatenate([EVERYWHERE, *(probe_positions(entry.positions) for entry in known)])
        )
        was, now = (
            {
                side: sum((entry.at(where, side) for entry in group), np.zeros(where.size))
                for side in Direction
            }
            for group in tables
        )
        change = _most(known[0].output_kind, where, was, now)
        if change is not None:
            found[pair] = change
    return found
