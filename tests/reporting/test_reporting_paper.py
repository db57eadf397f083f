"""A report on paper: every item of the standards, the extremes behind the parameters, the budget of
the uncertainty; each number that of the JSON.
"""

from __future__ import annotations

import base64
import json
import math
import re
import struct
import textwrap
import zlib
from collections.abc import Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.documents.evaluation import result_document
from compwright.evaluation.standards import STANDARDS, evaluate
from compwright.evaluation.uncertainty import contributions, length_uncertainty
from compwright.foundations.errors import InputError
from compwright.foundations.session import Session
from compwright.instruments.reading import read_tests
from compwright.jobs.reading import read_job
from compwright.records.axis import AxisKind
from compwright.records.conditions import Thermal, UncertaintyBudget
from compwright.records.job import Job, Logo, ReportHead
from compwright.records.positioning import PositioningTest
from compwright.reporting.axis_figures import result_figure
from compwright.reporting.charts import result_chart
from compwright.reporting.circles import circle_blocks
from compwright.reporting.evaluation_report import evaluation_report
from compwright.reporting.page import css_string
from compwright.reporting.paper import conformity, head
from compwright.reporting.report_items import BASIS, ITEMS, READ_EDITION, items_of
from compwright.reporting.run_report import run_report
from compwright.reporting.test_sheet import NOT_STATED, further_statements, sheet_rows
from compwright.reporting.verify_report import verify_report
from compwright.workflow.inputs.logo import read_logo
from compwright.workflow.results.test_facts import report_document, stated_of_axes
from places import PROJECT, SHARED, STANDARD_TABLES, needs_shared
from reporting_samples import made_up, run_view, verify_view

SMALL = """
compwright: 1
controller: {format: linuxcnc}
axes:
  X: {travel: [0, 500], before: [x.csv]}
"""
KINDS = ("positioning", "circular")
#: Header keys that other programs write; those of our own are in the documentation.
FOREIGN = re.compile(
    "by|location|datum|messdatum|uhrzeit|date_.*|serial_no|ballbar_.*|calibrat(or|ed)_.*|run_.*"
    "|air_temp|air_press|air_humidity|temperatur|temperature|machine_temperature|feed_?rate|dwell"
    "|alpha_m|software.*|programmed_.*|centre"
)


def table_after(page: bytes, heading: str) -> list[list[str]]:
    """The rows of the first table behind a heading."""
    return next(tables_after(page, heading))


def tables_after(page: bytes, heading: str) -> Iterator[list[list[str]]]:
    """The rows of each table behind a heading."""
    found = False
    for element in ET.fromstring(page.decode()).iter():  # noqa: S314  our own page
        text = " ".join("".join(element.itertext()).split())
        found = found or (element.tag in {"h2", "h3", "summary"} and text.startswith(heading))
        if found and element.tag == "table":
            yield [
                [" ".join("".join(cell.itertext()).split()) for cell in row]
                for row in element.findall("tbody/tr")
            ]


def page_of(results: list[dict[str, Any]]) -> bytes:
    evaluation = {"schema": "compwright/evaluation/1", "results": results, "errors": []}
    return evaluation_report({"evaluation": evaluation, "command": "compwright evaluate x.csv"})


def job(text: str) -> Job:
    return read_job(textwrap.dedent(text).encode(), "job.yaml")


def number_in(cell: str) -> float:
    return float(cell.replace("−", "-"))


# --- items
# --------------------------------------------------------------------------------------------------


def test_a_file_with_every_item_shows_every_item() -> None:
    keys = dict.fromkeys(key for item in items_of("positioning") for key in item.headers)
    result = {
        **made_up(),
        "header": {key: f"<{key}> stated" for key in keys},
        "budget": {"contributions": [], "standard": 0.0, "U": 0.0, "coverage": 2, "length": 0.0},
    }
    rows = dict(row[:2] for row in table_after(page_of([result]), "Conditions of the test"))
    assert len(rows) == len(items_of("positioning"))
    for item in items_of("positioning"):
        assert rows[str(item.label)] != str(NOT_STATED)
        for key in item.headers:
            assert f"<{key}> stated" in rows[str(item.label)], item.label


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_without_any_item_says_not_stated_for_each(kind: str) -> None:
    rows = {str(row["label"]): row["value"] for row in sheet_rows({"kind": kind, "header": {}}, {})}
    known = {"Standard and edition", "Estimator of s, smoothing"}
    assert {label for label, value in rows.items() if value != NOT_STATED} <= known
    assert set(rows) == {str(item.label) for item in items_of(kind)}
    assert rows["Software compensation of the control: on or off"] == NOT_STATED


def test_the_job_states_what_the_file_does_not() -> None:
    rows = {
        row["key"]: row["value"]
        for row in sheet_rows({"header": {"travel": "0 to 800"}}, {"travel": "0 to 850 mm (job)"})
    }
    assert str(rows["travel"]) == "0 to 800; 0 to 850 mm (job)"


