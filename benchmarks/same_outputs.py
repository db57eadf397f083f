"""Compare what two source trees of compwright say and write, byte for byte.

``python benchmarks/same_outputs.py OLD_TREE [NEW_TREE] [--jobs 200] [--control ID ...] [--first 0]
[--keep DIR]``; NEW_TREE defaults to the tree of this script. For every control so many random jobs,
jobs on variations of real backups where these are beside OLD_TREE, the examples, and the commands
that need no job. Of each: exit code, standard output, standard error and every file written.

Prints the exit codes of ``run`` by control, each difference with its first differing line, and the
seconds of each tree. Exit 1 where anything differs. What may differ stands in `ALLOWED`.
"""

from __future__ import annotations

import argparse
import itertools
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
#: One job in so many has its figures painted: they are two thirds of the time of a run.
PAINT_EVERY = 40
#: Of one control, no more differences than these are printed.
MOST_SHOWN = 12


@dataclass(frozen=True)
class Allowed:
    """A difference that is meant. ``files``: pattern of the name inside a job's folder (``said/*``
    is what the commands said). ``json_key``: dropped wherever it stands in these JSON documents.
    ``text``: a regular expression, by lines; what it finds is replaced by ``by`` in both trees.
    """

    files: str
    reason: str
    json_key: str = ""
    text: str = ""
    by: str = ""


#: What may differ, each with its reason. The comparison drops exactly this.
ALLOWED: tuple[Allowed, ...] = ()


def main() -> int:
    words = argparse.ArgumentParser(description=(__doc__ or "").split("\n", maxsplit=1)[0])
    words.add_argument("old", type=Path)
    words.add_argument("new", type=Path, nargs="?", default=HERE.parent)
    words.add_argument("--jobs", type=int, default=200, help="random jobs per control")
    words.add_argument("--first", type=int, default=0, help="seed of the first job")
    words.add_argument("--control", nargs="+", default=[], help="only these deals")
    words.add_argument("--keep", type=Path, help="folder for both trees' files, kept")
    given = words.parse_args()
    trees = {"old": given.old.resolve(), "new": given.new.resolve()}
    for tree in trees.values():
        if not (tree / "src" / "compwright").is_dir():
            words.error(f"{tree} holds no src/compwright")
    with tempfile.TemporaryDirectory() as temporary:
        base = (given.keep or Path(temporary)).resolve()
        folders = deal(base / "old", trees["old"], given.jobs, given.first, given.control)
        shutil.copytree(base / "old", base / "new")
        seconds = run_both(base, trees)
        differing = report(base, folders)
    for name, spent in seconds.items():
        parts = ", ".join(f"{key} {value:.1f}" for key, value in spent["commands"].items())
        print(f"{name} {trees[name]}: {spent['processor']:.1f} s of processor ({parts})")
    return int(differing > 0)


def deal(root: Path, old: Path, jobs: int, first: int, chosen: list[str]) -> list[str]:
    """Write all jobs below ``root``; return their folders, by their names inside it."""
    sys.path.insert(0, str(old / "tests"))
    sys.path.insert(0, str(old / "src"))
    import same_fixed
    import same_jobs
    import same_real

    if root.exists():
        raise SystemExit(f"{root} exists already")
    start = time.perf_counter()
    names = []
    for control in same_jobs.DEALS:
        for seed in range(first, first + jobs) if not chosen or control in chosen else ():
            names.append(f"{control}/{seed:05d}")
            same_jobs.write_random_job(control, seed, root / names[-1])
    names += same_real.write_real_jobs(root, jobs, first, chosen)
    names += same_fixed.write_fixed(root, old) if not chosen or "fixed" in chosen else []
    (root / "todo.json").write_text(json.dumps(names))
    print(f"{len(names)} jobs written in {time.perf_counter() - start:.0f} s", flush=True)
    return names


