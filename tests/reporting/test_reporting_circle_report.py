"""The page of a circle in a report: causes in words, next to what the instrument's software printed,
with what to do about them.
"""

from __future__ import annotations

import io
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest
import yaml
from matplotlib.figure import Figure
from rich.console import Console

from compwright.cli import run as compwright
from compwright.documents.evaluation import in_short
from compwright.records.circular import CIRCULAR_NAMES
from compwright.reporting.cause_pictures import cause_pictures
from compwright.reporting.causes import (
    _KINDS,
    CircleCause,
    named_in_words,
    ranked_causes,
    summed_causes,
)
from compwright.reporting.circle_figures import draw_causes
from compwright.reporting.circle_report import _causes, _sums, _words, machine_block
from compwright.reporting.circle_steps import job_lines, machine_job, next_step, steps_for
from compwright.reporting.circular_parameters import parameter_words, printed_parameters
from compwright.reporting.circular_tables import circular_tables
from compwright.words.sentences import say
from places import REAL, needs_shared

BALLBARS = REAL / "ballbar"

AXES = ("Z", "X")


def entry(value: float, error: float, effect: float, share: float) -> dict[str, Any]:
    return {"value": value, "std_error": error, "unit": "um", "effect": effect, "share": share}


RESULT: dict[str, Any] = {
    "axes": AXES,
    "parameters": {"G_ccw": 5.0, "H": None},
    "diagnosis": {
        "backlash_second": entry(4.0, 0.2, 4.0, 0.8),
        "backlash_second_at_positive": entry(5.0, 0.3, 4.5, 0.0),
        "straightness_first": entry(1.0, 0.9, 0.5, 0.2),
    },
    "plain": {},
    "vendor": {},
}


def test_no_mechanic_can_remove_a_negative_lost_motion() -> None:
    """An axis that turns round too far: its nut is not worn, its compensation is too large."""
    for value, step in ((4.0, "check nut"), (-4.0, "reduce the control's backlash compensation")):
        diagnosis = {"backlash_second": entry(value, 0.2, 4.0, 0.8)}
        causes = ranked_causes({"axes": AXES, "diagnosis": diagnosis})
        (said,) = map(str, steps_for(causes, AXES))
        assert step in said
        assert ("Mechanic" in said) == (value > 0.0)


def test_causes_with_their_ends() -> None:
    table = _causes(ranked_causes(RESULT))
    lost, end, straight = [list(map(str, row)) for row in table["rows"]]
    assert lost[:4] == ["Lost motion X", "4.00", "80", "4.00 ± 0.20"]
    assert end == ["– at X+", "", "", "5.00 ± 0.30", "µm"]
    assert straight[0] == "Straightness Z"
    assert "Software of the instrument" not in [str(head["text"]) for head in table["heads"]]


def test_what_the_software_printed_is_next_to_it() -> None:
    def row(printed: float, *, valid: bool = True) -> list[str]:
        vendor = {"RENISHAW_DIAGNOSTICS": {"AF_BACKLASH_B_POS": {"value": printed, "valid": valid}}}
        table = _causes(ranked_causes({**RESULT, "vendor": vendor}))
        assert str(table["heads"][-1]["text"]) == "Comparison"
        return list(map(str, table["rows"][1][-2:]))

    assert row(4.5) == ["4.50", "agrees"]  # 5.0 ± 0.3
    assert row(4.3) == ["4.30", "differs"]
    assert row(5.0, valid=False) == ["(5.00)", "not valid"]


def test_the_bars_name_the_period_of_each_cyclic_error() -> None:
    """An axis can have several, as a screw and its half pitch: the period tells them apart."""
    waves = [
        {**entry(1.5 / n, 0.01, 3.0 / n, 0.6 / n), "period": 10.0 / n, "phase": 120.0}
        for n in (1, 2)
    ]
    given = {
        "axes": AXES,
        "diagnosis": dict(zip(("cyclic_first", "cyclic_first_2"), waves, strict=True)),
    }
    panel = Figure().add_subplot()
    draw_causes(panel, ranked_causes(given), "en")
    assert [each.get_text().partition(")")[0] for each in panel.texts][::2] == [
        "Cyclic error Z (period 10 mm",
        "Cyclic error Z (period 5 mm",
    ]


