"""Decision whether the existing table was active during the tests, made before a run writes a new
table.

A test with the table and a test without it are compared in the same way as a test after loading
with the tests before (`verification.loading`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from compwright.foundations.findings import Finding
from compwright.records.verification import Candidate, LoadingName, LoadingVerdict
from compwright.verification.loading_messages import candidate_text
from compwright.words.sentences import Sentence, say

#: Verdicts for a table that was active as in the files.
ACTIVE: Final[tuple[LoadingName, ...]] = ("loaded", "thermal")
#: Least probability of a fault, named or not; and of a candidate that is listed.
_CLEAR: Final = 0.99
_LISTED: Final = 0.05


@dataclass(frozen=True, slots=True)
class ExistingTableVerdict:
    """The verdict on whether the existing table was active, from one test with the table and one
    test without it.

    ``on``, ``off``: names of the test with the table and of the test without it. ``state``: the
    state of the control in which the table should have been active.
    """

    on: str
    off: str
    state: str
    verdict: LoadingVerdict

    @property
    def contradicted(self) -> bool:
        """Whether the tests show, with odds above 99 to 1, that the active correction was not the
        one in the files.
        """
        if self.verdict.verdict != "undecided":
            return self.verdict.verdict not in ACTIVE
        fits = not any(finding.code == "CW-V001" for finding in self.verdict.findings)
        return fits and self.probability_active < 1.0 - _CLEAR

    @property
    def probability_active(self) -> float:
        """The probability that the table was active with the values in the files."""
        return sum(each.probability for each in self.verdict.candidates if each.verdict in ACTIVE)

    @property
    def likely(self) -> tuple[Candidate, ...]:
        """The explanations of the tests that are probable enough to be listed, the most probable
        first.
        """
        return tuple(each for each in self.verdict.candidates if each.probability >= _LISTED)

    def refusal(self, look_at: Sequence[str]) -> Sentence:
        """Return the sentence that states why no table is written. ``look_at``: what to check on
        the control.
        """
        found = self.verdict
        names = {found.verdict, *(each.verdict for each in self.likely)}
        return say(
            "CW-P001.old_table",
            off=self.off,
            on=self.on,
            state=self.state,
            percent=min(100.0 * (1.0 - self.probability_active), 99.9),
            did=found.verdict,
            factor=found.factor,
            shift=found.shift_nodes,
            likely=self._likely_sentences(),
            detail=found.detail or found.of or "",
            # Both tests show the same then: only their difference speaks.
            off_too="not_active" in names,
            exchanged="inverted" in names,
            look_at=[sentence.rstrip(".") for sentence in look_at],
        )

    def finding(self) -> Finding | None:
        """Return the finding that the table was active (CW-V030), or that the tests cannot decide
        this (CW-V031). None if the tests show that the table was not active as in the files.
        """
        if self.contradicted:
            return None
        if self.verdict.verdict in ACTIVE:
            percent = min(100.0 * self.probability_active, 99.9)
            return Finding.of(
                "CW-V030", "info", off=self.off, on=self.on, state=self.state, percent=percent
            )
        return Finding.of(
            "CW-V031",
            "info" if self.probability_active >= _LISTED else "warning",
            off=self.off,
            on=self.on,
            state=self.state,
            likely=self._likely_sentences(),
        )

    def _likely_sentences(self) -> list[Sentence]:
        return [
            say(
                "loading.likely",
                verdict=candidate_text(each.verdict),
                percent=100.0 * each.probability,
            )
            for each in self.likely
        ]
