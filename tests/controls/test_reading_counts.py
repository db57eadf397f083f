"""A run compiles each form of its control once and reads each text once, whoever asks for it."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.formats.definition.schema import Definition, Statement
from compwright.formats.families.columns import table_reading as columns_text
from compwright.formats.families.shapes import control_format
from compwright.formats.text import entry_sheet, texts
from compwright.formats.text.texts import text_reader
from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile
from format_samples import DEFINITIONS, SIEMENS, axis_of, table
from loop import Machine, csv_of

pytestmark = pytest.mark.short_estimate

MACHINE = Machine()
ADDRESSES = {name: one.expect[0].axis for name, one in DEFINITIONS.items()}
PULSE: dict[str, object] = {"detection_unit": 0.001, "first_point": 0}
OPTIONS: dict[str, dict[str, object]] = {
    **{name: PULSE for name in DEFINITIONS if name.startswith("fanuc")},
    "pmac": {"counts_per_unit": 1000.0},
}
COLUMNS = {
    "X.COM": "BEGIN X .COM MM DATUM:0 DIST:100\nNR   1=F()\n"
    + "".join(f"{row:<4d} +0.0010\n" for row in range(9))
    + "END X .COM\n",
    "MP.TXT": "MP710.0 : 0.0000\nMP730 : %00001\n",
}


def old_files(format_id: str) -> dict[str, bytes]:
    """A table of 9 points as the control holds it, as files."""
    if format_id == "heidenhain-itnc530":
        return {name: text.encode() for name, text in COLUMNS.items()}
    nodes = [MACHINE.low + (MACHINE.high - MACHINE.low) / 8 * index for index in range(9)]
    address = ADDRESSES[format_id]
    control = control_format(DEFINITIONS[format_id], OPTIONS.get(format_id, {}))
    old = table(address, nodes, [0.0, *[0.001] * 7, 0.0])
    own = [
        ControlFile(name, text.encode())
        for name, text in DEFINITIONS[format_id].sample_files.items()
        if DEFINITIONS[format_id].limit("only_patching") is not None
    ]
    files = control.write([old], [axis_of(address)], own)
    return {file.name: file.content for file in files}


def counted(monkeypatch: pytest.MonkeyPatch) -> tuple[Counter[object], Counter[object]]:
    """Counters of the forms that are compiled and the texts that are parsed from now on."""
    forms: Counter[object] = Counter()
    parsed: Counter[object] = Counter()

    def count(owner: object, name: str, key: Callable[..., object], into: Counter[object]) -> None:
        original = getattr(owner, name)

        def counting(*words: Any) -> object:
            into[key(*words)] += 1
            return original(*words)

        monkeypatch.setattr(owner, name, counting)

    def form(statement: Statement, definition: Definition) -> object:
        return id(definition), statement.name

    def text(_reader: object, file: ControlFile, _faults: list[Fault]) -> object:
        return file

    def sheet(file: ControlFile, _faults: list[Fault]) -> object:
        return file

    def cells(_reader: object, file: ControlFile, _faults: list[Fault]) -> object:
        return "cells", file

    count(texts, "compile_statement", form, forms)
    count(texts.TextReader, "parse", text, parsed)
    count(entry_sheet, "parse_sheet", sheet, parsed)
    # Lines and cells of one table are two readings: what changed in its first line is told too.
    count(columns_text, "parse_table", cells, parsed)
    return forms, parsed


@pytest.mark.parametrize("format_id", sorted(DEFINITIONS))
def test_a_run_compiles_each_form_once_and_reads_each_text_once(
    format_id: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    targets = MACHINE.targets()
    (tmp_path / "x.csv").write_text(csv_of(targets, MACHINE.measure(targets, seed=1)))
    states = []
    for name, content in old_files(format_id).items():
        (tmp_path / name).write_bytes(content)
        states += ["--state", str(tmp_path / name)]
    options = [f"{name}={value}" for name, value in OPTIONS.get(format_id, {}).items()]
    text_reader.cache_clear()  # as at the start of the program
    forms, parsed = counted(monkeypatch)
    code = compwright(
        [
            *("run", str(tmp_path / "x.csv"), "--format", format_id, "--axis", "X", *states),
            *("--travel", f"{MACHINE.low}:{MACHINE.high}", "--out", str(tmp_path / "out")),
            *("--option", f"address={ADDRESSES[format_id]}"),
            *(word for option in options for word in ("--option", option)),
        ]
    )
    assert code == 0
    assert set(forms.values()) == {1}
    assert len(forms) >= len(DEFINITIONS[format_id].statements)
    assert parsed, "the run must have read something for the demand to mean anything"
    assert set(parsed.values()) == {1}


def test_what_was_wrong_with_a_text_is_told_each_time_it_is_read() -> None:
    file = ControlFile("a.ini", b"$AA_ENC_COMP[0,1,AX1]=0,5\n" + str(time.time()).encode())
    reader = text_reader(SIEMENS)
    first: list[Fault] = []
    again: list[Fault] = []
    reader.read(file, first)
    second = reader.read(file, again, 3)
    assert first == again
    assert [fault.place for fault in first] == ["line 1"]
    assert second is not None
    assert second.number == 3  # the place among the files is the caller's, not the text's


def test_two_files_that_differ_by_a_byte_or_by_their_name_are_two_texts() -> None:
    reader = text_reader(SIEMENS)
    values = []
    for name, text in (("a.ini", b"=1\n"), ("a.ini", b"=2\n"), ("b.ini", b"=2\n")):
        read = reader.read(ControlFile(name, b"$MA_BACKLASH[0,AX1]" + text), [])
        assert read is not None
        values += [(one.file, one.tokens["value"].text) for one in read.occurrences]
    assert values == [("a.ini", "1"), ("a.ini", "2"), ("b.ini", "2")]
