"""Work on many things alike: one after the other, or side by side on the processors that there
are.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from typing import Protocol, TypeVar

T = TypeVar("T")
R = TypeVar("R")


class Each(Protocol):
    """Does the same work on every one of some items."""

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return what ``work`` makes of each item, in their order. Raises what ``work`` raises for
        the first item for which it raises anything.

        ``work`` is a function of a module, and what it takes and returns can be copied to another
        process.
        """


class Crew(Protocol):
    """Provides who works on up to ``items`` items; ``ready`` loads what the work needs."""

    def __call__(self, items: int, ready: Callable[[], None]) -> AbstractContextManager[Each]:
        """Return what works on the items as long as it is entered."""


def in_turn(work: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Return what ``work`` makes of each item, one after the other."""
    return [work(item) for item in items]


@contextmanager
def alone(items: int, ready: Callable[[], None]) -> Iterator[Each]:  # noqa: ARG001
    """Provide what works on items in turn, in this process."""
    yield in_turn
