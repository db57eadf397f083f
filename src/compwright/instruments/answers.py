"""Answers of the user about a file of a known form, for facts that the file leaves open."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Sign = Literal["measured minus target", "target minus measured"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Answers:
    """None where not answered. ``unit``: of the deviations, a key of `foreign_units`; ``sign``: of
    the deviations.
    """

    unit: str | None = None
    sign: Sign | None = None


NO_ANSWERS = Answers()
