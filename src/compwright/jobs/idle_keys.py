"""Keys of a job that have no effect."""

from __future__ import annotations

from collections.abc import Iterable

from compwright.foundations.findings import Finding
from compwright.records.job import Acknowledgement, Job


def idle_keys(job: Job, *, systems: bool, numbers: bool, motions: bool) -> list[Finding]:
    """Return findings on the keys of axes in a job that have no effect on this control.

    ``systems``: the control's files distinguish measuring systems. ``numbers``: the control's files
    have an axis number that differs from the address. ``motions``: backlash at rapid traverse can
    have its own value. If one of them is False, the keys for it have no effect.
    """
    keys = []
    for name, entry in job.axes.items():
        encoder = entry.axis.encoder
        if not systems and encoder.stated and encoder.system != 1:
            keys.append(f"axes.{name}.encoder.system: {encoder.system}")
        if not numbers and entry.axis.axis_number is not None:
            keys.append(f"axes.{name}.axis_number: {entry.axis.axis_number}")
        keys += [
            f"axes.{name}.before, test {request.name}: motion: {request.motion}"
            for request in entry.before
            if not motions and request.motion != "feed"
        ]
    return [Finding.of("CW-J020", "warning", key=key, format=job.format) for key in keys]


def unused_acknowledgements(unused: Iterable[Acknowledgement]) -> list[Finding]:
    """Return a finding for each acknowledged doubt that was not found."""
    return [Finding.of("CW-J021", "warning", code=each.code, axis=each.axis) for each in unused]
