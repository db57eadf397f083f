"""What a control's own files say of its axes beside the compensation itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from compwright.records.axis import AxisKind

#: One fact that a control's files say: a number, a word, a yes or no.
Fact = float | int | str | bool


@dataclass(frozen=True, slots=True)
class Turn:
    """The range of an endless axis: where it begins and its length, deg. ``said``: a file says
    where it begins.
    """

    start: float
    length: float
    said: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class PairFacts:
    """What tables between axes, or of the axis over itself, mean for one axis.

    ``own``: the indices of its own two tables, + first. ``max_sum``: the control's limit of the sum
    of all corrections on it, mm or deg; None: not said. ``odd_sum``: what tables that cannot be
    read as curves add to it at most, mm or deg. ``untold``: the tables from other axes that act on
    it and cannot be counted with, in words that change with their values.
    """

    own: tuple[int, int] | None = None
    max_sum: float | None = None
    odd_sum: float = 0.0
    untold: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisFacts:
    """What a control's files say of one axis; None or empty: they do not say it.

    ``name``: what they call it; ``letters``: the axes of all joints, one letter each. ``limits``:
    the software limits or, of an endless axis, its ``turn``, mm or deg. ``encoder_system``: the
    measuring system whose table was read. ``enabled``: its table acts. ``beside``: what else acts
    on it, in words. ``said``: further quantities by neutral name, which settle options.
    """

    name: str | None = None
    letters: str = ""
    kind: AxisKind | None = None
    limits: tuple[float, float] | None = None
    turn: Turn | None = None
    encoder_system: int | None = None
    enabled: bool | None = None
    beside: str = ""
    pairs: PairFacts = PairFacts()
    said: Mapping[str, Fact] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class PairTables:
    """The tables between axes that a control's files hold, by index: input and output axis, and the
    points that are reserved.
    """

    used: Mapping[int, tuple[str, str]] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
