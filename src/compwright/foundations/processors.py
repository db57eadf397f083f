"""Settings of this process: number of threads, garbage collection, and free memory."""

from __future__ import annotations

import gc
import os
import sys
from typing import Final

#: New objects from which on Python looks for circles of garbage (it says 700): a figure is some ten
#: thousand, and nearly all else that a command makes stays until its end. Saves a twentieth of the
#: processor time of a run, and takes no more memory.
_NEW_OBJECTS: Final = 20_000
#: Parameters of mallopt (glibc, malloc.h) with what they are set to, bytes: from which size on a
#: block is got from the system for itself alone (the largest size that glibc allows), and how much
#: of what is free at the end of the heap is kept.
_KEEPING: Final = ((-3, 32 * 1024 * 1024), (-1, 64 * 1024 * 1024))


def look_for_garbage_seldom() -> None:
    """Make Python collect garbage less often, only after many new objects."""
    gc.set_threshold(_NEW_OBJECTS, *gc.get_threshold()[1:])


def keep_free_memory() -> None:
    """Make this process keep its free memory for later arrays (only with the C library glibc).

    Otherwise the system sets every page of each new large array to zero, which takes a tenth of the
    processor time of a run.
    """
    if sys.platform != "linux":
        return
    try:
        import ctypes

        tell = ctypes.CDLL(None).mallopt
    except (ImportError, OSError, AttributeError):  # another C library
        return
    for parameter, size in _KEEPING:
        tell(parameter, size)


def use_one_thread() -> None:
    """Restrict the linear algebra of numpy and scipy to one thread. Call it before numpy is loaded.

    The matrices here are small, so several threads need more time than they save. A job with four
    axes needs 27 s of processor time with several threads, and 6 s with one. Environment variables
    that the user has set keep their values.
    """
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, "1")


def processors() -> int:
    """Return the number of processors that this process is allowed to use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
