"""How many processors there are, and how many the linear algebra may use: one."""

from __future__ import annotations

import os


def use_one_thread() -> None:
    """Tell the linear algebra of numpy and scipy to stay on one thread; to be called before numpy
    is loaded.

    The matrices here are small: threads cost five times what they gain (27 s of processor time
    against 6 s for a job of four axes). Who has set these variables keeps his values.
    """
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
        os.environ.setdefault(name, "1")


def processors() -> int:
    """Return how many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
