"""Fourth stage of a run: write the tables as the control's files, and read these files again with
two independent readers.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.controls.control import Control, decode
from compwright.controls.cross_tables import CrossOutcome, write_planned
from compwright.controls.decoded_state import DecodedState
from compwright.controls.file_replacement import changed_neighbours, loadable_files
from compwright.controls.gantries import check_partners, with_partners
from compwright.controls.judged_corrections import applied_correction
from compwright.foundations.errors import CompwrightError, UsageError, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.parallel_work import Each, in_turn
from compwright.planning import axis_tasks
from compwright.planning.axis_work import AxisWork
from compwright.planning.cross import plan_cross
from compwright.planning.scale import scale_steps
from compwright.records.axis import Axis
from compwright.records.correction import ControlFile
from compwright.records.fitted_table import FittedTable
from compwright.records.job import AS_FOUND
from compwright.records.plan import PlannedAxis
from compwright.workflow.run.estimate_stage import Wanted
from compwright.workflow.run.input_stage import Measured
from compwright.workflow.run.table_stage import Fitted

_NOTHING_BETWEEN = CrossOutcome(files=())
FittedAxes = Sequence[tuple[Axis, FittedTable]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Written:
    """The files with the fitted tables, and the corrections read from them (``loaded``).

    ``entered``: the changed copies of the control's own files, and new files, whichever of them are
    delivered. ``back``: small files that restore the old values. ``works``: the axes, without the
    tables that would not improve them. ``cross``: the corrections between axes.
    """

    works: Mapping[str, AxisWork]
    tables: tuple[ControlFile, ...] = ()
    entered: tuple[ControlFile, ...] = ()
    back: tuple[ControlFile, ...] = ()
    loaded: DecodedState | None = None
    cross: CrossOutcome = _NOTHING_BETWEEN
    findings: tuple[Finding, ...] = ()


def written(
    measured: Measured,
    wanted: Wanted,
    fitted: Fitted,
    *,
    accept_worse: bool,
    each: Each = in_turn,
) -> Written:
    """Write the tables of a job as the control's files and read them again. Tables that improve
    nothing are left out, unless ``accept_worse``.

    Raises CapacityError if the control cannot hold a table. Raises CompwrightError (an internal
    fault) if the values read differ from those written.
    """
    as_found, control = measured.as_found, fitted.control
    if as_found is None:
        return Written(works=fitted.works)
    works = fitted.works
    tables, loaded = write_fitted(control, tables_of(works, fitted.scales), as_found)
    if loaded is not None and not accept_worse:
        works = _improving(works, loaded, each)
    if works is not fitted.works:
        tables, loaded = write_fitted(control, tables_of(works, fitted.scales), as_found)
    kept = tables_of(works, fitted.scales)
    plan = plan_cross(measured.job, wanted.circles, measured.active, measured.active[AS_FOUND])
    tabled = [axis.name for axis, table in kept if table.compensation.positions.size]
    cross = write_planned(control, plan.planned, tables, as_found, measured.axes, tabled)
    axes = [axis for axis, _ in kept]
    whole = None if axes else cross.after  # a cross-axis table alone may not show its unit
    if cross.written:
        loaded = whole or decode(control, cross.files, axes, carried_out=True)
    delivery = loadable_files(control, cross.files, as_found, axes, loaded)
    return Written(
        works=works,
        tables=delivery.files,
        entered=cross.files,
        back=delivery.back,
        loaded=replace(whole, files=delivery.files)
        if whole
        else (loaded if delivery.own else decode(control, delivery.files, axes, written=True)),
        cross=replace(cross, steps=(*scale_steps(fitted.scaled), *cross.steps)),
        findings=(
            *(finding for entry in fitted.scaled for finding in entry.findings),
            *plan.findings,
            *cross.findings,
        ),
    )


def tables_of(
    works: Mapping[str, AxisWork], scales: Mapping[str, PlannedAxis]
) -> list[tuple[Axis, FittedTable]]:
    """Return each axis that gets a table, with that table: first tables from positioning tests,
    then those from circles.
    """
    planned = (*(work.planned for work in works.values()), *scales.values())
    return [(entry.axis, entry.fitted) for entry in planned if entry.fitted is not None]


def _improving(
    works: Mapping[str, AxisWork], loaded: DecodedState, each: Each
) -> Mapping[str, AxisWork]:
    """Return all axes. An axis that its table would not improve has no table, but the reason
    instead.
    """
    tasks = {
        name: (work, applied_correction(loaded, work.planned.axis))
        for name, work in works.items()
        if work.planned.fitted is not None
    }
    reasons = zip(tasks, each(axis_tasks.gain_task, list(tasks.values())), strict=True)
    refused = {name: why for name, why in reasons if why}
    if not refused:
        return works
    return {
        name: (
            replace(work, refused=refused[name], planned=replace(work.planned, fitted=None))
            if name in refused
            else work
        )
        for name, work in works.items()
    }


def write_fitted(
    control: Control, fitted: FittedAxes, as_found: DecodedState
) -> tuple[tuple[ControlFile, ...], DecodedState | None]:
    """Write fitted tables as the control's files. Returns these files and the corrections that are
    read back from them.

    The files are changed copies of the present ones (``as_found``). Raises CapacityError if a value
    cannot be held. Raises CompwrightError (an internal fault) if the table of another axis reads
    differently than before.
    """
    if not fitted:
        return (), None
    axes = [axis for axis, _ in fitted]
    every = with_partners(control, fitted, as_found)
    compensations = [table.compensation for _, table in every]
    try:
        files = control.format.write(compensations, [axis for axis, _ in every], as_found.files)
    except UsageError as error:  # an option that the control's files do not answer
        named = all(fault.place in control.definition.options for fault in error.faults)
        raise (control.origin.named(error) if named else error) from error
    raise_all(CompwrightError, changed_neighbours(control, as_found.files, files, axes))
    loaded = decode(control, files, axes, written=True)
    check_partners(every, loaded)
    return files, loaded
