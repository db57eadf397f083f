"""Files of a control as they may be found: own and wrong tables, those of neighbours, switches,
comments and the forms in which a text may stand. Written here from the pages of the makers, not by
the package.
"""

from __future__ import annotations

import re

import numpy as np
from same_machines import Floats, MachineAxis, OldTable, Rng

#: Format -> the addresses of X, Y, Z, A, B, C.
ADDRESSES = {
    "fanuc-30i": ("1", "2", "3", "4", "5", "6"),
    "fanuc-0i-16i": ("1", "2", "3", "4", "5", "6"),
    "heidenhain-itnc530": tuple("XYZABC"),
    "heidenhain-nck": tuple("XYZABC"),
    "siemens-840d-sl": ("AX1", "AX2", "AX3", "AX4", "AX5", "AX6"),
    "linuxcnc": ("0", "1", "2", "3", "4", "5"),
    "isg-kernel": ("1", "2", "3", "4", "5", "6"),
    "pmac": ("1", "2", "3", "4", "5", "6"),
}
for _same, _others in {
    "fanuc-30i": ("fanuc-0i-d", "fanuc-0i-f", "fanuc-15i"),
    "siemens-840d-sl": ("siemens-828d", "siemens-840d-pl", "siemens-one"),
}.items():
    ADDRESSES |= dict.fromkeys(_others, ADDRESSES[_same])


def old_table(rng: Rng, axis: MachineAxis, quantum: float, *, wrong: bool) -> OldTable:
    """A table of the last visit, in whole quanta, zero at 0; ``wrong``: of another machine."""
    low, high = axis.travel
    count = int(rng.choice([9, 13, 17, 19, 25]))
    step = (high - low) / (count - 1)
    if not axis.endless and rng.random() < 0.6:
        step = float(rng.choice([15.0, 30.0] if axis.rotary else [25.0, 40.0, 50.0, 100.0]))
        count = int((high - low) / step) + int(rng.integers(1, 3))
    start = low if low > -step else step * float(np.floor(low / step))
    nodes = start + step * np.arange(count)
    u = np.asarray((nodes - low) / (high - low), dtype=np.float64)
    height = rng.uniform(10, 20) if wrong else rng.uniform(2, 6)
    phase = float(rng.uniform(0, 6))

    def curve(v: Floats) -> Floats:
        return np.asarray(height * np.sin(2 * np.pi * v * (1 if axis.endless else 0.7) + phase))

    zero = curve(np.asarray([-low / (high - low)], dtype=np.float64))
    shape: Floats = np.asarray(curve(u) - zero, dtype=np.float64)
    values = quantum * np.round(shape * (axis.unit / quantum))
    if axis.endless:
        values[-1] = values[0]
    backlash = quantum * round(float(rng.choice([0.0, rng.uniform(-2, 8)])) * axis.unit / quantum)
    return OldTable(start, step, np.asarray(values), backlash)


def hold_in_increments(axis: MachineAxis, unit: float) -> None:
    """Make the old table one that whole increments of at most 7 can hold, zero at the reference."""
    old = axis.old
    if old is None or old.start > 0:
        axis.old = None
        return
    increments = np.clip(np.round(np.diff(old.values) / unit), -7, 7)
    if axis.endless:
        increments[-1] -= increments.sum()
        increments = np.clip(increments, -7, 7)
    totals = np.concatenate([np.zeros(1), np.cumsum(increments)]) * unit
    reference = min(round(-old.start / old.step), old.values.size - 1)
    old.values = np.asarray(totals - totals[reference], dtype=np.float64)


