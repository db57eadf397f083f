"""Lists of an ISG kernel and scripts of a PMAC as they may be found, as `same_controls.py` has the
files of the other controls. Written here from the pages of the makers, not by the package.
"""

from __future__ import annotations

import numpy as np
from same_machines import MachineAxis, OldTable, Rng

#: mm or deg of one value in a list whose unit is 1, and of all positions in it.
ISG_UNIT = 1e-4
#: A value of a PMAC table is so many parts of a count.
PARTS = 16


def isg_lists(rng: Rng, axes: list[MachineAxis], *, meaning: str, acts: bool) -> dict[str, str]:
    """A list for each axis: one column or two, positions listed or at an interval, switched off by
    the list or by the axis parameters; sometimes a cross-axis table and the start-up list.
    """
    files: dict[str, str] = {}
    for axis in axes:
        lines = [f"# axis {axis.name}, from the last service", f"kopf.achs_nr {axis.address}"]
        lines += [f"kopf.log_achs_name {axis.name}"] if rng.random() < 0.5 else []
        parameters = []
        if axis.old is not None:
            by_list = rng.random() < 0.5
            lines += _isg_table(rng, axis, axis.old, meaning, manual=not acts and by_list)
            if not acts and not by_list:
                parameters.append("lr_param.ssfk 0")
            elif rng.random() < 0.4:
                parameters.append("lr_param.ssfk 1")
        if rng.random() < 0.1:
            lines += _isg_cross(rng, axes, axis)
        text = "\n".join([*lines, ""])
        files[f"achskw{axis.address}.lis"] = (
            text.replace("\n", "\r\n") if rng.random() < 0.4 else text
        )
        if parameters:
            head = [f"kopf.achs_nr {axis.address}", "achs_typ 0x0001"]
            files[f"achsmds{axis.address}.lis"] = "\n".join([*head, *parameters, ""])
    if rng.random() < 0.25:
        rows = [f"zahl_kw {len(axes)}"]
        for place, axis in enumerate(axes):
            rows += [f"achs_kw_log_ax_nr[{place}] {axis.address}"]
            rows += [f"achs_kw[{place}] achskw{axis.address}.lis"]
        files["hochlauf.lis"] = "\n".join([*rows, ""])
    return files


def _isg_table(
    rng: Rng, axis: MachineAxis, old: OldTable, meaning: str, *, manual: bool
) -> list[str]:
    sign = -1 if meaning == "error" else 1
    shift = old.backlash if axis.home < 0 else 0.0
    two = old.backlash != 0.0 or rng.random() < 0.8
    places = np.round((old.start + old.step * np.arange(old.values.size)) / ISG_UNIT)
    listed = rng.random() < 0.7
    keys = {
        "unit": 1,
        "interval": 0 if listed else f"{old.step / ISG_UNIT:.10g}",
        "kw_startpos": f"{places[0]:.0f}",
        "kw_nr_max": places.size,
        "bilateral": int(two),
        "modulo": int(axis.endless),
    }
    keys |= {"max_points": 400} if rng.random() < 0.3 else {}
    keys |= {"manual_activation": int(manual)} if manual or rng.random() < 0.3 else {}
    lines = [f"kw.ssfk.{key:<25} {value}" for key, value in keys.items()]
    for index, (place, total) in enumerate(zip(places, old.values, strict=True)):
        positive = round(sign * (total + shift) / ISG_UNIT)
        negative = round(sign * (total + shift - old.backlash) / ISG_UNIT)
        row = f"kw.ssfk.table[{index}]"
        lines += [f"{row}.setpoint  {place:.0f}"] if listed else []
        lines += [f"{row}.pos       {positive}"]
        lines += [f"{row}.neg       {negative}"] if two else []
    return lines


def _isg_cross(rng: Rng, axes: list[MachineAxis], axis: MachineAxis) -> list[str]:
    """A table of another axis on this one."""
    other = next((one.address for one in axes if one is not axis), "9")
    lines = ["kw.crosscomp.unit 1", f"kw.crosscomp.master_ax_nr {other}"]
    lines += ["kw.crosscomp.last_index 2"]
    for index, place in enumerate((0, 1_000_000, 2_000_000)):
        lines += [f"kw.crosscomp.table[{index}].setpoint {place}"]
        lines += [f"kw.crosscomp.table[{index}].correction {int(rng.integers(-30, 30))}"]
    return lines


def pmac_scripts(rng: Rng, axes: list[MachineAxis], *, counts: float, acts: bool) -> dict[str, str]:
    """One script, or one for each motor: tables that wrap at their length, backlash with its rate,
    sometimes one that varies with the position.
    """
    unit = 1.0 / (PARTS * counts)
    scripts: dict[str, list[str]] = {}
    together = rng.random() < 0.6
    for axis in axes:
        old, motor = axis.old, axis.address
        lines = scripts.setdefault("comp.pmc" if together else f"motor{motor}.pmc", [])
        if old is None:
            lines += [f"I{motor}86=0"] if rng.random() < 0.5 else []
            continue
        count = old.values.size - 1
        if abs(old.start / old.step - round(old.start / old.step)) > 1e-9:
            axis.old = None  # such a table has an entry at 0 of the motor
            continue
        turn = -round(old.start / old.step)
        # It ends as it began, and is 0 at 0.
        ramp = np.linspace(0.0, old.values[-1] - old.values[0], count + 1)
        values = np.round((old.values - ramp) / unit)
        old.values = np.asarray(unit * (values - values[turn % count]), dtype=np.float64)
        length = round(count * old.step * abs(counts))
        # Entry k is for k steps, the last one for 0 too.
        entries = np.roll(old.values[:-1], -turn - 1)
        numbers = [str(round(float(value) / unit)) for value in entries]
        lines += [f"; motor {motor}, {axis.name}"] if rng.random() < 0.5 else []
        lines += [f"#{motor} DEFINE COMP {count},#{motor}D,{length}"]
        lines += [" ".join(numbers[n : n + 8]) for n in range(0, count, 8)]
        if rng.random() < 0.15:
            lines += [f"#{motor} DEFINE BLCOMP {count},{length}", " ".join(["0"] * count)]
        lines += [f"I{motor}85=32", f"I{motor}86={round(old.backlash / abs(unit))}"]
    switch = [f"I51={int(acts)}"] if not acts or rng.random() < 0.85 else []
    first = next(iter(scripts))
    scripts[first] = (
        [*switch, *scripts[first]] if rng.random() < 0.5 else [*scripts[first], *switch]
    )
    return {name: "\n".join([*lines, ""]) for name, lines in scripts.items()}
