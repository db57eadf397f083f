"""LinuxCNC: settings in HAL files that correct an axis in addition to its table, or change a
joint's backlash while the control runs.

Commands of halcmd(1): ``setp PIN VALUE``, ``net SIGNAL PIN ..``, ``linkps``, ``linksp``,
``linkpp``. An INI contains such lines as ``HALCMD = ..``. Pins of motion(9):
``axis.L.eoffset-counts`` times ``axis.L.eoffset-scale`` is added to the position of axis L while
``axis.L.eoffset-enable`` is on. ``ini.N.backlash`` (milltask(1)) replaces BACKLASH while the
control runs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_LINKS = frozenset({"net", "linkps", "linksp", "linkpp"})
_OFF = frozenset({"0", "0.0", "false"})


def run_time_pins(
    files: Sequence[ControlFile], concerns: Callable[[str], bool], joint: Callable[[str], bool]
) -> Iterator[Fault]:
    """Yield a fault for each line that sets or links a pin which corrects an axis in addition to
    its table, or replaces a joint's BACKLASH. ``concerns``, ``joint``: whether an axis or a joint
    is part of the job.

    The argument of ``concerns`` is the axis letter in capitals. The argument of ``joint`` is the
    joint number as text.
    """
    for file in files:
        lines = file.content.decode("latin-1").replace("\r", "\n").split("\n")
        for number, line in enumerate(lines, start=1):
            for pin in _pins(line):
                owner, whose, key = (*pin.split("."), "", "")[:3]
                offset = owner == "axis" and key in ("eoffset-enable", "eoffset-counts")
                if offset and concerns(whose.upper()):
                    message = f"the HAL pin {pin} adds an external offset to the axis"
                elif owner == "ini" and key == "backlash" and joint(whose):
                    message = f"the HAL pin {pin} takes the place of BACKLASH"
                else:
                    continue
                yield Fault(
                    message=message,
                    file=file.name,
                    place=f"line {number}",
                    expected="a HAL file that leaves this pin alone",
                    found=line.strip(),
                    hint=(
                        "remove the line from the HAL file, measure again, then give the new file"
                    ),
                )


def _pins(line: str) -> list[str]:
    """Return the pins that a line sets or links."""
    words = line.partition("#")[0].replace("=", " = ").split()
    if words[:2] and words[0].upper() == "HALCMD" and words[1:2] == ["="]:
        words = words[2:]
    command, *rest = words or [""]
    if command.lower() == "setp":
        off = rest[0].lower().endswith("eoffset-enable") if rest else False
        return [] if off and rest[1:2] and rest[1].lower() in _OFF else rest[:1]
    return rest if command.lower() in _LINKS else []
