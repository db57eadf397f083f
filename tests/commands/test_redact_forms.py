"""A form of measurement files and a shape of controls bring their own redaction: none can be entered
without it, and what it forgets does not stay.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from compwright.cli import run as compwright
from compwright.formats.definition.shape_rules import ShapeRules
from compwright.formats.families.shapes import RULES
from compwright.foundations.redaction import Cuts, Names
from compwright.instruments import forms
from compwright.instruments.b5r_elements import ELEMENTS
from compwright.instruments.circular_reading import (
    CIRCULAR_FORMS,
    CircularForm,
    circular_form,
    read_circular,
)
from compwright.instruments.csv_table import row_cells
from compwright.instruments.forms import FORMS, PLAIN_CSV, MeasurementForm, form_of
from compwright.instruments.other_files import ACCEPTED_FORMS
from compwright.instruments.redaction.cutting import KEPT, redacted_lines
from compwright.instruments.safe_xml import Element
from compwright.instruments.spans import Spans, TextSpan, whole
from places import PROJECT
from redaction_samples import BALLBAR, CONTROLS, FREE, PLAIN, filled

_LASER = "MYLASER 1\nUser {S}\n0 0.001\n100 0.002\n"


def _spans(text: Sequence[str]) -> Iterator[Spans]:
    """The spans of a form that nobody knows yet; the second line is forgotten."""
    for number, line in enumerate(text):
        rows = whole(line, "key" if number == 0 else "row")
        yield () if number == 1 else rows


def _new_form() -> MeasurementForm:
    def read(text: Sequence[str], faults: object, answers: object) -> object:
        rows = "".join(",+,1,".join(line.split()) + "\n" for line in text[2:] if line)
        plain = f"target_mm,direction,run,deviation_mm\n{rows}".split("\n")
        return PLAIN_CSV.read(plain, faults, answers)  # type: ignore[arg-type]

    return MeasurementForm(
        "a new laser (.new)",
        lambda text: text[0] == "MYLASER 1",
        read,  # type: ignore[arg-type]
        _spans,
        ("MYLASER",),
    )


def test_a_form_is_redacted_as_soon_as_it_is_entered(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(forms, "FORMS", (*FORMS, _new_form()))
    (tmp_path / "x.new").write_bytes(filled(_LASER))
    assert compwright(["redact", str(tmp_path / "x.new"), "--out", str(tmp_path / "out")]) == 0
    copy = (tmp_path / "out" / "x.new").read_text()
    assert copy == "MYLASER 1\nredacted\n0 0.001\n100 0.002\n"


@pytest.mark.parametrize("form", [MeasurementForm, CircularForm])
def test_no_form_is_made_without_what_redacts_it(
    form: type[MeasurementForm | CircularForm],
) -> None:
    given = {"name": "x", "recognises": bool, "read": bool, "words": ()}
    names = {name: given[name] for name in given if name in form.__dataclass_fields__}
    with pytest.raises(TypeError, match=r"spans_of|grammar"):
        form(**names)  # type: ignore[arg-type]


def test_every_form_has_a_sample_with_a_secret_at_every_place() -> None:
    lines = {name: filled(text).decode().splitlines() for name, text in PLAIN.items()}
    assert {form_of(text, "").name for text in lines.values()} == {
        form.name for form in (*FORMS, PLAIN_CSV)
    }
    circles = (filled(BALLBAR), filled(PLAIN["circle"]))
    assert {circular_form(content).name for content in circles} == {
        form.name for form in CIRCULAR_FORMS
    }


@pytest.mark.parametrize("form", [*FORMS, PLAIN_CSV, *CIRCULAR_FORMS], ids=lambda form: form.name)
def test_every_form_stands_on_the_page_and_in_messages(
    form: MeasurementForm | CircularForm,
) -> None:
    page = (PROJECT / "docs" / "measurement-files.md").read_text(encoding="utf-8")
    rows = " ".join(re.findall(r"^\| ([^|]+) \|", page, re.MULTILINE))
    named = re.findall(r"\.[a-z0-9]{3}\b|TGT_DATA\[1\]=\.\.\.", form.name) or [form.name]
    assert [name for name in named if name not in rows] == []
    if isinstance(form, MeasurementForm):
        assert [name for name in named if name not in ACCEPTED_FORMS] == []


def test_the_reader_of_a_ballbar_asks_for_no_element_that_its_copy_would_lose(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    asked: set[str] = set()
    right = Element.all

    def noted(element: Element, *path: str) -> Iterator[Element]:
        asked.update((element.tag, *path))
        return right(element, *path)

    monkeypatch.setattr(Element, "all", noted)
    read_circular(filled(BALLBAR), "x.b5r")
    assert len(asked) > 40
    assert asked - set(ELEMENTS.tags) == set()


def test_what_no_span_covers_goes_but_for_marks_and_blanks() -> None:
    cuts = Cuts(Names())
    lines = ["Erika: 5 mm", "::  ;;", "4711", "a 1 b", "x = y"]
    spans: list[Spans] = [(), (), (), (TextSpan(2, 3, "numbers"),), (TextSpan(0, 1, "key"),)]
    made = redacted_lines(lines, lambda _: iter(spans), cuts)
    assert made == ["redacted", "::  ;;", "redacted", "redacted1redacted", "xredacted"]
    assert [text for _, text in cuts.removed] == ["Erika: 5 mm", "4711", "a", "b", "= y"]


def test_no_meaning_but_a_word_of_the_form_lets_a_name_stay() -> None:
    assert [meaning for meaning, kept in KEPT.items() if kept(FREE) or kept("Zerspanwerk")] == [
        "key"
    ]


@pytest.mark.parametrize("name", sorted(PLAIN))
def test_spans_stand_in_their_line_one_behind_the_other(name: str) -> None:
    text = filled(PLAIN[name]).decode().split("\n")
    form = PLAIN_CSV if name == "circle" else form_of(text, "")
    for line, spans in zip(text, form.spans_of(text), strict=True):
        ends = [0, *(place for span in spans for place in (span.start, span.end)), len(line)]
        assert ends == sorted(ends), line


def test_no_shape_of_controls_is_made_without_the_lines_that_may_stay() -> None:
    with pytest.raises(TypeError, match="kept"):
        ShapeRules(words="x", grid=())  # type: ignore[call-arg]


@pytest.mark.parametrize("shape", sorted(RULES))
def test_no_line_of_a_shape_that_stays_holds_a_name(shape: str) -> None:
    kept = RULES[shape].kept
    for line in ("Zerspanwerk", "Muehlbauer GmbH", "N10037Q0P0(Erika)", "; Erika", "$MN_A=Erika"):
        assert not kept.stays(line)
        assert not kept.holds_names(line)


@given(
    cells=st.lists(
        st.text(alphabet='ab1 "\t', max_size=5) | st.sampled_from(['"a,b"', '"a ""b"" ;"', "1.5"]),
        min_size=1,
        max_size=5,
    ),
    delimiter=st.sampled_from(",;\t"),
)
@example(['1"', "b", '"', "2"], ",")
def test_spans_of_cells_are_the_cells_that_are_read(cells: list[str], delimiter: str) -> None:
    line = delimiter.join(cells)
    read = row_cells(line, delimiter)
    assume(read is not None and line.strip(" \t,;") and not line.lstrip(' "').startswith("#"))
    _, spans = PLAIN_CSV.spans_of([f"target_mm{delimiter}x", line])
    for span, cell in zip(spans, read or (), strict=True):
        text = line[span.start : span.end]
        (bare,) = next(csv.reader([text], delimiter=delimiter, skipinitialspace=True), None) or [""]
        assert bare.strip() == cell


def copied(tmp_path: Path, name: str, text: str) -> str:
    """Return the only copy of a file."""
    (tmp_path / name).write_text(text)
    assert compwright(["redact", str(tmp_path / name), "--out", str(tmp_path / "out")]) == 0
    return (tmp_path / "out" / name).read_text()


def test_quoted_numbers_and_their_quotes_stay(tmp_path: Path) -> None:
    text = '"target_mm","direction","run","deviation_um"\n"0.5","+","1", 0.4\n"100","+","1","2.1"\n'
    assert copied(tmp_path, "x.csv", text) == text


def test_numbers_above_the_rows_of_a_compensation_text_go(tmp_path: Path) -> None:
    text = filled(PLAIN["ren"]).decode()
    made = copied(tmp_path, "x.ren", f"48151623\r\n{text}")
    assert made.startswith("redacted")


def test_a_value_with_two_remarks_stays_without_them(tmp_path: Path) -> None:
    text = CONTROLS["heidenhain"]["MP.TXT"].replace(" ; {W}", " ; Erika ; Vogt")
    made = copied(tmp_path, "MP.TXT", text.replace("{S}", "").replace("{W}", "5"))
    assert "MP710.1 : 0.0010 ; redacted\n" in made


def test_what_stands_behind_the_name_of_a_section_is_counted_and_goes(tmp_path: Path) -> None:
    text = CONTROLS["linuxcnc"]["machine.ini"].replace("{S}", "").replace("{W}", "vogt")
    made = copied(tmp_path, "machine.ini", text.replace("[vogt]", "[vogt] Erika"))
    assert "erika" not in made.lower()
    assert "# redacted\n# redacted\n[TRAJ]" in made


def test_a_table_is_known_by_its_first_line_whatever_else_stands_on_it(tmp_path: Path) -> None:
    text = CONTROLS["heidenhain"]["X.COM"].partition("#STRUCT")[0].strip() + " U\n"
    rows = "NR      1=F()     2=F()\n0       +0.000    +0.0000\n1       -0.002    +0.0001\n"
    text = f"{text}{rows}END X .COM\n"
    assert copied(tmp_path, "X.COM", text) == text


def test_what_stands_behind_a_remark_goes_with_it(tmp_path: Path) -> None:
    made = copied(tmp_path, "CNC-PARA.TXT", "%\nN03620Q1A1P40A2P0\n(A)Erika (B) Vogt\n%\n")
    assert made == "%\nN03620Q1A1P40A2P0\n(redacted)\n%\n"


def test_a_machine_that_is_called_as_a_result_is_has_no_name_and_the_instrument_keeps_its_own(
    tmp_path: Path,
) -> None:
    text = BALLBAR.replace('MACHINE_TESTED NAME="{S}"', 'MACHINE_TESTED NAME="TEST-54"')
    text = re.sub("<COMMENT.*</COMMENT>", "<COMMENT>QC20 of Vogt, redacted</COMMENT>", text)
    made = copied(tmp_path, "x.b5r", filled(text).decode())
    assert "TEST-54" not in made
    assert "Vogt" not in made
    assert 'MODEL="QC20-W"' in made
