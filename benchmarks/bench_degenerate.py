"""Valid tests that show little or no scatter, through whole commands: counts by outcome.

    python benchmarks/bench_degenerate.py [--targets N]... [--only WORD] [--format ID]...

Runs that differ by a constant (all, one alone, alternating, opposite by direction), no scatter in
one direction, at one target, at all but one, anywhere; whole steps; offsets of a metre; jumps; one
and two runs, thirty runs. Each is measured, evaluated, planned for, verified with itself, and put
into the history. Counted by exit code; 70, a code above 5, a Python warning, no end within a minute
and an absurd prediction with exit 0 (not finite, or above sixty times what the readings differ) end
it with 1.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from loaded_controls import without_reports
from numpy.typing import NDArray

Floats = NDArray[np.float64]
LENGTH = 800.0
SECONDS = 60.0
CONTROLS: dict[str, tuple[object, dict[str, Any]]] = {
    "siemens-840d-sl": ("AX1", {"cec": "available", "cec_sign": "error", "cec_tables": [0, 1]}),
    "fanuc-30i": (1, {"detection_unit": 0.001, "first_point": 100}),
    "linuxcnc": ("0", {}),
}


def cases(x: Floats, rotary: bool) -> Iterator[tuple[str, Floats, Floats]]:  # noqa: FBT001
    """Yield names and readings (m, n) in + and in -, µm or arcsec."""
    rng, m = np.random.default_rng(1), x.size
    bend = (10.0 * np.sin(x / 200.0) + 0.01 * x)[:, np.newaxis]
    curve = 10.0 * np.sin(np.radians(x))[:, np.newaxis] if rotary else bend
    one = (np.arange(m) == m // 3)[:, np.newaxis]
    still = np.zeros((m, 5))
    shapes = {
        "shifts": np.array([0.0, 1.3, -0.7, 2.2, 0.4]),
        "alternating": np.array([0.0, 1.0, 0.0, 1.0, 0.0]),
        "one run": np.array([0.0, 0.0, 1.0, 0.0, 0.0]),
        "one run by 100": np.array([0.0, 0.0, 100.0, 0.0, 0.0]),
        "drift": np.arange(5.0),
        "two runs": np.array([0.0, 1.0]),
        "thirty runs": np.arange(30.0) % 2,
    }
    for name, shift in shapes.items():
        yield name, curve + shift, curve - 3.0 + shift
        yield f"{name}, no curve", 0.0 * curve + shift, 0.0 * curve - 3.0 + shift
        yield f"{name}, opposite", curve + shift, curve - 3.0 - shift
        yield f"{name}, in + alone", curve + shift, curve - 3.0 + 0.0 * shift
    noise = [rng.standard_normal((m, 5)) for _ in range(2)]
    yield "no scatter", curve + still, curve - 3.0 + still
    yield "scatter in + alone", curve + noise[0], curve - 3.0 + still
    yield "scatter at one target", curve + one * noise[0], curve - 3.0 + still
    yield "scatter at all but one", curve + ~one * noise[0], curve - 3.0 + ~one * noise[1]
    yield "steps of 1", np.round(curve + 0.3 * noise[0]), np.round(curve - 3.0 + 0.3 * noise[1])
    yield "steps of 5", 5.0 * np.round(curve / 5.0) + still, 5.0 * np.round(curve / 5.0) + still
    yield "a line", 0.1 * x[:, np.newaxis] + still, 0.1 * x[:, np.newaxis] - 3.0 + still
    yield "a jump", curve + 100.0 * (x[:, np.newaxis] > 300.0) + still, curve - 3.0 + still
    yield "one metre off", 1e6 + curve + noise[0], 1e6 + curve - 3.0 + noise[1]
    yield "one run alone", curve + noise[0][:, :1], curve - 3.0 + noise[1][:, :1]
    yield "all zero", still, still
    yield "hundredths of a µm", 0.01 * (curve + noise[0]), 0.01 * (curve - 3.0 + noise[1])


def text_of(x: Floats, blocks: Sequence[Floats], cycle: str, rotary: bool) -> str:  # noqa: FBT001
    """Return the measurement file."""
    target, unit = ("deg", "arcsec") if rotary else ("mm", "um")
    lines = ["# axis: X", f"# cycle: {cycle}", f"target_{target},direction,run,deviation_{unit}"]
    for sign, block in zip("+-", blocks, strict=True):
        for place, row in zip(x, block, strict=True):
            lines += [f"{place:.4f},{sign},{run},{v:.4f}" for run, v in enumerate(row, start=1)]
    return "\n".join(lines) + "\n"


def job_of(control: str, rotary: bool) -> str:  # noqa: FBT001
    """Return the job file."""
    address, options = CONTROLS[control]
    axis: dict[str, Any] = {"travel": [0, LENGTH], "address": address, "before": ["x.csv"]}
    if rotary:
        axis |= {"kind": "rotary", "travel": [0, 360], "modulo": 360}
    return json.dumps(
        {
            "compwright": 1,
            "controller": {"format": control, "options": options},
            "states": {"as_found": "none"},
            "axes": {"X": axis},
        }
    )


def done(*arguments: str) -> tuple[int, str, float, list[str]]:
    """Return exit code, what was said, seconds and warnings of a command."""
    from compwright.cli import run

    said, start = io.StringIO(), time.perf_counter()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = run(list(arguments))
    seconds = time.perf_counter() - start
    return code, said.getvalue(), seconds, [str(one.message) for one in caught]


def absurd(folder: Path, blocks: Sequence[Floats]) -> bool:
    """Whether the prediction is no number, or far above anything that the readings show."""
    document = json.loads((folder / "prediction.json").read_text(encoding="utf-8"))
    differ = max(float(np.ptp(block)) for block in blocks)
    shown = document["axes"]["X"]["predicted"] or {}
    tops = [each["p95"] for each in shown.values() if each]
    return any(not np.isfinite(top) or abs(top) > 60.0 * differ + 1.0 for top in tops)


def main() -> int:
    """Work, then print."""
    reader = argparse.ArgumentParser(description="Degenerate tests through whole commands.")
    reader.add_argument("--targets", type=int, action="append")
    reader.add_argument("--only", default="")
    reader.add_argument("--format", action="append", choices=sorted(CONTROLS))
    words = reader.parse_args()
    without_reports()
    counts: dict[str, Counter[str]] = {}
    bad = 0
    for count in words.targets or [2, 11]:
        for control in words.format or list(CONTROLS):
            for rotary, cycle in ((False, "standard"), (True, "standard"), (False, "step")):
                if (rotary and control != "siemens-840d-sl") or (cycle == "step" and count < 5):
                    continue
                x = np.linspace(0.0, LENGTH, count)
                x = np.arange(count) * (360.0 / count) if rotary else x
                for name, *blocks in cases(x, rotary):
                    if words.only in name:
                        where = f"{name}, {count} targets, {control}, {cycle}"
                        text = text_of(x, blocks, cycle, rotary)
                        bad += one(where, text, job_of(control, rotary), blocks, counts)
    print("| command | " + " | ".join(KINDS) + " |\n|---|" + "---|" * len(KINDS))
    for command, some in counts.items():
        print(f"| {command} | " + " | ".join(str(some[kind]) for kind in KINDS) + " |")
    return 1 if bad else 0


KINDS = ("0", "1", "2", "3", "4", "BROKEN", "WARNED", "SLOW", "ABSURD")


def one(
    where: str, text: str, job: str, blocks: Sequence[Floats], counts: dict[str, Counter[str]]
) -> int:
    """Work on one test; returns how many of its commands are not as they should be."""
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "x.csv").write_text(text, encoding="utf-8")
        (folder / "job.yaml").write_text(job, encoding="utf-8")
        file, plan, out = (str(folder / each) for each in ("job.yaml", "out", "after"))
        for command in (
            ("evaluate", str(folder / "x.csv")),
            ("run", file, "--out", plan),
            ("verify", file, "--after", f"x={folder / 'x.csv'}", "--plan", plan, "--out", out),
            ("history", str(folder)),
        ):
            code, said, seconds, caught = done(*command)
            kind = str(code) if 0 <= code <= 4 else "BROKEN"
            kind = "WARNED" if caught else "SLOW" if seconds > SECONDS else kind
            if command[0] == "run" and code == 0 and absurd(folder / "out", blocks):
                kind = "ABSURD"
            counts.setdefault(command[0], Counter())[kind] += 1
            if not kind.isdigit():
                bad += 1
                print(f"{kind}: {command[0]}, {where}: {caught or said[-300:]}")
            if command[0] == "run" and code > 1:
                break
    return bad


if __name__ == "__main__":
    sys.exit(main())
