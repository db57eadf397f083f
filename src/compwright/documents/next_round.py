"""The key ``next`` of ``verification.json``: the next round of ``verify --update``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True, kw_only=True)
class UpdatedAxis:
    """One axis of the plan in the next round. ``updated``: it is part of it; ``table``: it gets a
    table; ``reason``: why, as text.
    """

    reason: str
    updated: bool = False
    table: bool = False


def next_document(
    reason: str,
    axes: Mapping[str, UpdatedAxis],
    between: Sequence[str] = (),
    *,
    written: bool = False,
) -> dict[str, Any]:
    """Return the key ``next``. ``between``: sentences about corrections between axes; ``written``:
    whether the folder exists.
    """
    return {
        "written": written,
        "reason": reason,
        "axes": {
            name: {"updated": axis.updated, "table": axis.table, "reason": axis.reason}
            for name, axis in axes.items()
        },
        "between": list(between),
    }
