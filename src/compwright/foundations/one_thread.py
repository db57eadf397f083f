"""Ensure that only one thread at a time changes settings that all threads of the process share."""

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
    """Provide a context in which library warnings are ignored whose text begins with the regular
    expression ``message``.

    Filters of warnings belong to the whole process. So a second thread waits until the first one
    has restored them. Therefore other global settings of a library can be changed inside this
    context too.
    """
    with _TURN, warnings.catch_warnings():
        warnings.filterwarnings("ignore", message=message)
        yield
