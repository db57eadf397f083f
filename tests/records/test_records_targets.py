"""Targets that are proposed: within the range, at random offsets, and blind to no period."""

from __future__ import annotations

import numpy as np
import pytest

from compwright.records.targets import proposed_targets, targets_text


@pytest.mark.parametrize(
    ("low", "high", "count"), [(0.0, 500.0, 11), (-850.0, 0.0, 30), (0, 20, 12)]
)
def test_proposed_targets_show_every_period_down_to_a_tenth_of_their_interval(
    low: float, high: float, count: int
) -> None:
    """Cosine and sine of a period are worst when all targets have the same phase: the mean of the
    phasors is then 1; equal intervals have that at every whole part of the interval."""
    targets = proposed_targets(low, high, count)
    interval = (high - low) / count
    middle = low + (np.arange(count) + 0.5) * interval
    assert np.all(np.abs(targets - middle) <= 0.3 * interval + 0.05)
    worst = max(
        abs(np.mean(np.exp(2j * np.pi * targets * parts / interval))) for parts in np.arange(1, 11)
    )
    assert worst < 0.8
    assert targets.tolist() == proposed_targets(low, high, count).tolist()


def test_a_proposal_in_words_has_a_length_that_a_person_reads() -> None:
    assert str(targets_text(0.0, 4000.0, 400, "mm")).count(",") == 29
    assert str(targets_text(0.0, 100.0, 5, "mm")).count(",") == 11
