"""What a control loads of written files, compared with the whole files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from compwright.controls.control import Control, decode
from compwright.controls.decoded import DecodedState, judged
from compwright.controls.two_readers import probe_positions
from compwright.foundations.errors import CompwrightError, Fault, UsageError, raise_all
from compwright.records.axis import Axis, Direction
from compwright.records.correction import ControlFile
from compwright.records.delivery import Delivery
from compwright.records.serial_line import as_on_line
from compwright.verification.read_back import SAME


def deliver(
    control: Control,
    files: tuple[ControlFile, ...],
    as_found: DecodedState,
    axes: Sequence[Axis],
    image: DecodedState | None,
) -> Delivery:
    """Return what the control loads of the ``files`` that were written for ``axes``.

    Raises UsageError for a form of files that these have not, and CompwrightError (a fault of our
    own) where small files do something else than the whole ``image``, which they stand for.
    """
    try:
        delivery = control.format.delivered(files, as_found.files, axes)
    except UsageError as error:
        raise control.origin.named(error) from error
    delivery = replace(delivery, files=as_on_line(delivery.files, as_found.files))
    if delivery.own or image is None:
        return delivery
    small = decode(control, delivery.files, axes, written=True)
    faults = [
        Fault(
            message="the small files do not have the same effect as the archive",
            place=f"axis {axis.address}, direction {direction.value}",
            hint=(
                "set `files: patched` in the options, and report this line with "
                "the job and its files"
            ),
        )
        for axis in axes
        for direction in Direction
        if not _same(small, image, axis.address, direction)
    ]
    raise_all(CompwrightError, faults)
    return delivery


def _same(one: DecodedState, other: DecodedState, address: str, direction: Direction) -> bool:
    where = probe_positions(other.state.axes[address].positions)
    mine, theirs = (judged(state, address, where, direction) for state in (one, other))
    return bool(np.all(np.abs(mine - theirs) <= SAME))
