"""A control's files read axis by axis, where the whole cannot be read: an odd neighbour hides no
other axis.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace

from compwright.controls.control import Control
from compwright.foundations.errors import InputError, UsageError
from compwright.records.correction import ControlFile, ControlState


@dataclass(frozen=True, slots=True)
class AxisByAxis:
    """``state``: of all axes that could be read, None where none could; ``refused``: why another
    one could not, by address.
    """

    state: ControlState | None
    refused: Mapping[str, InputError | UsageError]


def axis_by_axis(
    control: Control,
    files: Sequence[ControlFile],
    read: Callable[[str], ControlState],
    among: Collection[str] | None = None,
    caught: type[InputError] | tuple[type[InputError], type[UsageError]] = InputError,
) -> AxisByAxis:
    """Return the state that ``read`` gives for one address of ``files`` after the other, ``among``
    these if given; none if the control's axes may not be read alone.

    An axis on which nothing is active, by the others, is skipped. ``caught``: errors that leave an
    axis out.
    """
    refused: dict[str, InputError | UsageError] = {}
    state: ControlState | None = None
    listing = control.format.listing
    for address in listing.alone(control.format, files):
        idle = state is not None and listing.idle(state, address)
        if idle or (among is not None and address not in among):
            continue
        try:
            one = read(address)
        except caught as error:
            refused[address] = error
        else:
            state = one if state is None else _together(state, one)
    return AxisByAxis(state, refused)


def _together(one: ControlState, other: ControlState) -> ControlState:
    """Return what two readings of the same files say, each of its own axes."""
    axes, facts = {**one.axes, **other.axes}, {**one.facts, **other.facts}
    return replace(one, axes=axes, facts=facts)
