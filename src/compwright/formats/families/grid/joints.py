"""Axes that the control drives by joints, as its own files name them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from compwright.foundations.errors import Fault
from compwright.records.axis import Axis
from compwright.records.facts import AxisFacts

#: Letters of axes: an axis of the job that bears another name says nothing of the control's own
#: letters.
_LETTERS = "XYZABCUVW"


#: The kinematics whose joints are the letters above, whatever other lines say.
_TRIVIAL = "trivkins"


def joint_letters(kinematics: str, order: str, count: str) -> str:
    """Return the letter of each joint; nothing where the files leave that to the letters' places.

    ``kinematics``: its name with what it is given (``coordinates=XYYZ`` counts before all else);
    ``order``: the machine's axes, of a kinematics with letters of its own (XYZBC), where there are
    as many as joints, ``count``.
    """
    given = re.search(r"coordinates=([A-Za-z]+)", kinematics)
    if given is not None:
        return given[1].upper()
    letters = "".join(order.split()).upper()
    name = kinematics.split(maxsplit=1)[0].lower() if kinematics.strip() else _TRIVIAL
    return letters if name != _TRIVIAL and count.strip() == str(len(letters)) else ""


def other_joints(axis: Axis, facts: AxisFacts, state: str) -> Iterator[Fault]:
    """Yield where the files of a state name the joint of an axis by another letter, or drive the
    axis by a second joint.
    """
    letters, letter = facts.letters, facts.name
    if not letters:
        return
    place, said = f"axes.{axis.name}", f"{letters}: joint {axis.address} is {letter}"
    if len(axis.name) == 1 and axis.name.upper() in _LETTERS and axis.name.upper() != letter:
        yield Fault(
            message=f"the files of the state {state} call this joint by another letter",
            place=f"{place}.address",
            expected=f"a joint of {axis.name}",
            found=said,
        )
        return
    others = [
        str(index)
        for index, other in enumerate(letters)
        if other == letter and str(index) != axis.address
    ]
    if others and axis.gantry not in others:
        yield Fault(
            message="a second joint drives this axis: a table on one of them alone racks it",
            place=f"{place}.gantry",
            expected=" or ".join(f'gantry: "{other}"' for other in others),
            found=said,
        )
