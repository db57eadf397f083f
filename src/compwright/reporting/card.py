"""The commissioning card: what to type, what to look at and how to go back, as Markdown and as a
page: one A4 sheet for the control and at most one for each axis.

A card holds ``title``, ``machine`` (name -> text), ``format`` (``id``, ``title``), ``axes``,
``steps`` (``title``, ``text``, ``evidence``; ``heads`` and ``rows``: what differs by axis, where it
does), ``changes`` (``entries`` of ``entry``, ``old``, ``new``; ``untouched``: lines that stay; None
where the control's own files were not given), ``unconfirmed`` and ``restore`` (sentences),
``restore_steps`` (as ``steps``),
``assumed`` (``fact``, ``value``, ``evidence``), ``files`` (names) and ``proven`` (a sentence). Each
axis holds ``name``, ``address``, ``unit`` (um or arcsec), ``rows`` (``quantity``, ``old``, ``new``,
``typed`` and ``typed_old``: the values as the control's parameter), ``numbering`` (see `numbering`;
None where points have no numbers), ``quick_check`` (``position``, ``direction``, ``adds``: the
compensation that the control itself shows, ``expected``, ``stop``), ``points_needed``, ``rapid``
(its test was taken at rapid traverse, for which everything here holds) and ``fixed_positions``
(``name``, ``position``, ``moves``).
Values to be typed carry a plain minus sign, so that they can be copied.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

from compwright.foundations.utf8 import visible
from compwright.reporting.numbering import numbering_svg, numbering_text
from compwright.reporting.numbers import (
    MISSING,
    decimals_of,
    number,
    plain,
    position_unit,
    symbol,
    unit_text,
)
from compwright.reporting.page import render_page
from compwright.reporting.sections import (
    Document,
    acknowledged,
    assumed,
    doubts,
    evidence_mark,
    pairs,
    rule_lines,
)
from compwright.words.sentences import Sentence

#: What a card of a test at rapid traverse holds for: a control may have another backlash there.
RAPID = (
    "Measured at rapid traverse: the backlash here, what the control adds and the check positions"
    " hold at rapid traverse. Check there, not at cutting feed."
)
_BOX = "[ ]"
#: Evidence of what a card leaves to the report; what is not confirmed stands above its steps.
_DEFAULT = "default of the definition"
_SENTENCE = re.compile(r"(?<=\.)\s+(?=[A-Z‹])|\n")
_OF_AXIS = re.compile(r"[Aa]xis (\w+)\b")
#: What the one table of check positions is for.
HOW_TO_CHECK = (
    "Every check of this card is made here: what the control adds, on its compensation display"
    " where it has one, and after loading the quick check with the instrument."
)
#: More changes than these are read in changes.csv, not on the card.
_MOST_CHANGES = 60


def card_html(card: Document) -> bytes:
    """Return the card as a self-contained page. Raises UsageError when the report extra is
    missing.
    """
    return render_page("card.html", _content(card))


def card_markdown(card: Document) -> str:
    """Return the card as Markdown with boxes to tick; it reads well as plain text too. Needs no
    extra.
    """
    content = _content(card)
    lines = [f"# {_escape(content['title'])}", "", *_machine(content), ""]
    doubts = content["doubts"]
    if doubts:
        lines += _bullets(f"## {doubts['heading']}", [item["message"] for item in doubts["items"]])
        lines += [_escape(str(doubts["step"])), ""] if doubts["step"] else []
    lines += _bullets("## Acknowledged doubts", content["acknowledged"])
    lines += _bullets("## Not confirmed: look before the axis moves fast", content["unconfirmed"])
    lines += _steps(content["steps"])
    lines += _bullets("## Way back", content["restore"])
    lines += _bullets("## Limits, as predicted", content["limits"])
    for axis in content["axes"]:
        lines += _axis(axis)
    lines += _changes(content["changes"])
    if content["assumed"]:
        rows = [
            [
                _escape(fact["fact"]),
                _escape(fact["value"]),
                ("**unconfirmed** " if fact["open"] else "") + _escape(fact["evidence"]),
            ]
            for fact in content["assumed"]
        ]
        lines += ["## Assumed facts", "", *_table(["Fact", "Assumed value", "Evidence"], rows), ""]
    if content["files"]:
        lines += [
            "## Files",
            "",
            *(f"- `{_one_line(file).replace('`', '')}`" for file in content["files"]),
            "",
        ]
    if content["proven"]:
        lines += ["## Proven", "", _escape(content["proven"]), ""]
    lines += [
        "Loaded by: ______________________   Date: ______________   Measured after loading: [ ]",
        "",
    ]
    return "\n".join(lines)


# --- one content for both forms
# ------------------------------------------------------------------------------------------------


def _content(card: Document) -> dict[str, Any]:
    title = plain(card.get("title") or "Commissioning card")
    return {
        "page_title": title,
        "page_class": "card",
        "title": title,
        "machine": pairs(card.get("machine")),
        "format": {
            "id": plain((card.get("format") or {}).get("id", "")),
            "title": plain((card.get("format") or {}).get("title", "")),
        },
        "doubts": doubts(card.get("doubts")),
        "acknowledged": acknowledged(card.get("acknowledged")),
        "limits": _limits(card.get("limits") or {}, card.get("circle_limits") or {}),
        "unconfirmed": _alike_once([plain(text) for text in card.get("unconfirmed") or []]),
        "steps": [_step(step) for step in card.get("steps") or []],
        "axes": [_axis_content(axis) for axis in card.get("axes") or []],
        "changes": changes_content(card.get("changes")),
        "restore": [
            *(plain(text) for text in card.get("restore") or []),
            *(line["text"] for step in card.get("restore_steps") or [] for line in _lines(step)),
        ],
        "assumed": [
            fact
            for fact in assumed(card.get("assumed"))
            if not fact["open"] and fact["evidence"] != _DEFAULT
        ],
        "files": [plain(file) for file in card.get("files") or []],
        "proven": plain(card.get("proven") or ""),
    }


def _limits(axes: Document, circles: Document) -> list[str]:
    """Return a sentence for each limit of the prediction's axes and circles, then the rule where it
    is the guarded one.
    """
    decisions: list[str] = []
    rules: list[str] = []
    limited = [(f"Axis {name}", axis, axis.get("unit", "um")) for name, axis in axes.items()]
    limited += [(f"Circle {name}", circle, "um") for name, circle in circles.items()]
    for name, its, its_unit in limited:
        unit, accept = unit_text(its_unit), its.get("accept") or {}
        decided = [
            f"{symbol(key)} {plain(entry['limit'])} {unit}: {entry['decision']}"
            for key, entry in accept.items()
        ]
        decisions += [f"{name}: {'; '.join(decided)}."] if decided else []
        rules += map(str, rule_lines(accept, unit))
    return [*decisions, *dict.fromkeys(rules)]


def changes_content(changes: Document | None) -> dict[str, Any] | None:
    """Return the table of what changes in the control's files: the first rows, how many more there
    are, how many lines stay.
    """
    if changes is None:
        return None
    rows = [
        [
            plain(row["entry"]),
            *(MISSING if row[key] is None else plain(row[key]) for key in ("old", "new")),
        ]
        for row in changes["entries"]
    ]
    return {
        "rows": rows[:_MOST_CHANGES],
        "more": max(0, len(rows) - _MOST_CHANGES),
        "count": len(rows),
        "untouched": changes["untouched"],
    }


def _step(step: Document) -> dict[str, Any]:
    return {
        "title": plain(step.get("title") or ""),
        "lines": _lines(step),
        **evidence_mark(step.get("evidence")),
    }


def _lines(step: Document) -> list[dict[str, Any]]:
    """Return the lines of a step with every number filled in, as ``text`` and whether they have a
    box of their own (``tick``): a sentence about what differs by axis stands once for each row, the
    others once.
    """
    text = plain(step.get("text") or "")
    heads, rows = step.get("heads") or (), step.get("rows") or ()
    if not rows:
        lines = _alike_once([line for line in text.splitlines() if line.strip()])
        return [{"text": line, "tick": len(lines) > 1} for line in lines]
    ticked = []
    for named, group in groupby(_SENTENCE.split(text), key=lambda sentence: "‹" in sentence):
        words = " ".join(group)
        each = [_filled(words, heads, row) for row in rows] if named else [words]
        ticked += [{"text": line, "tick": named} for line in each]
    return ticked


def _filled(words: str, heads: Sequence[object], row: Sequence[object]) -> str:
    """Return a sentence with what a row says of each ‹head›, the axis before it."""
    for head, cell in zip(heads, row, strict=True):
        words = words.replace(f"‹{plain(head)}›", plain(cell))
    return words if words.startswith("Axis ") else f"{plain(row[0])}: {words}"


def _alike_once(lines: Sequence[str]) -> list[str]:
    """Return the lines, those that say the same of several axes once, with all their names."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for line in lines:
        found = _OF_AXIS.match(line)
        name = found[1] if found else ""
        form = re.sub(rf"\b{re.escape(name)}\b", "‹›", line) if name else line
        groups.setdefault(form, []).append((name, line))
    shown = []
    for group in groups.values():
        others = [name for name, _ in group[1:] if name]
        more = f". The same holds for axis {', '.join(others)}." if others else ""
        shown.append(f"{group[0][1].rstrip('.') if more else group[0][1]}{more}")
    return shown


