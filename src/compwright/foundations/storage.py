"""The only code that touches the file system: read whole, write whole or not at all.

Files are staged beside their target and then put in place by ``os.replace``; a failure on the way
removes what was staged and puts back what was there before. Folders made on the way are removed
too.

What a command has read is never overwritten or deleted by it, whatever name leads there (a link,
another case of the letters, a way around through ``..``): see `command_inputs`.
"""

from __future__ import annotations

import errno
import os
import shutil
import stat
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from compwright.foundations.command_inputs import Identity, is_input, remember
from compwright.foundations.errors import Fault, InputError, StorageError, raise_all
from compwright.foundations.foreseen import foreseen_bytes

_MOST_BYTES = 256 * 1024 * 1024  # no measurement or control file comes near it
_MOST_NAMED = 4  # files named in a line about several
#: Opening what became a pipe since it was looked at must not wait for the other end (POSIX;
#: elsewhere there is no such flag).
_NO_WAITING = (
    getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
)

#: Whether the file of this relative name and content, which stands in the way, was written by an
#: earlier run of the same command.
Known = Callable[[str, bytes], bool]


def _reason(error: OSError | ValueError) -> str:
    strerror = getattr(error, "strerror", None)
    return strerror or str(error) or type(error).__name__


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file, and remember that it was read; of one that is to be written with
    what is made of it (`foreseen`) the bytes that it will have.

    Raises InputError when it is missing, cannot be read, is no ordinary file (a pipe or device
    could be waited for without end) or is larger than 256 MiB.
    """
    expected = foreseen_bytes(path)
    if expected is not None:
        return expected
    try:
        refused = _not_to_be_read(path.stat())
        if refused is None:
            with open(path, "rb", opener=_opened) as stream:
                seen = os.fstat(stream.fileno())
                refused = _not_to_be_read(seen)
                content = stream.read(_MOST_BYTES + 1) if refused is None else b""
            remember((seen.st_dev, seen.st_ino))
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have (a null byte)
        raise InputError(
            Fault(message="cannot be read", file=str(path), found=_reason(error))
        ) from error
    if refused is not None:
        raise InputError(
            Fault(
                message="cannot be read", file=str(path), expected="an ordinary file", found=refused
            )
        )
    if len(content) > _MOST_BYTES:
        raise InputError(
            Fault(message="is too large", file=str(path), expected=f"at most {_MOST_BYTES} bytes")
        )
    return content


def earlier_bytes(path: Path) -> bytes:
    """Return the bytes of a result of an earlier run, empty where there is none; it counts as a
    result, not as an input.
    """
    try:
        return path.read_bytes() if path.is_file() and path.stat().st_size <= _MOST_BYTES else b""
    except (OSError, ValueError):
        return b""


def _opened(path: str, flags: int) -> int:
    return os.open(path, flags | _NO_WAITING)


def _not_to_be_read(seen: os.stat_result) -> str | None:
    """Return what it is that cannot be read as a file, None for an ordinary file."""
    kinds = (
        (stat.S_ISDIR, os.strerror(errno.EISDIR)),
        (stat.S_ISFIFO, "a pipe"),
        (stat.S_ISSOCK, "a socket"),
        (stat.S_ISCHR, "a device"),
        (stat.S_ISBLK, "a device"),
    )
    return next((name for is_kind, name in kinds if is_kind(seen.st_mode)), None)


def list_files(path: Path) -> list[Path]:
    """Return ``[path]`` for a file or for nothing, and for a folder all in it but folders by name,
    hidden ones left out.

    What is no ordinary file (a pipe, a link to nowhere) is listed too: `read_bytes` says so. Raises
    InputError when the folder cannot be listed.
    """
    try:
        if not path.is_dir():
            return [path]
        return sorted(
            entry for entry in path.iterdir() if not (entry.name.startswith(".") or entry.is_dir())
        )
    except (OSError, ValueError) as error:
        raise InputError(
            Fault(message="folder cannot be read", file=str(path), found=_reason(error))
        ) from error


def in_folders_of(folder: Path, name: str) -> list[Path]:
    """Return the files called ``name`` that lie in the folders of ``folder``, one level down; what
    cannot be listed has none.
    """
    try:
        return sorted(path for path in folder.glob(f"*/{name}") if path.is_file())
    except OSError:
        return []


def folders_holding(top: Path, names: Sequence[str]) -> tuple[list[Path], list[Fault]]:
    """Return ``top`` and the folders below it that hold a file of one of ``names``, in the order of
    their names, and those that cannot be read; hidden folders and links to folders are left out.

    Raises InputError where ``top`` is no folder.
    """
    if not is_folder(top):
        raise InputError(
            Fault(
                message="is no folder",
                file=str(top),
                expected="a folder with results",
                found="a file" if is_there(top) else "nothing",
            )
        )
    found: list[Path] = []
    faults: list[Fault] = []

    def refused(error: OSError) -> None:
        faults.append(
            Fault(
                message="folder cannot be read",
                file=str(error.filename or top),
                found=_reason(error),
            )
        )

    for folder, below, files in os.walk(top, onerror=refused):
        below[:] = sorted(name for name in below if not name.startswith("."))
        if not set(names).isdisjoint(files):
            found.append(Path(folder))
    return sorted(found), faults


def state_of(paths: Sequence[Path]) -> str:
    """Return what the file system says of files: the same text as long as none was changed, added
    or taken away. They count as read: what is said of them comes from here.
    """
    told = []
    for path in paths:
        try:
            seen = path.stat()
            remember((seen.st_dev, seen.st_ino))
            told.append(f"{seen.st_size}:{seen.st_mtime_ns}")
        except (OSError, ValueError):
            told.append("-")
    return " ".join(told)


def resolved(path: Path) -> Path:
    """Return ``path`` from the root, without links; as it is where it cannot be followed."""
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError):
        return path


def is_there(path: Path) -> bool:
    """Whether there is a file, folder or link at ``path``; False for a name that no file can
    have.
    """
    return foreseen_bytes(path) is not None or os.path.lexists(path)


def is_folder(path: Path) -> bool:
    """Whether ``path`` is a folder that can be looked at."""
    try:
        return path.is_dir()
    except (OSError, ValueError):
        return False


def refuse_overwriting(
    targets: Mapping[Path, bytes], *, force: bool, completed: Sequence[Path] = ()
) -> None:
    """Raise StorageError, naming every file that may not be written.

    Those that exist already, unless ``force`` or among those ``completed``. With ``force`` too:
    what this command has read (unless the same bytes go there), folders in the place of a file,
    what is no file at all (a device, a pipe), and a file that would be written twice.
    """
    faults = dict.fromkeys(
        fault for path, content in targets.items() for fault in _hindrances(path, content)
    )
    existing = [
        path for path in targets if not force and path not in completed and _is_existing_file(path)
    ]
    faults |= dict.fromkeys(_twice(targets))
    if existing:
        faults[_exist_already(existing)] = None
    if faults:
        raise StorageError(*faults)


def _hindrances(path: Path, content: bytes) -> Iterator[Fault]:
    try:
        exists, is_file, is_folder = os.path.lexists(path), path.is_file(), path.is_dir()
        is_link = path.is_symlink()
        above = next((folder for folder in path.parents if os.path.lexists(folder)), None)
        blocked = above is not None and not above.is_dir()
        input_lost = is_file and was_read(path) and path.read_bytes() != content
    except (OSError, ValueError) as error:
        yield Fault(message="cannot be written", file=str(path), found=_reason(error))
        return
    if blocked:
        yield Fault(message="is no folder", file=str(above), expected="a folder to write into")
    elif is_folder:
        yield Fault(message="is a folder", file=str(path), expected="the name of a file")
    elif (
        exists and not is_file and not (is_link and not path.exists())
    ):  # a link to nowhere is only a name
        yield Fault(message="is no ordinary file", file=str(path), expected="the name of a file")
    elif input_lost:
        yield Fault(
            message="was read by this command and is not overwritten, not even with --force",
            file=str(path),
            expected="another name",
        )


def _is_existing_file(path: Path) -> bool:
    try:
        return os.path.lexists(path) and (path.is_file() or path.is_symlink()) and not path.is_dir()
    except (OSError, ValueError):
        return False


def _exist_already(paths: Sequence[Path]) -> Fault:
    """Return one line about all files that are there already, the first of them named."""
    if len(paths) == 1:
        return Fault(
            message="exists already",
            file=str(paths[0]),
            expected="a new file, or --force to replace it",
        )
    folder = Path(os.path.commonpath([path.parent for path in paths]))
    names = [relative(path, folder) for path in paths[:_MOST_NAMED]]
    more = len(paths) - len(names)
    return Fault(
        message=f"{len(paths)} files exist already",
        file=str(folder),
        expected="new files, another folder, or --force to replace them",
        found=", ".join(names) + (f" and {more} more" if more else ""),
    )


def _twice(targets: Mapping[Path, bytes]) -> Iterator[Fault]:
    """Yield a fault for each file that two different contents would go to, under whatever names."""
    seen: dict[object, bytes] = {}
    for path, content in targets.items():
        where = _identity(path) or _place(path)
        if seen.setdefault(where, content) != content:
            yield Fault(
                message="is also the name of another file that is written",
                file=str(path),
                expected="another name",
            )


def _place(path: Path) -> str:
    with suppress(OSError, ValueError, RuntimeError):
        return os.path.normcase(path.resolve())
    return str(path)


def _identity(path: Path) -> Identity | None:
    """Return what the file at ``path`` is, None where there is none."""
    try:
        seen = path.stat()
    except (OSError, ValueError):
        return None
    return (seen.st_dev, seen.st_ino)


def was_read(path: Path) -> bool:
    """Whether this command has read the file at ``path``, by this or another name."""
    return is_input(_identity(path))


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
    renewed: Sequence[str] = (),
    completed: Sequence[str] = (),
    outdated: Sequence[str] = (),
    known: Known = lambda _name, _content: True,
) -> list[Path]:
    """Write ``files`` (relative name with ``/`` -> bytes) below ``folder``, and those of
    ``elsewhere``, all of them or none.

    ``known`` tells of a file that stands below ``folder`` in the place of one of ``files`` whether
    an earlier run wrote it; one that it does not know is the user's and is not replaced. ``whole``:
    folders below ``folder`` that hold exactly these files afterwards; ``renewed``: folders in which
    the user may keep files of his own; ``completed``: files that an earlier command began and this
    one replaces without ``force``. What else lies directly in either is removed with ``force``
    where it is known; else it stays, and in a ``whole`` folder nothing is written. So is what is
    ``outdated``: files that hold no longer with what is written now. Returns the
    paths in the order given. Raises StorageError when a file exists (unless ``force``), was read by
    this command or is not known, for missing permission, for a full disk and for a name that leads
    out of ``folder``; then everything is as it was before, files replaced included.
    """
    below = {_below(folder, name): name for name in files}
    targets = _merged({path: files[name] for path, name in below.items()}, dict(elsewhere or {}))
    refuse_overwriting(targets, force=force, completed=[_below(folder, name) for name in completed])
    gone = _strangers(folder, [*whole, *renewed], targets) | {
        path: name for name in outdated if _is_existing_file(path := _below(folder, name))
    }
    lost = {
        path: known(name, earlier_bytes(path))
        for path, name in (below | gone).items()
        if _is_existing_file(path)
    }
    raise_all(
        StorageError,
        [*_users_files(below, lost, targets), *_in_the_way(folder, whole, gone, lost, force=force)],
    )
    removed = [path for path in gone if force and lost[path] and not was_read(path)]
    changes = _Changes()
    current = folder
    try:
        for current, content in targets.items():
            _make_folder(current.parent, changes.made)
            _stage(current, content, changes)
        for temporary, current in zip(changes.staged, targets, strict=True):
            temporary.replace(current)
            changes.placed.append(current)
        for current in removed:
            changes.kept[current] = _beside(current)
            current.replace(changes.kept[current])
            changes.placed.append(current)
    except (OSError, ValueError) as error:
        changes.undo()
        raise StorageError(
            Fault(message="cannot be written", file=str(current), found=_reason(error))
        ) from error
    except BaseException:  # Ctrl-C leaves nothing half-written either
        changes.undo()
        raise
    changes.clear()
    return list(targets)


def _merged(files: dict[Path, bytes], others: dict[Path, bytes]) -> dict[Path, bytes]:
    """Return both; a path in both with different contents is refused, for one of them would be
    lost.
    """
    raise_all(StorageError, list(_twice_named(files, others)))
    return files | others


def _twice_named(files: Mapping[Path, bytes], others: Mapping[Path, bytes]) -> Iterator[Fault]:
    for path, content in others.items():
        if files.get(path, content) != content:
            yield Fault(
                message="is also the name of another file that is written",
                file=str(path),
                expected="another name",
            )


def _strangers(
    folder: Path, names: Sequence[str], targets: Mapping[Path, bytes]
) -> dict[Path, str]:
    """Return the files in the folders ``names`` that are none of ``targets`` by any name, each with
    its own relative name.
    """
    written = {_identity(path) for path in targets} - {None}
    found: dict[Path, str] = {}
    for name in names:
        inner = _below(folder, name)
        for path in sorted(inner.iterdir()) if is_folder(inner) else ():
            is_target = path in targets or _identity(path) in written
            if not is_target and (path.is_file() or path.is_symlink()):
                found[path] = f"{name}/{path.name}"
    return found


def _users_files(
    below: Mapping[Path, str], known: Mapping[Path, bool], targets: Mapping[Path, bytes]
) -> Iterator[Fault]:
    """Yield a fault for each file that would be replaced although no earlier run wrote it so."""
    for path in below:
        if not known.get(path, True) and earlier_bytes(path) != targets[path]:
            yield Fault(
                message=(
                    "was not written by an earlier run, or was changed since, and is not"
                    " overwritten"
                ),
                file=str(path),
                expected="it elsewhere (move it), or another folder for the results",
            )


def _in_the_way(
    folder: Path,
    whole: Sequence[str],
    gone: Mapping[Path, str],
    known: Mapping[Path, bool],
    *,
    force: bool,
) -> Iterator[Fault]:
    """Yield a fault for each file that may not stay in a folder that is handed on as a whole."""
    inside = {_below(folder, name) for name in whole}
    for path in gone:
        removable = known[path] and not was_read(path)
        if path.parent in inside and not (force and removable):
            hint = (
                "a folder that holds nothing else, or --force to remove it"
                if removable
                else "another place for it"
            )
            yield Fault(
                message="is no part of what is written, and all that lies here is handed on",
                file=str(path),
                expected=hint,
            )


def write_file(path: Path, content: bytes, *, force: bool = False) -> Path:
    """Write one file whole. Errors as in `write_files`; with ``force`` any file is replaced that
    this command has not read.
    """
    if not path.name:
        raise StorageError(
            Fault(message="is a folder", file=str(path), expected="the name of a file")
        )
    return write_files(path.parent, {path.name: content}, force=force)[0]


def _below(folder: Path, name: str) -> Path:
    parts = PurePosixPath(name).parts
    if not parts or ".." in parts or PurePosixPath(name).is_absolute() or Path(name).is_absolute():
        raise StorageError(
            Fault(message="leads out of the folder", file=name, expected=f"a name below {folder}")
        )
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
    """Return an unused short name beside ``target`` (one longer than the target's could be too long
    for the file system).
    """
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
    """Yield name and bytes of the controller definitions that ship with compwright, in the order of
    their names.
    """
    return _shipped("controller_formats")


def demo_files() -> dict[str, bytes]:
    """Return machine and job of the demo, which name a control, by the names of their files."""
    return dict(_shipped("controller_formats/demo"))


def _shipped(folder: str) -> Iterator[tuple[str, bytes]]:
    """Yield name and bytes of the YAML files of a folder, which lies beside the code in an
    installed wheel and at the top of a source checkout.
    """
    package = Path(__file__).resolve().parents[1]
    for place in (package / folder, package.parents[1] / folder):
        if place.is_dir():
            for path in sorted(place.glob("*.yaml")):
                yield path.name, read_bytes(path)
            return


def relative(path: Path, folder: Path) -> str:
    """Return how ``path`` is named from ``folder``, with ``/``; whole where there is no such way
    (another drive).
    """
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:
        return path.as_posix()
