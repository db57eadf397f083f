"""Every mapping that a user writes is checked by pydantic; what is wrong comes with its key path,
what was expected and what was found. Cases are worked by hand.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Literal

import pytest
from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, nearest
from compwright.foundations.record_schemas import Form, RecordSchemas
from compwright.foundations.validation import checked


class Side(Enum):
    LEFT = "left"
    RIGHT = "right"


@dataclass(frozen=True)
class Part:
    """A part that may hold others of its kind."""

    length: float
    side: Side
    others: tuple[Part, ...] = ()


@dataclass(frozen=True)
class Round:
    kind: Literal["round"]
    radius: float


@dataclass(frozen=True)
class Flat:
    kind: Literal["flat"]
    ends: tuple[float, float]


@dataclass(frozen=True)
class Whole:
    name: str
    part: Part
    shapes: tuple[Round | Flat, ...]
    by_name: Mapping[str, float | None]


def _longer(part: Part) -> Iterator[str]:
    if part.length < sum(other.length for other in part.others):
        yield "a length that holds the others"
    if part.length < 0:
        yield "a length of 0 or more"


WHOLE = RecordSchemas(
    {
        Whole: Form(keys={"by_name": "names"}, inline="part"),
        Part: Form(absent=frozenset({"others"})),
    },
    {Part: _longer},
    {str: cs.is_instance_schema(str), float: cs.float_schema(strict=True)},
).validator(Whole)
SOUND: dict[str, Any] = {
    "name": "a",
    "length": 3,
    "side": "left",
    "others": [{"length": 1.5, "side": "right"}],
    "shapes": [{"kind": "round", "radius": 1.0}, {"kind": "flat", "ends": [0.0, 1.0]}],
    "names": {"b": None},
}


def test_a_record_comes_back_from_its_mapping() -> None:
    made, faults = checked(WHOLE, SOUND)
    assert faults == []
    part = Part(3.0, Side.LEFT, (Part(1.5, Side.RIGHT),))
    assert made == Whole("a", part, (Round("round", 1.0), Flat("flat", (0.0, 1.0))), {"b": None})


@pytest.mark.parametrize(
    ("change", "path"),
    [
        ({"nam": "a"}, ("nam",)),
        ({"name": 3}, ("name",)),
        ({"length": "3"}, ("length",)),
        ({"length": True}, ("length",)),
        ({"side": "top"}, ("side",)),
        ({"others": {}}, ("others",)),
        ({"others": [{"length": 1.5}]}, ("others", 0, "side")),
        ({"shapes": [{"kind": "square"}]}, ("shapes", 0, "kind")),
        ({"shapes": [{}]}, ("shapes", 0, "kind")),
        ({"shapes": [{"kind": "flat", "ends": [0.0]}]}, ("shapes", 0, "ends")),
        ({"shapes": [{"kind": "flat", "ends": [0.0, "1"]}]}, ("shapes", 0, "ends", 1)),
        ({"names": {"b": "x"}}, ("names", "b")),
    ],
)
def test_one_change_is_one_fault_at_its_place(
    change: Mapping[str, Any], path: tuple[str | int, ...]
) -> None:
    assert [fault.path for fault in checked(WHOLE, {**SOUND, **change})[1]] == [path]


def test_all_faults_come_at_once_and_name_what_is_near() -> None:
    data = {**SOUND, "names": 1, "shapes": [{"kind": "round", "raduis": 1.0}], "length": -1}
    faults = checked(WHOLE, data)[1]
    assert [fault.path for fault in faults] == [
        (),
        (),
        ("shapes", 0, "radius"),
        ("shapes", 0, "raduis"),
        ("names",),
    ]
    assert faults[0] == KeyFault((), "contradicts itself", "a length that holds the others", "")
    assert faults[3].expected == "'radius', the nearest known name"
    assert str(faults[4].in_file("f")) == (
        "f: names: is not a mapping; expected a mapping: {key: value}, found 1"
    )


def test_the_nearest_name_has_its_own_case() -> None:
    assert nearest("TRAVLE", ["travel", "Table"]) == "travel"
    assert nearest("zzz", ["travel"]) is None
