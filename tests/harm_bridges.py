"""Machines with two columns that move as one, on six controls: files, contents, what each column does.

Each column has an error, a table and a backlash of its own. The tables are written, and read back
after loading, by the small controls of this judge alone.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from harm_fanuc import Backup, Fanuc, Pitch
from harm_following import follow
from harm_measuring import Correction, table_value
from harm_sinumerik import Control, grid_of


@dataclass(frozen=True)
class Column:
    """What is in the control for one column: corrections at nodes from 0, µm, and backlash, µm."""

    corrections: Sequence[int]
    step: float = 100.0
    backlash: int = 3

    @property
    def points(self) -> list[float]:
        return [i * self.step for i in range(len(self.corrections))]


LEAD = Column((0, -6, -13, -16, -22, -29, -34))
#: Partners by what differs from LEAD.
TABLE = Column((0, -3, -5, -14, -16, -18, -25))
BACKLASH = Column(LEAD.corrections, backlash=8)
GRID = Column((0, -3, -7, -10, -12, -14, -16, -17, -21, -25, -28, -31, -34), step=50.0)
EMPTY = Column((0,) * 7)
LATE = Column((0, -6, -13, -16, -22, -29, -35))


class Bridge(ABC):
    """One control with a leading column and its partner."""

    format: str
    options: str
    lead: str
    partner: str
    name: str = "X"
    #: What couples the columns here, as the control calls it.
    couplings: Sequence[str]

    @abstractmethod
    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        """Give the control's own files; an empty coupling couples nothing."""

    @abstractmethod
    def loaded(self, files: Mapping[str, str]) -> None:
        """Let the control hold these files alone."""

    @abstractmethod
    def load(self, files: Mapping[str, str], card: str) -> None:
        """Load what was written as the card says."""

    @abstractmethod
    def correction(self, address: str) -> Correction:
        """Give what the control adds to this column."""


class FanucBridge(Bridge):
    """Axes 1 and 4; the increments of both columns in one pitch file."""

    format, options, lead, partner = "fanuc-30i", "{}", "1", "4"
    couplings = ("8311", "1817", "8180", "8186")

    def __init__(self) -> None:
        self.control = Fanuc()

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        pitches = {
            axis: Pitch(
                first,
                first,
                column.step,
                [
                    0,
                    *(
                        b - a
                        for a, b in zip(column.corrections, column.corrections[1:], strict=False)
                    ),
                ],
                backlash=column.backlash,
            )
            for axis, first, column in ((1, 40, lead), (4, 140, partner))
        }
        extra = {
            "8311": {8311: ["0", "0", "0", "1"]},
            "1817": {
                1817: ["01000000", "00000000", "00000000", "01000000"],
                1023: ["1", "3", "4", "2"],
            },
            "8180": {8180: ["0", "0", "0", "1"]},
            "8186": {8186: ["0", "0", "0", "1"]},
            "others": {8311: ["0", "0", "2", "0"]},
        }.get(coupling, {8311: ["0"] * 4, 1817: ["00000000"] * 4})
        backup = Backup(pitches, extra=extra)
        return {"CNC-PARA.TXT": backup.parameters(), "PITCH.TXT": backup.points()}

    def loaded(self, files: Mapping[str, str]) -> None:
        self.control = Fanuc()
        self.load(files, "")

    def load(self, files: Mapping[str, str], _card: str) -> None:
        for text in files.values():
            self.control.load(text)

    def correction(self, address: str) -> Correction:
        return lambda x, d: self.control.correction(int(address), x, d)


