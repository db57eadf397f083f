"""Write a proposed mapping profile as text, with remarks."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any, Final

from compwright.foundations.errors import CompwrightError
from compwright.instruments.fault_list import FaultList
from compwright.instruments.header_words import sign_word
from compwright.instruments.profile import MARK, SIGNS, VERSION
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.profile_tables import read_by_profile
from compwright.instruments.proposing import Proposal
from compwright.instruments.worked_rows import worked_readings

_PLAIN_WORD: Final = re.compile(r"[A-Za-z][A-Za-z _-]*")
#: The number of a run in the text about a traverse that is open.
_ANSWER: Final = re.compile(r'"\+([0-9]+)"')
_LISTED: Final = 4
#: Words that are no text in YAML.
_YAML_WORDS: Final = frozenset({"true", "false", "null"})
#: What stands behind a key, for whoever fills it in.
_MEANINGS: Final[dict[str, str]] = {
    "layout": "long: one row per reading; wide: one column per traverse",
    "encoding": "as the file was written; empty: found out",
    "decimal": "point or comma",
    "header_line": "line of the file with the names of the columns; 0: none",
    "axis": "may stay empty where a job or --axis says it",
    "axis_column": "column that names the axis of each row; empty: none",
    "target": "column with the positions that were commanded",
    "value": "column with the deviation or the measured position",
    "value_is": "deviation or measured",
    "sign": "measured minus target, or target minus measured",
    "direction_from": "column, order (rows in the order of time), + or - (all alike)",
    "directions": 'each word: "+" approached from below, "-" from above',
    "run": "column that counts the runs; empty: counted by how often a target comes",
    "run_counts": "runs (both directions have the same) or traverses (each way counts)",
    "traverses": 'each column: approach direction and run, such as "+1", "-1", "+2"',
}


def profile_text(proposal: Proposal, file: str) -> str:
    """Return the profile as YAML with comments. Unknown keys are empty and marked FILL IN.

    ``file``: the name of the table for which the profile was made.
    """
    lines = [f"# Mapping profile, proposed by compwright for {_one_line(file)}."]
    lines += ["# Keys marked FILL IN decide about the result and could not be known from the file."]
    lines.append(f"{MARK}: {VERSION}")
    for key, value in proposal.keys.items():
        if isinstance(value, Mapping):
            lines.append(f"{key}:{_behind(key)}")
            lines += [
                f"  {_quoted(name)}:{_value(one)}{_open(proposal, f'{key}: {name}')}"
                for name, one in value.items()
            ]
        elif value is None and key in proposal.why:
            lines.append(f"{key}:{_open(proposal, key)}")
        else:
            lines.append(f"{key}:{_value(value)}{_behind(key)}")
    lines += [
        "cycle: standard  # standard (whole traverses) or step",
        "# machine = sense * file + offset; -1 where the instrument counts against the machine",
        "position_map: {sense: 1, offset: 0.0}",
        "leave_out: []  # columns that hold no readings, without a warning",
        "",
    ]
    return "\n".join(lines)


def worked_rows(proposal: Proposal, text: Sequence[str], file: str) -> list[str]:
    """Return three readings of the table as sentences, as the proposed profile reads them, so that
    the user can check the profile.

    If only the sign or the directions are unknown, the sentences are made with an assumed answer,
    which they name. If more is unknown, they give the readings as they are in the file.
    """
    filled, words = _with_answers(proposal)
    if filled is None:
        return _as_written(proposal)
    try:
        profile = read_profile(profile_text(filled, file).encode(), "profile")
        parsed = read_by_profile(text, profile, FaultList(file))
    except CompwrightError:
        return _as_written(proposal)
    rows = worked_readings(parsed.readings, parsed.kind)
    if not words:
        return rows
    return [
        f"if {' and '.join(words)}:",
        *rows,
        "each answer that is the other one turns too far into short, and short into too far",
    ]


def _with_answers(proposal: Proposal) -> tuple[Proposal | None, list[str]]:
    """Return the proposal with the sign and the directions assumed where they are unknown, and the
    assumptions as text; None if other keys are unknown.
    """
    keys, words = dict(proposal.keys), []
    for key in sorted(proposal.why, key=lambda one: one != "sign"):
        section, _, name = key.partition(": ")
        way = sign_word(name)
        if key == "sign":
            keys["sign"] = SIGNS[0]
            words.append(f"the sign is '{SIGNS[0]}'")
        elif section in {"directions", "traverses"} and way in {"out", "back"}:
            sign = "+" if way == "out" else "-"
            number = _ANSWER.search(proposal.why[key]) if section == "traverses" else None
            keys[section] = {**keys[section], name: f"{sign}{number[1] if number else ''}"}
            words.append(f"'{name}' is {sign}")
        else:
            return None, []
    more = f" (and {len(words) - _LISTED} more)" if len(words) > _LISTED else ""
    shown = [*words[:_LISTED]]
    shown[-1:] = [f"{shown[-1]}{more}"] if shown else []
    return Proposal(proposal.table, keys), shown


def _as_written(proposal: Proposal) -> list[str]:
    """Return one text for each of the first three rows, with the cells as written in the file, for
    a proposal with too many unknown keys to read the rows.
    """
    keys, lines = proposal.keys, []
    names = [keys.get(key) for key in ("target", "value", "direction", "run")]
    names += list(keys.get("traverses") or ())[:2]
    table = proposal.table
    for row, line in enumerate(table.lines[:3]):
        cells = [f"{name} = {table.of(name)[row]}" for name in names if name in table.columns]
        lines.append(f"line {line} says: {', '.join(cells or [of[row] for of in table.cells])}")
    return lines


def _filled(proposal: Proposal) -> list[tuple[str, Proposal]]:
    """Return the complete proposals that are possible, each with the assumption on which it depends
    ("" for none): the given one if it is complete, two if only the sign is unknown, else none.
    """
    if not proposal.why:
        return [("", proposal)]
    if set(proposal.why) != {"sign"}:
        return []
    return [
        (
            f"the sign is '{sign}'",
            Proposal(proposal.table, {**proposal.keys, "sign": sign}, {}, []),
        )
        for sign in ("measured minus target", "target minus measured")
    ]


def _one_line(text: str) -> str:
    return "".join(mark if mark.isprintable() else "?" for mark in text)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def _value(value: Any) -> str:
    if value is None or value == "":
        return ""
    text = str(value)
    return f" {text}" if isinstance(value, int) or _is_plain(text) else f" {_quoted(text)}"


def _is_plain(text: str) -> bool:
    return bool(_PLAIN_WORD.fullmatch(text)) and text == text.strip() and text not in _YAML_WORDS


def _behind(key: str) -> str:
    meaning = _MEANINGS.get(key)
    return f"  # {meaning}" if meaning else ""


def _open(proposal: Proposal, key: str) -> str:
    why = proposal.why.get(key)
    return f"  # FILL IN: {why}" if why else ""
