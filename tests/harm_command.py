"""Run a command as a user would, and look only at what a user gets: code, text, JSON, files."""

from __future__ import annotations

import contextlib
import io
import json
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from compwright.cli import run

#: Codes of the contract by which a command declines: a question, a contradiction, a limit.
ASKED, REFUSED, IMPOSSIBLE = 2, 3, 4


@dataclass(frozen=True)
class Answer:
    """Exit code and both streams of one command."""

    code: int
    out: str
    err: str

    @property
    def text(self) -> str:
        return self.out + self.err

    @property
    def first(self) -> str:
        """The first lines that an engineer sees, for a failed assertion."""
        return (self.err or self.out)[:300]

    @property
    def declined(self) -> bool:
        """Whether it asked for something or refused, without a fault of its own."""
        return self.code in {ASKED, REFUSED} and "Traceback" not in self.text

    def names(self, *words: str) -> bool:
        """Say whether all words are in the text, whatever its line breaks."""
        flat = re.sub(r"\s+", "", self.text)
        return all(re.sub(r"\s+", "", word) in flat for word in words)

    def json(self) -> Any:
        return json.loads(self.out)


def command(*words: str | Path) -> Answer:
    """Run one command in this process."""
    streams = [io.TextIOWrapper(io.BytesIO(), encoding="utf-8") for _ in range(2)]
    out, err = streams
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = run([str(word) for word in words])
    for stream in streams:
        stream.flush()
        stream.seek(0)
    return Answer(code, out.read(), err.read())


def tables_of(results: Path) -> list[Path]:
    """All files that ``run`` wrote to be loaded."""
    folder = results / "tables"
    return sorted(path for path in folder.rglob("*") if path.is_file()) if folder.is_dir() else []


def card_of(results: Path) -> str:
    return (results / "card" / "card.md").read_text(encoding="utf-8").replace("\\", "")


def document(results: Path, name: str) -> Any:
    return json.loads((results / name).read_text(encoding="utf-8"))
