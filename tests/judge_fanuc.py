"""Plays a job on a variation of a FANUC backup through the command line; the virtual FANUC judges
what came out.
"""

from __future__ import annotations

import contextlib
import io
import json
import re
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from backup_files_fanuc import Rng
from backup_jobs_fanuc import AxisJob, Job, csv, dithered, state_files
from compwright.cli import run
from compwright.fitting.solve import load_solver
from virtual_fanuc import (
    Floats,
    Grid,
    NotKnownError,
    Registers,
    VirtualFanuc,
    accuracy,
    differing,
    loaded,
    owners,
)

#: A fresh test may be that much above the predicted median: 40 % for the band of a prediction, 1 µm
#: (1 arcsec) for quanta.
FACTOR, ROOM = 1.4, 1.0
REPEATS = 15
OWN = {1851, 1852, *range(3620, 3628), 3605}
#: Largest number and increment: of 0i-F no page tells the increment.
LIMITS = {"fanuc-0i-16i": (1023, 7), "fanuc-0i-d": (1023, 7), "fanuc-0i-f": (1535, 7)}
#: Options of a control whose function compwright may count and write, and its parameters.
COUNTED = {
    "inclination": {*range(5861, 5865), *range(5871, 5875)},
    "cyclic": set(range(14985, 14989)),
}
#: Point numbers of functions beside the table: they may follow a grid that moves, no amount may.
OF_AXIS = set(range(5861, 5865))
OF_PATH = {first + n for first in (5731, 5741, 5751) for n in range(4)}
_GROUP = re.compile(rb"([ALS]\d+|Q1)[PMI]([-0-9.]+)")


@dataclass
class Outcome:
    """What came of a job: exit code, what was said, which axes got a table, and every fault
    found.
    """

    job: Job
    code: int
    said: str
    shown: str = ""
    written: list[str] = field(default_factory=list)
    faults: list[str] = field(default_factory=list)
    figures: list[str] = field(default_factory=list)
    #: for each axis written: whether A of a fresh test lies in the band of the prediction
    within: list[bool] = field(default_factory=list)
    #: what came of compare and verify (judge_loaded_fanuc)
    verdicts: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        head = f"{self.job.title} ({self.job.mark}): exit {self.code}, written {self.written}"
        return "\n  ".join([head, *self.faults, *self.figures, *self.said.splitlines()])


def quietly(arguments: list[str]) -> tuple[int, str, str]:
    """Run a command in this process, without the report; exit code, standard error,
    standard output.
    """
    said, shown = io.StringIO(), io.StringIO()
    load_solver()  # which wants the same library, too
    pages = {name: module for name, module in sys.modules.items() if name.split(".")[0] == "jinja2"}
    sys.modules |= dict.fromkeys(["jinja2", *pages], None)  # type: ignore[arg-type]
    try:
        with contextlib.redirect_stdout(shown), contextlib.redirect_stderr(said):
            return run(arguments), said.getvalue(), shown.getvalue()
    finally:
        del sys.modules["jinja2"]
        sys.modules |= pages


@dataclass(frozen=True)
class Played:
    """A job that was run: what was in the control, what the command said, where its output lies,
    why nothing can be measured.
    """

    job: Job
    before: VirtualFanuc
    really: Mapping[str, bytes]
    out: Path
    code: int
    said: str
    shown: str
    unknown: str

    @property
    def tables(self) -> Path:
        return self.out / "tables" / self.job.format


def control_of(job: Job, registers: Registers) -> VirtualFanuc:
    """What the job says of a function is what the pages say; every other function acts hidden."""
    counted = {name for name in COUNTED if job.options.get(name) == "available"}
    return VirtualFanuc(
        registers,
        older=job.format == "fanuc-0i-16i",
        hidden=1 + job.seed,
        told=frozenset(counted),
        has_npe=job.format in ("fanuc-0i-d", "fanuc-0i-f"),
    )


def play(job: Job, folder: Path, *, today: bool = True, text: str | None = None) -> Outcome:
    """Run a job and judge it; ``text``: another job file than the job's own."""
    return judge(run_job(job, folder, today=today, text=text))


