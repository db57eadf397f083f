"""Pictures of an axis in the pages: what a reader reads off them, by the numbers along their own
axes, is what the documents hold.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import pairwise
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from compwright.reporting.axis_figures import (
    before_after_figure,
    estimate_figure,
    result_figure,
    table_figure,
)
from compwright.reporting.chart_svg import Drawing
from compwright.reporting.charts import LOOKS, Band, Chart, ChartCurve
from compwright.words.sentences import say
from reporting_samples import made_up, positioning, quantiles, run_view, verify_view

BLUE, ORANGE = "#0b4a82", "#c2590c"  # approached in + and in -
SEEN = 0.03  # of a point: what stands so far off is not seen
NUMBER = re.compile(r"−?\d+(\.\d+)?")


class Picture:
    """A picture as it is read: by the numbers along its axes."""

    def __init__(self, drawn: Drawing | str) -> None:
        svg = drawn.svg("en") if isinstance(drawn, Drawing) else drawn
        self.root = ET.fromstring(svg)  # noqa: S314  our own picture
        self.words = [
            (float(one.attrib["x"]), float(one.attrib["y"]), one.text or "", dict(one.attrib))
            for one in self.root.iter("text")
        ]
        up = [
            (at[1], _value(at[2]))
            for at in self.words
            if at[3].get("text-anchor") == "end" and NUMBER.fullmatch(at[2])
        ]
        along = [
            (at[0], _value(at[2]))
            for at in self.words
            if at[3].get("text-anchor") == "middle" and NUMBER.fullmatch(at[2])
        ]
        self.rows = [value for _, value in up]
        assert self.rows == sorted(self.rows)
        assert up == sorted(up, reverse=True)  # what is larger stands higher
        self._up = [(y - 2.7, value) for y, value in up]
        # A panel ends where the numbers along it begin anew.
        self.panels: list[list[tuple[float, float]]] = [[]]
        for here, value in along:
            if self.panels[-1] and value <= self.panels[-1][-1][1]:
                self.panels.append([])
            self.panels[-1].append((here, value))

    def value_at(self, y: float) -> float:
        """The deviation at a height, by the first and the last number up the axis."""
        return _between(y, self._up[0], self._up[-1])

    def position_at(self, x: float, panel: int = 0) -> float:
        """The position at a place, by the first and the last number along a panel."""
        return _between(x, self.panels[panel][0], self.panels[panel][-1])

    def resolution(self) -> float:
        """What a part of a point that nobody sees is worth, up the axis."""
        (low, first), (high, last) = self._up[0], self._up[-1]
        return abs((last - first) / (high - low)) * SEEN

    def holds(self, found: Sequence[float]) -> bool:
        """Whether deviations stand between the ends of the axis."""
        ends = re.compile(r"M[\d.]+,([\d.]+)V([\d.]+)H")
        shapes = (one.attrib["d"] for one in self.root.iter("path"))
        top, bottom = next(
            map(float, told.groups()) for shape in shapes if (told := ends.match(shape))
        )
        return self.value_at(bottom) < min(found) and max(found) < self.value_at(top)

    def triangles(self, colour: str, face: str, panel: int = 0) -> list[tuple[float, float]]:
        """Positions and deviations of the markers of one colour, filled with ``face``."""
        found = []
        for path in self.root.iter("path"):
            shape = re.findall(r"M([\d.-]+),([\d.-]+)l[^h]*?,(-?[\d.]+)h", path.attrib["d"])
            if path.attrib["stroke"] != colour or path.attrib["fill"] != face:
                continue
            for x, tip, height in shape:
                if self._inside(float(x), panel):
                    middle = float(tip) + float(height) / 2
                    found.append((self.position_at(float(x), panel), self.value_at(middle)))
        return found

    def bands(self, colour: str, panel: int = 0) -> list[list[tuple[float, float]]]:
        """Outlines of the bands of one colour."""
        outlines = []
        for one in self.root.iter("polygon"):
            points = [tuple(map(float, point.split(","))) for point in one.attrib["points"].split()]
            if one.attrib["fill"] == colour and self._inside(points[0][0], panel):
                outlines.append([(self.position_at(x, panel), self.value_at(y)) for x, y in points])
        return outlines[:1] if len(outlines) > 1 else outlines  # the last is that of the legend

    def lines(self, colour: str) -> list[str]:
        """Paths of lines of one colour."""
        return [
            one.attrib["d"]
            for one in self.root.iter("path")
            if one.attrib["stroke"] == colour and "l" not in one.attrib["d"]
        ]

    def texts(self) -> list[str]:
        return [text.replace("\xa0", " ") for _, _, text, _ in self.words]

    def _inside(self, x: float, panel: int) -> bool:
        """Whether a place belongs to a panel; the legend stands below all of them."""
        first, last = self.panels[panel][0][0], self.panels[panel][-1][0]
        free = 0.3 * (last - first)
        return first - free < x < last + free


def _svg(charts: list[Chart], height: float) -> str:
    described = say("chart.described", what="deviations", name="X")
    return Drawing(tuple(charts), height, described).svg("en")


def _value(text: str) -> float:
    return float(text.replace("−", "-"))


def _between(at: float, first: tuple[float, float], last: tuple[float, float]) -> float:
    return first[1] + (last[1] - first[1]) * (at - first[0]) / (last[0] - first[0])


def values(found: Sequence[tuple[float, float]]) -> list[float]:
    return [value for _, value in found]


def test_a_test_is_read_off_its_picture() -> None:
    result = made_up()
    picture = Picture(result_figure(result, "deviations"))
    for colour, key in ((BLUE, "positive"), (ORANGE, "negative")):
        means = picture.triangles(colour, colour)[: len(result["targets"])]
        for (where, mean), target in zip(means, result["targets"], strict=True):
            assert mean == pytest.approx(target[f"mean_{key}"], abs=picture.resolution())
            assert where == pytest.approx(target["position"], rel=2e-4, abs=0.5)
        readings = picture.triangles(colour, "none")
        told = [one for target in result["targets"] for one in target[f"deviations_{key}"]]
        assert values(readings)[: len(told)] == pytest.approx(told, abs=picture.resolution())
    assert "Deviation in µm" in picture.texts()
    assert "Position in mm" in picture.texts()
    assert {"mean (+)", "mean (−)", "single readings (+)"} <= set(picture.texts())


def test_before_predicted_and_after_share_one_scale() -> None:
    view = verify_view()
    expected = view["axes"]["X"]["predicted_targets"]
    before, after = (view[key]["results"][0] for key in ("evaluation_before", "evaluation_after"))
    told = {**expected, "parameters": {"A": quantiles(4.12, 3.47, 5.03)}}
    picture = Picture(before_after_figure(before, told, "all three", after))
    assert len(picture.panels) == 3
    assert [[value for _, value in panel] for panel in picture.panels] == [
        [value for _, value in picture.panels[0]]
    ] * 3
    for colour, key in ((BLUE, "positive"), (ORANGE, "negative")):
        for panel, result in ((0, before), (2, after)):
            means = values(picture.triangles(colour, colour, panel))
            told_means = [target[f"mean_{key}"] for target in result["targets"]]
            assert means[: len(told_means)] == pytest.approx(told_means, abs=picture.resolution())
            assert picture.holds(told_means)
        shown = values(picture.triangles(colour, "#ffffff", 1))[: len(expected[key])]
        assert shown == pytest.approx(expected[key], abs=picture.resolution())
        (band,) = picture.bands(colour, 1)
        half = len(band) // 2
        for (_, low), (_, high), mean in zip(
            band[:half], reversed(band[half:]), expected[key], strict=True
        ):
            assert (low, high) == pytest.approx(
                (mean - 2 * expected["s"], mean + 2 * expected["s"]), abs=picture.resolution()
            )
    words = picture.texts()
    assert "A 4.12 (3.47 to 5.03) µm" in words
    heads = [at for at in picture.words if at[2] in ("Before", "Predicted", "After")]
    assert [at[2] for at in sorted(heads)] == ["Before", "Predicted", "After"]


def test_the_nodes_of_a_table_are_marked_beside_what_was_wanted() -> None:
    view = run_view()
    table, wanted = view["prediction"]["axes"]["X"]["table"], view["axes"]["X"]["wanted"]
    picture = Picture(table_figure({"table": table, "wanted": wanted}, "correction"))
    for colour, key in ((BLUE, "positive"), (ORANGE, "negative")):
        nodes = picture.triangles(colour, colour)[: len(table["positions"])]
        assert values(nodes) == pytest.approx(table[f"correction_{key}"], abs=picture.resolution())
    assert {"Correction in µm", "wanted (+)", "table (−)"} <= set(picture.texts())
    many = [float(node) for node in range(400)]  # markers would cover the curve
    same = {"positions": many, "correction_positive": many, "correction_negative": many}
    dense = Picture(table_figure({"table": {**table, **same}}, "correction"))
    assert dense.triangles(BLUE, BLUE) == []
    assert "table (+ and −)" in dense.texts()
    assert not any("wanted" in text or "table (−)" in text for text in dense.texts())


def test_the_estimate_shows_two_standard_deviations_and_the_measured_means() -> None:
    view = run_view()
    estimate, result = view["axes"]["X"]["estimate"], view["evaluation"]["results"][0]
    estimate["std_negative"] = [1.5 for _ in estimate["positions"]]
    picture = Picture(estimate_figure(estimate, result, "estimate"))
    (band,) = picture.bands(ORANGE)
    half = len(band) // 2
    heights = [
        high - low for (_, low), (_, high) in zip(band[:half], reversed(band[half:]), strict=True)
    ]
    assert heights == pytest.approx([4 * 1.5] * half, abs=2 * picture.resolution())
    measured = [target["mean_negative"] for target in result["targets"]]
    shown = values(picture.triangles(ORANGE, ORANGE))[: len(measured)]
    assert shown == pytest.approx(measured, abs=picture.resolution())


def test_one_direction_and_missing_readings_draw_only_what_there_is() -> None:
    picture = Picture(result_figure(run_view()["evaluation"]["results"][1], "one way"))
    words = picture.texts()
    assert {"mean (+)", "single readings (+)", "Deviation in arcsec", "Position in deg"} <= set(
        words
    )
    assert not any("(−)" in text for text in words if not text.startswith("(+)"))
    assert "A+ 9.13   E+ 7.52   R+ 3.24 arcsec" in words
    single = positioning(
        [0.0, 900.0, 3000.0],
        [[1.0], [2.0], [8.0]],
        [[0.0], [None], [7.0]],
        {"A": None, "E": 8.0, "B": 1.0},
    )
    svg = result_figure(single, "single").svg("en")
    assert "polygon" not in svg  # no s, no band
    assert values(Picture(svg).triangles(ORANGE, "none"))[:2] == pytest.approx([0.0, 7.0], abs=0.01)
    line = next(d for d in Picture(svg).lines(ORANGE) if d.count("M") > 1)
    assert line.count("M") == 2  # nothing is drawn where nothing was measured


def test_full_turns_are_read_in_degrees_that_people_count_in() -> None:
    turn = positioning(
        [0.0, 90.0, 180.0, 270.0, 360.0], [[1.0, 2.0]] * 5, None, {"A_positive": 1.0}, unit="arcsec"
    )
    along = [value for _, value in Picture(result_figure(turn, "turn")).panels[0]]
    assert {0.0, 90.0, 180.0, 270.0, 360.0} <= set(along)


def test_a_flat_curve_is_not_blown_up() -> None:
    flat = positioning([0.0, 100.0], [[0.0, 0.001]] * 2, [[0.0, 0.001]] * 2, {"A": 0.0})
    rows = Picture(result_figure(flat, "flat")).rows
    assert max(rows) - min(rows) >= 0.15


@pytest.mark.parametrize("top", [0.004, 0.7, 3.0, 12.5, 480.0, 99999.0])
def test_numbers_along_the_axes_are_round_apart_and_few(top: float) -> None:
    curve = ChartCurve(x=[-top, top], y=[-3 * top, top], look=LOOKS[0], label="any", width=1.0)
    picture = Picture(_svg([Chart(curves=[curve])] * 3, 234.0))
    assert 3 <= len(picture.rows) <= 10
    for panel in picture.panels:
        assert 2 <= len(panel) <= 10
        steps = {round(after[1] - before[1], 9) for before, after in pairwise(panel)}
        assert len(steps) == 1
        digits = f"{steps.pop():e}".split("e")[0].rstrip("0").rstrip(".")
        assert digits in {"1", "2", "2.5", "5"}
        widest = max(len(text) for _, _, text, _ in picture.words if NUMBER.fullmatch(text))
        for before, after in pairwise(panel):
            assert after[0] - before[0] > widest * 4.0  # points: no number touches the next


def test_a_dense_curve_loses_no_peak() -> None:
    places = [float(place) for place in range(4001)]
    curve = [math.sin(place / 300.0) for place in places]
    curve[1777], curve[2903] = 9.0, -7.0
    chart = Chart(
        curves=[ChartCurve(x=places, y=curve, look=LOOKS[0], width=1.0)],
        bands=[
            Band(x=places, low=[v - 1 for v in curve], high=[v + 1 for v in curve], look=LOOKS[1])
        ],
    )
    svg = _svg([chart], 209.0)
    picture = Picture(svg)
    points = [tuple(map(float, at.split(","))) for at in picture.lines(BLUE)[0][1:].split()]
    assert len(points) < 1100
    shown = {round(picture.position_at(x)): picture.value_at(y) for x, y in points}
    assert shown[1777] == pytest.approx(9.0, abs=picture.resolution())
    assert shown[2903] == pytest.approx(-7.0, abs=picture.resolution())
    (outline,) = picture.bands(ORANGE)
    assert max(values(outline)) == pytest.approx(10.0, abs=picture.resolution())
    assert min(values(outline)) == pytest.approx(-8.0, abs=picture.resolution())
    assert len(svg) < 60_000


def test_names_of_the_user_stay_text() -> None:
    hostile: dict[str, Any] = made_up(name="$\\frac{$ 中\n<b>", axis="C<script>&" * 20)
    picture = Picture(result_figure(hostile, '"<X>"'))
    assert picture.root.attrib["aria-label"] == 'deviations of axis "<X>"'
    assert any("<b>" in text for text in picture.texts())
    assert {one.tag for one in picture.root.iter()} <= {"svg", "path", "polygon", "text"}


@pytest.mark.parametrize("names", [3, 9, 14])
def test_every_name_of_a_long_legend_is_inside_the_picture(names: int) -> None:
    """A letter of a sans-serif font is about half as wide as high."""
    labels = [f"Mittelwert der Messungen {n}" for n in range(names)]
    curves = [
        ChartCurve(x=[0.0, 1.0], y=[0.0, 1.0], look=LOOKS[0], label=label, width=1.0)
        for label in labels
    ]
    root = ET.fromstring(_svg([Chart(curves=curves)], 209.0))  # noqa: S314  our own picture
    _, _, width, height = map(float, root.attrib["viewBox"].split())
    letter = 0.5 * float(root.attrib["font-size"])
    places = {one.text: one.attrib for one in root.iter("text") if one.text in labels}
    assert set(places) == set(labels)
    for label, place in places.items():
        left = float(place["x"])
        assert left >= 0.0
        assert left + letter * len(label) <= width
        assert float(place["y"]) < height