def test_numbers_get_their_unit_and_start_and_end_are_told_apart() -> None:
    header = {"T_m_start": "21.4", "t m end": "21,9", "Air-Pressure": "1013 mbar", "dwell_s": "4"}
    rows = {row["key"]: row["value"] for row in sheet_rows({"header": header}, {})}
    assert (
        str(rows["temperatures"])
        == "21.4 °C at the start of the test; 21,9 °C at the end of the test"
    )
    assert rows["air_pressure"] == "1013 mbar"
    assert str(rows["dwell"]) == "4 s"


def test_what_is_no_item_is_printed_too() -> None:
    result = {**made_up(), "header": {"axis": "X", "date": "today", "door": "open"}}
    assert further_statements(result) == [("door", "open")]
    assert ["In the file: door", "open", ""] in table_after(page_of([result]), "Conditions")


def test_every_standard_has_its_list_and_every_clause_an_edition_that_was_read() -> None:
    circular = {"iso230-4:1996", "iso230-4:2005"}
    assert set(BASIS) == set(READ_EDITION) == {*STANDARDS, *circular}
    assert {edition for item in ITEMS for edition in item.clauses} <= set(READ_EDITION.values())


@pytest.mark.parametrize(
    ("edition", "count"),
    # Counted by hand in the texts. GOST, 8.1: instrument's position, date, machine (name, type,
    # travels), equipment (type, serial number), scale, axis (name, line, other axes), feed, dwell,
    # targets, warm-up, air (temperature, pressure, humidity), compensation, shower, approaches.
    # ISO 230-4, 6: date, machine, instrument, 4.4 a) to i), g) being three. 1988: what "test sheet"
    # is said of.
    [("iso230-2:1988", 6), ("gost27843:2006", 21), ("iso230-4:1996", 14)],
)
def test_the_items_of_an_edition_are_as_many_as_its_text_has(edition: str, count: int) -> None:
    assert sum(edition in item.clauses for item in ITEMS) == count


#: ISO 230-2:2006, 7.1, in its order: the words of each item, and the items of the page.
ITEMS_OF_2006 = {
    "position of the measuring instrument": "instrument_position",
    "thermal expansion used for NDE correction": "expansion",
    "position of the temperature sensor(s)": "sensor_positions",
    "temperatures of sensors for NDE correction": "temperatures temperatures_instrument",
    "type of compensation routine": "compensation_routine",
    "date of test": "date",
    "machine name, type": "machine machine_type",
    "coordinate axes travels": "travel",
    "list of the test equipment used": "instrument",
    "type and serial number of the": "instrument_serial",
    "type of machine scale used": "scale",
    "its coefficient of thermal expansion": "scale_expansion",
    "name of axis under test": "axis",
    "the location of its measurement line": "measuring_line",
    "axes not under test": "other_axes",
    "description of nominal location": "measuring_line",
    "feed rate and dwell time": "feed dwell",
    "list of nominal target positions": "targets",
    "warm-up operation": "warm_up",
    "air temperature, air pressure and humidity": "air_temperature air_pressure humidity",
    "built-in compensation routines": "compensation",
    "use of air or oil shower": "air_shower",
    "number of approaches": "approaches",
    "contributors and parameters used": "contributors",
}


def test_the_items_of_2006_are_those_of_its_clause_one_by_one() -> None:
    expected = {key for keys in ITEMS_OF_2006.values() for key in keys.split()}
    assert {item.key for item in ITEMS if "iso230-2:2006" in item.clauses} == expected
    assert "axis_location" in next(item for item in ITEMS if item.key == "measuring_line").headers


@needs_shared
def test_each_item_of_2006_is_in_the_text_of_its_clause() -> None:
    path = SHARED / "standards" / "iso-230-2-2006-preview-en-fr.txt"
    text = " ".join(path.read_text(encoding="utf-8").split())
    clause = text.rpartition("7.1 Method of presentation")[2].partition("7.2 Parameters")[0]
    places = [clause.find(words) for words in ITEMS_OF_2006]
    assert -1 not in places
    assert clause.count("⎯") == 20  # bullets, three of them about the NDE correction's


def test_the_keys_are_in_the_documentation() -> None:
    text = (PROJECT / "docs" / "measurement-files.md").read_text(encoding="utf-8").lower()
    keys = {key for item in ITEMS for key in item.headers if not FOREIGN.fullmatch(key)}
    assert not {key for key in keys if f"`{key}`" not in text}


# --- numbers
# --------------------------------------------------------------------------------------------------


def table_2() -> PositioningTest:
    path = STANDARD_TABLES / "iso-230-2-1997-table-2.csv"
    return read_tests(path.read_bytes(), path.name)[0]


