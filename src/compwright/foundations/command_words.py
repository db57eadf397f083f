"""Command lines in which an option has several values: ``--loaded a b c`` means ``--loaded a
--loaded b --loaded c``. Also options whose values are ``KEY=VALUE``.

The words after such an option are its values, up to the next option. The first value may follow
``=``. A word that does not look like a value (`OptionForm.more`) ends them, and so does ``--``.

File arguments that the command itself needs are not values either. If they are not elsewhere on the
line, they are taken from these words. If as many words as needed have the usual extension of such a
file, it is these words. Otherwise it is the last words after the last file option, or all words
after it but the first if the command takes many files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from compwright.foundations.errors import Fault


@dataclass(frozen=True, slots=True)
class OptionForm:
    """The form of an option: without a value, with one value, or with ``several`` values.

    ``flag``: the option has no value. ``more``: a function that returns whether a word may follow a
    given value as a further value. ``files``: the values are files.
    """

    flag: bool = False
    several: bool = False
    # any word is a value
    more: Callable[[str, str], bool] = lambda value, word: True  # noqa: ARG005
    files: bool = True


@dataclass(frozen=True, slots=True)
class Own:
    """The file arguments of a command itself (not of its options): how many are ``needed``, whether
    there can be ``many``, and their usual extensions.
    """

    needed: int
    many: bool = False
    endings: tuple[str, ...] = ()


def key_values(options: Iterable[str]) -> tuple[dict[str, str], list[Fault]]:
    """Return the values of ``--option KEY=VALUE`` by key, and the faults of the options.

    Two things are faults: an option without this form, and a key that an earlier option has too.
    """
    given: dict[str, str] = {}
    faults = []
    for option in options:
        key, mark, value = (part.strip() for part in option.partition("="))
        if not mark or not key:
            faults.append(
                Fault(
                    message="the value of `--option` must look like KEY=VALUE",
                    place="--option",
                    found=repr(option),
                    hint="give one key and its value, such as `--option detection_unit=0.001`",
                )
            )
        elif key in given:
            faults.append(
                Fault(
                    message=f"`--option` is given twice with the key {key}",
                    place=f"--option {key}",
                    expected="each key once",
                    hint="remove one of the two",
                )
            )
        else:
            given[key] = value
    return given, faults


def spread(words: Sequence[str], options: Mapping[str, OptionForm], own: Own) -> list[str]:
    """Return the command line in a form with one value per option: the file arguments first, and
    each option repeated before each of its values.
    """
    given, files, further = _sorted(words, options)
    if own.needed and not files and further:
        kept = _held_back(given, further, own)
        files = [given[place] for place in kept]
        for place in reversed(kept):
            del given[place - 1 : place + 1]
    dashed = [file for file in files if _is_option(file)]
    plain = [file for file in files if not _is_option(file)]
    return [*plain, *given, "--", *dashed] if dashed else [*plain, *given]


def _held_back(given: Sequence[str], further: Sequence[range], own: Own) -> Sequence[int]:
    """Return the indices of those words in ``given`` (the options with their values) that must be
    the command's own file arguments. ``further``: the index ranges of the second and later values
    of each file option.
    """
    named = [
        place
        for places in further
        for place in places
        if own.endings and given[place].lower().endswith(own.endings)
    ]
    if len(named) == own.needed and not own.many:
        return named
    return further[-1] if own.many else further[-1][-own.needed :]


def _sorted(
    words: Sequence[str], options: Mapping[str, OptionForm]
) -> tuple[list[str], list[str], list[range]]:
    """Return three lists: the options with their values, the file arguments, and the index ranges
    of the second and later values of file options.
    """
    given: list[str] = []
    files: list[str] = []
    further: list[range] = []
    left = list(words)
    while left:
        word = left.pop(0)
        if word == "--":
            files += left
            break
        if not _is_option(word):
            files.append(word)
            continue
        word = _set_off(word, options, left)
        form = options.get(word)
        given.append(word)
        if form is None or form.flag or not left:
            continue
        given.append(left.pop(0))
        place = len(given)
        while form.several and left and not _is_option(left[0]) and form.more(given[-1], left[0]):
            given += [word, left.pop(0)]
        if form.files and len(given) > place:
            further.append(range(place + 1, len(given), 2))
    return given, files, further


def _set_off(word: str, options: Mapping[str, OptionForm], left: list[str]) -> str:
    """Split a word such as ``--state=a``: return the option's name and put the value back into
    ``left``. Any other word is returned unchanged.
    """
    name, mark, value = word.partition("=")
    form = options.get(name)
    if not mark or form is None or form.flag or not form.several:
        return word
    left.insert(0, value)
    return name


def _is_option(word: str) -> bool:
    return word.startswith("-") and word != "-"
