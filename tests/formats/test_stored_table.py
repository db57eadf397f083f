"""The rows of a table are those of the written files: entries of PMAC from motor zero on, and the
point numbers of FANUC, with the number of the reference where the travel begins or ends there.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from compwright.formats.families.family import Family
from compwright.formats.families.shapes import control_format
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation
from format_samples import DEFINITIONS

PLUS, MINUS = Direction


def axis(travel: tuple[float, float], modulo: float | None = None) -> Axis:
    kind = AxisKind.LINEAR if modulo is None else AxisKind.ROTARY
    return Axis(name="X", kind=kind, travel=travel, address="1", modulo=modulo)


def table(
    low: int, values: list[int], lost: int = 0, period: float | None = None
) -> AxisCompensation:
    """Values (µm) at points 50 mm apart from ``low`` on; ``lost``: less in -."""
    return AxisCompensation(
        address="1",
        kind=AxisKind.LINEAR if period is None else AxisKind.ROTARY,
        positions=50.0 * np.arange(low, low + len(values), dtype=np.float64),
        positive=np.array(values) / 1000.0,
        negative=(np.array(values) - lost) / 1000.0,
        period=period,
    )


def written(control: Family, axis_: Axis, one: AxisCompensation) -> str:
    return "".join(file.content.decode() for file in control.write([one], [axis_]))


@pytest.mark.parametrize("counts", [1000.0, -1000.0])
@pytest.mark.parametrize("lost", [0, 4])
def test_the_rows_of_pmac_are_its_entries(counts: float, lost: int) -> None:
    control = control_format(DEFINITIONS["pmac"], {"counts_per_unit": counts})
    ahead = PLUS if counts > 0 else MINUS
    # zero at motor zero in the direction in which the motor counts up
    values = np.array([3, -2, 0, 5, 7, 1, -4]) + (lost if ahead is MINUS else 0)
    x, one = axis((-100.0, 200.0)), table(-2, values.tolist(), lost)
    text = written(control, x, one)
    (found,) = re.findall(r"DEFINE COMP \d+,#1D,(\d+)\s((?:\s*-?\d+)+)", text)
    entries = np.array(found[1].split(), dtype=float) / (16 * counts)
    stored = control.stored_table(x, one)
    curve = stored.compensation.curve(ahead)
    np.testing.assert_allclose(stored.rows(curve), entries, atol=1e-9)
    assert stored.compensation.period == float(found[0]) / abs(counts)
    # as planned over the travel, and the rows alone make the table
    where = np.linspace(-100.0, 200.0, 61)
    for side in Direction:
        np.testing.assert_allclose(
            stored.compensation.at(where, side), one.at(where, side), atol=1e-12
        )
        own = stored.compensation.curve(side)
        np.testing.assert_allclose(stored.curve(stored.rows(own)) + own[stored.zero], own)
    # entry i of n is i/n of the length from motor zero, in the direction in which the motor counts
    turned = entries[::-1]
    faulty = replace(stored.compensation, positive=stored.curve(turned))
    where = where[where != 0.0]  # where the last entry ends, the first one has begun
    along = np.mod(where * counts, float(found[0]))
    places = float(found[0]) * np.arange(entries.size + 1) / entries.size
    by_hand = np.interp(along, places, np.append(0.0, turned))
    np.testing.assert_allclose(faulty.at(where, PLUS), by_hand, atol=1e-12)


@pytest.mark.parametrize(
    ("low", "values"),
    [
        (-2, [3, 1, 0, 2, 5]),
        (0, [0, 2, 5, 4]),  # begins at the reference: its own number too
        (-3, [4, 5, 2, 0]),  # ends there: one more number
    ],
)
def test_the_rows_of_fanuc_are_its_points(low: int, values: list[int]) -> None:
    control = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001, "first_point": 1})
    x = axis((50.0 * low, 50.0 * (low + len(values) - 1)))
    one = table(low, values)
    points = [float(one) for one in re.findall(r"N1\d{4}Q0P(-?\d+)", written(control, x, one))]
    stored = control.stored_table(x, one)
    curve = stored.compensation.positive
    rows = stored.rows(curve)
    np.testing.assert_allclose(rows * 1000.0, points, atol=1e-9)
    np.testing.assert_allclose(stored.curve(rows), curve, atol=1e-12)
    # number n owns the section that ends n - 3620 intervals from the reference (the manual's rule)
    (first,) = re.findall(r"N03620Q1A1P(\d+)", written(control, x, one))
    places = 50.0 * (1 + np.arange(rows.size) - int(first))
    np.testing.assert_allclose(stored.compensation.positions[stored.row_points], places)


def test_the_rows_of_a_turn_of_fanuc() -> None:
    """The number of the reference holds the same as the last one."""
    control = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001, "first_point": 1})
    x = axis((0.0, 200.0), modulo=200.0)
    one = table(0, [0, 3, -2, 1, 0], period=200.0)
    points = [float(one) for one in re.findall(r"N1\d{4}Q0P(-?\d+)", written(control, x, one))]
    stored = control.stored_table(x, one)
    np.testing.assert_allclose(stored.rows(one.positive) * 1000.0, points, atol=1e-9)
    np.testing.assert_allclose(stored.curve(stored.rows(one.positive)), one.positive)
