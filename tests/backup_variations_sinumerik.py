"""What is special about a job on a real SINUMERIK archive, and its mark beforehand, by what the
manuals say and nothing else.
"""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

import sinumerik_archive as archive
from backup_cases_sinumerik import (
    ANSWERABLE,
    NAMES,
    PLAIN,
    ROTARY,
    TRAVELS,
    Case,
    smooth,
    start,
    style,
)
from sinumerik_archive import cec_lines, eec_lines, number, put, replace_cec, replace_eec, without

Special = Callable[[Case, np.random.Generator], None]


# -- what is special: nothing else acts
# -------------------------------------------------------------------------------------------


def nothing(case: Case, rng: np.random.Generator) -> None:
    pass


def known_by_two_names(case: Case, rng: np.random.Generator) -> None:
    """X1 and AX1 are one axis (MD10000 stands in the machine data); files mix both."""
    if case.axis == "AX1" and case.nonzero and rng.random() < 0.5:
        case.md = put(case.md, f"$MA_BACKLASH[{case.system},AX1]", number(0.006))
    which = int(rng.integers(3))
    name = NAMES[case.axis]
    if which != 1:
        case.eec = re.sub(rf"\b{case.axis}\]", f"{name}]", case.eec)
    if which != 0:
        case.md = re.sub(rf"(BACKLASH\[\d),{case.axis}\]", rf"\1,{name}]", case.md)
        case.md = re.sub(rf"(ENC_COMP_ENABLE\[\d),{case.axis}\]", rf"\1,{name}]", case.md)
    case.address = name if rng.random() < 0.5 else case.axis


def half_by_name(case: Case, rng: np.random.Generator) -> None:
    """One table whose lines name the axis by turns X1 and AX1."""
    turn = iter(range(10_000))
    case.eec = re.sub(
        rf"\b{case.axis}\]",
        lambda _: f"{NAMES[case.axis]}]" if next(turn) % 2 else f"{case.axis}]",
        case.eec,
    )


def sleeping_table_over_itself(case: Case, rng: np.random.Generator) -> None:
    """A CEC table of the axis over itself, 100 µm, switched off at MD32710 or SD41300: it does not
    act, and must go on sleeping.
    """
    low, high = case.travel
    assert case.cec is not None
    case.cec = replace_cec(
        case.cec,
        9,
        cec_lines(9, case.axis, case.axis, low, (high - low) / 4, [0, 0.1, 0.05, -0.1, 0]),
    )
    case.md = put(case.md, "$MN_MM_CEC_MAX_POINTS[9]", "5")
    at_axis = rng.random() < 0.5
    case.md = put(case.md, f"$MA_CEC_ENABLE[{case.axis}]", "0" if at_axis else "1")
    case.md = put(case.md, "$SN_CEC_TABLE_ENABLE[9]", "1" if at_axis else "0")


def sleeping_tables_of_others(case: Case, rng: np.random.Generator) -> None:
    """MD32710 of all axes off, foreign tables of 100 µm stand ready."""
    other = "AX3" if case.axis != "AX3" else "AX1"
    assert case.cec is not None
    case.cec = replace_cec(
        case.cec, 9, cec_lines(9, other, other, -600, 200, [0.1, -0.1, 0.05, 0.1])
    )
    case.md = put(case.md, "$MN_MM_CEC_MAX_POINTS[9]", "10")
    for axis in TRAVELS:
        case.md = put(case.md, f"$MA_CEC_ENABLE[{axis}]", "0")
    case.md = put(case.md, "$SN_CEC_TABLE_ENABLE[9]", "1")


