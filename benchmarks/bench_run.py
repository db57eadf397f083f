"""``run`` of three axes, report and card included, in turn with ``python -c "import numpy"``; on
the grid that is there, in turn with ``spacing: auto``; of 20 axes with report and card as PDF, in
turn with the same job without. Prints, judges nothing. ``bench_run.py pdf``: one pair of the last.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

from measure import COMPWRIGHT, NUMPY, in_turn, once, spread, two_processors

RUNS = 5
#: Axis -> travel, slope, amplitude of the smooth error, reversal, noise (µm) and targets of the
#: virtual machine; keys of the job.
AXES: dict[str, tuple[str, float, float, float, float, int, str]] = {
    "X": ("[0, 850]", 22, 5, -5, 0.5, 18, "screw_pitch: 10, "),
    "Y": ("[-500, 0]", -31, 3, -3, 0.4, 11, ""),
    "Z": ("[-510, 0]", 14, 4, -7, 0.6, 11, ""),
}
CONTROLS = {
    "siemens-840d-sl": [f"AX{number}" for number in range(1, 21)],
    "linuxcnc": ["0", "1", "2"],
}
#: As many axes as a report in 10 s has to hold.
MANY = {f"U{number}": AXES["XYZ"[number % 3]] for number in range(1, 21)}


def prepare(
    folder: Path,
    format_id: str,
    axes: Mapping[str, tuple[str, float, float, float, float, int, str]] = AXES,
) -> Path:
    """Write a job of simulated axes into ``folder`` and return it."""
    folder.mkdir()
    machine = [f"virtual_machine: 1\ncontroller: {{format: {format_id}}}\naxes:"]
    job = [f"compwright: 1\ncontroller: {{format: {format_id}}}\nstates: {{as_found: none}}\naxes:"]
    for address, (name, (travel, slope, smooth, reversal, noise, targets, keys)) in zip(
        CONTROLS[format_id], axes.items(), strict=False
    ):
        head = f'  {name}:\n    travel: {travel}\n    address: "{address}"\n'
        error = f"{{slope_um_per_m: {slope}, smooth: {{amplitude_um: {smooth}, seed: 1}}, "
        error += f"reversal: {{mean_um: {reversal}}}, noise_um: {noise}}}"
        machine.append(f"{head}    error: {error}\n    test: {{targets: {targets}}}")
        job.append(
            f"{head}    accept: {{A: 12}}\n    before: [{name.lower()}.csv]"
            + (f"\n    {keys.rstrip(', ')}" if keys else "")
        )
    machine_file, job_file = folder / "machine.yaml", folder / "job.yaml"
    machine_file.write_text("\n".join(machine) + "\n", encoding="utf-8")
    job_file.write_text("\n".join(job) + "\n", encoding="utf-8")
    once([*COMPWRIGHT, "simulate", str(machine_file), "--out", str(folder)])
    return job_file


def second_visits(job_file: Path) -> tuple[Path, Path]:
    """Return two jobs on the control with coarse tables in it: one keeps their grid, which costs an
    offer beside the fit, one lets another be chosen.
    """
    folder = job_file.parent
    job = job_file.read_text(encoding="utf-8").replace("{A: 12}", "{A: 100}")
    old, kept, chosen = (folder / f"{name}.yaml" for name in ("old", "kept", "chosen"))
    old.write_text(_with_spacing(job, ["170", "100", "102"]), encoding="utf-8")
    once([*COMPWRIGHT, "run", str(old), "--force"])
    tables = next((folder / "old" / "tables").iterdir())
    machine = [str(folder / "machine.yaml"), "--out", str(folder)]
    once([*COMPWRIGHT, "simulate", *machine, "--with-tables", str(tables), "--force"])
    files = ", ".join(sorted(str(file) for file in tables.iterdir()))
    there = job.replace("as_found: none", f"as_found: [{files}]")
    kept.write_text(there, encoding="utf-8")
    chosen.write_text(_with_spacing(there, ["auto"] * 3), encoding="utf-8")
    return kept, chosen


def _with_spacing(job: str, spacings: list[str]) -> str:
    head, *axes = job.split("    accept:")
    wishes = (f"    table: {{spacing: {one}}}\n    accept:" for one in spacings)
    return head + "".join(wish + axis for wish, axis in zip(wishes, axes, strict=True))


def print_pdf(folder: Path, runs: int) -> None:
    """Print a row for 20 axes: what report and card as PDF add to ``run``."""
    job = prepare(folder, "siemens-840d-sl", MANY)
    plain = [*COMPWRIGHT, "run", str(job), "--force"]
    pairs = in_turn([*plain, "--report", str(folder / "report.pdf")], plain, runs)
    print(
        f"run of 20 axes to PDF: wall {spread([one.wall for one, _ in pairs])} s, processor"
        f" {spread([one.cpu for one, _ in pairs])} s, ratio to the same without PDF"
        f" {spread([one.cpu / other.cpu for one, other in pairs])}; of processor seconds the PDF is"
        f" {spread([one.cpu - other.cpu for one, other in pairs])}; wanted below 10 s"
    )


def main() -> None:
    """Print two rows per control: wall and processor seconds, and the ratio to numpy; the ratio of
    a job on the grid that is there to one that chooses.
    """
    print(f"whole processes on {two_processors()}, {RUNS} pairs, min / median / max")
    with tempfile.TemporaryDirectory() as name:
        print_pdf(Path(name) / "pdf", 1 if sys.argv[1:] == ["pdf"] else RUNS)
        if sys.argv[1:] == ["pdf"]:
            return
        for format_id in CONTROLS:
            job = prepare(Path(name) / format_id, format_id)
            pairs = in_turn([*COMPWRIGHT, "run", str(job), "--force"], NUMPY, RUNS)
            print(
                f"run of three axes, {format_id:16} wall {spread([one.wall for one, _ in pairs])}"
                f" s, processor {spread([one.cpu for one, _ in pairs])} s, ratio to import numpy"
                f" {spread([one.wall / other.wall for one, other in pairs], 1)}; wanted below 6 s"
            )
            kept, chosen = (
                [*COMPWRIGHT, "run", str(one), "--force", "--accept-worse"]
                for one in second_visits(job)
            )
            pairs = in_turn(kept, chosen, RUNS)
            print(
                f"on the grid that is there, {format_id:16} wall"
                f" {spread([one.wall for one, _ in pairs])} s, ratio to spacing: auto, processor"
                f" {spread([one.cpu / other.cpu for one, other in pairs])}"
            )


if __name__ == "__main__":
    main()
