"""Virtual circular tests for `bench_circle.py`: exact positions of both axes in time.

Written from the definitions of the outside contract, apart from the model that is fitted: an axis
follows its command with a first-order lag, stands still or creeps in its friction after a reversal,
and carries its geometric errors; the bar is the distance to the set-up point, filtered by the
bandwidth of the instrument, sampled and rounded.

Values of a machine go by the names of the contract where it has one, in its units (µm, µm/m, ms).
Beside them ``lag_*`` (ms), ``rise_*`` and ``decay_*`` of a spike (s), ``pitch_*`` (mm), ``phase_*``
(rad), ``centre_*`` (mm), ``frequency`` (Hz), ``turn_*`` (µm: half of a spike's height in ccw less
that in cw), ``spiral`` (µm: growth of the radius during a run), ``offset_change_*`` (µm: centre in
ccw less that in cw), ``master_slave`` (µm: step of the radius where the other axis becomes the
faster one).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Final

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

AXES: Final = ("first", "second")
ENDS: Final = ("positive", "negative")
POINTS: Final = tuple(f"{axis}_at_{end}" for axis in AXES for end in ENDS)
TURNS: Final = {"ccw": 1.0, "cw": -1.0}
#: Kinds of arc: (start, extent) deg, starts turned by whole quadrants.
ARCS: Final[Mapping[str, tuple[tuple[float, float], ...]]] = {
    "360": ((0.0, 360.0), (45.0, 360.0)),
    "220": ((-20.0, 220.0), (70.0, 220.0)),
    "180": ((0.0, 180.0), (45.0, 180.0)),
    "90": ((0.0, 90.0), (-5.0, 100.0)),
    "90 between": ((30.0, 90.0), (45.0, 92.0), (70.0, 95.0)),
}
RESOLUTION: Final = 1e-4  # mm
_FINE: Final = 8  # steps of the path per sample where the instrument has a bandwidth
_STUCK: Final = 4  # strokes of a stick-slip motion
_STROKE: Final = 0.05  # s
#: Parameters that shape a cause, by the amplitude without which they do nothing.
SHAPES: Final[Mapping[str, str]] = {
    **{f"decay_{p}": f"reversal_spike_{p}" for p in POINTS},
    **{f"rise_{p}": f"reversal_spike_{p}" for p in POINTS},
    **{f"pitch_{a}": f"cyclic_{a}" for a in AXES},
    **{f"phase_{a}": f"cyclic_{a}" for a in AXES},
    "frequency": "vibration",
    "vibration_phase": "vibration",
}
#: Causes that few machines have: unknowns of the bound only where they are there.
RARE: Final = (
    *("vibration", "stick_slip_first", "stick_slip_second", "master_slave", "spiral"),
    *("offset_change_first", "offset_change_second"),
    *(f"turn_{p}" for p in POINTS),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Circle:
    """A machine (``values``) and how it is measured.

    ``radius`` mm, ``feed`` mm/min, arc in deg, ``samples`` of the arc. ``friction``: ``creep`` (a
    spike rises with a time constant of its own), ``peak`` (rises at once) or ``stand`` (the axis
    stands still until it lags by the spike's height). ``play``: the lost motion is passed through
    gradually while the axis stands still; else it is a step, as of a control's compensation.
    ``bandwidth`` Hz, None without a limit. ``noise`` µm, its correlation of neighbours ``rho``.
    ``overshoot`` deg: the path before the arc.
    """

    values: Mapping[str, float]
    radius: float = 150.0
    feed: float = 1000.0
    start: float = 0.0
    extent: float = 360.0
    kind: str = "360"
    senses: tuple[str, ...] = ("ccw", "cw")
    samples: int = 1500
    friction: str = "creep"
    play: bool = False
    bandwidth: float | None = None
    calibrated: bool = True
    noise: float = 0.2
    rho: float = 0.0
    overshoot: float = 180.0

    @property
    def omega(self) -> float:
        """Angular speed, rad/s."""
        return self.feed / 60.0 / self.radius

    def angles(self, sense: str) -> Array:
        """Return the commanded angles (n,) deg in the order of time."""
        steps = (np.arange(self.samples) + 0.5) * self.extent / self.samples
        return self.start + (steps if sense == "ccw" else self.extent - steps)

    def readings(self, sense: str) -> Array:
        """Return what an instrument without noise and rounding reads, (n,) mm less the radius."""
        step = np.radians(self.extent / self.samples) / self.omega
        fine = 1 if self.bandwidth is None else _FINE
        before = int(np.radians(self.overshoot) / self.omega / step)
        # The last of `fine` steps of each sample lies at the sample.
        ticks = (np.arange((before + self.samples) * fine) + 1) / fine - before - 0.5
        length = _bar(self, ticks * step, sense) - self.radius
        if self.bandwidth is not None:
            kept = float(np.exp(-2.0 * np.pi * self.bandwidth * step / fine))
            from scipy.signal import lfilter  # takes a second to load

            length = lfilter([1.0 - kept], [1.0, -kept], length, zi=[kept * length[0]])[0]
        taken: Array = length[before * fine + fine - 1 :: fine]
        return taken

    def text(self, rng: np.random.Generator) -> str:
        """Return the plain CSV form of one measurement, with fresh noise."""
        lines = [
            "# plane: XY",
            f"# nominal_radius_mm: {self.radius:g}",
            f"# feed_mm_min: {self.feed:g}",
            f"# calibrated: {'yes' if self.calibrated else 'no'}",
            "# centre: 400 400",
            "direction,angle_deg,deviation_um",
        ]
        for sense in self.senses:
            read = self.readings(sense) + 1e-3 * self._noise(rng)
            rounded = np.round(read / RESOLUTION) * RESOLUTION * 1e3
            lines += [
                f"{sense},{angle:.5f},{value:.1f}"
                for angle, value in zip(self.angles(sense), rounded, strict=True)
            ]
        return "\n".join(lines) + "\n"

    def write(self, path: Path, rng: np.random.Generator) -> None:
        """Write one measurement as plain CSV."""
        path.write_text(self.text(rng), encoding="utf-8")

    def _noise(self, rng: np.random.Generator) -> Array:
        drive = self.noise * rng.standard_normal(self.samples)
        drive[1:] *= np.sqrt(1.0 - self.rho**2)
        from scipy.signal import lfilter

        found: Array = lfilter([1.0], [1.0, -self.rho], drive)
        return found

    def truth(self) -> dict[str, float]:
        """Return every cause by its contract name, in its unit.

        The means of both ends, the difference of the lags as angle over speed, the difference of
        the diameters.
        """
        v = self.values
        found = {name: v[name] for name in v if not name.startswith(_OTHERS)}
        lags = [np.arctan(self.omega * v[f"lag_{axis}"] * 1e-3) for axis in AXES]
        found["servo_mismatch"] = float(lags[0] - lags[1]) / self.omega * 1e3
        for axis in AXES:
            for cause in ("backlash", "reversal_spike"):
                found[f"{cause}_{axis}"] = float(
                    np.mean([v[f"{cause}_{axis}_at_{end}"] for end in ENDS])
                )
        for point in POINTS:
            for sense, sign in TURNS.items():
                turned = v[f"reversal_spike_{point}"] + sign * v[f"turn_{point}"]
                found[f"reversal_spike_{point}_{sense}"] = turned
        difference = v["scale_error_first"] - v["scale_error_second"]
        found["scale_mismatch"] = 2e-3 * self.radius * difference
        return found

    def peaks(self) -> dict[str, float]:
        """Return the largest size that each spike reaches in the samples, µm with its sign, mean
        of the directions; NaN where no sample comes near it.
        """
        silent = {f"{kind}_{p}": 0.0 for kind in ("reversal_spike", "turn") for p in POINTS}
        still = replace(self, values={**self.values, **silent})
        found: dict[str, list[float]] = {point: [] for point in POINTS}
        for sense in self.senses:
            more = 1e3 * (self.readings(sense) - still.readings(sense))
            for place, point in enumerate(
                (
                    "first_at_positive",
                    "second_at_positive",
                    "first_at_negative",
                    "second_at_negative",
                )
            ):
                near = np.abs((self.angles(sense) - 90.0 * place + 180.0) % 360.0 - 180.0) < 20.0
                if near.any():
                    inside = more[near]
                    found[point].append(float(inside[np.argmax(np.abs(inside))]))
        return {point: float(np.mean(each)) if each else np.nan for point, each in found.items()}

    def bound(self, *, known: bool = True) -> dict[str, float]:
        """Return the least standard error (Cramér, Rao) of every cause for this noise and all
        unknowns of the machine; very large where the arc does not show a cause.

        ``known``: it is known which of the `RARE` causes the machine has, the friction after its
        reversals, how it passes its lost motion, and the bandwidth of the instrument. Else these
        are unknowns too, of the sizes that `circle` draws (van Trees, Detection, Estimation, and
        Modulation Theory I, 1968, section 2.4).
        """
        open_ = {} if known else {n: size for n, size in self._sizes().items() if n in RARE}
        names = [
            name
            for name, value in self.values.items()
            if (name not in RARE or value or name in open_)
            and (name not in SHAPES or self.values[SHAPES[name]])
        ]
        rows = []
        for sense in self.senses:
            here = self.readings(sense)
            columns = []
            for name in names:
                step = _step(name, self.values[name])
                moved = replace(self, values={**self.values, name: self.values[name] + step})
                columns.append((moved.readings(sense) - here) / step)
            if not known:
                columns += list(self._other_instruments(sense))
            columns.append(np.full(here.shape, 1e-3))  # length of the bar
            jacobian = np.column_stack(columns)
            white = jacobian.copy()
            white[1:] -= self.rho * jacobian[:-1]
            white[1:] /= np.sqrt(1.0 - self.rho**2)
            rows.append(white)
        noise = 1e-3 * np.hypot(self.noise, 1e3 * RESOLUTION / np.sqrt(12.0))
        design = np.vstack(rows) / noise
        if not known:
            priors = np.zeros(design.shape[1])
            priors[len(names) : -1] = 1.0
            for name, size in open_.items():
                priors[names.index(name)] = 1.0 / size
            design = np.vstack([design, np.diag(priors)])
        if self.calibrated:
            design = design[:, :-1]
        return self._derived(names, design)

    def _sizes(self) -> dict[str, float]:
        """Return the standard deviations of the causes that a machine may have without showing it,
        where it has them.
        """
        turns = {f"turn_{p}": 0.17 * abs(self.values[f"reversal_spike_{p}"]) for p in POINTS}
        every = {"spiral": 1.5, "offset_change_first": 1.0, "offset_change_second": 1.0, **turns}
        return {name: size for name, size in every.items() if size > 0.0}

    def _other_instruments(self, sense: str) -> Iterator[Array]:
        """Yield how the readings change, each by one standard deviation, with another friction at
        each reversal point, another way to pass the lost motion, and a slower instrument.
        """
        here = self.readings(sense)
        after = {point: self._after(point, sense) for point in POINTS}
        for friction in {"creep", "peak", "stand"} - {self.friction}:
            change = replace(self, friction=friction).readings(sense) - here
            yield from (np.where(mine, change, 0.0) / 2.0 for mine in after.values())
        change = replace(self, play=not self.play).readings(sense) - here
        yield from (np.where(mine, change, 0.0) / 2.0 for mine in after.values())
        step = np.radians(self.extent / self.samples) / self.omega
        own = 1.0 / (2.0 * np.pi * self.bandwidth) if self.bandwidth else 0.0
        slow = own + max(0.003, 0.3 * step)
        yield replace(self, bandwidth=1.0 / (2.0 * np.pi * slow)).readings(sense) - here

    def _after(self, point: str, sense: str) -> NDArray[np.bool_]:
        """Return whether a sample is on the quarter of the path after a reversal point."""
        axis, end = point.split("_at_")
        start = 90.0 * (axis == "second") + 180.0 * (end == "negative")
        since = TURNS[sense] * (self.angles(sense) - start)
        found: NDArray[np.bool_] = since % 360.0 < 90.0
        return found

    def _derived(self, names: list[str], design: Array) -> dict[str, float]:
        unit: Array = np.maximum(np.linalg.norm(design, axis=0), 1e-12)
        shown = (design / unit).T @ (design / unit) + 1e-13 * np.eye(unit.size)
        covariance = np.linalg.inv(shown) / np.outer(unit, unit)
        found = dict(zip(names, np.sqrt(np.maximum(np.diag(covariance), 0.0)), strict=False))
        mixed: dict[str, dict[str, float]] = {
            f"{cause}_{axis}": {f"{cause}_{axis}_at_{end}": 0.5 for end in ENDS}
            for axis in AXES
            for cause in ("backlash", "reversal_spike")
        }
        each = 2e-3 * self.radius
        mixed["scale_mismatch"] = {"scale_error_first": each, "scale_error_second": -each}
        mixed["servo_mismatch"] = {"lag_first": 1.0, "lag_second": -1.0}
        for name, parts in mixed.items():
            weights = np.zeros(unit.size)
            for part, weight in parts.items():
                weights[names.index(part)] = weight
            found[name] = float(np.sqrt(max(float(weights @ covariance @ weights), 0.0)))
        return {name: float(value) for name, value in found.items()}

    def reverses(self) -> bool:
        """Say whether both axes reverse well inside the arc."""
        first, last = self.start + 3.0, self.start + self.extent - 3.0
        return {k % 2 for k in range(-8, 16) if first < 90 * k < last} == {0, 1}

    def determinable(self, bound: Mapping[str, float]) -> bool:
        """Say whether the test can give the squareness, by what it is made of."""
        both = self.reverses() and len(self.senses) == len(TURNS)
        return both and bound["squareness"] < min(abs(self.values["squareness"]) / 8.0, 7.5)


_OTHERS: Final = (
    "lag_",
    "rise_",
    "decay_",
    "pitch_",
    "phase_",
    "centre_",
    "turn_",
    "vibration_p",
    "frequency",
)


def _step(name: str, value: float) -> float:
    """Return the step of a difference quotient: small by the shape of the cause."""
    if name.startswith(("decay_", "rise_", "pitch_")):
        return 1e-3 * value
    return 1e-4 if name.startswith("frequency") else 1e-3


def _bar(test: Circle, t: Array, sense: str) -> Array:
    """Return the length of the bar (n,) mm at times ``t`` s, 0 at the start of the arc."""
    v, sign, um, ppm = test.values, TURNS[sense], 1e-3, 1e-6
    start = test.start if sense == "ccw" else test.start + test.extent
    commanded = np.radians(start) + sign * test.omega * t
    u, v_um, moves = _axis(test, "first", commanded, sign)
    w, w_um, w_moves = _axis(test, "second", commanded, sign)
    R = test.radius
    x = u * (1.0 + ppm * v["scale_error_first"]) - ppm * v["squareness"] * w + um * v_um
    y = w * (1.0 + ppm * v["scale_error_second"]) + um * w_um
    x = x + um * (v["straightness_second"] * (w / R) ** 2 + v["lateral_play_second"] / 2 * w_moves)
    y = y + um * (v["straightness_first"] * (u / R) ** 2 + v["lateral_play_first"] / 2 * moves)
    faster = np.sign(np.cos(2.0 * commanded))
    x = x + um * v["master_slave"] / 2 * faster * np.cos(commanded)
    y = y + um * v["master_slave"] / 2 * faster * np.sin(commanded)
    centre = [v[f"centre_{a}"] + sign * um / 2 * v[f"offset_change_{a}"] for a in AXES]
    length: Array = np.hypot(x + centre[0], y + centre[1])
    whole = np.radians(test.extent) / test.omega
    length = length + um * (sign * v["radius_change"] + v["spiral"] * (t / whole - 0.5))
    shaken = np.sin(2.0 * np.pi * v["frequency"] * t + v["vibration_phase"])
    return length + um * v["vibration"] * shaken


def _axis(test: Circle, axis: str, commanded: Array, sign: float) -> tuple[Array, Array, Array]:
    """Return where a servo of one axis stands (n,) mm, what its drive adds to it (n,) µm, and the
    sign (n,) in which it moves.
    """
    v, omega = test.values, test.omega
    late = float(np.arctan(omega * 1e-3 * v[f"lag_{axis}"]))
    turned = commanded - sign * late - (0.0 if axis == "first" else np.pi / 2)
    u: Array = test.radius * np.cos(late) * np.cos(turned)
    count = np.floor(sign * turned / np.pi)
    since = (sign * turned / np.pi - count) * np.pi / omega  # s after the last reversal
    end = np.where(np.mod(count, 2) == 0, 1.0, -1.0)  # where that was
    travelled = 1e3 * test.radius * (1.0 - np.cos(omega * since))  # µm of the command
    ends = {name: v[f"backlash_{axis}_at_{name}"] for name in ENDS}
    middle = (ends["positive"] + ends["negative"]) / 2.0
    lost = middle + (ends["positive"] - ends["negative"]) / 2.0 * np.cos(turned)
    passed = np.where(lost > 0.0, np.minimum(travelled, lost), lost) if test.play else lost
    added = end * (passed - lost / 2.0)
    for name, side in (("positive", 1.0), ("negative", -1.0)):
        point = f"{axis}_at_{name}"
        height = v[f"reversal_spike_{point}"] + sign * v[f"turn_{point}"]
        after = np.where(end == side, since, np.inf)
        added = added + side * height * _spike(test, point, height, after, travelled)
    stuck = np.where(since < _STUCK * _STROKE, 1.0 - (since / _STROKE) % 1.0, 0.0)
    added = added + v[f"stick_slip_{axis}"] * end * stuck
    cyclic = v[f"cyclic_{axis}"] * np.cos(2.0 * np.pi * u / v[f"pitch_{axis}"] + v[f"phase_{axis}"])
    return u, added + cyclic, -end


def _spike(test: Circle, point: str, height: float, since: Array, travelled: Array) -> Array:
    """Return the spike of height 1 (n,) after a reversal ``since`` s ago."""
    decay, rise = test.values[f"decay_{point}"], test.values[f"rise_{point}"]
    if test.friction == "peak":
        shape: Array = np.exp(-since / decay)
    elif test.friction == "stand" and height:
        reached = np.arccos(1.0 - 1e-3 * abs(height) / test.radius) / test.omega
        standing = np.isfinite(since) & (since < reached)
        shape = np.where(
            standing,
            travelled / abs(height),
            np.exp(-np.maximum(since - reached, 0.0) / decay),
        )
    else:
        finite = np.where(np.isfinite(since), since, 0.0)
        shape = (1.0 - np.exp(-finite / rise)) * np.exp(-finite / decay)
        top = rise * np.log1p(decay / rise)  # where it is largest
        shape = shape / ((1.0 - np.exp(-top / rise)) * np.exp(-top / decay))
    return np.where(np.isfinite(since), shape, 0.0)


def quiet() -> dict[str, float]:
    """Return the values of a machine without errors."""
    signed = (
        "squareness",
        "radius_change",
        "vibration",
        "vibration_phase",
        "master_slave",
        "spiral",
    )
    values = dict.fromkeys(signed, 0.0)
    each = (
        "scale_error",
        "lag",
        "lateral_play",
        "cyclic",
        "phase",
        "straightness",
        "stick_slip",
        "offset_change",
        "centre",
    )
    values |= {f"{name}_{axis}": 0.0 for name in each for axis in AXES}
    values |= {
        f"{name}_{p}": 0.0 for name in ("backlash", "reversal_spike", "turn") for p in POINTS
    }
    values |= {f"decay_{p}": 0.1 for p in POINTS} | {f"rise_{p}": 0.03 for p in POINTS}
    return values | {"pitch_first": 10.0, "pitch_second": 10.0, "frequency": 20.0}


def circle(rng: np.random.Generator, kind: str, *, both: bool = True) -> Circle:
    """Return a random machine of the sizes met in workshops, measured on an arc of a kind (another
    word: any arc), in both directions or in one.
    """
    if kind in ARCS:
        start, extent = ARCS[kind][int(rng.integers(len(ARCS[kind])))]
        start += float(rng.choice([0.0, 90.0, 180.0, 270.0]))
    else:
        start, extent = float(rng.uniform(0.0, 360.0)), float(rng.uniform(91.0, 355.0))
    radius = float(rng.choice([50.0, 100.0, 150.0, 300.0]))
    feed = float(rng.choice([500.0, 1000.0, 2000.0, 4000.0]))
    per_turn = float(rng.choice([720, 1500, 1500, 3600]))
    samples = round(per_turn * extent / 360.0)  # whole samples fill the arc
    rate = feed / 60.0 / radius * per_turn / (2.0 * np.pi)  # samples a second
    friction = str(rng.choice(["creep", "creep", "peak", "stand"]))
    return Circle(
        values={**quiet(), **dict(_values(rng, feed / 60.0 / radius, rate))},
        radius=radius,
        feed=feed,
        start=start,
        extent=extent,
        kind=kind,
        senses=("ccw", "cw") if both else (str(rng.choice(["ccw", "cw"])),),
        samples=samples,
        friction=friction,
        play=bool(rng.uniform() < 0.5) and friction != "stand",  # the axis stands still once
        bandwidth=None if rng.uniform() < 0.5 else float(rate * rng.uniform(0.1, 2.0)),
        calibrated=bool(rng.uniform() < 0.8),
        noise=float(rng.choice([0.05, 0.15, 0.3, 0.6])),
        rho=float(rng.choice([0.0, 0.0, 0.7, 0.9, 0.97])),
        overshoot=180.0 if extent >= 360.0 else float(rng.choice([20.0, 45.0])),
    )


def _chance(rng: np.random.Generator, share: float) -> bool:
    return bool(rng.uniform() < share)


def _values(rng: np.random.Generator, omega: float, rate: float) -> Iterator[tuple[str, float]]:
    """Yield what is not zero. ``omega`` rad/s, ``rate`` samples a second."""
    u, normal, has = rng.uniform, rng.normal, partial(_chance, rng)
    yield "squareness", float(normal(0.0, 30.0)) if has(0.85) else 0.0
    common = float(rng.choice([0.0, u(0.0, 3.0), u(5.0, 40.0)]))
    for axis in AXES:
        yield f"scale_error_{axis}", float(normal(0.0, 25.0))
        yield f"lag_{axis}", common + (float(abs(normal(0.0, 0.25))) if has(0.7) else 0.0)
        yield f"straightness_{axis}", float(normal(0.0, 2.0)) if has(0.6) else 0.0
        yield f"lateral_play_{axis}", float(normal(0.0, 1.5)) if has(0.5) else 0.0
        yield f"cyclic_{axis}", u(0.2, 2.0) if has(0.4) else 0.0
        yield f"pitch_{axis}", float(rng.choice([5.0, 8.0, 10.0, 16.0, 20.0, u(3.0, 25.0)]))
        yield f"phase_{axis}", u(0.0, 2.0 * np.pi)
        yield f"centre_{axis}", u(-0.1, 0.1)
        yield f"stick_slip_{axis}", u(0.5, 2.0) if has(0.05) else 0.0
        yield f"offset_change_{axis}", float(normal(0.0, 1.0)) if has(0.2) else 0.0
        yield from _reversal(rng, axis, omega)
    yield "radius_change", float(normal(0.0, 0.5)) if has(0.5) else 0.0
    yield "spiral", float(normal(0.0, 1.5)) if has(0.25) else 0.0
    yield "master_slave", u(0.5, 2.0) if has(0.05) else 0.0
    yield "vibration", u(0.2, 1.5) if has(0.15) else 0.0
    yield "frequency", rate * u(0.05, 0.45)
    yield "vibration_phase", u(0.0, 2.0 * np.pi)


def _reversal(rng: np.random.Generator, axis: str, omega: float) -> Iterator[tuple[str, float]]:
    """Yield lost motion and spikes of an axis: alike at both ends, or free at each."""
    u, has = rng.uniform, partial(_chance, rng)
    size = float(rng.choice([0.0, u(0.3, 4.0), u(2.0, 12.0)])) * (-0.4 if has(0.15) else 1.0)
    spread = float(rng.normal(0.0, 0.8)) if has(0.5) else 0.0
    height = float(rng.choice([0.0, u(0.5, 3.0), u(2.0, 9.0)])) * (-0.5 if has(0.1) else 1.0)
    free, turning = has(0.4), has(0.2)
    decay = float(np.exp(u(np.log(0.02), np.log(0.6))))
    decay = min(decay, np.radians(8.0) / omega)
    for end, side in (("positive", 1.0), ("negative", -1.0)):
        point = f"{axis}_at_{end}"
        yield f"backlash_{point}", size + side * spread
        own = height * (float(rng.choice([0.0, u(0.2, 1.6)])) if free else 1.0)
        yield f"reversal_spike_{point}", own
        yield f"turn_{point}", own * u(-0.3, 0.3) if turning else 0.0
        ours = decay * (u(0.6, 1.6) if free else 1.0)
        yield f"decay_{point}", ours
        yield f"rise_{point}", ours * u(0.1, 0.6)
