"""One job before a virtual SINUMERIK: measure what acts, run, load by the card, measure again,
demand that no harm was done.
"""

from __future__ import annotations

import difflib
import json
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from backup_cases_sinumerik import ANSWERABLE, MUST_REFUSE, PLAIN, Case
from card_files import wrong_files
from harm_following import for_each_axis
from virtual_sinumerik import Register, VirtualSinumerik, assignments

Floats = NDArray[np.float64]
Run = Callable[[list[str]], tuple[int, str]]
REPEATS = 15
_HARMLESS_LINES = re.compile(
    r"^\s*(%.*|;.*|METRIC|INCH|CHANDATA\(\d+\)|NEWCONF|STOPRE|M17|M30)?\s*$"
)


@dataclass(frozen=True)
class AxisError:
    """What the axis does without any compensation: a smooth curve, a slope, lost motion, noise. mm
    or deg.
    """

    low: float
    high: float
    slope: float
    waves: tuple[tuple[float, float, float], ...]
    lost: float
    noise: float
    datum: float

    def mean(self, x: Floats, direction: int) -> Floats:
        u = (x - self.low) / (self.high - self.low)
        curve: Floats = self.slope * u
        for amplitude, cycles, phase in self.waves:
            curve = curve + amplitude * np.sin(2 * np.pi * cycles * u + phase)
        result: Floats = curve - direction * self.lost / 2
        return result


def error_of(case: Case, rng: np.random.Generator) -> AxisError:
    """Two waves, 8 to 35 µm (arcsec) over the travel, lost motion 0 to 9, noise 0.3 to 0.8; a full
    turn closes.
    """
    unit = case.unit
    turn = case.modulo
    waves = (
        (
            float(rng.uniform(5, 10)) * unit,
            float(rng.integers(1, 3)) if turn else float(rng.uniform(0.3, 1.1)),
            float(rng.uniform(0, 6)),
        ),
        (
            float(rng.uniform(0.5, 1.5)) * unit,
            float(rng.integers(2, 5)) if turn else float(rng.uniform(1.2, 2.2)),
            float(rng.uniform(0, 6)),
        ),
    )
    slope = 0.0 if turn else float(rng.choice([-1, 1]) * rng.uniform(8, 25)) * unit
    low, high = case.travel
    return AxisError(
        low,
        high,
        slope,
        waves,
        float(rng.uniform(0, 9)) * unit,
        float(rng.uniform(0.3, 0.8)) * unit,
        float(rng.normal(0, 20)) * unit,
    )


def targets_of(case: Case, rng: np.random.Generator, count: int) -> Floats:
    """Equal intervals with a random part, at least 4 mm (1 deg) from the ends (ISO 230-2, 4.2)."""
    low, high = case.travel
    edge = 1.0 if case.rotary else 4.0
    places: Floats = (
        low + (np.arange(count) + 0.5 + rng.uniform(-0.3, 0.3, count)) * (high - low) / count
    )
    return np.asarray(np.round(np.clip(places, low + edge, high - edge), 3), dtype=np.float64)


def measure(
    control: VirtualSinumerik,
    case: Case,
    error: AxisError,
    targets: Floats,
    rng: np.random.Generator,
) -> dict[int, Floats]:
    """Five readings per target and direction."""
    datum = rng.normal(0, 10) * case.unit
    readings = {}
    for direction in (1, -1):
        mean = (
            error.mean(targets, direction)
            + control.correction(case.axis, targets, direction)
            + datum
        )
        readings[direction] = mean[:, None] + rng.normal(0, error.noise, (targets.size, 5))
    return readings


def accuracy(readings: dict[int, Floats]) -> float:
    """A of ISO 230-2 with k = 2."""
    means = {d: r.mean(axis=1) for d, r in readings.items()}
    spreads = {d: 2 * r.std(axis=1, ddof=1) for d, r in readings.items()}
    return float(
        max((means[d] + spreads[d]).max() for d in readings)
        - min((means[d] - spreads[d]).min() for d in readings)
    )


def control_before(case: Case) -> VirtualSinumerik:
    """The control as it was when the test was taken."""
    control = VirtualSinumerik(
        cec_sign=case.cec_sign,
        reference_return={case.axis: case.home},
        dynamic_on=case.dynamic_on,
        positions=dict(case.positions),
        own_beside_product=case.own_beside_product,
        point_beyond=case.point_beyond,
    )
    control.used[case.axis] = case.system
    if case.gantry:
        control.used[case.gantry] = case.system
    for text in case.holds():
        control.load(text, protected=False)
    if case.enabled is not None:
        switch(control, f"$MA_ENC_COMP_ENABLE[{case.system},{case.axis}]={int(case.enabled)}")
    return control


