"""Circles of a job: where they lie, what acts on them, and whether they get worse."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from compwright.foundations.errors import InputError
from compwright.planning import circles as planning_circles
from compwright.planning.circles import (
    CircleWork,
    in_job_names,
    measured_range,
    predicted_circle,
    start_circle,
    travel_findings,
    worse_circle_findings,
)
from compwright.prediction.active_corrections import (
    NO_CORRECTIONS,
    ActiveCorrections,
    correction_in_motion,
    difference,
    no_correction,
    sum_of_corrections,
)
from compwright.prediction.circular import CirclePath
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.circular import CircularResult, CircularRun, CircularTest, FittedRun, Sense
from compwright.records.job import CircleRequest
from compwright.records.prediction import CirclePrediction, Quantiles
from planning_samples import MINUS, PLUS, UM, axis_of, by_slope, circle_of

pytestmark = pytest.mark.short_estimate

AXES = {"X": axis_of(), "Y": axis_of("Y", travel=(-600.0, 0.0))}
REQUEST = CircleRequest(files=("xy.b5r",), name="xy")


def measured() -> CircularTest:
    """A true circle with a little noise."""
    angles = (np.arange(360) + 0.5).astype(np.float64)
    noise = np.random.default_rng(5).normal(0.0, 0.1 * UM, (2, 360))
    runs = (
        CircularRun(sense="ccw", angles=angles, deviations=noise[0]),
        CircularRun(sense="cw", angles=angles[::-1].copy(), deviations=noise[1]),
    )
    return replace(circle_of({}).result.test, name="xy", runs=runs)


def test_sums_and_differences_of_what_acts() -> None:
    where = np.array([0.0, 100.0])
    one, two = by_slope(3e-6), by_slope(1e-6, lost=5.0 * UM)
    np.testing.assert_allclose(difference(one, two)(where, MINUS), [-5.0 * UM, -4.8 * UM])
    np.testing.assert_allclose(sum_of_corrections(one, two)(where, PLUS), [0.0, 0.4 * UM])
    np.testing.assert_array_equal(no_correction(where, PLUS), [0.0, 0.0])
    assert NO_CORRECTIONS.on("X") is no_correction
    assert NO_CORRECTIONS.between("X", "Y") is no_correction


def test_an_axis_that_moves_back_gets_its_correction_of_that_direction() -> None:
    moves = np.array([1.0, -1.0])
    got = correction_in_motion(by_slope(0.0, lost=5.0 * UM), np.zeros(2), moves)
    np.testing.assert_array_equal(got, [0.0, 5.0 * UM])


def test_the_tool_is_moved_by_its_own_axes_and_by_each_other() -> None:
    """At X 200, Y -300 with X on its way to + and Y to -."""
    acting = ActiveCorrections(
        {"X": by_slope(10e-6, lost=1.0 * UM), "Y": by_slope(20e-6, lost=2.0 * UM)},
        {("X", "Y"): by_slope(30e-6), ("Y", "X"): by_slope(0.0, lost=4.0 * UM)},
    )
    path = CirclePath(*(np.array([value]) for value in (200.0, -300.0, 1.0, -1.0)))
    moved = acting.displacement(("X", "Y"))(path)
    np.testing.assert_allclose(moved, [[(2.0 + 4.0) * UM, (-6.0 + 2.0 + 6.0) * UM]])
    turned = CirclePath(*(np.array([value]) for value in (-300.0, 200.0, -1.0, 1.0)))
    np.testing.assert_allclose(acting.displacement(("Y", "X"))(turned), moved[:, ::-1])


def test_a_table_that_lengthens_an_axis_lengthens_the_circle_along_it(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """100 µm/m on X alone over a radius of 100 mm: 10 µm at 0° and 180°, nothing at 90°."""
    monkeypatch.setattr(
        planning_circles, "predict_circle", lambda _result, expected, _rng, _draws: expected
    )
    test = measured()
    planned = replace(circle_of({}).planned, test=test, centre=(500.0, -300.0))
    longer = ActiveCorrections({"X": by_slope(100e-6)}, {})
    for before, after, sign in ((NO_CORRECTIONS, longer, 1.0), (longer, NO_CORRECTIONS, -1.0)):
        found: Any = predicted_circle(circle_of({}).result, planned, before, after)
        moved = found.test.runs[0].deviations - test.runs[0].deviations
        np.testing.assert_allclose(moved[[0, 179]], sign * 10.0 * UM, atol=0.01 * UM)
        np.testing.assert_allclose(moved[[89, 90]], 0.0, atol=0.01 * UM)


def test_the_centre_is_what_the_job_says_then_the_file_then_the_middle() -> None:
    test = measured()
    assert start_circle(replace(REQUEST, centre=(1.0, 2.0)), test, AXES).planned.centre == (
        1.0,
        2.0,
    )
    told = replace(test, centre=(11.0, 12.0, 13.0))
    assert start_circle(REQUEST, told, AXES).planned.centre == (11.0, 12.0)
    turned = replace(told, axes=("Y", "X"), plane="YX")
    assert start_circle(REQUEST, turned, AXES).planned.centre == (12.0, 11.0)
    assumed = start_circle(REQUEST, test, AXES)
    assert assumed.planned.centre == (500.0, -300.0)
    assert [finding.code for finding in assumed.findings] == ["CW-P101"]
    assert start_circle(replace(REQUEST, centre=(1.0, 2.0)), test, AXES).findings == ()
    with pytest.raises(InputError, match="expected two numbers"):
        start_circle(replace(REQUEST, centre=(1.0, 2.0, 3.0)), replace(test, axes=("U", "V")), AXES)


def test_axes_are_called_as_in_the_job() -> None:
    test = replace(measured(), axes=("x", "W"))
    assert in_job_names(test, AXES).axes == ("X", "W")


@pytest.mark.parametrize(
    ("centre", "axis", "codes"),
    [
        ((100.0, -100.0), AXES["X"], []),
        ((99.0, -100.0), AXES["X"], ["CW-P102"]),
        ((900.0, -100.0), AXES["X"], []),
        ((901.0, -100.0), AXES["X"], ["CW-P102"]),
        ((500.0, -99.0), AXES["X"], ["CW-P102"]),
        ((500.0, -501.0), AXES["X"], ["CW-P102"]),
        ((500.0, -300.0), axis_of(kind=AxisKind.ROTARY), ["CW-P102"]),
    ],
)
def test_a_whole_circle_has_to_lie_within_the_travels(
    centre: tuple[float, float], axis: object, codes: list[str]
) -> None:
    axes = {"X": axis, "Y": AXES["Y"]}
    found = travel_findings(at(centre), axes)  # type: ignore[arg-type]
    assert [finding.code for finding in found] == codes


def at(centre: tuple[float, float], part: float = 1.0) -> CircleWork:
    """The circle of `measured` at a ``centre``; ``part``: of it, from 0° on."""
    work, test = circle_of({}, centre=centre), measured()
    runs = tuple(replace(one, angles=one.angles * part) for one in test.runs)
    test = replace(test, runs=runs, arc=(0.0, 360.0 * part))
    planned = replace(work.planned, test=test)
    return replace(work, result=replace(work.result, test=test), planned=planned)


def test_the_arc_alone_has_to_lie_within_the_travel() -> None:
    """An arc is measured where a full circle has no room: 0° to 180° stays above its centre."""
    assert travel_findings(at((500.0, -600.0), 0.5), AXES) == ()
    (found,) = travel_findings(at((500.0, -600.5), 0.5), AXES)
    assert (found.code, found.axes) == ("CW-P102", ("X", "Y"))


def test_the_ends_of_the_measured_part_are_rounded_outwards() -> None:
    """The samples of a circle that begin between two steps of angle miss its ends by a little."""
    work = at((50.0, -300.0))
    runs = tuple(replace(one, angles=one.angles + 0.11) for one in work.result.test.runs)
    work = replace(work, result=replace(work.result, test=replace(work.result.test, runs=runs)))
    (found,) = travel_findings(work, AXES)
    assert "from -50 to 150 on axis X" in found.message


def test_a_rotary_axis_has_no_travel_that_a_circle_leaves() -> None:
    (found,) = travel_findings(at((500.0, -300.0)), {"X": axis_of(kind=AxisKind.ROTARY)})
    assert "beyond the travel" not in found.message
    assert "axis X is a rotary axis" in found.message


def prediction(was: dict[str, float], becomes: dict[str, tuple[float, float]]) -> CirclePrediction:
    """``becomes``: 5 % quantile and median, mm."""
    before: CircularResult = replace(circle_of({}).result, parameters=was)
    predicted = {name: Quantiles(mid, low, 2.0 * mid) for name, (low, mid) in becomes.items()}
    return CirclePrediction(before=before, expected=before, predicted=predicted, causes={})


@pytest.mark.parametrize(
    ("low", "median", "worse"),
    [
        (10.1, 12.0, True),
        (10.1, 11.1, True),
        (10.1, 10.9, False),  # not by more than a tenth
        (9.9, 12.0, False),  # no more than the noise of a test
    ],
)
def test_a_circle_gets_worse_beyond_noise_and_a_tenth(
    low: float, median: float, *, worse: bool
) -> None:
    found = worse_circle_findings(
        {
            "xy": prediction(
                {"G_bidirectional": 10.0 * UM}, {"G_bidirectional": (low * UM, median * UM)}
            )
        }
    )
    assert [finding.code for finding in found] == (["CW-P131"] if worse else [])
    if worse:
        assert f"grow from 10.0 to {median:.1f} µm ({low:.1f} to" in found[0].message


@pytest.mark.parametrize(("median", "worse"), [(10.4, False), (10.6, True)])
def test_noise_does_not_hide_that_a_circle_gets_worse(median: float, *, worse: bool) -> None:
    """An ellipse of 5 µm, measured as 10 with its noise: a tenth of it is 0.5 µm."""
    found = prediction(
        {"G_bidirectional": 10.0 * UM}, {"G_bidirectional": (10.1 * UM, median * UM)}
    )
    assert found.before.diagnosis is not None
    angles = np.arange(0.0, 360.0)
    ellipse = 2.5 * UM * np.cos(2.0 * np.radians(angles))
    runs: dict[Sense, FloatArray] = {"ccw": angles, "cw": angles[::-1]}
    fitted = tuple(
        FittedRun(sense=sense, number=1, angles=turned, deviations=ellipse, residuals=np.zeros(360))
        for sense, turned in runs.items()
    )
    before = replace(found.before, diagnosis=replace(found.before.diagnosis, fitted=fitted))
    assert bool(worse_circle_findings({"xy": replace(found, before=before)})) is worse


def test_both_runs_together_count_where_there_are_both() -> None:
    """One run alone may look worse when lag and squareness no longer cancel in it."""
    was = {"G_bidirectional": 10.0 * UM, "G_ccw": 2.0 * UM}
    becomes = {"G_bidirectional": (4.0 * UM, 5.0 * UM), "G_ccw": (4.0 * UM, 5.0 * UM)}
    assert worse_circle_findings({"xy": prediction(was, becomes)}) == ()
    alone = prediction({"G_ccw": 2.0 * UM}, {"G_ccw": (4.0 * UM, 5.0 * UM)})
    assert len(worse_circle_findings({"xy": alone})) == 1


@pytest.mark.parametrize(
    ("arc", "x", "y"),
    [
        ((0.0, 360.0), (400.0, 600.0), (-400.0, -200.0)),
        ((350.0, 200.0), (400.0, 600.0), (-317.36, -200.0)),
        ((60.0, 90.0), (413.40, 550.0), (-250.0, -200.0)),
    ],
)
def test_the_range_of_an_arc(
    arc: tuple[float, float], x: tuple[float, float], y: tuple[float, float]
) -> None:
    work = circle_of({}, centre=(500.0, -300.0))
    planned = replace(work.planned, test=replace(work.planned.test, arc=arc))
    for index, range_ in enumerate((x, y)):
        assert measured_range(planned, index) == pytest.approx(range_, abs=0.01)
