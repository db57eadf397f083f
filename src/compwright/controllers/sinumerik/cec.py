"""The cross-axis tables (CEC) in all files: which tables are in use, and why the remaining tables
are not.

Some machine builders use a table for another purpose, so that its values are no curve. An example
from a real archive is MIN -850, MAX 0, STEP 100; output ``(X)``, STEP 0. Such a table is ignored if
all its values are zero. Otherwise the correction of its pair of axes is unknown.

MULT_BY_TABLE = n multiplies a table by the table with the index n - 1 (manual p. 245, p. 249, p.
252). No manual page states whether the values of the multiplied table are also added. So neither
the product nor these values are included in the correction, and the table is reported. While it
stays unchanged, its effect is the same before and after. If the output of the other table is zero,
there is no product.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import numpy as np

from compwright.controllers.request import Request, wrong_choice
from compwright.controllers.sinumerik.axes import MachineAxisNames
from compwright.controllers.sinumerik.cec_tables import CecTableLoader
from compwright.controllers.sinumerik.lengths import Lengths
from compwright.controllers.sinumerik.sag import Pair, Sag, SagTable
from compwright.controllers.sinumerik.tables import Remarks
from compwright.controllers.sinumerik.text import VariableAssignment
from compwright.records.correction import Assumption

#: Default of MD32720, mm or deg (as in a real archive).
_USUAL_LIMIT = 1.0
_SIGNS = {"correction": 1, "error": -1}


def load_sag(
    entries: Sequence[VariableAssignment],
    request: Request,
    spelling: Mapping[str, str],
    remarks: Remarks,
    unknown_keys: Mapping[int, str],
    names: MachineAxisNames,
    lengths: Lengths,
    screws: frozenset[str] = frozenset(),
    room: tuple[int, int] | None = None,
) -> Sag:
    """Return the cross-axis tables (CEC) that the assignments ``entries`` of all files define. The
    other arguments state the axes' names and units, and the limits of the control.

    - ``spelling``: the known name of each axis, by its name in capitals.
    - ``remarks``: faults and notes are added to it.
    - ``unknown_keys``: for each table with an unknown variable, the name of this variable.
    - ``names``: the names of the machine axes.
    - ``lengths``: which axes are linear, and whether the basic system is inch.
    - ``screws``: axes (in capitals) whose leadscrew table is switched on.
    - ``room``: the number of tables of the control and the number of points of a table; None if
      machine data state them.

    Raises UsageError for an option ``cec_sign`` that is neither ``correction`` nor ``error``.
    """
    sign = _sign(request)
    loader = CecTableLoader(
        [entry for entry in entries if "CEC" in entry.name], dict(spelling), remarks, request
    )
    loader.unknown_keys, loader.names, loader.lengths = unknown_keys, names, lengths
    loader.screws = screws
    tables = loader.tables()
    if remarks.faults:  # a table may be missing: what follows would be wrong about the others
        return Sag({}, frozenset(), {}, sign)
    if room is not None:
        remarks.faults += loader.beyond(tables, room)
    counted = loader.without_cut_sums(_without_products(tables, remarks))
    by_pair: dict[Pair, list[SagTable]] = defaultdict(list)
    for table in counted:
        by_pair[table.input, table.output].append(table)
    of_output: dict[str, list[Pair]] = defaultdict(list)
    for pair in by_pair:
        of_output[pair[1]].append(pair)
    if counted:
        _note_sign(sign, request, remarks)
    sag = Sag(
        by_pair={pair: tuple(given) for pair, given in by_pair.items()},
        off=frozenset(output for output in of_output if loader.switched_off(output)),
        odd=loader.odd,
        uncounted=tuple(dict.fromkeys(loader.uncounted)),
        limits={
            output: limit
            for output in of_output
            if (limit := loader.of_axis(output, "MA_CEC_MAX_SUM")) is not None
        },
        sign=sign,
    )
    for output, pairs in of_output.items():
        if output not in sag.off:
            _remark(sag, output, pairs, remarks)
    return sag


def _sign(request: Request) -> int:
    # the options of a job always hold the key: None where it is not given
    option = request.options.get("cec_sign", "correction")
    if option is None:
        return 0
    if option not in _SIGNS:
        raise wrong_choice("cec_sign", option, _SIGNS)
    return _SIGNS[str(option)]


def _note_sign(sign: int, request: Request, remarks: Remarks) -> None:
    if not sign:
        remarks.notes.append(
            "the effect of the CEC tables is unknown: their sign is not given (option cec_sign)"
        )
        return
    remarks.assumed.append(
        Assumption(
            "sign of the CEC values (cec_sign)",
            "correction" if sign > 0 else "error",
            "option"
            if "cec_sign" in request.options
            else "not asked for here; the Function Manual of 03/2009, p. 372, says error",
        )
    )


def _without_products(tables: Mapping[int, SagTable], remarks: Remarks) -> list[SagTable]:
    """Return the tables that are not multiplied by another table; add a note for each multiplied
    table.

    A table counts as multiplied unless it is inactive or all values of the other table are zero. If
    the other table is switched off (SD41300) or has the weight 0, the product is unknown: no manual
    page states it.
    """
    counted: list[SagTable] = []
    for index, table in tables.items():
        partner = None if table.factor is None else tables.get(table.factor)
        if partner is None or not (np.any(partner.table.values) and table.is_active()):
            counted.append(table)
            continue
        remarks.notes.append(
            f"CEC table {index} is multiplied by table {table.factor}"
            f" ($AN_CEC_MULT_BY_TABLE[{index}]): what both do to {table.output} is left alone and"
            " not counted"
        )
    return counted


def _remark(sag: Sag, output: str, pairs: Sequence[Pair], remarks: Remarks) -> None:
    """Add a note if the control limits or deactivates the sum of all tables on an output axis."""
    reached = 0.0
    for pair in pairs:
        base = pair[0]
        ways = {table.direction for table in sag.by_pair[pair] if table.enabled}
        if ways in ({1}, {-1}):
            way = "+" if 1 in ways else "-"
            remarks.notes.append(
                f"{output}: its tables over {base} act only while {base} moves towards {way}"
            )
        reached += sag.peak(pair)
    limit = sag.limits.get(output)
    if limit is not None and reached > limit:
        remarks.notes.append(
            f"{output}: MD32720 $MA_CEC_MAX_SUM cuts the sum of its CEC tables to {limit:g}; they"
            f" reach up to {reached:g}"
        )
    if limit is None and reached > _USUAL_LIMIT:
        remarks.assumed.append(
            Assumption(
                f"MD32720 $MA_CEC_MAX_SUM of {output}",
                "no limit",
                f"not in the files; unchanged it would be {_USUAL_LIMIT:g}",
            )
        )
