"""Types of values in a job file: text, numbers, lists, and short forms of mappings."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag
from pydantic_core import PydanticCustomError


def _one_line_of_text(value: Any) -> Any:
    """Accept a word or whole number as text, but a decimal number such as 1.10 only in quotes."""
    if isinstance(value, int) and not isinstance(value, bool):
        return str(value)
    if not isinstance(value, str):
        kind = "text_in_quotes"
        raise PydanticCustomError(kind, "is not text")
    if not value.strip() or any(
        ord(character) < ord(" ") or character == "\x7f" for character in value
    ):
        kind = "one_line"
        raise PydanticCustomError(kind, "is blank or contains control characters")
    return value


def listed(value: Any) -> Any:
    """Return a list, also for a single entry that is written without a list."""
    return value if isinstance(value, list) else [value]


def named_file(value: Any) -> Any:
    """Return a mapping with ``files``, also for a value that is only a file name."""
    return {"files": [value]} if isinstance(value, str) else value


def named_axis(value: Any) -> Any:
    """Return a mapping with ``axis``, also for a value that is only an axis name."""
    return value if isinstance(value, dict) else {"axis": value}


def acknowledgements(value: Any) -> Any:
    """Return a list of mappings, also for a value that is one mapping or only a reason."""
    return [{"reason": one} if isinstance(one, str) else one for one in listed(value)]


def no_truth_value(value: Any) -> Any:
    """Refuse ``true`` where a number is expected, although Python takes it for 1."""
    if isinstance(value, bool):
        raise PydanticCustomError("truth_value", "is a truth value")
    return value


def yes_or_no(value: Any) -> Any:
    """Return the truth value that ``yes``, ``no``, ``true`` or ``false`` means in a job file."""
    return {"yes": True, "no": False}.get(value, value) if isinstance(value, str) else value


def files_or_mapping(value: Any) -> Any:
    """Return a mapping with ``files``, also for a value that is only file names."""
    return value if isinstance(value, dict) else {"files": value}


def _auto_or_number(value: Any) -> str:
    return "auto" if value == "auto" else "number"


def drift_file(value: Any) -> Any:
    """Return a mapping with ``file``, also for a value that is only a file name."""
    return {"file": value} if isinstance(value, str) else value


def drift_or_number(value: Any) -> str:
    """Return which model a value is checked by: ``drift`` for a file name or mapping, ``number``
    for any other value.
    """
    if isinstance(value, dict):
        return "drift"
    named = isinstance(value, str) and re.search(r"[^\W\d_]", value) is not None
    return "drift" if named else "number"


def size_of_smallest(limits: object) -> object:
    """Return the limits of a circular test, with the size of a negative limit on ``F_min_*``: the
    smallest radial deviation is mostly negative (ISO 230-4:1996, 3.5).
    """
    if not isinstance(limits, dict):
        return limits
    return {
        name: -limit
        if str(name).startswith("F_min") and isinstance(limit, int | float) and limit < 0
        else limit
        for name, limit in limits.items()
    }


Text = Annotated[str, BeforeValidator(_one_line_of_text)]
Positive = Annotated[float, Field(gt=0)]
#: Limits of a circular test by parameter.
CircularLimits = Annotated[
    dict[str, Positive], BeforeValidator(size_of_smallest), Field(min_length=1)
]
NotNegative = Annotated[float, Field(ge=0)]
#: A complaint about a number that is none speaks of a number, not of the word too.
Spacing = Annotated[
    Annotated[Positive, Tag("number")] | Annotated[Literal["auto"], Tag("auto")],
    Discriminator(_auto_or_number),
]
#: °C: one temperature, or that at the start and at the end of the test.
Temperature = Annotated[list[float], BeforeValidator(listed), Field(min_length=1, max_length=2)]
Sense = Annotated[Literal[1, -1], BeforeValidator(no_truth_value)]
Sign = Literal["+", "-"]
