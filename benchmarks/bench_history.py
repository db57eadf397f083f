"""Does ``history`` tell what grows? Machines over five years, read back through the command.

    python benchmarks/bench_history.py [N] [--first F] [--seed S] [--folders M] [--list]

A machine has 10 to 20 positioning tests of one axis at irregular dates. A third of the machines are
stable, in a third the reversal error grows, in a third the slope, both linearly. A repair sets back
what has grown, a crash is a step of reversal and slope, a new instrument has its own scale error. A
hall moves the slope by expansion, in part as a season of a year, in part from test to test; two
thirds of the jobs declare it (``U_theta``), the others leave it to the 1 K of steel that
``history`` allows for. Every test has scatter of readings, shifts of whole traverses, and a
reversal and a curve that change a little from test to test. A result folder is that of one real
``run``; measurement file, job, evaluation and record are those of the test, made through the
evaluation of the package.

Prints, each with its binomial standard error:

- growth of reversal (mean B) and slope that is shown as clear with the right sign, by its size over
  the standard error of a judge who knows the noise and where the steps are; in brackets how often
  it is found by the best test that knows the steps and has to estimate the noise: a t test at 1 %,
  reversal and slope together 2 % false alarms. With 14 tests and one step that is 49 % at 3
  standard errors, 79 % at 4, 95 % at 5: no test finds 95 % at 3. What a judge finds who has to find
  the step as well: `history_judge` (seed 52: 76 % at 3 to 5, 83 of 83 at 5 to 8);
- rates within 1.645 and 2 stated standard errors of the true rate;
- stable machines with a clear rate of any parameter, with a date of a limit, and machines with a
  change or jump at a test where nothing happened;
- true date of a limit (on B, A or E) within the forecast interval, and how often one is given;
- steps (repair, crash, instrument) named at the right test, as ``changes`` or as ``jumps``.

``--folders`` (1000): then the processor seconds of one command over so many folders; 0 for none.
Exits with 1 where growth of five standard errors or more is found in less than 95 %, stable
machines with a clear rate or a wrong change are more than 2 %, or dates are held in less than 90 %,
each by more than two standard errors, or where the folders take more than 10 s.
"""

from __future__ import annotations

import argparse
import datetime as dt
import hashlib
import json
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from measure import COMPWRIGHT, environment
from numpy.typing import NDArray
from scipy import stats

import compwright
from compwright.documents.evaluation import result_document
from compwright.documents.recorded_test import measured_test
from compwright.evaluation.standards import evaluate
from compwright.records.conditions import UncertaintyBudget
from compwright.workflow.results.scatter import errors_of

Floats = NDArray[np.float64]

START = dt.date(2019, 1, 1)
YEAR = 365.25
RUNS = 5
STEEL = 11.5  # µm/(m K)
KINDS = ("stable", "reversal", "slope")
BATCH = 30


