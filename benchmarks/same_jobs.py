"""Random jobs, one folder each: tests, files of the control, a job file, and the commands that are
run on it. The same control and seed give the same bytes.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import same_controls as controls
import same_isg_pmac as lists
import yaml
from same_machines import Floats, MachineAxis, Rng, circle_csv, positioning_csv, random_axis

#: Name of a deal -> format; behind + what is special.
DEALS = {
    "fanuc-30i": "fanuc-30i",
    "fanuc-0i-16i": "fanuc-0i-16i",
    "heidenhain-itnc530": "heidenhain-itnc530",
    "heidenhain-nck": "heidenhain-nck",
    "siemens-840d-sl": "siemens-840d-sl",
    "siemens-840d-sl+cec": "siemens-840d-sl",
    "linuxcnc": "linuxcnc",
    "isg-kernel": "isg-kernel",
    "pmac": "pmac",
    **{name: name for name in ("fanuc-0i-d", "fanuc-0i-f", "fanuc-15i")},
    **{name: name for name in ("siemens-828d", "siemens-840d-pl", "siemens-one")},
}
#: Whose parameters stand without ``Q1``.
WITHOUT_Q = ("fanuc-0i-16i", "fanuc-15i")
LETTERS = "XYZABC"
STANDARDS = ["iso230-2:1988", "iso230-2:1997", "iso230-2:2006", "gost27843:2006", "vdi3441"]
#: One job in so many has a fault put in.
FAULTY = 8
Words = dict[str, Any]


def write_random_job(deal: str, seed: int, folder: Path) -> None:
    """Write the files of one job, with ``commands.json`` and ``truth.json`` beside them."""
    rng = np.random.default_rng([seed, *deal.encode()])
    format_id = DEALS[deal]
    axes = _axes(rng, format_id)
    options = _options(rng, deal, axes)
    state, files = _state(rng, format_id, axes, options)
    job: Words = {
        "compwright": 1,
        "controller": {"format": format_id, "options": options},
        "states": {"as_found": state},
        "axes": {},
    }
    if not options and rng.random() < 0.5:
        del job["controller"]["options"]
    for axis in axes:
        job["axes"][axis.name] = _axis_words(rng, job, axis, files)
    _whole(rng, job, axes, files)
    files = {name: content.encode() for name, content in files.items()}  # type: ignore[misc]
    if rng.integers(FAULTY) == 0:
        _fault(rng, job, files)
    text = yaml.safe_dump(job, sort_keys=False, allow_unicode=True)
    if rng.random() < 0.01:
        text = text.replace(": ", ":", 1) + "\tx"
    write_job(folder, files, text, axes, _commands(rng, format_id, job, axes, files))


def write_job(
    folder: Path,
    files: Mapping[str, Any],
    job: str,
    axes: list[MachineAxis],
    commands: list[list[str]],
) -> None:
    """Write a job's folder: its files, ``job.yaml``, what the axes do, and the commands."""
    for name, content in {**files, "job.yaml": job.encode()}.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    truth = {axis.name: _truth(axis) for axis in axes}
    (folder / "truth.json").write_text(json.dumps(truth))
    (folder / "commands.json").write_text(json.dumps(commands))


def _truth(axis: MachineAxis) -> dict[str, Any]:
    """What a test after loading shows without any table, in mm or deg."""
    rng = np.random.default_rng([31, axis.number])
    x = axis.targets(rng)
    none = {1: np.zeros(x.size), -1: np.zeros(x.size)}
    readings = axis.measure(rng, x, none)
    return {
        "unit": "deg" if axis.rotary else "mm",
        "targets": x.tolist(),
        "readings": {str(sign): block.tolist() for sign, block in readings.items()},
    }


