"""Checks that the order in which scripts are sent is known, if the result depends on it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from compwright.formats.families.wrapped.card_memory import Script, Word
from compwright.foundations.errors import Fault

_NAMES = {"enabled": "I51", "take_up_rate": "I{}85", "backlash": "I{}86"}


def left_to_the_order(script: Script) -> Iterator[Fault]:
    """Yield a fault for each value that depends on the order of scripts given by their folder: that
    order is by name, and scripts are not sent by name.
    """
    for (quantity, motor), words in script.settings.items():
        name = _NAMES[quantity].format(motor)
        yield from _other_ends(script, name, words, [word.text for word in words])
    for (kind, motor), commands in _tables(script).items():
        words, ends = [word for _, word in commands], [done for done, _ in commands]
        yield from _other_ends(script, f"#{motor} {kind}", words, ends)


def _tables(script: Script) -> Mapping[tuple[str, int], list[tuple[str, Word]]]:
    """Return the commands for each table, by kind and motor.

    Any two deletions are equal; a definition is equal only to the same definition.
    """
    found: dict[tuple[str, int], list[tuple[str, Word]]] = {}
    for number, (command, motor, word) in enumerate(script.commands):
        done, _, kind = command.partition(" ")
        if kind in ("COMP", "BLCOMP"):
            done_to_it = done if done == "DELETE" else f"{done} {number}"
            found.setdefault((kind, motor), []).append((done_to_it, word))
    return found


def _other_ends(
    script: Script, name: str, words: Sequence[Word], ends: Sequence[str]
) -> Iterator[Fault]:
    """Yield a fault if the last of several ``words`` of ``name`` is the last only by the name of
    its file; ``ends``: the result of each.
    """
    folder = script.files[words[-1].number].folder
    last_of = {word.number: (word, end) for word, end in zip(words, ends, strict=True)}
    for number, (word, end) in last_of.items():
        if folder and script.files[number].folder == folder and end != ends[-1]:
            yield words[-1].fault(
                f"{name}: {word.file}, line {word.line}, says {_shown(word)}, and what is sent last"
                " counts: a folder has no order",
                expected="the scripts named one by one, in the order in which they are sent",
                found=_shown(words[-1]),
            )


def _shown(word: Word) -> str:
    return " ".join(word.text.split())
