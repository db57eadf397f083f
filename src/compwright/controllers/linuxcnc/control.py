"""LinuxCNC virtual control: screw compensation (``COMP_FILE``) and ``BACKLASH`` of each joint.

The rules are taken from the control's source and from runs of LinuxCNC 2.9.0~pre1, independently of
the definition that writes the files:

- While the joint moves towards +, the second column of the table applies; towards -, the third. The
  correction is added to the command. With COMP_FILE_TYPE 0 (the default) the columns are actual
  positions, and correction = nominal - actual. With any other type the columns are the corrections.
- The correction is looked up at the commanded joint position, linear between rows. Outside, the
  value of the end row applies. No table repeats, not even that of a rotary joint.
- BACKLASH (the full gap) is active only if the table contains no row: +BACKLASH/2 going +,
  -BACKLASH/2 going -.
- Everything is in machine units ([TRAJ] LINEAR_UNITS, ANGULAR_UNITS). The direction of referencing
  has no effect.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from compwright.controllers.linuxcnc.hal import run_time_pins
from compwright.controllers.linuxcnc.ini import (
    MIXING,
    IniFile,
    IniValue,
    bare_name,
    joint_number,
    letters_of_joints,
    read_inis,
)
from compwright.controllers.linuxcnc.table import CompTable, leading_number, load_table
from compwright.controllers.request import Request, by_address, unknown_axis
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile

_LINEAR_UNITS = {
    "mm": 1.0,
    "metric": 1.0,
    "in": MILLIMETRES_PER_INCH,
    "inch": MILLIMETRES_PER_INCH,
    "imperial": MILLIMETRES_PER_INCH,
}
_ANGULAR_UNITS = {
    "deg": 1.0,
    "degree": 1.0,
    "grad": 0.9,
    "gon": 0.9,
    "rad": math.degrees(1.0),
    "radian": math.degrees(1.0),
}


#: TYPE of a joint, a word or its number: whether it counts angles.
_TYPES = {"LINEAR": False, "1": False, "ANGULAR": True, "2": True}


@dataclass(frozen=True, slots=True)
class _Joint:
    """One joint of a virtual LinuxCNC. ``unit``: mm or deg per machine unit."""

    table: CompTable | None
    backlash: float
    unit: float


@dataclass(frozen=True, slots=True)
class LinuxCncControl:
    """LinuxCNC with loaded files and all joints homed; interface
    ``controllers.virtual_control.VirtualControl``.

    The address of an axis is its joint number as text. The correction is NaN if a number in the
    joint's table is not finite.
    """

    joints: dict[str, _Joint]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the joint numbers in the files, ascending."""
        return tuple(self.joints)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of the table rows that the control loads, mm or deg."""
        joint = self._joint(address)
        return np.empty(0) if joint.table is None else joint.table.nominal * joint.unit

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction added to the command at ``positions`` (any shape) approached in
        ``direction``, mm or deg.
        """
        joint = self._joint(address)
        x = np.asarray(positions, dtype=np.float64) / joint.unit
        if joint.table is None or joint.table.nominal.size == 0:
            return np.full(x.shape, direction.sign * joint.backlash / 2.0 * joint.unit)
        return _looked_up(joint.table, x, direction) * joint.unit

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return no axis pairs, because no table corrects one joint by another joint."""
        return ()

    def cross_correction(  # the protocol's names
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,  # noqa: ARG002
        direction: Direction,  # noqa: ARG002
    ) -> FloatArray:
        """Raise UsageError, because no table corrects one joint by the position of another."""
        raise UsageError(
            Fault(
                message=(
                    f"axis {input} cannot correct axis {output}: LinuxCNC has no tables "
                    "between joints"
                ),
                hint="remove this entry from `cross` of the job",
            )
        )

    def _joint(self, address: str) -> _Joint:
        joint = self.joints.get(joint_number(address))
        if joint is None:
            raise unknown_axis(address, self.addresses())
        return joint


def _looked_up(table: CompTable, x: FloatArray, direction: Direction) -> FloatArray:
    """Return the correction at ``x`` (machine units), calculated as the control does.

    As in the servo loop of the control, it is the value of the row below plus slope times distance.
    """
    if not table.defined:
        return np.full(x.shape, np.nan)
    trim, slope = (
        (table.forward, table.forward_slope)
        if direction is Direction.POSITIVE
        else (table.reverse, table.reverse_slope)
    )
    row = np.searchsorted(table.nominal, x, side="right") - 1
    below = row < 0
    row = np.maximum(row, 0)
    distance = np.where(below | (row == table.nominal.size - 1), 0.0, x - table.nominal[row])
    return np.asarray(trim[row] + slope[row] * distance, dtype=np.float64)


def linuxcnc_control(files: Sequence[ControlFile], request: Request) -> LinuxCncControl:
    """Return the control with ``files`` loaded: INI files and the tables that they name.

    If no INI names a table, its file name ``joint_N...`` states the joint, else the option
    ``axis``. Lines that the control would ignore without a message are ignored here too and listed
    in ``notes``.

    Raises InputError if the control would not start (a missing table, a key without a number).
    Raises InputError also if the files do not state which joint loads a table.
    """
    names = [file.name for file in files]
    if len(set(names)) != len(names):
        raise InputError(
            Fault(
                message="two of the control's files have the same name",
                found=", ".join(sorted({n for n in names if names.count(n) > 1})),
                hint="give each file once",
            )
        )
    inis, used = read_inis(files)
    tables = {file.name: file.content for file in files if file.name not in used}
    raise_all(InputError, [fault for ini in inis for fault in ini.faults])
    loader = _JointLoader(inis, tables, request)
    joints = loader.joints()
    loader.faults += run_time_pins(files, loader.works_on_axis, loader.works_on_joint)
    raise_all(InputError, loader.faults)
    return LinuxCncControl(joints=joints, assumed=tuple(loader.assumed), notes=tuple(loader.notes))


class _JointLoader:
    """Builds the joints; collects assumptions, notes, and faults that prevent a start."""

    def __init__(
        self, inis: tuple[IniFile, ...], tables: dict[str, bytes], request: Request
    ) -> None:
        self.inis = inis
        self.tables = tables
        self.request = request
        self.assumed: list[Assumption] = []
        self.notes: list[str] = [remark for ini in inis for remark in ini.repeated()]
        self.faults: list[Fault] = []

    def joints(self) -> dict[str, _Joint]:
        """Return all joints in the files, by number."""
        numbers = {number for ini in self.inis for number in ini.joints()}
        orphans = self._orphans(numbers)
        self._kinematics()
        self._wrapped(numbers | set(orphans))
        found = {number: self._from_ini(number) for number in numbers}
        found |= {number: self._from_orphan(number, name) for number, name in orphans.items()}
        if not found and not self.faults:
            self.faults.append(
                Fault(
                    message="the files contain no joint",
                    file=", ".join([ini.name for ini in self.inis] + list(self.tables)),
                    expected="an INI with a section [JOINT_N], or a table called joint_N.comp",
                    hint="give the INI of the machine",
                )
            )
        return {str(number): joint for number, joint in sorted(found.items()) if joint is not None}

    def works_on_axis(self, letter: str) -> bool:
        """Return whether a joint of this axis is part of the job. True where no INI states the
        joints.
        """
        numbers = [
            number
            for ini in self.inis
            for number, one in enumerate(letters_of_joints(ini))
            if one == letter
        ]
        return not self.inis or any(self.works_on_joint(str(number)) for number in numbers)

    def works_on_joint(self, number: str) -> bool:
        """Return whether the joint ``number`` (a text) is part of the job; True also for a text
        that is not a number.
        """
        wanted = {joint_number(one) for one in self.request.axes_under_work}
        return not wanted or not number.isdigit() or number in wanted

    def _kinematics(self) -> None:
        """Refuse kinematics in which an axis is moved by several joints, because tables correct
        joints.
        """
        for ini in self.inis if self.request.reference else ():
            value = ini.find("KINS", "KINEMATICS")
            if value is not None and value.text.split()[0].lower() in MIXING:
                message = (
                    "[KINS] KINEMATICS: an axis moves several joints here, and a table is"
                    " active on one joint"
                )
                self.faults.append(
                    value.fault(message, expected="trivkins, where each joint is an axis")
                )

    def _wrapped(self, numbers: set[int]) -> None:
        """Refuse a wrapped rotary axis, whose position counts on beyond the turn that the table
        covers.
        """
        for ini in self.inis if self.request.reference else ():
            letters = letters_of_joints(ini)
            for number in sorted(numbers):
                if number >= len(letters) or not self.request.is_under_work(str(number)):
                    continue
                value = ini.find(f"AXIS_{letters[number]}", "WRAPPED_ROTARY")
                if value is not None and leading_number(value.text) not in (None, 0.0):
                    message = (
                        f"[AXIS_{letters[number]}] WRAPPED_ROTARY: the axis counts on past its"
                        f" turn, and a table of joint {number} does not repeat: beyond its last row"
                        " its end value is active"
                    )
                    self.faults.append(
                        value.fault(message, expected="WRAPPED_ROTARY = 0 and an axis with ends")
                    )

    def _orphans(self, numbers: set[int]) -> dict[int, str]:
        """Return tables that no INI file names, by the joint to which they probably belong."""
        named = {
            bare_name(value.text)
            for number in numbers
            if (value := self._value(number, "COMP_FILE")) is not None
        }
        found: dict[int, str] = {}
        for name in self.tables:
            if name in named:
                continue
            number = self._number_of(name)
            if number is not None and number not in numbers and number not in found:
                found[number] = name
            elif numbers or number in found:
                self.notes.append(f"{name}: no INI names this file: the control does not load it")
            else:
                self.faults.append(
                    Fault(
                        message="the files do not show which joint loads this table",
                        file=name,
                        expected="a file name such as joint_0.comp, or the INI that names the "
                        "table",
                        hint="rename the file to `joint_N.comp`, or add the INI",
                    )
                )
        return found

    def _number_of(self, name: str) -> int | None:
        match = re.fullmatch(r"joint[_-]?([0-9]{1,3})(?:\D.*)?", name, re.IGNORECASE)
        if match:
            return int(match.group(1))
        axis = joint_number(str(self.request.options.get("axis", "")))
        return int(axis) if re.fullmatch("[0-9]{1,3}", axis) and len(self.tables) == 1 else None

    def _value(self, number: int, key: str) -> IniValue | None:
        """Return the value of a joint's key in all INI files; two different values are a fault."""
        found = [
            value for ini in self.inis if (value := ini.find(f"JOINT_{number}", key)) is not None
        ]
        differing = [value for value in found[1:] if value.text != found[0].text]
        faults = [
            value.fault(
                f"{key} of joint {number} differs from {found[0].line.file}",
                expected=repr(found[0].text),
            )
            for value in differing
        ]
        self.faults += [fault for fault in faults if fault not in self.faults]
        return found[0] if found else None

    def _number(self, number: int, key: str) -> float | None:
        value = self._value(number, key)
        if value is None:
            return None
        parsed = leading_number(value.text)
        if parsed is None or not math.isfinite(parsed):
            self.faults.append(
                value.fault(
                    f"{key} of joint {number}: the control does not start", expected="a number"
                )
            )
            return None
        return parsed

    def _from_ini(self, number: int) -> _Joint | None:
        backlash = self._number(number, "BACKLASH") or 0.0
        comp_type = self._type(number)
        named = self._value(number, "COMP_FILE")
        table = None
        if named is not None:
            name = bare_name(named.text)
            if name not in self.tables:
                self.faults.append(
                    named.fault(
                        f"table of joint {number} was not given; without it the control does not"
                        " start",
                        expected=name,
                    )
                )
                return None
            if self._value(number, "COMP_FILE_TYPE") is None:
                self.assumed.append(
                    Assumption(f"COMP_FILE_TYPE of joint {number}", "0", "the control's default")
                )
            table = self._load(number, name, comp_type)
        if table is not None and table.nominal.size and backlash != 0.0:
            self.notes.append(
                f"joint {number}: BACKLASH {backlash:g} is ignored, because a table is loaded"
            )
        return _Joint(table=table, backlash=backlash, unit=self._unit(number))

    def _type(self, number: int) -> int:
        """Return COMP_FILE_TYPE as the control reads it (``%i`` of the language C). 0 where it is
        missing.
        """
        value = self._value(number, "COMP_FILE_TYPE")
        if value is None:
            return 0
        match = re.match(r"\s*([+-]?)(0x[0-9a-f]+|0[0-7]*|[1-9][0-9]*)", value.text, re.IGNORECASE)
        if match is None:
            self.faults.append(
                value.fault(
                    f"COMP_FILE_TYPE of joint {number}: the control does not start",
                    expected="0 or 1",
                )
            )
            return 0
        digits = match.group(2)
        base = 16 if digits[:2].lower() == "0x" else 8 if digits[0] == "0" else 10
        parsed = int(digits, base)
        if match.group(1) == "-" or parsed > 1:
            self.notes.append(f"joint {number}: COMP_FILE_TYPE {value.text} is treated as 1")
        return parsed

    def _from_orphan(self, number: int, name: str) -> _Joint:
        option = self.request.options.get("comp_file_type", 0)
        if str(option) not in {"0", "1"}:
            raise UsageError(
                Fault(
                    message="the option comp_file_type has a wrong value",
                    expected="0 or 1",
                    found=repr(option),
                    hint=(
                        "give `--option comp_file_type=0` or `--option "
                        "comp_file_type=1`, as in the INI"
                    ),
                )
            )
        evidence = "option" if "comp_file_type" in self.request.options else "the control's default"
        self.assumed.append(Assumption(f"joint that loads {name}", str(number), "no INI was given"))
        self.assumed.append(Assumption(f"COMP_FILE_TYPE of joint {number}", str(option), evidence))
        table = self._load(number, name, int(str(option)))
        return _Joint(table=table, backlash=0.0, unit=self._unit(number))

    def _load(self, number: int, name: str, comp_type: int) -> CompTable:
        table = load_table(self.tables[name], name, comp_type)
        self.notes += table.notes
        if table.nominal.size == 0:
            self.notes.append(
                f"joint {number}: {name} gives no row: there is no compensation by table, "
                "and BACKLASH"
                " is active instead"
            )
        return table

    def _unit(self, number: int) -> float:
        """Return mm or deg per machine unit of a joint."""
        value = self._value(number, "TYPE")
        kind = by_address(self.request.kinds, str(number))
        if value is not None and value.text.upper() not in _TYPES:
            self.faults.append(
                value.fault(
                    f"TYPE of joint {number}: the control does not start",
                    expected="LINEAR or ANGULAR",
                )
            )
        angular = (
            _TYPES.get(value.text.upper(), False) if value is not None else kind is AxisKind.ROTARY
        )
        if angular:
            return self._named_unit("ANGULAR_UNITS", _ANGULAR_UNITS) or 1.0
        named = self._named_unit("LINEAR_UNITS", _LINEAR_UNITS)
        if named is not None:
            return named
        option = self.request.options.get("units", "mm")
        if option not in {"mm", "inch"}:
            raise UsageError(
                Fault(
                    message="the option units has a wrong value",
                    expected="mm or inch",
                    found=repr(option),
                    hint="give `--option units=mm` or `--option units=inch`, as in the INI",
                )
            )
        evidence = "option" if "units" in self.request.options else "default"
        self.assumed.append(Assumption(f"machine units of joint {number}", str(option), evidence))
        return _LINEAR_UNITS[str(option)]

    def _named_unit(self, key: str, units: dict[str, float]) -> float | None:
        """Return mm or deg per machine unit by a key of the section [TRAJ].

        ``units``: size of each unit by its name, mm or deg. If the value of the key is a number
        instead of a name, it is the machine units per mm or degree. Returns None if no INI contains
        the key.
        """
        found = [value for ini in self.inis if (value := ini.find("TRAJ", key)) is not None]
        sizes: list[float] = []
        for value in found:
            number = leading_number(value.text)
            size = (
                1.0 / number
                if number is not None and 0.0 < number < math.inf
                else units.get(value.text.lower())
            )
            if size is None:
                fault = value.fault(
                    f"[TRAJ] {key}: the control does not start", expected=" or ".join(units)
                )
                self.faults += [] if fault in self.faults else [fault]
            else:
                sizes.append(size)
        if len(set(sizes)) > 1:
            self.faults.append(
                found[1].fault(
                    f"[TRAJ] {key} differs from {found[0].line.file}", expected=repr(found[0].text)
                )
            )
        return sizes[0] if sizes else None
