"""Circular tests to ISO 230-4: real ballbar files, exact machines with known errors, figures worked
by hand.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from circular_samples import (
    SENSES,
    UM,
    Array,
    ballbar_file,
    circular_test,
    measured,
    perfect,
    plain_run,
    radial,
    run_of,
    table,
)
from compwright.evaluation.circular import CIRCULAR_STANDARDS, evaluate_circle
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.provenance import source_of
from compwright.records.circular import CIRCULAR_NAMES, CircularResult, CircularRun, Sense
from places import REAL, SHARED, needs_shared

BALLBAR = REAL / "ballbar"
FILES = [
    "ballbar_demo_100mm_XY.b5r",
    "ballbar_qc20w_150mm_XY.b5r",
    "ballbar_qc20w_150mm_ZX_220deg.b5r",
]
#: Exact machines are compared to this, mm: rounding of the placed points, far below a thousandth of
#: a µm.
EXACT = 1e-9


def value(result: CircularResult, name: str) -> float:
    found = result.parameters[name]
    assert found is not None, result.not_applicable[name]
    return found


def codes(result: CircularResult) -> set[str]:
    return {finding.code for finding in result.findings}


# ---- real files ----


@needs_shared
@pytest.mark.parametrize("file", FILES)
def test_real_files_as_recomputed_elsewhere(file: str) -> None:
    """Centres, mean radius, both kinds of G, F about the least-squares centre and D within 0.05 µm
    (printed to 0.01 µm).
    """
    expected = {row["file"]: row for row in table(BALLBAR / "ballbar_expected.csv")}[file]
    test, _ = ballbar_file(BALLBAR / file)
    result = evaluate_circle(test)
    got = {
        "bidir_G_lsc_um": value(result, "G_bidirectional_lsc"),
        "bidir_mean_dev_um": value(result, "D"),
    }
    for sense in ("ccw", "cw"):
        got |= {
            f"{sense}_cx_um": result.centres[sense][0],
            f"{sense}_cy_um": result.centres[sense][1],
            f"{sense}_mean_dev_um": result.mean_radius_deviation[sense],
            f"{sense}_G_lsc_um": value(result, f"G_{sense}_lsc"),
            f"{sense}_G_mzc_um": value(result, f"G_{sense}"),
            f"{sense}_Fmax_um": value(result, f"F_max_{sense}_lsc"),
            f"{sense}_Fmin_um": value(result, f"F_min_{sense}_lsc"),
        }
    assert {name: round(number / UM, 2) for name, number in got.items()} == pytest.approx(
        {name: float(expected[name]) for name in got}, abs=0.05
    )


@needs_shared
@pytest.mark.parametrize("file", FILES)
@pytest.mark.parametrize("edition", ["1996", "2005"])
def test_real_files_as_the_instrument_printed_them(file: str, edition: str) -> None:
    """The results in the file are about least-squares centres and rounded to 0.1 µm; the readings
    to 0.01 µm.

    The demo file's hysteresis of 0.0 is wrong.
    """
    test, printed = ballbar_file(BALLBAR / file)
    result = evaluate_circle(test, f"iso230-4:{edition}")
    ours = {
        "AF_CIRCULAR_DEVIATION_CCW": "G_ccw_lsc",
        "AF_CIRCULAR_DEVIATION_CW": "G_cw_lsc",
        "AF_MAX_RADIAL_DEVIATION_CCW": "F_max_ccw_lsc",
        "AF_MIN_RADIAL_DEVIATION_CCW": "F_min_ccw_lsc",
        "AF_MAX_RADIAL_DEVIATION_CW": "F_max_cw_lsc",
        "AF_MIN_RADIAL_DEVIATION_CW": "F_min_cw_lsc",
        "AF_CIRCULAR_HYSTERESIS": "H",
        "AF_BIDIRECTIONAL_CIRCULAR_DEVIATION": "G_bidirectional_lsc",
        "AF_MEAN_BIDIRECTIONAL_RADIAL_DEVIATION": "D",
    }
    compared = 0
    for theirs, name in ours.items():
        if theirs in printed[edition] and (name, file) != ("H", FILES[0]):
            assert value(result, name) / UM == pytest.approx(
                printed[edition][theirs], abs=0.05 + 0.005
            ), name
            compared += 1
    assert compared >= (2 if file == FILES[0] else 7)


# ---- exact machines ----


@pytest.mark.parametrize("arc", [(0.0, 360.0), (45.0, 360.0), (300.0, 90.0), (250.0, 220.0)])
@pytest.mark.parametrize("offset", [(0.0, 0.0), (0.3, -0.4), (0.5, 0.0)])
def test_a_perfect_circle_off_centre(arc: tuple[float, float], offset: tuple[float, float]) -> None:
    """R = 50: nothing but the offset remains; laid out at the commanded angles around the set-up
    centre G would be 2.5 µm.
    """
    result = evaluate_circle(measured(perfect, radius=50.0, arc=arc, offset=offset))
    for name in (
        "G_ccw",
        "G_cw",
        "G_bidirectional",
        "G_ccw_lsc",
        "G_bidirectional_lsc",
        "D",
        "F_max_ccw_lsc",
        "F_min_cw_lsc",
    ):
        assert value(result, name) == pytest.approx(0.0, abs=EXACT), name
    for name in ("ccw", "cw", "common"):
        assert result.centres[name] == pytest.approx(offset, abs=EXACT)
    for name in ("ccw", "cw", "both"):
        assert result.zone_centres[name] == pytest.approx(offset, abs=EXACT)
        assert result.zone_radii[name] == pytest.approx((50.0, 50.0), abs=EXACT)
    assert ("CW-C011" in codes(result)) == (offset != (0.0, 0.0))


def test_radius_error() -> None:
    """One direction 3 µm too large, the other 1 µm too small: D is the mean, G of each nothing, of
    both together 4 µm.
    """
    result = evaluate_circle(
        measured(
            radial(lambda angle, sense: np.full(angle.shape, 3 * UM if sense == "ccw" else -1 * UM))
        )
    )
    assert value(result, "D") == pytest.approx(1 * UM, abs=EXACT)
    assert value(result, "G_ccw") == pytest.approx(0.0, abs=EXACT)
    assert value(result, "G_bidirectional") == pytest.approx(4 * UM, abs=EXACT)
    assert value(result, "G_bidirectional_lsc") == pytest.approx(4 * UM, abs=EXACT)
    assert value(result, "F_max_ccw") == pytest.approx(3 * UM, abs=EXACT)
    assert value(result, "F_min_cw") == pytest.approx(-1 * UM, abs=EXACT)
    assert result.mean_radius_deviation == pytest.approx({"ccw": 3 * UM, "cw": -1 * UM}, abs=EXACT)
    assert result.zone_radii["both"] == pytest.approx((99.999, 100.003), abs=EXACT)


def test_scale_error_of_one_axis() -> None:
    """X travels 100 ppm too far over R = 100 mm: an ellipse of half axes 100.01 and 100, so G = 10
    µm, D = 5 µm (B.2.1).
    """

    def machine(angle: Array, radius: float, sense: Sense) -> Array:
        return np.column_stack([1.0001 * radius * np.cos(angle), radius * np.sin(angle)])

    result = evaluate_circle(measured(machine, n=7200, offset=(0.02, 0.01)))
    # second order: the tangential error R e sin 2t/2 = 5 µm turns points, 5e-3²/2R = 1e-7 mm
    for name in ("G_ccw", "G_cw", "G_bidirectional", "G_ccw_lsc", "G_bidirectional_lsc"):
        assert value(result, name) == pytest.approx(0.01, abs=1e-6), name
    assert value(result, "D") == pytest.approx(0.005, abs=1e-6)
    assert value(result, "F_max_cw") == pytest.approx(0.01, abs=1e-6)
    assert value(result, "F_min_cw") == pytest.approx(0.0, abs=1e-6)
    assert value(evaluate_circle(measured(machine), "iso230-4:1996"), "H") == pytest.approx(
        0.0, abs=EXACT
    )


def test_every_sample_counts() -> None:
    """A spike of one sample is in G, F and H (clause 5)."""
    run = run_of(perfect, "ccw")
    run.deviations[100] = 30 * UM
    test = circular_test([run, run_of(perfect, "cw")])
    result, older = evaluate_circle(test), evaluate_circle(test, "iso230-4:1996")
    assert value(result, "G_ccw") == pytest.approx(
        30 * UM, abs=2e-6
    )  # the neighbours 0.5° beside move with the centre
    assert value(result, "F_max_ccw") == pytest.approx(
        30 * UM * (1.0 - 2.0 / 720.0), abs=1e-6
    )  # the centre moves 2/n of the spike
    assert value(older, "H") == pytest.approx(30 * UM, abs=1e-6)


def test_bidirectional_zone_needs_both_runs() -> None:
    """Two ellipses of 4 µm (ccw) that lie across each other: each has G 4 µm about r = 100;
    together ±2 µm again, not more.
    """
    test = measured(
        radial(lambda angle, sense: (2 * UM if sense == "ccw" else -2 * UM) * np.cos(2 * angle)),
        n=1440,
    )
    result = evaluate_circle(test)
    assert value(result, "G_ccw") == pytest.approx(
        4 * UM, abs=1e-7
    )  # the nearest sample is 0.125° from the top: 2 µm 1e-5
    assert value(result, "G_bidirectional") == pytest.approx(4 * UM, abs=1e-7)
    # and at one angle they differ by the whole 4 µm
    assert value(evaluate_circle(test, "iso230-4:1996"), "H") == pytest.approx(4 * UM, abs=1e-7)


# ---- H by hand ----


def hysteresis_of(
    ccw: Sequence[tuple[float, float]], cw: Sequence[tuple[float, float]], arc: tuple[float, float]
) -> float:
    """Return H (µm) of two runs given as (angle deg, deviation µm) in ascending order."""
    downwards = list(reversed(cw))
    runs = [
        plain_run("ccw", [a for a, _ in ccw], [d for _, d in ccw]),
        plain_run("cw", [a for a, _ in downwards], [d for _, d in downwards]),
    ]
    return (
        value(evaluate_circle(circular_test(runs, radius=1000.0, arc=arc), "iso230-4:1996"), "H")
        / UM
    )


def test_hysteresis_between_the_samples() -> None:
    """ccw 8 µm at 91°, 0 elsewhere; cw 0 at 90° and 92°: at 91° the cw path is interpolated.

    The centre moves with the spike, but for both runs alike: at one angle that cancels.
    """
    ccw = [(a, 8.0 if a == 91 else 0.0) for a in range(181)]
    cw = [(a, 0.0) for a in range(0, 181, 2)]
    assert hysteresis_of(ccw, cw, (0.0, 180.0)) == pytest.approx(8.0, abs=1e-3)
    assert hysteresis_of([(a, -d) for a, d in ccw], cw, (0.0, 180.0)) == pytest.approx(
        8.0, abs=1e-3
    )


def test_hysteresis_is_taken_at_the_same_angle() -> None:
    """Both runs follow 0.1 µm per degree; cw is sampled half a degree beside. Compared by index
    they would differ by 0.05 µm.
    """
    ccw = [(a, 0.1 * a) for a in range(181)]
    cw = [(a + 0.5, 0.1 * (a + 0.5)) for a in range(180)]
    # the centre moves by about 10 µm; its cosine bends by 10 (0.5°)²/2 µm between samples
    assert hysteresis_of(ccw, cw, (0.0, 180.0)) == pytest.approx(0.0, abs=1e-3)


def test_hysteresis_where_both_were_measured() -> None:
    """ccw goes on to 180°, where it jumps; cw ends at 170°: the jump has nothing to be compared
    with.
    """
    ccw = [(a, 50.0 if a == 180 else 0.0) for a in range(0, 181, 10)]
    cw = [(a, 0.0) for a in range(0, 171, 10)]
    assert hysteresis_of(ccw, cw, (0.0, 180.0)) == pytest.approx(0.0, abs=1e-3)


def test_hysteresis_across_the_seam_of_a_full_circle() -> None:
    """ccw at 0.2°, 1.2°, ..., cw at 0.8°, ..., 359.8°: a bump at the first ccw sample, then at the
    last cw sample.
    """
    flat = [(a + 0.8, 0.0) for a in range(360)]
    assert hysteresis_of(
        [(a + 0.2, 10.0 if a == 0 else 0.0) for a in range(360)], flat, (0.0, 360.0)
    ) == pytest.approx(10.0, abs=1e-3)
    flat = [(a + 0.2, 0.0) for a in range(360)]
    assert hysteresis_of(
        flat, [(a + 0.8, -7.0 if a == 359 else 0.0) for a in range(360)], (0.0, 360.0)
    ) == pytest.approx(7.0, abs=1e-3)


def test_hysteresis_interpolates_across_the_seam() -> None:
    """cw is 4 µm at 359.8° and 10 µm at 0.8°, so 6.4 µm at 0.2°, where ccw is -10 µm: 16.4 µm. At
    0.8° it is 10 + 4.
    """
    ccw = [(a + 0.2, -10.0 if a == 0 else 0.0) for a in range(360)]
    cw = [(a + 0.8, {0: 10.0, 359: 4.0}.get(a, 0.0)) for a in range(360)]
    assert hysteresis_of(ccw, cw, (0.0, 360.0)) == pytest.approx(16.4, abs=1e-3)


def test_hysteresis_of_an_arc_between_samples_beside_zero() -> None:
    """An arc from 250° to 470°: ccw -9 µm at 360°, where cw has samples half a degree to either
    side.
    """
    ccw = [(float(a), -9.0 if a == 360 else 0.0) for a in range(250, 471)]
    cw = [(a + 0.5, 0.0) for a in range(250, 470)]
    assert hysteresis_of(ccw, cw, (250.0, 220.0)) == pytest.approx(9.0, abs=1e-3)


def test_hysteresis_counts_from_the_common_centre() -> None:
    """Samples 4° and 8° apart, 0.3 mm off centre: about the set-up centre the lines between the
    samples would cut off up to 0.7 µm.

    That is 0.3 mm (4°)²/2. About the centre of the circle there is nothing to cut.
    """
    runs = [
        run_of(perfect, "ccw", n=90, offset=(0.3, 0.0)),
        run_of(perfect, "cw", n=45, offset=(0.3, 0.0)),
    ]
    assert value(evaluate_circle(circular_test(runs), "iso230-4:1996"), "H") == pytest.approx(
        0.0, abs=EXACT
    )


def test_hysteresis_with_both_ends_of_a_circle() -> None:
    """A circle sampled at 0° and at 360°, with lost motion of 6 µm there: both samples count."""
    ccw = [(float(a), 6.0 if a == 360 else 0.0) for a in range(0, 361, 5)]
    cw = [(float(a), 0.0) for a in range(0, 361, 5)]
    assert hysteresis_of(ccw, cw, (0.0, 360.0)) == pytest.approx(6.0, abs=1e-3)
    ccw = [(float(a), 6.0 if a == 0 else 0.0) for a in range(0, 361, 5)]
    assert hysteresis_of(ccw, cw, (0.0, 360.0)) == pytest.approx(6.0, abs=1e-3)


def test_hysteresis_on_an_arc_across_zero() -> None:
    """An arc from 250° to 470° (110°): ccw -9 µm at 360°, cw counted from 470° down and from 110°
    down alike.
    """
    ccw = [(float(a), -9.0 if a == 360 else 0.0) for a in range(250, 471, 10)]
    cw = [(float(a), 0.0) for a in range(250, 471, 10)]
    assert hysteresis_of(ccw, cw, (250.0, 220.0)) == pytest.approx(9.0, abs=1e-3)
    assert hysteresis_of(ccw, [(a - 360.0, d) for a, d in cw], (250.0, 220.0)) == pytest.approx(
        9.0, abs=1e-3
    )


@settings(max_examples=50, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.integers(91, 200),
    st.integers(91, 200),
    st.sampled_from([(0.0, 360.0), (200.0, 270.0)]),
)
def test_hysteresis_against_a_dense_comparison(
    seed: int, n: int, m: int, arc: tuple[float, float]
) -> None:
    """The definition itself: r_ccw - r_cw at 20 000 angles. It finds H from below, to a part of one
    sample interval.

    The set-up centre is the least-squares centre to 1e-4 mm here, which does not matter for a
    difference at one angle.
    """
    rng = np.random.default_rng(seed)
    noise = radial(lambda angle, _: rng.normal(0.0, 1 * UM, angle.size))
    runs = [
        run_of(noise, sense, n=count, arc=arc) for sense, count in zip(SENSES, (n, m), strict=True)
    ]
    found = value(evaluate_circle(circular_test(runs, arc=arc), "iso230-4:1996"), "H")
    dense = np.linspace(arc[0], arc[0] + arc[1], 20001)
    curves = []
    for run in runs:
        order = np.argsort(run.angles)
        angle, deviation = run.angles[order], run.deviations[order]
        if arc[1] < 360.0:
            curves.append(np.interp(dense, angle, deviation, left=np.nan, right=np.nan))
        else:
            curves.append(np.interp(dense, angle, deviation, period=360.0))
    expected = np.nanmax(np.abs(curves[0] - curves[1]))
    assert expected - 0.02 * UM <= found <= expected + 0.1 * UM


# ---- what F counts from ----


def test_radial_deviation_on_an_arc_counts_from_the_set_up_centre() -> None:
    """3.5 a with note 6: on an arc of 90° about 45° an offset of (0.02, 0.02) adds 28.3 µm in the
    middle and 20 µm at the ends.
    """
    result = evaluate_circle(measured(perfect, n=9001, arc=(0.0, 90.0), offset=(0.02, 0.02)))
    assert value(result, "F_max_ccw") == pytest.approx(0.02 * np.sqrt(2.0), abs=1e-8)
    assert value(result, "F_min_ccw") == pytest.approx(
        0.02, abs=5e-6
    )  # the first sample lies 0.005° beside the end; e²/2R 2 nm
    assert value(result, "F_max_ccw_lsc") == pytest.approx(0.0, abs=EXACT)
    assert "CW-C010" in codes(result)


def test_radial_deviation_on_a_full_circle_counts_from_the_least_squares_centre() -> None:
    """3.5 b: the same offset on a full circle is not in F."""
    result = evaluate_circle(measured(perfect, offset=(0.02, 0.02)))
    assert value(result, "F_max_ccw") == pytest.approx(0.0, abs=EXACT)
    assert value(result, "F_min_cw") == pytest.approx(0.0, abs=EXACT)
    assert "CW-C010" not in codes(result)


def test_radial_deviation_keeps_its_sign() -> None:
    """Positive is away from the centre (note 5): cos 3t of 5 µm on a circle that is 2 µm too
    small.
    """
    result = evaluate_circle(
        measured(radial(lambda angle, _: 5 * UM * np.cos(3 * angle) - 2 * UM), n=3600)
    )
    assert value(result, "F_max_ccw") == pytest.approx(3 * UM, abs=1e-7)
    assert value(result, "F_min_ccw") == pytest.approx(-7 * UM, abs=1e-7)


# ---- editions, directions, bars, runs ----


@needs_shared
def test_the_names_are_the_contracts() -> None:
    text = (SHARED / "contract.md").read_text("utf-8")
    block = text[text.index('"parameters": {"G_ccw"') :]
    assert tuple(re.findall(r'"(\w+)"', block[: block.index("}")])[1:]) == CIRCULAR_NAMES


def test_what_each_edition_defines() -> None:
    test = measured(perfect)
    older, newer = evaluate_circle(test, "iso230-4:1996"), evaluate_circle(test)
    assert newer.standard == "iso230-4:2005"
    assert set(older.not_applicable) == {"G_bidirectional", "G_bidirectional_lsc", "D"}
    assert set(newer.not_applicable) == {"H"}
    shared = set(CIRCULAR_NAMES) - {"H", "D", "G_bidirectional", "G_bidirectional_lsc"}
    assert {name: older.parameters[name] for name in shared} == {
        name: newer.parameters[name] for name in shared
    }
    assert older.diagnosis is None


@pytest.mark.parametrize("standard", CIRCULAR_STANDARDS)
@pytest.mark.parametrize("calibrated", [True, False])
@pytest.mark.parametrize("senses", [("ccw",), ("cw",), ("ccw", "cw")])
def test_a_missing_parameter_has_its_reason(
    standard: str, calibrated: bool, senses: tuple[Sense, ...]
) -> None:
    test = circular_test([run_of(perfect, sense) for sense in senses], calibrated=calibrated)
    result = evaluate_circle(test, standard)
    assert tuple(result.parameters) == CIRCULAR_NAMES
    assert {name for name, number in result.parameters.items() if number is None} == set(
        result.not_applicable
    )
    assert all(result.not_applicable.values())
    for name in CIRCULAR_NAMES:
        for sense in {"ccw", "cw"} - set(senses):
            if sense in name.split("_"):
                assert sense in result.not_applicable[name]


def test_one_direction_only() -> None:
    result = evaluate_circle(circular_test([run_of(perfect, "cw")]))
    given = {name for name, number in result.parameters.items() if number is not None}
    assert given == {"G_cw", "G_cw_lsc", "F_max_cw", "F_min_cw", "F_max_cw_lsc", "F_min_cw_lsc"}
    assert (
        set(result.centres) == set(result.mean_radius_deviation) == set(result.zone_radii) == {"cw"}
    )
    assert result.not_applicable["D"] == "the test was not measured in the ccw direction"
    assert codes(result) == {"CW-C002"}


def test_a_bar_that_was_not_calibrated() -> None:
    """F needs the length of the bar (4.5), G and H do not (3.4 note 3)."""
    result = evaluate_circle(
        measured(radial(lambda angle, _: np.full(angle.shape, 2 * UM)), calibrated=False)
    )
    missing = {name for name, number in result.parameters.items() if number is None}
    assert missing == {"H", "F_max_ccw", "F_min_ccw", "F_max_cw", "F_min_cw"}
    assert "not calibrated" in result.not_applicable["F_max_ccw"]
    assert value(result, "D") == pytest.approx(2 * UM, abs=EXACT)
    assert value(result, "F_max_cw_lsc") == pytest.approx(2 * UM, abs=EXACT)
    assert codes(result) == {"CW-C003"}
    assert "CW-C010" not in codes(
        evaluate_circle(measured(perfect, calibrated=False, arc=(0.0, 180.0)))
    )


def test_of_several_runs_the_first_counts() -> None:
    """Run 1 of ccw has lobes of ±1 µm, run 2 of ±4 µm and is 5 µm larger; listed in the other
    order.
    """

    def lobes(amplitude: float, mean: float, sense: Sense, number: int) -> CircularRun:
        return run_of(
            radial(lambda angle, _: amplitude * UM * np.cos(2 * angle) + mean * UM),
            sense,
            n=1440,
            number=number,
        )

    runs = [lobes(4.0, 5.0, "ccw", 2), lobes(1.0, 0.0, "ccw", 1), lobes(1.0, 0.0, "cw", 1)]
    result = evaluate_circle(circular_test(runs))
    assert value(result, "G_ccw") == pytest.approx(2 * UM, abs=1e-7)
    assert value(result, "G_bidirectional") == pytest.approx(2 * UM, abs=1e-7)
    assert value(result, "D") == pytest.approx(0.0, abs=EXACT)
    told = [finding.message for finding in result.findings if finding.code == "CW-C001"]
    assert len(told) == 1
    assert "ccw run 1 and cw run 1" in told[0]
    assert "ccw run 2: G 8.00 µm" in told[0]


def test_unknown_standard() -> None:
    with pytest.raises(UsageError, match="iso230-4:1996, iso230-4:2005"):
        evaluate_circle(measured(perfect), "iso230-2:2014")


# ---- what cannot be evaluated ----


def test_an_arc_below_90_degrees() -> None:
    with pytest.raises(InputError, match="too short an arc; expected at least 90°"):
        evaluate_circle(measured(perfect, arc=(10.0, 88.9)))
    for extent in (90.0, 89.1):  # readings at the ends can be missing
        found = evaluate_circle(measured(perfect, arc=(10.0, extent)))
        assert value(found, "G_ccw") == pytest.approx(0.0, abs=EXACT)


def test_samples_at_half_steps_of_90_degrees() -> None:
    """A plain CSV gives the first and the last sample as arc (0.5° to 89.5°)."""
    run = plain_run("ccw", [0.5 + k for k in range(90)], [3.0] * 90)
    result = evaluate_circle(circular_test([run], arc=(0.5, 89.0)))
    assert value(result, "G_ccw") == pytest.approx(0.0, abs=EXACT)


def test_a_run_that_stopped_early() -> None:
    run = run_of(perfect, "ccw")
    short = replace(run, angles=run.angles[:170], deviations=run.deviations[:170])  # 85°
    with pytest.raises(InputError, match=r"ccw run 1.*at least 90.*found 85"):
        evaluate_circle(circular_test([short, run_of(perfect, "cw")]))


def test_every_fault_at_once() -> None:
    runs = [
        plain_run("ccw", [0.0, 90.0, 180.0], [0.0, 0.0, 0.0]),
        plain_run("cw", [0.0, 90.0, 180.0, 270.0], [0.0, np.nan, 0.0, 0.0]),
        plain_run("cw", [0.0, 90.0, 180.0, 270.0], [0.0, 0.0, 0.0], number=2),
        plain_run("ccw", [0.0, 90.0, 180.0, 270.0], [0.0, 0.0, 0.0, -1e9], number=2),
    ]
    test = replace(
        circular_test(runs, radius=-1.0, arc=(0.0, 400.0)), sources=(source_of("c.csv", b""),)
    )
    with pytest.raises(InputError) as caught:
        evaluate_circle(test)
    lines = str(caught.value).splitlines()
    assert len(lines) == 6
    assert all(line.startswith("c.csv: ") for line in lines)
    with pytest.raises(InputError, match="no run"):
        evaluate_circle(circular_test([]))
    flat = replace(circular_test(runs[3:]), nominal_radius=100.0)
    with pytest.raises(InputError, match="more than minus the nominal radius"):
        evaluate_circle(flat)
