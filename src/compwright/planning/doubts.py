"""Doubts about measurements and the state of the control. A doubt makes every decision about an
axis undecided until the job acknowledges the doubt.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.foundations.findings import Finding
from compwright.records.job import Acknowledged, Acknowledgement
from compwright.records.prediction import AcceptDecision


@dataclass(frozen=True, slots=True)
class ScopedFinding:
    """A finding with the ``axes`` of the job that it concerns (None: all axes), and the name of its
    circular test in ``circle``.
    """

    finding: Finding
    axes: frozenset[str] | None = None
    circle: str | None = None

    def concerns(self, axis: str) -> bool:
        """Return whether the finding concerns the given axis."""
        return self.axes is None or axis in self.axes


@dataclass(frozen=True, slots=True)
class Doubts:
    """The doubts of a job: ``open``, ``acknowledged``, and acknowledgements that match no doubt
    (``unused``).
    """

    open: tuple[ScopedFinding, ...] = ()
    acknowledged: tuple[Acknowledged, ...] = ()
    unused: tuple[Acknowledgement, ...] = ()

    def about(self, axis: str) -> bool:
        """Return whether an axis has a doubt that the job does not acknowledge."""
        return any(one.concerns(axis) for one in self.open)

    def about_circle(self, name: str, axes: Iterable[str]) -> bool:
        """Return whether a circular test, or one of its axes, has a doubt that the job does not
        acknowledge.
        """
        return any(one.circle == name for one in self.open) or any(map(self.about, axes))


def find_doubts(
    noticed: Iterable[ScopedFinding], given: Sequence[Acknowledgement], axes_of_job: Iterable[str]
) -> Doubts:
    """Return the doubts among the findings ``noticed``, each once. ``given``: the acknowledgements
    of the job.

    If a doubt concerns several axes, an acknowledgement for one of them does not remove it. A doubt
    about all axes concerns all axes of the job.
    """
    every = frozenset(axes_of_job)
    still: list[ScopedFinding] = []
    done: list[Acknowledged] = []
    for one in dict.fromkeys(each for each in noticed if each.finding.is_doubt):
        axes = every if one.axes is None else one.axes
        by = {each.axis: each for each in reversed(given) if each.code == one.finding.code}
        covering = [by[None]] if None in by else [by[axis] for axis in sorted(axes & by.keys())]
        done.extend(Acknowledged(one.finding, each) for each in covering)
        left = axes - by.keys()
        if not covering:
            still.append(one)
        elif None not in by and left:
            still.append(replace(one, axes=left))
    used = {id(each.by) for each in done}
    unused = tuple(each for each in given if id(each) not in used)
    return Doubts(tuple(still), tuple(done), unused)


def mark_undecided(accept: Mapping[str, AcceptDecision]) -> dict[str, AcceptDecision]:
    """Return the decisions of an axis or circular test with an open doubt, all changed to
    undecided.
    """
    return {name: replace(entry, decision="undecided") for name, entry in accept.items()}