class SinumerikBridge(Bridge):
    """AX1 leads, AX4 follows; the table holds errors."""

    format, options, lead, partner = "siemens-840d-sl", "{}", "AX1", "AX4"
    couplings = ("37100",)

    def __init__(self) -> None:
        self.control = Control()

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        table, data = ["CHANDATA(1)"], ["CHANDATA(1)"]
        kinds = {"37100": ("1", "11", "0"), "others": ("0", "0", "2")}.get(
            coupling, ("0", "0", "0")
        )
        other = Column((0, 2, 4, 1, 0, -1, -2))
        for address, column, kind in zip(
            ("AX1", "AX4", "AX2"), (lead, partner, other), kinds, strict=True
        ):
            table += [
                f"$AA_ENC_COMP[0,{i},{address}]={-value / 1000:.4f}"
                for i, value in enumerate(column.corrections)
            ]
            table += grid_of(address, len(column.corrections), 0.0, column.step)
            data += [
                f"N32450 $MA_BACKLASH[0,{address}]={column.backlash / 1000}",
                f"N32700 $MA_ENC_COMP_ENABLE[0,{address}]=1",
                f"N37100 $MA_GANTRY_AXIS_TYPE[{address}]={kind}",
                f"N38000 $MA_MM_ENC_COMP_MAX_POINTS[0,{address}]=50",
            ]
        if coupling == "others":
            data += ["N37100 $MA_GANTRY_AXIS_TYPE[AX5]=12"]
        return {
            "AX_EEC.INI": "\n".join([*table, "M17"]) + "\n",
            "MD.INI": "\n".join([*data, "M17"]) + "\n",
        }

    def loaded(self, files: Mapping[str, str]) -> None:
        self.control = Control()
        for text in files.values():
            self.control.load(text)
        self.control.reset()

    def load(self, files: Mapping[str, str], card: str) -> None:
        assert not follow(card, files, self.control)
        assert not self.control.alarms

    def correction(self, address: str) -> Correction:
        return lambda x, d: self.control.correction(address, x, d)


_INI = """[EMC]
VERSION = 1.1
[KINS]
KINEMATICS = trivkins coordinates={letters} kinstype=BOTH
JOINTS = 4
[TRAJ]
COORDINATES = {letters}
LINEAR_UNITS = mm
[EMCMOT]
SERVO_PERIOD = 1000000
"""


class LinuxcncBridge(Bridge):
    """Joints 1 and 2 are both Y; corrections in two columns, half the backlash in each."""

    format, options, lead, partner, name = "linuxcnc", "{}", "1", "2", "Y"
    couplings = ("coordinates",)

    def __init__(self) -> None:
        self.rows: dict[str, list[tuple[float, float, float]]] = {}

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        letters = {"coordinates": "XYYZ", "others": "XYZZ"}.get(coupling, "XYZA")
        ini = _INI.format(letters=letters)
        files = {}
        for joint, column in (("0", LEAD), ("1", lead), ("2", partner), ("3", LEAD)):
            half = column.backlash / 2000
            files[f"j{joint}.comp"] = "".join(
                f"{x} {value / 1000 + half:.6f} {value / 1000 - half:.6f}\n"
                for x, value in zip(column.points, column.corrections, strict=True)
            )
            ini += f"[JOINT_{joint}]\nTYPE = LINEAR\nMIN_LIMIT = -1\nMAX_LIMIT = 601\n"
            ini += "MAX_VELOCITY = 500\nMAX_ACCELERATION = 2000\n"
            ini += f"COMP_FILE = j{joint}.comp\nCOMP_FILE_TYPE = 1\n"
        return {"mill.ini": ini, **files}

    def loaded(self, files: Mapping[str, str]) -> None:
        self.rows = {}
        self._sections(files["mill.ini"], files)

    def load(self, files: Mapping[str, str], _card: str) -> None:
        for name, text in files.items():
            if name.endswith(".ini"):
                self._sections(text, files)

    def _sections(self, ini: str, files: Mapping[str, str]) -> None:
        for joint, body in re.findall(r"\[JOINT_(\d)\](.*?)(?=\n\[|\Z)", ini, re.DOTALL):
            keys = dict(re.findall(r"^(\w+)\s*=\s*(\S+)", body, re.MULTILINE))
            if "COMP_FILE" not in keys:
                continue
            rows = []
            for line in files[keys["COMP_FILE"]].splitlines():
                x, forward, reverse = map(float, line.split()[:3])
                if keys.get("COMP_FILE_TYPE", "0") == "0":
                    forward, reverse = x - forward, x - reverse
                rows.append((x, forward, reverse))
            self.rows[joint] = rows

    def correction(self, address: str) -> Correction:
        def correct(x: float, d: int) -> float:
            rows = self.rows.get(address, [(0.0, 0.0, 0.0)])
            return table_value([r[0] for r in rows], [r[1 if d > 0 else 2] for r in rows], x)

        return correct


_COUNTS = 1000


