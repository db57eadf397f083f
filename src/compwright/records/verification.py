"""The verdict on how a table was loaded, from a test after loading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.axis import Direction
from compwright.words.sentences import Sentence, SentenceText

LoadingName = Literal[
    "loaded",
    "not_active",
    "inverted",
    "scaled",
    "shifted",
    "mirrored",
    "wrong_axis",
    "one_direction",
    "backlash",
    "partial",
    "increment",
    "on_top",
    "state",
    "thermal",
    "measurement",
    "undecided",
]
#: What is wrong with a measurement, for the verdict ``measurement``.
MeasurementFault = Literal["sign", "direction", "unit", "wrong_axis", "copied", "zeros"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """A possible loading verdict and its probability. ``detail``: which form of the fault is most
    probable, as text.
    """

    verdict: LoadingName
    probability: float
    detail: Sentence | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class LoadingVerdict:
    """The verdict on whether the loaded table was active as planned.

    ``margin``: natural logarithm of the odds of the favoured candidate over the next one (4.6 is
    100:1). ``sentence``: its text. ``equivalent``: names that no test could distinguish from the
    verdict; ``near``: names that this test distinguishes poorly, whatever their prior probability
    (less than eight standard errors apart). ``candidates``: the likeliest names, first the
    likeliest, empty if no known one fits. ``detail``: the variant of the verdict, in words. ``of``:
    for ``measurement``, its fault; for ``wrong_axis``, the axis. ``factor``: for ``scaled``;
    ``shift_nodes`` > 0: the loaded table sits so many nodes too far to +. ``slope``: of the after
    test relative to the expected one, with its standard error, mm/mm; None if none was found.
    """

    verdict: LoadingName
    margin: float
    sentence: Sentence
    equivalent: tuple[LoadingName, ...] = ()
    factor: float = 1.0
    shift_nodes: int = 0
    of: str | None = None
    detail: Sentence | None = None
    near: tuple[LoadingName, ...] = ()
    candidates: tuple[Candidate, ...] = ()
    slope: tuple[float, float] | None = None
    findings: tuple[Finding, ...] = ()

    @property
    def message(self) -> str:
        """The sentence in English."""
        return SentenceText(self.sentence)


@dataclass(frozen=True, slots=True)
class ReadBack:
    """The largest difference (mm or deg) between the correction read back and the planned one, and
    the fault that explains it.

    ``verdict``: ``loaded``, ``not_active``, ``inverted``, ``scaled``, ``shifted``,
    ``one_direction``, ``backlash``, ``increment``, ``on_top``, ``partial`` (some files were not
    loaded), ``other``.
    """

    worst: float
    position: float
    direction: Direction
    verdict: str
    message: str
