"""Circular tests through the command line: reference values, pairs of files, bad input, what the
terminal shows.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Mapping
from dataclasses import replace
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from circle_machine import Machine, Setup, measured, truth
from circular_samples import ballbar_file, table
from compwright.cli import run as compwright
from compwright.estimation.circle import diagnose
from compwright.foundations.errors import UsageError
from compwright.foundations.session import Session
from compwright.planning import circle_diagnosis
from compwright.records.circular import CircularTest, Diagnosis
from compwright.simulation.circular import CircleErrors, CirclePlan, record_circle
from compwright.simulation.circular_files import to_b5r
from compwright.workflow.commands.evaluate import evaluate_files, evaluation_renderables
from places import PROJECT, REAL, needs_shared

pytestmark = pytest.mark.real_pages

BALLBAR = REAL / "ballbar"
FILES = (
    "ballbar_demo_100mm_XY.b5r",
    "ballbar_qc20w_150mm_XY.b5r",
    "ballbar_qc20w_150mm_ZX_220deg.b5r",
)
#: µm. The reference table holds values rounded to 0.01; what is beyond is the difference between
#: two computations.
REFERENCE = 0.05
#: µm. The instrument prints one decimal (half of it: 0.05); 0.005 more for its own readings of five
#: decimals of a mm.
PRINTED = 0.055
POSITIONING = "# axis: X\ntarget_mm,direction,run,deviation_um\n" + "".join(
    f"{x},{way},{run},{x / 100 + run / 10}\n"
    for x in (0, 100, 200)
    for way in "+-"
    for run in (1, 2)
)
MACHINE = Machine(
    squareness=40.0,
    backlash_first_at_positive=6.0,
    backlash_first_at_negative=6.0,
    scale_error_second=20.0,
)


def answer(
    capsys: pytest.CaptureFixture[str], *words: str | Path
) -> tuple[int, dict[str, Any], str]:
    """Run ``evaluate ... --json -``; return exit code, document and messages."""
    code = compwright(["evaluate", *map(str, words), "--json", "-"])
    captured = capsys.readouterr()
    assert "Traceback" not in captured.err
    return code, json.loads(captured.out), captured.err


def csv_of(
    sense: str | None = None,
    machine: Machine = MACHINE,
    setup: Setup | None = None,
    keys: Mapping[str, str] | None = None,
    plane: str = "XY",
) -> str:
    """Return a test of the independent machine as plain CSV; ``sense`` alone where one is named."""
    test = measured(
        machine,
        setup or Setup(radius=100.0, feed=1000.0, samples=720, noise=0.3),
        np.random.default_rng(4),
    )
    own = {
        "plane": plane,
        "nominal_radius_mm": f"{test.nominal_radius}",
        "feed_mm_min": f"{test.feed}",
        "calibrated": "yes",
    }
    lines = [f"# {key}: {value}" for key, value in {**own, **(keys or {})}.items()] + [
        "direction,angle_deg,deviation_um"
    ]
    for run in test.runs:
        if sense in (None, run.sense):
            lines += [
                f"{run.sense},{a:.6f},{d * 1000:.5f}"
                for a, d in zip(run.angles, run.deviations, strict=True)
            ]
    return "\n".join(lines) + "\n"


# --- outside references
# --------------------------------------------------------------------------------------------------


@needs_shared
@pytest.mark.parametrize("name", FILES)
def test_reference_values_end_to_end(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    expected = next(row for row in table(BALLBAR / "ballbar_expected.csv") if row["file"] == name)
    code, document, _ = answer(capsys, BALLBAR / name)
    assert code == 0
    (result,) = document["results"]
    values = result["parameters"]
    assert (result["kind"], result["plane"], result["nominal_radius"]) == (
        "circular",
        expected["plane"],
        float(expected["nominal_mm"]),
    )
    found = {"bidir_G_lsc_um": values["G_bidirectional_lsc"], "bidir_mean_dev_um": values["D"]}
    for way in ("ccw", "cw"):
        found[f"{way}_cx_um"], found[f"{way}_cy_um"] = result["centre"][way]
        found[f"{way}_mean_dev_um"] = result["mean_radius_deviation"][way]
        found[f"{way}_G_lsc_um"], found[f"{way}_G_mzc_um"] = (
            values[f"G_{way}_lsc"],
            values[f"G_{way}"],
        )
        found[f"{way}_Fmax_um"], found[f"{way}_Fmin_um"] = (
            values[f"F_max_{way}_lsc"],
            values[f"F_min_{way}_lsc"],
        )
        assert len(next(run for run in result["runs"] if run["direction"] == way)["angles"]) == int(
            expected[f"{way}_n"]
        )
    for key, value in found.items():
        assert value == pytest.approx(float(expected[key]), abs=REFERENCE), key


@needs_shared
@pytest.mark.parametrize("name", FILES)
def test_printed_results_of_the_instrument(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    _, printed = ballbar_file(BALLBAR / name)
    _, document, _ = answer(capsys, BALLBAR / name)
    values = document["results"][0]["parameters"]
    told = printed["2005"]
    pairs = {"G_ccw_lsc": "CIRCULAR_DEVIATION_CCW", "G_cw_lsc": "CIRCULAR_DEVIATION_CW"}
    pairs |= {
        "G_bidirectional_lsc": "BIDIRECTIONAL_CIRCULAR_DEVIATION",
        "D": "MEAN_BIDIRECTIONAL_RADIAL_DEVIATION",
    }
    if (
        "AF_MAX_RADIAL_DEVIATION_CCW" in told
    ):  # the demo's bar was not calibrated, and none are printed
        pairs |= {
            f"F_{end}_{way}_lsc": f"{end.upper()}_RADIAL_DEVIATION_{way.upper()}"
            for end in ("max", "min")
            for way in ("ccw", "cw")
        }
    for ours, theirs in pairs.items():
        assert values[ours] == pytest.approx(told[f"AF_{theirs}"], abs=PRINTED), ours


@needs_shared
def test_radial_deviations_need_a_calibrated_bar(capsys: pytest.CaptureFixture[str]) -> None:
    _, document, _ = answer(capsys, BALLBAR / FILES[0])
    (result,) = document["results"]
    names = [f"F_{end}_{way}" for end in ("max", "min") for way in ("ccw", "cw")]
    assert result["calibrated"] is False
    assert [result["parameters"][name] for name in names] == [None] * 4
    assert all("not calibrated" in result["not_applicable"][name] for name in names)
    assert result["parameters"]["D"] is not None
    assert any(finding["code"] == "CW-C003" for finding in result["findings"])


@needs_shared
def test_plain_regression_agrees_with_the_instruments_diagnostics(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The bounds are those within which an outside recomputation agreed on this file, and half the
    last digit printed.
    """
    path = BALLBAR / FILES[1]
    root = ET.fromstring(path.read_text("utf-8-sig"))  # noqa: S314  a known file
    block = next(
        entry for entry in root.iter("ANALYSIS") if entry.attrib["NAME"] == "RENISHAW_DIAGNOSTICS"
    )
    printed = {
        feature.attrib["NAME"].removeprefix("AF_"): float(feature.text or "nan")
        for feature in block.iter("FEATURE")
    }
    _, document, _ = answer(capsys, path)
    plain = document["results"][0]["plain"]
    pairs = {
        "squareness": "SQUARENESS",
        "servo_mismatch": "SERVO_MISMATCH",
        "scale_mismatch": "SCALE_MISMATCH",
    }
    pairs["radius_change"] = "RADIUS_CHANGE"
    for axis, letter in (("first", "A"), ("second", "B")):
        pairs |= {
            f"backlash_{axis}": f"BACKLASH_{letter}_GLOBAL",
            f"lateral_play_{axis}": f"LATERAL_PLAY_{letter}_GLOBAL",
        }
        pairs |= {f"straightness_{axis}": f"STRAIGHTNESS_{letter}"}
        pairs |= {
            f"backlash_{axis}_at_{end}": f"BACKLASH_{letter}_{end[:3].upper()}"
            for end in ("positive", "negative")
        }
    bounds = {"squareness": 1.5 + 0.05, "servo_mismatch": 0.02 + 0.005}  # um/m, ms
    for ours, theirs in pairs.items():
        assert plain[ours] == pytest.approx(printed[theirs], abs=bounds.get(ours, 0.3 + 0.05)), ours