def sinumerik(rng: Rng, axes: list[MachineAxis], system: int, *, enabled: str) -> dict[str, str]:
    """Tables (EEC), machine data and sometimes a cross-axis table that are not under work."""
    eec, md = ["%_N_AX_EEC_INI", "CHANDATA(1)"], ["CHANDATA(1)"]
    for axis in axes:
        name, old = axis.address, axis.old
        if old is not None:
            rows = [
                f"$AA_ENC_COMP[{system},{n},{name}]={-value:.7f}"
                for n, value in enumerate(old.values)
            ]
            end = old.start + old.step * (old.values.size - 1)
            eec += [
                *rows,
                f"$AA_ENC_COMP_STEP[{system},{name}]={old.step:.10g}",
                f"$AA_ENC_COMP_MIN[{system},{name}]={old.start:.10g}",
                f"$AA_ENC_COMP_MAX[{system},{name}]={end:.10g}",
                f"$AA_ENC_COMP_IS_MODULO[{system},{name}]={int(axis.endless)}",
            ]
            md.append(f"N32450 $MA_BACKLASH[{system},{name}]={old.backlash:.7f}")
            md += [f"N32700 $MA_ENC_COMP_ENABLE[{system},{name}]={enabled}"] if enabled else []
        elif rng.random() < 0.9:
            md.append(f"N32450 $MA_BACKLASH[{system},{name}]=0")
        if rng.random() < 0.6:
            reserved = int(rng.choice([25, 61, 125, 500, 500, 500]))
            md.append(f"N38000 $MA_MM_ENC_COMP_MAX_POINTS[{system},{name}]={reserved}")
        if rng.random() < 0.5:
            md.append(f"N30300 $MA_IS_ROT_AX[{name}]={int(axis.rotary)}")
            md.append(f"N30310 $MA_ROT_IS_MODULO[{name}]={int(axis.endless)}")
        if rng.random() < 0.2:
            md.append(f"N36100 $MA_POS_LIMIT_MINUS[{name}]={axis.travel[0]:g}")
            md.append(f"N36110 $MA_POS_LIMIT_PLUS[{name}]={axis.travel[1]:g}")
        if rng.random() < 0.5:
            md.append(f"N32710 $MA_CEC_ENABLE[{name}]={int(rng.random() < 0.7)}")
    _sinumerik_extras(rng, axes, system, md)
    files = {"MD.INI": "\n".join([*md, "M17", ""])}
    if len(eec) > 2 or rng.random() < 0.5:
        files["AX_EEC.INI"] = "\n".join([*eec, "M17", ""])
    if rng.random() < 0.35:
        files["NC_CEC.INI"] = _cec(rng, axes)
    return {name: _sinumerik_style(rng, text) for name, text in files.items()}


def _sinumerik_extras(rng: Rng, axes: list[MachineAxis], system: int, md: list[str]) -> None:
    name = axes[0].address
    for chance, line in (
        (0.1, "N10240 $MN_SCALING_SYSTEM_IS_METRIC=1"),
        (0.02, "N10240 $MN_SCALING_SYSTEM_IS_METRIC=0"),
        (0.1, f'N10000 $MN_AXCONF_MACHAX_NAME_TAB[0]="{name}"'),
        (0.1, f"N30200 $MA_NUM_ENCS[{name}]={system + 1}"),
        (0.04, f"N32750 $MA_TEMP_COMP_TYPE[{name}]={int(rng.integers(0, 4))}"),
        (0.04, f"N32452 $MA_BACKLASH_FACTOR[0,{name}]={rng.choice(['1', '0.5', '1.0'])}"),
        (0.04, f"N32456 $MA_BACKLASH_DYN[{system},{name}]={rng.choice(['0', '0.003'])}"),
        (0.04, f"N37100 $MA_GANTRY_AXIS_TYPE[{name}]={int(rng.integers(0, 3))}"),
        (0.05, "N18342 $MN_MM_CEC_MAX_POINTS[3]=40"),
        (0.05, f"N32720 $MA_CEC_MAX_SUM[{name}]=1"),
    ):
        if rng.random() < chance:
            md.append(line)


def _cec(rng: Rng, axes: list[MachineAxis]) -> str:
    """One or two cross-axis tables, or of an axis over itself; some sleep."""
    lines = ["%_N_NC_CEC_INI", "CHANDATA(1)"]
    names = [axis.address for axis in axes] + ["AX7", "AX8"]
    for table in rng.choice([0, 1, 3, 8], int(rng.integers(1, 3)), replace=False):
        one, two = (str(name) for name in rng.choice(names, 2))
        values = [0.0, *np.round(rng.normal(0, 0.003, 2), 6)]
        lines += [f"$AN_CEC[{table},{n}]={value:.7f}" for n, value in enumerate(values)]
        lines += [f"$AN_CEC_INPUT_AXIS[{table}]=({one})", f"$AN_CEC_OUTPUT_AXIS[{table}]=({two})"]
        words = {"STEP": 400.0, "MIN": 0.0, "MAX": 800.0, "DIRECTION": int(rng.integers(-1, 2))}
        words |= {"MULT_BY_TABLE": 0, "IS_MODULO": 0}
        lines += [f"$AN_CEC_{key}[{table}]={value}" for key, value in words.items()]
        if rng.random() < 0.6:
            lines.append(f"$SN_CEC_TABLE_ENABLE[{table}]={int(rng.random() < 0.3)}")
    return "\n".join([*lines, "M17", ""])


