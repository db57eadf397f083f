"""The printed card: at most a page for the control and one for each axis, in every language."""

from __future__ import annotations

import io
import json
import shutil
from pathlib import Path
from typing import Any

import pypdf
import pytest
from test_every_control import ADDRESS, FORMATS, FORMS, OPTIONS

from compwright.cli import run as compwright
from compwright.reporting import card
from compwright.reporting.card import card_html
from compwright.reporting.card_steps import step_lines
from compwright.reporting.pdf import pdf_of_page
from loop import Machine, csv_of
from places import PROJECT

pytestmark = pytest.mark.short_estimate

LANGUAGES = ("en", "de", "fr", "ru")
ADDRESSES = {"AX1": ("AX1", "AX2", "AX3"), "X": ("X", "Y", "Z"), "0": ("0", "1", "2")}


def job_of(folder: Path, control: str, count: int) -> str:
    """Write a job of some measured axes and return its name."""
    machine = Machine()
    targets = machine.targets(11)
    options = dict(OPTIONS.get(control, {}))
    first = options.pop("first_point", None)
    axes = {}
    addresses = ADDRESSES.get(ADDRESS[control], ("1", "2", "3"))
    for place, (name, address) in enumerate(zip("XYZ"[:count], addresses, strict=False)):
        file = f"{name}.csv"
        (folder / file).write_text(csv_of(targets, machine.measure(targets, 5 + place), name))
        axes[name] = {
            "travel": [machine.low, machine.high],
            "address": address,
            "accept": {"A": 12, "B": 5},
            "before": [file],
            "options": {} if first is None else {"first_point": 200 * place},
        }
    job = {
        "compwright": 1,
        "controller": {"format": control, "options": options},
        "states": {"as_found": "none"},
        "axes": axes,
    }
    (folder / "job.yaml").write_text(json.dumps(job))
    return str(folder / "job.yaml")


def card_of(job: str, patch: pytest.MonkeyPatch) -> dict[str, Any]:
    """Run a job and return what its card shows."""
    given: list[dict[str, Any]] = []

    def kept(document: dict[str, Any], *_: object) -> bytes:
        given.append(document)
        return b""

    patch.setattr(card, "card_html", kept)
    assert compwright(["run", job]) in {0, 1}
    return given[-1]


def pages_of(document: dict[str, Any]) -> dict[str, int]:
    """The number of printed pages of a card by language, in the two languages with the most text."""
    pages = {each: card_html({**document, "language": each}) for each in LANGUAGES}
    longest = sorted(pages, key=lambda each: len(pages[each].decode("utf-8")))[-2:]
    return {
        each: len(pypdf.PdfReader(io.BytesIO(pdf_of_page(pages[each]))).pages) for each in longest
    }


@pytest.mark.parametrize(
    ("control", "count"), [*((name, 1) for name in FORMATS), *((name, 3) for name in FORMS)]
)
def test_a_page_for_the_control_and_one_for_each_axis(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, control: str, count: int
) -> None:
    pages = pages_of(card_of(job_of(tmp_path, control, count), monkeypatch))
    assert max(pages.values()) <= 1 + count, pages


@pytest.mark.real_pages
def test_entries_of_a_backup_do_not_need_another_page(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The list of changed entries and a note about the language come on top. Values to be read have
    minus signs.
    """
    folder = tmp_path / "work"
    shutil.copytree(PROJECT / "examples" / "fanuc-backup", folder)
    document = card_of(str(folder / "job.yaml"), monkeypatch)
    pages = pages_of(document)
    assert max(pages.values()) <= 2, pages
    values = " ".join(row[key] for row in document["axes"][0]["rows"] for key in ("old", "new"))
    assert "−" in values
    assert "-" not in values


def test_what_holds_for_every_axis_is_on_the_card_once() -> None:
    text = "Both together. Type 3620 = 40. Compare.\nBoth together. Type 3620 = 140. Compare."
    lines = step_lines({"text": text}, "en")
    assert [(line["text"], line["tick"]) for line in lines] == [
        ("Both together.", False),
        ("Type 3620 = 40.", True),
        ("Type 3620 = 140.", True),
        ("Compare.", False),
    ]