def test_a_plane_has_the_name_that_its_circle_has() -> None:
    found = {"value": 60.1, "std_error": 0.1, "unit": "um/m", "correction": "correct"}
    machine = {
        "machine": None, "serial": None, "circles": ["zx"], "contradictions": [],
        "causes": {"squareness": {"XZ": found}, "backlash": {}, "scale_error": {}},
    }  # fmt: skip
    block = machine_block(machine, [{**RESULT, "sources": [{"file": "zx.b5r"}]}])
    assert str(block["table"]["rows"][0][0]) == "Squareness ZX"


def test_nothing_is_done_about_less_than_the_resolution_of_a_ballbar() -> None:
    """Readings in mm taken as µm: effects of 0.01 µm, all of them "large" shares."""
    small = {"squareness": {**entry(0.05, 0.001, 0.01, 0.6), "unit": "um/m"},
             "backlash_first": entry(0.01, 0.001, 0.01, 0.4)}  # fmt: skip
    causes = ranked_causes({**RESULT, "diagnosis": small})
    assert all(cause.shown for cause in causes)
    assert steps_for(causes, AXES) == []
    assert not any(cause.corrected for cause in causes)


def test_doubts_come_first_at_the_terminal() -> None:
    lines = [
        {"code": code, "severity": "warning", "message": f"about {code}"}
        for code in ("CW-D004", "CW-C015")
    ]
    console = Console(width=100, record=True, file=io.StringIO())
    result = {
        **RESULT, "name": "xy", "plane": "ZX", "standard": "iso230-4:2005", "sources": [],
        "arc": {"extent": 360.0, "start": 0.0}, "calibrated": True, "nominal_radius": 150.0,
        "feed": 1000.0, "centre": {"common": [0.0, 0.0]}, "not_applicable": {}, "findings": lines,
        "parameters": dict.fromkeys(CIRCULAR_NAMES),
    }  # fmt: skip
    for table in circular_tables([result]):
        console.print(table)
    text = console.export_text()
    assert text.index("CW-C015") < text.index("Cause, effect") < text.index("CW-D004")


def test_a_value_whose_error_exceeds_both_is_too_uncertain_to_compare() -> None:
    """The scale error of the real 150 mm circle: 2.8 ± 51.1, the software printed 3."""
    wide = {**entry(2.8, 51.1, 0.0, 0.0), "unit": "um/m"}
    vendor = {"RENISHAW_DIAGNOSTICS": {"AF_SCALE_ERROR_A": {"value": 3.0}}}
    diagnosis = {"scale_mismatch": entry(1.0, 0.2, 1.0, 1.0), "scale_error_first": wide}
    table = _causes(ranked_causes({**RESULT, "diagnosis": diagnosis, "vendor": vendor}))
    assert list(map(str, table["rows"][1][-2:])) == ["3.0", "too uncertain to compare"]


def test_values_of_another_definition_are_next_to_ours() -> None:
    vendor = {
        "RENISHAW_DIAGNOSTICS": {
            "AF_REVERSAL_SPIKES_A_POS": {"value": 1.3},
            "AF_REVERSAL_SPIKES_A_NEG": {"value": 1.2},
            "AF_OFFSET_B_SHIFT": {"value": 0.1},
            "AF_CYCLIC_ERROR_B_FWD": {"value": 0.9},
            "AF_CYCLIC_ERROR_B_REV": {"value": 0.7},
            "AF_CYCLIC_PITCH_B": {"value": 12.0},
        }
    }
    diagnosis = {
        "reversal_spike_first": entry(1.5, 0.4, 1.5, 0.5),
        "reversal_spike_first_at_positive": {**entry(1.5, 0.4, 1.5, 0.0), "raw_peak": 1.65},
        "reversal_spike_first_at_negative": {**entry(-1.2, 0.4, 1.2, 0.0), "raw_peak": -1.4},
        "cyclic_second": {**entry(0.28, 0.04, 0.6, 0.4), "period": 6.014, "phase": 148.2},
        "offset_change_second": entry(0.2, 0.1, 0.2, 0.1),
        "vibration": {**entry(0.1, 0.02, 0.1, 0.05), "frequency": 41.6, "axis": "Z"},
    }
    table = _causes(ranked_causes({**RESULT, "diagnosis": diagnosis, "vendor": vendor}))
    rows = {str(row[0]): list(map(str, row[-2:])) for row in table["rows"]}
    assert list(rows) == [
        "Reversal spike Z",
        "– at Z+ (raw peak 1.65 µm)",
        "– at Z− (raw peak −1.40 µm)",
        "Cyclic error X (period 6.014 mm, phase 148°)",
        "Centre change X, ccw − cw",
        "Vibration (41.6 Hz)",
    ]
    assert [printed for printed, _ in rows.values()] == [
        "",
        "1.30",
        "1.20",
        "0.90 / 0.70",
        "0.10",
        "",
    ]
    compared = [words for _, words in rows.values()]
    assert compared[1:5] == [
        *["other definition"] * 2,
        "other definition (forward / backward, at a pitch of 12 mm)",
        "other definition",
    ]


