"""Find the axes of a SINUMERIK that move together, except gantries (MD37100).

The files can state three kinds of coupling:

- master and slave drives (MD37250, MD37252, MD37262);
- coupling in the machine coordinate system (MD63000);
- a transformation of coordinates that is active after reset (MD20140).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    CouplingStatement,
    statements_in,
    whole_number,
)
from compwright.records.correction import ControlFile

_OF_AXIS = re.compile(
    r"\$MA_(?P<key>MS_ASSIGN_MASTER_SPEED_CMD|MS_ASSIGN_MASTER_TORQUE_CTR"
    r"|MS_COUPLING_ALWAYS_ACTIVE|CC_MASTER_AXIS)\[[ \t]*(?P<axis>\w+)[ \t]*\][ \t]*=[ \t]*"
    r"(?P<value>[^\s;]*)",
    re.IGNORECASE,
)
_OF_CHANNEL = re.compile(
    r"\$MC_(?P<key>TRAFO_RESET_VALUE|TRAFO_TYPE_(?P<number>[0-9]+))[ \t]*=[ \t]*"
    r"(?P<value>[^\s;]*)",
    re.IGNORECASE,
)
_REMARK = re.compile(r";[^\r\n]*")
_NUMBERS = {
    "MS_ASSIGN_MASTER_SPEED_CMD": "MD37250",
    "MS_ASSIGN_MASTER_TORQUE_CTR": "MD37252",
    "CC_MASTER_AXIS": "MD63000",
}
#: Types of transformations (MD24100 and on) by which one programmed axis moves several.
_TRANSFORMATIONS = {256: "TRANSMIT", 257: "TRANSMIT", 1 << 10: "TRAANG"} | dict.fromkeys(
    range(512, 516), "TRACYL"
)


def couplings_of(
    files: Sequence[ControlFile], address: Callable[[str], str], wanted: Sequence[str]
) -> tuple[Coupling, ...]:
    """Return the couplings of the axes that move together, as the files state them.

    ``address``: a function that returns the address of an axis, given any name of the axis.
    """
    return (*_masters(files, address, wanted), *_transformed(files, wanted))


def _masters(
    files: Sequence[ControlFile], address: Callable[[str], str], wanted: Sequence[str]
) -> Iterator[Coupling]:
    statements: dict[tuple[str, str], CouplingStatement] = {}
    for found in statements_in(files, _OF_AXIS, _REMARK):
        statements[address(found.match["axis"]), found.match["key"].upper()] = found
    for (follows, key), found in statements.items():
        number = whole_number(found.match["value"])
        if key not in _NUMBERS or number == 0:
            continue
        named = replace(found, words=f"{_NUMBERS[key]}, {found.words}")
        if number is None:
            others = tuple(one for one in wanted if one != follows)
            yield named.coupling(others, follows, unlike=UNREAD)
            continue
        master = address(f"AX{number}")
        if key == "CC_MASTER_AXIS":
            yield named.coupling((master,), follows, switched=True)
            continue
        always = statements.get((follows, "MS_COUPLING_ALWAYS_ACTIVE"))
        on = always is not None and whole_number(always.match["value"]) != 0
        unlike = f"its drive follows axis {master}, without a position of its own"
        yield named.coupling((master,), follows, switched=not on, unlike=unlike, drive=True)


def _transformed(files: Sequence[ControlFile], wanted: Sequence[str]) -> Iterator[Coupling]:
    statements = {
        found.match["key"].upper(): found for found in statements_in(files, _OF_CHANNEL, _REMARK)
    }
    active = statements.get("TRAFO_RESET_VALUE")
    if active is None:
        return
    which = whole_number(active.match["value"])
    kind = statements.get(f"TRAFO_TYPE_{which}")
    type_ = 0 if kind is None else whole_number(kind.match["value"])
    if which is None or type_ is None:
        unread = active if which is None or kind is None else kind
        for follows in wanted:
            yield unread.coupling((), follows, switched=True, unlike=UNREAD)
        return
    name = _TRANSFORMATIONS.get(type_)
    if name is not None:
        unlike = f"{name} is active after reset (MD20140): a programmed axis moves several"
        for follows in wanted:
            yield active.coupling((), follows, switched=True, unlike=unlike)
