"""Work on items in several processes, because one Python process uses only one processor.

The processes are started with the method ``spawn``, because every system supports it.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError, ProcessPoolExecutor
from contextlib import contextmanager, suppress
from multiprocessing import get_context, parent_process
from threading import Lock, Thread
from typing import Final, Generic, TypeVar

from compwright.foundations.errors import CompwrightError
from compwright.foundations.parallel_work import Each, in_turn
from compwright.foundations.processors import (
    keep_free_memory,
    look_for_garbage_seldom,
    processors,
)

T = TypeVar("T")
R = TypeVar("R")
#: Items that are handed to a process at once: what they share is sent once.
_AT_ONCE: Final = 4
#: Turns that every process is to have at least: the fewer, the longer some are idle at the end.
_TURNS: Final = 4
#: More processes than this are not started: each takes some 100 MB.
_MOST: Final = 8


@contextmanager
def side_by_side(items: int, ready: Callable[[], None]) -> Iterator[Each]:
    """Provide a function that works on items in this process and in further parallel ones.
    ``items``: the number of items; ``ready``: called first in each further process.

    The function works on one item after the other if there is only one item or one processor, or if
    the system cannot start processes.
    """
    keep_free_memory()
    others = min(processors(), items, _MOST) - 1
    pool = _pool(others) if others > 0 else None
    if pool is None:
        yield in_turn
        return
    try:
        with _ctrl_c_later():
            for _ in range(others):
                pool.submit(ready)
        yield _Several(pool, others)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _pool(others: int) -> ProcessPoolExecutor | None:
    try:
        return ProcessPoolExecutor(others, get_context("spawn"), _begin)
    except (ImportError, NotImplementedError, OSError):  # no semaphores, no room
        return None


@contextmanager
def _ctrl_c_later() -> Iterator[None]:
    """Provide a context that delays Ctrl-C while processes start, as a starting process would print
    a traceback.
    """
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin() -> None:
    """Set up a new parallel process. At Ctrl-C it ends silently, as the main process reports it."""
    Thread(target=_end_with_the_first, daemon=True).start()
    look_for_garbage_seldom()
    keep_free_memory()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    if hasattr(signal, "pthread_sigmask"):
        signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})


def _end_with_the_first() -> None:
    """End this parallel process when the main process no longer exists.

    A main process that was killed cannot report that there is no more work. Without this function
    the parallel process would wait for ever.
    """
    first = parent_process()
    if first is not None:
        first.join()
        signal.raise_signal(signal.SIGTERM)  # ends it on every system, whatever it waits for


class _Several:
    """A function that works on items in this process and, from the first item on, in several
    further processes.

    An item that another process could not complete is worked on once more here. So the errors are
    the same as without further processes.
    """

    def __init__(self, pool: ProcessPoolExecutor, others: int) -> None:
        self._pool, self._others = pool, others

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        shared = _Shared(work, items, self._others)
        threads = [
            Thread(target=shared.work_there, args=(self._pool,))
            for _ in range(min(self._others, len(items) - 1))
        ]
        for thread in threads:
            thread.start()
        try:
            shared.work_here()
            for thread in threads:
                thread.join()
        finally:
            shared.close()
        return [
            one
            for item, done in zip(items, shared.done, strict=True)
            for one in done or [work(item)]
        ]


class _Shared(Generic[T, R]):
    """Items that are distributed among processes: this process takes items from the end, the
    ``others`` take items from the beginning.

    For each other process there is a thread that gives it the next items only after it has
    completed the earlier ones. The queue of an executor is not used for this: it would hold items
    that this process could work on while it is idle.
    """

    def __init__(self, work: Callable[[T], R], items: Sequence[T], others: int) -> None:
        self._work, self._items, self._others = work, items, others
        self.done: list[list[R]] = [[] for _ in items]
        self._first, self._last = 0, len(items)
        self._taking = Lock()

    def work_here(self) -> None:
        """Work in this process on the last items, one by one, until none is left."""
        while (place := self._taken_here()) is not None:
            with suppress(CompwrightError):  # raised again in turn: an earlier item may raise, too
                self.done[place] = [self._work(self._items[place])]

    def work_there(self, pool: ProcessPoolExecutor) -> None:
        """Take items from the front of the queue, batch by batch, and let another process work on
        them, until the queue is empty.
        """
        while places := self._taken_there():
            batch = [self._items[place] for place in places]
            try:
                future = pool.submit(in_turn, self._work, batch)
                if future.exception() is None:
                    for place, one in zip(places, future.result(), strict=True):
                        self.done[place] = [one]
            except (RuntimeError, CancelledError):  # the other processes have ended
                return

    def close(self) -> None:
        """Prevent that work on further items begins. Work on items already taken is completed."""
        with self._taking:
            self._last = self._first

    def _taken_here(self) -> int | None:
        with self._taking:
            if self._first == self._last:
                return None
            self._last -= 1
            return self._last

    def _taken_there(self) -> range:
        """Return the indices of the next items for another process, several if many are left."""
        with self._taking:
            first = self._first
            count = -(-(self._last - first) // (_TURNS * (self._others + 1)))
            self._first += min(count, _AT_ONCE)
            return range(first, self._first)
