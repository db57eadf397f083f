"""Work side by side in several processes, because most of the work is Python's own, of which one
process does one thing at a time. They are started fresh (``spawn``), as every system can do it.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Final, TypeVar

from compwright.foundations.errors import CompwrightError
from compwright.foundations.processors import processors
from compwright.foundations.side_by_side import Each, in_turn

T = TypeVar("T")
R = TypeVar("R")
#: Items that are handed to a process at once: what they share is sent once.
_AT_ONCE: Final = 4
#: Fewer batches than this would leave processes idle at the end.
_BATCHES: Final = 8
#: More processes than this are not started: each takes some 100 MB.
_MOST: Final = 8


@contextmanager
def side_by_side(items: int, ready: Callable[[], None]) -> Iterator[Each]:
    """Provide what works on up to ``items`` items in this process and in others beside it, which
    call ``ready`` first; in turn where there is one item or one processor, or where the system
    lets no process be started.
    """
    others = min(processors(), items, _MOST) - 1
    pool = _pool(others) if others > 0 else None
    if pool is None:
        yield in_turn
        return
    try:
        with _ctrl_c_later():
            for _ in range(others):
                pool.submit(ready)
        yield _Several(pool)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _pool(others: int) -> ProcessPoolExecutor | None:
    try:
        return ProcessPoolExecutor(others, get_context("spawn"), _end_when_told)
    except (ImportError, NotImplementedError, OSError):  # no semaphores, no room
        return None


@contextmanager
def _ctrl_c_later() -> Iterator[None]:
    """Hold Ctrl-C back, also in processes that are started meanwhile, which would else answer with
    a traceback from the midst of their imports; where the system can hold signals back.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _end_when_told() -> None:
    """End at Ctrl-C without a word: the first process says it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


class _Several:
    """Works on items from the last on, while other processes work from the first on.

    What another process could not do, for whatever reason, is done here once more, so that errors
    are those of working in turn.
    """

    def __init__(self, pool: ProcessPoolExecutor) -> None:
        self._pool = pool

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        size = min(_AT_ONCE, max(1, len(items) // _BATCHES))
        batches = [items[start : start + size] for start in range(0, len(items), size)]
        try:
            futures = [self._pool.submit(in_turn, work, batch) for batch in batches]
        except RuntimeError:  # the other processes have ended
            return in_turn(work, items)
        own = _done_here(work, batches, futures)
        return [
            one
            for batch, future, done in zip(batches, futures, own, strict=True)
            for one in done or _done_there(future) or in_turn(work, batch)
        ]


def _done_here(
    work: Callable[[T], R], batches: Sequence[Sequence[T]], futures: Sequence[Future[list[R]]]
) -> list[list[R] | None]:
    """Return what was done here, from the last batch on, as long as no other process has begun it;
    None for the others, and where an error was raised.
    """
    done: list[list[R] | None] = [None] * len(batches)
    for index in range(len(batches) - 1, -1, -1):
        if not futures[index].cancel():
            break
        try:
            done[index] = in_turn(work, batches[index])
        except CompwrightError:  # raised again in turn: an earlier item may raise another
            continue
    return done


def _done_there(future: Future[list[R]]) -> list[R] | None:
    """Return what another process did; None where it could not."""
    return None if future.cancelled() or future.exception() is not None else future.result()
