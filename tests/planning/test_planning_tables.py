"""Tables on the grid that is there: what happens where it cannot serve, and when another one is
offered.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from test_fitting import COARSE, FINE, UM, wavy, wish

from compwright.foundations.errors import CapacityError
from compwright.planning import tables
from compwright.planning.tables import fit_within, free_grid_table, grid_text, new_grid_offer
from compwright.records.axis import Axis
from compwright.records.capacity import Capacity, Lattice
from compwright.records.fitted_table import TableRequest
from compwright.records.prediction import Quantiles, TestPrediction
from planning_samples import KnownAxis, axis_of, work_of

X = np.linspace(0.0, 500.0, 501)
AXIS: Axis = axis_of(travel=(0.0, 500.0), reference=0.0)
WANTED = wish(wavy(X), wavy(X), positions=X)
KEEP = TableRequest()
COARSE_GRID = (0.0, 250.0, 500.0)
FINE_GRID = tuple(float(node) for node in range(0, 501, 10))
#: Steps of 1 µm, seven at most from node to node.
STEEP = Lattice(unit=1 * UM, increments=(-7, 7), magnifications=(1,))


def stepping(there: tuple[float, ...]) -> Capacity:
    return replace(COARSE, lattice=STEEP, anchored=True, backlash_quantum=UM, there=there)


# --- what cannot serve
# --------------------------------------------------------------------------------------------------


def test_a_correction_beyond_its_increments_gets_a_new_grid_and_the_reason() -> None:
    table = fit_within(WANTED, stepping(COARSE_GRID), KEEP, AXIS)
    assert not table.keeps_grid
    assert table.compensation.positions.size > 3
    first = table.findings[0]
    assert (first.code, first.severity) == ("CW-P140", "warning")
    assert first.message.startswith(f"Axis {AXIS.name}: the new table gets new points, ")
    assert (
        "of the existing table, 3 points from 0 to 500 mm, every 250 mm, cannot be kept"
        in first.message
    )
    assert "larger than the control can store (largest increment)" in first.message


def test_the_same_distance_insisted_on_is_refused() -> None:
    with pytest.raises(CapacityError, match="largest increment"):
        fit_within(WANTED, stepping(COARSE_GRID), TableRequest(spacing=250.0), AXIS)


def test_what_no_grid_holds_is_refused() -> None:
    with pytest.raises(CapacityError, match="largest increment"):
        fit_within(wish(0.02 * X, 0.02 * X, positions=X), stepping(COARSE_GRID), KEEP, AXIS)


@pytest.mark.parametrize("millimetres", [11.0, 100.0, 19000.0])
def test_what_exceeds_the_range_by_far_is_refused_before_anything_is_fitted(
    millimetres: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whole steps over metres would be searched for hours."""
    monkeypatch.setattr(tables, "fit_remaining", None)
    far = wish(millimetres * X / 500.0, millimetres * X / 500.0, positions=X)
    range_of_10_mm = replace(stepping(()), value_range=(-10.0, 10.0))
    with pytest.raises(CapacityError, match="value range") as refused:
        fit_within(far, range_of_10_mm, KEEP, AXIS)
    assert refused.value.faults[0].expected == "values from -10000 to 10000 µm"


def test_nodes_that_serve_other_axes_are_never_given_up() -> None:
    fixed = replace(stepping(COARSE_GRID), points=COARSE_GRID)
    with pytest.raises(CapacityError):
        fit_within(WANTED, fixed, KEEP, AXIS)


def test_without_a_table_there_is_nothing_to_say() -> None:
    codes = {one.code for one in fit_within(WANTED, FINE, KEEP, AXIS).findings}
    assert not codes & {"CW-P140", "CW-F011"}


# --- what another grid would gain
# --------------------------------------------------------------------------------------------------


def chosen(there: tuple[float, ...], request: TableRequest = KEEP) -> bool:
    capacity = replace(FINE, there=there)
    table = fit_within(WANTED, capacity, request, AXIS)
    return free_grid_table(WANTED, capacity, request, table, AXIS) is not None


def test_another_grid_is_tried_only_where_the_one_that_is_there_loses_something() -> None:
    assert chosen(COARSE_GRID)
    assert not chosen(FINE_GRID)
    assert not chosen(())
    assert not chosen(COARSE_GRID, TableRequest(spacing="auto"))
    assert not chosen(COARSE_GRID, TableRequest(spacing=250.0))


def told(
    gain: float, gain_at_new: float = 0.0, quantum: float = 0.1 * UM, band: float = 0.0
) -> str:
    """The offer where A falls from 10 µm by ``gain`` µm, at new targets from 12 by
    ``gain_at_new``; ``band``: 5 to 95 %, µm.
    """
    result = work_of(KnownAxis(np.zeros_like, np.zeros_like), AXIS).results[0]

    def prediction(same: float, new: float) -> TestPrediction:
        one, two = (
            {name: Quantiles(median * UM, (median - band / 2) * UM, (median + band / 2) * UM) for name in result.parameters}
            for median in (same, new)
        )  # fmt: skip
        return TestPrediction(name="x", before=result, predicted=one, predicted_new_targets=two)

    table = fit_within(WANTED, FINE, KEEP, AXIS)
    finding = new_grid_offer(
        AXIS,
        np.array(COARSE_GRID),
        table,
        prediction(10.0, 12.0),
        prediction(10.0 - gain, 12.0 - gain_at_new),
        quantum=quantum,
        written=True,
    )
    return "" if finding is None else finding.message


def test_a_gain_is_offered_in_both_predictions() -> None:
    words = told(2.0, 3.0)
    assert (
        "the new table keeps the points of the existing table (3 points from 0 to 500 mm, every"
        " 250 mm). Predicted A: 10.00 µm at the same targets, 12.00 µm at new targets." in words
    )
    assert "8.00 µm at the same targets, 9.00 µm at new targets" in words
    assert "To use the new points, set `spacing: auto`" in words


def test_a_gain_at_new_targets_alone_is_one() -> None:
    """At targets that are nodes a finer grid shows nothing."""
    assert told(0.0, 3.0)


def test_less_than_the_resolution_of_the_control_is_none() -> None:
    assert not told(0.9, quantum=1 * UM)
    assert told(1.1, quantum=1 * UM)


def test_less_than_a_test_would_show_is_none() -> None:
    """5 to 95 % of a normal law are 3.29 standard deviations (2 · 1.645)."""
    assert not told(0.9, band=3.29)
    assert told(1.1, band=3.29)


def test_a_loss_is_never_offered() -> None:
    assert not told(-5.0, -5.0)


def test_grids_in_words() -> None:
    even = grid_text(np.array([0.0, 40.0, 80.0]), "mm")
    assert str(even) == "3 points from 0 to 80 mm, every 40 mm"
    uneven = grid_text(np.array([0.0, 40.0, 100.0]), "mm")
    assert str(uneven) == "3 points from 0 to 100 mm, 40 to 60 mm apart"
