"""``demo``: the whole loop on a virtual machine: measure, compensate, load, measure again,
verify.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from compwright.foundations import storage
from compwright.jobs.reading import read_job
from compwright.workflow.commands.run import RunOutcome, run_job
from compwright.workflow.commands.simulate import load_machine, simulate_files
from compwright.workflow.commands.verify import VerifyOutcome, verify_job

MACHINE = """\
# A virtual machining centre: three linear axes with the errors of ball screws, and a tilting axis that does not wrap.
virtual_machine: 1
machine: {name: Virtual VMC 850, serial: DEMO-1}
controller: {format: siemens-840d-sl}
axes:
  X:
    travel: [0, 850]
    address: AX1
    error:
      slope_um_per_m: 22
      smooth: {amplitude_um: 5, length_mm: 220, seed: 11}
      screw: [{period_mm: 10, amplitude_um: 0.8, phase_deg: 40}]
      reversal: {mean_um: -5.5, varies_um: 0.6, seed: 4}
      noise_um: 0.5
      drift_um: 1.0
    test: {targets: 18, runs: 5}
  Y:
    travel: [-500, 0]
    address: AX2
    reference_return: "-"
    error:
      slope_um_per_m: -31
      smooth: {amplitude_um: 3, length_mm: 150, seed: 12}
      reversal: {mean_um: -3, varies_um: 0.3, seed: 5}
      noise_um: 0.4
    test: {targets: 11, runs: 5}
  Z:
    travel: [-510, 0]
    address: AX3
    error:
      slope_um_per_m: 14
      smooth: {amplitude_um: 4, length_mm: 180, seed: 13}
      reversal: {mean_um: -7, seed: 6}
      noise_um: 0.6
    test: {targets: 11, runs: 5}
  A:
    kind: rotary
    travel: [-30, 120]
    address: AX4
    error:
      slope_arcsec_per_deg: 0.08
      smooth: {amplitude_arcsec: 6, length_deg: 60, seed: 14}
      reversal: {mean_arcsec: -5}
      noise_arcsec: 0.8
    test: {targets: 16, runs: 5}
"""  # noqa: E501 - the first line of a file that users get

JOB = """\
# The job of the demo: what the engineer writes. See docs/job-file.md for every key.
compwright: 1
machine: {name: Virtual VMC 850, serial: DEMO-1, type: vertical machining centre (simulated)}
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X:
    travel: [0, 850]
    address: AX1
    screw_pitch: 10
    before: [before/x.csv]
    accept: {A: 10, B: 3}
  Y:
    travel: [-500, 0]
    address: AX2
    reference_return: "-"
    before: [before/y.csv]
    accept: {A: 8, B: 3}
  Z:
    travel: [-510, 0]
    address: AX3
    before: [before/z.csv]
    accept: {A: 8, B: 3}
  A:
    kind: rotary
    travel: [-30, 120]
    address: AX4
    before: [before/a.csv]
    accept: {A: 12}
"""


@dataclass(frozen=True, slots=True)
class DemoOutcome:
    """The two halves of the demo and where their pages are."""

    run: RunOutcome
    verification: VerifyOutcome
    folder: Path


def run_demo(out: Path, *, force: bool = False) -> DemoOutcome:
    """Play the whole loop below ``out``: machine, measurement, job, tables, measurement with the
    tables loaded, verification.

    Raises StorageError when a file exists (unless ``force``) or cannot be written.
    """
    files = {"machine.yaml": MACHINE.encode(), "job.yaml": JOB.encode()}
    machine_file, job_file = storage.write_files(
        out, files, force=force, known=lambda name, content: content == files[name]
    )
    machine = load_machine(machine_file)
    simulate_files(machine, out / "before", seed=1, force=force)
    job = read_job(storage.read_bytes(job_file), str(job_file))
    result = out / "job"
    run = run_job(job, out, result, force=force)
    tables = result / "tables" / job.format
    after = simulate_files(machine, out / "after", seed=2, tables=tables, force=force)
    verification = verify_job(
        job, [str(path) for path in after], plan_file=result / "plan.json", out=result, force=force
    )
    return DemoOutcome(run=run, verification=verification, folder=out)
