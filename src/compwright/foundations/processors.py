"""How many processors there are, how many the linear algebra may use (one), and how often Python
looks for garbage.
"""

from __future__ import annotations

import gc
import os
from typing import Final

#: New objects from which on Python looks for circles of garbage (it says 700): a figure is some ten
#: thousand, and nearly all else that a command makes stays until its end. Saves a twentieth of the
#: processor time of a run, and takes no more memory.
_NEW_OBJECTS: Final = 20_000


def look_for_garbage_seldom() -> None:
    """Let this process look for circles of garbage only after many new objects."""
    gc.set_threshold(_NEW_OBJECTS, *gc.get_threshold()[1:])


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
