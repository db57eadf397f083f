"""Every mapping that a user writes is checked by pydantic; what is wrong comes with its key path,
what was expected and what was found. Cases are worked by hand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Any, Literal

import pytest
from pydantic_core import core_schema as cs

from compwright.formats.definitions import load_definition
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.key_faults import KeyFault, key_path_text, nearest
from compwright.foundations.record_schemas import RecordForm, RecordSchemas
from compwright.foundations.validation import checked
from compwright.foundations.yaml_reader import read_yaml
from compwright.instruments.profile_reading import read_profile
from compwright.jobs.reading import read_job
from compwright.simulation.reading import read_machine
from format_samples import CONTENT
from next_steps import without_hint
from places import PROJECT
from profile_samples import LONG_PROFILE


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
        Whole: RecordForm(keys={"by_name": "names"}, inline="part"),
        Part: RecordForm(absent=frozenset({"others"})),
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
    assert without_hint(str(faults[4].in_file("f"))) == (
        "f: names is not a mapping; expected a mapping: {key: value}, found 1"
    )


def test_the_nearest_name_has_its_own_case() -> None:
    assert nearest("TRAVLE", ["travel", "Table"]) == "travel"
    assert nearest("zzz", ["travel"]) is None


#: A sound mapping of each kind that a user writes, how it is read, and keys whose own keys are
#: names that the user chooses.
MAPPINGS: dict[str, tuple[bytes, Callable[[bytes], object], set[str]]] = {
    "job": (
        (PROJECT / "examples" / "fanuc-backup" / "job.yaml").read_bytes(),
        lambda content: read_job(content, "f"),
        {"axes", "states", "options", "accept", "acknowledged", "fixed_positions", "tool_change"},
    ),
    "machine": (
        (PROJECT / "examples" / "linuxcnc-two-axes" / "machine.yaml").read_bytes(),
        lambda content: read_machine(content, "f"),
        {"axes", "circles", "options"},
    ),
    "profile": (
        LONG_PROFILE.encode(),
        lambda content: read_profile(content, "f"),
        {"directions"},
    ),
    "definition": (
        CONTENT["isg-kernel.yaml"],
        lambda content: load_definition(content, "f"),
        {"sources", "texts", "statements", "fields", "bindings", "options", "parameters", "files"}
        | {"values", "error", "sign"},
    ),
}


@pytest.mark.parametrize("kind", sorted(MAPPINGS))
def test_a_misspelt_key_is_named_with_its_place_and_the_key_that_was_meant(kind: str) -> None:
    content, read, free = MAPPINGS[kind]
    read(content)  # sound
    document = read_yaml(content, "f")
    keys = [
        path for path in document.lines if isinstance(path[-1], str) and not free & {*path[-2:-1]}
    ]
    version = {
        "compwright",
        "virtual_machine",
        "compwright_profile",
        "compwright_format",
        "extends",
    }
    tried = [path for path in keys if path[-1] not in version][:: max(1, len(keys) // 12)]
    assert len(tried) > 5
    lines = content.decode().split("\n")
    for path in tried:
        at, key = document.lines[path] - 1, str(path[-1])
        before, found, after = lines[at].partition(f"{key}:")
        text = "\n".join([*lines[:at], f"{before}{key}x:{after}", *lines[at + 1 :]])
        with pytest.raises((UsageError, InputError)) as caught:
            read(text.encode())
        place = f"line {at + 1}, {key_path_text((*path[:-1], f'{key}x'))}"
        known = [fault for fault in caught.value.faults if fault.place == place]
        assert found, path
        assert [fault.expected for fault in known] == [f"{key!r}, the nearest known name"], path
