"""More that is special about a job on a real SINUMERIK archive: what acts beside the table, units,
steps that do not divide, gantries, containers; each with its mark by the manuals.

What acted while the test was taken and acts the same afterwards, its registers untouched, is in the
readings before and after and cancels: a table must be written, whatever the sign of CEC is.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np

import sinumerik_archive as archive
from backup_cases_sinumerik import ROTARY, TRAVELS, Case, smooth
from backup_variations_sinumerik import (
    Special,
    ask_for_a_pair,
    inch_control,
    loader,
    make_gantry,
    own_table,
)
from sinumerik_archive import cec_lines, eec_lines, number, put, replace_cec, replace_eec, without
from sinumerik_container import BLOCK, Packing

OTHERS = {"AX1": "AX3", "AX2": "AX1", "AX3": "AX2", "AX4": "AX2", "AX5": "AX1"}


# -- tables of the builder that put out on the axis
# --------------------------------------------------------------------------------------------------


def into_the_axis(
    case: Case,
    rng: np.random.Generator,
    t: int,
    inputs: str,
    *,
    direction: int = 0,
    product: int = 0,
    scale: float = 1.0,
) -> None:
    """A table of five to nine points, up to 20 µm (arcsec) times ``scale``, switched on."""
    low, high = case.travel if inputs == case.axis else TRAVELS[inputs]
    count = int(rng.integers(5, 10))
    step = (high - low) / (count - 1)
    values = np.round(scale * case.unit * rng.uniform(-20, 20, count), 6)
    assert case.cec is not None
    lines = cec_lines(
        t, inputs, case.axis, low, step, list(values), direction=direction, product=product
    )
    case.cec = replace_cec(case.cec, t, lines)
    case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", str(count + 2))
    case.md = put(case.md, f"$SN_CEC_TABLE_ENABLE[{t}]", "1")
    case.md = put(case.md, f"$MA_CEC_ENABLE[{case.axis}]", "1")
    if inputs != case.axis:
        case.positions[inputs] = float(rng.uniform(low, high))
    case.cec_sign = float(rng.choice([1, -1]))


def say_the_sign(case: Case) -> None:
    case.options["cec_sign"] = "correction" if case.cec_sign > 0 else "error"


def builders_tables_into_the_axis(case: Case, rng: np.random.Generator) -> None:
    """Sag and swivel: from another axis, from the axis itself, weighted, of one direction."""
    into_the_axis(case, rng, 11, OTHERS[case.axis])
    if rng.random() < 0.6:
        into_the_axis(case, rng, 12, case.axis, scale=0.3)
    if rng.random() < 0.3:
        into_the_axis(case, rng, 13, OTHERS[case.axis], direction=int(rng.choice([1, -1])))
    case.md = put(case.md, "$SN_CEC_TABLE_WEIGHT[11]", str(rng.choice(["1", "0.5", "-1"])))
    if rng.random() < 0.5:
        say_the_sign(case)


def products_into_the_axis(case: Case, rng: np.random.Generator) -> None:
    """A table is multiplied by another one; whether it adds its own value too is on no page."""
    other = OTHERS[case.axis]
    one, two = ((other, case.axis), (case.axis, other), (case.axis, case.axis))[
        int(rng.integers(3))
    ]
    into_the_axis(case, rng, 11, one, product=13, scale=0.4)
    into_the_axis(case, rng, 12, two, scale=0.4)
    if rng.random() < 0.5:
        case.md = put(case.md, "$SN_CEC_TABLE_ENABLE[12]", "0")
    case.own_beside_product = bool(rng.random() < 0.5)
    if rng.random() < 0.3:
        say_the_sign(case)


def odd_tables_into_the_axis(case: Case, rng: np.random.Generator) -> None:
    """SD41320, SD41321, a cylinder error table, or a step that does not divide, on a builder's
    table.
    """
    case.point_beyond = bool(rng.random() < 0.5)
    inputs = str(rng.choice([case.axis, OTHERS[case.axis]]))
    into_the_axis(case, rng, 11, inputs, scale=0.3)
    make_odd(case, rng, 11, case.unit * 4)
    if rng.random() < 0.3:
        say_the_sign(case)


def make_odd(case: Case, rng: np.random.Generator, t: int, size: float) -> str:
    """One thing that makes table ``t`` no ordinary curve; its name as a refusal must bear it."""
    assert case.cec is not None
    which = int(rng.integers(4))
    if which < 2:
        case.md = put(case.md, f"$SN_CEC_{which}[{t}]", number(size))
        return rf"SD4132{which}|SN_CEC_{which}"
    if which == 2:
        case.cec = put(case.cec, f"$AN_CEC_TYPE[{t}]", "1")
        return "CEC_TYPE"
    found = re.search(rf"\$AN_CEC_STEP\[{t}\]=(\S+)", case.cec)
    assert found is not None
    case.cec = put(case.cec, f"$AN_CEC_STEP[{t}]", number(float(found[1]) * 0.93))
    return "CEC_STEP|CEC_MAX|spacing|divide|multiple"


def odd_tables_of_others(case: Case, rng: np.random.Generator) -> None:
    """The same on tables between other axes."""
    other = OTHERS[case.axis]
    low, high = TRAVELS[other]
    assert case.cec is not None
    for t in (11, 12):
        case.cec = replace_cec(
            case.cec, t, cec_lines(t, other, other, low, (high - low) / 4, [0, 0.02, 0, -0.01, 0])
        )
        case.md = put(case.md, f"$MN_MM_CEC_MAX_POINTS[{t}]", "6")
        case.md = put(case.md, f"$SN_CEC_TABLE_ENABLE[{t}]", "1")
        make_odd(case, rng, t, 0.004)


def limited_sum(case: Case, rng: np.random.Generator) -> None:
    """MD32720 clips what the builder's tables give: the same before and after."""
    into_the_axis(case, rng, 11, str(rng.choice([case.axis, OTHERS[case.axis]])))
    case.md = put(case.md, f"$MA_CEC_MAX_SUM[{case.axis}]", number(4 * case.unit))
    if rng.random() < 0.3:
        say_the_sign(case)


