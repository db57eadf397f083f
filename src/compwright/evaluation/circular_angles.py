"""Check that the angles of both runs of a circular test have the same sense and origin.

If the angles of one run were counted in its direction of travel or from the other axis, squareness
and servo mismatch are exchanged.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from compwright.foundations.findings import Finding
from compwright.foundations.units import MICROMETRES_PER_MILLIMETRE
from compwright.records.axis import FloatArray
from compwright.records.circular import CircularTest
from compwright.words.sentences import Amount

#: Deviations that remain with the angles as given are at least so many times those with one run
#: mirrored or turned: with one centre for both runs, and with a centre for each. A ball that moved
#: between the runs can fulfil the first alone. Mirrored: no false finding in 600 circles and 600
#: arcs of mixed causes, half of them with a moved ball, at most 0.84 of both. Turned: none in 750
#: circles, 2 in 750 whose ball moved by 1 to 100 µm.
_COMMON: Final = 2.0
_OWN: Final = 1.05
#: Less than this, mm, is rounding of computed samples.
_LEAST: Final = 1e-5
#: Samples of a run that are enough.
_SAMPLES: Final = 2000


def wrong_angles(test: CircularTest) -> list[Finding]:
    """Return the finding CW-C014 if a test in both directions fits the causes of ISO 230-4:1996,
    annex B, much better with other angles of the runs in cw: mirrored about 0° or the axis at which
    a full circle begins, or about the middle of an arc; or, on a full circle, turned by a right
    angle.
    """
    if not (test.of("ccw") and test.of("cw")):
        return []
    parts = [(run, slice(None, None, 1 + run.angles.size // _SAMPLES)) for run in test.runs]
    theta = np.concatenate([run.angles[part] for run, part in parts])
    values = np.concatenate([run.deviations[part] for run, part in parts])
    sense = np.concatenate(
        [
            (1.0 if run.sense == "ccw" else -1.0) * np.ones(run.angles[part].size)
            for run, part in parts
        ]
    )
    if test.full_circle:
        # Turned by 180°, the causes keep their signs, and only the ends of the axes are exchanged.
        others = [(True, turn) for turn in (360.0, 90.0, 180.0, 270.0)]
        others += [(False, turn) for turn in (90.0, 270.0)]
    else:
        others = [(True, 2.0 * test.arc[0] + test.arc[1])]
    given = _left(np.radians(theta), sense, values)
    left = []
    for mirrored, turn in others:
        angles = turn - theta if mirrored else turn + theta
        left.append(_left(np.radians(np.where(sense > 0.0, theta, angles)), sense, values))
    (common, own), (mirrored, turn) = min(zip(left, others, strict=True))
    if given[0] < _LEAST or given[0] <= _COMMON * common or given[1] <= _OWN * own:
        return []
    before, after = (Amount(one * MICROMETRES_PER_MILLIMETRE, "µm") for one in (given[0], common))
    if mirrored:
        return [Finding.of("CW-C014.mirrored", "warning", given=before, left=after, turn=turn)]
    return [Finding.of("CW-C014.turned", "warning", given=before, left=after, turn=turn)]


def _left(theta: FloatArray, sense: FloatArray, values: FloatArray) -> tuple[float, float]:
    """Return the root mean square, mm, that the causes leave of the deviations ``values`` (n,) at
    ``theta`` (n,) rad: with one centre for both runs, and with a centre for each. ``sense`` (n,):
    1 in ccw, -1 in cw.
    """
    cos, sin = np.cos(theta), np.sin(theta)
    rows = [np.ones_like(cos), sense, cos, sin, np.cos(2.0 * theta), np.sin(2.0 * theta)]
    rows += [sense * np.sin(2.0 * theta), sense * np.abs(sin), sense * np.abs(cos)]
    for along, step in ((cos, np.sign(sin) * cos), (sin, np.sign(cos) * sin)):
        rows += [sense * step * (along > 0.0), sense * step * (along < 0.0)]
    found = []
    for more in ([], [sense * cos, sense * sin]):
        matrix = np.column_stack([*rows, *more])
        fitted = matrix @ np.linalg.lstsq(matrix, values, rcond=None)[0]
        found.append(float(np.sqrt(np.mean((values - fitted) ** 2))))
    return found[0], found[1]
