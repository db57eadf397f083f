"""How often one run decodes each control file and compiles each pattern.

``python benchmarks/count_reads.py [TREE] [--all]``: one job of each control with files of a state,
run with the compwright of TREE. Watched from outside with a profile function: every ``decode`` of
bytes that are a control file (read or written), every function that is handed such a file's whole
content, and every ``re.compile``. Prints the largest count and totals by room; ``--all``: each.
"""

from __future__ import annotations

import contextlib
import importlib
import io
import json
import os
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path
from types import FrameType
from typing import Any

HERE = Path(__file__).resolve().parent
#: Seeds are tried in turn until a job with files of a state writes tables.
SEEDS = 40
#: Shorter contents would be mistaken for other texts.
LEAST_BYTES = 20


class Watch:
    """Counts of one run, by room: ``decodes`` of a content, ``calls`` of functions that are handed
    it, ``compiles`` of a pattern.
    """

    def __init__(self, package: Path) -> None:
        self._package = str(package) + os.sep
        self.decodes: Counter[tuple[str, bytes]] = Counter()
        self.calls: Counter[tuple[str, str, str]] = Counter()
        self.compiles: Counter[tuple[str, str]] = Counter()
        self.contents: dict[bytes, str] = {}

    def room(self, frame: FrameType | None) -> str | None:
        while frame is not None and not frame.f_code.co_filename.startswith(self._package):
            frame = frame.f_back
        if frame is None:
            return None
        return Path(frame.f_code.co_filename.removeprefix(self._package)).parts[0]

    def __call__(self, frame: FrameType, event: str, argument: Any) -> None:
        if event == "c_call" and argument.__name__ == "decode":
            content = argument.__self__
            if isinstance(content, bytes) and len(content) >= LEAST_BYTES:
                self.decodes[self.room(frame) or "outside", content] += 1
        elif event == "call" and frame.f_code is re.compile.__code__:
            pattern = frame.f_locals["pattern"]
            self.compiles[self.room(frame) or "outside", str(pattern)] += 1
        elif event == "call" and frame.f_code.co_filename.startswith(self._package):
            self._handed(frame)

    def _handed(self, frame: FrameType) -> None:
        code = frame.f_code
        for name in code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]:
            value = frame.f_locals.get(name)
            content = getattr(value, "content", None) if name != "self" else None
            if isinstance(content, bytes) and len(content) >= LEAST_BYTES:
                self.contents[content] = str(getattr(value, "name", "?"))
                module = code.co_filename.removeprefix(self._package)
                self.calls[module, code.co_qualname, self.contents[content]] += 1


def watched_run(package: Path, deal: str, folder: Path) -> Watch | None:
    """Run the first job of the deal that has files of a state and writes tables."""
    same_jobs = importlib.import_module("same_jobs")
    run = importlib.import_module("compwright.cli").run
    for seed in range(SEEDS):
        job = folder / deal / str(seed)
        same_jobs.write_random_job(deal, seed, job)
        if json.loads((job / "commands.json").read_text())[0][0] != "new":
            continue
        os.chdir(job)
        watch = Watch(package)
        streams = [io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2)]
        with contextlib.redirect_stdout(streams[0]), contextlib.redirect_stderr(streams[1]):
            sys.setprofile(watch)
            try:
                code = run(["run", "job.yaml"])
            finally:
                sys.setprofile(None)
        if code in (0, 1) and (job / "job" / "tables").is_dir():
            print(f"{deal}: job {seed}")
            return watch
    return None


def say(watch: Watch, *, everything: bool) -> None:
    """Print the counts by room."""
    control = {key: n for key, n in watch.decodes.items() if key[1] in watch.contents}
    for room in sorted({room for room, _ in control}):
        counts = Counter({key: n for key, n in control.items() if key[0] == room})
        (worst, most) = counts.most_common(1)[0]
        print(
            f"  {room}: {len(counts)} control texts decoded {counts.total()} times, at most {most}"
            f" ({watch.contents[worst[1]]})"
        )
    rooms = sorted({room for room, _ in watch.compiles})
    for room in rooms:
        patterns = Counter({key: n for key, n in watch.compiles.items() if key[0] == room})
        (pattern, most) = patterns.most_common(1)[0]
        print(
            f"  {room}: {len(patterns)} patterns compiled {patterns.total()} times, at most {most}"
            f" ({pattern[1][:60]!r})"
        )
    for (module, name, file), n in watch.calls.most_common(None if everything else 4):
        print(f"    {module} {name} is handed {file} {n} times")


def main(tree: Path, *, everything: bool) -> None:
    sys.path.insert(0, str(tree / "src"))
    package = tree / "src" / "compwright"
    with tempfile.TemporaryDirectory() as folder:
        for deal in importlib.import_module("same_jobs").DEALS:
            watch = watched_run(package, deal, Path(folder))
            if watch is None:
                print(f"{deal}: none of {SEEDS} jobs has files of a state and writes tables")
            else:
                say(watch, everything=everything)
        os.chdir(HERE)


if __name__ == "__main__":
    trees = [word for word in sys.argv[1:] if word != "--all"]
    main(Path(trees[0] if trees else HERE.parent).resolve(), everything="--all" in sys.argv)