@needs_shared
def test_extremes_are_those_that_the_standard_prints() -> None:
    """ISO 230-2:1997, table 2: A = 4.0 - (-5.5), E = 3.4 - (-4.3), M = 1.5 - (-2.5)."""
    document = result_document(evaluate(table_2(), "iso230-2:1997"))
    printed: dict[str, list[tuple[float, str | None]]] = {
        "A": [(4.0, "-"), (-5.5, "+")],
        "E": [(3.4, "-"), (-4.3, "+")],
        "M": [(1.5, None), (-2.5, None)],
    }
    for name, ends in printed.items():
        for (value, direction), end in zip(ends, document["extremes"][name], strict=True):
            assert end["value"] == pytest.approx(value, abs=0.1)  # as far as the print is rounded
            assert end["direction"] == direction
    for name, (high, low) in document["extremes"].items():
        assert high["value"] - low["value"] == pytest.approx(document["parameters"][name])
    rows = table_after(page_of([document]), "Extremes")
    every = [end for pair in document["extremes"].values() for end in pair]
    for row, one in zip(rows, every, strict=True):
        assert number_in(row[3]) == one["position"]
        assert number_in(row[4]) == pytest.approx(one["value"], abs=0.005)


@needs_shared
def test_rings_r_are_as_far_apart_as_the_largest_r() -> None:
    """ISO 230-2:1997, table 2: R is the largest R_i, from the lowest to the highest mean ± 2 s."""
    document = result_document(evaluate(table_2(), "iso230-2:1997"))
    high, low = (mark for mark in result_chart(document).marks if mark.text == "R")
    assert high.x == low.x == document["at"]["R"]
    assert high.y - low.y == pytest.approx(document["parameters"]["R"])
    described = result_figure(document, "X").svg("de").split("aria-label=")[1]
    assert described.startswith('"Abweichungen der Achse X, Ringe an den Extremwerten')


@needs_shared
def test_raw_readings_have_every_digit_of_the_file() -> None:
    document = result_document(evaluate(table_2(), "iso230-2:1997"))
    document["targets"][3]["deviations_positive"][1] = -1.234567891
    first, second = islice(tables_after(page_of([document]), "Single readings"), 2)
    for row, more, target in zip(first, second, document["targets"], strict=True):
        every = [*target["deviations_positive"], *target["deviations_negative"]]
        assert [number_in(cell) for cell in (*row[1:], *more[1:])] == every
        assert number_in(row[0]) == number_in(more[0]) == target["position"]


@pytest.mark.parametrize(("digits", "most"), [(1, 10), (9, 5)])
def test_single_readings_fit_across_a_page(digits: int, most: int) -> None:
    document = made_up()
    for target in document["targets"]:
        for key in ("deviations_positive", "deviations_negative"):
            target[key] = [-49.225874143 if digits > 1 else -49.2] * 5
    rows = table_after(page_of([document]), "Single readings")
    assert {len(row) - 1 for row in rows} == {most}


def axis(length: float = 800.0, kind: AxisKind = AxisKind.LINEAR) -> PositioningTest:
    noise = np.random.default_rng(3).normal(0.0, 2e-4, (2, 9, 5))
    return PositioningTest(
        name="x", axis="X", kind=kind, targets=np.linspace(0.0, length, 9),
        positive=noise[0], negative=noise[1], runs_positive=(1, 2, 3, 4, 5), runs_negative=(1, 2, 3, 4, 5),
    )  # fmt: skip


def test_the_budget_is_the_one_that_was_used() -> None:
    """By hand, over 0.8 m at 23 °C: (0.5 + 0.4 · 0.8)/2; 2²/(2 · 0.8)/√12; 11.5 · 0.8 · 0.5/2;
    3 · 0.8 · 1/2; 0.6/2; 1/√12 µm.
    """
    budget = UncertaintyBudget(
        device=0.5, device_per_m=0.4, misalignment_mm=2.0, U_theta=0.5, U_alpha=1.0, setup=0.6, E_VE=1.0
    )  # fmt: skip
    thermal = Thermal(alpha_m=11.5, T_m=23.0)
    by_hand = {
        "device": 0.41, "misalignment_mm": 2.5 / math.sqrt(12.0), "U_theta_machine": 2.3,
        "U_alpha_machine": 1.2, "setup": 0.3, "E_VE": 1.0 / math.sqrt(12.0),
    }  # fmt: skip
    document = result_document(evaluate(axis(), budget=budget, thermal=thermal))
    table = document["budget"]
    found = {one["source"]: one["standard"] for one in table["contributions"]}
    assert found == pytest.approx(by_hand)
    assert table["standard"] == pytest.approx(math.hypot(*by_hand.values()))
    assert table["U"] == pytest.approx(2 * table["standard"])
    for one in table["contributions"]:
        product = one["given"] / one["divisor"] * one["sensitivity"]
        assert product == pytest.approx(one["standard"], abs=1e-8)
    length = [one.standard for one in contributions(axis(), budget, thermal) if one.per == "length"]
    assert length_uncertainty(axis(), budget, thermal) == pytest.approx(2 * math.hypot(*length))
    rows = table_after(page_of([document]), "Budget of the measurement uncertainty")
    shown = [number_in(row[4]) for row in rows]
    assert shown == pytest.approx([*by_hand.values(), table["standard"], table["U"]], abs=5e-4)