def others_act_between_others(case: Case, rng: np.random.Generator) -> None:
    """Tables of other axes, weights, products, over themselves too: none puts out on the axis under
    work.
    """
    others = [axis for axis in TRAVELS if axis != case.axis]
    one, two = (str(axis) for axis in rng.choice(others, 2, replace=False))
    assert case.cec is not None
    low, high = TRAVELS[one]
    case.cec = replace_cec(
        case.cec, 9, cec_lines(9, one, two, low, (high - low) / 3, [0, 0.02, -0.03, 0], product=11)
    )
    case.cec = replace_cec(
        case.cec, 10, cec_lines(10, one, one, low, (high - low) / 2, [0.01, 0, -0.01], direction=1)
    )
    # The axis under work as input of a table that moves another one: its own readings know nothing
    # of it.
    low, high = case.travel
    case.cec = replace_cec(
        case.cec, 11, cec_lines(11, case.axis, two, low, (high - low) / 2, [0.02, 0, -0.02])
    )
    for t in (9, 10, 11):
        case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", "6")
        case.md = put(case.md, f"$SN_CEC_TABLE_ENABLE[{t}]", "1")
    case.md = put(case.md, "$SN_CEC_TABLE_WEIGHT[9]", "0.5")


def loader_that_switches_on(case: Case, rng: np.random.Generator) -> None:
    """A maker's program alone: off, NEWCONF, data, on, NEWCONF. Its last word is on."""
    case.files = {"G_LAS.MPF": loader(case, rng, "1" if rng.random() < 0.5 else "TRUE")}
    case.truth = [case.md, *case.files.values()]
    if case.system == 1:
        case.job_system = None if rng.random() < 0.5 else 2
    case.active = case.enabled = None
    case.mark, case.demand, case.code = PLAIN, "$^", None


def loader(case: Case, rng: np.random.Generator, last: str | None) -> str:
    """The text of such a program, with the backlash in it."""
    low, step, count = case.grid
    e, axis = case.system, case.axis
    values = smooth(case, rng) if case.nonzero else np.zeros(count)
    backlash = number(rng.uniform(0, 8) * case.unit)
    case.md = put(case.md, f"$MA_BACKLASH[{e},{axis}]", backlash)
    lines = f";{case.letter}-Achse\n$MA_ENC_COMP_ENABLE[{e},{axis}]=0\nNEWCONF\nSTOPRE\n"
    lines += eec_lines(axis, e, low, step, list(values), modulo=case.modulo)
    lines += f"$MA_BACKLASH[{e},{axis}]={backlash}\nSTOPRE\nNEWCONF\n"
    if last is not None:
        lines += f"$MA_ENC_COMP_ENABLE[{e},{axis}]={last}\nSTOPRE\nNEWCONF\n"
    return lines + "M17\n"


def the_makers_program(case: Case, rng: np.random.Generator) -> None:
    """G_85.MPF of the archive: the tables of X, Y and Z in system 2, all zero, switched on at its
    end.
    """
    if case.rotary:
        return
    text = archive.member("G_85.MPF").decode("latin-1")
    case.system, case.nonzero, case.active, case.enabled = 1, False, None, None
    case.job_system = None if rng.random() < 0.5 else 2
    case.md = put(
        put(case.md, f"$MA_NUM_ENCS[{case.axis}]", "2"), f"$MA_ENC_COMP_ENABLE[0,{case.axis}]", "0"
    )
    case.md = put(case.md, f"$MA_ENC_COMP_ENABLE[1,{case.axis}]", "1")
    case.md = put(
        put(case.md, f"$MA_BACKLASH[1,{case.axis}]", "0"),
        f"$MA_MM_ENC_COMP_MAX_POINTS[1,{case.axis}]",
        "25",
    )
    case.files = {"G_85.MPF": text} if rng.random() < 0.5 else {"MD.INI": case.md, "G_85.MPF": text}
    case.truth = [case.md, text]
    case.mark, case.demand, case.code = PLAIN, "$^", None


def stated_active(case: Case, rng: np.random.Generator) -> None:
    """A loader that ends with compensation off, or a table alone; the job says whether it acted."""
    case.active = str(rng.choice(["yes", "no", "true", "false"]))
    case.enabled = case.active in {"yes", "true"}
    case.mark, case.demand, case.code = PLAIN, "$^", None
    if rng.random() < 0.6:
        case.files = {"G_LAS.MPF": loader(case, rng, "0")}
        case.truth = [case.md, *case.files.values()]
    else:
        case.files, case.truth = (
            {"AX_EEC.INI": case.eec},
            [
                put(case.md, f"$MA_BACKLASH[{case.system},{case.axis}]", "0"),
                case.eec,
            ],
        )
    case.job_system = case.system + 1 if rng.random() < 0.5 else None


