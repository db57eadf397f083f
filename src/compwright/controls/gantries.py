"""Gantries: tables for a slave axis whose existing table differs from that of its master."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from compwright.controls.control import Control
from compwright.controls.decoded_state import DecodedState
from compwright.controls.judged_corrections import judged_correction
from compwright.controls.reader_comparison import probe_positions, table_positions
from compwright.formats.families.coupled_axes import SAME_TABLE
from compwright.foundations.errors import CapacityError, CompwrightError, Fault, raise_all
from compwright.foundations.findings import Finding
from compwright.foundations.own_faults import SEND_JOB
from compwright.foundations.units import outside_factor, shown_unit
from compwright.planning.tables import fit_within
from compwright.prediction.active_corrections import difference
from compwright.records.axis import Axis, Direction, FloatArray, partner_of
from compwright.records.capacity import Capacity
from compwright.records.correction import AxisCompensation, ControlState, no_compensation
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import FittedTable, TableRequest
from compwright.records.job import AS_FOUND, Job
from compwright.verification.read_back import SAME

FittedAxes = Sequence[tuple[Axis, FittedTable]]
#: Positions over the travel at which two tables are compared.
_DENSE = 401
#: Points are the same below this many mm or deg.
_SAME_POINT = 1e-6
#: A skew that changes by more than this many mm or deg is a warning.
_SKEW = 1e-3
#: A change that moves both axes apart by more than this many mm or deg is a doubt: finer than this
#: no two grids agree after rounding.
_APART = 2e-3
_ANSWERS = (
    "`gantry: {{axis: {address}, table: same}}` (both axes get the same total) or `gantry: {{axis:"
    " {address}, table: change}}` (the same change is added to the existing table of each)"
)


def partner_questions(
    job: Job, states: Mapping[str, DecodedState]
) -> tuple[list[Fault], list[Fault]]:
    """Return two lists of faults of gantries: two different tables, for which the job must decide
    what the slave gets; and a difference that has changed since the first test.

    ``states``: the decoded files by name of the state. The key ``gantry_table`` of the job decides
    what the slave gets.
    """
    questions: list[Fault] = []
    faults: list[Fault] = []
    for name, entry in job.axes.items():
        axis = entry.axis
        if axis.gantry is None or not (entry.before or name in job.apply.scale):
            continue
        measured_in = [request.measured_in for request in entry.before[:1]]
        concerned = [one for one in dict.fromkeys((AS_FOUND, *measured_in)) if one in states]
        found = {one: differing(axis, states[one].state) for one in concerned}
        own = {one: words for one, words in found.items() if words}
        place = f"axes.{name}.gantry"
        if own and axis.gantry_table is None:
            questions += [
                Fault(
                    message=(
                        f"axes {axis.address} and {axis.gantry} move together as a gantry, but "
                        f"have different compensation in the control's files of `states: {state}`"
                    ),
                    file=job.file,
                    place=place,
                    expected=_ANSWERS.format(address=axis.gantry),
                    found=f"a different {' and '.join(words)}",
                    hint=f"write one of these two answers into axis {name} of the job",
                )
                for state, words in own.items()
            ]
        elif axis.gantry_table == "change" and _skews_differ(axis, states, measured_in):
            faults.append(
                Fault(
                    message=(
                        f"`table: change` keeps the difference between the compensations of the "
                        f"gantry axes {axis.address} and {axis.gantry}. This difference is not the "
                        f"same in `{measured_in[0]}`, the state of the first test, as in "
                        f"`{AS_FOUND}`, the state of the control now"
                    ),
                    file=job.file,
                    place=place,
                    expected=f"a first test with `measured_in: {AS_FOUND}`, or `table: same`",
                    found="`table: change`",
                    hint=(
                        f"set `measured_in: {AS_FOUND}` for the first test if it was "
                        "taken in that state, or set `table: same`"
                    ),
                )
            )
    return questions, faults


def differing(axis: Axis, state: ControlState) -> list[str]:
    """Return as words what differs between a gantry's two tables: values, points, backlash."""
    leading, partner = _both(axis, state)
    facts, own_facts = (state.facts_of(address) for address in (axis.address, str(axis.gantry)))
    grid, own_grid = _grid(leading, facts.grid), _grid(partner, own_facts.grid)
    where = _where(axis, leading, partner)
    if not (own_grid.size or any(np.any(partner.at(where, side)) for side in Direction)):
        return []
    gaps = [
        (partner.at(where, side) - partner.backlash_at(side))
        - (leading.at(where, side) - leading.backlash_at(side))
        for side in Direction
    ]
    same_grid = grid.shape == own_grid.shape and np.allclose(grid, own_grid, atol=_SAME_POINT)
    rapid = (facts.rapid_more, own_facts.rapid_more)
    words = {
        "table" if own_grid.size or grid.size else "backlash": np.max(np.abs(gaps)) > SAME_TABLE,
        "grid": bool(own_grid.size) and not same_grid,
        "backlash at rapid traverse": rapid[0] != rapid[1],
    }
    lost = abs(partner.backlash - leading.backlash) > SAME_TABLE
    found = [word for word, differs in words.items() if differs]
    return list(dict.fromkeys([*found, *(["backlash"] if lost else [])]))