def switch(control: VirtualSinumerik, statement: str) -> None:
    control.load(statement, protected=True)


@dataclass(repr=False)
class Outcome:
    """What one job came to. ``harms`` is what must not be."""

    case: Case
    code: int
    message: str
    written: bool = False
    before: float = 0.0
    after: float = 0.0
    predicted: float = 0.0
    band: tuple[float, float] = (0.0, 0.0)
    loaded: VirtualSinumerik | None = None
    harms: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    files: dict[str, bytes] = field(default_factory=dict)
    card: str = ""
    error: AxisError | None = None
    count: int = 0  # targets of the test

    def __repr__(self) -> str:
        return self.line()

    def line(self) -> str:
        numbers = (
            f" before {self.before:.1f} predicted {self.predicted:.1f} after {self.after:.1f}"
            if self.written
            else ""
        )
        about = f"seed {self.case.seed} [{', '.join(self.case.told)}] {self.case.mark}"
        return f"{about}: exit {self.code}{numbers}: {'; '.join(self.harms)}"


def rows_of(case: Case, readings: dict[int, Floats], targets: Floats) -> str:
    unit, factor, name = ("deg", 3600.0, "arcsec") if case.rotary else ("mm", 1000.0, "um")
    rows = [
        f"# axis: {case.letter}",
        "# cycle: standard",
        "# deviation: measured minus target",
        f"target_{unit},direction,run,deviation_{name}",
    ]
    for direction, mark in ((1, "+"), (-1, "-")):
        for target, values in zip(targets, readings[direction], strict=True):
            rows += [
                f"{target:.3f},{mark},{run},{value * factor:.4f}"
                for run, value in enumerate(values, 1)
            ]
    return "\n".join(rows) + "\n"


def write_job(folder: Path, case: Case, readings: dict[int, Floats], targets: Floats) -> Path:
    (folder / "x.csv").write_text(rows_of(case, readings, targets))
    (folder / "control").mkdir()
    for file, text in case.given().items():
        (folder / "control" / file).write_bytes(text.encode("latin-1"))
    listed = "[" + ", ".join(f"control/{file}" for file in case.given()) + "]"
    state = (
        "none"
        if case.none
        else listed
        if case.active is None
        else f"{{files: {listed}, active: {case.active}}}"
    )
    options = "{" + ", ".join(f"{key}: {value}" for key, value in case.options.items()) + "}"
    axis = [
        f"kind: {case.kind}",
        f"travel: [{case.travel[0]:g}, {case.travel[1]:g}]",
        f"address: {case.address}",
        "before: [x.csv]",
    ]
    axis += ["modulo: 360"] if case.modulo and case.kind == "rotary" else []
    axis += [f"reference: {case.reference:g}"] if case.reference else []
    axis += ['reference_return: "-"'] if case.home < 0 else []
    axis += [f"encoder: {{system: {case.job_system}}}"] if case.job_system else []
    axis += [f"gantry: {case.gantry}"] if case.gantry else []
    axis += (
        ["table: {" + ", ".join(f"{k}: {v}" for k, v in case.table.items()) + "}"]
        if case.table
        else []
    )
    job = folder / "job.yaml"
    job.write_text(
        f"compwright: 1\ncontroller: {{format: {case.format}, options: {options}}}\nstates: {{as_found:"
        f" {state}}}\naxes:\n  {case.letter}: {{{', '.join(axis)}}}\n"
    )
    return job


