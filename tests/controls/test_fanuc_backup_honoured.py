"""A FANUC backup as it comes: whatever acts on an axis or shares its numbers is read and honoured,
or refuses the axis by name.

The files are small copies of a real backup (CNC software D4G3): all axes in one line, P for
lengths, Q0 for pitch data and Q1 for parameters, also above 10000; X from number 1 to 41 with 40
mm, a rotary B with 3621 = 3620 + 1. The virtual machine is plain: what the control adds is summed
by hand from the numbers (FANUC 0i-PB parameter manual B-63980EN/01 p. 100; 1851: B-64120EN/01 p.
116).
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from compwright.cli import run as compwright
from compwright.records.axis import FloatArray

pytestmark = pytest.mark.short_estimate

#: By parameter: X, Y, Z, B, and the letter of the owner; the real machine's values where they
#: matter.
PARAMETERS: dict[int, tuple[str, ...]] = {
    981: ("1", "1", "1", "1"),
    1006: ("00000000", "00000000", "00000000", "00000001"),
    1013: ("00000000",) * 4,
    1020: ("88", "89", "90", "66"),
    1260: ("0.0", "0.0", "0.0", "360.0"),
    1320: ("1.0", "1.0", "30.0", "360.0"),
    1321: ("-1000.0", "-1101.0", "-781.0", "-360.0"),
    1420: ("24000.0", "24000.0", "24000.0", "3600.0"),
    1820: ("20", "20", "20", "20"),
    1848: ("0",) * 4,
    1851: ("40", "10", "20", "-4"),
    1852: ("10", "10", "-10", "-4"),
    3605: ("00000010",) * 4,
    3620: ("40", "140", "240", "300"),
    3621: ("1", "101", "201", "301"),
    3622: ("41", "141", "241", "312"),
    3623: ("10", "10", "10", "1"),
    3624: ("40.0", "27.5", "27.5", "30.0"),
    3625: ("0.0",) * 4,
    3626: ("0",) * 4,
    3627: ("0",) * 4,
    5861: ("0",) * 4,
    5864: ("0",) * 4,
    5871: ("0",) * 4,
    14985: ("0",) * 4,
    14986: ("0",) * 4,
    14987: ("0.0",) * 4,
}
BY_PATH = {
    1001: "00000000",
    1800: "00011000",
    5711: "0",
    5721: "0",
    5731: "0",
    5761: "0",
    10800: "0",
    13391: "0",
}
OF_MACHINE = {3602: "00000000", 10342: "0"}
POINTS = {n: -1 if n % 3 else 1 for n in (*range(1, 41), *range(101, 141), *range(201, 241))} | {
    310: 10,
    311: -10,
}
AXES = {"X": 1, "Y": 2, "Z": 3, "B": 4}
TRAVEL = {"X": (-1000.0, 0.0), "Y": (-1100.0, 0.0), "Z": (-780.0, 0.0), "B": (0.0, 360.0)}
UNIT = 1e-4  # 0.001 / CMR 10, mm or deg: 1820 = 20 (B-63943EN-1/02 p. 109)

#: Edits of the backup: parameter and owner (axis number, ``L1``, or nothing) -> value.
Edits = Mapping[tuple[int, str], str]


def backup(edits: Edits = {}) -> str:  # noqa: B006  # never changed
    def value(number: int, owner: str, usual: str) -> str:
        return edits.get((number, owner), usual)

    rows = {
        number: "".join(f"A{k}P{value(number, str(k), text)}" for k, text in enumerate(texts, 1))
        for number, texts in PARAMETERS.items()
    }
    rows |= {
        number: "".join(f"L{k}P{value(number, f'L{k}', text)}" for k in (1, 2))
        for number, text in BY_PATH.items()
    }
    rows |= {number: f"P{value(number, '', text)}" for number, text in OF_MACHINE.items()}
    for (number, owner), text in edits.items():
        rows.setdefault(number, f"{owner if owner.startswith('L') else f'A{owner}'}P{text}")
    return "%\n" + "".join(f"N{number:05d}Q1{rows[number]} \n" for number in sorted(rows)) + "%"


def pitch(points: Mapping[int, int] = POINTS) -> str:
    return "%\n" + "".join(f"N{10_000 + n}Q0P{points.get(n, 0)}\n" for n in range(1536)) + "%"


def said(text: str, number: int, axis: int) -> str:
    line = next(line for line in text.splitlines() if line.startswith(f"N{number:05d}Q1"))
    found = re.search(rf"A{axis}[PMI](-?[\d.]+)", line)
    assert found is not None
    return found[1]


def data(text: str) -> dict[int, int]:
    return {
        int(number) - 10_000: int(value)
        for number, value in re.findall(r"^N(1\d{4})Q0P(-?\d+)", text, re.MULTILINE)
    }


def added(
    parameters: str, points: Mapping[int, int], axis: int, x: FloatArray, sign: int, *,
    rapid: bool = False, unit: float = UNIT,
    inch: bool = False,
) -> FloatArray:  # fmt: skip
    """What the control adds, mm or deg: sums of increments from the reference, out in the middle of
    a section, and backlash.
    """
    r, first, last, k = (int(said(parameters, number, axis)) for number in (3620, 3621, 3622, 3623))
    total = np.zeros_like(x)
    if k and first != last:
        interval = float(said(parameters, 3624, axis)) * (25.4 if inch else 1.0)
        nodes = np.arange(first - 1, last + 1) - r
        sums = np.concatenate([[0], np.cumsum([points.get(n, 0) for n in range(first, last + 1)])])
        sums = sums - np.interp(0, nodes, sums)
        place = np.mod(x, 360.0) if said(parameters, 1006, axis)[-2:] == "01" else x
        total = (
            k
            * unit
            * sums[
                np.clip(np.floor(place / interval + 0.5) - nodes[0], 0, sums.size - 1).astype(int)
            ]
        )
    backlash = int(said(parameters, 1852 if rapid else 1851, axis)) * unit
    return total if sign > 0 else total - backlash


def error(axis: int, x: FloatArray, sign: int) -> FloatArray:
    """Mechanics: mm on 1, 2, 3; deg on 4, where it repeats with the turn. Lost motion 4 µm, 3
    arcsec.
    """
    if axis == 4:
        turn = np.radians(x)
        return np.asarray(
            0.002 * np.sin(turn + 1) + 0.0008 * np.sin(2 * turn) + (0.0008 if sign < 0 else 0.0)
        )
    return np.asarray(-2e-5 * x + 0.006 * np.sin(x / 140 + axis) + (0.004 if sign < 0 else 0.0))


class Bench:
    """A folder with a backup, measurements with the backup's tables acting, and a job."""

    def __init__(
        self,
        folder: Path,
        edits: Edits = {},  # noqa: B006
        *,
        points: Mapping[int, int] | None = POINTS,
        **words: Any,
    ) -> None:
        self.folder, self.points, self.words = folder, points or {}, words
        self.parameters = backup(edits)
        (folder / "CNC-PARA.TXT").write_text(self.parameters)
        if points is not None:
            (folder / "PITCH.TXT").write_text(pitch(points))
        self.state = "[CNC-PARA.TXT" + (", PITCH.TXT]" if points is not None else "]")

    def measure(self, name: str, targets: FloatArray | None = None) -> None:
        low, high = TRAVEL[name]
        axis = AXES[name]
        rng = np.random.default_rng(axis)
        dithered = np.linspace(low, high, 13) + np.array([0, *rng.uniform(-5, 5, 11), 0])
        x = np.round(dithered, 3) if name != "B" else np.arange(0.0, 361.0, 30.0)
        x = x if targets is None else targets
        unit = "deg" if name == "B" else "mm"
        rows = [f"target_{unit},direction,run,deviation_{unit}"]
        for sign, mark in ((1, "+"), (-1, "-")):
            mean = error(axis, x, sign) + added(
                self.parameters, self.points, axis, x, sign, **self.words
            )
            for run in range(1, 4):
                noisy = mean + rng.normal(0, 0.0003, x.size)
                rows += [
                    f"{position:g},{mark},{run},{value:.6f}"
                    for position, value in zip(x, noisy, strict=True)
                ]
        (self.folder / f"{name}.csv").write_text("\n".join(rows) + "\n")

    def run(
        self,
        *names: str,
        options: str = "",
        axes: Mapping[str, str] = {},
        targets: FloatArray | None = None,
    ) -> int:
        job = (
            f"compwright: 1\ncontroller: {{format: fanuc-30i{options}}}\nstates: {{as_found:"
            f" {self.state}}}\naxes:\n"
        )
        for name in names:
            self.measure(name, targets)
            low, high = TRAVEL[name]
            usual = {
                "travel": f"[{low:g}, {high:g}]",
                "address": str(AXES[name]),
                "before": f"[{name}.csv]",
            }
            usual |= {"kind": "rotary", "modulo": "360"} if name == "B" else {}
            more = dict(re.findall(r"(\w+): (\[.*?\]|\{.*?\}|[^,]+)", axes.get(name, "")))
            words = {key: text for key, text in {**usual, **more}.items() if text.strip() != "-"}
            job += f"  {name}: {{{', '.join(f'{key}: {text}' for key, text in words.items())}}}\n"
        (self.folder / "job.yaml").write_text(job)
        return compwright(["run", str(self.folder / "job.yaml")])

    def written(self) -> tuple[str, dict[int, int]]:
        files = {
            path.name: path.read_text()
            for path in (self.folder / "job" / "tables" / "fanuc-30i").iterdir()
        }
        return files["CNC-PARA.TXT"], data(
            "\n".join(text for name, text in files.items() if name.startswith("PITCH"))
        )

    def left(self, name: str) -> float:
        """Range of what is left over the travel and both directions, mm or deg, with the written
        files loaded.
        """
        parameters, points = self.written()
        x, axis = np.linspace(*TRAVEL[name], 301), AXES[name]
        return float(
            np.ptp([error(axis, x, sign) + added(parameters, points, axis, x, sign,
            **self.words) for sign in (1, -1)])
        )  # fmt: skip

    def changed(self) -> set[tuple[int, str]]:
        """Parameter and owner of every value that differs from the backup's; bytes outside values
        must not differ.
        """
        old, new = self.parameters.split("\n"), self.written()[0].split("\n")
        assert len(old) == len(new)
        found = set()
        for one, other in zip(old, new, strict=True):
            assert re.sub(r"P-?[\d.]+", "P", one) == re.sub(r"P-?[\d.]+", "P", other)
            groups = [re.findall(r"([AL]?\d*)P(-?[\d.]+)", line[8:]) for line in (one, other)]
            found |= {(int(one[1:6]), a[0]) for a, b in zip(*groups, strict=True) if a != b}
        return found


