"""Change settings that all threads of the process share, by one thread at a time."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from threading import RLock
from typing import Final

#: What the threads of a process share: no result depends on which thread holds it.
_TURN: Final = RLock()


@contextmanager
def warnings_ignored(message: str = "") -> Iterator[None]:
    """Ignore the warnings of libraries whose text begins with ``message`` (a regular expression).

    The filters of warnings belong to the process. A second thread waits until the first one has
    restored them, so other settings of a library can be changed inside too.
    """
    with _TURN, warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=message)
        yield
