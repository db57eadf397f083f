"""How often the stated U of a parameter holds the difference between a test and the same test
without instrument and environment: simulated axes with known truth, by geometry.

    PYTHONPATH=src python benchmarks/bench_uncertainty.py [TESTS] [--kind WORD] [--draws N]

k = 2 of the normal law is 95.45 %. With TESTS tests the standard error of a share is
sqrt(0.0455 * 0.9545 / TESTS): 1.0 % for 400.

Measured over 93 kinds of axes, in % (docs/evaluation.md has the range):

    scatter of the axis over that of the environment     A     E     M     R     B   mean B
    0.35                                               97.5  94.9  95.5  99.1  95.4   95.3
    1.4                                                93.7  94.8  94.9  94.5  95.2   95.5
    7                                                  95.5  95.0  95.3  95.2  95.8   95.8
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from unittest.mock import patch

import numpy as np

from compwright.evaluation.standards import evaluate
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.positioning import PositioningTest
from compwright.records.result import PositioningResult

NAMES = ("A", "A_positive", "E", "E_positive", "M", "R", "R_positive", "B", "B_mean")
UM = 1e-3
ARCSEC = 1.0 / 3600.0
Curve = Callable[[FloatArray, np.random.Generator], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True)
class Case:
    """A kind of axis (curve in + and - over 0 to 1, µm or arcsec), its own scatter, its test and
    what the environment and the instrument add.
    """

    name: str
    curve: Curve
    scatter: float = 0.6
    targets: int = 11
    runs: int = 5
    E_VE: float = 1.5
    length: float = 1000.0
    U_theta: float = 0.1
    per_m: float = 0.5
    kind: AxisKind = AxisKind.LINEAR
    missing: float = 0.0


def flat(u: FloatArray, _rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    return 0.0 * u, 0.0 * u - 0.3


def slope(u: FloatArray, _rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    return 25.0 * u, 25.0 * u - 1.0


def reversal(u: FloatArray, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    return 0.4 * u, 0.4 * u - 6.0 + 0.5 * rng.normal() * u


def varying(u: FloatArray, _rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    return 2.0 * u**2, 2.0 * u**2 - 3.0 - 2.0 * np.sin(5.0 * u)


def wave(u: FloatArray, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    c = 3.0 * np.sin(2.0 * np.pi * u * rng.uniform(0.5, 3.0) + rng.uniform(0.0, 6.0))
    return c, c - 1.0


def walk(u: FloatArray, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    c = np.cumsum(rng.normal(size=u.size)) * 2.5 / np.sqrt(u.size)
    return c, c - rng.uniform(0.0, 2.0)


def screw(u: FloatArray, rng: np.random.Generator) -> tuple[FloatArray, FloatArray]:
    c = 1.5 * np.sin(2.0 * np.pi * 97.3 * u + rng.uniform(0.0, 6.0)) + 4.0 * u
    return c, c - 0.8


CURVES: tuple[Curve, ...] = (flat, slope, reversal, varying, wave, walk, screw)
#: targets, runs
TESTS = ((5, 5), (11, 5), (21, 3), (60, 5), (12, 10), (30, 2), (9, 1), (40, 1))
SCATTERS = {"quiet": 0.15, "": 0.6, "noisy": 3.0}


def cases() -> Iterator[Case]:
    """Yield every kind of axis with every test, and some that are apart."""
    for curve in CURVES:
        for targets, runs in TESTS:
            for word, scatter in SCATTERS.items():
                if runs > 1 or not word:
                    name = f"{curve.__name__} {word}".strip()
                    yield Case(name, curve, scatter=scatter, targets=targets, runs=runs)
    for curve in (flat, slope, wave):
        yield Case(f"short {curve.__name__}", curve, length=120.0, targets=6)
        yield Case(
            f"long {curve.__name__}",
            curve,
            length=6000.0,
            targets=25,
            runs=1,
            E_VE=4.0,
            U_theta=0.3,
        )
        yield Case(f"length alone {curve.__name__}", curve, E_VE=0.0, U_theta=0.5)
        yield Case(f"environment alone {curve.__name__}", curve, per_m=0.0, U_theta=0.0)
        yield Case(f"missing readings {curve.__name__}", curve, missing=0.08, targets=15)
        yield Case(
            f"rotary {curve.__name__}", curve, kind=AxisKind.ROTARY, targets=12, length=330.0
        )


def one(case: Case, rng: np.random.Generator) -> dict[str, tuple[bool, float]]:
    """Return for a fresh test whether U holds, and U in µm or arcsec."""
    unit = UM if case.kind is AxisKind.LINEAR else ARCSEC
    m, n = case.targets, case.runs
    u = (np.arange(m) + 0.5 + rng.uniform(-0.3, 0.3, m)) / m
    made = rng.random((2, m, n)) >= case.missing
    truth = np.stack(case.curve(u, rng))[:, :, np.newaxis]
    truth = truth + case.scatter * rng.standard_normal((2, m, n))
    thermal = Thermal(alpha_m=11.5, T_m=20.0)
    budget = UncertaintyBudget(
        device_per_m=case.per_m, U_theta=case.U_theta, E_VE=case.E_VE, device=0.0
    )
    per_m = 0.5 * np.hypot(case.per_m, 11.5 * case.U_theta) * rng.standard_normal()
    added = per_m * u[:, np.newaxis] * case.length / 1000.0 * (case.kind is AxisKind.LINEAR)
    seen = truth + added + (rng.random((2, m, n)) - 0.5) * case.E_VE

    def parameters(readings: FloatArray, given: UncertaintyBudget | None) -> PositioningResult:
        blocks = np.where(made, readings, np.nan) * unit
        test = PositioningTest(
            name="t",
            axis="X",
            kind=case.kind,
            targets=u * case.length,
            positive=blocks[0],
            negative=blocks[1],
            runs_positive=tuple(range(n)),
            runs_negative=tuple(range(n)),
        )
        return evaluate(test, budget=given, thermal=thermal)

    without, result = parameters(truth, None).parameters, parameters(seen, budget)
    found = {}
    for name in NAMES:
        value, true = result.parameters[name], without[name]
        if value is not None and true is not None and result.uncertainty is not None:
            U = result.uncertainty[name].U
            found[name] = (abs(value - true) <= U * (1.0 + 1e-9) + 1e-12, U / unit)
    return found


def main() -> None:
    """Print the share held, in per cent, and the mean U of each parameter."""
    parser = argparse.ArgumentParser()
    parser.add_argument("tests", type=int, nargs="?", default=200)
    parser.add_argument("--kind", default="", help="cases whose name holds this word")
    parser.add_argument("--draws", type=int, help="for each U, instead of the usual number")
    given = parser.parse_args()
    if given.draws:
        patch("compwright.evaluation.uncertainty.DRAWS", (given.draws, given.draws)).start()
    print(f"{'':28}{'m':>4}{'n':>4}" + "".join(f"{name:>16}" for name in NAMES))
    for number, case in enumerate(cases()):
        if given.kind not in case.name:
            continue
        rng = np.random.default_rng([number, 23])
        every = [one(case, rng) for _ in range(given.tests)]
        cells = []
        for name in NAMES:
            held = [each[name] for each in every if name in each]
            share, mean = np.mean(held, axis=0) if held else (0.0, 0.0)
            cells.append(f"{f'{100 * share:.1f} ({mean:.2f})' if held else '-':>16}")
        print(f"{case.name:28}{case.targets:4d}{case.runs:4d}" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
