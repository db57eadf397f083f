"""The temperatures stated in a measurement file, at start and end of a test (ISO 230-2:2006, 7.1).

Keys of the header, °C: ``T_m`` is the temperature of the machine's scale or workpiece, ``T_d`` of
the measuring device. Instead of ``T_m`` a file may state ``T_m_start`` and ``T_m_end``, and instead
of ``T_d`` it may state ``T_d_start`` and ``T_d_end``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from compwright.foundations.errors import Fault, InputError, raise_all
from compwright.records.conditions import PLAUSIBLE_TEMPERATURES, Thermal
from compwright.records.positioning import PositioningTest

_NUMBER: Final = re.compile(r"([+-]?\d+(?:[.,]\d+)?)\s*(?:°\s?C|C|deg ?C)?")

Temperatures = Mapping[str, tuple[float, float]]


def stated_temperatures(header: Mapping[str, str], file: str) -> Temperatures:
    """Return the temperatures ``T_m`` and ``T_d`` (°C) at start and end of a test from the header
    of ``file``.

    Upper and lower case of the keys are equal; blanks and hyphens count as underscores. Raises
    InputError with a fault for each value that is no plausible temperature, for a start without an
    end, and for a temperature that is given in both forms.
    """
    keys = {re.sub(r"[ -]+", "_", key).lower(): (key, value) for key, value in header.items()}
    faults: list[Fault] = []
    found: dict[str, tuple[float, float]] = {}
    for name in ("T_m", "T_d"):
        given = {
            end: _number(*keys[f"{name}{end}".lower()], file, faults)
            for end in ("", "_start", "_end")
            if f"{name}{end}".lower() in keys
        }
        if not given:
            continue
        if set(given) not in ({""}, {"_start", "_end"}):
            faults.append(
                Fault(
                    message="the temperature is given incompletely",
                    file=file,
                    place=f"key {name}",
                    expected=f"{name}, or both {name}_start and {name}_end",
                    found=", ".join(f"{name}{end}" for end in given),
                    hint=f"give `{name}`, or both `{name}_start` and `{name}_end`",
                )
            )
            continue
        ends = list(given.values())
        found[name] = (ends[0], ends[-1])
    raise_all(InputError, faults)
    return found


def temperatures_of(parts: Sequence[PositioningTest]) -> Temperatures:
    """Return the temperatures of one test from the headers of all its files.

    The start of a temperature is that of the first file that states it. The end is that of the last
    file that states it.
    """
    found: dict[str, tuple[float, float]] = {}
    for part in parts:
        file = part.sources[0].file if part.sources else part.name
        for name, (start, end) in stated_temperatures(part.header, file).items():
            found[name] = (found.get(name, (start, end))[0], end)
    return found


def _number(key: str, text: str, file: str, faults: list[Fault]) -> float:
    match = _NUMBER.fullmatch(text.strip())
    value = float(match[1].replace(",", ".")) if match else None
    low, high = PLAUSIBLE_TEMPERATURES
    if value is None or not low <= value <= high:
        faults.append(
            Fault(
                message=f"the value of the key `{key}` is not a plausible temperature of a test "
                "in °C",
                file=file,
                place=f"key {key}",
                expected=f"one number from {low:g} to {high:g}",
                found=text,
                hint="correct this value in the file, or remove the line",
            )
        )
        return 0.0
    return value


def with_temperatures(thermal: Thermal, stated: Temperatures) -> Thermal:
    """Return ``thermal`` with the mean of the temperatures stated at start and end of a test."""
    for name, (start, end) in stated.items():
        mean, rise = 0.5 * (start + end), end - start
        thermal = (
            replace(thermal, T_m=mean, rise_m=rise)
            if name == "T_m"
            else replace(thermal, T_d=mean, rise_d=rise)
        )
    return thermal
