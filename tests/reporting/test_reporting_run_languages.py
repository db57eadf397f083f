"""The reports of ``run`` and ``verify`` in the language of the job: its labels, the numbers of the
documents, and a last line that names what is still in English.
"""

from __future__ import annotations

import json
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from string import Formatter
from typing import Any
from xml.etree import ElementTree as ET

import pytest
from test_every_control import FORMATS, run_arguments

from compwright.cli import run as compwright
from compwright.reporting import card, evaluation_report
from compwright.reporting import run_report as report
from compwright.reporting.card import card_html
from compwright.reporting.run_report import run_report
from compwright.reporting.verify_report import verify_report
from compwright.words.sentences import catalogue, parts
from loop import Machine, csv_of
from places import PROJECT, REAL, needs_shared
from reporting_samples import english_words, run_view, verify_view

pytestmark = [pytest.mark.short_estimate, pytest.mark.real_pages]

LANGUAGES = ("de", "fr", "ru")
PAGE = evaluation_report.evaluation_report
EXAMPLE = PROJECT / "examples" / "linuxcnc-two-axes"
#: Words of the English pages that every language has to replace.
ENGLISH = ("Before", "Predicted", "Decision", "not stated", "Annex", "Assumed", "Raw readings")
IN_ENGLISH = {"de": "sind auf Englisch", "fr": "sont en anglais", "ru": "на английском"}


def page_of(content: bytes) -> ET.Element:
    """Return the page without its figures, whose words are in English."""
    text = re.sub(r"<svg.*?</svg>", "", content.decode("utf-8"), flags=re.DOTALL)
    return ET.fromstring(text)  # noqa: S314  our own page


def text_of(element: ET.Element) -> str:
    return " ".join("".join(element.itertext()).split())


def numbers_in(text: str) -> list[float]:
    """The numbers of a text in which the decimal mark is a comma; one with a point fails."""
    found = re.findall(r"−?\d+(?:[.,]\d+)?", text)
    assert not [number for number in found if "." in number], text
    return [float(number.replace(",", ".").replace("−", "-")) for number in found]


@pytest.fixture(scope="module")
def german_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("german") / "work"
    shutil.copytree(EXAMPLE, folder)
    job = folder / "job.yaml"
    job.write_text(job.read_text(encoding="utf-8") + "report: {language: de}\n", encoding="utf-8")
    assert compwright(["run", str(job)]) == 0
    return folder / "job"


def test_a_german_run_has_german_headings_and_names_what_is_english(german_run: Path) -> None:
    page = page_of((german_run / "report.html").read_bytes())
    headings = [text_of(one) for level in ("h1", "h2", "h3") for one in page.iter(level)]
    assert page.get("lang") == "de"
    assert {"Kompensation von X, A", "Achse X", "Annahmen", "Geschriebene Dateien"} <= set(headings)
    heads = [text_of(head) for head in page.iter("th")]
    assert [
        word
        for word in ENGLISH
        if any(re.search(rf"\b{word}\b", one) for one in (*headings, *heads))
    ] == []
    (footer,) = page.iter("footer")
    assert IN_ENGLISH["de"] in text_of(footer)


def test_the_verdict_of_a_german_run_has_the_numbers_of_the_json(german_run: Path) -> None:
    page = page_of((german_run / "report.html").read_bytes())
    prediction: dict[str, Any] = json.loads((german_run / "prediction.json").read_bytes())
    (verdict,) = (one for one in page.iter("section") if "verdict" in one.get("class", ""))
    rows = [[text_of(cell) for cell in row] for row in verdict.iterfind(".//tbody/tr")]
    assert [(row[0], row[1]) for row in rows] == [("X", "A"), ("X", "B"), ("A", "A")]
    for row in rows:
        axis = prediction["axes"][row[0]]
        band = axis["predicted"][row[1]]
        expected = [
            axis["before"][row[1]], band["median"], band["p05"], band["p95"],
            axis["accept"][row[1]]["limit"],
        ]  # fmt: skip
        assert numbers_in(" ".join(row[2:6])) == pytest.approx(expected, abs=0.00501)


