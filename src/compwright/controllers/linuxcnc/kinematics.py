"""LinuxCNC: which joint is which axis, and kinematics in which no joint is an axis.

Source: the control's own kinematics modules and example configurations.
"""

from __future__ import annotations

import re

from compwright.controllers.linuxcnc.ini import IniFile

_LETTERS = "XYZABCUVW"
#: Kinematics in which a motion of one axis moves several joints (LinuxCNC's own modules).
MIXING = frozenset(
    {
        *(
            "corexykins",
            "rotatekins",
            "scarakins",
            "scorbot-kins",
            "pumakins",
            "rosekins",
            "lineardeltakins",
        ),
        *("rotarydeltakins", "genhexkins", "genserkins", "genser", "pentakins", "tripodkins"),
    }
)


def joint_number(address: str) -> str:
    """Return the joint number of an address; an axis letter stands for its place among XYZABCUVW (X
    is joint 0).
    """
    letter = address.strip().upper()
    return (
        str(_LETTERS.index(letter)) if len(letter) == 1 and letter in _LETTERS else address.strip()
    )


def letters_of_joints(ini: IniFile) -> str:
    """Return the axis letter of each joint.

    Those given to the kinematics; for kinematics other than trivkins the machine's axes, if each
    has one joint; else all letters in order.
    """
    values = {
        key: "" if (value := ini.find(section, key)) is None else value.text
        for section, key in (("KINS", "KINEMATICS"), ("KINS", "JOINTS"), ("TRAJ", "COORDINATES"))
    }
    given = re.search("coordinates=([A-Za-z]+)", values["KINEMATICS"])
    if given is not None:
        return given.group(1).upper()
    axes = values["COORDINATES"].upper().replace(" ", "").replace("\t", "")
    return (
        axes
        if values["KINEMATICS"].lower().split()[:1] not in ([], ["trivkins"])
        and values["JOINTS"].strip() == str(len(axes))
        else _LETTERS
    )
