"""The door of the room: bytes of a measurement file to a record. The form is told by the content,
never by the file's name.
"""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.provenance import source_of
from compwright.instruments.answers import NO_ANSWERS
from compwright.instruments.assembling import grid_of
from compwright.instruments.fault_list import FaultList
from compwright.instruments.forms import PLAIN_CSV, Form, form_of
from compwright.instruments.own_forms import is_plain_csv
from compwright.instruments.parsed import Parsed
from compwright.instruments.plausibility import findings_of
from compwright.instruments.profile import Profile
from compwright.instruments.profiled import has_columns, read_by_profile
from compwright.instruments.reading_findings import (
    assumed_finding,
    header_findings,
    unfinished_finding,
)
from compwright.instruments.text_input import read_any_lines, read_lines
from compwright.records.axis import Direction
from compwright.records.positioning import PositioningTest, to_machine

#: First lines of a file of samples over time: text, and then numbers as bytes.
_DYNAMIC: Final = re.compile(
    rb"\s*HEADER::.{0,2000}?File type\s*:\s*rtx", re.IGNORECASE | re.DOTALL
)


def read_positioning(content: bytes, file: str, profile: Profile | None = None) -> PositioningTest:
    """Return the positioning test in ``content``; ``file`` is the name that messages and the
    record's source carry.

    Reads the forms of `forms.FORMS`, the plain CSV forms (contract, "Plain CSV"), and any other
    table by a ``profile``. The result is in mm or deg, deviations are measured minus target, and
    its name is the stem of ``file``. The frame is the instrument's, or the machine's where the
    profile maps the positions. An axis that the file does not name is an empty text with a finding.
    Raises InputError with every fault that could be found at once.
    """
    faults = FaultList(file)
    if profile is not None and profile.layout != "own" and not _has_own_form(content, file):
        test = _by_profile(content, profile, faults)
        if test is not None:
            return test
    text, form = _text_and_form(content, file)
    answers = profile.answers if profile and profile.layout == "own" else NO_ANSWERS
    test = test_of(form.read(text, faults, answers), text, content, faults)
    return _mapped(test, profile) if profile and profile.layout == "own" else test


def _has_own_form(content: bytes, file: str) -> bool:
    """Whether a file is of one of `FORMS`, which are recognised for certain."""
    try:
        return form_of(read_any_lines(content, file)[0], file) is not PLAIN_CSV
    except InputError:
        return False


def _by_profile(content: bytes, profile: Profile, faults: FaultList) -> PositioningTest | None:
    """Return the test by a profile; None for a plain CSV file that has none of its columns."""
    text, _ = read_any_lines(content, faults.file, profile.encoding)
    if not has_columns(text, profile) and is_plain_csv(text):
        return None
    return _mapped(test_of(read_by_profile(text, profile, faults), text, content, faults), profile)


def _mapped(test: PositioningTest, profile: Profile) -> PositioningTest:
    header = {**test.header, "profile": f"{profile.file} (sha256 {profile.sha256})"}
    test = replace(test, header=header)
    return to_machine(test, profile.position_map) if profile.position_map else test


def test_of(parsed: Parsed, text: list[str], content: bytes, faults: FaultList) -> PositioningTest:
    """Return the record of what a reader found in the lines ``text`` of a file.

    Raises InputError with the faults noted so far and those that need all readings.
    """
    grid = grid_of(parsed.readings, parsed.kind, faults)
    assumed = parsed.assumed if parsed.cycle else (*parsed.assumed, "cycle: standard")
    shared = (assumed_finding(assumed), *header_findings(parsed.header))
    return PositioningTest(
        name=stem(faults.file),
        axis=parsed.header.get("axis", ""),
        kind=parsed.kind,
        targets=grid.targets,
        positive=grid.deviations[Direction.POSITIVE],
        negative=grid.deviations[Direction.NEGATIVE],
        runs_positive=grid.runs[Direction.POSITIVE],
        runs_negative=grid.runs[Direction.NEGATIVE],
        cycle=parsed.cycle or "standard",
        frame="instrument",
        sources=(source_of(faults.file, content),),
        header=parsed.header,
        findings=tuple(
            finding
            for finding in (
                *shared,
                *parsed.findings,
                *findings_of(grid, parsed.kind),
                unfinished_finding(text),
            )
            if finding is not None
        ),
    )


def stem(file: str) -> str:
    """Return the name of a file without its folders and its ending."""
    name = re.split(r"[\\/]", file)[-1]
    return name.rpartition(".")[0] or name


def _text_and_form(content: bytes, file: str) -> tuple[list[str], Form]:
    """Return the lines of a file and their form; other encodings than UTF-8 and UTF-16 only where
    the form has them.
    """
    try:
        text = read_lines(content, file)
    except InputError as strict:
        try:
            text, _ = read_any_lines(content, file)
        except InputError:
            _refuse_dynamic_data(content, file)
            raise strict from None
        form = form_of(text, file)
        if not form.code_pages:
            raise
        return text, form
    return text, form_of(text, file)


def _refuse_dynamic_data(content: bytes, file: str) -> None:
    if _DYNAMIC.match(content):
        raise InputError(
            Fault(
                message="holds dynamic data (samples over time), not positions",
                file=file,
                expected="the positioning test (.rtl or .rta)",
                found="File type: rtx",
            )
        )
