"""The commissioning card as Markdown and as an HTML page: what to type at the control, what to
check, and how to restore the old values.

A card is a document with these keys:

- ``title``, ``machine`` (name -> text), ``format`` (``id``, ``title``), ``files`` (names),
  ``proven`` (a sentence).
- ``steps``: each with ``title``, ``text`` and ``evidence``; if a step differs by axis, also
  ``heads`` and ``rows``. ``restore_steps``: the same for restoring. ``restore``, ``unconfirmed``:
  sentences.
- ``changes``: ``entries`` with ``entry``, ``old`` and ``new``, and ``untouched`` (lines that stay);
  None if the control's own files were not given.
- ``assumed``: each with ``fact``, ``value`` and ``evidence``.
- ``axes``: each with ``name``, ``address``, ``unit`` (um or arcsec), ``rows`` (``quantity``,
  ``old``, ``new``; ``typed`` and ``typed_old`` are the values as the control's parameter holds
  them), ``numbering`` (see `numbering`; None if points have no numbers), ``quick_check``
  (``position``, ``direction``, ``adds``: the compensation that the control displays, ``expected``,
  ``stop``), ``points_needed``, ``rapid`` (the test was made at rapid traverse, and all values are
  for it) and ``fixed_positions`` (``name``, ``position``, ``moves``).

Values to be typed have a plain minus sign, so that they can be copied. Numbers in tables and steps
have a decimal point in every ``language`` (that of the page, English by default).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from compwright.foundations.utf8 import visible
from compwright.reporting.card_steps import alike_once, step_content, step_lines
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
    pairs,
    rule_lines,
)
from compwright.words.sentences import Language, NumberText, Sentence, in_language, say

_BOX = "[ ]"
#: Evidence of what a card leaves to the report; what is not confirmed stands above its steps.
_DEFAULT = "default of the definition"
#: More changes than these are read in changes.csv, not on the card.
_MOST_CHANGES = 60
#: Three rows of changes fit next to each other where no entry with its values has more letters.
_SHORT_CHANGE = 30


def card_html(card: Document) -> bytes:
    """Return the card as a self-contained page. Raises UsageError when the report extra is
    missing.
    """
    return render_page("card.html", _content(card), _language(card))


def card_markdown(card: Document) -> str:
    """Return the card as Markdown with boxes to tick. It is readable as plain text and needs no
    extra.
    """
    content, language = _content(card), _language(card)

    def words(sentence: Sentence) -> str:
        return sentence.text(language)

    lines = [f"# {_escape(content['title'])}", "", *_machine(content, language), ""]
    doubts = content["doubts"]
    if doubts:
        lines += _bullets(f"## {doubts['heading']}", [item["message"] for item in doubts["items"]])
        lines += [_escape(str(doubts["step"])), ""] if doubts["step"] else []
    headings = (
        ("acknowledged", say("report.acknowledged")),
        ("unconfirmed", say("card.not_confirmed")),
    )
    for key, heading in headings:
        lines += _bullets(f"## {words(heading)}", content[key])
    lines += _steps(content["steps"], language)
    for key, heading in (("restore", say("card.way_back")), ("limits", say("card.limits"))):
        lines += _bullets(f"## {words(heading)}", content[key])
    for axis in content["axes"]:
        lines += _axis(axis, language)
    lines += _changes(content["changes"], language)
    if content["assumed"]:
        rows = [
            [
                _escape(fact["fact"]),
                _escape(fact["value"]),
                (f"**{words(say('card.unconfirmed'))}** " if fact["open"] else "")
                + _escape(fact["evidence"]),
            ]
            for fact in content["assumed"]
        ]
        head = [say("head.fact"), say("head.assumed_value"), say("head.evidence")]
        lines += [f"## {words(say('run.assumed'))}", "", *_table([*map(words, head)], rows), ""]
    if content["files"]:
        lines += [
            f"## {words(say('run.files'))}",
            "",
            *(f"- `{_one_line(file).replace('`', '')}`" for file in content["files"]),
            "",
        ]
    if content["proven"]:
        lines += [f"## {words(say('card.proven'))}", "", _escape(content["proven"]), ""]
    lines += [words(say("card.signature")), ""]
    lines += [content["note"], ""] if content["note"] else []
    return "\n".join(lines)


# --- one content for both forms
# ------------------------------------------------------------------------------------------------


def _language(card: Document) -> Language:
    return card.get("language") or "en"


def _content(card: Document) -> dict[str, Any]:
    """Return the contents that the Markdown form and the page of a card share."""
    language = _language(card)
    title = card.get("title") or say("card.no_title")
    content = {
        "page_title": title,
        "page_class": "card",
        "title": title,
        "machine": [
            (say("label.machine", key=name), value) for name, value in pairs(card.get("machine"))
        ],
        "format": {
            "id": plain((card.get("format") or {}).get("id", "")),
            "title": plain((card.get("format") or {}).get("title", "")),
        },
        "doubts": doubts(card.get("doubts")),
        "acknowledged": acknowledged(card.get("acknowledged")),
        "limits": _limits(card.get("limits") or {}, card.get("circle_limits") or {}),
        "unconfirmed": alike_once(
            [in_language(plain(text), language) for text in card.get("unconfirmed") or []], language
        ),
        "steps": [step_content(step, language) for step in card.get("steps") or []],
        "axes": [_axis_content(axis, language) for axis in card.get("axes") or []],
        "changes": changes_content(card.get("changes")),
        "restore": [
            *(plain(text) for text in card.get("restore") or []),
            *(
                line["text"]
                for step in card.get("restore_steps") or []
                for line in step_lines(step, language)
            ),
        ],
        "assumed": [
            fact
            for fact in assumed(card.get("assumed"))
            if not fact["open"] and fact["evidence"] != _DEFAULT
        ],
        "files": [plain(file) for file in card.get("files") or []],
        "proven": plain(card.get("proven") or ""),
        "note": _note(card, language),
    }
    return {key: _resolved(value, language) for key, value in content.items()}


def _resolved(value: Any, language: Language) -> Any:
    """Return card contents with all sentences translated. Numbers keep their decimal point."""
    if isinstance(value, Mapping):
        return {key: _resolved(one, language) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [_resolved(one, language) for one in value]
    if isinstance(value, NumberText):
        return str(value)
    return in_language(value, language) if isinstance(value, str | Sentence) else value


def _note(card: Document, language: Language) -> str | Sentence:
    """Return a note on the card in a language other than English: which parts are not translated,
    and how numbers are written.
    """
    if language == "en":
        return ""
    steps = [*(card.get("steps") or ()), *(card.get("restore_steps") or ())]
    foreign = any(not getattr(step["text"], "translated", bool)(language) for step in steps)
    return say("card.note", foreign=foreign)


def _limits(axes: Document, circles: Document) -> list[Sentence]:
    """Return one sentence for each limit, with the decision on it, and then the decision rule with
    its guard bands.
    """
    decisions: list[Sentence] = []
    rules: list[Sentence] = []
    limited = [
        (say("card.axis", name=name), axis, axis.get("unit", "um")) for name, axis in axes.items()
    ]
    limited += [(say("card.circle", name=name), circle, "um") for name, circle in circles.items()]
    for name, its, its_unit in limited:
        unit, accept = unit_text(its_unit), its.get("accept") or {}
        decided = [
            say(
                "card.limit",
                symbol=symbol(key),
                limit=plain(entry["limit"]),
                unit=unit,
                decision=entry["decision"],
            )
            for key, entry in accept.items()
        ]
        decisions += [say("card.decided", name=name, decided=decided)] if decided else []
        rules += rule_lines(accept, unit)
    return [*decisions, *dict.fromkeys(rules)]


def changes_content(changes: Document | None) -> dict[str, Any] | None:
    """Return a table of changed entries of the control files, cut after the first rows, and the
    number of rows left out.
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
    shown = rows[:_MOST_CHANGES]
    short = all(sum(map(len, row)) < _SHORT_CHANGE for row in shown)
    return {
        "rows": shown,
        "columns": 3 if short else 2,
        "more": len(rows) - len(shown),
        "count": len(rows),
        "untouched": changes["untouched"],
    }