def own_odd_table(case: Case, rng: np.random.Generator) -> None:
    """The table that the job gives to be written acts, and is no ordinary curve: what it did in the
    readings is not known.
    """
    own_table(case, rng, 0, 9)
    case.cec_sign = float(rng.choice([1, -1]))
    say_the_sign(case)
    case.options |= {"cec": "available", "cec_tables": "[9, 10]"}
    case.must_refuse(make_odd(case, rng, 9, 4 * case.unit))


def own_product(case: Case, rng: np.random.Generator) -> None:
    """The table that the job gives to be written is multiplied by another one."""
    into_the_axis(case, rng, 11, OTHERS[case.axis])
    own_table(case, rng, 0, 9)
    assert case.cec is not None
    case.cec = put(case.cec, "$AN_CEC_MULT_BY_TABLE[9]", "12")
    say_the_sign(case)
    case.options |= {"cec": "available", "cec_tables": "[9, 10]"}
    case.must_refuse("MULT_BY_TABLE")


# -- steps that do not divide the range
# --------------------------------------------------------------------------------------------------


def nearly_dividing_step(case: Case, rng: np.random.Generator) -> None:
    """A tool rounded STEP to four places: 19.7436 for 770 / 39."""
    low, high = case.travel
    count = min(case.grid[2], 40)
    if case.modulo:
        return
    exact = (high - low) / (count - 1)
    step = next(
        s
        for s in (round(exact, 4), round(exact + 1e-4, 4))
        if abs((high - low) / s - count + 1) < 9e-4
    )
    case.grid = (low, step, count)
    values = smooth(case, rng) if case.nonzero else np.zeros(count)
    lines = eec_lines(case.axis, case.system, low, step, list(values), modulo=False)
    case.eec = replace_eec(case.eec, case.axis, lines)
    case.eec = put(case.eec, f"$AA_ENC_COMP_MAX[{case.system},{case.axis}]", number(high))


def step_that_does_not_divide(case: Case, rng: np.random.Generator) -> None:
    """850 by 100: whether the point beyond MAX counts is on no page; it matters where the last two
    differ.
    """
    low, high = case.travel
    count = case.grid[2]
    if case.modulo:
        return
    kind = str(rng.choice(["differ", "same", "zero"]))
    case.point_beyond = bool(rng.random() < 0.5)
    step = (high - low) / (count - 1.5)
    case.grid = (low, round(step, 3), count)
    if kind == "zero":
        case.nonzero = False
    values = smooth(case, rng) if case.nonzero else np.zeros(count)
    if kind == "same":
        values[-1] = values[-2]
    elif case.nonzero:
        values[-1] = values[-2] + 6 * case.unit
    lines = eec_lines(case.axis, case.system, low, case.grid[1], list(values), modulo=False)
    case.eec = replace_eec(case.eec, case.axis, lines)
    case.eec = put(case.eec, f"$AA_ENC_COMP_MAX[{case.system},{case.axis}]", number(high))
    if case.nonzero and kind == "differ" and case.active not in {"no", "false"}:
        case.must_refuse("ENC_COMP_STEP|ENC_COMP_MAX|spacing|divide|multiple")


