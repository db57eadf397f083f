"""Axes, circles and tests whose answers are known by hand, for the decisions of ``planning``."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from compwright.estimation.axis import Draws
from compwright.estimation.hidden_periods import HiddenPeriods
from compwright.evaluation.standards import evaluate
from compwright.planning.axis_work import AxisWork
from compwright.planning.circles import CircleWork
from compwright.planning.wanted_correction import MeasuredError
from compwright.prediction.active_corrections import Correction, no_correction
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.capacity import Capacity
from compwright.records.circular import (
    CircularEffect,
    CircularResult,
    CircularTest,
    Diagnosis,
)
from compwright.records.correction import AxisCompensation
from compwright.records.estimate import ErrorEstimate
from compwright.records.fitted_table import TableRequest
from compwright.records.job import Acceptance, AxisJob, Job, TestRequest
from compwright.records.noise import normal_noise
from compwright.records.plan import PlannedAxis, PlannedCircle, PlannedTest
from compwright.records.positioning import PositioningTest

Floats = NDArray[np.float64]
Curve = Callable[[Floats], Floats]
UM = 1e-3  # mm
PPM = 1e-6
PLUS, MINUS = Direction.POSITIVE, Direction.NEGATIVE
TARGETS = np.linspace(0.0, 1000.0, 11)


def axis_of(name: str = "X", **words: Any) -> Axis:
    """A linear axis of a metre with its reference at 0, approached in +."""
    given = {"kind": AxisKind.LINEAR, "travel": (0.0, 1000.0), "address": name, **words}
    return Axis(name=name, **given)


def job_of(*axes: Axis, **words: Any) -> Job:
    """A job in which every axis has a test, unless ``untested`` names it."""
    untested = words.pop("untested", ())
    entries = {
        axis.name: AxisJob(
            axis=axis,
            before=() if axis.name in untested else (TestRequest(files=("x.csv",), name="x"),),
            accept=words.get("accept"),
        )
        for axis in axes
    }
    words.pop("accept", None)
    return Job(file="job.yaml", format="any", axes=entries, **words)


def by_slope(slope: float, lost: float = 0.0) -> Correction:
    """A correction of ``slope`` mm/mm, and ``lost`` mm more where the axis arrives in -."""
    return lambda x, way: slope * np.asarray(x) + (lost if way is MINUS else 0.0)


class KnownAxis:
    """In place of an estimate: deviations that are known, each draw shifted by its share of
    ``std``.
    """

    def __init__(
        self, plus: Curve, minus: Curve, *, std: float = 0.0, noise: float = 0.0, odds: float = 0.0
    ) -> None:
        self.plus, self.minus, self.std, self.noise = plus, minus, std, noise
        self.noise_dof, self.reversal_log_odds, self.findings = 10.0, odds, ()
        self.hidden = HiddenPeriods(())

    def summary(self, positions: Floats) -> ErrorEstimate:
        return estimate_of(positions, self.plus, self.minus, std=self.std, noise=self.noise)

    def draw(
        self, positions: Floats, count: int, _rng: np.random.Generator, _test: int = 0
    ) -> Draws:
        rows = np.zeros((count, 1))
        return Draws(
            self.plus(positions) + rows,
            self.minus(positions) + rows,
            normal_noise(np.full(count, self.noise)),
        )


def estimate_of(
    positions: Floats, plus: Curve, minus: Curve, *, std: float = 0.0, noise: float = 0.0
) -> ErrorEstimate:
    where = np.asarray(positions, dtype=float)
    spread = np.full(where.shape, std)
    return ErrorEstimate(
        kind=AxisKind.LINEAR,
        positions=where,
        mean_positive=plus(where),
        mean_negative=minus(where),
        std_positive=spread,
        std_negative=spread,
        noise=noise,
        noise_dof=10.0,
        measured=(float(where[0]), float(where[-1])),
    )


def readings_of(
    plus: Floats, minus: Floats | None, targets: Floats = TARGETS, **words: Any
) -> PositioningTest:
    """Readings of one axis, mm: a column per run; no direction - where ``minus`` is None."""
    given = {"name": "x", "axis": "X", "kind": AxisKind.LINEAR, "frame": "machine", **words}
    blank = np.empty((targets.size, 0))
    return PositioningTest(
        targets=targets,
        positive=plus,
        negative=blank if minus is None else minus,
        runs_positive=tuple(range(1, plus.shape[1] + 1)),
        runs_negative=() if minus is None else tuple(range(1, minus.shape[1] + 1)),
        **given,
    )


def work_of(
    known: KnownAxis,
    axis: Axis | None = None,
    *,
    active: AxisCompensation | None = None,
    as_found: Correction = no_correction,
    one_way: bool = False,
    accept: Acceptance | None = None,
) -> AxisWork:
    """An axis whose readings are the known error itself, twice."""
    axis = axis or axis_of()
    repeats = np.ones((1, 2))
    plus, minus = known.plus(TARGETS)[:, None] * repeats, known.minus(TARGETS)[:, None] * repeats
    test = readings_of(plus, None if one_way else minus, axis=axis.name)
    planned = PlannedAxis(
        axis=axis,
        tests=(PlannedTest(test=test, measured_in="as_found"),),
        estimate=known.summary(np.linspace(*axis.travel, 101)),
        active=active,
        wanted=None,
        request=TableRequest(),
        fitted=None,
        accept=accept,
    )
    return AxisWork(
        entry=AxisJob(axis=axis, before=(TestRequest(files=("x.csv",), name="x"),), accept=accept),
        results=(evaluate(test, "iso230-2:2014"),),
        posterior=cast("MeasuredError", known),
        planned=planned,
        as_found=as_found,
    )


def circle_of(
    effects: Mapping[str, tuple[float, float]],
    axes: tuple[str, str] = ("X", "Y"),
    *,
    radius: float = 100.0,
    feed: float = 1000.0,
    centre: tuple[float, float] = (500.0, 500.0),
    measured_in: str = "as_found",
    name: str = "circle",
    calibrated: bool = True,
    scales_correlate: float = 0.0,
) -> CircleWork:
    """A circle with its causes given: (value, standard error) by name, in the contract's units, and
    the correlation of both scale errors.
    """
    correlation = np.eye(len(effects))
    if scales_correlate and "scale_error_first" in effects:
        rows = [list(effects).index(f"scale_error_{side}") for side in ("first", "second")]
        correlation[rows, rows[::-1]] = scales_correlate
    test = CircularTest(
        name=name,
        plane="".join(axes),
        axes=axes,
        nominal_radius=radius,
        feed=feed,
        arc=(0.0, 360.0),
        calibrated=calibrated,
        runs=(),
    )
    diagnosis = Diagnosis(
        effects={
            cause: CircularEffect(value=value, std_error=error, unit="um", effect=1.0, share=0.1)
            for cause, (value, error) in effects.items()
        },
        plain={},
        names=tuple(effects),
        correlation=correlation,
        residual=0.0,
        correlation_length=1.0,
    )
    result = CircularResult(
        test=test,
        standard="iso230-4:2005",
        parameters={},
        centres={},
        mean_radius_deviation={},
        zone_centres={},
        zone_radii={},
        diagnosis=diagnosis,
    )
    return CircleWork(result, PlannedCircle(test=test, measured_in=measured_in, centre=centre))


def capacity_of(axis: Axis, *, one_curve: bool = False) -> Capacity:
    """A control that holds two curves on a free grid in tenths of a micrometre."""
    del axis, one_curve
    return Capacity(
        format="any",
        curves=2,
        spacing="free",
        quantum=1e-4,
        position_quantum=1e-3,
        value_range=(-1.0, 1.0),
        max_points=50,
    )
