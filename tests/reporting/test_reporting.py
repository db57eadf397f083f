"""Plots, reports and cards: what stands in the document stands on the paper, whole, escaped, and
the same every time.
"""

from __future__ import annotations

import copy
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import UsageError
from compwright.reporting import plots
from compwright.reporting.card import card_html, card_markdown
from compwright.reporting.numbers import MISSING, decimals_of, number, plain
from compwright.reporting.panels import known_format
from compwright.reporting.plots import evaluation_plot
from compwright.reporting.run_report import run_report
from compwright.reporting.verify_report import verify_report
from frames import frame
from places import PROJECT, needs_shared
from reporting_samples import (
    made_up,
    positioning,
    printed_table,
    quantiles,
    run_view,
    sample_card,
    verify_view,
)

pytestmark = pytest.mark.real_pages

HOSTILE = "<script>alert('x')</script> & \"$\\frac{1}{0}$\" \x00\x0b\ud800\uffff\nnext"
EXACT = 1e-9  # µm: a number that only passes through


# --- reading a page
# --------------------------------------------------------------------------------------------------


def tree(page: bytes) -> ET.Element:
    """Parse as XML: stricter than any browser, every tag closed and every attribute quoted."""
    return ET.fromstring(page.decode("utf-8"))  # noqa: S314  our own page


def text(element: ET.Element) -> str:
    return " ".join("".join(element.itertext()).split())


def tables(page: bytes) -> Iterator[tuple[list[str], list[list[str]]]]:
    for table in tree(page).iter("table"):
        head = [text(cell) for cell in table.findall("thead/tr/th")]
        yield head, [[text(cell) for cell in row] for row in table.findall("tbody/tr")]


def table_with(page: bytes, *words: str) -> tuple[list[str], list[list[str]]]:
    """The first table in whose head all ``words`` occur."""
    return next(
        (head, rows)
        for head, rows in tables(page)
        if all(any(word in cell for cell in head) for word in words)
    )


def value(cell: str) -> float:
    return float(cell.replace("−", "-"))


def assert_self_contained(page: bytes, files: tuple[str, ...] = ()) -> None:
    assert b"http:" not in page
    assert b"https:" not in page
    assert b"@import" not in page
    root = tree(page)
    names = [element.tag for element in root.iter()]
    assert not {"script", "link", "img", "iframe", "object", "base", "form"} & set(names)
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    assert len(ids) == len(set(ids)), "an id stands twice"
    for element in root.iter():
        assert not any(name.startswith("on") or name == "src" for name in element.keys()), (  # noqa: SIM118
            element.attrib
        )
        target = element.get("href")
        if target is not None:
            assert target[1:] in ids if target.startswith("#") else target in files, target
    for reference in re.findall(rb"url\(#([^)]*)\)", page):
        assert reference.decode() in ids


# --- numbers
# --------------------------------------------------------------------------------------------------


def test_numbers_have_a_true_minus_sign_no_minus_zero_and_a_dash_where_there_is_none() -> None:
    assert number(-1.534) == "−1.53"
    assert number(-0.004) == "0.00"
    assert number(-0.006) == "−0.01"
    assert number(12) == "12.00"
    assert number(3.14159, 0) == "3"
    assert [number(nothing) for nothing in (None, float("nan"), float("inf"), "7", True)] == [
        MISSING
    ] * 5
    assert plain(50.0) == "50"
    assert plain(-0.0) == "0"
    assert plain(-2) == "−2"


@given(st.floats(-1e6, 1e6), st.integers(0, 4))
def test_a_number_reads_back_to_its_last_digit(given_value: float, decimals: int) -> None:
    assert (
        abs(value(number(given_value, decimals)) - given_value) <= 0.5000001 * 10.0**-decimals
    )  # half a last digit


def test_a_column_gets_the_decimals_that_it_needs() -> None:
    assert decimals_of([0.0, 250.0, -500.0]) == 0
    assert decimals_of([6.711, 353.8]) == 3
    assert decimals_of([1.0 / 3.0]) == 4
    assert decimals_of([None, float("nan")]) == 0
    assert decimals_of([17.000000000002]) == 0  # from mm to µm


