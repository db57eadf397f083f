"""Tables that others would make from the same test, and those that know the truth; and the
parameters of ISO 230-2 written out a second time.

A table: nodes (k,) and corrections (2, k) in µm (arcsec), for + and -, straight lines between.
Readings (2, m, n), as in ``machines``.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from informed import Informed, without_period
from machines import Machine
from numpy.typing import NDArray
from scipy.interpolate import make_smoothing_spline
from scipy.optimize import linprog

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Table:
    """Corrections at nodes; ``turn``: after which they repeat."""

    points: Floats
    corrections: Floats
    turn: float | None = None

    def at(self, x: Floats) -> Floats:
        """Correction (2, len(x))."""
        return np.stack(
            [np.interp(x, self.points, one, period=self.turn) for one in self.corrections]
        )


def parameters(readings: Floats, signs: tuple[int, ...]) -> dict[str, float]:
    """A, E, R, B, M of ISO 230-2:2006 (clauses 2.11 to 2.24, k = 2), as far as the test has them;
    those of the one direction where only one was run.
    """
    used = readings[[0 if sign > 0 else 1 for sign in signs]]
    mean = used.mean(axis=2)
    values = {"E": float(mean.max() - mean.min())}
    if used.shape[2] > 1:
        s = used.std(axis=2, ddof=1)
        values["A"] = float((mean + 2 * s).max() - (mean - 2 * s).min())
        values["R"] = float((4 * s).max())
    if len(signs) == 2:
        b = mean[0] - mean[1]
        values["B"] = float(np.abs(b).max())
        values["M"] = float(np.ptp(mean.mean(axis=0)))
        if "A" in values:
            values["R"] = float(max(values["R"], (2 * s[0] + 2 * s[1] + np.abs(b)).max()))
    return values


def rivals(
    machine: Machine, readings: Floats, nodes: Floats, warm: float, known: Informed
) -> dict[str, Table]:
    """Return the tables of the others, by name.

    ``oracle``: expected squares on the same nodes, from the true curves as they were in the first
    test (``warm``: what its temperature added over the travel), without drift; ``oracle, one
    table``: one curve and a constant reversal. ``interpolation``: of the means; ``spline``:
    smoothing spline by generalised cross-validation; ``minimax``: the least A of the test itself
    (linear program), on as many nodes as there are targets; ``informed``, ``period unknown`` (if
    the job gives none): see that module. One curve and a constant reversal where the job asks for
    one table.
    """
    x = machine.targets
    complete = _both(readings, machine.signs)
    mean = np.nanmean(complete, axis=2)
    spread = np.nanstd(complete, axis=2, ddof=1) if machine.runs > 1 else np.zeros_like(mean)
    mean = mean - mean.mean()
    if machine.mode == "single":
        mean = _flat(mean)
    dense = np.linspace(machine.low, machine.high, max(2001, 5 * nodes.size))
    slope = warm * (dense - machine.low) / machine.length
    truth = _both(machine.error(dense), machine.signs) + slope
    best = _both(known.error(dense), machine.signs)
    turn = machine.turn
    found = {}
    if not machine.told and not turn:
        searched = without_period(machine, readings, dense)
        found["period unknown"] = Table(nodes, -_squares(nodes, dense, searched, turn), turn)
    return {
        **found,
        "oracle": Table(nodes, -_squares(nodes, dense, truth, turn), turn),
        "oracle, one table": Table(nodes, -_squares(nodes, dense, _flat(truth), turn), turn),
        "informed": Table(
            nodes,
            -_squares(nodes, dense, _flat(best) if machine.mode == "single" else best, turn),
            turn,
        ),
        "interpolation": Table(x, -mean, turn),
        "spline": Table(nodes, -np.stack([_spline(x, one, nodes) for one in mean]), turn),
        "minimax": _minimax(machine, x, mean, spread),
    }


def _both(values: Floats, signs: tuple[int, ...]) -> Floats:
    """Where one direction was not run, the other one stands for it."""
    return values if len(signs) == 2 else np.repeat(values[[0 if signs[0] > 0 else 1]], 2, axis=0)


def _flat(curves: Floats) -> Floats:
    """One curve and the mean reversal."""
    middle, half = curves.mean(axis=0), (curves[0] - curves[1]).mean() / 2
    return np.stack([middle + half, middle - half])


def _hats(nodes: Floats, x: Floats, turn: float | None) -> Floats:
    return np.stack([np.interp(x, nodes, one, period=turn) for one in np.eye(nodes.size)], axis=1)


def _squares(nodes: Floats, dense: Floats, curves: Floats, turn: float | None) -> Floats:
    spare = 1e-9 * np.eye(nodes.size)  # nodes beyond the travel, the doubled one of a turn
    hats = _hats(nodes, dense, turn)
    return np.asarray(np.linalg.solve(hats.T @ hats + spare, hats.T @ curves.T).T)


def _spline(x: Floats, mean: Floats, nodes: Floats) -> Floats:
    inside = np.clip(nodes, x[0], x[-1])
    return np.asarray(make_smoothing_spline(x, mean)(inside))


def _minimax(machine: Machine, x: Floats, mean: Floats, spread: Floats) -> Table:
    """Unknown: corrections of + and -, highest, lowest, and the size of every second difference,
    which decides among equals.
    """
    k = min(x.size, 60)
    nodes = np.linspace(machine.low, machine.high, k)
    hats, bends = _hats(nodes, x, None), np.diff(np.eye(k), 2, axis=0)
    zero, m, b = np.zeros((x.size, k)), x.size, k - 2
    both = np.block([[hats, zero], [zero, hats]])
    curved = np.block([[bends, np.zeros((b, k))], [np.zeros((b, k)), bends]])
    one, none = np.ones((2 * m, 1)), np.zeros((2 * m, 1))
    slack = np.zeros((2 * m, 2 * b))
    rows = np.block(
        [
            [both, -one, none, slack],
            [-both, none, one, slack],
            [curved, np.zeros((2 * b, 2)), -np.eye(2 * b)],
            [-curved, np.zeros((2 * b, 2)), -np.eye(2 * b)],
        ]
    )
    high, low = (mean + 2 * spread).ravel(), (mean - 2 * spread).ravel()
    limits = np.concatenate([-high, low, np.zeros(4 * b)])
    cost = np.concatenate([np.zeros(2 * k), [1, -1], np.full(2 * b, 1e-3)])
    free: list[tuple[float | None, float | None]] = [(None, None)] * (2 * k + 2)
    bounds = free + [(0, None)] * (2 * b)
    solved = linprog(cost, A_ub=rows, b_ub=limits, bounds=bounds)
    corrections = solved.x[: 2 * k].reshape(2, k) if solved.status == 0 else -np.zeros((2, k))
    return Table(nodes, corrections - corrections.mean())
