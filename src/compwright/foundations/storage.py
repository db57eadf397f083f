"""The only code that touches the file system: read whole, write whole or not at all.

Files are staged beside their target and then put in place by ``os.replace``; a failure on the way removes what was staged
and puts back what was there before. Folders made on the way are removed too.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from compwright.foundations.errors import Fault, InputError, StorageError

_MOST_BYTES = 256 * 1024 * 1024  # no measurement or control file comes near it; a device file would never end


def _reason(error: OSError | ValueError) -> str:
    strerror = getattr(error, "strerror", None)
    return strerror or str(error) or type(error).__name__


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file. Raises InputError when it is missing, cannot be read or is larger than 256 MiB."""
    try:
        with path.open("rb") as stream:
            content = stream.read(_MOST_BYTES + 1)
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have (a null byte)
        raise InputError(Fault(message="cannot be read", file=str(path), found=_reason(error))) from error
    if len(content) > _MOST_BYTES:
        raise InputError(Fault(message="is too large", file=str(path), expected=f"at most {_MOST_BYTES} bytes"))
    return content


def list_files(path: Path) -> list[Path]:
    """Return ``[path]`` for a file or for nothing, and for a folder its files by name, hidden ones left out.

    Raises InputError when the folder cannot be listed.
    """
    try:
        if not path.is_dir():
            return [path]
        return sorted(entry for entry in path.iterdir() if entry.is_file() and not entry.name.startswith("."))
    except (OSError, ValueError) as error:
        raise InputError(Fault(message="folder cannot be read", file=str(path), found=_reason(error))) from error


def is_there(path: Path) -> bool:
    """Whether there is a file, folder or link at ``path``; False for a name that no file can have."""
    return os.path.lexists(path)


def is_folder(path: Path) -> bool:
    """Whether ``path`` is a folder that can be looked at."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def refuse_overwriting(paths: Sequence[Path], *, force: bool) -> None:
    """Raise StorageError, naming every file that exists already, unless ``force``.

    Folders in the place of a file, and what is no file at all (a device, a pipe), are refused with ``force`` too.
    """
    faults = dict.fromkeys(fault for path in paths for fault in _hindrances(path, force=force))
    if faults:
        raise StorageError(*faults)


def _hindrances(path: Path, *, force: bool) -> Iterator[Fault]:
    try:
        exists, is_file, is_folder = os.path.lexists(path), path.is_file(), path.is_dir()
        is_link = path.is_symlink()
        above = next((folder for folder in path.parents if os.path.lexists(folder)), None)
        blocked = above is not None and not above.is_dir()
    except (OSError, ValueError) as error:
        yield Fault(message="cannot be written", file=str(path), found=_reason(error))
        return
    if blocked:
        yield Fault(message="is no folder", file=str(above), expected="a folder to write into")
    elif is_folder:
        yield Fault(message="is a folder", file=str(path), expected="the name of a file")
    elif exists and not (is_file or is_link):
        yield Fault(message="is no ordinary file", file=str(path), expected="the name of a file")
    elif exists and not force:
        yield Fault(message="exists already", file=str(path), expected="a new file, or --force to replace it")


@dataclass(slots=True)
class _Changes:
    """What was done so far, so that it can be undone."""

    staged: list[Path] = field(default_factory=list)
    kept: dict[Path, Path] = field(default_factory=dict)  # target -> copy of what was there before
    placed: list[Path] = field(default_factory=list)
    made: list[Path] = field(default_factory=list)

    def undo(self) -> None:
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


def write_files(
    folder: Path,
    files: Mapping[str, bytes],
    *,
    force: bool = False,
    elsewhere: Mapping[Path, bytes] | None = None,
    whole: Sequence[str] = (),
) -> list[Path]:
    """Write ``files`` (relative name with ``/`` -> bytes) below ``folder``, and those of ``elsewhere``, all of them or none.

    ``whole``: folders below ``folder`` that hold exactly these files afterwards: what else lies in them directly is refused, or
    with ``force`` removed. Returns the paths in the order given. Raises StorageError when one exists (unless ``force``), for
    missing permission, for a full disk and for a name that leads out of ``folder``; then everything is as it was before, files
    replaced included.
    """
    targets = {_below(folder, name): content for name, content in files.items()} | dict(elsewhere or {})
    refuse_overwriting(list(targets), force=force)
    strangers = _strangers([_below(folder, name) for name in whole], targets, force=force)
    changes = _Changes()
    current = folder
    try:
        for current, content in targets.items():
            _make_folder(current.parent, changes.made)
            _stage(current, content, changes)
        for temporary, current in zip(changes.staged, targets, strict=True):
            temporary.replace(current)
            changes.placed.append(current)
        for current in strangers:
            changes.kept[current] = _beside(current)
            current.replace(changes.kept[current])
            changes.placed.append(current)
    except (OSError, ValueError) as error:
        changes.undo()
        raise StorageError(Fault(message="cannot be written", file=str(current), found=_reason(error))) from error
    except BaseException:  # Ctrl-C leaves nothing half-written either
        changes.undo()
        raise
    changes.clear()
    return list(targets)


def _strangers(folders: Sequence[Path], targets: Mapping[Path, bytes], *, force: bool) -> list[Path]:
    """Return the files in ``folders`` that are not among ``targets``. Raises StorageError where there are any, unless ``force``."""
    found = [
        path
        for folder in folders
        if folder.is_dir()
        for path in sorted(folder.iterdir())
        if path not in targets and (path.is_file() or path.is_symlink())
    ]
    if found and not force:
        expected = "a folder that holds nothing else, or --force to remove it"
        raise StorageError(*(Fault(message="is no part of what is written", file=str(path), expected=expected) for path in found))
    return found


def write_file(path: Path, content: bytes, *, force: bool = False) -> Path:
    """Write one file whole. Errors as in `write_files`."""
    if not path.name:
        raise StorageError(Fault(message="is a folder", file=str(path), expected="the name of a file"))
    return write_files(path.parent, {path.name: content}, force=force)[0]


def _below(folder: Path, name: str) -> Path:
    parts = PurePosixPath(name).parts
    if not parts or ".." in parts or PurePosixPath(name).is_absolute() or Path(name).is_absolute():
        raise StorageError(Fault(message="leads out of the folder", file=name, expected=f"a name below {folder}"))
    return folder.joinpath(*parts)


def _make_folder(folder: Path, made: list[Path]) -> None:
    """Make a folder and those above it, noting each one made, also when a later one fails."""
    missing: list[Path] = []
    probe = folder
    while not probe.exists():
        missing.append(probe)
        probe = probe.parent
    for path in reversed(missing):
        path.mkdir()
        made.append(path)


def _beside(target: Path) -> Path:
    """Return an unused short name beside ``target`` (one longer than the target's could be too long for the file system)."""
    return target.with_name(f".{os.urandom(6).hex()}.part")


def _stage(target: Path, content: bytes, changes: _Changes) -> None:
    """Write ``content`` beside ``target``, with the rights of the file that it will replace."""
    temporary = _beside(target)
    changes.staged.append(temporary)
    with temporary.open("xb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
    if target.is_file():
        shutil.copymode(target, temporary)
        kept = _beside(target)
        changes.kept[target] = kept
        shutil.copy2(target, kept)


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


def relative(path: Path, folder: Path) -> str:
    """Return how ``path`` is named from ``folder``, with ``/``; whole where there is no such way (another drive)."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        return path.as_posix()