def zero_and_silent(case: Case, rng: np.random.Generator) -> None:
    """A table of zeros alone: nothing is said about on or off, and nothing hangs on it."""
    low, step, count = case.grid
    case.nonzero = False
    case.eec = replace_eec(
        case.eec,
        case.axis,
        eec_lines(case.axis, case.system, low, step, [0.0] * count, modulo=case.modulo),
    )
    case.files = {"AX_EEC.INI": case.eec}
    case.truth = [put(case.md, f"$MA_BACKLASH[{case.system},{case.axis}]", "0"), case.eec]
    case.active = case.enabled = None
    case.mark, case.demand, case.code = PLAIN, "$^", None


def state_none(case: Case, rng: np.random.Generator) -> None:
    """Nothing is in the control, and the job says so."""
    case.none, case.nonzero, case.files, case.active, case.enabled = True, False, {}, None, None
    clean = case.md
    for e in (0, 1):
        clean = put(
            put(clean, f"$MA_BACKLASH[{e},{case.axis}]", "0"),
            f"$MA_ENC_COMP_ENABLE[{e},{case.axis}]",
            "0",
        )
        clean = put(clean, f"$MA_MM_ENC_COMP_MAX_POINTS[{e},{case.axis}]", "5000")
    case.truth = [clean]
    case.job_system = case.system + 1
    case.mark, case.demand, case.code = PLAIN, "$^", None


def stale_table_in_the_idle_system(case: Case, rng: np.random.Generator) -> None:
    """Two measuring systems; the idle one holds an old table that is switched off."""
    if case.system == 0:
        case.md = put(case.md, f"$MA_NUM_ENCS[{case.axis}]", "2")
        case.job_system = 1
    idle = 1 - case.system
    low, step, count = case.grid
    lines = eec_lines(case.axis, idle, low, step, list(smooth(case, rng, 4.0)), modulo=case.modulo)
    place = case.eec.index("M17")
    case.eec = case.eec[:place] + lines + case.eec[place:]
    case.md = put(case.md, f"$MA_MM_ENC_COMP_MAX_POINTS[{idle},{case.axis}]", str(count))
    case.md = put(case.md, f"$MA_BACKLASH[{idle},{case.axis}]", number(20 * case.unit))


def other_control(case: Case, rng: np.random.Generator) -> None:
    """The axes of another real control, from the listing of its machine data."""
    rows = archive.listing()
    column = int(rng.integers(0, 3))
    e, axis = 1, f"AX{column + 1}"
    low, high, step = (
        float(rows[f"$AA_ENC_COMP_{key}[1]"][column]) for key in ("MIN", "MAX", "STEP")
    )
    case.axis, case.letter, case.system, case.kind, case.modulo = (
        axis,
        "XYZ"[column],
        e,
        "linear",
        False,
    )
    case.travel, case.reference, case.home = (low, high), low if low > 0 or high < 0 else 0.0, 1
    case.grid = (low, step, round((high - low) / step) + 1)
    case.address = axis if rng.random() < 0.5 else rows["$MN_AXCONF_MACHAX_NAME_TAB"][column]
    case.job_system, case.active, case.enabled = None, None, None
    case.mark, case.demand, case.code, case.cec = PLAIN, "$^", None, None
    lines = ["METRIC", "CHANDATA(1)", "N10240 $MN_SCALING_SYSTEM_IS_METRIC=1"]
    lines += [
        f'N10000 $MN_AXCONF_MACHAX_NAME_TAB[{n}]="{rows["$MN_AXCONF_MACHAX_NAME_TAB"][n]}"'
        for n in range(5)
    ]
    tables = []
    for n in range(5):
        for key, cells in rows.items():
            if key.startswith("$MA_"):
                head, _, index = key.partition("[")
                inside = f"{index.rstrip(']')}," if index and "POS_LIMIT" not in key else ""
                lines.append(f"{cells[-2]} {head}[{inside}AX{n + 1}]={cells[n]}")
        points = int(rows["$MA_MM_ENC_COMP_MAX_POINTS[1]"][n])
        start_, step_ = (
            float(rows["$AA_ENC_COMP_MIN[1]"][n]),
            float(rows["$AA_ENC_COMP_STEP[1]"][n]),
        )
        values = smooth(case, rng) if n == column else rng.normal(0, 0.003, points)
        tables.append(eec_lines(f"AX{n + 1}", 1, start_, step_, list(values), modulo=n > 2))
    case.nonzero = True
    case.md = "\n".join([*lines, "M17"]) + "\n"
    case.eec = "CHANDATA(1)\n" + "".join(tables) + "M17\n"


