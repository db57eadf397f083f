"""Find the motors of a PMAC that move together, from its scripts.

The scripts can state three kinds of coupling:

- two motors on one axis of a coordinate system (`#1->1000X`, `#2->1000X`);
- motors whose position a kinematics program calculates (`#1->I`);
- position following (Ixx06), where Ixx05 contains the address of the followed register.
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
from compwright.formats.families.wrapped.preprocessor import DIRECTIVE, expanded, whole_value
from compwright.records.correction import ControlFile
from compwright.records.facts import AxisFacts

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
    """Return the motors that move together; of several statements on a motor the last counts."""
    plain = _without_macros(files)
    assigned = statements_in(plain, _ASSIGNED, _REMARK)
    motors = {int(found.match["motor"]) for found in assigned if found.match["motor"]}
    texts = (file.content.decode("latin-1") for file in files)
    tabled = {int(motor) for text in texts for motor in _DEFINED.findall(text)}
    return (*_assigned(plain), *_following(plain, motors | tabled))


def axis_scales(
    files: Sequence[ControlFile],
) -> Mapping[int, Sequence[tuple[float, CouplingStatement]]]:
    """Return the counts per axis unit of each motor that drives an axis alone (`#1->10000X`).

    A definition without such a number is left out: the axis unit is then one count of the motor,
    which is no length.
    """
    found: dict[int, list[tuple[float, CouplingStatement]]] = {}
    for motor, definitions in _definitions(_without_macros(files)).items():
        for _, statement in definitions:
            terms = _terms(statement)
            if len(terms) == 1 and abs(_factor(terms[0][0])) != 1.0:
                found.setdefault(motor, []).append((_factor(terms[0][0]), statement))
    return found


def axis_letters(files: Sequence[ControlFile]) -> Mapping[int, AxisFacts]:
    """Return the letter of the axis that each motor drives alone."""
    return {
        motor: AxisFacts(name=terms[0][1], name_evidence=statement.words)
        for motor, definitions in _definitions(_without_macros(files)).items()
        for _, statement in definitions
        if len(terms := _terms(statement)) == 1
    }


def _without_macros(files: Sequence[ControlFile]) -> list[ControlFile]:
    """Return the files with their macros expanded, except macros with several possible values."""
    texts = [(file.name, file.content.decode("latin-1")) for file in files]
    values: dict[str, set[str]] = {}
    for found in (found for _, text in texts for found in _MACRO.finditer(text)):
        values.setdefault(found[1], set()).add(found[2].strip())
    macros = {name: next(iter(some)) for name, some in values.items() if len(some) == 1}
    return [
        ControlFile(name, expanded(_MACRO.sub("", text), macros).encode("latin-1"))
        for name, text in texts
    ]


def _definitions(files: Sequence[ControlFile]) -> dict[int, list[tuple[str, CouplingStatement]]]:
    """Return by motor each axis definition that can be in effect, with its coordinate system."""
    system, last = "1", dict[int, list[tuple[str, CouplingStatement]]]()
    for found in statements_in(files, _ASSIGNED, _REMARK):
        if found.match["system"]:
            system = found.match["system"]
            continue
        if not _is_conditional(found):
            last.pop(int(found.match["motor"]), None)
        last.setdefault(int(found.match["motor"]), []).append((system, found))
    return last


def _is_conditional(found: CouplingStatement) -> bool:
    """Return whether a statement of a script is inside a conditional block."""
    before = found.match.string[: found.match.start()]
    names = [str(directive["name"]).upper() for directive in DIRECTIVE.finditer(before)]
    return sum(name.startswith("IF") for name in names) > names.count("ENDIF")


def _terms(found: CouplingStatement) -> list[tuple[str, str]]:
    """Return the factor and axis letter of each term in an axis definition such as 10000X+5Y."""
    return _TERM.findall("".join((found.match["axis"] or "").split()).upper())


def _factor(text: str) -> float:
    return float(text + "1" if text in ("", "+", "-") else text)


def _assigned(files: Sequence[ControlFile]) -> Iterator[Coupling]:
    """Yield the couplings of motors that drive the same axis; the motor with the lowest number
    leads.
    """
    axes: dict[tuple[str, str], tuple[int, float]] = {}
    definitions = sorted(_definitions(files).items())
    for motor, own, found in ((motor, *one) for motor, some in definitions for one in some):
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
    """Yield the motors that follow the position of another motor, and motors that possibly do so.

    If the files do not show whose position the register contains, every other motor may be the
    followed one.
    """
    statements: dict[tuple[int, str], list[CouplingStatement]] = {}
    for found in statements_in(files, _SETTING, _REMARK):
        key = int(found.match["motor"]), found.match["which"]
        if not _is_conditional(found):
            statements.pop(key, None)
        statements.setdefault(key, []).append(found)
    for motor in sorted({motor for motor, _ in statements}):
        modes = ((found, _number([found])) for found in statements.get((motor, "06"), ()))
        following = next((found for found, mode in modes if mode is None or mode % 2), None)
        if following is None:
            continue
        sources = statements.get((motor, "05"), [])
        leads = _sources(statements, motor, _number(sources))
        others = {*motors, *(one for one, _ in statements)} - {motor}
        scale, own_scale = (
            _number(some) if (some := statements.get((motor, which))) else _SCALE
            for which in ("07", "08")
        )
        unlike = _RATIO if leads and (scale is None or scale != own_scale) else ""
        names = tuple(str(one) for one in leads or sorted(others))
        coupling = following.coupling(names, str(motor), switched=True, unlike=unlike)
        words = ", ".join(one.words for one in (following, *sources))
        yield replace(coupling, parameter=words)


def _sources(
    statements: Mapping[tuple[int, str], Sequence[CouplingStatement]],
    motor: int,
    register: int | None,
) -> list[int]:
    """Return the motors whose position a ``register`` possibly contains.

    These are motors that use the register as feedback (Ixx03, Ixx04). If there are none, it is the
    motor in whose own block the register lies: motor n has $80 registers from n times $80 on.
    """
    if register is None:
        return []
    fed = {
        other
        for (other, which), places in statements.items()
        if which in ("03", "04") and other != motor
        if any(_number([place]) == register for place in places)
    }
    own = register // _BLOCK
    return sorted(fed) or ([own] if 1 <= own <= _MOTORS and own != motor else [])


def _number(some: Sequence[CouplingStatement]) -> int | None:
    """Return the number that a setting has in all statements; None if they differ or if unknown."""
    numbers = {whole_value(found.match["value"], {}) for found in some}
    return numbers.pop() if len(numbers) == 1 else None
