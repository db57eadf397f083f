"""Find the axes of an ISG kernel that move together, as its lists state it.

Three entries of the lists state it:

- kenngr.gantry_ax_nr in the list of a slave axis: its master (P-AXIS-00070).
- kenngr.multi_link: a leading axis with a factor (P-AXIS-00383).
- synchro_data of a channel: pairs of master and slave (P-CHAN-00037, P-CHAN-00038).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from compwright.formats.families.coupled_axes import (
    UNREAD,
    Coupling,
    CouplingStatement,
    statements_in,
    whole_number,
)
from compwright.formats.families.lists.files import without_remarks
from compwright.records.correction import ControlFile

_OF_AXIS = re.compile(
    r"^[ \t]*kenngr\.(gantry_ax_nr|multi_link\[[0-9]+\]\.lead_axis)(?:[ \t]+(\S+))?",
    re.MULTILINE | re.IGNORECASE,
)
_OF_CHANNEL = re.compile(
    r"^[ \t]*synchro_data\.koppel_gruppe\[([0-9]+)\]\.paar\[([0-9]+)\]"
    r"\.log_achs_nr_(master|slave)(?:[ \t]+(\S+))?",
    re.MULTILINE | re.IGNORECASE,
)
#: How a line of the lists that couples axes begins.
COUPLING = re.compile(r"kenngr\.(?:gantry_ax_nr|multi_link)|synchro_data\.", re.IGNORECASE)
_REMARK = re.compile(r"(?!)")  # without_remarks has taken them


def couplings_of(
    files: Sequence[ControlFile], owners: Mapping[str, int], wanted: Sequence[str]
) -> tuple[Coupling, ...]:
    """Return a coupling for each axis that moves with another axis, as the lists state it.
    ``owners``: axis number by file name; ``wanted``: addresses of the axes to be read.
    """
    plain = [ControlFile(file.name, without_remarks(file.content)) for file in files]
    return (*_of_axes(plain, owners, wanted), *_of_channels(plain, wanted))


def _of_axes(
    files: Sequence[ControlFile], owners: Mapping[str, int], wanted: Sequence[str]
) -> Iterator[Coupling]:
    for found in statements_in(files, _OF_AXIS, _REMARK):
        number, own = whole_number(found.match[2] or ""), owners.get(found.file)
        if own is not None and number is None:
            others = tuple(one for one in wanted if one != str(own))
            yield found.coupling(others, str(own), unlike=UNREAD)
        if not number or own is None or number == own:
            continue
        ratio = found.match[1].lower() != "gantry_ax_nr"
        unlike = "it is linked with another axis by a factor" if ratio else ""
        yield found.coupling((str(number),), str(own), unlike=unlike)


def _of_channels(files: Sequence[ControlFile], wanted: Sequence[str]) -> Iterator[Coupling]:
    pairs: dict[tuple[str, str, str], dict[str, CouplingStatement]] = {}
    for found in statements_in(files, _OF_CHANNEL, _REMARK):
        key = (found.file, found.match[1], found.match[2])
        pairs.setdefault(key, {})[found.match[3].lower()] = found
    for pair in pairs.values():
        numbers = {role: whole_number(one.match[4] or "") for role, one in pair.items()}
        unread = next((pair[role] for role, number in numbers.items() if number is None), None)
        if unread is not None:
            for follows in wanted:
                yield unread.coupling((), follows, switched=True, unlike=UNREAD)
        elif len(pair) == 2 and all(numbers.values()):
            yield pair["slave"].coupling(
                (str(numbers["master"]),), str(numbers["slave"]), switched=True
            )
