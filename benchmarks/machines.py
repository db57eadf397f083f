"""Virtual axes by kind for ``table_quality.py``: known error, known noise, numpy alone.

Made a second time, apart from the package's own simulation, so that both cannot be wrong together.
Positions in mm (deg), deviations in µm (arcsec), deviation = measured minus target. Signs of
direction: +1, -1. Readings of a test have the shape (2, m, n): +, then -; NaN where none was made.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from error_curves import Curve, constant, sines, smooth, total
from numpy.random import Generator
from numpy.typing import NDArray

Floats = NDArray[np.float64]

#: Leads of screws that jobs tell, mm.
PITCHES = (5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0)
#: Leads that nobody tells: a catalogue's in mm, and in parts of an inch.
METRIC = (2, 2.5, 3, 4, 5, 6, 8, 10, 12, 15, 16, 20, 25, 30, 32, 40, 50)
INCH = (0.2, 0.25, 0.5, 1.0)


@dataclass(frozen=True, kw_only=True)
class Noise:
    """What a reading shows beside the error curve; µm unless said otherwise.

    ``sigma``: standard deviation of a reading at the low end in + (scale of Student's t where
    ``student`` gives its degrees of freedom); ``negative``: its factor in -; ``growth``: it is
    1 + growth times as large at the high end. ``outlier_size`` in sigma, either sign. ``states``:
    half their distance in sigma, where an axis comes to rest on one of two sides; ``even``: scatter
    of the same standard deviation, evenly spread. ``shift``
    and ``tilt`` (over the travel): drawn per traverse; ``walk``: step from a traverse to the next;
    ``run_shift``: drawn per run; ``off_share`` of the traverses lie ``off_size`` off, either side.
    ``wave``: in time, ``waves`` of them in a test, amplitude and phase drawn per test. ``memory``:
    standard deviation of what decays from reading to reading as exp(-t / ``memory_time``), t in
    readings.
    ``drift``, ``expansion`` (at the far end, none at the low one): grown from the first reading to
    the last, linear in time, the same in each test unless ``redrawn`` (then a standard deviation).
    ``daily``: standard deviation of the logarithm by which ``sigma`` is another in each test.
    ``warmup`` grows as 1 - exp(-t / ``warmup_time``), t = 1 at the end of the test; of it
    ``warmup_slope`` grows along the travel. ``temperature``: standard deviation of a slope per
    test, over the travel.
    """

    sigma: float
    negative: float = 1.0
    growth: float = 0.0
    student: float = 0.0
    outlier_share: float = 0.0
    outlier_size: float = 0.0
    states: float = 0.0
    even: bool = False
    shift: float = 0.0
    tilt: float = 0.0
    walk: float = 0.0
    run_shift: float = 0.0
    off_share: float = 0.0
    off_size: float = 0.0
    wave: float = 0.0
    waves: float = 1.0
    memory: float = 0.0
    memory_time: float = 1.0
    drift: float = 0.0
    expansion: float = 0.0
    redrawn: bool = False
    daily: float = 0.0
    warmup: float = 0.0
    warmup_time: float = 1.0
    warmup_slope: float = 0.0
    temperature: float = 0.0
    resolution: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Machine:
    """One axis with its first test and the wishes of its job.

    ``mean``: error arriving in +; ``reversal``: B, mean(+) less mean(-); both functions of
    position. ``tests``: how many are made before the table. ``periods``: of the periodic errors in
    it, largest first; ``told``: what the job says.
    """

    low: float
    high: float
    mean: Curve
    reversal: Curve
    noise: Noise
    targets: Floats
    runs: int = 5
    tests: int = 1
    turn: float | None = None
    rotary: bool = False
    signs: tuple[int, ...] = (1, -1)
    missing: float = 0.0
    periods: tuple[float, ...] = ()
    told: tuple[float, ...] = ()
    spacing: float = 10.0
    mode: str = "auto"
    job: Mapping[str, Any] = field(default_factory=dict)

    @property
    def length(self) -> float:
        """Travel."""
        return self.high - self.low

    def error(self, x: Floats) -> Floats:
        """Error (2, len(x)) in + and in -."""
        return np.stack([self.mean(x), self.mean(x) - self.reversal(x)])

    def new_targets(self, rng: Generator) -> Floats:
        """As many targets, dithered anew: the rule of ``predicted_new_targets``."""
        m = self.targets.size
        steps = np.arange(m) + 0.5 + rng.uniform(-0.3, 0.3, m)
        x = np.clip(self.low + steps * self.length / m, self.low + 4, self.high - 4)
        return np.round(x, 3)

    def temperature(self, rng: Generator) -> float:
        """Draw what the temperature of a test adds over the travel, µm."""
        return float(self.noise.temperature * rng.standard_normal())

    def measure(self, x: Floats, rng: Generator, warm: float = 0.0) -> Floats:
        """Readings (2, m, n) of a test at ``x``, before the instrument's resolution."""
        return self.error(x)[:, :, None] + self.scatter(x, rng, warm)

    def times(self, m: int) -> Floats:
        """When each of the readings (2, m, n) is made, 0 to 1, in the standard cycle: up through
        all targets, down, and again.
        """
        order = np.stack([np.arange(m), m + np.arange(m)[::-1]])[:, :, None]
        return np.asarray((order + 2 * m * np.arange(self.runs)) / (2 * m * self.runs - 1))

    def scales(self, u: Floats) -> Floats:
        """Size of white noise (2, m, 1) at ``u`` (m,), 0 to 1 along the travel."""
        factor = np.array([1, self.noise.negative])[:, None, None]
        return np.asarray(self.noise.sigma * (1 + self.noise.growth * u[:, None]) * factor)

    def scatter(self, x: Floats, rng: Generator, warm: float = 0.0) -> Floats:
        """All that readings (2, m, n) show beside the error. ``warm``: see ``temperature``."""
        noise = self.noise
        u = (x - self.low) / self.length
        shape = (2, x.size, self.runs)
        if noise.student:
            random = rng.standard_t(noise.student, shape)
        elif noise.even:
            random = rng.uniform(-np.sqrt(3), np.sqrt(3), shape)
        else:
            random = rng.standard_normal(shape)
        if noise.states:
            random = random + noise.states * rng.choice([-1.0, 1.0], shape)
        hit = rng.uniform(size=shape) < noise.outlier_share
        random = random + hit * noise.outlier_size * rng.choice([-1.0, 1.0], shape)
        if noise.daily:
            random = random * np.exp(noise.daily * rng.standard_normal())
        beside = self._traverses(u[:, None], rng) + self._in_time(u, rng) + warm * u[:, None]
        datum = 20 * rng.standard_normal()
        return np.asarray(self.scales(u) * random + beside + datum)

    def _traverses(self, u: Floats, rng: Generator) -> Floats:
        noise, n = self.noise, self.runs
        steps = rng.standard_normal((n, 2))
        walk = noise.walk * np.cumsum(steps.ravel()).reshape(n, 2).T
        shift = noise.shift * rng.standard_normal((2, n)) + walk
        tilt = noise.tilt * rng.standard_normal((2, n))
        if noise.run_shift:
            shift = shift + noise.run_shift * rng.standard_normal(n)
        if noise.off_share:
            off = rng.uniform(size=(2, n)) < noise.off_share
            shift = shift + off * noise.off_size * rng.choice([-1.0, 1.0], (2, n))
        return np.asarray(shift[:, None, :] + tilt[:, None, :] * (u - 0.5))

    def _in_time(self, u: Floats, rng: Generator) -> Floats:
        factors = rng.standard_normal(2) if self.noise.redrawn else np.ones(2)
        drift = self.in_time(u, self.noise.drift * factors[0], self.noise.expansion * factors[1])
        if self.noise.wave:
            a, b = self.noise.wave * rng.standard_normal(2)
            angle = 2 * np.pi * self.noise.waves * self.times(u.size)
            drift = drift + a * np.sin(angle) + b * np.cos(angle)
        if self.noise.memory:
            steps = rng.standard_normal(2 * u.size * self.runs)
            drift = drift + self.remembered(u.size, steps)
        return drift

    def remembered(self, m: int, steps: Floats) -> Floats:
        """What stays of earlier readings: a process of the first order in the order of the readings
        (2, m, n), made of standard normal ``steps`` (2 m n,).
        """
        kept = float(np.exp(-1 / self.noise.memory_time))
        series = np.empty_like(steps)
        series[0] = steps[0]
        for i in range(1, steps.size):
            series[i] = kept * series[i - 1] + np.sqrt(1 - kept**2) * steps[i]
        order = np.argsort(self.times(m).ravel())
        found = np.empty_like(series)
        found[order] = self.noise.memory * series
        return found.reshape(2, m, self.runs)

    def in_time(self, u: Floats, drift: float, expansion: float) -> Floats:
        """What drift, expansion and warming up add to readings (2, m, n) at ``u`` (m,)."""
        noise, time, along = self.noise, self.times(u.size), u[:, None]
        warm = noise.warmup * (1 - np.exp(-time / noise.warmup_time))
        warm = warm * (1 - noise.warmup_slope + noise.warmup_slope * along)
        return np.asarray((drift + expansion * along) * time + warm)

    def seen(self, readings: Floats) -> Floats:
        """Return them as the instrument shows them: in whole steps of its resolution."""
        step = self.noise.resolution
        return np.round(readings / step) * step if step else readings