def with_partners(
    control: Control, fitted: FittedAxes, as_found: DecodedState
) -> list[tuple[Axis, FittedTable]]:
    """Return the fitted tables, and a table for each gantry slave that gets the same change as the
    table of its master. ``as_found``: the control's files before.

    Raises CapacityError if the control cannot store the table of a slave.
    """
    made = list(fitted)
    faults: list[Fault] = []
    for axis, table in fitted:
        if axis.gantry is None or axis.gantry_table != "change":
            continue
        partner = partner_of(axis, axis.gantry)
        try:
            made.append((partner, _changed(control, axis, partner, table, as_found)))
        except CapacityError as error:
            faults.extend(fault.within(f"axis {partner.name}") for fault in error.faults)
    raise_all(CapacityError, faults)
    return made


def check_partners(axes: Sequence[tuple[Axis, FittedTable]], loaded: DecodedState) -> None:
    """Raise CompwrightError if the independent file reader (virtual control) finds a wrong table on
    a gantry slave.

    Such a table is an internal error. ``axes``: axes and tables as `with_partners` returns them.
    ``loaded``: the written files, decoded.
    """
    tables = {axis.address: table.compensation for axis, table in axes}
    faults = []
    for axis, table in axes:
        if axis.gantry is None:
            continue
        own = tables.get(axis.gantry)
        back = judged_correction(loaded, partner_of(axis, axis.gantry))
        if own is None:
            meant = judged_correction(loaded, axis)
            where = probe_positions(table.compensation.positions)
        else:
            meant = own.at
            where = table_positions(own.positions, axis.travel)
        off = difference(meant, back)
        if any(float(np.max(np.abs(off(where, side)))) > SAME for side in Direction):
            faults.append(
                Fault(
                    message="an internal error of compwright: the table in the new files is not "
                    f"the one meant for gantry axis {axis.gantry}",
                    place=f"axis {axis.name}",
                    hint=f"load nothing of this run, and {SEND_JOB}",
                )
            )
    raise_all(CompwrightError, faults)


