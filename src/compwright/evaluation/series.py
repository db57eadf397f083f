"""What changed in a series of tests of one axis or one plane, beyond the uncertainty."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from compwright.evaluation.changed import (
    UNDECLARED_SLOPE,
    Change,
    Told,
    difference,
    scatter_changed,
)
from compwright.records.history import HistoryEntry, NotedChange, SameTable

#: What is judged. The others follow from these (E, R), or hang on single readings (G).
JUDGED = ("A", "B", "B_mean", "s", "squareness")
#: They hang on where was measured: judged only between tests at the same targets, to one standard.
_OF_TARGETS = frozenset({"A", "B"})
#: Targets are the same within this share of the measured length.
_SAME_TARGET = 1e-3
#: Share of each measured length that has to be common to both.
_COMMON = 0.8


def noted_changes(entries: Sequence[HistoryEntry]) -> list[NotedChange]:
    """Return what differs between tests of one axis or plane, each held against the last one before
    it that can be compared; ``entries`` in their order in time.
    """
    found = []
    for place, entry in enumerate(entries):
        for parameter in JUDGED:
            earlier = _last_comparable(entries, place, parameter)
            if earlier is None:
                continue
            change, undeclared = _compared(entries[earlier], entry, parameter)
            if change.clear:
                found.append(
                    NotedChange(
                        parameter=parameter,
                        before=earlier,
                        after=place,
                        value_before=entries[earlier].values[parameter],
                        value_after=entry.values[parameter],
                        size=change.size,
                        std_error=change.std_error,
                        score=change.score,
                        chance=change.chance,
                        table=same_table(entries[earlier], entry),
                        undeclared=undeclared,
                    )
                )
    return found


def _last_comparable(entries: Sequence[HistoryEntry], of: int, parameter: str) -> int | None:
    for place in reversed(range(of)):
        if _comparable(entries[place], entries[of], parameter):
            return place
    return None


def _comparable(one: HistoryEntry, other: HistoryEntry, parameter: str) -> bool:
    if not all(parameter in each.values and parameter in each.errors for each in (one, other)):
        return False
    if one.unit != other.unit:
        return False
    if parameter == "squareness":
        return True
    if parameter in _OF_TARGETS:
        return one.standard == other.standard and _same_targets(one.targets, other.targets)
    return _common_length(one.targets, other.targets)


def _same_targets(one: Sequence[float], other: Sequence[float]) -> bool:
    if len(one) != len(other) or not one:
        return False
    allowed = _SAME_TARGET * (max(one) - min(one))
    return bool(np.all(np.abs(np.sort(one) - np.sort(other)) <= allowed))


def _common_length(one: Sequence[float], other: Sequence[float]) -> bool:
    if not one or not other:
        return False
    common = min(max(one), max(other)) - max(min(one), min(other))
    return all(common >= _COMMON * (max(each) - min(each)) for each in (one, other))


def _compared(one: HistoryEntry, other: HistoryEntry, parameter: str) -> tuple[Change, bool]:
    """Return the difference, and whether a slope was allowed for because nobody declares one."""
    before, after = _told(one, parameter), _told(other, parameter)
    if parameter == "s":
        return scatter_changed(before, after), False
    undeclared = (
        parameter == "A"
        and not other.rotary
        and not (one.declared.get("A") and other.declared.get("A"))
    )
    length = max(other.targets) - min(other.targets) if undeclared else 0.0
    return difference(before, after, UNDECLARED_SLOPE * length / 1000.0), undeclared


def _told(entry: HistoryEntry, parameter: str) -> Told:
    error, dof = entry.errors[parameter]
    U, coverage = entry.declared.get(parameter, (0.0, 1.0))
    return Told(entry.values[parameter], error, dof, U / coverage)


def same_table(one: HistoryEntry, other: HistoryEntry) -> SameTable:
    """Return whether the same table acted in two tests, as far as their files tell."""
    if not one.acting or not other.acting:
        return "unknown"
    if one.acting == other.acting:
        return "same"
    if one.folder == other.folder or "none" in (one.acting, other.acting):
        return "changed"
    return "unknown"  # a backup saved later is another file with the same table


def without_repeats(entries: Sequence[HistoryEntry]) -> Iterator[HistoryEntry]:
    """Yield the tests of one axis or plane each once: a test that a later job uses again is the
    same. One that says how its table acted counts before one that does not.
    """
    kept: dict[tuple[str, ...], HistoryEntry] = {}
    for entry in entries:
        key = tuple(sorted(entry.sources)) or (entry.folder, str(entry.number))
        known = kept.get(key)
        if known is None or (known.taken == "before" and entry.taken == "after"):
            kept[key] = entry
    yield from kept.values()
