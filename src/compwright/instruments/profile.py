"""A mapping profile: what the columns of a table made by somebody else mean, as a small YAML file.

Nothing in it has a default that decides about a sign, a unit or a direction: a key that is needed
and empty is refused. ``docs/measurement-files.md`` explains it key by key.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Final, Literal, cast

from compwright.foundations.errors import Fault, UsageError, raise_all
from compwright.foundations.provenance import fingerprint
from compwright.foundations.yaml_reader import YamlDocument, read_yaml
from compwright.instruments.answers import Answers, Sign
from compwright.instruments.csv_table import traverse_of
from compwright.instruments.fault_list import shown
from compwright.instruments.foreign_table import DELIMITERS
from compwright.instruments.foreign_units import ANGLES, LENGTHS
from compwright.records.axis import AxisKind, Direction, PositionMap
from compwright.records.positioning import Cycle

VERSION: Final = 1
#: The key that makes a YAML file a profile; its value is the version.
MARK: Final = "compwright_profile"
Layout = Literal["long", "wide", "own"]
#: How the approach direction of a row is told: by a column, by the order of the rows, or all alike.
DIRECTION_FROM: Final = ("column", "order", "+", "-")
SIGNS: Final = ("measured minus target", "target minus measured")
_CHOICES: Final[dict[str, tuple[Any, ...]]] = {
    "layout": ("long", "wide", "own"),
    "delimiter": tuple(DELIMITERS),
    "decimal": ("point", "comma"),
    "target_unit": (*LENGTHS, *ANGLES),
    "value_is": ("deviation", "measured"),
    "unit": (*LENGTHS, *ANGLES),
    "sign": SIGNS,
    "direction_from": DIRECTION_FROM,
    "run_counts": ("runs", "traverses"),
    "cycle": ("standard", "step"),
}
_TEXTS: Final = frozenset(
    {"encoding", "axis", "axis_column", "target", "value", "direction", "run"}
)
_OTHERS: Final = frozenset(
    {MARK, "header_line", "directions", "traverses", "position_map", "leave_out"}
)
#: Keys that a layout needs; further ones hang on what these say.
_NEEDED: Final[dict[str, tuple[str, ...]]] = {
    "long": (
        *("delimiter", "decimal", "header_line", "target", "target_unit"),
        *("value", "value_is", "unit", "direction_from"),
    ),
    "wide": (
        *("delimiter", "decimal", "header_line", "target", "target_unit"),
        *("value_is", "unit", "traverses"),
    ),
    "own": (),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """``layout``: long (one row per reading), wide (one column per traverse) or own (a form that
    has its own reader; only ``unit`` and ``sign`` count).

    Columns by their names in the header row; ``traverses``: column -> direction and run;
    ``directions``: word in the column ``direction`` -> direction. ``position_map``: None where it
    changes nothing. ``file`` and ``sha256``: of the profile itself.
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
        """The kind of axis, by the unit of the targets."""
        return AxisKind.LINEAR if self.target_unit in LENGTHS else AxisKind.ROTARY

    @property
    def answers(self) -> Answers:
        """What the profile says about a file of a form with its own reader."""
        return Answers(unit=self.unit, sign=self.sign)


def read_profile(content: bytes, file: str) -> Profile:
    """Return the profile in ``content``.

    Raises UsageError with every fault: a key that is needed and empty or absent, an unknown key, a
    value that is none of its words; InputError for what is no YAML.
    """
    document = read_yaml(content, file)
    data = document.data
    if not isinstance(data, dict) or MARK not in data:
        raise UsageError(
            Fault(
                message="is not a mapping profile",
                file=file,
                expected=f"YAML with the key {MARK}: {VERSION} (compwright profile FILE --out"
                " P.yaml writes one)",
            )
        )
    checked = _Checked(document, data, file, fingerprint(content))
    profile = checked.profile()
    raise_all(UsageError, checked.faults)
    return profile


