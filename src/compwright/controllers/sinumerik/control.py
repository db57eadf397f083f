"""SINUMERIK 840D sl virtual control: leadscrew compensation, cross-axis tables (CEC), backlash.

In the files, the leadscrew table (EEC) is the variable ``$AA_ENC_COMP``, and backlash is MD32450.
The rules also apply to 828D, 840D power line and SINUMERIK ONE.

The rules are taken from the manuals, independently of the definition that writes the files. Further
rules are in the modules ``sag`` (CEC tables), ``loading`` (order of loading) and ``lengths``
(inches):

- The value of the leadscrew table is added to the actual value, so a positive value moves the axis
  towards minus. The shift of the axis is minus the value (Function Manual Extended Functions
  03/2013, p. 238; 808D Function Manual 01/2017, p. 106).
- Values are linear between points (p. 237). Outside, the end values apply: that of point 0 below
  MIN, the last one above MAX (p. 240). A modulo table repeats with the period MAX - MIN (p. 242);
  its two end values must be equal (p. 249).
- The table is active only if MD32700 is 1 (p. 237). If it is assigned several times, the last value
  applies.
- MD32450 positive: the encoder leads the machine part, which is normal backlash (808D ADVANCED
  parameter manual p. 241). It adds nothing in the direction of referencing. On reversal the whole
  value is added in the direction of motion: shift = sgn(d) * MD32450 * MD32452.
- The leadscrew table, backlash and the CEC tables by the axis' own position add up.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.controllers.request import Request, by_address, unknown_axis
from compwright.controllers.sinumerik.axes import MachineAxisNames, axis_names
from compwright.controllers.sinumerik.cec import load_sag
from compwright.controllers.sinumerik.lengths import encoders_of, lengths_of
from compwright.controllers.sinumerik.loading import load
from compwright.controllers.sinumerik.programs import check_programs, without_programs
from compwright.controllers.sinumerik.sag import Pair, Sag, union
from compwright.controllers.sinumerik.tables import (
    CompensationTable,
    Remarks,
    build_table,
    is_default,
    last_value,
    too_few_points,
)
from compwright.controllers.sinumerik.text import READ, SWITCHES, VariableAssignment
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile

_PREFIX = "AA_ENC_COMP"
#: No position, value or factor of a machine is larger; what is would overflow in a product.
_LARGEST = 1e9
#: Sag tables of an 828D, and points of each, whatever machine data say (Function Manual 03/2013,
#: p. 264).
ROOM_828D = (8, 200)


@dataclass(frozen=True, slots=True)
class _SinumerikAxis:
    """The leadscrew table and backlash of one axis of the virtual SINUMERIK.

    ``table``: table of the active measuring system, with the values in the file (errors).
    ``enabled``: it is active. ``screw_on``: the files switch on the leadscrew table of a measuring
    system, and it has values other than 0.
    """

    table: CompensationTable | None = None
    enabled: bool = False
    backlash: float = 0.0
    reference_return: Direction = Direction.POSITIVE
    screw_on: bool = False

    def shift(self, positions: FloatArray) -> FloatArray:
        """Return the correction (mm or deg) of the axis by its leadscrew table at ``positions``
        (any shape).
        """
        if self.table is None or not self.enabled:
            return np.zeros(positions.shape)
        return np.asarray(0.0 - self.table.value(positions), dtype=np.float64)


@dataclass(frozen=True, slots=True)
class SinumerikControl:
    """A SINUMERIK 840D sl with loaded files and all axes referenced; interface
    ``controllers.virtual_control.VirtualControl``.
    """

    axes: dict[str, _SinumerikAxis]
    sag: Sag
    names: MachineAxisNames
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the machine axes that the files correct by their own positions.

        An axis that is only the input or the output of a table between two axes is not included:
        see `cross`.
        """
        return tuple(self.axes)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of all table points of an axis, active or not, mm or deg."""
        name, axis = self._axis(address)
        return union(
            [
                self.sag.points((name, name)),
                *([] if axis.table is None else [axis.table.positions()]),
            ]
        )

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.

        Corrections by the position of another axis are not included (`cross_correction`). Raises
        UsageError for an axis that is not in the files. Raises UsageError also if the effect of the
        CEC tables by the axis' own position is unknown.
        """
        name, axis = self._axis(address)
        x = np.asarray(positions, dtype=np.float64)
        total = axis.shift(x) + self.sag.own_shift(name, x, direction)
        if direction is not axis.reference_return:
            total = total + direction.sign * axis.backlash
        return total

    def cross(self) -> tuple[Pair, ...]:
        """Return (input axis, output axis) of the tables between two axes, ascending by the index
        of the table.

        Tables whose effect cannot be evaluated are left out and listed in ``notes``. If the option
        ``cec_sign`` is not given, all tables are left out.
        """
        if not self.sag.sign:
            return ()
        return tuple(pair for pair in self.sag.pairs() if pair[0] != pair[1])

    def cross_correction(
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,
    ) -> FloatArray:
        """Return the correction of ``output`` (mm or deg) with ``input`` at ``positions`` (any
        shape), moving in ``direction``.

        Raises UsageError for a pair without a table, or if the sign of the CEC values is unknown.
        """
        wanted = (self.names.name(input).casefold(), self.names.name(output).casefold())
        crossing = [pair for pair in self.sag.pairs() if pair[0] != pair[1]]
        pair = next(
            (pair for pair in crossing if (pair[0].casefold(), pair[1].casefold()) == wanted), None
        )
        if pair is None:
            raise UsageError(
                Fault(
                    message=f"the files contain no table that corrects axis {output} over the "
                    f"position of axis {input}",
                    expected=" or ".join(f"{corrected} over {base}" for base, corrected in crossing)
                    or "cross tables in the files",
                    hint=("correct the entry `cross` of the job, or give the file with this table"),
                )
            )
        return self.sag.shift(pair, np.asarray(positions, dtype=np.float64), direction)

    def _axis(self, address: str) -> tuple[str, _SinumerikAxis]:
        """Return the axis that has this name in the files."""
        name = by_address({name: name for name in self.axes}, self.names.name(address))
        if name is None:
            raise unknown_axis(address, self.addresses())
        return name, self.axes[name]


