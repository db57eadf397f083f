"""The self-test of an installation: every value within its limit, and no fault goes unseen."""

from __future__ import annotations

import copy
import json
import math
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from compwright.cli import run as compwright
from compwright.controls.checked_definitions import checked_definitions, hand_worked
from compwright.evaluation import standards
from compwright.evaluation.statistics import standard_deviation
from compwright.foundations import storage
from compwright.foundations.session import Session
from compwright.reporting.selftest_report import selftest_report
from compwright.workflow.commands import selftest as command
from compwright.workflow.commands.selftest import selftest
from format_samples import DEFINITIONS
from places import STANDARD_TABLES, needs_shared


@pytest.fixture(scope="module")
def document() -> dict[str, Any]:
    return selftest(Session())


def test_every_value_is_within_its_limit(document: dict[str, Any]) -> None:
    assert document["good"]
    assert len(document["checks"]) > 150
    for check in document["checks"]:
        assert check["good"], check
        assert abs(check["obtained"] - check["expected"]) <= check["limit"]


def test_every_control_file_and_standard_takes_part(document: dict[str, Any]) -> None:
    groups = {check["group"] for check in document["checks"]}
    assert groups == {*DEFINITIONS, *document["reference_data"]} - {"expected.csv"}
    subjects = {check["subject"] for check in document["checks"]}
    assert {*standards.STANDARDS, "iso230-4:1996", "iso230-4:2005"} <= subjects
    assert set(document["packages"]) >= {"numpy", "scipy", "cvxpy", "osqp"}


@needs_shared
@pytest.mark.parametrize("year", [1988, 1997])
def test_the_tables_that_ship_are_those_that_were_typed(year: int) -> None:
    name = f"iso-230-2-{year}-table-2.csv"
    assert storage.reference_files(Session())[name] == (STANDARD_TABLES / name).read_bytes()


def test_a_limit_is_no_larger_than_the_rounding_of_the_print(document: dict[str, Any]) -> None:
    for check in document["checks"]:
        assert check["limit"] <= (0.1 if "table-2" in check["group"] else 1e-3) or (
            check["quantity"] == "squareness" and check["limit"] <= 0.1
        )


def test_s_with_another_divisor_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Divided by n instead of n - 1, s is 0.894 of what it must be."""
    right = standard_deviation
    monkeypatch.setattr(
        f"{standards.__name__}.standard_deviation", lambda block: right(block) * math.sqrt(0.8)
    )
    monkeypatch.setattr(command, "_controls", lambda _: iter(()))
    wrong = {check["quantity"] for check in selftest(Session())["checks"] if not check["good"]}
    assert {"A", "R", "R_positive"} <= wrong
    assert not {"E", "B", "M"} & wrong


def test_a_wrong_sign_in_a_definition_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    true = list(checked_definitions(Session(), ()))
    right = hand_worked

    def turned(checked: Any) -> Any:
        for one in right(checked):
            off = 6.0 if one.reader == "formats" else one.difference
            yield type(one)(one.format, one.expectation, one.reader, one.count, off, one.unit)

    monkeypatch.setattr(command, "checked_definitions", lambda *_: iter(true[:1]))
    monkeypatch.setattr(command, "hand_worked", turned)
    found = selftest(Session())
    assert not found["good"]
    assert {
        check["quantity"].partition(":")[0] for check in found["checks"] if not check["good"]
    } == {"formats"}


def test_what_cannot_be_evaluated_is_outside(monkeypatch: pytest.MonkeyPatch) -> None:
    files = {**storage.reference_files(Session()), "axis-by-hand.csv": b"no test"}
    monkeypatch.setattr(storage, "reference_files", lambda _: files)
    monkeypatch.setattr(command, "_controls", lambda _: iter(()))
    wrong = [check for check in selftest(Session())["checks"] if not check["good"]]
    assert {check["group"] for check in wrong} == {"axis-by-hand.csv"}
    assert all(check["obtained"] is None and check["note"] for check in wrong)


def test_an_installation_without_controls_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(command, "checked_definitions", lambda *_: iter(()))
    wrong = [check for check in selftest(Session())["checks"] if not check["good"]]
    assert [(check["group"], check["note"]) for check in wrong] == [
        ("controls", "none was found: install compwright again")
    ]


def test_the_command_exits_1_when_any_value_is_off(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, document: dict[str, Any]
) -> None:
    assert_written(tmp_path / "good", 0)
    wrong = copy.deepcopy(document)
    wrong["checks"][3].update(obtained=9.0, good=False)
    wrong["good"] = False
    monkeypatch.setattr(command, "selftest", lambda _: wrong)
    assert_written(tmp_path / "wrong", 1)


def assert_written(folder: Path, code: int) -> None:
    assert compwright(["selftest", "--out", str(folder)]) == code
    found = json.loads((folder / "selftest.json").read_bytes())
    page = (folder / "selftest.html").read_bytes()
    assert page == selftest_report(found)
    marks = ["".join(one.itertext()) for one in ET.fromstring(page.decode()).iter("span")]  # noqa: S314
    assert marks.count("✗") == 2 * code  # of the value, and of its group


def test_each_number_of_the_page_is_that_of_the_json(document: dict[str, Any]) -> None:
    root = ET.fromstring(selftest_report(document).decode())  # noqa: S314  our own page
    shown = [
        [float("".join(cell.itertext()).replace("−", "-")) for cell in row.findall("td")[3:6]]
        for row in root.iter("tr")
        if len(row.findall("td")) == 7
    ]
    told = [
        [check[key] for key in ("expected", "obtained", "limit")] for check in document["checks"]
    ]
    assert len(shown) == len(told)
    for page, numbers in zip(shown, told, strict=True):
        assert page == pytest.approx(numbers, rel=1e-9)