def test_ends_that_differ_are_drawn_as_they_are() -> None:
    """X+ inward, X− outward, as in the real 150 mm circle: not two equal outward ends."""
    diagnosis = {
        "reversal_spike_first": entry(0.36, 0.34, 2.9, 1.0),
        "reversal_spike_first_at_positive": entry(-1.22, 0.3, 1.2, 0.0),
        "reversal_spike_first_at_negative": entry(1.95, 0.5, 1.9, 0.0),
    }
    drawn = cause_pictures(ranked_causes({**RESULT, "diagnosis": diagnosis}))
    assert drawn is not None
    (picture,) = drawn["pictures"]
    for way in ("ccw", "cw"):
        points = [tuple(map(float, point.split(","))) for point in picture[way].split()]
        away = {
            end: [
                math.hypot(x - picture["x"], y - picture["y"]) - drawn["radius"]
                for x, y in points
                if (x > picture["x"]) == (end > 0) and abs(y - picture["y"]) < 6
            ]
            for end in (1, -1)
        }
        assert min(away[1]) < -6
        assert max(away[1]) < 1
        assert max(away[-1]) > 10
        assert max(away[-1]) / -min(away[1]) == pytest.approx(1.95 / 1.22, rel=0.02)


@pytest.mark.parametrize(
    ("plain", "says"),
    [(4.4, "the spikes make 80 % of the difference"), (5.1, "the spikes are not the reason")],
)
def test_a_difference_has_the_reason_that_a_fit_without_spikes_shows(
    plain: float, says: str
) -> None:
    vendor = {"RENISHAW_DIAGNOSTICS": {"AF_BACKLASH_B_POS": {"value": 4.25}}}
    given = {**RESULT, "plain": {"backlash_second_at_positive": plain}, "vendor": vendor}
    words = str(_causes(ranked_causes(given))["rows"][1][-1])
    assert words.startswith(f"differs. Without reversal spikes our value is {plain:.2f} µm")
    assert says in words


def test_values_that_sum_up_causes_are_on_the_page() -> None:
    given = {
        **RESULT,
        "diagnosis": {
            **RESULT["diagnosis"],
            "lobes_2": {**entry(1.6, 0.1, 0.0, 0.0), "effect": None, "share": None},
            "lobes_3": {**entry(0.4, 0.1, 0.0, 0.0), "effect": None, "share": None},
            "positional_tolerance": entry(6.7, 0.3, 0.0, 0.0),
        },
        "vendor": {"RENISHAW_DIAGNOSTICS": {"AF_POSITIONAL_TOLERANCE": {"value": 35.3}}},
    }
    rows = [list(map(str, row)) for row in _sums(summed_causes(given), printed=True)["rows"]]
    assert [row[:3] for row in rows] == [
        ["Two lobes", "1.60 ± 0.10", "µm"],
        ["Three lobes", "0.40 ± 0.10", "µm"],
        ["Positional tolerance", "6.70 ± 0.30", "µm"],
    ]
    assert rows[2][3] == "35.30"
    assert rows[2][4] == "other definition"  # ours is not theirs: neither agrees nor differs