def run_job(job: Job, folder: Path, *, today: bool = True, text: str | None = None) -> Played:
    """Measure with what really acts, and run the job in this process."""
    folder.mkdir(parents=True, exist_ok=True)
    state_files(job, folder)
    really = dict(job.really if job.really is not None else job.files or {})
    before = control_of(job, loaded(really.values()))
    rng = np.random.default_rng([job.seed, 7])
    unknown = ""
    for axis in job.axes:
        try:
            act = acting(before, axis)
            act(np.zeros(1), 1)
        except NotKnownError as reason:
            unknown, act = str(reason), lambda x, _: np.zeros_like(x)
        x = dithered(rng, axis.measured, axis.targets)
        (folder / f"{axis.name}.csv").write_text(
            csv(axis.name, axis.rotary, x, axis.physics.read(rng, x, act))
        )
    (folder / "job.yaml").write_text(job.yaml(today) if text is None else text)
    code, said, shown = quietly(["run", str(folder / "job.yaml"), "--out", str(folder / "out")])
    return Played(job, before, really, folder / "out", code, said, shown, unknown)


def judge(
    played: Played, mutate: Callable[[VirtualFanuc], VirtualFanuc] = lambda control: control
) -> Outcome:
    """Load what was written and measure again. ``mutate`` turns the judge, to see that its demands
    notice.
    """
    job, before = played.job, played.before
    outcome = Outcome(job, played.code, played.said, played.shown)
    if played.tables.is_dir() and played.code in (0, 1):
        after = control_of(job, reloaded(played.really, played.tables))
        _judge_files(outcome, played, after)
        if played.unknown and job.mark != "warn":
            outcome.faults.append(
                f"written although the pages do not tell what acted before: {played.unknown}"
            )
        elif not played.unknown:
            prediction = json.loads((played.out / "prediction.json").read_text())
            _judge_axes(
                outcome,
                mutate(before),
                mutate(after),
                prediction,
                np.random.default_rng([job.seed, 8]),
            )
    elif (played.out / "tables").exists():
        outcome.faults.append(f"exit {played.code}, and yet there are tables")
    _judge_words(outcome)
    return outcome


def reloaded(really: Mapping[str, bytes], tables: Path) -> Registers:
    """The control after loading: what was in it, and every file of the folder on top; loading
    clears nothing.
    """
    written = sorted(tables.iterdir(), key=lambda path: (path.name not in really, path.name))
    return loaded([*really.values(), *(path.read_bytes() for path in written)])


def acting(control: VirtualFanuc, axis: AxisJob) -> Callable[[Floats, int], Floats]:
    return lambda x, d: control.correction(axis.address, x, d, home=axis.home, rapid=axis.rapid)


# --- the accuracy
# --------------------------------------------------------------------------------------------------


def _judge_axes(
    outcome: Outcome,
    before: VirtualFanuc,
    after: VirtualFanuc,
    prediction: Mapping[str, Any],
    rng: Rng,
) -> None:
    for axis in outcome.job.axes:
        if axis.name not in outcome.written:
            continue
        band = prediction["axes"][axis.name]["predicted_new_targets"]["A"]
        said = band["median"]
        try:
            old, new = (
                median_accuracy(axis, acting(control, axis), rng) for control in (before, after)
            )
        except NotKnownError as reason:
            outcome.faults.append(
                f"{axis.name}: what was written is no table that the pages describe: {reason}"
            )
            continue
        outcome.figures.append(
            f"{axis.name}: A {old:.1f} before, {new:.1f} after, {said:.1f} predicted"
        )
        outcome.within.append(bool(band["p05"] <= new <= band["p95"]))
        if new > FACTOR * said + ROOM or new > old:
            outcome.faults.append(f"HARM {outcome.figures[-1]}")


def median_accuracy(axis: AxisJob, act: Callable[[Floats, int], Floats], rng: Rng) -> float:
    """The median of A over fresh tests at newly placed targets, µm or arcsec."""
    unit = 3600.0 if axis.rotary else 1000.0
    tests = (
        axis.physics.read(rng, dithered(rng, axis.measured, axis.targets), act)
        for _ in range(REPEATS)
    )
    return unit * float(np.median([accuracy(test) for test in tests]))


# --- the words
# --------------------------------------------------------------------------------------------------


