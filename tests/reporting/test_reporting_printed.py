"""A page printed by a browser has the pages of its PDF. Skipped where there is no chromium."""

from __future__ import annotations

import io
import shutil
import subprocess
from pathlib import Path

import pypdf
import pytest

from compwright.reporting.card import card_html
from compwright.reporting.evaluation_report import evaluation_report
from compwright.reporting.pdf import pdf_of_page
from compwright.reporting.run_report import run_report
from compwright.reporting.verify_report import verify_report
from reporting_samples import made_up, run_view, sample_card, verify_view

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")

pytestmark = [
    pytest.mark.real_pages,
    pytest.mark.skipif(BROWSER is None, reason="no chromium to print pages with"),
]

EVALUATION = {"schema": "compwright/evaluation/1", "results": [made_up()], "errors": []}
PAGES = {
    "run": lambda language: run_report({**run_view(), "language": language}),
    "verify": lambda language: verify_report({**verify_view(), "language": language}),
    "card": lambda language: card_html({**sample_card(), "language": language}),
    "evaluation": lambda language: evaluation_report(
        {"evaluation": EVALUATION, "command": "compwright", "language": language}
    ),
}


def first_words(pdf: bytes) -> list[str]:
    """Return the first word of each page."""
    return [page.extract_text().split()[0] for page in pypdf.PdfReader(io.BytesIO(pdf)).pages]


@pytest.mark.parametrize(
    ("kind", "language"), [("run", "de"), ("verify", "en"), ("card", "de"), ("evaluation", "en")]
)
def test_a_printed_page_has_the_pages_of_the_pdf(tmp_path: Path, kind: str, language: str) -> None:
    page = PAGES[kind](language)
    (tmp_path / "page.html").write_bytes(page)
    printed = tmp_path / "printed.pdf"
    subprocess.run(
        [
            str(BROWSER), "--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
            f"--print-to-pdf={printed}", (tmp_path / "page.html").as_uri(),
        ],
        check=True,
        capture_output=True,
        timeout=300,
    )  # fmt: skip
    assert len(first_words(printed.read_bytes())) == len(first_words(pdf_of_page(page)))
