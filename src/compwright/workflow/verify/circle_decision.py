"""Decide from a circle after loading how the table of a squareness or scale error was loaded."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from compwright.controls.control import Control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.judged_corrections import judged_cross
from compwright.foundations.findings import Finding
from compwright.planning.wanted_correction import axis_compensation
from compwright.prediction.dead_zone import applied_compensation
from compwright.records.axis import Direction
from compwright.records.correction import AxisCompensation, ControlState, no_compensation
from compwright.records.plan import Plan, PlannedCircle, PlannedCross
from compwright.records.stored_table import StoredTable
from compwright.records.verification import LoadingVerdict
from compwright.verification.circle_loading import ShownValue, TableInCircle, judge_circle
from compwright.verification.hypothesis import Loading


@dataclass(frozen=True, slots=True, kw_only=True)
class TablesOnControl:
    """The tables of a plan and those that the control had before.

    ``control``: in the state of its files before. ``as_found``: contents of the control before.
    ``stored``: the same with its tables switched on. ``read_back``: by the axes of each table that
    was read back from the control, whether it is as planned.
    """

    control: Control
    plan: Plan
    as_found: DecodedState
    stored: ControlState
    read_back: Mapping[frozenset[str], bool]

    @classmethod
    def of(
        cls,
        control: Control,
        plan: Plan,
        as_found: DecodedState,
        stored: ControlState,
        between: Sequence[tuple[PlannedCross | None, Finding]],
        axes: Mapping[str, Mapping[str, Any]],
        *,
        believed: bool,
    ) -> TablesOnControl:
        """Return the tables. ``between``: what is wrong with tables between axes that were read
        back. ``axes``: the axes in the document of ``compare``. ``believed``: whether anything was
        read back from the control.
        """
        same = {entry.pair: True for entry in plan.cross if entry.delivered}
        for entry, found in between:
            if entry is not None and found.code == "CW-V011":
                same[entry.pair] = False
            elif entry is not None:
                same.pop(entry.pair, None)
        same |= {frozenset({name}): axis["verdict"] == "loaded" for name, axis in axes.items()}
        return cls(
            control=control,
            plan=plan,
            as_found=as_found,
            stored=stored,
            read_back=same if believed else {},
        )

    def judged_squareness(
        self,
        table: TableInCircle,
        entry: PlannedCross,
        shown: ShownValue,
        during: DecodedState | None,
    ) -> LoadingVerdict:
        """Return the verdict on how the correction ``entry`` was loaded. ``during``: contents of
        the control in the first test.
        """
        old, active = (_existing(entry, each) for each in (self.as_found, during))
        change = entry.added.by_input
        total = change
        if old.positions.size:
            where = np.union1d(old.positions, change.positions)
            positive, negative = (old.at(where, d) + change.at(where, d) for d in Direction)
            total = replace(old, positions=where, positive=positive, negative=negative)
        # A control has one table with the total, or one with the change next to the existing one.
        tables = [total, *([replace(change, others=(old,))] if old.positions.size else [])]
        as_planned = self.read_back.get(entry.pair) is True
        loadings = [
            Loading(
                new=StoredTable.by_point(each),
                old=old,
                active_before=active,
                read_back=as_planned,
                axis=entry.input,
            )
            for each in tables
        ]
        return judge_circle(shown, table, loadings)

    def judged_scale(
        self, table: TableInCircle, name: str, shown: ShownValue, during: DecodedState | None
    ) -> LoadingVerdict:
        """Return the verdict on how the table of the axis ``name`` was loaded. ``during``: contents
        of the control in the first test.
        """
        axis = self.plan.axes[name].axis
        tables = {
            each: self.control.format.stored_table(
                entry.axis, applied_compensation(entry.fitted.compensation, entry.axis)
            )
            for each, entry in self.plan.axes.items()
            if entry.fitted is not None
        }
        none = no_compensation(axis.address, axis.kind, axis.reference_return)
        as_planned = self.read_back.get(frozenset({name})) is True
        loading = Loading(
            new=tables.pop(name),
            old=axis_compensation(self.stored, axis),
            active_before=none if during is None else axis_compensation(during.state, axis),
            others=tables,
            reference=axis.reference,
            read_back=as_planned,
        )
        return judge_circle(shown, table, [loading])


def table_in_circle(circle: PlannedCircle, given: str, bent: str) -> TableInCircle:
    """Return the table of a circle's plane that moves the axis ``bent`` by the position of the axis
    ``given``.
    """
    axes = circle.test.axes
    index = axes.index(given)
    middle = circle.centre[index]
    return TableInCircle(circle.test.nominal_radius, middle, index, axes.index(bent))


def _existing(entry: PlannedCross, decoded: DecodedState | None) -> AxisCompensation:
    tables = () if decoded is None else judged_cross(decoded)
    found = [each for each in tables if (each.input, each.output) == entry.addresses]
    if not found:
        return no_compensation(entry.added.input, entry.added.input_kind)
    return found[0].by_input
