"""What limits an axis, as it is shown: every cause with its number and a bar as long as its part."""

from __future__ import annotations

import re
from typing import Any

import pytest

from compwright.reporting.limiting import limits_block, limits_line
from compwright.reporting.report import run_report
from reporting_samples import run_view


def axis_x() -> dict[str, Any]:
    axis: dict[str, Any] = run_view()["prediction"]["axes"]["X"]
    return {**axis, "unit": "um"}


def test_bars_are_as_long_as_their_part() -> None:
    block = limits_block(axis_x(), "um")
    assert block is not None
    noise, quantum, points = block["rows"]
    assert noise["width"] / block["width"] == pytest.approx(2.45 / 4.89, abs=1e-3)
    assert quantum["width"] / noise["width"] == pytest.approx(0.4 / 2.45, abs=2e-3)
    assert points["width"] == 0.0  # it cancels others: there is no bar of less than nothing
    assert (points["value"], points["rms"], noise["rms"]) == ("−0.02", "0.115", "")


def test_the_report_names_what_limits_an_axis_in_plain_words() -> None:
    page = run_report(run_view()).decode()
    part = page[page.index("What limits this axis") :].partition("<h3>")[0]
    text = " ".join(re.sub("<[^>]*>", " ", part).split())
    assert "4.89 µm expected, 24.60 µm with what is in the control now" in text
    assert "would give 3.90 µm" in text
    assert "repeatability" in text
    assert "do not add up" in text
    assert page.count("What limits this axis") == 1  # the other axis has nothing to show


def test_the_terminal_says_it_in_one_line() -> None:
    line = limits_line(axis_x())
    assert line == (
        "What limits A (4.89 µm at new targets): noise 2.45, quantum 0.40 µm (each alone; they do"
        " not add up)."
    )
    assert limits_line({"limited": None}) == ""
