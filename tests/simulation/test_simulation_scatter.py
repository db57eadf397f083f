"""Scatter of a virtual machine: tails, outliers, traverses apart, expansion, coarse instruments.

Sizes are recovered from many readings by formulas of textbooks; the tolerance is four standard
errors unless said otherwise.
"""

from __future__ import annotations

import numpy as np
import pytest

from compwright.foundations.errors import UsageError
from compwright.records.positioning import PositioningTest
from compwright.simulation.machine import VirtualMachine
from compwright.simulation.reading import read_machine

UM = 1e-3  # mm
MANY = "{targets: 100, runs: 100}"


def machine(error: str, test: str = MANY, more: str = "") -> VirtualMachine:
    text = f"virtual_machine: 1\naxes:\n  X: {{travel: [0, 1000], error: {error}, test: {test}{more}}}\n"
    return read_machine(text.encode(), "machine.yaml")


def measured(error: str, test: str = MANY, seed: int = 1, more: str = "") -> PositioningTest:
    return machine(error, test, more).measure("X", rng=np.random.default_rng(seed))


def test_seeds_give_what_they_gave() -> None:
    # printed by the simulation before it knew anything but white noise and drift
    rng = np.random.default_rng(7)
    plus, minus = rng.standard_normal((3, 2)), rng.standard_normal((3, 2))
    test = measured("{noise_um: 2}", "{targets: [0, 100, 200], runs: 2}", seed=7)
    np.testing.assert_allclose(test.positive / UM, 2 * plus, atol=1e-12)
    np.testing.assert_allclose(test.negative / UM, 2 * minus, atol=1e-12)


@pytest.mark.parametrize(
    "more",
    [
        "outliers: {share_percent: 10, size_um: 50}",
        "traverses: {offset_um: 3}",
        "traverses: {walk_um: 3, slope_um_per_m: 5}",
    ],
)
def test_what_comes_on_top_leaves_the_noise_as_it_is(more: str) -> None:
    quiet = measured(f"{{{more}}}")
    both = measured(f"{{noise_um: 1, {more}}}")
    white = measured("{noise_um: 1}")
    np.testing.assert_allclose(both.positive - quiet.positive, white.positive, atol=1e-12)
    np.testing.assert_allclose(both.negative - quiet.negative, white.negative, atol=1e-12)
    assert np.abs(quiet.positive).max() > UM


def test_noise_of_each_direction() -> None:
    test = measured("{noise_um: 1, noise_negative_um: 3}")
    # 10 000 readings: a standard deviation is known to 0.7 %
    assert test.positive.std() == pytest.approx(1 * UM, rel=0.03)
    assert test.negative.std() == pytest.approx(3 * UM, rel=0.03)


def test_noise_grows_along_the_travel() -> None:
    test = measured("{noise_um: 1, growth_of_noise: 4}", "{targets: [0, 500, 1000], runs: 1000}")
    for block in (test.positive, test.negative):
        np.testing.assert_allclose(block.std(axis=1) / UM, [1.0, 2.5, 4.0], rtol=0.09)


def test_tails_of_student() -> None:
    share = np.mean(np.abs(measured("{noise_um: 1, tails_dof: 3}").positive) > 3.182 * UM)
    # two-sided 5 % point of t with 3 degrees of freedom: 3.182 (Fisher and Yates, table III)
    assert share == pytest.approx(0.05, abs=4 * np.sqrt(0.05 * 0.95 / 10_000))


def test_outliers_lie_to_either_side() -> None:
    readings = measured("{outliers: {share_percent: 2, size_um: 8}}").positive
    far = readings[np.abs(readings) > 4 * UM]
    assert far.size / readings.size == pytest.approx(0.02, abs=4 * np.sqrt(0.02 * 0.98 / 10_000))
    np.testing.assert_allclose(np.abs(far), 8 * UM)
    assert 0.3 < np.mean(far > 0) < 0.7


def test_traverses_stand_apart_as_wholes() -> None:
    test = measured("{traverses: {offset_um: 2}}", "{targets: 3, runs: 1000}")
    for block in (test.positive, test.negative):
        assert np.ptp(block, axis=0).max() < 1e-12
        assert block[0].std() == pytest.approx(2 * UM, rel=0.09)
    together = np.corrcoef(test.positive[0], test.negative[0])[0, 1]
    assert abs(together) < 4 / np.sqrt(1000)


