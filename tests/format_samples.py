"""What the tests of `formats` share: the installed definitions, and short ways to files, axes and
tables.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from compwright.formats.definitions import definitions_from
from compwright.formats.families.shapes import control_format
from compwright.foundations.session import Session
from compwright.foundations.storage import definition_files
from compwright.records.axis import Axis, AxisKind, Direction, Encoder
from compwright.records.correction import AxisCompensation, ControlFile, ControlState

CONTENT = dict(definition_files(Session()))
DEFINITIONS = definitions_from(CONTENT.items())
#: File names of the definitions of whole controls; what others extend is none by itself.
CONTROLS = [name for name in CONTENT if not name.endswith(".base.yaml")]
SIEMENS = DEFINITIONS["siemens-840d-sl"]
LINUXCNC = DEFINITIONS["linuxcnc"]


def files(**texts: str) -> list[ControlFile]:
    """Control files; ``__`` in a name stands for the point of its ending."""
    return [
        ControlFile(name.replace("__", "."), text.encode("latin-1")) for name, text in texts.items()
    ]


def axis_of(
    address: str,
    *,
    system: int = 1,
    kind: AxisKind = AxisKind.LINEAR,
    returns: Direction = Direction.POSITIVE,
    modulo: float | None = None,
) -> Axis:
    return Axis(
        name="X",
        kind=kind,
        travel=(0.0, 1.0),
        address=address,
        reference_return=returns,
        encoder=Encoder(system=system),
        modulo=modulo,
    )


def table(
    address: str,
    positions: Sequence[float],
    positive: Sequence[float],
    negative: Sequence[float] | None = None,
    *,
    backlash: float = 0.0,
    below: str = "hold",
    kind: AxisKind = AxisKind.LINEAR,
) -> AxisCompensation:
    return AxisCompensation(
        address=address,
        kind=kind,
        positions=np.array(positions, dtype=np.float64),
        positive=np.array(positive, dtype=np.float64),
        negative=np.array(positive if negative is None else negative, dtype=np.float64),
        backlash=backlash,
        below="zero" if below == "zero" else "hold",
    )


def siemens(text: str, *axes: Axis, options: Mapping[str, object] | None = None) -> ControlState:
    return control_format(SIEMENS, {"cec_sign": "correction", **(options or {})}).read(
        files(A__INI=text), axes
    )


def codes(state: ControlState) -> set[str]:
    return {finding.code for finding in state.findings}


def correction(state: ControlState, address: str, position: float, direction: Direction) -> float:
    """Correction in mm or deg at one position."""
    return float(state.axes[address].at(np.array([position]), direction)[0])
