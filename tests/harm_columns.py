"""A bridge of two columns as a job: its files, its test, what is loaded, how far the columns move."""

from __future__ import annotations

from pathlib import Path

from harm_bridges import LEAD, Bridge, Column, Skew
from harm_command import card_of, tables_of
from harm_measuring import Axis, Correction, measure, write_csv

FIRST = Axis(slope=70, lost=9)
SECOND = Axis(slope=78, lost=11, bow=3)
#: µm that two columns may move apart by rounding, steps and another grid of their tables.
APART = 6.0


def prepare(folder: Path, bridge: Bridge, partner: Column, coupling: str, gantry: str = "") -> Path:
    files = bridge.files(LEAD, partner, coupling)
    bridge.loaded(files)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    write_csv(folder / "x.csv", bridge.name, measure(FIRST, bridge.correction(bridge.lead)))
    path = folder / "job.yaml"
    extra = f", gantry: {gantry.replace('IT', bridge.partner)}" if gantry else ""
    path.write_text(
        f"compwright: 1\ncontroller: {{format: {bridge.format}, options: {bridge.options}}}\n"
        f"states: {{as_found: [{', '.join(files)}]}}\n"
        f"axes:\n  {bridge.name}: {{travel: [0, 600], address: {bridge.lead}, before: [x.csv]{extra}}}\n",
        encoding="utf-8",
    )
    return path


def snapshot(bridge: Bridge, address: str) -> Correction:
    """Keep what acts now, whatever is loaded later."""
    now = bridge.correction(address)
    kept = {(x, d): now(x, d) for x in Skew().places for d in (1, -1)}
    return lambda x, d: kept[x, d]


def load(bridge: Bridge, results: Path) -> None:
    files = {path.name: path.read_text(encoding="utf-8") for path in tables_of(results)}
    assert files
    bridge.load(files, card_of(results))


def accuracy(axis: Axis, correction: Correction, seed: int) -> float:
    return measure(axis, correction, seed=seed).A()