def _axis_content(axis: Document) -> dict[str, Any]:
    unit = axis.get("unit", "um")
    checks = axis.get("quick_check") or []
    fixed = axis.get("fixed_positions") or []
    places = decimals_of(row.get("position") for row in (*checks, *fixed))
    shown = decimals_of((row.get("adds") for row in checks), 3)
    return {
        "name": plain(axis.get("name")),
        "address": plain(axis.get("address")),
        "unit": unit_text(unit),
        "where": position_unit(unit),
        "points": axis.get("points_needed"),
        "rapid": RAPID if axis.get("rapid") else "",
        "rows": [
            [
                plain(row.get("quantity")),
                _with_parameter(row.get("old"), row.get("typed_old")),
                _typed(row.get("new")),
                plain(row.get("typed") or ""),
            ]
            for row in axis.get("rows") or []
        ],
        "checks": [
            [
                number(row.get("position"), places),
                _direction(row.get("direction")),
                number(row.get("adds"), shown),
                _amount(row.get("expected")),
                _amount(row.get("stop")),
            ]
            for row in checks
        ],
        "numbering": _numbering(axis.get("numbering")),
        "how_to_check": HOW_TO_CHECK,
        "zeroed": bool(checks) and number(checks[0].get("expected")) == number(0.0),
        "fixed": [
            [plain(row.get("name")), number(row.get("position"), places), _signed(row.get("moves"))]
            for row in fixed
        ],
    }


