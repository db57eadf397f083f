"""The squareness after loading compared with the prediction: whether its correction is active, what
is wrong with it, and the decision.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Literal

from compwright.foundations.findings import Finding, Severity
from compwright.records.correction_need import NEGLIGIBLE, most_uncertain
from compwright.records.prediction import Decision
from compwright.records.verification import LoadingName, LoadingVerdict, SquarenessAfter
from compwright.words.sentences import say

#: The active part of a correction is known if U is below this part of the correction.
_CLEAR: Final = 0.25


@dataclass(frozen=True, slots=True)
class SquarenessCheck:
    """The squareness (µm/m) after loading compared with the prediction.

    ``before``: before loading, under the corrections that the control had as found; the plan
    changes it from there to ``expected``. ``U`` (k = 2): of the difference between ``value`` and
    ``expected``, from the noise of the two tests. It does not hold the set-up of the instrument.
    ``fault``: what the circle shows of the loaded table; None if that is unknown.
    """

    value: float | None
    expected: float
    U: float
    before: float
    fault: LoadingVerdict | None = None
    #: Whether the table that was read back is as planned; None if none was read back.
    as_planned: bool | None = None

    @property
    def factor(self) -> float | None:
        """The part of the planned correction that is active; None if the tests do not show it."""
        planned = self.before - self.expected
        if self.value is None or _CLEAR * abs(planned) <= self.U:
            return None
        return (self.before - self.value) / planned

    @property
    def verdict(self) -> LoadingName | Literal["read_back"]:
        """The name of the loading verdict, as of an axis; ``read_back`` if the table that was read
        back differs from the plan.
        """
        if self.as_planned is False:
            return "read_back"
        if self.factor is not None:
            planned = abs(self.before - self.expected)
            near = max(self.U, min(NEGLIGIBLE, _CLEAR * planned)) / planned
            if abs(self.factor - 1.0) <= near:
                return "loaded"
            if self.fault is not None and self.fault.verdict != "undecided":
                return self.fault.verdict
        return "loaded" if self.decision == "accept" else "undecided"

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
            candidates=() if self.fault is None else self.fault.candidates,
        )

    @property
    def findings(self) -> tuple[Finding, ...]:
        """The finding CW-V035 if the squareness after loading is not as predicted."""
        if self.value is None or self.decision == "undecided":
            return (Finding.of("CW-V035.open", "warning"),)
        if abs(self.value - self.expected) <= self.U:
            return ()
        accepted = self.decision == "accept"
        uncertain = self.factor is None and self.as_planned is not False
        return (
            correction_finding(
                self.value,
                self.expected,
                self.U,
                "uncertain" if uncertain else self.verdict,
                self.fault,
                as_planned=self.as_planned is True,
                severity="info" if accepted else "warning",
                negligible=NEGLIGIBLE if accepted else 0.0,
            ),
        )


def correction_finding(
    value: float,
    expected: float,
    U: float,
    verdict: str,
    fault: LoadingVerdict | None,
    *,
    as_planned: bool,
    severity: Severity = "warning",
    axis: str = "",
    negligible: float = 0.0,
) -> Finding:
    """Return the finding CW-V035 on a squareness, or on the scale error of an ``axis``, that is not
    as ``expected`` after loading (µm/m), with the name of the loading ``fault``. ``as_planned``:
    the table was read back, and is as planned.
    """
    return Finding.of(
        "CW-V035",
        severity,
        axis=axis,
        value=value,
        expected=expected,
        U=U,
        verdict=verdict,
        step=say("CW-V035.step", as_planned=as_planned),
        loading=say("loading.circle", effect=None, candidates=[])
        if fault is None
        else fault.sentence,
        negligible=negligible,
    )
