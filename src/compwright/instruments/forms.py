"""The file formats of positioning tests: how each is recognised and read."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass

from compwright.foundations.errors import Fault, InputError
from compwright.instruments import compensation_text, mean_blocks, sections, target_data
from compwright.instruments.answers import Answers
from compwright.instruments.comments import KEYS
from compwright.instruments.compensation_text import is_compensation_text, read_compensation_text
from compwright.instruments.fault_list import FaultList
from compwright.instruments.laser_runs import is_laser_runs, read_laser_runs
from compwright.instruments.mean_blocks import is_mean_blocks, read_mean_blocks
from compwright.instruments.own_forms import (
    is_target_data_file,
    read_plain_csv,
    read_target_data_file,
    spans_of_plain_csv,
    spans_of_target_data,
)
from compwright.instruments.parsed_test import Parsed
from compwright.instruments.spans import SpansOf


@dataclass(frozen=True, slots=True)
class MeasurementForm:
    """One file format of positioning tests.

    ``name``: the name in messages. ``recognises``: whether the lines of a file have this format.
    ``read``: the reader; it is called with the lines of the file, the list of faults and the user's
    answers. ``spans_of``: gives the meaning of the parts of a line, from which `redact` decides
    what it keeps and what it replaces. ``words``: names of sections and keys of the format, which
    stay in a redacted copy. ``code_pages``: whether free text in the file may be in an old code
    page.
    """

    name: str
    recognises: Callable[[Sequence[str]], bool]
    read: Callable[[Sequence[str], FaultList, Answers], Parsed]
    spans_of: SpansOf
    words: Collection[str]
    code_pages: bool = True


FORMS = (
    MeasurementForm(
        "the laser's runs (.rtl, .rta)",
        is_laser_runs,
        read_laser_runs,
        sections.spans_of,
        sections.WORDS,
    ),
    MeasurementForm(
        "the laser's means (.pos)",
        is_mean_blocks,
        read_mean_blocks,
        mean_blocks.spans_of,
        sections.WORDS,
    ),
    MeasurementForm(
        "a compensation text (.ren)",
        is_compensation_text,
        read_compensation_text,
        compensation_text.spans_of,
        compensation_text.KEYS,
    ),
    MeasurementForm(
        "target data (TGT_DATA[1]=...)",
        is_target_data_file,
        lambda text, faults, _: read_target_data_file(text, faults),
        spans_of_target_data,
        target_data.KEYS,
        code_pages=False,
    ),
)
#: Forms whose reader may ask for the unit or the sign.
OPEN_FORMS = FORMS[:3]
#: What a file is taken for that no other form recognises.
PLAIN_CSV = MeasurementForm(
    "plain CSV",
    lambda _: True,
    lambda text, faults, _: read_plain_csv(text, faults),
    spans_of_plain_csv,
    KEYS,
    code_pages=False,
)


def form_of(text: Sequence[str], file: str) -> MeasurementForm:
    """Return the file format of the lines of a file. Raises InputError if two formats match."""
    found = [form for form in FORMS if form.recognises(text)]
    if len(found) > 1:
        raise InputError(
            Fault(
                message="the file mixes two formats, in which equal values can have different "
                "meanings",
                file=file,
                expected="a file of one format",
                found=" and ".join(form.name for form in found),
                hint="keep the lines of one format only",
            )
        )
    return found[0] if found else PLAIN_CSV
