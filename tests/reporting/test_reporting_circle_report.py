"""The page of a circle in a report: causes in words, next to what the instrument's software printed,
with what to do about them.
"""

from __future__ import annotations

from typing import Any

import pytest

from compwright.reporting.causes import _WORDS
from compwright.reporting.circle_report import _causes, _words
from compwright.reporting.circle_steps import next_step

AXES = ("Z", "X")


def entry(value: float, error: float, effect: float, share: float) -> dict[str, Any]:
    return {"value": value, "std_error": error, "unit": "um", "effect": effect, "share": share}


RESULT: dict[str, Any] = {
    "axes": AXES,
    "parameters": {"G_ccw": 5.0, "H": None},
    "diagnosis": {
        "backlash_second": entry(4.0, 0.2, 4.0, 0.8),
        "backlash_second_at_positive": entry(5.0, 0.3, 4.5, 0.0),
        "straightness_first": entry(1.0, 0.9, 0.5, 0.2),
    },
    "plain": {},
    "vendor": {},
}


def test_causes_with_their_ends_and_the_step_of_what_is_significant() -> None:
    table = _causes(RESULT)
    lost, end, straight = table["rows"]
    assert lost[:2] == ["Lost motion X", "4.00 ± 0.20"]
    assert lost[-2] == "80"
    assert "X screw" in lost[-1]
    assert (end[1], end[-1]) == ("5.00 ± 0.30", "")
    assert (straight[0], straight[-1]) == ("Straightness Z", "")  # 1.0 ± 0.9 says nothing
    assert "Software of the instrument" not in [head["text"] for head in table["heads"]]


def test_what_the_software_printed_is_next_to_it() -> None:
    vendor = {"RENISHAW_DIAGNOSTICS": {"AF_BACKLASH_B_POS": {"value": 4.4, "valid": False}}}
    table = _causes({**RESULT, "vendor": vendor})
    assert "Software of the instrument" in [head["text"] for head in table["heads"]]
    assert [row[2] for row in table["rows"]] == ["", "(4.40)", ""]


#: Details of another cause, and values that sum causes up.
NO_STEP = {"scale_error", "backlash_mismatch", "lobes_2", "lobes_3", "positional_tolerance"}


@pytest.mark.parametrize("cause", sorted(set(_WORDS) - NO_STEP))
def test_every_cause_has_a_step_in_words(cause: str) -> None:
    step = next_step(cause, AXES) or next_step(f"{cause}_first", AXES)
    assert len(step) > 20
    assert "{first}" not in step
    assert "_" not in step


def test_the_job_that_corrects_squareness_is_named() -> None:
    assert "apply: {squareness: {ZX: X}}" in next_step("squareness", AXES)


def test_no_name_of_a_key_is_on_the_page() -> None:
    assert _words("backlash_first", RESULT) == "Lost motion Z"
    assert _words("backlash_first_at_positive", RESULT) == "Lost motion Z at Z+"
    assert _words("scale_error_second", RESULT) == "Scale error X"
    assert _words("G_ccw", RESULT) == "G ccw"
