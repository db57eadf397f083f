"""The machines of `benchmarks/bench_circle.py`: their geometry by the first-order formulas of the
circular test (ISO 230-4 diagnosis), their bound, and the squareness that is read from them.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from bench_circle import evaluated
from examiner_circles import TURNS, Array, Circle, circle, quiet

from compwright.foundations.own_faults import OWN_FAULT
from compwright.foundations.session import Session
from compwright.planning import circle_network
from compwright.workflow.commands.evaluate import evaluate_files, write_evaluation

R, V = 150.0, 1000.0 / 60.0  # mm, mm/s


def both_ends(name: str, value: float) -> dict[str, float]:
    return {f"{name}_at_positive": value, f"{name}_at_negative": value}


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"squareness": 30.0}, lambda t, _: -0.030 * R / 2 * np.sin(2 * t)),
        ({"scale_error_first": 30.0}, lambda t, _: 0.030 * R * np.cos(t) ** 2),
        ({"scale_error_second": 30.0}, lambda t, _: 0.030 * R * np.sin(t) ** 2),
        ({"lag_first": 0.2}, lambda t, d: d * V * 0.2 / 2 * np.sin(2 * t)),
        (both_ends("backlash_first", 4.0), lambda t, d: 2 * d * np.sign(np.sin(t)) * np.cos(t)),
        (both_ends("backlash_second", 4.0), lambda t, d: -2 * d * np.sign(np.cos(t)) * np.sin(t)),
        ({"lateral_play_first": 3.0}, lambda t, d: -1.5 * d * np.abs(np.sin(t))),
        ({"lateral_play_second": 3.0}, lambda t, d: 1.5 * d * np.abs(np.cos(t))),
        ({"straightness_first": 3.0}, lambda t, _: 3 * np.cos(t) ** 2 * np.sin(t)),
        (
            {"cyclic_first": 2.0},
            lambda t, _: 2 * np.cos(2 * np.pi * R * np.cos(t) / 10) * np.cos(t),
        ),
        ({"radius_change": 0.7}, lambda t, d: 0.7 * d + 0 * t),
    ],
)
def test_geometry(values: dict[str, float], expected: Callable[[Array, float], Array]) -> None:
    """Terms in µm; what is left is of second order."""
    test = Circle(values={**quiet(), **values}, radius=R, feed=60 * V)
    for sense, sign in TURNS.items():
        angles = np.radians(test.angles(sense))
        found = 1e3 * test.readings(sense)
        np.testing.assert_allclose(found, expected(angles, sign), atol=0.002)


@pytest.mark.parametrize("friction", ["peak", "creep", "stand"])
@pytest.mark.parametrize("height", [5.0, -5.0])
def test_a_spike_has_its_height_after_its_own_reversal_alone(friction: str, height: float) -> None:
    values = {**quiet(), "reversal_spike_second_at_negative": height}
    test = Circle(values=values, radius=R, feed=60 * V, samples=36000, friction=friction)
    for sense, sign in TURNS.items():
        read, angles = 1e3 * test.readings(sense), test.angles(sense)
        after = sign * (angles - 270.0)
        assert np.max(read * np.sign(height)) == pytest.approx(5.0, rel=0.02)
        assert np.max(np.abs(read[(after < 0.0) | (after > 8.0)])) < 0.1
    assert test.peaks()["second_at_negative"] == pytest.approx(height, rel=0.02)


def test_bound() -> None:
    """Least squares by hand: one cause, white noise, the others known to be zero."""
    test = Circle(values={**quiet(), "squareness": 20.0}, noise=0.3)
    angles = np.radians(test.angles("ccw"))
    alone = 0.3 / np.sqrt(2 * np.sum((-1e-3 * R / 2 * np.sin(2 * angles)) ** 2))
    assert alone < test.bound()["squareness"] < 1.5 * alone


@pytest.mark.parametrize("number", [0, 1, 2, 3])
def test_squareness_where_the_circle_shows_it(number: int, tmp_path: Path) -> None:
    """Within three standard errors; an arc in which no axis reverses has none."""
    rng = np.random.default_rng([7, number])
    whole = circle(rng, "360")
    found = evaluated(whole, rng, tmp_path / "c.csv")["diagnosis"]["squareness"]
    assert whole.determinable(whole.bound())
    assert abs(found["value"] - whole.values["squareness"]) < 3 * found["std_error"]
    arc = circle(rng, "90 between")
    answer = evaluated(arc, rng, tmp_path / "a.csv")
    assert "errors" not in answer
    assert answer["diagnosis"] is None or answer["diagnosis"]["squareness"]["value"] is None


def test_a_spike_before_the_arc_lasts_into_it(tmp_path: Path) -> None:
    """The clockwise run enters 3° after its first axis reversed; the spike there decays over 8°."""
    spikes = both_ends("reversal_spike_first", 8.0)
    decays = {f"decay_{name}": 0.2 for name in both_ends("first", 0.0)}
    values = {**quiet(), "squareness": 60.0, **both_ends("backlash_first", 3.0), **spikes, **decays}
    arc = Circle(values=values, radius=50.0, feed=2000.0, start=119.0, extent=238.0, overshoot=45.0)
    found = evaluated(replace(arc, samples=1000), np.random.default_rng(3), tmp_path / "a.csv")
    entry = found["diagnosis"]["squareness"]
    assert abs(entry["value"] - 60.0) < 4.0 * entry["std_error"]
    assert entry["std_error"] < 5.0 * arc.bound()["squareness"]
    assert found["diagnosis"]["reversal_spike_first_at_positive"]["value"] is None


#: The causes of the outside contract, in the order of its text.
CONTRACT = {
    *("squareness", "scale_mismatch", "servo_mismatch", "radius_change", "backlash_mismatch"),
    *("vibration", "master_slave", "spiral", "lobes_2", "lobes_3", "positional_tolerance"),
    *(
        f"{cause}_{axis}{end}"
        for axis in ("first", "second")
        for cause in ("backlash", "reversal_spike")
        for end in ("", "_at_positive", "_at_negative")
    ),
    *(
        f"{cause}_{axis}"
        for axis in ("first", "second")
        for cause in (
            *("scale_error", "lateral_play", "cyclic", "straightness"),
            *("offset_change", "stick_slip"),
        )
    ),
}


@pytest.mark.parametrize(("kind", "number", "most"), [("220", 865, 5.0), ("any arc", 990, 8.0)])
def test_a_vibration_hides_no_cyclic_error(
    kind: str, number: int, most: float, tmp_path: Path
) -> None:
    """Vibrations of 1.4 and 1.0 µm with cyclic errors of 1.7 and 1.0 µm: each was noise to the
    other (0.02 ± 0.02 µm of 1.0 µm; squareness ± 16 and ± 44 µm/m). The arc of the second one turns
    a lobe of 0.03 µm into several µm/m of squareness: its error is 7.
    """
    rng = np.random.default_rng([281170, number])
    test = circle(rng, kind)
    causes = evaluated(test, rng, tmp_path / "c.csv")["diagnosis"]
    for name, limit in {"cyclic_first": 0.05, "vibration": 0.05, "squareness": most}.items():
        found = causes[name]
        assert found["value"] == pytest.approx(test.truth()[name], abs=3.0 * found["std_error"])
        assert found["std_error"] < limit


def test_causes_that_a_test_cannot_have_are_null_with_a_reason(tmp_path: Path) -> None:
    tests = {
        "whole": Circle(values=quiet(), samples=300),
        "one_way": Circle(values=quiet(), samples=300, senses=("cw",), calibrated=False),
        "arc": Circle(values=quiet(), samples=300, start=20.0, extent=100.0),
    }
    answers = {}
    for name, test in tests.items():
        rng = np.random.default_rng(4)
        answers[name] = evaluated(test, rng, tmp_path / f"{name}.csv")
    for answer in answers.values():
        assert set(answer["diagnosis"]) >= {*answers["whole"]["diagnosis"], *CONTRACT}
        for name, entry in answer["diagnosis"].items():
            ratio = name == "squareness" or name.startswith("scale_error")
            assert entry["unit"] == (
                "ms" if name == "servo_mismatch" else "um/m" if ratio else "um"
            )
            if entry["value"] is None:
                assert answer["not_applicable"][name]
                assert entry["std_error"] is None or entry["std_error"] > 0.0
            else:
                assert entry["std_error"] > 0.0
    absent = {name for name, e in answers["one_way"]["diagnosis"].items() if e["value"] is None}
    assert absent >= {"radius_change", "offset_change_first", "scale_error_second"}


def test_several_circles_show_one_machine(tmp_path: Path) -> None:
    """Two feeds tell scale and position loop apart; a circle of another squareness is named, and
    one that states another machine is left out.
    """
    loops, scales = {"X": 30.0, "Y": 25.0}, {"X": 40.0, "Y": -15.0}
    values = {
        **quiet(),
        "squareness": 25.0,
        "lag_first": loops["X"],
        "lag_second": loops["Y"],
        "scale_error_first": scales["X"],
        "scale_error_second": scales["Y"],
        **both_ends("backlash_first", 4.0),
    }
    slow = Circle(values=values, radius=R, feed=500.0, noise=0.1, samples=500)
    files = {"slow": slow, "fast": replace(slow, feed=4000.0)}
    for seed, (name, test) in enumerate(files.items()):
        test.write(tmp_path / f"{name}.csv", np.random.default_rng(seed))
    strange = replace(slow, values={**values, "squareness": -80.0})
    text = strange.text(np.random.default_rng(7))
    (tmp_path / "strange.csv").write_text(f"# machine: other\n{text}", encoding="utf-8")
    (machine,) = evaluate_files(Session(), [tmp_path]).document["machines"]
    assert sorted(machine["circles"]) == ["fast", "slow"]
    assert machine["contradictions"] == []
    expected = {
        "squareness": {"XY": 25.0},
        "scale_error": scales,
        "backlash": {"X": 4.0, "Y": 0.0},
        "position_loop": loops,
    }
    assert set(machine["causes"]) == set(expected)
    for cause, true in expected.items():
        assert set(machine["causes"][cause]) == set(true)
        for name, value in true.items():
            found = machine["causes"][cause][name]
            assert abs(found["value"] - value) < max(3.0 * found["std_error"], 0.01 * value), cause

    job = r"circles: \[\{file: [^{]*fast.csv[^{]*\{file: [^{]*slow.csv[^{]*\]"
    assert len(re.findall(job, _page(tmp_path))) == 2  # on the page of each

    copied = tmp_path / "copied.csv"
    copied.write_bytes((tmp_path / "slow.csv").read_bytes())
    document = evaluate_files(Session(), [tmp_path]).document
    assert len(document["results"]) == 4
    assert document["machines"][0]["causes"] == machine["causes"]  # a copy proves nothing more
    repeated = {
        result["name"]
        for result in document["results"]
        if "CW-T034" in {finding["code"] for finding in result["findings"]}
    }
    assert repeated == {"slow", "copied"}
    copied.unlink()

    (tmp_path / "strange.csv").write_text(text, encoding="utf-8")
    (machine,) = evaluate_files(Session(), [tmp_path]).document["machines"]
    (contradiction,) = machine["contradictions"]
    assert contradiction["cause"] == "squareness"
    seen = {one["name"]: one["value"] for one in contradiction["circles"]}
    assert seen == pytest.approx({"slow": 25.0, "fast": 25.0, "strange": -80.0}, abs=1.0)
    assert "CW-P110" in {finding["code"] for finding in machine["findings"]}
    page = _page(tmp_path)
    each = machine["causes"]["squareness"]["XY"]
    row = f'>Squareness XY</td><td class="n">{each["value"]:.1f} ± {each["std_error"]:.1f}</td>'
    assert row in page.replace("−", "-")
    assert "state no machine and no serial number" in page
    assert "contradict each other" in page
    assert "squareness: {" not in page  # no job corrects what the circles contradict each other in


def _page(folder: Path) -> str:
    """Return the report of the circles of a folder."""
    document = evaluate_files(Session(), [folder]).document
    (path,) = write_evaluation(Session(), document, report_path=folder / "r.html", force=True)
    text = path.read_text(encoding="utf-8")
    path.unlink()
    return text


def test_a_fault_of_several_circles_names_their_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The circles one by one are evaluated, and nothing ends in a traceback."""

    def broken(_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(circle_network, "solve_network", broken)
    for seed, name in enumerate(("a", "b")):
        Circle(values=quiet(), samples=200).write(
            tmp_path / f"{name}.csv", np.random.default_rng(seed)
        )
    run = evaluate_files(Session(), [tmp_path])
    assert run.exit_code == OWN_FAULT
    assert len(run.document["results"]) == 2
    (error,) = run.document["errors"]
    assert {"a.csv", "b.csv"} <= set(re.findall(r"\w+\.csv", str(error)))
