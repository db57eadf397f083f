"""Recognise circular tests. Refuse files that are no plain CSV positioning file, and guess for the
user what kind of file they are.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Sequence
from typing import Final

from compwright.foundations.errors import Fault, InputError
from compwright.instruments.comments import Comments
from compwright.instruments.csv_table import (
    DELIMITERS,
    INCHES,
    NumberedLines,
    header_names,
    in_inches,
    is_number,
    split_lines,
)
from compwright.instruments.fault_list import by_profile, shown

#: The forms that `read_positioning` reads, by their names in messages.
ACCEPTED_FORMS = (
    "a plain CSV file (columns target_mm, direction, run, deviation_um; target_mm and one column"
    " per traverse; or, of an axis at rest, time_min and deviation_um), target data"
    " (TGT_DATA[1]=...), or a file of laser software (.rtl, .rta, .pos, .ren)"
)
_BALLBAR_ENDING: Final = ".b5r"
_LOOKED_AT: Final = 65536  # bytes of a file that tell its form
_NEWEST_FORM = 1
_FORM_KEY = re.compile(r"positioning\s+([0-9]{1,9})")


def is_circular(content: bytes, file: str) -> bool:
    """Return whether the first lines of a file are those of XML or of a plain CSV circular test.

    XML is taken as a ballbar's file here, and other XML is refused by the reader later. The file
    name decides only if the content is neither of the two: an empty or broken file ``.b5r`` is
    still a ballbar's file.
    """
    head = content[:_LOOKED_AT]
    utf16 = head.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE))
    text = head.decode("utf-16" if utf16 else "utf-8-sig", errors="replace").lstrip()
    if text.startswith(("<?xml", "<TEST_DOCUMENT")):
        return True
    comments, lines = split_lines(text.splitlines())
    if any(
        comment.replace(" ", "").lower().startswith("compwright:circular")
        for _, comment in comments
    ):
        return True
    _, names, known = header_names(lines.texts[0]) if lines else ("", [], 0)
    if any(name.startswith("target_") for name in names):
        return False
    return "angle_deg" in names or (not known and file.lower().endswith(_BALLBAR_ENDING))


def refuse_other_files(lines: NumberedLines, comments: Comments, file: str) -> None:
    """Raise InputError when the file is not a plain CSV positioning file, with a guess of its
    kind.
    """
    form = comments.get("compwright").lower()
    match = _FORM_KEY.fullmatch(form)
    if match and int(match[1]) > _NEWEST_FORM:
        raise InputError(
            Fault(
                message="the file was written for a newer version of compwright",
                file=file,
                place=comments.places["compwright"],
                expected=f"# compwright: positioning {_NEWEST_FORM}, or a lower number",
                found=form,
                hint="install the newer version of compwright (docs/how-to/offline.md)",
            )
        )
    if not lines:
        raise InputError(
            Fault(
                message="the file contains comment lines only",
                file=file,
                expected="a header row and readings",
                hint="add a header row and the readings",
            )
        )
    number, first = next(iter(lines))
    _, names, count = header_names(first)
    if form.startswith("circular") or (
        "angle_deg" in names and {"direction", "radius_mm"} & set(names)
    ):
        raise InputError(
            Fault(
                message="the file contains a circular test, not a positioning test",
                file=file,
                place=f"line {number}",
                expected=ACCEPTED_FORMS,
                found=f"columns {', '.join(names[:8])}",
                hint=(
                    "list it under `circles:` of the job, or evaluate it with `compwright evaluate`"
                ),
            )
        )
    if "time" in names and {"air_c", "material_c"} & set(names):
        raise InputError(
            Fault(
                message="the file contains a record of the environment, not a positioning test",
                file=file,
                place=f"line {number}",
                expected=ACCEPTED_FORMS,
                found=f"columns {', '.join(names[:8])}",
                hint="give it as `environment` in the job (docs/job-file.md#environment)",
            )
        )
    if names and not count and re.match(r"(elapsed|date)?[ _]?time|minutes?\b", names[0]):
        raise InputError(
            Fault(
                message="the columns of a stand-still test (axis at rest) have other names",
                file=file,
                place=f"line {number}",
                expected="time_min (minutes from the first reading) and deviation_um",
                found=f"columns {', '.join(names[:8])}",
                hint=(
                    "for a stand-still test, rename the columns to time_min and deviation_um (of a "
                    "rotary axis: deviation_arcsec); describe any other table with "
                    f"{by_profile(file)}"
                ),
            )
        )
    if _is_status_pro(names):
        raise InputError(
            Fault(
                message=(
                    "the file is a table of the Status Pro software, whose columns are not "
                    "documented: Delta may be the step between positions, and AX1 and AX3 may be "
                    "measured across the axis"
                ),
                file=file,
                place=f"line {number}",
                expected="a mapping profile that states the column of the deviations",
                found=f"columns {', '.join(names[:8])}",
                hint=f"describe the columns with {by_profile(file)}",
            )
        )
    if not count and names:
        raise _unknown_form(number, first, names, file)


def _is_status_pro(names: Sequence[str]) -> bool:
    known = {name.partition(" [")[0] for name in names if "[" in name}
    return "delta" in known and len(known & {"ax1", "ax2", "ax3"}) >= 2


def _unknown_form(number: int, first: str, names: Sequence[str], file: str) -> InputError:
    start = first.strip()
    if start.startswith("<"):
        if "TEST_DOCUMENT" in first or "<?xml" in first:
            return InputError(
                Fault(
                    message=(
                        "the file is not a positioning file (XML such as a ballbar's .b5r "
                        "contains a circular test)"
                    ),
                    file=file,
                    place=f"line {number}",
                    expected=ACCEPTED_FORMS,
                    found=shown(start),
                    hint="list a ballbar file under `circles:` of the job",
                )
            )
        what = "XML or HTML"
    elif names == ["point", "position", "value", "unit"]:
        what = "a typed-entry sheet of a compensation table"
    elif in_inches(names):
        return InputError(
            Fault(
                message="the file is in inches, which compwright does not read",
                file=file,
                place=f"line {number}",
                expected=INCHES,
                found=shown(in_inches(names)),
                hint="export the file again in mm",
            )
        )
    elif start.startswith(("{", "[")):
        what = "JSON, or sections in brackets"
    elif all(name in {"", "+", "-"} or is_number(name) for name in names):
        what = f"a row of numbers where the header row should be: {shown(first)}"
    else:
        what = f"{shown(first)} as the first row"
        if len(names) == 1 and len(start.split()) > 1:
            what += f", without {', '.join(list(DELIMITERS.values())[:-1])} or tab"
    return InputError(
        Fault(
            message="the file is not a positioning file",
            file=file,
            place=f"line {number}",
            expected=ACCEPTED_FORMS,
            found=what,
            hint=f"describe a table of another program with {by_profile(file)}",
        )
    )