def test_a_rotary_budget_has_no_length_terms() -> None:
    document = result_document(
        evaluate(axis(90.0, AxisKind.ROTARY), budget=UncertaintyBudget(device=0.4, setup=0.3))
    )
    units = {one["source"]: one["unit"] for one in document["budget"]["contributions"]}
    assert units == {"device": "arcsec", "setup": "arcsec", "E_VE": "arcsec"}


def test_without_contributors_there_is_no_budget() -> None:
    document = result_document(evaluate(axis()))
    assert document["budget"] is None
    assert b"Budget of the measurement" not in page_of([document])


# --- every number of a page
# --------------------------------------------------------------------------------------------------

MICRONS = "\N{MICRO SIGN}m"


def every_table(page: bytes) -> list[tuple[list[str], list[list[str]]]]:
    """The heads and rows of each table of a page."""
    return [
        (
            [" ".join("".join(cell.itertext()).split()) for cell in table.iterfind("thead/tr/th")],
            [
                [" ".join("".join(cell.itertext()).split()) for cell in row]
                for row in table.iterfind("tbody/tr")
            ],
        )
        for table in ET.fromstring(page.decode()).iter("table")  # noqa: S314  our own page
    ]


def table_with(page: bytes, *heads: str) -> list[list[str]]:
    """The rows of the one table whose heads end with ``heads``, units included."""
    found = [rows for has, rows in every_table(page) if has[-len(heads) :] == list(heads)]
    assert len(found) == 1, heads
    return found[0]


def numbers_of(cells: list[str]) -> list[float]:
    return [number_in(text) for cell in cells for text in re.findall(r"−?\d+(?:\.\d+)?", cell)]


def equal(cells: list[str], values: list[float | None], digits: int = 2) -> None:
    """What is printed is these values, none more and none less."""
    expected = [value for value in values if value is not None]
    assert numbers_of(cells) == pytest.approx(expected, abs=0.5001 * 10.0**-digits)


KEYS = {"mean B": "B_mean", "B̄": "B_mean", "A+": "A_positive", "A−": "A_negative"} | {
    f"{letter}{sign}": f"{letter}_{word}"
    for letter in "ER"
    for sign, word in (("+", "positive"), ("−", "negative"))
}


def test_each_number_of_an_evaluation_is_that_of_the_json_with_its_unit() -> None:
    budget = UncertaintyBudget(
        device=0.5, device_per_m=0.4, misalignment_mm=2.0, U_theta=0.5, U_alpha=1.0, setup=0.6, E_VE=1.0
    )  # fmt: skip
    measured = replace(axis(), positive=axis().positive + 1e-3)
    result = result_document(
        evaluate(measured, budget=budget, thermal=Thermal(alpha_m=11.5, T_m=23.0))
    )
    for target in result["targets"]:
        target["expansion_removed"] = target["position"] / 100
    page = page_of([result])
    values, U = result["parameters"], {key: one["U"] for key, one in result["uncertainty"].items()}
    ((_, _, summary, unit),) = table_with(page, "Test", "Standard", "Parameters", "Unit")
    assert unit == MICRONS
    equal([summary], [each for key in "AEMRB" for each in (values[key], U[key])])
    rows = table_with(page, "Parameter ISO 230-2:2014", f"Value {MICRONS}; ± U, k = 2")
    assert len(rows) == len(values)
    for letter, _, *cells in rows:
        key = KEYS.get(letter, letter)
        equal(cells, [values[key], U[key]])
    heads = ("Parameter", f"Value {MICRONS}", f"Expanded uncertainty U {MICRONS}")
    for letter, *cells in table_with(page, *heads, "Coverage factor k"):
        key = KEYS.get(letter, letter)
        equal(cells, [values[key], U[key], 2])
    ends = [(one, name) for name, both in result["extremes"].items() for one in both]
    for row, (one, name) in zip(
        table_with(page, "Approach", "Position mm", f"Value {MICRONS}"), ends, strict=True
    ):
        assert KEYS.get(row[0], row[0]) == name
        equal(row[3:], [one["position"], one["value"]])
    contributed = result["budget"]["contributions"]
    units = ["µm", "mm", "K", "µm/(m K)", "µm", "µm"]
    budget_heads = (
        "Value given",
        "Distribution",
        "Sensitivity",
        f"Contribution u {MICRONS}",
        "Remark",
    )
    rows = table_with(page, *budget_heads)
    for row, one, unit in zip(rows[:-2], contributed, units, strict=True):
        equal(
            [row[1].split()[0], *row[3:5]], [one["given"], one["sensitivity"], one["standard"]], 3
        )
        assert row[1].split(maxsplit=1)[1] == unit
    equal([rows[-2][4], rows[-1][4]], [result["budget"]["standard"], result["budget"]["U"]], 3)
    columns = ["mean +", "mean −", "s +", "s −", "B", "mean ±", "R +", "R −", "R"]
    keys = ["mean_positive", "mean_negative", "s_positive", "s_negative", "reversal", "mean"]
    keys = ["position", *keys, "R_positive", "R_negative", "R"]
    rows = table_with(page, "Position mm", *(f"{one} {MICRONS}" for one in columns))
    for row, target in zip(rows, result["targets"], strict=True):
        equal(row, [target[key] for key in keys])
    every = every_table(page)
    for sign, key in (("+", "deviations_positive"), ("−", "deviations_negative")):
        runs = ["Position mm", *(f"{sign}{run} {MICRONS}" for run in range(1, 6))]
        as_measured, reduced = [rows for has, rows in every if has == runs]
        for row, less, target in zip(as_measured, reduced, result["targets"], strict=True):
            place = target["position"]
            equal(row, [place, *(one + place / 100 for one in target[key])], 8)
            equal(less, [place, *target[key]], 8)
    text = " ".join("".join(ET.fromstring(page.decode()).itertext()).split())  # noqa: S314
    assert "9 target positions, traverses: 5 in +, 5 in −, limits drawn at ± 2 s" in text
    for letter, key in (("R", "R"), ("R+", "R_positive"), ("R−", "R_negative"), ("B", "B")):
        assert re.search(rf"[:;] {re.escape(letter)} at {result['at'][key]:g} mm[;.]", text)


