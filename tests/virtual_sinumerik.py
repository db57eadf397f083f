"""A SINUMERIK that loads texts, keeps its registers and says by how much it shifts an axis.

Written from the manuals' facts alone, apart from the package: it knows nothing of how the package
reads, writes or judges.

    shift of an axis = - EEC (the value is added to the actual value: a positive one moves the axis
    in the negative direction;
                         840D sl function manual K3)
                       + ``cec_sign`` · CEC (which way a positive value moves the axis is not
                       proven: both worlds can be made) + backlash (0 arriving in the direction of
                       referencing, else direction · MD32450 · MD32452) + dynamic lost motion
                       (direction · MD32456 / 2 where the PLC switches it on)
                       - temperature compensation (MD32750, SD43900 .. SD43920)

Values are kept as they were written, with the unit that held; a linear axis of an inch control is
converted where a value is used.
"""

from __future__ import annotations

import copy
import functools
import re
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Register = tuple[str, tuple[str, ...]]
INCH = 25.4

_ASSIGNMENT = re.compile(
    r"\$(?P<name>[A-Z]{1,3}_\w+)\s*(?:\[(?P<index>[^\]]*)\])?\s*=(?!=)\s*(?P<value>\"[^\"]*\"|'[^']*'|\([^)]*\)|[^\s;]+)"
)
_STATEMENT = re.compile(r"\s*(?:N\d+\s+)?(?P<rest>.*)", re.DOTALL)
_CONDITION = re.compile(r"(IF|WHILE|UNTIL|ELSE|REDEF|DEF|WHENEVER|WHEN|IDS?\s*=)\b", re.IGNORECASE)
_END = re.compile(r"(M17|M30|M02|M2|RET)\b", re.IGNORECASE)
_WORDS = {"TRUE": "1", "FALSE": "0"}


@dataclass(frozen=True)
class Value:
    """What stands behind ``=``: text, and whether inches held there."""

    text: str
    inch: bool

    @property
    def number(self) -> float:
        return float(self.text)


@dataclass(frozen=True)
class Refused:
    """A write that the control did not take: compensation was on, or no room was reserved.

    Values written while only SD41300 is on are taken, but stand here too: the makers' programs
    switch both off first.
    """

    register: Register
    old: str | None
    new: str
    why: str

    @property
    def mattered(self) -> bool:
        return self.old is None or not _same(self.old, self.new)


def _same(one: str, other: str) -> bool:
    try:
        return float(one) == float(other)
    except ValueError:
        return one == other


@functools.lru_cache(maxsize=64)
def assignments(text: str) -> tuple[tuple[Register, Value], ...]:
    """Every assignment of a text in its order; index tokens as written, except that blanks are
    gone.
    """
    found: list[tuple[Register, Value]] = []
    inch = False
    for line in text.splitlines():
        code = _without_comment(line)
        match = _STATEMENT.fullmatch(code)
        rest = match["rest"].strip() if match else ""
        if rest.upper() in {"METRIC", "INCH"}:
            inch = rest.upper() == "INCH"
        if _CONDITION.match(rest):
            continue
        for part in _ASSIGNMENT.finditer(rest):
            index = (
                tuple(token.strip().strip("()") for token in part["index"].split(","))
                if part["index"] is not None
                else ()
            )
            raw = part["value"].strip("\"()'").strip()
            found.append(((part["name"], index), Value(_WORDS.get(raw.upper(), raw), inch)))
        if _END.match(rest):
            break
    return tuple(found)


def _without_comment(line: str) -> str:
    if ";" not in line:
        return line
    inside = False
    for place, letter in enumerate(line):
        if letter == '"':
            inside = not inside
        elif letter == ";" and not inside:
            return line[:place]
    return line


