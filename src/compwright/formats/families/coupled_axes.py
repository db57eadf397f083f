"""Find axes that move together by the control's own files, and compare them with the job.

A table on only one of two coupled axes racks the machine. The job must therefore name the
synchronised axis (``gantry``). If a program or the PLC switches the coupling, the job may state
instead that the axis moves alone.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal

import numpy as np

from compwright.formats.text.gathering import Gathered, Key
from compwright.formats.text.notes import Notes
from compwright.foundations.errors import Fault
from compwright.records.axis import Axis, Direction, FloatArray
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.facts import AxisFacts

#: What the job says of an axis that moves alone.
ALONE = "gantry: none"
#: Why a table for both is no answer where a parameter holds no number.
UNREAD = "a parameter that couples it with another axis cannot be read"
_BY_ITSELF = "an axis that moves by itself"
_WHOLE = re.compile(r"[+-]?[0-9]{1,9}(?:\.0*)?")


def whole_number(text: str) -> int | None:
    """Return the whole number in a parameter; None for other text."""
    text = text.strip()
    return int(float(text)) if _WHOLE.fullmatch(text) else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Coupling:
    """The statement of a control's files that one axis (``follows``) moves with another axis.

    ``leads``: addresses of the leading axis: several if the files leave it open, none if they do
    not state it. ``parameter``: the parameter that states the coupling, with its value; ``file``,
    ``place``: where it is. ``switched``: a program or the PLC switches the coupling. ``unlike``:
    why one table for both axes does not help; empty if both move alike. ``drive``: only the drive
    follows and has no position of its own, so that the leading axis needs no other table.
    """

    leads: tuple[str, ...]
    follows: str
    parameter: str
    file: str = ""
    place: str = ""
    switched: bool = False
    unlike: str = ""
    drive: bool = False

    def fault(self, message: str, expected: str, found: str = "") -> Fault:
        """Return a fault that names the file and line of the parameter that couples the axes."""
        more = f", or {ALONE} where it was measured alone" if self.switched else ""
        return Fault(
            message=f"{message} ({self.parameter})",
            file=self.file,
            place=self.place,
            expected=expected + more,
            found=found,
            hint=(
                "correct the axes and `gantry` in the job, or give the file with the "
                "missing parameter with the control's other files"
            ),
        )


def check_couplings(couplings: Sequence[Coupling], axes: Mapping[str, Axis], notes: Notes) -> None:
    """Compare the axis couplings in the files with the gantries of the job's axes, given by
    address.

    If the job does not name a synchronised axis, ``notes`` gets a question to the user. A coupling
    for which one table for both axes does not help is a fault. A synchronised axis may be among
    ``axes`` itself. Then it gets a table of its own.
    """
    led = {axis.gantry for axis in axes.values()}
    for address, axis in axes.items():
        mine = [one for one in couplings if address in (one.follows, *one.leads)]
        for coupling in mine:
            if coupling.drive and address in coupling.leads:
                notes.find(
                    "CW-S037",
                    "info",
                    axis=address,
                    follows=coupling.follows,
                    parameter=coupling.parameter,
                )
            elif axis.moves_alone and coupling.switched:
                notes.find("CW-S035", "warning", axis=address, parameter=coupling.parameter)
            elif coupling.unlike:
                message = f"axis {address}: {coupling.unlike}"
                expected = "a whole number" if coupling.unlike == UNREAD else _BY_ITSELF
                notes.once(coupling.fault(message, expected))
            elif coupling.follows == address and address not in led:
                notes.once(_led(address, coupling))
        _ask_about_followers(address, axis, [one for one in mine if address in one.leads], notes)
        notes.faults.extend(_other_leader(address, axis, couplings))


def followers(couplings: Sequence[Coupling], address: str) -> tuple[str, ...]:
    """Return the axes that move with the axis at ``address``."""
    found = (one.follows for one in couplings if address in one.leads and not one.unlike)
    return tuple(dict.fromkeys(found))


def _leader(couplings: Sequence[Coupling], address: str) -> str | None:
    """Return the address of the axis that the axis at ``address`` follows; None if it follows no
    axis.
    """
    found = (one.leads for one in couplings if one.follows == address and not one.unlike)
    return next((leads[0] for leads in found if leads), None)


def with_couplings(facts: AxisFacts, couplings: Sequence[Coupling], address: str) -> AxisFacts:
    """Return the facts of the axis at ``address``, with the axes that move together with it."""
    return replace(
        facts,
        synchronised=followers(couplings, address),
        leading=_leader(couplings, address),
        couplings=parameters_of(couplings, address),
    )


def parameters_of(couplings: Sequence[Coupling], address: str) -> dict[str, str]:
    """Return the parameters, with their values, that couple the axis at ``address``, and the axis
    that follows it; empty if none follows it alike.
    """
    return {
        one.parameter: one.follows if address in one.leads and not one.unlike else ""
        for one in couplings
        if address in (one.follows, *one.leads)
    }


def _led(address: str, coupling: Coupling) -> Fault:
    if not coupling.leads:
        return coupling.fault(
            f"axis {address} is coupled with another axis, which no file names",
            "the parameter that names this axis among the files",
        )
    leads = " or ".join(coupling.leads)
    return coupling.fault(
        f"axis {address} follows axis {leads}: a table on it alone racks the machine",
        f'the leading axis in the job (address: "{leads}") with gantry: "{address}"',
    )


def _ask_about_followers(
    address: str, axis: Axis, couplings: Sequence[Coupling], notes: Notes
) -> None:
    alike = [one for one in couplings if not (one.unlike or (axis.moves_alone and one.switched))]
    names = followers(alike, address)
    if len(names) > 1:
        message = f"axes {', '.join(names)} follow axis {address}; a job names one synchronised"
        notes.once(alike[0].fault(f"{message} axis", "one axis that follows"))
    elif names and axis.gantry is None:
        fault = alike[0].fault(
            f"axis {names[0]} moves with axis {address}: a table on one of them alone racks the"
            " machine",
            f'gantry: "{names[0]}" for axis {axis.name} in the job; gantry: {{axis: "{names[0]}",'
            f" table: same}} or table: change where axis {names[0]} has values of its own",
            "no gantry in the job",
        )
        notes.ask(fault)
    elif names and axis.gantry != names[0]:
        message = f"axis {names[0]} moves with axis {address}, not axis {axis.gantry}"
        notes.once(alike[0].fault(message, f'gantry: "{names[0]}"', f"gantry: {axis.gantry}"))


def _other_leader(address: str, axis: Axis, couplings: Sequence[Coupling]) -> Iterator[Fault]:
    """Yield a fault if, by the files, the job's gantry slave follows another master axis, or is
    coupled in another way than a gantry.
    """
    for coupling in couplings:
        if axis.gantry != coupling.follows:
            continue
        if coupling.unlike and address not in coupling.leads:
            yield coupling.fault(f"axis {axis.gantry}: {coupling.unlike}", "an axis that follows")
        elif coupling.leads and address not in coupling.leads:
            leads = " or ".join(coupling.leads)
            message = f"axis {axis.gantry} follows axis {leads}, not axis {address}"
            yield coupling.fault(message, f"the job's axis at {leads}", f"gantry: {axis.gantry}")


@dataclass(frozen=True, slots=True)
class CouplingParameter:
    """A parameter that possibly couples axes: its text with the value (``words``), its file and
    line.
    """

    words: str
    file: str
    line: int

    def coupling(
        self,
        leads: tuple[str, ...],
        follows: str,
        *,
        switched: bool = False,
        unlike: str = "",
        drive: bool = False,
    ) -> Coupling:
        """Return the coupling that this parameter states: the axis ``follows`` moves with one of
        the axes ``leads`` (empty: not stated). ``switched``, ``unlike``, ``drive``: see `Coupling`.
        """
        return Coupling(
            leads=leads,
            follows=follows,
            parameter=self.words,
            file=self.file,
            place=f"line {self.line}",
            switched=switched,
            unlike=unlike,
            drive=drive,
        )


@dataclass(frozen=True, slots=True)
class CouplingStatement(CouplingParameter):
    """A parameter that possibly couples axes, with the match of the pattern that found its
    statement in the file; the stored text has no blanks.
    """

    match: re.Match[str]


def statements_in(
    files: Iterable[ControlFile], pattern: re.Pattern[str], remark: re.Pattern[str]
) -> Iterator[CouplingStatement]:
    """Yield every match of ``pattern`` in the files, in their order, except in comments, which the
    pattern ``remark`` describes.
    """
    for file in files:
        text = remark.sub(lambda found: " " * len(found[0]), file.content.decode("latin-1"))
        line, place = 1, 0
        for match in pattern.finditer(text):
            line += text.count("\n", place, match.start())
            place = match.start()
            yield CouplingStatement(" ".join(match[0].split()), file.name, line, match)


#: Two axes of a gantry hold the same table when their corrections nowhere differ by more than this,
#: mm or deg: the last decimal place of a table.
SAME_TABLE = 1e-6


def find_partners(
    gathered: Gathered,
    partners: Mapping[str, str],
    read: Mapping[str, AxisCompensation],
    notes: Notes,
    *,
    of_job: bool,
    single: Collection[str] = (),
) -> None:
    """Report gantries whose two axes have different tables. ``partners``: the slave's address by
    that of its master; ``read``: the compensations by address.

    For a job (``of_job``), also report axes that have equal tables although the job does not couple
    them. ``single``: addresses of axes that, by the files, belong to no gantry.
    """
    compare_partners(partners, read, notes)
    if not of_job:
        return
    for address, compensation in read.items():
        if compensation.positions.size == 0 or address in (*partners, *partners.values()):
            continue
        for other in gathered.addresses():
            if other not in read and _table(gathered, address) & _table(gathered, other):
                note_twin(address, other, notes, single=address in single)


def compare_partners(
    partners: Mapping[str, str], read: Mapping[str, AxisCompensation], notes: Notes
) -> None:
    """Report every gantry whose two axes have different compensations. ``partners``: the slave's
    address by that of its master; ``read``: the compensations by address.
    """
    for leading, partner in partners.items():
        if leading in read and partner in read and not _same(read[leading], read[partner]):
            notes.find("CW-S030", "warning", partner=partner, leading=leading)


def note_twin(address: str, other: str, notes: Notes, *, single: bool = False) -> None:
    """Report that an axis of the job has the same table as another axis, which suggests that they
    form a gantry; only as information if the axis is in no gantry by the files (``single``).
    """
    if single:
        notes.find("CW-S031.single", "info", address, axis=address, other=other)
        return
    notes.find("CW-S031.gantry", "warning", address, axis=address, other=other)


def _same(one: AxisCompensation, other: AxisCompensation) -> bool:
    points: FloatArray = np.union1d(one.positions, other.positions)
    points = points if points.size else np.zeros(1)
    return all(
        float(np.max(np.abs(one.at(points, d) - other.at(points, d)))) <= SAME_TABLE
        for d in Direction
    )


def _table(gathered: Gathered, address: str) -> set[tuple[tuple[int, Decimal], ...]]:
    """Return the different tables of an axis in all measuring systems, each as pairs (point number,
    value). Tables of zeros are left out.
    """
    tables = set()
    keys: list[Key] = [key for key in gathered.rows if key[0] == address]
    for key in keys:
        values = {
            int(tokens["index"].text): Decimal(tokens["value"].text)
            for row in gathered.rows[key]
            if "index" in (tokens := row.occurrence.tokens) and "value" in tokens
        }
        if any(value != 0 for value in values.values()):
            tables.add(tuple(sorted(values.items())))
    return tables
