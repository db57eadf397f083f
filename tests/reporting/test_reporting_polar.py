"""Pictures of circular tests: what is drawn is compared with geometry and with the document, never
with an older picture.
"""

from __future__ import annotations

import copy
import math
import re
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure

from circle_machine import Machine, Setup, measured
from compwright.documents.circular import circular_document
from compwright.evaluation.circular import evaluate_circle
from compwright.foundations.errors import UsageError
from compwright.records.circular import CircularEffect, CircularTest, Diagnosis
from compwright.reporting import circle_figures
from compwright.reporting.causes import CircleCause, ranked_causes
from compwright.reporting.circle_figures import (
    draw_causes,
    draw_path,
    draw_test,
    magnification_of,
    paths_of,
    polar_figure,
)
from compwright.reporting.plots import evaluation_plot

pytestmark = pytest.mark.real_pages

RADIUS = 100.0
#: µm. Points are laid by geometry in double precision.
EXACT = 1e-6
BAD = Machine(
    squareness=60.0,
    backlash_first_at_positive=5.0,
    backlash_first_at_negative=5.0,
    centre=(0.15, -0.1),
)


def circle(
    machine: Machine = BAD, *, standard: str = "iso230-4:2005", **setup: Any
) -> dict[str, Any]:
    test = measured(machine, Setup(radius=RADIUS, feed=1000.0, samples=720, **setup))
    return circular_document(evaluate_circle(test, standard))


def effect(
    value: float,
    error: float,
    size: float,
    share: float,
    unit: str = "um",
    low: float | None = None,
) -> CircularEffect:
    return CircularEffect(
        value=value, std_error=error, unit=unit, effect=size, share=share, low=low
    )


EFFECTS = {
    "squareness": effect(-40.0, 5.0, 4.0, 0.4, "um/m"),
    "scale_mismatch": effect(2.0, 1.5, 1.0, 0.1),
    "scale_error_first": effect(8.0, 50.0, 0.8, 0.08, "um/m"),
    "backlash_first": effect(5.0, 0.5, 5.0, 0.47),
    "backlash_first_at_positive": effect(6.0, 0.5, 6.0, 0.5),
    "backlash_first_at_negative": effect(4.0, 0.5, 4.0, 0.4),
    "reversal_spike_second": effect(0.2, 0.4, 0.2, 0.02, low=0.0),
    "cyclic_first": effect(0.0, 0.1, 0.0, 0.0, low=0.0),
    "servo_mismatch": effect(0.02, 0.003, 0.1, 0.0099, "ms"),
}


def diagnosed(test: CircularTest | None = None) -> dict[str, Any]:
    """A document with made-up causes whose order in the document is not that of their effects."""
    result = evaluate_circle(test or measured(BAD, Setup(radius=RADIUS, samples=360)))
    names = tuple(EFFECTS)
    diagnosis = Diagnosis(
        effects=EFFECTS,
        plain={"squareness": -41.0},
        names=names,
        correlation=np.eye(len(names)),
        residual=0.0,
        correlation_length=1.0,
    )
    return circular_document(replace(result, diagnosis=diagnosis))


def drawn_path(result: Mapping[str, Any]) -> Any:
    panel = Figure().subplots()
    draw_path(panel, result)
    return panel


def line(panel: Any, start: str) -> Any:
    """Return the only line whose label begins with ``start``."""
    (found,) = [entry for entry in panel.lines if str(entry.get_label()).startswith(start)]
    return found


