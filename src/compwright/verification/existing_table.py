"""Did the table that was in the control act in the tests before anything is written? A test with it
on, judged as a test after loading is, against one with it off (`verification.loading`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from compwright.foundations.findings import Finding
from compwright.foundations.numerals import significant
from compwright.records.verification import Candidate, LoadingName, LoadingVerdict
from compwright.words.sentences import say

#: Verdicts for a table that was active as in the files.
ACTIVE: Final[tuple[LoadingName, ...]] = ("loaded", "thermal")
_DID: Final[dict[LoadingName, str]] = {
    "not_active": "was not active",
    "inverted": "was active with the opposite sign",
    "scaled": "was active with factor {factor}",
    "shifted": "was active, shifted by {shift} points",
    "mirrored": "was active, mirrored over the travel",
    "wrong_axis": "was not the active one: that of another axis was",
    "one_direction": "was active in one direction only",
    "backlash": "was active with a different backlash",
    "partial": "was active over a part of the travel only",
    "measurement": "and the readings do not go together: one of the tests was measured wrongly",
    "undecided": "did something else ({which})",
}
#: What would have shown the same: the tests tell only by how much they differ.
_AS_WELL: Final[dict[LoadingName, str]] = {
    "not_active": (
        "or it was active in {off} as well: both show the same axis (was it off for {off}?)"
    ),
    "inverted": "or the two tests are exchanged",
}
#: Least probability of a fault, named or not; and of a candidate that is listed.
_CLEAR: Final = 0.99
_LISTED: Final = 0.05


@dataclass(frozen=True, slots=True)
class ExistingTableVerdict:
    """What two tests of an axis show about a table.

    ``on``, ``off``: names of the test with it and of the one without it; ``state``: the state in
    which it should have been active.
    """

    on: str
    off: str
    state: str
    verdict: LoadingVerdict

    @property
    def contradicted(self) -> bool:
        """Whether the active correction differs from the files: one named fault, or one of several
        with odds of 99 to 1.
        """
        if self.verdict.verdict != "undecided":
            return self.verdict.verdict not in ACTIVE
        fits = not any(finding.code == "CW-V001" for finding in self.verdict.findings)
        return fits and self.probability_active < 1.0 - _CLEAR

    @property
    def probability_active(self) -> float:
        """Probability that the table was active as in the files."""
        return sum(each.probability for each in self.verdict.candidates if each.verdict in ACTIVE)

    @property
    def likely(self) -> tuple[Candidate, ...]:
        """What may have happened, the likeliest first."""
        return tuple(each for each in self.verdict.candidates if each.probability >= _LISTED)

    def refusal(self, look_at: Sequence[str]) -> str:
        """Return why no table is written; ``look_at``: what to look at on the control."""
        found = self.verdict
        did = _DID[found.verdict].format(
            factor=significant(found.factor, 2),
            shift=f"{found.shift_nodes:+d}",
            which=_words(self.likely),
        )
        detail = found.detail or found.of or ""
        more = f" ({detail})" if detail else ""
        names = dict.fromkeys((found.verdict, *(each.verdict for each in self.likely)))
        as_well = "".join(
            f", {_AS_WELL[name].format(off=self.off)}" for name in names if name in _AS_WELL
        )
        percent = min(100.0 * (1.0 - self.probability_active), 99.9)
        look = f" Look at: {' '.join(look_at)}" if look_at else ""
        return (
            f"the tests {self.off} and {self.on} contradict what the files say, {percent:.1f} %"
            f" sure: the table of state {self.state} {did}{more} in {self.on}{as_well}. A total of"
            f" old and new would be wrong by as much.{look}".rstrip(".")
        )

    def finding(self) -> Finding | None:
        """Return that the table was active (CW-V030), or that the tests cannot decide it (CW-V031);
        None where it is contradicted.
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
            likely=[
                say(
                    "loading.likely",
                    verdict=each.verdict.replace("_", " "),
                    percent=100.0 * each.probability,
                )
                for each in self.likely
            ],
        )


def _words(likely: Sequence[Candidate]) -> str:
    return ", ".join(
        f"{each.verdict.replace('_', ' ')} {100.0 * each.probability:.0f} %" for each in likely
    )