def skew_findings(
    axes: Iterable[Axis],
    as_found: DecodedState,
    loaded: DecodedState | None,
    gains: Mapping[str, float],
) -> Iterator[Finding]:
    """Yield findings on the difference between a gantry's two tables, before and after loading.
    ``gains``: by axis name, by how much the new table reduces the main parameter of the test (such
    as A or E), mm or deg.
    """
    for axis in axes:
        if axis.gantry is None or axis.gantry_table is None or loaded is None:
            continue
        unit = axis.kind.unit
        factor, small = outside_factor(unit), shown_unit(unit)
        where = np.linspace(*axis.travel, _DENSE)
        was, now = (_skew(axis, state, where) for state in (as_found, loaded))
        moved = float(np.max(np.abs(np.subtract(now, was)))) * factor
        before, after = (float(np.max(np.abs(one))) * factor for one in (was, now))
        yield Finding.of(
            "CW-S036",
            "warning" if moved > _SKEW * factor else "info",
            axes=(axis.address,),
            gantry=axis.gantry,
            table=axis.gantry_table,
            axis=axis.name,
            after=after,
            unit=small,
            before=before,
            moved=moved,
        )
        gain = gains.get(axis.name, 0.0) * factor
        if axis.gantry_table == "change" and moved > _APART * factor:
            yield Finding.of(
                "CW-S038",
                "warning",
                axes=(axis.address,),
                axis=axis.name,
                gantry=axis.gantry,
                moved=moved,
                unit=small,
                limit=_APART * factor,
                gain=gain,
            )


def _skew(axis: Axis, state: DecodedState, where: FloatArray) -> list[FloatArray]:
    """Return the correction of the slave axis minus that of its master at the positions ``where``,
    for each direction.
    """
    own, leading = (
        judged_correction(state, partner_of(axis, str(axis.gantry))),
        judged_correction(state, axis),
    )
    return [own(where, side) - leading(where, side) for side in Direction]


def _skews_differ(
    axis: Axis, states: Mapping[str, DecodedState], measured_in: Sequence[str]
) -> bool:
    """Return whether the difference between a gantry's two tables has changed since the first test.
    ``measured_in``: names of the states in which the axis was measured.
    """
    test = [states[name] for name in measured_in if name in states and name != AS_FOUND]
    if not test or AS_FOUND not in states:
        return False
    where = np.linspace(*axis.travel, _DENSE)
    then, now = (np.array(_skew(axis, one, where)) for one in (test[0], states[AS_FOUND]))
    return bool(np.max(np.abs(then)) > SAME and np.max(np.abs(then - now)) > SAME)


def _both(axis: Axis, state: ControlState) -> tuple[AxisCompensation, AxisCompensation]:
    leading, partner = (
        state.axes.get(address, no_compensation(address, axis.kind, axis.reference_return))
        for address in (axis.address, str(axis.gantry))
    )
    return leading, partner


def _grid(table: AxisCompensation, idle: Sequence[float]) -> FloatArray:
    """Return the positions of a table's points; for a table with fewer than two points return the
    positions ``idle``.
    """
    return table.positions if table.positions.size > 1 else np.array(idle, dtype=np.float64)


def _where(axis: Axis, *tables: AxisCompensation) -> FloatArray:
    """Return positions at which to compare tables: over the travel, and at the tables' points."""
    points = [other.positions for table in tables for other in (table, *table.others)]
    return np.unique(np.concatenate([np.linspace(*axis.travel, _DENSE), *points]))


