"""Random arcs with ``apply`` of squareness or scale: does a correction ever make a circle worse?

``python benchmarks/bench_circle_apply.py [COUNT] [--seed S]``. The machines are those of
`examiner_circles.py`, on arcs of 90° to 360° in both directions; each is diagnosed and decided as
a job with ``apply: {squareness: {XY: Y}}`` does, every tenth goes through the function behind
``compwright run`` itself, and with ``apply: {scale: [X, Y]}`` too. The corrected machine is
measured by the examiner without noise.
``worse``: the squareness (scale) that is left is larger than before; ``circle worse``: the
bidirectional circular deviation grows by more than 0.1 µm and a tenth, which `run` calls worse;
``..., exit 0``: and `run` ends with 0. ``doubted``: corrected with the doubt CW-P166.
``determinable``: both axes reverse inside the arc, and two Cramér-Rao errors are below half of the
value and below 30 µm/m; ``written``: of these a correction was written; ``negligible``: of these
none was, because the squareness is known to be below 15 µm/m. ``clear``: where that holds for three
Cramér-Rao errors, because a diagnosis may state 1.5 times of them.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Final

import numpy as np
from examiner_circles import AXES, TURNS, Circle, circle

from compwright.evaluation.circular import evaluate_circle
from compwright.foundations.session import Session
from compwright.instruments.circular_csv import read_circular_csv
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.planning.circles import CIRCULAR_STANDARD as STANDARD
from compwright.planning.value_with_error import worse_doubts
from compwright.records.circular import CircularTest
from compwright.records.correction_need import correction_need
from compwright.workflow.commands.run import PlannedJob, planned
from compwright.workflow.inputs.jobs import read_job_file

#: Kinds of arc (`examiner_circles.ARCS`; another word: any).
KINDS: Final = ("360", "220", "180", "90", "90 between", "any arc", "any arc", "any arc")
_GROWS: Final = 0.1  # µm
_SHARE: Final = 1.1  # 1 + `planning.circles.WORSE`
_RUN_EVERY: Final = 10
#: Stated standard error, by its bound, from which the certainty of a correction is judged.
_RATIOS: Final = {"determinable": 1.0, "clear": 1.5}


def run(folder: Path, apply: str) -> PlannedJob:
    """Return the planned job of the circle in ``folder``."""
    job = folder / "job.yaml"
    job.write_text(
        "compwright: 1\ncontroller: {format: siemens-840d-sl, options: {cec: available,"
        " cec_sign: correction, cec_tables: [0, 1, 2, 3]}}\nstates: {as_found: none}\naxes:\n"
        "  X: {travel: [0, 800], address: AX1, before: []}\n"
        "  Y: {travel: [0, 800], address: AX2, before: []}\n"
        f"circles: [{{file: xy.csv, name: xy, centre: [400, 400]}}]\napply: {apply}\n",
        encoding="utf-8",
    )
    session = Session()
    return planned(session, read_job_file(session, job), folder, folder / "out")


def deviation(test: Circle) -> float:
    """Return the bidirectional circular deviation without noise, µm."""
    text = replace(test, noise=0.0).text(np.random.default_rng(0))
    read: CircularTest = read_circular_csv(text.encode(), "xy.csv", "xy")
    return 1e3 * float(evaluate_circle(read).parameters["G_bidirectional"] or 0.0)


def decided(text: str) -> tuple[float | None, bool, bool]:
    """Return the squareness that a job would correct, µm/m, by the circle of a CSV ``text``, None
    where it would not, whether it is known to need no correction, and whether it is in doubt.
    """
    diagnosis = diagnose_circle(
        read_circular_csv(text.encode(), "xy.csv", "xy"), STANDARD
    ).diagnosis
    if diagnosis is None or "squareness" in diagnosis.undetermined:
        return None, False, False
    effect = diagnosis.effects["squareness"]
    need = correction_need(effect.value, effect.std_error)
    if need != "correct":
        return None, need == "negligible", False
    return effect.value, False, bool(worse_doubts(effect.value, effect.std_error, ("X", "Y")))


def slope_of(found: PlannedJob) -> float | None:
    """Return the squareness that is corrected, µm/m, None where none is."""
    for cross in found.results.prediction["cross"]:
        return float(1e3 * np.polyfit(cross["positions"], cross["correction"], 1)[0])
    return None


class Counts:
    """What is counted over all machines."""

    def __init__(self) -> None:
        self.all: Counter[str] = Counter()

    def squareness(
        self, number: int, test: Circle, slope: float | None, folder: Path, *, small: bool
    ) -> None:
        """Count a decision about the squareness by the circle in ``folder``; ``small``: it is known
        to need no correction.
        """
        true = test.values["squareness"]
        bound = test.bound()["squareness"]
        both = test.reverses() and len(test.senses) == len(TURNS)
        for name, ratio in _RATIOS.items():
            if both and 2.0 * ratio * bound < min(abs(true) / 2.0, 30.0):
                self.all[name] += 1
                self.all[f"{name}, written"] += slope is not None
                self.all[f"{name}, negligible"] += small
                if slope is None and not small:
                    self.note(number, test, f"{name}: {true:.1f} ± {bound:.1f} not corrected")
        if slope is None:
            return
        self.all["corrected"] += 1
        if abs(true - slope) > abs(true):
            self.harm("worse", number, test, folder, f"{true:.1f} µm/m corrected by {slope:.1f}")
        after = replace(test, values={**test.values, "squareness": true - slope})
        was, becomes = deviation(test), deviation(after)
        if becomes > max(was + _GROWS, was * _SHARE):
            what = f"G {was:.2f} to {becomes:.2f} µm, {true:.1f} µm/m corrected by {slope:.1f}"
            self.harm("circle worse", number, test, folder, what)

    def harm(self, kind: str, number: int, test: Circle, folder: Path, words: str) -> None:
        """Count a correction that makes something worse, and whether `run` ends with 0."""
        exit_code = run(folder, "{squareness: {XY: Y}}").exit_code
        self.all[kind] += 1
        self.all[f"{kind}, exit 0"] += exit_code == 0
        self.note(number, test, f"{kind}, exit {exit_code}: {words}")

    def run(self, number: int, test: Circle, slope: float | None, found: PlannedJob) -> None:
        """Count a job that went through ``run``: the same correction, or none and exit 1."""
        self.all["run"] += 1
        written = slope_of(found)
        same = (
            written is None if slope is None else written is not None and abs(written - slope) < 0.1
        )
        self.all["run alike"] += same
        if not same:
            self.note(number, test, f"decided {slope}, run wrote {written}, exit {found.exit_code}")

    def scale(self, number: int, test: Circle, found: PlannedJob) -> None:
        """Count a job that asks for the scales."""
        self.all["scale jobs"] += 1
        self.all["scale exit 0"] += found.exit_code == 0
        slopes = scale_slopes(found)
        self.all["scale corrected"] += bool(slopes)
        for axis, slope in slopes.items():
            true = test.values[f"scale_error_{axis}"]
            if found.exit_code == 0 and abs(true - slope) > abs(true):
                self.all["scale worse"] += 1
                self.note(number, test, f"scale {true:.1f} µm/m corrected by {slope:.1f}")

    def note(self, number: int, test: Circle, words: str) -> None:
        """Print a case."""
        where = f"{number} {test.kind} {test.start:.0f}+{test.extent:.0f}"
        print(f"{where}: {words}", flush=True)

    def show(self, arcs: int) -> None:
        """Print the counts so far."""
        counts = ", ".join(f"{name} {count}" for name, count in self.all.items())
        print(f"{arcs} arcs: {counts}", flush=True)


def scale_slopes(found: PlannedJob) -> dict[str, float]:
    """Return what is taken off the scale of each axis, µm/m, by ``first`` and ``second``."""
    slopes = {}
    for side, name in zip(AXES, "XY", strict=True):
        table = found.results.prediction["axes"].get(name, {}).get("table")
        if table:
            slopes[side] = float(-1e3 * np.polyfit(table["positions"], table["correction"], 1)[0])
    return slopes


def main() -> None:
    """Print the counts and the cases."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=100)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    counts, started = Counts(), time.perf_counter()
    with tempfile.TemporaryDirectory() as text:
        folder = Path(text)
        for number in range(arguments.count):
            rng = np.random.default_rng([arguments.seed, number])
            test = circle(rng, KINDS[number % len(KINDS)])
            test.write(folder / "xy.csv", rng)
            slope, small, doubted = decided((folder / "xy.csv").read_text(encoding="utf-8"))
            counts.all["doubted"] += doubted
            counts.squareness(number, test, slope, folder, small=small)
            if number % _RUN_EVERY == 0:
                counts.run(number, test, slope, run(folder, "{squareness: {XY: Y}}"))
                counts.scale(number, test, run(folder, "{scale: [X, Y]}"))
                counts.show(number + 1)
    counts.show(arguments.count)
    print(f"{(time.perf_counter() - started) / arguments.count:.1f} s an arc")


if __name__ == "__main__":
    main()