@dataclass(frozen=True, kw_only=True)
class Machine:
    """The truth of one axis over its tests; µm, µm/m, years since `START`.

    ``rate``: growth in a year of the reversal error (µm) or of the slope (µm/m). ``event``: the
    step, in reversal and slope, between the tests ``at - 1`` and ``at``. ``hall``: standard
    deviation of the slope by temperature (season and the rest alike); ``scale``: that of the
    instruments. ``noise``: of a reading, of a traverse, of the reversal and of the curve of a test.
    """

    name: str
    kind: str
    length: float
    targets: Floats
    curve: Floats
    years: Floats
    reversal: float
    rate: float
    event: str
    at: int
    step: tuple[float, float]
    declared: float
    hall: float
    scale: float
    noise: tuple[float, float, float, float]
    limit: str

    def true_reversal(self, years: Floats) -> Floats:
        """Return the true mean reversal error at these times."""
        grown = self.rate * years if self.kind == "reversal" else 0.0 * years
        return self.reversal + grown + self.step[0] * self._after(years)

    def true_slope(self, years: Floats) -> Floats:
        """Return what wear and steps add to the slope of the curve, in µm/m."""
        grown = self.rate * years if self.kind == "slope" else 0.0 * years
        return grown + self.step[1] * self._after(years)

    def _after(self, years: Floats) -> Floats:
        if not self.event or self.event == "instrument":
            return 0.0 * years
        moment = (self.years[self.at - 1] + self.years[self.at]) / 2.0
        return np.where(years > moment, 1.0, 0.0)

    def readings(self, rng: np.random.Generator) -> list[Floats]:
        """Return the deviations (2, m, n) of each test in µm: what the instrument shows."""
        single, traverse, visit, shape = self.noise
        m = self.targets.size
        along = (self.targets - self.targets.mean()) / 1000.0
        phase = rng.uniform(0.0, 2.0 * math.pi)
        season = self.hall * abs(rng.normal()) * np.cos(2.0 * math.pi * self.years + phase)
        scales = rng.normal(0.0, self.scale, 2)
        found = []
        for i, year in enumerate(self.years):
            replaced = self.event == "instrument" and i >= self.at
            slope = float(self.true_slope(np.array(year)))
            slope += season[i] + rng.normal(0.0, self.hall) + scales[int(replaced)]
            lost = float(self.true_reversal(np.array(year))) + rng.normal(0.0, visit)
            bent = rng.normal(0.0, shape) * np.sin(
                np.pi * along / np.ptp(along) * rng.integers(1, 4)
            )
            mean = self.curve + bent + slope * along + rng.normal(0.0, 1.0)
            both = np.stack([mean + lost / 2.0, mean - lost / 2.0])[:, :, None]
            found.append(
                both
                + rng.normal(0.0, single, (2, m, RUNS))
                + rng.normal(0.0, traverse, (2, 1, RUNS))
            )
        return found

    def judge(self, parameter: str) -> float:
        """Return the standard error of the rate for one who knows the noise and the steps."""
        single, traverse, visit, _ = self.noise
        m, t = self.targets.size, self.years
        along = (self.targets - self.targets.mean()) / 1000.0
        columns = [np.ones_like(t), t]
        if self.event in ("repair", "crash"):
            columns.append((np.arange(t.size) >= self.at).astype(np.float64))
        if parameter == "B_mean":
            each = 2.0 * (single**2 / (m * RUNS) + traverse**2 / RUNS) + visit**2
            spread = np.eye(t.size) * each
        else:
            each = single**2 / (2.0 * RUNS) / float(along @ along) + self.hall**2
            spread = np.eye(t.size) * each
            spread += self.hall**2 * np.cos(2.0 * math.pi * (t[:, None] - t))
            if self.event == "instrument":
                same = (np.arange(t.size) >= self.at)[:, None] == (np.arange(t.size) >= self.at)
                spread += self.scale**2 * same
        design = np.stack(columns, axis=1)
        return float(np.sqrt(np.linalg.inv(design.T @ np.linalg.solve(spread, design))[1, 1]))

    def expected(self, parameter: str, years: Floats, rng_seed: int = 5) -> Floats:
        """Return what a test without errors of hall and instrument shows on average (B, E or A)."""
        single, traverse, visit, _ = self.noise
        rng = np.random.default_rng(rng_seed)
        m, draws = self.targets.size, 300
        along = (self.targets - self.targets.mean()) / 1000.0
        scatter = rng.normal(0.0, single, (draws, 2, m, RUNS))
        scatter += rng.normal(0.0, traverse, (draws, 2, 1, RUNS))
        lost = rng.normal(0.0, visit, (draws, 1))
        means, s = scatter.mean(axis=3), scatter.std(axis=3, ddof=1)
        values = []
        for year in years:
            when = np.array(year)
            curve = self.curve + float(self.true_slope(when)) * along
            half = (float(self.true_reversal(when)) + lost) / 2.0
            mean = means + np.stack([curve + half, curve - half], axis=1)
            if parameter == "B":
                shown = np.abs(mean[:, 0] - mean[:, 1]).max(axis=1)
            else:
                wide = 2.0 * s if parameter == "A" else 0.0 * s
                shown = (mean + wide).max(axis=(1, 2)) - (mean - wide).min(axis=(1, 2))
            values.append(float(shown.mean()))
        return np.array(values)

    def budget(self) -> UncertaintyBudget:
        """Return what the job declares; nothing where ``declared`` is zero."""
        if not self.declared:
            return UncertaintyBudget()
        return UncertaintyBudget(device_per_m=2.0 * self.scale, U_theta=self.declared)