def _changed(
    control: Control, axis: Axis, partner: Axis, table: FittedTable, as_found: DecodedState
) -> FittedTable:
    """Return a gantry slave's new table: its old one plus the change of its master's table.

    The change applies over the travel. First it is added at each point of the slave's table. If
    this moves the two axes apart by more than `_SKEW`, a table is also fitted. The table that moves
    the axes apart the least is returned. Raises CapacityError if the control can store neither.
    """
    old, own = _both(axis, as_found.state)
    new, capacity = table.compensation, control.format.capacity(partner)
    idle = as_found.state.facts_of(partner.address).grid
    where = np.linspace(*axis.travel, _DENSE)

    def change(points: FloatArray, side: Direction) -> FloatArray:
        return new.at(points, side) - old.at(points, side)

    def apart(made: FittedTable) -> float:
        held = made.compensation
        gaps = [
            held.at(where, side) - own.at(where, side) - change(where, side) for side in Direction
        ]
        return float(np.max(np.abs(gaps)))

    by_point = _by_point(partner, old, own, new, capacity, idle)
    made: list[FittedTable] = []
    if by_point is not None:
        try:
            control.format.write([new, by_point], [axis, partner], as_found.files)
        except CapacityError:
            pass
        else:
            made.append(replace(table, compensation=by_point))
            if apart(made[0]) <= _SKEW:
                return made[0]
    within = _where(axis, new, old, own)
    within = within[(within >= axis.travel[0]) & (within <= axis.travel[1])]
    wanted = WantedCorrection(
        kind=axis.kind,
        positions=within,
        positive=own.at(within, Direction.POSITIVE) + change(within, Direction.POSITIVE),
        negative=own.at(within, Direction.NEGATIVE) + change(within, Direction.NEGATIVE),
        reference=axis.reference,
        reference_return=axis.reference_return,
        noise=capacity.quantum,
    )
    request = TableRequest(mode=table.mode)
    if not (own.positions.size > 1 or idle) and new.positions.size > 1:
        spacing = float(new.positions[1] - new.positions[0])
        start, end = float(new.positions[0]), float(new.positions[-1])
        request = replace(request, start=start, end=end, spacing=spacing)
    try:
        made.append(fit_within(wanted, capacity, request, partner))
    except CapacityError:
        if not made:
            raise
    return min(made, key=apart)


def _by_point(
    partner: Axis,
    old: AxisCompensation,
    own: AxisCompensation,
    new: AxisCompensation,
    capacity: Capacity,
    idle: Sequence[float],
) -> AxisCompensation | None:
    """Return the slave's table ``own`` plus, at each point, the change of its master's table from
    ``old`` to ``new``; None if the control cannot store the sum. ``idle``: the points of the
    slave's inactive table.

    ``capacity``: limits of the slave's table. The master's table is taken as linear between points,
    even if the control applies it in steps. Otherwise a step at another position would move the
    axes apart by the whole step. The change is constant outside the points that enclose the travel.
    """
    grid = _grid(own, idle)
    if capacity.there and own.period is None:
        points = np.array(capacity.there)
    else:
        points = grid if grid.size else new.positions
    ahead, behind = (replace(one, interpolation="linear") for one in (new, old))
    low, high = partner.travel
    below, above = points[points <= low], points[points >= high]
    held = np.clip(points, below[-1] if below.size else -np.inf, above[0] if above.size else np.inf)
    curves = {
        side: own.at(points, side)
        + (ahead.at(held, side) - behind.at(held, side))
        - sum(one.at(points, side) for one in capacity.stays)
        for side in Direction
    }
    total = replace(
        own,
        address=partner.address,
        positions=points,
        positive=curves[Direction.POSITIVE],
        negative=curves[Direction.NEGATIVE],
        backlash=own.backlash + new.backlash - old.backlash,
        slope=0.0 if points.size else own.slope + new.slope - old.slope,
        interpolation=new.interpolation,
        below=new.below,
        above=new.above,
        period=own.period if grid.size else new.period,
        others=capacity.stays,
    )
    return _rounded(total, capacity)


def _rounded(table: AxisCompensation, capacity: Capacity) -> AxisCompensation | None:
    """Return a table rounded to values that the control can store; None if it needs two curves and
    the control has one.
    """
    quantum, step = capacity.quantum, capacity.backlash_quantum
    lost = 0.0 if step is None else round(table.backlash / step) * step
    single = replace(table, backlash=lost)
    curves = {side: table.curve(side) - single.backlash_at(side) for side in Direction}
    if not table.positions.size:
        return single
    apart = float(np.max(np.abs(curves[Direction.POSITIVE] - curves[Direction.NEGATIVE])))
    if apart > 0.5 * quantum:
        if capacity.curves == 1:
            return None
        single = replace(table, backlash=0.0)
        curves = {side: table.curve(side) for side in Direction}
    positive, negative = (np.round(curves[side] / quantum) * quantum + 0.0 for side in Direction)
    if apart <= 0.5 * quantum:
        negative = positive
    return replace(single, positive=positive, negative=negative)