def verification_of_an_axis_and_a_circle() -> dict[str, Any]:
    """A view in which no two numbers are the same."""
    view = verify_view()
    (before,), (after,) = (
        view[key]["results"] for key in ("evaluation_before", "evaluation_after")
    )
    before["uncertainty"] = {"A": {"U": 1.31, "coverage": 2}, "E": {"U": 1.07, "coverage": 2}}
    after["uncertainty"] = {"A": {"U": 1.9, "coverage": 2}, "E": {"U": 1.7, "coverage": 2}}
    axis = view["verification"]["axes"]["X"]
    for entry in axis["accept"].values():
        entry["rule"] = "guarded"
    axis["loading"] |= {"verdict": "shifted", "shift_nodes": -3}
    circle = {
        "kind": "circular", "name": "xy", "plane": "XY", "standard": "iso230-4:2005",
        "nominal_radius": 150.0, "axes": ["X", "Y"], "arc": {"start": 0.0, "extent": 360.0},
        "uncertainty": {"G_ccw": {"U": 0.83, "coverage": 2}}, "parameters": {},
        "diagnosis": {
            "squareness": {"value": -21.4, "std_error": 0.6, "unit": "um/m", "effect": 3.2, "share": 0.7},
            "servo_mismatch": {"value": 0.123, "std_error": 0.02, "unit": "ms", "effect": 1.1, "share": 0.3},
        },
    }  # fmt: skip
    view["evaluation_before"]["results"].append(circle)
    view["verification"]["circles"] = {
        "xy": {
            "before": {"G_ccw": 11.2, "F_min_ccw": -6.4, "squareness": -21.4, "servo_mismatch": 0.123},
            "predicted": {
                "G_ccw": {"median": 5.5, "p05": 4.4, "p95": 6.6},
                "F_min_ccw": {"median": -2.5, "p05": -3.1, "p95": -1.9},
                "squareness": {"median": -1.3, "p05": -2.2, "p95": 0.4},
                "servo_mismatch": {"median": 0.11, "p05": 0.09, "p95": 0.14},
            },
            "after": {"G_ccw": 5.7, "F_min_ccw": -2.8, "squareness": -1.7, "servo_mismatch": 0.1},
            "accept": {"G_ccw": {"limit": 9.3, "value": 5.7, "decision": "accept"}},
        }
    }  # fmt: skip
    return view


