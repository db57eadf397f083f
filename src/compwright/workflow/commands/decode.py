"""``decode``: show the correction that a control would make with given files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from compwright.controls.decoded_state import DecodedState, judged_values
from compwright.controls.judged_corrections import judged_cross
from compwright.documents.decode import DecodedAxis, decode_document
from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.session import Session
from compwright.jobs.command_line import stated_activity
from compwright.records.axis import Direction, FloatArray
from compwright.workflow.inputs.axis_kinds import Kinds, decode_kinds

MOST_POSITIONS = 1_000_000


def decoded_files(
    session: Session,
    paths: Sequence[Path],
    format_id: str,
    options: dict[str, object],
    *,
    axis: str | None = None,
    at: str | None = None,
) -> tuple[DecodedState, Kinds, dict[str, Any]]:
    """Return the contents of the control files, the axes for which linear or rotary is unknown, and
    the JSON document of the command. ``axis``: the only axis address to decode (None: all); ``at``:
    the positions, as text (None: those of the tables).

    The option ``active`` states whether the tables are active, and whether all values of a program
    were carried out. Raises UsageError for wrong options and for an invalid list of positions.
    Raises InputError for files that cannot be read, and for an axis that they do not contain.
    """
    active = stated_activity(options)
    wanted = None if at is None else positions_of(at)
    control, decoded, kinds = decode_kinds(session, paths, format_id, options, axis, active=active)
    answer = {}
    for address, entry in decoded.state.axes.items():
        where = entry.positions if wanted is None else wanted
        answer[address] = DecodedAxis(
            kind=None if address in kinds.unknown else entry.kind,
            positions=where,
            positive=judged_values(decoded, address, where, Direction.POSITIVE),
            negative=judged_values(decoded, address, where, Direction.NEGATIVE),
        )
    assumed = (*control.assumed(decoded.state), *decoded.state.assumed, *kinds.assumed)
    findings = (*control.findings, *kinds.findings, *decoded.state.findings)
    cross = judged_cross(decoded, wanted)
    return decoded, kinds, decode_document(answer, assumed, findings, cross, kinds.unknown)


def positions_of(text: str) -> FloatArray:
    """Return the positions (mm or deg) in a text of numbers and ranges ``LO:HI:STEP``, in the order
    of the text.

    A range includes HI if a step ends there (within 1e-9 of a step). Raises UsageError with every
    part that cannot be read.
    """
    faults: list[Fault] = []
    positions: list[float] = []
    for part in text.split(","):
        try:
            positions.extend(_part(part.strip()))
        except ValueError as error:
            faults.append(
                Fault(
                    message="the value of `--at` must be one number or look like 0:800:10",
                    place="--at",
                    found=str(error),
                    hint="give `--at 0:800:10` (from, to, step), or positions: `--at 0,100,250`",
                )
            )
    if faults:
        raise UsageError(*faults)
    return np.array(positions, dtype=np.float64)


def _part(part: str) -> list[float]:
    try:
        numbers = [float(piece) for piece in part.split(":")]
    except ValueError as error:
        raise ValueError(repr(part)) from error
    if not all(np.isfinite(numbers)) or len(numbers) not in {1, 3}:
        raise ValueError(repr(part))
    if len(numbers) == 1:
        return numbers
    low, high, step = numbers
    if step <= 0 or high < low or (high - low) / step > MOST_POSITIONS:
        raise ValueError(f"{part!r} (LO <= HI, STEP > 0, at most {MOST_POSITIONS} positions)")
    count = int(np.floor((high - low) / step + 1e-9)) + 1
    return [low + index * step for index in range(count)]
