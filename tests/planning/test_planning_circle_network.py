"""Circles of one machine in several planes, sizes and feeds, from the physics of that machine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from circular_samples import SENSES, circular_test, plain_run
from compwright.planning.circle_diagnosis import diagnose_circle
from compwright.planning.circle_network import CircleNetwork, network_findings, solve_network
from compwright.planning.circles import CIRCULAR_STANDARD, CircleWork
from planning_samples import circle_of

SQUARENESS = {"XY": 22.0, "YZ": -14.0, "XZ": 9.0}  # um/m
SCALE = {"X": 31.0, "Y": -12.0, "Z": 45.0}  # um/m
LOST = {"X": 3.0, "Y": 1.2, "Z": 5.5}  # um
LOOP = {"X": 32.0, "Y": 30.0, "Z": 41.0}  # ms, first order
#: What a good fit leaves open: um/m, um, ms.
FIT = {"squareness": 0.5, "scale": 0.4, "lost": 0.05, "servo": 0.004}


def circle(
    name: str,
    axes: tuple[str, str] = ("X", "Y"),
    *,
    radius: float = 150.0,
    feed: float = 1000.0,
    calibrated: bool = True,
    off: dict[str, float] | None = None,
    seed: int = 0,
) -> CircleWork:
    """What a circle shows: a lag T shrinks its axis by (ω T)² / 2, ω = v / R; the doubt about it,
    uniform up to Kv = 1000/60, is in the standard error of a single scale.
    """
    rng = np.random.default_rng([seed, *name.encode()])
    omega = feed / 60.0 / radius
    seen = {axis: SCALE[axis] - 1e6 * (omega * 1e-3 * LOOP[axis]) ** 2 / 2.0 for axis in axes}
    mean = sum(seen.values()) / 2.0 + FIT["scale"] * rng.standard_normal()
    difference = seen[axes[0]] - seen[axes[1]] + FIT["scale"] * rng.standard_normal()
    doubt = 1e6 * (omega / (1000.0 / 60.0)) ** 2 / 2.0 / np.sqrt(3.0)
    single = float(np.sqrt(1.25 * FIT["scale"] ** 2 + doubt**2))
    across = 2e-3 * radius
    true = {
        "squareness": (SQUARENESS["".join(sorted(axes))], FIT["squareness"]),
        "scale_mismatch": (across * difference, across * FIT["scale"]),
        "backlash_first": (LOST[axes[0]], FIT["lost"]),
        "backlash_second": (LOST[axes[1]], FIT["lost"]),
        "servo_mismatch": (LOOP[axes[0]] - LOOP[axes[1]], FIT["servo"]),
    }
    effects = {
        cause: (value + error * rng.standard_normal() * (cause != "scale_mismatch"), error)
        for cause, (value, error) in true.items()
    }
    if calibrated:
        effects["scale_error_first"] = (mean + difference / 2.0, single)
        effects["scale_error_second"] = (mean - difference / 2.0, single)
    for cause, more in (off or {}).items():
        effects[cause] = (effects[cause][0] + more, effects[cause][1])
    # The mean and the doubt are common to both scales, half the difference has opposite signs.
    together = 1.0 - 0.5 * FIT["scale"] ** 2 / single**2
    return circle_of(
        effects,
        axes,
        radius=radius,
        feed=feed,
        name=name,
        calibrated=calibrated,
        scales_correlate=together,
    )


FEEDS = [circle("slow", feed=500.0), circle("fast", feed=4000.0)]
PLANES = [
    *FEEDS,
    circle("yz", ("Y", "Z"), feed=500.0),
    circle("yz-fast", ("Y", "Z"), feed=4000.0, radius=100.0),
    circle("zx", ("Z", "X"), radius=300.0, calibrated=False),
]


def solved(circles: list[CircleWork]) -> CircleNetwork:
    return solve_network([work.result for work in circles])


def test_two_feeds_separate_the_loop_from_the_scale() -> None:
    network = solved(FEEDS)
    for axis in "XY":
        scale, shrinking = network.values["scale", axis], network.values["shrinking", axis]
        assert abs(scale.value - SCALE[axis]) < 3.0 * scale.std_error
        assert scale.std_error < 1.0
        expected = 1e6 * (1e-3 * LOOP[axis]) ** 2 / 2.0
        assert abs(shrinking.value - expected) < 3.0 * shrinking.std_error
        assert shrinking.std_error < 0.05 * expected
    assert network.contradictions == {}


def test_one_feed_does_not() -> None:
    """4000 mm/min on 150 mm: the softest loop shrinks 356 µm/m, uniform up to that ± 103."""
    scale = solved([FEEDS[1], circle("again", feed=4000.0)]).values["scale", "X"]
    assert scale.std_error > 60.0


def test_a_scale_that_is_the_mean_of_a_prior_is_not_given() -> None:
    """2000 mm/min on 150 mm: the softest loop shrinks 89 µm/m, so half of it, 44 ± 26, would be
    added to what the circle shows. At 500 mm/min it is 3 ± 1.6.
    """
    fast = solved([circle("once", feed=2000.0), circle("again", feed=2000.0)])
    assert fast.values_of("scale") == {}
    slow = solved([circle("once", feed=500.0), circle("again", feed=500.0)]).values_of("scale")
    assert abs(slow["X"].value - SCALE["X"]) < 3.0 * slow["X"].std_error
    assert set(solved(FEEDS).values_of("scale")) == {"X", "Y"}


def test_three_planes_are_one_machine() -> None:
    network = solved(PLANES)
    for kind, true in (("squareness", SQUARENESS), ("scale", SCALE), ("lost motion", LOST)):
        found = network.values_of(kind)
        assert set(found) == set(true)
        for name, value in true.items():
            assert abs(found[name].value - value) < 3.0 * found[name].std_error, (kind, name)
    assert network.contradictions == {}
    (finding,) = network_findings(PLANES)
    assert finding.code == "CW-P135"
    assert "Time constant of the position loop: " in finding.message
    assert "Z +4" in finding.message.partition("position loop: ")[2]
    assert "± 0.0 " not in finding.message  # 0.03 µm of a lost motion
    assert max(map(len, finding.message.replace(":", ".").split(". "))) < 120


@pytest.mark.parametrize(
    ("cause", "more", "kind", "axes"),
    [
        ("backlash_first", 1.0, "lost motion", "X"),
        ("backlash_second", 1.0, "lost motion", "Y"),
        ("scale_error_first", 8.0, "scale", "XYZ"),
        ("scale_mismatch", 3.0, "scale", "XYZ"),
        ("servo_mismatch", 0.1, "servo mismatch", "XYZ"),
    ],
)
def test_a_circle_that_contradicts_the_others_is_named(
    cause: str, more: float, kind: str, axes: str
) -> None:
    """Every kind has more circles than unknowns here; servo mismatches close around the planes.
    Lost motion of one axis says nothing of the others.
    """
    wrong = [*PLANES, circle("odd", feed=1500.0, off={cause: more})]
    assert list(solved(wrong).contradictions) == [(kind, axes if kind == "lost motion" else "")]
    (found,) = [each for each in network_findings(wrong) if each.code == "CW-P136"]
    assert "odd" in found.message
    assert sorted(found.axes) == [*axes]


def test_arcs_state_how_uncertain_their_mean_scale_is() -> None:
    """An arc of 220° in which one axis reverses once hardly separates the radius from the scale
    mismatch. The machine has squareness, lost motion and white noise alone, no scale error.
    """
    seen = []
    for start in (-20.0, 160.0):
        for seed in range(3):
            rng = np.random.default_rng([seed, int(start) + 20])
            runs = []
            for sense, way in zip(SENSES, (1.0, -1.0), strict=True):
                angles = start + 220.0 * (np.arange(1000) + 0.5)[:: int(way)] / 1000.0
                cos, sin = np.cos(np.radians(angles)), np.sin(np.radians(angles))
                lost = np.sign(sin) * cos - 1.5 * np.sign(cos) * sin
                path = way * lost - 6.0 * cos * sin + rng.normal(0.0, 0.2, 1000)
                runs.append(plain_run(sense, angles, path))
            test = circular_test(runs, radius=150.0, arc=(start % 360.0, 220.0))
            seen.append(diagnose_circle(replace(test, name=f"{start} {seed}"), CIRCULAR_STANDARD))
    network = solve_network(seen)
    assert ("scale", "") not in network.contradictions
    found = [network.values["scale", axis] for axis in "XY"]
    assert all(abs(each.value) < 3.0 * each.std_error for each in found)


def test_consistent_circles_rarely_contradict_each_other() -> None:
    """A kind is named beyond 3.09 standard deviations: one of a thousand consistent machines."""
    named = [
        kind
        for seed in range(40)
        for kind in solved(
            [
                circle("slow", feed=500.0, seed=seed),
                circle("fast", feed=4000.0, seed=seed),
                circle("mid", feed=1500.0, seed=seed),
                circle("yz", ("Y", "Z"), seed=seed),
                circle("zx", ("Z", "X"), seed=seed),
            ]
        ).contradictions
    ]
    assert len(named) <= 2  # of 240: four kinds, squareness by plane


@pytest.mark.parametrize("feed", [500.0, 3e4, 1e6])
def test_circles_without_noise_have_finite_values(
    feed: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    for kind in FIT:
        monkeypatch.setitem(FIT, kind, 1e-12)
    network = solved([circle(name, feed=feed) for name in ("one", "two", "three")])
    values = network.values["squareness", "XY"], network.values["lost motion", "X"]
    assert [each.value for each in values] == pytest.approx([SQUARENESS["XY"], LOST["X"]], rel=1e-4)
    assert all(0.0 < each.std_error < 1e3 for each in network.values.values())
    assert network.contradictions == {}


def test_one_circle_or_other_states_are_no_network() -> None:
    assert list(network_findings(FEEDS[:1])) == []
    assert list(network_findings([])) == []
