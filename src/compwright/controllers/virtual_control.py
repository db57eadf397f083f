"""The interface of all virtual controls, and the list of the virtual controls."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Protocol

from compwright.controllers.fanuc import series
from compwright.controllers.fanuc.control import fanuc_control
from compwright.controllers.heidenhain import elements as heidenhain
from compwright.controllers.heidenhain.control import heidenhain_control
from compwright.controllers.isg.control import isg_control
from compwright.controllers.linuxcnc.control import linuxcnc_control
from compwright.controllers.pmac.control import pmac_control
from compwright.controllers.request import Request
from compwright.controllers.sinumerik.control import ROOM_828D, sinumerik_control
from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.records.axis import AxisKind, Direction, FloatArray
from compwright.records.correction import Assumption, ControlFile


class VirtualControl(Protocol):
    """The interface of a virtual control: its files are loaded, and its corrections can be read.

    ``assumed``: facts that are not in the files. ``notes``: parts of the files that the control
    ignores or changes without a message, one sentence each with file and line. A caller that needs
    exactly the written values must check the notes.
    """

    @property
    def assumed(self) -> tuple[Assumption, ...]:
        """The facts about the control that were assumed because no file states these facts."""
        ...

    @property
    def notes(self) -> tuple[str, ...]:
        """Notes on parts of the files that the control does not load or ignores."""
        ...

    def addresses(self) -> tuple[str, ...]:
        """Return the axes in the files, by the control's own names."""
        ...

    def points(self, address: str) -> FloatArray:
        """Return the positions (k,) of an axis' table points, mm or deg; empty without a table."""
        ...

    def correction(self, address: str, positions: FloatArray, direction: Direction) -> FloatArray:
        """Return the correction at ``positions`` (any shape, mm or deg), approached in
        ``direction``; mm or deg.

        The correction is the sum of table and backlash. Raises UsageError for an axis that is not
        in the files.
        """
        ...

    def cross(self) -> tuple[tuple[str, str], ...]:
        """Return (input axis, output axis) of the tables by which one axis corrects another."""
        ...

    def cross_correction(
        self,
        input: str,  # noqa: A002
        output: str,
        positions: FloatArray,
        direction: Direction,
    ) -> FloatArray:
        """Return the correction of ``output`` with ``input`` at ``positions`` (any shape), moving
        in ``direction``; mm or deg.

        Raises UsageError for a pair of axes without a table.
        """
        ...


_MAKERS: Mapping[str, Callable[[Sequence[ControlFile], Request], VirtualControl]] = {
    "fanuc-0i-16i": partial(fanuc_control, series=series.SERIES_0I_16I),
    "fanuc-0i-d": partial(fanuc_control, series=series.SERIES_0I_D),
    "fanuc-0i-f": partial(fanuc_control, series=series.SERIES_0I_F),
    "fanuc-15i": partial(fanuc_control, series=series.SERIES_15I),
    "fanuc-30i": partial(fanuc_control, series=series.SERIES_30I),
    "heidenhain-itnc530": partial(heidenhain_control, generation=heidenhain.ITNC530),
    "heidenhain-nck": partial(heidenhain_control, generation=heidenhain.NCK),
    "isg-kernel": isg_control,
    "linuxcnc": linuxcnc_control,
    "pmac": pmac_control,
    "siemens-828d": partial(sinumerik_control, room=ROOM_828D),
    "siemens-840d-pl": sinumerik_control,
    "siemens-840d-sl": sinumerik_control,
    "siemens-one": sinumerik_control,
}

#: Formats that have a judge. A format without one is read back, not independently checked.
KNOWN: tuple[str, ...] = tuple(_MAKERS)


def virtual_control(
    format_id: str,
    files: Sequence[ControlFile],
    *,
    reference_return: Mapping[str, Direction] | None = None,
    options: Mapping[str, object] | None = None,
    encoder: Mapping[str, int] | None = None,
    kinds: Mapping[str, AxisKind] | None = None,
    modulo: Mapping[str, float] | None = None,
    reference: Mapping[str, float] | None = None,
    active: bool | None = None,
    carried_out: bool = False,
    axis_options: Mapping[str, Mapping[str, object]] | None = None,
    axes_under_work: Sequence[str] = (),
    axis_number: Mapping[str, int] | None = None,
) -> VirtualControl:
    """Return the virtual control named ``format_id`` with ``files`` loaded. The other arguments are
    facts from the job that the files may lack, such as which tables were active.

    Arguments by axis address:

    - ``reference_return``: direction in which the reference is approached.
    - ``encoder``: active measuring system, 1 or 2.
    - ``kinds``: linear or rotary, if no file states it.
    - ``modulo``: travel per turn of an endless axis, deg.
    - ``reference``: machine coordinate of the reference position, mm or deg.
    - ``axis_number``: the control's number of an axis, from 1.
    - ``axis_options``: options of one axis, which override ``options``.

    Other arguments:

    - ``options``: the options of the control.
    - ``active``: whether tables were active that the files switch off or do not mention. None:
      those switched off were not active, the others were.
    - ``carried_out``: every assignment of the programs among the files was executed.
    - ``axes_under_work``: the axes of the job; empty for all axes. Faults of other axes are not
      errors, if the control tolerates them.

    Assumptions are listed in ``assumed`` of the result. Raises UsageError for an unknown format.
    Raises InputError for files that the control would refuse or that contradict themselves.
    """
    maker = _MAKERS.get(format_id)
    if maker is None:
        raise UsageError(
            Fault(
                message="compwright has no virtual control (independent second reader of the "
                "files) for this format",
                expected=" or ".join(KNOWN),
                found=format_id,
                hint="use one of these formats",
            )
        )
    if not files:
        raise InputError(
            Fault(
                message="no file of the control was given",
                expected="the files that the control loads",
                hint="give the files that the control loads",
            )
        )
    request = Request(
        reference_return=dict(reference_return or {}),
        encoder=dict(encoder or {}),
        kinds=dict(kinds or {}),
        modulo=dict(modulo or {}),
        reference=dict(reference or {}),
        active=active,
        carried_out=carried_out,
        options=dict(options or {}),
        axis_options=dict(axis_options or {}),
        axes_under_work=tuple(axes_under_work),
        axis_number=dict(axis_number or {}),
    )
    return maker(files, request)
