"""HEIDENHAIN controls: iTNC 530 and older (machine parameters, .COM/.CMA), and NCK controls
(CfgAxisComp, .COM/.CMA).

The older controls include TNC 407 to 430. Machine parameters: MP710 (backlash), MP720 (linear
error), MP730 (selection of the tables).

The rules are taken from the manuals, independently of the definitions that write the files:

- Linear error MP720, mm/m, positive when the axis travels too far. It begins at the reference mark:
  the control adds -MP720 * (p - reference) / 1000. It has no effect on rotary axes. On each axis
  either MP720 or the tables are active (MP730 bit), TNC 407 p. 151.
- A column Y in the .COM that the active .CMA line names under X is Y = F(X) (MANUALplus 620 p.
  718). On an iTNC 530, point k is at DATUM + k * spacing. The spacing is 2^n * 0.1 µm (TNC 407 p.
  153) or free (iTNC 530 HSCI p. 655). On an NCK control, the column AXISPOS lists the positions (p.
  716).
- MP710 / backLash positive: the encoder runs ahead, the travel is too short (TNC 426/430 p. 366,
  MANUALplus 620 p. 707). It adds nothing in the direction of referencing (unconfirmed). On reversal
  the whole value is added in the direction of motion.
- The column BACKLASH of an NCK table contains the values of the moving axis for travel towards -. A
  table has at most 256 points (MANUALplus 620 p. 715).
- Axes are numbered as the job states (``axis_number``; AX4 is axis 4), else X, Y, Z, A, B, C from
  1.
- The sign of the table values and the correction outside a table are unconfirmed, and so an option
  or an assumption.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from compwright.controllers.heidenhain.elements import Generation
from compwright.controllers.heidenhain.loading import Loader
from compwright.controllers.heidenhain.sheet import JudgedSheet, is_sheet, read_sheet
from compwright.controllers.heidenhain.table import Content, read_text
from compwright.controllers.heidenhain.tables import CorrectionCurve, HeidenhainAxis
from compwright.controllers.request import Request, unknown_axis
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.records.axis import Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile


@dataclass(frozen=True, slots=True)
class HeidenhainControl:
    """A HEIDENHAIN control with loaded files and all axes referenced; interface
    ``controllers.virtual_control.VirtualControl``.
    """

    generation: Generation
    axes: dict[str, HeidenhainAxis]
    crossed: dict[tuple[str, str], CorrectionCurve]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the axes that the files correct, by tables or parameters, active or not."""
        return tuple(self.axes)

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of the axis' own table, active or not, mm or deg; empty without
        a table.
        """
        table = self._axis(address).table
        return np.empty(0) if table is None else table.points()

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.

        Corrections by the position of another axis are not included: see `cross_correction`.
        """
        return self._axis(address).correction(np.asarray(positions, dtype=np.float64), direction)

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return (moving axis, corrected axis) of each table column that corrects another axis."""
        return tuple(self.crossed)

    def cross_correction(
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,  # noqa: ARG002
    ) -> FloatArray:
        """Return the correction of ``output`` (mm, deg for a rotary axis) with ``input`` at
        ``positions`` (any shape).

        The correction is the same in both directions. It is 0 if the tables of ``output`` are not
        active. Raises UsageError for a pair without a table.
        """
        pair = (self.generation.address(input), self.generation.address(output))
        if pair not in self.crossed:
            known = ", ".join(f"{corrected} over {moving}" for moving, corrected in self.crossed)
            raise UsageError(
                Fault(
                    message=f"the files contain no table that corrects {output} over the "
                    f"position of {input}",
                    expected=known or "an active table",
                    hint=("correct the entry `cross` of the job, or give the file with this table"),
                )
            )
        where = np.asarray(positions, dtype=np.float64)
        return (
            self.crossed[pair].at(where) if self.axes[pair[1]].nonlinear else np.zeros(where.shape)
        )

    def _axis(self, address: str) -> HeidenhainAxis:
        axis = self.axes.get(self.generation.address(address))
        if axis is None:
            raise unknown_axis(address, self.addresses())
        return axis


def heidenhain_control(
    files: Sequence[ControlFile], request: Request, *, generation: Generation
) -> HeidenhainControl:
    """Return a control of one generation with its files loaded; their order does not matter.

    The files are entry sheets, .COM and .CMA tables and, for an iTNC 530, lines of machine
    parameters.

    Options of the job: ``table_values`` of exported tables (``error``, ``correction``);
    ``spacing_rule`` (``free``, ``power_of_two``; iTNC 530); ``backlash_column`` (``second_curve``,
    ``absent``; NCK).

    Raises InputError for data that the control would not accept and for contradictions, each fault
    with file and line. Raises UsageError for a wrong option or a turn other than 360 deg.
    """
    numbers = {
        int(one[2:]): one for one in request.axes_under_work if re.fullmatch(r"AX[1-9][0-9]?", one)
    }
    numbers |= {
        number: generation.address(axis)
        for axis, number in request.axis_number.items()
        if number > 0
    }
    generation = replace(generation, numbers=numbers)
    sheets: list[JudgedSheet] = []
    contents: list[Content] = []
    faults: list[Fault] = []
    for file in files:
        if is_sheet(file):
            sheet, wrong = read_sheet(file, generation)
            sheets += [sheet] if sheet is not None else []
            faults += wrong
        else:
            contents.append(read_text(file, generation))
            faults += contents[-1].faults
    raise_all(InputError, faults)
    loader = Loader(generation, request, sheets, contents)
    axes = loader.axes()
    if not axes and not loader.faults:
        loader.faults.append(
            Fault(
                message="the files contain no compensation data",
                file=", ".join(file.name for file in files),
                expected="an entry sheet, a table (.COM) or machine parameters",
                hint="give the files that contain the compensation of this control",
            )
        )
    raise_all(InputError, loader.faults)
    return HeidenhainControl(
        generation=generation,
        axes=axes,
        crossed=loader.crossed,
        assumed=tuple(dict.fromkeys(loader.given.assumed)),
        notes=tuple(dict.fromkeys(loader.given.notes)),
    )
