"""``run``, whole process with report, over nodes, axes, targets and known periods: seconds, and the
largest memory of one process. Prints, judges nothing.

``python benchmarks/bench_growth.py [PLOT.svg|.png] [--most SECONDS]``: a figure of all four where a
path is given; a series ends where a run takes longer than ``--most`` (30). On two processors, where
the system lets us.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from measure import COMPWRIGHT, environment, once, two_processors

TRAVEL = 4000.0  # mm
TARGETS = 41
SERIES: Mapping[str, tuple[int, ...]] = {
    "nodes": (51, 201, 501, 1001, 2001, 4001),  # a control holds 5000 at most
    "axes": (1, 2, 5, 10, 20, 31),
    "targets": (11, 41, 101, 201, 401, 801),
    "periods": (0, 1, 10, 30, 100),
}


@dataclass(frozen=True)
class Cost:
    """Wall seconds of a run, processor seconds of all its processes, and the largest memory of one
    of them, MB (the last two 0 where the system does not tell).
    """

    seconds: float
    processor: float
    megabytes: float


def prepare(
    folder: Path, *, nodes: int = 0, axes: int = 1, targets: int = TARGETS, periods: int = 1
) -> Path:
    """Write a job with measured axes of 4 m into ``folder`` and return it. ``nodes``: of each
    table, 0: as the tool chooses; ``periods``: how many the job knows.
    """
    folder.mkdir()
    machine = ["virtual_machine: 1\ncontroller: {format: siemens-840d-sl}\naxes:"]
    job = ["compwright: 1\ncontroller: {format: siemens-840d-sl}\nstates: {as_found: none}\naxes:"]
    for index in range(1, axes + 1):
        head = f"  X{index}:\n    travel: [0, {TRAVEL:g}]\n    address: AX{index}\n"
        machine.append(
            f"{head}    error: {{slope_um_per_m: {10 + index % 7}, smooth: {{amplitude_um:"
            f" {4 + index % 5}, seed: {index}}}, screw: [{{period_mm: 10, amplitude_um: 1}}],"
            f" reversal: {{mean_um: -{3 + index % 4}}}, noise_um: 0.5}}\n"
            f"    test: {{targets: {targets}}}"
        )
        known = ", ".join(f"{10 + 1.5 * one:g}" for one in range(periods))
        job.append(
            f"{head}    before: [x{index}.csv]"
            + (f"\n    table: {{spacing: {TRAVEL / (nodes - 1):.10g}}}" if nodes else "")
            + (f"\n    screw_pitch: [{known}]" if periods else "")
        )
    machine_file, job_file = folder / "machine.yaml", folder / "job.yaml"
    machine_file.write_text("\n".join(machine) + "\n", encoding="utf-8")
    job_file.write_text("\n".join(job) + "\n", encoding="utf-8")
    once([*COMPWRIGHT, "simulate", str(machine_file), "--out", str(folder)])
    return job_file


def cost(job: Path) -> Cost:
    """Run a job as a process of its own."""
    command = [*COMPWRIGHT, "run", str(job), "--force", "--accept-worse"]
    start = time.perf_counter()
    running = subprocess.Popen(
        command, env=environment(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
    )
    processor, largest = _used_by(running)
    seconds = time.perf_counter() - start
    if running.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(command)} ended with {running.returncode}")
    return Cost(seconds, processor, largest)


def _used_by(running: subprocess.Popen[bytes]) -> tuple[float, float]:
    """Wait for a process; return the processor seconds of it and of those that it started, and the
    largest memory of one of them, MB.
    """
    if not hasattr(os, "wait4"):  # not told on Windows
        running.wait()
        return 0.0, 0.0
    _, status, usage = os.wait4(running.pid, 0)
    running.returncode = os.waitstatus_to_exitcode(status)
    unit = 1024.0**2 if sys.platform == "darwin" else 1024.0
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / unit


def measured(most: float, each: Callable[[str, int, Cost], None]) -> dict[str, dict[int, Cost]]:
    """Run every series and tell ``each`` result."""
    found: dict[str, dict[int, Cost]] = {}
    with tempfile.TemporaryDirectory() as name:
        cost(prepare(Path(name) / "first"))  # not counted: it compiles the modules
        for series, sizes in SERIES.items():
            found[series] = {}
            for size in sizes:
                job = prepare(Path(name) / f"{series}-{size}", **{series: size})
                found[series][size] = cost(job)
                each(series, size, found[series][size])
                if found[series][size].seconds > most:
                    break
    return found


def draw(found: Mapping[str, Mapping[int, Cost]], path: Path) -> None:
    """Draw seconds and memory over each size; both axes from zero, so that growth in proportion is
    a straight line.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9.0, 4.6), layout="constrained")
    panels = figure.subplots(2, len(found), sharex="col", sharey="row")
    for column, (series, costs) in zip(panels.T, found.items(), strict=True):
        sizes = list(costs)
        column[0].plot(sizes, [one.seconds for one in costs.values()], "o-", markersize=3)
        column[0].plot(sizes, [one.processor for one in costs.values()], "x:", markersize=3)
        column[1].plot(sizes, [one.megabytes for one in costs.values()], "s-", markersize=3)
        column[1].set_xlabel(series)
    # A limit that is set ends the search for the others: only once everything is drawn.
    for panel in panels.flat:
        panel.set_xlim(left=0)
        panel.set_ylim(bottom=0)
        panel.grid(visible=True, linewidth=0.4)
    panels[0][0].set_ylabel("seconds\n(dotted: of processors)")
    panels[1][0].set_ylabel("MB, largest process")
    figure.suptitle("run, whole process with report: 1 axis, 41 targets, else as named")
    figure.savefig(path, metadata={"Date": None} if path.suffix == ".svg" else None)


def main(words: Sequence[str] | None = None) -> None:
    """Print a line per run; draw the figure where a path is given."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", maxsplit=1)[0])
    parser.add_argument("plot", type=Path, nargs="?")
    parser.add_argument("--most", type=float, default=30.0, help="seconds, then a series ends")
    given = parser.parse_args(words)
    print(f"whole processes on {two_processors()}")

    def told(series: str, size: int, one: Cost) -> None:
        print(
            f"{size:6} {series:8} {one.seconds:6.2f} s, processor {one.processor:6.2f} s,"
            f" {one.megabytes:4.0f} MB",
            flush=True,
        )

    found = measured(given.most, told)
    if given.plot is not None:
        draw(found, given.plot)


if __name__ == "__main__":
    main()
