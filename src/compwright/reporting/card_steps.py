"""The steps of a commissioning card as lines of text. A sentence that applies to several axes is
printed only once.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

from compwright.reporting.numbers import plain
from compwright.reporting.sections import Document, evidence_mark
from compwright.words.sentences import Language, in_language, say

_SENTENCE = re.compile(r"(?<=\.)\s+(?=[A-ZÀ-ÞА-Я‹])|\n")
#: The word before the name of an axis at the beginning of a sentence.
_AXIS: Mapping[Language, str] = {"en": "Axis", "de": "Achse", "fr": "Axe", "ru": "Ось"}
#: How sure a step is, in words.
_EVIDENCE = {"confirmed": say("card.confirmed"), "inferred": say("card.inferred")}


def step_content(step: Document, language: Language) -> dict[str, Any]:
    """Return a step's title, lines and evidence as the card's page needs them."""
    mark = evidence_mark(step.get("evidence"))
    return {
        "title": plain(step.get("title") or ""),
        "lines": step_lines(step, language),
        "open": mark["open"],
        "evidence": _EVIDENCE.get(mark["evidence"], mark["evidence"]),
        "shown": mark["evidence"] not in ("", "confirmed"),
    }


def step_lines(step: Document, language: Language) -> list[dict[str, Any]]:
    """Return the lines of a step. Placeholders for values of an axis are replaced by the values, in
    one line for each axis.

    Each line has its ``text``, and ``tick`` states whether it has a box to tick. A sentence with
    values of an axis becomes one line for each row of the step; any other sentence becomes one
    line.
    """
    text = in_language(plain(step.get("text") or ""), language)
    heads, rows = step.get("heads") or (), step.get("rows") or ()
    if not rows:
        lines = alike_once([line for line in text.splitlines() if line.strip()], language)
        return _common_once(lines)
    ticked = []
    for named, group in groupby(_SENTENCE.split(text), key=lambda sentence: "‹" in sentence):
        words = " ".join(group)
        each = [_filled(words, heads, row, language) for row in rows] if named else [words]
        ticked += [{"text": line, "tick": named} for line in each]
    return ticked


def _common_once(lines: Sequence[str]) -> list[dict[str, Any]]:
    """Return the lines of a step, one line with a tick box for each axis. Sentences that are the
    same for all axes are printed once, without a tick box.
    """
    if len(lines) < 2:
        return [{"text": line, "tick": False} for line in lines]
    each = [_SENTENCE.split(line) for line in lines]
    common = [one for one in each[0] if all(one in sentences for sentences in each)]
    above = [one for one, own in zip(common, each[0], strict=False) if one == own]
    own = [" ".join(one for one in sentences if one not in common) for sentences in each]
    if not all(own):
        return [{"text": line, "tick": True} for line in lines]
    shown = [(" ".join(above), False), *((line, True) for line in own)]
    shown.append((" ".join(common[len(above) :]), False))
    return [{"text": text, "tick": tick} for text, tick in shown if text]


def _filled(words: str, heads: Sequence[object], row: Sequence[object], language: Language) -> str:
    """Return a sentence with each ‹column heading› replaced by the value of one axis."""
    for head, cell in zip(heads, row, strict=True):
        words = words.replace(f"‹{plain(head)}›", in_language(cell, language))
    if words.startswith(f"{_AXIS[language]} "):
        return words
    return say("label.coded", code=plain(row[0]), text=words).text(language)


def alike_once(lines: Sequence[str], language: Language) -> list[str]:
    """Return the lines of text. Lines that differ only in the name of the axis become one line that
    names all these axes.
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    of_axis = re.compile(rf"(?i:{_AXIS[language]}) (\w+)\b")
    for line in lines:
        found = of_axis.match(line)
        name = found[1] if found else ""
        form = re.sub(rf"\b{re.escape(name)}\b", "‹›", line) if name else line
        groups.setdefault(form, []).append((name, line))
    shown = []
    for group in groups.values():
        others = [name for name, _ in group[1:] if name]
        same = say("card.same_holds", axes=others).text(language)
        shown.append(f"{group[0][1].rstrip('.')}. {same}" if others else group[0][1])
    return shown
