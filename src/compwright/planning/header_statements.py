"""Comparison of statements in the headers of test files with the job and with each other."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Final, TypeVar

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.serial_numbers import other_serials, serials
from compwright.planning.circles import CircleWork
from compwright.planning.wanted_correction import axis_compensation
from compwright.records.axis import Axis
from compwright.records.circular import CircularResult
from compwright.records.correction import ControlState
from compwright.records.plan import PlannedTest
from compwright.records.positioning import PositioningTest
from compwright.records.result import PositioningResult
from compwright.words.sentences import Sentence, say

_Result = TypeVar("_Result", PositioningResult, CircularResult)

_KEY: Final = "compensation"
_ON: Final = re.compile(r"(on|yes|active|ein|an|ja|oui|вкл\w*|да)\b", re.IGNORECASE)
_OFF: Final = re.compile(
    r"(off|no|none|not active|inactive|aus|nein|non|выкл\w*|нет)\b", re.IGNORECASE
)


def statement_findings(
    tests: Sequence[PlannedTest], axis: Axis, states: Mapping[str, ControlState], serial: str
) -> Iterator[Finding]:
    """Yield a finding where the headers of an axis' files contradict each other, the job's state of
    the control, or the ``serial`` number of the machine in the job.

    ``states``: the states whose content is known, by name.
    """
    for planned in tests:
        yield from _differences(planned.test, axis)
        other = _other_machine(planned.test.header, serial)
        if other is not None:
            sentence = say("of_test", axis=axis.name, test=planned.test.name, finding=other)
            yield Finding("CW-P171", "warning", sentence, axes=(axis.name,))
        what = _contradiction(planned.test.header, planned.measured_in, (axis,), states)
        if what is not None:
            sentence = say("of_test", axis=axis.name, test=planned.test.name, finding=what)
            yield Finding("CW-P162", "warning", sentence, axes=(axis.name,))


def with_statements(
    works: Iterable[CircleWork],
    axes: Mapping[str, Axis],
    states: Mapping[str, ControlState],
    serial: str,
) -> tuple[CircleWork, ...]:
    """Return the circular tests, with a finding where a header contradicts the state of the control
    or the ``serial`` number of the machine in the job.
    """
    checked = []
    for work in works:
        test = work.result.test
        both = [axes[name] for name in test.axes if name in axes]
        what = _contradiction(test.header, work.planned.measured_in, both, states)
        other = _other_machine(test.header, serial)
        found = [
            Finding(code, "warning", sentence)
            for code, sentence in (("CW-P162", what), ("CW-P171", other))
            if sentence is not None
        ]
        findings = (*work.result.findings, *found)
        checked.append(replace(work, result=replace(work.result, findings=findings)))
    return tuple(checked)


def _other_machine(header: Mapping[str, str], serial: str) -> Sentence | None:
    """Return the sentence that a file is of another machine than that with the ``serial`` number of
    the job, else than the first file of the test; None if it is not.
    """
    known = (serials({"serial": serial}) or serials(header))[:1]
    others = other_serials(header, known)
    return say("CW-P171", found=others, known=known[0]) if others else None


def after_test_doubts(result: _Result, axes: Sequence[str]) -> _Result:
    """Return the ``result`` of a test after loading, with a doubt if the header of the measurement
    file states that compensation was off.

    ``axes``: the axes for which the plan loads a table. If there are none, no doubt is added.
    """
    stated = _stated(result.test.header)
    if not axes or False not in stated:
        return result
    doubt = Finding.of(
        "CW-P162.after", "warning", axes=tuple(axes), both=True in stated, names=axes
    )
    return replace(result, findings=(*result.findings, doubt))


def _contradiction(
    header: Mapping[str, str],
    measured_in: str,
    axes: Sequence[Axis],
    states: Mapping[str, ControlState],
) -> Sentence | None:
    """Return the sentence that a header contradicts itself or the state of its test, with the next
    step, or None without a contradiction.

    Compensation counts as active in the state if it is active for any of the ``axes``.
    """
    stated, state = _stated(header), states.get(measured_in)
    if len(stated) > 1:
        return say("CW-P162.both")
    if not stated or state is None or not axes:
        return None
    (on,) = stated
    active = any(_is_active(state, axis) for axis in axes)
    if on == active:
        return None
    names = [axis.name for axis in axes]
    return say("CW-P162.state", on=on, state=measured_in, active=active, names=names)


def _is_active(state: ControlState, axis: Axis) -> bool:
    held = axis_compensation(state, axis)
    return bool(held.backlash or np.any(held.positive) or np.any(held.negative))


def _stated(header: Mapping[str, str]) -> set[bool]:
    """Return the states of compensation that a header contains: True for on, False for off. The set
    is empty if the header does not mention compensation.
    """
    texts = [text for key, text in header.items() if key.strip().lower() == _KEY]
    lines = [line.strip() for text in texts for line in text.splitlines()]
    return {_OFF.match(line) is None for line in lines if _ON.match(line) or _OFF.match(line)}


def _differences(test: PositioningTest, axis: Axis) -> Iterator[Finding]:
    """Yield the header entries that differ between the files of one test."""
    if len(test.sources) < 2:
        return
    differing = [
        f"{key}: {' / '.join(lines)}"
        for key, text in test.header.items()
        if len(lines := [line.strip() for line in text.splitlines() if line.strip()]) > 1
    ]
    if differing:
        yield Finding.of(
            "CW-P163", "info", axes=(axis.name,), axis=axis.name, test=test.name, keys=differing
        )