class PmacBridge(Bridge):
    """Motors 1 and 2; entries in 1/16 count, the length is motor zero again."""

    format, options, lead, partner = "pmac", "{counts_per_unit: 1000}", "1", "2"
    couplings = ("definition", "I206")

    def __init__(self) -> None:
        self.tables: dict[str, list[tuple[float, list[float]]]] = {}
        self.play: dict[str, float] = {}

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        rows = []
        for motor, column in (("2", partner), ("1", lead)):
            entries = [*column.corrections[1:], column.corrections[-1] // 2, 0]
            length = round(len(entries) * column.step * _COUNTS)
            rows.append(f"#{motor} DEFINE COMP {len(entries)},{length}")
            rows.append(" ".join(str(16 * value) for value in entries))
            rows += [f"I{motor}86={16 * column.backlash}", f"I{motor}85=32"]
        rows.append("I51=1")
        rows += ["&1", "#1->1000X", "#2->1000X" if coupling == "definition" else "#2->1000Y"]
        rows += ["I205=$8B", "I206=1"] if coupling == "I206" else []
        rows += ["#3->1000Z", "#4->1000Z"] if coupling == "others" else []
        return {"comp.pmc": "\n".join(rows) + "\n"}

    def loaded(self, files: Mapping[str, str]) -> None:
        self.tables, self.play = {}, {}
        self.load(files, "")

    def load(self, files: Mapping[str, str], _card: str) -> None:
        for text in files.values():
            self._script(re.sub(r";.*|//.*", "", text))

    def _script(self, text: str) -> None:
        for motor, value in re.findall(r"^I(\d)86=(-?\d+)", text, re.MULTILINE):
            self.play[motor] = int(value)
        form = r"#(\d)\s*DEFINE\s+(COMP|BLCOMP)\s+(\d+)[,\s]+(?:#\d+D?,)*(\d+)\s+((?:-?\d+[\s,]+)+)"
        for motor, kind, count, length, body in re.findall(form, text):
            entries = [float(v) for v in re.split(r"[\s,]+", body.strip())][: int(count)]
            assert len(entries) == int(count)
            self.tables[motor + kind] = [(int(length) / _COUNTS, entries)]

    def correction(self, address: str) -> Correction:
        def correct(x: float, d: int) -> float:
            value = self._table(address + "COMP", x)
            if d < 0:
                value -= self._table(address + "BLCOMP", x) + self.play.get(address, 0.0)
            return value / 16 / _COUNTS

        return correct

    def _table(self, key: str, x: float) -> float:
        if key not in self.tables:
            return 0.0
        length, entries = self.tables[key][0]
        step = length / len(entries)
        return table_value(
            [i * step for i in range(len(entries) + 1)], [entries[-1], *entries], x % length
        )


class IsgBridge(Bridge):
    """Lists of axes 1 and 2; two columns of errors in 0.1 µm, which hold the reversal."""

    format, options, lead, partner = "isg-kernel", "{}", "1", "2"
    couplings = ("gantry_ax_nr", "log_achs_nr_slave")

    def __init__(self) -> None:
        self.lists: dict[str, dict[str, int]] = {}

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        files = {}
        for address, column in (("1", lead), ("2", partner)):
            rows = [
                f"kopf.achs_nr {address}",
                "kw.ssfk.unit 1",
                f"kw.ssfk.interval {round(column.step * 10000)}",
                "kw.ssfk.kw_startpos 0",
                f"kw.ssfk.kw_nr_max {len(column.corrections)}",
                "kw.ssfk.bilateral 1",
            ]
            for i, value in enumerate(column.corrections):
                rows += [
                    f"kw.ssfk.table[{i}].pos {-10 * value}",
                    f"kw.ssfk.table[{i}].neg {-10 * (value - column.backlash)}",
                ]
            rows += ["lr_param.ssfk 1", "lr_param.anwahl_losekomp 0"]
            if coupling == "gantry_ax_nr" and address == "2":
                rows.append("kenngr.gantry_ax_nr 1")
            files[f"achskw{address}.lis"] = "\n".join(rows) + "\n"
        pair = {"log_achs_nr_slave": (1, 2), "others": (3, 4)}.get(coupling)
        if pair is not None:
            files["channel.lis"] = "".join(
                f"synchro_data.koppel_gruppe[0].paar[0].log_achs_nr_{role} {number}\n"
                for role, number in zip(("master", "slave"), pair, strict=True)
            )
        return files

    def loaded(self, files: Mapping[str, str]) -> None:
        self.lists = {}
        self.load(files, "")

    def load(self, files: Mapping[str, str], _card: str) -> None:
        for text in files.values():
            plain = re.sub(r"#.*|/\*.*?\*/", "", text, flags=re.DOTALL if "/*" in text else 0)
            said = {
                name.replace(" ", ""): int(value)
                for name, value in re.findall(
                    r"^\s*([a-z_0-9.\[\] ]+?)\s+(-?\d+)\s*$", plain, re.MULTILINE
                )
            }
            if "kopf.achs_nr" in said:
                self.lists[str(said["kopf.achs_nr"])] = said

    def correction(self, address: str) -> Correction:
        def correct(x: float, d: int) -> float:
            said = self.lists.get(address, {})
            count, step = said.get("kw.ssfk.kw_nr_max", 0), said.get("kw.ssfk.interval", 0)
            start, side = said.get("kw.ssfk.kw_startpos", 0), "pos" if d > 0 else "neg"
            if not count:
                return 0.0
            at = [
                start + i * step if step else said[f"kw.ssfk.table[{i}].setpoint"]
                for i in range(count)
            ]
            values = [-said[f"kw.ssfk.table[{i}].{side}"] / 10000 for i in range(count)]
            return table_value([one / 10000 for one in at], values, x)

        return correct


class HeidenhainBridge(Bridge):
    """Axes 1 (X) and 2 (Y): a .COM of errors each, MP710 for backlash."""

    format, options, lead, partner = "heidenhain-itnc530", "{}", "X", "Y"
    couplings = ("850",)

    def __init__(self) -> None:
        self.tables: dict[str, tuple[list[float], list[float]]] = {}
        self.play: dict[str, float] = {}

    def files(self, lead: Column, partner: Column, coupling: str) -> dict[str, str]:
        files = {}
        for number, (address, column) in enumerate((("X", lead), ("Y", partner)), start=1):
            rows = "".join(
                f"{i:<5d}" + " " * 10 * (number - 1) + f"{-value / 1000:+.4f}\n"
                for i, value in enumerate(column.corrections)
            )
            files[f"{address}.COM"] = (
                f"BEGIN {address}      .COM MM DATUM:0 DIST:{column.step:g}\n"
                f"NR   1=F()     2=F()\n{rows}END   {address}      .COM\n"
            )
        files["CONFIG.CMA"] = (
            "BEGIN CONFIG .CMA MM\nNR   1         2\n0    X         Y\nEND   CONFIG .CMA\n"
        )
        follows = {"850": ("0", "1", "0", "0"), "others": ("0", "0", "0", "3")}.get(
            coupling, ("0", "0", "0", "0")
        )
        files["MP.TXT"] = "".join(
            [
                "MP730 : %00011\n",
                *(
                    f"MP710.{i} : {column.backlash / 1000:.4f}\nMP720.{i} : 0.0\n"
                    for i, column in enumerate((lead, partner))
                ),
                *(f"MP850.{i} : {number}\n" for i, number in enumerate(follows)),
            ]
        )
        return files

    def loaded(self, files: Mapping[str, str]) -> None:
        self.tables, self.play = {}, {}
        self.load(files, "")

    def load(self, files: Mapping[str, str], _card: str) -> None:
        for name, text in files.items():
            if name.endswith(".COM"):
                head, names, *rows = text.splitlines()
                start, step = (
                    float(re.search(rf"{key}:([-+.\d]+)", head)[1])  # type: ignore[index]
                    for key in ("DATUM", "DIST")
                )
                number = {"X": 1, "Y": 2}[name[0]]
                left = names.index(f"{number}=F(")
                values = [float(row[left : left + 10].strip() or 0) for row in rows[:-1]]
                self.tables[name[0]] = [start + i * step for i in range(len(values))], values
            for index, value in re.findall(r"^MP710\.(\d) *: *([-+.\d]+)", text, re.MULTILINE):
                self.play["XY"[int(index)]] = float(value)

    def correction(self, address: str) -> Correction:
        def correct(x: float, d: int) -> float:
            nodes, values = self.tables.get(address, ([0.0], [0.0]))
            return -table_value(nodes, values, x) - (self.play.get(address, 0.0) if d < 0 else 0.0)

        return correct


BRIDGES: dict[str, Callable[[], Bridge]] = {
    "fanuc": FanucBridge,
    "sinumerik": SinumerikBridge,
    "linuxcnc": LinuxcncBridge,
    "pmac": PmacBridge,
    "isg": IsgBridge,
    "heidenhain": HeidenhainBridge,
}


@dataclass
class Skew:
    """How two columns stand to each other over the travel, both directions."""

    places: Sequence[float] = field(default_factory=lambda: [7 + 15.0 * i for i in range(40)])

    def changes(self, before: Correction, after: Correction) -> list[float]:
        """Give by how much what acts has changed, µm."""
        return [1000 * (after(x, d) - before(x, d)) for x in self.places for d in (1, -1)]
