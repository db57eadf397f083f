"""Why a vendor's lost motion and servo mismatch differ from ours: both models on circles of known
machines.

``python benchmarks/bench_vendor_circle.py [FOLDER]`` (the ballbar files with the vendor's results).
A vendor-like model has harmonics and one step per reversal, no spikes (`circle_plain`).

First table: machines of `examiner_circles.py` with the same lost motion and spikes of one height
at one end; error of either model. Second table, each file: the vendor's printed value, the
vendor-like model on the readings, the same on a circle without noise that has exactly the causes
that our fit found, and our value. Where the third number is the vendor's and not ours, the
difference is that of the models, not of the machine.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import numpy as np
from examiner_circles import AXES, ENDS, Circle, quiet

from compwright.estimation.circle import diagnose
from compwright.instruments.b5r import read_b5r
from compwright.instruments.circular_csv import read_circular_csv
from compwright.records.circular import CircularTest, Diagnosis

FOLDER: Final = Path(__file__).resolve().parents[2] / "shared/data/real/ballbar"
HEIGHTS: Final = (0.0, 1.0, 2.0, 4.0)  # um
DECAYS: Final = (0.05, 0.2)  # s
LOST: Final = 2.0  # um
#: Causes by the vendor's names.
NAMES: Final = {
    "squareness": "AF_SQUARENESS",
    "scale_mismatch": "AF_SCALE_MISMATCH",
    "servo_mismatch": "AF_SERVO_MISMATCH",
    "backlash_first": "AF_BACKLASH_A_GLOBAL",
    "backlash_first_at_positive": "AF_BACKLASH_A_POS",
    "backlash_first_at_negative": "AF_BACKLASH_A_NEG",
    "backlash_second": "AF_BACKLASH_B_GLOBAL",
    "backlash_second_at_positive": "AF_BACKLASH_B_POS",
    "backlash_second_at_negative": "AF_BACKLASH_B_NEG",
    "lateral_play_first": "AF_LATERAL_PLAY_A_GLOBAL",
    "lateral_play_second": "AF_LATERAL_PLAY_B_GLOBAL",
}
_SHOWN: Final = ("backlash_first_at_positive", "backlash_first_at_negative", "servo_mismatch")


def known_machines() -> str:
    """Return the errors of both models on machines with a spike at one end of the first axis."""
    lines = ["spike  decay   " + "".join(f"{name:>32}" for name in _SHOWN)]
    lines.append(" " * 15 + "".join(f"{'vendor-like       ours':>32}" for _ in _SHOWN))
    for decay in DECAYS:
        for height in HEIGHTS:
            values = quiet() | {
                **{f"backlash_{axis}_at_{end}": LOST for axis in AXES for end in ENDS},
                "reversal_spike_first_at_positive": height,
                "decay_first_at_positive": decay,
            }
            circle = Circle(values=values, friction="peak", noise=0.1)
            text = circle.text(np.random.default_rng(1)).encode()
            found = diagnose(read_circular_csv(text, "c.csv", "c"))
            cells = ""
            for name in _SHOWN:
                true, ours = circle.truth()[name], found.effects[name]
                cells += (
                    f"{found.plain[name] - true:12.3f} {ours.value - true:10.3f}"
                    f" ±{2.0 * ours.std_error:7.3f}"
                )
            lines.append(f"{height:4.0f} µm {1e3 * decay:4.0f} ms {cells}")
    return "\n".join(lines)


def synthetic(test: CircularTest, found: Diagnosis) -> Diagnosis:
    """Return the diagnosis of the circle without noise that our fit of a test is the mean of."""
    runs = tuple(
        replace(run, angles=each.angles, deviations=np.mean(each.paths, axis=0))
        for run, each in zip(test.runs, found.fresh(), strict=True)
    )
    return diagnose(replace(test, runs=runs))


def of_file(path: Path) -> str:
    """Return the table of one file."""
    test = read_b5r(path.read_bytes(), path.name, path.stem)
    printed: Mapping[str, Any] = next(
        (
            value
            for name, value in test.vendor.items()
            if name.startswith("RENISHAW_DIAGNOSTICS") and isinstance(value, Mapping)
        ),
        {},
    )
    ours = diagnose(test)
    again = synthetic(test, ours)
    lines = [path.name]
    lines.append(f"  {'':28}{'vendor':>9}{'like':>9}{'like, ours':>12}{'ours':>18}  explained")
    for name, key in NAMES.items():
        entry = printed.get(key)
        if entry is None or entry.get("valid") is False or name not in ours.plain:
            continue
        if name in ours.undetermined:
            continue
        vendor, effect = float(entry["value"]), ours.effects[name]
        gap = abs(effect.value - vendor)
        if gap <= 2.0 * effect.std_error:
            why = "agrees"
        else:
            why = f"{100.0 * (1.0 - abs(again.plain[name] - vendor) / gap):.0f} %"
        lines.append(
            f"  {name:28}{vendor:9.2f}{ours.plain[name]:9.2f}{again.plain[name]:12.2f}"
            f"{effect.value:11.2f} ±{2.0 * effect.std_error:5.2f}  {why}"
        )
    return "\n".join(lines)


def main() -> None:
    """Print both tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?", default=FOLDER)
    folder = parser.parse_args().folder
    print(known_machines())
    for path in sorted(folder.glob("*.b5r")):
        print(of_file(path))


if __name__ == "__main__":
    main()