def sinumerik_control(
    files: Sequence[ControlFile], request: Request, *, room: tuple[int, int] | None = None
) -> SinumerikControl:
    """Return the control with ``files`` loaded: first archives, then all other files, whose values
    replace those of the archives. ``room``: the numbers of CEC tables and of their points, if these
    are fixed.

    Archives are loaded first in their container. Table files, machine data and archives in text
    form are loaded over them, in any order. The active measuring system is ``request.encoder``. If
    it is not given, it is the only one with a table, listed in ``assumed``. All names of a machine
    axis (MD10000, MD20080) mean one axis.

    Option ``cec_sign``: ``correction`` if a positive CEC value moves the output axis towards +,
    ``error`` if towards -. If the job does not state it, the effect of CEC tables is unknown.
    Option ``units``: ``inch``, used if no file states the basic system.

    Raises InputError for data that the control would not accept and for contradictions, each fault
    with file and line. Raises UsageError for a measuring system other than 1 or 2 and for a wrong
    ``cec_sign``. Raises UsageError also for a program whose assignments may not all have been
    executed (``request.carried_out``).
    """
    loaded = load(files)
    if request.active is False and not loaded.faults:
        loaded = replace(loaded, over=without_programs(loaded.over))
    contents, faults = loaded.contents, loaded.faults
    names = axis_names(contents, request)
    assignments = loaded.assignments(names)
    faults += loaded.unanswered(names)
    if not assignments and not faults and request.active is not False:
        faults.append(
            Fault(
                message="the files contain no compensation data",
                file=", ".join(file.name for file in files),
                expected="$AA_ENC_COMP, $AN_CEC or $MA_BACKLASH",
                hint="give the files with the compensation data of this control",
            )
        )
    faults += [fault for entry in assignments if (fault := _out_of_range(entry)) is not None]
    lengths, strange = lengths_of(contents, names, request)
    faults += strange if assignments else []
    raise_all(InputError, faults)
    check_programs(contents, names, request, inch=lengths.inch)
    assignments = [lengths.in_mm(entry) for entry in assignments]
    remarks = Remarks(notes=[note for content in contents for note in content.notes])
    by_axis: dict[str, list[VariableAssignment]] = defaultdict(list)
    for entry in assignments:
        if "system" in READ[entry.name]:
            by_axis[entry.axis.upper()].append(entry)
    loader = _AxisLoader(request, remarks, encoders_of(contents, names))
    axes = {entries[0].axis: loader.axis(entries) for entries in by_axis.values()}
    keys = {table: key for content in contents for table, key in content.unknown_keys.items()}
    screws = frozenset(name.upper() for name, axis in axes.items() if axis.screw_on)
    sag = load_sag(
        assignments,
        request,
        {name.upper(): name for name in axes},
        remarks,
        keys,
        names,
        lengths,
        screws,
        room,
    )
    raise_all(InputError, remarks.faults)
    alone = (corrected for base, corrected in sag.pairs() if base == corrected)
    for name in (*alone, *sag.uncounted):
        axes.setdefault(name, _SinumerikAxis())
    return SinumerikControl(
        axes=axes, sag=sag, names=names, assumed=tuple(remarks.assumed), notes=tuple(remarks.notes)
    )


