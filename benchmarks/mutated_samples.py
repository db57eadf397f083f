"""A small sound sample of everything that compwright reads, how it is read, and a judge who counts
readings in a text without its reader.
"""

from __future__ import annotations

import io
import json
import random
import re
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "instruments"))

import numpy as np
from mutated import mutated
from test_instruments_circular_b5r import document as ballbar
from test_instruments_target_data import COMPLETE
from test_instruments_workbook import workbook

from compwright.cli import run
from compwright.documents.plan import read_plan
from compwright.documents.record import read_record
from compwright.formats.definition.inheritance import BASE_ENDING, found_in
from compwright.formats.definitions import definition_of, load_definition
from compwright.formats.gate import check_definition
from compwright.foundations.errors import (
    CapacityError,
    Fault,
    InputError,
    StorageError,
    UsageError,
    raise_all,
)
from compwright.instruments.circular_reading import read_circular
from compwright.instruments.drift_csv import read_drift
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.reading import read_tests
from compwright.jobs.reading import read_job
from compwright.records.axis import AxisKind
from compwright.records.correction import ControlFile
from compwright.simulation.reading import read_machine
from damage import SAMPLES, damaged, read
from format_samples import CONTENT
from laser_files import compensation_file, laser_file, mean_file
from profile_samples import LONG, LONG_PROFILE, WIDE, WIDE_PROFILE

#: Readings that somebody who looks at a text without its reader counts in it.
Judge = Callable[[bytes], int]


@dataclass(frozen=True)
class Sample:
    """``sound`` is as it should be, ``change`` makes something damaged of it, ``read`` reads it. Of
    measurements, ``readings`` counts what was read, ``judge`` what stands in the content, and
    ``told`` are the codes of the warnings that came with it.
    """

    name: str
    sound: Any
    change: Callable[[random.Random], Any]
    read: Callable[[Any], Any]
    judge: Judge | None = None
    readings: Callable[[Any], int] | None = None
    told: Callable[[Any], frozenset[str]] = lambda _: frozenset()


def text_of(content: bytes) -> list[str]:
    """The lines of a text in whatever encoding a bystander would try."""
    for start, name in ((b"\xff\xfe", "utf-16"), (b"\xfe\xff", "utf-16"), (b"", "utf-8-sig")):
        if content.startswith(start):
            try:
                return re.split(r"\r\n|\r|\n", content.decode(name))
            except UnicodeDecodeError:
                continue
    return re.split(r"\r\n|\r|\n", content.decode("latin-1"))


def rows(pattern: str, each: int = 1) -> Judge:
    """Judge: as many readings as different lines that look exactly like sound ones, ``each`` in a
    line: a line that stands twice is one reading.
    """
    row = re.compile(pattern)
    return lambda content: each * len({line for line in text_of(content) if row.fullmatch(line)})


def readings_of_tests(tests: Any) -> int:
    return sum(
        int(np.isfinite(block).sum()) for one in tests for block in (one.positive, one.negative)
    )


def warnings_of_tests(tests: Any) -> frozenset[str]:
    return frozenset(
        finding.code for one in tests for finding in one.findings if finding.severity != "info"
    )


