"""The small drawing of numbered sections on the card, as text and as a picture."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from card_files import card_of
from compwright.cli import run as compwright
from compwright.formats.families.increments.increment_facts import IncrementFacts
from compwright.formats.families.shapes import control_format
from compwright.records.axis import Axis, AxisKind, Direction
from compwright.records.correction import AxisCompensation
from compwright.records.facts import AxisFacts
from compwright.reporting.numbering import numbering_svg, numbering_text
from format_samples import DEFINITIONS

pytestmark = pytest.mark.short_estimate


def numbered(
    reference: int,
    first: int,
    last: int,
    interval: float,
    *,
    travel: tuple[float, float] = (-100.0, 100.0),
    zero: float = 0.0,
    modulo: float | None = None,
    second: int | None = None,
    held: Mapping[int, int] | None = None,
    format_id: str = "fanuc-30i",
) -> tuple[dict[str, Any], list[str]]:
    """The document of the drawing and its sentences, by the numbers of an axis; ``held``: what the
    points hold that are not 0.
    """
    facts = AxisFacts(
        of_family=IncrementFacts(
            reference_number=reference,
            first_number=first,
            last_number=last,
            interval=interval,
            magnification=2,
            negative_first=second,
            two_sets=second is not None,
        )
    )
    kind = AxisKind.LINEAR if modulo is None else AxisKind.ROTARY
    axis = Axis(name="X", kind=kind, travel=travel, address="1", modulo=modulo, reference=zero)
    steps = [(held or {}).get(number, 0) for number in range(first, last + 1)]
    sums = 2 * 0.001 * np.concatenate([[0.0], np.cumsum(steps)])
    nodes = zero + interval * (np.arange(first - 1, last + 1, dtype=np.float64) - reference)
    table = AxisCompensation(
        address="1",
        kind=kind,
        positions=nodes,
        positive=sums,
        negative=sums,
        backlash=0.0,
        reference_return=Direction.POSITIVE,
    )
    options = {"detection_unit": 0.001}
    found = card_of(control_format(DEFINITIONS[format_id], options), axis, table, facts).numbered
    assert found is not None
    document = {
        "unit": found.unit,
        "reference": found.reference,
        "sections": [{"number": n, "from": low, "to": high} for n, low, high in found.sections],
        "marks": [{"number": number, "name": name} for number, name in found.marks],
        "second": found.second,
    }
    return document, list(found.words)


def test_the_example_of_the_manual() -> None:
    """B-63980EN/01 page 100: interval 50, reference 40, -400 to 800: 33 to 56."""
    document, words = numbered(40, 33, 56, 50.0, travel=(-400.0, 800.0))
    assert numbering_text(document) == [
        "parameter         3621                      3620                              3622",
        "number             33      34                40      41                55      56",
        "                |-------|-------|   ...   |-------#-------|   ...   |-------|-------|",
        "position      -400    -350    -300       -50      0      50        700     750     800  mm",
        "# is the reference position",
    ]
    sections = {each["number"]: (each["from"], each["to"]) for each in document["sections"]}
    assert sections[33] == (-400, -350)
    assert sections[40] == (-50, 0)
    assert sections[41] == (0, 50)
    assert sections[56] == (750, 800)
    assert "3620 = 40 owns -50 to 0 mm, at the reference." in words
    assert "3621 = 33 owns -400 to -350 mm, the first." in words
    assert "3622 = 56 owns 750 to 800 mm, the last." in words


def test_a_turn_in_the_manuals_form_and_in_that_of_a_real_control() -> None:
    """Same page: 45 deg, reference 60, last 68; number 60 holds the same value as 68. The real
    backup: 300, first 301, last 312, 30 deg.
    """
    document, words = numbered(60, 60, 68, 45.0, modulo=360.0, travel=(0.0, 360.0))
    assert [each["number"] for each in document["sections"]] == list(range(61, 69))
    assert any(
        "the same section as point 68 and must hold the same value" in each for each in words
    )
    document, words = numbered(300, 301, 312, 30.0, modulo=360.0, travel=(0.0, 360.0))
    assert [each["number"] for each in document["sections"]] == list(range(301, 313))
    assert any(
        "3620 = 300 is the number of the reference: it owns no section" in each for each in words
    )
    assert document["sections"][-1] == {"number": 312, "from": 330.0, "to": 360.0}


def test_travel_that_begins_or_ends_at_the_reference() -> None:
    _, words = numbered(10, 10, 14, 25.0, travel=(0.0, 100.0))
    assert "Point 10 holds 0: its section lies beyond the travel." in words
    _, words = numbered(13, 10, 14, 25.0, travel=(-100.0, 0.0))
    assert "Point 14 holds 0: its section lies beyond the travel." in words
    _, words = numbered(12, 10, 14, 25.0)
    assert not any("holds 0" in each for each in words)


def test_what_a_point_holds_is_what_was_read_back() -> None:
    """3620 = 3622: the last point is the reference's own and holds -26; nothing of it is beyond the
    travel. Beyond the travel the value of the table counts, whatever it is.
    """
    _, words = numbered(300, 281, 300, 50.0, travel=(-1000.0, 0.0), held={300: -26})
    assert not any("300 holds" in each for each in words)
    _, words = numbered(13, 10, 14, 25.0, travel=(-100.0, 0.0), held={13: 4, 14: -3})
    assert "Point 14 holds -3: its section lies beyond the travel." in words


def test_a_second_set_and_numbers_of_another_series() -> None:
    document, words = numbered(40, 37, 44, 50.0, second=110, travel=(-200.0, 200.0))
    assert any("110 to 117 (3626)" in each for each in words)
    lines = numbering_text(document)
    assert [line.split()[0] for line in lines[:3]] == ["parameter", "number", "travel"]
    assert lines[2].split()[3:] == [str(number) for number in range(110, 118)]
    _, words = numbered(40, 37, 44, 50.0, format_id="fanuc-15i")
    assert "5420 = 40 owns -50 to 0 mm, at the reference." in words


@pytest.mark.parametrize(
    ("numbers", "shown"),
    [
        ((40, 37, 44, 50.0), [37, 38, 39, 40, 41, 42, 43, 44]),
        ((40, 33, 56, 50.0), [33, 34, 40, 41, 55, 56]),
        ((40, 39, 80, 2.5), [39, 40, 41, 79, 80]),
        ((40, 40, 41, 1000.0), [40, 41]),
        ((1000, 500, 1001, 0.5), [500, 501, 1000, 1001]),
    ],
)
def test_of_many_sections_the_ends_and_those_about_the_reference(
    numbers: tuple[int, int, int, float], shown: list[int]
) -> None:
    """Text and picture show the same numbers and positions, none of them twice or into another."""
    document, _ = numbered(*numbers, zero=-12.5)
    parameter, line, rule, position, *_ = numbering_text(document)
    assert line.split()[1:] == [str(number) for number in shown]
    assert rule.count("...") == sum(b != a + 1 for a, b in pairwise(shown))
    places = position.split()[1:-1]
    assert len(places) == rule.count("|") + rule.count("#")
    assert rule.count("#") == 1
    assert places[[one for one in rule if one in "|#"].index("#")] == "-12.5"
    assert "3620" in parameter
    texts = re.findall(r">([^<>]+)</text>", numbering_svg(document))
    for number in shown:
        assert texts.count(str(number)) >= 1
    assert texts.count("reference") == 1
    assert all(place in texts for place in places)


#: The table of an axis in which nothing acts.
NOTHING = AxisCompensation(
    address="1",
    kind=AxisKind.LINEAR,
    positions=np.empty(0),
    positive=np.empty(0),
    negative=np.empty(0),
    backlash=0.0,
    reference_return=Direction.POSITIVE,
)


def test_a_control_without_such_numbers_has_no_drawing() -> None:
    nodes, zeros = np.array([0.0, 1.0]), np.zeros(2)
    flat = replace(NOTHING, positions=nodes, positive=zeros, negative=zeros)
    for name, definition in DEFINITIONS.items():
        if not name.startswith("fanuc"):
            control = control_format(definition, definition.sample_options)
            address = "1" if definition.addresses.type == "integer" else "AX1"
            axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(0.0, 1.0), address=address)
            assert card_of(control, axis, flat).numbered is None
    fanuc = control_format(DEFINITIONS["fanuc-30i"], {"detection_unit": 0.001})
    axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(0.0, 1.0), address="1")
    assert card_of(fanuc, axis, NOTHING).numbered is None


def test_it_stands_on_the_card_with_the_numbers_that_were_written(tmp_path: Path) -> None:
    rows = "".join(
        f"{x},{sign},{run},{0.05 * x + (2 if sign == '-' else 0)}\n"
        for run in (1, 2)
        for sign in "+-"
        for x in range(0, 401, 40)
    )
    (tmp_path / "x.csv").write_text(f"# axis: X\ntarget_mm,direction,run,deviation_um\n{rows}")
    words = ["--format", "fanuc-30i", "--axis", "X", "--travel", "0:400", "--state", "none"]
    for option in ("address=1", "detection_unit=0.001", "first_point=70", "spacing=40"):
        words += ["--option", option]
    out = tmp_path / "out"
    assert compwright(["run", str(tmp_path / "x.csv"), *words, "--out", str(out)]) in (0, 1)
    card = (out / "card" / "card.md").read_text()
    drawing = card.partition("### Numbers of the sections")[2].partition("### ")[0]
    assert "3620 = 70 owns -40 to 0 mm, at the reference." in drawing
    assert "3622 = 80 owns 360 to 400 mm, the last." in drawing
    assert "3621 3620" in drawing
    page = (out / "card" / "card.html").read_text()
    assert "Numbers of the sections" in page
    assert ">3621 3620</text>" in page