def _axes(rng: Rng, format_id: str) -> list[MachineAxis]:
    endless = 0.03 if format_id == "linuxcnc" else 0.6
    count = int(rng.choice([1, 1, 1, 2, 2, 3]))
    places = sorted(rng.choice(6, count, replace=False, p=[0.3, 0.2, 0.2, 0.1, 0.1, 0.1]))
    axes = [
        random_axis(rng, LETTERS[n], controls.ADDRESSES[format_id][n], n + 1, endless)
        for n in map(int, places)
    ]
    for axis in axes:  # of rotary axes these controls use 0 to 360 only
        if format_id.startswith("heidenhain") and axis.travel[0] < 0 and axis.rotary:
            axis.travel = (0.0, 300.0) if rng.random() < 0.9 else axis.travel
    return axes


# --- options
# --------------------------------------------------------------------------------------------------


def _options(rng: Rng, deal: str, axes: list[MachineAxis]) -> Words:
    format_id = DEALS[deal]
    if format_id.startswith("fanuc"):
        return _fanuc_options(rng)
    if format_id.startswith("heidenhain"):
        return _heidenhain_options(rng, format_id)
    if format_id == "isg-kernel":
        signs = ["error", "correction"]
        return _some(rng, {"table_values": (0.4, signs), "cross_values": (0.9, signs)})
    if format_id == "pmac":
        counts = [1000, 10000, 62500]
        return _some(rng, {"counts_per_unit": (0.97, counts), "take_up_rate": (0.2, [8, 64])})
    if format_id == "linuxcnc":
        return _some(rng, {"comp_file_type": (0.5, ["0", "1"]), "units": (0.15, ["mm", "inch"])})
    options = _some(
        rng, {"points": (0.3, [20, 60, 125, 400]), "encoder_system": (0.2, ["auto", "1", "2"])}
    )
    if deal.endswith("+cec"):
        tables = [3, 8, 10, 11, 20, 21, 30, 31][: 2 * len(axes) + int(rng.integers(0, 3))]
        options |= {"cec": "available", "cec_tables": tables}
        options |= {"cec_sign": str(rng.choice(["correction", "error"]))}
        if rng.random() < 0.08:
            del options[str(rng.choice(["cec_sign", "cec_tables"]))]
    elif rng.random() < 0.6:
        options["cec_sign"] = str(rng.choice(["correction", "error"]))
    return options


def _some(rng: Rng, choices: Mapping[str, tuple[float, list[Any]]]) -> Words:
    """Each option by its chance, one of its values."""
    return {
        name: values[int(rng.integers(len(values)))]
        for name, (chance, values) in choices.items()
        if rng.random() < chance
    }


def _fanuc_options(rng: Rng) -> Words:
    return _some(
        rng,
        {
            "detection_unit": (0.95, [0.001, 0.001, 0.0005, 0.0001]),
            "first_point": (0.9, [0, 40, 200]),
            "increment_limit": (0.3, ["7", "127"]),
            "output": (0.35, ["step", "ramp"]),
            "max_feed": (0.2, [10000, 24000, 120000]),
            "pitch_sign": (0.25, ["+", "-"]),
            "offset_sign": (0.15, ["+", "-"]),
            "offset_magnified": (0.15, ["no", "yes"]),
            "straightness": (0.25, ["absent", "available"]),
            "program": (0.3, ["none", "g10"]),
        },
    )


def _heidenhain_options(rng: Rng, format_id: str) -> Words:
    common: dict[str, tuple[float, list[Any]]] = {
        "table_values": (0.4, ["error", "correction"]),
        "max_points": (0.25, [26, 40, 128]),
    }
    if format_id == "heidenhain-nck":
        own: dict[str, tuple[float, list[Any]]] = {
            "backlash_column": (0.3, ["absent", "second_curve"])
        }
    else:
        own = {
            "spacing_rule": (0.25, ["free", "power_of_two"]),
            "method": (0.2, ["table", "line"]),
        }
    return _some(rng, common | own)


# --- what is in the control
# --------------------------------------------------------------------------------------------------


