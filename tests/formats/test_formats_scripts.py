"""A script of commands as the text room reads it: a command opens a block, the block holds whole
numbers over any number of lines, several settings stand on one line. The text is the worked example
of the PMAC manuals (DEFINE COMP, Turbo PMAC software reference), the expected tokens are counted by
hand.
"""

from __future__ import annotations

from dataclasses import replace

from compwright.formats.definition.schema import Definition, Statement, TextKind
from compwright.formats.definition.statements import Occurrence, print_form
from compwright.formats.definition.vocabulary import FieldType
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile
from format_samples import SIEMENS

NOTE = SIEMENS.layout.evidence
SCRIPT = """\
I51=0 ; tables off
#1 DEFINE COMP 4,#1D,400000
-32 -48
16\t0
#1 DEFINE BLCOMP 4,400000
8 12 -4 0
I185=32 I186=96
I51=1
"""


def statement(
    name: str, form: str, fields: dict[str, FieldType], within: str | None = None
) -> Statement:
    return Statement(name, "script", form, (), fields, within, "none", NOTE)


def script() -> Definition:
    table = "{motor} DEFINE COMP {entries},#{source}D,{length}"
    statements = [
        statement("block", "#{section}", {"section": "label"}),
        statement("entries", "({value})*", {"value": "signed"}, table),
        statement("pairs", "({value})*", {"value": "signed"}, "{motor} DEFINE BLCOMP {entries},{length}"),
        statement("setting", "(I{number}={value})*", {"number": "integer", "value": "signed"}),
    ]  # fmt: skip
    kind = TextKind(
        name="script",
        recognised_by=None,
        sections="block",
        comment_marks=(";",),
        comments_anywhere=True,
        blank_lines_anywhere=True,
        claims_at_start=(),
        claims_anywhere=("DEFINE",),
        other_lines_refused=True,
        because="each line is a command",
        ends_with=(),
        evidence=NOTE,
    )
    dialect = replace(SIEMENS.dialect, block_number=None, line_checksum=None)
    addresses = replace(SIEMENS.addresses, type="integer")
    return replace(
        SIEMENS,
        dialect=dialect,
        addresses=addresses,
        texts={"script": kind},
        statements={each.name: each for each in statements},
    )


def read(text: str) -> tuple[list[Occurrence], list[Fault]]:
    faults: list[Fault] = []
    found = text_reader(script()).read(ControlFile("comp.pmc", text.encode()), faults)
    assert found is not None
    return list(found.occurrences), faults


def test_the_numbers_of_a_block_are_its_rows_wherever_the_lines_end() -> None:
    found, faults = read(SCRIPT)
    assert faults == []
    rows = [one for one in found if one.statement == "entries"]
    assert [one.tokens["value"].text for one in rows] == ["-32", "-48", "16", "0"]
    assert {one.tokens["motor"].text for one in rows} == {"1"}
    assert {one.tokens["length"].text for one in rows} == {"400000"}
    pairs = [one.tokens["value"].text for one in found if one.statement == "pairs"]
    assert pairs == ["8", "12", "-4", "0"]


def test_every_number_and_every_field_of_the_command_has_its_place_in_the_file() -> None:
    found, _ = read(SCRIPT)
    for one in found:
        for token in one.tokens.values():
            assert SCRIPT[token.start : token.end] == token.text


def test_several_settings_on_one_line_are_statements_of_their_own() -> None:
    found, _ = read(SCRIPT)
    settings = [
        (one.tokens["number"].text, one.tokens["value"].text)
        for one in found
        if one.statement == "setting"
    ]
    assert settings == [("51", "0"), ("185", "32"), ("186", "96"), ("51", "1")]


def test_two_numbers_are_never_read_out_of_one() -> None:
    # Ten digits are more than a field holds: that is no pair of numbers.
    found, faults = read(SCRIPT.replace("16\t0", "1234567890 0"))
    assert [fault.place for fault in faults] == ["line 4"]
    rows = [one.tokens["value"].text for one in found if one.statement == "entries"]
    assert rows == ["-32", "-48"]


def test_a_repeating_number_is_printed_once() -> None:
    assert print_form("({value})*", {"value": "-32"}) == "-32"
