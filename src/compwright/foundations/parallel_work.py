"""Do the same work on many items, in turn or in parallel on several processors."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from itertools import islice
from typing import Final, Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")
#: Seconds of work, in turn, from which further processes are started.
_WORTH: Final = 1.0
#: Items from which the time of the others is judged.
_FIRST: Final = 4
#: Seconds of work that a crew is handed at once, and the least that an item is taken to need.
_WINDOW: Final = 1.0
_SHORTEST: Final = 1e-3
#: Bytes of the items that are handed on at once.
_WEIGHT: Final = 32 * 1024 * 1024


class Each(Protocol):
    """A function that does the same work on each of several items."""

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return the results of ``work`` in the order of the items. Raises the first error.

        ``work`` must be a function of a module. Its arguments and results must be such that they
        can be copied to another process.
        """


class Crew(Protocol):
    """A function that starts parallel workers for up to ``items`` items."""

    def __call__(self, items: int, ready: Callable[[], None]) -> AbstractContextManager[Each]:
        """Return a context manager that gives an `Each`, a function that works on items. ``ready``:
        called in each new process to load modules.
        """


def in_turn(work: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Return the result of ``work`` for each item, one after the other."""
    return [work(item) for item in items]


@contextmanager
def alone(items: int, ready: Callable[[], None]) -> Iterator[Each]:  # noqa: ARG001
    """Provide `in_turn`, which works on items one after the other in this process, for callers that
    expect a `Crew`.
    """
    yield in_turn


def in_order(
    work: Callable[[T], R],
    items: Iterable[T],
    *,
    crew: Crew,
    ready: Callable[[], None],
    count: int,
    weight: Callable[[T], int],
) -> Iterator[R]:
    """Yield the results of ``work`` in the order of the ``items`` (at most ``count``), each as soon
    as possible. ``weight``: a function that returns the size of an item in bytes.

    An item is taken from ``items`` only when it is needed. Raises the errors of ``work``, as `Each`
    does.

    The first items are worked on in this process, and their time is measured. The ``crew`` is
    started only if the rest would take longer than `_WORTH` seconds here, because the start of a
    process takes almost as long. The crew gets as many items at once as take about `_WINDOW`
    seconds, with at most `_WEIGHT` bytes together. So results come steadily, and few items are in
    memory at once.
    """
    waiting = iter(items)
    begun = False
    while count > 0:
        first = time.perf_counter()
        done = [work(item) for item in islice(waiting, _FIRST if begun else 1)]
        takes = (time.perf_counter() - first) / max(len(done), 1)
        yield from done
        count -= len(done)
        if not done:
            return
        # The first item alone: what all need was loaded with it.
        if begun and count * takes > _WORTH:
            yield from _by_the_crew(work, waiting, crew(count, ready), takes, weight)
            return
        begun = True


def _by_the_crew(
    work: Callable[[T], R],
    waiting: Iterator[T],
    crew: AbstractContextManager[Each],
    takes: float,
    weight: Callable[[T], int],
) -> Iterator[R]:
    with crew as each:
        while some := _taken(waiting, round(_WINDOW / max(takes, _SHORTEST)), weight):
            first = time.perf_counter()
            done = each(work, some)
            takes = (time.perf_counter() - first) / len(some)
            yield from done


def _taken(waiting: Iterator[T], most: int, weight: Callable[[T], int]) -> list[T]:
    """Take the next items from ``waiting``: at least one, at most ``most``, and no more after their
    ``weight`` has reached a limit.
    """
    taken: list[T] = []
    heavy = 0
    for item in waiting:
        taken.append(item)
        heavy += weight(item)
        if len(taken) >= most or heavy >= _WEIGHT:
            break
    return taken
