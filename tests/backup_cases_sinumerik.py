"""The ground of every job on a real SINUMERIK archive: an axis, its measuring system, its old
table, and the mark of the job.

``plain``        nothing else acts on the axis: a table must be written;
``answerable``   something acts or is open that can be honoured: written and right,
or refused by name;
``must_refuse``  the files and the job leave open, or contradict, what decides: refused by name.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

import sinumerik_archive as archive
from sinumerik_archive import eec_lines, number, put, replace_eec
from sinumerik_container import Packing

PLAIN, ANSWERABLE, MUST_REFUSE = "plain", "answerable", "must_refuse"
NAMES = {"AX1": "X1", "AX2": "Y1", "AX3": "Z1", "AX4": "C1", "AX5": "A1"}
ROTARY = {"AX4", "AX5", "AX6", "AX7", "AX20"}
TRAVELS = {
    "AX1": (0.0, 935.0),
    "AX2": (-850.0, 0.0),
    "AX3": (-650.0, 0.0),
    "AX4": (0.0, 360.0),
    "AX5": (-120.0, 120.0),
}
UM, ARCSEC = 1e-3, 1 / 3600


@dataclass
class Case:
    """One job, the control that it stands before, and the mark."""

    seed: int
    axis: str = "AX1"
    letter: str = "X"
    system: int = 1
    travel: tuple[float, float] = (0.0, 935.0)
    modulo: bool = False
    md: str = ""
    eec: str = ""
    cec: str | None = ""
    files: dict[str, str] | None = None  # given to the job in place of md, eec and cec
    truth: list[str] | None = None  # what the control holds, where the job does not get all of it
    address: str = ""
    job_system: int | None = None
    gantry: str | None = None
    kind: str = ""
    reference: float = 0.0
    home: int = 1
    options: dict[str, str] = field(default_factory=dict)
    table: dict[str, str] = field(default_factory=dict)
    active: str | None = None
    enabled: bool | None = (
        None  # MD32700 of the axis during the test, where the files do not say it
    )
    none: bool = False
    mark: str = PLAIN
    demand: str = "$^"  # what a refusal must name
    code: int | None = None
    cec_sign: float = 1.0
    stated_wrong: bool = False
    dynamic_on: bool = False
    positions: dict[str, float] = field(default_factory=dict)
    told: list[str] = field(default_factory=list)
    nonzero: bool = False
    grid: tuple[float, float, int] = (0.0, 50.0, 20)
    written_tables: set[str] = field(default_factory=set)  # CEC indices that may be written
    format: str = "siemens-840d-sl"
    packing: Packing | None = None  # the archive in its container in place of its texts
    over: dict[str, str] = field(default_factory=dict)  # small files that were loaded over it
    own_beside_product: bool = False  # see VirtualSinumerik
    point_beyond: bool = False

    @property
    def rotary(self) -> bool:
        return self.axis in ROTARY

    @property
    def unit(self) -> float:
        return ARCSEC if self.rotary else UM

    def given(self) -> dict[str, str]:
        if self.files is not None:
            return self.files
        files = {"MD.INI": self.md, "AX_EEC.INI": self.eec}
        if self.cec is not None:
            files["NC_CEC.INI"] = self.cec
        if self.packing is not None:
            files = {"backup.arc": self.packing.packed(files).decode("latin-1")}
        return files | self.over

    def holds(self) -> list[str]:
        if self.truth is not None:
            return self.truth
        if self.packing is None:
            return list(self.given().values())
        return [self.md, self.eec, *([] if self.cec is None else [self.cec]), *self.over.values()]

    def may_refuse(self, demand: str, code: int | None = None) -> None:
        """Answerable from here on; a refusal must name one of what acts."""
        self.demand = demand if self.mark == PLAIN else f"{self.demand}|{demand}"
        self.code = code if self.mark == PLAIN else None
        self.mark = ANSWERABLE

    def must_refuse(self, demand: str, code: int | None = None) -> None:
        if self.mark == ANSWERABLE:  # something else is open too: either may be named
            demand, code = f"{self.demand}|{demand}", code if code == self.code else None
        self.mark, self.demand, self.code = MUST_REFUSE, demand, code


# -- the ground
# --------------------------------------------------------------------------------------------------


def start(
    seed: int,
    rng: np.random.Generator,
    axis: str | None = None,
    kind: tuple[str, str] | None = None,
) -> Case:
    axis = axis or str(
        rng.choice(["AX1", "AX2", "AX3", "AX4", "AX5"], p=[0.3, 0.2, 0.25, 0.15, 0.1])
    )
    systems, state = kind or (
        str(rng.choice(["second", "first"], p=[0.6, 0.4])),
        str(rng.choice(["zero", "on", "off"], p=[0.3, 0.55, 0.15])),
    )
    case = Case(
        seed, axis, NAMES[axis][0], travel=TRAVELS[axis], modulo=axis == "AX4", address=axis
    )
    case.told += [axis, systems, state]
    case.md, case.eec, case.cec = archive.machine_data(), archive.eec_text(), archive.cec_text()
    case.kind = "rotary" if case.rotary else "linear"
    # The tables 2 (X over Y) and 7 (A over C) of the archive hold values and act on AX2 and AX4:
    # elsewhere they are others'.
    for t, output in (("2", "AX2"), ("7", "AX4")):
        if output == axis:
            case.md = put(case.md, f"$SN_CEC_TABLE_ENABLE[{t}]", "0")
    case.system = 1 if systems == "second" else 0
    reserved = int(rng.choice([25, 25, 40, 61, 12, 121]))
    for e in (0, 1):
        case.md = put(
            case.md,
            f"$MA_MM_ENC_COMP_MAX_POINTS[{e},{axis}]",
            str(reserved if e == case.system else 0),
        )
        on = e == case.system and state != "off"
        case.md = put(case.md, f"$MA_ENC_COMP_ENABLE[{e},{axis}]", str(int(on)))
    if systems == "first":
        case.md = put(case.md, f"$MA_NUM_ENCS[{axis}]", "1")
    elif state == "off" or rng.random() < 0.3:
        case.job_system = 2
    case.grid = grid_of(case, rng, reserved)
    low, step, count = case.grid
    case.nonzero = state != "zero"
    values = smooth(case, rng) if case.nonzero else np.zeros(count)
    case.eec = replace_eec(
        case.eec,
        axis,
        eec_lines(
            axis, case.system, low, step, list(values), modulo=case.modulo, spare=reserved - count
        ),
    )
    if rng.random() < 0.35:
        case.md = put(
            case.md, f"$MA_BACKLASH[{case.system},{axis}]", number(rng.uniform(-2, 9) * case.unit)
        )
    if rng.random() < 0.2 and not case.rotary:
        case.home = -1
    if state == "off":
        off_in_the_machine_data(case, rng)
    return case


def grid_of(case: Case, rng: np.random.Generator, reserved: int) -> tuple[float, float, int]:
    """First point, step and number of points of the table that is in the control."""
    low, high = case.travel
    count = min(reserved, int(rng.integers(8, 32)))
    step = (high - low) / (count - 1)
    if (
        not case.modulo and rng.random() < 0.6
    ):  # round numbers, and often a table that is longer or shorter than the travel
        step = float(rng.choice([15, 30]) if case.rotary else rng.choice([25, 40, 50, 65]))
        count = min(reserved, int((high - low) / step) + int(rng.integers(0, 2)) + 1)
    elif case.modulo:
        count = next(n for n in (37, 25, 19, 13, 10, 9) if n <= reserved)
        step = 360.0 / (count - 1)
    else:
        step = round(step, 4)
    return low, step, count


def smooth(case: Case, rng: np.random.Generator, scale: float = 1.0) -> np.ndarray:
    """A curve of 5 to 15 µm (arcsec) on the grid, 0 at the reference."""
    low, step, count = case.grid
    x = low + step * np.arange(count)
    u = (x - case.travel[0]) / (case.travel[1] - case.travel[0])
    cycles = float(rng.integers(1, 3)) if case.modulo else float(rng.uniform(0.4, 1.6))
    phase = float(rng.uniform(0, 6))
    slope = 0.0 if case.modulo else float(rng.uniform(-12, 12))
    amplitude = float(rng.uniform(4, 9))

    def curve(v: np.ndarray) -> np.ndarray:
        return amplitude * np.sin(2 * np.pi * cycles * v + phase) + slope * v

    zero = (case.reference - case.travel[0]) / (case.travel[1] - case.travel[0])
    values: np.ndarray = np.round(scale * case.unit * (curve(u) - curve(np.array([zero]))), 6)
    if case.modulo:
        values[-1] = values[0]
    return values


def off_in_the_machine_data(case: Case, rng: np.random.Generator) -> None:
    """MD32700 = 0 over a table with values: the files switch it off. The job says whether that is
    how the test was taken.
    """
    answer = rng.random()
    if answer < 0.4:
        case.active, case.enabled = str(rng.choice(["no", "false"])), False
    elif answer < 0.7:
        case.active, case.enabled = "yes", True
        case.may_refuse("active|MD32700|ENC_COMP_ENABLE")
    else:
        case.enabled = False
        case.may_refuse("active", 2)


def style(case: Case, rng: np.random.Generator) -> None:
    """The same statements in other forms seen: CR LF, block numbers, blanks, comments, TRUE and
    FALSE, M30, checksums.
    """
    form = int(rng.integers(0, 9))
    case.told.append(f"form {form}")

    def each(change: Callable[[str], str]) -> None:
        case.md, case.eec = change(case.md), change(case.eec)
        case.cec = change(case.cec) if case.cec is not None else None

    if form == 1:
        each(lambda text: text.replace("\n", "\r\n"))
    elif form == 2:
        case.md = re.sub(
            r"(ENABLE\[[^\]]*AX\d+\])=([01])$",
            lambda m: f"{m[1]}={'TRUE' if m[2] == '1' else 'FALSE'}",
            case.md,
            flags=re.MULTILINE,
        )
    elif form == 3:
        case.eec = re.sub(r"^(\$[^=\n]*)=(\S+)$", r"\1 = \2   ; Wert", case.eec, flags=re.MULTILINE)
    elif form == 4:
        case.md = re.sub(r"^N\d+ ", "", case.md, flags=re.MULTILINE)
    elif form == 5:
        case.eec = case.eec.replace("M17\n", "M30\n")
    elif form == 6:
        case.eec = "%_N_AX_EEC_INI\n" + re.sub(
            r"=(\d+\.\d+)$", r"=+\1", case.eec, flags=re.MULTILINE
        )
    elif form == 7:
        case.cec = None
    elif form == 8:  # a line checksum (MD11230)
        case.md = re.sub(
            r"^(N\d+ \$.*)$",
            lambda m: f"{m[1]} '{sum(m[1].encode()) & 0xFFFF:04X}",
            case.md,
            flags=re.MULTILINE,
        )
