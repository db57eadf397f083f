"""Did the table that was in the control act in the tests before anything is written? A test with it
on, judged as a test after loading is, against one with it off (`verification.loading`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.verification import LoadingName, LoadingVerdict

#: Verdicts that say that it acted as the files say, or that nothing can be told.
ACTED: Final[tuple[LoadingName, ...]] = ("loaded", "thermal")
_DID: Final[dict[LoadingName, str]] = {
    "not_active": "did not act",
    "inverted": "acted with the opposite sign",
    "scaled": "acted {factor} times",
    "shifted": "acted shifted by {shift} nodes",
    "mirrored": "acted mirrored over the travel",
    "wrong_axis": "was not the one that acted: that of another axis did",
    "one_direction": "acted in one direction only",
    "backlash": "acted with another backlash",
    "partial": "acted over a part of the travel only",
    "measurement": "cannot have acted as one of the tests was measured",
}


@dataclass(frozen=True, slots=True)
class OldTable:
    """What two tests of an axis say of a table. ``on``, ``off``: names of the test with it and of
    the one without it, ``state`` that in which it should have acted.
    """

    on: str
    off: str
    state: str
    verdict: LoadingVerdict

    @property
    def contradicted(self) -> bool:
        """Whether something else acted than the files say: named, with odds of 99 to 1."""
        return self.verdict.verdict not in (*ACTED, "undecided")

    @property
    def odds(self) -> float:
        """Probability of the verdict, with what no test could tell from it."""
        told = {self.verdict.verdict, *self.verdict.equivalent}
        if self.verdict.verdict in ACTED:
            told |= set(ACTED)
        return sum(each.probability for each in self.verdict.candidates if each.verdict in told)

    def refusal(self, look_at: Sequence[str]) -> str:
        """Return why no table is written; ``look_at``: what to look at on the control."""
        found = self.verdict
        did = _DID[found.verdict].format(
            factor=significant(found.factor, 2), shift=f"{found.shift_nodes:+d}"
        )
        detail = found.detail or found.of or ""
        more = f" ({detail})" if detail else ""
        percent = min(100.0 * self.odds, 99.9)
        look = f". Look at: {' '.join(look_at)}" if look_at else ""
        return (
            f"the tests {self.off} and {self.on} contradict what the files say: the table of state"
            f" {self.state} {did}{more} in {self.on}, with {percent:.1f} %, and a total of old"
            f" and new would be wrong by as much{look.rstrip('.')}"
        )

    def finding(self) -> Finding | None:
        """Return that the table acted (CW-V030), or that nothing can be told (CW-V031); None where
        it is contradicted.
        """
        if self.contradicted:
            return None
        between = f"Tests {self.off} (without it) and {self.on} (with it)"
        if self.verdict.verdict in ACTED:
            text = f"{between}: the table of state {self.state} acted as its files say."
            return Finding("CW-V030", "info", text)
        likely = ", ".join(
            f"{each.verdict.replace('_', ' ')} {100.0 * each.probability:.0f} %"
            for each in self.verdict.candidates
            if each.probability >= 0.05
        )
        text = (
            f"{between} do not tell whether the table of state {self.state} acted as its files say:"
            f" {likely or 'nothing that is known fits'}. They count as far as they agree."
        )
        return Finding("CW-V031", "warning", text)