# -- what is special: something acts that can be honoured
# -------------------------------------------------------------------------


def inch_control(case: Case, rng: np.random.Generator) -> None:
    """MD10240 = 0, or the line INCH, or both: lengths of linear axes are inches."""
    rotary = ROTARY
    case.md = put(archive.in_inch(case.md, rotary), "$MN_SCALING_SYSTEM_IS_METRIC", "0")
    case.eec, case.cec = archive.in_inch(case.eec, rotary), None
    which = int(rng.integers(3))
    if which == 1:  # the machine data say it, no line does
        case.md, case.eec = (
            without(case.md, re.compile(r"^INCH$")),
            without(case.eec, re.compile(r"^INCH$")),
        )
    if (
        which == 2 and "$MA_BACKLASH" in case.md
    ):  # the lines say it, the machine data were not exported with the basic system
        case.truth = [case.md, case.eec]
        case.files = {"MD.INI": without(case.md, "SCALING_SYSTEM"), "AX_EEC.INI": case.eec}
    case.may_refuse("inch|MD10240|SCALING_SYSTEM")


def own_table(
    case: Case, rng: np.random.Generator, direction: int = 0, t: int = 9, weight: float = 1.0
) -> None:
    low, high = case.travel
    count = 13 if case.modulo else 11
    grid, case.grid = case.grid, (low, (high - low) / (count - 1), count)
    values = smooth(case, rng)
    assert case.cec is not None
    case.cec = replace_cec(
        case.cec,
        t,
        cec_lines(
            t,
            case.axis,
            case.axis,
            low,
            case.grid[1],
            list(values),
            direction=direction,
            modulo=int(case.modulo),
        ),
    )
    case.grid = grid
    case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", str(count))
    case.md = put(case.md, f"$SN_CEC_TABLE_ENABLE[{t}]", "1")
    case.md = put(case.md, f"$SN_CEC_TABLE_WEIGHT[{t}]", number(weight))
    case.md = put(case.md, f"$MA_CEC_ENABLE[{case.axis}]", "1")


def table_over_itself(case: Case, rng: np.random.Generator) -> None:
    """A CEC table of the axis over itself acts: one for both directions or a pair; the sign is
    stated rightly.
    """
    case.cec_sign = float(rng.choice([1, -1]))
    if rng.random() < 0.5:
        own_table(case, rng, 0, 9, float(rng.choice([1, 1, 0.5])))
    else:
        own_table(case, rng, 1, 9)
        own_table(case, rng, -1, 10)
    case.options["cec_sign"] = "correction" if case.cec_sign > 0 else "error"
    case.may_refuse(r"\bCEC\b|AN_CEC|MD32710|SD41300")
    if rng.random() < 0.3:
        case.options["cec"], case.options["cec_tables"] = "available", "[9, 10]"
        case.written_tables = {"9", "10"}


def table_over_itself_without_a_sign(case: Case, rng: np.random.Generator) -> None:
    own_table(case, rng)
    case.cec_sign = float(rng.choice([1, -1]))
    case.may_refuse("cec_sign", 2)