def _state(
    rng: Rng, format_id: str, axes: list[MachineAxis], options: Words
) -> tuple[Any, dict[str, str]]:
    """The word or files of the state as found; the axes get the tables that act."""
    if rng.random() < 0.3:
        return "none", {}
    quantum = 1e-4 if format_id.startswith("heidenhain") else 1e-6
    if format_id.startswith("fanuc"):
        quantum = float(options.get("detection_unit", 0.001))
    if format_id == "pmac":
        quantum = 1.0 / (lists.PARTS * float(options.get("counts_per_unit", 1000)))
    wrong = rng.random() < 0.2
    for axis in axes:
        if rng.random() < (0.97 if format_id == "heidenhain-nck" else 0.9):
            axis.old = controls.old_table(rng, axis, quantum, wrong=wrong)
            if format_id.startswith("fanuc"):
                controls.hold_in_increments(axis, quantum)
    acts = rng.random() < 0.85
    neighbours = [] if rng.random() < 0.6 else _neighbours(rng, format_id, axes, quantum)
    files = _files(rng, format_id, axes + neighbours, options, acts=acts)
    listed = [f"control/{name}" for name in files]
    state: Any = "control" if rng.random() < 0.15 else listed
    said = 0.9 if not acts else 0.15
    open_by_files = format_id.startswith(("siemens", "heidenhain", "isg"))
    if rng.random() < (said if open_by_files else 0.02):
        state = {"files": state, "active": bool(acts) if rng.random() < 0.9 else not acts}
    if not acts:
        for axis in axes:
            axis.old = None
    return state, {f"control/{name}": text for name, text in files.items()}


def _neighbours(
    rng: Rng, format_id: str, axes: list[MachineAxis], quantum: float
) -> list[MachineAxis]:
    taken = {axis.name for axis in axes}
    number, letter = next((n, c) for n, c in enumerate(LETTERS) if c not in taken)
    one = random_axis(rng, letter, controls.ADDRESSES[format_id][number], number + 1)
    one.old = controls.old_table(rng, one, quantum, wrong=False)
    if format_id.startswith("fanuc"):
        controls.hold_in_increments(one, quantum)
    return [one]


def _files(
    rng: Rng, format_id: str, axes: list[MachineAxis], options: Words, *, acts: bool
) -> dict[str, str]:
    meaning = str(options.get("table_values", "error"))
    match format_id.split("-", maxsplit=1)[0], format_id:
        case "siemens", _:
            system = int(rng.random() < 0.3)
            if system and axes[0].old is not None and rng.random() < 0.7:
                for axis in axes:
                    axis.words["encoder"] = {"system": 2}
            enabled = str(rng.choice(["1"] * 9 + [""])) if acts else "0"
            return controls.sinumerik(rng, axes, system, enabled=enabled)
        case "fanuc", _:
            unit = float(options.get("detection_unit", 0.001))
            newer = format_id not in WITHOUT_Q
            return controls.fanuc(rng, axes, newer=newer, unit=unit, acts=acts)
        case _, "heidenhain-itnc530":
            return controls.heidenhain_itnc(rng, axes, meaning=meaning, acts=acts)
        case _, "heidenhain-nck":
            return controls.heidenhain_nck(
                rng,
                axes,
                meaning=meaning,
                acts=acts,
                second_curve=options.get("backlash_column") == "second_curve",
            )
        case "isg", _:
            return lists.isg_lists(rng, axes, meaning=meaning, acts=acts)
        case "pmac", _:
            counts = float(options.get("counts_per_unit", 1000))
            return lists.pmac_scripts(rng, axes, counts=counts, acts=acts)
        case _:
            return controls.linuxcnc(rng, axes, inch=options.get("units") == "inch")


# --- the job file
# --------------------------------------------------------------------------------------------------