def _sinumerik_style(rng: Rng, text: str) -> str:
    form = int(rng.integers(0, 9))
    if form == 1:
        return text.replace("\n", "\r\n")
    if form == 2:
        return re.sub(r"(ENABLE\[[^\]]*\])=([01])$", _true_or_false, text, flags=re.MULTILINE)
    if form == 3:
        return re.sub(r"^(\$[^=\n]*)=(\S+)$", r"\1 = \2   ; value", text, flags=re.MULTILINE)
    if form == 4:
        return re.sub(r"^N\d+ ", "", text, flags=re.MULTILINE)
    if form == 5:
        return text.replace("M17\n", "M30\n")
    if form == 6:
        return "; backup of 2023, second shift\n\n" + text.replace("=0.", "=.")
    return text


def _true_or_false(match: re.Match[str]) -> str:
    return f"{match[1]}={'TRUE' if match[2] == '1' else 'FALSE'}"


def fanuc(
    rng: Rng, axes: list[MachineAxis], *, newer: bool, unit: float, acts: bool
) -> dict[str, str]:
    """Parameters and pitch data; axes without a table of their own hold zeros, others may claim
    numbers.
    """
    decimal = newer or rng.random() < 0.15
    q = "Q1" if newer else ""
    rows: dict[int, list[str]] = {}
    points: dict[int, int] = {}
    first = int(rng.choice([0, 10, 100]))
    for axis in axes:
        first = _fanuc_axis(axis, rows, points, first, unit, acts=acts)
    if rng.random() < 0.4:  # a neighbour that claims numbers of its own
        for number, value in ((3620, 505), (3621, 500), (3622, 510), (3623, 1), (3624, 60000)):
            rows.setdefault(number, []).append(f"A7P{value}")
        points |= {n: int(rng.integers(-3, 4)) for n in range(500, 511)}
    _fanuc_extras(rng, axes, rows, decimal=decimal)
    lines = [f"N{number:05d}{q}{''.join(words)}" for number, words in sorted(rows.items())]
    if rng.random() < 0.05:
        one = "Q1L1" if newer else ""
        lines.insert(0, f"N01001{one}P0000000{int(rng.random() < 0.5)}")
    zero = "Q0" if newer else ""
    pitch = [f"N1{number:04d}{zero}P{value}" for number, value in sorted(points.items())]
    if rng.random() < 0.2:
        return {"ALL.TXT": _fanuc_style(rng, "\n".join(["%", *lines, *pitch, "%", ""]))}
    texts = {"CNC-PARA.TXT": lines, "PITCH.TXT": pitch}
    return {
        name: _fanuc_style(rng, "\n".join(["%", *body, "%", ""])) for name, body in texts.items()
    }


def _fanuc_extras(
    rng: Rng, axes: list[MachineAxis], rows: dict[int, list[str]], *, decimal: bool
) -> None:
    """Bits, limits and the backlash of rapid; ``decimal``: lengths are written with a point."""
    if rng.random() < 0.3:
        rows[1006] = [f"A{axis.address}P0000000{int(axis.rotary)}" for axis in axes]
    if rng.random() < 0.3:
        rows[1815] = [f"A{axis.address}P00{int(rng.integers(0, 2))}00000" for axis in axes]
    if rng.random() < 0.7:
        rows[3605] = [f"A{axis.address}P0000000{int(rng.random() < 0.05)}" for axis in axes]
    if decimal:
        for number in {3624, 3625} & set(rows):
            words = [word.split("P") for word in rows[number]]
            rows[number] = [f"{name}P{int(value) / 1000}" for name, value in words]
        rows[1320] = [f"A{axis.address}P{axis.travel[1]:.3f}" for axis in axes]
        rows[1321] = [f"A{axis.address}P{axis.travel[0]:.3f}" for axis in axes]
    if rng.random() < 0.2:
        rows[1852] = list(rows.get(1851, ["A1P0"]))


