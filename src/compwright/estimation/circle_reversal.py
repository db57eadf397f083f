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
from dataclasses import dataclass, field
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.circle_equations import CircleProblem, Reversal, scaled_inverse
from compwright.estimation.circle_fit import WeightedProblem
from compwright.estimation.circle_model import UM, SpikeShape, sample_spacing
from compwright.estimation.circle_noise import IndexArray
from compwright.estimation.circle_shapes import (
    DECAYS,
    PRIOR,
    SIZES,
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
#: Slope of the logistic function nearest to the normal distribution (Bowling et al., Journal of
#: Industrial Engineering and Management 2, 2009).
_LOGISTIC: Final = 1.702
#: Samples below which the shape of a take-up is not seen.
_FEW: Final = 2.0
#: Added to the diagonal of scaled normal equations: readings without noise leave only rounding.
_ROUNDING: Final = 1e-10
#: Rare causes other than a spiral, which can look like lost motion, are drawn in every so many
#: sweeps.
_RARELY: Final = 3
#: Times in which reversal spikes usually die out, s, how many of them are tried, and how high, um,
#: one may be that is not seen.
_USUAL: Final = (0.015, 0.15)
_TIMES: Final = 5
HIDDEN: Final = 4.0
#: Share of the lost motion from which a gradual take-up is the passing of the whole lost motion.
_PASSED: Final = 0.5
#: Pairs of draws of the causes for each drawn choice of shapes.
_PAIRS: Final = 6


def choose_shapes(weighted: WeightedProblem, shapes: SpikeShapes) -> None:
    """Change the spike shapes one at a time until no change makes the fit more probable."""
    marginal = _marginal(weighted, shapes.always)
    every = _options(weighted.problem, marginal, shapes)
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
                set_shape(shapes, *place, int(np.argmax(every[place].evidence(shapes, place))))
            changes += shapes.at(place) != before
            compared[place] = changes
        if changes == start:
            break


@dataclass(frozen=True, slots=True)
class MarginalEquations:
    """Normal equations after some causes were integrated out: matrix ``gram`` (k, k), without the
    priors of the remaining causes, and right side ``right`` (k,). ``alone`` (k,): sizes of the
    causes that were integrated out, in a fit without the others, else 0. ``found``: what `inverse`
    found.
    """

    gram: FloatArray
    right: FloatArray
    alone: FloatArray
    found: dict[bytes, FloatArray] = field(default_factory=dict)

    def inverse(self, chosen: IndexArray, precision: FloatArray) -> FloatArray:
        """Return the inverse (c, c) of the normal equations of the ``chosen`` columns (c,), with
        prior ``precision`` (c,).
        """
        key = chosen.tobytes() + precision.tobytes()
        if key not in self.found:
            normal = self.gram[chosen[:, np.newaxis], chosen]
            diagonal = normal.diagonal() + precision
            normal.flat[:: chosen.size + 1] = diagonal * (1.0 + _ROUNDING)
            self.found[key] = np.asarray(np.linalg.inv(normal), dtype=np.float64)
        return self.found[key]


def _marginal(weighted: WeightedProblem, always: IndexArray) -> MarginalEquations:
    """Return the normal equations after the causes with the indices ``always`` are integrated out
    under their priors (Schur complement).
    """
    gram, prior = weighted.gram, weighted.problem.widths[always] ** -2.0
    inverse = scaled_inverse(gram[np.ix_(always, always)] + np.diag(prior))
    shared = inverse @ np.column_stack([gram[always], weighted.right[always]])
    alone = np.zeros(len(gram))
    alone[always] = shared[:, -1]
    return MarginalEquations(
        gram - gram[:, always] @ shared[:, :-1], weighted.right - gram @ alone, alone
    )


class _Tried:
    """Columns (t,) that are tried as additions to a fit, with their normal equations."""

    def __init__(self, marginal: MarginalEquations, columns: IndexArray) -> None:
        self.marginal, self.columns = marginal, columns
        self.weight = np.maximum(marginal.gram[columns, columns], 0.0)
        self.right = marginal.right[columns]

    def added(
        self, shapes: SpikeShapes, chosen: IndexArray
    ) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return the normal equations of the tried columns after a fit with the ``chosen`` columns.

        The results are the right side (t,), the weight (t,) without the priors of the columns, the
        products (c, t) with the chosen columns, and the sizes (c, t) of these in a fit to each
        tried column (columns added to a regression with normal priors: Seber and Lee, Linear
        Regression Analysis, 2nd ed. 2003, section 3.7).
        """
        products = self.marginal.gram[chosen[:, np.newaxis], self.columns]
        fitted = self.marginal.inverse(chosen, shapes.precision[chosen]) @ products
        weight = np.maximum(self.weight - np.add.reduce(products * fitted), 0.0)
        return self.right - self.marginal.right[chosen] @ fitted, weight, products, fitted


def _odds(
    marginal: MarginalEquations, shapes: SpikeShapes, name: str
) -> tuple[FloatArray, FloatArray]:
    """Return the log probability of each possibility of a rare cause: absent, or one of its m
    shapes (1 + m,), and the standard error of its size for each shape (m,).
    """
    columns = np.array(shapes.rare[name])
    rest, found, *_ = _Tried(marginal, columns).added(shapes, shapes.chosen(name))
    prior = shapes.precision[columns]
    weight = found + prior
    gain = 0.5 * rest**2 / weight - 0.5 * np.log(weight / prior)
    chance = shapes.chance[name]
    there = math.log(chance / columns.size)
    absent = math.log1p(-chance) if chance < 1.0 else -math.inf
    if name.startswith("_changeover") and shapes.present["master_slave"] < 0:
        there = -math.inf  # the response of a changeover that is absent
    return np.concatenate([[absent], there + gain]), 1.0 / np.sqrt(weight)


def _drawn(score: FloatArray, rng: np.random.Generator) -> int:
    """Return the index of a possibility, drawn by the log probabilities ``score``."""
    chance = np.exp(score - score.max()).cumsum()
    return min(int(chance.searchsorted(rng.random() * chance[-1])), score.size - 1)


def _options(
    problem: CircleProblem, marginal: MarginalEquations, shapes: SpikeShapes
) -> dict[tuple[int, int], _Options]:
    """Return the possible shapes of each slot. Slots for the same kind of shape share them.

    Only a negative lost motion that is taken up leaves an axis outside. A long one may still be
    part of a spike. A short one would make the only sample of a spike nearly its peak.
    """
    spacing = sample_spacing(problem.samples)
    every: dict[tuple[int, bool], _Options] = {}
    for reversal, slot in shapes.slots():
        if (reversal, slot >= DECAYS) not in every:
            here = problem.reversals[reversal]
            short = np.array([shape.length for shape in here.shapes]) < _FEW * spacing
            lost = marginal.alone[_lost_motion_column(problem, here)]
            inside = short & (slot >= DECAYS and lost >= 0.0)
            every[reversal, slot >= DECAYS] = _Options(marginal, shapes, reversal, slot, inside)
    return {(reversal, slot): every[reversal, slot >= DECAYS] for reversal, slot in shapes.slots()}


def _lost_motion_column(problem: CircleProblem, reversal: Reversal) -> int:
    own = f"backlash_{reversal.axis}_at_{reversal.end}"
    return problem.names.index(own if own in problem.names else f"backlash_{reversal.axis}")


class _Options:
    """All shapes that are possible in one slot at a reversal point, compared by their evidence.
    ``inside`` (m,): the shapes of this point that are not possible with a size above 0 (outward).
    """

    def __init__(
        self,
        marginal: MarginalEquations,
        shapes: SpikeShapes,
        reversal: int,
        slot: int,
        inside: NDArray[np.bool_],
    ) -> None:
        here, options = shapes.reversals[reversal], shapes.options(reversal, slot)
        self.count, self.both = options.size, bool(here.unlike.size)
        self.inside = inside[options]
        self.index = {place: index for index, place in enumerate(options.tolist())}
        alike, unlike = here.alike[options], here.unlike[options if self.both else []]
        self.tried = _Tried(marginal, np.concatenate([alike, unlike]))
        self.cross = marginal.gram[alike, unlike] if self.both else np.empty(0)
        share = [1.0 - UNLIKE, UNLIKE] if self.both else [1.0]
        size = max(self.count * SIZES.size, 1)
        each = np.log(np.array(share)[:, np.newaxis, np.newaxis] * THERE / size)
        self.log_prior = each + 0.5 * np.log([PRIOR, PRIOR**2][: len(share)])
        self.found: dict[bytes, FloatArray] = {}

    def evidence(self, shapes: SpikeShapes, place: tuple[int, int]) -> FloatArray:
        """Return the log probability of each possibility: no shape, a shape that is equal in both
        directions, or a shape that differs between the directions. ``place``: reversal point and
        slot.

        For s sizes and m shapes, the array has 1 + 2 * s * m entries. The first is for no shape.
        Then s * m entries are for equal shapes, and s * m for shapes that differ. With one
        direction, the last part is missing.
        """
        chosen = shapes.chosen(place)
        key = chosen.tobytes() + shapes.precision[chosen].tobytes()
        count = self.count
        if not count:
            return np.zeros(1)
        if key in self.found:
            return self.found[key]
        rest, found, products, fitted = self.tried.added(shapes, chosen)
        volume, gain = np.empty((2, len(self.log_prior), SIZES.size, count))
        weight = np.add(found[:count], PRIOR, out=volume[0])
        np.divide(rest[:count] ** 2, weight, out=gain[0])
        if self.both:
            cross = self.cross - np.add.reduce(products[:, :count] * fitted[:, count:])
            share = cross / weight
            left = np.maximum(found[count:] - cross * share, 0.0) + PRIOR
            np.divide((rest[count:] - share * rest[:count]) ** 2, left, out=gain[1])
            gain[1] += gain[0]
            np.multiply(weight, left, out=volume[1])
        outside = rest[:count] / np.sqrt(weight)
        gain -= np.log(volume, out=volume)
        gain *= 0.5
        if np.any(self.inside):
            # Twice the probability of a negative size (normal as logistic).
            negative = math.log(2.0) - np.logaddexp(0.0, _LOGISTIC * outside)
            gain += np.where(self.inside, negative, 0.0)
        gain += self.log_prior
        # Two slots with one shape are one decay of another size.
        reversal, slot = place
        for each, other in enumerate(shapes.place[reversal].tolist()):
            if each != slot and other in self.index:
                gain[..., self.index[other]] = -np.inf
        self.found[key] = np.append(math.log(1.0 - THERE), gain)
        return self.found[key]


@dataclass(frozen=True, slots=True, kw_only=True)
class CircleDraws:
    """Random draws of the causes and the spikes of a circular test from their posterior.

    ``values`` (d, p): sizes of the causes other than spikes. ``spikes``: one for each reversal
    point. ``sizes`` (s, k): a draw of all columns for each drawn choice of spike shapes.
    ``least_error``: standard error of each rare cause by name, if the cause exists.
    """

    values: FloatArray
    spikes: tuple[SpikeDraws, ...]
    sizes: FloatArray
    least_error: dict[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class SpikeDraws:
    """Random draws (d,) of the spikes at one reversal point: peak heights, depths and lengths.
    ``lost``: column of the lost motion there.

    The arrays (d, s) are in µm; s = 2 for ccw and cw, s = 1 if both are equal. ``heights``: outward
    peak above the lost motion. ``depths``: largest inward deviation. ``extrapolated``: all
    decays but the fastest, extrapolated to the reversal. ``unseen``: range of the heights that no
    sample determines. ``standing``: by how much a spike that begins at the reversal is higher than
    one that begins when the axis has passed its lost motion; ``heights`` is the mean of both.
    ``deeper``: additional inward deviation while lost motion is taken up.

    ``decay`` (d,), mm: arc from the peak (of the depth for an `INWARD` spike) to 1/e of it.
    ``rise`` (d,), mm: arc to the peak, or 0. ``there``: probability of a spike; ``unlike``: of
    different directions. ``curve`` (s, m): mean amplitude, µm, of each shape. ``least_error``,
    ``hidden``: standard error of a spike that was not found, µm, and its part that no sample shows.
    """

    reversal: Reversal
    lost: int
    heights: FloatArray
    depths: FloatArray
    extrapolated: FloatArray
    unseen: FloatArray
    standing: FloatArray
    deeper: FloatArray
    decay: FloatArray
    rise: FloatArray
    there: float
    unlike: float
    curve: FloatArray
    least_error: float
    hidden: float


def draw_shapes(
    weighted: WeightedProblem, shapes: SpikeShapes, rng: np.random.Generator
) -> CircleDraws:
    """Return random draws of the spike shapes and of the causes under each draw, starting from
    ``shapes``. The draws of the causes are pairs, symmetric about their mean (antithetic variates:
    Hammersley and Morton, 1956).
    """
    marginal = _marginal(weighted, shapes.always)
    every = _options(weighted.problem, marginal, shapes)
    drawn, errors = [], dict.fromkeys(shapes.rare, 0.0)
    for sweep in range(_FORGOTTEN + _SWEEPS):
        for place, options in every.items():
            set_shape(shapes, *place, _drawn(options.evidence(shapes, place), rng))
        for name in shapes.rare:
            if sweep % _RARELY and name != "spiral":
                continue
            score, each = _odds(marginal, shapes, name)
            shapes.present[name] = _drawn(score, rng) - 1
            errors[name] = float(each[np.argmax(score[1:])])
        if sweep < _FORGOTTEN:
            continue
        active = shapes.active()
        drew = np.zeros((2 * _PAIRS, shapes.precision.size))
        drew[:, active] = _coefficients(weighted, active, shapes.precision, rng)
        drawn.append(drew)
    sizes = np.array(drawn)
    return CircleDraws(
        values=sizes[..., : shapes.count].reshape(-1, shapes.count),
        sizes=sizes[:, 0],
        spikes=tuple(
            _spike_draws(
                weighted.problem, reversal, sizes, *_least_error(weighted, marginal, reversal)
            )
            for reversal in shapes.reversals
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
) -> tuple[float, float]:
    """Return the standard error, um, of the spike at a reversal point where no spike was found, and
    the part of it that is hidden from the samples. It assumes a single spike that decays within one
    of the equally likely times of `_USUAL`. A spike that ends before the next sample is limited
    only by its prior. Hidden is the share that the variance has in that of the prior.
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
    variance = 1.0 / (weight + HIDDEN**-2.0)
    return float(np.sqrt(np.mean(variance))), float(np.sqrt(np.mean(variance**2)) / HIDDEN)


def of_the_spike(taken: FloatArray, spike: FloatArray, lost: FloatArray) -> FloatArray:
    """Return the part of the gradual take-up ``taken`` (d, s), um, that counts as reversal spike
    and not as lost motion. ``spike``, ``lost``: sizes of reversal spike and lost motion.

    An outward take-up always belongs to the spike. An inward one has two possible causes: the axis
    stands still until it has passed its lost motion (size ``lost``), or until its drive overcomes
    the friction (size ``spike`` at the reversal). The cause with the nearer size is taken.
    """
    friction = np.abs(taken + spike) < np.abs(taken + lost)
    return np.where((taken > 0.0) | friction, taken, 0.0)


def _spike_draws(
    problem: CircleProblem,
    reversal: Reversal,
    drawn: FloatArray,
    least_error: float,
    hidden: float,
) -> SpikeDraws:
    """Return the spikes at one reversal point from the ``drawn`` sizes of all columns, (s, d, k):
    d draws for each of s choices of shapes.
    """
    spacing, lengths = sample_spacing(problem.samples), [s.length for s in reversal.shapes]
    arcs = np.geomspace(0.2 * min(lengths), 5.0 * max(lengths), 48)
    arcs = np.concatenate([[0.0], arcs])
    shapes = np.array([shape(arcs) for shape in reversal.shapes])
    decays = np.array([isinstance(shape, SpikeShape) for shape in reversal.shapes])
    lost = _lost_motion_column(problem, reversal)
    senses = np.array([1.0, -1.0] if reversal.unlike.size else [1.0])[:, np.newaxis]
    sizes = drawn[..., np.newaxis, reversal.alike]
    unlike = drawn[..., np.newaxis, reversal.unlike] if reversal.unlike.size else 0.0 * sizes
    sizes = sizes + senses * unlike
    curve = sizes[..., decays] @ shapes[decays]
    taken, moved = sizes[..., ~decays], drawn[..., lost]
    over = moved[..., np.newaxis, np.newaxis]
    friction = of_the_spike(taken, curve[..., :1], over)
    curve += friction @ shapes[~decays]
    heights = np.max(curve, axis=-1, initial=0.0)
    # While it passes its lost motion, an axis stands still, and the spike may not have begun.
    stands = np.any((friction == 0.0) & (taken < -_PASSED * np.abs(over)), axis=-1)
    passed = np.sqrt(2.0 * UM * np.abs(np.mean(moved, axis=1)) * problem.samples.radius)
    until = np.where(stands, passed[:, np.newaxis, np.newaxis], 0.0)
    begun = np.where(arcs >= until[..., np.newaxis], curve, 0.0)
    after = np.max(begun, axis=-1, initial=0.0)
    visible = arcs >= 0.5 * spacing
    first = np.max(curve[..., visible], axis=-1, initial=0.0)
    deepest = -np.min(curve[..., visible], axis=-1, initial=0.0)
    # Inside while the lost motion is taken up, the axis stands still.
    seen = arcs >= 0.5 * spacing + passed[:, np.newaxis]
    depths = -np.min(np.where(seen[:, np.newaxis, np.newaxis], curve, 0.0), axis=-1, initial=0.0)
    inward = np.mean(depths, axis=(1, 2)) > INWARD * np.mean(heights, axis=(1, 2))
    whole = np.mean(curve, axis=(1, 2))
    whole = np.where(inward[:, np.newaxis], np.where(seen, -whole, 0.0), whole)
    there = np.any(sizes != 0.0, axis=(1, 2)) & decays
    decay, rise, slow = np.zeros(len(drawn)), np.zeros(len(drawn)), heights.copy()
    for index in np.flatnonzero(np.any(there, axis=1)):
        peak = int(np.argmax(whole[index]))
        rise[index] = arcs[peak]
        decay[index] = _died(arcs, whole[index], peak) or lengths[0]
        # A rise is over before a decay of the same length.
        fast, *fall = sorted(np.flatnonzero(there[index]), key=lambda p: (lengths[p], -p))
        rising = any(shapes[place, 0] == 0.0 for place in fall)
        if fall and not rising and np.mean(sizes[index, ..., fast]) < 0.0:
            slow[index] = np.sum(sizes[index][..., fall], axis=-1)
    # Of a decay shorter than the distance of two samples its height at the reversal is a guess.
    unseen = (heights - first) / (1.0 + (decay / spacing) ** 2)[:, np.newaxis, np.newaxis]
    heights, slow = heights - 0.5 * unseen, slow - 0.5 * unseen
    standing = np.maximum(heights - after, 0.0)
    heights -= 0.5 * standing
    slow = np.where(until > 0.0, heights, slow)
    each = heights, depths, slow, unseen, standing, deepest - depths
    heights, depths, slow, unseen, standing, deeper = (
        part.reshape(-1, len(senses)) for part in each
    )
    return SpikeDraws(
        reversal=reversal,
        lost=lost,
        heights=heights,
        depths=depths,
        extrapolated=slow,
        unseen=unseen,
        standing=standing,
        deeper=deeper,
        decay=np.repeat(decay, drawn.shape[1]),
        rise=np.repeat(rise, drawn.shape[1]),
        there=float(np.mean(np.any(there, axis=1))),
        unlike=float(np.mean(np.any(unlike[..., decays] != 0.0, axis=(1, 2, 3)))),
        curve=np.mean(sizes, axis=(0, 1)),
        least_error=least_error,
        hidden=hidden,
    )


def _died(arcs: FloatArray, curve: FloatArray, peak: int) -> float:
    """Return the arc length, mm, in which a spike falls from its peak to 1/e of the peak, or 0 if
    the ``curve`` at the ``arcs`` does not fall so far.
    """
    level = curve[peak] / np.e
    below = np.flatnonzero(curve[peak:] <= level)
    if not below.size or level <= 0.0:
        return 0.0
    last = peak + max(int(below[0]), 1)
    share = (curve[last - 1] - level) / max(curve[last - 1] - curve[last], 1e-12)
    return float(arcs[last - 1] + share * (arcs[last] - arcs[last - 1]) - arcs[peak])