def _numbering(numbering: Document | None) -> dict[str, Any] | None:
    if numbering is None:
        return None
    return {
        "text": numbering_text(numbering),
        "picture": numbering_svg(numbering),
        "words": [plain(words) for words in numbering["words"]],
    }


def _with_parameter(value: object, typed: object) -> str:
    """Return a value, behind the control's parameter that holds it where one does."""
    return f"{plain(typed)} ({_typed(value)})" if typed else _typed(value)


def _typed(value: object) -> str:
    return plain(value).replace("−", "-") if isinstance(value, int | float) else plain(value)


def _direction(value: object) -> str:
    return {"-": "−"}.get(str(value), plain(value))


def _amount(value: object) -> str:
    return number(value) if isinstance(value, int | float) else plain(value)


def _signed(value: object) -> str:
    text = _amount(value)
    return (
        f"+{text}"
        if isinstance(value, int | float) and value > 0 and text not in {MISSING, "0.00"}
        else text
    )


# --- Markdown
# --------------------------------------------------------------------------------------------------


def _machine(content: Document) -> list[str]:
    control = " ".join(
        filter(
            None,
            [
                content["format"]["title"],
                f"({content['format']['id']})" if content["format"]["id"] else "",
            ],
        )
    )
    return [
        f"- {_escape(name)}: {_escape(value)}"
        for name, value in [*content["machine"], ("control", control)]
    ]


