"""Lines of machine parameters of an iTNC 530: ``MP710.0 : 0.0040`` (index = axis number from 0) and
``MP730 : %00011``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from compwright.controllers.heidenhain.words import (
    MOST_AXES,
    Generation,
    LinePlace,
    Parameter,
    Quantity,
    number,
)
from compwright.foundations.errors import Fault

_PARAMETER = re.compile(
    r"MP(710|720|730)(?:\.([0-9]{1,2}))?\s{0,80}:\s{0,80}(\S{1,40})", re.IGNORECASE
)
_MINE = re.compile(r"MP\s{0,80}(?:710|720|730)(?![0-9])", re.IGNORECASE)
_OTHER = re.compile(r"MP[0-9]", re.IGNORECASE)
_BITS = re.compile(f"%[01]{{1,{MOST_AXES}}}")
_DECIMAL = re.compile("[0-9]{1,6}")


@dataclass(slots=True)
class ParameterLines:
    """Parameters in their order, other lines (``stray``), and faults."""

    parameters: list[Parameter] = field(default_factory=list)
    stray: list[tuple[LinePlace, str]] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)


def read_parameters(
    lines: Sequence[tuple[LinePlace, str]], generation: Generation
) -> ParameterLines:
    """Read MP710, MP720 and MP730 of the axes that ``generation`` numbers; skip other parameters
    and comments (``;``, ``#``, ``*``).
    """
    found = ParameterLines()
    for place, line in lines:
        code = line.split(";", 1)[0].strip()
        if _MINE.match(code):
            _read(code, place, found, generation)
        elif code and not code.startswith(("#", "*")) and not _OTHER.match(code):
            found.stray.append((place, code))
    return found


def _read(code: str, place: LinePlace, found: ParameterLines, generation: Generation) -> None:
    match = _PARAMETER.fullmatch(code)
    index = None if match is None or match.group(2) is None else int(match.group(2))
    if match is None or (index is None) != (match.group(1) == "730") or (index or 0) >= MOST_AXES:
        found.faults.append(
            place.fault(
                "parameter cannot be read",
                expected="MP710.0 : 0.0040 or MP730 : %00000",
                found=repr(code[:80]),
            )
        )
        return
    text = match.group(3)
    if index is None:
        found.parameters += _mask(text, place, found, generation)
        return
    value = number(text)
    if value is None:
        found.faults.append(
            place.fault("value", expected="a number with a decimal point", found=repr(text))
        )
        return
    quantity, unit = (
        (Quantity.BACKLASH, "") if match.group(1) == "710" else (Quantity.LINEAR, "mm/m")
    )
    found.parameters.append(Parameter(quantity, generation.axis(index + 1), value, unit, place))


def _mask(
    text: str, place: LinePlace, found: ParameterLines, generation: Generation
) -> list[Parameter]:
    """Return the bits of MP730, bit 0 = first axis: all digits of ``%00011``, all axes of a decimal
    number.
    """
    bits = text[1:][::-1] if _BITS.fullmatch(text) else ""
    if len(text.lstrip("0")) > 1 and not set(text) - {"0", "1"}:
        found.faults.append(
            place.fault(
                "MP730: bits or a decimal number",
                expected=f"%{text} or %{int(text):b}",
                found=repr(text),
            )
        )
        return []
    if _DECIMAL.fullmatch(text) and int(text) < 1 << MOST_AXES:
        bits = f"{int(text):0{MOST_AXES}b}"[::-1]
    if not bits:
        found.faults.append(
            place.fault(
                "MP730",
                expected=f"%00000 (up to {MOST_AXES} bits) or a whole number",
                found=repr(text),
            )
        )
    return [
        Parameter(Quantity.NONLINEAR, generation.axis(index + 1), float(bit), "", place)
        for index, bit in enumerate(bits)
    ]