def try_case(case: Case, folder: Path, run: Run) -> Outcome:
    """Measure, run the job in ``folder``, load what it wrote, measure again."""
    rng = np.random.default_rng([230, case.seed])
    error = error_of(case, rng)
    control = control_before(case)
    targets = targets_of(case, rng, int(rng.integers(13, 24)))
    readings = measure(control, case, error, targets, rng)
    code, message = run(
        ["run", str(write_job(folder, case, readings, targets)), "--out", str(folder / "out")]
    )
    outcome = Outcome(case, code, message, before=accuracy(readings) / case.unit, error=error)
    outcome.count = targets.size
    tables = folder / "out" / "tables" / case.format
    outcome.written = tables.is_dir()
    if outcome.written:
        outcome.files = {path.name: path.read_bytes() for path in sorted(tables.iterdir())}
        outcome.card = (folder / "out" / "card" / "card.md").read_text(encoding="utf-8")
        outcome.harms += wrong_files(folder / "out")
        document = json.loads((folder / "out" / "prediction.json").read_text(encoding="utf-8"))
        outcome.predicted = document["axes"][case.letter]["predicted_new_targets"]["A"]["median"]
        outcome.band = (
            document["axes"][case.letter]["predicted_new_targets"]["A"]["p05"],
            document["axes"][case.letter]["predicted_new_targets"]["A"]["p95"],
        )
        demand_of_written(outcome, control, folder / "out", targets.size)
    else:
        demand_of_refused(outcome)
    if code == 70:
        outcome.harms.append("exit 70")
    return outcome


def demand_of_refused(outcome: Outcome) -> None:
    case = outcome.case
    if case.mark == PLAIN:
        outcome.harms.append(f"plain, but refused: {outcome.message.strip()[-300:]}")
        return
    if outcome.code not in {2, 3, 4} and not (case.mark == ANSWERABLE and outcome.code == 1):
        outcome.harms.append(f"no table, exit {outcome.code}")
    if case.code is not None and outcome.code != case.code:
        outcome.harms.append(f"exit {outcome.code}, not {case.code}")
    if not re.search(case.demand, outcome.message, re.IGNORECASE):
        outcome.harms.append(
            f"the refusal does not name {case.demand}: {outcome.message.strip()[-300:]}"
        )


def demand_of_written(outcome: Outcome, before: VirtualSinumerik, out: Path, count: int) -> None:
    case = outcome.case
    if case.mark == MUST_REFUSE:
        outcome.harms.append(f"written, though it must be refused by {case.demand}")
    control = before.copy()
    control.refused.clear()
    load_by_card(control, outcome)
    outcome.loaded = control
    lost = [
        f"{'$' + r.register[0]}{list(r.register[1])}: {r.why}"
        for r in control.refused
        if r.mattered
    ]
    if lost:
        outcome.harms.append(f"{len(lost)} values loaded while they are protected, first {lost[0]}")
    if control.refused and not lost:
        outcome.remarks.append(
            f"{len(control.refused)} values loaded again while protected (unchanged)"
        )
    if case.stated_wrong:
        return
    outcome.after = fresh(control, outcome, count)
    if not outcome.after < 1.4 * outcome.predicted + 1:
        outcome.harms.append(
            f"A {outcome.after:.1f} after, {outcome.predicted:.1f} predicted, {outcome.before:.1f}"
            " before"
        )
    if not outcome.after < outcome.before:
        outcome.harms.append(f"worse than before: {outcome.before:.1f} to {outcome.after:.1f}")
    outcome.harms += foreign_registers(case, before, control)
    outcome.harms += entries_of_others(case, control, outcome.files)
    outcome.harms += moved_grid(outcome, before, control)
    outcome.harms += way_back(outcome, before, control, out)
    outcome.harms += foreign_bytes(
        case,
        outcome.files,
        {name: text.encode("latin-1") for name, text in case.given().items()},
        out,
    )


def fresh(control: VirtualSinumerik, outcome: Outcome, count: int) -> float:
    """The median A of new tests at newly dithered targets, in µm or arcsec."""
    assert outcome.error is not None
    rng = np.random.default_rng([231, outcome.case.seed])
    values = []
    for _ in range(REPEATS):
        targets = targets_of(outcome.case, rng, count)
        values.append(accuracy(measure(control, outcome.case, outcome.error, targets, rng)))
    return float(np.median(values)) / outcome.case.unit


# -- loading
# --------------------------------------------------------------------------------------------------


def load_by_card(control: VirtualSinumerik, outcome: Outcome) -> None:
    """The steps of the card in their order: what it switches is switched, what it loads is loaded,
    nothing else.
    """
    texts = {name: content.decode("latin-1") for name, content in outcome.files.items()}
    left = dict(texts)
    listed = steps(outcome.card)
    too = next(
        (
            found[1]
            for _, text in listed
            if (found := re.search(r"every step for the synchronised axis (\w+)", text))
        ),
        None,
    )
    for title, text in listed:
        if re.search(r"save|archive|sign|way back|read back|check", title, re.IGNORECASE):
            continue
        events = switched(text, outcome, too)
        for register, points in reserved(text):
            reserve(control, outcome, register, points)
        place = re.search(r"\bLoad\b", text)
        if place is not None:
            named = {
                name: found.start()
                for name in texts
                if (found := re.search(rf"(?<![\w/.]){re.escape(name)}", text))
            }
            kind = [] if named else kinds(title + text, texts)
            events += [(at, name) for name, at in named.items()] + [
                (place.start(), name) for name in kind
            ]
        for _, event in sorted(events, key=lambda e: e[0]):
            control.load(texts.get(event, event))
            left.pop(event, None)
    if left:
        outcome.remarks.append(f"the card loads no {sorted(left)}")
        if any(matters(control, text) for text in left.values()):
            outcome.harms.append(f"no step of the card loads {sorted(left)}")


