"""Findings that several readers of measurement files report."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.foundations.findings import Finding
from compwright.instruments.assembling import as_text
from compwright.instruments.csv_table import misspelt
from compwright.instruments.fault_list import shown
from compwright.instruments.readings import Readings
from compwright.instruments.text_input import unfinished_number
from compwright.records.axis import AxisKind, FloatArray
from compwright.words.sentences import Sentence, say

_LISTED = 5
#: Values of ``compensated_for`` that say the instrument corrected nothing.
_NOTHING = frozenset({"", "no", "none", "nothing", "-"})


def assumed_finding(assumed: Sequence[str]) -> Finding | None:
    """Return the finding about facts that are assumed because the file lacks them, or None if
    nothing is assumed.
    """
    return Finding.of("CW-R001", "info", assumed=assumed) if assumed else None


def left_out_finding(columns: Sequence[str], optional: str = "") -> Finding | None:
    """Return the finding about columns that are not part of the form, or None if there are none.

    ``optional``: the name of an optional column that the file does not have. If one of the columns
    may be this column under another name, the finding suggests it.
    """
    if not columns:
        return None
    near = list(misspelt(columns, {optional} - {""}))
    return Finding.of("CW-R005", "warning", columns=columns, near=near, name=optional)


def stray_finding(lines: Sequence[tuple[int, str]]) -> Finding | None:
    """Return the finding about ``lines`` that look like readings but were not read, or None if
    there are no such lines.
    """
    if not lines:
        return None
    listed = [f"{number} {shown(text)}" for number, text in lines[:_LISTED]]
    return Finding.of("CW-R063", "warning", lines=listed, more=max(0, len(lines) - _LISTED))


def unread_finding(targets: FloatArray, readings: Readings, kind: AxisKind) -> Finding | None:
    """Return the finding about targets (n,) without any reading, or None if each has a reading.

    The unit of the targets is that of ``kind``.
    """
    without = np.setdiff1d(targets[np.isfinite(targets)], readings.targets)
    if not without.size:
        return None
    shown_first = [as_text(target) for target in without[:_LISTED].tolist()]
    more = max(0, without.size - _LISTED)
    return missing_finding(say("CW-R006.rows", targets=shown_first, more=more, unit=kind.unit))


def missing_finding(sentence: Sentence) -> Finding:
    """Return the finding about missing readings; the ``sentence`` states which readings are
    missing.
    """
    return Finding("CW-R006", "warning", sentence)


def sheets_finding(sentence: Sentence) -> Finding:
    """Return the finding about sheets of a workbook that were not read; the ``sentence`` states
    which.
    """
    return Finding("CW-R061", "warning", sentence)


def unfinished_finding(lines: Sequence[str]) -> Finding | None:
    """Return the finding that the last number of a file may have lost digits, or None if that
    number is complete.
    """
    number = unfinished_number(lines)
    if not number:
        return None
    return Finding.of("CW-R051", "warning", number=shown(number), line=len(lines))


def doubtful_finding(number: str) -> Finding | None:
    """Return the finding that the point in ``number`` may separate thousands, or None if ``number``
    is empty.
    """
    if not number:
        return None
    return Finding.of("CW-R015", "warning", number=shown(number))


def header_findings(header: Mapping[str, str]) -> list[Finding]:
    """Return the findings about a file's header: that it names no axis, and that its readings were
    already compensated by the instrument.
    """
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
    """Return the finding that the targets fall within the file. ``sentence``: states how the
    directions were found.
    """
    return Finding("CW-R014", "warning", sentence)
