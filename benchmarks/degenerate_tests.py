"""Valid tests with little or no scatter, dealt by number, and the jobs and files that they come in.

Each is a sum of ingredients: an error, a lost motion, scatter (none, in one direction, at one
target, at all but one, in one run), shifts of the runs (constants, one run, alternating, drift,
opposite by direction, in + alone), a coarse step, an offset, readings that are missing.
"""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from loaded_controls import CONTROLS
from numpy.random import Generator
from numpy.typing import NDArray

Floats = NDArray[np.float64]
#: Numbers of targets with their weights; of runs.
TARGETS = {2: 4, 3: 4, 4: 3, 5: 5, 6: 4, 8: 5, 11: 8, 13: 4, 17: 4, 21: 4, 30: 2, 50: 2, 100: 1}
TARGETS |= {200: 1, 500: 1}
RUNS = {1: 3, 2: 3, 3: 3, 5: 8, 7: 1, 10: 2, 20: 1, 30: 1}
SCATTERS = ("none", "+ alone", "- alone", "one target", "all but one", "one run", "everywhere")
SHIFTS = ("none", "constants", "one run", "alternating", "drift", "opposite", "+ alone", "tilts")
ERRORS = ("nothing", "bend", "line", "steep line", "jump", "one target", "zigzag", "wave")
STEPS = (0.0, 0.0, 0.0, 0.001, 0.1, 1.0, 5.0)
OFFSETS = (0.0, 0.0, 0.0, 30.0, 1e4, 1e6)
FACTORS = (1.0, 1.0, 1.0, 1.0, 0.1, 10.0)
FORMS = ("long", "wide", "comma", "laser runs", "target data", "workbook", "profile")


@dataclass(frozen=True, kw_only=True)
class Dealt:
    """A test: targets (m,) in mm or deg, readings (m, n) in + and in -, µm or arcsec; NaN where a
    reading was not made, None where a direction was not measured.
    """

    name: str
    rotary: bool
    cycle: str
    form: str
    targets: Floats
    positive: Floats | None
    negative: Floats | None

    @property
    def blocks(self) -> dict[str, Floats]:
        """The readings by direction."""
        both = {"+": self.positive, "-": self.negative}
        return {sign: block for sign, block in both.items() if block is not None}

    @property
    def repeated(self) -> bool:
        """Whether each target was approached more than once from each side measured."""
        return all(np.all(np.sum(~np.isnan(b), axis=1) > 1) for b in self.blocks.values())

    @property
    def differ(self) -> float:
        """By how much its readings differ, all together."""
        values = np.concatenate([block.ravel() for block in self.blocks.values()])
        return float(np.nanmax(values) - np.nanmin(values))


def one_of(rng: Generator, weights: Mapping[int, int]) -> int:
    """Return a number by its weight."""
    shares = np.array(list(weights.values()), dtype=float)
    return int(rng.choice(list(weights), p=shares / shares.sum()))


def deal(number: int, seed: int, again: int = 0) -> Dealt:
    """Return test ``number``; ``again``: the same axis measured once more, by other chances."""
    rng = np.random.default_rng([seed, number])
    rotary = bool(rng.random() < 0.2)
    cycle = "step" if rng.random() < 0.1 else "standard"
    m, n = one_of(rng, TARGETS), one_of(rng, RUNS)
    n = n if m * n <= 2500 else 2
    x = targets_of(rng, m, 360.0 if rotary else 800.0, endless=rotary)
    error, form = str(rng.choice(ERRORS)), str(rng.choice(FORMS))
    curve = error_of(rng, error, x)
    lost = float(rng.choice([0.0, -3.0, 5.0])) + 2.0 * float(rng.choice([0, 1])) * np.sin(x / 90.0)
    step, offset, factor = (float(rng.choice(each)) for each in (STEPS, OFFSETS, FACTORS))
    scatter, shift = str(rng.choice(SCATTERS)), str(rng.choice(SHIFTS))
    size = float(rng.choice([0.01, 0.3, 3.0])), float(rng.choice([0.7, 1.0, 2.5, 100.0]))
    alone = str(rng.choice(["", "", "", "", "+", "-"]))
    missing = bool(rng.random() < 0.08 and n > 2 and form in ("long", "wide", "comma"))
    rng = np.random.default_rng([seed, number, again])
    both = curve[:, None] + shifts_of(rng, shift, n, size[1], x)
    noise = scatter_of(rng, scatter, (m, n), size[0])
    half = np.stack([lost / 2.0, -lost / 2.0])[:, :, None]
    blocks = factor * (both + noise + half) + offset
    if step:
        blocks = step * np.round(blocks / step)
    uneven = 0 if alone else uneven_of(np.random.default_rng([seed, number, 11]), form, n)
    if uneven:
        blocks[1, :, uneven:] = np.nan
    if missing:
        first = blocks[:, :, 0].copy()
        blocks[rng.random(blocks.shape) < 0.1] = np.nan
        blocks[:, :, 0] = np.where(np.isnan(blocks).all(axis=2), first, blocks[:, :, 0])
    name = f"{number}: {m} targets, {n} runs, {error}, scatter {scatter} {size[0]:g}, shifts"
    name += f" {shift} {size[1]:g}, step {step:g}, offset {offset:g}, times {factor:g}, {form}"
    for word, said in (("rotary", rotary), (cycle, cycle == "step"), (f"{alone} only", alone)):
        name += f", {word}" if said else ""
    return Dealt(
        name=name + (", missing" if missing else "") + (f", {uneven} in -" if uneven else ""),
        rotary=rotary,
        cycle=cycle,
        form="long" if cycle == "step" or (alone and form == "target data") else form,
        targets=x,
        positive=None if alone == "-" else blocks[0],
        negative=None if alone == "+" else blocks[1],
    )


