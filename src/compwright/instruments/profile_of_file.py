"""Propose a mapping profile from the bytes of a file, or state that the file needs none."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from compwright.foundations.errors import Fault, InputError, UsageError
from compwright.instruments.forms import OPEN_FORMS, PLAIN_CSV, MeasurementForm, form_of
from compwright.instruments.own_forms import is_plain_csv
from compwright.instruments.profile import MARK, SIGNS, VERSION
from compwright.instruments.profile_text import profile_text, worked_rows
from compwright.instruments.proposing import propose
from compwright.instruments.table_shape import has_table
from compwright.instruments.text_input import read_any_lines
from compwright.instruments.workbook import is_workbook, sheets_of


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposed:
    """The ``text`` of a proposed profile, some readings as sentences for a check, and the keys that
    the user must fill in.
    """

    text: str
    worked: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    open: tuple[str, ...] = ()


def proposed_profile(content: bytes, file: str) -> Proposed:
    """Return the proposed profile for ``content``. ``file``: its name in messages.

    Raises InputError for a file without a table. Raises UsageError for a file whose form is known
    completely, so that it needs no profile.
    """
    if is_workbook(content):
        return _of_workbook(content, file)
    lines, encoding = read_any_lines(content, file)
    form = form_of(lines, file)
    if form in OPEN_FORMS:
        return _answers(form, file)
    if form is not PLAIN_CSV or is_plain_csv(lines):
        raise UsageError(
            Fault(
                message=f"the file needs no profile: compwright reads it directly as {form.name}",
                file=file,
                hint="give the file without `--profile`",
            )
        )
    # plain ASCII tells nothing of the encoding of the next file of the same program
    return _proposed(lines, "" if content.isascii() else encoding, file)


def _of_workbook(content: bytes, file: str) -> Proposed:
    """Return the profile for the first sheet of a workbook with a table that is not plain CSV."""
    sheets = sheets_of(content, file)
    plain = ", ".join(sheet.name for sheet in sheets if is_plain_csv(sheet.lines))
    for sheet in sheets:
        if has_table(sheet.lines) and not is_plain_csv(sheet.lines):
            found = _proposed(sheet.lines, "", f"{file}, sheet {sheet.name}")
            note = f"proposed for the sheet {sheet.name}"
            note += f"; {plain} needs none" if plain else ""
            return replace(found, notes=(note, *found.notes))
    if plain:
        raise UsageError(
            Fault(
                message=f"the file needs no profile: compwright reads its sheet {plain} directly",
                file=file,
                hint="give the file without `--profile`",
            )
        )
    raise InputError(
        Fault(
            message="the file contains no sheet with a table of numbers",
            file=file,
            expected="rows of at least two columns, one of them with targets",
            hint="give a file with a table: targets in one column, readings in others",
        )
    )


def _proposed(lines: Sequence[str], encoding: str, file: str) -> Proposed:
    proposal = propose(lines, encoding, file)
    return Proposed(
        text=profile_text(proposal, file),
        worked=tuple(worked_rows(proposal, lines, file)),
        notes=tuple(proposal.notes),
        open=tuple(f"{key}: {why}" for key, why in proposal.why.items()),
    )


def _answers(form: MeasurementForm, file: str) -> Proposed:
    """Return the profile for a file of a known form, in which the user states only what the file
    lacks: the unit or the sign.
    """
    text = (
        f"# For {file}: {form.name}. Only what its own reader cannot know has to be filled in.\n"
        f"{MARK}: {VERSION}\n"
        "layout: own\n"
        "unit:  # of the deviations: um, mm; arcsec, urad, mrad\n"
        f"sign:  # {SIGNS[0]}, or {SIGNS[1]}; empty: as the file or its form says\n"
    )
    note = f"{form.name} is read as it is; the profile is for what its reader asks for"
    return Proposed(text=text, notes=(note,))
