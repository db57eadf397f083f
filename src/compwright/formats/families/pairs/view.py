"""Tables between axes that are only shown; no measurement depends on them."""

from __future__ import annotations

from dataclasses import replace

from compwright.foundations.findings import Finding
from compwright.records.correction import Assumption, ControlState


def with_sign_unknown(state: ControlState) -> ControlState:
    """Return a state that was read as corrections, with the note that the sign of its tables
    between axes is unknown.
    """
    if not state.tables.used:
        return state
    assumption = Assumption(
        "option cec_sign",
        "correction",
        "unconfirmed: one manual of Siemens says error; no readings depend on it here",
    )
    return replace(
        state,
        assumed=(*state.assumed, assumption),
        findings=(*state.findings, Finding.of("CW-S055", "warning")),
    )
