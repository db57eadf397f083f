"""Findings, assumptions and questions that readers collect, and the texts that readers share."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final, Literal

from compwright.formats.text.gathering import FoundValue
from compwright.foundations.errors import Fault
from compwright.foundations.findings import Finding, Severity
from compwright.records.correction import Assumption, ControlFile
from compwright.words.sentences import Sentence

# Next steps of `Notes.refuse`, by the cause.
CORRECT_VALUE: Final = (
    "correct this value in the control, measure the axis again and export its files again; or"
    " leave the axis out of the job"
)
NOT_COUNTED: Final = (
    "compwright cannot include this in its calculation: switch it off in the control, measure the"
    " axis again and export its files again; or leave the axis out of the job"
)
EXPORT_AGAIN: Final = (
    "export this file from the control again and give it unchanged; or leave the axis out of the"
    " job"
)
ADD_FILE: Final = "give the file that contains it with the control's other files"
KEEP_ONE: Final = (
    "give only the file that is in the control now: remove the other one from the files of the"
    " state; within one file, export it from the control again"
)
CORRECT_TRAVEL: Final = (
    "correct `travel` of the axis in the job: machine coordinates, within the limits of the axis"
)


@dataclass(slots=True)
class Notes:
    """The findings, assumptions, questions and faults that were collected while reading files."""

    faults: list[Fault] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    assumed: list[Assumption] = field(default_factory=list)
    #: What only the user can answer: nothing is done with the files without it.
    questions: list[Fault] = field(default_factory=list)
    #: Answers of the job that the files contradict; they are questions where no table needed the
    #: answer.
    contradictions: list[Fault] = field(default_factory=list)
    open_answers: int = 0

    def take(self, other: Notes) -> None:
        """Add to these notes the findings, assumptions and questions of ``other``, but not its
        faults.
        """
        self.findings.extend(other.findings)
        self.questions.extend(other.questions)
        self.contradictions.extend(other.contradictions)
        self.open_answers += other.open_answers
        for note in other.assumed:
            self.assume(note.fact, note.value, note.evidence)

    def ask_contradicted(self) -> None:
        """Ask about the job's answer ``active`` if the files contradict the answer and no table
        needs it.
        """
        if not self.open_answers:
            for fault in self.contradictions:
                self.ask(fault)

    def ask(self, question: Fault) -> None:
        """Add a question for the user, unless the notes already contain it."""
        if question not in self.questions:
            self.questions.append(question)

    def assume(self, fact: str, value: str, evidence: str) -> None:
        """Add an assumption, if it is not there yet."""
        note = Assumption(fact, value, evidence)
        if note not in self.assumed:
            self.assumed.append(note)

    def find(self, name: str, severity: str, axis: str = "", /, **values: object) -> None:
        """Add a finding.

        The arguments are those of `Finding.of`. ``axis``: the address of the finding's axis, or its
        label, which may have further words (``axis AX1, measuring system 2``).
        """
        about = (axis.removeprefix("axis ").partition(",")[0],) if axis else ()
        grave: Severity = "warning" if severity == "warning" else "info"
        self.findings.append(Finding.of(name, grave, about, **values))

    def no_data(
        self, label: str, files: Iterable[ControlFile], named: Iterable[str], expected: str
    ) -> None:
        """Refuse an axis (``label``) whose compensation is in none of the ``files``. ``named``: the
        axes in them; ``expected``: what would state the compensation.
        """
        fault = Fault(
            message=f"no given file states the compensation of {label}; missing values do not"
            " count as zero",
            file=", ".join(file.name for file in files),
            expected=f"{expected}, or `none` instead of files",
            found=f"axes {', '.join(named)}" if named else "no axis at all",
            hint="correct the `address` of the axis, or add the file that contains it to the"
            " control's files (`states` or `--state`); give `none` instead of files if the control"
            " has no compensation",
        )
        self.faults.append(fault)

    def counted_as(self, label: str, name: str, value: str) -> None:
        """Report the value that is assumed for a quantity which is not in the files."""
        self.find("CW-S005", "warning", label, label=label, quantity=name, value=value)

    def switched_off(self, label: str, what: str) -> None:
        """Report that a table in the files corrects nothing.

        ``label``: the table in messages. ``what``: the parameter that deactivates it.
        """
        self.find("CW-S007", "info", label=label, switch=what)

    def no_table(self, label: str, *, off: bool = False) -> None:
        """Report that no file contains a table of an axis: as a warning, or only as information if
        the files activate no table (``off``).
        """
        self.find("CW-S008", "info" if off else "warning", label, label=label)

    def taken_for(self, axis: str, address: str) -> None:
        """Report which axis of the control was assumed to be the axis of the job."""
        self.find("CW-S010", "warning", axis=axis, address=address)

    def refuse(
        self,
        label: str,
        message: str,
        place: FoundValue | None,
        *,
        expected: str,
        hint: str,
        found: str | None = None,
    ) -> None:
        """Add a fault at the line of ``place``, unless it is there already.

        ``expected``, ``found``: the expected value and the value found, which defaults to the text
        of ``place``. ``hint``: the next step.
        """
        fault = Fault(
            message=f"{label}: {message}",
            file=place.occurrence.file if place is not None else "",
            place=place.occurrence.place if place is not None else "",
            expected=expected,
            found=place.text if found is None and place is not None else found or "",
            hint=hint,
        )
        self.once(fault)

    def once(self, fault: Fault) -> None:
        """Add a fault, if it is not there yet."""
        if fault not in self.faults:
            self.faults.append(fault)

    def ignored(self, label: str, what: str, why: Literal["table", "rotary"]) -> None:
        """Report a value that the control ignores because the axis has a table or is rotary."""
        self.find("CW-S009", "warning", label=label, what=what, why=why)

    def idle_file(self, sentence: Sentence) -> None:
        """Report a table file that is not among those that the control loads."""
        self.findings.append(Finding("CW-S012", "warning", sentence))
