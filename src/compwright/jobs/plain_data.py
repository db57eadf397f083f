"""Plain data of a job before the schema has checked the types, and their faults."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import PureWindowsPath
from typing import Any

from compwright.foundations.key_faults import KeyFault, KeyPath, shown, suggestion, too_large
from compwright.records.job import AS_FOUND


def default_name(file: str) -> str:
    """Return the default name of a test: the name of its file without folder and ending."""
    return PureWindowsPath(file).stem or file


def mapping_of(value: Any) -> Mapping[str, Any]:
    """Return a mapping; an empty one for anything else."""
    return value if isinstance(value, dict) else {}


def list_of(value: Any) -> Sequence[Any]:
    """Return a list; an empty one for anything else."""
    return value if isinstance(value, list) else []


def number_of(value: Any) -> float | None:
    """Return a number; None for anything else, and for one that is too large."""
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
    """Yield a fault for a test measured in a state that is not in the job."""
    state = section.get("measured_in", AS_FOUND)
    if isinstance(state, str | int) and str(state) not in states:
        yield KeyFault(
            (*path, "measured_in"),
            "names no state of this job",
            suggestion(str(state), states),
            shown(state),
        )