def _axis_content(axis: Document, language: Language) -> dict[str, Any]:
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
        "points": _around_points(axis.get("points_needed"), language),
        "rapid": say("card.rapid") if axis.get("rapid") else "",
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
        "numbering": _numbering(axis.get("numbering"), language),
        "how_to_check": say("card.how_to_check"),
        "zeroed": bool(checks) and number(checks[0].get("expected")) == number(0.0),
        "fixed": [
            [plain(row.get("name")), number(row.get("position"), places), _signed(row.get("moves"))]
            for row in fixed
        ],
    }


def _around_points(points: object, language: Language) -> list[str] | None:
    """Return the sentence on how many table points are enough, in three parts: the text before the
    number, the number, and the text after it.
    """
    if points is None:
        return None
    before, _, after = say("card.points", points="\n").text(language).partition("\n")
    return [before, plain(points), after]


def _numbering(numbering: Document | None, language: Language) -> dict[str, Any] | None:
    if numbering is None:
        return None
    return {
        "text": numbering_text(numbering, language),
        "picture": numbering_svg(numbering, language),
        "words": [plain(words) for words in numbering["words"]],
    }


def _with_parameter(value: object, typed: object) -> str | Sentence:
    """Return an old value as text: as the control's parameter holds it (``typed``), with ``value``
    in parentheses; ``value`` alone if ``typed`` is empty.
    """
    return say("card.with_unit", text=typed, unit=_typed(value)) if typed else _typed(value)


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


def _machine(content: Document, language: Language) -> list[str]:
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
        for name, value in [*content["machine"], (say("label.control").text(language), control)]
    ]


