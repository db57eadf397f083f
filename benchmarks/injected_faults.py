"""Loading faults of a table: what the control then adds to the command at given positions.

Once from what ``decode`` says of the files as they were written, once by changing the files and
decoding those. Corrections (2, m) in µm (arcsec), for + and -; `names`: those of the contract.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from loaded_controls import (
    Change,
    Control,
    Files,
    Loaded,
    files_of,
    with_backlash,
    with_file_of,
    with_values,
    write_files,
)
from machines import Floats, Machine
from numpy.random import Generator

FACTORS = (2.0, 0.5, 0.1, 10.0)
#: Where an entry is 1/16 of a count, that is forgotten.
SIXTEENTHS = (2.0, 0.5, 16.0, 1 / 16)
SHIFTS = (1, -1, 2, -2, 3, -3)
NAMES = (
    *("loaded", "not_active", "inverted", "scaled", "shifted", "mirrored", "wrong_axis"),
    *("one_direction", "backlash", "partial", "increment", "on_top", "state", "thermal"),
)
#: Tables in the control before: active in the test before, idle there, believed to be active.
OLD = ("active", "idle", "believed")


@dataclass(frozen=True)
class Fault:
    """One fault and what it makes the control add; ``plain``: as the list of names has it, not a
    variant under the same name. ``value``: factor, nodes, axis, whatever the name asks for.
    """

    name: str
    words: str
    value: float | str
    correction: Floats
    plain: bool = True


@dataclass(frozen=True)
class Plan:
    """What was written for an axis, and what was in the control before (``old``; None: nothing), in
    which of the ways `OLD`.

    ``numbers_of``: the other axes; what their corrections (µm, arcsec) become where their numbers
    are taken for those of this axis.
    """

    name: str
    machine: Machine
    new: Loaded
    old: Loaded | None
    numbers_of: Mapping[str, float]
    how: str

    @property
    def control(self) -> Control:
        """The control that is loaded."""
        return self.new.control

    def at(self, x: Floats) -> Floats:
        """The planned correction."""
        return self.new.at(self.name, self._within(x))

    def stored(self, x: Floats) -> Floats:
        """What the tables in the control before add where they are active."""
        return np.zeros((2, x.size)) if self.old is None else self.old.at(self.name, x)

    def points(self) -> tuple[Floats, Floats]:
        """Nodes of the planned table and its corrections."""
        return self.new.points(self.name)

    @property
    def factors(self) -> Sequence[float]:
        """Wrong factors that somebody may enter."""
        return SIXTEENTHS if self.control.repeats else FACTORS

    def _within(self, x: Floats) -> Floats:
        turn = self.machine.turn
        return np.asarray(self.machine.low + np.mod(x - self.machine.low, turn)) if turn else x


def faults_of(plan: Plan, x: Floats, slopes: Sequence[float]) -> Iterator[Fault]:
    """Yield every fault of the list with its variants, from the decoded tables as they are."""
    if plan.how == "believed":  # the error is believed to be larger by what was not active
        stored = plan.stored(x)
        for fault in _faults_where_stated(plan, x, slopes):
            yield replace(fault, correction=fault.correction - stored)
        yield Fault("state", "", 0.0, plan.at(x))
    else:
        yield from _faults_where_stated(plan, x, slopes)


def _faults_where_stated(plan: Plan, x: Floats, slopes: Sequence[float]) -> Iterator[Fault]:
    """Yield the faults of a job whose statement of the tables before is true."""
    full, old = plan.at(x), plan.stored(x)
    yield Fault("loaded", "", 1.0, full)
    idle = plan.how == "idle"
    yield Fault("not_active", "the old one acts", 0.0, old, plain=not idle)
    if plan.old is not None:
        yield Fault("not_active", "nothing acts", 0.0, 0 * old, plain=idle)
        yield Fault("increment", "", 0.0, full - old)
        yield Fault("on_top", "", 0.0, full + old)
    yield from _sizes(plan, full)
    yield from _places(plan, x)
    for row, word in enumerate("+-"):
        rests = [("nothing", 0 * old)] + [("the old one", old)] * (plan.old is not None)
        for what, rest in rests:
            one = rest.copy()
            one[row] = full[row]
            yield Fault("one_direction", f"{word}, else {what}", word, one, what == "nothing")
    for cut in (0.3, 0.5, 0.7):
        yield from (_partial_rows if plan.control.repeats else _partial)(plan, x, cut)
    middle = (plan.machine.low + plan.machine.high) / 2
    for slope in slopes:
        yield Fault("thermal", f"{slope:+.0f}", slope, full + slope * (x - middle) / 1000)


def _sizes(plan: Plan, full: Floats) -> Iterator[Fault]:
    """Inverted, scaled, another backlash."""
    _, totals = plan.points()
    reversals = totals[1] - totals[0]
    reversal = float(reversals[0] if plan.control.repeats else reversals.mean())
    backlash = np.array([[0.0], [reversal]])
    for name, factor in [("inverted", -1.0), *(("scaled", factor) for factor in plan.factors)]:
        yield Fault(name, f"{factor:g}", factor, factor * full)
        if not plan.control.two_curves and reversal:
            rest = factor * full + (1 - factor) * backlash
            yield Fault(name, f"{factor:g}, not its backlash", factor, rest, plain=False)
    if reversal:
        for word, factor in (("missing", -1.0), ("twice", 1.0), ("wrong sign", -2.0)):
            if plan.control.repeats and word == "wrong sign":
                continue  # Ixx86 is not negative
            yield Fault("backlash", word, word, full + factor * backlash)
    if plan.control.repeats:
        yield from _columns_of(plan, full, backlash)


def _columns_of(plan: Plan, full: Floats, backlash: Floats) -> Iterator[Fault]:
    """The whole reversal missing; and COMP or BLCOMP wrong, each by itself."""
    common = np.stack([full[0], full[0]])
    if np.any(full != common):
        yield Fault("backlash", "not taken up", "missing", common, plain=False)
    lost = full - common - backlash
    if np.any(np.abs(lost) > 1e-6):
        for name, factor in [("inverted", -1.0), *(("scaled", factor) for factor in plan.factors)]:
            alone = full + (factor - 1) * common
            yield Fault(name, f"{factor:g}, COMP alone", factor, alone, plain=False)
        for word, factor in (("missing", -1.0), ("twice", 1.0), ("wrong sign", -2.0)):
            alone = full + factor * lost
            yield Fault("backlash", f"{word}, BLCOMP alone", word, alone, plain=False)


def _places(plan: Plan, x: Floats) -> Iterator[Fault]:
    """Shifted, mirrored, the table of another axis."""
    if plan.control.repeats:
        yield from _other_rows(plan, x)
        return
    nodes, _ = plan.points()
    step = float(np.median(np.diff(nodes)))
    for k in SHIFTS:
        yield Fault("shifted", f"{k:+d}", float(k), plan.at(x - k * step))
    yield Fault("mirrored", "", 0.0, plan.at(nodes[0] + nodes[-1] - x))
    for other in plan.numbers_of:
        factor = plan.numbers_of[other]
        yield Fault("wrong_axis", f"of {other}", other, factor * plan.new.at(other, x))
        theirs = plan.new.points(other)[0]
        their_step = float(np.median(np.diff(theirs)))
        starts = [("number", nodes[0], theirs[0])]
        if plan.control.increments:  # its numbers and that of its reference, in this axis's
            starts.append(("reference number", 0.0, 0.0))
        for what, mine, their in starts:
            by_number = factor * plan.new.at(other, their + (x - mine) / step * their_step)
            yield Fault("wrong_axis", f"of {other}, by {what}", other, by_number, plain=False)


def _other_rows(plan: Plan, x: Floats) -> Iterator[Fault]:
    """Shifted, mirrored, the table of another axis, where rows are counted from the reference: row
    by row, as somebody enters them.
    """
    for k in SHIFTS:
        moved = _with_rows(plan, x, partial(_moved, k=k, control=plan.control))
        yield Fault("shifted", f"{k:+d} rows", float(k), moved)
    yield Fault("mirrored", "rows from last to first", 0.0, _with_rows(plan, x, _turned))
    other_way = _with_rows(plan, x, lambda v: np.append(v[:, -2::-1], v[:, -1:], axis=1))
    yield Fault("mirrored", "counted the other way", 0.0, other_way, plain=False)
    for other in plan.numbers_of:
        # entries of 1/16 count, whatever the axis; its table repeats after its own length
        factor = plan.numbers_of[other]
        yield Fault("wrong_axis", f"of {other}", other, factor * plan.new.at(other, x))
        theirs, _ = plan.new.rows(other)
        rows = _with_rows(plan, x, partial(_fitted, theirs[:, 1:]))
        yield Fault("wrong_axis", f"of {other}, by number", other, rows, plain=False)


def _partial_rows(plan: Plan, x: Floats, cut: float) -> Iterator[Fault]:
    """The rows up to one or from one on; the others hold zeros, or those of the old table."""
    rests = ["nothing"]
    if plan.old is not None:
        old, length = plan.old.rows(plan.name)
        same = plan.new.rows(plan.name)
        rests += ["the old rows"] * (old.shape == same[0].shape and length == same[1])
    for rest in rests:
        for word in ("up to", "from"):

            def part(v: Floats, rest: str = rest, word: str = word) -> Floats:
                there = (np.arange(v.shape[1]) < cut * v.shape[1]) == (word == "up to")
                return np.where(there, v, 0.0 if rest == "nothing" else old[: v.shape[0], 1:])

            plain = cut == 0.5 and rest == "nothing"
            curve = _with_rows(plan, x, part)
            yield Fault("partial", f"{word} {cut:.0%}, else {rest}", cut, curve, plain)


def _with_rows(plan: Plan, x: Floats, change: Change) -> Floats:
    """What the control adds with other rows in the written file."""
    files = with_values(plan.control, files_of(plan.new.folder), plan.name, change)
    with tempfile.TemporaryDirectory() as folder:
        written = write_files(Path(folder) / "changed", files)
        return Loaded(plan.control, written, plan.new.rotary).at(plan.name, x)


def _turned(values: Floats) -> Floats:
    return values[:, ::-1]


def _fitted(rows: Floats, places: Floats) -> Floats:
    """The first of the rows, with zeros behind them, as many as there are places."""
    fitted = np.zeros(places.shape)
    count = min(places.shape[1], rows.shape[1])
    fitted[:, :count] = rows[: places.shape[0], :count]
    return fitted


def _partial(plan: Plan, x: Floats, cut: float) -> Iterator[Fault]:
    """The table up to a node or from it on; the rest holds zeros (a backlash value acts there too),
    the old table, or (steps) the last total; or the table ends with its backlash.
    """
    nodes, totals = plan.points()
    place, plain = nodes[int(cut * nodes.size)], cut == 0.5
    nothing = np.zeros_like(totals)
    if not plan.control.two_curves:
        nothing[1] = (totals[1] - totals[0]).mean()
    rests = [("zeros", nothing)]
    if plan.old is not None:
        rests.append(("the old one", plan.old.at(plan.name, nodes)))
    for word, there in (("up to", nodes <= place), ("from", nodes >= place)):
        words = f"{word} {place:g}"
        if plan.control.increments:
            clipped = np.minimum(x, place) if word == "up to" else np.maximum(x, place)
            held = plan.at(clipped)
            yield Fault("partial", f"{words}, then no steps", place, held, plain)
            if plan.old is not None:
                steps = plan.stored(x) - plan.stored(clipped)
                yield Fault(
                    "partial", f"{words}, then the old steps", place, held + steps, plain=False
                )
        else:
            for what, rest in rests:
                kept = np.where(there, totals, rest)
                turn = plan.machine.turn
                curve = np.stack([np.interp(x, nodes, one, period=turn) for one in kept])
                first = plain and what == rests[0][0]
                yield Fault("partial", f"{words}, else {what}", place, curve, first)
        beside = x <= place if word == "up to" else x >= place
        yield Fault("partial", f"{words}, a jump", place, beside * plan.at(x), plain=False)


# ---- the written files, changed


def entered(plan: Plan, name: str, x: Floats, rng: Generator, folder: Path) -> Fault | None:
    """Return a fault of this name made by changing the files; None where no change makes it."""
    files = files_of(plan.new.folder)
    try:
        changed, words, value = _changed(plan, name, files, rng)
    except ValueError:
        return None
    try:
        loaded = Loaded(plan.control, write_files(folder, changed), plan.new.rotary)
        correction = loaded.at(plan.name, x)
    except ValueError:  # the control refuses the values, or a reader the files
        return None
    return Fault(name, f"files: {words}", value, correction, plain=False)


def _changed(plan: Plan, name: str, files: Files, rng: Generator) -> tuple[Files, str, float | str]:
    control, axis = plan.control, plan.name

    def values(change: Change) -> Files:
        return with_values(control, files, axis, change)

    if name == "inverted":
        return values(lambda v: -v), "every value negated", -1.0
    if name == "scaled":
        factor = float(rng.choice((2.0, 10.0) if control.increments else plan.factors))
        return values(lambda v: factor * v), f"every value times {factor:g}", factor
    if name == "shifted":
        k = int(rng.choice(SHIFTS))
        return values(lambda v: _moved(v, k, control)), f"{k:+d} rows", float(k)
    if name == "mirrored":
        return values(_turned), "rows from last to first", 0.0
    if name == "wrong_axis" and plan.numbers_of:
        other = str(rng.choice(list(plan.numbers_of)))
        return with_file_of(control, files, axis, other), f"file of {other}", other
    if name == "one_direction" and control.two_curves and not control.repeats:
        row = int(rng.integers(2))
        keep = np.array([[1.0], [0.0]] if row == 0 else [[0.0], [1.0]])
        return values(lambda v: keep * v), f"only column {'+-'[row]}", "+-"[row]
    if name == "backlash":
        ways = [("missing", 0.0), ("twice", 2.0), ("wrong sign", -1.0)]
        word, factor = ways[rng.integers(2 if control.repeats else 3)]
        return with_backlash(control, files, axis, factor), word, word
    if name == "partial":
        share = float(rng.uniform(0.25, 0.75))
        return values(lambda v: _cut(v, share)), f"the first {100 * share:.0f} %", share
    raise ValueError(name)


def _moved(values: Floats, k: int, control: Control) -> Floats:
    """Values k rows later; the end value, or steps of zero, come in."""
    places = np.arange(values.shape[1]) - k
    moved = values[:, np.clip(places, 0, values.shape[1] - 1)]
    if control.increments:
        moved = np.where((places >= 0) & (places < values.shape[1]), moved, 0.0)
    return np.asarray(moved)


def _cut(values: Floats, share: float) -> Floats:
    return np.where(np.arange(values.shape[1]) < share * values.shape[1], values, 0.0)


# ---- how far apart


def apart(one: Floats, other: Floats, error: float, rows: Sequence[int]) -> float:
    """Return the contract's standard errors between two noise-free after-tests: the norm, over
    targets and directions ``rows``, of their difference less its mean; ``error``: s·√(2/n).
    """
    difference = (one - other)[list(rows)]
    return float(np.linalg.norm(difference - difference.mean()) / error)