def _judge_words(outcome: Outcome) -> None:
    job, code = outcome.job, outcome.code
    if code not in (0, 1, 2, 3, 4):
        outcome.faults.append(f"EXIT {code}")
        return
    missing = [axis.name for axis in job.axes if axis.name not in outcome.written]
    if job.mark == "plain" and missing:
        outcome.faults.append(
            f"WRONG REFUSAL of {missing}: nothing but what the pages describe acts"
        )
    elif job.mark == "refuse" and not missing:
        outcome.faults.append(f"WRITTEN and not refused by {job.names}")
    elif missing and code == 0:
        outcome.faults.append("exit 0 without a table")
    if (
        outcome.written
        and job.names
        and job.mark in ("plain", "warn")
        and not _told(job, outcome.said + outcome.shown)
    ):
        outcome.faults.append(f"WRITTEN without a word on any of {job.names}")
    if (
        missing
        and not _told(job, outcome.said)
        and job.mark != "plain"
        and not (job.mark == "answerable" and code == 1)
    ):
        outcome.faults.append(f"REFUSED WITHOUT NAMING any of {job.names}")


def _told(job: Job, text: str) -> bool:
    return any(re.search(name, text) for name in job.names)


# --- the files
# --------------------------------------------------------------------------------------------------


def _judge_files(outcome: Outcome, played: Played, after: VirtualFanuc) -> None:
    job, before = outcome.job, played.before
    parameters, points = differing(before.registers, after.registers)
    for axis in job.axes:
        if (
            any(group == f"A{axis.address}" for _, group in parameters)
            or points & after.grid(axis.address).numbers()
        ):
            outcome.written.append(axis.name)
    groups = {f"A{axis.address}": axis.address for axis in job.axes}
    groups |= {f"L{before.path(axis.address)}": axis.address for axis in job.axes}
    if foreign := sorted(
        (number, group)
        for number, group in parameters
        if group not in groups
        or number not in own_numbers(job)
        or (group[0] == "L") != (number in OF_PATH)
    ):
        outcome.faults.append(f"FOREIGN parameters changed: {foreign[:4]}, {len(foreign)} in all")
    for axis in job.axes:
        outcome.faults.extend(_numbers(before, after, axis, job))
        outcome.faults.extend(_bits(before, after, axis.address))
        if axis.name in outcome.written:
            outcome.faults.extend(_grid_stays(before, after, axis, outcome))
    outcome.faults.extend(_neighbours(before, after, job))
    outcome.faults.extend(_pitch_data(before, after, points, job))
    outcome.faults.extend(_straightness(before, after, job))
    outcome.faults.extend(_written_files(played, groups))


def own_numbers(job: Job) -> set[int]:
    """What compwright may write for an axis: the table, backlash, and functions that the job says
    are there.
    """
    return (OWN | OF_AXIS | OF_PATH).union(
        *(COUNTED[name] for name in COUNTED if job.options.get(name) == "available")
    )


def _grid_stays(
    before: VirtualFanuc, after: VirtualFanuc, axis: AxisJob, outcome: Outcome
) -> Iterator[str]:
    """Without ``spacing`` numbers, reference and interval stay, or CW-P140 says why not."""
    old, new = before.grid(axis.address), after.grid(axis.address)
    there = old.interval > 0 and old.last > old.first
    first = min(old.first, old.reference)  # 3621 = 3620 + 1 without a wrap: 3621 <= 3620 is asked
    kept = [
        (new.reference, new.first, new.last, new.interval)
        == (old.reference, number, old.last, old.interval)
        for number in (old.first, first)
    ]
    told = "CW-P140" in outcome.said + outcome.shown or "CW-S014" in outcome.said + outcome.shown
    changed = {number for number, _ in differing(before.registers, after.registers)[0]}
    if kept[0] and changed & (OF_AXIS | OF_PATH) and not outcome.job.options:
        yield f"{axis.name}: point numbers of another function changed, and the grid stays"
    if there and "table" not in axis.words and not any(kept) and not told:
        yield f"{axis.name}: the grid that was there moved without a word"