def test_each_number_of_a_verification_is_that_of_the_json_with_its_unit() -> None:
    view = verification_of_an_axis_and_a_circle()
    page = verify_report(view)
    axis, circle = view["verification"]["axes"]["X"], view["verification"]["circles"]["xy"]

    def stages(one: dict[str, Any], key: str) -> list[float | None]:
        band = one["predicted"].get(key) or {}
        return [one["before"].get(key), *(band.get(part) for part in ("median", "p05", "p95"))]

    limited = [(axis, "A"), (axis, "E"), (circle, "G_ccw")]
    rows = next(rows for heads, rows in every_table(page) if heads[:2] == ["Axis", "Loading"])
    assert [row[2] for row in rows] == ["A", "E", "G ccw"]
    for row, (one, key) in zip(rows, limited, strict=True):
        equal(row[3:8], [*stages(one, key), one["after"][key], one["accept"][key]["limit"]])
        assert row[8] == MICRONS
    stated = [
        view[f"evaluation_{when}"]["results"][0]["uncertainty"] for when in ("before", "after")
    ]
    with_U = f"{MICRONS}; ± U, k = 2"
    heads = (f"Before {with_U}", f"Predicted {MICRONS}; median, 5–95 %", f"After {with_U}")
    for letter, _, *cells in table_with(page, *heads):
        key = KEYS.get(letter, letter)
        U_before, U_after = (of_test.get(key, {}).get("U") for of_test in stated)
        value, *band = stages(axis, key)
        equal(cells, [value, U_before, *band, axis["after"].get(key), U_after])
    heads = (f"After {MICRONS}", f"U {MICRONS}", f"Limit {MICRONS}")
    for letter, *cells, _ in table_with(page, "Limit on", *heads, "Decision"):
        equal(cells, [axis["accept"][letter][key] for key in ("value", "U", "limit")])
    units = {"G ccw": ("G_ccw", MICRONS), "F min ccw": ("F_min_ccw", MICRONS)} | {
        "Squareness XY": ("squareness", f"{MICRONS}/m"),
        "Servo mismatch X − Y": ("servo_mismatch", "ms"),
    }
    rows = table_with(page, "Before", "U k = 2", "Predicted median", "Predicted 5–95 %", "After", "Limit", "Decision")  # fmt: skip
    assert [row[0] for row in rows] == list(units)
    for name, unit, before, U, *cells in rows:
        key, expected = units[name]
        assert unit == expected
        value, *band = stages(circle, key)
        equal([before], [value])
        equal([U], [0.83] if key == "G_ccw" else [])
        equal(cells, [*band, circle["after"][key], *([9.3] if key == "G_ccw" else [])])
    text = " ".join("".join(ET.fromstring(page.decode()).itertext()).split())  # noqa: S314
    assert f"U (k = 2) of the test after loading: A 1.90 {MICRONS}, E 1.70 {MICRONS}." in text
    assert "shift in points −3" in text
    axis["loading"] |= {"verdict": "scaled", "factor": 2.54}
    assert re.search(r"factor <b>2\.54</b>", verify_report(view).decode())


def test_each_number_of_a_circle_and_its_machine_is_that_of_the_json_with_its_unit() -> None:
    causes: dict[str, dict[str, dict[str, Any]]] = {
        "squareness": {"XY": {"value": -21.3, "std_error": 0.7, "unit": "um/m"}},
        "backlash": {"X": {"value": 3.41, "std_error": 0.28, "unit": "um"}},
        "scale_error": {"Y": {"value": 5.1, "std_error": 3.3, "unit": "um/m"}},
        "servo_mismatch": {"XY": {"value": -0.123, "std_error": 0.021, "unit": "ms"}},
    }
    result = {
        "kind": "circular", "name": "xy", "plane": "XY", "standard": "iso230-4:2005", "unit": "um",
        "nominal_radius": 150.0, "axes": ["X", "Y"], "arc": {"start": 0.0, "extent": 360.0},
        "header": {"machine": "VMC", "serial": "7"}, "residual": 0.48,
        "parameters": {"G_ccw": 11.2, "G_cw": 12.3, "G_bidirectional": 13.6, "F_min_ccw": -6.4, "D": -0.9},
        "uncertainty": {"G_ccw": {"U": 0.83, "coverage": 2}, "D": {"U": 0.57, "coverage": 2}},
        "diagnosis": {
            "squareness": {"value": -21.4, "std_error": 0.6, "unit": "um/m", "effect": 3.2, "share": 0.71},
            "servo_mismatch": {"value": 0.123, "std_error": 0.02, "unit": "ms", "effect": 1.1, "share": 0.29},
        },
        "fitted": [
            {"direction": "ccw", "angles": [0.0, 90.0], "deviations": [0.0, 0.0], "residuals": [0.3, -0.3]}
        ],
    }  # fmt: skip
    machine = {"machine": "VMC", "serial": "7", "circles": ["xy"], "causes": causes}
    machine |= {"contradictions": [], "findings": []}
    evaluation = {"results": [result], "machines": [machine], "errors": []}
    page = evaluation_report({"evaluation": evaluation})
    rows = table_with(page, "Cause", "Value ± standard error", "Unit")
    shown = [entry for of in causes.values() for entry in of.values()]
    for (_, value, unit), entry, expected in zip(
        rows, shown, (f"{MICRONS}/m", MICRONS, f"{MICRONS}/m", "ms"), strict=True
    ):
        equal([value], [entry["value"], entry["std_error"]], 1 if expected.endswith("/m") else 2)
        assert unit == expected
    k = f"{MICRONS}; ± U, k = 2"
    rows = next(rows for heads, rows in every_table(page) if heads[-1] == f"both {k}")
    equal(rows[0][2:], [11.2, 0.83, 12.3, 13.6])
    equal(rows[1][2:], [-6.4])
    equal(rows[2][2:], [-0.9, 0.57])
    text = " ".join("".join(ET.fromstring(page.decode()).itertext()).split())  # noqa: S314
    assert f"leave 0.48 {MICRONS} rms unexplained" in text


