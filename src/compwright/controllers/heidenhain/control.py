"""HEIDENHAIN controls: iTNC 530 and older (machine parameters, .COM/.CMA), and NCK controls
(CfgAxisComp, .COM/.CMA).

TNC 407 to 430 too; MP710, MP720, MP730.

Stated from the manuals, independently of the definitions that write the files:

- Linear error MP720, mm/m, positive when the axis travels too far; it starts at the reference mark:
  the control adds -MP720 * (p - reference) / 1000. No effect on rotary axes; per axis either this
  or the tables (MP730 bit), TNC 407 p. 151.
- A column Y in the .COM that the active .CMA line names under X is Y = F(X) (MANUALplus 620 p.
  718). Point k lies at DATUM + k * spacing; the spacing is 2^n * 0.1 µm (TNC 407 p. 153) or free
  (iTNC 530 HSCI p. 655). NCK: AXISPOS (p. 716).
- MP710 / backLash positive: the encoder runs ahead, the travel is too short (TNC 426/430 p. 366,
  MANUALplus 620 p. 707). Nothing in the direction of referencing, on reversal the whole value in
  the direction of motion; that zero state is not confirmed.
- The column BACKLASH of an NCK table holds the values of the axis' own column for travel towards -;
  a table has at most 256 points (MANUALplus 620 p. 715).
- Axes are numbered as given (``axis_number``; AX4 is axis 4), else X, Y, Z, A, B, C from 1.
- Unconfirmed and so an option or an assumption: the sign of the table values, and the correction
  outside a table.
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
    ``controllers.virtual.VirtualControl``.
    """

    generation: Generation
    axes: dict[str, HeidenhainAxis]
    crossed: dict[tuple[str, str], CorrectionCurve]
    assumed: tuple[Assumption, ...]
    notes: tuple[str, ...]

    def addresses(self) -> tuple[str, ...]:
        """Return the axes that the files correct, by tables or parameters, active or not."""
        return tuple(self.axes)

    def nodes(self, address: str) -> FloatArray:
        """Return the positions (k,) of the axis' own table, active or not, mm or deg; empty without
        a table.
        """
        table = self._axis(address).table
        return np.empty(0) if table is None else table.nodes()

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape), approached in ``direction``; mm or
        deg.

        Without cross tables.
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

        It is the same in both directions. Raises UsageError for a pair without a table.
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

    Entry sheets, .COM, .CMA and, for an iTNC 530, lines of machine parameters.

    Options: ``table_values`` (``error``, ``correction``) of exported tables, ``spacing_rule``
    (``free``, ``power_of_two``; iTNC 530), ``backlash_column`` (``second_curve``, ``absent``; NCK).
    Raises InputError for anything the control would not take or that is contradictory, every fault
    with file and line; UsageError for a wrong option or a turn other than 360 deg.
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