def odd_step_of_a_neighbour(case: Case, rng: np.random.Generator) -> None:
    other = OTHERS[case.axis]
    values = [0.003, -0.002, 0.004, 0.001]
    case.eec = replace_eec(
        case.eec, other, eec_lines(other, 1, TRAVELS[other][0], 97.3, values, modulo=False)
    )
    top = TRAVELS[other][0] + 250
    case.eec = put(case.eec, f"$AA_ENC_COMP_MAX[1,{other}]", number(top))


def stale_points_behind_the_end(case: Case, rng: np.random.Generator) -> None:
    """Values behind MAX are ignored."""
    count = case.grid[2]
    reserved = count + 6
    for e, points in ((case.system, reserved),):
        case.md = put(case.md, f"$MA_MM_ENC_COMP_MAX_POINTS[{e},{case.axis}]", str(reserved))
        del points
    own = rf"\$AA_ENC_COMP\[{case.system},(\d+),{case.axis}\]"
    case.eec = without(
        case.eec, re.compile(rf"\$AA_ENC_COMP\[{case.system},({count}|{count}\d),{case.axis}\]")
    )
    there = {int(found[1]) for found in re.finditer(own, case.eec)}
    for n in range(count, reserved):
        register = f"$AA_ENC_COMP[{case.system},{n},{case.axis}]"
        if n in there:
            case.eec = put(case.eec, register, "0.05")
        else:
            case.eec = case.eec.replace(
                f"$AA_ENC_COMP_STEP[{case.system},{case.axis}]",
                f"{register}=0.05\n$AA_ENC_COMP_STEP[{case.system},{case.axis}]",
                1,
            )


# -- units
# --------------------------------------------------------------------------------------------------


def inch_with_builders_tables(case: Case, rng: np.random.Generator) -> None:
    """An inch control; a builder's table into the axis counts by MD32711, whichever it says."""
    into_the_axis(case, rng, 11, str(rng.choice([case.axis, OTHERS[case.axis]])), scale=0.3)
    kept = case.cec
    inch_control(case, rng)
    case.cec = None if kept is None else archive.in_inch(kept, ROTARY)
    if case.files is not None and case.cec is not None:
        case.files["NC_CEC.INI"] = case.cec
        assert case.truth is not None
        case.truth.append(case.cec)
    word = str(rng.choice(["0", "1"]))
    register = f"$MA_CEC_SCALING_SYSTEM_METRIC[{case.axis}]"
    case.md = put(case.md, register, word)
    if case.files is not None:
        case.files["MD.INI"] = put(case.files["MD.INI"], register, word)
        case.truth = [case.md, *list(case.truth or [])[1:]]


def pair_in_inches(case: Case, rng: np.random.Generator) -> None:
    """A pair is wanted where MD32711 counts in inches."""
    ask_for_a_pair(case, rng)
    case.md = put(case.md, f"$MA_CEC_SCALING_SYSTEM_METRIC[{case.axis}]", "0")
    case.must_refuse("MD32711|CEC_SCALING_SYSTEM_METRIC")
    if case.rotary:
        case.mark = "answerable"


def inch_said_by_the_job(case: Case, rng: np.random.Generator) -> None:
    """No file says the basic system; the job's option does."""
    if case.rotary:
        return
    case.md = put(archive.in_inch(case.md, ROTARY), "$MN_SCALING_SYSTEM_IS_METRIC", "0")
    case.eec, case.cec = archive.in_inch(case.eec, ROTARY), None
    case.truth = [case.md, case.eec]
    silent = without(case.md, "SCALING_SYSTEM_IS_METRIC")
    case.files = {
        "MD.INI": without(silent, re.compile(r"^INCH$")),
        "AX_EEC.INI": without(case.eec, re.compile(r"^INCH$")),
    }
    case.options["units"] = "inch"


def units_against_the_files(case: Case, rng: np.random.Generator) -> None:
    case.options["units"] = "inch"
    case.must_refuse("units|inch|MD10240|SCALING_SYSTEM|METRIC")
    if case.rotary:
        case.mark = "answerable"


