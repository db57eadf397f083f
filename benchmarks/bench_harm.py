"""Random programs, columns and exports: what a control of the judge's own ends with, by outcome.

    python benchmarks/bench_harm.py [programs|columns|exports] [--count N] [--seed 1] [--keep DIR]

``harmed``: exit 0, and the axis is worse than before, or not what was predicted. ``neighbour``:
exit 0, and another axis does something else, or two columns have moved apart. ``refused``: a plain
case was not written. ``asked``: a case whose files do not say what acts was asked about or refused.
Cases that harmed or were refused wrongly are kept, with job and files.
"""

from __future__ import annotations

import argparse
import random
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from harm_bridges import BRIDGES, Column, Skew
from harm_columns import APART, FIRST, load, prepare, snapshot
from harm_command import command, tables_of
from harm_exports import CROSS, Held, file, judge, separate
from harm_exports import prepare as exported
from harm_measuring import measure
from harm_program_jobs import read, run
from harm_programs import GRID, LOST, OFF, ON, OTHERS, VALUES, World, ends, program

#: Statements without any effect on compensation, and pairs that open and close a flow.
IDLE = [
    "STOPRE",
    "G4 F1",
    'MSG("IF R1==1 GOTOF ENDE")',
    "R77=1",
    "; RET",
    ";GOTOF X",
    "",
    "NEWCONF",
]
PAIRS = [
    ("IF R50==1", "ENDIF"),
    ("IF NOT (R50==1)", "ENDIF"),
    ("WHILE R50==1", "R50=0\nENDWHILE"),
    ("FOR R1=1 TO R50", "ENDFOR"),
    ("IF R50==1 GOTOF HIER", "HIER:"),
    ("GOTOF DORT", "DORT: R78=1"),
    ("CASE R50 OF 1 GOTOF DA DEFAULT GOTOF WEG\nDA:", "WEG:"),
    ("REPEAT", "UNTIL R50<>1"),
    ("IF R50==1\nR79=1\nELSE", "ENDIF"),
    ("/GOTOF SPRUNG", "SPRUNG:"),
]
SINGLE = [
    "RET",
    "L100",
    "SETZEN",
    'CALL "KOMP_X"',
    "/M17",
    "IF R50==1 GOTOF ENDE",
    "IF R50==0\nRET\nENDIF",
]


def random_program(rng: random.Random) -> str:
    """Put idle statements, flow around or between the parts, or flow after them."""
    rows = [*OFF, *VALUES, *GRID, *LOST, *ON]
    tail: list[str] = []
    for _ in range(rng.randrange(4)):
        rows.insert(rng.randrange(len(rows) + 1), rng.choice(IDLE))
    kind = rng.choice(["plain", "after", "pair", "pair", "single", "second"])
    if kind == "after":
        opening, closing = rng.choice(PAIRS)
        tail = [*opening.split("\n"), rng.choice(IDLE), *closing.split("\n")]
    elif kind == "pair":
        opening, closing = rng.choice(PAIRS)
        first, last = sorted(rng.sample(range(len(rows) + 1), 2))
        rows = [
            *rows[:first],
            *opening.split("\n"),
            *rows[first:last],
            *closing.split("\n"),
            *rows[last:],
        ]
    elif kind == "single":
        rows.insert(rng.randrange(len(rows) - 1), rng.choice(SINGLE))
        tail = ["ENDE:"]
    elif kind == "second":
        at = rng.randrange(len(VALUES))
        opening, closing = rng.choice(PAIRS)
        tail = [*opening.split("\n"), OTHERS[at], *closing.split("\n")]
    if rng.random() < 0.3:
        rows = [
            f"N{10 * i} {row}" if row and row[0] not in "/;" else row
            for i, row in enumerate(rows, 1)
        ]
        rows = [row if ":" not in row else row.split(" ", 1)[1] for row in rows]
    return program(
        *(row for part in rows for row in part.split("\n")),
        tail,
        end=rng.choice(["M17", "M30", ""]),
    )


def programs(rng: random.Random, folder: Path) -> str:
    """One program: certain ones are read right, others are asked about."""
    text = random_program(rng)
    (folder / "P.MPF").write_text(text, encoding="utf-8")
    found = set(ends(text))
    if len(found) == 1:
        got = read(folder)
        plain = not any(_is_flow(row) for row in text.split(ON[0])[0].splitlines())
        if got is None:
            return "refused" if plain and _is_flow_free(text) else "declined"
        return "good" if {got} == found else "harmed"
    answer, _ = run(folder, text, World())
    return "asked" if answer.declined else "harmed"


