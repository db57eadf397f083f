"""Homing of a joint, and steps of its correction that the control never applies."""

from __future__ import annotations

from typing import Literal

from compwright.formats.families.grid.axis_values import GridAxisValues
from compwright.records.axis import Direction

_TRUE = {"1", "YES", "TRUE"}
_NANOSECOND = 1e-9
#: What the control takes where the files do not say it: SERVO_PERIOD in ns, and the limits of a
#: joint (emcglb.c).
_SERVO_PERIOD, _MAX_VELOCITY, _MAX_ACCELERATION = 1e6, 1.0, 1.0
#: Of the limits of a joint, the part by which its correction is ramped (control.c).
_RAMP = 0.5

Homing = Literal["", "relative", "absolute"]


def homing_of(
    values: GridAxisValues, factor: float
) -> tuple[Homing, tuple[float, Direction] | None]:
    """Return how homing changes the correction, and the place (mm or deg) and direction at which it
    counts as zero. ``factor``: mm or deg per unit of the files.

    A switch sets the motor offset to the commanded position less the correction that is applied
    there; an encoder's index that resets its counter, an absolute encoder, and homing in place
    before the first motion leave the correction unchanged (homing.c).
    """
    if "home_offset" not in values.definition.bindings:
        return "", None
    search, latch, offset = (
        0.0 if (found := values.single(name)) is None else float(found.text)
        for name in ("home_search_velocity", "home_latch_velocity", "home_offset")
    )
    index, kept = (_is_true(values, name) for name in ("home_index", "home_index_kept"))
    whole = values.single("servo_period") is not None or any(
        values.single(name) is not None
        for name in ("home_offset", "home_search_velocity", "home_latch_velocity")
    )
    if not whole:
        return "", None
    absolute = _is_true(values, "home_absolute", others=True)
    if absolute or not latch or not (search or index) or (index and not kept):
        return "absolute", None
    direction = Direction.POSITIVE if latch > 0.0 else Direction.NEGATIVE
    return "relative", (round(offset * factor, 9), direction)


def _is_true(values: GridAxisValues, name: str, *, others: bool = False) -> bool:
    """Return whether a switch is on; ``others``: any number other than 0 counts as on."""
    found = values.single(name)
    if found is None:
        return False
    word = found.text.upper()
    return word in _TRUE or (others and word.isdigit() and int(word) != 0)


def unapplied_steps(values: GridAxisValues, factor: float) -> tuple[float, float] | None:
    """Return the range of steps of the correction that the control never applies, mm or deg: above
    the first number, up to the second; None if the files do not state it.

    From rest the ramp takes a step up to ``least`` at once; it starts for a step above ``most``
    (control.c, ``compute_screw_comp``).
    """
    if "max_acceleration" not in values.definition.bindings or not any(
        values.single(name) is not None for name in ("servo_period", "max_acceleration")
    ):
        return None
    period, velocity, acceleration = (
        default if (found := values.single(name)) is None else float(found.text)
        for name, default in (
            ("servo_period", _SERVO_PERIOD),
            ("max_velocity", _MAX_VELOCITY),
            ("max_acceleration", _MAX_ACCELERATION),
        )
    )
    T, v, a = period * _NANOSECOND, _RAMP * velocity, _RAMP * acceleration
    if not (T > 0.0 and v > 0.0 and a > 0.0):
        return None
    speed = min(a * T, v)
    least, most = 0.5 * a * T**2, 0.5 * speed * T + 0.5 * speed**2 / a
    return (least * factor, most * factor) if least < most else None
