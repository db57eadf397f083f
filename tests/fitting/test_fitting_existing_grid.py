"""The grid that is in the control, kept by the fit: which nodes, and when it cannot serve.

Nodes are written out by hand.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from test_fitting import COARSE, FINE, UM, wavy, wish

from compwright.fitting.fit import fit_table
from compwright.foundations.errors import CapacityError
from compwright.records.axis import AxisKind
from compwright.records.capacity import Capacity, Lattice
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.words.sentences import say
from next_steps import without_hint

X = np.linspace(0.0, 500.0, 501)
SMOOTH = wish(wavy(X), wavy(X) + 4 * UM, positions=X)

#: Not what anybody would choose over 0 to 500 mm.
UNEVEN = (0.0, 70.0, 90.0, 300.0, 500.0)
EVEN = tuple(float(node) for node in range(-70, 561, 70))
THERE = replace(FINE, there=EVEN)
TURN = np.linspace(0.0, 360.0, 401)


def nodes(capacity: Capacity, **request: Any) -> list[float]:
    return [float(node) for node in kept(capacity, **request).compensation.positions]


def kept(capacity: Capacity, **request: Any) -> FittedTable:
    return fit_table(SMOOTH, capacity, TableRequest(**request), address="1")


def refused(capacity: Capacity, **request: Any) -> str:
    with pytest.raises(CapacityError) as caught:
        nodes(capacity, **request)
    (fault,) = caught.value.faults
    assert fault.place == "table.spacing"
    return without_hint(str(fault))


def test_what_is_there_stays() -> None:
    assert nodes(THERE) == list(EVEN)
    assert nodes(replace(THERE, cover=1)) == list(EVEN)  # it reaches as far as it did
    assert nodes(replace(COARSE, there=EVEN)) == list(EVEN)
    assert nodes(replace(FINE, spacing="free", there=UNEVEN)) == list(UNEVEN)


def test_whether_it_stays_is_told() -> None:
    assert kept(THERE).keeps_grid
    assert not kept(THERE, spacing="auto").keeps_grid
    assert not kept(FINE).keeps_grid
    assert "CW-F006" not in {finding.code for finding in kept(THERE).findings}  # as it did before


def test_auto_and_a_number_do_without_it() -> None:
    assert nodes(THERE, spacing="auto") == nodes(FINE)
    assert nodes(THERE, spacing=100.0) == [0, 100, 200, 300, 400, 500]


@pytest.mark.parametrize(
    ("request_", "left"),
    [
        ({"start": 70.0}, list(EVEN[2:])),
        ({"end": 490.0}, list(EVEN[:-1])),
        ({"start": 0.0, "end": 350.0}, [0, 70, 140, 210, 280, 350]),
        ({"end": 700.0}, [*EVEN, 630, 700]),
        ({"start": -210.0}, [-210, -140, *EVEN]),
    ],
)
def test_a_named_end_cuts_it_short_or_goes_on(
    request_: dict[str, float], left: list[float]
) -> None:
    assert nodes(THERE, **request_) == left


def test_where_nodes_may_lie_anywhere_a_named_end_is_one() -> None:
    free = replace(FINE, spacing="free", there=UNEVEN)
    assert nodes(free, start=80.0, end=450.0) == [80, 90, 300, 450]
    assert nodes(free, start=80.0, end=120.0) == [80, 90, 120]  # short, as the job says


def test_a_named_end_beside_an_even_grid_is_refused() -> None:
    assert "table.end is none of its points, which come every 70 mm" in refused(THERE, end=500.0)


def test_less_than_half_of_the_travel_is_no_use() -> None:
    assert nodes(replace(FINE, there=(0.0, 125.0, 250.0))) == [0, 125, 250]
    words = refused(replace(FINE, there=(0.0, 120.0, 240.0)))
    assert "covers less than half of the travel" in words
    assert "240 mm of it" in words


def test_a_grid_beyond_the_points_of_the_control_is_no_use() -> None:
    words = refused(replace(THERE, max_points=9))
    assert words.endswith("expected at most 9 points, found 10")
    assert "at least 11 points" in refused(replace(THERE, min_points=11))


def test_a_grid_without_the_reference_is_no_use_where_the_control_counts_from_there() -> None:
    beside = tuple(node + 1.0 for node in EVEN)
    assert "reference position, which is none" in refused(
        replace(FINE, anchored=True, there=beside)
    )
    assert nodes(replace(FINE, anchored=True, there=EVEN)) == list(EVEN)
    assert nodes(replace(FINE, there=beside)) == list(beside)


def test_unequal_steps_are_no_use_to_a_control_that_has_one() -> None:
    assert "not equally spaced" in refused(replace(FINE, there=UNEVEN))


def test_a_spacing_that_the_control_does_not_have_is_no_use() -> None:
    assert "does not take its spacing" in refused(replace(THERE, spacings=(64.0, 128.0)))


def test_what_only_the_format_knows_is_said() -> None:
    assert "cannot keep the points of the existing one: it repeats" in refused(
        replace(THERE, unfit="it repeats")
    )


def test_a_rule_for_the_least_spacing_is_told_and_the_grid_stays() -> None:
    ruled = replace(
        THERE, min_spacing=80.0, min_spacing_reason=say("as_written", text="feed / 7500")
    )
    result = kept(ruled)
    assert result.compensation.positions.tolist() == list(EVEN)
    (told,) = [one for one in result.findings if one.code == "CW-F011"]
    assert told.severity == "warning"
    assert "70 mm apart: feed / 7500" in told.message


# --- a turn
# --------------------------------------------------------------------------------------------------

ROUND = replace(FINE, period=360.0)


def turned(there: tuple[float, ...], reference: float, **request: Any) -> list[float]:
    around = wish(
        10 * UM * np.sin(np.radians(TURN)),
        10 * UM * np.sin(np.radians(TURN)),
        positions=reference + TURN,
        reference=reference,
    )
    around = replace(around, kind=AxisKind.ROTARY)
    table = fit_table(around, replace(ROUND, there=there), TableRequest(**request), address="1")
    return [float(node) for node in table.compensation.positions]


def test_a_turn_is_told_from_the_reference() -> None:
    turn = tuple(float(node) for node in range(0, 361, 45))
    assert turned(turn, 0.0) == list(turn)
    assert turned(turn, 90.0) == [node + 90.0 for node in turn]
    assert turned(tuple(node - 180.0 for node in turn), 0.0) == list(turn)


@pytest.mark.parametrize(
    ("there", "reference", "why"),
    [
        (tuple(range(0, 361, 45)), 10.0, "no point is there"),
        (tuple(range(0, 181, 45)), 0.0, "does not span the turn"),
    ],
)
def test_a_turn_that_cannot_be_told_from_the_reference_is_no_use(
    there: tuple[float, ...], reference: float, why: str
) -> None:
    with pytest.raises(CapacityError, match=why):
        turned(there, reference)


def test_ends_that_a_turn_has_may_be_named() -> None:
    turn = tuple(float(node) for node in range(0, 361, 45))
    assert turned(turn, 0.0, start=0.0, end=360.0) == list(turn)
    with pytest.raises(CapacityError, match=r"table.end is none of a table that goes round"):
        turned(turn, 0.0, end=180.0)


# --- whole increments
# --------------------------------------------------------------------------------------------------


def test_increments_stand_on_it_too() -> None:
    lattice = Lattice(unit=1 * UM, increments=(-7, 7), magnifications=tuple(range(1, 101)))
    control = replace(
        COARSE,
        lattice=lattice,
        anchored=True,
        interpolation="step",
        there=EVEN,
        backlash_quantum=UM,
    )
    result = kept(control)
    assert result.compensation.positions.tolist() == list(EVEN)
    assert result.keeps_grid
