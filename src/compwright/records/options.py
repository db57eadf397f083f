"""The names of options that are the same for every control."""

from __future__ import annotations

from dataclasses import dataclass

#: What every control's files are read with where no job says more about the axis: the zero state.
REFERENCE = "reference"
REFERENCE_RETURN = "reference_return"
#: Whether an axis is linear or rotary, for reading files that do not say it: a word for every axis,
#: or kinds by address.
KIND = "kind"
#: The option that says how long a pulse is: asked for, never assumed.
DETECTION_UNIT = "detection_unit"
#: What the values of a table mean, where no manual says it; an entry sheet says it of its axis.
TABLE_VALUES = "table_values"
#: The option that names the measuring system to read where no job does.
ENCODER_SYSTEM = "encoder_system"


@dataclass(frozen=True, slots=True)
class UnansweredOption:
    """An option of the control that the user must state in a new job, because no file states it.

    ``words``: what is expected. ``stand_in``: a value with which the axes can be read from the
    files although the true value is unknown. ``lengths``: whether the positions of a table are in
    the unit of this option.
    """

    name: str
    words: str
    stand_in: float
    lengths: bool
