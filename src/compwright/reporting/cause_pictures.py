"""Small pictures of causes in a circular test. Each shows the path that the machine would draw if
it had only this cause.

The shapes are those of ISO 230-4:1996, annex B, in both directions (`estimation.circle_model` has
the formulas).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Final

from compwright.reporting.causes import CircleCause, whole_cause
from compwright.reporting.circle_steps import significant_causes

_SIZE: Final = 140  # of one picture, in units of the drawing: room for the longest name
_WORDS: Final = 26  # height of the words below it
_RADIUS, _AMPLITUDE, _STEP = 38.0, 11.0, 2
_IN_ROW: Final = 5
_SPIKE: Final = 0.12  # rad
#: Kind -> radial deviation from angle (rad), direction (+1 ccw) and travelled share of the run; of
#: the first axis where there are two.
_SHAPES: Final[dict[str, Callable[[float, float, float], float]]] = {
    "squareness": lambda t, _d, _s: -math.sin(2.0 * t),
    "scale_mismatch": lambda t, _d, _s: math.cos(2.0 * t),
    "servo_mismatch": lambda t, d, _s: d * math.sin(2.0 * t),
    "radius_change": lambda _t, d, _s: 0.5 * d,
    "backlash": lambda t, d, _s: d * math.copysign(math.cos(t), math.sin(t) * math.cos(t)),
    "lateral_play": lambda t, d, _s: -d * abs(math.sin(t)),
    "straightness": lambda t, _d, _s: 2.5 * math.cos(t) ** 2 * math.sin(t),
    "reversal_spike": lambda t, d, _s: 1.2 * math.exp(-_since(t, d) / _SPIKE),
    "cyclic": lambda t, _d, _s: math.cos(16.0 * math.cos(t)) * math.cos(t),
    "offset_change": lambda t, d, _s: 0.7 * d * math.cos(t),
    "spiral": lambda _t, _d, s: 1.6 * (s - 0.5),
    "master_slave": lambda t, _d, _s: math.copysign(0.5, math.cos(2.0 * t)),
    "vibration": lambda t, _d, _s: 0.5 * math.sin(36.0 * t),
    "stick_slip": lambda t, d, _s: (
        1.0 - (4.0 * _since(t, d) / math.pi * 5.0) % 1.0 if _since(t, d) < math.pi / 5.0 else 0.0
    ),
}
#: Seen from the second axis these change their sign: its plane is mirrored.
_MIRRORED: Final = frozenset({"lateral_play", "straightness"})


def _since(angle: float, direction: float) -> float:
    """Return the angle (rad) travelled since the first axis last reversed, at 0° or 180°."""
    return (direction * angle) % math.pi


def cause_pictures(causes: Sequence[CircleCause]) -> dict[str, Any] | None:
    """Return the pictures of the significant causes, each with the paths of a ccw and a cw run;
    None if no significant cause has a picture.
    """
    pictures: list[dict[str, Any]] = []
    for cause in significant_causes(causes):
        name = whole_cause(cause.name)
        kind, second = name.removesuffix("_first"), name.endswith("_second")
        kind = kind.removesuffix("_second")
        if kind not in _SHAPES:
            continue
        row, column = divmod(len(pictures), _IN_ROW)
        centre = (column + 0.5) * _SIZE, row * (_SIZE + _WORDS) + 0.5 * _SIZE
        ends = _ends(cause)
        pictures.append(
            {
                "x": centre[0],
                "y": centre[1],
                "below": centre[1] + 0.5 * _SIZE + 8.0,
                "words": cause.words,
                "ccw": _line(kind, ends, 1.0, centre, second=second),
                "cw": _line(kind, ends, -1.0, centre, second=second),
            }
        )
    if not pictures:
        return None
    rows, columns = -(-len(pictures) // _IN_ROW), min(len(pictures), _IN_ROW)
    return {
        "width": max(columns, _IN_ROW) * _SIZE,
        "height": rows * (_SIZE + _WORDS),
        "radius": _RADIUS,
        "pictures": pictures,
    }


def _ends(cause: CircleCause) -> tuple[float, float]:
    """Return the value of a cause at the positive and at the negative end of its axis, relative to
    the larger of both: -1 to 1. A cause without ends has its sign at both, and a cause that is
    known at one end is zero at the other.
    """
    found = {part.name: part.value for part in (cause, *cause.parts)}
    ends = [
        next((value for name, value in found.items() if name.endswith(ending)), 0.0)
        for ending in ("_at_positive", "_at_negative")
    ]
    largest = max(map(abs, ends))
    if not largest:
        return (math.copysign(1.0, cause.value),) * 2
    return ends[0] / largest, ends[1] / largest


def _at(kind: str, ends: tuple[float, float], angle: float, direction: float) -> float:
    """Return the value at an ``angle`` (rad) of the first axis of a cause with the values ``ends``:
    that of the last reversal for a spike, else in proportion to the position.
    """
    share = 0.5 + 0.5 * math.cos(angle)
    if kind == "reversal_spike":
        share = float((direction * angle) % (2.0 * math.pi) < math.pi)
    return share * ends[0] + (1.0 - share) * ends[1]


def _line(
    kind: str,
    ends: tuple[float, float],
    direction: float,
    centre: tuple[float, float],
    *,
    second: bool,
) -> str:
    """Return the path of one run as points of an SVG polyline, in the order of its motion.
    ``ends``: as from `_ends`; ``centre``: of the picture; ``second``: the cause is one of the
    second axis.
    """
    points = []
    for number in range(360 // _STEP + 1):
        # Half a step aside: at a reversal point itself a step has no side.
        angle = math.radians(direction * (number * _STEP + 0.5 * _STEP))
        # The second axis reverses 90° after the first.
        turned = angle - 0.5 * math.pi if second else angle
        away = _at(kind, ends, turned, direction)
        away *= _SHAPES[kind](turned, direction, number * _STEP / 360.0)
        away = -away if second and kind in _MIRRORED else away
        length = _RADIUS + _AMPLITUDE * away
        points.append(
            f"{centre[0] + length * math.cos(angle):.1f},{centre[1] - length * math.sin(angle):.1f}"
        )
    return " ".join(points)
