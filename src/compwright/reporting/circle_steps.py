"""What to do about a cause that a circular test shows, in words: who acts, what to check first.

Common practice of the workshop, in the order in which it costs least; no standard prescribes it.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any, Final

from compwright.reporting.causes import CircleCause

#: How many causes get a next step, the largest first.
_MOST: Final = 3

#: Cause (contract name without its axis) -> sentence; {axis} is the axis, {first} and {second} are
#: those of the plane.
_STEPS: Final[Mapping[str, str]] = {
    "squareness": (
        "Mechanic: check level and alignment of the guideways. Table: a job with"
        " `apply` corrects it where the control can."
    ),
    "scale_mismatch": (
        "Check the temperature of both axes. Table: measure {first} and {second} with a laser and"
        " run a job with both tests."
    ),
    "servo_mismatch": (
        "Servo: give {first} and {second} the same position loop gain (Kv) and feedforward."
    ),
    "radius_change": (
        "Measurement: repeat both directions with the same feed; check the seat of the bar."
    ),
    "backlash": (
        "Mechanic: check nut, support bearing and coupling of the {axis} screw. Then correct the"
        " control's backlash compensation of {axis}."
    ),
    "lateral_play": "Mechanic: check preload and gibs of the {axis} guideway.",
    "reversal_spike": (
        "Servo: adjust the friction compensation of {axis} at reversal. Mechanic: check its"
        " lubrication and wipers."
    ),
    "cyclic": (
        "Mechanic: check screw, its bearing and the encoder mount of {axis}. Table: at least three"
        " points in each period correct what is left."
    ),
    "straightness": (
        "Mechanic: check the alignment of the {axis} guideway. Table: a table between the axes"
        " corrects it where the control has one (cross)."
    ),
    "offset_change": "Measurement: check the centre mount and the magnet cups; then repeat.",
    "spiral": "Measurement: let machine and bar reach a stable temperature; then repeat.",
    "vibration": (
        "Look for the source by its frequency: pump, fan, motor. Servo: lower the gain for a trial."
    ),
    "stick_slip": "Mechanic: check lubrication, wipers and preload of the {axis} guideway.",
    "master_slave": "Servo: check the interpolation parameters of {first} and {second}.",
}


#: A name of a file that YAML reads as it is.
_WORD: Final = re.compile(r"[A-Za-z_][\w./-]*")


def steps_for(causes: Sequence[CircleCause], axes: Sequence[str]) -> list[str]:
    """Return what to do about the largest significant causes, a sentence each."""
    acting = [cause for cause in causes if cause.significant and cause.shown]
    return [
        f"{cause.words} ({100.0 * cause.share:.0f} % of all effects). {step}"
        for cause in acting[:_MOST]
        if (step := next_step(cause.name, axes))
    ]


def next_step(cause: str, axes: Sequence[str]) -> str:
    """Return what to do about a cause of a test in the plane of ``axes``; empty for one that is not
    known.
    """
    first, second = axes
    for ending, axis in (("_first", first), ("_second", second), ("", "")):
        words = _STEPS.get(cause.removesuffix(ending)) if cause.endswith(ending) else None
        if words is not None:
            return words.format(axis=axis, first=first, second=second)
    return ""


def job_lines(causes: Sequence[str], result: Mapping[str, Any]) -> list[str]:
    """Return the lines of a job that corrects what a table can correct of the ``causes``; empty
    where none of them is for a table. Scale is that of the positioning tests, which the circle
    checks.
    """
    first, second = result.get("axes") or ("first", "second")
    applied = []
    if "squareness" in causes:
        applied.append(f"squareness: {{{first}{second}: {second}}}")
    if {"backlash_first", "backlash_second"} & set(causes):
        applied.append("backlash_from: circle")
    if not applied and "scale_mismatch" not in causes:
        return []
    files = [str(source.get("file")) for source in result.get("sources") or ()]
    # Which of several files holds which direction is not in the result.
    named = f"file: {_yaml(files[0])}" if len(files) == 1 else "ccw: FILE, cw: FILE"
    lines = [f"circles: [{{{named}}}]"]
    return [*lines, f"apply: {{{', '.join(applied)}}}"] if applied else lines


def _yaml(text: str) -> str:
    return text if _WORD.fullmatch(text) else json.dumps(text, ensure_ascii=False)
