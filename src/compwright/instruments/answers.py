"""Facts that a measurement file does not state and the user gives: the unit and the sign."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Sign = Literal["measured minus target", "target minus measured"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Answers:
    """Unit and sign of a file's deviations as the user states them; None if not stated."""

    unit: str | None = None
    sign: Sign | None = None


NO_ANSWERS = Answers()
