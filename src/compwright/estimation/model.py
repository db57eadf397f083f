"""One model of the error of an axis: its functions, its priors, and draws of its weights.

Models differ in their periods and in whether the reversal varies with position. The estimate of an
axis error is a mixture of models, weighted by their probability (Bayesian model averaging: Hoeting
et al., Statistical Science 14, 1999).
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace
from typing import Final

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.basis import Basis
from compwright.estimation.cells import Cells, visible_harmonics
from compwright.estimation.evidence import (
    LENGTH,
    LOCAL,
    NOISE,
    PERIODIC,
    REVERSAL,
    REVERSAL_LENGTH,
    SMOOTH,
    Evidence,
    Prior,
    WeightPosterior,
)
from compwright.estimation.hyperparameters import HyperparameterDraws, draw_hyperparameters
from compwright.records.axis import FloatArray
from compwright.records.noise import NoiseDraws

#: Lengths, in half travels, from which a climb starts: that of a rough smooth part, of a calm one.
_SHORT: Final = (0.08, 0.16)
_LONG: Final = (0.8, 1.6)
#: Middle and width of the prior of the length's logarithm, in half travels. ISO 230-2 takes five
#: targets a metre for enough: an error keeps together over the 200 mm between them, 0.4 of half
#: a metre. Axes of 300 to 2 000 mm and rougher errors are within a factor of 2.2. Longer ones (0.7)
#: make bands at five to seven targets a fifth narrower, and random walks 7 to 18 % less exact.
_LENGTH: Final = (float(np.log(0.4)), 0.8)
_REVERSAL_PART: Final = [REVERSAL, REVERSAL_LENGTH]
_SEED: Final = 230  # the same tests give the same posterior


@dataclass(frozen=True, slots=True)
class Travel:
    """The range (low, high) over which an axis moves, mm or deg. ``turn`` (deg) is the period of an
    endless axis, None for others.
    """

    low: float
    high: float
    turn: float | None = None


@dataclass(frozen=True, slots=True)
class Periods:
    """Known or possible ``periods`` of the error, mm or deg, with the ``harmonics`` in use for
    each.
    """

    periods: tuple[float, ...] = ()
    harmonics: tuple[tuple[int, ...], ...] = ()

    @classmethod
    def of(cls, cells: Cells, periods: tuple[float, ...]) -> Periods:
        """Return the ``periods``, each with its harmonics except those that look like longer waves
        at the targets.
        """
        return cls(periods, tuple(visible_harmonics(cells.targets, each) for each in periods))

    def with_periods(
        self, periods: tuple[float, ...], harmonics: tuple[tuple[int, ...], ...]
    ) -> Periods:
        """Return these periods together with further ``periods`` and their ``harmonics``."""
        return Periods((*self.periods, *periods), (*self.harmonics, *harmonics))


@dataclass(frozen=True, slots=True, eq=False)
class MixturePart:
    """One of several averaged models, with equally likely draws of the weights of its functions.

    ``values`` (n, h): the hyperparameters of each draw. ``draws`` (n,): index of the random draw of
    the noise that belongs to each.
    """

    evidence: Evidence
    values: FloatArray
    draws: NDArray[np.intp]

    @property
    def basis(self) -> Basis:
        """The functions of position in the model."""
        return self.evidence.basis

    @property
    def noises(self) -> FloatArray:
        """The variance (n,) of a reading in each draw, if the noise is estimated, relative to the
        squared scale.
        """
        return np.array([self.evidence.variances(h)[0] for h in self.values])

    @property
    def weights(self) -> tuple[WeightPosterior, ...]:
        """The distribution of the weights of the functions, one for each draw (n). Only the models
        used last keep these distributions in memory.
        """
        return _weights_of(self)


@functools.lru_cache(maxsize=8)
def _weights_of(part: MixturePart) -> tuple[WeightPosterior, ...]:
    return tuple(
        part.evidence.weights(h, int(draw)) for h, draw in zip(part.values, part.draws, strict=True)
    )


@dataclass(frozen=True, slots=True)
class FittedModel:
    """One model of the error fitted to the mean readings of an axis, with its draws and its
    evidence.
    """

    evidence: Evidence
    drawn: HyperparameterDraws

    def part(self, noise: NDArray[np.intp]) -> MixturePart:
        """Return the model with one draw of its weights for each draw of the noise (n,)."""
        pick = np.linspace(0, self.drawn.values.shape[0] - 1, noise.size).round().astype(int)
        return MixturePart(self.evidence, self.drawn.values[pick], noise)


def fit_model(
    cells: Cells, travel: Travel, periods: Periods, *, varying: bool, draws: int
) -> FittedModel:
    """Return a model with the ``periods``, fitted to the mean readings of an axis. The reversal
    error of the model varies with position if ``varying``, else it is constant. ``draws``: number
    of equally likely draws of the hyperparameters.
    """
    evidence = model_evidence(cells, travel, periods, varying=varying)
    # Many targets leave little room for the hyperparameters.
    proposals = 2 * draws if cells.targets.size <= 100 else 2 * draws // 3
    return FittedModel(
        evidence,
        draw_hyperparameters(
            evidence,
            _starts(cells, evidence.prior),
            proposals=proposals,
            draws=draws,
            rng=np.random.default_rng(_SEED),
        ),
    )


def _starts(cells: Cells, prior: Prior) -> list[FloatArray]:
    """Return start points (k, h) in the search for the most probable parameters of a model.

    The result is a list of arrays, one for each possible explanation of the roughness of the means.
    The first is the middle of the prior. The others are a smooth error of short length, an error
    that is independent from target to target, and waves of the periods if there are any.
    """
    rough = float(np.log(cells.roughness))
    # As steep as ever where it is longer.
    slow = [{LENGTH: np.log(each), SMOOTH: rough + np.log(2.0 * each)} for each in _LONG]
    kinds: list[list[dict[int, float]]] = [
        [{}],
        [{LENGTH: np.log(length), SMOOTH: rough - 0.7} for length in _SHORT],
        [{**calm, LOCAL: rough - 1.5} for calm in slow],
    ]
    if prior.centre.size > PERIODIC:
        waves = dict.fromkeys(range(PERIODIC, prior.centre.size), rough - 0.7)
        kinds.append([{**calm, **waves} for calm in slow])
    starts = [np.tile(prior.centre, (len(kind), 1)) for kind in kinds]
    for places, kind in zip(starts, kinds, strict=True):
        for place, own in zip(places, kind, strict=True):
            place[list(own)] = list(own.values())
    return starts


def with_other_periods(fit: FittedModel, cells: Cells, periods: Periods) -> FittedModel:
    """Return a fitted model in which the same number of other ``periods`` replaces the periods of
    ``fit``. The draws of the model's parameters are kept.
    """
    evidence = fit.evidence
    if periods.periods == evidence.basis.periods:
        return fit
    basis = replace(evidence.basis, periods=periods.periods, kept=periods.harmonics)
    return FittedModel(Evidence(basis, cells.targets, cells.data, evidence.prior), fit.drawn)


def model_evidence(cells: Cells, travel: Travel, periods: Periods, *, varying: bool) -> Evidence:
    """Return the log probability of the mean readings under one model (marginal likelihood;
    Rasmussen and Williams, Gaussian Processes for Machine Learning, 2006, section 5.2). Arguments
    as for `fit_model`.
    """
    basis = model_basis(cells, travel, periods, varying=varying)
    return Evidence(basis, cells.targets, cells.data, _prior_for(cells, basis, varying=varying))


def model_basis(cells: Cells, travel: Travel, periods: Periods, *, varying: bool) -> Basis:
    """Return the functions of position of a model. Arguments as for `fit_model`."""
    m = cells.targets.size
    # Twice the targets resolves what they can show; 112 sines resolve a length of 3 % of the half
    # travel.
    sines, reversal_sines = int(np.clip(2 * m, 24, 112)), int(np.clip(m, 12, 32))
    low, high = min(travel.low, float(cells.targets[0])), max(travel.high, float(cells.targets[-1]))
    centre, half = 0.5 * (low + high), 0.5 * (high - low)
    if travel.turn is not None:
        # Functions that repeat with the turn, cosine and sine: an even number of them.
        centre, half, reversal_sines = (
            float(cells.targets[0]),
            0.5 * travel.turn,
            reversal_sines & -2,
        )
    return Basis(
        centre=centre,
        half=half,
        sines=sines,
        reversal_sines=reversal_sines if varying else 0,
        periods=periods.periods,
        bidirectional=cells.bidirectional,
        turn=travel.turn,
        kept=periods.harmonics,
    )


def _prior_for(cells: Cells, basis: Basis, *, varying: bool) -> Prior:
    """Return weak priors of the parameters, centred on values that fit the scatter of the readings.

    Most priors have a width of 1.5, a factor of 4.5 up or down. If a test has no repeated readings,
    its noise is assumed to be about that of another test of the axis.
    """
    spread, roughness = cells.spread, cells.roughness
    centre = [
        np.log(spread),
        np.log(0.1 * spread),
        np.log(roughness),
        _LENGTH[0],
        np.log(3.0),
        np.log(spread) if varying else np.log(1e-6),  # constant: a millionth of the scale
        np.log(0.7),
    ]
    width = [3.0 if cells.data.dof else 1.0, 1.5, 1.5, _LENGTH[1], 1.2, 1.5, 0.7]
    if cells.other_noise is not None:
        centre[NOISE] = _borrowed_noise(cells.other_noise, cells.data.scale)
        width[NOISE] = 0.5
    centre += [np.log(max(spread, 0.2 * roughness))] * len(basis.periods)
    width += [1.5] * len(basis.periods)
    free = [True] * len(centre)
    free[NOISE] = bool(np.any(cells.data.counts > 0))
    for index in _REVERSAL_PART:
        free[index] = basis.bidirectional and varying
    return Prior(centre=np.array(centre), width=np.array(width), free=tuple(free))


def _borrowed_noise(noise: NoiseDraws, scale: float) -> float:
    """Return the log standard deviation of a reading from another test of the axis, relative to
    ``scale``.
    """
    return float(np.mean(np.log(np.maximum(noise.sigma, 1e-12) / scale)))
