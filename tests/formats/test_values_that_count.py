"""Which of several places in a control's files counts, and what holds where none does."""

from __future__ import annotations

from dataclasses import replace

import pytest

from compwright.formats.definition.schema import Absent, EvidenceNote
from compwright.formats.definition.vocabulary import Repeated, Say
from compwright.formats.text.gathering import FoundValue, gather
from compwright.formats.text.notes import Notes
from compwright.formats.text.texts import text_reader
from compwright.formats.text.values import Values
from compwright.records.correction import ControlFile
from format_samples import SIEMENS


def places(*files: str) -> list[FoundValue]:
    """The backlash of AX1 wherever files a, b, .. say it."""
    reader = text_reader(SIEMENS)
    texts = [
        reader.read(ControlFile(name, text.encode()), [], number)
        for number, (name, text) in enumerate(zip("abc", files, strict=False))
    ]
    gathered = gather(SIEMENS, [text for text in texts if text is not None])
    return gathered.found("backlash", "AX1", "0")


def line(value: str) -> str:
    return f"$MA_BACKLASH[0,AX1]={value}\n"


def values(rule: Repeated = "last", say: Say | None = None) -> Values:
    binding = SIEMENS.bindings["backlash"]
    absent = None if say is None else Absent("0", say, EvidenceNote("unconfirmed", "no file"))
    bindings = {**SIEMENS.bindings, "backlash": replace(binding, repeated=rule, when_absent=absent)}
    return Values(replace(SIEMENS, bindings=bindings), "axis AX1", Notes())


@pytest.mark.parametrize(("rule", "text"), [("first", "1"), ("last", "3")])
def test_within_a_file_the_first_or_the_last_counts_and_that_is_told(
    rule: Repeated, text: str
) -> None:
    read = values(rule)
    found = read.one("backlash", places(line("1") + line("2") + line("3")))
    assert found is not None
    assert found.text == text
    assert read.notes.faults == []
    assert [note.code for note in read.notes.findings] == ["CW-S003"]
    assert f"The {rule} value is used: {text} (a, line {text})" in read.notes.findings[0].message


def test_where_all_must_be_the_same_both_lines_that_differ_are_named() -> None:
    read = values("same")
    assert read.one("backlash", places(line("1") + line("1.0") + line("2"))) is None
    (fault,) = read.notes.faults
    assert (fault.file, fault.place, fault.expected, fault.found) == ("a", "line 1", "2", "1")
    assert fault.message == "axis AX1: $MA_BACKLASH contradicts a, line 3"


def test_several_files_have_to_agree_on_the_value_that_counts_in_each() -> None:
    agreeing = places(line("5") + line("1"), line("1.000"))
    found = values("last").one("backlash", agreeing)
    assert found is not None
    assert found.where == "a, line 2"
    read = values("last")
    assert read.one("backlash", places(line("1"), line("7") + line("2"))) is None
    (fault,) = read.notes.faults
    assert (fault.file, fault.place, fault.found) == ("b", "line 2", "2")


def test_a_repetition_that_says_the_same_is_not_told_and_quiet_tells_none() -> None:
    read = values("last")
    read.one("backlash", places(line("1") + line("+1.00")))
    read.one("backlash", places(line("1") + line("2")), quiet=True)
    assert read.notes.findings == []


@pytest.mark.parametrize(
    ("say", "assumed", "codes"),
    [("nothing", 0, []), ("assumed", 1, []), ("warning", 1, ["CW-S005"])],
)
def test_what_counts_where_no_file_says_it_is_told_as_its_rule_says(
    say: Say, assumed: int, codes: list[str]
) -> None:
    read = values(say=say)
    assert read.absent("backlash", "backlash") == "0"
    assert len(read.notes.assumed) == assumed
    assert [note.code for note in read.notes.findings] == codes
    if assumed:
        assert read.notes.assumed[0].fact == "axis AX1: $MA_BACKLASH (backlash)"


def test_without_a_rule_nothing_counts_and_nothing_is_told() -> None:
    read = values()
    assert read.absent("backlash") is None
    assert read.notes == Notes()


def test_a_word_that_the_control_does_not_know_is_a_fault_at_its_line() -> None:
    reader = text_reader(SIEMENS)
    text = reader.read(ControlFile("a", b"\n$MA_ENC_COMP_ENABLE[0,AX1]=7\n"), [])
    assert text is not None
    (found,) = gather(SIEMENS, [text]).found("enabled", "AX1", "0")
    read = values()
    assert read.word("enabled", found) is None
    (fault,) = read.notes.faults
    assert (fault.place, fault.expected, fault.found) == ("line 2", "one of 0, 1", "7")
