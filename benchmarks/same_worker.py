"""Runs the jobs of a folder with the compwright that is on the path, in one process.

``python same_worker.py ROOT PAINT_EVERY`` with PYTHONPATH=TREE/src: every folder of ROOT/todo.json
in turn. What each command says goes into ``said/`` of the job, with its exit code; the seconds of
each command into ROOT/seconds.json. Figures are empty frames except in one job of PAINT_EVERY.
"""

from __future__ import annotations

import contextlib
import importlib
import io
import json
import os
import pkgutil
import shutil
import sys
import time
import traceback
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

_FRAME = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"></svg>'
_FIGURES = ("polar_figure",)  # those of axes take no time


def _frame(*_: object, **__: object) -> bytes:
    return _FRAME


class Figures:
    """The functions that paint the figures of pages, wherever they are bound."""

    def __init__(self) -> None:
        reporting = importlib.import_module("compwright.reporting")
        self._bound = [
            (module, name, getattr(module, name))
            for info in pkgutil.walk_packages(reporting.__path__, "compwright.reporting.")
            for module in [importlib.import_module(info.name)]
            for name in _FIGURES
            if hasattr(module, name)
        ]
        missing = set(_FIGURES) - {name for _, name, _ in self._bound}
        if missing:
            raise SystemExit(f"no such figures in compwright.reporting: {sorted(missing)}")

    def paint(self, *, really: bool) -> None:
        for module, name, original in self._bound:
            setattr(module, name, original if really else _frame)


def main(root: Path, paint_every: int) -> None:
    run: Callable[[list[str]], int] = importlib.import_module("compwright.cli").run
    figures = Figures()
    # The disk is waited for otherwise, file by file.
    os.fsync = lambda _: None  # type: ignore[assignment]
    seconds: dict[str, float] = defaultdict(float)
    start = time.perf_counter()
    todo = json.loads((root / "todo.json").read_text())
    for turn, name in enumerate(todo):
        folder = root / name
        os.chdir(folder)
        figures.paint(really=paint_every > 0 and turn % paint_every == paint_every - 1)
        commands = json.loads((folder / "commands.json").read_text())
        for number, words in enumerate(commands):
            seconds[words[0]] += _said(run, number, words)
            if words[:2] == ["run", "job.yaml"]:
                try:
                    _after(folder)
                    _damaged(folder)
                except Exception as error:  # noqa: BLE001 - one odd result must not end the worker
                    (folder / "said" / "after.txt").write_text(repr(error))
        (root / "done.txt").write_text(f"{turn + 1} of {len(todo)}")
    os.chdir(root)
    total = {"wall": time.perf_counter() - start, "processor": time.process_time()}
    (root / "seconds.json").write_text(json.dumps({**total, "commands": seconds}))


def _said(run: Callable[[list[str]], int], number: int, words: list[str]) -> float:
    """Run one command and write down what it said; return its processor seconds."""
    out, err = _stream(), _stream()
    start = time.process_time()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            code: Any = run(words)
        except BaseException:  # noqa: BLE001 - what flies out of the command line is compared too
            code = f"raised\n{traceback.format_exc().splitlines()[-1]}"
    spent = time.process_time() - start
    folder = Path("said")
    folder.mkdir(exist_ok=True)
    text = f"$ {' '.join(words)}\nexit {code}\n"
    for title, stream in (("output", out), ("error", err)):
        stream.flush()
        text += f"--- standard {title}\n{stream.buffer.getvalue().decode()}"
    (folder / f"{number:02d}_{words[0]}.txt").write_text(text, encoding="utf-8", newline="")
    return spent


def _stream() -> Any:
    """A stream like that of a terminal: text in front of bytes, UTF-8."""
    return io.TextIOWrapper(io.BytesIO(), encoding="utf-8", newline="", write_through=True)


def _after(folder: Path) -> None:
    """Write the test after loading: the true error and what prediction.json says that the table
    does.
    """
    prediction = folder / "job" / "prediction.json"
    if not prediction.is_file():
        return
    axes = json.loads(prediction.read_text(encoding="utf-8"))["axes"]
    (folder / "after").mkdir(exist_ok=True)
    for name, truth in json.loads((folder / "truth.json").read_text()).items():
        table = axes.get(name, {}).get("table")
        unit, factor, column = ("mm", 1000.0, "um")
        if truth["unit"] == "deg":
            unit, factor, column = ("deg", 3600.0, "arcsec")
        lines = [f"# axis: {name}", f"target_{unit},direction,run,deviation_{column}"]
        for sign, mark, key in (("1", "+", "positive"), ("-1", "-", "negative")):
            adds = np.zeros(len(truth["targets"]))
            if table is not None and table["positions"]:
                adds = np.interp(truth["targets"], table["positions"], table[f"correction_{key}"])
            lines += [
                f"{target:.4f},{mark},{run},{value * factor + add:.6f}"
                for target, values, add in zip(
                    truth["targets"], truth["readings"][sign], adds, strict=True
                )
                for run, value in enumerate(values, 1)
            ]
        (folder / "after" / f"{name}.csv").write_text("\n".join([*lines, ""]))


def _damaged(folder: Path) -> None:
    """Copy what was written as if one digit had been typed in wrongly."""
    for tables in sorted((folder / "job" / "tables").glob("*")):
        shutil.copytree(tables, folder / "damaged", dirs_exist_ok=True)
    for path in _some_files(folder / "damaged"):
        content = path.read_bytes()
        place = len(content) * 2 // 3
        digits = [n for n in range(place, len(content)) if content[n : n + 1] in b"123456"]
        if digits:
            n = digits[0]
            path.write_bytes(content[:n] + b"7" + content[n + 1 :])


def _some_files(folder: Path) -> Iterator[Path]:
    return (path for n, path in enumerate(sorted(folder.glob("*"))) if n % 2 == 0)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