def uneven_of(rng: Generator, form: str, n: int) -> int:
    """Return how many runs there are in -, where fewer than in +; else nothing."""
    fits = n > 1 and form in ("long", "wide", "comma") and rng.random() < 0.25
    return int(rng.integers(1, n)) if fits else 0


def targets_of(rng: Generator, m: int, length: float, *, endless: bool) -> Floats:
    """Return ascending targets: equal steps, scattered, or two of them close to each other."""
    x = np.arange(m) * (length / m) if endless else np.linspace(0.0, length, m)
    kind = rng.choice(["equal", "scattered", "close"])
    if kind == "scattered":
        x = (np.arange(m) + 0.5 + rng.uniform(-0.3, 0.3, m)) * length / m
    elif kind == "close" and m > 2:
        x[m // 2] = x[m // 2 - 1] + 0.01
    return np.round(x, 3)


def error_of(rng: Generator, kind: str, x: Floats) -> Floats:
    """Return the error (m,), µm or arcsec."""
    place = rng.integers(x.size)
    errors = {
        "nothing": 0.0 * x,
        "bend": 10.0 * np.sin(x / 200.0 + rng.uniform(0, 6)),
        "line": 0.1 * x,
        "steep line": 3.0 * x,
        "jump": 100.0 * (np.arange(x.size) > place),
        "one target": 50.0 * (np.arange(x.size) == place),
        "zigzag": 5.0 * (np.arange(x.size) % 2),
        "wave": 3.0 * np.sin(2 * np.pi * x / 10.0 + rng.uniform(0, 6)),
    }
    return np.asarray(errors[kind], dtype=np.float64)


def shifts_of(rng: Generator, kind: str, n: int, size: float, x: Floats) -> Floats:
    """Return what moves whole traverses (2, m or 1, n)."""
    own = size * rng.standard_normal(n)
    tilts = own * np.linspace(-1.0, 1.0, x.size)[:, None]
    rows: dict[str, tuple[Any, Any]] = {
        "none": (0.0 * own, 0.0 * own),
        "constants": (own, own),
        "one run": (size * (np.arange(n) == n // 2),) * 2,
        "alternating": (size * (np.arange(n) % 2),) * 2,
        "drift": (size * np.arange(n),) * 2,
        "opposite": (own, -own),
        "+ alone": (own, 0.0 * own),
        "tilts": (tilts, tilts),
    }
    return np.stack([np.broadcast_to(row, (x.size, n)) for row in rows[kind]])


def scatter_of(rng: Generator, kind: str, shape: tuple[int, int], size: float) -> Floats:
    """Return scatter (2, m, n)."""
    noise = size * rng.standard_normal((2, *shape))
    one = np.zeros(shape, dtype=bool)
    one[shape[0] // 3] = True
    run = np.zeros(shape, dtype=bool)
    run[:, shape[1] // 2] = True
    masks = {
        "none": (False, False),
        "+ alone": (True, False),
        "- alone": (False, True),
        "one target": (one, False),
        "all but one": (~one, ~one),
        "one run": (run, run),
        "everywhere": (True, True),
    }
    return np.stack([each * mask for each, mask in zip(noise, masks[kind], strict=True)])


# ---- files


def write_test(test: Dealt, folder: Path, stem: str) -> tuple[str, str]:
    """Write its file; return its name and that of the profile that it needs, or nothing."""
    content, ending = WRITERS[test.form](test)
    (folder / f"{stem}{ending}").write_bytes(content)
    if test.form != "profile":
        return f"{stem}{ending}", ""
    unit = ("deg", "arcsec") if test.rotary else ("mm", "um")
    text = PROFILE.format(target=unit[0], value=unit[1])
    (folder / "profile.yaml").write_text(text, encoding="utf-8")
    return f"{stem}{ending}", "profile.yaml"


PROFILE = """compwright_profile: 1
layout: long
encoding: cp1252
delimiter: semicolon
decimal: comma
header_line: 2
axis: X
target: "Soll"
target_unit: {target}
value: "Abweichung"
value_is: deviation
unit: {value}
sign: measured minus target
direction_from: column
direction: Richtung
directions: {{auf: "+", ab: "-"}}
run: Lauf
run_counts: runs
cycle: standard
"""


def rows_of(test: Dealt) -> list[tuple[str, str, int, str]]:
    """Return target, direction, run and deviation of each reading."""
    return [
        (f"{place:.4f}", sign, run, f"{value:.4f}")
        for sign, block in test.blocks.items()
        for place, row in zip(test.targets, block, strict=True)
        for run, value in enumerate(row, start=1)
        if not np.isnan(value)
    ]


def _long(test: Dealt) -> tuple[bytes, str]:
    target, unit = ("deg", "arcsec") if test.rotary else ("mm", "um")
    lines = [
        "# axis: X",
        f"# cycle: {test.cycle}",
        f"target_{target},direction,run,deviation_{unit}",
    ]
    lines += [",".join(map(str, row)) for row in rows_of(test)]
    return ("\n".join(lines) + "\n").encode(), ".csv"


def _comma(test: Dealt) -> tuple[bytes, str]:
    text = _long(test)[0].decode().replace(",", ";").replace(".", ",")
    return text.replace("\n", "\r\n").encode("utf-8-sig"), ".csv"


def _wide(test: Dealt) -> tuple[bytes, str]:
    target, unit = ("deg", "arcsec") if test.rotary else ("mm", "um")
    heads = [f"{sign}{run + 1}" for sign, b in test.blocks.items() for run in range(b.shape[1])]
    table = np.hstack(list(test.blocks.values()))
    lines = ["# axis: X", f"# unit: {unit}", ",".join([f"target_{target}", *heads])]
    for place, row in zip(test.targets, table, strict=True):
        lines.append(",".join([f"{place:.4f}", *("" if np.isnan(v) else f"{v:.4f}" for v in row)]))
    return ("\n".join(lines) + "\n").encode(), ".csv"


def _profile(test: Dealt) -> tuple[bytes, str]:
    lines = ["Protokoll", "Soll;Richtung;Lauf;Abweichung"]
    for place, sign, run, value in rows_of(test):
        way = {"+": "auf", "-": "ab"}[sign]
        lines.append(f"{place};{way};{run};{value}".replace(".", ","))
    return ("\r\n".join(lines) + "\r\n").encode("cp1252"), ".txt"


def _laser_runs(test: Dealt) -> tuple[bytes, str]:
    kind = "rta" if test.rotary else "rtl"
    factor = 1e6 * np.pi / (180.0 * 3600.0) if test.rotary else 1.0  # µrad
    both = len(test.blocks) == 2
    start = "-" if list(test.blocks) == ["-"] else "+"
    targets = test.targets if start == "+" else test.targets[::-1]
    count = next(iter(test.blocks.values())).shape[1] * len(test.blocks)
    lines = ["HEADER::", f"File type  : {kind}", "Version no : V20.02.02", "", "TARGET DATA::"]
    lines += ["Filetype  : ISO", f"Target-count: {targets.size}", "Targets :"]
    lines += [f"{place:.4f}" for place in targets]
    lines += [
        "Flags: 0 0 2 0" if both else "Flags: 0 1 2 0",
        "",
        "USER-TEXT::",
        "Axis: X",
        "",
        "RUNS::",
    ]
    lines += [f"Run-count: {count}", "", "DEVIATIONS::", "Run Target Data:"]
    traverse = 0
    for run in range(count // len(test.blocks)):
        for sign, block in test.blocks.items():
            traverse += 1
            order = list(range(targets.size))
            column = block[:, run] if start == "+" else block[::-1, run]
            for index in order if sign == start else order[::-1]:
                lines.append(f" {traverse} {index + 1} {factor * column[index]:.4f}")
    lines += ["", "EQUIPMENT::", "ENVIRONMENT::", "EOF::"]
    return ("\r\n".join(lines) + "\r\n").encode(), "." + kind


def _target_data(test: Dealt) -> tuple[bytes, str]:
    unit, factor = ("deg", 1 / 3600.0) if test.rotary else ("mm", 1e-3)
    runs = next(iter(test.blocks.values())).shape[1]
    lines = [f"UNIT={unit}", f"CYCLES={runs}", f"POSITIONS={test.targets.size}", "DEC=5"]
    lines += [f"TGT_DATA[{k}]={place:.4f}" for k, place in enumerate(test.targets, start=1)]
    for sign, block in test.blocks.items():
        name = "REF_DATA_FWD" if sign == "+" else "REF_DATA_BWD"
        for (k, run), value in np.ndenumerate(block):
            lines.append(f"{name}[{k + 1},{run + 1}]={test.targets[k] + factor * value:.8f}")
    return ("\n".join(lines) + "\n").encode(), ".txt"


def _workbook(test: Dealt) -> tuple[bytes, str]:
    import openpyxl

    book = openpyxl.Workbook(write_only=True)
    sheet = book.create_sheet("X")
    target, unit = ("deg", "arcsec") if test.rotary else ("mm", "um")
    sheet.append([f"target_{target}", "direction", "run", f"deviation_{unit}"])
    for place, sign, run, value in rows_of(test):
        sheet.append([float(place), sign, run, float(value)])
    content = io.BytesIO()
    book.save(content)
    return content.getvalue(), ".xlsx"


WRITERS: dict[str, Callable[[Dealt], tuple[bytes, str]]] = {
    "long": _long,
    "comma": _comma,
    "wide": _wide,
    "profile": _profile,
    "laser runs": _laser_runs,
    "target data": _target_data,
    "workbook": _workbook,
}


# ---- jobs

UNCERTAIN = {
    "device": {"U": 0.5, "per_m": 0.5},
    "misalignment_mm": 1,
    "U_theta": 0.5,
    "U_alpha": 1.0,
    "E_VE": 1.0,
}


def job_of(test: Dealt, before: str, profile: str, control: str, rng: Generator) -> dict[str, Any]:
    """Return a job for a control without tables; by chance with limits and other wishes."""
    made = CONTROLS[control]
    options = dict(made.options)
    if control.startswith("fanuc"):
        options["first_point"] = 100
    if control == "siemens-840d-sl" and rng.random() < 0.3:
        options |= {"cec": "available", "cec_sign": "error", "cec_tables": [0, 1]}
    entry: Any = {"files": [before], "name": "x", **({"profile": profile} if profile else {})}
    axis: dict[str, Any] = {
        "travel": [0, 360 if test.rotary else 800],
        "address": made.addresses["X"],
        "before": [entry],
    }
    if test.rotary:
        axis |= {"kind": "rotary"} | ({"modulo": 360} if made.endless else {})
    job: dict[str, Any] = {
        "compwright": 1,
        "controller": {"format": control, "options": options},
        "states": {"as_found": "none"},
        "axes": {"X": axis},
    }
    whole = len(test.blocks) == 2 and test.repeated
    if rng.random() < 0.4:
        axis["accept"] = {
            "A" if whole else "E_positive" if test.positive is not None else "E_negative": 5
        }
    if rng.random() < 0.2 and not test.rotary:
        job |= {"uncertainty": UNCERTAIN, "decision_rule": "guarded"}
    if rng.random() < 0.3:
        axis["screw_pitch"] = 10
    if rng.random() < 0.2 and whole:
        axis["table"] = {"goal": str(rng.choice(["A", "E", "M"]))}
    return job


def write_job(job: Mapping[str, Any], folder: Path, name: str) -> Path:
    """Write a job file."""
    path = folder / name
    path.write_text(json.dumps(job), encoding="utf-8")
    return path
