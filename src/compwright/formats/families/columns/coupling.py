"""Synchronised axes of a HEIDENHAIN by machine parameter: MP850.x is 0 for a master axis, else the
number of the axis that axis x + 1 follows (iTNC 530 HSCI technical manual, July 2013, page 779).
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from compwright.formats.families.columns.sources import AxisNumbers
from compwright.formats.families.coupled_axes import Coupling, statements_in
from compwright.records.correction import ControlFile

_LINE = re.compile(
    r"^[ \t]*MP[ \t]*850\.([0-9]{1,2})[ \t]*[:=]?[ \t]*([0-9]{1,2})(?![0-9.])",
    re.MULTILINE | re.IGNORECASE,
)
_REMARK = re.compile(r";[^\r\n]*")


def couplings_of(files: Sequence[ControlFile], numbers: AxisNumbers) -> tuple[Coupling, ...]:
    """Return which axes follow another one; ``numbers``: how the control counts its axes."""
    last = {found.match[1]: found for found in statements_in(files, _LINE, _REMARK)}
    return tuple(
        found.coupling((numbers.address(int(found.match[2])),), numbers.address(int(index) + 1))
        for index, found in last.items()
        if int(found.match[2])
    )