def _neighbours(before: VirtualFanuc, after: VirtualFanuc, job: Job) -> Iterator[str]:
    """What every other axis does stays as it was, to the bit."""
    for axis in set(before.axes()) - {axis.address for axis in job.axes}:
        grid = before.grid(axis)
        low, high = (grid.first - grid.reference - 2, grid.last - grid.reference + 2)
        x = (grid.interval or 1.0) * np.linspace(low, high, 301)
        for home, d, rapid in ((1, 1, False), (1, -1, False), (1, -1, True)):
            found = []
            for control in (before, after):
                try:
                    found.append(control.correction(axis, x, d, home=home, rapid=rapid).tobytes())
                except NotKnownError as reason:
                    found.append(str(reason).encode())
            if found[0] != found[1]:
                yield f"HARM axis {axis}, which is not in the job, does something else than before"
                break


def _pitch_data(
    before: VirtualFanuc, after: VirtualFanuc, points: set[int], job: Job
) -> Iterator[str]:
    mine = set().union(
        *(control.grid(a.address).numbers() for a in job.axes for control in (before, after))
    )
    if job.options.get("cyclic") == "available":
        second = {n for a in job.axes for n in after.cyclic_numbers(a.address)}
        new = second - {n for a in job.axes for n in before.cyclic_numbers(a.address)}
        others = set().union(*owners(before).values())
        if clash := sorted(
            n for n in new if n in others or float(before.registers.pitch.get(n, "0"))
        ):
            yield f"the second table takes numbers of others, or that hold something: {clash[:5]}"
        mine |= second
    if stray := sorted(points - mine):
        yield f"FOREIGN pitch data changed: {stray[:5]}, {len(stray)} in all"


def _written_files(played: Played, groups: Mapping[str, int]) -> Iterator[str]:
    job = played.job
    for name, given in (job.files or {}).items():
        kept = played.out / "rollback" / job.format / name
        if not kept.is_file() or kept.read_bytes() != given:
            yield f"rollback of {name} is no byte copy"
        patched = played.tables / name
        if patched.is_file():
            own = own_numbers(job)
            yield from _lines(name, given, patched.read_bytes(), groups, own)
    for path in sorted(played.tables.iterdir()):
        if path.name not in played.really:
            yield from _fresh(path.name, loaded([path.read_bytes()]), groups, own_numbers(job))


def _bits(before: VirtualFanuc, after: VirtualFanuc, axis: int) -> Iterator[str]:
    old, new = before.entry(3605, axis), after.entry(3605, axis)
    if old is not None and new is not None and old.text[:-1] != new.text[:-1]:
        yield f"3605 of axis {axis}: bits of others changed, {old.text} to {new.text}"


def _numbers(before: VirtualFanuc, after: VirtualFanuc, axis: AxisJob, job: Job) -> Iterator[str]:
    """Where the new table lies: on numbers that nobody else has, points to, or has filled; inside
    what the control takes.
    """
    address = axis.address
    old, grid = before.grid(address), after.grid(address)
    used = grid.numbers()
    if grid == old and not differing(before.registers, after.registers)[1] & used:
        return
    taken = set().union(
        *(numbers for other, numbers in owners(before).items() if other != address)
    ) | pointed(before, address)
    if clash := sorted(used & taken):
        yield f"{axis.name}: numbers of others are taken: {clash[:5]}, {len(clash)} in all"
    alien = [n for n in used - old.numbers() if float(before.registers.pitch.get(n, "0"))]
    if alien:
        yield (
            f"{axis.name}: numbers that hold something are taken: {sorted(alien)[:5]}, {len(alien)}"
            " in all"
        )
    yield from _limits(axis, job, grid, after)
    feed = after.value(1420, address) * (
        25.4 if after.bit(1001, address, 0) and not axis.rotary else 1.0
    )
    if (
        job.files is not None
        and "table" not in axis.words
        and grid.interval < old.interval
        and grid.interval < feed / 7500 - 1e-9
    ):
        yield f"{axis.name}: an interval of {grid.interval:g} is below {feed:g}/7500 (1420)"
    if (
        "first_point" in job.options
        and job.files is None
        and used
        and min(used) < int(job.options["first_point"])
    ):
        yield f"{axis.name}: number {min(used)} is below first_point"


