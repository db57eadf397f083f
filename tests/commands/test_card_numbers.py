"""Every number of a card that may be typed is the one in the written files, with its unit: all
statements ``name = number unit`` of the card, what it says of points and sections, and its check
positions, compared with the bytes in ``tables/`` (and the entry sheet) by regular expressions.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest
from test_fanuc_backup_honoured import Bench

from compwright.cli import run as compwright
from compwright.records.axis import FloatArray
from places import PROJECT

pytestmark = pytest.mark.short_estimate

#: ``name = number unit`` as cards write it; a bracket may stand behind the name.
_ASSIGNED = re.compile(
    r"((?:MD\d+ )?[$A-Za-z_]\w*(?:\.\d+)?(?:\[[^\]]+\])?|\b\d{4}(?:#\d)?)(?: of axis \w+| \(\d+\))?"
    r" = (-?\d+(?:\.\d+)?)(?: (mm/m|mm|deg|inch|detection units))?(?: of ([\d.]+) (mm|deg))?"
)
#: What a card says of a value that is not that of the files: the check of the sign with the table
#: off, the switch before loading, what decides which parameter is active.
_FOR_A_WHILE = {("3623", "0"), ("1800#4", "0"), ("1800#4", "1")}
#: The unit of each value; none for numbers of points, switches, factors.
_UNITS = {
    **dict.fromkeys(("3620", "3621", "3622", "3623", "3605#0"), ""),
    "3624": "mm",
    "1851": "detection units",
    "1852": "detection units",
    "MP710": "mm",
    "MP720": "mm/m",
    "backLash": "mm",
    "linearCompValue": "mm/m",
    "$MA_BACKLASH": "mm",
    "$MA_ENC_COMP_ENABLE": "",
}


def run_example(name: str, folder: Path) -> Path:
    job = PROJECT / "examples" / name / "job.yaml"
    assert compwright(["run", str(job), "--out", str(folder / "job")]) in {0, 1}
    return folder / "job"


def run_sheet(format_id: str, folder: Path) -> Path:
    """A table that is typed in: some µm per mm, a reversal of 3.14 µm."""
    rng = np.random.default_rng(5)
    rows = ["# axis: X", "target_mm,direction,run,deviation_um"]
    for run in (1, 2, 3):
        for sign, lost in (("+", 0.0), ("-", 3.14)):
            for x in range(0, 401, 40):
                value = 0.02 * x + lost + 2 * np.sin(x / 60) + rng.normal(0, 0.2)
                rows.append(f"{x},{sign},{run},{value:.3f}")
    (folder / "x.csv").write_text("\n".join(rows) + "\n")
    words = ["--format", format_id, "--axis", "X", "--travel", "0:400", "--state", "none"]
    words += ["--option", "table_values=error", "--out", str(folder / "job")]
    assert compwright(["run", str(folder / "x.csv"), *words]) == 0
    return folder / "job"


def run_bench(folder: Path, edits: Mapping[tuple[int, str], str]) -> Path:
    assert Bench(folder, edits).run("X") == 0
    return folder / "job"


RUNS = {
    "example fanuc-backup": lambda folder: run_example("fanuc-backup", folder),
    "example sinumerik-standard": lambda folder: run_example("sinumerik-standard", folder),
    "example sinumerik-old-table": lambda folder: run_example("sinumerik-old-table", folder),
    "travel ends in the reference's own section": lambda folder: run_bench(
        folder, {(3622, "1"): "40"}
    ),
    "3623 stays": lambda folder: run_bench(folder, {(3623, "1"): "2"}),
    "1852 counts": lambda folder: run_bench(folder, {(1800, "L1"): "00010000"}),
    "heidenhain-itnc530": lambda folder: run_sheet("heidenhain-itnc530", folder),
    "heidenhain-nck": lambda folder: run_sheet("heidenhain-nck", folder),
}


@pytest.fixture(scope="module", params=RUNS)
def job(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return RUNS[request.param](tmp_path_factory.mktemp("card"))


def texts(job: Path) -> str:
    paths = [*(job / "tables").rglob("*.*"), *(job / "card").glob("entry_*.csv")]
    return "\n".join(path.read_text() for path in paths)


def card(job: Path) -> str:
    """The text of a card without the column of old values."""
    text = re.sub(r"\\(.)", r"\1", (job / "card" / "card.md").read_text(encoding="utf-8"))
    return re.sub(
        r"^(\| \[ \] \| backlash in addition[^|]*\|)[^|]*\|", r"\1", text, flags=re.MULTILINE
    )


def test_old_backlash_is_that_of_the_files_before(job: Path) -> None:
    """By its parameter: the way back by hand. 0 where nothing was active."""
    text = re.sub(r"\\(.)", r"\1", (job / "card" / "card.md").read_text(encoding="utf-8"))
    before = "\n".join(path.read_text() for path in (job / "rollback").rglob("*.*"))
    for cell in re.findall(
        r"^\| \[ \] \| backlash in addition[^|]*\|([^|]*)\|", text, re.MULTILINE
    ):
        for name, number, unit, *_ in _ASSIGNED.findall(cell):
            assert unit == _UNITS[re.split(r"[.\[]", name.split()[-1])[0]]
            assert float(number) in (held(before, name) or {0.0}), (name, number)


def held(files: str, name: str) -> set[float]:
    """The values of a parameter in the files, whatever they are."""
    name = name.rsplit(maxsplit=1)[-1]
    if re.fullmatch(r"\d{4}#0", name):
        found = re.findall(rf"N0?{name[:4]}Q1.*?A1P[01]{{7}}([01])", files)
    elif re.fullmatch(r"\d{4}", name):
        found = re.findall(rf"N0?{name}Q1A1[PM](-?[\d.]+)", files)
    elif name.startswith("$"):
        key = re.escape(name.replace(" ", ""))
        found = re.findall(rf"{key}\s*=\s*(-?[\d.]+)", files)
    else:
        found = re.findall(rf"^{re.escape(name.split('.')[0])},,(-?[\d.]+)", files, re.MULTILINE)
    return {float(value) for value in found}


def test_every_statement_is_that_of_the_files_with_its_unit(job: Path) -> None:
    files, seen = texts(job), 0
    steps = card(job).split("## Assumed facts")[0]
    for name, number, unit, size, _ in _ASSIGNED.findall(steps):
        if (name, number) in _FOR_A_WHILE or name.startswith("MD32700"):
            continue
        if number == "0" and name.startswith("MP7"):  # without compensation, in the check
            continue
        key = re.split(r"[.\[]", name.split()[-1])[0]
        if key not in _UNITS:
            continue
        assert unit == _UNITS[key], (name, number, unit)
        assert float(number) in held(files, name), (name, number)
        if size:
            assert size in {"0.001", "0.0001"}
        seen += 1
    assert seen >= 1


def test_the_page_says_the_same(job: Path) -> None:
    """As often, with µm in grey next to it."""
    page = re.sub(r"<[^>]+>", "", (job / "card" / "card.html").read_text(encoding="utf-8"))
    same = [
        statement
        for statement in _ASSIGNED.findall(card(job).split("## Assumed facts")[0])
        if re.split(r"[.\[]", statement[0].split()[-1])[0] in _UNITS
    ]
    assert set(same) <= set(_ASSIGNED.findall(page))


def points(files: str) -> dict[int, int]:
    return {
        int(n) - 10_000: int(v) for n, v in re.findall(r"^N(1\d{4})Q0P(-?\d+)", files, re.MULTILINE)
    }


def test_points_and_sections_are_those_of_the_files(job: Path) -> None:
    text, files = card(job), texts(job)
    for number, value in re.findall(r"Point (\d+) holds (-?\d+)", text):
        assert points(files)[int(number)] == int(value)
    for number, low, high in re.findall(r"= (\d+) owns (-?[\d.]+) to (-?[\d.]+) mm", text):
        reference, interval = (held(files, name).pop() for name in ("3620", "3624"))
        assert float(high) == (int(number) - reference) * interval
        assert float(low) == float(high) - interval


def test_the_table_and_the_check_positions_are_those_of_the_files(job: Path) -> None:
    """What the control adds at three positions, without the backlash: sums of points in the middle
    of the sections, or the error of an EEC table turned.
    """
    text, files = card(job), texts(job)
    rows = re.findall(r"^\| ([−\d.]+) +\| \+ +\| ([−\d.]+) ", text, re.MULTILINE)
    assert len(rows) >= 3
    at, adds = (
        np.array([float(cell.replace("−", "-")) for cell in row])
        for row in zip(*rows, strict=False)
    )
    if "ENC_COMP[" in files:
        step, low = (
            float(re.findall(rf"\$AA_ENC_COMP_{word}\[[^\]]+\]\s*=\s*(-?[\d.]+)", files)[0])
            for word in ("STEP", "MIN")
        )
        found = re.findall(r"\$AA_ENC_COMP\[\d,(\d+),\w+\]\s*=\s*(-?[\d.]+)", files)
        values = {int(index): float(value) for index, value in found}
        nodes = low + step * np.arange(len(values))
        error = np.interp(at, nodes, [values[index] for index in range(len(values))])
        np.testing.assert_allclose(adds, -1000 * error, atol=0.0011)
        range_ = f"{nodes[0]:g} to {nodes[-1]:g} mm"
        assert range_ in text
    elif "N03620" in files:
        numbers = (3620, 3621, 3622, 3623, 3624)
        reference, first, last, factor, interval = (held(files, str(n)).pop() for n in numbers)
        unit = float(re.findall(r"detection units of ([\d.]+) mm", text)[0])
        nodes = np.arange(first - 1, last + 1) - reference
        every = points(files)
        sums = np.concatenate(
            [[0], np.cumsum([every[n] for n in range(int(first), int(last) + 1)])]
        )
        sums = (sums - np.interp(0, nodes, sums)) * factor * unit * 1000
        index = np.clip(np.floor(at / interval + 0.5) - nodes[0], 0, sums.size - 1).astype(int)
        np.testing.assert_allclose(adds, sums[index], atol=0.0011)


@pytest.mark.parametrize("job", ["heidenhain-itnc530", "heidenhain-nck"], indirect=True)
def test_a_reading_stops_where_the_scatter_of_the_instrument_gives_it_no_more(job: Path) -> None:
    """Readings of 0.2 µm, drawn so above: the difference of two, and what is known of the mean, by
    5 standard deviations. Between a mean known exactly and one known by a single reading.
    """
    line = re.compile(r"^\| [\d.]+ +\| [+−] +\|(?:[^|]*\|){3} ([\d.]+) +\|", re.MULTILINE)
    rows = line.findall(card(job))
    assert len(rows) == 6
    for stop in map(float, rows):
        assert 0.75 * 5 * 0.2 * np.sqrt(2) < stop < 1.25 * 5 * 0.2 * np.sqrt(3)


#: Format and axis of an example, what ``decode`` needs besides.
EXAMPLES = {
    "example fanuc-backup": ("fanuc-30i", "1", ["--option", "detection_unit=0.001"]),
    "example sinumerik-old-table": ("siemens-840d-sl", "MA_Y", []),
}


def rows_below(text: str, heading: str) -> list[list[str]]:
    """The cells of the table below a heading, minus signs as a computer reads them."""
    block = re.split(r"\n#+ ", text.split(heading, 1)[1])[0].replace("\N{MINUS SIGN}", "-")
    lines = [line for line in block.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


def equals(printed: str, value: float) -> None:
    """A printed number is that value, within half of its last digit."""
    digits = len(printed.partition(".")[2])
    assert float(printed) == pytest.approx(value, abs=0.5001 * 10**-digits), (printed, value)


class Example:
    """Card, documents and read-back files of an example."""

    def __init__(self, name: str, folder: Path) -> None:
        self.job, self.folder = run_example(name.split()[1], folder), folder
        self.format, self.address, self.options = EXAMPLES[name]
        text = (self.job / "card" / "card.md").read_text(encoding="utf-8")
        self.text = re.sub(r"\\(.)", r"\1", text)
        prediction, plan = (
            json.loads((self.job / f"{which}.json").read_text("utf-8"))
            for which in ("prediction", "plan")
        )
        ((self.axis, self.predicted),) = prediction["axes"].items()
        self.plan = plan["axes"][self.axis]

    def files(self, which: str) -> list[Path]:
        every = sorted((self.job / which / self.format).iterdir())
        return [path for path in every if not path.name.startswith("BACK_")]

    def decoded(self, which: str, at: list[float] | None = None) -> dict[str, FloatArray]:
        answer = self.folder / "decoded.json"
        words = ["decode", *map(str, self.files(which)), "--format", self.format, *self.options]
        words += ["--axis", self.address, "--json", str(answer), "--force"]
        words += [] if at is None else ["--at=" + ",".join(map(str, at))]
        assert compwright(words) == 0
        axis = json.loads(answer.read_text("utf-8"))["axes"][self.address]
        return {key: np.array(value) for key, value in axis.items() if key != "unit"}


@pytest.fixture(scope="module", params=EXAMPLES)
def example(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Example:
    return Example(request.param, tmp_path_factory.mktemp("example"))


def test_old_and_new_values_are_those_of_the_files_read_back(example: Example) -> None:
    rows = {row[1]: row[2:] for row in rows_below(example.text, "### Values that change")}
    assert len(rows) == 4
    for column, which in enumerate(("rollback", "tables")):
        axis = example.decoded(which)
        plus = axis["correction_positive"]
        number = re.compile(r"-?\d+(?:\.\d+)?")
        points, spanned, added, backlash = (cells[column] for cells in rows.values())
        equals(points, plus.size)
        for cell, values in ((spanned, axis["positions"]), (added, plus)):
            low, high = number.findall(cell)
            equals(low, values.min())
            equals(high, values.max())
        (reversal,) = re.findall(r"\((-?[\d.]+) µm\)", backlash)
        equals(reversal, float((plus - axis["correction_negative"]).mean()))


def test_each_entry_is_that_of_the_files_with_its_count(example: Example) -> None:
    rows = rows_below(example.text, "## Old to new")
    old, new = (
        [line for path in example.files(which) for line in path.read_text().splitlines()]
        for which in ("rollback", "tables")
    )
    for entry, *values in rows:
        head, axis = re.fullmatch(r"(.*?)(A\d)?", entry).groups()  # type: ignore[union-attr]
        between = "=" if "$" in entry else rf"(?=[AP]).*?{axis or ''}[PM]"
        for lines, value in zip((old, new), values, strict=True):
            found = re.findall(re.escape(head) + between + r"(-?[\d.]+)", "\n".join(lines))
            assert found == [value], entry
    changed, same = re.findall(r"(\d+) entries change; (\d+) lines", example.text)[0]
    assert int(changed) == len(rows) == sum(a != b for a, b in zip(old, new, strict=True))
    assert int(same) == sum(a == b for a, b in zip(old, new, strict=True))


def test_limits_are_those_of_the_prediction(example: Example) -> None:
    (line,) = re.findall(rf"Axis {example.axis}: (A .*)\.$", example.text, re.MULTILINE)
    shown = re.findall(r"(\w+) ([\d.]+) µm: (\w+)", line)
    expected = [
        (name, f"{one['limit']:g}", one["decision"])
        for name, one in example.predicted["accept"].items()
    ]
    assert shown == expected


def test_the_quick_check_is_that_of_the_files_and_of_the_plan(example: Example) -> None:
    """Expected deviation: what the files add, less the correction that the plan wants, from the
    first row on.
    """
    rows = rows_below(example.text, "### Check positions")
    at = [float(row[0]) for row in rows]
    axis, wanted = example.decoded("tables", at), example.plan["wanted"]
    rest = []
    for number, row in enumerate(rows):
        way = {"+": "positive", "-": "negative"}[row[1]]
        adds = axis[f"correction_{way}"][number]
        equals(row[2], adds)
        rest.append(adds - 1000 * np.interp(at[number], wanted["positions"], wanted[way]))
        assert float(row[4]) == pytest.approx(rest[-1] - rest[0], abs=0.01), row
        noise = 1000 * example.plan["estimate"]["noise"]
        assert 5 * np.sqrt(2) * noise < float(row[5])


def test_fixed_positions_move_by_the_difference_of_the_files(example: Example) -> None:
    ((name, at, moves),) = rows_below(example.text, "### Fixed positions that move")
    assert (name, float(at)) == ("tool_change", -300)
    old, new = (
        example.decoded(which, [float(at)])["correction_positive"][0]
        for which in ("rollback", "tables")
    )
    equals(moves, new - old)
