"""What a circle shows of a table, by hand, and that no wrong loading fault is named.

A correction of Y by + β times the position of X takes β of squareness (more than 90° is > 0); one
of X by its own position adds to its scale error. Over a circle both directions of motion count
alike. The faults are those of two numbers: the part of the existing table that is left, and the
part of the planned change that is active.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from compwright.records.axis import AxisKind
from compwright.records.correction import AxisCompensation, no_compensation
from compwright.records.stored_table import StoredTable
from compwright.verification.circle_loading import ShownValue, TableInCircle, judge_circle
from compwright.verification.hypothesis import Loading

NONE = no_compensation("X", AxisKind.LINEAR)


@pytest.mark.parametrize("axes", [(0, 1), (1, 0), (0, 0), (1, 1)])
def test_a_ramp_is_a_squareness_or_a_scale(axes: tuple[int, int]) -> None:
    table = TableInCircle(150.0, 400.0, *axes)
    sign = 1.0 if axes[0] == axes[1] else -1.0
    ramp = 1e-6 * (table.targets - 400.0)
    for change, shown in (
        ([ramp, ramp], [sign, 0.0]),
        ([ramp, 0.0 * ramp], [0.5 * sign, sign]),
        ([0.0 * ramp, ramp], [0.5 * sign, -sign]),
        ([0.0 * ramp + 0.001, 0.0 * ramp + 0.001], [0.0, 0.0]),  # set-up
        ([0.0 * ramp + 0.001, 0.0 * ramp - 0.001], [0.0, 0.0]),  # lost motion
    ):
        found = np.tensordot(table.weights(), np.stack(change), 2)
        assert found == pytest.approx(shown, abs=1e-9)


def ramp(angle: float) -> AxisCompensation:
    where = np.array([0.0, 800.0])
    values = 1e-6 * angle * where
    return replace(NONE, positions=where, positive=values, negative=values)


def test_no_wrong_fault_is_named() -> None:
    """Corrections of 10 to 80 µm/m, half of them added to an existing table; the machine is as
    before or not, and the noise is that of a good and of a bad circle.
    """
    rng = np.random.default_rng(5)
    named, cases = 0, 150
    for _ in range(cases):
        planned, existing = rng.uniform(10.0, 80.0), rng.choice([0.0, rng.uniform(5.0, 80.0)])
        planned, existing = np.array([planned, existing]) * rng.choice([-1.0, 1.0], 2)
        ways = {
            "loaded": (1.0, 1.0, 0.0),  # of the existing table, of the change, one direction
            "not_active": (1.0, 0.0, 0.0),
            "inverted": (-1.0, -1.0, 0.0),
            "scaled": (2.0, 2.0, 0.0),
            "one_direction": (1.0, 0.5, rng.choice([-1.0, 1.0])),
        }
        if existing:
            ways |= {"increment": (0.0, 1.0, 0.0), "on_top": (2.0, 1.0, 0.0)}
        name = str(rng.choice(list(ways)))
        old_part, part, side = ways[name]
        noise = 10.0 ** rng.uniform(-1.0, 0.0)
        machine = planned + existing + rng.choice([0.0, rng.normal(0.0, 1.5)])
        left = machine - old_part * existing - part * planned + rng.normal(0.0, noise)
        between = -side * planned + rng.normal(0.0, noise)
        old = ramp(existing) if existing else NONE
        tables = [ramp(planned + existing), replace(ramp(planned), others=(old,))]
        loadings = [
            Loading(new=StoredTable.by_point(one), old=old, active_before=old)
            for one in (tables if existing else tables[:1])
        ]
        shown = ShownValue(left, 0.0, planned, noise, (between, noise))
        found = judge_circle(shown, TableInCircle(150.0, 400.0, 0, 1), loadings)
        assert found.verdict in (name, "undecided")
        assert name in [each.verdict for each in found.candidates]
        named += found.verdict == name
    assert named > 0.6 * cases


def test_a_value_that_no_fault_explains_has_no_name() -> None:
    """-7.5 times 40 µm/m."""
    loading = Loading(new=StoredTable.by_point(ramp(40.0)), old=NONE, active_before=NONE)
    shown = ShownValue(340.0, 0.0, 40.0, 0.2, (0.0, 0.2))
    found = judge_circle(shown, TableInCircle(150.0, 400.0, 0, 1), [loading])
    assert (found.verdict, found.candidates) == ("undecided", ())
    assert "No known loading fault explains this" in found.message


def test_a_fault_with_many_variants_is_only_possible() -> None:
    """A shift by some points, or a part that is active, makes nearly every scale error."""
    where = np.linspace(-500.0, 0.0, 6)
    values = 60e-6 * where
    new = replace(NONE, positions=where, positive=values, negative=values)
    loading = Loading(new=StoredTable.by_point(new), old=NONE, active_before=NONE)
    listed = set[str]()
    for left in np.linspace(-150.0, 150.0, 61):
        shown = ShownValue(float(left), 0.0, 60.0, 0.5)
        found = judge_circle(shown, TableInCircle(150.0, -250.0, 1, 1), [loading])
        assert found.verdict not in ("shifted", "partial")
        listed |= {each.verdict for each in found.candidates if each.probability > 0.99}
    assert listed & {"shifted", "partial"}