def _steps(steps: Iterable[Document]) -> list[str]:
    lines = []
    for step in steps:
        mark = " **(unconfirmed)**" if step["open"] else ""
        lines.append(f"- {_BOX} **{_escape(step['title'])}**{mark}")
        for line in step["lines"]:
            words = line["text"]
            lines.append(
                f"  - {_BOX} {_escape(words)}" if line["tick"] else f"  {_paragraph(words)}"
            )
        if step["evidence"]:
            lines.append(f"  Evidence: {_escape(step['evidence'])}")
    return ["## Steps", "", *lines, ""] if lines else []


def _axis(axis: Document) -> list[str]:
    unit, where = axis["unit"], axis["where"]
    lines = [f"## Axis {_escape(axis['name'])}, control address {_escape(axis['address'])}", ""]
    if axis["rapid"]:
        lines += [f"**{axis['rapid']}**", ""]
    if axis["points"] is not None:
        lines += [
            (
                f"- {_BOX} The control must hold at least {plain(axis['points'])} points for this"
                " axis."
            ),
            "",
        ]
    if axis["rows"]:
        rows = [
            [_BOX, *map(_escape, row[:2]), _escape(f"{row[3]} ({row[2]})" if row[3] else row[2])]
            for row in axis["rows"]
        ]
        lines += ["### Values that change", "", *_table(["", "Quantity", "Old", "New"], rows), ""]
    if axis["numbering"] is not None:
        drawing = axis["numbering"]
        lines += ["### Numbers of the sections", "", "```", *drawing["text"], "```", ""]
        lines += [*(f"- {_escape(words)}" for words in drawing["words"]), ""]
    if axis["checks"]:
        head = [f"Position ({where})", "Approach", f"Control adds ({unit})", "read"]
        head += [f"Expected deviation ({unit})", f"Stop if off by ({unit})", "measured"]
        rows = [
            [*row[:3], "", *row[3:], ""]
            for row in ([_escape(cell) for cell in check] for check in axis["checks"])
        ]
        zero = (
            ["In this order, the instrument set to zero at the first row.", ""]
            if axis["zeroed"]
            else []
        )
        lines += ["### Check positions", "", HOW_TO_CHECK, "", *zero, *_table(head, rows), ""]
    if axis["fixed"]:
        rows = [list(map(_escape, row)) for row in axis["fixed"]]
        lines += [
            "### Fixed positions that move",
            "",
            *_table(["Name", f"Position ({where})", f"Moves by ({unit})"], rows),
            "",
        ]
    return lines


def _changes(changes: dict[str, Any] | None) -> list[str]:
    if changes is None:
        return []
    more = [f"{changes['more']} more changes are in changes.csv.", ""] if changes["more"] else []
    rows = [list(map(_escape, row)) for row in changes["rows"]]
    sentence = (
        f"{changes['count']} entries change; {changes['untouched']} lines of the control's files"
        " stay as they are. The values are those of the files, in the control's own units."
    )
    table = [*_table(["Entry", "Old", "New"], rows), ""] if rows else []
    return ["## Old to new", "", sentence, "", *table, *more]


def _bullets(heading: str, items: Sequence[str | Sentence]) -> list[str]:
    return [heading, "", *(f"- {_BOX} {_escape(item)}" for item in items), ""] if items else []


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Cells padded to one width: the source reads as a table too."""
    widths = [max(3, *(len(row[column]) for row in [head, *rows])) for column in range(len(head))]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |"
        for row in [head, *rows]
    ]
    return [lines[0], "|" + "|".join("-" * (width + 2) for width in widths) + "|", *lines[1:]]


def _one_line(text: str | Sentence) -> str:
    return " ".join(visible(f"{text}").split())


def _paragraph(text: str | Sentence) -> str:
    """A line of text that begins no heading, list, quotation or rule."""
    line = _escape(text)
    return f"\\{line}" if line[:1] in set("#-+>=~_") else line


def _escape(text: str | Sentence) -> str:
    """One line in which nothing is markup; underscores inside names stay as they are."""
    line = _one_line(text)
    for letter in "\\`*[]|":
        line = line.replace(letter, f"\\{letter}")
    return line.replace("&", "&amp;").replace("<", "&lt;")
