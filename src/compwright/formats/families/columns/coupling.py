"""Synchronised axes of a HEIDENHAIN by machine parameter: MP850.x is 0 for a master axis, else the
number of the axis that axis x + 1 follows (iTNC 530 HSCI technical manual, July 2013, page 779).
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence

from compwright.formats.families.columns.sources import AxisNumbers
from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    statements_in,
    whole_number,
)
from compwright.records.correction import ControlFile

_LINE = re.compile(
    r"^[ \t]*MP[ \t]*850\.([0-9]{1,2})(?![0-9])[ \t]*[:=]?[ \t]*([^\s;]*)",
    re.MULTILINE | re.IGNORECASE,
)
_REMARK = re.compile(r";[^\r\n]*")


def couplings_of(
    files: Sequence[ControlFile],
    numbers: AxisNumbers,
    wanted: Sequence[str],
    known: Collection[str],
) -> Iterator[Coupling]:
    """Yield which axes follow another one; ``numbers``: the control's axis numbers; ``wanted``:
    axes under work; ``known``: axes that the job names.
    """
    last = {found.match[1]: found for found in statements_in(files, _LINE, _REMARK)}
    for index, found in last.items():
        follows, master = numbers.follower(int(index) + 1, known), whole_number(found.match[2])
        if master is None or master < 0:
            others = tuple(one for one in wanted if one != follows)
            yield found.coupling(others, follows, unlike=UNREAD)
        elif master:
            yield found.coupling((numbers.address(master),), follows)
