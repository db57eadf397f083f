"""The only code that touches the file system: read whole, write whole or not at all.

Files are staged beside their target and then put in place by ``os.replace``; a failure on the way removes what was staged
and, of files that did not exist before, what was already put in place.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from compwright.foundations.errors import Fault, InputError, StorageError


def _reason(error: OSError) -> str:
    return error.strerror or type(error).__name__


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file. Raises InputError when it is missing or cannot be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(Fault(message="cannot be read", file=str(path), found=_reason(error))) from error


def list_files(path: Path) -> list[Path]:
    """Return ``[path]`` for a file, and for a folder its files in the order of their names, hidden ones left out.

    Raises InputError when there is nothing at ``path`` or the folder cannot be listed.
    """
    if not path.is_dir():
        return [path]
    try:
        return sorted(entry for entry in path.iterdir() if entry.is_file() and not entry.name.startswith("."))
    except OSError as error:
        raise InputError(Fault(message="folder cannot be read", file=str(path), found=_reason(error))) from error


def refuse_overwriting(paths: Sequence[Path], *, force: bool) -> None:
    """Raise StorageError, naming every file that exists already, unless ``force``."""
    if force:
        return
    faults = [
        Fault(message="exists already", file=str(path), expected="a new file, or --force to replace it")
        for path in paths
        if path.exists() and not path.is_dir()
    ]
    if faults:
        raise StorageError(*faults)


def write_files(folder: Path, files: Mapping[str, bytes], *, force: bool = False) -> list[Path]:
    """Write ``files`` (relative name with ``/`` -> bytes) below ``folder``, all of them or none.

    Returns the paths in the order given. Raises StorageError when one exists (unless ``force``), for missing permission and
    for a full disk; then nothing half-written is left.
    """
    targets = {folder / name: content for name, content in files.items()}
    refuse_overwriting(list(targets), force=force)
    staged: list[tuple[Path, Path]] = []
    placed: list[Path] = []
    made: list[Path] = []
    current = folder
    try:
        for current, content in targets.items():
            made.extend(_make_folder(current.parent))
            staged.append((_stage(current, content), current))
        for temporary, current in staged:
            existed = current.exists()
            temporary.replace(current)
            if not existed:
                placed.append(current)
    except OSError as error:
        _undo([temporary for temporary, _ in staged], placed, made)
        raise StorageError(Fault(message="cannot be written", file=str(current), found=_reason(error))) from error
    return list(targets)


def write_file(path: Path, content: bytes, *, force: bool = False) -> Path:
    """Write one file whole. Errors as in `write_files`."""
    return write_files(path.parent, {path.name: content}, force=force)[0]


def _make_folder(folder: Path) -> list[Path]:
    missing: list[Path] = []
    probe = folder
    while not probe.exists():
        missing.append(probe)
        probe = probe.parent
    folder.mkdir(parents=True, exist_ok=True)
    return missing


def _stage(target: Path, content: bytes) -> Path:
    if target.is_dir():
        raise IsADirectoryError(21, "is a folder", str(target))
    handle, name = tempfile.mkstemp(prefix=f".{target.name}.", suffix=".part", dir=target.parent)
    temporary = Path(name)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        temporary.chmod(0o644)
    except OSError:
        with suppress(OSError):
            temporary.unlink()
        raise
    return temporary


def _undo(temporaries: Sequence[Path], placed: Sequence[Path], made: Sequence[Path]) -> None:
    for path in (*temporaries, *placed):
        with suppress(OSError):
            path.unlink(missing_ok=True)
    for folder in sorted(made, key=lambda path: len(path.parts), reverse=True):
        with suppress(OSError):
            folder.rmdir()


def definition_files() -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of the controller definitions that ship with compwright, in the order of their names.

    They lie beside the code in an installed wheel and at the top of a source checkout.
    """
    package = Path(__file__).resolve().parents[1]
    for folder in (package / "controller_formats", package.parents[1] / "controller_formats"):
        if folder.is_dir():
            for path in sorted(folder.glob("*.yaml")):
                yield path.name, read_bytes(path)
            return