class _Checked:
    """Takes values out of the data and notes what is wrong with them."""

    def __init__(
        self, document: YamlDocument, data: dict[str, Any], file: str, sha256: str
    ) -> None:
        self.document, self.data, self.file, self.sha256 = document, data, file, sha256
        self.faults: list[Fault] = []

    def fault(self, key: str, message: str, *, expected: str = "", found: object = None) -> None:
        path = tuple(key.split("\0"))
        self.faults.append(
            Fault(
                message=message,
                file=self.file,
                place=self.document.place(path),
                expected=expected,
                found="" if found is None else shown(str(found)),
            )
        )

    def profile(self) -> Profile:
        if self.data[MARK] != VERSION:
            self.fault(MARK, "is of a version that is not known", expected=str(VERSION))
        for key in self.data.keys() - _CHOICES.keys() - _TEXTS - _OTHERS:
            self.fault(key, "is no key of a profile")
        layout = self.choice("layout")
        if not layout:
            self.needed("layout")
            return Profile(file=self.file, layout="own")
        for key in _NEEDED[layout]:
            self.needed(key)
        measured = self.choice("value_is") == "measured"
        if layout != "own" and not measured:
            self.needed("sign")
        if layout == "long" and self.choice("direction_from") == "column":
            self.needed("direction")
            self.needed("directions")
        unit, target_unit = self.choice("unit"), self.choice("target_unit") or "mm"
        if layout != "own" and unit and (unit in LENGTHS) != (target_unit in LENGTHS):
            self.fault("unit", "is an angle and target_unit a length, or the reverse")
        return Profile(
            file=self.file,
            layout=cast("Layout", layout),
            encoding=self.text("encoding") or None,
            delimiter=DELIMITERS.get(self.choice("delimiter"), ","),
            decimal="," if self.choice("decimal") == "comma" else ".",
            header_line=self.header_line(),
            axis=self.text("axis"),
            axis_column=self.text("axis_column"),
            target=self.text("target"),
            target_unit=target_unit,
            value=self.text("value"),
            measured=measured,
            unit=unit or None,
            sign=cast("Sign | None", self.choice("sign") or None),
            direction_from=self.choice("direction_from"),
            direction=self.text("direction"),
            directions=self.directions(),
            run=self.text("run"),
            run_counts=self.choice("run_counts") or "runs",
            traverses=self.traverses(),
            cycle=cast("Cycle | None", self.choice("cycle") or None),
            position_map=self.position_map(),
            leave_out=self.leave_out(),
            sha256=self.sha256,
        )

    def needed(self, key: str) -> None:
        if self.data.get(key) in (None, "", {}):
            choices = _CHOICES.get(key)
            wanted = " or ".join(map(str, choices)) if choices else "a value"
            self.fault(key, f"'{key}' is empty and must be filled in", expected=wanted)

    def choice(self, key: str) -> str:
        value = self.data.get(key)
        if value is None or value == "":
            return ""
        if value not in _CHOICES[key]:
            known = f"'{key}' has an unknown value"
            if all(fault.place != self.document.place((key,)) for fault in self.faults):
                self.fault(key, known, expected=" or ".join(_CHOICES[key]), found=value)
            return ""
        return str(value)

    def text(self, key: str) -> str:
        value = self.data.get(key)
        if isinstance(value, dict | list):
            self.fault(key, f"'{key}' is not text", found=value)
            return ""
        return "" if value is None else " ".join(str(value).split())

    def header_line(self) -> int:
        value = self.data.get("header_line")
        if value is None:
            return 0
        if not isinstance(value, int) or isinstance(value, bool) or value < 0:
            self.fault(
                "header_line",
                "'header_line' is no line number",
                expected="1, 2, .., or 0 where there is no header row",
                found=value,
            )
            return 0
        return value

    def mapping(self, key: str) -> dict[str, Any]:
        value = self.data.get(key)
        if value is not None and not isinstance(value, dict):
            self.fault(key, f"'{key}' is no mapping", expected="lines 'word: value' below it")
            return {}
        return value or {}

    def directions(self) -> dict[str, Direction]:
        found = {}
        for word, value in self.mapping("directions").items():
            if value in ("+", "-"):
                found[word.casefold()] = Direction(value)
            else:
                empty = value in (None, "")
                self.fault(
                    f"directions\0{word}",
                    "is empty and must be filled in" if empty else "is neither + nor -",
                    expected='"+" (approached from below) or "-" (from above)',
                    found=None if empty else value,
                )
        return found

    def traverses(self) -> dict[str, tuple[Direction, int]]:
        found: dict[str, tuple[Direction, int]] = {}
        for column, value in self.mapping("traverses").items():
            traverse = traverse_of(str(value)) if value is not None else None
            if traverse is None:
                self.fault(
                    f"traverses\0{column}",
                    "is empty and must be filled in" if value is None else "is no traverse",
                    expected='"+1", "-1", "+2", ..: approach direction and run',
                    found=value,
                )
                continue
            one = (Direction(traverse[0]), traverse[1])
            if one in found.values():
                self.fault(f"traverses\0{column}", "is given twice", found=value)
            found[column] = one
        return found

    def position_map(self) -> PositionMap | None:
        if not self.data.get("position_map"):
            return None
        data = self.mapping("position_map")
        sense, offset = data.get("sense", 1), data.get("offset", 0.0)
        for key in data.keys() - {"sense", "offset"}:
            self.fault(f"position_map\0{key}", "is no key of a position map")
        if sense not in (1, -1) or isinstance(sense, bool):
            self.fault("position_map\0sense", "is neither 1 nor -1", found=sense)
            sense = 1
        if not isinstance(offset, int | float) or isinstance(offset, bool):
            self.fault("position_map\0offset", "is no number", found=offset)
            offset = 0.0
        found = PositionMap(sense=1 if sense == 1 else -1, offset=float(offset))
        return None if found == PositionMap() else found

    def leave_out(self) -> frozenset[str]:
        value = self.data.get("leave_out")
        if value is None:
            return frozenset()
        if not isinstance(value, list):
            self.fault("leave_out", "'leave_out' is no list of columns", found=value)
            return frozenset()
        return frozenset(" ".join(str(one).split()) for one in value)
