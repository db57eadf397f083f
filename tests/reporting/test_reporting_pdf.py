"""Reports as PDF: the words of the HTML page, the same bytes each time, PDF/A-2b and PDF/UA-1.

typst writes no file that breaks one of the two. Pages of each kind were also checked with pdfua
0.1.3 (its 16 rules: no finding), outloud 0.2.1 (PDF/UA-1: only that heads of tables which repeat on
the next page are marked as artifacts, as they must be) and ``qpdf --check`` 11.3. A second check of
PDF/A (veraPDF) was not available.
"""

from __future__ import annotations

import io
import re
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pypdf
import pytest
from pypdf.generic import IndirectObject

from compwright.cli import run as compwright
from compwright.foundations.errors import UsageError
from compwright.reporting.evaluation_report import evaluation_report
from compwright.reporting.pdf import pdf_of_page
from compwright.reporting.run_report import run_report
from compwright.reporting.verify_report import verify_report
from places import STANDARD_TABLES, needs_shared
from reporting_samples import made_up, run_view, verify_view

pytestmark = pytest.mark.real_pages

HOSTILE = (
    "#import \"x\": * $x^2$ <label> @ref [b] *b* _i_ `c` // /* \\u{41} \\ ~ --- 'q' & </script>"
)
CYRILLIC = "Станок № 7, ось X"
CHINESE = "测试机床"
PAGE, FOOTER = 842, 40  # the height of A4 and where the footer ends, in points


def csv_text(axis: str = "X", targets: int = 11, runs: int = 2, **header: str) -> str:
    lines = [f"# {key}: {value}" for key, value in {"axis": axis, **header}.items()]
    lines.append("target_mm,direction,run,deviation_um")
    lines += [
        f"{10 * place}.25,{direction},{run},{((place * 7 + run * 3) % 11) / 4 + lost:.2f}"
        for direction, lost in (("+", -1.0), ("-", 1.0))
        for run in range(1, runs + 1)
        for place in range(targets)
    ]
    return "\n".join(lines) + "\n"


def evaluated(folder: Path, *files: str, name: str = "out.pdf") -> bytes:
    report = folder / name
    assert compwright(["evaluate", *files, "--report", str(report), "--force"]) == 0
    return report.read_bytes()


def text_of(pdf: bytes) -> str:
    return "\n".join(page.extract_text() for page in pypdf.PdfReader(io.BytesIO(pdf)).pages)


def squeezed(text: str) -> str:
    return re.sub(r"[\s\u200b\u00ad]+", "", text)


def printed(page: bytes) -> Iterator[str]:
    """Yield the words of each element of a page that is printed and holds no other block."""
    blocks = {"td", "th", "p", "li", "h1", "h2", "h3", "dt", "dd", "summary", "figcaption"}

    def walk(element: ET.Element) -> Iterator[str]:
        for child in element:
            if child.tag in {"nav", "style", "svg"}:
                continue
            if child.tag == "details" and child.get("open") is None:
                continue
            if child.tag in blocks and not any(
                inner.tag in blocks for inner in child.iter() if inner is not child
            ):
                yield from " ".join(child.itertext()).split()
            else:
                yield from walk(child)

    (body,) = ET.fromstring(page.decode()).iterfind("body")  # noqa: S314  our own page
    yield from walk(body)


def samples() -> dict[str, bytes]:
    results = [made_up(standard=standard) for standard in ("iso230-2:2014", "gost27843:2006")]
    evaluation = {"schema": "compwright/evaluation/1", "results": results, "errors": []}
    return {
        "evaluation": evaluation_report({"evaluation": evaluation, "command": "compwright"}),
        "run": run_report(run_view()),
        "verify": verify_report(verify_view()),
    }


def test_pdf_says_every_word_of_the_page() -> None:
    for name, page in samples().items():
        text = squeezed(text_of(pdf_of_page(page)))
        words = list(printed(page))
        assert len(words) > 200
        assert [word for word in words if squeezed(word) not in text] == [], name