def inch_of_another_length(case: Case, rng: np.random.Generator) -> None:
    inch_control(case, rng)
    case.md = put(case.md, "$MN_SCALING_VALUE_INCH", "25")
    if case.files is not None:
        case.files["MD.INI"] = put(case.files["MD.INI"], "$MN_SCALING_VALUE_INCH", "25")
    case.must_refuse("MD10250|SCALING_VALUE_INCH")
    if case.rotary:
        case.mark = "answerable"


def units_of_the_users_own(case: Case, rng: np.random.Generator) -> None:
    """MD10220: positions or compensation values in units of the user's own."""
    word = str(rng.choice(["'H1'", "'H800'"] if not case.rotary else ["'H2'", "'H1000'"]))
    case.md = put(case.md, "$MN_SCALING_USER_DEF_MASK", word)
    case.must_refuse("MD10220|SCALING_USER_DEF_MASK")


# -- gantry, words, limits
# --------------------------------------------------------------------------------------------------


def work_on_the_follower(case: Case, rng: np.random.Generator) -> None:
    """The job works on the synchronised axis and names no leading one."""
    make_gantry(case)
    follower = case.gantry
    assert follower is not None
    for address, word in ((case.axis, "11"), (follower, "1")):
        case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{address}]", word)
    case.gantry = None
    case.must_refuse("gantry|MD37100")


def second_gantry(case: Case, rng: np.random.Generator) -> None:
    """Grouping 2 (2 leads, 12 follows), named by the job."""
    make_gantry(case)
    assert case.gantry is not None
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{case.axis}]", "2")
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{case.gantry}]", "12")


def gantry_of_others(case: Case, rng: np.random.Generator) -> None:
    one, two = [axis for axis in ("AX1", "AX2", "AX3") if axis != case.axis][:2]
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{one}]", "1")
    case.md = put(case.md, f"$MA_GANTRY_AXIS_TYPE[{two}]", "11")


def words_for_numbers(case: Case, rng: np.random.Generator) -> None:
    """TRUE and FALSE in all that is a BOOL."""
    word = {"1": "TRUE", "0": "FALSE"}
    flags = re.compile(r"(\$A[AN]_(?:ENC_COMP|CEC)_IS_MODULO\[[^\]]*\])=([01])$", re.MULTILINE)
    case.eec = flags.sub(lambda found: f"{found[1]}={word[found[2]]}", case.eec)
    assert case.cec is not None
    case.cec = flags.sub(lambda found: f"{found[1]}={word[found[2]]}", case.cec)
    switches = re.compile(r"(_ENABLE\[[^\]]*\])=([01])$", re.MULTILINE)
    case.md = switches.sub(lambda found: f"{found[1]}={word[found[2]]}", case.md)


def limits_told_from_the_other_end(case: Case, rng: np.random.Generator) -> None:
    """MD36100 and MD36110 bound a travel on the other side of zero."""
    if case.rotary:
        return
    low, high = case.travel
    case.md = put(case.md, f"$MA_POS_LIMIT_MINUS[{case.axis}]", number(-high - 0.5))
    case.md = put(case.md, f"$MA_POS_LIMIT_PLUS[{case.axis}]", number(-low + 0.5))
    case.must_refuse("MD361|POS_LIMIT|software limit")


# -- containers
# --------------------------------------------------------------------------------------------------


def programs_in_the_container(case: Case, rng: np.random.Generator) -> None:
    """Programs that load tables of 100 µm and switch them stand beside: they are no state."""
    text = loader(replace(case), rng, "0").replace("]=0.0", "]=0.1").encode("latin-1")
    case.packing = Packing(
        programs=(
            ("\\MPF.DIR\\", "LOAD.MPF", text),
            ("\\WKS.DIR\\K.WPD\\", "AX_EEC.INI", text),
            ("\\CMA.DIR\\", "SWITCH.SPF", b"$SN_CEC_TABLE_ENABLE[9]=1\nM17\n"),
        ),
        marks=bool(rng.random() < 0.5),
    )