def _fanuc_axis(
    axis: MachineAxis,
    rows: dict[int, list[str]],
    points: dict[int, int],
    first: int,
    unit: float,
    *,
    acts: bool,
) -> int:
    """Add the axis' numbers; return the next free point."""
    old, name = axis.old, axis.address
    words = dict.fromkeys((1851, 3620, 3621, 3622, 3623, 3624), 0)
    if old is not None:
        below = round(-old.start / old.step)
        reference = first + max(below, 0)
        count = old.values.size
        increments = np.round(np.diff(old.values) / unit).astype(int)
        numbers = [reference - below + 1 + n for n in range(count - 1)]
        claimed = range(min(numbers[0], reference), max(numbers[-1], reference) + 1)
        points |= dict.fromkeys(claimed, 0)
        points |= dict(zip(numbers, increments.tolist(), strict=True))
        words = {
            1851: round(old.backlash / unit),
            3620: reference,
            3621: claimed[0],
            3622: claimed[-1],
            3623: int(acts),
            3624: round(old.step * 1000),
        }
        if axis.endless:
            words[3625] = 360000
        first = words[3622] + 5
    for number, value in words.items():
        rows.setdefault(number, []).append(f"A{name}P{value}")
    return first


def _fanuc_style(rng: Rng, text: str) -> str:
    form = int(rng.integers(0, 6))
    if form == 1:
        return text.replace("\n", "\r\n")
    if form == 2:
        return re.sub(r"(A\d+P)", r" \1 ", text)
    if form == 3:
        return text.replace("N0", "N")
    if form == 4:
        return text.replace("%\n", "%\n\n", 1) + "\n"
    return text


def heidenhain_itnc(
    rng: Rng, axes: list[MachineAxis], *, meaning: str, acts: bool
) -> dict[str, str]:
    """Own table files with a column of another axis, a list of parameters, or entry sheets."""
    sign = -1 if meaning == "error" else 1
    files = {}
    parameters, mask = [], 0
    for axis in axes:
        old, number = axis.old, axis.number
        if old is None:
            parameters.append(f"MP710.{number - 1} : 0.0000")
            continue
        mask |= int(acts) << (number - 1)
        if rng.random() < 0.4:
            files[f"entry_{axis.name}.csv"] = _sheet(axis, old, meaning, sign, "MP710", acts=acts)
            continue
        other = number % 3 + 1
        rows = [
            f"{n:<4d} {sign * value:+.4f}   {rng.normal(0, 0.002):+.4f}"
            for n, value in enumerate(old.values)
        ]
        head = f"BEGIN {axis.name} .COM MM DATUM:{old.start:g} DIST:{old.step:.10g}"
        names = f"NR   {number}=F()    {other}=F()"
        files[f"{axis.name}.COM"] = "\n".join([head, names, *rows, f"END {axis.name} .COM", ""])
        parameters.append(f"MP710.{number - 1} : {old.backlash:.4f}")
    if parameters or rng.random() < 0.5:
        if rng.random() < 0.2:
            parameters.append(f"MP720.{int(rng.integers(0, 3))} : {rng.normal(0, 0.02):.3f}")
        parameters += ["MP1010.0 : 30000 ; feed", f"MP730 : %{mask:05b}"]
        files["MP.TXT"] = "\n".join([*parameters, ""])
    return files or {"MP.TXT": "MP710.0 : 0.0000\nMP730 : %00000\n"}


