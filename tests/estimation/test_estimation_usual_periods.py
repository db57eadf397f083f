"""What is usual among periods: no lead that drives a machine tool is preferred to another."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.estimation.basis import Basis
from compwright.estimation.period_candidates import _Prior
from compwright.estimation.period_likelihood import BidirectionalMeans
from compwright.estimation.periods import search_periods
from compwright.estimation.usual_periods import USUAL_PERIODS, usual_periods
from compwright.records.axis import AxisKind

LEADS = (4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0, 25.0, 32.0, 40.0)


def test_leads_of_machine_tools_are_expected_alike_and_others_less() -> None:
    weights = {each.size: each.weight for each in USUAL_PERIODS[AxisKind.LINEAR]}
    (common,) = {weights[lead] for lead in LEADS}
    assert all(weight < common for size, weight in weights.items() if size not in LEADS)
    assert {25.4 * part for part in (0.2, 0.25, 0.5, 1.0)} <= set(weights)


def test_what_the_files_suggest_counts_as_much_as_all_others() -> None:
    *others, told = usual_periods(AxisKind.LINEAR, (14.0,))
    assert told.size == 14.0
    assert told.weight == pytest.approx(sum(each.weight for each in others))


def test_half_of_what_a_usual_period_weighs_is_near_it() -> None:
    """A density integrates to what it stands for: over the logarithm of the frequency, half of the
    odds of 0.6 (log-normal about 0.1 per mm), and those of any other period.
    """
    prior = _Prior(np.log(0.002), np.array([0.1]), np.log([0.6]))
    logs = np.linspace(np.log(0.08), np.log(0.125), 20001)
    density = np.exp(prior.at(np.exp(logs)) + logs)
    integral = float(np.sum(density[1:] + density[:-1]) * 0.5 * (logs[1] - logs[0]))
    assert integral == pytest.approx(0.3 + 0.002 * (logs[-1] - logs[0]), rel=1e-6)


@pytest.mark.parametrize("lead", LEADS)
def test_each_lead_is_named_as_it_is(lead: float) -> None:
    """2 µm over 20 targets on 800 mm, 0.5 µm of noise: far above what hides it."""
    rng = np.random.default_rng(6)
    targets = np.round((np.arange(20) + 0.5 + rng.uniform(-0.3, 0.3, 20)) * 40.0, 3)
    sigma = 0.0005
    values = (
        0.004 * np.sin(targets / 210.0)
        + 0.002 * np.sin(2 * np.pi * targets / lead + 0.7)
        + sigma / np.sqrt(10.0) * rng.standard_normal(20)
    )
    middles = BidirectionalMeans(
        targets=targets,
        values=values,
        variances=np.full(20, sigma**2 / 10.0),
        dof=160.0,
        reading=sigma,
        free=np.column_stack([np.ones(20), targets]),
    )
    basis = Basis(
        centre=400.0,
        half=400.0,
        sines=60,
        reversal_sines=12,
        periods=(),
        bidirectional=False,
        turn=None,
    )
    search = search_periods(middles, basis, AxisKind.LINEAR)
    assert [each.period for each in search.found if each.probability > 0.5] == [lead]