def _axis_words(rng: Rng, job: Words, axis: MachineAxis, files: dict[str, str]) -> Words:
    """The axis of the job file; its tests go into ``files``."""
    control = job["controller"]
    format_id, options = control["format"], control.get("options", {})
    none = job["states"]["as_found"] == "none"
    both = 0.4 if _holds_two_curves(format_id, options, none=none) else 0.05
    name = f"runs/{axis.name.lower()}.csv"
    x = axis.targets(rng)
    files[name] = positioning_csv(rng, axis, x, axis.measure(rng, x))
    words: Words = {"travel": list(axis.travel), "address": axis.address, "before": [name]}
    if axis.rotary:
        words["kind"] = "rotary"
    if axis.endless:
        words["modulo"] = 360
    if axis.home < 0:
        words["reference_return"] = "-"
    if rng.random() < 0.2:
        later = f"runs/{axis.name.lower()}_later.csv"
        x = axis.targets(rng)
        files[later] = positioning_csv(rng, axis, x, axis.measure(rng, x))
        words["before"].append({"files": [later], "name": f"later_{axis.name}"})
        if rng.random() < 0.4:
            job["states"]["earlier"] = "none"
            words["before"][-1]["measured_in"] = "earlier"
    if rng.random() < 0.5:
        words["accept"] = {"A": float(rng.choice([2, 6, 12, 40])), "B": 5}
    words |= _some(
        rng,
        {
            "screw_pitch": (0.25, [10, 20, [10, 5], 30]),
            "encoder": (0.15, [{"type": "absolute"}, {"type": "distance_coded"}]),
            "programmed": (0.0 if axis.rotary else 0.015, ["radius", "diameter"]),
            "reference": (0.12, [0, axis.travel[0], axis.travel[1], axis.travel[1] / 2]),
            "axis_number": (0.1, [axis.number]),
            "position_map": (0.05, [{"sense": 1, "offset": 0}]),
            "table": (0.5, [_table(rng, axis, both)]),
        },
    )
    _odd_words(rng, format_id, options, words, none=none)
    return words | axis.words


def _odd_words(rng: Rng, format_id: str, options: Words, words: Words, *, none: bool) -> None:
    """What few axes have: options of their own, no table beside a line, a synchronised axis."""
    if options and rng.random() < 0.1:
        words["options"] = dict([next(iter(options.items()))])
    if options.get("method") == "line" and not none and rng.random() < 0.9:
        words.pop("table", None)
    if format_id.startswith("siemens"):
        if rng.random() < (0.12 if none else 0.02):
            words["gantry"] = "AX9"
    elif rng.random() < 0.01:
        words["gantry"] = "9"


def _holds_two_curves(format_id: str, options: Words, *, none: bool) -> bool:
    """Whether the control can hold a curve for each direction, as far as the job tells."""
    if format_id == "heidenhain-nck":
        return options.get("backlash_column") == "second_curve" and not none
    if format_id in ("linuxcnc", "isg-kernel", "pmac") or "cec" in options:
        return True
    return format_id.startswith("fanuc") and format_id not in WITHOUT_Q and not none


def _table(rng: Rng, axis: MachineAxis, both: float) -> Words:
    length = axis.travel[1] - axis.travel[0]
    odd = 0.0 if axis.endless else 0.06
    modes = ["bidirectional"] if rng.random() < both else ["auto", "single"]
    return _some(
        rng,
        {
            "mode": (0.6, modes),
            "goal": (0.3, ["expected", "A", "E", "M"]),
            "spacing": (0.4, ["auto", length / 16, length / 20, length / 10, length / 10, 30.0]),
            "start": (odd, [axis.travel[0], axis.travel[0] - 20]),
            "end": (odd, [axis.travel[1], axis.travel[1] + 20]),
        },
    )


