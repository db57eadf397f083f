"""Third stage of a run: fit tables under the limits of the control."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from compwright.controls.control import Control
from compwright.foundations.parallel_work import Each, in_turn
from compwright.planning.axis_fits import fit_all
from compwright.planning.axis_work import AxisWork
from compwright.planning.scale import ScaleCorrection, correct_scales
from compwright.records.plan import PlannedAxis
from compwright.workflow.run.estimate_stage import Wanted
from compwright.workflow.run.input_stage import Measured


@dataclass(frozen=True, slots=True, kw_only=True)
class Fitted:
    """The control, the axes with their fitted tables, and the corrections of scale errors found by
    circular tests.
    """

    control: Control
    works: Mapping[str, AxisWork]
    scaled: tuple[ScaleCorrection, ...] = ()

    @property
    def scales(self) -> dict[str, PlannedAxis]:
        """The axes whose table corrects a scale error from circles, by name."""
        return {entry.name: entry.planned for entry in self.scaled if entry.planned is not None}


def fitted(measured: Measured, wanted: Wanted, each: Each = in_turn) -> Fitted:
    """Return the tables fitted within the control's limits. If the present contents of the control
    are unknown, no table is fitted.

    Raises UsageError if an option contradicts the control's files, and CapacityError with the
    faults of all axes.
    """
    job, as_found = measured.job, measured.as_found
    if as_found is None:
        return Fitted(control=measured.control, works=wanted.works)
    control = measured.control.in_state(as_found.state)
    capacity_of = control.format.capacity
    return Fitted(
        control=control,
        works=fit_all(wanted.works, capacity_of, job.file, each, job.decision_rule),
        scaled=correct_scales(job, wanted.circles, wanted.checks, capacity_of, as_found.state),
    )