def heidenhain_nck(
    rng: Rng, axes: list[MachineAxis], *, meaning: str, acts: bool, second_curve: bool
) -> dict[str, str]:
    """Own table files, the file of assignments with its active line, or entry sheets."""
    sign = -1 if meaning == "error" else 1
    files, cells = {}, []
    for axis in axes:
        old = axis.old
        if old is None:
            continue
        if rng.random() < 0.4:
            files[f"entry_{axis.name}.csv"] = _sheet(
                axis, old, meaning, sign, "backLash", acts=acts
            )
            continue
        cells.append(axis.name)
        two = rng.random() < (0.7 if second_curve else 0.03)
        rows = []
        for n, value in enumerate(old.values):
            back = f"{sign * (value - old.backlash):+.4f}" if two else "       "
            place = f"{old.start + n * old.step:+.4f}"
            rows.append(f"{n:<3d} {place:<12}{back:<11}{sign * value:+.4f}    +0.00{10 + n % 90}")
        names = f"NR  {'AXISPOS':<12}{'BACKLASH':<11}{axis.name:<10} W"
        head = f"BEGIN {axis.name}.COM MM"
        files[f"{axis.name}.COM"] = "\n".join([head, names, *rows, "[END]", ""])
        if not two and rng.random() < 0.7:
            words = f"backLash,,{old.backlash:.4f},{'deg' if axis.rotary else 'mm'}"
            lines = [f"# axis: {axis.name}", f"# value: {meaning}", "point,position,value,unit"]
            files[f"entry_{axis.name}.csv"] = "\n".join([*lines, words, ""])
    if cells:
        line = "".join(f"{name + '.COM':<8}" for name in cells)
        names = "".join(f"{name:<8}" for name in [*cells, "W"])
        mark = "*" if acts else " "
        files["CONFIG.CMA"] = (
            f"BEGIN CONFIG.CMA MM\nNR  ACTIVE  {names}\n0   {mark}       {line}\n[END]\n"
        )
    return files or {"CONFIG.CMA": "BEGIN CONFIG.CMA MM\nNR  ACTIVE  X\n0   *\n[END]\n"}


def _sheet(
    axis: MachineAxis, old: OldTable, meaning: str, sign: int, backlash: str, *, acts: bool
) -> str:
    unit = "deg" if axis.rotary else "mm"
    lines = [f"# axis: {axis.name}", f"# address: {axis.address}", f"# value: {meaning}"]
    lines += [f"# points: {old.values.size}", "point,position,value,unit"]
    lines += [
        f"{n},{old.start + n * old.step:.4f},{sign * value:.4f},{unit}"
        for n, value in enumerate(old.values)
    ]
    lines.append(f"{backlash},,{old.backlash:.4f},{unit}")
    lines += [f"MP730,,{int(acts)},"] if backlash == "MP710" else []
    return "\n".join([*lines, ""])


def linuxcnc(rng: Rng, axes: list[MachineAxis], *, inch: bool) -> dict[str, str]:
    """The INI file of a machine and a table for each joint, of type 0 or 1."""
    scale = 25.4 if inch else 1.0
    files: dict[str, str] = {}
    ini = ["# the machine of hall 3", "[TRAJ]"]
    ini += [f"LINEAR_UNITS = {'inch' if inch else 'mm'}"] if inch or rng.random() < 0.7 else []
    if rng.random() < 0.5:
        ini += ["[KINS]", "KINEMATICS = trivkins coordinates=XYZABC"]
    for axis in axes:
        old, joint = axis.old, axis.address
        unit = 1.0 if axis.rotary else scale
        ini += ["", f"[JOINT_{joint}]", f"TYPE = {'ANGULAR' if axis.rotary else 'LINEAR'}"]
        if rng.random() < 0.4:
            ini += [f"MIN_LIMIT = {axis.travel[0] / unit:.4f}"]
            ini += [f"MAX_LIMIT = {axis.travel[1] / unit:.4f}"]
        if old is None:
            continue
        kind = int(rng.integers(0, 2))
        rows = []
        for n, value in enumerate(old.values):
            place = old.start + n * old.step
            two = (value, value - old.backlash)
            shown = [(place - v) / unit if kind == 0 else v / unit for v in two]
            rows.append(f"{place / unit:.6f} {shown[0]:.7f} {shown[1]:.7f}")
        files[f"joint_{joint}.comp"] = "\n".join([*rows, ""])
        ini += [f"COMP_FILE = joint_{joint}.comp", f"COMP_FILE_TYPE = {kind}"]
        ini += [f"BACKLASH = {rng.choice(['0', '0.0', '0.004'])}"] if rng.random() < 0.6 else []
    return {"machine.ini": "\n".join([*ini, ""])} | files