def test_the_parameters_of_a_german_run_have_the_numbers_of_the_json(german_run: Path) -> None:
    page = page_of((german_run / "report.html").read_bytes())
    prediction: dict[str, Any] = json.loads((german_run / "prediction.json").read_bytes())
    tables = [one for one in page.iter("table") if one.get("class") == "parameters"]
    assert len(tables) == len(prediction["axes"])
    for table, axis in zip(tables, prediction["axes"].values(), strict=True):
        for row in table.iterfind("tbody/tr"):
            sign, _, before, *predicted = [text_of(cell) for cell in row]
            key = sign.replace("+", "_positive").replace("−", "_negative")
            key = "B_mean" if sign == "B̄" else key
            expected = [axis["before"][key]]
            for band in (axis["predicted"][key], axis["predicted_new_targets"][key]):
                expected += [band["median"], band["p05"], band["p95"]]
            assert numbers_in(" ".join((before, *predicted))) == pytest.approx(
                expected, abs=0.00501
            )


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("kind", ["run", "verify"])
def test_no_english_head_is_left_and_the_last_line_names_the_rest(kind: str, language: str) -> None:
    view = {**(run_view() if kind == "run" else verify_view()), "language": language}
    page = page_of(run_report(view) if kind == "run" else verify_report(view))
    heads = [text_of(one) for level in ("h2", "h3", "th", "summary") for one in page.iter(level)]
    assert [word for word in ENGLISH if any(re.search(rf"\b{word}\b", one) for one in heads)] == []
    (footer,) = page.iter("footer")
    assert IN_ENGLISH[language] in text_of(footer)
    (verdict,) = (one for one in page.iter("section") if "verdict" in one.get("class", ""))
    for cell in verdict.iterfind(".//td"):
        numbers_in(text_of(cell))


@pytest.mark.parametrize("kind", ["run", "verify"])
def test_an_english_page_has_no_line_about_languages(kind: str) -> None:
    page = page_of(run_report(run_view()) if kind == "run" else verify_report(verify_view()))
    (footer,) = page.iter("footer")
    assert "in English" not in text_of(footer)
    assert page.get("lang") == "en"


def fixed_words(template: str) -> Iterator[str]:
    """Yield the texts of a template between its fields, those inside of its choices too."""
    for text, _, form, _ in Formatter().parse(template):
        yield " ".join(text.split()).strip(" .:;,")
        how, *texts = parts(form or "")
        if how in ("plural", "if", "choose"):
            for one in texts:
                yield from fixed_words(one.partition("=")[2] if how == "choose" else one)


def english_on(report: Path) -> list[str]:
    """The fixed words of 4 words or more of English sentences that are on a page, its figures
    included.
    """
    (body,) = ET.fromstring(report.read_bytes()).iterfind("body")  # noqa: S314  our own page
    text = " ".join(" ".join(body.itertext()).split())
    every = {words for template in catalogue("en").values() for words in fixed_words(template)}
    return sorted(
        words for words in every if len(re.findall("[A-Za-z]{2,}", words)) >= 4 and words in text
    )


@pytest.mark.parametrize("language", ["en", *LANGUAGES])
def test_no_english_sentence_of_the_catalogue_is_on_a_translated_report(
    tmp_path: Path, language: str
) -> None:
    """Without an exception; the English page shows that they would be found."""
    folder = tmp_path / "work"
    shutil.copytree(PROJECT / "examples" / "sinumerik-old-table", folder)
    job = folder / "job.yaml"
    text = job.read_text(encoding="utf-8") + f"report: {{language: {language}}}\n"
    job.write_text(text, encoding="utf-8")
    assert compwright(["run", str(job)]) == 0
    found = english_on(folder / "job" / "report.html")
    assert len(found) > 50 if language == "en" else found == []


@needs_shared
def test_no_english_is_on_the_translated_page_of_an_axis_and_a_circle(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the files state stays as it is; it is left out here."""
    given: dict[str, Any] = {}

    def keep(view: dict[str, Any]) -> bytes:
        given.update(view)
        return b""

    monkeypatch.setattr(evaluation_report, "evaluation_report", keep)
    axis = PROJECT / "src" / "compwright" / "reference_data" / "axis-by-hand.csv"
    circle = REAL / "ballbar" / "ballbar_qc20w_150mm_ZX_220deg.b5r"
    words = ["--report", str(tmp_path / "out.html")]
    assert compwright(["evaluate", str(axis), str(circle), *words]) == 0
    for result in given["evaluation"]["results"]:
        result["header"] = {}
    for language in ("en", *LANGUAGES):
        found = english_words(PAGE({**given, "language": language}), axis.stem)
        assert len(found) > 20 if language == "en" else not found, found


@pytest.mark.parametrize("control", FORMATS)
def test_no_english_is_on_the_german_card_and_report_of_any_control(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, control: str
) -> None:
    """That each sentence has every language is tested with the catalogue: here texts that passed it
    by would be found. Names in code and quoted messages of a control stay as they are.
    """
    given: dict[str, Any] = {}

    def kept(document: dict[str, Any], *_: object) -> bytes:
        given["report" if "evaluation" in document else "card"] = document
        return b""

    machine = Machine()
    targets = machine.targets(11)
    (tmp_path / "x.csv").write_text(csv_of(targets, machine.measure(targets, 5), "X"))
    monkeypatch.setattr(card, "card_html", kept)
    monkeypatch.setattr(report, "run_report", kept)
    assert compwright(run_arguments(tmp_path, control, machine, "none")) in {0, 1}
    for language in ("en", "de"):
        pages = [
            card_html({**given["card"], "language": language}),
            run_report({**given["report"], "language": language}),
        ]
        for page in pages:
            found = english_words(page, str(tmp_path))
            assert len(found) > 20 if language == "en" else not found, found
