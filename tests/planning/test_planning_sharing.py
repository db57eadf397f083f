"""Points of a store that all axes share, counted by hand."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from compwright.planning.shared_points import share_points
from compwright.records.capacity import Capacity
from compwright.records.fitted_table import TableRequest
from compwright.records.plan import PlannedAxis
from planning_samples import KnownAxis, axis_of, capacity_of, work_of

STORE = replace(capacity_of(axis_of()), shared_points=128, max_points=128)


def planned(
    name: str = "X", travel: tuple[float, float] = (0.0, 1000.0), **words: Any
) -> PlannedAxis:
    axis = axis_of(name, travel=travel, reference=words.pop("reference", 0.0))
    work = work_of(KnownAxis(np.zeros_like, np.zeros_like), axis)
    return replace(work.planned, request=TableRequest(**words))


def most(
    entries: dict[str, PlannedAxis], capacities: dict[str, Capacity] | None = None
) -> dict[str, int | None]:
    shared = capacities or dict.fromkeys(entries, STORE)
    return {name: one.max_points for name, one in share_points(shared, entries).items()}


def test_two_axes_get_half_of_the_store_each_less_the_two_points_that_a_table_may_need_more() -> (
    None
):
    assert most({"X": planned(), "Y": planned("Y")}) == {"X": 62, "Y": 62}  # 128 / 2 - 2


def test_one_axis_alone_has_the_whole_store() -> None:
    assert most({"X": planned()}) == {"X": 128}


def test_two_tables_of_one_axis_need_twice_the_points() -> None:
    assert most({"X": planned(mode="bidirectional")}) == {"X": 62}
    both = most({"X": planned(mode="bidirectional"), "Y": planned("Y")})
    assert both == {"X": 30, "Y": 62}  # 64 for each; two tables of 32 less 2


def test_an_axis_whose_spacing_is_named_gets_what_it_needs_first() -> None:
    """1000 mm every 50 mm: 20 intervals and 3 points more; the rest, 105, is the other one's."""
    assert most({"X": planned(spacing=50.0), "Y": planned("Y")}) == {"X": 128, "Y": 103}


def test_a_named_grid_counts_from_the_reference_even_where_that_lies_outside() -> None:
    """From -500 to 1000: 30 intervals; from 0 to 1500: as many."""
    assert most({"X": planned(spacing=50.0, reference=-500.0), "Y": planned("Y")})["Y"] == 93
    assert most({"X": planned(spacing=50.0, reference=1500.0), "Y": planned("Y")})["Y"] == 93


def test_a_named_start_and_end_count_in_place_of_the_travel() -> None:
    shorter = planned(spacing=50.0, start=100.0, end=600.0, reference=100.0)
    assert most({"X": shorter, "Y": planned("Y")})["Y"] == 128 - 13 - 2  # 10 intervals and 3


def test_two_named_tables_take_twice_as_much() -> None:
    named = planned(spacing=50.0, mode="bidirectional")
    assert most({"X": named, "Y": planned("Y")})["Y"] == 128 - 46 - 2


def test_a_store_of_ones_own_is_shared_with_nobody() -> None:
    own = replace(STORE, shared_points=None)
    entries = {"X": planned(), "Y": planned("Y")}
    assert most(entries, {"X": own, "Y": STORE}) == {"X": 128, "Y": 128}
    assert most({"X": planned()}, {"X": STORE, "Z": STORE}) == {"X": 128, "Z": 128}  # Z: no table


def test_a_grid_that_stays_takes_nothing_of_what_is_free() -> None:
    """It has its points already; where the job lets one be chosen, it takes part."""
    there = replace(STORE, there=tuple(np.arange(0.0, 1001.0, 40.0)))
    capacities = {"X": there, "Y": STORE}
    assert most({"X": planned(), "Y": planned("Y")}, capacities) == {"X": 128, "Y": 128}
    assert most({"X": planned(spacing="auto"), "Y": planned("Y")}, capacities) == {"X": 62, "Y": 62}


def test_a_grid_whose_points_another_axis_uses_too_takes_part() -> None:
    there = replace(STORE, there=tuple(np.arange(0.0, 1001.0, 40.0)), there_shared=True)
    assert most({"X": planned(), "Y": planned("Y")}, {"X": there, "Y": there}) == {"X": 62, "Y": 62}


def test_a_store_that_is_full_leaves_two_points_which_writing_then_refuses() -> None:
    assert most({"X": planned(spacing=5.0), "Y": planned("Y")})["Y"] == 2


def test_an_axis_never_gets_more_than_it_may_hold_itself() -> None:
    entries = {"X": planned(), "Y": planned("Y")}
    small = replace(STORE, max_points=40)
    assert most(entries, {"X": small, "Y": STORE}) == {"X": 40, "Y": 62}


def test_no_axis_is_left_less_than_the_points_that_it_has_already() -> None:
    """X has 41 of its own, Y and Z none; 20 are free: 20 / 3 - 2 are too few for anything but the
    two points that a table has at least.
    """
    having = replace(STORE, shared_points=20, own_points=41)
    having_none = replace(STORE, shared_points=20)
    entries = {name: planned(name, spacing="auto") for name in "XYZ"}
    stores = {"X": having, "Y": having_none, "Z": having_none}
    assert most(entries, stores) == {"X": 41, "Y": 4, "Z": 4}
    two = {"X": planned(mode="bidirectional", spacing="auto")}
    assert most(two, {"X": having}) == {"X": 20}


def test_a_named_grid_takes_from_the_store_only_what_its_own_points_do_not_hold() -> None:
    """20 intervals have 21 points; the two to spare are for a table in the store."""
    entries = {"X": planned(spacing=50.0), "Y": planned("Y")}
    assert most(entries, {"X": replace(STORE, own_points=21), "Y": STORE})["Y"] == 126
    assert most(entries, {"X": replace(STORE, own_points=20), "Y": STORE})["Y"] == 103
