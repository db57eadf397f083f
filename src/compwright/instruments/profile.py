"""A mapping profile: a small YAML file with the meaning of the columns in another program's table.

No key that decides a sign, a unit or a direction has a default: a required key that is empty is
refused. ``docs/measurement-files.md`` explains it key by key.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final, Literal

from compwright.instruments.answers import Answers, Sign
from compwright.instruments.foreign_units import LENGTHS
from compwright.records.axis import AxisKind, Direction, PositionMap
from compwright.records.positioning import Cycle

VERSION: Final = 1
#: The key that makes a YAML file a profile; its value is the version.
MARK: Final = "compwright_profile"
Layout = Literal["long", "wide", "own"]
SIGNS: Final = ("measured minus target", "target minus measured")


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """The meaning of a table's columns. ``layout``: long (a row per reading), wide (a row per
    target), or own (a file form with its own reader; only ``unit`` and ``sign`` are used).

    Columns have the names in the header row. ``traverses``: direction and run of each column of a
    traverse. ``directions``: the direction that each word in the column ``direction`` means.
    ``position_map``: the conversion of positions, None if there is none. ``file`` and ``sha256``:
    those of the profile itself.
    """

    file: str
    layout: Layout
    encoding: str | None = None
    delimiter: str = ","
    decimal: str = "."
    header_line: int = 0
    axis: str = ""
    axis_column: str = ""
    target: str = ""
    target_unit: str = "mm"
    value: str = ""
    measured: bool = False
    unit: str | None = None
    sign: Sign | None = None
    direction_from: str = ""
    direction: str = ""
    directions: Mapping[str, Direction] = field(default_factory=dict)
    run: str = ""
    run_counts: str = "runs"
    traverses: Mapping[str, tuple[Direction, int]] = field(default_factory=dict)
    cycle: Cycle | None = None
    position_map: PositionMap | None = None
    leave_out: frozenset[str] = frozenset()
    sha256: str = ""

    @property
    def kind(self) -> AxisKind:
        """The kind of axis (linear, rotary), by the unit of the targets."""
        return AxisKind.LINEAR if self.target_unit in LENGTHS else AxisKind.ROTARY

    @property
    def answers(self) -> Answers:
        """The unit and sign in the profile, for a file whose form has its own reader."""
        return Answers(unit=self.unit, sign=self.sign)