def _limits(axis: AxisJob, job: Job, grid: Grid, after: VirtualFanuc) -> Iterator[str]:
    """What the control itself takes (A4)."""
    used = grid.numbers()
    most_number, most = LIMITS.get(job.format, (1535, 127))
    values = [abs(float(after.registers.pitch.get(n, "0"))) for n in used]
    if used and (max(used) > most_number or min(used) < 0):
        yield f"{axis.name}: numbers {min(used)} to {max(used)} are outside 0 to {most_number}"
    if values and max(values) > most:
        yield f"{axis.name}: an increment of {max(values):g} is more than {most}"
    if not grid.turn and not grid.first <= grid.reference <= grid.last:
        yield (
            f"{axis.name}: 3621 <= 3620 <= 3622 is broken: {grid.first}, {grid.reference},"
            f" {grid.last}"
        )
    if not 0 < grid.magnification <= 100:
        yield f"{axis.name}: 3623 = {grid.magnification}"


def pointed(control: VirtualFanuc, but: int) -> set[int]:
    """Numbers that another function points to: inclination of other axes, straightness, second
    tables of every axis.
    """
    numbers: set[int] = set()
    for (number, group), entry in control.registers.parameters.items():
        inclined = number in range(5861, 5865) and group != f"A{but}"
        straight = any(number in range(first, first + 4) for first in (5731, 5741, 5751))
        if (inclined or straight) and float(entry.text):
            numbers.add(int(entry.text))
    for axis in control.axes():
        numbers |= set(control.cyclic_numbers(axis))
    return numbers - (control.grid(but).numbers() - set(control.cyclic_numbers(but)))


def _straightness(before: VirtualFanuc, after: VirtualFanuc, job: Job) -> Iterator[str]:
    """What an axis under work does to others by straightness compensation stays: its points hang on
    its numbers and interval.
    """
    for axis in job.axes:
        x = np.linspace(*axis.measured, 400)
        old, new = before.straightness(axis.address, x), after.straightness(axis.address, x)
        for bent in old.keys() | new.keys():
            a, b = old.get(bent, np.zeros_like(x)), new.get(bent, np.zeros_like(x))
            slack = max(float(np.abs(np.diff(a)).max()), float(np.abs(np.diff(b)).max()))
            if (worst := float(np.abs(a - b).max())) > slack + 1e-9:
                yield (
                    f"HARM straightness: axis {bent} moves by {1000 * worst:.1f} um more or less"
                    f" while {axis.name} moves"
                )


def _lines(
    name: str, given: bytes, patched: bytes, groups: Mapping[str, int], own: set[int]
) -> Iterator[str]:
    """A patched file differs in values of the axis under work and of pitch data, in nothing else;
    lines neither come nor go.
    """
    old, new = given.split(b"\n"), patched.split(b"\n")
    if len(old) != len(new):
        yield f"{name}: {len(old)} lines became {len(new)}"
        return
    for before, after in zip(old, new, strict=True):
        if before == after:
            continue
        a, b = before.strip(b"\r"), after.strip(b"\r")
        if before.replace(a, b) != after:
            yield f"{name}: the line end changed: {before[-9:]!r} became {after[-9:]!r}"
        blank = [re.sub(rb"(?<=[PMI])[-0-9.]+", b"#", line) for line in (a, b)]
        if blank[0] != blank[1]:
            yield f"{name}: more than values changed: {a[:60]!r} became {b[:60]!r}"
        number = int((re.search(rb"N(\d+)", a) or [b"", b"0"])[1])
        parameter = number < 10000 or b"Q1" in a[:8]
        if parameter and not (number in own and _only(a, b, groups)):
            yield f"{name}: another axis's entry changed: {a[:60]!r} became {b[:60]!r}"
        if number >= 10000 and b"Q1" in a[:8] and number not in own:
            yield (
                f"{name}: a parameter changed as if it were pitch data: {a[:60]!r} became"
                f" {b[:60]!r}"
            )


def _only(a: bytes, b: bytes, groups: Mapping[str, int]) -> bool:
    pairs = zip(
        _GROUP.findall(a.replace(b" ", b"")), _GROUP.findall(b.replace(b" ", b"")), strict=True
    )
    return all(x == y or x[0].decode() in groups for x, y in pairs)


def _fresh(
    name: str, registers: Registers, groups: Mapping[str, int], own: set[int]
) -> Iterator[str]:
    for number, group in registers.parameters:
        if group not in groups or number not in own:
            yield f"{name}: entry {number} {group} is not of an axis under work"
        if number == 3605:
            yield f"{name}: 3605 as a whole byte, without having read what stands there"
