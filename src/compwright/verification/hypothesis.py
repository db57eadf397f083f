"""Hypotheses about how a table was loaded: correctly, not at all, or with a fault.

A correction is what the control adds to the command, table and backlash compensation together. A
constant that both directions have in common is the instrument's datum and is ignored; a difference
between the directions is not.

The weight of a hypothesis is its prior probability divided by that of a correctly loaded table.
Several variants may have the same name. If a name has many variants (such as a cut at any point),
they share its weight. All lengths are in mm or deg.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Final

import numpy as np

from compwright.records.axis import FloatArray
from compwright.records.correction import AxisCompensation
from compwright.records.stored_table import StoredTable
from compwright.records.verification import LoadingName
from compwright.words.sentences import Sentence

#: A machine that has warmed up by a fraction of a degree, or whose scale is read a little
#: otherwise, changes the effect of a table by so much of itself (standard deviation).
SLACK: Final = 0.02
#: Standard deviation of a factor that nothing is known of.
UNKNOWN_FACTOR: Final = 0.7
# Prior odds of a fault against the loaded table, of each distinct variant. With odds of 5:1 and a
# verdict from 99 %, a fault that lies two standard errors from the loaded table, where it is mixed
# up most easily, passes for it in about 2 % of the tests.
COMMON: Final = 0.2
RARE: Final = 0.05


@dataclass(frozen=True, slots=True, kw_only=True)
class Hypothesis:
    """One hypothesis about how a table was loaded, such as with the wrong sign.

    - ``positive``, ``negative`` (m,): the correction under the hypothesis minus the correction that
      the expected deviation contains.
    - ``free`` (2, m): a further difference, multiplied by an unknown standard normal number.
      ``slack``: standard deviation of an unknown factor on the change. ``sloped``: an unknown slope
      over the positions, of any size, is added.
    - ``weight``: the prior probability divided by that of a correctly loaded table.
    - ``inner``: the correctly loaded table is its limit (a cut near the end, a factor near one),
      and there it has no name of its own.
    - ``read``: for a fault of measurement, the state of the table.
    """

    name: LoadingName
    positive: FloatArray
    negative: FloatArray
    weight: float = 1.0
    detail: Sentence | None = None
    factor: float = 1.0
    shift_nodes: int = 0
    of: str | None = None
    free: FloatArray | None = None
    slack: float = 0.0
    sloped: bool = False
    inner: bool = False
    read: LoadingName | None = None

    @property
    def change(self) -> FloatArray:
        """The change of the correction in + and − that this hypothesis predicts, (2, m)."""
        return np.stack([self.positive, self.negative])


@dataclass(frozen=True, slots=True, kw_only=True)
class Loading:
    """The planned table, and the state of the control before it was loaded.

    - ``new``: the planned table, in the rows of the control. ``old``: the existing table, active or
      not.
    - ``active_before``: the correction that was active in the tests before loading, from which the
      expected deviation comes.
    - ``others``: the tables planned for other axes, by name.
    - ``always`` (m,): by direction, the correction that is active in the test in any case.
    - ``read_back``: whether the values read back from the control are the planned ones.
    - ``axis``: the axis by whose position the table corrects, if the texts have to name it.
    """

    new: StoredTable
    old: AxisCompensation
    active_before: AxisCompensation
    others: Mapping[str, StoredTable] = field(default_factory=dict)
    reference: float = 0.0
    always: tuple[FloatArray, FloatArray] | None = None
    read_back: bool = False
    axis: str = ""
