"""The forms of positioning files, each with how its content is recognised and how it is read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from compwright.foundations.errors import Fault, InputError
from compwright.instruments.answers import Answers
from compwright.instruments.compensation_text import is_compensation_text, read_compensation_text
from compwright.instruments.fault_list import FaultList
from compwright.instruments.laser_runs import is_laser_runs, read_laser_runs
from compwright.instruments.mean_blocks import is_mean_blocks, read_mean_blocks
from compwright.instruments.own_forms import (
    is_target_data_file,
    read_plain_csv,
    read_target_data_file,
)
from compwright.instruments.parsed import Parsed


@dataclass(frozen=True, slots=True)
class Form:
    """``name`` stands in messages; ``read`` takes the lines of the file and what the user says of
    it. ``code_pages``: text of users in it may be in an old code page.
    """

    name: str
    recognises: Callable[[Sequence[str]], bool]
    read: Callable[[Sequence[str], FaultList, Answers], Parsed]
    code_pages: bool = True


FORMS = (
    Form("the laser's runs (.rtl, .rta)", is_laser_runs, read_laser_runs),
    Form("the laser's means (.pos)", is_mean_blocks, read_mean_blocks),
    Form("a compensation text (.ren)", is_compensation_text, read_compensation_text),
    Form(
        "target data (TGT_DATA[1]=...)",
        is_target_data_file,
        lambda text, faults, _: read_target_data_file(text, faults),
        code_pages=False,
    ),
)
#: Forms whose reader may ask for the unit or the sign.
OPEN_FORMS = FORMS[:3]
#: What a file is taken for that no other form recognises.
PLAIN_CSV = Form(
    "plain CSV",
    lambda _: True,
    lambda text, faults, _: read_plain_csv(text, faults),
    code_pages=False,
)


def form_of(text: Sequence[str], file: str) -> Form:
    """Return the form of the lines of a file. Raises InputError where two forms recognise it."""
    found = [form for form in FORMS if form.recognises(text)]
    if len(found) > 1:
        raise InputError(
            Fault(
                message="is of two forms at once, and they may mean different things",
                file=file,
                expected="a file of one form",
                found=" and ".join(form.name for form in found),
            )
        )
    return found[0] if found else PLAIN_CSV