# --- plots
# --------------------------------------------------------------------------------------------------


@pytest.fixture
def drawn(monkeypatch: pytest.MonkeyPatch) -> Callable[[], Any]:
    """The figure that was drawn last, instead of its bytes."""
    figures: list[Any] = []

    def keep(figure: Any, _kind: str) -> bytes:
        figures.append(figure)
        return b""

    monkeypatch.setattr(plots, "render", keep)
    return lambda: figures[-1]


def lines(panel: Any, label: str) -> Any:
    return next(line for line in panel.get_lines() if line.get_label() == label)


def band_at(panel: Any, label: str, position: float) -> tuple[float, float]:
    """Lower and upper limit of a filled band at ``position``."""
    band = next(entry for entry in panel.collections if entry.get_label() == label)
    heights = [y for path in band.get_paths() for x, y in path.vertices if abs(x - position) < 1e-6]
    return min(heights), max(heights)


@needs_shared
@pytest.mark.parametrize(
    ("year", "label", "position", "low", "high", "tolerance"),
    # printed rows "mean - 2s" and "mean + 2s" of table 2, rounded to 0.1 µm: half a digit, and half
    # a digit of the readings
    [
        (1997, "mean ± 2 s (−)", 6.711, 1.6, 2.9, 0.1),
        (1997, "mean ± 2 s (+)", 6.711, -2.3, -0.9, 0.1),
        (1997, "mean ± 2 s (−)", 1750.920, -1.7, 0.8, 0.1),
        (1997, "mean ± 2 s (+)", 1234.304, -5.5, -3.0, 0.1),
        # printed limits of the 1988 table with k = 3 (expected.md), to 0.01 µm
        (1988, "mean ± 3 s (+)", 150.71, -1.17, 3.01, 0.01),
    ],
)
def test_the_bands_are_the_limits_that_the_standard_prints(
    drawn: Callable[[], Any],
    year: int,
    label: str,
    position: float,
    low: float,
    high: float,
    tolerance: float,
) -> None:
    evaluation_plot({"results": [printed_table(year)]})
    found = band_at(drawn().axes[0], label, position)
    assert found[0] == pytest.approx(low, abs=tolerance)
    assert found[1] == pytest.approx(high, abs=tolerance)


@needs_shared
def test_means_and_readings_of_each_direction_stand_at_their_targets(
    drawn: Callable[[], Any],
) -> None:
    evaluation_plot({"results": [printed_table(1997)]})
    panel = drawn().axes[0]
    positive, negative = lines(panel, "mean (+)"), lines(panel, "mean (−)")
    assert positive.get_xdata()[0] == 6.711
    # printed means of the first and last target, to 0.1 µm
    assert [positive.get_ydata()[i] for i in (0, -1)] == pytest.approx(
        [-1.6, -4.0], abs=0.05 + EXACT
    )
    assert [negative.get_ydata()[i] for i in (0, -1)] == pytest.approx(
        [2.3, -0.5], abs=0.05 + EXACT
    )
    # the mean bidirectional deviation is half the sum of both (ISO 230-2:1997, 2.11)
    both = lines(panel, "mean (±)").get_ydata()
    assert [both[i] for i in (0, -1)] == pytest.approx([0.35, -2.25], abs=0.05 + EXACT)
    assert (positive.get_marker(), positive.get_linestyle()) == ("^", "-")
    assert (negative.get_marker(), negative.get_linestyle()) == ("v", "--")
    readings = lines(panel, "single readings (+)")
    assert len(readings.get_xdata()) == 55
    assert list(readings.get_ydata()[:5]) == [-1.2, -1.7, -1.9, -1.3, -1.9]
    assert "A 9.60   E 7.70   R 6.50   B 4.10 µm" in panel.get_title(loc="right")


