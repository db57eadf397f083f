"""Options that take several values at once: ``--loaded a b c`` is ``--loaded a --loaded b --loaded
c``.

The words behind such an option are its values up to the next option. Three things hold words back
from it: what does not look like a value of it (`Form.more`), ``--``, and the files that the command
itself still lacks. Where these stand nowhere else, they are the last words behind the last such
option: one word for one file, all but the first where the command takes many.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Form:
    """How an option is written. ``several``: it takes several values; ``more``: whether a word may
    follow a value of it.
    """

    flag: bool = False
    several: bool = False
    # any word is a value
    more: Callable[[str, str], bool] = lambda value, word: True  # noqa: ARG005


def spread(
    words: Sequence[str], options: Mapping[str, Form], *, needed: int, many: bool
) -> list[str]:
    """Return ``words`` with the files of the command first and each value behind an option of its
    own.

    ``needed``: how many files the command asks for at least; ``many``: it takes any number.
    """
    given, files, further = _sorted(words, options)
    if needed and not files and further:
        kept = further if many else further[-needed:]
        files = [given[place] for place in kept]
        del given[kept[0] - 1 : kept[-1] + 1]
    dashed = [file for file in files if _is_option(file)]
    plain = [file for file in files if not _is_option(file)]
    return [*plain, *given, "--", *dashed] if dashed else [*plain, *given]


def _sorted(
    words: Sequence[str], options: Mapping[str, Form]
) -> tuple[list[str], list[str], range]:
    """Return options with their values, the files, and the places of the further values behind the
    last option that has some.
    """
    given: list[str] = []
    files: list[str] = []
    further = range(0)
    left = list(words)
    while left:
        word = left.pop(0)
        if word == "--":
            files += left
            break
        form = options.get(word)
        if not _is_option(word):
            files.append(word)
            continue
        given.append(word)
        if form is None or form.flag or not left:
            continue
        given.append(left.pop(0))
        place = len(given)
        while form.several and left and not _is_option(left[0]) and form.more(given[-1], left[0]):
            given += [word, left.pop(0)]
        if len(given) > place:
            further = range(place + 1, len(given), 2)
    return given, files, further


def _is_option(word: str) -> bool:
    return word.startswith("-") and word != "-"