def dithered(rng: Generator, low: float, length: float, count: int) -> Floats:
    """Targets as ISO 230-2:2006 clause 4.2 wants them: equal intervals plus a random part."""
    steps = np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)
    return np.asarray(np.round(low + steps * length / count, 3))


def untold(rng: Generator) -> float:
    """Draw a period that nobody tells, mm: seven in ten of `METRIC`, one of `INCH`, two of no
    catalogue, between 4 and 30 evenly in the logarithm.
    """
    metric, inch = 0.7, 0.1
    place = float(rng.uniform())
    if place < metric:
        return float(METRIC[int(place / metric * len(METRIC))])
    if place < metric + inch:
        return 25.4 * INCH[int((place - metric) / inch * len(INCH))]
    return float(4 * 7.5 ** ((place - metric - inch) / (1 - metric - inch)))


def fine(periods: tuple[float, ...], length: float) -> float:
    """A spacing of the table that holds the shortest period, at least travel / 1000."""
    wanted = min([*(p / 5 for p in periods), length / 50])
    usual = np.array([0.5, 1, 2, 2.5, 5, 10, 20, 50])
    usual = usual[(usual >= length / 1000) & (length % usual == 0)]
    return float(max(usual[usual <= wanted], default=usual.min()))


def plain(rng: Generator, *, waves: bool = True) -> Machine:
    """An axis of a machining centre: slope and bow, lost motion, white noise, and (three in four)
    a periodic error of a pitch that the job tells.
    """
    length = float(rng.integers(30, 121) * 10)
    low = float(rng.choice([0.0, -length, -length / 2]))
    count = int(rng.integers(max(11, int(length) // 60), max(16, int(length) // 25) + 1))
    pitch = float(rng.choice(PITCHES[:] if length < 900 else PITCHES[2:]))
    size = float(rng.uniform(0.4, 2.5)) if waves and rng.uniform() < 0.75 else 0.0
    curve = smooth(rng, low, length, rng.uniform(4, 20))
    return Machine(
        low=low,
        high=low + length,
        mean=total(curve, sines((pitch,), (size,), rng)),
        reversal=constant(-float(rng.uniform(0.5, 8))),
        noise=Noise(sigma=float(rng.uniform(0.25, 1.0))),
        targets=dithered(rng, low, length, count),
        periods=(pitch,) if size else (),
        told=(pitch,) if waves else (),
        spacing=fine((pitch,) if waves else (), length),
    )


def name_seed(kind: str, *numbers: int) -> Generator:
    """Return the generator of a kind and its numbers, the same on every machine."""
    return np.random.default_rng([zlib.crc32(kind.encode()), *numbers])


def loud(machine: Machine, **noise: Any) -> Machine:
    """Return the machine with more in its noise."""
    return replace(machine, noise=replace(machine.noise, **noise))
