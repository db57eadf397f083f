"""The shapes of the spikes after the reversals of a circular test. Several possible decays are
averaged by their probability.

After a reversal the axis deviates by its lost motion and by a spike of unknown height, rise and
decay (ISO 230-4:1996, B.3.1). The spike is a sum of up to `DECAYS` decays. One decay is a sharp
spike; a slow decay minus a fast one is a spike with a rise. Each reversal point has its own shape,
which may differ between the directions. All these shapes are hypotheses with prior probabilities.
They are drawn in proportion to their evidence, one decay at a time, with all sizes integrated out
(Gibbs sampling of collapsed models: Liu, Journal of the American Statistical Association 89, 1994;
George and McCulloch, Statistica Sinica 7, 1997).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.circle_fit import (
    CircleProblem,
    MarginalEquations,
    Reversal,
    WeightedProblem,
    fitted_path,
)
from compwright.estimation.circle_model import RARE, UM, SpikeShape, sample_spacing
from compwright.estimation.circle_noise import IndexArray
from compwright.estimation.circle_shapes import (
    DECAYS,
    PRIOR,
    SLOTS,
    THERE,
    UNLIKE,
    SpikeShapes,
    set_shape,
)
from compwright.records.axis import FloatArray

#: Sweeps over all reversal points to find the likeliest shapes, to forget the start, and to draw.
_CLIMBS: Final = 4
_FORGOTTEN: Final = 6
_SWEEPS: Final = 80
#: A spike goes inward where its depth is more than this many times its height.
INWARD: Final = 2.0
#: Added to the diagonal of scaled normal equations: readings without noise leave only rounding.
_ROUNDING: Final = 1e-10
#: Rare causes other than a spiral, which can look like lost motion, are drawn in every so many
#: sweeps.
_RARELY: Final = 3
#: Times in which reversal spikes usually die out, s, how many of them are tried, and how high, um,
#: one may be that is not seen.
_USUAL: Final = (0.015, 0.15)
_TIMES: Final = 5
_HIDDEN: Final = 4.0
#: Pairs of draws of the causes for each drawn choice of shapes.
_PAIRS: Final = 6


def choose_shapes(weighted: WeightedProblem, shapes: SpikeShapes) -> None:
    """Change the spike shapes one at a time until no change makes the fit more probable."""
    marginal = weighted.without(shapes.always)
    every = {place: _Options(marginal, shapes, *place) for place in shapes.slots()}
    places: list[tuple[int, int] | str] = [*every, *shapes.rare]
    changes, compared = 0, dict.fromkeys(places, -1)
    for _ in range(_CLIMBS):
        start = changes
        for place, last in compared.items():
            if last == changes:  # with the same others the same shape is the most probable
                continue
            before = shapes.at(place)
            if isinstance(place, str):
                shapes.present[place] = int(np.argmax(_odds(marginal, shapes, place)[0])) - 1
            else:
                set_shape(shapes, *place, int(np.argmax(every[place].evidence(marginal, shapes))))
            changes += shapes.at(place) != before
            compared[place] = changes
        if changes == start:
            break


class _Tried:
    """Columns (t,) that are tried as additions to a fit, with their normal equations."""

    def __init__(self, marginal: MarginalEquations, columns: IndexArray) -> None:
        self.rows = marginal.gram[columns].T  # symmetric: rows are quicker to take
        self.weight = np.maximum(marginal.gram[columns, columns], 0.0)
        self.right = marginal.right[columns]

    def added(
        self, marginal: MarginalEquations, shapes: SpikeShapes, chosen: IndexArray
    ) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return the normal equations of the tried columns after a fit with the ``chosen`` columns.

        The results are the right side (t,), the weight (t,) without the priors of the columns, and
        the inner products (c, t) with the chosen columns (columns added to a regression with normal
        priors: Seber and Lee, Linear Regression Analysis, 2nd ed. 2003, section 3.7).
        """
        if not chosen.size:
            return self.right, self.weight, np.zeros((0, self.right.size))
        normal = marginal.gram[chosen[:, np.newaxis], chosen]
        diagonal = slice(None, None, chosen.size + 1)
        normal.flat[diagonal] += shapes.precision[chosen]
        unit = 1.0 / np.sqrt(normal.diagonal())
        normal *= unit * unit[:, np.newaxis]
        normal.flat[diagonal] += _ROUNDING
        root = np.linalg.inv(np.linalg.cholesky(normal)) * unit
        known = root @ self.rows[chosen]
        weight = np.maximum(self.weight - np.einsum("ct,ct->t", known, known), 0.0)
        return self.right - known.T @ (root @ marginal.right[chosen]), weight, known


