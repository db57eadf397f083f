"""Findings that readers of several forms share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import as_text
from compwright.instruments.fault_list import shown
from compwright.instruments.readings import Readings
from compwright.instruments.text_input import unfinished_number
from compwright.records.axis import AxisKind, FloatArray

_LISTED = 5
#: Values of ``compensated_for`` that say the instrument corrected nothing.
_NOTHING = frozenset({"", "no", "none", "nothing", "-"})


def assumed_finding(assumed: Sequence[str]) -> Finding | None:
    """Return the finding that says what the file leaves open, None when that is nothing."""
    return (
        Finding("CW-R001", "info", f"Not stated in the file, assumed: {'; '.join(assumed)}.")
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


def stray_finding(lines: Sequence[tuple[int, str]]) -> Finding | None:
    """Return the finding about lines (number, text) that look like readings where none are read,
    None when there are none.
    """
    if not lines:
        return None
    told = ", ".join(f"{number} {shown(text)}" for number, text in lines[:_LISTED])
    more = f" and {len(lines) - _LISTED} more" if len(lines) > _LISTED else ""
    return Finding(
        "CW-R063",
        "warning",
        "Lines that look like readings stand outside the readings and were not read: line"
        f" {told}{more}. Compare with the instrument.",
    )


def unread_finding(targets: FloatArray, readings: Readings, kind: AxisKind) -> Finding | None:
    """Return the finding about targets of rows (n,), in the unit of ``kind``, of which no reading
    was made; None when there are none.
    """
    without = np.setdiff1d(targets[np.isfinite(targets)], readings.targets)
    if not without.size:
        return None
    told = ", ".join(as_text(target) for target in without[:_LISTED].tolist())
    more = f" and {without.size - _LISTED} more" if without.size > _LISTED else ""
    return missing_finding(
        f"Rows without any reading were left out: target {told}{more} {kind.unit}. The results do"
        " not speak of them."
    )


def missing_finding(words: str) -> Finding:
    """Return the finding about readings that are missing; ``words``: a sentence."""
    return Finding("CW-R006", "warning", words)


def sheets_finding(words: str) -> Finding:
    """Return the finding about sheets of a workbook that were left out; ``words``: a sentence."""
    return Finding("CW-R061", "warning", words)


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


def doubtful_finding(number: str) -> Finding | None:
    """Return the finding about a point that may mark thousands (`DecimalMarks.doubtful_point`),
    None for an empty ``number``.
    """
    if not number:
        return None
    return Finding(
        "CW-R015",
        "warning",
        f"{shown(number)} was read with a decimal point, but whole numbers are in the same column"
        " and no number proves the point: if it marks thousands, take it out.",
    )


def header_findings(header: Mapping[str, str]) -> list[Finding]:
    """Return what is remarkable about what a file says of its test: no axis, something that was
    compensated already.
    """
    findings = []
    if not header.get("axis"):
        findings.append(
            Finding(
                "CW-R002", "info", "The file does not name its axis (comment line '# axis: X')."
            )
        )
    compensated = header.get("compensated_for", "")
    if compensated.lower() not in _NOTHING:
        findings.append(
            Finding("CW-R004", "info", f"The instrument already compensated for: {compensated}.")
        )
    return findings


def measured_findings(header: Mapping[str, str], *, sign_said: bool) -> list[Finding]:
    """Return the findings about a file of measured positions instead of deviations."""
    findings = [
        Finding(
            "CW-R003", "info", "Measured values were turned into deviations, measured minus target."
        )
    ]
    if sign_said and header.get("deviation"):
        findings.append(
            Finding(
                "CW-R013",
                "warning",
                f"The key 'deviation: {header.get('deviation')}' has no effect: the file gives"
                " measured values, not deviations.",
            )
        )
    return findings


def cut_finding(why: str) -> Finding:
    """Return the finding about a file that may have been cut off; ``why``: a sentence."""
    return Finding("CW-R053", "warning", why)


def falling_finding(what: str) -> Finding:
    """Return the finding about targets that do not stand from low to high; ``what``: how the
    directions were taken, a sentence.
    """
    return Finding("CW-R014", "warning", what)
