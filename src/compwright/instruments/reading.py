"""Read the bytes of a measurement file as records. The contents decide the file format."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import Source, fingerprint, source_of
from compwright.instruments.answers import NO_ANSWERS
from compwright.instruments.assembling import grid_of
from compwright.instruments.code_page import read_plain_lines
from compwright.instruments.cut_files import cut_findings
from compwright.instruments.fault_list import FaultList, by_profile
from compwright.instruments.forms import PLAIN_CSV, MeasurementForm, form_of
from compwright.instruments.hidden_cells import hidden_finding
from compwright.instruments.own_forms import is_plain_csv
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.parts import TestPart, plain_parts
from compwright.instruments.plausibility import findings_of
from compwright.instruments.profile import Profile
from compwright.instruments.profile_tables import (
    at_its_header,
    has_columns,
    profiled_parts,
    read_by_profile,
)
from compwright.instruments.reading_findings import (
    assumed_finding,
    header_findings,
    sheets_finding,
    unfinished_finding,
)
from compwright.instruments.sections import axis_name
from compwright.instruments.table_shape import has_table
from compwright.instruments.text_input import read_any_lines, read_lines, stem
from compwright.instruments.workbook import WorkbookSheet, is_workbook, sheets_of
from compwright.records.axis import Direction
from compwright.records.positioning import PositioningTest, to_machine
from compwright.words.sentences import say

#: First lines of a file of samples over time: text, and then numbers as bytes.
_DYNAMIC: Final = re.compile(
    rb"\s*HEADER::.{0,2000}?File type\s*:\s*rtx", re.IGNORECASE | re.DOTALL
)


@dataclass(frozen=True, slots=True)
class _Read:
    """The parsed contents of one test in a file, and its lines, before it becomes a record."""

    parsed: Parsed
    part: TestPart
    faults: FaultList


def read_tests(
    content: bytes, file: str, profile: Profile | None = None
) -> tuple[PositioningTest, ...]:
    """Return the positioning tests in a file. A file has one test, or one for each axis or for each
    sheet of a workbook.

    ``file`` is the name in messages and in the record's source. A file has one of the forms of
    `forms.FORMS`, or one of the plain CSV forms (contract, "Plain CSV"), also in an Excel workbook.
    Any other table needs a ``profile``.

    The results are in mm or deg, and deviations are measured minus target. The name of a test is
    the stem of ``file``, with the axis if there are several tests. Positions are those of the
    instrument, or of the machine if the profile converts them. If the axis is unknown, it is an
    empty text and there is a finding. Raises InputError with all faults that can be found at once.
    """
    if is_workbook(content):
        sheets = sheets_of(content, file)
        used = [sheet for sheet in sheets if _is_test(sheet, profile)]
        reads = [read for sheet in used for read in _of_sheet(sheet, file, profile)]
        _refuse_no_sheet(reads, sheets, file)
        left_out = [sheet.name for sheet in sheets if sheet not in used]
    else:
        reads = _of_text(content, FaultList(file), profile)
        left_out = []
    several = len(reads) > 1
    tests = tuple(
        _test_of(read, _source(read, content, file, several=several), _name(read, file, reads))
        for read in reads
    )
    if left_out:
        finding = sheets_finding(say("CW-R061.sheets", sheets=left_out[:8], more=len(left_out) > 8))
        tests = tuple(replace(test, findings=(*test.findings, finding)) for test in tests)
    return tuple(_mapped(test, profile) for test in tests)


def _of_text(content: bytes, faults: FaultList, profile: Profile | None) -> list[_Read]:
    """Return the tests in a text file."""
    file = faults.file
    if profile is not None and profile.layout != "own" and not _has_own_form(content, file):
        text, _ = read_any_lines(content, file, profile.encoding)
        profile = at_its_header(text, profile)
        if has_columns(text, profile) or not is_plain_csv(text):
            return _by_profile(text, profile, faults)
    text, form, code_page = _text_and_form(content, file)
    parts = plain_parts(text, faults) if form is PLAIN_CSV else (TestPart(text),)
    reads = _by_form(form, parts, faults, profile)
    return [_with_finding(read, code_page) for read in reads] if code_page is not None else reads


def _with_finding(read: _Read, finding: Finding) -> _Read:
    parsed = read.parsed
    return replace(read, parsed=replace(parsed, findings=(finding, *parsed.findings)))


def _by_form(
    form: MeasurementForm, parts: Sequence[TestPart], faults: FaultList, profile: Profile | None
) -> list[_Read]:
    own = profile is not None and profile.layout == "own"
    answers = profile.answers if profile is not None and own else NO_ANSWERS
    return [_Read(form.read(part.text, faults, answers), part, faults) for part in parts]


def _by_profile(text: Sequence[str], profile: Profile, faults: FaultList) -> list[_Read]:
    return [
        _Read(_marked(read_by_profile(part.text, profile, faults), profile), part, faults)
        for part in profiled_parts(text, profile, faults)
    ]


def _marked(parsed: Parsed, profile: Profile) -> Parsed:
    stated = f"{profile.file} (sha256 {profile.sha256})"
    return replace(parsed, header={**parsed.header, "profile": stated})


def _has_own_form(content: bytes, file: str) -> bool:
    """Return whether a file certainly has one of the known forms (`FORMS`)."""
    try:
        return form_of(read_any_lines(content, file)[0], file) is not PLAIN_CSV
    except InputError:
        return False


def _is_test(sheet: WorkbookSheet, profile: Profile | None) -> bool:
    return is_plain_csv(sheet.lines) or (
        profile is not None
        and profile.layout != "own"
        and has_columns(sheet.lines, _for_sheet(sheet, profile))
    )


def _for_sheet(sheet: WorkbookSheet, profile: Profile) -> Profile:
    return at_its_header(sheet.lines, replace(profile, delimiter="\t"))


def _of_sheet(sheet: WorkbookSheet, file: str, profile: Profile | None) -> list[_Read]:
    faults = FaultList(f"{file}, sheet {sheet.name}")
    if profile is not None and has_columns(sheet.lines, _for_sheet(sheet, profile)):
        reads = _by_profile(sheet.lines, _for_sheet(sheet, profile), faults)
    else:
        reads = _by_form(PLAIN_CSV, plain_parts(sheet.lines, faults), faults, None)
    reads = [replace(read, part=replace(read.part, sheet=sheet.name)) for read in reads]
    hidden = hidden_finding(sheet.hidden, sheet.lines)
    return reads if hidden is None else [_with_finding(read, hidden) for read in reads]


def _refuse_no_sheet(reads: Sequence[_Read], sheets: Sequence[WorkbookSheet], file: str) -> None:
    if not reads:
        raise InputError(
            Fault(
                message="the file is an Excel workbook, but no sheet contains a test",
                file=file,
                expected=(
                    "a sheet with the columns of plain CSV (target_mm, direction, "
                    "run, deviation_um)"
                ),
                found=_listed([sheet.name for sheet in sheets]) or "empty sheets",
                hint=f"describe the sheet with {by_profile(file)}",
            )
        )


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:8]) + (", .." if len(names) > 8 else "")


def _source(read: _Read, content: bytes, file: str, *, several: bool) -> Source:
    """Return file name and SHA-256 of a test. ``several``: the file contains several tests, and the
    hash is that of this test's lines only.
    """
    if not several:
        return source_of(file, content)
    own = "\n".join((read.part.sheet, read.part.axis, *read.part.text))
    return Source(file=file, sha256=fingerprint(own.encode("utf-8", "surrogatepass")))


def _name(read: _Read, file: str, reads: Sequence[_Read]) -> str:
    if len(reads) == 1:
        return stem(file)
    names = [name for name in (read.part.sheet, read.part.axis) if name]
    return " ".join([stem(file), *dict.fromkeys(names)])


def _test_of(read: _Read, source: Source, name: str) -> PositioningTest:
    """Return the record of one test. Raises InputError with all faults."""
    parsed = read.parsed
    grid = grid_of(parsed.readings, parsed.kind, read.faults)
    header, assumed = _with_axis(parsed, read.part)
    if not parsed.cycle:
        assumed = (*assumed, "cycle: standard")
    findings = (
        assumed_finding(assumed),
        *header_findings(header),
        *parsed.findings,
        *findings_of(grid, parsed.kind),
        *cut_findings(parsed.readings, parsed.kind, header),
        None if read.part.sheet else unfinished_finding(read.part.text),
    )
    return PositioningTest(
        name=name,
        axis=header.get("axis", ""),
        kind=parsed.kind,
        targets=grid.targets,
        positive=grid.deviations[Direction.POSITIVE],
        negative=grid.deviations[Direction.NEGATIVE],
        runs_positive=grid.runs[Direction.POSITIVE],
        runs_negative=grid.runs[Direction.NEGATIVE],
        times=grid.times,
        cycle=parsed.cycle or "standard",
        frame="instrument",
        sources=(source,),
        header=header,
        findings=tuple(finding for finding in findings if finding is not None),
    )


def _with_axis(parsed: Parsed, part: TestPart) -> tuple[dict[str, str], tuple[str, ...]]:
    """Return the header and the assumptions of a test, with the axis name from the file's column of
    axes, or else from the sheet name.
    """
    header = dict(parsed.header)
    if part.axis:
        return {**header, "axis": part.axis}, parsed.assumed
    named = axis_name(part.sheet) if part.sheet else ""
    stated = header.get("axis", "")
    if stated and named and stated.upper() != named:
        return header, (*parsed.assumed, f"axis: {stated}, though the sheet is called {part.sheet}")
    if stated or not named:
        return header, parsed.assumed
    return {**header, "axis": named}, (*parsed.assumed, f"axis: {named}, the name of the sheet")


def _mapped(test: PositioningTest, profile: Profile | None) -> PositioningTest:
    used = profile is not None and (profile.layout == "own" or "profile" in test.header)
    if profile is None or not used or profile.position_map is None:
        return test
    return to_machine(test, profile.position_map)


def _text_and_form(content: bytes, file: str) -> tuple[list[str], MeasurementForm, Finding | None]:
    """Return the lines of a file, the file format that they have, and a finding if the encoding of
    the file is assumed (else None).

    An encoding other than UTF-8 and UTF-16 is assumed only if files of this format can have it, or
    if no number depends on it.
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
        if form is PLAIN_CSV and is_plain_csv(text):
            text, finding = read_plain_lines(content, file)
            return text, form, finding
        foreign = form is PLAIN_CSV and has_table(text)
        if not form.code_pages and not foreign:
            raise
        # the message for a table of another program names it, whatever its encoding
        return text, form, None
    return text, form_of(text, file), None


def _refuse_dynamic_data(content: bytes, file: str) -> None:
    if _DYNAMIC.match(content):
        raise InputError(
            Fault(
                message="the file contains dynamic data (samples over time), not readings at "
                "target positions",
                file=file,
                expected="the positioning test (.rtl or .rta)",
                found="File type: rtx",
                hint="give the file of the positioning test (.rtl or .rta)",
            )
        )