@pytest.mark.parametrize(
    ("need", "offered"), [("correct", True), ("undetermined", False), ("negligible", False)]
)
def test_the_page_offers_only_a_correction_that_run_writes(need: str, *, offered: bool) -> None:
    """10 ± 3 µm/m is more than two standard errors, and `run` does not correct it."""
    angle = {**entry(10.0, 3.0, 1.0, 0.5), "unit": "um/m", "correction": need}
    (cause,) = ranked_causes({**RESULT, "diagnosis": {"squareness": angle}})
    assert cause.known
    assert cause.corrected == offered
    machine = {
        "causes": {"squareness": {"XZ": angle}, "backlash": {}, "scale_error": {}},
        "contradictions": [],
    }
    result = {**RESULT, "sources": [{"file": "zx.b5r"}]}
    assert bool(machine_job(machine, [result])) == offered


#: Details of another cause, and values that sum causes up.
NO_STEP = {"scale_error", "backlash_mismatch", "lobes_2", "lobes_3", "positional_tolerance"}


@pytest.mark.parametrize("cause", sorted(set(_KINDS) - NO_STEP))
def test_every_cause_has_a_step_in_words(cause: str) -> None:
    step = str(next_step(cause, AXES) or next_step(f"{cause}_first", AXES))
    assert len(step) > 20
    assert "{first}" not in step
    assert "_" not in step


@pytest.mark.parametrize(("mean", "what"), [(0.1, "guideway"), (1.5, "backlash compensation")])
def test_only_lost_motion_in_the_mean_is_for_the_backlash_value(mean: float, what: str) -> None:
    """+1.5 and -1.5 µm at the two ends (the real 150 mm circle): the control's value removes none."""
    whole = CircleCause(
        name="backlash_first", words=say("circle.share"), value=mean, error=0.3, unit="um",
        effect=1.5, share=0.3,
    )  # fmt: skip
    end = replace(whole, name="backlash_first_at_positive", value=1.5)
    (step,) = map(str, steps_for([replace(whole, parts=(end,))], AXES))
    assert what in step
    assert ("backlash" in step) == (mean == 1.5)


def test_the_job_that_corrects_what_a_table_can() -> None:
    result = {**RESULT, "sources": [{"file": "zx.b5r"}]}
    lines = job_lines(["squareness", "scale_mismatch", "backlash_first", "vibration"], result)
    (path,) = [yaml.safe_load(line) for line in lines[:1]]
    assert path == {"circles": [{"file": "zx.b5r", "centre": ["Z", "X"]}]}
    apply = yaml.safe_load(lines[1])["apply"]
    assert apply == {"squareness": {"ZX": "X"}, "backlash_from": "circle"}
    assert job_lines(["scale_mismatch"], result) == ["circles: [{file: zx.b5r, centre: [Z, X]}]"]
    assert job_lines(["scale_error_first"], result) == job_lines(["scale_mismatch"], result)
    assert job_lines(["vibration", "stick_slip_first"], result) == []
    odd = {**RESULT, "sources": [{"file": "a, 1.csv"}]}
    (entry,) = yaml.safe_load(job_lines(["squareness"], odd)[0])["circles"]
    assert entry["file"] == "a, 1.csv"
    two = {**RESULT, "sources": [{"file": "a.csv"}, {"file": "b.csv"}]}
    assert job_lines(["squareness"], two)[0] == "circles: [{ccw: FILE, cw: FILE, centre: [Z, X]}]"


@pytest.mark.parametrize(("second", "named"), [(60.0, "both"), (5.0, "one"), (30.0, "mismatch")])
def test_scale_errors_of_both_axes_have_a_step(second: float, named: str) -> None:
    """60 µm/m of both axes over R = 120 mm: 7.2 µm on the radius, and no mismatch."""
    apart = 0.24 * (60.0 - second)
    diagnosis = {
        "scale_mismatch": entry(apart, 0.02, apart / 2.0, 0.7 if named == "mismatch" else 0.0),
        "scale_error_first": {**entry(60.0, 3.0, 7.2, 0.0), "unit": "um/m"},
        "scale_error_second": {**entry(second, 3.0, 0.12 * second, 0.0), "unit": "um/m"},
    }
    causes = ranked_causes({"axes": AXES, "diagnosis": diagnosis})
    (step,) = map(str, steps_for(causes, AXES))
    assert "Check the temperature of both axes" in step
    assert ("Scale mismatch" in step) == (named == "mismatch")
    assert ("Scale error Z (60.0 ± 3.0 µm/m)" in step) == (named != "mismatch")
    assert ("Scale error X (" in step) == (named == "both")