@dataclass
class VirtualSinumerik:
    """One control. ``used``: the measuring system (0, 1) that the PLC selects per axis, where the
    machine data leave it open.
    """

    cec_sign: float = 1.0
    names: dict[str, str] = field(default_factory=dict)
    used: dict[str, int] = field(default_factory=dict)
    reference_return: dict[str, int] = field(default_factory=dict)
    dynamic_on: bool = False
    # What no page settles, so that both worlds can be made: whether a table that is multiplied adds
    # its own value too, and whether the point beyond MAX counts where STEP does not divide.
    own_beside_product: bool = False
    point_beyond: bool = False
    positions: dict[str, float] = field(default_factory=dict)
    registers: dict[Register, Value] = field(default_factory=dict)
    refused: list[Refused] = field(default_factory=list)
    # What the checks of this judge turn, one at a time; each is 1 on a true control.
    eec_turned: float = 1.0
    backlash_turned: float = 1.0
    inch_turned: float = 1.0
    system_turned: int = 0

    def copy(self) -> VirtualSinumerik:
        other = copy.copy(self)
        for name in ("names", "used", "reference_return", "positions", "registers"):
            setattr(other, name, dict(getattr(self, name)))
        other.refused = []
        return other

    # -- loading
    # ----------------------------------------------------------------------------------------------

    def load(self, text: str, *, protected: bool = True) -> None:
        """Take a text as the control would. ``protected=False``: the text says how the control is,
        nothing is being loaded.
        """
        lines = {line.strip().upper() for line in text.splitlines()}
        says_unit = bool(lines & {"METRIC", "INCH"})
        for register, value in assignments(text):
            inch = value.inch if says_unit else self._is_inch()
            self.write(register, Value(value.text, inch), protected=protected)

    def write(self, register: Register, value: Value, *, protected: bool = True) -> None:
        name, index = register
        if name == "MN_AXCONF_MACHAX_NAME_TAB" and value.text:
            self.names[value.text] = f"AX{int(index[0]) + 1}"
        own = (name, tuple(self.axis(token) for token in index))
        if name.endswith(("_INPUT_AXIS", "_OUTPUT_AXIS")):
            value = Value(self.axis(value.text), value.inch)
        why = self._forbidden(own) if protected else None
        if why is not None:
            old = self.registers.get(own)
            self.refused.append(Refused(own, old.text if old else None, value.text, why))
        if why is None or why.startswith("SD41300"):
            self.registers[own] = value

    def axis(self, token: str) -> str:
        """The machine axis AXn behind a name: X1 and AX1 are one (MD10000)."""
        return self.names.get(token, token)

    def _forbidden(self, register: Register) -> str | None:
        name, index = register
        if name.startswith("AA_ENC_COMP"):
            if self.flag("MA_ENC_COMP_ENABLE", index[0], index[-1]):
                return f"MD32700[{index[0]},{index[-1]}] = 1"
            reserved = self.registers.get(("MA_MM_ENC_COMP_MAX_POINTS", (index[0], index[-1])))
            if name == "AA_ENC_COMP" and reserved and int(index[1]) >= reserved.number:
                return f"MD38000[{index[0]},{index[-1]}] = {reserved.text}"
        if name == "AN_CEC" or name.startswith("AN_CEC_"):
            output = self.registers.get(("AN_CEC_OUTPUT_AXIS", index[:1]))
            if output is not None and self.flag("MA_CEC_ENABLE", output.text):
                return f"MD32710[{output.text}] = 1"
            reserved = self.registers.get(("MN_MM_CEC_MAX_POINTS", index[:1]))
            if name == "AN_CEC" and reserved and int(index[1]) >= reserved.number:
                return f"MD18342[{index[0]}] = {reserved.text}"
            if self.flag("SN_CEC_TABLE_ENABLE", index[0]):
                return f"SD41300[{index[0]}] = 1"
        return None

    # -- registers
    # ----------------------------------------------------------------------------------------------

    def _is_inch(self) -> bool:
        basic = self.registers.get(("MN_SCALING_SYSTEM_IS_METRIC", ()))
        return basic is not None and basic.number == 0

    def value(self, name: str, *index: str, default: float = 0.0) -> float:
        found = self.registers.get((name, index))
        return default if found is None else found.number

    def flag(self, name: str, *index: str) -> bool:
        return self.value(name, *index) != 0

    def length(self, axis: str, name: str, *index: str) -> float:
        """A register in mm (linear axis) or deg."""
        found = self.registers.get((name, index))
        if found is None:
            return 0.0
        rotary = self.flag("MA_IS_ROT_AX", axis)
        return found.number * (INCH * self.inch_turned if found.inch and not rotary else 1.0)

    def system(self, axis: str) -> str:
        """The measuring system that is in use: MD30200, what is switched on (MD32700), and else the
        word of the PLC.
        """
        if self.value("MA_NUM_ENCS", axis, default=2) < 2:
            return str(self.system_turned)
        on = [e for e in ("0", "1") if self.flag("MA_ENC_COMP_ENABLE", e, axis)]
        chosen = self.used.get(axis, int(on[0]) if len(on) == 1 else 0)
        return str((chosen + self.system_turned) % 2)

    # -- what acts
    # ----------------------------------------------------------------------------------------------

    def correction(self, axis: str, x: Floats, direction: int) -> Floats:
        """By how much the axis stands off its command at ``x``, arriving in ``direction``: mm or
        deg, everything together.
        """
        x = np.asarray(x, dtype=float)
        e = self.system(axis)
        shift = np.zeros_like(x)
        if self.flag("MA_ENC_COMP_ENABLE", e, axis):
            shift -= self.eec_turned * self._eec(e, axis, x)
        shift += self.cec_sign * self._cec(axis, x, direction)
        if direction != self.reference_return.get(axis, 1):
            factor = self.value("MA_BACKLASH_FACTOR", "0", axis, default=1.0)
            shift += (
                direction
                * self.backlash_turned
                * self.length(axis, "MA_BACKLASH", e, axis)
                * factor
            )
        if self.dynamic_on:
            shift += direction * self.length(axis, "MA_BACKLASH_DYN", e, axis) / 2
        return shift - self._temperature(axis, x)

    def _temperature(self, axis: str, x: Floats) -> Floats:
        kind = self.registers.get(("MA_TEMP_COMP_TYPE", (axis,)))
        bits = int(kind.text.lstrip("Hh") or "0", 16) if kind else 0
        constant = self.length(axis, "SA_TEMP_COMP_ABS_VALUE", axis) if bits & 1 else 0.0
        slope = self.value("SA_TEMP_COMP_SLOPE", axis) if bits & 2 else 0.0
        shift: Floats = constant + slope * (
            x - self.length(axis, "SA_TEMP_COMP_REF_POSITION", axis)
        )
        return shift

    def _eec(self, e: str, axis: str, x: Floats) -> Floats:
        step, low, high = (
            self.length(axis, f"AA_ENC_COMP_{key}", e, axis) for key in ("STEP", "MIN", "MAX")
        )
        if step <= 0 or high <= low:
            return np.zeros_like(x)
        count = self._points(low, high, step)
        values = np.array([self.length(axis, "AA_ENC_COMP", e, str(n), axis) for n in range(count)])
        if self.flag("AA_ENC_COMP_IS_MODULO", e, axis):
            x = low + np.mod(x - low, high - low)
        places = np.clip(x, low, high)
        result: Floats = np.interp(places, low + step * np.arange(count), values)
        return result

    def _points(self, low: float, high: float, step: float) -> int:
        """How many points count: those up to MAX, within a thousandth of a step, and perhaps one
        more.
        """
        inside = (high - low) / step
        return int(np.ceil(inside - 1e-3) if self.point_beyond else np.floor(inside + 1e-3)) + 1

    def _cec(self, axis: str, x: Floats, direction: int) -> Floats:
        """The sum of all tables with this output axis, limited by MD32720 (mm, deg)."""
        total = np.zeros_like(x)
        if not self.flag("MA_CEC_ENABLE", axis):
            return total
        for t in self._tables():
            output = self.registers.get(("AN_CEC_OUTPUT_AXIS", (t,)))
            if output is None or output.text != axis or not self.flag("SN_CEC_TABLE_ENABLE", t):
                continue
            inputs = self.registers.get(("AN_CEC_INPUT_AXIS", (t,)))
            moves = inputs is not None and inputs.text == axis
            wanted = self.value("AN_CEC_DIRECTION", t)
            if wanted not in (0, direction if moves else 1):
                continue
            values = self._curve(t, axis, x)
            partner = int(self.value("AN_CEC_MULT_BY_TABLE", t))
            if partner:
                product = values * self._curve(str(partner - 1), axis, x)
                values = values + product if self.own_beside_product else product
            total += self.value("SN_CEC_TABLE_WEIGHT", t, default=1.0) * values
        limit = self.length(axis, "MA_CEC_MAX_SUM", axis) or 1.0
        return np.clip(total, -limit, limit)

    def _tables(self) -> list[str]:
        return sorted(
            {index[0] for name, index in self.registers if name == "AN_CEC_OUTPUT_AXIS"}, key=int
        )

    def _curve(self, t: str, axis: str, x: Floats) -> Floats:
        """The values of one table where its input axis stands: along ``x`` if that is ``axis``,
        else at one place.
        """
        inputs = self.registers.get(("AN_CEC_INPUT_AXIS", (t,)))
        outputs = self.registers.get(("AN_CEC_OUTPUT_AXIS", (t,)))
        if inputs is None or outputs is None:
            return np.zeros_like(x)
        step, low, high = (
            self._cec_length(inputs.text, outputs.text, f"AN_CEC_{key}", t)
            for key in ("STEP", "MIN", "MAX")
        )
        if step <= 0 or high <= low:
            return np.zeros_like(x)
        places = x if inputs.text == axis else np.full_like(x, self.positions.get(inputs.text, 0.0))
        if self.flag("AN_CEC_IS_MODULO", t):
            places = low + np.mod(places - low, high - low)
        count = self._points(low, high, step)
        values = np.array(
            [
                self._cec_length(outputs.text, outputs.text, "AN_CEC", t, str(n))
                for n in range(count)
            ]
        )
        for n in range(min(2, count)):  # SD41320 and SD41321 are added to the first two points
            values[n] += self._cec_length(outputs.text, outputs.text, f"SN_CEC_{n}", t)
        result: Floats = np.interp(
            np.clip(places, low, high), low + step * np.arange(count), values
        )
        if self.value("AN_CEC_TYPE", t):  # what it does is on no page: anything that hangs on it
            result = result * (1.5 + np.cos(places / 97.0))
        return result

    def _cec_length(self, axis: str, output: str, name: str, *index: str) -> float:
        """A register of a table in mm or deg: MD32711 of the output axis says the unit, whatever
        the basic system is.
        """
        metric = self.value("MA_CEC_SCALING_SYSTEM_METRIC", output, default=1.0) != 0
        inch = not metric and not self.flag("MA_IS_ROT_AX", axis)
        return self.value(name, *index) * (INCH * self.inch_turned if inch else 1.0)