TARGETS = ["0.0000", "100.2500", "200.0000", "300.1250"]
RUNS = {
    (run, index): f"{index - run % 2 * 2}.{run}" for run in (1, 2, 3, 4) for index in range(1, 5)
}
ANGLES = {key: "7" + value.lstrip("-") for key, value in RUNS.items()}
MEANS = [("0.000", "0.0000"), ("100.000", "0.0021"), ("200.000", "0.0030")]
MEANS_BACK = [("0.000", "0.0012"), ("100.000", "0.0034"), ("200.000", "0.0045")]
TABLE = [["1", "-250", "0", "-0.0002"], ["2", "-225", "0.0013", "0.0008"]]
TABLE += [["3", "-200", "0.0020", "0.0011"]]
PLAIN = "# axis: X\n# date: 2026-03-02\ntarget_mm,direction,run,deviation_um\n" + "".join(
    f"{target},{sign},{run},{index + run / 10}\n"
    for run in (1, 2, 3)
    for index, target in enumerate((0.5, 100.25, 200.75))
    for sign in "+-"
)
GERMAN = PLAIN.replace(",", ";").replace(".", ",").replace("# axis", "# Größe: µ\n# axis")
AXES = "axis,target_mm,direction,run,deviation_um\n" + "".join(
    f"{axis},{target},{sign},{run},{run}.5\n"
    for axis in "XY"
    for run in (1, 2)
    for target in (0, 100)
    for sign in "+-"
)
TRAVERSES = "# unit: um\ntarget_mm,+1,-1,+2,-2\n" + "".join(
    f"{target},1.5,-0.5,1.25,-0.75\n" for target in (0, 100, 200)
)
CIRCLE = (
    "# plane: XY\n# nominal_radius_mm: 100\n# feed_mm_min: 1000\n# calibrated: yes\n"
    "direction,angle_deg,deviation_um\n"
    + "".join(f"{way},{at},{at % 7}.5\n" for way in ("ccw", "cw") for at in range(0, 360, 10))
)
DRIFT = "# axis: X\ntime_min,deviation_um\n" + "".join(f"{at},0.{at}\n" for at in range(8))
MACHINE = """\
virtual_machine: 1
machine: {name: Virtual, serial: "1"}
controller: {format: linuxcnc, options: {units: mm}}
axes:
  X:
    travel: [0, 500]
    address: "0"
    error:
      slope_um_per_m: 20
      smooth: {amplitude_um: 5, length_mm: 120, seed: 3}
      screw: [{period_mm: 10, amplitude_um: 1, phase_deg: 30}]
      reversal: {mean_um: -3, varies_um: 0.5}
      noise_um: 0.3
      outliers: {share_percent: 1, size_um: 5}
      traverses: {offset_um: 0.1, slope_um_per_m: 1, walk_um: 0.1}
    test: {targets: 9, runs: 5, cycle: standard, datum_um: 3, resolution_um: 0.1}
  C: {kind: rotary, travel: [0, 360], modulo: 360, error: {noise_arcsec: 1}, test: {targets: 9}}
circles:
  xy:
    {plane: XY, radius_mm: 100, feed_mm_min: 1000, centre: [200, 0], format: b5r, runs: 1,
     arc: {start_deg: 0, extent_deg: 360}, overshoot_deg: 20, sample_rate_hz: 40}
"""
JOB = """\
compwright: 1
machine: {name: VMC 850, serial: "1111111"}
controller: {format: fanuc-30i, options: {detection_unit: 0.001}}
states:
  as_found: [PARA.TXT]
  before: none
axes:
  X:
    travel: [-850, 0]
    address: 1
    position_map: {sense: -1, offset: -850}
    screw_pitch: [10, 5]
    encoder: {type: incremental, system: 1}
    before:
      - x.csv
      - {files: [a.csv, b.csv], name: two, measured_in: before, thermal: {T_m: 21}}
    table: {start: -850, end: 0, spacing: 50, mode: auto, goal: expected}
    accept: {A: 8, E: 6, B: 3}
  Y: {kind: rotary, travel: [0, 360], modulo: 360, before: [y.csv], accept: {test: y, A: 8}}
circles: [{file: xy.b5r, name: xy-150, centre: [-400, -250, -300]}]
cross: [{input: X, output: Y, positions: [0, 100], deviations: [0, 5], unit: arcsec}]
apply: {squareness: {XY: Y}, scale: [X], backlash_from: positioning}
fixed_positions: {tool_change: {X: 0}}
uncertainty: {device: {U: 0.5, per_m: 0.5}, misalignment_mm: 1, U_theta: 0.5}
thermal: {alpha_m: 11.5, T_m: 22.0, alpha_d: 0, T_d: 20, x_fix: 0, refer_to: scale}
decision_rule: simple
proven: [{control: c, machine: m, date: 2026-01-01, how: measured}]
report: {language: en}
"""