def polar_of(entry: Any) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Return angles (deg, 0 to 360) and radii (mm of the picture) of a drawn line."""
    x, y = np.asarray(entry.get_xdata(), dtype=float), np.asarray(entry.get_ydata(), dtype=float)
    return np.degrees(np.arctan2(y, x)) % 360.0, np.hypot(x, y)


def labels(panel: Any) -> list[str]:
    return list(panel.get_legend_handles_labels()[1])


# --- the path
# --------------------------------------------------------------------------------------------------


@given(st.floats(0.1, 1e5), st.floats(10.0, 1000.0))
def test_the_magnification_is_round_and_the_largest_that_fits(
    largest: float, radius: float
) -> None:
    found = magnification_of(largest, radius)
    first = f"{found:e}"[0]
    assert found == pytest.approx(
        float(first) * 10.0 ** int(f"{found:e}".partition("e")[2]), rel=1e-12
    )
    assert first in "125"
    drawn = found * largest / 1000.0  # mm of the picture
    assert drawn <= 0.32 * radius * (1 + 1e-6)
    assert drawn * 2.5 * (1 + 1e-6) > 0.32 * radius  # the next step is at most 2.5 times as large


def test_a_path_about_its_centre_has_no_offset_left() -> None:
    """A true circle 180 µm beside the set-up centre: without it, or with the wrong sign, deviations
    of 180 or 360 µm.
    """
    centre = (0.15, -0.1)
    result = circle(Machine(centre=centre))
    name, found = circle_figures.picture_centre(result)
    assert name == "common"
    assert found == pytest.approx((150.0, -100.0), abs=0.001)  # µm, of the evaluation
    for path in paths_of(result, found, result["runs"]):
        assert (
            max(map(abs, path.radial)) < 0.002
        )  # µm; e²/2R of the offset, 0.16 µm, is taken off too
    for path in paths_of(result, (150.0, -100.0), result["runs"]):
        assert max(map(abs, path.radial)) < EXACT


def test_deviations_are_drawn_magnified_outward_about_the_nominal_circle() -> None:
    """ccw 3 µm too large, cw 1 µm too small."""
    result = circle(Machine(radius_change=2.0, scale_error_first=10.0, scale_error_second=10.0))
    panel = drawn_path(result)
    # the largest deviation is 3 µm: 32 mm / 3 µm = 10 700
    assert panel.get_title().endswith("Magnification 10 000 : 1, rings in µm")
    for way, deviation in (("ccw", 3.0), ("cw", -1.0)):
        angles, radii = polar_of(line(panel, f"{way}: "))
        assert radii == pytest.approx(
            np.full(radii.size, RADIUS + 10.0 * deviation), abs=10.0 * EXACT
        )  # 10 mm per µm
        run = next(run for run in result["runs"] if run["direction"] == way)
        assert angles[:-1] == pytest.approx(np.array(run["angles"]) % 360.0, abs=1e-6)  # deg
        star = line(panel, f"start of {way}")
        assert polar_of(star)[0][0] == pytest.approx(run["angles"][0] % 360.0, abs=1e-6)
    nominal = polar_of(line(panel, "nominal circle"))[1]
    assert nominal == pytest.approx(np.full(nominal.size, RADIUS), abs=1e-9)


@pytest.mark.parametrize("arc", [(0.0, 360.0), (250.0, 220.0), (20.0, 130.0)])
def test_the_path_lies_between_the_circles_of_its_zone_and_touches_both(
    arc: tuple[float, float],
) -> None:
    result = circle(start=arc[0], extent=arc[1])
    both, common = result["minimum_zone"]["both"]["centre"], result["centre"]["common"]
    assert (
        arc[1] > 200.0 or min(abs(both[i] - common[i]) for i in (0, 1)) > 0.05
    )  # µm: a wrong sign would show
    panel = drawn_path(result)
    inner, outer = [entry for entry in panel.lines if entry.get_color() == circle_figures._ZONE]
    scale = _scale(panel)

    def at(entry: Any, angles: Any) -> Any:
        where, radii = polar_of(entry)
        order = np.argsort(where)
        return np.interp(angles, where[order], radii[order], period=360.0)

    margins: list[np.ndarray[Any, Any]] = []
    for way in ("ccw", "cw"):
        angles, radii = polar_of(line(panel, f"{way}: "))
        margins += [radii - at(inner, angles), at(outer, angles) - radii]
    below, above = (
        np.concatenate(margins[0::2]) / scale,
        np.concatenate(margins[1::2]) / scale,
    )  # µm
    # 0.02 µm: chords of 1° across the magnified circles, and e/R of first order in the offset of
    # the zone
    for margin in (below, above):
        assert -0.02 < margin.min() < 0.02
    assert f"G {result['parameters']['G_bidirectional']:.2f} µm" in inner.get_label()
    assert arc[1] < 360.0 or below.max() + above.min() > result["parameters"]["G_bidirectional"] / 2


def _scale(panel: Any) -> float:
    """Return mm of the picture per µm by the words of the title."""
    words = panel.get_title().rpartition("Magnification ")[2].partition(" :")[0]
    return float(words.replace(" ", "")) / 1000.0


def test_directions_differ_by_line_and_width_not_by_colour_alone() -> None:
    panel = drawn_path(circle())
    one, other = line(panel, "ccw: "), line(panel, "cw: ")
    assert one.get_linestyle() != other.get_linestyle()
    assert one.get_linewidth() > other.get_linewidth()
    assert (
        line(panel, "start of ccw").get_markerfacecolor()
        != line(panel, "start of cw").get_markerfacecolor()
    )


def test_the_legend_states_the_parameters() -> None:
    result = circle(replace(BAD, scale_error_first=20.0))
    values = result["parameters"]
    told = " | ".join(labels(drawn_path(result))).replace("−", "-")
    for way in ("ccw", "cw"):
        expected = (
            f"{way}: G {values[f'G_{way}']:.2f}, F {values[f'F_max_{way}']:+.2f} /"
            f" {values[f'F_min_{way}']:+.2f} µm"
        )
        assert expected in told
    assert f"G {values['G_bidirectional']:.2f} µm; D {values['D']:+.2f} µm" in told
    assert "common least-squares centre: X 150.0, Y -100.0 µm" in told
    old = circle(standard="iso230-4:1996")
    told = " | ".join(labels(drawn_path(old)))
    assert f"H {old['parameters']['H']:.2f} µm" in told
    assert "minimum zone, ccw: G" in told
    assert "minimum zone, cw: G" in told
    assert "D " not in told


def test_which_centre_radial_deviations_count_from_is_said() -> None:
    assert any(
        label.startswith("ccw: ") and "F (set-up centre) " in label
        for label in labels(drawn_path(circle(extent=180.0)))
    )
    loose = circle(calibrated=False)
    told = next(label for label in labels(drawn_path(loose)) if label.startswith("ccw: "))
    assert f"F (own centre) +{loose['parameters']['F_max_ccw_lsc']:.2f}" in told


def test_a_radius_far_from_nominal_does_not_hide_the_form() -> None:
    """150 µm too large, with 5 µm of form: drawn about its own circle, which the legend names."""
    result = circle(
        Machine(
            backlash_first_at_positive=5.0,
            backlash_first_at_negative=5.0,
            scale_error_first=1500.0,
            scale_error_second=1500.0,
        )
    )
    panel = drawn_path(result)
    assert not any(label == "nominal circle" for label in labels(panel))
    assert any(label.startswith("least-squares circle, radius +150.") for label in labels(panel))
    _, radii = polar_of(line(panel, "ccw: "))
    form = result["parameters"]["G_ccw_lsc"]
    assert np.ptp(radii) == pytest.approx(
        _scale(panel) * form, rel=0.2
    )  # about another centre than that of the run
    assert _scale(panel) * form > 0.1 * RADIUS
    own = polar_of(line(panel, "least-squares circle"))[1]
    assert own == pytest.approx(np.full(own.size, RADIUS), abs=1e-9)
    assert radii.mean() == pytest.approx(RADIUS, abs=0.5 * _scale(panel) * form)


def test_one_direction_and_further_runs() -> None:
    result = circle(senses=("cw",))
    panel = drawn_path(result)
    assert not any("ccw" in label for label in labels(panel))
    assert any(label.startswith("least-squares centre of cw") for label in labels(panel))
    both = circle()
    again = copy.deepcopy(both["runs"][0])
    again["number"] = 2
    again["deviations"] = [deviation + 1.0 for deviation in again["deviations"]]
    both["runs"].insert(0, again)  # not first by its place in the document
    paths = paths_of(both, (0.0, 0.0), both["runs"])
    assert [path.evaluated for path in paths] == [True, False, True]
    assert paths[0].radial == pytest.approx(both["runs"][1]["deviations"], abs=EXACT)
    assert paths[1].radial == pytest.approx(again["deviations"], abs=EXACT)
    assert sum(str(label).startswith("ccw: ") for label in labels(drawn_path(both))) == 1


def test_an_arc_has_its_stars_at_either_end() -> None:
    panel = drawn_path(circle(start=250.0, extent=220.0))
    for way, start in (("ccw", 250.0), ("cw", 110.0)):
        where = polar_of(line(panel, f"start of {way}"))[0][0]
        assert where == pytest.approx(
            start, abs=0.2
        )  # deg; the first sample stands half a step, 0.15 deg, inside


def test_axes_are_named_at_their_positive_ends() -> None:
    result = {**circle(), "axes": ["Z", "X"]}
    texts = {entry.get_text(): entry.get_position() for entry in drawn_path(result).texts}
    assert texts["+Z"][0] > RADIUS
    assert texts["+Z"][1] == pytest.approx(0.0, abs=1e-9)
    assert texts["+X"][1] > RADIUS


def test_rings_stand_at_the_deviations_that_they_name() -> None:
    panel = drawn_path(circle(Machine(radius_change=3.0)))
    scale = _scale(panel)
    rings = {
        entry.get_text(): math.hypot(*entry.get_position())
        for entry in panel.texts
        if entry.get_text()[:1] in "+−" and entry.get_text()[1:2].isdigit()
    }
    assert {"+2", "−2"} <= set(rings)
    for words, radius in rings.items():
        assert radius == pytest.approx(RADIUS + scale * float(words.replace("−", "-")), abs=1e-9)


# --- the causes
# --------------------------------------------------------------------------------------------------


def test_causes_are_ranked_and_details_are_parts() -> None:
    causes = ranked_causes(diagnosed())
    assert [cause.name for cause in causes] == [
        "backlash_first",
        "squareness",
        "scale_mismatch",
        "reversal_spike_second",
        "servo_mismatch",
        "cyclic_first",
    ]
    by_name = {cause.name: cause for cause in causes}
    assert [str(part.words) for part in by_name["backlash_first"].parts] == ["at X+", "at X−"]
    assert [str(part.words) for part in by_name["scale_mismatch"].parts] == ["Scale error X"]
    assert str(by_name["squareness"].words) == "Squareness XY"
    assert str(by_name["squareness"].value_text) == "−40.0 ± 5.0"
    assert by_name["squareness"].plain == -41.0
    assert str(by_name["reversal_spike_second"].words) == "Reversal spike Y"
    assert [cause.name for cause in causes if not cause.shown] == [
        "servo_mismatch",
        "cyclic_first",
    ]  # 0.99 %, nothing
    assert [cause.significant for cause in causes] == [True, True, False, False, True, False]
    assert ranked_causes({"diagnosis": None}) == []


def cause(**values: Any) -> CircleCause:
    return CircleCause(
        **{
            "name": "x",
            "words": "x",
            "value": 2.0,
            "error": 0.5,
            "unit": "um",
            "effect": 1.0,
            "share": 0.5,
            **values,
        }
    )


def test_whiskers_by_hand() -> None:
    # 2 ± 1.96 * 0.5 = 1.02 to 2.98, each worth half as much effect
    assert cause().limits == pytest.approx((0.51, 1.49), abs=1e-12)
    assert cause(value=-2.0).limits == pytest.approx((0.51, 1.49), abs=1e-12)
    assert cause(error=2.0).limits == pytest.approx((0.0, 2.96), abs=1e-12)
    assert cause(low=1.2).limits == pytest.approx((0.6, 1.49), abs=1e-12)
    assert cause(value=0.0, effect=0.0).limits == (0.0, 0.0)
    assert cause(error=math.nan).limits == (0.0, math.inf)
    assert not cause(error=math.nan).significant


def test_bars_have_the_lengths_of_the_effects_in_their_order() -> None:
    panel: Any = Figure().subplots()
    causes = [entry for entry in ranked_causes(diagnosed()) if entry.shown]
    draw_causes(panel, causes, "en")
    bars = sorted(panel.patches, key=lambda bar: bar.get_y())
    assert [bar.get_width() for bar in bars] == pytest.approx([5.0, 4.0, 1.0, 0.2])
    assert panel.get_ylim()[0] > panel.get_ylim()[1]  # the first on top
    texts = [entry.get_text() for entry in panel.texts]
    assert texts[:2] == ["Lost motion X  5.00 ± 0.50 µm", "47 %"]
    assert panel.get_xlim() == pytest.approx((0.0, 8.75))  # 1.75 * 5
    whiskers = [
        entry.get_xdata()
        for entry in panel.lines
        if len(entry.get_xdata()) == 2 and len(set(entry.get_ydata())) == 1
    ]
    assert list(whiskers[1]) == pytest.approx(
        [4.0 - 0.98, 4.0 + 0.98]
    )  # 40 ± 9.8 um/m at 0.1 µm per um/m


def test_a_whisker_longer_than_the_panel_ends_with_an_arrow() -> None:
    panel: Any = Figure().subplots()
    draw_causes(panel, [cause(error=100.0)], "en")
    assert [entry.get_marker() for entry in panel.lines if len(entry.get_xdata()) == 1] == [">"]


# --- files
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "magic"), [("svg", b"<?xml"), ("png", b"\x89PNG\r\n"), ("pdf", b"%PDF-")]
)
def test_every_format_is_the_same_every_time(kind: str, magic: bytes) -> None:
    first = polar_figure(diagnosed(), format=kind)
    assert first.startswith(magic)
    assert first == polar_figure(diagnosed(), format=kind)


def test_both_kinds_of_test_share_a_figure(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[Any] = []

    def keep(figure: Any, _: str) -> bytes:
        made.append(figure)
        return b""

    monkeypatch.setattr("compwright.reporting.plots.render", keep)
    target = {"position": 0.0, "mean_positive": 1.0, "s_positive": 0.1}
    straight = {
        "kind": "positioning",
        "axis": "X",
        "unit": "um",
        "targets": [target, {**target, "position": 9.0}],
        "parameters": {},
    }
    evaluation_plot({"results": [diagnosed(), straight, circle()]})
    parts = made[0].subfigs
    assert [len(part.axes) for part in parts] == [
        1,
        2,
        1,
    ]  # the positioning tests first; a circle without causes has one panel
    assert parts[0].axes[0].get_ylabel() == "Deviation in µm"
    assert made[0].get_figheight() == pytest.approx(2.9 + 0.35 + 2 * circle_figures.TEST_HEIGHT)


def test_no_number_of_a_picture_is_minus_zero() -> None:
    """The outline of a star, the mark of the start, has a corner at x = -0."""
    drawn = evaluation_plot({"results": [circle()]}).decode()
    assert re.search(r"\bL 0 1\.\d", drawn)
    assert not re.findall(r"(?<![\w.])-0(?:\.0+)?(?![\w.])", drawn)


def test_what_cannot_be_drawn_is_said() -> None:
    with pytest.raises(UsageError, match="to plot"):
        polar_figure({**circle(), "runs": []})
    with pytest.raises(UsageError, match="unknown ending"):
        polar_figure(circle(), format="bmp")


def test_hostile_names_cannot_break_the_picture() -> None:
    result = {**diagnosed(), "name": "$\\frac{$ 中\n<b>" * 9, "axes": ["{first}", "$Y$"]}
    assert polar_figure(result).startswith(b"<?xml")
    figure = Figure()
    draw_test(figure, result)
    assert "\n" not in figure.get_suptitle()
