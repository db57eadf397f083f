"""The data of the next job: what is kept as it was written, and what is not."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from compwright.foundations.yaml_reader import read_yaml
from compwright.jobs.next_job import (
    NextAxis,
    NextRound,
    earlier_test,
    name_of_round,
    next_job,
    test_after,
    test_sections,
)
from compwright.jobs.writing import data_text

test_after.__test__ = False  # type: ignore[attr-defined]  # a function of the package
test_sections.__test__ = False  # type: ignore[attr-defined]  # likewise

JOB: dict[str, Any] = {
    "compwright": 1,
    "controller": {"format": "own.yaml", "options": {"a": 1}},
    "states": {"as_found": "none"},
    "axes": {
        "X": {
            "travel": [0, 800],
            "before": ["x.csv"],
            "accept": {"A": 8},
            "encoder": {"type": "absolute"},
            "table": {"spacing": "auto", "mode": "single"},
        },
        "Y": {"travel": [0, 400], "before": ["y.csv"], "accept": {"A": 8}},
        "Z": {"travel": [0, 300], "before": ["z.csv"]},
    },
    "circles": [{"file": "xy.csv"}],
    "cross": [
        {"input": "X", "output": "Y", "positions": [0, 1], "deviations": [0, 1], "unit": "um"}
    ],
    "apply": {"squareness": {"XY": "Y", "YZ": "Z"}, "scale": ["Z"], "backlash_from": "circle"},
    "uncertainty": {"U_theta": 0.5, "E_VE": {"file": "d.csv", "duration_min": 5}},
    "decision_rule": "guarded",
}
X = NextAxis(
    before=[{"files": ["m/a.csv"], "name": "x"}],
    resolved={"address": "1", "encoder": {"system": 2}},
)


def after(**more: Any) -> dict[str, Any]:
    axes = {"X": X, "Y": NextAxis(before=())}
    then = NextRound(format="definition/own.yaml", states={"as_found": ["f"]}, axes=axes, **more)
    return next_job(JOB, then)


def test_what_the_engineer_wrote_stays_and_what_was_settled_is_written_out() -> None:
    job = after(paths={"d.csv": "m/d.csv"})
    assert job["axes"]["X"] == {
        "travel": [0, 800],
        "before": [{"files": ["m/a.csv"], "name": "x"}],
        "accept": {"A": 8},
        "encoder": {"type": "absolute", "system": 2},
        "address": "1",
        # a chosen grid is in the control now: `auto` would choose another one
        "table": {"mode": "single", "gain": "seen"},
    }
    assert list(job["axes"]) == ["X", "Y"]
    assert job["controller"] == {"format": "definition/own.yaml", "options": {"a": 1}}
    assert job["uncertainty"]["E_VE"] == {"file": "m/d.csv", "duration_min": 5}
    assert job["decision_rule"] == "guarded"


def test_an_axis_that_only_circles_speak_of_has_neither_tests_nor_limits() -> None:
    assert after()["axes"]["Y"] == {"travel": [0, 400], "before": []}


def test_only_what_was_measured_again_is_corrected_between_axes() -> None:
    circle = {"file": "m/xy.csv", "name": "xy"}
    job = after(circles=[circle], squareness=["XY"])
    assert job["circles"] == [circle]
    assert job["apply"] == {"squareness": {"XY": "Y"}, "backlash_from": "circle"}
    assert "cross" not in job
    assert {"circles", "apply", "cross"}.isdisjoint(after())


def test_limits_go_on_speaking_of_their_test() -> None:
    moved = NextAxis(before=X.before, limited="x_long")
    then = NextRound(format="own", states={}, axes={"X": moved})
    assert next_job(JOB, then)["axes"]["X"]["accept"] == {"test": "x_long", "A": 8}


@pytest.mark.parametrize(
    "before", ["runs/x.csv", ["runs/x.csv"], {"files": "runs/x.csv"}, [{"files": ["runs/x.csv"]}]]
)
def test_every_way_to_write_a_test(before: Any) -> None:
    assert test_sections({"before": before}) == [{"name": "x", "files": ["runs/x.csv"]}]


def test_each_test_keeps_its_own_state_and_temperature() -> None:
    section = {
        "name": "x",
        "files": ["x.csv"],
        "motion": "rapid",
        "profile": "p.yaml",
        "thermal": {"alpha_m": 11.5, "T_m": 22.0},
    }
    paths = {"p.yaml": "m/p.yaml"}
    old = earlier_test(section, ["m/x.csv"], "x_round_1", "round_1", paths)
    assert old["measured_in"] == "round_1"
    assert old["thermal"] == {"alpha_m": 11.5, "T_m": 22.0}
    other = earlier_test({**section, "measured_in": "off"}, ["m/x.csv"], "x", "round_1", paths)
    assert other["measured_in"] == "off"
    new = test_after(section, ["m/n.csv"], {"T_m": (23.0, 24.0), "T_d": (20.0, 20.0)}, paths)
    assert new == {
        "name": "x",
        "files": ["m/n.csv"],
        "motion": "rapid",
        "profile": "m/p.yaml",
        "thermal": {"alpha_m": 11.5, "T_m": [23.0, 24.0]},
        "measured_in": "as_found",
    }


def test_rounds_are_counted() -> None:
    assert name_of_round(["as_found", "off"]) == "round_1"
    assert name_of_round(["as_found", "round_1", "round_2"]) == "round_3"


PLAIN = st.recursive(
    st.text() | st.integers(-(10**9), 10**9) | st.booleans() | st.floats(-1e6, 1e6),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)


@given(st.dictionaries(st.text() | st.sampled_from(["axes", "states"]), PLAIN, min_size=1))
def test_a_job_reads_back_as_it_was(data: dict[str, Any]) -> None:
    assert read_yaml(data_text(data, ["above it"]).encode(), "job.yaml").data == data
