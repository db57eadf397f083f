"""Read LinuxCNC INI files by the rules of the control.

Only the first section of a name is searched, and the first matching key applies. A value reaches to
the end of its line, so a comment after it belongs to the value. A key without a value counts as
missing. A line that ends in a backslash continues in the next line. ``#INCLUDE name`` inserts
another file. Source: LinuxCNC 2.9 (``inifile.cc``, the start script).

The module also finds which joint is which axis, and the kinematics in which no joint is an axis.
Source: the control's kinematics modules and example configurations.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from compwright.foundations.errors import Fault
from compwright.records.correction import ControlFile

_BLANKS = " \t\r\n"
_JOINT = re.compile(r"\[JOINT_([0-9]{1,3})\]")


@dataclass(frozen=True, slots=True)
class IniLine:
    """One INI line, joined with its continuation lines, with its file and first line number."""

    text: str
    file: str
    number: int


@dataclass(frozen=True, slots=True)
class IniValue:
    """The value of an INI key: the text after its equals sign."""

    text: str
    line: IniLine

    def fault(self, message: str, *, expected: str = "", found: str = "") -> Fault:
        """Return a fault with the file and line of this entry."""
        return Fault(
            message=message,
            file=self.line.file,
            place=f"line {self.line.number}",
            expected=expected,
            found=found or repr(self.text),
            hint="correct this line in the INI, then give the new file",
        )


@dataclass(frozen=True, slots=True)
class IniFile:
    """One INI file in which include files are inserted."""

    name: str
    lines: tuple[IniLine, ...]
    faults: tuple[Fault, ...]

    def find(self, section: str, key: str) -> IniValue | None:
        """Return the value of a key as the control would find it in the file; None if the control
        would find no value.
        """
        inside = False
        for line in self.lines:
            text = line.text.lstrip(_BLANKS)
            if not text or text[0] in ";#":
                continue
            if not inside:
                inside = text.startswith(f"[{section}]")
            elif text[0] == "[":
                return None
            elif text.startswith(key) and text[len(key) : len(key) + 1] in {" ", "\t", "="}:
                value = text.partition("=")[2].strip(_BLANKS)
                return IniValue(value, line) if value else None
        return None

    def joints(self) -> tuple[int, ...]:
        """Return the numbers of the joints with a section, in order of appearance."""
        found = [
            match.group(1)
            for line in self.lines
            if (match := _JOINT.match(line.text.lstrip(_BLANKS)))
        ]
        return tuple(dict.fromkeys(int(number) for number in found))

    def repeated(self) -> tuple[str, ...]:
        """Return notes on repeated joint sections, of which the control reads only the first."""
        seen: set[str] = set()
        remarks = []
        for line in self.lines:
            match = _JOINT.match(line.text.lstrip(_BLANKS))
            if match and match.group(1) in seen:
                remarks.append(
                    f"{line.file}: line {line.number}: second section {match.group(0)}: the control"
                    " reads only the first"
                )
            elif match:
                seen.add(match.group(1))
        return tuple(remarks)


def _looks_like_ini(file: ControlFile) -> bool:
    """Return whether a file is an INI file, by its name or because it has a joint section."""
    return (
        file.name.lower().endswith(".ini")
        or re.search(rb"^[ \t]*\[JOINT_[0-9]+\]", file.content, re.MULTILINE) is not None
    )


def read_inis(files: Sequence[ControlFile]) -> tuple[tuple[IniFile, ...], frozenset[str]]:
    """Return the INI files with their include files inserted, and the names of all files used."""
    by_name = {file.name: file for file in files}
    included: set[str] = set()
    read = [_expanded(file, by_name, included) for file in files if _looks_like_ini(file)]
    used = included | {ini.name for ini in read}
    # files that include each other leave no root: then all of them count
    return tuple(ini for ini in read if ini.name not in included) or tuple(read), frozenset(used)


def bare_name(path: str) -> str:
    """Return the last part of a path with slashes or backslashes."""
    return re.split(r"[/\\]", path.strip())[-1]


def _expanded(file: ControlFile, files: Mapping[str, ControlFile], included: set[str]) -> IniFile:
    lines: list[IniLine] = []
    faults: list[Fault] = []
    for line in _lines(file, faults):
        # the start script includes one level deep and only where the mark is the line's first word
        mark, _, name = line.text.strip().partition(" ")
        if mark != "#INCLUDE":
            lines.append(line)
            continue
        wanted = bare_name(name)
        if wanted in files:
            included.add(wanted)
            lines += _lines(files[wanted], faults)
        else:
            faults.append(
                Fault(
                    message="the file that this line includes was not given",
                    file=line.file,
                    place=f"line {line.number}",
                    expected=wanted or "a file name",
                    hint="give the included file with the control's other files",
                )
            )
    return IniFile(file.name, tuple(lines), tuple(faults))


def _lines(file: ControlFile, faults: list[Fault]) -> list[IniLine]:
    """Return the lines of one file, each joined with its continuation lines."""
    found: list[IniLine] = []
    text = file.content.decode("utf-8", "replace")
    carried, started = "", 0
    for number, raw in enumerate(text.split("\n"), start=1):
        line = raw.removesuffix("\r")
        if "\r" in line or "\x00" in line:
            faults.append(
                Fault(
                    message="this line contains a carriage return or a NUL byte, so the "
                    "control would not start",
                    file=file.name,
                    place=f"line {number}",
                    hint="save the INI again with a plain text editor",
                )
            )
            return found
        started = started or number
        if len(line) > 1 and line.endswith("\\"):
            carried += line[:-1]
            continue
        found.append(IniLine(carried + line, file.name, started))
        carried, started = "", 0
    if carried:
        found.append(IniLine(carried, file.name, started))
    return found


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
    """Return the joint number of an address. An axis letter means its place in XYZABCUVW (X is
    joint 0).
    """
    letter = address.strip().upper()
    return (
        str(_LETTERS.index(letter)) if len(letter) == 1 and letter in _LETTERS else address.strip()
    )


def letters_of_joints(ini: IniFile) -> str:
    """Return the axis letters in the order of the joints as one word; ``XYYZ``: joints 1 and 2 both
    move Y.

    The letters are ``coordinates=`` of the kinematics, if stated. For kinematics other than
    trivkins they are [TRAJ] COORDINATES, if each axis has one joint. Else they are all possible
    letters in order.
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