def test_no_name_of_a_key_is_on_the_page() -> None:
    assert str(_words("backlash_first", RESULT)) == "Lost motion Z"
    assert str(_words("backlash_first_at_positive", RESULT)) == "Lost motion Z at Z+"
    assert str(_words("scale_error_second", RESULT)) == "Scale error X"
    assert str(_words("G_ccw", RESULT)) == "G ccw"
    assert str(parameter_words("G_bidirectional_lsc")) == "G both, least-squares circle"
    assert str(parameter_words("F_max_cw_lsc")) == "F max cw, least-squares centre"
    message = say("CW-D001.cause", cause="scale_mismatch", factor=9, other="straightness_second")
    assert str(named_in_words(message, AXES)) == (
        "Scale mismatch Z − X (9 times, similar to Straightness X)"
    )
    assert named_in_words("my_file.b5r", AXES) == "my_file.b5r"
    assert [str(say("CW-D001.more", count=count)) for count in (1, 2)] == [
        "and of 1 more cause",
        "and of 2 more causes",
    ]


#: Rows of the results and their three columns, rows of the causes.
_PARAMETERS = {
    "Circular deviation, minimum zone": ("G_ccw", "G_cw", "G_bidirectional"),
    "by the least-squares circle": ("G_ccw_lsc", "G_cw_lsc", "G_bidirectional_lsc"),
    "Radial deviation, largest": ("F_max_ccw", "F_max_cw"),
    "Radial deviation, smallest": ("F_min_ccw", "F_min_cw"),
    "Mean radial deviation": ("none", "none", "D"),
}
_CAUSES = {
    "squareness": "Squareness {0}{1}",
    "scale_mismatch": "Scale mismatch {0} − {1}",
    "servo_mismatch": "Servo mismatch {0} − {1}",
    "radius_change": "Radius change ccw − cw",
    "backlash_first": "Lost motion {0}",
    "backlash_second": "Lost motion {1}",
    "lateral_play_first": "Lateral play {0}",
    "lateral_play_second": "Lateral play {1}",
    "reversal_spike_first": "Reversal spike {0}",
    "reversal_spike_second": "Reversal spike {1}",
    "cyclic_first": "Cyclic error {0}",
    "straightness_first": "Straightness {0}",
    "straightness_second": "Straightness {1}",
    "offset_change_first": "Centre change {0}, ccw − cw",
    "offset_change_second": "Centre change {1}, ccw − cw",
}


def _equals(printed: str, value: float) -> bool:
    """Whether a printed number is that value, within half of its last digit."""
    digits = len(printed.partition(".")[2])
    return bool(abs(float(printed.replace("−", "-")) - value) < 0.5001 / 10**digits)