#: Three runs of noise 0.3 µm and steps of the table: what is left of some 20 µm stays well below
#: this, mm.
SMALL = 0.0025


# Pitch data and parameters (Q0, Q1)
# ----------------------------------------------------------------------------------------

OFF = {(3623, str(axis)): "0" for axis in (1, 2, 3, 4)}


def test_parameters_above_10000_stay_when_there_is_no_pitch_file(tmp_path: Path) -> None:
    bench = Bench(tmp_path, {**OFF, (10342, ""): "0"}, points=None)
    assert bench.run("X") == 0
    assert {number for number, _ in bench.changed()} <= {1851, 1852, 3620, 3621, 3622, 3623, 3624}
    assert bench.left("X") < SMALL


def test_a_table_that_is_on_needs_its_pitch_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    bench.state = "[CNC-PARA.TXT]"
    assert bench.run("X") == 3
    assert "no file that was given contains pitch data" in capsys.readouterr().err


def test_compare_says_that_a_file_holds_no_pitch_data(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X") == 0
    loaded = tmp_path / "job" / "tables" / "fanuc-30i" / "CNC-PARA.TXT"
    assert (
        compwright(["compare", str(tmp_path / "job" / "plan.json"), "--loaded", str(loaded)]) == 3
    )
    assert "no file that was given contains pitch data" in capsys.readouterr().err


# What else acts, and what points to the numbers
# ----------------------------------------------------------------------------

ACTING: dict[str, tuple[dict[tuple[int, str], str], str]] = {
    "totals": ({(3602, ""): "00000001"}, "3602"),
    "a neighbour's cyclic table in its numbers": (
        {(14985, "2"): "30", (14986, "2"): "35", (14987, "2"): "2.0"},
        "14985",
    ),
}


@pytest.mark.parametrize("what", ACTING)
def test_what_acts_on_the_axis_refuses_it_by_name(
    what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edits, named = ACTING[what]
    assert Bench(tmp_path, edits).run("X") == 3
    said = capsys.readouterr().err
    assert f"parameter {named}" in said
    assert "axis 1" in said


def test_numbers_that_hold_data_or_are_pointed_to_are_never_taken(tmp_path: Path) -> None:
    edits = {
        **{
            (number, "1"): "0" for number in (3620, 3621, 3622, 3623)
        },  # X has no numbers of its own; its old data still stand
        (14985, "2"): "400",
        (14986, "2"): "419",
        (14987, "2"): "2.0",
        (5861, "3"): "330",
    }
    bench = Bench(tmp_path, edits, points=POINTS | {600: 5})
    assert bench.run("X") == 0
    parameters, points = bench.written()
    taken = range(int(said(parameters, 3621, 1)), int(said(parameters, 3622, 1)) + 1)
    assert not set(taken) & {*POINTS, *range(300, 313), *range(400, 420), 330, 600}
    assert {n: points[n] for n in POINTS} == POINTS
    assert bench.left("X") < SMALL


def test_without_files_the_first_free_number_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path, OFF, points=None)
    bench.state = "none"
    assert bench.run("X", options=f", options: {{detection_unit: {UNIT}}}") == 2
    said_first = capsys.readouterr().err
    assert "controller.options.first_point" in said_first
    assert "pitch files" in said_first
    assert (
        bench.run(
            "X",
            "Y",
            options=f", options: {{detection_unit: {UNIT}}}",
            axes={"X": "options: {first_point: 500}"},
        )
        == 0
    )
    folder = tmp_path / "job" / "tables" / "fanuc-30i"
    x, y = ((folder / f"PARAM_{axis}.TXT").read_text() for axis in (1, 2))
    assert int(said(x, 3621, 1)) == 500
    assert int(said(y, 3621, 2)) == int(said(x, 3622, 1)) + 1


NO_NUMBERS = {(number, "1"): "0" for number in (3620, 3621, 3622, 3623)}


def test_numbers_of_which_no_file_speaks_are_not_free(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A pitch file that ends at number 399, X without numbers of its own: what 400 and on hold only
    the control knows.
    """
    bench = Bench(tmp_path, NO_NUMBERS)
    file = tmp_path / "PITCH.TXT"
    file.write_text(
        "\n".join(
            line
            for line in file.read_text().splitlines()
            if not line.startswith(("N104", "N105", "N11"))
        )
    )
    cut = file.read_text()
    assert bench.run("X") == 0
    parameters, points = bench.written()
    assert int(said(parameters, 3622, 1)) < 400 or int(said(parameters, 3621, 1)) >= 600
    written = data(cut).keys()
    assert points.keys() == written


def test_without_pitch_data_an_axis_without_numbers_asks(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path, {**OFF, **NO_NUMBERS}, points=None)
    assert bench.run("X") == 2
    assert "first_point" in capsys.readouterr().err
    assert bench.run("X", options=", options: {first_point: 700}") == 0
    assert bench.left("X") < SMALL


def test_old_numbers_of_another_axis_of_the_job_stay_its_own(tmp_path: Path) -> None:
    """X needs more numbers than it has; those that Y leaves hold Y's old table until Y's new one is
    loaded.
    """
    bench = Bench(tmp_path)
    assert bench.run("X", "Y", "B", axes=dict.fromkeys("XY", "table: {spacing: 10}")) == 0
    parameters, _ = bench.written()
    x = set(range(int(said(parameters, 3621, 1)), int(said(parameters, 3622, 1)) + 1))
    y = set(range(int(said(parameters, 3621, 2)), int(said(parameters, 3622, 2)) + 1))
    assert not x & {*range(101, 142), *range(300, 313)}
    assert not y & {*range(1, 42), *range(300, 313)}


def test_the_direction_of_the_reference_return_is_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """1006#5 = 1: towards -. Two sets hang on it; with one set the job is followed and the
    contradiction named.
    """
    minus = {(1006, "1"): "00100000"}
    bench = Bench(
        tmp_path, {**minus, (3605, "1"): "00000001", (3626, "1"): "700", (3627, "1"): "5"}
    )
    assert bench.run("X") == 3
    assert "1006#5" in capsys.readouterr().err
    (tmp_path / "one").mkdir()
    bench, tmp_path = Bench(tmp_path / "one", minus), tmp_path / "one"
    assert bench.run("X", axes={"X": "table: {mode: bidirectional}"}) == 4
    assert "1006#5" in capsys.readouterr().err
    assert bench.run("X") == 0
    assert "CW-S044" in capsys.readouterr().out
    words = [
        "--from",
        str(tmp_path / "CNC-PARA.TXT"),
        "--from",
        str(tmp_path / "PITCH.TXT"),
        "--format",
        "fanuc-30i",
    ]
    assert compwright(["new", *words, "--out", str(tmp_path / "new.yaml")]) == 0
    text = (tmp_path / "new.yaml").read_text()
    assert 'reference_return: "-"' in text[text.index("\n  X:") :].partition("before:")[0]


# Detection unit
# --------------------------------------------------------------------------------------------------


def test_the_detection_unit_is_read_and_a_contradiction_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X", options=", options: {detection_unit: 0.001}") == 3
    told = capsys.readouterr().err
    for part in ("0.0001 mm", "1820 = 20", "1013", "detection_unit: 0.001"):
        assert part in told
    assert bench.run("X") == 0
    assert bench.left("X") < SMALL


@pytest.mark.parametrize(
    ("edits", "unit", "inch"),
    [
        ({(1820, "1"): "2"}, 1e-3, False),
        ({(1820, "1"): "2", (1013, "1"): "00000010"}, 1e-4, False),
        ({(1820, "1"): "4", (1013, "1"): "00000001"}, 5e-3, False),
        ({(1001, "L1"): "00000001", (3624, "1"): "1.5", (1420, "1"): "945.0"}, 2.54e-4, True),
    ],
)
def test_the_unit_follows_multiplier_system_and_inch(
    edits: Edits, unit: float, inch: bool, tmp_path: Path
) -> None:
    bench = Bench(tmp_path, edits, unit=unit, inch=inch)
    assert bench.run("X") == 0
    assert bench.left("X") < SMALL + 2 * unit
    plan = json.loads((tmp_path / "job" / "plan.json").read_text())
    assert f"{unit:g} mm" in json.dumps(plan)


@pytest.mark.parametrize(
    "line", ["N01820Q1A1P2", "N00981Q1A1P2", "N01800Q1L1P00000000", "N01420Q1A1P99000.0"]
)
def test_a_parameter_that_stands_there_twice_is_refused(
    line: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two saves in one file, or a second file: which of the values the control has nobody can
    tell.
    """
    bench = Bench(tmp_path)
    file = tmp_path / "CNC-PARA.TXT"
    file.write_text(bench.parameters.replace("N01851", f"{line}\nN01851"))
    assert bench.run("X") == 3
    assert f"parameter {int(line[1:6])}" in capsys.readouterr().err
    file.write_text(
        bench.parameters.replace(
            "N01851", f"{line.replace('A1', 'A2').replace('L1', 'L9')}\nN01851"
        )
    )
    assert bench.run("X") == 0


@pytest.mark.parametrize("newline", ["\r\n", "\n\r\r"])
def test_other_line_ends_are_read_and_kept(newline: str, tmp_path: Path) -> None:
    """Backups with LF CR CR are known from the field; 1820, 1013 and 1006 stand in lines that begin
    behind a CR there.
    """
    bench = Bench(tmp_path)
    for name in ("CNC-PARA.TXT", "PITCH.TXT"):
        path = tmp_path / name
        path.write_bytes(path.read_text().replace("\n", newline).encode())
    assert bench.run("X") == 0
    written = (tmp_path / "job" / "tables" / "fanuc-30i" / "CNC-PARA.TXT").read_bytes()
    assert written.count(newline.encode()) == bench.parameters.count("\n") == written.count(b"\n")


def test_a_reference_beside_machine_zero_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """No page says whether the points are counted from machine zero or from the reference position:
    a table is made only for the latter, and only where the job says so.
    """
    bench = Bench(tmp_path, {(1240, "1"): "-480.0"})
    assert bench.run("X", axes={"X": "reference: -480"}) == 2
    assert bench.run("X", axes={"X": "reference: -480"}, options=FROM_ZERO) == 2
    said = capsys.readouterr().err
    assert said.count("points_from") >= 2
    assert said.count("1240") == 2
    assert not (tmp_path / "job").exists()
    assert bench.run("X", axes={"X": "reference: -480"}, options=FROM_REFERENCE) == 0
    prediction = json.loads((tmp_path / "job" / "prediction.json").read_text())
    assert not any(doubt["code"] == "CW-S018" for doubt in prediction["doubts"])


FROM_ZERO = ", options: {points_from: machine_zero}"
FROM_REFERENCE = ", options: {points_from: reference}"


def test_a_reference_that_cannot_be_read_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A length without a point, which this series does not write: -500 mm or -0.5 mm."""
    assert Bench(tmp_path, {(1240, "1"): "-500"}).run("X") == 3
    assert "parameter 1240 is a length and needs a decimal point" in capsys.readouterr().err


def test_a_coding_that_is_not_known_is_asked_for(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for number, coded in ((1013, "00000011"), (1820, "100")):
        bench = Bench(tmp_path, {(number, "1"): coded})
        assert bench.run("X") == 2
        told = capsys.readouterr().err
        assert "detection_unit" in told
        assert f"parameter {number} of axis 1 = {coded}" in told
    assert bench.run("X", options=f", options: {{detection_unit: {UNIT}}}") == 0


# Intervals, numbers for all, inch, odd neighbours
# ---------------------------------------------------------------------------


def test_the_automatic_interval_keeps_the_feed_rule_and_leaves_numbers(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("X", "Y", "Z", axes=dict.fromkeys("XYZ", "screw_pitch: 10")) == 0
    parameters, _ = bench.written()
    for name in "XYZ":
        assert float(said(parameters, 3624, AXES[name])) >= 24000 / 7500
        assert bench.left(name) < SMALL


def test_a_spacing_below_the_feed_rule_is_refused_with_the_parameter(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Bench(tmp_path).run("X", axes={"X": "table: {spacing: 2}"}) == 4
    assert "1420" in capsys.readouterr().err


def test_an_inch_control_gets_inches_in_its_lines(tmp_path: Path) -> None:
    edits = {
        (1001, "L1"): "00000001",
        **{(3624, axis): "1.5" for axis in "123"},
        **{(1420, axis): "945.0" for axis in "123"},
    }
    bench = Bench(tmp_path, edits, unit=2.54e-4, inch=True)
    assert bench.run("X") == 0
    parameters, _ = bench.written()
    interval = said(parameters, 3624, 1)
    assert "M" not in next(line for line in parameters.splitlines() if line.startswith("N03624"))
    assert float(interval) * 10_000 == pytest.approx(round(float(interval) * 10_000), abs=1e-9)
    assert bench.left("X") < SMALL


def test_an_odd_neighbour_is_named_and_stops_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path, {(3622, "4"): "313"})
    assert bench.run("X") == 0
    assert "CW-S042" in capsys.readouterr().out
    parameters, points = bench.written()
    assert not set(range(int(said(parameters, 3621, 1)), int(said(parameters, 3622, 1)) + 1)) & set(
        range(300, 314)
    )
    assert {n: points[n] for n in range(300, 314)} == {n: POINTS.get(n, 0) for n in range(300, 314)}
    assert all(owner in ("A1", "") for _, owner in bench.changed())


def test_neighbours_that_overlap_stop_nothing(tmp_path: Path) -> None:
    bench = Bench(
        tmp_path, {(3620, "3"): "150", (3621, "3"): "111", (3622, "3"): "151"}
    )  # Z in the numbers of Y
    assert bench.run("X") == 0
    assert bench.left("X") < SMALL
    assert {n: bench.written()[1][n] for n in range(101, 152)} == {
        n: POINTS.get(n, 0) for n in range(101, 152)
    }


# Kind, turn, diameter, backlash at rapid traverse
# ----------------------------------------------------------------------------


def test_the_endless_axis_of_the_backup(tmp_path: Path) -> None:
    bench = Bench(tmp_path)
    assert bench.run("B", axes={"B": "table: {spacing: auto}"}) == 0
    parameters, points = bench.written()
    first, last = (int(said(parameters, number, 4)) for number in (3621, 3622))
    assert first == int(said(parameters, 3620, 4))
    assert sum(points[n] for n in range(first + 1, last + 1)) == 0
    assert bench.left("B") < 0.0008  # deg: of 0.006; noise of 0.0003 and steps


@pytest.mark.parametrize(
    ("travel", "first"),
    [("[0, 360]", -180), ("[-360, 360]", 0), ("[-360, 360]", -180), ("[-180, 180]", -180)],
)
def test_the_error_of_an_endless_axis_repeats_whatever_the_travel(
    travel: str, first: int, tmp_path: Path
) -> None:
    bench = Bench(tmp_path)
    assert (
        bench.run(
            "B",
            axes={"B": f"travel: {travel}, table: {{spacing: auto}}"},
            targets=first + np.arange(0.0, 361.0, 30.0),
        )
        == 0
    )
    assert bench.left("B") < 0.0008


def test_a_rotary_axis_with_ends_need_not_close(tmp_path: Path) -> None:
    """1006 = 3: a turn from 0 to 360 whose increments add up to 10 is a table as any other."""
    bench = Bench(tmp_path, {(1006, "4"): "00000011"}, points=POINTS | {311: 0})
    assert bench.run("B", axes={"B": "modulo: -, table: {spacing: auto}"}) == 0
    assert bench.left("B") < 0.0008


CONTRADICTIONS = {
    "endless in the job, ends in the files": ("B", {(1006, "4"): "00000011"}, "", "1006"),
    "ends in the job, endless in the files": ("B", {}, "modulo: -", "1006"),
    "another turn": ("B", {(1260, "4"): "180.0"}, "", "1260"),
    "linear in the files": ("B", {(1006, "4"): "00000000"}, "", "1006#0"),
    "rotary in the files": ("X", {(1006, "1"): "00000001"}, "", "1006#0"),
    "diameter in the files": ("X", {(1006, "1"): "00001000"}, "", "1006#3"),
    "diameter in the job": ("X", {}, "programmed: diameter", "1006#3"),
    "another axis by its letter": ("X", {(1020, "1"): "89", (1020, "2"): "88"}, "", "1020"),
}


@pytest.mark.parametrize("what", CONTRADICTIONS)
def test_job_and_files_that_disagree_are_refused(
    what: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name, edits, words, named = CONTRADICTIONS[what]
    assert Bench(tmp_path, edits).run(name, axes={name: words}) == 3
    assert named in capsys.readouterr().err


def test_a_travel_where_the_axis_cannot_go_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Limits -1000 to 1 (1321, 1320): targets told from the other end, 0 to 1000, are no machine
    coordinates.
    """
    there = {"X": "travel: [0, 1000]"}
    assert Bench(tmp_path).run("X", axes=there, targets=np.linspace(10, 990, 12)) == 3
    assert "1320, 1321" in capsys.readouterr().err
    assert Bench(tmp_path).run("X", axes={"X": "travel: [-1100, 0]"}) == 1  # a doubt
    said_first = capsys.readouterr().out
    assert "CW-S045" in said_first
    (tmp_path / "off").mkdir()
    off = Bench(
        tmp_path / "off", {(1320, "1"): "-1.0", (1321, "1"): "1.0"}
    )  # 1320 below 1321: no limits are set
    assert off.run("X", axes=there, targets=np.linspace(10, 990, 12)) == 0


def test_diameter_is_refused_where_no_file_says_it(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = Bench(tmp_path)
    file = tmp_path / "CNC-PARA.TXT"
    file.write_text(re.sub("N01006.*\n", "", bench.parameters))
    assert bench.run("X", axes={"X": "programmed: diameter"}) == 2
    assert "1006#3" in capsys.readouterr().err
    bench.state = "none"
    options = f", options: {{detection_unit: {UNIT}, first_point: 1}}"
    assert bench.run("X", options=options, axes={"X": "programmed: diameter"}) == 2
    assert "axes.X.programmed" in capsys.readouterr().err


@pytest.mark.parametrize("rapid", [False, True])
@pytest.mark.parametrize("path", ["1", "2"])
def test_backlash_at_rapid_traverse_changes_as_1851_does(
    rapid: bool, path: str, tmp_path: Path
) -> None:
    """1800#4 of the axis' own path: a test at rapid traverse or at cutting feed is right
    afterwards.
    """
    other = "L1" if path == "2" else "L2"
    bench = Bench(tmp_path, {(981, "1"): path, (1800, other): "00001000"}, rapid=rapid)
    assert bench.run("X") == 0
    assert bench.left("X") < SMALL
    parameters, _ = bench.written()
    assert int(said(parameters, 1851, 1)) - int(said(parameters, 1852, 1)) == 40 - 10


def test_1852_stays_where_it_does_not_act(tmp_path: Path) -> None:
    bench = Bench(tmp_path, {(1800, "L1"): "00001000"})
    assert bench.run("X") == 0
    assert (1852, "A1") not in bench.changed()


# The card, the sheet and the program
# ----------------------------------------------------------------------------------------


def test_the_synchronised_axis_gets_its_sheet_its_program_and_its_row_on_the_card(
    tmp_path: Path,
) -> None:
    """A table that is typed in, or entered by a program, on the leading axis alone racks the
    bridge.
    """
    bench = Bench(tmp_path)
    assert (
        bench.run(
            "X", options=", options: {program: g10}", axes={"X": "gantry: {axis: 3, table: same}"}
        )
        == 0
    )
    parameters, points = bench.written()
    first, last = (int(said(parameters, number, 3)) for number in (3621, 3622))
    card = tmp_path / "job" / "card"
    typed = dict(
        re.findall(
            r"^1(\d{4}),[^,]*,(-?\d+),pulse", (card / "entry_X_3.csv").read_text(), re.MULTILINE
        )
    )
    assert {int(number): int(value) for number, value in typed.items()} == {
        n: points[n] for n in range(first, last + 1)
    }
    leading, partner = ((card / f"G10_{axis}.NC").read_text() for axis in (1, 3))
    assert f"N3620P3R{said(parameters, 3620, 3)}\n" in partner
    assert leading.split()[1] != partner.split()[1]
    text = (card / "card.md").read_text()
    assert f"- [ ] X (3): Parameters: 3620 = {said(parameters, 3620, 3)}, " in text


def test_the_sheet_is_read_where_1852_acts(tmp_path: Path) -> None:
    """1800#4 = 1 as on the real machine: the sheet names 1852 too, and what is typed in from it is
    the plan's table.
    """
    assert Bench(tmp_path).run("X") == 0
    card = tmp_path / "job" / "card"
    assert re.search("^1852,", (card / "entry_X.csv").read_text(), re.MULTILINE)
    plan = str(tmp_path / "job" / "plan.json")
    assert compwright(["compare", plan, "--loaded", str(card / "entry_X.csv")]) == 0
    decode = [
        "decode",
        str(card / "entry_X.csv"),
        "--format",
        "fanuc-30i",
        "--option",
        f"detection_unit={UNIT}",
    ]
    assert compwright(decode) == 0


def test_a_gantry_of_a_linear_and_a_rotary_axis_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Bench(tmp_path).run("X", axes={"X": "gantry: 4"}) == 3
    assert "1006#0" in capsys.readouterr().err


def test_the_card_says_all_that_has_to_be_set(tmp_path: Path) -> None:
    bench = Bench(tmp_path, {(1815, "1"): "00100000"})
    assert bench.run("X", axes={"X": "table: {mode: bidirectional}"}) == 0
    parameters, _ = bench.written()
    text = (tmp_path / "job" / "card" / "card.md").read_text()
    for number in (3620, 3621, 3622, 3626, 3627, 1851, 1852):
        assert f"{number} = {said(parameters, number, 1)}" in text
    assert "3605#0 = 1" in text
    assert "Absolute encoder: no reference return" in text


# Coverage
# --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "targets"), [("X", np.linspace(-1000, -560, 9)), ("B", np.arange(0.0, 171.0, 10.0))]
)
def test_less_than_half_of_the_travel_is_refused(
    name: str, targets: FloatArray, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert Bench(tmp_path).run(name, targets=targets) == 3
    assert f"axes.{name}.travel" in capsys.readouterr().err


# A new job
# --------------------------------------------------------------------------------------------------


def test_a_new_job_says_what_the_backup_says(tmp_path: Path) -> None:
    Bench(tmp_path)
    words = [
        word for file in ("CNC-PARA.TXT", "PITCH.TXT") for word in ("--from", str(tmp_path / file))
    ]
    assert (
        compwright(["new", *words, "--format", "fanuc-30i", "--out", str(tmp_path / "new.yaml")])
        == 0
    )
    text = (tmp_path / "new.yaml").read_text()
    rotary = text[text.index("\n  B:") :]
    assert "travel: [0.0, 360.0]" in rotary
    assert "modulo: 360.0" in rotary
    assert text.count('"detection_unit": 0.0001') == 4


# Paths of which nobody says whose they are
# ---------------------------------------------------------------------------------

WITHOUT_981 = re.compile(r"^N00981Q1.*\n", re.MULTILINE)


def paths(parameters: str, edits: Edits) -> str:
    """The parameters with other values by path, in the place of their lines."""
    for number in {number for number, _ in edits}:
        usual = BY_PATH.get(number, "00000000")
        row = "".join(f"L{k}P{edits.get((number, f'L{k}'), usual)}" for k in (1, 2))
        parameters = re.sub(
            rf"^N{number:05d}Q1.*$", f"N{number:05d}Q1{row}", parameters, flags=re.MULTILINE
        )
    return parameters


def without_981(bench: Bench) -> Bench:
    bench.parameters = WITHOUT_981.sub("", bench.parameters)
    (bench.folder / "CNC-PARA.TXT").write_text(bench.parameters)
    return bench


@pytest.mark.parametrize(
    ("edits", "told"),
    [
        ({(1001, "L2"): "00000001"}, "1001#0 = 0 of path 1; 1001#0 = 1 of path 2"),
        ({(1001, "L1"): "00000001"}, "1001#0 = 1 of path 1; 1001#0 = 0 of path 2"),
        ({(1800, "L2"): "00001000"}, "1800#4 = 1 of path 1; 1800#4 = 0 of path 2"),
        ({(3602, "L1"): "00000000", (3602, "L2"): "00000001"}, "3602#0 = 1"),
    ],
)
def test_paths_that_differ_need_981(
    edits: Edits, told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Which path an axis belongs to is said by 981 only: without it nobody knows whether X counts
    in inches.
    """
    bench = without_981(Bench(tmp_path))
    bench.parameters = paths(bench.parameters, edits)
    (tmp_path / "CNC-PARA.TXT").write_text(bench.parameters)
    assert bench.run("X") == 3
    error = capsys.readouterr().err
    assert told in error
    assert "parameter 981 of axis 1" in error


@pytest.mark.parametrize(
    ("axis", "edits"),
    [
        ("X", {}),
        (
            "X",
            {(1001, "L2"): "00000010", (1800, "L2"): "00011001"},
        ),  # other bits, which nothing here hangs on
        ("B", {(1001, "L2"): "00000001"}),  # a rotary axis knows no inches
    ],
)
def test_without_981_paths_that_agree_stop_nothing(axis: str, edits: Edits, tmp_path: Path) -> None:
    bench = without_981(Bench(tmp_path, edits))
    assert bench.run(axis) == 0
    assert bench.left(axis) < SMALL * (5 if axis == "B" else 1)


def test_what_a_second_path_says_of_unknown_axes_acts_on_every_axis_without_981(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    edits = {(5711, "L2"): "2", (5721, "L2"): "3", (5731, "L2"): "900", (5761, "L2"): "5"}
    bench = without_981(Bench(tmp_path, edits))
    assert bench.run("X", axes={"X": "table: {spacing: 20}"}) == 4
    assert "5711 of path 2" in capsys.readouterr().err
    assert bench.run("X", axes={"X": "table: {spacing: 40}"}) == 0  # nothing moves