def _whole(rng: Rng, job: Words, axes: list[MachineAxis], files: dict[str, str]) -> None:
    """What stands beside the axes: circles, cross-axis tables, uncertainty, rules."""
    linear = [axis for axis in axes if not axis.rotary]
    if len(linear) >= 2 and rng.random() < 0.4:
        _circle(rng, job, linear, files)
    if len(axes) >= 2 and rng.random() < 0.2:
        one, two = (axes[int(n)] for n in rng.choice(len(axes), 2, replace=False))
        places = np.linspace(*one.travel, 5).round(3)
        values = rng.normal(0, 6, 5).round(2)
        unit = "arcsec" if two.rotary else "um"
        entry = {"input": one.name, "output": two.name, "positions": places.tolist()}
        job["cross"] = [entry | {"deviations": values.tolist(), "unit": unit}]
    device = {"device": {"U": 0.5, "per_m": 0.5}, "U_theta": 0.5, "U_alpha": 1.0, "E_VE": 0.6}
    job |= _some(
        rng,
        {
            "uncertainty": (0.2, [device]),
            "decision_rule": (0.1, ["simple"]),
            "standard": (0.2, STANDARDS),
            "thermal": (0.08, [{"alpha_m": 11.5, "T_m": 22.0}]),
            "machine": (0.3, [{"name": "VMC 850", "serial": "17", "type": "centre"}]),
            "fixed_positions": (0.2, [{"tool change": {axes[0].name: 0}}]),
            "report": (0.1, [{"language": "en"}, {"language": "de"}]),
        },
    )
    if "uncertainty" in job and rng.random() < 0.5:
        job["decision_rule"] = "guarded"
    if job.get("standard") in STANDARDS and rng.random() < 0.95:
        limit = {"P": 12.0} if job["standard"] == "vdi3441" else {"A": 12.0}
        for words in job["axes"].values():
            if "accept" in words:
                words["accept"] = dict(limit)


def _circle(rng: Rng, job: Words, linear: list[MachineAxis], files: dict[str, str]) -> None:
    one, two = linear[:2]
    plane = one.name + two.name
    files["runs/circle.csv"] = circle_csv(rng, plane, one, two)
    centre = [sum(one.travel) / 2, sum(two.travel) / 2]
    job["circles"] = [{"file": "runs/circle.csv", "name": plane.lower(), "centre": centre}]
    if rng.random() < 0.7:
        job["apply"] = _some(
            rng,
            {
                "squareness": (0.7, [{plane: one.name}, {plane: two.name}]),
                "scale": (0.4, [[one.name], [one.name, two.name]]),
                "backlash_from": (0.3, ["circle", "positioning"]),
            },
        )
    if rng.random() < 0.1:
        job["axes"][one.name]["before"] = []
        job["axes"][one.name].pop("accept", None)


def _fault(rng: Rng, job: Words, files: dict[str, Any]) -> None:
    """One fault in the job file, in a test or in a file of the control."""
    name = next(iter(job["axes"]))
    axis = job["axes"][name]
    in_job: list[tuple[Words, str, Any]] = [
        (axis, "travel", [5, 5]),
        (axis, "travel", ["0", 800]),
        (axis, "adress", "AX1"),
        (axis, "address", "Q9"),
        (axis, "before", ["missing.csv"]),
        (axis, "modulo", -1),
        (axis, "accept", {"Q": 8}),
        (axis, "gantry", name),
        (axis, "table", {"spacing": "wide", "mode": "both"}),
        (axis, "table", {"start": 100.0, "end": 10.0}),
        (axis, "table", {"spacing": 0.01}),
        (axis, "options", {"no_such": 1}),
        (job["controller"], "format", "fanuc-31"),
        (job["controller"], "options", {"units": "ell", "detection_unit": "x"}),
        (job, "states", {}),
        (job, "states", {"as_found": ["control/none.txt"]}),
        (job, "compwright", 2),
        (job, "apply", {"squareness": {"XY": "Z"}}),
    ]
    choice = int(rng.integers(len(in_job) + 8))
    if choice < len(in_job):
        section, key, value = in_job[choice]
        section[key] = value
        return
    chosen = sorted(files)[int(rng.integers(len(files)))]
    content = bytearray(files[chosen])
    for _ in range(int(rng.integers(1, 4))):
        place = int(rng.integers(len(content))) if content else 0
        if choice % 3 == 0:
            del content[place : place + int(rng.integers(1, 60))]
        elif content:
            content[place] = int(rng.choice([0, 36, 44, 46, 48, 57, 61, 65, 200]))
    files[chosen] = bytes(content)


