"""Start-up: ``--help`` and ``evaluate`` of one test or circle, in turn with ``python -c "import
numpy"``. Prints ratios, judges nothing.
"""

from __future__ import annotations

import tempfile
from pathlib import Path

from large_files import circular_csv
from measure import COMPWRIGHT, NUMPY, in_turn, spread, two_processors

RUNS = 11


def deviation(i: int, direction: str, run: int) -> float:
    return 0.9 * i + 0.3 * run * (-1.0) ** i + (2 if direction == "-" else 0)


def a_test(path: Path) -> Path:
    """Write one test of 11 targets, 5 runs each way, in the long form of the plain CSV."""
    rows = ["# axis: X", "# cycle: standard", "target_mm,direction,run,deviation_um"]
    rows += [
        f"{100 * i + 7 * (i % 3)},{direction},{run},{deviation(i, direction, run):.2f}"
        for i in range(11)
        for direction in "+-"
        for run in range(1, 6)
    ]
    path.write_text("\n".join(rows) + "\n", encoding="utf-8")
    return path


def main() -> None:
    """Print a row per command: wall and processor seconds, ratio of the wall seconds to numpy, and
    what is wanted.
    """
    print(f"whole processes on {two_processors()}, {RUNS} pairs, min / median / max")
    with tempfile.TemporaryDirectory() as folder:
        test = str(a_test(Path(folder) / "x.csv"))
        circles = {rows: str(Path(folder) / f"{rows}.csv") for rows in (1_500, 100_000)}
        for rows, circle in circles.items():
            circular_csv(Path(circle), rows)
        for name, words, wanted in (
            ("--help", ["--help"], 0.5),
            ("evaluate, table", ["evaluate", test], 1.5),
            ("evaluate, --json -", ["evaluate", test, "--json", "-"], 1.5),
            *(
                (f"circle of {rows}", ["evaluate", circle, "--json", "-"], 15.0)
                for rows, circle in circles.items()
            ),
        ):
            pairs = in_turn([*COMPWRIGHT, *words], NUMPY, RUNS)
            ratios = [one.wall / other.wall for one, other in pairs]
            wall, cpu = ([getattr(one, clock) for one, _ in pairs] for clock in ("wall", "cpu"))
            print(
                f"{name:20} wall {spread(wall, 3)} s, processor {spread(cpu, 3)} s,"
                f" ratio to import numpy {spread(ratios)}; wanted below {wanted}"
            )


if __name__ == "__main__":
    main()
