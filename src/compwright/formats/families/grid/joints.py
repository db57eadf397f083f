"""Joints of a LinuxCNC machine: their axis letters, their homing, and the steps of the correction
that the control never applies.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Literal

from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    CouplingStatement,
    statements_in,
    whole_number,
)
from compwright.formats.families.grid.axis_values import GridAxisValues
from compwright.records.axis import Direction
from compwright.records.correction import ControlFile

#: Letters of axes: an axis of the job that bears another name says nothing of the control's own
#: letters.
_LETTERS = "XYZABCUVW"


#: The kinematics whose joints are the letters above, whatever other lines say.
_TRIVIAL = "trivkins"
_HOMING = re.compile(
    r"^[ \t]*\[[ \t]*(?P<section>\w+)[ \t]*\]|^[ \t]*HOME_SEQUENCE[ \t]*=[ \t]*(?P<value>[^\s#;]*)",
    re.MULTILINE | re.IGNORECASE,
)
_LETTERED = re.compile(r"^[ \t]*KINEMATICS[ \t]*=.*coordinates=", re.MULTILINE | re.IGNORECASE)
_REMARK = re.compile(r"^[ \t]*[#;][^\r\n]*", re.MULTILINE)


def joined_joints(files: Sequence[ControlFile]) -> Iterator[Coupling]:
    """Yield a possible coupling for joints that are homed together (negative HOME_SEQUENCE),
    because several joints that drive one axis are homed in this way.
    """
    if any(True for _ in statements_in(files, _LETTERED, _REMARK)):
        return
    section, joints = "", dict[int, list[tuple[int, CouplingStatement]]]()
    for found in statements_in(files, _HOMING, _REMARK):
        if found.match["section"]:
            section = found.match["section"].upper()
        elif section.startswith("JOINT_") and section[6:].isdecimal():
            sequence, joint = whole_number(found.match["value"]), int(section[6:])
            if sequence is None:
                yield found.coupling((), str(joint), switched=True, unlike=UNREAD)
            else:
                joints.setdefault(sequence, []).append((joint, found))
    for sequence, members in joints.items():
        leads, *others = sorted(members, key=lambda member: member[0])
        for joint, found in others if sequence < 0 else ():
            yield found.coupling((str(leads[0]),), str(joint), switched=True)


def joint_letters(kinematics: str, order: str, count: str) -> str:
    """Return the axis letter of each joint in one word, such as XYYZ; empty if LinuxCNC's default
    order applies. ``kinematics``, ``order``, ``count``: the machine's kinematics, axis letters and
    number of joints, as the files state them.

    An argument of the kinematics (``coordinates=XYYZ``) has priority. Without it, ``order`` is used
    if the kinematics has its own letters (such as XYZBC) and there are as many letters as joints.
    """
    given = re.search(r"coordinates=\"?([A-Za-z]+(?:[ \t]+[A-Za-z]+(?![\w=]))*)", kinematics)
    if given is not None:
        return "".join(given[1].split()).upper()
    letters = "".join(order.split()).upper()
    name = kinematics.split(maxsplit=1)[0].lower() if kinematics.strip() else _TRIVIAL
    return letters if name != _TRIVIAL and count.strip() == str(len(letters)) else ""


def sure_joints(kinematics: str, order: str, count: str) -> str:
    """Return the axis letter of each joint in one word, such as XYYZ, also where LinuxCNC's default
    order applies; empty if the letters are uncertain. Arguments as `joint_letters`.
    """
    letters = joint_letters(kinematics, order, count)
    name = kinematics.split(maxsplit=1)[0].lower() if kinematics.strip() else ""
    if letters or name != _TRIVIAL:
        return letters
    row = _LETTERS[: int(count)] if count.strip().isdecimal() else _LETTERS
    return row if set("".join(order.split()).upper()) <= set(row) else ""


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
    """Return whether homing shifts the correction ("relative"), and the position and direction at
    which a shifted correction is zero. ``values``: the settings of one joint; ``factor``: mm or deg
    per unit of the files.

    Homing to a switch shifts the correction: it sets the motor offset to the commanded position
    less the correction at this position. Three kinds of homing leave the correction unchanged
    ("absolute", homing.c):

    - homing to an encoder index that resets its counter;
    - homing with an absolute encoder;
    - homing in place before the first motion.

    If the files do not show the kind, the word is empty.
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
    """Return whether the yes-or-no setting ``name`` is true; False if no file states it.
    ``others``: numbers other than 0 and 1 also mean true.
    """
    found = values.single(name)
    if found is None:
        return False
    word = found.text.upper()
    return word in _TRUE or (others and word.isdecimal() and int(word) != 0)


def unapplied_steps(values: GridAxisValues, factor: float) -> tuple[float, float] | None:
    """Return the smallest and largest step (mm or deg) in a correction that the control leaves out,
    because it applies smaller and larger steps only; None if unknown. ``factor``: mm or deg per
    unit of the files.

    The control leaves out a step that is larger than the first number and at most the second. From
    rest, a step up to the first number is applied at once. A step above the second number starts a
    ramp (control.c, ``compute_screw_comp``).
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