def small_files_over_the_container(case: Case, rng: np.random.Generator) -> None:
    """The archive of before, and small files that were loaded since: these say what acts."""
    e, axis = case.system, case.axis
    case.packing = Packing()
    own = re.compile(rf"\$AA_ENC_COMP\w*\[{e},(?:\d+,)?{axis}\]")
    lines = [line for line in case.eec.splitlines(keepends=True) if own.search(line)]
    case.over = {"LAST_EEC.INI": "METRIC\nCHANDATA(1)\n" + "".join(lines) + "M17\n"}
    low, step, count = case.grid
    older = list(smooth(case, rng))
    case.eec = replace_eec(case.eec, axis, eec_lines(axis, e, low, step, older, modulo=case.modulo))
    assert len(older) == count
    if rng.random() < 0.5:
        found = re.search(rf"\$MA_BACKLASH\[{e},{axis}\]=(\S+)", case.md)
        assert found is not None
        case.over["LAST_MD.INI"] = f"CHANDATA(1)\n$MA_BACKLASH[{e},{axis}]={found[1]}\nM17\n"
        case.md = put(case.md, f"$MA_BACKLASH[{e},{axis}]", number(7 * case.unit))


def _edited(whole: bytes) -> bytes:
    return whole.replace(b"CHANDATA(1)", b"CHANDATA(10)", 1)


def _cut(whole: bytes) -> bytes:
    return whole[: len(whole) - 3 * BLOCK]


def _header_sum(whole: bytes) -> bytes:
    at = whole.index(b"_N_INITIAL_INI") + 148
    return whole[:at] + (b"1" if whole[at : at + 1] != b"1" else b"2") + whole[at + 1 :]


def damaged_container(case: Case, rng: np.random.Generator) -> None:
    """Edited with a text editor, cut short, a header that is wrong."""
    damage = (_edited, _cut, _header_sum)[int(rng.integers(3))]
    case.packing = Packing(damage=damage)
    case.must_refuse(r"INI\b|cut short|edited|check ?sum|header", 3)


def copies_that_differ(case: Case, rng: np.random.Generator) -> None:
    """A member twice, and not the same: which one counts is not known."""
    case.packing = Packing(copies=("AX_EEC.INI",), damage=None)
    whole = case.packing.packed({"MD.INI": case.md, "AX_EEC.INI": case.eec, "NC_CEC.INI": "M17\n"})
    at = whole.rindex(b"_N_AX_EEC_INI") + BLOCK
    point = re.compile(rb"\$AA_ENC_COMP\[\d,\d+,\w+\]=0(?=\r?\n)").search(whole, at)
    assert point is not None
    content = whole[: point.end() - 1] + b"1" + whole[point.end() :]
    case.packing = replace(case.packing, damage=lambda _: content)
    case.must_refuse(r"AX_EEC\.INI")


def pair_of_the_828d(case: Case, rng: np.random.Generator) -> None:
    """828D: eight tables, 0 to 7; the job names 9 and 10."""
    ask_for_a_pair(case, rng)
    case.format = "siemens-828d"
    case.must_refuse("cec_tables|0 to 7|8 CEC tables")


def renamed(case: Case, rng: np.random.Generator) -> None:
    """The axis has another name, letters and digits; table and job use it or the other one."""
    index = int(case.axis[2:]) - 1
    name = str(rng.choice(["MX1", "Q5", "XL", "TISCH"]))
    case.md = re.sub(rf"(\$MN_AXCONF_MACHAX_NAME_TAB\[{index}\]=)\"\w*\"", rf'\1"{name}"', case.md)
    if rng.random() < 0.6:
        case.eec = re.sub(rf"\b{case.axis}\]", f"{name}]", case.eec)
    case.address = name if rng.random() < 0.5 else case.axis


ACTIVE: tuple[tuple[Special, int], ...] = (
    (builders_tables_into_the_axis, 6),
    (products_into_the_axis, 4),
    (odd_tables_into_the_axis, 4),
    (odd_tables_of_others, 2),
    (limited_sum, 2),
    (own_odd_table, 2),
    (own_product, 1),
    (nearly_dividing_step, 3),
    (step_that_does_not_divide, 3),
    (odd_step_of_a_neighbour, 2),
    (stale_points_behind_the_end, 2),
    (inch_with_builders_tables, 3),
    (pair_in_inches, 1),
    (inch_said_by_the_job, 2),
    (units_against_the_files, 1),
    (inch_of_another_length, 1),
    (units_of_the_users_own, 1),
    (work_on_the_follower, 1),
    (second_gantry, 2),
    (gantry_of_others, 1),
    (words_for_numbers, 2),
    (limits_told_from_the_other_end, 1),
    (programs_in_the_container, 4),
    (small_files_over_the_container, 4),
    (damaged_container, 2),
    (copies_that_differ, 1),
    (pair_of_the_828d, 1),
    (renamed, 2),
)