def test_same_bytes_twice_and_in_another_process(tmp_path: Path) -> None:
    page = samples()["run"]
    source = tmp_path / "page.html"
    source.write_bytes(page)
    program = (
        "import sys, pathlib; from compwright.reporting.pdf import pdf_of_page;"
        "sys.stdout.buffer.write(pdf_of_page(pathlib.Path(sys.argv[1]).read_bytes()))"
    )
    other = subprocess.run(
        [sys.executable, "-c", program, str(source)],
        check=True,
        capture_output=True,
        cwd=tmp_path,
        env={"TZ": "Asia/Tokyo", "SOURCE_DATE_EPOCH": "1000000000"},
    ).stdout
    assert pdf_of_page(page) == pdf_of_page(page) == other


def test_date_is_that_of_the_test(tmp_path: Path) -> None:
    for text, day in (
        ("2026-03-14 08:30", "20260314"),
        ("20251206-071745", "20251206"),
        ("2026-13-45", "19700101"),
        ("", "19700101"),
    ):
        (tmp_path / "x.csv").write_text(csv_text(date=text))
        metadata = pypdf.PdfReader(
            io.BytesIO(evaluated(tmp_path, str(tmp_path / "x.csv")))
        ).metadata
        assert metadata is not None
        assert str(metadata["/CreationDate"])[2:10] == day


def _resolved(value: Any) -> Any:
    return value.get_object() if isinstance(value, IndirectObject) else value


def _structure(node: Any) -> Iterator[Any]:
    node = _resolved(node)
    if isinstance(node, dict):
        if "/S" in node:
            yield node
        children = _resolved(node.get("/K", []))
        for child in children if isinstance(children, list) else [children]:
            yield from _structure(child)


def test_archive_and_accessibility_marks() -> None:
    for name, page in samples().items():
        reader = pypdf.PdfReader(io.BytesIO(pdf_of_page(page)))
        catalog: Any = reader.trailer["/Root"]
        metadata = _resolved(catalog["/Metadata"]).get_data().decode()
        assert re.search(r"pdfaid:part>2<", metadata), name
        assert re.search(r"pdfaid:conformance>B<", metadata)
        assert re.search(r"pdfuaid:part>1<", metadata)
        assert catalog["/Lang"] == "en"
        assert _resolved(catalog["/MarkInfo"])["/Marked"]
        assert _resolved(catalog["/ViewerPreferences"])["/DisplayDocTitle"]
        assert "/OutputIntents" in catalog
        nodes = list(_structure(catalog["/StructTreeRoot"]))
        figures = [node for node in nodes if node["/S"] == "/Figure"]
        assert figures
        assert all(str(node["/Alt"]).strip() for node in figures)
        kinds = {str(node["/S"]) for node in nodes}
        assert {"/H1", "/H2", "/Table", "/TH", "/TD", "/P"} <= kinds
        for sheet in reader.pages:
            for font in _resolved(_resolved(sheet["/Resources"]).get("/Font", {})).values():
                for below in _resolved(_resolved(font)["/DescendantFonts"]):
                    descriptor = _resolved(_resolved(below)["/FontDescriptor"])
                    assert {"/FontFile2", "/FontFile3"} & set(descriptor)