def machine(number: int, seed: int) -> Machine:
    """Draw a machine."""
    rng = np.random.default_rng([seed, number])
    kind = KINDS[number % 3]
    length, m = float(rng.uniform(400.0, 1500.0)), int(rng.integers(8, 16))
    targets = np.round((np.arange(m) + 0.5 + rng.uniform(-0.3, 0.3, m)) * length / m, 1)
    curve = rng.uniform(0.5, 3.0) * np.sin(
        2.0 * np.pi * targets / length * rng.uniform(0.4, 1.5) + rng.uniform(0.0, 6.0)
    )
    count = int(rng.integers(10, 21))
    apart = rng.uniform(0.4, 1.6, count - 1)
    years = np.concatenate([[0.0], np.cumsum(apart)]) * rng.uniform(4.5, 5.0) / apart.sum()
    years = np.round(years * YEAR) / YEAR
    declared = float(rng.uniform(0.4, 1.5)) if rng.random() < 2 / 3 else 0.0
    hall = STEEL * (declared / 2.0 if declared else 0.5) / math.sqrt(2.0)
    choice = ["", "", "crash", "instrument"] + ([] if kind == "stable" else ["repair"])
    event = str(rng.choice(choice))
    at = int(rng.integers(3, count - 2))
    sign = float(rng.choice([-1.0, 1.0]))
    rate, step = 0.0, (0.0, 0.0)
    if kind == "reversal":
        rate = -math.exp(rng.uniform(math.log(0.05), math.log(1.5)))
    elif kind == "slope":
        rate = sign * math.exp(rng.uniform(math.log(1.0), math.log(20.0)))
    if event == "crash":
        step = (float(-rng.uniform(1.0, 6.0)), float(rng.choice([-1.0, 1.0]) * rng.uniform(0, 30)))
    elif event == "repair":
        back = -0.9 * rate * float(years[at])
        step = (back, 0.0) if kind == "reversal" else (0.0, back)
    return Machine(
        name=f"machine-{number:04}",
        kind=kind,
        length=length,
        targets=targets,
        curve=curve,
        years=years,
        reversal=float(-rng.uniform(0.5, 4.0)),
        rate=rate,
        event=event,
        at=at if event else 0,
        step=step,
        declared=declared,
        hall=hall,
        scale=float(rng.uniform(0.2, 1.0)),
        noise=(
            float(rng.uniform(0.2, 0.8)),
            float(rng.uniform(0.05, 0.25)),
            float(rng.uniform(0.03, 0.2)),
            float(rng.uniform(0.05, 0.3)),
        ),
        limit=str(rng.choice(["B", "A", "E"] if kind == "reversal" else ["A", "E"])),
    )


def limit_of(made: Machine, seed: int) -> tuple[float, float | None]:
    """Return a limit and the year in which the machine reaches it; None: not by its own wear.

    Up to four years ahead of the last test; a stable machine gets 1.3 times what it shows.
    """
    rng = np.random.default_rng([seed, 77])
    last = float(made.years[-1])
    now = float(made.expected(made.limit, np.array([last]))[0])
    if made.kind == "stable":
        return 1.3 * now, None
    year = last + float(rng.uniform(0.3, 4.0))
    on_the_way = made.expected(made.limit, np.linspace(last, year + 1.0, 9))
    limit = float(made.expected(made.limit, np.array([year]))[0])
    grows = bool(np.all(np.diff(on_the_way) > 0.0))
    return (limit, year) if grows else (2.0 * limit, None)


def template(folder: Path) -> Path:
    """Return the result folder of one real run."""
    made = machine(0, 0)
    write_test(folder / "x.csv", made, 0, made.readings(np.random.default_rng(1))[0])
    (folder / "job.yaml").write_text(job_text(made, 10.0), encoding="utf-8")
    command = [*COMPWRIGHT, "run", "job.yaml", "--out", "out"]
    done = subprocess.run(command, cwd=folder, env=environment(), capture_output=True, check=False)
    if not (folder / "out" / "record.json").exists():
        sys.exit(done.stderr.decode())
    return folder / "out"