def test_known_causes_come_back_through_csv(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "xy.csv"
    path.write_text(csv_of(), encoding="utf-8")
    code, document, _ = answer(capsys, path)
    assert code == 0
    found, true = document["results"][0]["diagnosis"], truth(MACHINE, Setup(radius=100.0))
    for name in (
        "squareness",
        "scale_mismatch",
        "backlash_first",
        "backlash_second",
        "servo_mismatch",
        "lateral_play_first",
    ):
        effect = found[name]
        assert effect["value"] == pytest.approx(true[name], abs=4.0 * effect["std_error"]), name
    # 4 standard errors of noise of 0.3 µm over 1440 samples are far below the causes: 40 um/m and 6
    # µm
    assert found["squareness"]["std_error"] < 2.0
    assert found["backlash_first"]["std_error"] < 0.5


# --- the files of one test
# --------------------------------------------------------------------------------------------------


def names_and_codes(folder: Path) -> list[tuple[str, int, list[str]]]:
    """Return name, number of sources, and findings about pairs, of each result."""
    results = evaluate_files(Session(), [folder]).document["results"]
    codes = [
        [
            finding["code"]
            for finding in result["findings"]
            if finding["code"] in ("CW-R038", "CW-R039")
        ]
        for result in results
    ]
    return [
        (result["name"], len(result["sources"]), told)
        for result, told in zip(results, codes, strict=True)
    ]


def put(folder: Path, **files: str) -> None:
    for name, text in files.items():
        (folder / f"{name}.csv").write_text(text, encoding="utf-8")


def test_two_files_of_one_direction_each_are_one_test(tmp_path: Path) -> None:
    (tmp_path / "pair").mkdir()
    (tmp_path / "whole").mkdir()
    put(tmp_path / "whole", xy=csv_of())
    put(tmp_path / "pair", xy_ccw=csv_of("ccw"), xy_CW=csv_of("cw"))
    (one,) = evaluate_files(Session(), [tmp_path / "pair"]).document["results"]
    (other,) = evaluate_files(Session(), [tmp_path / "whole"]).document["results"]
    for key in ("name", "plane", "parameters", "centre", "diagnosis", "plain", "feed", "arc"):
        assert one[key] == other[key], key
    assert sorted(Path(source["file"]).name for source in one["sources"]) == [
        "xy_CW.csv",
        "xy_ccw.csv",
    ]
    (told,) = [finding for finding in one["findings"] if finding["code"] == "CW-R038"]
    assert told["severity"] == "info"
    assert "xy_ccw.csv (ccw)" in told["message"]
    assert "xy_CW.csv (cw)" in told["message"]


def test_names_that_say_nothing_are_joined_too(tmp_path: Path) -> None:
    put(tmp_path, r1=csv_of("cw"), r2=csv_of("ccw"))
    assert names_and_codes(tmp_path) == [("r1 + r2", 2, ["CW-R038"])]


@pytest.mark.parametrize(
    "other",
    [
        csv_of("cw", plane="YZ"),
        csv_of("cw", plane="YX"),
        csv_of("cw", setup=Setup(radius=50.0, feed=1000.0, samples=720)),
        csv_of("cw", setup=Setup(radius=100.0, feed=2000.0, samples=720)),
        csv_of("cw", setup=Setup(radius=100.0, feed=1000.0, samples=720, extent=180.0)),
        csv_of("cw", keys={"machine": "B"}),
        csv_of("ccw", keys={"operator": "other"}),
    ],
    ids=["plane", "order of axes", "radius", "feed", "arc", "machine", "direction"],
)
def test_files_of_different_tests_are_not_joined(tmp_path: Path, other: str) -> None:
    put(tmp_path, xy_ccw=csv_of("ccw", keys={"machine": "A"}), xy_cw=other)
    assert [(count, codes) for _, count, codes in names_and_codes(tmp_path)] == [(1, []), (1, [])]


def test_what_fits_several_is_left_alone_and_told(tmp_path: Path) -> None:
    put(tmp_path, a=csv_of("ccw"), b=csv_of("cw"), c=csv_of("cw", keys={"date": "2"}))
    assert names_and_codes(tmp_path) == [(name, 1, ["CW-R039"]) for name in "abc"]
    told = {
        r["name"]: r["findings"] for r in evaluate_files(Session(), [tmp_path]).document["results"]
    }
    message = next(finding["message"] for finding in told["a"] if finding["code"] == "CW-R039")
    assert "b.csv, c.csv" in message


@pytest.mark.parametrize("order", list(permutations(range(4)))[::5])
def test_names_decide_where_the_content_does_not(tmp_path: Path, order: tuple[int, ...]) -> None:
    """Before and after on one machine: the same plane, radius and feed."""
    later = Machine(squareness=5.0)
    made = {
        "ccw-before": csv_of("ccw"),
        "cw-before": csv_of("cw"),
        "after.CCW": csv_of("ccw", later),
        "after.CW": csv_of("cw", later),
    }
    put(tmp_path, **made)
    paths = [tmp_path / f"{name}.csv" for name in made]
    results = evaluate_files(Session(), [paths[index] for index in order]).document["results"]
    squareness = {result["name"]: result["diagnosis"]["squareness"]["value"] for result in results}
    # um/m; the causes differ by 35, the standard errors are below 2
    assert squareness == {
        "before": pytest.approx(40.0, abs=8.0),
        "after": pytest.approx(5.0, abs=8.0),
    }


def test_a_whole_test_and_the_rest_by_elimination(tmp_path: Path) -> None:
    put(
        tmp_path,
        a=csv_of(),
        b_ccw=csv_of("ccw"),
        b_cw=csv_of("cw"),
        u=csv_of("ccw", keys={"date": "1"}),
        v=csv_of("cw", keys={"date": "1"}),
    )
    assert names_and_codes(tmp_path) == [
        ("a", 1, []),
        ("b", 2, ["CW-R038"]),
        ("u + v", 2, ["CW-R038"]),
    ]


def test_a_word_that_only_contains_cw_is_no_direction(tmp_path: Path) -> None:
    """Without its last letters macw would be the partner of ma."""
    put(tmp_path, macw=csv_of("cw"), ma=csv_of("ccw"), zz=csv_of("ccw", keys={"date": "1"}))
    assert names_and_codes(tmp_path) == [(name, 1, ["CW-R039"]) for name in ("ma", "macw", "zz")]


# --- standards, kinds, missing diagnosis
# ---------------------------------------------------------------------------------------


def test_one_standard_per_kind(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    put(tmp_path, x=POSITIONING, xy=csv_of())
    _, document, _ = answer(capsys, tmp_path)
    assert [(r["kind"], r["standard"]) for r in document["results"]] == [
        ("positioning", "iso230-2:2014"),
        ("circular", "iso230-4:2005"),
    ]
    _, document, _ = answer(
        capsys, tmp_path, "--standard", "iso230-4:1996", "--standard", "iso230-2:1997"
    )
    assert [r["standard"] for r in document["results"]] == ["iso230-2:1997", "iso230-4:1996"]
    old = document["results"][1]
    assert old["parameters"]["H"] > 0.0
    assert [old["parameters"][name] for name in ("D", "G_bidirectional")] == [None, None]
    assert "1996" in old["not_applicable"]["D"]
    with pytest.raises(UsageError, match="more than once for circular tests") as caught:
        evaluate_files(Session(), [tmp_path], ["iso230-4:1996", "iso230-4:2005", "vdi3441"])
    assert len(caught.value.faults) == 1
    assert compwright(["evaluate", str(tmp_path), "--standard", "iso230-4:2015"]) == 2
    error = capsys.readouterr().err
    assert "iso230-4:1996, iso230-4:2005, found iso230-4:2015" in error
    assert "Next: give `--standard iso230-4:2005`" in error


def test_without_a_diagnosis_the_rest_is_given(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """20 samples per direction: enough for G, too few to tell the causes from the noise."""
    put(tmp_path, xy=csv_of(setup=Setup(radius=100.0, feed=1000.0, samples=20)))
    code, document, _ = answer(capsys, tmp_path)
    (result,) = document["results"]
    assert (code, result["diagnosis"], result["plain"]) == (0, None, None)
    assert "too few samples" in result["not_applicable"]["diagnosis"]
    assert result["parameters"]["G_bidirectional"] > 0.0
    assert "No causes: " in shown(document, 80)


@pytest.mark.parametrize("singular", [True, False])
def test_causes_without_a_standard_error_are_not_given(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, *, singular: bool
) -> None:
    def unsound(test: CircularTest) -> Diagnosis:
        if singular:
            raise np.linalg.LinAlgError
        found = diagnose(test)
        return replace(
            found,
            effects={
                name: replace(effect, std_error=float("nan"))
                for name, effect in found.effects.items()
            },
        )

    monkeypatch.setattr(circle_diagnosis, "diagnose", unsound)
    put(tmp_path, xy=csv_of())
    (result,) = evaluate_files(Session(), [tmp_path]).document["results"]
    assert result["diagnosis"] is None
    assert "cannot separate the causes of deviation" in result["not_applicable"]["diagnosis"]


@pytest.mark.parametrize("extent", [90.0, 180.0, 360.0])
@pytest.mark.parametrize("sense", [None, "ccw"])
def test_samples_without_noise_are_no_fault_of_compwright(
    tmp_path: Path, extent: float, sense: str | None
) -> None:
    """Computed samples: a bare number is never given, either the causes have their standard errors
    or the reason stands there.
    """
    put(
        tmp_path,
        xy=csv_of(
            sense, setup=Setup(radius=100.0, feed=1000.0, samples=720, extent=360.0, start=45.0)
        ),
    )
    text = csv_of(sense, setup=Setup(radius=100.0, feed=1000.0, samples=720, extent=extent + 0.25))
    put(tmp_path, arc=text)
    run = evaluate_files(Session(), [tmp_path])
    assert run.exit_code == 0
    for result in run.document["results"]:
        causes = result["diagnosis"]
        assert (causes is None) == ("diagnosis" in result["not_applicable"])
        for name, cause in (causes or {}).items():
            if cause["std_error"] is None:
                assert cause["value"] is None
                assert result["not_applicable"][name]


def test_a_perfect_circle_needs_no_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    put(tmp_path, xy=csv_of(machine=Machine(), setup=Setup(radius=100.0, feed=1000.0, samples=360)))
    code, document, _ = answer(capsys, tmp_path)
    assert code == 0
    assert (
        document["results"][0]["parameters"]["G_bidirectional"] < 0.001
    )  # µm; the file holds steps of 0.00001
    assert compwright(["evaluate", str(tmp_path), "--plot", str(tmp_path / "p.svg")]) == 0


# --- bad input
# --------------------------------------------------------------------------------------------------

SOUND = to_b5r(
    record_circle(
        CircleErrors(squareness=20e-6, noise=0.0003),
        CirclePlan(radius=100.0, sample_rate=20.0),
        seed=2,
    )
).decode()


def changed(pattern: str, by: str) -> str:
    text, count = re.subn(pattern, by, SOUND, flags=re.DOTALL)
    assert count, pattern
    return text


BAD: dict[str, tuple[str, tuple[str, ...]]] = {
    "cut short": (SOUND[: len(SOUND) // 2], ("cut off",)),
    "entity expansion": (
        (
            '<?xml version="1.0"?>\n<!DOCTYPE t [<!ENTITY a "aa"><!ENTITY b'
            ' "&a;&a;">]>\n<TEST_DOCUMENT>&b;</TEST_DOCUMENT>'
        ),
        ("DOCTYPE",),
    ),
    "readings of the wrong length": (
        changed(r"(<READINGS>(?:\S+ ){50})[^<]*", r"\1"),
        ("is outside the readings", "found"),
    ),
    "indices out of range": (
        changed(r"<END_INDEX>\d+", "<END_INDEX>99999"),
        ("END_INDEX", "99999"),
    ),
    "start behind end": (changed(r"<START_INDEX>\d+", "<START_INDEX>99998"), ("INDEX",)),
    "unequal radii": (
        changed(r"<TEST_RADIUS>[^<]*", "<TEST_RADIUS>150"),
        ("radius", "expected 100 mm", "found 150 mm"),
    ),
    "arc below 90 deg": (
        changed(r"<END_ANGLE>[^<]*", "<END_ANGLE>60"),
        ("at least 90 deg", "60 deg"),
    ),
    "another instrument": (
        '<?xml version="1.0"?><Laser><Data>1 2 3</Data></Laser>',
        ("not a ballbar file", "TEST_DOCUMENT", "Laser"),
    ),
    "header only": (
        changed(r"<RUN_RESULTS>.*</RUN_RESULTS>", "<RUN_RESULTS></RUN_RESULTS>"),
        ("no readings",),
    ),
    "a reading that is no number": (changed(r"<READINGS>\S+", "<READINGS>1e400"), ("READINGS",)),
    "CSV header only": (csv_of().partition("ccw,")[0], ("no samples",)),
    "CSV arc below 90 deg": (
        csv_of(setup=Setup(radius=100.0, feed=1000.0, samples=80, extent=80.0)),
        ("at least 90 deg",),
    ),
    "CSV without a plane": (csv_of().replace("# plane: XY\n", ""), ("plane",)),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_files_are_told_in_lines_and_the_rest_is_evaluated(
    case: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text, parts = BAD[case]
    bad = tmp_path / ("bad.csv" if case.startswith("CSV") else "bad.b5r")
    bad.write_text(text, encoding="utf-8")
    put(tmp_path, good=csv_of(), x=POSITIONING)
    code, document, messages = answer(capsys, tmp_path)
    assert code == 3
    assert [result["name"] for result in document["results"]] == ["good", "x"]
    assert {error["file"] for error in document["errors"]} == {str(bad)}
    assert all(part in " ".join(error["message"] for error in document["errors"]) for part in parts)
    lines = messages.splitlines()
    assert 1 <= len(lines) <= 2  # one per direction where both are wrong
    assert all(line.startswith(f"error: {bad}: ") for line in lines)


def test_the_sound_file_of_the_bad_ones_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "sound.b5r").write_text(SOUND, encoding="utf-8")
    code, document, _ = answer(capsys, tmp_path)
    assert (code, document["results"][0]["kind"]) == (0, "circular")


# --- the terminal
# --------------------------------------------------------------------------------------------------


def shown(document: Mapping[str, Any], width: int) -> str:
    console = Console(width=width, force_terminal=False, color_system=None)
    with console.capture() as captured:
        for part in evaluation_renderables(document):
            console.print(part)
    return captured.get()


def test_the_terminal_shows_the_documents_numbers_at_80_columns(tmp_path: Path) -> None:
    put(tmp_path, x=POSITIONING, xy=csv_of())
    document = evaluate_files(Session(), [tmp_path]).document
    text = shown(document, 80)
    assert all(len(line.rstrip()) <= 80 for line in text.splitlines())
    assert "…" not in text
    assert text.index("x.csv · axis X") < text.index("xy.csv · circle XY")
    result = document["results"][1]
    values = result["parameters"]
    rows = {line[:33].strip(): line[33:].replace("−", "-").split() for line in text.splitlines()}
    g = [f"{values[name]:.2f}" for name in ("G_ccw", "G_cw", "G_bidirectional")]
    assert rows["Circular deviation, minimum zone"] == ["G", *g]
    assert rows["Radial deviation, smallest"][2:] == [
        f"{values[name]:.2f}" for name in ("F_min_ccw", "F_min_cw")
    ]
    assert rows["Mean radial deviation"] == ["D", f"{values['D']:+.2f}"]
    assert "about the least-squares centre" not in text  # the same as F on a full circle
    assert "Circular hysteresis" not in text  # not of 2005: why stands below
    lines = [line for line in text.splitlines() if re.search(r" ± .* %", line)]
    squareness = next(line for line in lines if line.startswith("Squareness XY"))
    entry = result["diagnosis"]["squareness"]
    assert f"{entry['value']:.1f} ± {entry['std_error']:.1f}" in squareness
    assert squareness.split()[-4:] == [
        f"{entry['effect']:.2f}",
        f"{100 * entry['share']:.0f}",
        "%",
        f"{result['plain']['squareness']:.1f}",
    ]
    effects = [float(line.split()[-4 if line.split()[-2] == "%" else -3]) for line in lines]
    assert effects == sorted(effects, reverse=True)
    assert effects[0] > 1.0


@needs_shared
def test_the_terminal_shows_what_the_instrument_printed() -> None:
    text = shown(evaluate_files(Session(), [BALLBAR / name for name in FILES]).document, 80)
    assert all(len(line.rstrip()) <= 80 for line in text.splitlines())
    assert "…" not in text.replace("(…)", "")
    assert "Printed in the file: G 7.2 / 6.7 / 7.2, D −5.7 µm" in text
    assert "— F ccw, F cw: the length of the bar was not calibrated" in text
    assert re.search(
        r"Squareness XY +31\.\d .* 31$|Squareness XY +30\.\d .* 31$", text, re.MULTILINE
    )
    assert re.search(r"Lateral play X .* 1\.4$", text, re.MULTILINE)
    assert re.search(r"Lateral play Y .* 0\.6$", text, re.MULTILINE)
    assert re.search(
        r"Scale mismatch Z − X .*\(−3\.3\)$", text, re.MULTILINE
    )  # which the instrument calls not valid


# --- what is loaded
# --------------------------------------------------------------------------------------------------


def test_positioning_loads_nothing_circular_and_circles_nothing_heavy(tmp_path: Path) -> None:
    put(tmp_path, x=POSITIONING, xy=csv_of())
    code = (
        "import sys; from pathlib import Path; from compwright.workflow.results.answers import"
        " to_json;from compwright.foundations.session import Session;"
        "from compwright.workflow.commands.evaluate import"
        " evaluate_files;to_json(evaluate_files(Session(), [Path(sys.argv[1])]).document);print(sorted(m"
        " for m in sys.modules if m.startswith('compwright.') and 'circ' in m or m in ('scipy',"
        " 'cvxpy', 'matplotlib', 'pydantic', 'rich', 'xml', 'compwright.instruments.b5r')))"
    )
    environment = {**os.environ, "PYTHONPATH": str(PROJECT / "src")}

    def loaded(name: str) -> str:
        command = [sys.executable, "-c", code, str(tmp_path / name)]
        return subprocess.run(
            command, capture_output=True, text=True, check=True, env=environment
        ).stdout.strip()

    assert loaded("x.csv") == "[]"
    circular = loaded("xy.csv")
    assert "compwright.evaluation.circular" in circular
    assert not re.search("scipy|cvxpy|matplotlib|pydantic|rich", circular)


def test_several_runs_of_a_direction_stay_one_test(tmp_path: Path) -> None:
    """A file with two ccw and one cw is whole by itself: nothing is sought for it."""
    test = measured(MACHINE, Setup(radius=100.0, feed=1000.0, samples=360))
    extra = replace(test.runs[0], number=2)
    lines = [
        line
        for line in csv_of(setup=Setup(radius=100.0, feed=1000.0, samples=360)).splitlines()
        if line.startswith("#")
    ]
    lines.append("direction,run,angle_deg,deviation_um")
    for run in (*test.runs, extra):
        lines += [
            f"{run.sense},{run.number},{a:.6f},{d * 1000:.5f}"
            for a, d in zip(run.angles, run.deviations, strict=True)
        ]
    put(tmp_path, whole="\n".join(lines) + "\n", single=csv_of("cw"))
    assert names_and_codes(tmp_path) == [("single", 1, []), ("whole", 1, [])]
