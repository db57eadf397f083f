"""Findings: what was noticed on the way, as records with stable codes. Nobody prints on the way.

Code families: ``CW-R`` reading, ``CW-T`` test checks, ``CW-J`` job, ``CW-S`` state of the control,
``CW-E`` error estimate, ``CW-F`` fit, ``CW-X`` format and export, ``CW-P`` prediction, ``CW-V``
verification. The list with the meaning of each is ``docs/findings.md``; a test compares it with the
codes in the source.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final, Literal

Severity = Literal["info", "warning", "error"]

#: Findings that put the whole result in doubt. Terminal, report and card show them before
#: everything else (`doubts_of`), because whoever loads the table or signs the verdict has to settle
#: them first.
DOUBTS: Final = frozenset(
    {
        *("CW-R008", "CW-R009", "CW-R010", "CW-R011", "CW-T007", "CW-T011"),
        *("CW-R055", "CW-R056", "CW-R058"),
        *("CW-P131", "CW-P153", "CW-P154", "CW-P160"),
        *("CW-T030", "CW-T031", "CW-T032", "CW-T033", "CW-T034", "CW-T035", "CW-T036"),
        *("CW-E003", "CW-E010", "CW-E011", "CW-S005", "CW-S018", "CW-S045"),
        *("CW-S060", "CW-S061"),
        *("CW-V020", "CW-V021", "CW-V022", "CW-V023", "CW-V024", "CW-V025", "CW-V026", "CW-V027"),
        "CW-V028",
    }
)
#: How the doubts are headed, the same at the terminal, in reports and on the card.
DOUBTS_FIRST: Final = "Settle first: the result rests on it"


@dataclass(frozen=True, slots=True)
class Finding:
    """Something that the user should know. ``code`` is stable across versions; ``message`` is one
    plain sentence.
    """

    code: str
    severity: Severity
    message: str


def doubts_of(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return those of ``findings`` that have to be settled before the result is used, each once,
    the errors first; no infos.
    """
    told = dict.fromkeys(
        finding for finding in findings if finding.code in DOUBTS and finding.severity != "info"
    )
    return tuple(sorted(told, key=lambda finding: finding.severity != "error"))
