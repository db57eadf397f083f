"""Valid tests that show little or no scatter, through whole commands: counts by outcome.

    python benchmarks/bench_degenerate.py [N] [--first F] [--seed S] [--seconds S] [--out FILE]

Cases are dealt by number (`degenerate_tests.py`): 2 to 500 targets, 1 to 30 runs, linear, rotary,
step cycle, one direction; every form of file that holds readings; every control. Each is evaluated,
planned for, verified with the test itself or with another one of the same axis, one in three with
the next plan, and put into the history; one in eight with its pages. Every case is a process of its
own with a limit of processor seconds.

Counted by exit code, and as BROKEN (70, another code above 5), HUNG (the limit), WARNED (a Python
warning on the terminal), ABSURD (exit 0 or 1 with a number that is not finite, a negative standard
error, a median far beyond what the readings differ by, or A or E other than the definition gives).
Any of these ends it with 1. `--out` keeps every answer, for the refusals (2, 3, 4) too.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import re
import resource
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from degenerate_tests import Dealt, deal, job_of, write_job, write_test
from loaded_controls import CONTROLS, without_reports

KINDS = ("0", "1", "2", "3", "4", "5", "BROKEN", "HUNG", "WARNED", "ABSURD")
WARNING = re.compile(r"\b\w*Warning\b:|Traceback \(most recent")
ROUNDED = 2e-4  # µm: files hold four decimals
WAIT = 1800.0
#: Takes command, outcome, terminal and processor seconds.
Tell = Callable[[tuple[str, str, str, float]], object]


def said_by(words: list[str], folder: Path) -> tuple[int, str]:
    """Return exit code and terminal of a command in this process, whoever writes there."""
    from compwright.cli import run

    sys.stdout.flush()
    sys.stderr.flush()
    path = folder / "terminal.txt"
    kept = [os.dup(1), os.dup(2)]
    with path.open("wb") as terminal:
        for place in (1, 2):
            os.dup2(terminal.fileno(), place)
        try:
            code = run(words)
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            for place, old in zip((1, 2), kept, strict=True):
                os.dup2(old, place)
                os.close(old)
    return code, path.read_text(encoding="utf-8", errors="replace")


def numbers_in(value: Any, path: str = "") -> Iterator[tuple[str, float]]:
    """Yield every number of a document with its place."""
    if isinstance(value, dict):
        for key, each in value.items():
            yield from numbers_in(each, f"{path}.{key}")
    elif isinstance(value, list):
        for index, each in enumerate(value):
            yield from numbers_in(each, f"{path}[{index}]")
    elif isinstance(value, float | int) and not isinstance(value, bool):
        yield path, float(value)


def absurd_numbers(document: Any) -> str:
    """Return which number of a document cannot be."""
    for path, value in numbers_in(document):
        if not np.isfinite(value):
            return f"{path} is {value}"
        last = path.rsplit(".", 1)[-1]
        if value < 0.0 and re.fullmatch(r"U|std_error|s_positive|s_negative|probability", last):
            return f"{path} is {value}"
    return ""


def absurd_evaluation(document: Any, test: Dealt) -> str:
    """Return what differs from the definitions of ISO 230-2."""
    result = document["results"][0]
    means = [np.nanmean(block, axis=1) for block in test.blocks.values()]
    own = {"E": float(np.max(means) - np.min(means))}
    if test.repeated:
        spread = [2.0 * np.nanstd(block, axis=1, ddof=1) for block in test.blocks.values()]
        ends = [m + s for m, s in zip(means, spread, strict=True)]
        own["A"] = float(np.max(ends) - np.min(np.array(means) - np.array(spread)))
    if len(test.blocks) == 1:
        own = {f"{k}_{'positive' if '+' in test.blocks else 'negative'}": v for k, v in own.items()}
    for name, value in own.items():
        found = result["parameters"].get(name)
        room = ROUNDED * (8.0 if name[0] == "A" else 2.0)
        if found is None or abs(found - value) > room + 1e-9 * abs(value):
            return f"{name} is {found}, the definition gives {value:.6g}"
    return ""


def absurd_prediction(document: Any, test: Dealt) -> str:
    """Return which prediction is far beyond what the readings show."""
    axis = document["axes"]["X"]
    for key in ("predicted", "predicted_new_targets"):
        for name, band in (axis[key] or {}).items():
            if not band:
                continue
            if not band["p05"] <= band["median"] <= band["p95"]:
                return f"{key} {name} is out of order: {band}"
            middle, top = abs(band["median"]), max(abs(band["p95"]), abs(band["p05"]))
            if middle > 6.0 * test.differ + 3.0 or top > 60.0 * test.differ + 3.0:
                return f"{key} {name} is {band}, the readings differ by {test.differ:.4g}"
    return ""


class Case:
    """One case in a folder of its own; ``tell`` is told what each command ended with."""

    def __init__(self, number: int, seed: int, folder: Path, tell: Tell) -> None:
        """Write the test."""
        self.number, self.seed, self.folder, self.tell = number, seed, folder, tell
        self.test = deal(number, seed)
        self.rng = np.random.default_rng([seed, number, 7])
        self.before, profile = write_test(self.test, folder, "x")
        self.profile = profile
        self.known = ["--profile", str(folder / profile)] if profile else []

    def ended(self, command: str, *words: str, answer: Path | None = None) -> int:
        """Run a command; tell what it ended with, and what is absurd in its answer."""
        self.tell((command, "begun", "", 0.0))
        start = time.process_time()
        code, terminal = said_by([command, *words], self.folder)
        seconds = round(time.process_time() - start, 1)
        kind, why = str(code), terminal
        if code > 5:
            kind = "BROKEN"
        elif WARNING.search(terminal):
            kind = "WARNED"
        elif code < 2 and answer is not None and answer.exists():
            document = json.loads(answer.read_text(encoding="utf-8"))
            wrong = absurd_numbers(document)
            if not wrong and command in ABSURD:
                wrong = ABSURD[command](document, self.test)
            kind, why = ("ABSURD", wrong) if wrong else (kind, terminal)
        self.tell((command, kind, why, seconds))
        return code

    def work(self) -> None:
        """Run all commands."""
        folder, plan, after = self.folder, self.folder / "out", self.folder / "after"
        answer = folder / "evaluation.json"
        words = [str(folder / self.before), *self.known, "--json", str(answer)]
        self.ended("evaluate", *words, answer=answer)
        control = str(self.rng.choice(list(CONTROLS)))
        job = job_of(self.test, self.before, self.profile, control, self.rng)
        file = str(write_job(job, folder, "job.yaml"))
        code = self.ended("run", file, "--out", str(plan), answer=plan / "prediction.json")
        if code > 1 or not plan.is_dir():
            return
        again = self.before
        if self.rng.random() < 0.6:
            again, _ = write_test(deal(self.number, self.seed, again=1), folder, "y")
        words = ["--after", f"x={folder / again}", "--plan", str(plan), *self.known]
        if self.rng.random() < 0.33 and (plan / "tables").is_dir():
            words += ["--loaded", str(plan / "tables"), "--update"]
        answer = after / "verification.json"
        self.ended("verify", file, *words, "--out", str(after), answer=answer)
        self.ended("history", str(folder))


def worked(number: int, seed: int, tell: Tell, *, pages: bool) -> None:
    """Work on one case."""
    if not pages:
        without_reports()
    with tempfile.TemporaryDirectory() as name:
        Case(number, seed, Path(name), tell).work()


ABSURD = {"evaluate": absurd_evaluation, "run": absurd_prediction}


def case(number: int, seed: int, seconds: int, *, pages: bool) -> list[tuple[str, str, str, float]]:
    """Return what the commands of one case ended with, from a process of its own."""
    context = multiprocessing.get_context("fork")
    here, there = context.Pipe(duplex=False)

    def work() -> None:
        here.close()
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        try:
            worked(number, seed, there.send, pages=pages)
        except Exception:  # noqa: BLE001 - it is what is looked for
            there.send(("the benchmark", "BROKEN", traceback.format_exc(), 0.0))

    process = context.Process(target=work)
    process.start()
    there.close()
    found: list[tuple[str, str, str, float]] = []
    while here.poll(WAIT):
        try:
            found.append(here.recv())
        except EOFError:
            break
    if process.is_alive():
        process.join(5)
        process.kill()
    process.join()
    ended = [each for each in found if each[1] != "begun"]
    if found and found[-1][1] == "begun":
        ended.append((found[-1][0], "HUNG", "killed by its limit", float(seconds)))
    return ended


def main() -> int:
    """Work, then print."""
    reader = argparse.ArgumentParser(description=__doc__)
    reader.add_argument("count", nargs="?", type=int, default=300)
    reader.add_argument("--first", type=int, default=0)
    reader.add_argument("--seed", type=int, default=1)
    reader.add_argument("--seconds", type=int, default=120, help="limit of a case")
    reader.add_argument("--out", type=Path)
    words = reader.parse_args()
    worked(0, 1, lambda _: None, pages=True)  # imports what every case needs

    counts: dict[str, Counter[str]] = {}
    bad = 0
    for number in range(words.first, words.first + words.count):
        name = deal(number, words.seed).name
        ended = case(number, words.seed, words.seconds, pages=number % 8 == 0)
        for command, kind, why, seconds in ended:
            counts.setdefault(command, Counter())[kind] += 1
            if not kind.isdigit():
                bad += 1
                print(f"{kind}: {command}, {name}: {why[-1500:]}", flush=True)
            if words.out:
                with words.out.open("a", encoding="utf-8") as stream:
                    stream.write(json.dumps([name, command, kind, seconds, why[:3000]]) + "\n")
    print("| command | " + " | ".join(KINDS) + " |\n|---|" + "---|" * len(KINDS))
    for command, some in counts.items():
        print(f"| {command} | " + " | ".join(str(some[kind]) for kind in KINDS) + " |")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
