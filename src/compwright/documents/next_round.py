"""The key ``next`` of ``verification.json``, about the next round that ``verify --update`` made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True, kw_only=True)
class UpdatedAxis:
    """Whether an axis is part of the next round and gets a table, and the ``reason`` as text."""

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
    """Return the value of the key ``next``: whether the next round was ``written``, the ``reason``
    as text, and its axes. ``between``: sentences on corrections between axes.
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
