"""What limits an axis, as it is shown: every cause with its number and a bar as long as its part."""

from __future__ import annotations

import re
from typing import Any

import pytest

from compwright.reporting.limiting import limits_block, limits_line
from compwright.reporting.point_count_figure import worth_block
from compwright.reporting.run_report import run_report
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
    part = page[page.index("what limits its accuracy") :].partition("<h3>")[0]
    text = " ".join(re.sub("<[^>]*>", " ", part).split())
    assert "4.89 µm expected, 24.60 µm with what is in the control now" in text
    assert "would give 3.90 µm" in text
    assert "repeatability" in text
    assert "do not add up" in text
    assert page.count("what limits its accuracy") == 1  # the other axis has nothing to show


def test_the_terminal_says_it_in_one_line() -> None:
    line = limits_line(axis_x())
    assert line == (
        "What limits A (4.89 µm at new targets): noise 2.45, resolution of the table"
        " values 0.40 µm (effect of each cause alone; do not add the values)."
    )
    assert limits_line({"limited": None}) == ""


def circles_of(svg: str) -> list[tuple[float, float, str]]:
    """Where a picture has its dots, and how they are filled."""
    found = re.findall(r'<circle cx="([\d.]+)" cy="([\d.]+)" r="[\d.]+" fill="(#\w+)"', svg)
    return [(float(x), float(y), fill) for x, y, fill in found]


def test_the_worth_of_points_is_drawn_to_scale() -> None:
    """Down is less: heights above the line of zero are in proportion to the medians; each doubling
    of the points is as wide as the next; only the table that is written is filled.
    """
    block = worth_block(axis_x(), "um")
    assert block is not None
    dots = circles_of(block["figure"].svg("en"))
    zero = 182.0
    heights = [zero - y for _, y, _ in dots]
    assert heights == pytest.approx(
        [heights[0] * m / 16.0 for m in (16.0, 8.0, 4.89, 4.8)], abs=0.2
    )
    first, second, third = (x for x, _, _ in dots[:3])
    assert (third - second) / (second - first) == pytest.approx(1.0, abs=0.01)  # 2, 6, 18
    assert [fill == "#ffffff" for _, _, fill in dots] == [True, True, False, True]
    assert "the ring is the existing table of the control" in str(block["caption"])
    assert str(block["words"][2]) == "18 points, every 50 mm: A 4.89 µm (3.91 to 6.36)"


def test_the_worth_of_points_stands_in_the_report_once() -> None:
    page = run_report(run_view()).decode()
    assert page.count("predicted accuracy by number of table points") == 1
    assert worth_block({"points_worth": [], "limited": axis_x()["limited"]}, "um") is None