def pair_is_wanted(case: Case, rng: np.random.Generator) -> None:
    """A bidirectional table is asked for and free CEC tables are given; the sign is stated
    rightly.
    """
    ask_for_a_pair(case, rng)
    case.may_refuse(r"\bCEC\b|AN_CEC|MD32710|MD32700|SD41300|EEC|modulo")


def ask_for_a_pair(case: Case, rng: np.random.Generator) -> None:
    case.cec_sign = float(rng.choice([1, -1]))
    for t in (9, 10):
        case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", "40")
    case.options |= {
        "cec": "available",
        "cec_tables": "[9, 10]",
        "cec_sign": "correction" if case.cec_sign > 0 else "error",
    }
    case.table["mode"] = "bidirectional"
    case.written_tables = {"9", "10"}


def backlash_factor(case: Case, rng: np.random.Generator) -> None:
    """MD32452 multiplies MD32450."""
    case.md = put(
        case.md, f"$MA_BACKLASH[{case.system},{case.axis}]", number(rng.uniform(2, 6) * case.unit)
    )
    factor = str(rng.choice(["2", "0.5"]))
    for n in range(6):
        case.md = put(case.md, f"$MA_BACKLASH_FACTOR[{n},{case.axis}]", factor)
    case.may_refuse("MD32452|BACKLASH_FACTOR")


def dynamic_backlash(case: Case, rng: np.random.Generator) -> None:
    """MD32456, switched on or off by the PLC: nobody knows from the files."""
    case.md = put(
        case.md,
        f"$MA_BACKLASH_DYN[{case.system},{case.axis}]",
        number(rng.uniform(4, 9) * case.unit),
    )
    case.dynamic_on = bool(rng.random() < 0.7)
    case.may_refuse("MD32456|BACKLASH_DYN")


def temperature(case: Case, rng: np.random.Generator) -> None:
    """MD32750: a constant as in the archive, or a slope too."""
    kind = str(rng.choice(["'H1'", "'H3'"]))
    case.md = put(case.md, f"$MA_TEMP_COMP_TYPE[{case.axis}]", kind)
    case.md = put(case.md, f"$SA_TEMP_COMP_SLOPE[{case.axis}]", number(rng.uniform(-3e-5, 3e-5)))
    case.may_refuse("MD32750|TEMP_COMP|SD439")


def another_axis_moves_this_one(case: Case, rng: np.random.Generator) -> None:
    """Cross tables put out on the axis under work, by another axis' position: one value during the
    test; a product perhaps.
    """
    other = "AX3" if case.axis != "AX3" else "AX1"
    low, high = TRAVELS[other]
    assert case.cec is not None
    case.positions[other] = float(rng.uniform(low, high))
    case.cec = replace_cec(
        case.cec,
        9,
        cec_lines(9, other, case.axis, low, (high - low) / 4, [0.02, 0.01, 0, -0.01, -0.02]),
    )
    case.md = put(put(case.md, "$MN_MM_CEC_MAX_POINTS[9]", "5"), "$SN_CEC_TABLE_ENABLE[9]", "1")
    if rng.random() < 0.4:
        low, high = case.travel
        case.cec = replace_cec(
            case.cec,
            9,
            cec_lines(9, other, case.axis, *TRAVELS[other][:1], 100, [1.0] * 5, product=11),
        )
        case.cec = replace_cec(
            case.cec,
            10,
            cec_lines(10, case.axis, "X", low, (high - low) / 4, [0, 0.01, 0.005, -0.01, 0]),
        )
        case.md = put(case.md, "$MN_MM_CEC_MAX_POINTS[10]", "5")
    case.md = put(case.md, f"$MA_CEC_ENABLE[{case.axis}]", "1")
    case.cec_sign = float(rng.choice([1, -1]))
    case.may_refuse(r"\bCEC\b|AN_CEC|MD32710|SD41300")


