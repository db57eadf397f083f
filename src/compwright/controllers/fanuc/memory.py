"""The parameters and pitch error data of a FANUC after all files are loaded, each value once.

Meaning of 3620 to 3627: 16i technical report A-77810E (bidirectional pitch error compensation) and
0i-PB parameter manual B-63980EN/01 p. 100. Ranges of 1851 and 1852 (-9999..9999): 0i-C parameter
manual B-64120EN/01 p. 116. Known from practice only: the ranges of point numbers, and that 3624 is
an integer on the older series.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from typing import TypeVar

from compwright.controllers.fanuc.machine import Machine, MachineEntry
from compwright.controllers.fanuc.series import ControlSeries
from compwright.controllers.fanuc.text import POINT_BASE, ParameterSetting, PointRecord, TapeContent
from compwright.foundations.units import MILLIMETRES_PER_INCH
from compwright.records.correction import Assumption

Value = TypeVar("Value")

#: Bits that are read: parameter -> bits, 0 the rightmost.
_BITS = {1001: (0,), 1004: (0, 1), 1006: (0, 1, 3), 1013: (0, 1), 1800: (4,), 3605: (0, 2)}
#: Parameters of the machine: refused in another form only where the axis' compensation depends on
#: them (`axis_checks`).
_OF_MACHINE = frozenset({1001, 1004, 1006, 1013, 1800})
#: Parameters that count only with an axis number.
_BY_AXIS = frozenset({1006, 1013, 1851, 1852, 3605, *range(3620, 3628)})
#: An increment is a signed byte (fwlib32.h, cnc_rdpitchr), whatever the series.
BYTE = (-128, 127)

_WHOLE = re.compile(r"-?[0-9]{1,12}")
_EIGHT_BITS = re.compile("[01]{8}")


class Memory:
    """The parameters and pitch error data in all files, with faults and notes.

    If the files give a value twice, both must be the same.
    """

    def __init__(
        self, contents: Sequence[TapeContent], series: ControlSeries, machine: Machine
    ) -> None:
        self.series = series
        self.machine = machine
        self.faults = [fault for content in contents for fault in content.faults]
        self.notes = [note for content in contents for note in content.notes]
        self.assumed: list[Assumption] = []
        self._settings: dict[tuple[int, int | None, int | None], list[ParameterSetting]] = (
            defaultdict(list)
        )
        for content in contents:
            for setting in content.settings:
                self._keep(setting)
        self.points: dict[int, PointRecord] = {}
        #: Increments by point number, for the records in ``points``.
        self.increments: dict[int, int] = {}
        self._keep_points([record for content in contents for record in content.points])

    def axes(self) -> tuple[int, ...]:
        """Return the controlled axes with a 36xx parameter or 1851 in the files, ascending."""
        return tuple(
            sorted(
                {
                    axis
                    for number, axis, _ in self._settings
                    if axis is not None and (number >= 3605 or number == 1851)
                }
            )
        )

    def given(self, number: int, axis: int) -> bool:
        """Return whether the files contain the parameter ``number`` for an axis."""
        return bool(self._settings.get((number, axis, None)))

    def setting(self, number: int, axis: int) -> ParameterSetting:
        """Return a parameter of an axis that the files contain, with its file and line."""
        return self._settings[number, axis, None][0]

    def moves(self, axis: int) -> bool:
        """Return whether an axis has an active table or a backlash value.

        Without a table and backlash, the detection unit of the axis has no effect.
        """
        low, high = self.whole(3621, axis), self.whole(3622, axis)
        return bool((self.whole(3623, axis) and low != high) or self.whole(1851, axis))

    def whole(self, number: int, axis: int) -> int | None:
        """Return a parameter as a whole number; None if it is missing or (with a fault) invalid."""
        lowest, highest = self._range(number)

        def convert(setting: ParameterSetting) -> int | None:
            if setting.keyword in ("M", "I") or not _WHOLE.fullmatch(setting.text):
                self.faults.append(
                    setting.fault(
                        f"the value of {setting.label} is wrong",
                        expected="a whole number P.. without a point",
                    )
                )
                return None
            value = int(setting.text)
            if not lowest <= value <= highest:
                self.faults.append(
                    setting.fault(
                        f"the value of {setting.label} is wrong", expected=f"{lowest} to {highest}"
                    )
                )
                return None
            return value

        return self._one((number, axis, None), convert)

    def whole_if_sound(self, number: int, axis: int) -> int | None:
        """Return an axis' parameter as a whole number; None, without a fault, if invalid."""
        before = len(self.faults)
        value = self.whole(number, axis)
        del self.faults[before:]
        return value

    def bit(self, number: int, bit: int, axis: int | None) -> bool | None:
        """Return a bit of a parameter; None if it is not in the files.

        ``number``: the parameter. ``bit``: number of the bit, 0 is the rightmost. ``axis``:
        controlled axis number; None for a parameter that belongs to no axis.
        """
        return self._one((number, axis, bit), lambda setting: setting.text == "1")

    def length(self, number: int, axis: int, *, rotary: bool) -> float | None:
        """Return parameter 3624 (interval) or 3625 (travel per turn), mm or deg; None if it is
        missing or, with a fault, invalid.
        """
        return self._one((number, axis, None), lambda setting: self._length(setting, rotary=rotary))

    def entry_length(self, entry: MachineEntry, axis: int, *, rotary: bool) -> float | None:
        """Return a parameter as a length in mm or deg; None, with a fault, if it is invalid."""
        setting = ParameterSetting(
            entry.number, axis, None, entry.letter, entry.text, entry.file, entry.line
        )
        return self._length(setting, rotary=rotary)

    def increment_size(self, axis: int) -> float | None:
        """Return the least input increment of an axis, mm or deg. If the files do not state the
        increment system, IS-B with 0.001 is assumed.

        Returns None, with a fault, if the parameter of the increment system has an unknown form.
        """
        size, system = self.machine.least_increment(axis), self.machine.system(axis)
        if system is None:
            self.assumed.append(
                Assumption(
                    f"increment system of {axis}", "IS-B", "neither 1013 nor 1004 is in the files"
                )
            )
            return 0.001
        if size is None:
            self.faults.append(
                system.fault(
                    f"increment system of axis {axis}, in which its lengths count",
                    "eight binary digits, one system",
                )
            )
        return size

    def _length(self, setting: ParameterSetting, *, rotary: bool) -> float | None:
        if setting.keyword in ("mm", "deg") and (setting.keyword == "deg") != rotary:
            self.faults.append(
                setting.fault(
                    f"the unit of {setting.label} is wrong",
                    expected="deg" if rotary else "mm",
                    found=setting.keyword,
                )
            )
            return None
        counts = setting.axis is not None and bool(self.machine.bit(1001, 0, setting.axis))
        inch = not rotary and (setting.keyword == "I" or (setting.keyword == "P" and counts))
        value = float(setting.text)
        if value < 0.0:
            self.faults.append(
                setting.fault(f"the value of {setting.label} is wrong", expected="0 or more")
            )
            return None
        if "." not in setting.text and setting.keyword not in ("mm", "deg"):
            if not self.series.whole_lengths and value != 0.0:
                self.faults.append(
                    setting.fault(
                        f"{setting.label} has no decimal point, so its unit is open",
                        expected="a real number such as 50.0",
                    )
                )
                return None
            # the least input increment of an inch machine is a tenth of the same number of inches
            # (IS-B: 0.0001 inch)
            size = self.increment_size(setting.axis or 0)
            if size is None:
                return None
            value *= size * (0.1 if inch else 1.0)
        return value * (MILLIMETRES_PER_INCH if inch else 1.0)

    def _range(self, number: int) -> tuple[int, int]:
        if number in (1851, 1852):
            return -9999, 9999
        if number == 3623:
            return 0, 100
        return (-32768, 32767) if number == 3627 else (0, self.series.highest_point)

    def _one(
        self,
        key: tuple[int, int | None, int | None],
        convert: Callable[[ParameterSetting], Value | None],
    ) -> Value | None:
        """Return the first valid value that is stored under ``key`` (parameter number, axis, bit),
        None if there is none; add a fault for each later value that differs from it.
        """
        first: Value | None = None
        settings = self._settings.get(key, [])
        for setting in settings:
            value = convert(setting)
            if first is not None and value is not None and value != first:
                other = settings[0]
                self.faults.append(
                    setting.fault(
                        f"{setting.label} contradicts {other.file}, line {other.line}",
                        expected=other.text,
                    )
                )
            first = value if first is None else first
        return first

    def _keep(self, setting: ParameterSetting) -> None:
        """Store a parameter value by its number, axis and bit."""
        number = setting.number
        if number in _BY_AXIS and setting.axis is None:
            self.faults.append(
                setting.fault(f"parameter {number} names no axis", expected=f"N{number:05d}Q1A1P..")
            )
            return
        if number not in _BITS:
            if setting.bit is None:
                self._settings[number, setting.axis, None].append(setting)
            else:
                self.faults.append(
                    setting.fault(f"{setting.label} is not a bit", expected="a whole value")
                )
            return
        if setting.bit is not None and setting.text in ("0", "1"):
            self._settings[number, setting.axis, setting.bit].append(setting)
        elif setting.bit is None and setting.keyword == "P" and _EIGHT_BITS.fullmatch(setting.text):
            for bit in _BITS[number]:
                single = ParameterSetting(
                    number,
                    setting.axis,
                    bit,
                    "P",
                    setting.text[7 - bit],
                    setting.file,
                    setting.line,
                )
                self._settings[number, setting.axis, bit].append(single)
        elif number not in _OF_MACHINE:
            self.faults.append(
                setting.fault(
                    f"the value of {setting.label} is wrong",
                    expected="eight binary digits, or 0 or 1 for one bit",
                )
            )

    def _keep_points(self, records: list[PointRecord]) -> None:
        """Store the pitch error data of all files.

        A record without Q in a file with parameters may be a parameter. Such records are stored
        only if there are no other records and they cover the whole point range of an axis.
        """
        certain = [record for record in records if record.mark != "with_parameters"]
        held = {record.number for record in records}
        for record in certain or (
            records if any(held.issuperset(numbers) for numbers in self._ranges()) else []
        ):
            self._keep_point(record)

    def _ranges(self) -> list[range]:
        """Return the range of point numbers (3621 to 3622) of each axis, if both can be read."""
        texts = {
            axis: [
                self._settings[number, axis, None][0].text
                for number in (3621, 3622)
                if self._settings.get((number, axis, None))
            ]
            for _, axis, _ in list(self._settings)
        }
        ends = [
            tuple(map(int, text))
            for text in texts.values()
            if len(text) == 2 and all(map(_WHOLE.fullmatch, text))
        ]
        return [range(low, high + 1) for low, high in ends if low < high]

    def _keep_point(self, record: PointRecord) -> None:
        name = f"pitch data of point {record.number} (N{POINT_BASE + record.number})"
        if record.number > self.series.highest_point:
            self.faults.append(
                record.fault(
                    f"the control has no {name}",
                    expected=f"points 0 to {self.series.highest_point}",
                    found=str(record.number),
                )
            )
        elif not _WHOLE.fullmatch(record.text):
            self.faults.append(record.fault(name, expected="a whole number without a point"))
        elif not BYTE[0] <= int(record.text) <= BYTE[1]:
            self.faults.append(
                record.fault(
                    f"the increment of {name} is out of range", expected=f"{BYTE[0]} to {BYTE[1]}"
                )
            )
        elif self.increments.get(record.number, int(record.text)) != int(record.text):
            other = self.points[record.number]
            self.faults.append(
                record.fault(
                    f"{name} contradicts {other.file}, line {other.line}", expected=other.text
                )
            )
        else:
            self.points.setdefault(record.number, record)
            self.increments[record.number] = int(record.text)


def number_list(numbers: Iterable[int]) -> str:
    """Return numbers as text with ranges: ``10037, 10040 to 10044``. Long lists end in dots."""
    runs: list[list[int]] = []
    for number in sorted(numbers):
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    shown = [f"{low}" if low == high else f"{low} to {high}" for low, high in runs[:8]]
    return ", ".join(shown) + (" ..." if len(runs) > 8 else "")
