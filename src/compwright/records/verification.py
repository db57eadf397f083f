"""The verdict on how a table was loaded, from a test after loading."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from compwright.foundations.findings import Finding
from compwright.records.axis import Direction
from compwright.records.prediction import Decision
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

    - ``margin``: natural logarithm of the odds of the favoured candidate against the next one (4.6
      is 100:1).
    - ``sentence``: the text of the verdict. ``detail``: the variant of the verdict, as text.
    - ``equivalent``: names that no test could distinguish from the verdict. ``near``: names that
      this test distinguishes poorly (less than eight standard errors apart), whatever their prior
      probability. ``candidates``: the most probable names, in falling order; empty if no known name
      fits.
    - ``of``: the fault of a ``measurement``, or the axis of ``wrong_axis``. ``factor``: that of
      ``scaled``. ``shift_nodes``: the number of points by which the loaded table is shifted, > 0
      towards +.
    - ``slope``: slope of the test after loading relative to the expected one, with its standard
      error, mm/mm; None if none was found.
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
    loaded) or ``other``.
    """

    worst: float
    position: float
    direction: Direction
    verdict: str
    message: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ScaleAfter:
    """The scale error (µm/m) of an axis after loading, corrected from circles, and the prediction
    ``expected``. ``U`` (k = 2): of their difference. ``verdict``, ``candidates``: as in
    `SquarenessAfter`.
    """

    value: float
    expected: float
    U: float
    verdict: LoadingName | Literal["read_back"] = "loaded"
    candidates: tuple[Candidate, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class SquarenessAfter:
    """The squareness (µm/m) after loading beside the prediction ``expected``, with the decision.

    ``value``: None if the circle does not determine it. ``U`` (k = 2): of their difference.
    ``factor``: the part of the correction that is active, None if the tests do not show it.
    ``active``: whether the correction is active as planned, so that a further one may be added.
    ``verdict``: as of an axis, or ``read_back`` if the table that was read back differs from the
    plan. ``candidates``: the most probable verdicts, in falling order.
    """

    value: float | None
    expected: float
    U: float
    decision: Decision
    verdict: LoadingName | Literal["read_back"]
    factor: float | None
    active: bool
    candidates: tuple[Candidate, ...] = ()
