"""The JSON of a circular result: exactly the contract's keys, µm outside, never NaN."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from circular_samples import UM, circular_test, measured, perfect, radial, run_of
from compwright.documents.circular import circular_document
from compwright.documents.json_text import to_json
from compwright.evaluation.circular import evaluate_circle
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import source_of
from compwright.records.circular import CIRCULAR_NAMES, CircularEffect, CircularResult, Diagnosis
from compwright.words.sentences import say
from places import SHARED, needs_shared

KEYS = {
    "kind", "name", "sources", "plane", "axes", "nominal_radius", "feed", "standard", "unit", "arc", "calibrated", "parameters",
    "centre", "mean_radius_deviation", "diagnosis", "plain", "correlation", "vendor", "not_applicable", "findings",
}  # fmt: skip


def document(result: CircularResult) -> dict[str, Any]:
    read: dict[str, Any] = json.loads(to_json(circular_document(result)))
    return read


@needs_shared
def test_the_keys_are_the_contracts() -> None:
    text = (SHARED / "contract.md").read_text("utf-8")
    block = text[text.index('{"kind": "circular"') :]
    block = block[: block.index("\n\n")]
    assert (
        set(re.findall(r'"(\w+)":', block))
        - {"squareness", "start", "extent", "ccw", "cw", "common"}
        == KEYS
    )
    got = document(evaluate_circle(measured(perfect)))
    more = {"set_up", "minimum_zone", "runs", "fitted", "header", "uncertainty"}
    assert set(got) == KEYS | more
    assert tuple(got["parameters"]) == CIRCULAR_NAMES


def test_units_outside() -> None:
    """ccw 3 µm too large, cw 1 µm too small, both 40 µm beside in the second axis."""
    machine = radial(lambda angle, sense: np.full(angle.shape, (3 if sense == "ccw" else -1) * UM))
    test = replace(
        measured(machine, n=400, offset=(0.0, 0.04)),
        sources=(source_of("c.b5r", b"abc"),),
        centre=(-400.0, -250.0, -300.0),
        header={"machine": "VMC"},
    )
    got = document(evaluate_circle(test))
    assert (got["kind"], got["name"], got["plane"], got["axes"], got["unit"]) == (
        "circular",
        "circle",
        "XY",
        ["X", "Y"],
        "um",
    )
    assert (got["nominal_radius"], got["feed"], got["calibrated"]) == (100.0, 1000.0, True)
    assert got["arc"] == {"start": 0.0, "extent": 360.0}
    assert got["set_up"] == [-400.0, -250.0, -300.0]
    assert got["standard"] == "iso230-4:2005"
    # SHA-256 of "abc": FIPS 180-2, appendix B.1
    assert got["sources"] == [
        {
            "file": "c.b5r",
            "sha256": "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
        }
    ]
    assert got["parameters"]["G_bidirectional"] == pytest.approx(4.0, abs=1e-6)
    assert got["parameters"]["F_min_cw"] == pytest.approx(-1.0, abs=1e-6)
    assert got["parameters"]["D"] == pytest.approx(1.0, abs=1e-6)
    assert got["parameters"]["H"] is None
    assert got["mean_radius_deviation"] == pytest.approx({"ccw": 3.0, "cw": -1.0}, abs=1e-6)
    assert set(got["centre"]) == {"ccw", "cw", "common"}
    assert got["centre"]["common"] == pytest.approx([0.0, 40.0], abs=1e-6)
    zone = got["minimum_zone"]["both"]
    assert (zone["inner"], zone["outer"]) == pytest.approx((-1.0, 3.0), abs=1e-6)
    assert zone["centre"] == pytest.approx([0.0, 40.0], abs=1e-6)
    first = got["runs"][0]
    assert (
        first["direction"],
        first["number"],
        len(first["angles"]),
        len(first["deviations"]),
    ) == ("ccw", 1, 400, 400)
    assert first["angles"][0] == 0.45
    # distance of (100.003 cos t, 100.003 sin t + 0.04) from 0, t = 0.45°, less 100: 3 µm + 40 µm
    # sin t + 40²/2R cos² t
    assert first["deviations"][0] == pytest.approx(
        3.0 + 40.0 * np.sin(np.radians(0.45)) + 0.008, abs=1e-5
    )
    assert got["header"] == {"machine": "VMC"}


def test_one_direction_leaves_nulls() -> None:
    got = document(evaluate_circle(circular_test([run_of(perfect, "cw")])))
    assert got["centre"]["ccw"] is None
    assert got["centre"]["common"] is None
    assert got["mean_radius_deviation"]["ccw"] is None
    assert {name for name, number in got["parameters"].items() if number is None} == set(
        got["not_applicable"]
    )
    assert [entry["code"] for entry in got["findings"]] == ["CW-C002"]
    assert set(got["findings"][0]) == {"code", "severity", "message", "values"}
    assert got["findings"][0]["values"] == {"direction": "cw"}


def test_without_a_diagnosis() -> None:
    got = document(evaluate_circle(measured(perfect)))
    assert (got["diagnosis"], got["plain"], got["correlation"]) == (None, None, None)


def test_with_a_diagnosis() -> None:
    """Its values are in their own units and stay as they are; only the rms of the residuals is
    turned from mm into µm.
    """
    finding = Finding(
        "CW-D001",
        "warning",
        say("as_written", text="squareness and servo mismatch cannot be told apart"),
    )
    diagnosis = Diagnosis(
        effects={
            "squareness": CircularEffect(
                value=31.5, std_error=0.4, unit="um/m", effect=3.15, share=0.6
            ),
            "cyclic_first": CircularEffect(
                value=0.7, std_error=float("nan"), unit="um", effect=1.4, share=0.4, low=0.1
            ),
        },
        plain={"squareness": 30.9},
        names=("squareness", "cyclic_first"),
        correlation=np.array([[1.0, -0.25], [-0.25, 1.0]]),
        residual=0.0006,
        correlation_length=4.5,
        findings=(finding,),
    )
    result = replace(evaluate_circle(measured(perfect)), diagnosis=diagnosis)
    got = document(result)
    assert got["diagnosis"] == {
        "squareness": {
            "value": 31.5,
            "std_error": 0.4,
            "unit": "um/m",
            "effect": 3.15,
            "share": 0.6,
            "correction": "correct",
        },
        "cyclic_first": {
            "value": 0.7,
            "std_error": None,
            "unit": "um",
            "effect": 1.4,
            "share": 0.4,
            "low": 0.1,
        },
    }
    assert got["plain"] == {"squareness": 30.9}
    assert got["correlation"] == [[1.0, -0.25], [-0.25, 1.0]]
    assert got["correlation_names"] == ["squareness", "cyclic_first"]
    assert (got["residual"], got["correlation_length"]) == (0.6, 4.5)
    values = {"text": finding.message}
    told = {
        "code": "CW-D001",
        "severity": "warning",
        "message": finding.message,
        "values": values,
    }
    assert got["findings"] == [told]
    # whoever adds the diagnosis may have put its findings among those of the result already: told
    # once
    assert document(replace(result, findings=(finding,)))["findings"] == [told]


def test_what_the_instrument_printed_stays_as_it_is() -> None:
    vendor = {
        "ccw": {
            "AF_CIRCULARITY": (3.5, "um"),
            "STATUS": "AF_TOLERANCE_OK",
            "count": 2,
            "none": None,
            "odd": float("inf"),
        }
    }
    got = document(evaluate_circle(replace(measured(perfect), vendor=vendor, feed=float("nan"))))
    assert got["vendor"] == {
        "ccw": {
            "AF_CIRCULARITY": [3.5, "um"],
            "STATUS": "AF_TOLERANCE_OK",
            "count": 2,
            "none": None,
            "odd": None,
        }
    }
    assert got["feed"] is None
