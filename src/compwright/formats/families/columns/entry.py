"""Entries for one axis, as text."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from compwright.formats.families.columns.capacity import by_line
from compwright.formats.families.columns.sources import PARAMETERS
from compwright.formats.families.columns.values import TURN, column_scale
from compwright.formats.families.family import Family
from compwright.formats.text.entry_sheet import SheetRow
from compwright.formats.text.scale import NotHeld
from compwright.formats.text.values import name_of
from compwright.records.axis import Axis, AxisKind, FloatArray
from compwright.records.correction import AxisCompensation


class ColumnEntry:
    """Entries for one axis, as text."""

    def __init__(self, control: Family, axis: Axis, compensation: AxisCompensation) -> None:
        self.definition = control.definition
        self.axis = axis
        self.compensation = compensation
        self.options = control.options_of(axis)
        self.scale = column_scale(self.definition, axis.kind, self.options)
        self.line = by_line(self.options)
        self.nodes, self.positive, self.negative = _one_turn(axis, compensation)

    def value(self, correction: float) -> str:
        """Return a correction in mm or deg as the table holds it. Raises NotHeld."""
        return self.scale.write("value", correction)

    def points(self) -> list[SheetRow]:
        """Return the points of the sheet."""
        rows = []
        for number, (node, correction) in enumerate(zip(self.nodes, self.positive, strict=True)):
            position = self.scale.write("node_position", float(node))
            rows.append(
                SheetRow(str(number), position, self.value(float(correction)), self.axis.kind.unit)
            )
        return rows

    def parameters(self) -> dict[str, str]:
        """Return the parameters by quantity.

        With a table the linear parameter is 0, so nothing counts twice whichever of them is active.
        """
        straight = column_scale(self.definition, AxisKind.LINEAR, self.options)
        texts = {
            "backlash": self.scale.write("backlash", self.compensation.backlash),
            "slope": straight.write("slope", self.compensation.slope),
            "enabled": "0" if self.line else "1",
        }
        if self.axis.kind is AxisKind.ROTARY:
            del texts["slope"]  # it has no effect there
        return {
            name: texts[name]
            for name in PARAMETERS
            if name in texts and name in self.definition.bindings
        }

    def parameter_rows(self, left: Mapping[str, str]) -> list[SheetRow]:
        """Return the rows of the sheet for parameters that are entered there."""
        units = {"backlash": self.axis.kind.unit, "slope": "mm/m", "enabled": ""}
        return [
            SheetRow(name_of(self.definition, name), "", text, units[name])
            for name, text in left.items()
        ]


def _one_turn(
    axis: Axis, compensation: AxisCompensation
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return nodes and curves in the form of the table: those of an endless axis from 0 to 360
    degrees, wherever its reference is.

    Raises NotHeld when no node is at 0 degrees.
    """
    nodes, positive, negative = compensation.positions, compensation.positive, compensation.negative
    if axis.modulo is None or not nodes.size:
        return nodes, positive, negative
    turned = np.round(np.mod(nodes[:-1], TURN), 9) % TURN
    order = np.argsort(turned)
    if turned[order[0]] != 0:
        raise NotHeld(
            "the table needs a point at 0 degrees; a spacing that divides the reference"
            f" {axis.reference:g} would help"
        )
    where = np.concatenate([turned[order], [TURN]])
    curves = [
        np.concatenate([curve[:-1][order], [curve[:-1][order[0]]]])
        for curve in (positive, negative)
    ]
    return where, curves[0], curves[1]
