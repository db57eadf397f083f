"""Requests for corrections between axes (squareness, straightness), and the answers of controls."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Protocol

from compwright.formats.definition.schema import Definition
from compwright.foundations.errors import Fault
from compwright.foundations.findings import Severity
from compwright.foundations.units import outside_factor, shown_unit
from compwright.records.axis import Axis, FloatArray
from compwright.records.correction import ControlFile, ControlState
from compwright.records.plan import PlannedCross
from compwright.words.sentences import (
    Amount,
    ControlText,
    Sentence,
    SentenceText,
    control_text,
    say,
)

#: A shift of the whole axis by a cross-axis table is reported from this size on, mm or deg.
_NO_SHIFT = 2e-6


class FileReading(Protocol):
    """A function that reads the compensation from control files.

    ``written``: compwright wrote the files. A contradiction in them is then a fault of compwright.
    """

    def __call__(self, files: tuple[ControlFile, ...], *, written: bool = False) -> ControlState:
        """Return the compensation in ``files``; ``written``: compwright wrote these files. Raises
        CompwrightError if they cannot be read.
        """


@dataclass(frozen=True, slots=True, kw_only=True)
class BetweenRequest:
    """A request to add corrections between axes to a control's files.

    ``planned``: the corrections. ``axes``: the job's axes by name. ``tables``: the new files with
    tables of single axes. ``tabled``: names of the axes that have a table in these files.
    ``found``: the control's own files as they were found. ``base``: the same files, with ``tables``
    in place of those of the same name. ``read``: a function that reads the compensation from files.
    """

    planned: tuple[PlannedCross, ...]
    axes: Mapping[str, Axis]
    tabled: Collection[str]
    tables: tuple[ControlFile, ...]
    base: tuple[ControlFile, ...]
    read: FileReading
    found: tuple[ControlFile, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Between:
    """A control's answer to a request for corrections between axes: files, sheets, card steps.

    ``files``: files of ``BetweenRequest.base`` that change, and new files; None: no file contains
    the corrections. ``held``: the corrections as the files contain them; None: all, as planned.
    ``sheets``: entry sheets; ``typed``: the corrections that they contain. ``remarks``: findings.
    ``steps``: title, text and evidence of steps of the card. ``quantum``: rounding step of the
    values in the files, mm or deg; 0: the files contain the planned values.
    """

    files: tuple[ControlFile, ...] | None = None
    held: tuple[PlannedCross, ...] | None = None
    sheets: tuple[ControlFile, ...] = ()
    typed: tuple[PlannedCross, ...] = ()
    remarks: tuple[tuple[Severity, Sentence], ...] = ()
    steps: tuple[Mapping[str, str], ...] = ()
    quantum: float = 0.0


def error_label(entry: PlannedCross) -> Sentence:
    """Return the name of the error that a cross-axis table corrects: squareness or a slope.

    If the angle between the axes is above 90°, the output axis deviates towards -.
    """
    if entry.source == "circle":
        squareness = entry.squareness * 1e6
        return say("between.squareness", output=entry.output, input=entry.input, slope=squareness)
    of, per = entry.added.output_kind.unit, entry.added.input_kind.unit
    length, times = ("m", 1e3) if per == "mm" else ("deg", 1.0)
    slope = -entry.squareness * outside_factor(of) * times
    amount = Amount(slope, f"{shown_unit(of)}/{length}", "+.1f")
    return say("between.deviation", output=entry.output, input=entry.input, slope=amount)


def merged_files(
    first: Sequence[ControlFile], then: Sequence[ControlFile]
) -> tuple[ControlFile, ...]:
    """Return the files of both sets. A file in ``then`` replaces one with the same name."""
    return tuple({file.name: file for file in (*first, *then)}.values())


def combined_answer(answers: Iterable[Between]) -> Between:
    """Combine several answers that have no files into one answer."""
    every = list(answers)
    return Between(
        sheets=tuple(sheet for one in every for sheet in one.sheets),
        typed=tuple(entry for one in every for entry in one.typed),
        remarks=tuple(remark for one in every for remark in one.remarks),
        steps=tuple(step for one in every for step in one.steps),
    )


def entry_sheet_answer(
    entry: PlannedCross, values: FloatArray, sheet: ControlFile, sentence: Sentence, text: str
) -> Between:
    """Return the answer for a correction that the user has to type in from ``sheet``, because its
    sign is not confirmed. ``values``: the correction in the sheet at the positions of ``entry``, mm
    or deg; ``sentence``: a warning about the sign; ``text``: the card's text.
    """
    title = control_text("{output} over {input}: type in", output=entry.output, input=entry.input)
    return Between(
        sheets=(sheet,),
        typed=(replace(entry, added=replace(entry.added, positive=values, negative=values)),),
        remarks=(("warning", sentence),),
        steps=({"title": title, "text": text, "evidence": "unconfirmed"},),
    )


def cannot_hold(entries: Sequence[PlannedCross], why: str) -> Between:
    """Return the answer that ``entries`` are not corrected, with their common reason ``why``."""
    remark = say("CW-P113.not_held", what=_labels(entries), several=len(entries) > 1, why=why)
    return not_corrected(entries, remark, control_text("{why}.", why=why))


def _labels(entries: Sequence[PlannedCross]) -> Sentence:
    """Return the names of the errors of ``entries`` as one text."""
    labels = [error_label(entry) for entry in entries]
    return labels[0] if len(labels) == 1 else say("given.listed", items=labels)


def not_corrected(entries: Sequence[PlannedCross], remark: Sentence, step: str) -> Between:
    """Return the answer that corrections are not written: a finding, and a ``step`` of the card."""
    title = control_text("Not corrected: {error}", error=_labels(entries))
    return Between(
        remarks=(("error", remark),),
        steps=({"title": title, "text": step, "evidence": "inferred"},),
    )


def refusal(faults: Iterable[Fault]) -> SentenceText:
    """Return ``faults`` of a control's files or options as one text that can be translated."""
    every = [
        say(
            "between.fault",
            where=_where(fault),
            message=fault.message,
            expected=fault.expected,
            found=fault.found,
            hint=fault.hint,
        )
        for fault in faults
    ]
    return SentenceText(say("between.faults", faults=every))


