"""What the files of a test state in their headers, next to what the job states, and next to each
other.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.planning.circles import CircleWork
from compwright.planning.wanted import held_by
from compwright.records.axis import Axis
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest

_KEY: Final = "compensation"
_ON: Final = re.compile(r"(on|yes|active|ein|an|ja|oui|вкл\w*|да)\b", re.IGNORECASE)
_OFF: Final = re.compile(
    r"(off|no|none|not active|inactive|aus|nein|non|выкл\w*|нет)\b", re.IGNORECASE
)


def statement_findings(
    tests: Sequence[PlannedTest], axis: Axis, states: Mapping[str, ControlState]
) -> Iterator[Finding]:
    """Yield where the headers of an axis' files contradict the state of the control that the job
    gives, or each other. ``states``: by name, those of which somebody said what they are.
    """
    for planned in tests:
        yield from _differences(planned.test, axis)
        what = _contradiction(planned.test.header, planned.measured_in, (axis,), states)
        if what:
            message = f"Axis {axis.name}, test {planned.test.name}: {what}"
            yield Finding("CW-P162", "warning", message, axes=(axis.name,))


def with_statements(
    works: Iterable[CircleWork], axes: Mapping[str, Axis], states: Mapping[str, ControlState]
) -> tuple[CircleWork, ...]:
    """Return circular tests with a finding where their header contradicts the state of the job."""
    checked = []
    for work in works:
        test = work.result.test
        both = [axes[name] for name in test.axes if name in axes]
        what = _contradiction(test.header, work.planned.measured_in, both, states)
        if what:
            findings = (*work.result.findings, Finding("CW-P162", "warning", what))
            checked.append(replace(work, result=replace(work.result, findings=findings)))
        else:
            checked.append(work)
    return tuple(checked)


def _contradiction(
    header: Mapping[str, str],
    measured_in: str,
    axes: Sequence[Axis],
    states: Mapping[str, ControlState],
) -> str:
    """Return how a header contradicts the state in which its test was taken, as far as ``axes``
    show it, and what to do; empty where it does not.
    """
    stated, state = _stated(header), states.get(measured_in)
    if len(stated) > 1:
        what = "the files state compensation both on and off"
    elif not stated or state is None or not axes:
        return ""
    else:
        (on,) = stated
        active = any(_is_active(state, axis) for axis in axes)
        if on == active:
            return ""
        held = "holds an active table or backlash" if active else "holds nothing active"
        names = " and ".join(axis.name for axis in axes)
        what = (
            f"the file states compensation {'on' if on else 'off'}, but the state {measured_in} of"
            f" the job {held} for {names}"
        )
    return (
        f"{what}. The new total is wrong if the job is wrong. Check at the control what was active,"
        " then correct the key compensation of the file, or measured_in and states of the job."
    )


def _is_active(state: ControlState, axis: Axis) -> bool:
    held = held_by(state, axis)
    return bool(held.backlash or np.any(held.positive) or np.any(held.negative))


def _stated(header: Mapping[str, str]) -> set[bool]:
    """Return what the headers say of compensation: on, off, both, or nothing that is understood."""
    texts = [text for key, text in header.items() if key.strip().lower() == _KEY]
    lines = [line.strip() for text in texts for line in text.splitlines()]
    return {_OFF.match(line) is None for line in lines if _ON.match(line) or _OFF.match(line)}


def _differences(test: PositioningTest, axis: Axis) -> Iterator[Finding]:
    """Yield what the files of one test state differently."""
    if len(test.sources) < 2:
        return
    told = [
        f"{key}: {' / '.join(lines)}"
        for key, text in test.header.items()
        if len(lines := [line.strip() for line in text.splitlines() if line.strip()]) > 1
    ]
    if told:
        message = f"Axis {axis.name}, test {test.name}: its files differ in {'; '.join(told)}"
        yield Finding("CW-P163", "info", message, axes=(axis.name,))
