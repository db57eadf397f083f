"""The report page of a circular test: figures, parameters, causes, next steps, conditions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

from compwright.reporting import paper, sections
from compwright.reporting.axis_figures import residual_figure
from compwright.reporting.cause_pictures import cause_pictures
from compwright.reporting.causes import (
    CircleCause,
    full_cause_words,
    machine_title,
    ranked_causes,
    summed_causes,
)
from compwright.reporting.circle_steps import job_lines, machine_job, scale_errors, steps_for
from compwright.reporting.circles import CircleFigure
from compwright.reporting.circular_parameters import (
    parameter_rows,
    parameter_words,
    printed_parameters,
)
from compwright.reporting.numbers import number, plain
from compwright.reporting.sections import Document, TextTable
from compwright.words.sentences import NumberText, Sentence, say

#: Standard errors within which our value and the printed one agree.
_AGREES: Final = 2.0


def circle_page(result: Document, index: int, job: Sequence[str] | None = None) -> dict[str, Any]:
    """Return the contents of a circular test's report page. ``index``: the number of the test in
    the report; ``job``: lines to copy into a job file; None: lines made from this test alone.
    """
    name = plain(result.get("name") or "")
    causes, sums = ranked_causes(result), summed_causes(result)
    axes = result.get("axes") or ("first", "second")
    residual = residual_figure(result, name)
    corrected = [*(cause for cause in causes if cause.corrected), *scale_errors(causes)]
    return {
        "figure": CircleFigure(result, f"test{index}", name),
        "residual": residual,
        "residual_words": say("circle.unexplained", rms=number(result.get("residual"))),
        "parameters": _parameters(result),
        "causes": _causes(causes) if causes else None,
        "sums": _sums(sums, printed=_any_printed(causes)) if sums else None,
        "pictures": cause_pictures(causes),
        "comparison": say("circle.comparison") if _any_printed(causes) else "",
        "steps": steps_for(causes, axes),
        "job": (job_lines([cause.name for cause in corrected], result) if job is None else job),
        "reasons": _reasons(result),
        "sheet": paper.sheet(result, {}),
    }


def machine_block(machine: Document, results: Sequence[Document]) -> dict[str, Any]:
    """Return the report section with the common result of several circular tests of one machine."""
    rows = []
    planes = {"".join(sorted(result["axes"])): "".join(result["axes"]) for result in results}
    for kind, found in machine["causes"].items():
        for name, each in found.items():
            of = planes.get(name, name)
            words = say("cause.kind", kind=kind, first=of, second="", axis=of)
            cause = CircleCause(
                name=kind,
                words=words,
                value=each["value"],
                error=each["std_error"],
                unit=each["unit"],
                effect=0.0,
                share=0.0,
            )
            rows.append([words, cause.value_text, cause.unit_text])
    heads = sections.heads(say("head.cause"), (say("circle.value_error"), ""), say("head.unit"))
    return {
        "title": machine_title(machine),
        "unnamed": machine["machine"] is None and machine["serial"] is None,
        "table": {"heads": heads, "rows": rows},
        "job": machine_job(machine, results),
    }


def _parameters(result: Document) -> TextTable:
    """Return the table of parameters, with uncertainty U and the vendor's printed values."""
    values, printed = result.get("parameters") or {}, printed_parameters(result)
    stated = result.get("uncertainty") or {}
    rows = []
    for row in parameter_rows(result):
        cells = [
            say(
                "label.value_error",
                value=number(values.get(key)),
                error=number(stated[key]["U"]),
            )
            if key in stated
            else number(values.get(key))
            if key
            else ""
            for key in row.keys
        ]
        software = [NumberText(printed.get(row.letter, ""))] if printed else []
        rows.append([row.words, row.letter, *cells, *software])
    unit = say("label.with_uncertainty", unit="µm", k=2) if stated else "µm"
    return {
        "heads": sections.heads(
            say("head.parameter"),
            "",
            *((say("circle.sense", sense=way), unit) for way in ("ccw", "cw", "both")),
            *([(say("circle.software"), "µm")] if printed else []),
        ),
        "rows": rows,
    }