def switched(text: str, outcome: Outcome, too: str | None) -> list[tuple[int, str]]:
    """What a step sets, and where in its words; ``too``: the synchronised axis for which every step
    is to be done again.
    """
    events: list[tuple[int, str]] = []
    for found in re.finditer(
        r"(\$[A-Z]+_\w+)(\[[^\]]*\])?\s*=\s*([-+\d.]+(?:[eE][-+]?\d+)?|TRUE|FALSE)", text
    ):
        if re.search(r"\d[eE][-+]?\d", found[3]):
            outcome.harms.append(f"the card asks to type {found[0]}: the control takes no exponent")
        for index in indices(found[1], found[2], text[found.end() :]):
            statement = f"{found[1]}{index}={found[3].rstrip('.')}"
            events.append((found.start(), statement))
            if too and re.search(rf"\b{outcome.case.axis}\]", statement):
                events.append(
                    (found.start(), re.sub(rf"\b{outcome.case.axis}\]", f"{too}]", statement))
                )
    return events


def reserved(text: str) -> list[tuple[str, int]]:
    """The points that a step asks to reserve."""
    found = re.finditer(r"(\$M[AN]_MM_\w+)(\[[^\]]*\])?\s+must be at least (\d+)", text)
    return [
        (f"{one[1]}{index}", int(one[3]))
        for one in found
        for index in indices(one[1], one[2], text[one.end() :])
    ]


def indices(name: str, index: str | None, rest: str) -> list[str]:
    """The index of a register, or those of the tables that the words behind it name: "for the
    tables 9 and 10".
    """
    if index is not None or "CEC" not in name:
        return [index or ""]
    words = re.match(r"\W*(?:for )?(?:the )?tables? ((?:\d+(?:, | and )?)+)", rest)
    return [f"[{t}]" for t in re.findall(r"\d+", words[1])] if words else [""]


def reserve(control: VirtualSinumerik, outcome: Outcome, register: str, points: int) -> None:
    """What the card lets the operator reserve, unless a file that is loaded says a smaller
    number.
    """
    ((name, index), _), *_ = assignments(f"{register}=0")
    own = (name, tuple(control.axis(token) for token in index))
    says = [
        value.number
        for content in outcome.files.values()
        for key, value in assignments(content.decode("latin-1"))
        if key[0] == name and tuple(control.axis(token) for token in key[1]) == own[1]
    ]
    if min(says, default=points) >= points > control.value(name, *own[1]):
        control.load(f"{register}={points}")


def matters(control: VirtualSinumerik, text: str) -> bool:
    """Whether a file holds anything that the control does not hold already."""
    other = control.copy()
    other.load(text, protected=False)
    return any(
        key not in control.registers or value.text != control.registers[key].text
        for key, value in other.registers.items()
    )


def kinds(words: str, texts: dict[str, str]) -> list[str]:
    """The files that a step means which names a kind of file: with the table, with the backlash,
    with the cross tables.
    """
    wanted = (
        r"\$AN_CEC"
        if re.search(r"CEC", words)
        else r"\$MA_BACKLASH"
        if re.search(r"(?i)backlash", words)
        else r"\$AA_ENC_COMP"
    )
    return [name for name, text in texts.items() if re.search(wanted, text)]


def steps(card: str) -> list[tuple[str, str]]:
    """Title and text of each step, in the order of the card."""
    section = re.search(r"^## Steps\n(.*?)(?=^## )", card, re.MULTILINE | re.DOTALL)
    assert section is not None, "the card has no steps"
    found = []
    for block in re.split(r"^- \[ \] ", section[1], flags=re.MULTILINE)[1:]:
        head, _, rest = block.partition("\n")
        found.append((head.strip("* "), for_each_axis(re.sub(r"\\(.)", r"\1", rest))))
    return found


