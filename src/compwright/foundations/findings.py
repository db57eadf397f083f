"""Findings: what was noticed on the way, as records with stable codes. Nobody prints on the way.

Code families: ``CW-R`` reading, ``CW-T`` test checks, ``CW-J`` job, ``CW-S`` state of the control, ``CW-E`` error
estimate, ``CW-F`` fit, ``CW-X`` format and export, ``CW-P`` prediction, ``CW-V`` verification. The list with the meaning of
each is ``docs/findings.md``; a test compares it with the codes in the source.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Severity = Literal["info", "warning", "error"]


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that the user should know. ``code`` is stable across versions; ``message`` is one plain sentence."""

    code: str
    severity: Severity
    message: str