# --- the command
# --------------------------------------------------------------------------------------------------


@needs_shared
def test_evaluate_writes_a_report_with_the_numbers_of_the_json(tmp_path: Path) -> None:
    source = STANDARD_TABLES / "iso-230-2-1997-table-2.csv"
    page, answer = tmp_path / "out.html", tmp_path / "out.json"
    options = ["--standard", "iso230-2:1997", "--report", str(page), "--json", str(answer)]
    assert compwright(["evaluate", str(source), *options]) == 0
    (result,) = json.loads(answer.read_bytes())["results"]
    rows = table_after(page.read_bytes(), "Parameters")
    shown = {row[0].replace("mean B", "B_mean"): number_in(row[2]) for row in rows}
    names = {
        "A": "A",
        "E": "E",
        "M": "M",
        "R": "R",
        "B": "B",
        "B_mean": "B_mean",
        "A↑": "A_positive",
    }
    for label, name in names.items():
        assert shown[label] == pytest.approx(result["parameters"][name], abs=0.005 + 1e-9)
    text = page.read_text(encoding="utf-8")
    assert result["sources"][0]["sha256"] in text
    assert "--standard iso230-2:1997" in text


@needs_shared
@pytest.mark.parametrize("name", ["out.txt", "out"])
def test_another_ending_is_refused_by_name(tmp_path: Path, name: str) -> None:
    source = STANDARD_TABLES / "iso-230-2-1997-table-2.csv"
    assert compwright(["evaluate", str(source), "--report", str(tmp_path / name)]) == 2
    assert not (tmp_path / name).exists()


def test_a_number_of_a_report_cannot_end_the_style_sheet() -> None:
    hostile = '"} </style><script>alert(1)</script>\\\n'
    assert not set(css_string(hostile)[1:-1]) & set('"<>{}\n;')
    footer = str(head({"number": hostile}, [])["running"])
    assert css_string(footer).startswith('"Report \\22 \\7d  ')


# --- the reports of run and verify
# --------------------------------------------------------------------------------------------------


def headings(page: bytes) -> list[str]:
    root = ET.fromstring(page.decode())  # noqa: S314  our own page
    return ["".join(one.itertext()).strip() for one in root.iter("h2")]


def test_the_parts_of_a_report_stand_in_their_order() -> None:
    found = headings(run_report(run_view()))
    order = [
        "Before and predicted",
        "Axis X",
        "Axis C",
        "Assumed facts",
        "Annex A",
        "Annex B",
        "Annex C",
    ]
    places = [next(i for i, text in enumerate(found) if text.startswith(part)) for part in order]
    assert places == sorted(places)
    assert places[0] == 1  # behind the verdict
    found = headings(verify_report(verify_view()))
    order = ["Before, predicted and after", "Axis X", "Annex A", "Annex B"]
    places = [next(i for i, text in enumerate(found) if text.startswith(part)) for part in order]
    assert places == sorted(places)
    assert places[0] == 1


def test_head_and_stated_items_are_those_of_the_job() -> None:
    given = job("""
        compwright: 1
        machine: {name: VMC 850, serial: "4711", type: vertical spindle}
        controller: {format: linuxcnc}
        states: {as_found: none, loaded: {files: [a.comp], active: no}, stored: [b.comp]}
        axes:
          X:
            travel: [0, 500]
            before: [{files: x.csv, name: x}, {files: y.csv, name: y, measured_in: loaded}, {files: z.csv, name: z, measured_in: stored}]
        report: {number: "2026-117", customer: "<Meier>", operator: N N, place: hall 3}
        """)
    stated = stated_of_axes(given)["X"]
    assert str(stated["x"]["travel"]) == "0 to 500 mm (job)"
    assert str(stated["x"]["machine"]) == "VMC 850, 4711 (job)"
    assert str(stated["x"]["machine_type"]) == "vertical spindle (job)"
    assert str(stated["x"]["compensation"]).startswith("off: nothing was active")
    assert str(stated["y"]["compensation"]).startswith("off; in the control: a.comp")
    assert str(stated["z"]["compensation"]).startswith("on, as stored in b.comp")
    view = {
        **run_view(),
        "report": report_document(given),
        "stated": {"axes": {"X": {"x_before": stated["x"]}}},
    }
    page = run_report(view).decode()
    assert "2026-117" in page
    assert "&lt;Meier&gt;" in page
    rows = dict(row[:2] for row in table_after(page.encode(), "Conditions of the test"))
    assert "X: 0 to 500 mm (job)" in rows["Travel of the axis"]
    assert "X: N N (job)" in rows["Operator"]


