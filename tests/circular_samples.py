"""Circular tests to evaluate: an exact machine and the real ballbar files by a reader of its
own.
"""

from __future__ import annotations

import csv
import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from compwright.records.circular import CircularRun, CircularTest, Sense

Array = NDArray[np.float64]
#: Actual position (n, 2) mm about the programmed centre, from commanded polar angle (n,) rad,
#: radius mm and sense.
Machine = Callable[[Array, float, Sense], Array]
UM = 1e-3  # mm
SENSES: tuple[Sense, ...] = ("ccw", "cw")


def perfect(angle: Array, radius: float, sense: Sense) -> Array:
    """Return the commanded position itself."""
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def radial(function: Callable[[Array, Sense], Array]) -> Machine:
    """Return a machine whose path deviates by ``function(angle, sense)`` mm along the radius."""

    def machine(angle: Array, radius: float, sense: Sense) -> Array:
        distance = radius + function(angle, sense)
        return np.column_stack([distance * np.cos(angle), distance * np.sin(angle)])

    return machine


def angles_of(sense: Sense, n: int, arc: tuple[float, float]) -> Array:
    """Return commanded angles (deg) at half steps, in the order of the traverse."""
    steps = (np.arange(n) + 0.5) * arc[1] / n
    return arc[0] + steps if sense == "ccw" else arc[0] + arc[1] - steps


def run_of(
    machine: Machine,
    sense: Sense,
    *,
    radius: float = 100.0,
    n: int = 720,
    arc: tuple[float, float] = (0.0, 360.0),
    offset: tuple[float, float] = (0.0, 0.0),
    number: int = 1,
) -> CircularRun:
    """Measure one traverse: the distance from a set-up centre that lies minus ``offset`` (mm)
    beside the programmed one.
    """
    angles = angles_of(sense, n, arc)
    position = machine(np.radians(angles), radius, sense) + np.array(offset)
    return CircularRun(
        sense=sense,
        angles=angles,
        deviations=np.hypot(position[:, 0], position[:, 1]) - radius,
        number=number,
    )


def plain_run(
    sense: Sense, angles: ArrayLike, deviations: ArrayLike, number: int = 1
) -> CircularRun:
    """Return a run from plain lists: angles in deg, deviations in µm."""
    return CircularRun(
        sense=sense,
        angles=np.array(angles, dtype=np.float64),
        deviations=np.array(deviations, dtype=np.float64) * UM,
        number=number,
    )


def circular_test(
    runs: Sequence[CircularRun],
    *,
    radius: float = 100.0,
    arc: tuple[float, float] = (0.0, 360.0),
    feed: float = 1000.0,
    calibrated: bool = True,
) -> CircularTest:
    """Return a test of these runs in the XY plane."""
    return CircularTest(
        name="circle",
        plane="XY",
        axes=("X", "Y"),
        nominal_radius=radius,
        feed=feed,
        arc=arc,
        calibrated=calibrated,
        runs=tuple(runs),
    )


def measured(
    machine: Machine,
    *,
    radius: float = 100.0,
    n: int = 720,
    arc: tuple[float, float] = (0.0, 360.0),
    offset: tuple[float, float] = (0.0, 0.0),
    calibrated: bool = True,
) -> CircularTest:
    """Return a test of one traverse in each direction."""
    runs = [run_of(machine, sense, radius=radius, n=n, arc=arc, offset=offset) for sense in SENSES]
    return circular_test(runs, radius=radius, arc=arc, calibrated=calibrated)


def ballbar_file(path: Path) -> tuple[CircularTest, dict[str, dict[str, float]]]:
    """Return test and printed ISO 230-4 results (edition -> name -> µm) of a ``.b5r``; for the
    three real files only.
    """
    root = ET.fromstring(path.read_text("utf-8-sig"))  # noqa: S314  three known files
    start, end, length, feed = (
        float(_text(root, name))
        for name in ("START_ANGLE", "END_ANGLE", "NOMINAL_LENGTH", "PROGRAMMED_FEEDRATE")
    )
    arc = (start % 360.0, (end - start) % 360.0 or 360.0)
    runs = []
    for entry in root.iter("BALLBAR_RUN"):
        begin, last = int(_text(entry, "START_INDEX")), int(_text(entry, "END_INDEX"))
        readings = np.array(_text(entry, "READINGS").split(), dtype=np.float64)[begin : last + 1]
        sense: Sense = "ccw" if _text(entry, "RUN_DIRECTION") == "CCW" else "cw"
        runs.append(
            CircularRun(
                sense=sense, angles=angles_of(sense, readings.size, arc), deviations=readings
            )
        )
    printed = {
        entry.attrib["version"]: {
            feature.attrib["NAME"]: float(feature.text or "nan")
            for feature in entry.iter("FEATURE")
        }
        for entry in root.iter("ANALYSIS")
        if entry.attrib["NAME"] == "ISO230_4"
    }
    return circular_test(runs, radius=length, arc=arc, feed=feed), printed


def _text(entry: ET.Element, name: str) -> str:
    found = entry.find(f".//{name}")
    assert found is not None
    return found.text or ""


def table(path: Path) -> list[dict[str, str]]:
    """Return the rows of a table whose comment lines begin with #."""
    return list(
        csv.DictReader(
            line for line in path.read_text("utf-8").splitlines() if not line.startswith("#")
        )
    )
