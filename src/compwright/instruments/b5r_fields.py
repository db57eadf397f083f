"""Read the required elements of a ``.b5r`` file as text and numbers. Faults go to a `FaultList`."""

from __future__ import annotations

import math
import re
from typing import Final

from compwright.instruments.fault_list import FaultList, shown
from compwright.instruments.numbers import LARGEST
from compwright.instruments.safe_xml import Element

_NUMBER: Final = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?")


def text_of(parent: Element, faults: FaultList, *path: str) -> tuple[str, str]:
    """Return text and place of a required element. If it is missing, add a fault and return ""."""
    element = parent.first(*path)
    if element is None or not element.text:
        place = f"line {(element or parent).line}, {parent.tag}/{'/'.join(path)}"
        faults.add("is missing" if element is None else "is empty", place=place, expected="a value")
        return "", place
    return element.text, f"line {element.line}, {parent.tag}/{'/'.join(path)}"


def finite(text: str) -> float | None:
    """Return the number in a text if it is finite and of plausible size, else None."""
    value = float(text) if _NUMBER.fullmatch(text) else math.nan
    return value if abs(value) <= LARGEST else None


def number_of(
    parent: Element, tag: str, faults: FaultList, *, above: float = -LARGEST, most: float = LARGEST
) -> float:
    """Return an element's number between ``above`` and ``most``; else add a fault, return NaN."""
    text, place = text_of(parent, faults, tag)
    if not text:
        return math.nan
    value = finite(text)
    if value is None:
        faults.add(
            "is not a number",
            place=place,
            expected="a number with a decimal point",
            found=shown(text),
        )
        return math.nan
    if not above < value <= most:
        faults.add(
            "is out of range",
            place=place,
            expected=f"above {above:g}, at most {most:g}",
            found=shown(text),
        )
        return math.nan
    return value
