"""What is done to the disk while files are written, so that it can be undone."""

from __future__ import annotations

import os
import shutil
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(slots=True)
class Changes:
    """What was done so far, so that it can be undone."""

    staged: list[Path] = field(default_factory=list)
    kept: dict[Path, Path] = field(default_factory=dict)  # target -> copy of what was there before
    placed: list[Path] = field(default_factory=list)
    made: list[Path] = field(default_factory=list)

    def undo(self) -> None:
        """Put everything back as it was before."""
        for target in self.placed:
            with suppress(OSError):
                if target in self.kept:
                    self.kept[target].replace(target)
                else:
                    target.unlink()
        self.clear()
        for folder in reversed(self.made):
            with suppress(OSError):
                folder.rmdir()

    def clear(self) -> None:
        """Remove what was put beside the targets."""
        for path in (*self.staged, *self.kept.values()):
            with suppress(OSError):
                path.unlink(missing_ok=True)


def make_folder(folder: Path, made: list[Path]) -> None:
    """Make a folder and those above it, noting each one made, also when a later one fails."""
    missing: list[Path] = []
    probe = folder
    while not probe.exists():
        missing.append(probe)
        probe = probe.parent
    for path in reversed(missing):
        path.mkdir()
        made.append(path)


def beside(target: Path) -> Path:
    """Return an unused short name beside ``target`` (one longer than the target's could be too long
    for the file system).
    """
    return target.with_name(f".{os.urandom(6).hex()}.part")


def stage(target: Path, content: bytes, changes: Changes) -> None:
    """Write ``content`` beside ``target``, with the rights of the file that it will replace."""
    temporary = beside(target)
    changes.staged.append(temporary)
    with temporary.open("xb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
    if target.is_file():
        shutil.copymode(target, temporary)
        kept = beside(target)
        changes.kept[target] = kept
        shutil.copy2(target, kept)
