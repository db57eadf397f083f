"""Find whether the axes in a control's files are linear or rotary, without a job.

The answer comes from the files, from ``--option kind``, or from the plan of the run that wrote the
files. If none of these states it, the kind is unknown: a correction of 0.001 is then 1 µm or 3.6
arcsec.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from compwright.controls.control import Control, decode, open_control
from compwright.controls.control_files import read_control
from compwright.controls.decoded_state import DecodedState
from compwright.documents.plan import read_plan
from compwright.foundations import storage
from compwright.foundations.errors import CompwrightError, Fault, UsageError
from compwright.foundations.findings import Finding
from compwright.foundations.session import Session
from compwright.records.axis import AxisKind
from compwright.records.correction import Assumption, ControlFile
from compwright.records.options import KIND
from compwright.words.sentences import control_text
from compwright.workflow.inputs.jobs import PLAN

#: A run writes its tables so many folders below its plan (``tables/<format>/``), its entry sheets
#: fewer.
_LEVELS = 3


@dataclass(frozen=True, slots=True)
class Kinds:
    """The addresses of the axes for which linear or rotary is unknown, with the assumptions and the
    findings about the kind of axes.
    """

    unknown: tuple[str, ...] = ()
    assumed: tuple[Assumption, ...] = ()
    findings: tuple[Finding, ...] = ()


def decode_kinds(
    session: Session,
    paths: Sequence[Path],
    format_id: str,
    options: Mapping[str, object],
    address: str | None,
    *,
    active: bool | None = None,
) -> tuple[Control, DecodedState, Kinds]:
    """Return a control, the decoded contents of its files, and the axes for which the files do not
    show whether they are linear or rotary. ``address``: the only axis to decode (None: all);
    ``active``: whether the tables are active, None if not stated.

    Raises UsageError if the numbers themselves depend on an unknown kind, or if a given kind
    contradicts the files.
    """
    control = open_control(session, format_id, options)
    files = read_control(session, control, paths)
    planned = {} if KIND in options else _planned_kinds(session, paths, control.id)
    if planned:
        control = open_control(session, format_id, {**options, KIND: planned})
    found = decode(control, files, address=address, active=active)
    given = control.options[KIND]
    _check(control, found, given)
    unknown = _unknown(found, given)
    if unknown:
        rotary = {**planned, **dict.fromkeys(unknown, AxisKind.ROTARY)}
        other = open_control(session, format_id, {**options, KIND: rotary})
        _same_numbers(found, _readable(other, files, address, active=active))
    assumed = tuple(
        Assumption(
            control_text("axis {name}: kind", name=name),
            str(kind),
            control_text("{plan} above the files", plan=PLAN),
        )
        for name, kind in planned.items()
        if name in found.state.axes and found.state.facts_of(name).kind is None
    )
    return control, found, Kinds(unknown, assumed, tuple(_finding(unknown)))


def _unknown(found: DecodedState, given: object) -> tuple[str, ...]:
    """Return the addresses of the axes for which neither the files nor the user state whether they
    are linear or rotary.
    """
    if isinstance(given, str):
        return ()
    crossed = (end for entry in found.state.cross for end in (entry.input, entry.output))
    return tuple(
        name
        for name in dict.fromkeys((*found.state.axes, *crossed))
        if found.state.facts_of(name).kind is None
        and not (isinstance(given, Mapping) and name in given)
    )


def _planned_kinds(session: Session, paths: Sequence[Path], format_id: str) -> dict[str, AxisKind]:
    """Return the kind (linear, rotary) of each axis address as in the plan whose run wrote these
    files; no kinds if no plan is found.
    """
    kinds: dict[str, AxisKind] = {}
    for folder in dict.fromkeys(
        above for path in paths for above in (path, *path.absolute().parents[:_LEVELS])
    ):
        content = storage.earlier_bytes(session, folder / PLAN)
        if not content:
            continue
        try:
            plan = read_plan(content, str(folder / PLAN))
        except CompwrightError:
            continue  # no plan: another program's file of this name
        if plan.format != format_id:
            continue
        for axis in (*(entry.axis for entry in plan.axes.values()), *plan.untested.values()):
            kinds.update(dict.fromkeys(filter(None, (axis.address, axis.gantry)), axis.kind))
    return kinds


def _check(control: Control, found: DecodedState, given: object) -> None:
    """Raise an error if the user's kind (linear, rotary) contradicts the control's files."""
    kinds = {found.state.facts_of(name).kind for name in found.state.axes}
    if isinstance(given, str) and None not in kinds and AxisKind(given) not in kinds:
        raise UsageError(
            Fault(
                message=f"the option {KIND} contradicts the control's files",
                place=f"{control.origin.before_option}{KIND}",
                expected=" or ".join(sorted(kind for kind in kinds if kind)),
                found=given,
                hint="leave the option out, or give the files of this machine",
            )
        )


def _readable(
    control: Control, files: Sequence[ControlFile], address: str | None, *, active: bool | None
) -> DecodedState | None:
    """Return the decoded contents of the files (of one axis ``address``, or of all axes if it is
    None), or None if the files cannot be read. ``active``: whether the tables are active, None if
    not stated.
    """
    try:
        return decode(control, files, address=address, active=active)
    except CompwrightError:
        return None


def _same_numbers(linear: DecodedState, rotary: DecodedState | None) -> None:
    """Raise an error if an axis's table, decoded as ``linear`` and as ``rotary``, has different
    values, because the kind is unknown.
    """
    if rotary is None:
        return
    faults = []
    for name, table in linear.state.axes.items():
        other = rotary.state.axes.get(name)
        if other is not None and not all(
            one.shape == two.shape and np.allclose(one, two, rtol=1e-9, atol=1e-12)
            for one, two in (
                (table.positions, other.positions),
                (table.positive, other.positive),
                (table.negative, other.negative),
            )
        ):
            faults.append(
                Fault(
                    message=f"axis {name}: the files do not state whether it is linear or rotary",
                    place=f"--option {KIND}",
                    expected="linear or rotary",
                    found="nothing",
                    hint=f"give `--option {KIND}=linear` or `--option {KIND}=rotary`",
                )
            )
    if faults:
        raise UsageError(*faults)


def _finding(unknown: Sequence[str]) -> list[Finding]:
    if not unknown:
        return []
    return [Finding.of("CW-S086", "warning", names=unknown, number=len(unknown))]
