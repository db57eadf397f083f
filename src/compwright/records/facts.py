"""What a control's own files say of its axes beside the compensation itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.records.axis import AxisKind, Direction

#: One fact that a control's files say: a number, a word, a yes or no.
Fact = float | int | str | bool


@dataclass(frozen=True, slots=True)
class Turn:
    """The range of an endless axis: where it begins and its length, deg. ``said``: a file says
    where it begins.
    """

    start: float
    length: float
    stated: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class PairFacts:
    """What tables between axes, or of the axis over itself, mean for one axis.

    ``own``: the indices of its own two tables, + first. ``max_sum``: the control's limit of the sum
    of all corrections on it, mm or deg; None: not said. ``metric``: their values stand in mm, not
    in inch; None: no file says it. ``odd_sum``: what tables that cannot be
    read as curves add to it at most, mm or deg. ``untold``: the tables from other axes that act on
    it and cannot be counted with, in words that change with their values; ``untold_help``: what
    would let them be counted with.
    """

    own: tuple[int, int] | None = None
    max_sum: float | None = None
    metric: bool | None = None
    odd_sum: float = 0.0
    untold: str = ""
    untold_help: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisFacts:
    """What a control's files say of one axis; None or empty: they do not say it.

    ``name``: what they call it; ``machine_name``: the machine's own name of it, by which new files
    are called. ``letters``: the axes of all joints, one letter each. ``limits``: the software
    limits or, of an endless axis, its ``turn``, mm or deg. ``encoder_system``: the measuring system
    whose table was read. ``enabled``: its table acts. ``beside``: what else acts on it, in words.
    ``endless``: the turn of an axis without ends, deg. ``reference``: machine coordinate of the
    reference position, mm or deg, approached in ``reference_return``. ``diameter``: positions are
    programmed in diameter. ``unit_evidence``: what says its detection unit. ``synchronised``,
    ``leading``: the addresses of the other axes of its gantry, as the files pair them. ``lead``:
    the travel of one turn of its motor, mm or deg, as the files suggest it (``lead_evidence``).
    ``limits_evidence``: why the limits are not those that stand there. ``rapid_more``: by how much
    the backlash at rapid traverse is more than that at cutting feed, mm or deg; None: they leave it
    open. ``grid``: the nodes (ascending, mm or deg) of a table of its own that the files hold but
    that does not act; that of one that acts stands in its compensation. ``homing``: the control,
    when it homes, counts the correction at ``reference`` as zero ("relative"), or adds the table as
    it stands ("absolute"); empty: no file says it. ``unapplied_steps``: see `Axis`. ``of_family``:
    what only the family of the control knows of the axis; nothing else looks into it. ``said``:
    further quantities by neutral name, which settle options.
    """

    name: str | None = None
    machine_name: str = ""
    letters: str = ""
    kind: AxisKind | None = None
    limits: tuple[float, float] | None = None
    turn: Turn | None = None
    encoder_system: int | None = None
    enabled: bool | None = None
    other_functions: str = ""
    endless: float | None = None
    reference: float | None = None
    reference_return: Direction | None = None
    absolute_encoder: bool | None = None
    diameter: bool | None = None
    unit_evidence: str = ""
    synchronised: tuple[str, ...] = ()
    leading: str | None = None
    lead: float | None = None
    lead_evidence: str = ""
    limits_evidence: str = ""
    rapid_more: float | None = 0.0
    grid: tuple[float, ...] = ()
    homing: Literal["", "relative", "absolute"] = ""
    unapplied_steps: tuple[float, float] | None = None
    pairs: PairFacts = PairFacts()
    of_family: object = None
    stated: Mapping[str, Fact] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class PairTables:
    """The tables between axes that a control's files hold, by index: input and output axis, and the
    points that are reserved. ``stay``: those over an axis itself that stay whatever is written.
    """

    used: Mapping[int, tuple[str, str]] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
    stay: frozenset[int] = frozenset()