def test_one_direction_single_runs_and_missing_readings_draw_only_what_there_is(
    drawn: Callable[[], Any],
) -> None:
    one_way = run_view()["evaluation"]["results"][1]
    evaluation_plot({"results": [one_way]})
    panel = drawn().axes[0]
    labels = {line.get_label() for line in panel.get_lines()}
    assert {"mean (+)", "single readings (+)"} <= labels
    assert "mean (±)" not in labels
    assert not any("(−)" in label for label in labels)
    assert panel.get_ylabel() == "Deviation in arcsec"
    assert panel.get_xlabel() == "Position in deg"
    assert panel.get_title(loc="right") == "A+ 9.13   E+ 7.52   R+ 3.24 arcsec"
    single = positioning(
        [0.0, 900.0, 3000.0],
        [[1.0], [2.0], [8.0]],
        [[0.0], [None], [7.0]],
        {"A": None, "E": 8.0, "B": 1.0},
    )
    evaluation_plot({"results": [single]})
    assert not drawn().axes[0].collections  # no s, no band
    assert drawn().axes[0].get_title(loc="right") == "E 8.00   B 1.00 µm"


def test_a_flat_curve_is_not_blown_up(drawn: Callable[[], Any]) -> None:
    evaluation_plot(
        {"results": [positioning([0.0, 100.0], [[0.0, 0.001]] * 2, [[0.0, 0.001]] * 2, {"A": 0.0})]}
    )
    low, high = drawn().axes[0].get_ylim()
    assert high - low >= 0.2 - EXACT


@pytest.mark.parametrize(
    ("kind", "magic"), [("svg", b"<?xml"), ("png", b"\x89PNG\r\n"), ("pdf", b"%PDF-")]
)
def test_every_format_is_written_and_the_same_every_time(kind: str, magic: bytes) -> None:
    document = {
        "results": [
            made_up(),
            {"kind": "circular"},
            made_up(standard="vdi3441", parameters={"P": 40.0, "A": None, "E": None}),
        ]
    }
    first = evaluation_plot(document, format=kind)
    assert first.startswith(magic)
    assert first == evaluation_plot(copy.deepcopy(document), format=kind)


def test_names_of_the_user_cannot_break_a_figure() -> None:
    svg = evaluation_plot({"results": [made_up(name="$\\frac{$ 中\n<b>", axis="C$_1$" * 20)]})
    ET.fromstring(svg.decode())  # noqa: S314  our own file


def test_any_other_format_of_a_figure_is_refused_with_those_there_are() -> None:
    assert [known_format(ending) for ending in (".svg", ".PNG", "pdf")] == ["svg", "png", "pdf"]
    for ending in (".jpg", "", "bmp"):
        with pytest.raises(UsageError, match=r"unknown ending.*\.svg, \.png or \.pdf"):
            evaluation_plot({"results": [made_up()]}, format=ending)


