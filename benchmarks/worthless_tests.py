"""Does ``verify`` ever say good of a test that is worth nothing? Virtual axes of many kinds.

    python benchmarks/worthless_tests.py [--count N] [--seed S] [--kind K]... [--control C]...

Jobs as in ``loading_faults.py``, loaded as they should be, and measured as before. One axis at a
time gets a test after loading that somebody spoiled; the others an honest one. A job whose honest
tests are not good by themselves is left out. Counted by what was done: good, not good and told as
expected (``verdict`` ``measurement`` with the ``of``, or a doubt's code), not good with another
answer. ``apart``: how many standard errors the spoiled test lies from the honest one, both without
noise; where that is small, one cannot be told from the other, and no value changes.

Prints and judges nothing.
"""

from __future__ import annotations

import argparse
import json
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from fault_machines import Axis
from injected_faults import Plan, apart
from loaded_controls import CONTROLS, said, without_reports
from loading_faults import Job, a_test, job_of
from machines import Floats, name_seed
from table_quality import csv_of

Record = dict[str, Any]
Spoiled = tuple[Floats, Floats, str]


def _few(x: Floats, now: Floats) -> Spoiled:
    rows = [x.size // 7, (2 * x.size) // 3]
    return x[rows], now[:, rows], "CW-V020"


#: What was done -> (targets, readings after, readings before) to targets, readings, what is told.
SPOILS: dict[str, Callable[[Floats, Floats, Floats], Spoiled]] = {
    "zeros": lambda x, now, _: (x, 0 * now, "zeros"),
    "mm read as µm": lambda x, now, _: (x, now / 1000, "unit"),
    "two of the targets": lambda x, now, _: _few(x, now),
    "targets in inches": lambda x, now, _: (x / 25.4, now, "unit"),
    "sign": lambda x, now, _: (x, -now, "sign"),
    "directions": lambda x, now, _: (x, now[::-1], "direction"),
    "one run copied": lambda x, now, _: (x, np.repeat(now[:, :, :1], now.shape[2], 2), "copied"),
    "from before": lambda x, _, before: (x, before, "copied"),
    "from before, halved": lambda x, _, before: (x, before / 2, "copied"),
    "from before, a tenth": lambda x, _, before: (x, before / 10, "copied"),
}


def cases_of(job: Job, seed: int) -> Iterator[Record]:
    """Spoil the test of each axis in each way; nothing where honest tests are not good."""
    rng = name_seed("worthless tests", seed, job.number)
    honest = {
        name: a_test(job.axes[name].before, rng, plan.at(job.axes[name].before.targets))[1]
        for name, plan in job.plans.items()
    }
    texts = {
        name: csv_of(job.axes[name].before, job.axes[name].before.targets, one, name)
        for name, one in honest.items()
    }
    answer = _verified(job, texts, "honest")
    if answer.get("verdict") != "good":
        return
    for name, plan in job.plans.items():
        axis = job.axes[name]
        for what, spoil in SPOILS.items():
            x, readings, told = spoil(axis.before.targets, honest[name], _before(job, axis))
            if what == "one run copied" and axis.before.runs == 1:
                continue
            text = csv_of(axis.before, x, readings, name)
            answer = _verified(job, {**texts, name: text}, f"{name}-{what.replace(' ', '-')}")
            yield {
                "what": what,
                "where": f"job {job.number} {name} ({axis.kind}, {plan.control.format})",
                "apart": _apart(what, axis, plan),
                **_told(answer, name, told),
            }


def _before(job: Job, axis: Axis) -> Floats:
    """The readings of the first test, from its file."""
    rows = (job.folder / "job" / f"{axis.name}.csv").read_text(encoding="utf-8").splitlines()[3:]
    machine = axis.before
    readings = np.full((2, machine.targets.size, machine.runs), np.nan)
    place = {f"{value:.3f}": index for index, value in enumerate(machine.targets)}
    for row in rows:
        target, sign, run, value = row.split(",")
        readings["+-".index(sign), place[target], int(run) - 1] = float(value)
    return readings


def _apart(what: str, axis: Axis, plan: Plan) -> float:
    """Standard errors between a turned test and the honest one; others cannot be confused."""
    x = axis.before.targets
    left = axis.before.error(x) + plan.at(x)
    rows = [0 if sign > 0 else 1 for sign in axis.before.signs]
    error = axis.spread * float(np.sqrt(2 / axis.before.runs))
    if what == "sign":
        return apart(left, -left, error, rows)
    return apart(left, left[::-1], error, rows) if what == "directions" else float("inf")


def _verified(job: Job, texts: Mapping[str, str], word: str) -> Mapping[str, Any]:
    folder = job.folder / word
    folder.mkdir()
    files = []
    for name, text in texts.items():
        (folder / f"{name}.csv").write_text(text, encoding="utf-8")
        files += ["--after", f"{name}={folder / f'{name}.csv'}"]
    inside = job.folder / "job"
    code, answer, why = said(
        *("verify", str(inside / "job.yaml"), *files, "--plan", str(inside / "out")),
        *("--out", str(folder / "out"), "--json", "-"),
    )
    document: Mapping[str, Any] = json.loads(answer) if code in {0, 1} else {"refused": why}
    return document


def _told(answer: Mapping[str, Any], name: str, expected: str) -> Record:
    if "refused" in answer:
        return {"outcome": "refused", "message": answer["refused"].strip()[:200]}
    loading = answer["axes"][name]["loading"]
    codes = {doubt["code"] for doubt in answer["doubts"]}
    of = loading.get("of") if loading["verdict"] == "measurement" else None
    outcome = "told" if expected in {of, *codes} else "not good"
    outcome = "good" if answer["verdict"] == "good" else outcome
    message = f"{loading['verdict']} {of or ''} {sorted(codes)} {loading['message'][:160]}"
    return {"outcome": outcome, "message": message}


def show(records: Sequence[Record]) -> None:
    """Print the counts, and every test that was not told as expected."""
    print("| what was done | n | told | not good, another answer | refused | good |")
    print("|---|---|---|---|---|---|")
    outcomes = ("told", "not good", "refused", "good")
    for what in SPOILS:
        some = [one["outcome"] for one in records if one["what"] == what]
        cells = [what, str(len(some)), *(str(some.count(outcome)) for outcome in outcomes)]
        print("| " + " | ".join(cells) + " |")
    print()
    for one in records:
        if one["outcome"] in {"good", "not good"}:
            print(f"{one['where']}, {one['what']}, {one['apart']:.1f} apart -> {one['outcome']}:")
            print(f"    {one['message']}")


def main() -> None:
    """Work, then print."""
    reader = argparse.ArgumentParser(description="Tests after loading that are worth nothing.")
    reader.add_argument("--count", type=int, default=8, help="jobs of two or three axes")
    reader.add_argument("--seed", type=int, default=1, help="of the fleet")
    reader.add_argument("--kind", action="append", help="only kinds with this in their names")
    reader.add_argument("--control", action="append", choices=sorted(CONTROLS))
    words = reader.parse_args()
    without_reports()
    records: list[Record] = []
    for number in range(words.count):
        with tempfile.TemporaryDirectory() as folder:
            try:
                job = job_of(number, words.seed, words, Path(folder))
            except (RuntimeError, ValueError):
                continue
            records += cases_of(job, words.seed)
    show(records)


if __name__ == "__main__":
    main()