def _where(fault: Fault) -> str:
    """Return file and place of a fault; "" without a file."""
    word, _, number = fault.place.partition(" ")
    if fault.file and word == "line":
        return control_text("{file}: line {number}", file=fault.file, number=number)
    return ": ".join(filter(None, (fault.file, fault.place))) if fault.file else ""


def alternative_answer(definition: Definition, planned: Iterable[PlannedCross]) -> Between:
    """Return the answer of a control without cross-axis tables to the ``planned`` corrections
    between axes: for each, the alternative that the control's definition describes.

    The text may contain fields. ``{squareness}`` is the angle to be removed by kinematics, rad.
    ``{input}`` and ``{output}`` are the axes, lower case. ``{shift}`` is the shift of the output
    axis that this also causes. It arises because the line of the angle passes through machine zero,
    while the correction is zero at the reference.
    """
    return combined_answer(
        cannot_hold([entry], ControlText(definition.between_axes.instead, _named(entry)))
        for entry in planned
    )


def _named(entry: PlannedCross) -> dict[str, str]:
    added = entry.added
    constant = entry.squareness * float(added.positions[0]) - float(added.positive[0])
    moved = control_text(
        ", which also moves {output} as a whole by {constant} µm",
        output=entry.output,
        constant=f"{round(constant * 1e3, 2) + 0.0:+.2f}",
    )
    return {
        "squareness": f"{entry.squareness:+.9f}",
        "input": entry.input.lower(),
        "output": entry.output.lower(),
        "shift": moved if abs(constant) > _NO_SHIFT else "",
    }