def job_text(made: Machine, limit: float) -> str:
    """Return the job file of a machine, for a control whose table is no limit."""
    axis = {
        "travel": [-5.0, round(made.length + 5.0, 1)],
        "address": 0,
        "before": ["x.csv"],
        "accept": {made.limit: round(limit, 3)},
    }
    job: dict[str, Any] = {
        "compwright": 1,
        "machine": {"name": made.name, "serial": made.name},
        "controller": {"format": "linuxcnc"},
        "states": {"as_found": "none"},
        "axes": {"X": axis},
    }
    if made.declared:
        device = {"U": 0.0, "per_m": round(2.0 * made.scale, 3)}
        job["uncertainty"] = {"device": device, "U_theta": round(made.declared, 3)}
    return json.dumps(job)


def write_test(path: Path, made: Machine, i: int, readings: Floats) -> None:
    """Write test ``i`` in the long form of the plain CSV."""
    day = START + dt.timedelta(days=round(float(made.years[i]) * YEAR))
    second = made.event == "instrument" and i >= made.at
    lines = [
        "# axis: X",
        f"# machine: {made.name}",
        f"# date: {day.isoformat()}",
        f"# instrument: laser {'B' if second else 'A'}",
        "# cycle: standard",
        "target_mm,direction,run,deviation_um",
    ]
    for word, block in zip("+-", readings, strict=True):
        for target, row in zip(made.targets, block, strict=True):
            lines += [f"{target:.1f},{word},{n + 1},{value:.2f}" for n, value in enumerate(row)]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_folders(source: Path, out: Path, made: Machine, seed: int, limit: float) -> None:
    """Write a result folder for each test: the run's, with the files of the test in their place."""
    record = json.loads((source / "record.json").read_text(encoding="utf-8"))
    del record["sha256"]  # of the entries as `run` wrote them
    record["machine"] = {"name": made.name, "serial": made.name}
    accept = {made.limit: {"limit": round(limit, 3), "decision": "undecided"}}
    record["decisions"]["axes"]["X"]["accept"] = accept
    tests = made.readings(np.random.default_rng([seed, 3]))
    for i, readings in enumerate(tests):
        folder = out / f"{made.name}-{i:02}"
        shutil.copytree(source, folder, copy_function=os.link)
        for name in ("inputs/x.csv", "inputs/job.yaml", "evaluation.json", "record.json"):
            (folder / name).unlink()
        write_test(folder / "inputs" / "x.csv", made, i, readings)
        (folder / "inputs" / "job.yaml").write_text(job_text(made, limit), encoding="utf-8")
        [test] = compwright.read(folder / "inputs" / "x.csv")
        if not isinstance(test, compwright.PositioningTest):
            raise TypeError(folder)
        result = result_document(evaluate(test, budget=made.budget()))
        if not made.declared:
            result["uncertainty"] = None
        document = {"schema": "compwright/evaluation/1", "results": [result], "errors": []}
        (folder / "evaluation.json").write_text(json.dumps(document), encoding="utf-8")
        entry = measured_test(result, "before", {"X x": "as_found"}, errors_of)
        files = [one | described(folder / one["file"]) for one in record["files"]]
        inputs = [one | described(folder / one["copy"]) for one in record["inputs"]]
        filled = {**record, "files": files, "inputs": inputs, "tests": [entry]}
        (folder / "record.json").write_text(json.dumps(filled), encoding="utf-8")


def described(path: Path) -> dict[str, Any]:
    """Return hash and size of a file as a record lists them."""
    content = path.read_bytes()
    return {"sha256": hashlib.sha256(content).hexdigest(), "size": len(content)}


def history(folder: Path) -> tuple[dict[str, Any], float]:
    """Return the answer of ``history`` over a folder, and its processor seconds."""
    answer = folder.parent / "history.json"
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [*COMPWRIGHT, "history", str(folder), "--json", str(answer), "--force"]
    done = subprocess.run(command, env=environment(), capture_output=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 1):
        sys.exit(done.stderr.decode())
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads(answer.read_text(encoding="utf-8")), seconds