def _is_flow(row: str) -> bool:
    words = row.split(";", maxsplit=1)[0].replace("/", "/ ").split()
    return any(word in _FLOW for word in words) and not row.lstrip().startswith("MSG")


_FLOW = {
    "IF",
    "WHILE",
    "FOR",
    "REPEAT",
    "CASE",
    "GOTOF",
    "RET",
    "L100",
    "SETZEN",
    "CALL",
    "/",
    "ELSE",
    "M17",
    "M30",
}


def _is_flow_free(text: str) -> bool:
    """Whether no compensation value stands behind the flow."""
    return not any(row.startswith("$") for row in text.split(ON[0])[1].splitlines())


def columns(rng: random.Random, folder: Path) -> str:
    """One bridge with random contents in both columns."""
    bridge = BRIDGES[rng.choice(list(BRIDGES))]()
    step = rng.choice([50.0, 100.0])
    other = Column(
        [0, *(rng.randrange(-30, 5) for _ in range(round(600 / step)))], step, rng.randrange(9)
    )
    coupling = rng.choice(["", *bridge.couplings, bridge.couplings[0]])
    gantry = rng.choice(["", "IT", "{axis: IT, table: change}"]) if coupling else ""
    coupling = bridge.couplings[0] if "change" in gantry else coupling
    path = prepare(folder, bridge, other, coupling, gantry)
    one, two = (snapshot(bridge, address) for address in (bridge.lead, bridge.partner))
    before = measure(FIRST, bridge.correction(bridge.lead), seed=3).A()
    answer = command("run", path)
    if coupling and "change" not in gantry:
        return "asked" if answer.declined and not tables_of(folder / "job") else "neighbour"
    if answer.code:
        return "refused"
    load(bridge, folder / "job")
    if measure(FIRST, bridge.correction(bridge.lead), seed=3).A() > before:
        return "harmed"
    skew = Skew()
    moved = skew.changes(two, bridge.correction(bridge.partner))
    if not coupling:
        return "neighbour" if any(moved) else "good"
    pairs = zip(skew.changes(one, bridge.correction(bridge.lead)), moved, strict=True)
    return "good" if max(abs(a - b) for a, b in pairs) < APART else "neighbour"


def exports(rng: random.Random, folder: Path) -> str:
    """Several active axes of a SINUMERIK, some under work, in files of random shape."""
    system = rng.choice([0, 0, 1])
    axes = [
        Held(f"AX{k}", round(rng.uniform(-6, 6), 2), 1, rng.choice([0.0, 0.002, 0.005]), system)
        for k in rng.sample(range(1, 9), rng.randrange(2, 5))
    ]
    mine = rng.sample(axes, rng.choice([1, 1, 2]))
    shape = rng.randrange(4)
    if shape == 0:
        files = separate(*axes)
    elif shape == 1:
        files = {"NC.INI": file(*(axis.data() for axis in axes), *(axis.table() for axis in axes))}
    elif shape == 2:
        files = {f"{axis.address}.INI": file(axis.data(), axis.table()) for axis in axes}
    else:
        files = {"MD.INI": file(*(axis.data() for axis in axes))}
        files |= {f"{axis.address}_EEC.INI": file(axis.table()) for axis in axes}
    if rng.random() < 0.3 and {"AX2", "AX3"} <= {axis.address for axis in axes}:
        files |= {"NC_CEC.INI": file(CROSS)}
        mine = [axis for axis in axes if axis.address != "AX3"][:1]
    if command("run", exported(folder, files, mine, "")).code:
        return "refused"
    try:
        judge(folder, files, mine)
    except AssertionError as fault:
        return "neighbour" if "neighbours" in str(fault) else "harmed"
    return "good"


KINDS: dict[str, Callable[[random.Random, Path], str]] = {
    "programs": programs,
    "columns": columns,
    "exports": exports,
}


def main() -> None:
    """Try random cases and count."""
    parser = argparse.ArgumentParser()
    parser.add_argument("kind", choices=KINDS, nargs="?", default="programs")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=Path)
    given = parser.parse_args()
    counts: Counter[str] = Counter()
    for number in range(given.seed, given.seed + given.count):
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            outcome = KINDS[given.kind](random.Random(number), folder)  # noqa: S311 - cases, no secret
            counts[outcome] += 1
            if given.keep and outcome in {"harmed", "neighbour", "refused"}:
                shutil.copytree(
                    folder, given.keep / f"{given.kind}-{number}-{outcome}", dirs_exist_ok=True
                )
                print(number, outcome, flush=True)
    print(given.kind, dict(counts))


if __name__ == "__main__":
    main()