@pytest.mark.parametrize("results", [[], [{"kind": "circular"}]])
def test_nothing_to_plot_is_said(results: list[dict[str, Any]]) -> None:
    with pytest.raises(UsageError, match="to plot"):
        evaluation_plot({"results": results})


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pages with an empty figure instead of each plot, where a test is about words and numbers."""
    frame(monkeypatch, real=False, brief=False)


words_only = pytest.mark.usefixtures("quick")


# --- the report of run
# --------------------------------------------------------------------------------------------------


def test_the_report_is_whole_well_formed_and_the_same_every_time() -> None:
    page = run_report(run_view())
    assert_self_contained(page, tuple(run_view()["files"]))
    assert page == run_report(run_view())
    assert b"xmlns" not in page  # HTML needs none, and they would be addresses
    assert text(next(tree(page).iter("title"))) == "VMC 850, axes X and C"


@words_only
def test_the_report_states_the_numbers_of_the_documents() -> None:
    view = run_view()
    page = run_report(view)
    axis = view["prediction"]["axes"]["X"]
    head, rows = table_with(
        page, "Parameter", "Predicted, same targets", ("Predicted, new targets")
    )
    titles = [
        "Before µm; ± U, k = 2",
        "Predicted, same targets µm; median, 5–95 %",
        "Predicted, new targets µm; median, 5–95 %",
    ]
    assert head == ["Parameter ISO 230-2:2014", *titles]
    found = {row[0]: row for row in rows}
    for key, name in (("A", "A"), ("A_positive", "A+"), ("B_mean", "mean B"), ("M", "M")):
        row = found[name]
        assert value(row[2]) == axis["before"][key]
        for column, source in ((4, axis["predicted"]), (6, axis["predicted_new_targets"])):
            assert value(row[column]) == pytest.approx(
                source[key]["median"], abs=0.005 + EXACT
            )  # two decimals are shown
            low, high = row[column + 1].split(" to ")
            assert value(low) == pytest.approx(source[key]["p05"], abs=0.005 + EXACT)
            assert value(high) == pytest.approx(source[key]["p95"], abs=0.005 + EXACT)
    assert found["A"][3] == "± 1.90"
    assert found["M"][3] == ""


@words_only
def test_the_table_in_numbers_is_the_table() -> None:
    view = run_view()
    table = view["prediction"]["axes"]["X"]["table"]
    head, rows = table_with(run_report(view), "Correction +", "Correction −")
    assert head == ["Position mm", "Correction + µm", "Correction − µm"]
    expected = zip(
        table["positions"], table["correction_positive"], table["correction_negative"], strict=True
    )
    assert [tuple(map(value, row)) for row in rows] == list(expected)


@words_only
def test_a_long_table_stands_in_columns_and_loses_no_point() -> None:
    view = run_view()
    nodes = [float(node) for node in range(131)]
    view["prediction"]["axes"]["X"]["table"] |= {
        "positions": nodes,
        "correction_positive": nodes,
        "correction_negative": nodes,
    }
    found = [
        rows for head, rows in tables(run_report(view)) if head and head[-1] == "Correction − µm"
    ]
    assert [value(row[0]) for rows in found for row in rows] == nodes
    assert len(found) == 3


@words_only
def test_single_readings_stand_under_their_run_and_direction() -> None:
    view = run_view()
    target = view["evaluation"]["results"][0]["targets"][2]
    head, rows = table_with(run_report(view), "+1", "−5")
    row = next(row for row in rows if value(row[0]) == target["position"])
    readings = dict(zip(head, row, strict=True))
    assert value(readings["+4 µm"]) == target["deviations_positive"][3]
    assert value(readings["−2 µm"]) == target["deviations_negative"][1]
    head, rows = table_with(run_report(view), "mean +", "s −")
    row = next(row for row in rows if value(row[0]) == target["position"])
    statistics = dict(zip((cell.removesuffix(" µm") for cell in head), row, strict=True))
    for title, key in {
        "mean +": "mean_positive",
        "mean −": "mean_negative",
        "s −": "s_negative",
        "B": "reversal",
        "R +": "R_positive",
    }.items():
        assert value(statistics[title]) == pytest.approx(
            target[key], abs=0.005 + EXACT
        )  # two decimals are shown
    _, rotary = next(
        (head, rows)
        for head, rows in tables(run_report(view))
        if head == ["Position deg", "+1 arcsec", "+2 arcsec"]
    )
    assert rotary[1] == ["45", "2.0", MISSING]


@words_only
def test_the_verdict_stands_first_with_each_limit_and_its_decision() -> None:
    _, rows = table_with(run_report(run_view()), "Limit", "Decision")
    shown = [(row[1], row[2], row[3], row[4], row[5], row[6]) for row in rows]
    assert shown[0] == ("A", "31.42 µm", "4.12 µm", "3.47 to 5.03", "8.00 µm", "✓ accept")
    assert shown[1][5] == "? undecided"
    assert shown[2] == ("B", "6.84 µm", "0.82 µm", "0.41 to 1.31", "0.30 µm", "✗ reject")
    assert shown[3] == ("A+", "9.13 arcsec", "4.10 arcsec", "3.30 to 5.20", MISSING, "no limit")


def verdict_of(page: bytes) -> str:
    section = next(
        element for element in tree(page).iter("section") if "verdict" in str(element.get("class"))
    )
    return f"{str(section.get('class')).split()[-1]}: {text(section)}"


@words_only
@pytest.mark.parametrize(
    ("decisions", "headline"),
    [
        (["accept", "reject", "undecided"], "bad: At least one limit is predicted to be missed"),
        (["accept", "undecided"], "open: At least one limit may or may not be met"),
        (["accept", "accept"], "good: All limits are predicted to be met"),
        ([], "open: Predicted result; no limits were given"),
    ],
)
def test_the_headline_is_that_of_the_worst_decision(decisions: list[str], headline: str) -> None:
    view = run_view()
    limits = zip(("A", "E", "R"), decisions, strict=False)
    view["prediction"]["axes"]["X"]["accept"] = {
        key: {"limit": 5.0, "decision": decision} for key, decision in limits
    }
    assert verdict_of(run_report(view)).startswith(headline)


@words_only
def test_without_tables_the_report_says_why() -> None:
    view = run_view()
    view["no_tables"] = "The job does not say what is active in the control."
    page = run_report(view)
    assert verdict_of(page).startswith("bad: No table was written The job does not say")
    assert "No table was written, so the prediction is for a test without a table" in text(
        tree(page)
    )
    refused = run_view()
    refused["axes"]["X"]["refused"] = "it would make the axis worse"
    assert verdict_of(run_report(refused)).startswith(
        "bad: No table was written for axis X Axis X: it would make the axis worse."
    )


@words_only
def test_limits_about_another_test_are_shown_with_that_test() -> None:
    view = run_view()
    axis = view["prediction"]["axes"]["X"]
    axis["tests"].append(
        {"name": "x_long", "before": {"E": 50.0}, "predicted": {"E": quantiles(7.0, 6.0, 8.0)}}
    )
    axis["accept"] = {"E": {"limit": 9.0, "decision": "accept", "test": "x_long"}}
    page = run_report(view)
    _, rows = table_with(page, "Limit", "Decision")
    assert rows[0][1:7] == ["E", "50.00 µm", "7.00 µm", "6.00 to 8.00", "9.00 µm", "✓ accept"]
    assert "Test x_long" in [text(heading) for heading in tree(page).iter("h3")]


@words_only
def test_the_state_that_was_taken_is_told() -> None:
    def section(state: Any) -> str:
        view = run_view()
        view["axes"]["X"]["state"] = state
        return text(tree(run_report(view)))

    assert "None: nothing was active in the control" in section("none")
    assert "As in CNC-PARA.TXT, PITCH.TXT; the new table is the total" in section(
        ["CNC-PARA.TXT", "PITCH.TXT"]
    )
    assert (
        section(None).count(
            "If the present contents of the control are unknown, no table is written"
        )
        == 2
    )  # axes X and C


@words_only
def test_unconfirmed_facts_come_first_and_are_marked() -> None:
    _, rows = table_with(run_report(run_view()), "Fact", "Evidence")
    assert [row[0] for row in rows] == [
        "sign of a pitch error value",
        "detection unit",
        "compensation is active",
    ]
    assert rows[0][2] == "! unconfirmed B-64490EN 5.2 does not say"
    assert not any("!" in row[2] for row in rows[1:])


@words_only
def test_findings_stand_once_with_code_and_severity() -> None:
    view = run_view()
    view["findings"] += view["axes"]["X"]["findings"]
    view["evaluation"]["results"][0]["findings"] = [view["axes"]["X"]["findings"][1]]
    view["evaluation"]["errors"] = [{"file": "runs/y.csv", "message": "line 3: not a number"}]
    page = run_report(view)
    found = [
        text(item)
        for group in tree(page).iter("ul")
        if group.get("class") == "findings"
        for item in group
    ]
    assert found == [
        "! warning The readings drift by 1.2 µm over the five traverses. CW-T005",
        "info No screw pitch was given: a periodic error is not estimated. CW-E003",
        "✗ error runs/y.csv: line 3: not a number not read",
        "! warning The state of axis C was not said. CW-S001",
    ]


@words_only
def test_provenance_and_written_files_are_listed() -> None:
    page = run_report(run_view())
    _, rows = table_with(page, "SHA-256")
    assert rows == [["runs/x_before.csv", "a3f1" * 16], ["runs/c_before.csv", "a3f1" * 16]]
    links = [element.get("href") for element in tree(page).iter("a")]
    assert links.count("card/card.html") == 2  # the navigation and the list of files


def everywhere(document: Any, text_value: str) -> Any:
    """The document with every text that is free for the user replaced."""
    free = {
        "machine",
        "name",
        "message",
        "fact",
        "value",
        "evidence",
        "file",
        "cause",
        "mode_reason",
        "title",
        "quantity",
        "text",
    }
    if isinstance(document, dict):
        return {
            key: (
                text_value
                if key in free and isinstance(item, str)
                else everywhere(item, text_value)
            )
            for key, item in document.items()
        }
    return (
        [everywhere(item, text_value) for item in document]
        if isinstance(document, list)
        else document
    )


def test_hostile_text_stays_text() -> None:
    view = everywhere(run_view(), HOSTILE)
    view["machine"] = {HOSTILE: HOSTILE}
    view["files"] = ["javascript:alert(1)//card.html", "a b<c>.txt"]
    view["axes"]["X"]["state"] = [HOSTILE]
    page = run_report(view)
    assert_self_contained(page, ("javascript%3Aalert%281%29//card.html", "a%20b%3Cc%3E.txt"))
    assert "<script>alert('x')</script> & \"" in text(tree(page))
    after = everywhere(verify_view(), HOSTILE)
    after["machine"] = {HOSTILE: HOSTILE}
    assert_self_contained(verify_report(after))
    card = everywhere(sample_card(), HOSTILE)
    assert_self_contained(
        card_html(
            {
                **card,
                "files": [HOSTILE],
                "restore": [HOSTILE],
                "proven": HOSTILE,
                "machine": {HOSTILE: HOSTILE},
            }
        )
    )


def test_a_report_without_predictions_estimates_or_results_still_stands() -> None:
    bare = run_view()
    for axis in bare["prediction"]["axes"].values():
        axis.update(
            dict.fromkeys(
                (
                    "tests",
                    "before",
                    "predicted",
                    "predicted_new_targets",
                    "table",
                    "limits",
                    "accept",
                    "quantum",
                )
            )
        )
    for axis in bare["axes"].values():
        axis.update(
            dict.fromkeys(
                (
                    "estimate",
                    "wanted",
                    "certificate",
                    "predicted_targets",
                    "findings",
                    "mode",
                    "mode_reason",
                )
            )
        )
    assert_self_contained(run_report(bare), tuple(bare["files"]))
    bare["evaluation"] = {"results": [], "errors": []}
    bare["prediction"] = {}
    assert_self_contained(
        run_report({**bare, "files": [], "assumed": [], "findings": None, "machine": None})
    )


# --- the report of verify
# --------------------------------------------------------------------------------------------------


@words_only
def test_the_verification_shows_before_predicted_and_after() -> None:
    view = verify_view()
    page = verify_report(view)
    assert_self_contained(page)
    assert page == verify_report(verify_view())
    assert verdict_of(page).startswith("open: Undecided: the tests do not tell")
    _, rows = table_with(page, "Loading", "After")
    # axis, loading, symbol, before, median, range, after, limit, unit, decision, bar
    assert rows[0][:10] == [
        "X",
        "✓ loaded",
        "A",
        "31.42",
        "4.12",
        "3.47 to 5.03",
        "4.43",
        "8.00",
        "µm",
        "✓ accept",
    ]
    _, parameters = table_with(page, "Parameter", "After")
    found = {row[0]: row for row in parameters}
    assert [value(found["E"][column]) for column in (2, 4, 6)] == [28.77, 1.93, 2.21]
    assert "Axis X, x_before, before" in [text(heading) for heading in tree(page).iter("h3")]
    _, decisions = table_with(page, "Limit on")
    assert decisions[1] == ["E", "2.21", "1.70", "2.00", "? undecided"]
    view["verification"]["axes"]["X"]["within_prediction"] = {"A": True, "E": False}
    _, parameters = table_with(verify_report(view), "Parameter", "5–95 % of the prediction")
    assert {row[0]: row[-1] for row in parameters if row[0] in {"A", "E", "R"}} == {
        "A": "within",
        "E": "outside",
        "R": "",
    }
    words = text(tree(page))
    assert "cannot be distinguished from another temperature" in words
    assert "runs/broken.csv: line 3: not a number" in words


@words_only
@pytest.mark.parametrize(
    ("loading", "shown"),
    [
        ({"verdict": "not_active", "message": "Nothing changed."}, "✗ not active Nothing changed."),
        ({"verdict": "scaled", "factor": 2.0, "message": "Twice."}, "✗ scaled Twice. factor 2"),
        (
            {"verdict": "shifted", "shift_nodes": -1, "message": "Moved."},
            "✗ shifted Moved. shift in points −1",
        ),
        ({"verdict": "wrong_axis", "of": "Y", "message": "Y."}, "✗ wrong axis Y. table of axis Y"),
        ({"verdict": "undecided", "message": "Too little."}, "? undecided Too little."),
    ],
)
def test_a_loading_fault_is_named(loading: dict[str, Any], shown: str) -> None:
    view = verify_view()
    view["verification"]["axes"]["X"]["loading"] = loading
    view["verification"] |= {"verdict": "bad", "headline": "Bad: see the axes below"}
    page = verify_report(view)
    assert shown in text(tree(page))
    assert verdict_of(page).startswith("bad: Bad")


def test_a_verification_without_the_test_before_shows_the_one_after() -> None:
    view = verify_view()
    view["evaluation_before"] = None
    view["axes"] = {}
    view["verification"]["axes"]["X"] |= {"before": None, "predicted": None, "accept": None}
    assert_self_contained(verify_report(view))


# --- the card
# --------------------------------------------------------------------------------------------------


def test_the_card_has_every_number_and_a_box_for_every_step() -> None:
    page = card_html(sample_card())
    assert_self_contained(page)
    assert page == card_html(sample_card())
    _, rows = table_with(page, "Old", "New")
    assert rows[2] == ["", "3624 interval, mm", MISSING, "50"]
    assert rows[3][3] == "-2"  # typed into a control: a plain minus sign
    head, rows = table_with(page, "Expected deviation")
    assert head[:3] == ["Position mm", "Approach", "Control adds µm"]
    assert rows[1] == ["−50.5", "−", "−3", "", "−0.62", "8 µm either way", ""]
    head, rows = table_with(page, "Moves by")
    assert head == ["", "Name", "Position mm", "Moves by µm"]
    assert rows == [["", "tool change", "−20.0", "+1.20"]]
    ticks = [element for element in tree(page).iter("span") if element.get("class") == "tick"]
    # 1 unconfirmed, 4 steps and the 2 lines or rows of two of them, 1 number of points, 4 values, 1
    # fixed position, 2 to go back
    assert len(ticks) == 17
    words = text(tree(page))
    assert "2. Load the pitch error file ! unconfirmed" in words
    assert "X: 3620 = 17, 3624 = 50." in words
    assert "Y: 3620 = 40, 3624 = 25." in words
    assert "‹" not in words
    assert "at least 18 points" in words
    changes = {"entries": [{"entry": "N1851", "old": "4", "new": "-2"}], "untouched": 3}
    _, rows = table_with(card_html({**sample_card(), "changes": changes}), "Entry")
    assert rows == [["N1851", "4", "-2"]]


def test_the_card_as_text_says_the_same() -> None:
    card = sample_card()
    lines_ = card_markdown(card).splitlines()
    assert lines_[0] == "# Commissioning card: VMC 850"
    heads = [re.split(r" *\| *", line) for line in lines_ if line.startswith("| Position")]
    assert [head[1:4] for head in heads] == [["Position (mm)", "Approach", "Control adds (µm)"]]
    assert "- [ ] **Load the pitch error file** **(unconfirmed)**" in lines_
    assert any(
        re.fullmatch(r"\| −50\.5 +\| − +\| −3 +\| +\| −0\.62 +\| 8 µm either way +\| +\|", line)
        for line in lines_
    )
    assert "  - [ ] Y: 3620 = 40, 3624 = 25." in lines_
    assert any(
        re.fullmatch(r"\| \[ \] \| 1851 backlash, detection units +\| 4 +\| -2 +\|", line)
        for line in lines_
    )
    assert (
        sum("[ ]" in line for line in lines_) == 17
    )  # 1 + 4 + 2 + 2 + 1 + 4 + 2 as on the page without the fixed position, and the last line
    assert any("instrument set to zero" in line for line in lines_) is False
    card["axes"][0]["quick_check"][0]["expected"] = 0.0
    assert (
        "Measure in this order, with the instrument set to zero at the first row."
        in card_markdown(card).splitlines()
    )


def test_markup_in_names_stays_text_in_markdown() -> None:
    card = sample_card()
    card["axes"][0]["rows"][0]["quantity"] = "a|b *c* <img> `d`\n# e [x](y)"
    card["steps"][0]["text"] = "# no heading\n- no list"
    row = next(line for line in card_markdown(card).splitlines() if "img" in line)
    assert r"a\|b \*c\* &lt;img> \`d\` # e \[x\](y)" in row
    assert len(re.findall(r"(?<!\\)\|", row)) == 5
    assert "  - [ ] # no heading" in card_markdown(card).splitlines()
    assert "  - [ ] - no list" in card_markdown(card).splitlines()
    card["steps"][0]["text"] = "# no heading"
    assert "  \\# no heading" in card_markdown(card).splitlines()


@settings(max_examples=25, deadline=None)
@given(st.text(st.characters(), max_size=30))
def test_any_text_gives_a_well_formed_page_and_whole_tables(words: str) -> None:
    card = everywhere(sample_card(), words)
    assert_self_contained(card_html(card))
    rows = [line for line in card_markdown(card).splitlines() if line.startswith("|")]
    assert all(line.endswith("|") for line in rows)


def test_an_empty_card_is_a_card() -> None:
    assert_self_contained(card_html({}))
    assert card_markdown({"axes": [{"name": "X", "address": "1", "unit": "um"}]}).startswith(
        "# Commissioning card\n"
    )


# --- the extra
# --------------------------------------------------------------------------------------------------


def test_without_the_extra_the_tool_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("matplotlib", "jinja2"):
        monkeypatch.setitem(
            sys.modules, module, None
        )  # what importing a package that is not installed comes to
    calls: list[Callable[[], bytes]] = [
        lambda: evaluation_plot({"results": [made_up()]}),
        lambda: run_report(run_view()),
        lambda: verify_report(verify_view()),
        lambda: card_html(sample_card()),
    ]
    for call in calls:
        with pytest.raises(UsageError, match=r"pip install jinja2 matplotlib$") as caught:
            call()
        assert caught.value.exit_code == 2
    assert card_markdown(sample_card())  # needs no extra


def test_nothing_heavy_is_loaded_before_it_is_asked_for() -> None:
    code = (
        "import sys, compwright.reporting.run_report, compwright.reporting.card\n"
        "heavy = {'matplotlib', 'jinja2', 'numpy', 'scipy'} & set(sys.modules)\n"
        "sys.exit(str(heavy) if heavy else 0)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={"PYTHONPATH": str(PROJECT / "src")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_templates_ship_with_the_package() -> None:
    import compwright.reporting as package

    folder = Path(str(package.__file__)).parent / "templates"
    assert {"base.html", "card.html", "parts.html", "run.html", "style.css", "verify.html"} <= {
        path.name for path in folder.iterdir()
    }
