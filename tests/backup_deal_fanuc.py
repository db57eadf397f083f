"""Random jobs by family and seed, and how they are dealt."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

import backup_neighbour_functions_fanuc  # noqa: F401 - fills the list of families
import backup_oddities_fanuc  # noqa: F401 - fills the list of families
import backup_variations_fanuc  # noqa: F401 - fills the list of families
from backup_jobs_fanuc import FAMILIES, Job


def make(name: str, seed: int, whole: bool = False) -> Job:
    """The job of a family and a seed; the same every time."""
    rng = np.random.default_rng([seed, *name.encode()])
    return replace(FAMILIES[name](rng, whole), family=name, seed=seed)


#: How often a family comes in a draw: what a service engineer meets is mostly plain.
_SHARE = {
    "as_it_is": 4,
    "filled": 5,
    "backlash": 3,
    "detection_units": 3,
    "asleep": 2,
    "never_compensated": 2,
}
#: One round: every family at least once.
ROUND = sum(_SHARE.get(name, 1) for name in FAMILIES)


def deal(count: int, first: int = 0) -> list[tuple[str, int]]:
    """``count`` pairs of family and seed, each once: every family in turn, plain and odd ones
    evenly mixed.
    """
    order = _mixed(np.random.default_rng(2024))
    drawn = [order[n % len(order)] for n in range(first + count)]
    return [(name, drawn[:n].count(name)) for n, name in enumerate(drawn)][first:]


def _mixed(rng: np.random.Generator) -> list[str]:
    places: list[tuple[float, str]] = []
    for odd in (False, True):
        names = [
            name
            for name, make in FAMILIES.items()
            if (make.__module__ != "backup_variations_fanuc") == odd
        ]
        dealt = rng.permutation([name for name in names for _ in range(_SHARE.get(name, 1))])
        places += [((n + 0.5) / len(dealt), str(name)) for n, name in enumerate(dealt)]
    return [name for _, name in sorted(places)]
