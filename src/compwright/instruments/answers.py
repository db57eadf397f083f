"""The user's answers about a file of a known form, for facts that the file does not state."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Sign = Literal["measured minus target", "target minus measured"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Answers:
    """The user's answers, None where not given. ``unit`` of the deviations (a key of
    `foreign_units`) and their ``sign``.
    """

    unit: str | None = None
    sign: Sign | None = None


NO_ANSWERS = Answers()