def _out_of_range(entry: VariableAssignment) -> Fault | None:
    """Return the fault of a value that no SINUMERIK accepts; None for a valid value."""
    value, expected = entry.value, ""
    if not math.isfinite(value):
        return entry.fault(f"value of ${entry.name} is not a finite number", found=str(value))
    if abs(value) > _LARGEST:
        expected = f"at most {_LARGEST:g}"
    elif entry.name in SWITCHES:
        expected = "" if value in {0.0, 1.0} else "0 or 1"
    elif entry.name == "AN_CEC_DIRECTION":
        expected = "" if value in {-1.0, 0.0, 1.0} else "0, 1 or -1"
    elif entry.name == "AN_CEC_MULT_BY_TABLE":
        expected = (
            ""
            if value >= 0.0 and value.is_integer()
            else "0 or the number of a table, its index + 1"
        )
    elif entry.name == "MA_CEC_MAX_SUM":
        expected = "" if value >= 0.0 else "0 or more"
    elif entry.name == "MA_BACKLASH_FACTOR":
        expected = "" if 0.01 <= value <= 100.0 else "0.01 to 100"
    if expected:
        return entry.fault(f"value of ${entry.name}", expected=expected, found=f"{value:g}")
    if (
        "system" in READ[entry.name]
        and entry.name != "MA_BACKLASH_FACTOR"
        and entry.number not in {0, 1}
    ):
        return entry.fault(
            "the index of the measuring system is wrong", expected="0 or 1", found=str(entry.number)
        )
    return None


