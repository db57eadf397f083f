"""The door of the room: bytes of a measurement file to a record. The form is told by the content,
never by the file's name.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.findings import Finding
from compwright.foundations.provenance import source_of
from compwright.instruments.assembling import Reading, grid_of
from compwright.instruments.comments import Comments, cycle_of, read_comments
from compwright.instruments.csv_table import (
    DELIMITERS,
    INCHES,
    header_names,
    in_inches,
    is_number,
    read_table,
    split_lines,
)
from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.plain_csv import CsvReadings, read_csv
from compwright.instruments.plausibility import findings_of
from compwright.instruments.target_data import TargetData, is_target_data, read_target_data
from compwright.instruments.text_input import read_lines, unfinished_number
from compwright.records.axis import AxisKind, Direction
from compwright.records.positioning import PositioningTest

#: The forms that `read_positioning` reads, as they stand in messages.
ACCEPTED_FORMS = (
    "a plain CSV file (columns target_mm or target_deg, direction, run and a deviation or measured"
    " value; or target and one column per traverse) or target data (TGT_DATA[1]=...)"
)
_NEWEST_FORM = 1
#: Values of ``compensated_for`` that say the instrument corrected nothing.
_NOTHING = frozenset({"", "no", "none", "nothing", "-"})
_FORM_KEY = re.compile(r"positioning\s+([0-9]{1,9})")


@dataclass(frozen=True, slots=True, kw_only=True)
class _Parsed:
    """A file of either form after reading: what the record needs, before the checks that need all
    readings.
    """

    kind: AxisKind
    readings: tuple[Reading, ...]
    comments: Comments
    header: dict[str, str]
    assumed: tuple[str, ...]
    findings: tuple[Finding, ...]


def read_positioning(content: bytes, file: str) -> PositioningTest:
    """Return the positioning test in ``content``; ``file`` is the name that messages and the
    record's source carry.

    Reads the plain CSV forms (contract, "Plain CSV") and the ecmc target data form. The result is
    in mm or deg, deviations are measured minus target, the frame is the instrument's, and its name
    is the stem of ``file``. An axis that the file does not name is an empty text with a finding.
    Raises InputError with every fault that could be found at once.
    """
    faults = FaultList(file)
    text = read_lines(content, file)
    comment_lines, lines = split_lines(text)
    if is_target_data(lines):
        comments = read_comments(comment_lines, faults, any_key=False)
        parsed = _from_target_data(read_target_data(lines, faults), comments)
    else:
        comments = read_comments(comment_lines, faults)
        _refuse_other_forms(lines, comments, file)
        parsed = _from_csv(read_csv(read_table(lines, faults), comments, faults), comments)
    cycle = cycle_of(comments, faults)
    grid = grid_of(parsed.readings, parsed.kind, faults)
    assumed = parsed.assumed if cycle else (*parsed.assumed, "cycle: standard")
    return PositioningTest(
        name=stem(file),
        axis=comments.get("axis"),
        kind=parsed.kind,
        targets=grid.targets,
        positive=grid.deviations[Direction.POSITIVE],
        negative=grid.deviations[Direction.NEGATIVE],
        runs_positive=grid.runs[Direction.POSITIVE],
        runs_negative=grid.runs[Direction.NEGATIVE],
        cycle=cycle or "standard",
        frame="instrument",
        sources=(source_of(file, content),),
        header=parsed.header,
        findings=(
            *_about_header(comments, assumed),
            *parsed.findings,
            *findings_of(grid, parsed.kind),
            *_finding_list(unfinished_finding(text)),
        ),
    )


def stem(file: str) -> str:
    """Return the name of a file without its folders and its ending."""
    name = re.split(r"[\\/]", file)[-1]
    return name.rpartition(".")[0] or name


def assumed_finding(assumed: Sequence[str]) -> Finding | None:
    """Return the finding that says what the file leaves open, None when that is nothing."""
    return (
        Finding("CW-R001", "info", f"Not said in the file and taken as: {'; '.join(assumed)}.")
        if assumed
        else None
    )


def left_out_finding(columns: Sequence[str]) -> Finding | None:
    """Return the finding that names columns without a part in the form, None when there are
    none.
    """
    return (
        Finding("CW-R005", "warning", f"Columns that were left out: {', '.join(columns)}.")
        if columns
        else None
    )


def unfinished_finding(lines: Sequence[str]) -> Finding | None:
    """Return the finding about a file that may have been cut off inside its last number, None where
    it was not.
    """
    number = unfinished_number(lines)
    if not number:
        return None
    return Finding(
        "CW-R051",
        "warning",
        f"The file ends without a line end after {shown(number)} (line {len(lines)}): if it was cut"
        " off while it was copied, digits are missing there, or readings after it.",
    )


def _finding_list(finding: Finding | None) -> list[Finding]:
    return [] if finding is None else [finding]


def doubtful_finding(number: str) -> Finding | None:
    """Return the finding about a point that may mark thousands (`DecimalMarks.doubtful_point`),
    None for an empty ``number``.
    """
    if not number:
        return None
    return Finding(
        "CW-R015",
        "warning",
        f"{shown(number)} was read with a decimal point, but whole numbers stand in the same column"
        " and no number proves the point: if it marks thousands, take it out.",
    )


def _about_header(comments: Comments, assumed: Sequence[str]) -> list[Finding]:
    findings = [finding for finding in [assumed_finding(assumed)] if finding is not None]
    if not comments.get("axis"):
        findings.append(
            Finding(
                "CW-R002", "info", "The file does not name its axis (comment line '# axis: X')."
            )
        )
    if comments.get("compensated_for").lower() not in _NOTHING:
        findings.append(
            Finding(
                "CW-R004",
                "info",
                f"The instrument already compensated for: {comments.get('compensated_for')}.",
            )
        )
    return findings


def _measured_findings(comments: Comments, *, sign_said: bool) -> list[Finding]:
    findings = [
        Finding(
            "CW-R003", "info", "Measured values were turned into deviations, measured minus target."
        )
    ]
    if sign_said and comments.get("deviation"):
        findings.append(
            Finding(
                "CW-R013",
                "warning",
                f"The key 'deviation: {comments.get('deviation')}' has no effect: the file gives"
                " measured values, not deviations.",
            )
        )
    return findings


def _from_csv(read: CsvReadings, comments: Comments) -> _Parsed:
    findings = _measured_findings(comments, sign_said=read.sign_said) if read.measured else []
    about = (doubtful_finding(read.doubtful), left_out_finding(read.left_out))
    findings += [finding for finding in about if finding is not None]
    return _Parsed(
        kind=read.kind,
        readings=read.readings,
        comments=comments,
        header=comments.header,
        assumed=() if read.measured or read.sign_said else ("deviation: measured minus target",),
        findings=tuple(findings),
    )


def _from_target_data(read: TargetData, comments: Comments) -> _Parsed:
    findings = _measured_findings(comments, sign_said=bool(comments.get("deviation")))
    if read.descending:
        findings.append(
            Finding(
                "CW-R014",
                "warning",
                "The targets are listed from high to low, and FWD was taken as the approach in"
                " direction +: check the labels.",
            )
        )
    assumed = ["FWD: approach in direction +, BWD: in direction -"]
    if not read.unit_said:
        assumed.append("unit: mm")
    return _Parsed(
        kind=read.kind,
        readings=read.readings,
        comments=comments,
        header={**comments.header, **read.header},
        assumed=tuple(assumed),
        findings=tuple(findings),
    )


def _refuse_other_forms(lines: Sequence[tuple[int, str]], comments: Comments, file: str) -> None:
    """Raise InputError when the file is not a plain CSV positioning file, saying what it seems to
    be.
    """
    form = comments.get("compwright").lower()
    match = _FORM_KEY.fullmatch(form)
    if match and int(match[1]) > _NEWEST_FORM:
        expected = f"positioning {_NEWEST_FORM} or older"
        place = comments.places["compwright"]
        raise InputError(
            Fault(
                message="was written for a newer compwright",
                file=file,
                place=place,
                expected=expected,
                found=form,
            )
        )
    if not lines:
        raise InputError(
            Fault(
                message="holds comment lines only", file=file, expected="a header row and readings"
            )
        )
    number, first = lines[0]
    _, names, count = header_names(first)
    if form.startswith("circular") or (
        "angle_deg" in names and {"direction", "radius_mm"} & set(names)
    ):
        raise InputError(
            Fault(
                message="holds a circular test, not a positioning test",
                file=file,
                place=f"line {number}",
                expected=ACCEPTED_FORMS,
                found=f"columns {', '.join(names[:8])}",
            )
        )
    if not count and names:
        raise _unknown_form(number, first, names, file)


def _unknown_form(number: int, first: str, names: Sequence[str], file: str) -> InputError:
    start = first.strip()
    if start.startswith("<"):
        if "TEST_DOCUMENT" in first or "<?xml" in first:
            return InputError(
                Fault(
                    message=(
                        "is not a positioning file; XML such as a ballbar's .b5r holds a circular"
                        " test"
                    ),
                    file=file,
                    place=f"line {number}",
                    expected=ACCEPTED_FORMS,
                    found=shown(start),
                )
            )
        what = "XML or HTML"
    elif start.upper().startswith("HEADER::"):
        what = (
            "a laser file of the Renishaw form (HEADER::), which is not read yet: export its"
            " readings as plain CSV"
        )
    elif names == ["point", "position", "value", "unit"]:
        what = "a typed-entry sheet of a compensation table"
    elif in_inches(names):
        return InputError(
            Fault(
                message="is in inches, which are not read",
                file=file,
                place=f"line {number}",
                expected=INCHES,
                found=shown(in_inches(names)),
            )
        )
    elif start.startswith(("{", "[")):
        what = "JSON, or sections in brackets"
    elif all(name in {"", "+", "-"} or is_number(name) for name in names):
        what = f"a row of numbers where the header row should be: {shown(first)}"
    else:
        what = f"{shown(first)} as the first row"
        if len(names) == 1 and len(start.split()) > 1:
            what += f", without {', '.join(list(DELIMITERS.values())[:-1])} or tab"
    return InputError(
        Fault(
            message="is not a positioning file",
            file=file,
            place=f"line {number}",
            expected=ACCEPTED_FORMS,
            found=what,
        )
    )