def test_traverses_turn_about_the_middle_of_the_travel() -> None:
    test = measured(
        "{traverses: {slope_um_per_m: 4}}", "{targets: [0, 250, 500, 1000], runs: 1000}"
    )
    np.testing.assert_allclose(test.positive[2], 0.0, atol=1e-15)
    np.testing.assert_allclose(test.positive[0], -test.positive[3], atol=1e-15)
    np.testing.assert_allclose(test.positive[1], test.positive[0] / 2, atol=1e-15)
    assert test.positive[3].std() == pytest.approx(2 * UM, rel=0.09)  # 4 µm/m over 0.5 m


def test_a_walk_goes_on_from_traverse_to_traverse() -> None:
    test = measured("{traverses: {walk_um: 1}}", "{targets: 2, runs: 1000}")
    path = np.stack([test.positive[0], test.negative[0]], axis=1).ravel()  # up, down, up, ...
    steps = np.diff(path)
    assert steps.std() == pytest.approx(1 * UM, rel=0.07)
    assert abs(np.corrcoef(steps[1:], steps[:-1])[0, 1]) < 4 / np.sqrt(2000)


def test_a_walk_takes_no_step_in_a_direction_that_is_not_run() -> None:
    test = measured("{traverses: {walk_um: 1}}", "{targets: 2, runs: 1000, directions: '-'}")
    assert test.positive.shape == (2, 0)
    assert np.diff(test.negative[0]).std() == pytest.approx(1 * UM, rel=0.09)


def test_expansion_turns_the_error_about_the_reference() -> None:
    test = measured(
        "{expansion_um_per_m: 11}", "{targets: [100, 200, 300], runs: 2}", more=", reference: 200"
    )
    # 12 readings, the slope 0 to 11 µm/m: up 0 1 2, down 3 4 5 (at 300, 200, 100), then 6 to 11
    np.testing.assert_allclose(
        test.positive / UM, [[0.0, -0.6], [0.0, 0.0], [0.2, 0.8]], atol=1e-12
    )
    np.testing.assert_allclose(
        test.negative / UM, [[-0.5, -1.1], [0.0, 0.0], [0.3, 0.9]], atol=1e-12
    )


def test_a_coarse_instrument_reads_whole_steps() -> None:
    fine = measured("{noise_um: 1}", "{targets: 100, runs: 100, datum_um: 0.3}")
    coarse = measured(
        "{noise_um: 1}", "{targets: 100, runs: 100, datum_um: 0.3, resolution_um: 0.5}"
    )
    steps = coarse.positive / (0.5 * UM)
    np.testing.assert_allclose(steps, np.round(steps), atol=1e-9)
    assert np.abs(coarse.positive - fine.positive).max() <= 0.25 * UM + 1e-12


def test_a_rotary_axis_has_the_keys_in_its_own_units() -> None:
    text = (
        "virtual_machine: 1\naxes:\n  C: {kind: rotary, travel: [0, 360], error: {expansion_arcsec_per_deg:"
        " 0.11, outliers: {share_percent: 100, size_arcsec: 36}}, test: {targets: [0, 100, 200],"
        " runs: 2, resolution_arcsec: 0.1}}\n"
    )
    test = read_machine(text.encode(), "m.yaml").measure("C", rng=np.random.default_rng(1))
    seconds = np.abs(test.positive[0]) * 3600
    np.testing.assert_allclose(seconds, 36.0, atol=1e-9)  # no expansion at the reference
    assert np.abs(np.abs(test.positive[2, 1]) * 3600 - 36.0) == pytest.approx(16.0)  # 0.08 · 200


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (
            "{outliers: {share_percent: 101, size_um: 1}}",
            "share_percent is too large; expected 100 or less",
        ),
        ("{outliers: {share_percent: 1}}", "size_um is missing"),
        ("{outliers: {size_um: 1}}", "share_percent is missing"),
        ("{tails_dof: 0}", "tails_dof is too small; expected more than 0"),
        ("{noise_um: 1e-320}", "noise_um is too small; expected 0, or 1e-09 or more"),
        ("{drift_um: 1.0e+10}", "drift_um is too large; expected 1e+09 or less"),
        ("{growth_of_noise: -1}", "growth_of_noise is too small; expected 0 or more"),
        ("{noise_negative_um: -1}", "noise_negative_um is too small; expected 0 or more"),
        ("{traverses: {offset_um: -1}}", "offset_um is too small; expected 0 or more"),
        ("{traverses: {shift_um: 1}}", "shift_um: unknown key"),
    ],
)
def test_faults(error: str, message: str) -> None:
    with pytest.raises(UsageError) as caught:
        machine(error)
    assert len(caught.value.faults) == 1
    assert message in str(caught.value)