class _AxisLoader:
    """Builds the leadscrew tables and backlash of axes from their assignments."""

    def __init__(self, request: Request, remarks: Remarks, encoders: Mapping[str, int]) -> None:
        self.request = request
        self.remarks = remarks
        self.encoders = encoders

    def axis(self, entries: list[VariableAssignment]) -> _SinumerikAxis:
        """Return one axis from its assignments in the order of the files."""
        name = entries[0].axis
        by_system = {
            system: [entry for entry in entries if entry.number == system] for system in (0, 1)
        }
        tables = {system: self._table(name, system, given) for system, given in by_system.items()}
        system = self._system(name, by_system, tables)
        for other, table in tables.items():
            if table is not None and other != system:
                self.remarks.notes.append(
                    f"{name}: the table of measuring system {other + 1} does not act; system"
                    f" {system + 1} is the active one"
                )
        table = tables[system]
        enabled = last_value(by_system[system], "MA_ENC_COMP_ENABLE")
        if table is not None and enabled is None:
            self.remarks.assumed.append(
                Assumption(
                    f"MD32700 $MA_ENC_COMP_ENABLE of {name}",
                    "1",
                    "not in the files: counted as active",
                )
            )
        active = self.request.is_active([enabled])
        if table is not None and not active:
            ends = (
                "ends as 0"
                if enabled == 0.0
                else "is not in the files and the table did not act, as the job says"
            )
            self.remarks.notes.append(
                f"{name}: MD32700 $MA_ENC_COMP_ENABLE[{system}] {ends}: the table does not act"
            )
        backlash = last_value(by_system[system], "MA_BACKLASH") or 0.0
        returning, assumption = self.request.returning(name)
        if assumption is not None:
            self.remarks.assumed.append(assumption)
        return _SinumerikAxis(
            table=table,
            enabled=active,
            backlash=backlash * self._factor(name, entries),
            reference_return=returning,
            screw_on=any(
                last_value(given, "MA_ENC_COMP_ENABLE") == 1.0
                and any(e.name == _PREFIX and e.value for e in given)
                for given in by_system.values()
            ),
        )

    def _table(
        self, name: str, system: int, given: Sequence[VariableAssignment]
    ) -> CompensationTable | None:
        """Return the leadscrew table of the measuring system with the index ``system``, from the
        assignments ``given``; None without a table, or with faults.
        """
        data = [entry for entry in given if entry.name.startswith(_PREFIX)]
        label = f"table of {name}, measuring system {system + 1}"
        if not data:
            return None
        if is_default(data, _PREFIX):
            self.remarks.notes.append(f"{label}: all zero, the control's own default for no table")
            return None
        stranger = not self.request.is_under_work(name)
        table = build_table(data, _PREFIX, label, name, self.remarks, stranger=stranger)
        if table is not None and not stranger:
            reserved = [entry for entry in given if entry.name == "MA_MM_ENC_COMP_MAX_POINTS"]
            self.remarks.faults += too_few_points(reserved, table, f"MD38000 of {name}")
        return table

    def _factor(self, name: str, entries: list[VariableAssignment]) -> float:
        """Return the backlash factor (MD32452) of the first parameter set; 1 if the files do not
        state a factor.
        """
        if any(e.name == "MA_BACKLASH_DYN" and e.value != 0.0 for e in entries):
            self.remarks.assumed.append(
                Assumption(
                    f"dynamic backlash MD32456 of {name}", "off", "switched on by the PLC only"
                )
            )
        factors = {e.number: e.value for e in entries if e.name == "MA_BACKLASH_FACTOR"}
        if len(set(factors.values())) > 1:
            self.remarks.assumed.append(
                Assumption(f"parameter set of {name} (MD32452)", "0", "default")
            )
        return factors.get(0, 1.0)

    def _system(
        self,
        name: str,
        by_system: dict[int, list[VariableAssignment]],
        tables: dict[int, CompensationTable | None],
    ) -> int:
        """Return the index (0 or 1) of the measuring system in use: by the job, else, as an
        assumption, the only one with a table or a backlash value, else 0.
        """
        given = by_address(self.request.encoder, name)
        if given is not None:
            if given not in {1, 2}:
                raise UsageError(
                    Fault(
                        message=f"the measuring system of axis {name} has a wrong number",
                        expected="1 or 2",
                        found=repr(given),
                        hint="give `--option encoder_system=1` or `--option encoder_system=2`",
                    )
                )
            return given - 1
        holding = [system for system, table in tables.items() if table is not None]
        switched_on = [
            system
            for system in holding
            if last_value(by_system[system], "MA_ENC_COMP_ENABLE") != 0.0
        ]
        play = [system for system in tables if last_value(by_system[system], "MA_BACKLASH")]
        single = [0] if self.encoders.get(name.upper()) == 1 else []
        rules = (
            (single, "MD30200: the axis has one measuring system"),
            (holding, "the only one with a table"),
            (switched_on, "the only one whose table is switched on"),
            (play if not holding else [], "the only one with a backlash value"),
        )
        system, why = next(
            ((found[0], why) for found, why in rules if len(found) == 1), (0, "default")
        )
        self.remarks.assumed.append(
            Assumption(f"active measuring system of {name}", str(system + 1), why)
        )
        return system
