"""The error of an axis as a mixture of models: with and without unknown periods, with constant or
varying reversal. Each model is weighted by its posterior probability (Hoeting et al., Statistical
Science 14, 1999).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from compwright.estimation.cells import Cells
from compwright.estimation.model import (
    FittedModel,
    MixturePart,
    Periods,
    Travel,
    fit_model,
    with_other_periods,
)
from compwright.estimation.period_models import PeriodModel

_SEED: Final = 231  # by it draws of the noise go with models


@dataclass(frozen=True, slots=True)
class ModelMixture:
    """Several averaged models (``parts``) whose draws are all equally likely.
    ``reversal_log_odds``: log odds of a varying against a constant reversal error.
    """

    parts: tuple[MixturePart, ...]
    reversal_log_odds: float


def average_models(
    cells: Cells, travel: Travel, known: Periods, models: Sequence[PeriodModel], draws: int
) -> ModelMixture:
    """Return the average of the ``models``, the most probable first. Each model also has the
    ``known`` periods.

    Constant and varying reversal have equal prior probability. The share of the varying reversal is
    odds / (1 + odds) (Kass and Raftery, J. Am. Stat. Assoc. 90, 1995). The odds of the most
    probable model are used for all models, because the reversal is the difference of the directions
    and periods belong to their mean. Models with equally many periods and harmonics share the draws
    of their hyperparameters.
    """
    first, odds = _varying_and_constant_reversal(cells, travel, known, models[0], draws)
    share = 1.0 / (1.0 + float(np.exp(-np.clip(odds, -50.0, 50.0)))) if len(first) > 1 else 0.0
    favoured = max(first, key=lambda varying: share if varying else 1.0 - share)
    fits: dict[tuple[tuple[int, ...], ...], dict[bool, FittedModel]] = {models[0].harmonics: first}
    weights: list[tuple[FittedModel, float]] = []
    for model in models:
        periods = known.with_periods(model.periods, model.harmonics)
        if model.harmonics not in fits:
            fits[model.harmonics] = {
                favoured: fit_model(cells, travel, periods, varying=favoured, draws=draws // 2)
            }
        own = fits[model.harmonics]
        for varying, fit in own.items():
            part = (share if varying else 1.0 - share) if len(own) > 1 else 1.0
            weights.append((with_other_periods(fit, cells, periods), model.probability * part))
    counts = _apportion([weight for _, weight in weights], draws)
    # Every draw of the noise as often as any other, in no order.
    noise = np.random.default_rng(_SEED).permutation(np.arange(draws) * cells.data.draws // draws)
    shares = np.split(noise, np.cumsum(counts)[:-1])
    parts = [fit.part(mine) for (fit, _), mine in zip(weights, shares, strict=True) if mine.size]
    return ModelMixture(tuple(parts), odds)


def _varying_and_constant_reversal(
    cells: Cells, travel: Travel, known: Periods, model: PeriodModel, draws: int
) -> tuple[dict[bool, FittedModel], float]:
    """Return two models, the first with varying and the second with constant reversal error, and
    the log odds of the first model against the second.
    """
    periods = known.with_periods(model.periods, model.harmonics)
    both = {
        varying: fit_model(cells, travel, periods, varying=varying, draws=draws)
        for varying in ((True, False) if cells.bidirectional else (False,))
    }
    if len(both) == 1:
        return both, 0.0
    return both, both[True].drawn.log_evidence - both[False].drawn.log_evidence


def _apportion(weights: Sequence[float], draws: int) -> list[int]:
    """Return how many of the ``draws`` each weight gets: whole numbers in proportion to the
    ``weights``, with the sum ``draws``. The method is that of the largest remainders (Balinski and
    Young, Fair Representation, 1982).
    """
    exact = draws * np.round(np.array(weights) / sum(weights), 9)
    counts = np.floor(exact).astype(int)
    order = np.argsort(-np.round(exact - counts, 6), kind="stable")
    counts[order[: draws - int(np.sum(counts))]] += 1
    return [int(count) for count in counts]