@dataclass
class Share:
    """So many of so many; ``judge``: what the best test would have, case by case."""

    held: int = 0
    all: int = 0
    judge: list[float] = field(default_factory=list)

    @property
    def value(self) -> float:
        """Return the share."""
        return self.held / self.all if self.all else math.nan

    def error(self, share: float) -> float:
        """Return the standard error of the share where ``share`` is the true one."""
        return math.sqrt(share * (1.0 - share) / self.all) if self.all else math.nan

    def __str__(self) -> str:
        error = self.error((self.held + 0.5) / (self.all + 1.0))
        shown = f"{self.held} of {self.all} = {100 * self.value:.1f} ± {100 * error:.1f} %"
        if self.judge:
            shown += f" (best test {100 * float(np.mean(self.judge)):.1f} %)"
        return shown


class Tally:
    """Counts by name, and what is wrong with the machine at hand."""

    def __init__(self) -> None:
        self.shares: defaultdict[str, Share] = defaultdict(Share)
        self.wrong: list[str] = []

    def count(self, name: str, held: object, judge: float | None = None) -> None:
        """Count a case."""
        share = self.shares[name]
        share.held += bool(held)
        share.all += 1
        share.judge += [] if judge is None else [judge]

    def missed(self) -> list[str]:
        """Return what is asked and does not hold by more than two standard errors."""
        asked = (
            (FOUND, 0.95, 1),
            (FALSE, 0.02, -1),
            (MOVED, 0.02, -1),
            (HELD, 0.90, 1),
        )
        return [
            name
            for name, share, sign in asked
            if self.shares[name].all
            and sign * (self.shares[name].value - share) < -2.0 * self.shares[name].error(share)
        ]


FOUND = "found: 5 or more, both kinds"
FALSE = "false: stable machines with a clear rate"
MOVED = "false: stable machines with a change at a wrong test"
HELD = "forecast: date held"


def score(made: Machine, axis: dict[str, Any], crossing: float | None, tally: Tally) -> None:
    """Count what the answer says of one machine."""
    count_rates(made, axis["trends"], tally)
    if made.kind == "stable":
        count_false_rates(axis["trends"], tally)
    count_steps(made, axis, tally)
    if crossing is not None:
        count_date(made, axis["trends"].get(made.limit), crossing, tally)


def count_rates(made: Machine, trends: dict[str, Any], tally: Tally) -> None:
    """Count found growth and honest standard errors."""
    for name, kind in (("B_mean", "reversal"), ("slope", "slope")):
        true = made.rate if made.kind == kind else 0.0
        trend = trends.get(name)
        tally.count(f"{name}: a rate is given", trend)
        if trend is not None:
            off = abs(trend["rate_per_year"] - true) / trend["std_error"]
            tally.count(f"{name}: rate within 1.645 errors (90 %)", off < 1.645)
            tally.count(f"{name}: rate within 2 errors (95.4 %)", off < 2.0)
        if made.kind != kind:
            continue
        k = abs(true) / made.judge(name)
        clear = trend is not None and trend["clear"] and trend["rate_per_year"] * true > 0.0
        band = "below 3" if k < 3 else "3 to 5" if k < 5 else "5 to 8" if k < 8 else "8 or more"
        free = made.years.size - (3 if made.event in ("repair", "crash") else 2)
        best = float(stats.nct.sf(stats.t.ppf(0.995, free), free, k))
        for key in (f"found: {kind}, {band}", *([FOUND] if k >= 5 else [])):
            tally.count(key, clear, judge=best)
        if k >= 5 and not clear:
            shown = trend and (trend["rate_per_year"], trend["std_error"])
            tally.wrong.append(f"{name} {true:+.2f} a year ({k:.1f} errors) not clear: {shown}")


def count_false_rates(trends: dict[str, Any], tally: Tally) -> None:
    """Count what grows on a stable machine."""
    clear = [name for name, trend in trends.items() if trend["clear"]]
    crosses = [name for name, trend in trends.items() if trend["crosses"]]
    tally.count(FALSE, clear)
    for name, trend in trends.items():
        tally.count(f"false: clear {name} of stable machines", trend["clear"])
    tally.count("false: stable machines with a date of a limit", crosses)
    tally.wrong += [
        f"clear {name}: {trends[name]['rate_per_year']} ± {trends[name]['std_error']}"
        for name in clear
    ]
    tally.wrong += [f"date for {name}" for name in crosses]


