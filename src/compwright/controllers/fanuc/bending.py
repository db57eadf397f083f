"""Straightness compensation of a FANUC: the position of one axis corrects another axis.

The control outputs the amounts at the pitch points of the moving axis. This module interpolates
linearly between them, which is unconfirmed and reported as an assumption. Sources: the docstring of
``additional_functions``.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np

from compwright.controllers.fanuc.additional_functions import Bend, bends
from compwright.controllers.fanuc.axis import AxisLoader
from compwright.controllers.fanuc.options import Options
from compwright.controllers.fanuc.table import IncrementGrid
from compwright.records.axis import FloatArray
from compwright.records.correction import Assumption


@dataclass(frozen=True, slots=True)
class Bending:
    """The straightness compensation of the axis ``bent`` by the position of the axis ``moving``.

    ``points`` (k,): positions of the axis ``moving`` relative to its ``reference``, mm or deg.
    ``shifts`` (k,): corrections of the axis ``bent`` at these positions, mm or deg. ``turn``:
    travel per turn of an endless moving axis, deg; None for an axis with ends.
    """

    moving: str
    bent: str
    points: FloatArray
    shifts: FloatArray
    reference: float
    turn: float | None

    def at(self, positions: FloatArray) -> FloatArray:
        """Return the correction (mm or deg) of the axis ``bent`` with the moving axis at
        ``positions`` (any shape).

        Outside the points the corrections of the end points apply.
        """
        x = positions - self.reference
        if self.turn is not None:
            x = np.mod(x, self.turn)
        return np.asarray(np.interp(x, self.points, self.shifts), dtype=np.float64)


def bending_of(
    loader: AxisLoader, grids: Mapping[int, IncrementGrid | None], options: Mapping[int, Options]
) -> Iterator[Bending]:
    """Yield the straightness compensations of the job's axes, if the options ask to evaluate
    straightness.

    ``grids``: point numbers and interval of each axis' table. ``options``: the options of each
    axis. A fault is added to `Memory` if the moving axis has no active table. A fault is also added
    if the detection unit of the corrected axis is unknown.
    """
    memory = loader.memory
    if not any("straightness" in entry.counted for entry in options.values()):
        return
    for bend in bends(memory.machine, memory.faults):
        if not (loader.under_work(bend.moving) or loader.under_work(bend.bent)):
            loader.note(
                bend.bent,
                f"axis {bend.moving} bends it ({bend.entry.number}); it was not requested",
            )
            continue
        grid = grids.get(bend.moving)
        if grid is None:
            memory.faults.append(
                bend.entry.fault(
                    f"straightness compensation moves with axis {bend.moving}, whose points are not"
                    " active",
                    "3620 to 3624 of the moving axis",
                )
            )
            continue
        unit = _unit(loader, bend, options)
        if unit is not None:
            yield _bending(loader, bend, grid, unit)


def _unit(loader: AxisLoader, bend: Bend, options: Mapping[int, Options]) -> float | None:
    """Return the corrected axis' detection unit, mm or deg; None, with a fault, if unknown."""
    own = options.get(bend.bent)
    rotary = loader.known_rotary(bend.bent) is True
    unit = own.detection_unit if own is not None else None
    unit = unit or loader.memory.machine.detection_unit(bend.bent, rotary=rotary)
    if unit is None:
        loader.memory.faults.append(
            bend.entry.fault(
                f"detection unit of axis {bend.bent}, in which its straightness counts",
                f"1820 and 1013 of axis {bend.bent} in the files, or the option detection_unit",
            )
        )
    return unit


def _bending(loader: AxisLoader, bend: Bend, grid: IncrementGrid, unit: float) -> Bending:
    numbers = np.arange(
        grid.reference if grid.turn is not None else grid.lowest - 1, grid.highest + 1
    ).astype(np.float64)
    reference, _ = loader.request.referenced(str(bend.moving))
    loader.memory.assumed.append(
        Assumption(
            f"straightness of {bend.bent} over {bend.moving}",
            f"in detection units of axis {bend.bent}, + towards +, lines between the points",
            "unconfirmed",
        )
    )
    return Bending(
        moving=str(bend.moving),
        bent=str(bend.bent),
        points=grid.interval * (numbers - grid.reference),
        shifts=unit * bend.lines.at(numbers, grid.reference),
        reference=reference,
        turn=grid.turn,
    )
