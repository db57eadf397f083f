"""Helpers for the plain data of a job whose types the schema has not checked yet."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import PureWindowsPath
from typing import Any

from compwright.foundations.key_faults import KeyFault, KeyPath, shown, suggestion, too_large
from compwright.records.job import AS_FOUND


def default_name(file: str) -> str:
    """Return the default name of a test: its file name without folder and extension."""
    return PureWindowsPath(file).stem or file


def mapping_of(value: Any) -> Mapping[str, Any]:
    """Return a value if it is a mapping, else an empty mapping."""
    return value if isinstance(value, dict) else {}


def list_of(value: Any) -> Sequence[Any]:
    """Return a value if it is a list, else an empty list."""
    return value if isinstance(value, list) else []


def number_of(value: Any) -> float | None:
    """Return a value if it is a number of plausible size, else None."""
    if isinstance(value, bool) or not isinstance(value, int | float) or too_large(value):
        return None
    return float(value)


def repeated_files(files: Sequence[Any], path: KeyPath) -> Iterator[KeyFault]:
    """Yield a fault for each file that a list names twice."""
    for index, file in enumerate(files):
        if isinstance(file, str) and file in files[:index]:
            yield KeyFault((*path, index), "is given twice", "each file once", shown(file))


def unknown_state(
    section: Mapping[str, Any], path: KeyPath, states: Sequence[str]
) -> Iterator[KeyFault]:
    """Yield a fault for a test that was measured in a state not listed in the job."""
    state = section.get("measured_in", AS_FOUND)
    if isinstance(state, str | int) and str(state) not in states:
        yield KeyFault(
            (*path, "measured_in"),
            "names no state of this job",
            suggestion(str(state), states),
            shown(state),
        )