def few_points(case: Case, rng: np.random.Generator) -> None:
    """MD38000 holds hardly anything."""
    reserved = int(rng.choice([0, 2, 5]))
    low, high = case.travel
    case.md = put(case.md, f"$MA_MM_ENC_COMP_MAX_POINTS[{case.system},{case.axis}]", str(reserved))
    values = [0.0] * reserved
    lines = (
        eec_lines(
            case.axis, case.system, low, (high - low) / (reserved - 1), values, modulo=case.modulo
        )
        if reserved
        else ""
    )
    case.eec = replace_eec(case.eec, case.axis, lines)
    case.nonzero = False
    case.active, case.enabled = ("no", False) if case.active else (None, None)
    case.may_refuse("MD38000|ENC_COMP_MAX_POINTS|points")


def turned_reference(case: Case, rng: np.random.Generator) -> None:
    """A rotary modulo axis with its reference at 90 (others: the reference inside the travel)."""
    low, high = case.travel
    case.reference = 90.0 if case.modulo else float(round(low + 0.3 * (high - low)))
    if case.modulo:
        case.may_refuse("reference|modulo|360")


def gantry_named(case: Case, rng: np.random.Generator) -> None:
    """MD37100: AX1 leads AX3 ...; the job names it, and both get the table."""
    make_gantry(case)
    case.may_refuse("gantry|MD37100")


def make_gantry(case: Case) -> None:
    follower = "AX3" if case.axis != "AX3" else "AX2"
    if case.rotary:
        follower = "AX5" if case.axis == "AX4" else "AX4"
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{case.axis}]", "1")
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{follower}]", "11")
    same = re.sub(
        rf"\b{case.axis}\]",
        f"{follower}]",
        "".join(
            re.findall(rf"^\$AA_ENC_COMP\S*\b{case.axis}\]\S*\n", case.eec, flags=re.MULTILINE)
        ),
    )
    case.eec = replace_eec(case.eec, follower, same)
    for key in ("MM_ENC_COMP_MAX_POINTS", "ENC_COMP_ENABLE", "BACKLASH"):
        for e in (0, 1):
            found = re.search(rf"\$MA_{key}\[{e},{case.axis}\]=(\S+)", case.md)
            assert found is not None
            case.md = put(case.md, f"$MA_{key}[{e},{follower}]", found[1])
    case.md = put(
        case.md,
        f"$MA_NUM_ENCS[{follower}]",
        "1" if case.system == 0 and case.job_system is None else "2",
    )
    case.md = put(case.md, f"$MA_ROT_IS_MODULO[{follower}]", str(int(case.modulo)))
    case.md = put(
        put(case.md, f"$MA_MODULO_RANGE[{follower}]", "360"),
        f"$MA_MODULO_RANGE_START[{follower}]",
        "0",
    )
    case.gantry = follower


def neither_is_on(case: Case, rng: np.random.Generator) -> None:
    """Two measuring systems, no table yet, nothing switched on, no word in the job: the PLC uses
    one of them.
    """
    e = int(rng.integers(2))
    case.system, case.nonzero, case.active, case.enabled, case.job_system = (
        e,
        False,
        None,
        None,
        None,
    )
    case.mark, case.demand, case.code = PLAIN, "$^", None
    case.md = put(case.md, f"$MA_NUM_ENCS[{case.axis}]", "2")
    case.eec = replace_eec(case.eec, case.axis, "")
    for other in (0, 1):
        case.md = put(case.md, f"$MA_ENC_COMP_ENABLE[{other},{case.axis}]", "0")
        case.md = put(case.md, f"$MA_MM_ENC_COMP_MAX_POINTS[{other},{case.axis}]", "40")
        case.md = put(case.md, f"$MA_BACKLASH[{other},{case.axis}]", "0")
    case.may_refuse("MD30200|NUM_ENCS|measuring system|encoder|system|no table|ENC_COMP")