def _odds(
    marginal: MarginalEquations, shapes: SpikeShapes, name: str
) -> tuple[FloatArray, FloatArray]:
    """Return the log probability of each possibility of a rare cause: absent, or one of its m
    shapes (1 + m,), and the standard error of its size for each shape (m,).
    """
    columns = np.array(shapes.rare[name])
    rest, found, _ = _Tried(marginal, columns).added(marginal, shapes, shapes.chosen(name))
    prior = shapes.precision[columns]
    weight = found + prior
    gain = 0.5 * rest**2 / weight - 0.5 * np.log(weight / prior)
    there = math.log(RARE[name] / columns.size)
    if name.startswith("_changeover") and shapes.present["master_slave"] < 0:
        there = -math.inf  # the response of a changeover that is absent
    return np.concatenate([[math.log(1.0 - RARE[name])], there + gain]), 1.0 / np.sqrt(weight)


def _drawn(score: FloatArray, rng: np.random.Generator) -> int:
    """Return the index of a possibility, drawn by the log probabilities ``score``."""
    chance = np.exp(score - score.max()).cumsum()
    return min(int(chance.searchsorted(rng.random() * chance[-1])), score.size - 1)


class _Options:
    """All shapes that are possible in one slot at a reversal point, compared by their evidence."""

    def __init__(
        self, marginal: MarginalEquations, shapes: SpikeShapes, reversal: int, slot: int
    ) -> None:
        here, self.options = shapes.reversals[reversal], shapes.options(reversal, slot)
        self.place = reversal, slot
        self.both = bool(here.unlike.size)
        alike, unlike = here.alike[self.options], here.unlike[self.options if self.both else []]
        self.tried = _Tried(marginal, np.concatenate([alike, unlike]))
        self.cross = marginal.gram[alike, unlike] if self.both else np.empty(0)

    def evidence(self, marginal: MarginalEquations, shapes: SpikeShapes) -> FloatArray:
        """Return the log probability of each possibility: no shape, a shape that is equal in both
        directions, or a shape that differs between the directions.

        For s sizes and m shapes, the array has 1 + 2 * s * m entries. The first is for no shape.
        Then s * m entries are for equal shapes, and s * m for shapes that differ. With one
        direction, the last part is missing.
        """
        count = self.options.size
        if not count:
            return np.zeros(1)
        rest, found, known = self.tried.added(marginal, shapes, shapes.chosen(self.place))
        weight = found[:count] + PRIOR
        alike = 0.5 * rest[:count] ** 2 / weight - 0.5 * np.log(weight / PRIOR)
        # Two slots with one shape are one decay of another size.
        reversal, slot = self.place
        for each in range(SLOTS):
            if each != slot:
                alike[:, self.options == shapes.place[reversal, each]] = -np.inf
        there = np.log(THERE / alike.size)
        if not self.both:
            return np.concatenate([[np.log(1.0 - THERE)], there + alike.ravel()])
        cross = self.cross - np.einsum("ct,ct->t", known[:, :count], known[:, count:])
        left = np.maximum(found[count:] - cross**2 / weight, 0.0) + PRIOR
        more = rest[count:] - cross / weight * rest[:count]
        unlike = alike + 0.5 * more**2 / left - 0.5 * np.log(left / PRIOR)
        return np.concatenate(
            [
                [np.log(1.0 - THERE)],
                there + np.log(1.0 - UNLIKE) + alike.ravel(),
                there + np.log(UNLIKE) + unlike.ravel(),
            ]
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleDraws:
    """Random draws of the causes and the spikes of a circular test from their posterior.

    ``values`` (d, p): sizes of the causes other than spikes. ``spikes``: one for each reversal
    point. ``paths`` (s, n): fitted deviations, mm, for each drawn choice of spike shapes.
    ``least_error``: standard error of each rare cause by name, if the cause exists.
    """

    values: FloatArray
    spikes: tuple[SpikeDraws, ...]
    paths: FloatArray
    least_error: dict[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class SpikeDraws:
    """Random draws (d,) of the spikes at one reversal point: peak heights, depths and lengths.
    ``lost``: column of the lost motion there.

    The arrays (d, s) are in µm; s = 2 for ccw and cw, s = 1 if both are equal. ``heights``: outward
    peak above the lost motion. ``depths``: largest inward deviation. ``extrapolated``: all
    decays but the fastest, extrapolated to the reversal. ``unseen``: range of the heights that no
    sample determines. ``deeper``: additional inward deviation while lost motion is taken up.

    ``decay`` (d,), mm: arc from the peak (of the depth for an `INWARD` spike) to 1/e of it.
    ``rise`` (d,), mm: arc to the peak, or 0. ``there``: probability of a spike; ``unlike``: of
    different directions. ``curve`` (s, m): mean amplitude, µm, of each shape.
    """

    reversal: Reversal
    lost: int
    heights: FloatArray
    depths: FloatArray
    extrapolated: FloatArray
    unseen: FloatArray
    deeper: FloatArray
    decay: FloatArray
    rise: FloatArray
    there: float
    unlike: float
    curve: FloatArray
    least_error: float


def draw_shapes(
    weighted: WeightedProblem, shapes: SpikeShapes, rng: np.random.Generator
) -> CircleDraws:
    """Return random draws of the spike shapes and of the causes under each draw, starting from
    ``shapes``. The draws of the causes are pairs, symmetric about their mean (antithetic variates:
    Hammersley and Morton, 1956).
    """
    marginal = weighted.without(shapes.always)
    every = {place: _Options(marginal, shapes, *place) for place in shapes.slots()}
    paths: list[FloatArray] = []
    values, errors = [], dict.fromkeys(shapes.rare, 0.0)
    recorded = [_Recorder(weighted.problem, reversal) for reversal in shapes.reversals]
    for sweep in range(_FORGOTTEN + _SWEEPS):
        for place, options in every.items():
            set_shape(shapes, *place, _drawn(options.evidence(marginal, shapes), rng))
        for name in shapes.rare:
            if sweep % _RARELY and name != "spiral":
                continue
            score, each = _odds(marginal, shapes, name)
            shapes.present[name] = _drawn(score, rng) - 1
            errors[name] = float(each[np.argmax(score[1:])])
        if sweep < _FORGOTTEN:
            continue
        active = shapes.active()
        drew = _coefficients(weighted, active, shapes.precision, rng)
        paths.append(fitted_path(weighted.problem, active, drew[0]))
        row = np.zeros((drew.shape[0], shapes.count))
        plain = active < shapes.count
        row[:, active[plain]] = drew[:, plain]
        values.append(row)
        of = {int(column): drew[:, index] for index, column in enumerate(active)}
        for reversal, recorder in enumerate(recorded):
            recorder.add(shapes, reversal, of)
    floors = [_least_error(weighted, marginal, reversal) for reversal in shapes.reversals]
    return CircleDraws(
        values=np.concatenate(values),
        paths=np.array(paths),
        spikes=tuple(
            recorder.result(floor) for recorder, floor in zip(recorded, floors, strict=True)
        ),
        least_error=errors,
    )


def _coefficients(
    weighted: WeightedProblem, active: IndexArray, precision: FloatArray, rng: np.random.Generator
) -> FloatArray:
    normal = weighted.gram[np.ix_(active, active)] + np.diag(precision[active])
    unit = 1.0 / np.sqrt(np.diag(normal))
    root = np.linalg.cholesky(normal * np.outer(unit, unit) + _ROUNDING * np.eye(unit.size))
    half = np.linalg.solve(root, unit * weighted.right[active])
    noise = rng.standard_normal((_PAIRS, active.size))
    both = np.concatenate([half + noise, half - noise])
    drew: FloatArray = np.linalg.solve(root.T, both.T).T * unit
    return drew


def _least_error(
    weighted: WeightedProblem, marginal: MarginalEquations, reversal: Reversal
) -> float:
    """Return the standard error, um, of the spike at a reversal point where no spike was found. It
    assumes a single spike that decays within one of the equally likely times of `_USUAL`. A spike
    that ends before the next sample is limited only by its prior.
    """
    samples = weighted.problem.samples
    sharp = [
        i
        for i, shape in enumerate(reversal.shapes)
        if isinstance(shape, SpikeShape) and not shape.rising
    ]
    lengths = np.array([reversal.shapes[i].length for i in sharp])
    usual = np.geomspace(*_USUAL, _TIMES) * samples.speed
    nearest = np.argmin(np.abs(np.log(lengths / usual[:, np.newaxis])), axis=1)
    columns = reversal.alike[np.array(sharp)[nearest]]
    before = 0.5 * sample_spacing(samples)
    seen = np.exp(-np.clip(before / usual - before / lengths[nearest], 0.0, 20.0))
    weight = np.maximum(marginal.gram[columns, columns], 0.0) * seen**2
    return float(np.sqrt(np.mean(1.0 / (weight + _HIDDEN**-2.0))))


def of_the_spike(taken: FloatArray, spike: FloatArray, lost: FloatArray) -> FloatArray:
    """Return the part of the gradual take-up ``taken`` (d, s), um, that counts as reversal spike
    and not as lost motion. ``spike``, ``lost``: sizes of reversal spike and lost motion.

    An outward take-up always belongs to the spike. An inward one has two possible causes: the axis
    stands still until it has passed its lost motion (size ``lost``), or until its drive overcomes
    the friction (size ``spike`` at the reversal). The cause with the nearer size is taken.
    """
    friction = np.abs(taken + spike) < np.abs(taken + lost)
    return np.where((taken > 0.0) | friction, taken, 0.0)


class _Recorder:
    """Collector of the random draws of the spike at one reversal point."""

    def __init__(self, problem: CircleProblem, reversal: Reversal) -> None:
        self.reversal = reversal
        self.radius, self.spacing = problem.samples.radius, sample_spacing(problem.samples)
        own = f"backlash_{reversal.axis}_at_{reversal.end}"
        self.lost = problem.names.index(
            own if own in problem.names else f"backlash_{reversal.axis}"
        )
        self.senses = np.array([1.0, -1.0]) if reversal.unlike.size else np.array([1.0])
        lengths = [shape.length for shape in reversal.shapes]
        arcs = np.geomspace(0.2 * min(lengths), 5.0 * max(lengths), 48)
        self.arcs = np.concatenate([[0.0], arcs])
        self.shapes = np.array([shape(self.arcs) for shape in reversal.shapes])
        self.parts: list[tuple[FloatArray, ...]] = []
        self.there = self.unlike = 0
        self.curve = np.zeros((self.senses.size, len(reversal.shapes)))

    def add(self, shapes: SpikeShapes, index: int, of: dict[int, FloatArray]) -> None:
        count = next(iter(of.values())).size
        curve = np.zeros((count, self.senses.size, self.arcs.size))
        sizes: dict[int, FloatArray] = {}
        for slot in range(SLOTS):
            columns = shapes.columns(index, slot)
            if not columns:
                continue
            place = int(shapes.place[index, slot])
            size = np.repeat(of[columns[0]][:, np.newaxis], self.senses.size, axis=1)
            if len(columns) > 1:
                size = size + of[columns[1]][:, np.newaxis] * self.senses
            self.curve[:, place] += np.mean(size, axis=0)
            if slot >= DECAYS:
                size = of_the_spike(size, curve[:, :, 0], of[self.lost][:, np.newaxis])
            else:
                sizes[place] = size
            curve += size[:, :, np.newaxis] * self.shapes[place]
        heights = np.maximum(np.max(curve, axis=2), 0.0)
        first = np.maximum(np.max(curve[:, :, self.arcs >= 0.5 * self.spacing], axis=2), 0.0)
        # Inside while the lost motion is taken up, the axis stands still.
        lost = UM * abs(float(np.mean(of[self.lost])))
        seen = self.arcs >= 0.5 * self.spacing + np.sqrt(2.0 * lost * self.radius)
        depths = -np.min(curve[:, :, seen], axis=2, initial=0.0)
        deepest = -np.min(curve[:, :, self.arcs >= 0.5 * self.spacing], axis=2, initial=0.0)
        decay, rise = np.zeros(count), np.zeros(count)
        slow = heights
        if sizes:
            places = sorted(sizes, key=lambda place: self.reversal.shapes[place].length)
            whole = np.mean(curve, axis=(0, 1))
            if np.mean(depths) > INWARD * np.mean(heights):
                whole = np.where(seen, -whole, 0.0)
            peak = int(np.argmax(whole))
            rise += self.arcs[peak]
            decay += self._died(whole, peak)
            fast, *fall = places
            rising = any(self.shapes[place][0] == 0.0 for place in fall)
            if fall and not rising and np.mean(sizes[fast]) < 0.0:
                slow = np.sum([sizes[place] for place in fall], axis=0)
        # Of a decay shorter than the distance of two samples its height at the reversal is a guess.
        guessed = 1.0 / (1.0 + (decay / self.spacing) ** 2)[:, np.newaxis]
        unseen = guessed * (heights - first)
        heights = heights - 0.5 * unseen
        slow = slow - 0.5 * unseen
        self.parts.append((heights, depths, slow, unseen, deepest - depths, decay, rise))
        self.there += bool(sizes)
        decays = slice(DECAYS)
        turned = shapes.unlike[index, decays] & (shapes.place[index, decays] >= 0)
        self.unlike += bool(np.any(turned))

    def _died(self, curve: FloatArray, peak: int) -> float:
        """Return the arc length, mm, in which a spike falls from its peak to 1/e of the peak."""
        level = curve[peak] / np.e
        below = np.flatnonzero(curve[peak:] <= level)
        if not below.size or level <= 0.0:
            return float(self.reversal.shapes[0].length)
        last = peak + max(int(below[0]), 1)
        share = (curve[last - 1] - level) / max(curve[last - 1] - curve[last], 1e-12)
        died = self.arcs[last - 1] + share * (self.arcs[last] - self.arcs[last - 1])
        return float(died - self.arcs[peak])

    def result(self, least_error: float) -> SpikeDraws:
        count = len(self.parts)
        heights, depths, slow, unseen, deeper, decay, rise = (
            np.concatenate(part) for part in zip(*self.parts, strict=True)
        )
        return SpikeDraws(
            reversal=self.reversal,
            lost=self.lost,
            heights=heights,
            depths=depths,
            extrapolated=slow,
            unseen=unseen,
            deeper=deeper,
            decay=decay,
            rise=rise,
            there=self.there / count,
            unlike=self.unlike / count,
            curve=self.curve / count,
            least_error=least_error,
        )
