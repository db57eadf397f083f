"""A program as the state of a job: the test in the true world, what is read, what is loaded."""

from __future__ import annotations

from pathlib import Path

from harm_command import Answer, card_of, command, document, tables_of
from harm_following import follow
from harm_measuring import Axis, measure, write_csv
from harm_programs import AXIS, NODES, World
from harm_sinumerik import Control

MACHINE = Axis(slope=45, lost=6)
FORMAT = "siemens-840d-sl"


def job(folder: Path, control: Control, files: dict[str, str], state: str) -> Path:
    """Write program, job, and the test of the machine in the true world."""
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    before = measure(MACHINE, lambda x, d: control.correction(AXIS, x, d))
    write_csv(folder / "x.csv", "X", before)
    path = folder / "job.yaml"
    path.write_text(
        f"compwright: 1\ncontroller: {{format: {FORMAT}}}\nstates:\n  as_found: {state}\n"
        f"axes:\n  X: {{travel: [0, 600], address: {AXIS}, before: [x.csv]}}\n",
        encoding="utf-8",
    )
    return path


def run(folder: Path, text: str, world: World, active: str = "") -> tuple[Answer, Control]:
    control = world.control()
    control.load(text)
    control.reset()
    state = f"{{files: [P.MPF], active: {active}}}" if active else "[P.MPF]"
    return command("run", job(folder, control, {"P.MPF": text}, state)), control


def read(folder: Path) -> tuple[float, ...] | None:
    """Give what ``decode`` says of the program at the nodes, mm; None where it declines."""
    at = ",".join(map(str, NODES))
    answer = command("decode", folder / "P.MPF", "--format", FORMAT, "--at", at, "--json", "-")
    if answer.code:
        assert answer.declined
        return None
    found = answer.json()["axes"].get(AXIS)
    if found is None:
        return (0.0,) * (2 * len(NODES))
    return tuple(
        round(value / 1000, 7)
        for value in found["correction_positive"] + found["correction_negative"]
    )


def better(folder: Path, control: Control) -> bool:
    """Load what ``run`` wrote as its card says, measure again, and compare A."""
    before = measure(MACHINE, lambda x, d: control.correction(AXIS, x, d)).A()
    card = card_of(folder / "job")
    files = {path.name: path.read_text(encoding="utf-8") for path in tables_of(folder / "job")}
    assert not follow(card, files, control)
    after = measure(MACHINE, lambda x, d: control.correction(AXIS, x, d), seed=4).A()
    predicted = document(folder / "job", "prediction.json")["axes"]["X"]["predicted"]["A"]["p95"]
    return after < before and after < 1.5 * predicted