def run_both(base: Path, trees: dict[str, Path]) -> dict[str, Any]:
    """Run all jobs in both trees at the same time; return the seconds of each."""
    workers = {}
    for name, tree in trees.items():
        surroundings = {
            **os.environ,
            "PYTHONPATH": f"{tree / 'src'}{os.pathsep}{HERE}",
            "PYTHONHASHSEED": "0",
            "OPENBLAS_NUM_THREADS": "1",
            "COLUMNS": "100",
            "NO_COLOR": "1",
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        command = [sys.executable, str(HERE / "same_worker.py"), str(base / name)]
        workers[name] = subprocess.Popen([*command, str(PAINT_EVERY)], env=surroundings)
    for name, worker in workers.items():
        if worker.wait() != 0:
            raise SystemExit(f"the worker of the {name} tree ended with {worker.returncode}")
    return {name: json.loads((base / name / "seconds.json").read_text()) for name in trees}


def report(base: Path, folders: list[str]) -> int:
    """Print by control what came of the jobs and what differs; return how many jobs differ."""
    total = 0
    for control, group in itertools.groupby(folders, lambda name: name.split("/")[0]):
        names = list(group)
        codes = Counter(code for name in names for code in run_codes(base / "new" / name))
        written = sum(any((base / "new" / name / "job").glob("tables/*/*")) for name in names)
        found = [(name, list(differences(base, name))) for name in names]
        found = [(name, lines) for name, lines in found if lines]
        shown = ", ".join(f"{code}: {count}" for code, count in sorted(codes.items()))
        print(
            f"{control}: {len(names)} jobs, tables written by {written}; exit codes of run"
            f" {{{shown}}}; {len(found)} jobs differ"
        )
        for name, lines in found[:MOST_SHOWN]:
            print(
                f"  {name}: {len(lines)} differences\n" + "\n".join(f"    {x}" for x in lines[:3])
            )
        total += len(found)
    print(f"{len(folders)} jobs, {total} differ")
    return total


def run_codes(folder: Path) -> list[str]:
    """The exit codes of the ``run`` commands of a job."""
    texts = [path.read_text(encoding="utf-8") for path in folder.glob("said/*_run.txt")]
    return [text.splitlines()[1].removeprefix("exit ") for text in texts]


def differences(base: Path, name: str) -> Iterator[str]:
    """Every file of a job that is not the same in both trees, in words: what was said first, files
    that are missing last.
    """
    files = {
        tree: {
            str(path.relative_to(base / tree / name)): path
            for path in sorted((base / tree / name).rglob("*"))
            if path.is_file()
        }
        for tree in ("old", "new")
    }
    both = files["old"].keys() & files["new"].keys()
    for file in sorted(both, key=lambda file: (not file.startswith("said/"), file)):
        old, new = files["old"][file].read_bytes(), files["new"][file].read_bytes()
        if old == new:
            continue
        old, new = (
            settled(file, content.replace(str(base / tree).encode(), b"ROOT"))
            for tree, content in (("old", old), ("new", new))
        )
        if old != new:
            yield f"{file}: {first_difference(old, new)}"
    for file in sorted(files["old"].keys() ^ files["new"].keys()):
        yield f"{file}: not in the {'new' if file in files['old'] else 'old'} tree"


def settled(file: str, content: bytes) -> bytes:
    """The content without what may differ."""
    for entry in ALLOWED:
        if not fnmatch(file, entry.files):
            continue
        if entry.json_key and file.endswith(".json"):
            document = without_key(json.loads(content), entry.json_key)
            content = json.dumps(document, indent=1, ensure_ascii=False).encode()
        if entry.text:
            content = re.sub(entry.text.encode(), entry.by.encode(), content, flags=re.MULTILINE)
    return content


def without_key(value: Any, key: str) -> Any:
    """The JSON value without a key, at every depth; the order of all else stays."""
    if isinstance(value, dict):
        return {name: without_key(part, key) for name, part in value.items() if name != key}
    return [without_key(part, key) for part in value] if isinstance(value, list) else value


def first_difference(old: bytes, new: bytes) -> str:
    """The first line that differs, both ways, around the first differing character."""
    lines = itertools.zip_longest(old.splitlines(), new.splitlines(), fillvalue=b"(no line)")
    for number, (one, two) in enumerate(lines, 1):
        if one != two:
            same = itertools.takewhile(lambda pair: pair[0] == pair[1], zip(one, two, strict=False))
            common = sum(1 for _ in same)
            start = max(0, common - 60)
            parts = [line[start : common + 100].decode("utf-8", "replace") for line in (one, two)]
            return f"line {number}\n      old {parts[0]!r}\n      new {parts[1]!r}"
    return "line ends differ"


if __name__ == "__main__":
    sys.exit(main())