def test_what_all_tests_state_is_printed_once() -> None:
    """One table for all tests of a standard; where they differ, with the names of the tests."""
    tests = [
        {**made_up(axis="X"), "header": {"operator": "Ada", "feed": "500", "shift": "night"}},
        {**made_up(axis="Y"), "header": {"operator": "Ada", "feed": "800"}},
    ]
    page = page_of(tests)
    assert page.count(b"<h3>Conditions of the test") == 1
    rows = dict(row[:2] for row in table_after(page, "Conditions of the test"))
    assert rows["Operator"] == "Ada"
    assert rows["In the file: shift"] == "Axis X, x_before: night; Axis Y, x_before: not stated"
    (feed,) = [value for label, value in rows.items() if "500" in value and "Feed" in label]
    assert feed == "Axis X, x_before: 500; Axis Y, x_before: 800"


def test_without_states_nothing_is_said_of_compensation() -> None:
    assert stated_of_axes(job(SMALL))["X"]["x"]["compensation"] == ""


@pytest.mark.parametrize(
    ("decisions", "proven", "words"),
    [
        ([], True, "does not state conformity"),
        (["accept", "accept"], True, "conforms to every limit"),
        (["accept"], False, "not stated"),
        (["accept", "undecided"], True, "not stated"),
        (["accept", "reject", "undecided"], True, "does not conform"),
    ],
)
def test_conformity_is_stated_only_where_every_limit_is_met(
    decisions: list[str], proven: bool, words: str
) -> None:
    assert words in str(conformity(decisions, proven=proven))


# --- the logo
# --------------------------------------------------------------------------------------------------


def png() -> bytes:
    def chunk(kind: bytes, data: bytes) -> bytes:
        check = zlib.crc32(kind + data)
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

    head = struct.pack(">IIBBBBB", 1, 1, 8, 0, 0, 0, 0)
    parts = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(b"\0\0")) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + parts


SVG = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>'


@pytest.mark.parametrize(
    ("content", "kind"),
    [(png(), "image/png"), (SVG, "image/svg+xml"), (b"\xff\xd8\xff\xe0 \xff\xd9", "image/jpeg")],
)
def test_a_logo_is_embedded(tmp_path: Path, content: bytes, kind: str) -> None:
    (tmp_path / "logo").write_bytes(content)
    assert read_logo(Session(), "logo", tmp_path) == Logo(kind, content)
    head_of = report_document(replace(job(SMALL), report=ReportHead(image=Logo(kind, content))))
    page = run_report({**run_view(), "report": head_of}).decode()
    (shown,) = re.findall(r'src="data:([^;]*);base64,([^"]*)"', page)
    assert (shown[0], base64.b64decode(shown[1])) == (kind, content)


@pytest.mark.parametrize(
    "content",
    [
        b"", b"GIF89a", png()[:-5], png().replace(b"IDAT", b"IDAX"), SVG[:-3], b"<html></html>",
        b'<!DOCTYPE svg [<!ENTITY a "b">]><svg/>', b"\xff\xd8\xff\xe0 cut", png() + b"\0" * 500_000,
    ],
)  # fmt: skip
def test_a_faulty_logo_is_refused_by_name(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "logo.png").write_bytes(content)
    with pytest.raises(InputError) as caught:
        read_logo(Session(), "logo.png", tmp_path)
    assert "logo.png" in str(caught.value)


def test_conditions_of_a_circle_are_stated_too() -> None:
    circle = {
        "kind": "circular", "name": "xy", "standard": "iso230-4:2005", "nominal_radius": 150.0,
        "axes": ["X", "Y"], "arc": {"start": 0.0, "extent": 360.0}, "header": {"date": "today"},
    }  # fmt: skip
    stated = {"xy": {"compensation": "off (job)"}}
    (block,) = circle_blocks({"xy": {}}, {"results": [circle]}, stated=stated)
    rows = {row["key"]: (str(row["value"]), row["clause"]) for row in block["sheet"]["rows"]}
    assert rows["compensation"] == ("off (job)", "4.4 h")
    assert rows["diameter"] == ("radius 150 mm", "4.4 a")
    assert rows["range"] == ("from 0° to 360°, 360°", "4.4 g")
    assert rows["warm_up"] == (str(NOT_STATED), "")
