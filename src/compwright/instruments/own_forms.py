"""Readers of plain CSV files and of target data files (lines ``TGT_DATA[i]=``); each returns a
`Parsed`, the readings before further checks.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from itertools import chain, repeat

from compwright.instruments.comments import comment_text, cycle_of, read_comments
from compwright.instruments.csv_table import (
    CIRCULAR_COLUMNS,
    COLUMNS,
    column_name,
    first_row,
    header_names,
    read_table,
    row_cells,
    rows_as_comments,
    split_lines,
    traverse_of,
)
from compwright.instruments.drift_csv import DISTANCE, LOST_MOTION, SPEED, TIME
from compwright.instruments.fault_list import FaultList
from compwright.instruments.other_files import refuse_other_files
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.parts import AXIS_COLUMN
from compwright.instruments.plain_csv import VALUES, read_csv
from compwright.instruments.reading_findings import (
    cut_finding,
    doubtful_finding,
    falling_finding,
    left_out_finding,
    measured_findings,
    stray_finding,
)
from compwright.instruments.spans import Meaning, Spans, TextSpan, whole
from compwright.instruments.target_data import is_target_data, read_target_data, split_target_data
from compwright.instruments.target_data import spans_in as spans_in_target_data
from compwright.instruments.times import TIME as READING_TIME
from compwright.words.sentences import SentenceText, say

#: All columns that a plain CSV form reads, but for those of traverses.
_COLUMNS = COLUMNS | {*CIRCULAR_COLUMNS, AXIS_COLUMN, TIME, DISTANCE, SPEED, LOST_MOTION}
#: What the name of a column is, by what its cells are, where it is no word of the form.
_HEADS: Mapping[Meaning, Meaning] = {"other cell": "column"}


def is_target_data_file(text: Sequence[str]) -> bool:
    """Return whether the lines of a file have the form ``TGT_DATA[1]=``."""
    first = first_row(text)
    data = (line for line in text if "_DATA" in line and comment_text(line) is None)
    return first is not None and is_target_data(chain([first[1]], data))


def is_plain_csv(text: Sequence[str]) -> bool:
    """Return whether the header row of a file has a target column and a value column of the plain
    CSV forms.
    """
    first = first_row(text)
    names = header_names(first[1])[1] if first is not None else []
    return not {"target_mm", "target_deg"}.isdisjoint(names) and any(
        name in VALUES or traverse_of(name) is not None for name in names
    )


def read_plain_csv(text: Sequence[str], faults: FaultList) -> Parsed:
    """Return the test in the lines of a plain CSV file. Faults of cells are added to ``faults``.

    Raises InputError for a file of another form; the error names the form that it probably has.
    """
    comment_lines, lines = split_lines(text)
    comments = read_comments(comment_lines, faults)
    refuse_other_files(lines, comments, faults.file)
    table = read_table(lines, faults)
    read = read_csv(table, comments, faults)
    findings = (
        measured_findings(comments.header, sign_stated=read.sign_stated) if read.measured else []
    )
    long = "direction" in table.columns and READING_TIME not in table.columns
    optional = READING_TIME if long else ""
    width = len(row_cells(text[table.line - 1], table.delimiter) or ())
    hidden = rows_as_comments(
        text, table.line, lambda line: row_cells(line, table.delimiter), width
    )
    about = (
        doubtful_finding(read.doubtful),
        left_out_finding(read.left_out, optional),
        read.unread,
        stray_finding(hidden),
    )
    findings += [finding for finding in about if finding is not None]
    return Parsed(
        kind=read.kind,
        readings=read.readings,
        header=comments.header,
        cycle=cycle_of(comments, faults),
        assumed=()
        if read.measured or read.sign_stated
        else (SentenceText(say("reading.deviation")),),
        findings=tuple(findings),
    )


def read_target_data_file(text: Sequence[str], faults: FaultList) -> Parsed:
    """Return the test in the lines of a file of the form ``TGT_DATA[1]=``. Faults are added to
    ``faults``.
    """
    comment_lines, lines = split_target_data(text)
    comments = read_comments(comment_lines, faults, any_key=False)
    read = read_target_data(lines, faults)
    findings = measured_findings(comments.header, sign_stated=bool(comments.get("deviation")))
    if read.descending:
        findings.append(
            falling_finding(say("CW-R014.labels")),
        )
    if read.alone:
        findings.append(
            cut_finding(say("CW-R053.one_direction", direction=read.alone)),
        )
    assumed = [SentenceText(say("reading.fwd"))]
    if not read.unit_stated:
        assumed.append(SentenceText(say("reading.unit_mm")))
    return Parsed(
        kind=read.kind,
        readings=read.readings,
        header={**comments.header, **read.header},
        cycle=cycle_of(comments, faults),
        assumed=tuple(assumed),
        findings=tuple(findings),
    )


def spans_of_plain_csv(text: Sequence[str]) -> Iterator[Spans]:
    """Yield the parts of each line of a plain CSV file, each with its meaning, such as ``key``."""
    delimiter = ""
    meanings: list[Meaning] = []
    for line in text:
        if comment_text(line) is not None:
            yield whole(line, "comment")
        elif not line.strip(" \t,;"):
            yield ()
        elif not delimiter:
            delimiter, _, _ = header_names(line)
            meanings = [_of_column(column_name(name)) for name in row_cells(line, delimiter) or ()]
            yield _in_cells(line, delimiter, [_HEADS.get(one, "key") for one in meanings])
        else:
            yield _in_cells(line, delimiter, meanings)


def spans_of_target_data(text: Sequence[str]) -> Iterator[Spans]:
    """Yield the parts of each line of a target data file, each with its meaning."""
    for line in text:
        remark = comment_text(line) is not None
        yield whole(line, "comment") if remark else spans_in_target_data(line)


def _of_column(name: str) -> Meaning:
    if name == AXIS_COLUMN:
        return "axis"
    known = name in _COLUMNS or traverse_of(name) is not None
    return "cell" if known else "other cell"


def _in_cells(line: str, delimiter: str, meanings: Sequence[Meaning]) -> Spans:
    """Return, for each cell of a line, its first and last character in the line and the meaning of
    its column.
    """
    spans: list[TextSpan] = []
    start, cell = 0, _cell(delimiter)
    names: Iterator[Meaning] = chain(meanings, repeat("other cell"))
    while start <= len(line) and (found := cell.match(line, start)) is not None:
        spans.append(TextSpan(*found.span(), next(names)))
        start = found.end() + 1
    return spans


@cache
def _cell(delimiter: str) -> re.Pattern[str]:
    mark = re.escape(delimiter)
    quoted = rf' *"(?:[^"]|"")*(?:"[^{mark}]*|$)'  # one that is not closed takes the rest
    return re.compile(rf"{quoted}|[^{mark}]*")
