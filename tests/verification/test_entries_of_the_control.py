"""Faults of entries, computed from the manual's formula and from the written files.

PMAC: entry i of n is at i/n of the length from motor zero, 1/16 count of the motor; the table
repeats after its length. COMP is added in both directions; Ixx86 and BLCOMP are subtracted while
the motor counts down (Turbo PMAC User Manual, "Leadscrew compensation", "Backlash compensation").
FANUC: point number 3620 + i has the change of the correction over interval i.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

import numpy as np
import pytest

from compwright.formats.families.shapes import control_format
from compwright.records.axis import Axis, AxisKind, Direction, FloatArray
from compwright.records.correction import AxisCompensation, no_compensation
from compwright.records.stored_table import StoredTable
from compwright.verification.hypothesis import Hypothesis, Loading
from compwright.verification.loading_hypotheses import loading_hypotheses
from format_samples import DEFINITIONS

PLUS, MINUS = Direction
TRAVEL = (-150.0, 250.0)
TARGETS = np.linspace(
    -137.0, 243.0, 20
)  # none at 0, where the last entry ends and the first begins
#: µm at points 50 mm apart from -150 mm on, 0 at the reference.
X_VALUES = np.array([4.0, -2.0, 5.0, 0.0, 3.0, -6.0, 1.0, 2.0, -3.0])
Y_VALUES = np.array([-5.0, 1.0, -4.0, 0.0, 6.0, 2.0, -1.0, 4.0, 7.0])
#: How much less they are towards decreasing counts; 2 µm at the reference.
LOST = np.array([3.0, 2.5, 1.0, 2.0, 4.0, 3.0, 2.0, 1.5, 1.0])


class Motor:
    """A motor of PMAC with its written entries."""

    def __init__(self, address: str, per_unit: float, values: FloatArray, lost: FloatArray) -> None:
        control = control_format(DEFINITIONS["pmac"], {"counts_per_unit": per_unit})
        self.per_unit, self.ahead = per_unit, PLUS if per_unit > 0 else MINUS
        axis = Axis(name=address, kind=AxisKind.LINEAR, travel=TRAVEL, address=address)
        curves = {self.ahead: values / 1000.0, self.ahead.opposite: (values - lost) / 1000.0}
        if self.ahead is MINUS:  # counted down towards +: subtracted there is added here
            curves[PLUS] = (values + lost) / 1000.0
        table = AxisCompensation(
            address=address,
            kind=AxisKind.LINEAR,
            positions=np.linspace(*TRAVEL, values.size),
            positive=curves[PLUS],
            negative=curves[MINUS],
        )
        text = "".join(file.content.decode() for file in control.write([table], [axis]))
        self.stored: StoredTable = control.stored_table(axis, table)
        self.constant = float((re.search(r"I\d+86=(\d+)", text) or ["", "0"])[1])
        self.comp, self.lost = (self._column(text, kind) for kind in ("COMP", "BLCOMP"))
        self.length = float(re.findall(r"DEFINE COMP \d+,#\d+D,(\d+)", text)[0])

    @staticmethod
    def _column(text: str, kind: str) -> FloatArray:
        found = re.search(rf"DEFINE {kind} \d+,(?:#\d+D,)?\d+\s((?:\s*-?\d+)+)", text)
        return np.array(found[1].split() if found else [], dtype=np.float64)

    def added(
        self, comp: FloatArray, lost: FloatArray, constant: float, length: float = 0.0
    ) -> FloatArray:
        """What the control adds at the targets (2, m) with these entries, and with this length in
        counts (0: that of the motor).
        """
        length = length or self.length
        along = np.mod(TARGETS * self.per_unit, length) / length * comp.size

        def entry(values: FloatArray) -> FloatArray:
            whole = values if values.size else np.zeros(comp.size)
            held: FloatArray = np.interp(along, np.arange(comp.size + 1), np.append(0.0, whole))
            return held

        ahead, down = entry(comp), entry(comp) - constant - entry(lost)
        both = (ahead, down) if self.ahead is PLUS else (down, ahead)
        return np.stack(both) / (16.0 * self.per_unit)


def ways(
    new: StoredTable, name: str, targets: FloatArray = TARGETS, **others: StoredTable
) -> list[Hypothesis]:
    none = no_compensation("1", AxisKind.LINEAR)
    loading = Loading(new=new, old=none, active_before=none, others=others)
    return [one for one in loading_hypotheses(loading, targets) if one.name == name]


def nearest(found: Iterable[Hypothesis], curve: FloatArray) -> float:
    """The largest difference, µm, of the hypothesis that is nearest to a correction (2, m)."""
    return 1e3 * min(float(np.max(np.abs(one.change - curve))) for one in found)


NO_LOSS, CONSTANT = np.zeros(9), np.full(9, 2.0)


@pytest.mark.parametrize("per_unit", [1000.0, -1000.0])
@pytest.mark.parametrize("their", [1000.0, 2000.0, -1000.0])
@pytest.mark.parametrize(
    ("own", "loaded"), [(CONSTANT, LOST), (LOST, CONSTANT), (LOST, NO_LOSS), (NO_LOSS, LOST)]
)
def test_the_entries_of_another_motor(
    per_unit: float, their: float, own: FloatArray, loaded: FloatArray
) -> None:
    """With all columns of the other motor; where one of the two motors has no table of backlash,
    the entries of COMP alone, next to what this motor has of its own.
    """
    x = Motor("1", per_unit, X_VALUES, own)
    y = Motor("2", their, Y_VALUES, loaded)
    found = ways(x.stored, "wrong_axis", Y=y.stored)
    assert {one.of for one in found} == {"Y"}
    for lost in (y.lost, x.lost, np.empty(0)):
        for constant in (x.constant, y.constant):
            assert nearest(found, x.added(y.comp, lost, constant)) < 1e-6
    for lost in (y.lost, np.empty(0)):  # with its length, too
        assert nearest(found, x.added(y.comp, lost, y.constant, y.length)) < 1e-6


@pytest.mark.parametrize("per_unit", [1000.0, -1000.0])
@pytest.mark.parametrize("existing", [None, Y_VALUES])
def test_a_fault_of_one_of_the_two_tables(per_unit: float, existing: FloatArray | None) -> None:
    """COMP with a wrong factor or sign, moved, cut off, or still the old one, next to the right
    BLCOMP and Ixx86; and BLCOMP wrong next to the right COMP and Ixx86.
    """
    x = Motor("1", per_unit, X_VALUES, LOST)
    before = Motor("1", per_unit, existing, CONSTANT) if existing is not None else None
    old = before.stored.compensation if before else no_compensation("1", AxisKind.LINEAR)
    active = 0.0 if before is None else before.added(before.comp, before.lost, before.constant)
    kept = np.zeros(x.comp.size) if before is None else before.comp
    loading = Loading(new=x.stored, old=old, active_before=old)
    found = loading_hypotheses(loading, TARGETS)
    first = np.arange(x.comp.size) < 4
    wrong = [
        ("scaled", 2.0 * x.comp, x.lost),
        ("scaled", 10.0 * x.comp, x.lost),
        ("inverted", -x.comp, x.lost),
        ("shifted", np.append(0.0, x.comp[:-1]), x.lost),
        ("partial", np.where(first, x.comp, kept), x.lost),
        ("not_active", kept, x.lost),
        ("backlash", x.comp, 0.0 * x.lost),
        ("backlash", x.comp, -x.lost),
        ("backlash", x.comp, 2.0 * x.lost),
    ]
    if before is not None:
        wrong += [("on_top", x.comp + kept, x.lost), ("increment", x.comp - kept, x.lost)]
    for name, comp, lost in wrong:
        curve = x.added(comp, lost, x.constant) - active
        assert nearest([one for one in found if one.name == name], curve) < 1e-6, name


@pytest.mark.parametrize("per_unit", [1000.0, -1000.0])
@pytest.mark.parametrize("lost", [NO_LOSS, CONSTANT, LOST])
def test_entries_in_the_order_of_the_positions(per_unit: float, lost: FloatArray) -> None:
    """The value of the lowest point first, then on to +: against the counts it is back to front."""
    x = Motor("1", per_unit, X_VALUES, lost)
    places = np.mod(np.arange(1, x.comp.size + 1) * np.sign(per_unit), x.comp.size)
    places = np.where(50.0 * places > TRAVEL[1] + 100.0, places - x.comp.size, places)
    order = np.argsort(places)
    begin = int(np.flatnonzero(places[order] == -3)[0])
    whole, known = np.roll(order, -begin), np.arange(x.comp.size) < X_VALUES.size
    found = ways(x.stored, "shifted" if per_unit > 0 else "mirrored")
    for rest in (1.0, known):
        entries = rest * x.comp[whole]
        backlash = rest * x.lost[whole] if x.lost.size else x.lost
        assert nearest(found, x.added(entries, backlash, x.constant)) < 1e-6
    if per_unit > 0:
        # the value of -150 mm is in the first entry, at +50 mm: 4 points too far to +
        assert 4 in {one.shift_nodes for one in found if one.detail is not None}
        assert "in the order of the positions" in " ".join(str(one.detail) for one in found)


def test_the_sections_of_a_turn_in_the_order_of_the_positions() -> None:
    """A turn from -180° to 180°, whose sections are counted from 0° on."""
    control = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001, "first_point": 1})
    axis = Axis(name="C", kind=AxisKind.ROTARY, travel=(-180.0, 180.0), address="1", modulo=360.0)
    values = np.array([0.0, 3.0, -2.0, 4.0, 1.0, -3.0, 2.0, 5.0, 0.0]) / 1000.0
    table = AxisCompensation(
        address="1",
        kind=AxisKind.ROTARY,
        positions=np.linspace(0.0, 360.0, 9),
        positive=values,
        negative=values,
        period=360.0,
    )
    text = "".join(file.content.decode() for file in control.write([table], [axis]))
    points = [float(one) for one in re.findall(r"N1\d{4}Q0P(-?\d+)", text)]
    sections = np.array(points[-8:]) / 1000.0
    np.testing.assert_allclose(np.cumsum(sections), values[1:])
    entered = np.roll(sections, 4)  # that from -180° to -135° first
    targets = np.linspace(-170.0, 170.0, 18)
    where = np.mod(targets, 360.0)
    curve = np.interp(where, 45.0 * np.arange(9), np.append(0.0, np.cumsum(entered)))
    found = ways(control.stored_table(axis, table), "shifted", targets)
    assert nearest(found, np.stack([curve, curve])) < 1e-6
