"""The next step for each cause in a circular test: who has to do it (such as the mechanic), and
what to check first.

The steps are common practice in workshops, the cheapest first. No standard prescribes them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Container, Mapping, Sequence
from typing import Any, Final

from compwright.reporting.causes import LEAST_MENDED, CircleCause, whole_cause
from compwright.words.sentences import Sentence, say

#: So many of the largest causes get a next step, and all with this share of the effects or more.
_MOST: Final = 3
_LARGE: Final = 0.1

#: Cause (contract name without its axis) -> sentence; {axis} is the axis, {first} and {second} are
#: those of the plane.
#: Causes for which something can be done.
_STEPS: Final = frozenset(
    {
        "squareness", "scale_mismatch", "servo_mismatch", "radius_change", "backlash",
        "overcompensation", "lateral_play", "reversal_spike", "cyclic", "straightness",
        "offset_change", "spiral", "vibration", "stick_slip", "master_slave",
    }
)  # fmt: skip
_WORD: Final = re.compile(r"[A-Za-z_][\w./-]*")


def steps_for(causes: Sequence[CircleCause], axes: Sequence[str]) -> list[Sentence]:
    """Return the next steps for the most important significant causes, and a note that names causes
    too uncertain for a step.
    """
    shown = [cause for cause in causes if cause.large]
    significant = significant_causes(causes)
    last = shown.index(significant[-1]) if significant else _MOST
    open_causes = [
        say("circle.cause_share", cause=cause.words, share=100.0 * cause.share)
        for cause in shown[:last]
        if not cause.significant
    ]
    scales = [
        say(
            "cause.noted",
            cause=one.words,
            note=say("label.with_unit", value=one.value_text, unit=one.unit_text),
        )
        for one in scale_errors(causes)
    ]
    return [
        *(
            say("circle.to_do", cause=cause.words, share=100.0 * cause.share, step=step)
            for cause in significant
            if (step := next_step(whole_cause(_mended(cause)), axes, cause))
        ),
        *(
            [say("circle.scales", scales=scales, step=next_step("scale_mismatch", axes))]
            if scales
            else []
        ),
        *([say("circle.open_causes", causes=open_causes)] if open_causes else []),
    ]


def _mended(cause: CircleCause) -> str:
    """Return the name of the cause for which the next step is chosen: lateral play in place of a
    lost motion that has opposite signs at the two ends, and overcompensation in place of a negative
    one, which no mechanic can remove.
    """
    if not cause.known:
        return cause.name.replace("backlash", "lateral_play")
    return cause.name.replace("backlash", "overcompensation") if cause.value < 0.0 else cause.name


def significant_causes(causes: Sequence[CircleCause]) -> list[CircleCause]:
    """Return the few significant causes with the largest effects, and each further significant
    cause with a large share of all effects.
    """
    found = [cause for cause in causes if cause.large and cause.significant]
    return found[:_MOST] + [cause for cause in found[_MOST:] if cause.share >= _LARGE]


def scale_errors(causes: Sequence[CircleCause]) -> list[CircleCause]:
    """Return the significant scale errors of single axes if the step for their difference, the
    scale mismatch, is not proposed: two equal ones only change the mean radius.
    """
    done = significant_causes(causes)
    return [
        one
        for cause in causes
        if cause not in done
        for one in (cause, *cause.parts)
        if one.name.startswith("scale_error") and one.known and one.effect >= LEAST_MENDED
    ]


def next_step(name: str, axes: Sequence[str], found: CircleCause | None = None) -> Sentence | None:
    """Return the next step for the cause ``name`` of a circular test, or None for an unknown cause.

    ``found``: the cause, for the frequency and the axis of a vibration.
    """
    first, second = axes
    own = (found.axis if found else None) or ""
    for ending, axis in (("_first", first), ("_second", second), ("", own)):
        kind = name.removesuffix(ending)
        if name.endswith(ending) and kind in _STEPS:
            return say(
                "circle.step",
                kind=kind,
                axis=axis,
                first=first,
                second=second,
                frequency=found.frequency if found else None,
            )
    return None


def machine_job(machine: Mapping[str, Any], results: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return lines of a job that correct the causes on which the circular tests of one machine
    agree.
    """
    contradicted = {
        (one["cause"], circle["of"])
        for one in machine["contradictions"]
        for circle in one["circles"]
    }
    known = {
        cause: {
            of
            for of, each in found.items()
            if (cause, of) not in contradicted
            and each.get("correction", "correct") == "correct"
            and abs(each["value"]) > 2.0 * each["std_error"]
        }
        for cause, found in machine["causes"].items()
    }
    return _job(
        results, known["squareness"], lost=bool(known["backlash"]), scale=bool(known["scale_error"])
    )


def job_lines(causes: Sequence[str], result: Mapping[str, Any]) -> list[str]:
    """Return the lines of a job that correct the ``causes`` of one circular test."""
    planes = {"".join(sorted(result["axes"]))} if "squareness" in causes else set()
    lost = bool({"backlash_first", "backlash_second"} & set(causes))
    return _job(
        [result], planes, lost=lost, scale=any(cause.startswith("scale_") for cause in causes)
    )


def _job(
    results: Sequence[Mapping[str, Any]], planes: Container[str], *, lost: bool, scale: bool
) -> list[str]:
    """Return the lines of a job that correct from circular tests the squareness of ``planes``, the
    ``lost`` motion and the ``scale``; an empty list if none of these is wanted.

    The axes in the name of a plane are in alphabetical order. The scale comes from positioning
    tests, and the circles check it.
    """
    axes = {"".join(sorted(each)): each for each in (result["axes"] for result in results)}
    bent = [f"{one}{two}: {two}" for plane, (one, two) in axes.items() if plane in planes]
    applied = [f"squareness: {{{', '.join(bent)}}}"] if bent else []
    applied += ["backlash_from: circle"] if lost else []
    if not applied and not scale:
        return []
    lines = [f"circles: [{', '.join(_circle_entry(result) for result in results)}]"]
    return [*lines, f"apply: {{{', '.join(applied)}}}"] if applied else lines


def _circle_entry(result: Mapping[str, Any]) -> str:
    files = [str(source.get("file")) for source in result.get("sources") or ()]
    # Which of several files holds which direction is not in the result.
    given = f"file: {_yaml(files[0])}" if len(files) == 1 else "ccw: FILE, cw: FILE"
    return f"{{{given}, centre: [{', '.join(result['axes'])}]}}"


def _yaml(text: str) -> str:
    return text if _WORD.fullmatch(text) else json.dumps(text, ensure_ascii=False)
