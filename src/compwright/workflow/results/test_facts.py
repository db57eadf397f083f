"""What the job states about its tests (such as travel and compensation), for the test sheet of a
report.

The statements have the keys of `reporting.report_items`.
"""

from __future__ import annotations

import base64
from collections.abc import Mapping
from typing import Any

from compwright.records.axis import Axis
from compwright.records.job import NONE_STATE, Job
from compwright.words.sentences import Sentence, say


def report_document(job: Job) -> dict[str, Any]:
    """Return the job's entries for the head of the report as plain data, the logo as base64."""
    head = job.report
    logo = None
    if head.image is not None:
        logo = {
            "type": head.image.type,
            "base64": base64.b64encode(head.image.content).decode("ascii"),
        }
    return {
        "number": head.number,
        "customer": head.customer,
        "operator": head.operator,
        "place": head.place,
        "logo": logo,
    }


def stated_of_axes(job: Job) -> dict[str, dict[str, Mapping[str, str | Sentence]]]:
    """Return what the job states about each positioning test, by axis name and test name."""
    return {
        name: {
            request.name: {
                **_of_job(job),
                "travel": _travel(entry.axis),
                "compensation": compensation_text(job, request.measured_in),
            }
            for request in entry.before
        }
        for name, entry in job.axes.items()
    }


def stated_of_circles(job: Job) -> dict[str, Mapping[str, str | Sentence]]:
    """Return what the job states about each circular test, by the name of the circle."""
    return {
        request.name: {
            **_of_job(job),
            "compensation": compensation_text(job, request.measured_in),
        }
        for request in job.circles
    }


def compensation_text(job: Job, state: str) -> str | Sentence:
    """Return the sentence that states which compensation the control has in a ``state``, or "" if
    the job does not list that state.
    """
    files = job.states.get(state)
    if files is None:
        return ""
    if files == NONE_STATE:
        return say("given.compensation_none", state=state)
    active = job.active.get(state)
    how = "off" if active is False else "active" if active else "stored"
    return say("given.compensation", how=how, files=list(files), state=state)


def _of_job(job: Job) -> dict[str, Sentence]:
    machine = job.machine
    named = [machine.get("name"), machine.get("serial")]
    stated = {
        "machine": ", ".join(text for text in named if text),
        "machine_type": machine.get("type") or "",
        "operator": job.report.operator or "",
        "place": job.report.place or "",
    }
    return {key: _by_job(text) for key, text in stated.items() if text}


def _travel(axis: Axis) -> Sentence:
    low, high = axis.travel
    return _by_job(say("given.travel", low=low, high=high, unit=axis.kind.unit))


def _by_job(text: str | Sentence) -> Sentence:
    return say("given.by_job", text=text)
