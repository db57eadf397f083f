"""Facts about axes in a control's own files, other than compensation values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from compwright.records.axis import AxisKind, Direction

#: One fact that a control's files say: a number, a word, a yes or no.
Fact = float | int | str | bool


@dataclass(frozen=True, slots=True)
class Turn:
    """The range of an endless rotary axis, deg. ``stated``: a file states where it starts."""

    start: float
    length: float
    stated: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class PairFacts:
    """Facts about the cross-axis tables that correct one axis.

    - ``own``: the indices of its own two tables, + first.
    - ``max_sum``: the control's limit of the sum of all corrections of the axis, mm or deg; None if
      unknown.
    - ``metric``: whether the values are in mm (True) or in inch; None if no file states it.
    - ``odd_sum``: the largest sum that is added by tables which cannot be read as curves, mm or
      deg.
    - ``uncounted``: the active tables from other axes that cannot be counted, as a text that
      changes with their values. ``uncounted_help``: what would allow them to be counted.
    """

    own: tuple[int, int] | None = None
    max_sum: float | None = None
    metric: bool | None = None
    odd_sum: float = 0.0
    uncounted: str = ""
    uncounted_help: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class AxisFacts:
    """Facts about one axis in a control's files. A fact that the files do not state is None or
    empty.

    - ``name``: the axis' name in the files, by the parameter ``name_evidence``. ``machine_name``:
      the machine's own name of the axis, used in the names of new files. ``letters``: the axes of
      all joints, one letter each.
    - ``limits``: the software limits or, for an endless axis, its ``turn``, mm or deg.
      ``limits_evidence``: why they differ from those in the files. ``endless``: the turn of an axis
      without ends, deg.
    - ``encoder_system``: the measuring system whose table was read. ``enabled``: whether its table
      is active. ``other_functions``: the axis' other active functions, as text.
    - ``reference``: machine coordinate of the reference position, mm or deg. ``reference_return``:
      the direction in which it is approached. ``homing``: ``"relative"`` if the control takes the
      correction at the reference as zero after homing, ``"absolute"`` if it adds the table as
      written; empty if no file states it.
    - ``diameter``: whether positions are programmed in diameter. ``unit_evidence``: the source of
      the detection unit.
    - ``synchronised``, ``leading``: the addresses of the other axes of its gantry, from the files.
      ``couplings``: the parameters that couple the axis with other axes, with their values, and by
      each the axis that follows this one (empty: another coupling).
    - ``lead``: the travel of one turn of the axis' motor, mm or deg, as the files suggest it
      (``lead_evidence``).
    - ``rapid_more``: backlash at rapid traverse minus backlash at cutting feed, mm or deg; None if
      unknown.
    - ``grid``: the points (ascending, mm or deg) of the axis' own table in the files, if that table
      is not active. The points of an active table are in its compensation.
    - ``unapplied_steps``: see `Axis`. ``of_family``: facts that only the family of the control
      uses. ``stated``: further quantities by a name that is common to all controls; they answer
      options.
    """

    name: str | None = None
    name_evidence: str = ""
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
    couplings: Mapping[str, str] = field(default_factory=dict)
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
    """The cross-axis tables in a control's files: for each table number the input and output axis,
    and the number of reserved points.

    ``stay``: the numbers of tables whose input is also their output and which stay whatever is
    written.
    ``curves``: positions and corrections, mm or deg, of the tables between two axes.
    ``obstacles``: for each table to which no correction can be added, every reason with its next
    step (empty: only another table helps). Without one, the table is one curve for both directions,
    active beyond doubt.
    ``off``: the tables between two axes that hold values and are switched off in the files.
    """

    used: Mapping[int, tuple[str, str]] = field(default_factory=dict)
    reserved: Mapping[int, int] = field(default_factory=dict)
    stay: frozenset[int] = frozenset()
    curves: Mapping[int, tuple[tuple[float, ...], tuple[float, ...]]] = field(default_factory=dict)
    obstacles: Mapping[int, tuple[tuple[str, str], ...]] = field(default_factory=dict)
    off: frozenset[int] = frozenset()
