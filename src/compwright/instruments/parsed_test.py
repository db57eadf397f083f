"""What a reader of a file format returns: the readings of a test and the facts in the file, before
the checks that all formats share.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.foundations.findings import Finding
from compwright.instruments.readings import Readings
from compwright.records.axis import AxisKind
from compwright.records.positioning import Cycle


@dataclass(frozen=True, slots=True, kw_only=True)
class Parsed:
    """The readings of one test: targets and deviations (measured minus target) in mm or deg.

    ``header``: the facts in the file as text, by their key; known facts have the key of
    `comments.KNOWN_KEYS`. ``assumed``: the facts that the file does not state, with the values that
    were assumed, as text.
    """

    kind: AxisKind
    readings: Readings
    header: Mapping[str, str] = field(default_factory=dict)
    cycle: Cycle | None = None
    assumed: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()