def both_are_on(case: Case, rng: np.random.Generator) -> None:
    """Both measuring systems hold an acting table; the PLC uses the one that the job names, or that
    nobody names.
    """
    stale_table_in_the_idle_system(case, rng)
    for e in (0, 1):
        case.md = put(case.md, f"$MA_ENC_COMP_ENABLE[{e},{case.axis}]", "1")
    case.active = case.enabled = None
    case.mark, case.demand, case.code = PLAIN, "$^", None
    case.job_system = case.system + 1 if rng.random() < 0.5 else None
    if case.job_system is None:
        case.must_refuse("measuring system|MD32700|encoder|system")


def names_without_their_table(case: Case, rng: np.random.Generator) -> None:
    """X1 in one file, AX1 in the other, and MD10000 was not exported."""
    known_by_two_names(case, rng)
    case.truth = [case.md, case.eec]
    case.files = {"MD.INI": without(case.md, "MACHAX_NAME_TAB"), "AX_EEC.INI": case.eec}
    case.may_refuse(rf"MD10000|MACHAX|{NAMES[case.axis]}\b|{case.axis}\b")


# -- what is special: to be refused
# -----------------------------------------------------------------------------------------------


def pair_without_a_sign(case: Case, rng: np.random.Generator) -> None:
    ask_for_a_pair(case, rng)
    del case.options["cec_sign"]
    case.must_refuse("cec_sign", 2)


def loader_without_an_answer(case: Case, rng: np.random.Generator) -> None:
    """A loader that leaves the switch to the operator, with values: did it act?"""
    case.nonzero = True
    case.active, case.enabled = None, bool(rng.random() < 0.5)
    last = "0" if rng.random() < 0.6 else None
    text = loader(case, rng, last)
    if last is None:
        text = without(text, "ENC_COMP_ENABLE")
    case.files = {"G_LAS.MPF": text}
    case.truth = [case.md, text]
    case.must_refuse("active", 2)


def gantry_unnamed(case: Case, rng: np.random.Generator) -> None:
    make_gantry(case)
    case.gantry = None
    case.must_refuse("gantry|MD37100")


def wrong_kind(case: Case, rng: np.random.Generator) -> None:
    """The job says linear of an axis that MD30300 calls rotary, or the other way round."""
    case.kind = "linear" if case.rotary else "rotary"
    case.must_refuse("MD30300|IS_ROT_AX|kind")


def no_such_system(case: Case, rng: np.random.Generator) -> None:
    """The job asks for measuring system 2 of an axis that has one (MD30200)."""
    case.md = put(case.md, f"$MA_NUM_ENCS[{case.axis}]", "1")
    case.system, case.job_system = 0, 2
    case.must_refuse("MD30200|NUM_ENCS|measuring system|system")


def no_such_axis(case: Case, rng: np.random.Generator) -> None:
    case.address = "AX9"
    case.must_refuse("AX9")


def pair_of_others(case: Case, rng: np.random.Generator) -> None:
    """The job offers tables that belong to other axes (2 and 3 hold X over Y and X over Z)."""
    ask_for_a_pair(case, rng)
    case.options["cec_tables"] = "[1, 5]" if case.axis == "AX1" else "[3, 4]"
    case.written_tables = set()
    case.must_refuse(r"table\D{0,30}\b[1345]\b|cec_tables|AN_CEC")


def pair_beside_a_sleeper(case: Case, rng: np.random.Generator) -> None:
    """MD32710 is 0; switching it on for the new pair would wake a table of 100 µm whose SD41300 is
    on.
    """
    ask_for_a_pair(case, rng)
    other = "AX3" if case.axis != "AX3" else "AX1"
    assert case.cec is not None
    case.cec = replace_cec(
        case.cec, 11, cec_lines(11, other, case.axis, TRAVELS[other][0], 100, [0.1, 0.1, 0.1, 0.0])
    )
    case.md = put(put(case.md, "$MN_MM_CEC_MAX_POINTS[11]", "5"), "$SN_CEC_TABLE_ENABLE[11]", "1")
    case.md = put(case.md, f"$MA_CEC_ENABLE[{case.axis}]", "0")
    case.must_refuse(r"MD32710|SD41300|CEC_ENABLE|\b11\b")


