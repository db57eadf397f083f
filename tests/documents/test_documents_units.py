"""Every number that leaves in a document, once for a linear and once for a rotary axis: mm become µm
(times 1000), deg become arcsec (times 3600), positions stay.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from circle_machine import Machine, Setup, measured
from compwright.documents.circular import circular_document
from compwright.documents.compare import ComparedAxis, Others, compare_document
from compwright.documents.decode import DecodedAxis, decode_document
from compwright.documents.plan_rules import RULES
from compwright.documents.prediction import (
    circle_values,
    compensation_outside,
    cross_outside,
    parameters_outside,
    prediction_document,
    quantiles_outside,
)
from compwright.evaluation.circular import evaluate_circle
from compwright.evaluation.standards import evaluate
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import AxisCompensation, CrossCompensation
from compwright.records.estimate import AxisPeriod, PeriodEvidence
from compwright.records.limits import LimitingCause, LimitingCauses, PointCountOption
from compwright.records.prediction import AxisPrediction, Quantiles, TestPrediction
from compwright.records.verification import ReadBack
from evaluation_samples import axis_test

KINDS = pytest.mark.parametrize(
    ("kind", "factor", "unit"),
    [(AxisKind.LINEAR, 1000.0, "um"), (AxisKind.ROTARY, 3600.0, "arcsec")],
)


def table(kind: AxisKind) -> AxisCompensation:
    """Two curves and a backlash of 0.004, which acts with its sign against the return direction."""
    return AxisCompensation(
        address="1",
        kind=kind,
        positions=np.array([-10.0, 0.0, 250.0]),
        positive=np.array([0.001, 0.0, -0.0025]),
        negative=np.array([0.002, 0.0, 0.0005]),
        backlash=0.004,
        reference_return=Direction.POSITIVE,
    )


@KINDS
def test_a_table(kind: AxisKind, factor: float, unit: str) -> None:
    found = compensation_outside(table(kind))
    assert found["positions"] == [-10.0, 0.0, 250.0]
    assert found["unit"] == unit
    assert found["correction_positive"] == pytest.approx([0.001 * factor, 0.0, -0.0025 * factor])
    # arriving in -: the second curve less the backlash
    assert found["correction_negative"] == pytest.approx(
        [-0.002 * factor, -0.004 * factor, -0.0035 * factor]
    )


@KINDS
def test_what_is_decoded_and_compared(kind: AxisKind, factor: float, unit: str) -> None:
    axis = DecodedAxis(kind, np.array([5.0, 1.0]), np.array([0.001, 0.002]), np.array([0.0, -0.25]))
    (found,) = decode_document({"X": axis}, (), ())["axes"].values()
    assert found == {
        "positions": [5.0, 1.0],
        "correction_positive": pytest.approx([0.001 * factor, 0.002 * factor]),
        "correction_negative": pytest.approx([0.0, -0.25 * factor]),
        "unit": unit,
    }
    back = ReadBack(0.0125, 320.5, Direction.NEGATIVE, "scaled", "twice")
    document = compare_document(
        "id", {"X": ComparedAxis("AX1", kind, back, ())}, Others(), (), (), ()
    )
    assert document["axes"]["X"]["largest_difference"] == pytest.approx(0.0125 * factor)
    assert (document["axes"]["X"]["at"], document["axes"]["X"]["unit"]) == (320.5, unit)


@pytest.mark.parametrize(
    ("output", "factor", "unit"),
    [(AxisKind.LINEAR, 1000.0, "um"), (AxisKind.ROTARY, 3600.0, "arcsec")],
)
def test_what_one_axis_adds_to_another_is_in_the_unit_of_the_other(
    output: AxisKind, factor: float, unit: str
) -> None:
    one = CrossCompensation(
        input="X",
        output="Y",
        input_kind=AxisKind.LINEAR,
        output_kind=output,
        positions=np.array([0.0, 400.0]),
        positive=np.array([0.0, -0.012]),
        negative=np.array([0.0, -0.012]),
    )
    found = cross_outside(one)
    assert found["correction"] == pytest.approx([0.0, -0.012 * factor])
    assert (found["positions"], found["unit"]) == ([0.0, 400.0], unit)
    assert "correction_positive" not in found
    other = cross_outside(replace(one, negative=np.array([0.0, 0.003])))
    assert other["correction"] == other["correction_positive"]
    assert other["correction_negative"] == pytest.approx([0.0, 0.003 * factor])


@KINDS
def test_a_prediction(kind: AxisKind, factor: float, unit: str) -> None:
    """One direction, means from -0.01 to 0.03: E = 0.04."""
    test = axis_test([0, 90, 180], [[-0.01] * 2, [0.0] * 2, [0.03] * 2], kind=kind)
    before = evaluate(test)
    assert parameters_outside(before)["E_positive"] == pytest.approx(0.04 * factor)
    bands = {"A": Quantiles(median=0.02, p05=0.01, p95=0.05)}
    assert quantiles_outside(bands, kind)["A"] == pytest.approx(
        {"median": 0.02 * factor, "p05": 0.01 * factor, "p95": 0.05 * factor}
    )
    axis = AxisPrediction(
        tests=(
            TestPrediction(name="t", before=before, predicted=bands, predicted_new_targets=bands),
        ),
        table=table(kind),
        quantum=0.0005,
        limits=LimitingCauses(
            parameter="A",
            now=0.05,
            then=0.02,
            least=0.01,
            spread=0.001,
            causes=(
                LimitingCause(cause="noise", value=0.01),
                LimitingCause(cause="value range", value=0.002, rms=0.0005),
            ),
        ),
        periods=(AxisPeriod(10.0, 0.97, "found"), AxisPeriod(20.0, 1.0, "job")),
        evidence=PeriodEvidence(
            np.array([5.0, 10.0]), np.array([0.5, 12.0]), np.array([np.inf, 0.001]), ((12.5, 50.0),)
        ),
        worth=(
            PointCountOption(
                points=21, spacing=50.0, median=0.02, p05=0.01, p95=0.05, written=True
            ),
        ),
    )
    found = prediction_document("id", {"X": axis}, judged="independent")["axes"]["X"]
    assert found["quantum"] == pytest.approx(0.0005 * factor)
    assert found["limits"] == [
        {"cause": "noise", "value": pytest.approx(0.01 * factor), "unit": unit},
        {
            "cause": "value range",
            "value": pytest.approx(0.002 * factor),
            "unit": unit,
            "rms": pytest.approx(0.0005 * factor),
        },
    ]
    assert found["points_worth"] == [
        {
            "points": 21,
            "spacing": 50.0,
            "median": pytest.approx(0.02 * factor),
            "p05": pytest.approx(0.01 * factor),
            "p95": pytest.approx(0.05 * factor),
            "written": True,
            "there": False,
        }
    ]
    # Positions stay as they are: only deviations change their unit.
    assert found["periods"] == [
        {"period": 10.0, "probability": 0.97, "source": "found"},
        {"period": 20.0, "probability": 1.0, "source": "job"},
    ]
    assert found["period_search"] == {
        "periods": [5.0, 10.0],
        "log_odds": [0.5, 12.0],
        "detectable": [None, pytest.approx(0.001 * factor)],
        "alike": [[12.5, 50.0]],
    }
    assert found["limited"] == {
        "parameter": "A",
        "now": pytest.approx(0.05 * factor),
        "then": pytest.approx(0.02 * factor),
        "least": pytest.approx(0.01 * factor),
    }
    assert found["before"]["E_positive"] == pytest.approx(0.04 * factor)
    assert found["predicted"]["A"]["p95"] == pytest.approx(0.05 * factor)


def test_a_circle_is_in_micrometres() -> None:
    """A bar that reads 25 µm too long everywhere: D = 25 µm, and the circle stays round."""
    test = measured(Machine(), Setup(samples=90))
    longer = replace(
        test, runs=tuple(replace(run, deviations=run.deviations + 0.025) for run in test.runs)
    )
    found = circle_values(evaluate_circle(longer))
    assert found["D"] == pytest.approx(25.0, abs=1e-6)
    assert found["G_ccw"] == pytest.approx(0.0, abs=1e-6)


def test_no_document_of_a_circle_holds_a_minus_zero() -> None:
    """-1e-15 mm is rounded away; the sign of nothing must not stay."""
    test = measured(Machine(), Setup(samples=90))
    runs = tuple(replace(run, deviations=np.full(90, -1e-15)) for run in test.runs)
    found = circular_document(evaluate_circle(replace(test, runs=runs)))
    values = [value for run in found["runs"] for value in run["deviations"]]
    assert values == [0.0] * 180
    assert not np.any(np.signbit(values))


CIRCLE = measured(Machine(), Setup(samples=30))


@pytest.mark.parametrize(
    ("record", "broken"),
    [
        (table(AxisKind.LINEAR), 0),
        (replace(table(AxisKind.LINEAR), period=260.0), 0),
        (replace(table(AxisKind.LINEAR), period=0.0), 1),
        (replace(table(AxisKind.LINEAR), period=-260.0), 1),
        (replace(table(AxisKind.LINEAR), positions=np.array([0.0, -10.0, 250.0])), 1),
        (CIRCLE, 0),
        (replace(CIRCLE, feed=0.0), 1),
        (replace(CIRCLE, nominal_radius=-150.0), 1),
        (replace(CIRCLE, arc=(0.0, 361.0)), 1),
        (replace(CIRCLE, arc=(0.0, 0.0), runs=()), 2),
    ],
)
def test_what_a_plan_may_not_hold(record: Any, broken: int) -> None:
    assert len(list(RULES[type(record)](record))) == broken
