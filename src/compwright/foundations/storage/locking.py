"""A lock so that two running processes never write into the same folder at once.

It is the lock of a file in the temporary folder, with ``flock`` on POSIX and ``msvcrt.locking`` on
Windows. The system releases it when the process ends, for whatever reason. On a file system without
locks, files are written without one.
"""

from __future__ import annotations

import errno
import os
import stat
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from time import monotonic, sleep

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

LOCK = "lock"
#: s: what is waited for a living process; it holds the lock only while it writes.
PATIENCE = 10.0
_PAUSE = 0.02  # s
_FLAGS = (
    os.O_RDWR
    | os.O_CREAT
    | getattr(os, "O_CLOEXEC", 0)
    | getattr(os, "O_NOINHERIT", 0)
    | getattr(os, "O_NOFOLLOW", 0)
)
_NO_LOCKS = {
    getattr(errno, name)
    for name in ("ENOLCK", "ENOTSUP", "EOPNOTSUPP", "ENOSYS", "EINVAL")
    if hasattr(errno, name)
}


@dataclass(slots=True)
class Lock:
    """The lock of a temporary folder, held until `release`."""

    staging: Path
    handle: int

    def release(self) -> None:
        """Release the lock. A second call has no effect."""
        if self.handle >= 0:
            handle, self.handle = self.handle, -1
            os.close(handle)

    def remove(self) -> None:
        """Remove the lock file and the temporary folder, which must contain nothing else, and
        release the lock. Raises OSError.
        """
        file = self.staging / LOCK
        try:
            file.unlink()
        except PermissionError:  # Windows removes no open file
            self.release()
            file.unlink()
        self.staging.rmdir()
        self.release()


def take(staging: Path, *, make: bool = False, patience: float = PATIENCE) -> Lock:
    """Return the lock of the temporary folder ``staging``, as soon as no other process has it.
    ``make``: make the folder if it is missing; ``patience``: the longest time to wait, s.

    Raises TimeoutError if another process has the lock for longer, and OSError for other failures.
    """
    until = monotonic() + patience
    while True:
        lock = _attempt(staging, make=make)
        if lock is not None:
            return lock
        if monotonic() >= until:
            raise TimeoutError(errno.ETIMEDOUT, "another command is writing there")
        sleep(_PAUSE)


def _attempt(staging: Path, *, make: bool) -> Lock | None:
    if make:
        with suppress(FileExistsError):
            staging.mkdir()
    try:
        if not stat.S_ISDIR(staging.lstat().st_mode):  # a link would lead elsewhere
            raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(staging))
        handle = os.open(staging / LOCK, _FLAGS, 0o666)
    except FileNotFoundError:  # removed by the process that held it, just now
        if make:
            return None
        raise
    lock = Lock(staging, handle)
    try:
        if _is_locked(handle) and _is_still(handle, staging / LOCK):
            return lock
    except BaseException:
        lock.release()
        raise
    lock.release()
    return None


def _is_still(handle: int, file: Path) -> bool:
    """Return whether the lock file that this process has opened is still the one in the folder, so
    that no other process removed it.
    """
    try:
        return os.path.samestat(os.fstat(handle), file.lstat())
    except FileNotFoundError:
        return False


if sys.platform == "win32":

    def _is_locked(handle: int) -> bool:
        try:
            msvcrt.locking(handle, msvcrt.LK_NBLCK, 1)
        except OSError as error:
            return error.errno not in (errno.EACCES, errno.EDEADLK)
        return True

else:

    def _is_locked(handle: int) -> bool:
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError as error:
            if error.errno not in _NO_LOCKS:
                raise
        return True
