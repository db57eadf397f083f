"""Findings that several readers of measurement files report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import as_text
from compwright.instruments.fault_list import shown
from compwright.instruments.readings import Readings
from compwright.instruments.text_input import unfinished_number
from compwright.records.axis import AxisKind, FloatArray
from compwright.words.sentences import Sentence, say

_LISTED = 5
#: Values of ``compensated_for`` that say the instrument corrected nothing.
_NOTHING = frozenset({"", "no", "none", "nothing", "-"})


def assumed_finding(assumed: Sequence[str]) -> Finding | None:
    """Return the finding about facts that are assumed because the file lacks them, None without
    any.
    """
    return Finding.of("CW-R001", "info", assumed=assumed) if assumed else None


def left_out_finding(columns: Sequence[str]) -> Finding | None:
    """Return the finding about columns that are not part of the form, or None if there are none."""
    return Finding.of("CW-R005", "warning", columns=columns) if columns else None


def stray_finding(lines: Sequence[tuple[int, str]]) -> Finding | None:
    """Return the finding about lines that look like readings but are not read, None without any."""
    if not lines:
        return None
    listed = [f"{number} {shown(text)}" for number, text in lines[:_LISTED]]
    return Finding.of("CW-R063", "warning", lines=listed, more=max(0, len(lines) - _LISTED))


def unread_finding(targets: FloatArray, readings: Readings, kind: AxisKind) -> Finding | None:
    """Return the finding about targets (n,) without any reading, or None if each has a reading.

    Their unit is that of ``kind``.
    """
    without = np.setdiff1d(targets[np.isfinite(targets)], readings.targets)
    if not without.size:
        return None
    shown_first = [as_text(target) for target in without[:_LISTED].tolist()]
    more = max(0, without.size - _LISTED)
    return missing_finding(say("CW-R006.rows", targets=shown_first, more=more, unit=kind.unit))


def missing_finding(sentence: Sentence) -> Finding:
    """Return the finding about missing readings. ``sentence``: which ones are missing."""
    return Finding("CW-R006", "warning", sentence)


def sheets_finding(sentence: Sentence) -> Finding:
    """Return the finding about left-out sheets of a workbook. ``sentence``: which ones."""
    return Finding("CW-R061", "warning", sentence)


def unfinished_finding(lines: Sequence[str]) -> Finding | None:
    """Return the finding that a file may end inside its last number, or None if the number is
    complete.
    """
    number = unfinished_number(lines)
    if not number:
        return None
    return Finding.of("CW-R051", "warning", number=shown(number), line=len(lines))


def doubtful_finding(number: str) -> Finding | None:
    """Return the finding about a point that may be a thousands separator, None without one."""
    if not number:
        return None
    return Finding.of("CW-R015", "warning", number=shown(number))


def header_findings(header: Mapping[str, str]) -> list[Finding]:
    """Return the findings about a file's header: no axis, readings that are already compensated."""
    findings = []
    if not header.get("axis"):
        findings.append(Finding.of("CW-R002", "info"))
    compensated = header.get("compensated_for", "")
    if compensated.lower() not in _NOTHING:
        findings.append(Finding.of("CW-R004", "info", compensated=compensated))
    return findings


def measured_findings(header: Mapping[str, str], *, sign_stated: bool) -> list[Finding]:
    """Return the findings about a file with measured positions instead of deviations."""
    findings = [Finding.of("CW-R003", "info")]
    if sign_stated and header.get("deviation"):
        findings.append(Finding.of("CW-R013", "warning", deviation=header.get("deviation")))
    return findings


def cut_finding(sentence: Sentence) -> Finding:
    """Return the finding about a file that may have been cut off. ``sentence``: the reason."""
    return Finding("CW-R053", "warning", sentence)


def falling_finding(sentence: Sentence) -> Finding:
    """Return the finding about falling targets. ``sentence``: how the directions were found."""
    return Finding("CW-R014", "warning", sentence)