def test_hostile_texts_are_printed_as_text(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text(
        csv_text(
            machine=HOSTILE,
            operator=CYRILLIC,
            place="Ж" * 10_000,
            coolant="a word " * 1500,
            serial=f"{CHINESE} and \U0001f996",
        ),
        encoding="utf-8",
    )
    pdf = evaluated(tmp_path, str(tmp_path / "x.csv"))
    text = squeezed(text_of(pdf))
    assert squeezed(HOSTILE) in text
    assert squeezed(CYRILLIC) in text
    assert re.sub(r"ReportwithoutanumberPage\d+of\d+", "", text).count("Ж") >= 10_000
    # What the font lacks is printed by its number, and the first page says so.
    assert "".join(f"[U+{ord(letter):04X}]" for letter in CHINESE) in text
    assert "[U+1F996]" in text
    first = pypdf.PdfReader(io.BytesIO(pdf)).pages[0].extract_text()
    assert "does not hold every letter" in " ".join(first.split())


def test_nothing_lies_outside_the_paper(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text(csv_text(machine="M" * 400, comment="x/" * 300, runs=10))
    outside: list[tuple[str, float]] = []

    def seen(text: str, page: list[float], line: list[float], _font: Any, size: float) -> None:
        across = line[4] * page[0] + line[5] * page[2] + page[4]
        if text.strip() and not 35 < across < 560:
            outside.append((text, across))

    reader = pypdf.PdfReader(io.BytesIO(evaluated(tmp_path, str(tmp_path / "x.csv"))))
    for page in reader.pages:
        page.extract_text(visitor_text=seen)
    assert outside == []


def lines_of(page: pypdf.PageObject) -> list[tuple[float, bool]]:
    """The lines of a page above its footer, from below: their height, and whether all is bold."""
    lines: dict[int, list[bool]] = {}

    def seen(text: str, page: list[float], line: list[float], font: Any, _size: float) -> None:
        height = round(line[4] * page[1] + line[5] * page[3] + page[5])
        if text.strip() and font and height > FOOTER:
            lines.setdefault(height, []).append("Bold" in str(font["/BaseFont"]))

    page.extract_text(visitor_text=seen)
    return [(height, all(bold)) for height, bold in sorted(lines.items())]


@pytest.mark.parametrize(("count", "language"), [(1, "en"), (3, "de")])
def test_no_page_is_left_half_empty(count: int, language: str) -> None:
    """A figure with its words takes less than a third of a page: no more stays empty."""
    view = run_view()
    axes, predicted = view["axes"], view["prediction"]["axes"]
    results = view["evaluation"]["results"]
    result = next(one for one in results if one["axis"] == "X")
    names = ["X", "Y", "Z", "W"][:count]
    view["axes"] = dict.fromkeys(names, axes["X"])
    view["prediction"]["axes"] = dict.fromkeys(names, predicted["X"])
    view["evaluation"]["results"] = [{**result, "axis": name} for name in names]
    pdf = pdf_of_page(run_report({**view, "language": language}))
    *pages, last = pypdf.PdfReader(io.BytesIO(pdf)).pages
    for number, page in enumerate(pages, 1):
        lowest, _ = lines_of(page)[0]
        assert (number, lowest) < (number, FOOTER + PAGE / 3)
    assert len(lines_of(last)) > 5


def test_no_heading_is_left_alone_at_the_end_of_a_page() -> None:
    """Nor the head of a table: a row of it follows, also where a sentence is between them."""
    row = '<tr><td class="words">Row</td></tr>'
    table = f"<table><thead><tr><th>Head</th></tr></thead><tbody>{row}</tbody></table>"
    sections = "".join(
        f"<h2>Section</h2><p>Introduction</p><h3>Table</h3>{table}"
        + "<p>Text</p>" * (place**2 % 7 + place // 9 % 3)
        for place in range(120)
    )
    head = '<html lang="en"><head><title>P</title></head>'
    page = f"{head}<body><h1>P</h1>{sections}</body></html>"
    *pages, _ = pypdf.PdfReader(io.BytesIO(pdf_of_page(page.encode()))).pages
    ends = {sheet.extract_text().split()[-5] for sheet in pages}
    assert len(pages) > 8
    assert ends == {"Row", "Text"}


def test_table_heads_repeat_over_200_targets(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text(csv_text(targets=200, runs=5))
    reader = pypdf.PdfReader(io.BytesIO(evaluated(tmp_path, str(tmp_path / "x.csv"))))
    pages = [page.extract_text() for page in reader.pages]
    tables = [text for text in pages if len(re.findall(r"\d{3,4}\.25", text)) > 20]
    assert len(tables) >= 4
    assert all("Position" in text for text in tables)


def test_twenty_axes_in_ten_seconds(tmp_path: Path) -> None:
    names = []
    for place in range(20):
        names.append(str(tmp_path / f"a{place}.csv"))
        Path(names[-1]).write_text(csv_text(axis=f"A{place}", targets=21, runs=5))
    evaluated(tmp_path, *names, name="out.html")
    page = (tmp_path / "out.html").read_bytes()
    start = time.process_time()
    pdf = pdf_of_page(page)
    assert time.process_time() - start < 10.0
    assert len(pypdf.PdfReader(io.BytesIO(pdf)).pages) > 20  # one each, and annexes


def test_logo_and_number_of_the_report() -> None:
    svg = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><rect width="9" height="9"/></svg>'
    import base64

    logo = {"type": "image/svg+xml", "base64": base64.b64encode(svg.encode()).decode()}
    page = run_report({**run_view(), "report": {"number": "2026-117", "logo": logo}})
    reader = pypdf.PdfReader(io.BytesIO(pdf_of_page(page)))
    for number, sheet in enumerate(reader.pages, 1):
        text = " ".join(sheet.extract_text().split())
        assert "Report 2026-117" in text
        assert f"Page {number} of {len(reader.pages)}" in text


def test_without_the_pdf_extra(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.csv").write_text(csv_text())
    monkeypatch.setitem(sys.modules, "typst", None)
    with pytest.raises(UsageError):
        pdf_of_page(b"<html/>")
    report = tmp_path / "out.pdf"
    assert compwright(["evaluate", str(tmp_path / "x.csv"), "--report", str(report)]) == 2
    (line,) = [line for line in capsys.readouterr().err.splitlines() if "error" in line]
    assert "PDF reports need the package typst" in line
    assert f'"{sys.executable}" -m pip install jinja2 matplotlib typst~=0.15.2' in line
    assert not report.exists()


def test_no_package_and_no_network() -> None:
    source = Path(sys.modules["compwright"].__path__[0]) / "reporting/templates/page.typ"
    assert "import" not in source.read_text(encoding="utf-8")


@needs_shared
def test_printed_table_of_the_standard(tmp_path: Path) -> None:
    """The values that ISO 230-2:1988 prints for its table 2, on paper."""
    table = STANDARD_TABLES / "iso-230-2-1988-table-2.csv"
    report = tmp_path / "out.pdf"
    assert (
        compwright(["evaluate", str(table), "--standard", "iso230-2:1988", "--report", str(report)])
        == 0
    )
    assert "ISO 230-2:1988" in text_of(report.read_bytes())


def test_words_next_to_a_bar_keep_their_width() -> None:
    words = "error that the test did not show between the targets"
    bar = '<svg viewBox="0 0 200 18" aria-hidden="true"><rect width="9" height="9"></rect></svg>'
    page = (
        '<html lang="en"><head><title>Bars</title></head><body><h1>Bars</h1><table><thead><tr>'
        '<th>Cause</th><th class="n">Part</th><th class="bar"></th></tr></thead><tbody><tr>'
        f'<td class="words">{words}</td><td class="n">1.2</td><td class="bar">{bar}</td></tr>'
        "</tbody></table></body></html>"
    )
    assert words in text_of(pdf_of_page(page.encode()))


def test_a_long_value_breaks_in_its_column() -> None:
    value = "MD32450 $MA_BACKLASH[0,MA_Y] = 0.006005 mm (6.00 µm)"
    page = (
        '<html lang="en"><head><title>Values</title></head><body><h1>Values</h1><table><thead><tr>'
        '<th>Quantity</th><th class="n">Old</th><th class="n">New</th></tr></thead><tbody><tr>'
        f'<td>backlash in addition to the table</td><td class="n">{value}</td>'
        f'<td class="n">{value}</td></tr></tbody></table></body></html>'
    )
    text = text_of(pdf_of_page(page.encode())).replace("\u00a0", " ")
    assert squeezed(value) in squeezed(text)
    assert value not in text  # in one line it runs over the column next to it