def _reasons(result: Document) -> list[tuple[Sentence, str]]:
    """Return, for each reason why values are missing, the names of these values as one text, and
    the reason.
    """
    reasons: dict[str, list[Sentence]] = {}
    for key, reason in (result.get("not_applicable") or {}).items():
        words = say("head.causes") if key == "diagnosis" else _words(plain(key), result)
        reasons.setdefault(plain(reason), []).append(words)
    return [
        (say("given.listed", items=list(dict.fromkeys(names))), reason)
        for reason, names in reasons.items()
    ]


def _words(name: str, result: Document) -> Sentence:
    """Return the text for the JSON name of a cause or a parameter."""
    if name in (result.get("parameters") or {}):
        return parameter_words(name)
    return full_cause_words(name, result.get("axes") or ("first", "second"))


def _causes(causes: Sequence[CircleCause]) -> TextTable:
    """Return the table of causes and their parts by falling effect, with the vendor's values.

    A value of the vendor is in brackets if the file itself calls it invalid.
    """
    printed = _any_printed(causes)
    rows = []
    for cause in causes:
        share = f"{100.0 * cause.share:.0f}"
        rows.append(
            [cause.noted_words, number(cause.effect), share, *_values(cause, printed=printed)]
        )
        rows += [
            [say("circle.detail", part=part.noted_words), "", "", *_values(part, printed=printed)]
            for part in cause.parts
        ]
    effect = (say("circle.effect"), "µm"), (say("circle.share"), "%")
    return {"heads": _heads(say("head.cause"), *effect, printed=printed), "rows": rows}


def _sums(sums: Sequence[CircleCause], *, printed: bool) -> TextTable:
    """Return the table of the values that summarise causes, ``sums``. ``printed``: with a column
    for the values that the vendor's software printed.
    """
    rows = [[cause.words, *_values(cause, printed=printed)] for cause in sums]
    return {"heads": _heads(say("head.quantity"), printed=printed), "rows": rows}


def _heads(*first: tuple[Sentence, str] | Sentence, printed: bool) -> Any:
    software = (say("circle.software"), ""), say("circle.compared")
    value = (say("circle.value_error"), ""), say("head.unit")
    return sections.heads(*first, *value, *(software if printed else ()))


def _any_printed(causes: Sequence[CircleCause]) -> bool:
    return any(one.printed for cause in causes for one in (cause, *cause.parts))


def _values(cause: CircleCause, *, printed: bool) -> list[str | Sentence]:
    software = [NumberText(cause.printed_text(cause.text)), _comparison(cause)]
    return [cause.value_text, cause.unit_text, *(software if printed else [])]


def _comparison(cause: CircleCause) -> str | Sentence:
    """Return how the value of a cause compares with the value that the vendor's software printed:
    "agrees", "differs" with the reason, or why they are not compared; "" if no value was printed.

    To find the reason, the same readings are evaluated by a simple regression without spikes. It
    shows how much of the difference the spikes cause.
    """
    if not cause.printed:
        return ""
    theirs, plain = cause.printed[0], cause.plain
    apart = abs(cause.value - theirs)
    if cause.doubtful:
        how = "not_valid"
    elif not cause.comparable:
        how = "definition"
    elif cause.error > max(abs(cause.value), abs(theirs)):
        how = "uncertain"
    else:
        how = "agrees" if apart <= _AGREES * cause.error else "differs"
    if how != "differs" or plain is None:
        return say("circle.agreement", how=how, pitch=cause.pitch)
    share = 1.0 - abs(plain - theirs) / apart
    return say(
        "circle.difference",
        spikes=share > 0.5,
        share=100.0 * share,
        plain=cause.text(plain),
        unit=cause.unit_text,
    )
