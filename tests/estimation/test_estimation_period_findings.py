"""What a search for periods says to the user: what to look for, the odds, and targets that would
settle what these leave open.
"""

from __future__ import annotations

import numpy as np
import pytest

from compwright.estimation.period_findings import meaning, period_findings
from compwright.estimation.period_models import PeriodCurve, PeriodModel, PeriodSearch
from compwright.foundations.findings import Finding
from compwright.records.axis import AxisKind, FloatArray
from compwright.records.estimate import AxisPeriod

ODD: FloatArray = np.array([3.0, 61.0, 97.0, 158.0, 204.0, 247.0, 309.0, 346.0, 402.0, 455.0])
EQUAL: FloatArray = 50.0 * np.arange(10, dtype=np.float64)
CURVE = PeriodCurve(np.array([50.0, 2.0]), np.array([0.0, 0.0]), np.array([1e-3, np.inf]))


def said(
    *found: AxisPeriod,
    targets: FloatArray = ODD,
    alike: tuple[tuple[tuple[float, ...], float], ...] = (),
    known: tuple[float, ...] = (),
    fitted: tuple[float, ...] = (),
    curve: PeriodCurve | None = CURVE,
    nodes: tuple[float, ...] = (),
) -> list[Finding]:
    search = PeriodSearch((PeriodModel((), (), 1.0),), found, alike, curve)
    return period_findings(search, targets, AxisKind.LINEAR, known, fitted, nodes)


def test_a_found_period_says_what_to_look_for_and_its_odds() -> None:
    (finding,) = said(AxisPeriod(10.0, 0.97, "found"))
    assert finding.code == "CW-E012"
    assert "every 10 mm (probability 97 %, 32 times as likely as not)" in finding.message
    assert "once in 10 mm: a screw lead of 10 mm" in finding.message
    assert (
        "once in 20 mm and causes the error twice in it: a screw lead of 20 mm" in finding.message
    )
    (sure,) = said(AxisPeriod(10.0, 0.9947, "found"))
    assert "190 times as likely as not" in sure.message, "never exponents"


@pytest.mark.parametrize(
    ("spacing", "suspicious"), [(40.0, True), (40.5, True), (20.0, False), (50.0, False)]
)
def test_a_period_as_long_as_the_nodes_of_the_table_are_apart_is_suspicious(
    spacing: float, *, suspicious: bool
) -> None:
    nodes = tuple(spacing * k for k in range(12))
    (finding,) = said(AxisPeriod(40.0, 0.9, "found"), nodes=nodes)
    assert (finding.values["nodes"] is not None) == suspicious
    assert ("check first that the table was active" in finding.message) == suspicious
    (bare,) = said(AxisPeriod(40.0, 0.9, "found"))
    assert bare.values["nodes"] is None


def test_what_is_not_settled_is_one_finding() -> None:
    first, second = said(
        AxisPeriod(12.0, 0.6, "found"),
        AxisPeriod(10.0, 0.2, "found"),
        AxisPeriod(8.0, 0.22, "found"),
        AxisPeriod(6.0, 0.07, "found"),
    )
    assert "every 12 mm (probability 60 %" in first.message
    assert "10 mm (20 %) or 8 mm (22 %), but these" in second.message
    assert {first.code, second.code} == {"CW-E012"}


def test_what_looks_alike_is_not_named_and_comes_with_targets_that_tell() -> None:
    group = (86.8, 45.8, 11.3)
    (finding,) = said(AxisPeriod(86.8, 0.33, "found"), targets=EQUAL, alike=((group, 0.99),))
    assert (finding.code, finding.severity) == ("CW-E013", "warning")
    assert "86.8, 45.8, 11.3" in finding.message
    proposed = finding.message.partition("targets that would show this error: ")[2]
    assert len(proposed.split(",")) >= EQUAL.size
    # A group that is not likely is no news.
    assert [each.code for each in said(targets=EQUAL, alike=((group, 0.2),))] == ["CW-E014"]


def test_nothing_found_says_why_that_may_be() -> None:
    assert set(said(targets=EQUAL)[0].values) == {"interval", "unit"}
    assert said(targets=ODD[:5], curve=None)[0].values == {"targets": 5}
    assert "the readings show none" in said()[0].message
    assert said(known=(10.0,), fitted=(10.0,)) == []


def test_a_few_per_cent_are_no_news() -> None:
    (finding,) = said(AxisPeriod(8.0, 0.07, "found"))
    assert finding.code == "CW-E014"


def test_what_may_be_hidden_is_said_as_a_chance() -> None:
    models = (PeriodModel((), (), 0.75), PeriodModel((8.0,), ((1,),), 0.25))
    search = PeriodSearch(models, (), (), CURVE)
    (finding,) = period_findings(search, ODD, AxisKind.LINEAR, (), ())
    assert finding.values == {"probability": 25.0}


def test_known_periods_that_the_data_do_not_tell_are_counted() -> None:
    (finding,) = said(known=(5.0, 10.0, 20.0), fitted=(10.0,))
    assert finding.code == "CW-E015"
    assert finding.values == {"known": 3, "fitted": 1, "periods": (10.0,), "unit": "mm"}


@pytest.mark.parametrize(
    ("period", "kind", "word"),
    [
        (
            5.0,
            AxisKind.LINEAR,
            "once in 10 mm and causes the error twice in it: a screw lead of 10 mm",
        ),
        (12.7, AxisKind.LINEAR, "0.5 inch"),
        (5.0, AxisKind.ROTARY, "72 turns for one turn of the table"),
        (17.77, AxisKind.LINEAR, "no usual screw"),
        (7.77, AxisKind.ROTARY, "repeats 46.33 times per turn"),
    ],
)
def test_the_meaning_of_a_period(period: float, kind: AxisKind, word: str) -> None:
    assert word in str(meaning(period, kind))
