"""Random plans for every control: a wanted curve, a travel, a reference, options and limits;
fitted, written, read by the judge.

Nothing here knows how a format looks: only what a user would say of the axis, and what the judge
answers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from compwright.controllers.virtual_control import virtual_control
from compwright.controls.control import open_control
from compwright.fitting.fit import fit_table
from compwright.formats.families.shapes import control_format
from compwright.foundations.errors import CapacityError
from compwright.foundations.session import Session
from compwright.records.axis import Axis, AxisKind, Direction, Encoder
from compwright.records.correction import AxisCompensation, ControlFile
from compwright.records.estimate import WantedCorrection
from compwright.records.fitted_table import TableRequest

#: Formats that can write a table without files of the control: what to call the axis, and what to
#: choose at random.
ADDRESSES = {
    "fanuc-30i": "123",
    "fanuc-0i-16i": "123",
    "siemens-840d-sl": ("AX1", "Q_2"),
    "linuxcnc": ("0", "3"),
    "heidenhain-itnc530": "XYZ",
    "heidenhain-nck": "XYZ",
    "pmac": ("1", "2", "32"),
    "isg-kernel": ("1", "12"),
}
#: Doubles carry 1 m to 1e-13 mm, far below every quantum; LinuxCNC keeps its table in single
#: precision: 1 mm to 6e-8 mm. mm or deg.
SAME = {"linuxcnc": 2e-7}
SAME_ELSE = 1e-9


@dataclass(frozen=True)
class Plan:
    """One plan and what became of it: ``refused`` where the control cannot hold it, else the table
    and the files.
    """

    format_id: str
    axis: Axis
    options: Mapping[str, object]
    table: AxisCompensation | None
    files: tuple[ControlFile, ...]
    refused: str = ""


def random_plan(format_id: str, seed: int) -> Plan:
    """Return a plan that is fitted and written, or refused with a sentence; same seed, same
    plan.
    """
    rng = np.random.default_rng([seed, *format_id.encode()])
    options = random_options(format_id, rng)
    axis = random_axis(format_id, rng)
    control = open_control(Session(), format_id, options)
    request = random_request(format_id, axis, rng)
    wanted = random_wanted(axis, rng)
    try:
        capacity = control_format(control.definition, control.options).capacity(axis)
        table = fit_table(wanted, capacity, request, address=axis.address).compensation
        files = control_format(control.definition, control.options).write([table], [axis])
    except CapacityError as error:
        return Plan(format_id, axis, options, None, (), str(error))
    return Plan(format_id, axis, options, table, tuple(files))


def random_options(format_id: str, rng: np.random.Generator) -> dict[str, object]:
    if format_id.startswith("fanuc"):
        chosen: dict[str, object] = {
            "detection_unit": float(rng.choice([0.001, 0.0001, 0.0005, 0.01])),
            "points_from": "reference",
        }
        for name, values in (
            ("output", ("step", "ramp")),
            ("pitch_sign", "+-"),
            ("increment_limit", ("7", "127")),
        ):
            if rng.random() < 0.5:
                chosen[name] = str(rng.choice(np.array(list(values))))
        chosen["first_point"] = int(rng.integers(0, 900)) if rng.random() < 0.3 else 0
        return chosen
    if format_id == "pmac":
        return {"counts_per_unit": float(rng.choice([1000, -2000, 5000, -500, 64000]))}
    if format_id == "linuxcnc":
        return {
            "units": str(rng.choice(["mm", "inch"])),
            "comp_file_type": str(rng.choice(["0", "1"])),
        }
    if format_id.startswith(("heidenhain", "isg")):
        return {"table_values": str(rng.choice(["error", "correction"]))}
    if rng.random() < 0.4:
        return {
            "cec": "available",
            "cec_tables": [3, 8],
            "cec_sign": str(rng.choice(["error", "correction"])),
        }
    return {}


def random_axis(format_id: str, rng: np.random.Generator) -> Axis:
    kind = AxisKind.ROTARY if rng.random() < 0.25 else AxisKind.LINEAR
    if format_id.startswith(
        "heidenhain"
    ):  # of a rotary axis it uses 0 to 360 degrees only, which has tests of its own
        kind = AxisKind.LINEAR
    length = float(rng.integers(30, 360 if kind is AxisKind.ROTARY else 1200))
    low = float(
        rng.choice(
            [0.0, -length, -float(rng.integers(0, int(length))), float(rng.integers(-500, 500))]
        )
    )
    if kind is AxisKind.ROTARY and format_id.startswith("fanuc") and rng.random() < 0.4:
        return replace(axis_at(format_id, rng, kind, (0.0, 360.0), 0.0), modulo=360.0)
    reference = low + float(
        rng.choice([0.0, length, float(rng.integers(0, int(length))), 0.5 * length])
    )
    if format_id.startswith("fanuc") and rng.random() < 0.5 and low <= 0 <= low + length:
        reference = 0.0
    return axis_at(format_id, rng, kind, (low, low + length), reference)


def axis_at(
    format_id: str,
    rng: np.random.Generator,
    kind: AxisKind,
    travel: tuple[float, float],
    reference: float,
) -> Axis:
    return Axis(
        name="X",
        kind=kind,
        travel=travel,
        address=str(rng.choice(list(ADDRESSES[format_id]))),
        reference=reference,
        reference_return=Direction.POSITIVE if rng.random() < 0.5 else Direction.NEGATIVE,
        encoder=Encoder(system=int(rng.integers(1, 3))),
    )


def random_request(format_id: str, axis: Axis, rng: np.random.Generator) -> TableRequest:
    low, high = axis.travel
    if axis.modulo is not None:
        return TableRequest(spacing=float(rng.choice([5, 10, 22.5, 30, 45])))
    if rng.random() < 0.4 or format_id == "linuxcnc":
        return TableRequest(
            mode="bidirectional" if format_id == "linuxcnc" and rng.random() < 0.5 else "auto"
        )
    if format_id.startswith("fanuc"):
        return TableRequest(spacing=float(rng.choice([2, 5, 10, 12.5, 20, 33.333])))
    return TableRequest(spacing=(high - low) / int(rng.choice([10, 20, 25])))


def random_wanted(axis: Axis, rng: np.random.Generator) -> WantedCorrection:
    """Return totals of up to some 100 µm with a reversal, zero at the reference approached in its
    return direction.
    """
    low, high = axis.travel
    where = np.linspace(low, high, 401)
    u = (where - low) / (high - low)
    order = np.arange(1, 7)
    waves = np.sin(np.outer(u, order) * np.pi + rng.uniform(0, 6, 6)) @ (
        rng.standard_normal(6) / order
    )
    slope = rng.uniform(-1e-4, 1e-4) if axis.modulo is None else 0.0
    curve = (
        rng.uniform(0, 0.02) * (np.sin(2 * np.pi * u) if axis.modulo is not None else waves)
        + slope * where
    )
    varying = (
        rng.uniform(0, 0.004) * np.cos(3 * u) if rng.random() < 0.3 and axis.modulo is None else 0.0
    )
    reversal = rng.uniform(-0.01, 0.02) + varying
    own, other = curve, curve + axis.reference_return.opposite.sign * reversal
    zero = np.interp(axis.reference, where, own)
    own, other = own - zero, other - zero
    home = axis.reference_return is Direction.POSITIVE
    return WantedCorrection(
        kind=axis.kind,
        positions=where,
        positive=own if home else other,
        negative=other if home else own,
        reference=axis.reference,
        reference_return=axis.reference_return,
        noise=float(rng.uniform(0.0001, 0.002)),
        reversal_log_odds=float(rng.uniform(-5, 5)),
    )


def judged(plan: Plan, positions: NDArray[np.float64], direction: Direction) -> NDArray[np.float64]:
    """Return what the virtual control adds with the plan's files loaded."""
    axis = plan.axis
    judge = virtual_control(
        plan.format_id,
        plan.files,
        reference_return={axis.address: axis.reference_return},
        modulo={} if axis.modulo is None else {axis.address: axis.modulo},
        kinds={axis.address: axis.kind},
        encoder={axis.address: axis.encoder.system},
        reference={axis.address: axis.reference},
        options=plan.options,
    )
    return judge.correction(axis.address, positions, direction)


def tolerance(format_id: str) -> float:
    """Return up to what difference two corrections are the same, mm or deg."""
    return SAME.get(format_id, SAME_ELSE)


def worst_difference(plan: Plan) -> float:
    """Return by how much the judge differs from the fitted table at its nodes, between them and
    outside; mm or deg.
    """
    table = plan.table
    assert table is not None
    nodes = table.positions
    between = nodes[:-1] + 0.31 * np.diff(nodes)
    beyond = 3.0
    if plan.format_id == "pmac":  # behind three spacings beyond its ends its table repeats
        beyond = min(beyond, 3 * float(nodes[1] - nodes[0]))
    where = (
        np.concatenate([nodes, between, [nodes[0] - beyond, nodes[-1] + beyond]])
        if nodes.size
        else np.array(plan.axis.travel)
    )
    return max(
        float(np.max(np.abs(judged(plan, where, side) - table.at(where, side))))
        for side in Direction
    )
