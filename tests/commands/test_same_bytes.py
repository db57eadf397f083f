"""The same job gives the same bytes, whatever the processor, its kernels and the threads of the
linear algebra, and whether axes are worked on side by side.

The last bits of sums and of exponentials differ between them: in files they must not show.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from compwright.records.rounding import rounded, rounded_number

SOURCE = Path(__file__).resolve().parents[2] / "src"
MACHINE = """
virtual_machine: 1
controller: {format: siemens-840d-sl}
axes:
  X:
    travel: [0, 500]
    address: AX1
    error: {slope_um_per_m: 21, smooth: {amplitude_um: 4, seed: 2}, reversal: {mean_um: -4.3},
      screw: [{period_mm: 16, amplitude_um: 1.5}], noise_um: 0.4, drift_um: 1.5}
    test: {targets: 17}
  B:
    kind: rotary
    travel: [-30, 120]
    address: AX2
    error: {slope_arcsec_per_deg: 0.07, smooth: {amplitude_arcsec: 5, seed: 3},
      reversal: {mean_arcsec: -4, varies_arcsec: 1, seed: 4}, noise_arcsec: 0.7}
    test: {targets: 9}
circles:
  xy: {plane: XY, radius_mm: 150, feed_mm_min: 1000, centre: [250, 0], error: {noise_um: 0.3,
    squareness_um_per_m: 20, offset_um: [9, -7], X: {lost_motion_um: 3}}}
"""
JOB = """
compwright: 1
controller: {format: siemens-840d-sl}
states: {as_found: none}
axes:
  X: {travel: [0, 500], address: AX1, before: [x.csv], accept: {A: 12}}
  B: {kind: rotary, travel: [-30, 120], address: AX2, before: [b.csv]}
circles:
  - {file: xy.csv, name: xy, centre: [250, 0]}
"""
#: One processor where the system can say so: axes in turn, else side by side.
PROGRAM = """
import os, sys
if sys.argv.pop(1) == "alone" and hasattr(os, "sched_setaffinity"):
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
from compwright.cli import main
main()
"""


def features() -> str:
    """The kernels of numpy that this processor would choose, all but the plainest."""
    found = np.show_config(mode="dicts")
    assert isinstance(found, dict)
    return " ".join(found.get("SIMD Extensions", {}).get("found", []))


def started(folder: Path, crew: str, words: list[str], **settings: str) -> subprocess.Popen[str]:
    environment = {
        **os.environ,
        "PYTHONPATH": str(SOURCE),
        "PYTHONWARNINGS": "ignore",  # of features that cannot be switched off
        **settings,
    }
    return subprocess.Popen(
        [sys.executable, "-c", PROGRAM, crew, *words],
        cwd=folder,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def test_files_and_words_are_the_same_on_every_processor(tmp_path: Path) -> None:
    folders = [tmp_path / name for name in ("one", "other")]
    for folder in folders:
        folder.mkdir()
        (folder / "machine.yaml").write_text(MACHINE, encoding="utf-8")
        (folder / "job.yaml").write_text(JOB, encoding="utf-8")
    settings = (
        ("alone", {"OPENBLAS_NUM_THREADS": "1"}),
        (
            "several",
            {
                "OPENBLAS_NUM_THREADS": "2",
                "OPENBLAS_CORETYPE": "Prescott",
                "NPY_DISABLE_CPU_FEATURES": features(),
                "PYTHONHASHSEED": "7",
            },
        ),
    )
    said = []
    for words in (["simulate", "machine.yaml", "--out", "."], ["run", "job.yaml"]):
        running = [
            started(folder, crew, words, **chosen)
            for folder, (crew, chosen) in zip(folders, settings, strict=True)
        ]
        try:
            said += [(*process.communicate(timeout=120), process.returncode) for process in running]
        finally:
            for process in running:
                process.kill()  # one that has ended is left alone
                process.wait()
    assert said[2][2] in (0, 1), said[2]
    assert said[0] == said[1]
    assert said[2] == said[3]
    one, other = (
        {
            str(file.relative_to(folder)): file.read_bytes()
            for file in sorted(folder.rglob("*"))
            if file.is_file()
        }
        for folder in folders
    )
    assert list(one) == list(other)
    assert {"job/plan.json", "job/prediction.json", "job/report.html"} <= set(one)
    assert [name for name in one if one[name] != other[name]] == []


def test_what_is_settled_keeps_a_picometre_and_loses_the_last_bits() -> None:
    values = np.array([0.1 + 0.2, 1e-10, -1e-12, 0.0123456785])
    assert rounded(values).tolist() == [0.3, 0.0, 0.0, 0.012345678]
    assert not np.any(np.signbit(rounded(np.array([-1e-12]))))  # no minus zero in a file
    assert rounded_number(-4e-13) == 0.0
    assert rounded_number(2.00000049, 6) == 2.0


@pytest.mark.parametrize("bits", [1, -1])
def test_neighbours_settle_alike(bits: int) -> None:
    """Sums in another order differ by some units in the last place, here by 8 of them."""
    rng = np.random.default_rng(1)
    values = rng.uniform(-0.05, 0.05, 10_000)  # mm
    moved = values + 8 * bits * np.spacing(values)
    assert np.array_equal(rounded(values), rounded(moved))