def units_that_disagree(case: Case, rng: np.random.Generator) -> None:
    """The machine data say inch (MD10240 = 0), the lines of the files METRIC."""
    case.md = put(case.md, "$MN_SCALING_SYSTEM_IS_METRIC", "0")
    case.must_refuse("inch|MD10240|SCALING_SYSTEM|METRIC")
    if case.rotary:
        case.mark = ANSWERABLE


# Beside the random ones, by name only: they stand outside the list so that the seeds keep their
# jobs.


def loader_beside_the_machine_data(case: Case, rng: np.random.Generator) -> None:
    """MD32700 = 1 in the machine data, and a loader with values that ends with 0: which was later
    is not known.
    """
    case.nonzero, case.enabled = True, bool(rng.random() < 0.5)
    case.files = {"MD.INI": case.md, "G_LAS.MPF": loader(case, rng, "0")}
    case.files["MD.INI"] = case.md
    case.must_refuse("active|MD32700|ENC_COMP_ENABLE")


def job_names_the_idle_system(case: Case, rng: np.random.Generator) -> None:
    """Only system 2 is switched on, the job says that system 1 is in use, and so it is: nothing
    acts yet.
    """
    case.system, case.job_system = 0, 1
    case.md = put(case.md, f"$MA_MM_ENC_COMP_MAX_POINTS[0,{case.axis}]", "40")
    case.may_refuse("system|MD32700|encoder")


def pair_without_room(case: Case, rng: np.random.Generator) -> None:
    """Free tables are given for a pair, and MD18342 reserves nothing for them."""
    ask_for_a_pair(case, rng)
    for t in (9, 10):
        case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", "0")
    case.may_refuse("MD18342|MM_CEC_MAX_POINTS")


SPECIALS: tuple[tuple[Special, int], ...] = (
    (nothing, 8),
    (known_by_two_names, 4),
    (half_by_name, 1),
    (sleeping_table_over_itself, 4),
    (sleeping_tables_of_others, 3),
    (others_act_between_others, 4),
    (loader_that_switches_on, 3),
    (the_makers_program, 2),
    (stated_active, 4),
    (zero_and_silent, 2),
    (state_none, 2),
    (stale_table_in_the_idle_system, 4),
    (other_control, 5),
    (inch_control, 5),
    (table_over_itself, 4),
    (table_over_itself_without_a_sign, 1),
    (pair_is_wanted, 4),
    (backlash_factor, 2),
    (dynamic_backlash, 2),
    (temperature, 3),
    (another_axis_moves_this_one, 3),
    (few_points, 2),
    (turned_reference, 2),
    (gantry_named, 2),
    (neither_is_on, 2),
    (both_are_on, 2),
    (names_without_their_table, 2),
    (pair_without_a_sign, 1),
    (loader_without_an_answer, 1),
    (gantry_unnamed, 1),
    (wrong_kind, 1),
    (no_such_system, 1),
    (no_such_axis, 1),
    (pair_of_others, 1),
    (pair_beside_a_sleeper, 1),
    (units_that_disagree, 1),
)


def case_of(seed: int) -> Case:
    """The job of one seed: an axis, its measuring system and table, the form of the texts, and for
    most something special.
    """
    rng = np.random.default_rng([840, seed])
    case = start(seed, rng)
    chosen = [special for special, weight in SPECIALS for _ in range(weight)]
    special = chosen[int(rng.integers(len(chosen)))]
    case.told.append(special.__name__)
    special(case, rng)
    if case.files is None and not case.none:
        style(case, rng)
    return case


def named(special: Special, seed: int = 0, axis: str = "AX1") -> Case:
    """One special case on a fixed axis, system 2 in use, an old table acting."""
    rng = np.random.default_rng([841, seed])
    case = start(seed, rng, axis=axis, kind=("second", "on"))
    case.told.append(special.__name__)
    special(case, rng)
    return case