# -- what must not change
# --------------------------------------------------------------------------------------------------


def belongs(case: Case, control: VirtualSinumerik, register: Register) -> bool:
    """Whether a register is the axis' own: its table, backlash, switch and points, in the system in
    use; or a table given to it.
    """
    name, index = register
    own = {case.axis, case.gantry} - {None}
    axes = tuple(control.axis(token) for token in index)
    if name.startswith("AA_ENC_COMP") or name in {
        "MA_BACKLASH",
        "MA_ENC_COMP_ENABLE",
        "MA_MM_ENC_COMP_MAX_POINTS",
    }:
        return axes[-1] in own and axes[0] == str(case.system)
    if name == "MA_BACKLASH_FACTOR":
        return axes[-1] in own
    if name == "MA_CEC_ENABLE":
        return axes[0] in own and bool(case.written_tables)
    if name.startswith(("AN_CEC", "SN_CEC_TABLE_", "SN_CEC_0", "SN_CEC_1", "MN_MM_CEC_MAX_POINTS")):
        return bool(axes) and axes[0] in case.written_tables
    return False


def foreign_registers(case: Case, before: VirtualSinumerik, after: VirtualSinumerik) -> list[str]:
    changed = []
    for register in before.registers.keys() | after.registers.keys():
        old, new = before.registers.get(register), after.registers.get(register)
        if belongs(case, after, register) or (
            old
            and new
            and (old.text == new.text or _number(old.text) == _number(new.text) is not None)
        ):
            continue
        changed.append(
            f"${register[0]}{list(register[1])}: {old.text if old else None} to"
            f" {new.text if new else None}"
        )
    return [f"{len(changed)} registers of others differ, first {min(changed)}"] if changed else []


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def foreign_bytes(
    case: Case, written: dict[str, bytes], given: dict[str, bytes], out: Path
) -> list[str]:
    """Lines of the control's files that differ and are not the axis' own, and rollback files that
    are no copies; small files that bring old values back may lie beside them.
    """
    control = control_before(case)
    harms = []
    for name, content in written.items():
        if name not in given:
            continue
        for old, new in changes(given[name].split(b"\n"), content.split(b"\n")):
            for line in [*old, *new]:
                text = line.decode("latin-1")
                found = [register for register, _ in assignments(text)]
                if not own_line(case, control, found) and (
                    found or old or not _HARMLESS_LINES.match(text)
                ):
                    harms.append(f"{name}: a line that is not the axis' own differs: {text!r}")
            if len(old) == len(new):
                pairs = zip(old, new, strict=True)
                harms += [
                    f"{name}: more than the value differs: {a!r} {b!r}"
                    for a, b in pairs
                    if _frame(a) != _frame(b)
                ]
    folder = out / "rollback" / case.format
    copies = {path.name: path.read_bytes() for path in folder.iterdir()} if folder.is_dir() else {}
    harms += [
        f"rollback: {name} is no copy"
        for name, content in copies.items()
        if not name.startswith("BACK_") and given.get(name) != content
    ]
    harms += [f"rollback: {name} is missing" for name in given if name not in copies]
    return harms[:3]


def entries_of_others(
    case: Case, control: VirtualSinumerik, written: dict[str, bytes]
) -> list[str]:
    """Entries in files of our own that are not the axis' own, whatever their value is."""
    found = [
        f"{name}: enters ${register[0]}{list(register[1])}, which is not the axis' own"
        for name, content in written.items()
        if name not in case.given()
        for register, _ in assignments(content.decode("latin-1"))
        if not belongs(case, control, register)
    ]
    return found[:1]


def moved_grid(outcome: Outcome, before: VirtualSinumerik, after: VirtualSinumerik) -> list[str]:
    """A grid that the job did not ask to move, that is whole, that fits and that moved."""
    case, e = outcome.case, str(outcome.case.system)
    keys = [f"AA_ENC_COMP_{key}" for key in ("STEP", "MIN", "MAX")]
    old = [before.value(key, e, case.axis) for key in keys]
    new = [after.value(key, e, case.axis) for key in keys]
    step, low, high = (before.length(case.axis, key, e, case.axis) for key in keys)
    if "spacing" in case.table or case.written_tables or case.none or step <= 0 or old == new:
        return []
    count = (high - low) / step
    reserved = before.value("MA_MM_ENC_COMP_MAX_POINTS", e, case.axis, default=5000)
    travel = case.travel[1] - case.travel[0]
    covered = min(high, case.travel[1]) - max(low, case.travel[0])
    fits = (
        abs(count - round(count)) < 1e-3
        and 2 <= round(count) + 1 <= reserved
        and (high - low == travel if case.modulo else covered > travel / 2)
    )
    # Zero at the reference is a condition of what is written, and a turn is counted from there.
    apart = (case.reference - low) / step
    fits = fits and (not case.modulo or abs(apart - round(apart)) < 1e-3)
    known = case.active not in {"no", "false"}
    return [f"the grid moved: {old} to {new}"] if fits and known else []