@needs_shared
@pytest.mark.parametrize("path", sorted(BALLBARS.glob("*.b5r")), ids=lambda path: path.stem)
def test_pages_of_real_files(path: Path, tmp_path: Path) -> None:
    """Numbers are those of the JSON, what the instrument's software printed is next to them, and no
    key of the JSON is on the page.
    """
    report, answer = tmp_path / "out.html", tmp_path / "out.json"
    words = ["evaluate", str(path), "--report", str(report), "--json", str(answer)]
    assert compwright(words) == 0
    (result,) = json.loads(answer.read_text(encoding="utf-8"))["results"]
    root = ET.fromstring(report.read_text(encoding="utf-8"))  # noqa: S314  our own page
    body = root.find("body")
    assert body is not None
    text = " ".join(" ".join(body.itertext()).split())
    keys = {*result["diagnosis"], *result["parameters"], *result["not_applicable"]}
    clear = []
    for name, entry in result["diagnosis"].items():
        peak = entry.get("raw_peak")
        if peak is not None and abs(entry["value"]) > entry["std_error"]:
            clear.append(name)  # 0.03 of a spike of −1.22 is not
            assert (peak > 0) == (entry["value"] > 0), name
        assert (entry["effect"] is None) >= name.startswith(("lobes", "positional")), name
    assert clear
    assert [key for key in keys if "_" in key and key in text] == []
    rows = [[" ".join("".join(cell.itertext()).split()) for cell in row] for row in body.iter("tr")]
    cells = {row[0]: row for row in rows if row}
    for label, names in _PARAMETERS.items():
        for shown, key in zip(cells.get(label, [])[2:5], names, strict=False):
            value = result["parameters"].get(key)
            assert (shown == "") == (value is None), (label, key)
            assert not shown or _equals(shown, value), (label, key)
    for key, label in _CAUSES.items():
        entry, row = result["diagnosis"].get(key), cells.get(label.format(*result["axes"]))
        if row is not None:
            value, error = row[3].split(" ± ")
            printed = {"effect": row[1], "value": value, "std_error": error}
            assert all(_equals(text, entry[name]) for name, text in printed.items()), key
            assert _equals(row[2], 100 * entry["share"]), key
    # An error of half of the value, as on the arc of 220°, is no value: only then no row.
    row = cells.get(f"Squareness {''.join(result['axes'])}")
    assert (row is None) == (result["diagnosis"]["squareness"]["value"] is None)
    if row is None:
        return
    block = next(b for title, b in result["vendor"].items() if title.startswith("RENISHAW_DIAG"))
    theirs = block["AF_SQUARENESS"]["value"]
    assert row[5].strip("()") == f"{theirs:.1f}".replace("-", "−")


@needs_shared
def test_values_of_the_instrument_s_software_are_those_of_the_file(tmp_path: Path) -> None:
    """Each edition has its own block in the file; an entry in short has none of them."""
    path, answer = BALLBARS / "ballbar_qc20w_150mm_XY.b5r", tmp_path / "out.json"
    file = ET.parse(path).getroot()  # noqa: S314  a file of the project
    for year in ("1996", "2005"):
        (block,) = (
            entry
            for entry in file.iter("ANALYSIS")
            if (entry.get("NAME"), entry.get("version")) == ("ISO230_4", year)
        )
        in_file = {entry.get("NAME"): float(entry.text or "") for entry in block}
        words = ["evaluate", str(path), "--standard", f"iso230-4:{year}", "--json", str(answer)]
        assert compwright([*words, "--force"]) == 0
        (result,) = json.loads(answer.read_text(encoding="utf-8"))["results"]
        printed = printed_parameters(result)
        for letter, name in (("G", "CIRCULAR"), ("F max", "MAX_RADIAL"), ("F min", "MIN_RADIAL")):
            shown = [float(v.replace("\N{MINUS SIGN}", "-")) for v in printed[letter].split(" / ")]
            assert shown[:2] == [in_file[f"AF_{name}_DEVIATION_{way}"] for way in ("CCW", "CW")]
    assert printed_parameters(in_short(result)) == {}
    assert circular_tables([in_short(result)])


@needs_shared
def test_fit_and_residual_add_up_to_the_measured_run(tmp_path: Path) -> None:
    path, answer = BALLBARS / "ballbar_qc20w_150mm_XY.b5r", tmp_path / "out.json"
    assert compwright(["evaluate", str(path), "--json", str(answer)]) == 0
    (result,) = json.loads(answer.read_text(encoding="utf-8"))["results"]
    assert [run["direction"] for run in result["fitted"]] == ["ccw", "cw"]
    squares = []
    for fitted, run in zip(result["fitted"], result["runs"], strict=True):
        measured = dict(zip(run["angles"], run["deviations"], strict=True))
        assert 500 < len(fitted["angles"]) <= 1000
        for angle, value, rest in zip(
            fitted["angles"], fitted["deviations"], fitted["residuals"], strict=True
        ):
            nearest = min(measured, key=lambda place: abs(place - angle))
            assert value + rest == pytest.approx(measured[nearest], abs=1e-5)
            squares.append(rest**2)
    assert math.sqrt(sum(squares) / len(squares)) == pytest.approx(result["residual"], rel=0.1)