def _measurement(name: str, text: str | bytes, judge: Judge, profile: str = "") -> Sample:
    content = text if isinstance(text, bytes) else text.encode()
    mapped = read_profile(profile.encode(), "P.yaml") if profile else None
    return Sample(
        name,
        content,
        lambda chance: mutated(content, chance),
        lambda damage: read_tests(damage, "f", mapped),
        judge,
        readings_of_tests,
        warnings_of_tests,
    )


def _text(name: str, text: str | bytes, read_it: Callable[[bytes], Any]) -> Sample:
    content = text if isinstance(text, bytes) else text.encode()
    return Sample(name, content, lambda chance: mutated(content, chance), read_it)


def _circle(name: str, content: bytes, judge: Judge) -> Sample:
    return Sample(
        name,
        content,
        lambda chance: mutated(content, chance),
        lambda damage: (read_circular(damage, "f"),),
        judge,
        lambda tests: sum(run.angles.size for one in tests for run in one.runs),
        warnings_of_tests,
    )


def _samples_in_ballbar(content: bytes) -> int:
    """Samples of a ballbar file between its printed indices, in different runs whose tags are as
    they were.
    """
    runs = re.findall(rb"<BALLBAR_RUN>.*?</BALLBAR_RUN>", content)
    sound = re.compile(
        rb"<BALLBAR_RUN><RUN_DIRECTION>C?CW</RUN_DIRECTION>.{0,60}<START_INDEX>10</START_INDEX>"
        rb"<END_INDEX>49</END_INDEX>.{0,60}<READINGS>([-+. \d]*)</READINGS>"
    )
    return sum(len(found[1].split()[10:50]) for run in set(runs) if (found := sound.match(run)))


def _workbook() -> Sample:
    """A workbook whose sheet is damaged inside its archive."""
    head = ("target_mm", "direction", "run", "deviation_um")
    body = [(t, s, r, r + t / 1000) for r in (1, 2, 3) for t in (0.5, 100.25, 200.75) for s in "+-"]
    whole = workbook({"X": [("# axis: X",), head, *body]})
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    inside = [name for name in parts if name.endswith(".xml") and "docProps" not in name]

    def change(chance: random.Random) -> bytes:
        if chance.random() < 0.2:
            return mutated(whole, chance)
        name = "xl/worksheets/sheet1.xml" if chance.random() < 0.7 else chance.choice(inside)
        return _zipped({**parts, name: mutated(parts[name], chance)})

    # no judge: without the reader nobody tells what the cells of a damaged sheet say
    return Sample("xlsx", whole, change, lambda damage: read_tests(damage, "f.xlsx"))


