"""Motors of a PMAC that move together: two motors on one axis of a coordinate system (`#1->1000X`,
`#2->1000X`), motors that a kinematics program places (`#1->I`), and position following (Ixx06, of
the register that Ixx05 points to).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    CouplingStatement,
    statements_in,
)
from compwright.formats.families.wrapped.preprocessor import expanded, whole_value
from compwright.records.correction import ControlFile

_ASSIGNED = re.compile(
    r"&[ \t]*(?P<system>[0-9]+)|#[ \t]*(?P<motor>[0-9]{1,2})[ \t]*->[ \t]*"
    r"(?P<axis>I(?![0-9A-Z])|0(?![0-9.])|(?:[-+.0-9 \t]*[ABCUVWXYZ](?![A-Z0-9]))+)?"
    r"(?P<rest>[^\s;]*)",
    re.IGNORECASE,
)
_SETTING = re.compile(
    r"(?<![A-Z0-9])I(?P<motor>[0-9]{1,2})(?P<which>0[345678])[ \t]*=[ \t]*"
    r"(?P<value>[^\s;]+)",
    re.IGNORECASE,
)
_MACRO = re.compile(
    r"^[ \t]*#[ \t]*DEFINE[ \t]+([A-Z_]\w*)[ \t]+([^\r\n;]*?)[ \t]*(?=;|//|$)",
    re.MULTILINE | re.IGNORECASE,
)
_DEFINED = re.compile(r"#[ \t]*([0-9]{1,2})[ \t]*DEFINE", re.IGNORECASE)
_REMARK = re.compile(r"(?:;|//)[^\r\n]*")
_TERM = re.compile(r"([-+]?[.0-9]*)([ABCUVWXYZ])", re.IGNORECASE)
_RATIO = "it moves in a ratio with another motor"
#: Registers of a motor, from its number times this on (D:$8B is the actual position of motor 1,
#: D:$10B that of motor 2: suggested M-variables of public projects).
_BLOCK, _MOTORS = 0x80, 32
#: Ixx07 and Ixx08 where no file states them.
_SCALE = 96


def couplings_of(files: Sequence[ControlFile]) -> tuple[Coupling, ...]:
    """Return which motors move together; the last statement about a motor counts."""
    plain = _without_macros(files)
    assigned = statements_in(plain, _ASSIGNED, _REMARK)
    motors = {int(found.match["motor"]) for found in assigned if found.match["motor"]}
    texts = (file.content.decode("latin-1") for file in files)
    tabled = {int(motor) for text in texts for motor in _DEFINED.findall(text)}
    return (*_assigned(plain), *_following(plain, motors | tabled))


def axis_scales(files: Sequence[ControlFile]) -> Mapping[int, tuple[float, CouplingStatement]]:
    """Return the counts per unit of its axis for each motor on one axis alone, with the statement
    (`#1->10000X`).

    Without a number the axis counts in the motor's own counts; its unit is then no length.
    """
    found = {}
    for motor, (_, statement) in _definitions(_without_macros(files)).items():
        terms = _terms(statement)
        if len(terms) == 1 and abs(_factor(terms[0][0])) != 1.0:
            found[motor] = _factor(terms[0][0]), statement
    return found


def _without_macros(files: Sequence[ControlFile]) -> list[ControlFile]:
    texts = [(file.name, file.content.decode("latin-1")) for file in files]
    macros = {found[1]: found[2].strip() for _, text in texts for found in _MACRO.finditer(text)}
    return [
        ControlFile(name, expanded(_MACRO.sub("", text), macros).encode("latin-1"))
        for name, text in texts
    ]


def _definitions(files: Sequence[ControlFile]) -> dict[int, tuple[str, CouplingStatement]]:
    """Return the coordinate system and the last definition of each motor's axis."""
    system, last = "1", dict[int, tuple[str, CouplingStatement]]()
    for found in statements_in(files, _ASSIGNED, _REMARK):
        if found.match["system"]:
            system = found.match["system"]
        else:
            last[int(found.match["motor"])] = system, found
    return last


def _terms(found: CouplingStatement) -> list[tuple[str, str]]:
    """Return factor and axis of each term of a definition."""
    return _TERM.findall("".join((found.match["axis"] or "").split()).upper())


def _factor(text: str) -> float:
    return float(text + "1" if text in ("", "+", "-") else text)


def _assigned(files: Sequence[ControlFile]) -> Iterator[Coupling]:
    """Yield the motors of one axis, the lowest leads; and those that a program places."""
    axes: dict[tuple[str, str], tuple[int, float]] = {}
    for motor, (own, found) in sorted(_definitions(files).items()):
        text = "".join((found.match["axis"] or "").split()).upper()
        terms = _terms(found)
        if not text and found.match["rest"]:
            yield found.coupling((), str(motor), unlike=UNREAD)
        elif text == "I":
            unlike = "a kinematics program places it, and an axis moves several motors"
            yield found.coupling((), str(motor), unlike=unlike)
        elif len(terms) > 1:
            unlike = f"it is placed by {len(terms)} axes at once"
            yield found.coupling((), str(motor), unlike=unlike)
        elif terms:
            factor = _factor(terms[0][0])
            leads, own_factor = axes.setdefault((own, terms[0][1]), (motor, factor))
            if leads != motor:
                unlike = "" if factor == own_factor else _RATIO
                yield found.coupling((str(leads),), str(motor), unlike=unlike)


def _following(files: Sequence[ControlFile], motors: Iterable[int]) -> Iterator[Coupling]:
    """Yield the motors whose position following is on or unknown; ``motors``: those of the files.

    If no file explains the register, each of them may lead.
    """
    statements: dict[tuple[int, str], CouplingStatement] = {}
    for found in statements_in(files, _SETTING, _REMARK):
        statements[int(found.match["motor"]), found.match["which"]] = found
    for (motor, which), found in sorted(statements.items()):
        mode = _number(found)
        if which != "06" or (mode is not None and mode % 2 == 0):
            continue
        source = statements.get((motor, "05"))
        leads = _sources(statements, motor, None if source is None else _number(source))
        others = {*motors, *(one for one, _ in statements)} - {motor}
        scale, own_scale = (
            _SCALE if one is None else _number(one)
            for one in (statements.get((motor, "07")), statements.get((motor, "08")))
        )
        unlike = _RATIO if leads and (scale is None or scale != own_scale) else ""
        names = tuple(str(one) for one in leads or sorted(others))
        coupling = found.coupling(names, str(motor), switched=True, unlike=unlike)
        words = f"{found.words}, {source.words}" if source is not None else found.words
        yield replace(coupling, parameter=words)


def _sources(
    statements: Mapping[tuple[int, str], CouplingStatement], motor: int, register: int | None
) -> list[int]:
    """Return the motors that a register belongs to: by their feedback (Ixx03, Ixx04), or because it
    is one of their own (motor n has $80 of them from n times $80 on).
    """
    if register is None:
        return []
    fed = {
        other
        for (other, which), place in statements.items()
        if which in ("03", "04") and other != motor and _number(place) == register
    }
    own = register // _BLOCK
    return sorted(fed) or ([own] if 1 <= own <= _MOTORS and own != motor else [])


def _number(found: CouplingStatement) -> int | None:
    """Return the number of a setting; None if only the card knows it."""
    return whole_value(found.match["value"], {})
