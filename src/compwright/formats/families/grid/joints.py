"""Axes that the control drives by joints, as named in its own files."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    CouplingStatement,
    statements_in,
    whole_number,
)
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
    """Yield the joints that a negative HOME_SEQUENCE homes together, if no line of the kinematics
    states their axes: they may belong to one axis.
    """
    if any(True for _ in statements_in(files, _LETTERED, _REMARK)):
        return
    section, joints = "", dict[int, list[tuple[int, CouplingStatement]]]()
    for found in statements_in(files, _HOMING, _REMARK):
        if found.match["section"]:
            section = found.match["section"].upper()
        elif section.startswith("JOINT_") and section[6:].isdigit():
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
    """Return the axis letter of each joint; empty if the default order of letters holds.

    ``kinematics``: its name with its arguments (``coordinates=XYYZ`` has priority); ``order``: the
    machine's axes, used for kinematics with letters of its own (XYZBC) if there are as many as
    joints, ``count``.
    """
    given = re.search(r"coordinates=\"?([A-Za-z]+(?:[ \t]+[A-Za-z]+(?![\w=]))*)", kinematics)
    if given is not None:
        return "".join(given[1].split()).upper()
    letters = "".join(order.split()).upper()
    name = kinematics.split(maxsplit=1)[0].lower() if kinematics.strip() else _TRIVIAL
    return letters if name != _TRIVIAL and count.strip() == str(len(letters)) else ""


def sure_joints(kinematics: str, order: str, count: str) -> str:
    """Return the letter of each joint as `joint_letters`, and those of kinematics without letters
    of its own if all other lines agree with them; empty if that is uncertain.
    """
    letters = joint_letters(kinematics, order, count)
    name = kinematics.split(maxsplit=1)[0].lower() if kinematics.strip() else ""
    if letters or name != _TRIVIAL:
        return letters
    row = _LETTERS[: int(count)] if count.strip().isdigit() else _LETTERS
    return row if set("".join(order.split()).upper()) <= set(row) else ""
