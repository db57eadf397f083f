"""The JSON of ``evaluate``: exactly the contract's keys, units outside, never NaN."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from compwright.documents.evaluation import evaluation_document, result_document
from compwright.documents.json_text import to_json
from compwright.documents.recorded_test import measured_test
from compwright.evaluation.standards import STANDARDS, evaluate
from compwright.foundations.errors import Fault
from compwright.foundations.provenance import source_of
from compwright.records.axis import AxisKind
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.workflow.results.scatter import errors_of
from evaluation_samples import UM, axis_test, printed_table
from places import SHARED, STANDARD_TABLES, needs_shared

# typed from the contract
RESULT_KEYS = {
    "kind", "sources", "axis", "axis_kind", "standard", "cycle", "position_unit", "unit", "n_targets", "n_runs", "parameters",
    "at", "uncertainty", "targets", "not_applicable", "findings",
}  # fmt: skip
TARGET_KEYS = {
    "position", "n_positive", "n_negative", "mean_positive", "mean_negative", "s_positive", "s_negative", "reversal", "mean",
    "R_positive", "R_negative", "R",
}  # fmt: skip
PARAMETERS = [
    "A",
    "A_positive",
    "A_negative",
    "E",
    "E_positive",
    "E_negative",
    "M",
    "R",
    "R_positive",
    "R_negative",
    "B",
    "B_mean",
]


def sample_document(standard: str = "iso230-2:2014") -> dict[str, object]:
    test = axis_test(
        [0.0, 100.5], [[1 * UM, 3 * UM, np.nan], [0.0, 0.0, 0.0]], [[5 * UM, 7 * UM], [0.0, 2 * UM]]
    )
    test = replace(test, sources=(source_of("x.csv", b"abc"),), header={"machine": "VMC"})
    return evaluation_document(
        [evaluate(test, standard)],
        [Fault(message="cannot be read", file="y.csv", place="line 3", expected="a number")],
    )


def test_a_record_keeps_the_slope_that_all_tests_of_an_instrument_share() -> None:
    """ISO 230-2:2006, annex A: instrument 0.3 µm + 1.2 µm/m over 0.5 m, coefficient 1 µm/(m K) at
    23 °C; the temperature is another in each test.
    """
    test = axis_test([0.0, 500.0], [[1 * UM, 3 * UM], [0.0, 0.0]], [[5 * UM, 7 * UM], [0.0, UM]])
    budget = UncertaintyBudget(device=0.3, device_per_m=1.2, U_theta=2.0, U_alpha=1.0, setup=4.0)
    warm = Thermal(alpha_m=11.5, T_m=23.0, alpha_d=0.0, T_d=23.0)
    result = result_document(evaluate(test, budget=budget, thermal=warm))
    stated = measured_test(result, "before", {"X x": "as_found"}, errors_of)["uncertainty"]
    assert stated["slope"] == {"U": pytest.approx(np.hypot(1.8, 3.0)), "coverage": 2.0}
    without = result_document(evaluate(test))
    assert measured_test(without, "before", {"X x": "as_found"}, errors_of)["uncertainty"] == {}


def test_the_keys_are_the_contracts() -> None:
    document = json.loads(to_json(sample_document()))
    assert set(document) == {"schema", "results", "errors"}
    assert document["schema"] == "compwright/evaluation/1"
    result = document["results"][0]
    assert set(result) >= RESULT_KEYS
    assert list(result["parameters"]) == PARAMETERS
    assert set(result["targets"][0]) == TARGET_KEYS | {"deviations_positive", "deviations_negative"}
    assert document["errors"] == [
        {"file": "y.csv", "message": "line 3 cannot be read; expected a number"}
    ]
    # SHA-256 of "abc": FIPS 180-2, appendix B.1
    digest = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
    assert result["sources"] == [{"file": "x.csv", "sha256": digest}]


def test_units_outside_and_nothing_invented() -> None:
    result = json.loads(to_json(sample_document()))["results"][0]
    assert (result["unit"], result["position_unit"], result["axis_kind"]) == ("um", "mm", "linear")
    assert (result["n_targets"], result["n_runs"]) == (2, {"positive": 3, "negative": 2})
    first = result["targets"][0]
    assert first["position"] == 0.0
    assert (first["n_positive"], first["n_negative"]) == (2, 2)
    assert first["deviations_positive"] == [1.0, 3.0, None]
    assert (first["mean_positive"], first["mean_negative"], first["reversal"], first["mean"]) == (
        2.0,
        6.0,
        -4.0,
        4.0,
    )
    assert first["s_positive"] == pytest.approx(2**0.5, abs=1e-9)
    assert result["parameters"]["B"] == 4.0
    assert result["at"]["B"] == 0.0
    assert result["uncertainty"] is None


def test_rotary_in_arcsec() -> None:
    second = 1.0 / 3600.0
    test = axis_test(
        [0.0, 90.0],
        [[1 * second], [3 * second]],
        [[4 * second], [6 * second]],
        kind=AxisKind.ROTARY,
    )
    result = evaluation_document([evaluate(test, budget=UncertaintyBudget(device=0.5))])["results"][
        0
    ]
    assert (result["unit"], result["position_unit"], result["axis_kind"]) == (
        "arcsec",
        "deg",
        "rotary",
    )
    assert result["parameters"]["E"] == 5.0
    assert result["parameters"]["B_mean"] == -3.0
    assert result["uncertainty"]["E"] == {"U": 0.5, "coverage": 2.0}
    assert result["targets"][1]["position"] == 90.0


@pytest.mark.parametrize("standard", STANDARDS)
def test_a_null_has_its_reason_and_a_reason_its_null(standard: str) -> None:
    for test in (
        axis_test([0.0, 1.0], [[0.0], [1 * UM]]),
        axis_test([0.0, 1.0], [[0.0, 1 * UM], [1 * UM, np.nan]], [[0.0, 0.0], [0.0, 0.0]]),
    ):
        result = json.loads(to_json(evaluation_document([evaluate(test, standard)])))["results"][0]
        assert {name for name, value in result["parameters"].items() if value is None} == set(
            result["not_applicable"]
        )
        assert all(result["not_applicable"].values())


def test_nan_never_becomes_json() -> None:
    with pytest.raises(ValueError, match="JSON compliant"):
        to_json({"value": float("nan")})


def test_json_text_is_stable_utf8() -> None:
    text = to_json({"b": "µm", "a": [1.5, None]})
    assert text == '{\n  "b": "µm",\n  "a": [\n    1.5,\n    null\n  ]\n}\n'


@needs_shared
def test_the_contracts_example() -> None:
    """The contract shows the test of ISO 230-2:1997, table 2, with its places of R and B."""
    assert '"at": {"R": 1408.462, "B": 175.077}' in (SHARED / "contract.md").read_text("utf-8")
    result = evaluation_document(
        [evaluate(printed_table(STANDARD_TABLES / "iso-230-2-1997-table-2.csv"))]
    )["results"][0]
    assert (result["at"]["R"], result["at"]["B"]) == (1408.462, 175.077)
    assert (result["n_targets"], result["n_runs"], result["cycle"]) == (
        11,
        {"positive": 5, "negative": 5},
        "standard",
    )