def count_steps(made: Machine, axis: dict[str, Any], tally: Tally) -> None:
    """Count steps at the right test, and steps where nothing happened."""
    at = made.at if made.event else -1
    changes = {change["after"]: change["parameter"] for change in axis["changes"]}
    jumps = {
        jump["after"]: name for name, trend in axis["trends"].items() for jump in trend["jumps"]
    }
    large = abs(made.step[0]) >= 1.0 or abs(made.step[1]) >= 10.0
    size = "" if made.event == "instrument" else f" {'above' if large else 'below'} 1 µm, 10 µm/m"
    for what, found in (("change", changes), ("jump", jumps)):
        other = [
            f"{what} of {name} at {i} ({made.event or 'nothing'}, {at})"
            for i, name in found.items()
            if i != at
        ]
        if made.kind == "stable" and what == "change":
            tally.count(MOVED, other)
        else:
            tally.count(f"false: {what} at a wrong test, {made.kind}", other)
        tally.wrong += other
        if made.event:
            tally.count(f"step: {made.event}{size}, named as {what}", at in found)
    if made.event in ("repair", "crash") and large and at not in {*changes, *jumps}:
        tally.wrong.append(f"{made.event} {made.step} at {at} not named")


def count_date(made: Machine, trend: dict[str, Any] | None, crossing: float, tally: Tally) -> None:
    """Count whether the date on which the machine reaches its limit lies in the interval."""
    forecast = trend and trend["crosses"]
    tally.count(f"forecast: given for {made.limit}", forecast)
    if not forecast:
        return
    true = (START + dt.timedelta(days=round(crossing * YEAR))).isoformat()
    held = (forecast["earliest"] or "9999") <= true <= (forecast["latest"] or "9999")
    tally.count(HELD, held)
    tally.count(f"{HELD}, {made.limit}", held)
    tally.count(f"{HELD}, {made.event or 'no event'}", held)
    if not held:
        tally.wrong.append(f"{made.limit} reached {true}, forecast {forecast}")


def batches(numbers: Sequence[int]) -> Iterator[Sequence[int]]:
    """Return the numbers in portions whose folders are read by one command."""
    for i in range(0, len(numbers), BATCH):
        yield numbers[i : i + BATCH]


def timed(source: Path, folder: Path, count: int) -> float:
    """Return the processor seconds of one ``history`` over ``count`` folders."""
    written, number = 0, 0
    while written < count:
        made = machine(number, 99)
        write_folders(source, folder, made, number, 20.0)
        written, number = written + made.years.size, number + 1
    for extra in sorted(folder.iterdir())[count:]:
        shutil.rmtree(extra)
    return history(folder)[1]


def main() -> None:
    """Print the shares; exit with 1 where something asked does not hold."""
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folders", type=int, default=1000)
    parser.add_argument("--list", action="store_true", help="print every case that is not right")
    given = parser.parse_args()
    tally = Tally()
    with tempfile.TemporaryDirectory() as temporary:
        base = Path(temporary)
        source = template(base)
        for numbers in batches(range(given.first, given.first + given.count)):
            folder = base / "fleet"
            machines = {}
            for number in numbers:
                made = machine(number, given.seed)
                limit, crossing = limit_of(made, 1000 * given.seed + number)
                write_folders(source, folder, made, 1000 * given.seed + number, limit)
                machines[made.name] = (made, crossing)
            for entry in history(folder)[0]["machines"]:
                made, crossing = machines.pop(entry["name"])
                tally.wrong = []
                score(made, entry["axes"]["X"], crossing, tally)
                if given.list and tally.wrong:
                    print(made.name, made.kind, *tally.wrong, sep="\n    ", flush=True)
            if machines:
                sys.exit(f"not in the answer: {', '.join(machines)}")
            shutil.rmtree(folder)
        for name, share in sorted(tally.shares.items()):
            print(f"{name}: {share}")
        failed = tally.missed()
        if given.folders:
            seconds = timed(source, base / "many", given.folders)
            print(f"{given.folders} folders: {seconds:.1f} s of processor time")
            failed += ["time"] if seconds > 10.0 else []
    if failed:
        print("not as asked:", ", ".join(failed))
        sys.exit(1)


if __name__ == "__main__":
    main()
