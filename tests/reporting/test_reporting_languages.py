"""The test report in four languages: the same numbers as the JSON, written by the rules of the
language, and the terms of the standards' own texts.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from compwright.cli import run as compwright
from compwright.reporting.numbers import decimals_of_unit
from compwright.reporting.sections import bar, findings
from compwright.words.sentences import Language, SentenceText, in_language, say
from places import PROJECT

AXIS = PROJECT / "src" / "compwright" / "reference_data" / "axis-by-hand.csv"
LANGUAGES = ("en", "de", "fr", "ru")

# Read in the standards: DIN ISO 230-4:1999, B.3.1; ISO 230-2:2006 (F), 2.13, 2.17, 2.21, 2.24;
# GOST 27843-2006, 3.13, 3.18, 3.20, 3.23.
TERMS = {
    "de": {"B": "Umkehrspanne", "R": "Wiederholpräzision der Positionierung"},
    "fr": {
        "A": "Exactitude bidirectionnelle de positionnement",
        "B": "Valeur de réversibilité",
        "E": "Écart de position systématique bidirectionnel",
        "R": "Répétabilité de positionnement bidirectionnelle",
    },
    "ru": {
        "A": "Точность двустороннего позиционирования",
        "B": "Зона нечувствительности",
        "E": "Двустороннее систематическое позиционное отклонение",
        "R": "Двусторонняя повторяемость позиционирования",
    },
}


def page_and_document(
    folder: Path, language: str, *sources: Path
) -> tuple[ET.Element, dict[str, Any]]:
    report, document = folder / "report.html", folder / "evaluation.json"
    words = ["--report", str(report), "--lang", language, "--json", str(document)]
    assert compwright(["evaluate", *map(str, sources), *words]) == 0
    return ET.fromstring(report.read_bytes()), json.loads(document.read_bytes())  # noqa: S314


def text_of(element: ET.Element) -> str:
    return " ".join("".join(element.itertext()).split())


def rows_by_class(page: ET.Element, name: str) -> list[list[str]]:
    return [
        [text_of(cell) for cell in row]
        for table in page.iter("table")
        if name in table.get("class", "").split()
        for row in table.iterfind("tbody/tr")
    ]


def value_of(text: str, language: str) -> float:
    mark = "." if language == "en" else ","
    assert re.fullmatch(rf"−?\d+(?:{re.escape(mark)}\d+)?", text), text
    return float(text.replace(mark, ".").replace("−", "-"))


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_parameter_of_the_page_is_that_of_the_json(tmp_path: Path, language: str) -> None:
    page, document = page_and_document(tmp_path, language, AXIS)
    given = document["results"][0]["parameters"]
    letters = {"+": "_positive", "−": "_negative"}
    shown = {
        "B_mean"
        if row[0] in ("mean B", "B̄")
        else row[0][0] + letters.get(row[0][1:], ""): value_of(row[2], language)
        for row in rows_by_class(page, "parameters")
    }
    assert shown == {
        name: pytest.approx(value, abs=0.00501)
        for name, value in given.items()
        if value is not None
    }


@pytest.mark.parametrize("language", LANGUAGES)
def test_each_number_of_the_statistics_is_that_of_the_json(tmp_path: Path, language: str) -> None:
    page, document = page_and_document(tmp_path, language, AXIS)
    keys = ("position", "mean_positive", "mean_negative", "s_positive", "s_negative", "reversal")
    (table,) = [
        table
        for block in page.iter("details")
        for table in block.iter("table")
        if len(table.findall("thead/tr/th")) == 10
        and "s +" in [text_of(head).rpartition(" ")[0] for head in table.iter("th")]
    ]
    rows = [[text_of(cell) for cell in row] for row in table.iterfind("tbody/tr")]
    assert len(rows) == len(document["results"][0]["targets"])
    for row, target in zip(rows, document["results"][0]["targets"], strict=True):
        for text, key in zip(row, keys, strict=False):
            assert value_of(text, language) == pytest.approx(target[key], abs=0.00501)


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_label_of_another_language_and_no_field_is_left(tmp_path: Path, language: str) -> None:
    page, _ = page_and_document(tmp_path, language, AXIS)
    text = text_of(page)
    assert page.get("lang") == language
    (body,) = page.iterfind("body")
    assert not re.search("[{}]", text_of(body))
    english = ("not stated", "Measured by", "Annex A", "Report number", "target positions, trav")
    assert [word for word in english if word in text] == (list(english) if language == "en" else [])


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_a_page_says_that_no_native_speaker_has_read_it(tmp_path: Path, language: str) -> None:
    page, _ = page_and_document(tmp_path, language, AXIS)
    (footer,) = page.iter("footer")
    named = {"de": "Muttersprachler", "fr": "en anglais fait foi", "ru": "носителем языка"}
    assert named[language] in text_of(footer)


@pytest.mark.parametrize("language", LANGUAGES[1:])
def test_parameters_have_the_terms_of_the_standards(tmp_path: Path, language: str) -> None:
    page, _ = page_and_document(tmp_path, language, AXIS)
    shown = {row[0]: row[1] for row in rows_by_class(page, "parameters")}
    for letter, term in TERMS[language].items():
        assert shown[letter].startswith(term)


def test_numbers_of_the_repeating_command_and_of_json_keep_their_point(tmp_path: Path) -> None:
    page, document = page_and_document(tmp_path, "de", AXIS)
    code = " ".join(text_of(node) for node in page.iter("code"))
    assert "--lang de" in code
    assert "axis-by-hand.csv" in code
    assert isinstance(document["results"][0]["parameters"]["A"], float)


@pytest.mark.parametrize(
    ("language", "date"),
    [("en", "2026-11-24"), ("de", "24.11.2026"), ("fr", "24/11/2026"), ("ru", "24.11.2026")],
)
def test_the_date_of_a_test_is_that_of_the_language(
    tmp_path: Path, language: str, date: str
) -> None:
    """DIN 5008, the French and the Russian short forms of CLDR 45; a name stays as it is."""
    dated = tmp_path / "x.csv"
    dated.write_text(
        "# axis: X\n# date: 2026-11-24 10:30\n# operator: 2026-11-24\n" + AXIS.read_text("utf-8"),
        encoding="utf-8",
    )
    page, _ = page_and_document(tmp_path, language, dated)
    shown = [text_of(cell) for cell in page.iter("dd")]
    assert f"{date} 10:30" in shown
    assert "2026-11-24" in shown


def limits_of_travel(label: str) -> dict[str, Any]:
    values = {"label": label, "outside": 500.0, "unit": "mm", "low": -1000.0, "high": 1.0}
    return {**values, "parameters": "1320, 1321"}


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_finding_begins_with_a_capital_on_a_page_but_a_name_stays(language: Language) -> None:
    arc = SentenceText(say("CW-D006", axis="X", pitch=10.0))
    axis = SentenceText(say("CW-S045", **limits_of_travel("axis 1")))
    named = SentenceText(say("as_written", text="x.csv is empty"))
    shown = [
        in_language(entry["message"], language)
        for entry in findings([{"code": "CW", "message": one} for one in (arc, axis, named)])
    ]
    assert [text[0].isupper() for text in shown] == [True, True, False]


def test_a_bar_is_described_in_the_language_of_the_page() -> None:
    drawn = bar(23.634, {"median": 4.26, "p05": 3.6, "p95": 5.1}, 8.0)
    assert drawn is not None
    assert drawn["label"].text("de") == "Balken: vorher 23,63, jetzt 4,26, Grenze 8,00"
    assert drawn["label"].text("fr").startswith("Barre : avant 23,63")


@pytest.mark.parametrize(("unit", "decimals"), [("um", 2), ("um/m", 1), ("µm/m", 1), ("ms", 3)])
def test_decimals_go_with_the_unit(unit: str, decimals: int) -> None:
    assert decimals_of_unit(unit) == decimals


def test_tests_of_one_axis_with_the_same_name_are_told_apart(tmp_path: Path) -> None:
    """By their files; two of one file by a number too."""
    files = [tmp_path / folder / "x.csv" for folder in ("before", "after")]
    text = AXIS.read_text("utf-8")
    for index, file in enumerate(files):
        file.parent.mkdir()
        file.write_text(f"# axis: X\n# date: 2026-11-2{index}\n{text}", encoding="utf-8")
    page, _ = page_and_document(tmp_path, "en", *files)
    titles = [text_of(one) for one in page.iter("h2") if text_of(one).startswith("Axis X")]
    assert len(titles) == 2
    for title, file in zip(titles, files, strict=True):
        assert title.endswith(f"{file.parent.name}/x.csv")
