"""A simulated circular test as an instrument's file: plain CSV, or ballbar XML (``.b5r``)."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.circular import CircularTest
from compwright.simulation.circular import CirclePlan, CircleRecording, Traverse


def to_circular_csv(test: CircularTest, extra: Mapping[str, str] | None = None) -> bytes:
    """Return ``test`` as plain CSV (UTF-8, LF): angles in deg with six decimals, deviations in µm
    with four. ``extra``: further comment keys with their values.

    The comment keys are those of the test's header, then ``extra``, then those that the test itself
    determines. The rows come run by run, and within a run in the order of time.
    """
    own = {
        "plane": test.plane,
        "nominal_radius_mm": f"{test.nominal_radius:.10g}",
        "feed_mm_min": f"{test.feed:.10g}",
        "calibrated": "yes" if test.calibrated else "no",
    }
    if test.centre is not None:
        own["centre"] = _listed(test.centre)
    keys = {**test.header, **(extra or {}), **own}
    lines = [f"# {key}: {' '.join(text.split())}" for key, text in keys.items()]
    lines.append("direction,run,angle_deg,deviation_um")
    for run in test.runs:
        lines.extend(
            f"{run.sense},{run.number},{angle:.6f},{_micrometres(deviation)}"
            for angle, deviation in zip(run.angles, run.deviations, strict=True)
        )
    return ("\n".join(lines) + "\n").encode()


def _micrometres(deviation: float) -> str:
    text = f"{deviation * MICROMETRES_PER_MILLIMETRE:.4f}"
    return text.removeprefix("-") if float(text) == 0.0 else text


def _listed(centre: tuple[float, ...]) -> str:
    return ", ".join(f"{value:.10g}" for value in centre)


def to_b5r(recording: CircleRecording, extra: Mapping[str, str] | None = None) -> bytes:
    """Return ``recording`` as XML like a ``.b5r`` file (UTF-8 with byte order mark), with readings
    in mm and five decimals. ``extra``: ``machine`` and ``serial`` number, if known.

    The elements of printed results (FEATURE, ANALYSIS) and dates are left out, because a simulation
    has none. The same recording always gives the same bytes.
    """
    plan = recording.plan
    machine = " ".join(
        filter(None, ((extra or {}).get("machine", ""), (extra or {}).get("serial", "")))
    )
    directions = dict.fromkeys(traverse.run.sense.upper() for traverse in recording.traverses)
    lines = [
        '<?xml version="1.0" encoding="utf-8" standalone="yes"?>',
        "<TEST_DOCUMENT>",
        f'  <TEST_SPEC NAME="{escape(plan.name)}" version="2.0">',
        '    <INSTRUMENT MANUFACTURER="compwright" MODEL="virtual ballbar">',
        *_ballbar(plan, tuple(directions)),
        "    </INSTRUMENT>",
        "  </TEST_SPEC>",
        f'  <MACHINE_TESTED NAME="{escape(machine)}" />',
        "  <RUN_RESULTS>",
        *(line for traverse in recording.traverses for line in _run(plan, traverse)),
        "  </RUN_RESULTS>",
        "</TEST_DOCUMENT>",
    ]
    return "\n".join(lines).encode("utf-8-sig")


def _ballbar(plan: CirclePlan, directions: tuple[str, ...]) -> list[str]:
    start, extent = plan.arc[0] % 360.0, plan.arc[1]
    end = 360.0 if (start, extent) == (0.0, 360.0) else (start + extent) % 360.0
    first, second = map(escape, plan.axes)
    inner = [
        f"<NOMINAL_LENGTH>{plan.radius:.10g}</NOMINAL_LENGTH>",
        f"<PROGRAMMED_FEEDRATE>{plan.feed:.10g}</PROGRAMMED_FEEDRATE>",
        f"<START_ANGLE>{start:.10g}</START_ANGLE>",
        f"<END_ANGLE>{end:.10g}</END_ANGLE>",
        f"<OVERSHOOT_ANGLE>{plan.overshoot:.10g}</OVERSHOOT_ANGLE>",
        f"<TEST_RADIUS>{plan.radius:.10g}</TEST_RADIUS>",
        f'<PLANE VIEW="+A+B" TEST_PLANE="{first}{second}">',
        f"  <A_AXIS_NAME>{first}</A_AXIS_NAME>",
        f"  <B_AXIS_NAME>{second}</B_AXIS_NAME>",
        "</PLANE>",
        "<RUN_SPEC>",
        *(f"  <RUN_DIRECTION>{direction}</RUN_DIRECTION>" for direction in directions),
        "</RUN_SPEC>",
        f"<CENTRE>{_listed(plan.centre)}</CENTRE>",
        f"<SAMPLE_RATE>{plan.rate:.10g}</SAMPLE_RATE>",
    ]
    opening = "<DYNAMIC_BALLBAR" + (' CALIBRATION_REQUIRED="true">' if plan.calibrated else ">")
    return [f"      {opening}", *(f"        {line}" for line in inner), "      </DYNAMIC_BALLBAR>"]


def _run(plan: CirclePlan, traverse: Traverse) -> list[str]:
    readings = " ".join(f"{reading:+.5f}" for reading in traverse.readings)
    return [
        "    <BALLBAR_RUN>",
        f"      <RUN_DIRECTION>{traverse.run.sense.upper()}</RUN_DIRECTION>",
        f"      <START_INDEX>{traverse.start}</START_INDEX>",
        f"      <END_INDEX>{traverse.end}</END_INDEX>",
        f"      <SAMPLE_RATE>{plan.rate:.10g}</SAMPLE_RATE>",
        f"      <READINGS>{readings}</READINGS>",
        "    </BALLBAR_RUN>",
    ]
