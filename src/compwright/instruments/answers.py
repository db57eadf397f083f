"""What a user says about a file of a known form that the file itself leaves open."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Sign = Literal["measured minus target", "target minus measured"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Answers:
    """None where nobody said it. ``unit``: of the deviations, a key of `foreign_units`; ``sign``:
    of the deviations.
    """

    unit: str | None = None
    sign: Sign | None = None


NO_ANSWERS = Answers()
