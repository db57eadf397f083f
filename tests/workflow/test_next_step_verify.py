"""The next step after ``verify``: it names the axes of which it speaks."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from compwright.workflow.results.next_step import after_run, after_verify


def step(
    verdicts: dict[str, str],
    *codes: str,
    of_circle: str | None = None,
    own: str = "",
    read_back: bool = True,
    files: tuple[Path, ...] = (),
) -> str:
    document: dict[str, Any] = {
        "verdict": "bad",
        "axes": {
            name: {
                "loading": {"verdict": verdict},
                "findings": [{"code": own}] if own else [],
            }
            for name, verdict in verdicts.items()
        },
        "circles": {"xy": {"squareness": None, "findings": [{"code": of_circle}]}}
        if of_circle
        else {},
        "findings": [{"code": code} for code in codes],
        "doubts": [{"code": code} for code in codes],
    }
    outcome = SimpleNamespace(
        document=document,
        files=files,
        of_axes=["a.csv"] if verdicts else [],
        of_circles={},
    )
    after = [*outcome.of_axes, *(["xy=circle.csv"] if of_circle else [])]
    job, out = Path("job.yaml"), Path("job")
    return after_verify(outcome, job, out, after, plan=out, given=(), read_back=read_back)


@pytest.mark.parametrize(
    ("verdicts", "words"),
    [
        ({"X": "state"}, "Next: state what was active in the first test of X (states)"),
        (
            {"X": "state", "Y": "loaded", "Z": "not_active"},
            "Next: correct what is named above for Z, state what was active in the first test of X",
        ),
        # without a table, or open: there is nothing to correct on the control
        ({"X": "state", "Y": "undecided"}, "Next: state what was active in the first test of X"),
        ({"X": "loaded", "Z": "not_active"}, "Next: correct what is named above, measure again"),
    ],
)
def test_one_axis_does_not_decide_for_all(verdicts: dict[str, str], words: str) -> None:
    assert step(verdicts).startswith(words)


def test_the_next_round_of_one_axis_names_the_others_that_were_not_loaded() -> None:
    tables = (Path("job") / "next" / "tables" / "AX1_EEC.INI",)
    both = step({"X": "loaded", "Y": "not_active", "Z": "state"}, files=tables)
    assert both.startswith("Next: correct what is named above for Y, do the steps of job/next/card")
    alone = step({"X": "loaded", "Y": "undecided"}, files=tables)
    assert alone.startswith("Next: do the steps of job/next/card/card.html")


def test_a_coupling_that_is_new_is_nothing_to_load() -> None:
    assert "load what differs" in step({"X": "loaded"}, "CW-S087")
    coupled = step({"X": "loaded"}, "CW-S087", "CW-S088")
    assert "load what differs" in coupled
    coupled = step({"X": "loaded"}, "CW-S088")
    assert coupled.startswith("Next: check on the control the coupling that CW-S088 names")
    assert coupled.endswith("compwright run job.yaml --out job --force")


def test_a_doubt_is_no_reason_for_another_round() -> None:
    assert step({"X": "loaded"}).endswith("--loaded READ_BACK --update --force")
    assert step({"X": "loaded"}, "CW-V029").startswith("Next: check the test after loading as")
    assert step({"X": "loaded"}, "CW-V033").endswith("compwright compare job --loaded READ_BACK")


@pytest.mark.parametrize("code", ["CW-V021", "CW-V025", "CW-V026", "CW-V032"])
@pytest.mark.parametrize("read_back", [True, False])
def test_a_circle_that_cannot_be_trusted_is_checked_or_measured_before_the_control(
    code: str, *, read_back: bool
) -> None:
    """A noisy, turned or old file, or one of another machine, is no fault of the table."""
    first = step({}, of_circle=code, read_back=read_back)
    assert first.startswith(
        f"Next: check the test after loading as {code} says, or measure it again"
    )
    assert "verify job.yaml --after AFTER_FILE" in first
    assert "compare" not in first
    assert "load what differs" in step({}, "CW-V011", of_circle=code)


def test_a_circle_that_cannot_be_trusted_hides_no_fault_of_an_axis() -> None:
    """The own test of X proves that its table is inverted, however noisy the circle is."""
    faulty = step({"X": "inverted", "Y": "loaded"}, of_circle="CW-V021")
    assert faulty.startswith("Next: correct what is named above, measure again")
    faulty = step({"X": "not_active"}, of_circle="CW-V021", read_back=False)
    assert faulty.startswith("Next: save the control's files")
    state = step({"X": "state"}, of_circle="CW-V021")
    assert state.startswith("Next: state what was active in the first test of X")


def test_the_good_tests_of_axes_stay_in_the_command() -> None:
    circle = step({"X": "loaded", "Y": "undecided"}, of_circle="CW-V021")
    assert circle.startswith("Next: check the test after loading as CW-V021 says, or measure it")
    assert "verify job.yaml --after a.csv --after AFTER_FILE --loaded READ_BACK" in circle
    assert "a.csv" not in step({"X": "undecided"}, of_circle="CW-V021", own="CW-V026")


def test_two_findings_are_named_in_the_plural() -> None:
    both = step({"X": "loaded"}, "CW-V025", of_circle="CW-V021")
    assert "as the findings CW-V021 and CW-V025 say, or measure it again" in both
    both = step({"X": "loaded"}, "CW-V023", "CW-V034")
    assert "measure what the findings CW-V023 and CW-V034 name, then" in both


@pytest.mark.parametrize("sheet", ["entry_X.csv", "cross_X_Y.csv", "straightness_X_Y.csv"])
def test_an_entry_sheet_is_something_to_load(sheet: str) -> None:
    files = (Path("job") / "card" / sheet,)
    outcome = SimpleNamespace(no_tables=False, prediction={"doubts": []}, files=files)
    last = after_run(outcome, Path("job.yaml"), Path("job"), apart=False)
    assert last.startswith("Next: do the steps of job/card/card.html, measure again")
