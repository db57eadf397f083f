"""Periods in the report: a row for each with its probability, and the curve with its peak at the
period that was found.
"""

from __future__ import annotations

import math
import re
from typing import Any

import pytest

from compwright.reporting.periods import periods_block
from compwright.reporting.run_report import run_report
from reporting_samples import run_view

FOUND = [
    {"period": 10.0, "probability": 0.97, "source": "found"},
    {"period": 20.0, "probability": 1.0, "source": "job"},
    {"period": 4.0, "probability": 0.06, "source": "found"},
]
SEARCH = {
    "periods": [2.0, 5.0, 10.0, 50.0],
    "log_odds": [-9.0, 0.0, 6 * math.log(10.0), -1.0],
    "detectable": [None, 2.0, 0.5, 1.0],
    "alike": [[12.5, 50.0]],
}


def points(block: dict[str, Any]) -> list[tuple[float, float]]:
    return [
        (float(x), float(y))
        for x, y in (pair.split(",") for pair in block["odds"]["lines"][0].split())
    ]


def test_the_curve_stands_at_its_periods_and_odds() -> None:
    block = periods_block({"periods": FOUND, "period_search": SEARCH}, "um")
    assert block is not None
    drawn, picture = points(block), block["odds"]
    assert [x for x, _ in drawn] == sorted(x for x, _ in drawn)
    assert drawn[2][0] == picture["found"][0]["x"], "the mark stands at the peak"
    assert drawn[1][1] == picture["even"]
    assert min(y for _, y in drawn) == drawn[2][1]
    # A million to one is six steps of ten above even, on the same scale as the levels.
    levels = {level["text"]: level["y"] for level in picture["levels"]}
    per_ten = (levels["1"] - levels["100"]) / 2
    assert drawn[1][1] - drawn[2][1] == pytest.approx(6 * per_ten, abs=0.3)
    assert "10\u00a0000" in levels
    # Cut off below.
    assert drawn[0][1] <= picture["bottom"]


def test_the_least_amplitude_has_a_gap_where_no_wave_is_shown() -> None:
    search = {**SEARCH, "detectable": [1.0, None, 0.5, 25.0]}
    block = periods_block({"periods": FOUND, "period_search": search}, "um")
    assert block is not None
    lines, levels = block["least"]["lines"], block["least"]["levels"]
    assert [len(line.split()) for line in lines] == [1, 1]
    heights = [float(line.partition(",")[2]) for line in lines]
    level = {each["text"]: each["y"] for each in levels}
    assert heights[0] == level["1"]
    assert heights[1] == pytest.approx((level["0"] + level["1"]) / 2.0, abs=0.1)


def test_high_odds_are_written_as_powers_that_can_be_read() -> None:
    high = {**SEARCH, "log_odds": [0.0, 0.0, 30 * math.log(10.0), 0.0]}
    block = periods_block({"periods": FOUND, "period_search": high}, "um")
    assert block is not None
    texts = [level["text"] for level in block["odds"]["levels"]]
    assert texts[0] == "1"
    assert texts[-1] == "10²⁸"


def test_rows_say_who_tells_a_period_and_only_what_counts_is_marked() -> None:
    block = periods_block({"periods": FOUND, "period_search": SEARCH}, "um")
    assert block is not None
    assert [(row["period"], row["probability"], str(row["source"])) for row in block["rows"]] == [
        ("10", "97 %", "found in the readings"),
        ("20", "> 99.9 %", "given by the job"),
        ("4", "6 %", "found in the readings"),
    ]
    assert [mark["text"] for mark in block["odds"]["found"]] == ["10", "20"]
    assert list(map(str, block["alike"])) == [
        "At these targets the following periods cannot be distinguished: 50, 12.5 mm."
    ]
    assert periods_block({"periods": [], "period_search": None}, "um") is None


def test_the_report_shows_them() -> None:
    view = run_view()
    view["prediction"]["axes"]["X"].update(periods=FOUND, period_search=SEARCH)
    page = run_report(view).decode()
    part = page[page.index("periods of the error") :].partition("<h3>")[0]
    text = " ".join(re.sub("<[^>]*>", " ", part).split())
    assert "10 97 % found in the readings" in text
    assert "cannot be distinguished: 50, 12.5 mm" in text
    assert "<polyline" in part
    assert page.count("periods of the error") == 1


def test_periods_that_the_search_leaves_out_are_gaps() -> None:
    """A period that looks like the smooth error at the targets has no odds: it is no low value."""
    search = {**SEARCH, "log_odds": [-1.0, 0.0, -10.0, -10.0]}
    view = run_view()
    view["prediction"]["axes"]["X"].update(periods=[], period_search=search)
    block = periods_block({"periods": [], "period_search": search}, "um")
    assert block is not None
    assert [len(line.split()) for line in block["odds"]["lines"]] == [2]
    page = " ".join(run_report(view).decode().split())
    assert "the search cannot find it" in page
    assert "but not in the gaps of the figure above" in page
    assert "Smallest amplitude that this test shows, in µm" in page
