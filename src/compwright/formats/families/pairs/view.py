"""Tables between axes that are only shown, and hang together with no readings."""

from __future__ import annotations

from dataclasses import replace

from compwright.foundations.findings import Finding
from compwright.records.correction import Assumption, ControlState


def with_sign_unknown(state: ControlState) -> ControlState:
    """Return a state that was read as corrections, saying of its tables between axes that nobody
    knows their sign.
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
