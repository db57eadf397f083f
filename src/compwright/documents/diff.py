"""The JSON document of ``diff``: the differences between two backups of one machine."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from compwright.documents.findings import finding_documents
from compwright.foundations.findings import Finding
from compwright.foundations.units import outside_factor, outside_unit
from compwright.records.axis import AxisKind, Direction

SCHEMA = "compwright/diff/1"
#: Entries of a group of others that are shown.
MOST_EXAMPLES = 5


@dataclass(frozen=True, slots=True)
class EntryDifference:
    """A value that differs between two backups, ``old`` and ``new`` as the control writes values.

    - ``quantity``: name of the value. ``group``: name under which similar differences are counted.
    - ``addresses``: the axes to which the value belongs.
    - ``old``, ``new``: None if the backup does not contain the value.
    - ``meaning``: what the value means. ``compensates``: it belongs to a compensation.
    - ``at``: position of a value of a table, mm or deg; else None.
    """

    quantity: str
    group: str
    addresses: tuple[str, ...]
    old: str | None
    new: str | None
    meaning: str
    compensates: bool
    at: float | None


@dataclass(frozen=True, slots=True)
class Changed:
    """The largest change of a correction (mm or deg), with its position and direction."""

    kind: AxisKind
    most: float
    at: float
    direction: Direction


def diff_document(
    format_id: str,
    names: Mapping[str, str],
    entries: Sequence[EntryDifference],
    corrections: Mapping[str, Changed],
    cross: Mapping[tuple[str, str], Changed],
    findings: Sequence[Finding],
    *,
    known: bool,
    unknown: Collection[str],
) -> dict[str, Any]:
    """Return the JSON document of a comparison of two backups. ``known``: the corrections of all
    axes could be compared; ``unknown``: the addresses of axes for which they could not.

    ``names``: names of the axes by address. ``entries``: differing values. ``corrections``,
    ``cross``: the largest change of each axis' correction, and of each correction between two axes.
    """
    compensating = [entry for entry in entries if entry.compensates]
    named = (address for entry in compensating for address in entry.addresses)
    shown = dict.fromkeys((*corrections, *named))
    return {
        "schema": SCHEMA,
        "format": format_id,
        "same": not (entries or corrections or cross),
        "corrections_compared": known,
        "axes": {
            address: {
                "name": names.get(address),
                "correction_compared": address not in unknown,
                "entries": [
                    _entry(one, address) for one in compensating if address in one.addresses
                ],
                "correction": (
                    change_document(corrections[address]) if address in corrections else None
                ),
            }
            for address in shown
        },
        "cross": [
            {"input": pair[0], "output": pair[1], **change_document(change)}
            for pair, change in cross.items()
        ],
        "machine": [_entry(one, None) for one in compensating if not one.addresses],
        "other": others_document(one for one in entries if not one.compensates),
        "findings": finding_documents(findings),
    }


def change_document(change: Changed) -> dict[str, Any]:
    """Return the largest change of a correction, new minus old, in µm or arcsec."""
    key = f"max_change_{outside_unit(change.kind.unit)}"
    return {
        key: change.most * outside_factor(change.kind.unit),
        "at": change.at,
        "direction": change.direction.value,
    }


def _entry(entry: EntryDifference, address: str | None) -> dict[str, Any]:
    return {
        "quantity": entry.quantity,
        "address": address,
        "old": entry.old,
        "new": entry.new,
        "meaning": entry.meaning or None,
        "at": entry.at,
    }


def others_document(entries: Iterable[EntryDifference]) -> list[dict[str, Any]]:
    """Return, for each parameter, how many of the differing values ``entries`` it has; parameters
    in both backups come first.
    """
    groups: dict[str, list[EntryDifference]] = {}
    for entry in entries:
        groups.setdefault(entry.group, []).append(entry)
    counted = [
        {
            "quantity": group,
            "meaning": found[0].meaning or None,
            "changed": sum(None not in (one.old, one.new) for one in found),
            "only_old": sum(one.new is None for one in found),
            "only_new": sum(one.old is None for one in found),
            "examples": [
                _entry(one, one.addresses[0] if one.addresses else None)
                for one in found[:MOST_EXAMPLES]
            ],
        }
        for group, found in groups.items()
    ]
    return sorted(counted, key=lambda group: not group["changed"])