def _steps(steps: Iterable[Document], language: Language) -> list[str]:
    lines = []
    unconfirmed = say("card.unconfirmed").text(language)
    for step in steps:
        mark = f" **({unconfirmed})**" if step["open"] else ""
        lines.append(f"- {_BOX} **{_escape(step['title'])}**{mark}")
        for line in step["lines"]:
            words = line["text"]
            lines.append(
                f"  - {_BOX} {_escape(words)}" if line["tick"] else f"  {_paragraph(words)}"
            )
        if step["evidence"]:
            evidence = say("card.evidence", evidence=step["evidence"])
            lines.append(f"  {_escape(evidence.text(language))}")
    return [f"## {say('card.steps').text(language)}", "", *lines, ""] if lines else []


def _axis(axis: Document, language: Language) -> list[str]:
    def words(sentence: Sentence) -> str:
        return sentence.text(language)

    def with_unit(sentence: Sentence, unit: str) -> str:
        return words(say("card.with_unit", text=sentence, unit=unit))

    unit, where = axis["unit"], axis["where"]
    title = words(say("card.axis_title", axis=axis["name"], address=axis["address"]))
    lines = [f"## {_escape(title)}", ""]
    if axis["rapid"]:
        lines += [f"**{axis['rapid']}**", ""]
    if axis["points"] is not None:
        lines += [f"- {_BOX} {''.join(axis['points'])}", ""]
    if axis["rows"]:
        rows = [
            [_BOX, *map(_escape, row[:2]), _escape(f"{row[3]} ({row[2]})" if row[3] else row[2])]
            for row in axis["rows"]
        ]
        head = ["", *map(words, (say("card.quantity"), say("head.old"), say("head.new")))]
        lines += [f"### {words(say('card.values'))}", "", *_table(head, rows), ""]
    if axis["numbering"] is not None:
        drawing = axis["numbering"]
        lines += [f"### {words(say('card.sections'))}", "", "```", *drawing["text"], "```", ""]
        lines += [*(f"- {_escape(words)}" for words in drawing["words"]), ""]
    if axis["checks"]:
        head = [with_unit(say("head.position"), where), words(say("head.approach"))]
        head += [with_unit(say("card.adds"), unit), words(say("card.read"))]
        head += [with_unit(say("card.expected"), unit), with_unit(say("card.stop"), unit)]
        head += [words(say("card.measured"))]
        rows = [
            [*row[:3], "", *row[3:], ""]
            for row in ([_escape(cell) for cell in check] for check in axis["checks"])
        ]
        zero = [words(say("card.zeroed")), ""] if axis["zeroed"] else []
        lines += [f"### {words(say('card.check_positions'))}", "", axis["how_to_check"], ""]
        lines += [*zero, *_table(head, rows), ""]
    if axis["fixed"]:
        rows = [list(map(_escape, row)) for row in axis["fixed"]]
        head = [words(say("card.name")), with_unit(say("head.position"), where)]
        head += [with_unit(say("card.moves_by"), unit)]
        lines += [f"### {words(say('card.fixed'))}", "", *_table(head, rows), ""]
    return lines


def _changes(changes: dict[str, Any] | None, language: Language) -> list[str]:
    if changes is None:
        return []

    def words(sentence: Sentence) -> str:
        return sentence.text(language)

    left = changes["more"]
    more = [words(say("card.more_changes", more=left)), ""] if left else []
    rows = [list(map(_escape, row)) for row in changes["rows"]]
    count, untouched = changes["count"], changes["untouched"]
    sentence = words(say("changes.summary", count=count, untouched=untouched, more=0))
    head = [*map(words, (say("head.entry"), say("head.old"), say("head.new")))]
    table = [*_table(head, rows), ""] if rows else []
    return [f"## {words(say('run.changes'))}", "", sentence, "", *table, *more]


def _bullets(heading: str, items: Sequence[str | Sentence]) -> list[str]:
    return [heading, "", *(f"- {_BOX} {_escape(item)}" for item in items), ""] if items else []


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return a Markdown table with padded cells, readable also as plain text."""
    widths = [max(3, *(len(row[column]) for row in [head, *rows])) for column in range(len(head))]
    lines = [
        "| " + " | ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)) + " |"
        for row in [head, *rows]
    ]
    return [lines[0], "|" + "|".join("-" * (width + 2) for width in widths) + "|", *lines[1:]]


def _one_line(text: str | Sentence) -> str:
    return " ".join(visible(f"{text}").split())


def _paragraph(text: str | Sentence) -> str:
    """Return a line of text that Markdown does not take for a heading, list, quotation or rule."""
    line = _escape(text)
    return f"\\{line}" if line[:1] in set("#-+>=~_") else line


def _escape(text: str | Sentence) -> str:
    """Return a text as one line without Markdown markup. Underscores inside names stay."""
    line = _one_line(text)
    for letter in "\\`*[]|":
        line = line.replace(letter, f"\\{letter}")
    return line.replace("&", "&amp;").replace("<", "&lt;")