# --- the commands
# --------------------------------------------------------------------------------------------------


def _commands(
    rng: Rng, format_id: str, job: Words, axes: list[MachineAxis], files: Mapping[str, Any]
) -> list[list[str]]:
    """The command lines, in order; names of results that do not exist are part of the game."""
    given = job["controller"].get("options", {})
    options = option_words(given)
    control = sorted(name for name in files if name.startswith("control/"))
    commands = []
    if control:
        commands.append(
            ["new", "--from", *control, "--format", format_id, *options, "--out", "new.yaml"]
        )
        commands.append(["decode", *control, "--format", format_id, *options])
    worse = ["--accept-worse"] if rng.random() < 0.5 else []
    commands.append(["run", "job.yaml", *worse, *(["--json", "-"] if rng.random() < 0.1 else [])])
    if rng.random() < 0.15:
        test = next(name for name in sorted(files) if name.startswith("runs/"))
        state = [word for name in control or ["none"] for word in ("--state", name)]
        words = ["run", test, "--format", format_id, "--axis", axes[0].name]
        words += ["--travel", f"{axes[0].travel[0]:g}:{axes[0].travel[1]:g}", *state, *options]
        place = ["--option", f"address={axes[0].address}", "--out", "quick"]
        commands.append([*words, *place])
    return commands + later_commands(rng, format_id, options, axes)


def option_words(options: Mapping[str, Any]) -> list[str]:
    """``--option`` words for the command line."""
    words = []
    for key, value in options.items():
        text = ",".join(map(str, value)) if isinstance(value, list) else str(value)
        words += ["--option", f"{key}={text}"]
    return words


def later_commands(
    rng: Rng, format_id: str, options: list[str], axes: list[MachineAxis]
) -> list[list[str]]:
    """What is run on the results of ``run job.yaml``: in the worker ``after/`` then exists."""
    tables = f"job/tables/{format_id}"
    low, high = axes[0].travel
    at = f"{low - 33:g},{high + 50:g},{low:g}:{high:g}:{(high - low) / 7.3:.4g}"
    others = [other for other in controls.ADDRESSES if other != format_id]
    other = others[int(rng.integers(len(others)))]
    addresses = {f"address.{a.name}": controls.ADDRESSES[other][a.number - 1] for a in axes}
    if other.startswith("fanuc"):
        addresses |= {"detection_unit": "0.001", "first_point": "0"}
    loaded = ["--loaded", tables] if rng.random() < 0.5 else []
    after = [f"{axis.name}=after/{axis.name}.csv" for axis in axes]
    if rng.random() < 0.6:
        after = [f"after/{axis.name}.csv" for axis in axes]
    state = ["--state", "none"] if rng.random() < 0.8 else []
    export = ["export", "job/plan.json"]
    verify = ["verify", "job.yaml", *(word for path in after for word in ("--after", path))]
    return [
        ["decode", tables, "--format", format_id, *options, "--json", "-"],
        ["decode", tables, "--format", format_id, *options, "--at", at],
        *([[*export, "--format", format_id, "--out", "again"]] if rng.random() < 0.5 else []),
        [*export, "--format", other, *state, "--out", "other", *option_words(addresses)],
        *([["compare", "job/plan.json", "--loaded", tables]] if rng.random() < 0.5 else []),
        ["compare", "job/plan.json", "--loaded", "damaged", "--json", "compared.json"],
        [*verify, *loaded, "--out", "verified"],
    ]


def simple_readings(axis: MachineAxis, x: Floats, readings: dict[int, Floats]) -> str:
    """The readings in the plain long form."""
    return positioning_csv(None, axis, x, readings)
