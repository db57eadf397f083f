"""The squareness after loading compared with the prediction: whether its correction is active, what
is wrong with it, and the decision.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from compwright.foundations.findings import Finding
from compwright.records.correction_need import NEGLIGIBLE, most_uncertain
from compwright.records.prediction import Decision
from compwright.records.verification import SquarenessAfter

#: A loading fault of a squareness is named if U is below this part of the correction: the nearest
#: faults (not active, opposite sign) are a whole correction apart.
_CLEAR: Final = 0.25


@dataclass(frozen=True, slots=True)
class SquarenessCheck:
    """The squareness (µm/m) after loading compared with the prediction.

    ``before``: before loading, under the corrections that the control had as found; the plan
    changes it from there to ``expected``. ``U`` (k = 2): of the difference between ``value`` and
    ``expected``, from the noise of the two tests. It does not hold the set-up of the instrument.
    """

    value: float | None
    expected: float
    U: float
    before: float
    #: Whether the table that was read back differs from the plan: then this is the reason.
    differs: bool = False

    @property
    def factor(self) -> float | None:
        """The part of the planned correction that is active; None if the tests do not show it."""
        planned = self.before - self.expected
        if self.value is None or _CLEAR * abs(planned) <= self.U:
            return None
        return (self.before - self.value) / planned

    @property
    def verdict(self) -> Literal["loaded", "not_active", "inverted", "scaled", "undecided"]:
        """The name of the loading verdict to which ``factor`` belongs, as of an axis."""
        if self.factor is None:
            return "loaded" if self.decision == "accept" else "undecided"
        planned = abs(self.before - self.expected)
        near = max(self.U, min(NEGLIGIBLE, _CLEAR * planned)) / planned
        if abs(self.factor - 1.0) <= near:
            return "loaded"
        if abs(self.factor) <= near:
            return "not_active"
        if abs(self.factor + 1.0) <= near:
            return "inverted"
        return "scaled" if self.factor > 0.0 else "undecided"

    @property
    def active(self) -> bool:
        """Whether the correction is active as planned, so that a further one may be added."""
        return self.decision == "accept" or self.verdict == "loaded"

    @property
    def decision(self) -> Decision:
        """The decision on squareness.

        Accept if it differs from the prediction by no more than U, and U is small enough for a
        correction. Accept if a negligible squareness is left by a correction of which more than
        half is active.
        """
        if self.value is None:
            return "undecided"
        off, planned = abs(self.value - self.expected), abs(self.before - self.expected)
        if off <= self.U:
            return "accept" if most_uncertain(planned) > self.U else "undecided"
        negligible = abs(self.value) + self.U < NEGLIGIBLE and off + self.U < 0.5 * planned
        return "accept" if negligible else "reject"

    @property
    def result(self) -> SquarenessAfter:
        """The comparison as a record."""
        return SquarenessAfter(
            value=self.value,
            expected=self.expected,
            U=self.U,
            decision=self.decision,
            verdict=self.verdict,
            factor=self.factor,
            active=self.active,
        )

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The finding CW-V035 if the squareness after loading is not as predicted."""
        if self.value is None or self.decision == "undecided":
            return (Finding.of("CW-V035.open", "warning"),)
        if abs(self.value - self.expected) <= self.U:
            return ()
        accepted = self.decision == "accept"
        found = Finding.of(
            "CW-V035",
            "info" if accepted else "warning",
            value=self.value,
            expected=self.expected,
            U=self.U,
            verdict=(
                "read_back"
                if self.differs
                else "uncertain"
                if self.factor is None
                else self.verdict
            ),
            percent=100.0 * (self.factor or 0.0),
            negligible=NEGLIGIBLE if accepted else 0.0,
        )
        return (found,)