def way_back(
    outcome: Outcome, before: VirtualSinumerik, loaded: VirtualSinumerik, out: Path
) -> list[str]:
    """The small files of the way back, loaded as the card says, bring back every register that
    counts, to the last digit.
    """
    case = outcome.case
    folder = out / "rollback" / case.format
    back = {path.name: path for path in folder.glob("BACK_*")} if folder.is_dir() else {}
    words = re.sub(r"\\(.)", r"\1", outcome.card.partition("## Way back")[2].partition("\n## ")[0])
    named = sorted((words.index(name), name) for name in back if name in words)
    if len(named) < len(back):
        return [f"the way back does not name {sorted(set(back) - {name for _, name in named})}"]
    if not back:
        return [] if case.none else ["no small files of the way back"]
    control = loaded.copy()
    for axis in {case.axis, case.gantry} - {None}:
        control.load(f"$MA_ENC_COMP_ENABLE[{case.system},{axis}]=0")
    for t in case.written_tables:
        control.load(f"$SN_CEC_TABLE_ENABLE[{t}]=0")
    if case.written_tables:
        control.load(f"$MA_CEC_ENABLE[{case.axis}]=0")
    for _, name in named:
        control.load(back[name].read_text(encoding="ascii"))
    if case.written_tables:
        on = before.value("MA_CEC_ENABLE", case.axis)
        control.load(f"$MA_CEC_ENABLE[{case.axis}]={on:g}")
    x = np.linspace(*case.travel, 60)
    worst = max(
        float(np.ptp(control.correction(case.axis, x, d) - before.correction(case.axis, x, d)))
        for d in (1, -1)
    )
    harms = [] if worst < 1e-12 else [f"the way back leaves {worst * 1e3:.4g} um (mdeg)"]
    if case.none or case.files is not None or case.active is not None or case.written_tables:
        return harms
    return harms + [f"the way back: {harm}" for harm in unlike(before, control)]


def unlike(before: VirtualSinumerik, after: VirtualSinumerik) -> list[str]:
    """Registers that the control held and that hold another value now."""
    found = [
        f"${name}{list(index)}: {old.text} to {after.registers[name, index].text}"
        for (name, index), old in before.registers.items()
        if not name.startswith("MA_MM_")
        and old.text != after.registers[name, index].text
        and (_number(old.text) is None or old.number != _number(after.registers[name, index].text))
    ]
    return found[:1]


def own_line(case: Case, control: VirtualSinumerik, found: list[Register]) -> bool:
    return bool(found) and all(belongs(case, control, register) for register in found)


def changes(old: list[bytes], new: list[bytes]) -> list[tuple[list[bytes], list[bytes]]]:
    """The groups of lines that differ, old and new."""
    if len(old) == len(new):
        return [([a], [b]) for a, b in zip(old, new, strict=True) if a != b]
    first = next(
        (n for n, (a, b) in enumerate(zip(old, new, strict=False)) if a != b),
        min(len(old), len(new)),
    )
    last = next(
        (
            n
            for n, (a, b) in enumerate(zip(old[first:][::-1], new[first:][::-1], strict=False))
            if a != b
        ),
        0,
    )
    old, new = old[first : len(old) - last], new[first : len(new) - last]
    codes = difflib.SequenceMatcher(None, old, new, autojunk=False).get_opcodes()
    return [(old[i1:i2], new[j1:j2]) for tag, i1, i2, j1, j2 in codes if tag != "equal"]


def _frame(line: bytes) -> bytes:
    """A line without its value and its checksum (which a changed line must lose): what stands
    before it, its ending.
    """
    return re.sub(rb"=(\s*)[^\s;]+", rb"=\1", re.sub(rb" '[0-9A-Fa-f]{4}(?=\r?$)", b"", line))


def clean(folder: Path) -> Path:
    """An empty folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder
