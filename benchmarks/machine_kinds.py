"""The kinds of virtual axes that ``table_quality.py`` tries: those that every hall knows, and
others for which nobody made the tool. Each is a function of a generator; sizes are drawn.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from error_curves import bump, hinge, sines, smooth, total, turning
from machines import Machine, dithered, fine, loud, name_seed, plain, untold
from numpy.random import Generator

Kind = Callable[[Generator], Machine]
KINDS: dict[str, Kind] = {}

#: Usual coefficient of expansion
EXPANSION = 11.5  # µm/(m K), of steel


def kind(name: str) -> Callable[[Kind], Kind]:
    """Enter a kind under its name."""

    def enter(function: Kind) -> Kind:
        KINDS[name] = function
        return function

    return enter


def machine_of(name: str, number: int) -> Machine:
    """Return machine ``number`` of a kind; always the same one."""
    return KINDS[name](name_seed(name, number))


def sign(rng: Generator) -> float:
    """Return 1 or -1."""
    return float(rng.choice([-1.0, 1.0]))


# ---- the error curve; noise is white, the pitch told where there is one


@kind("pitch known")
def _known(rng: Generator) -> Machine:
    return plain(rng)


@kind("kink")
def _kink(rng: Generator) -> Machine:
    axis = plain(rng)
    place = axis.low + axis.length * rng.uniform(0.2, 0.8)
    steeper = sign(rng) * rng.uniform(6, 20) / axis.length
    return replace(axis, mean=total(axis.mean, hinge(place, steeper, 13 / axis.length)))


@kind("worn spot")
def _worn(rng: Generator) -> Machine:
    axis = plain(rng)
    place, width = axis.low + axis.length * rng.uniform(0.25, 0.75), axis.length * 0.06
    return replace(
        axis,
        mean=total(axis.mean, bump(place, width, -rng.uniform(2, 8))),
        reversal=total(axis.reversal, bump(place, width, -rng.uniform(1, 5))),
    )


def _varying(axis: Machine, rng: Generator) -> Machine:
    return replace(
        axis,
        reversal=total(axis.reversal, smooth(rng, axis.low, axis.length, rng.uniform(2, 6))),
    )


@kind("varying reversal, two tables")
def _two(rng: Generator) -> Machine:
    return replace(_varying(plain(rng), rng), mode="bidirectional")


@kind("varying reversal, one table")
def _one(rng: Generator) -> Machine:
    return replace(_varying(plain(rng), rng), mode="single")


@kind("few targets")
def _few(rng: Generator) -> Machine:
    axis = plain(rng)
    count = int(rng.integers(7, 12))
    return replace(axis, targets=dithered(rng, axis.low, axis.length, count))


@kind("many targets")
def _many(rng: Generator) -> Machine:
    axis = plain(rng)
    count = int(rng.integers(60, 121))
    return replace(axis, targets=dithered(rng, axis.low, axis.length, count))


# ---- nobody tells the pitch


def _hidden(rng: Generator, pitch: float, size: float, count: int) -> Machine:
    axis = plain(rng, waves=False)
    length = float(np.clip(np.round(pitch * rng.uniform(30, 100), -1), 200, 1200))
    curve = smooth(rng, 0, length, rng.uniform(4, 20))
    return loud(
        replace(
            axis,
            low=0.0,
            high=length,
            mean=total(curve, sines((pitch,), (size,), rng)),
            targets=dithered(rng, 0, length, count),
            periods=(pitch,),
            spacing=fine((pitch,), length),
        ),
        sigma=float(rng.uniform(0.25, 0.6)),
    )


@kind("pitch unknown")
def _unknown(rng: Generator) -> Machine:
    return _hidden(rng, untold(rng), rng.uniform(1, 3), int(rng.integers(12, 31)))


@kind("pitch unknown, 2 µm, 16 targets")
def _unknown_2(rng: Generator) -> Machine:
    return _hidden(rng, untold(rng), 2.0, 16)


@kind("pitch unknown, 1 µm, 12 targets")
def _unknown_1(rng: Generator) -> Machine:
    return _hidden(rng, untold(rng), 1.0, 12)


@kind("pitch unknown, of no catalogue")
def _odd(rng: Generator) -> Machine:
    return _hidden(rng, rng.uniform(4, 30), rng.uniform(1, 3), int(rng.integers(14, 31)))


@kind("two periods unknown")
def _two_periods(rng: Generator) -> Machine:
    first = second = untold(rng)
    while abs(second - first) < 0.1 * first:
        second = untold(rng)
    sizes = (float(rng.uniform(1.5, 3)), float(rng.uniform(1, 2)))
    axis = _hidden(rng, first, sizes[0], int(rng.integers(20, 41)))
    return replace(
        axis,
        mean=total(axis.mean, sines((second,), (sizes[1],), rng)),
        periods=(first, second),
        spacing=fine((first, second), axis.length),
    )


@kind("no period, none told")
def _none(rng: Generator) -> Machine:
    return plain(rng, waves=False)


# ---- noise of real machines


@kind("drift over the runs")
def _drift(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(axis, drift=sign(rng) * axis.noise.sigma * rng.uniform(2, 8))


@kind("drift, another each test")
def _redrawn(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(axis, drift=axis.noise.sigma * rng.uniform(2, 6), redrawn=True)


@kind("scatter, another each test")
def _daily(rng: Generator) -> Machine:
    return loud(plain(rng), daily=float(rng.uniform(0.2, 0.6)))


@kind("drift growing along the travel")
def _expansion(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(axis, expansion=sign(rng) * axis.noise.sigma * rng.uniform(3, 12))


@kind("exponential warm-up")
def _warmup(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(
        axis,
        warmup=sign(rng) * axis.noise.sigma * rng.uniform(3, 10),
        warmup_time=float(rng.uniform(0.15, 0.6)),
        warmup_slope=float(rng.uniform(0, 1)),
    )


@kind("heavy tails (t, 3 dof)")
def _tails(rng: Generator) -> Machine:
    return loud(plain(rng), student=3.0)


@kind("2 % outliers at 8 s")
def _outliers(rng: Generator) -> Machine:
    return loud(plain(rng), outlier_share=0.02, outlier_size=8.0)


@kind("two states of rest")
def _states(rng: Generator) -> Machine:
    return loud(plain(rng), states=float(rng.uniform(1, 3)))


@kind("evenly spread scatter")
def _even(rng: Generator) -> Machine:
    return loud(plain(rng), even=True)


def _moving(part: str, least: float, most: float) -> Kind:
    """Return the kind whose traverses move so many times the scatter of a reading."""

    def made(rng: Generator) -> Machine:
        axis = plain(rng)
        return loud(axis, **{part: axis.noise.sigma * rng.uniform(least, most)})

    return made


kind("shifts between traverses")(_moving("shift", 0.7, 3))
kind("tilts between traverses")(_moving("tilt", 1.5, 5))
kind("random walk between traverses")(_moving("walk", 0.4, 1.5))
kind("shifts between runs")(_moving("run_shift", 0.7, 3))


@kind("a traverse off now and then")
def _off(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(axis, off_share=0.1, off_size=axis.noise.sigma * rng.uniform(2, 6))


@kind("wave of the hall's temperature")
def _wave(rng: Generator) -> Machine:
    axis = plain(rng)
    return loud(axis, wave=axis.noise.sigma * rng.uniform(0.5, 2), waves=float(rng.uniform(0.5, 3)))


def _memory(least: float, most: float) -> Kind:
    """Return the kind whose readings remember so many of those before them."""

    def made(rng: Generator) -> Machine:
        axis = plain(rng)
        size = axis.noise.sigma * float(rng.uniform(0.5, 1.5))
        return loud(axis, memory=size, memory_time=float(rng.uniform(least, most)))

    return made


kind("memory of a few readings")(_memory(1.5, 6))
kind("memory of about a traverse")(_memory(10, 40))


@kind("noise growing along the travel")
def _growing(rng: Generator) -> Machine:
    return loud(plain(rng), growth=float(rng.uniform(1, 4)))


@kind("noise differing by direction")
def _directions(rng: Generator) -> Machine:
    factor = float(rng.uniform(1.7, 4))
    return loud(plain(rng), negative=factor if rng.uniform() < 0.5 else 1 / factor)


@kind("resolution 0.1 µm")
def _resolution(rng: Generator) -> Machine:
    return loud(plain(rng), resolution=0.1, sigma=float(rng.uniform(0.05, 0.4)))


@kind("resolution 1 µm")
def _coarse(rng: Generator) -> Machine:
    return loud(plain(rng), resolution=1.0, sigma=float(rng.uniform(0.3, 1.5)))


@kind("temperature within its uncertainty")
def _temperature(rng: Generator) -> Machine:
    axis = plain(rng)
    kelvin = float(np.round(rng.uniform(0.5, 2.5), 2))
    job = {
        "uncertainty": {"U_theta": kelvin},
        "thermal": {"alpha_m": EXPANSION, "T_m": 20.0, "x_fix": axis.low},
    }
    return loud(replace(axis, job=job), temperature=EXPANSION * kelvin / 2 * axis.length / 1000)


@kind("several at once")
def _several(rng: Generator) -> Machine:
    axis = plain(rng)
    sigma = axis.noise.sigma
    return loud(
        axis,
        shift=sigma * rng.uniform(0.5, 1.5),
        drift=sign(rng) * sigma * rng.uniform(1, 4),
        student=5.0,
        growth=float(rng.uniform(0, 1.5)),
    )


def _with_two_tests(once: Kind) -> Kind:
    """Return the kind whose axes are measured on two days before the table is made."""
    return lambda rng: replace(once(rng), tests=2)


for _name in (
    "drift, another each test",
    "scatter, another each test",
    "two states of rest",
    "evenly spread scatter",
):
    kind(f"{_name}: two tests")(_with_two_tests(KINDS[_name]))


# ---- other tests and axes


@kind("n = 3")
def _three(rng: Generator) -> Machine:
    return replace(plain(rng), runs=3)


@kind("n = 2")
def _twice(rng: Generator) -> Machine:
    return replace(plain(rng), runs=2)


@kind("missing readings")
def _missing(rng: Generator) -> Machine:
    return replace(plain(rng), missing=float(rng.uniform(0.02, 0.12)))


@kind("one direction only")
def _single_direction(rng: Generator) -> Machine:
    return replace(plain(rng), signs=(1,) if rng.uniform() < 0.5 else (-1,))


@kind("long axis, n = 1")
def _long(rng: Generator) -> Machine:
    axis = plain(rng, waves=False)
    length = float(rng.integers(25, 61) * 100)
    count = int(rng.integers(int(length) // 250, int(length) // 120))
    return loud(
        replace(
            axis,
            low=0.0,
            high=length,
            mean=smooth(rng, 0, length, rng.uniform(15, 60)),
            targets=dithered(rng, 0, length, count),
            runs=1,
            spacing=fine((), length),
        ),
        sigma=float(rng.uniform(0.5, 2)),
    )


@kind("endless rotary axis")
def _rotary(rng: Generator) -> Machine:
    waves, size = rng.normal(size=3), float(rng.uniform(1, 8))
    phases = rng.uniform(0, 2 * np.pi, 3)
    period = float(rng.choice([4.0, 5.0, 8.0, 10.0]))
    told = bool(rng.uniform() < 0.5)
    turn = turning(waves * size / np.arange(1, 4), phases, size)
    mean = total(turn, sines((period,), (rng.uniform(0.8, 3),), rng)) if told else turn
    axis = plain(rng, waves=False)
    return replace(
        axis,
        low=0.0,
        high=360.0,
        mean=mean,
        targets=dithered(rng, 0, 360, int(rng.integers(16, 37))),
        rotary=True,
        turn=360.0,
        periods=(period,) if told else (),
        told=(period,) if told else (),
        spacing=1.0,
    )