def test_the_largest_causes_have_a_step_or_a_reason() -> None:
    """Ends of +2 and -2 µm cancel in the mean and are a cause; 1 ± 1 µm is none, and is named."""
    diagnosis = {
        "reversal_spike_first": entry(0.0, 0.3, 4.0, 0.4),
        "reversal_spike_first_at_positive": entry(2.0, 0.3, 2.0, 0.0),
        "reversal_spike_first_at_negative": entry(-2.0, 0.3, 2.0, 0.0),
        "lateral_play_second": entry(1.0, 1.0, 3.0, 0.3),
        "straightness_first": entry(2.0, 0.1, 2.0, 0.2),
        "spiral": entry(0.1, 0.5, 0.2, 0.1),
    }
    steps = [
        str(step) for step in steps_for(ranked_causes({"axes": AXES, "diagnosis": diagnosis}), AXES)
    ]
    assert len(steps) == 3
    assert "Reversal spike Z" in steps[0]
    assert "Straightness Z" in steps[1]
    assert "No action is proposed for Lateral play X (30 % of all effects)" in steps[2]
    assert "Spiral" not in steps[2]


def test_an_end_whose_axis_has_no_value_is_a_cause_with_a_step() -> None:
    """An arc with one reversal point of an axis: its spike must be printed."""
    whole = {**entry(0.0, 1.0, 9.0, 0.0), "value": None}
    end = entry(9.1, 1.7, 9.1, 0.9)
    result = {
        **RESULT,
        "diagnosis": {
            "reversal_spike_second": whole,
            "reversal_spike_second_at_positive": end,
            "reversal_spike_second_at_positive_ccw": end,
        },
    }
    (cause,) = ranked_causes(result)
    assert str(cause.words) == "Reversal spike X at X+"
    assert "friction compensation of X" in str(steps_for([cause], AXES)[0])


def test_the_interval_of_unlike_ends_is_that_of_the_larger_end() -> None:
    """+1.7 and -1.5 um have a mean of 0.1 um; the path shows the 1.7 um, known to 0.3 um."""
    result = {
        **RESULT,
        "diagnosis": {
            "backlash_second": entry(0.1, 0.2, 1.7, 0.9),
            "backlash_second_at_positive": entry(1.7, 0.3, 1.7, 0.0),
            "backlash_second_at_negative": entry(-1.5, 0.3, 1.5, 0.0),
        },
    }
    (cause,) = ranked_causes(result)
    assert cause.limits == pytest.approx((1.7 - 1.96 * 0.3, 1.7 + 1.96 * 0.3))
    assert cause.significant


def test_the_step_for_a_vibration_names_its_frequency_and_axis() -> None:
    found = {**entry(1.0, 0.1, 2.0, 1.0), "frequency": 56.09, "axis": "X"}
    causes = ranked_causes({**RESULT, "diagnosis": {"vibration": found}})
    assert "by its frequency (56.1 Hz) at axis X: pump" in str(steps_for(causes, AXES)[0])


@needs_shared
@pytest.mark.parametrize("name", ["ballbar_demo_100mm_XY", "ballbar_qc20w_150mm_XY"])
def test_the_effect_of_a_spike_is_no_larger_than_the_spike(name: str, tmp_path: Path) -> None:
    """What takes up lost motion gradually is an effect of the lost motion."""
    answer = tmp_path / "answer.json"
    assert compwright(["evaluate", str(BALLBARS / f"{name}.b5r"), "--json", str(answer)]) == 0
    (result,) = json.loads(answer.read_text("utf-8"))["results"]
    causes = result["diagnosis"]
    ends = {key: each for key, each in causes.items() if "spike" in key and "_at_" in key}
    assert sum(key.endswith("tive") for key in ends) == 4
    for key, each in ends.items():
        if each["value"] is None:  # one direction of an end: not that end
            assert key.endswith("cw")
            assert key in result["not_applicable"]
        else:
            assert each["effect"] <= abs(each["value"]) + 1e-3