def _zipped(parts: Mapping[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    return stream.getvalue()


#: Exit codes of commands.
OWN_FAULT = 70
_ERRORS = {2: UsageError, 3: InputError, 4: CapacityError, 5: StorageError}
#: Bases, and a definition that extends each.
_EXTENDING = {"fanuc.base.yaml": "fanuc-30i.yaml", "fanuc-no-q.base.yaml": "fanuc-15i.yaml"}
#: One of each shape of files.
GATED = ("linuxcnc.yaml", "heidenhain-nck.yaml", "pmac.yaml", "isg-kernel.yaml", "fanuc-30i.yaml")
#: What a value of a document may become; missing altogether: GONE.
GONE = object()
VALUES: Sequence[Any] = (
    *(GONE, None, "x", "", -1, 0, 1e308, float("inf"), float("nan"), 1e-320, 10**30, True, [], {}),
    *([None], [[1]], "\ud800", "../x", "C:x", "a\x1b[2J", 0.5, "x" * 5000, ["x"], {"a": 1}),
    *([1e9, 2e9], -0.0, 3, "X", [0.0], [1.0, 0.0], "AX1", "1", 2**53),
)


def _document(name: str, content: bytes, read_it: Callable[[bytes], Any]) -> Sample:
    data = json.loads(content)
    places = list(_places(data))

    def change(chance: random.Random) -> bytes:
        if chance.random() < 0.25:
            return mutated(content, chance)
        changed = data
        for _ in range(chance.choice((1, 1, 2, 3))):
            changed = _edited(changed, chance.choice(places), chance)
        return json.dumps(changed).encode()

    return Sample(name, content, change, read_it)


def _places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    if path:
        yield path
    if isinstance(value, dict):
        for key in value:
            yield from _places(value[key], (*path, key))
    elif isinstance(value, list):
        for index in sorted({*range(min(2, len(value))), *([len(value) - 1] if value else [])}):
            yield from _places(value[index], (*path, index))


def _edited(data: Any, path: tuple[Any, ...], chance: random.Random) -> Any:
    """A copy with another value at ``path``, where that is still there."""
    if not path:
        return chance.choice(VALUES)
    key, rest = path[0], path[1:]
    here = isinstance(data, dict) and key in data
    if not here and not (isinstance(data, list) and isinstance(key, int) and key < len(data)):
        return data
    changed = dict(data) if isinstance(data, dict) else list(data)
    value = _edited(data[key], rest, chance)
    if value is GONE:
        del changed[key]
    elif isinstance(changed, dict) and not rest and chance.random() < 0.05:
        changed[f"{key}x"] = changed.pop(key)
    else:
        changed[key] = value
    return changed


def _definition(name: str, *, gate: bool = False) -> Sample:
    """A definition, of which one that extends it is read; ``gate``: checked too, as one of the
    user's own is before it is used.
    """
    whole = name if not name.endswith(BASE_ENDING) else _EXTENDING[name]

    def read_it(damage: bytes) -> Any:
        definition_of.cache_clear()
        given = {**CONTENT, name: damage}
        definition = load_definition(given[whole], whole, found_in(given))
        if gate:
            raise_all(InputError, check_definition(definition))
        return definition

    return _text(f"definition {name}{', gate' if gate else ''}", CONTENT[name], read_it)


def _control(format_id: str) -> Sample:
    """Sets of control files, read by both readers, which must agree."""
    samples = [sample for sample in SAMPLES if sample.format_id == format_id]

    def change(chance: random.Random) -> Any:
        sample = chance.choice(samples)
        if chance.random() < 0.5:
            return sample, damaged(sample, chance.randrange(10**12))
        which = chance.randrange(len(sample.files))
        files = list(sample.files)
        files[which] = ControlFile(files[which].name, mutated(files[which].content, chance))
        return sample, tuple(files)

    sound = (samples[0], samples[0].files)
    return Sample(f"control {format_id}", sound, change, lambda damage: read(*damage))


def _command(
    sample: Sample, name: str, words: Callable[[str], Sequence[str]], file: str = "input"
) -> Sample:
    """The same damage, through a whole command; ``words`` are those for the damaged file."""

    def read_it(damage: bytes) -> Any:
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / file
            path.write_bytes(damage)
            said, told = (io.TextIOWrapper(io.BytesIO(), "utf-8", "replace") for _ in range(2))
            with redirect_stdout(said), redirect_stderr(told):
                code = run(list(words(str(path))))
        for stream in (told, said):
            stream.flush()
        lines = [stream.detach().getvalue().decode() for stream in (told, said)]
        if code == OWN_FAULT:
            raise AssertionError(lines[0].splitlines()[0])
        obeyed = {c for c in "".join(lines) if not c.isprintable()} - {"\n"}
        if obeyed - {"\u00a0", "\u202f", "\u2009"}:
            raise AssertionError(f"a terminal would obey {sorted(obeyed)}")
        raise_all(_ERRORS.get(code, InputError), _printed_faults(lines[0]) if code > 1 else [])

    return Sample(f"{name} {sample.name}", sample.sound, sample.change, read_it)


def _printed_faults(text: str) -> list[Fault]:
    """Return the errors that a command printed. Raises AssertionError where there is none, or one
    without its next step.
    """
    errors = [line for line in text.splitlines() if line.startswith("error: ")]
    stuck = [line for line in errors if "Next: " not in line and "... and " not in line]
    if not errors or stuck:
        raise AssertionError(stuck[0] if stuck else "no error is printed")
    return [Fault(message=line.removeprefix("error: ")) for line in errors]


def _commands(found: Sequence[Sample], plans: Mapping[str, bytes]) -> Iterator[Sample]:
    by_name = {sample.name: sample for sample in found}
    for name in ("rtl", "pos", "ren", "plain", "wide", "xlsx", "circle csv", "b5r"):
        yield _command(by_name[name], "evaluate", lambda file: ["evaluate", file, "--json", "-"])
    yield _command(by_name["plain"], "evaluate, tables,", lambda file: ["evaluate", file])
    yield _command(
        by_name["machine"], "simulate", lambda file: ["simulate", file, "--out", f"{file}s"]
    )
    for name, content in plans.items():
        words = ("--format", json.loads(content)["format"], "--force")
        yield _command(by_name[f"plan {name}"], "export", _exporting(words))


def _exporting(words: Sequence[str]) -> Callable[[str], Sequence[str]]:
    return lambda file: ["export", file, *words, "--out", f"{file}s"]


def samples(plans: Mapping[str, bytes], records: Mapping[str, bytes]) -> list[Sample]:
    """Every sample; ``plans`` and ``records``: documents that runs wrote, by name."""
    number = r"-?\d+(?:\.\d+)?"
    laser = rf"   \d+     \d+     {number}"
    plain = rf"\d+(?:\.\d+)?,[+-],\d+,{number}"
    found = [
        _measurement("rtl", laser_file(TARGETS, RUNS), rows(laser)),
        _measurement("rta", laser_file(TARGETS, ANGLES, file_type="rta"), rows(laser)),
        _measurement(
            "pos",
            mean_file({"Forward Directional": MEANS, "Reverse Directional": MEANS_BACK}),
            rows(r"\d+\.\d{3}\t-?\d+\.\d{4}"),
        ),
        _measurement("ren", compensation_file(TABLE), rows(rf"\d   -\d+   {number}   {number}", 2)),
        _measurement("target data", COMPLETE, rows(rf"REF_DATA_..D\[[12],[12]\]={number}")),
        _measurement("plain", PLAIN, rows(plain)),
        _measurement("plain, german", GERMAN, rows(r"\d+(?:,\d+)?;[+-];\d+;-?\d+(?:,\d+)?")),
        _measurement("plain, axes", AXES, rows(rf"[XY],{plain}")),
        _measurement("wide", TRAVERSES, rows(rf"\d+(?:,{number}){{4}}", 4)),
        _measurement(
            "profile, long", LONG, rows(r"\d+,\d{3};(?:vor|zurück);1;-?\d+,\d"), LONG_PROFILE
        ),
        _measurement("profile, wide", WIDE, rows(r"\d+\t-?\d\.\d\t-?\d\.\d\t20", 2), WIDE_PROFILE),
        _workbook(),
        _circle("circle csv", CIRCLE.encode(), rows(rf"(?:ccw|cw),\d+,{number}")),
        _circle("b5r", ballbar(), _samples_in_ballbar),
        _text("drift", DRIFT, lambda damage: read_drift(damage, "f", AxisKind.LINEAR)),
        _text("profile of its own", LONG_PROFILE, _by_profile(LONG)),
        _text("profile of its own, wide", WIDE_PROFILE, _by_profile(WIDE)),
        _text("proposed profile", LONG, lambda damage: proposed_profile(damage, "f")),
        _text("proposed profile, wide", WIDE, lambda damage: proposed_profile(damage, "f")),
        _text("machine", MACHINE, lambda damage: read_machine(damage, "f")),
        _text("job", JOB, lambda damage: read_job(damage, "f")),
    ]
    found += [
        _document(f"plan {name}", content, lambda damage: read_plan(damage, "f"))
        for name, content in plans.items()
    ]
    found += [
        _document(f"record {name}", content, lambda damage: read_record(damage, "f"))
        for name, content in records.items()
    ]
    found += [_definition(name) for name in sorted(CONTENT)]
    found += [_definition(name, gate=True) for name in GATED]
    found += [_control(format_id) for format_id in sorted({one.format_id for one in SAMPLES})]
    return [*found, *_commands(found, plans)]


def _by_profile(text: str) -> Callable[[bytes], Any]:
    return lambda damage: read_tests(text.encode(), "f", read_profile(damage, "P.yaml"))
