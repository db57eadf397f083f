"""The commissioning card: one set of check positions for all of it, inside the travel, and a table
for what differs by axis.
"""

from __future__ import annotations

import json
import math
import re
import statistics
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from card_files import card_values
from compwright.cli import run as compwright
from compwright.formats.card import card_steps, card_steps_of_all
from compwright.formats.families.card_texts import loading_order
from compwright.formats.families.shapes import control_format
from compwright.planning.quick_check import check_positions
from compwright.records.axis import Axis, AxisKind
from compwright.records.correction import ControlFile
from compwright.records.facts import AxisFacts
from compwright.reporting import card as reporting_card
from compwright.reporting.card import card_html, card_markdown
from compwright.words.sentences import ControlText
from format_samples import DEFINITIONS, SIEMENS, axis_of, files, table
from places import PROJECT
from reporting_samples import sample_card
from sinumerik_container import container

pytestmark = pytest.mark.short_estimate

TRAVEL = {"X": (0.0, 1200.0), "A": (-120.0, 120.0)}  # of the example


@pytest.fixture(scope="module")
def card(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("card") / "out"
    assert (
        compwright(
            ["run", str(PROJECT / "examples" / "linuxcnc-two-axes" / "job.yaml"), "--out", str(out)]
        )
        == 0
    )
    return out


def checks(text: str) -> dict[str, list[list[str]]]:
    """The rows of the tables of check positions by axis name."""
    found = {}
    for part in text.split("## Axis ")[1:]:
        rows = [
            [cell.strip() for cell in line.strip("|").split("|")]
            for line in part.splitlines()
            if line.startswith("| ")
        ]
        start = next(number for number, row in enumerate(rows) if row[0].startswith("Position"))
        found[part.split(",")[0]] = [row for row in rows[start + 1 :] if row[1] in {"+", "−"}]
    return found


def number(text: str) -> float:
    return float(text.replace("−", "-"))


def test_one_set_of_positions_inside_the_travel(card: Path) -> None:
    text = (card / "card" / "card.md").read_text(encoding="utf-8")
    assert text.count("### Check positions") == 2
    assert "arriving in" not in text  # no second set in the steps
    for axis, rows in checks(text).items():
        low, high = TRAVEL[axis]
        places = [number(row[0]) for row in rows]
        assert [row[1] for row in rows] == ["+"] * 3 + ["−"] * 3
        assert places[:3] == sorted(places[:3]) == places[:2:-1]
        assert low <= places[0] < places[1] < places[2] <= high


def test_the_card_shows_what_the_control_would_add_there(
    card: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Against the rows of the exported table itself: nominal, actual arriving in + and in -;
    correction = nominal - actual.
    """
    rows = np.loadtxt(card / "tables" / "linuxcnc" / "joint_0.comp")
    for row in checks((card / "card" / "card.md").read_text(encoding="utf-8"))["X"]:
        column = 1 if row[1] == "+" else 2
        expected = np.interp(number(row[0]), rows[:, 0], rows[:, 0] - rows[:, column]) * 1000
        # positions are printed to 0.0005 mm, slopes are below 1e-3, values are printed to 0.0005 µm
        assert number(row[2]) == pytest.approx(expected, abs=0.0011)


def test_the_card_says_to_stop_where_the_readings_leave_no_accident(card: Path) -> None:
    """Five times the scatter of the difference of two readings, as the test itself shows it: from
    its means and standard deviations, in the unit of the column.
    """
    results = json.loads((card / "evaluation.json").read_text(encoding="utf-8"))["results"]
    scatter = {
        result["axis"]: math.sqrt(
            statistics.fmean(
                target[f"s_{way}"] ** 2
                for target in result["targets"]
                for way in ("positive", "negative")
            )
        )
        for result in results
        if result["kind"] == "positioning"
    }
    found = checks((card / "card" / "card.md").read_text(encoding="utf-8"))
    assert set(found) == {"X", "A"}
    for axis, rows in found.items():
        for row in rows:
            # the mean at a target adds to it, less than one reading does
            assert 0.6 < number(row[5]) / (5 * math.sqrt(2) * scatter[axis]) < 1.6


@pytest.mark.parametrize(
    ("targets", "expected"),
    [
        (
            [-20.0, 0.0, 30.0, 60.0, 100.0, 120.0],
            [0.0, 30.0, 100.0],
        ),  # what lies outside the travel is left out
        (
            [-20.0, 50.0, 120.0],
            [0.0, 50.0, 100.0],
        ),  # too few inside: the ends and the middle of the travel
    ],
)
def test_targets_outside_the_travel_are_no_check_positions(
    targets: list[float], expected: list[float]
) -> None:
    work: Any = SimpleNamespace(
        planned=SimpleNamespace(axis=SimpleNamespace(travel=(0.0, 100.0))),
        results=[SimpleNamespace(test=SimpleNamespace(targets=np.array(targets)))],
    )
    assert (
        check_positions(work, lambda where, _: np.where(where == 30.0, 0.01, 0.0)).tolist()
        == expected
    )


def test_the_sign_is_checked_at_two_of_these_positions() -> None:
    """FANUC: the two between which the table changes the distance most; what lies outside the
    travel is not asked for.
    """
    definition = DEFINITIONS["fanuc-30i"]
    axis = Axis(name="X", kind=AxisKind.LINEAR, travel=(-100.0, 0.0), address="1")
    new = table("1", [-150.0, -100.0, -50.0, 0.0, 50.0], [0.020, 0.004, -0.002, 0.0, -0.030])
    values = card_values(
        control_format(definition, {"detection_unit": 0.001}),
        axis,
        new,
        AxisFacts(),
        np.array([-95.0, -50.0, -5.0]),
    )
    assert (values["check_from"], values["check_to"]) == ("-95", "-50")
    assert values["check_change"] == "-5.4 µm"  # from 3.4 to -2.0


def test_what_differs_by_axis_stands_in_a_table_and_the_rest_once() -> None:
    definition = DEFINITIONS["siemens-840d-sl"]
    axes = [
        Axis(name=name, kind=AxisKind.LINEAR, travel=(0.0, 100.0), address=f"AX{n}")
        for n, name in enumerate("XY", start=1)
    ]
    tables = [
        table(axis.address, [0.0, 50.0, 100.0][:count], [0.0, 0.001, 0.002][:count])
        for axis, count in zip(axes, (3, 2), strict=True)
    ]
    values = [
        card_values(control_format(definition, {}), axis, new, AxisFacts(), new.positions)
        for axis, new in zip(axes, tables, strict=True)
    ]
    steps = {
        step.title: step
        for step in card_steps_of_all(definition, list(zip(axes, values, strict=True)))
    }
    reserve = steps["Reserve the points"]
    assert "$MA_MM_ENC_COMP_MAX_POINTS[0,‹address›] must be at least ‹points›" in reserve.text
    assert (reserve.heads, reserve.rows) == (
        ("axis", "address", "points"),
        (("X", "AX1", "3"), ("Y", "AX2", "2")),
    )
    assert steps["Read back"].rows == ()
    gantry = steps["Gantry"]  # whole sentences stay sentences
    assert (len(gantry.text.splitlines()), gantry.rows) == (2, ())
    (alone,) = [
        step
        for step in card_steps(definition, axes[0], values[0])
        if step.title == "Reserve the points"
    ]
    assert "$MA_MM_ENC_COMP_MAX_POINTS[0,AX1] must be at least 3" in alone.text
    assert alone.rows == ()


class Headings(HTMLParser):
    """Which heading, by the block that is kept together in print, stands before which table."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.loose: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in {"meta", "rect", "line"}:
            return
        self.open.append(dict(attrs).get("class") or "")
        if tag == "h3" and "keep" not in self.open:
            self.loose.append(str(self.getpos()))

    def handle_endtag(self, tag: str) -> None:
        if tag not in {"meta", "rect", "line"}:
            self.open.pop()


def test_in_print_the_tables_of_an_axis_stay_with_their_headings() -> None:
    """And no table of an axis lies in a box that cuts what does not fit; seen with a browser at
    1000 to 1600 px.
    """
    page = card_html({**sample_card(), "files": [], "proven": ""}).decode()
    style = page[page.index("<style>") : page.index("</style>")]
    assert re.search(r"\.keep \{[^}]*break-inside: avoid", style)
    assert style.count("{") == style.count("}")
    body = page[page.index('<section class="keep">') : page.index("</section>")]
    assert "<h3>Check positions</h3>" in body
    assert 'class="scroll"' not in body
    parser = Headings()
    parser.feed(body)
    assert parser.loose == []


def test_no_number_on_the_card_has_an_exponent() -> None:
    """A control takes no 7.6e-05 (SINUMERIK: digits and a point)."""
    axis = axis_of("AX1")
    new = table("AX1", [0.0, 50.0], [0.0, 0.001], backlash=0.000076)
    assert (
        card_values(control_format(SIEMENS, {}), axis, new, AxisFacts(), new.positions)["backlash"]
        == "0.000076"
    )


@pytest.mark.parametrize("cec", ["", "$MA_CEC_ENABLE[AX1]=1\nN41300 $SN_CEC_TABLE_ENABLE[9]=1\n"])
def test_values_are_loaded_before_the_switches_that_protect_them(cec: str) -> None:
    """SINUMERIK takes no value of a table that MD32700 (SD41300, MD32710) has on: machine data that
    say 1 are loaded behind.
    """
    given = files(
        MD__INI=f"N32700 $MA_ENC_COMP_ENABLE[0,AX1]=1\n{cec}M17\n",
        NC_CEC__INI="$AN_CEC[9,0]=0.001\nM17\n",
        AX_EEC__INI="$AA_ENC_COMP[0,0,AX1]=0.001\nM17\n",
    )
    assert loading_order(SIEMENS, given) == [
        "NC_CEC.INI",
        "AX_EEC.INI",
        "MD.INI",
    ]


def test_a_whole_archive_goes_before_the_files_that_lie_over_it() -> None:
    """Loaded behind them it would bring its own old values back."""
    on = b"$MA_ENC_COMP_ENABLE[0,AX1]=1\n"
    given = [
        ControlFile("X1_EEC.INI", b"$AA_ENC_COMP[0,0,AX1]=0\n"),
        ControlFile("A.ARC", container([("\\_NC_ACT.DIR\\", "MD.INI", on)])),
        ControlFile("X1_MD.INI", on),
    ]
    assert loading_order(SIEMENS, given) == ["A.ARC", "X1_EEC.INI", "X1_MD.INI"]


#: Words that leave a sign open.
DOUBT = re.compile(r"not confirmed|not proven|No (?:page|manual)[^.]* sign")


@pytest.mark.parametrize("name", DEFINITIONS)
@pytest.mark.parametrize("variant", ["text", "two_curves"])
def test_no_card_calls_a_sign_confirmed_and_not_confirmed(name: str, variant: str) -> None:
    """The step that checks the sign of a table is as sure as its evidence says, and no other step
    says the opposite; the sign of a display is another thing than that of its table.
    """
    steps = {rule.title: rule for rule in DEFINITIONS[name].card}
    words = {title: getattr(rule, variant) for title, rule in steps.items()}
    checks = [title for title in steps if title.startswith("Check the sign")]
    doubted = {title for title in checks if DOUBT.search(words[title])}
    assert doubted == {title for title in checks if steps[title].evidence.state != "confirmed"}
    whole = " ".join(words.values())
    assert not ("sign of this table is confirmed" in whole and doubted)
    assert doubted or not re.search(r"sign of (?:a|the|this) table is not confirmed", whole)


@pytest.fixture(scope="module")
def sinumerik_card(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The card of an axis with an old table, as data."""
    given: list[dict[str, Any]] = []

    def kept(card: dict[str, Any]) -> bytes:
        given.append(card)
        return b""

    out = tmp_path_factory.mktemp("sinumerik") / "out"
    job = PROJECT / "examples" / "sinumerik-old-table" / "job.yaml"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reporting_card, "card_html", kept)
        assert compwright(["run", str(job), "--out", str(out)]) == 0
    (card,) = given
    return card


def numbers(text: str) -> Counter[str]:
    """All numbers of a text, with a decimal point."""
    return Counter(re.findall(r"\d+(?:\.\d+)?", re.sub(r"(?<=\d),(?=\d)", ".", text)))


@pytest.mark.parametrize("language", ["de", "fr", "ru"])
def test_a_card_in_another_language_has_the_same_numbers_and_names(
    sinumerik_card: dict[str, Any], language: str
) -> None:
    english = card_markdown(sinumerik_card)
    other = card_markdown({**sinumerik_card, "language": language})
    assert numbers(other) == numbers(english)
    names = re.compile(r"\$[\w\\\[\],]+|[\w/]+\.(?:INI|csv|TXT)|`[^`]+`")
    assert Counter(names.findall(other)) == Counter(names.findall(english))
    assert not re.search(r"(?<!\w)(?:the|is|of|and) (?=[a-z])", other)


def test_steps_of_a_definition_of_ones_own_stay_english_and_the_card_says_so(
    sinumerik_card: dict[str, Any],
) -> None:
    own = {"title": ControlText("Wait", {}), "text": ControlText("Wait a while.", {})}
    card = {**sinumerik_card, "language": "de", "steps": [*sinumerik_card["steps"], own]}
    assert "Schritte der eigenen Definition haben keine Übersetzung" in card_markdown(card)
    translated = card_markdown({**sinumerik_card, "language": "de"})
    assert "keine Übersetzung" not in translated
