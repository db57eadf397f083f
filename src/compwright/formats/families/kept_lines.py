"""Lines of a control's files that hold addresses, numbers and keywords and nothing else, by the
shape of its tables: whatever compwright reads of them, nobody is named in them.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from typing import Final

from compwright.formats.definition.schema import Definition

#: What a user exports in the place of an archive in a container.
STATE_TEXTS: Final = "machine data of all axes, AX_EEC_INI, NC_CEC_INI"
_NUMBER: Final = r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:EX?[+-]?[0-9]{1,3})?"
#: What may stand where a control names an axis.
_AXIS: Final = r"(?:[A-Za-z]{1,2}|AX|M[AXSC]_?[A-Z]?|CA_?[A-Z]|SP)[0-9]{0,2}"
_VALUE: Final = (
    rf"(?:{_NUMBER}|'[HB][0-9A-F]+'|TRUE|FALSE|n/a|\"(?:{_AXIS})?\"|\((?:{_AXIS}|[0-9]+)?\))"
)
_INDEX: Final = rf"\[\s*(?:{_AXIS}|[0-9]+)(?:\s*,\s*(?:{_AXIS}|[0-9]+))*\s*\]"
#: What a control calls its data: capitals, and no number that is long enough for a serial one.
_ADDRESS: Final = r"(?-i:(?![A-Z0-9_]*[0-9]{5})[A-Z0-9_]+)"
_COLUMN: Final = r"(?:AXISPOS|BACKLASH|ACTIVE|[A-Z]{1,2}[0-9]?|[0-9]{1,2}=F\([A-Z]?[0-9]?\))"
#: The sections and keys of settings of a machine that stand beside its compensation.
_SECTIONS: Final = (
    r"EMC|DISPLAY|FILTER|RS274NGC|EMCMOT|TASK|HAL|HALUI|APPLICATIONS|TRAJ|KINS|EMCIO|EMCSERVER"
    r"|(?:JOINT|SPINDLE)_[0-9]{1,2}|AXIS_[A-Z0-9]"
)
_SETTINGS: Final = (
    r"(?:MIN|MAX|HOME|STEPGEN|DEFAULT|FERROR|SCALE|INPUT_SCALE|OUTPUT_SCALE|ENCODER_SCALE|JOINTS"
    r"|SERVO|BASE|CYCLE|STEP|STEPLEN|STEPSPACE|DIRSETUP|DIRHOLD|DEADBAND|BIAS|FF[0-3]|[PID]"
    r"|BACKLASH|COMP_FILE_TYPE|LOCKING|VOLATILE|LATCH|INCREMENTS|SPINDLES|POSITION|NO_FORCE)"
)

#: Whole lines without comments, case ignored.
_LINES: Final[Mapping[str, tuple[str, ...]]] = {
    "section_increments": (
        "%",
        rf"N[0-9]{{4,5}}(?:Q[0-9])?(?:(?:[ALSTKDG][0-9]{{1,3}})?[PMIR]{_NUMBER})+",
        r"(?:N[0-9]{1,5})?G1[01](?:L5[0-2])?;?",
    ),
    "values_by_index": (
        (
            rf"(?:N[0-9]+\s+)?\$[MSA][NACD]S?_{_ADDRESS}(?:{_INDEX})?\s*(?:=|\s)\s*{_VALUE}"
            r"(?:\s+'[0-9A-F]{4})?"
        ),
        r"CHANDATA\([0-9]{1,2}\)",
        r"METRIC|INCH|M17|M30|M0?2|M0|NEWCONF|STOPRE",
        (
            r"%_N_(?:N?C?_?(?:AX[0-9]*|NC|CH[0-9]*|COMPLETE|INITIAL|TOA[0-9]*|UFR|EEC|CEC|QEC|TEA|SEA"
            r"|INI|MPF|SPF|ACT|DIR)_?)+"
        ),
    ),
    "rows_by_position": (
        rf"\[(?:{_SECTIONS})\]",
        rf"{_SETTINGS}(?:_[A-Z0-9_]+)?\s*=\s*{_NUMBER}(?:\s+{_NUMBER})*",
    ),
    "user_tables": (
        r"\[END\]",
        rf"NR(?:\s+(?:{_COLUMN}|[0-9]{{1,2}}))+",
        rf"[0-9]{{1,4}}(?:\s+(?:\*|{_NUMBER}|[A-Z]{{1,2}}[0-9]?\s*\.COM))*",
        (
            rf"(?:BEGIN|END)\s+(?:{_AXIS}|CONFIG)\s*\.(?:COM|CMA)(?:\s+(?:MM|INCH))?"
            rf"(?:\s+DATUM:\s*{_NUMBER})?(?:\s+DIST:\s*{_NUMBER})?"
            r"(?:\s+Version:\s*'Update:[0-9.]+(?:\s+Date:[0-9-]+)?')?"
            r"(?:\s+U)?"
        ),
        (
            r"#STRUCT(?:BEGIN|END)|TableDescription\s*\(|columns\s*:=\s*\[|CfgColumnDescription\s*\("
            r"|[)\]]\s*,?"
        ),
        rf"NAME\s*=\s*{_COLUMN}|key\s*:=\s*\"(?:NR|{_COLUMN})\"\s*,?|TYPE\s*=\s*[A-Z]",
        rf"(?:WIDTH|DEC|POS)\s*=\s*{_NUMBER}",
        r"primaryKey\s*:=\s*\"(?:NR)?\"\s*,?",
        (
            r"(?:width|initial|minimum|maximum|decimals|unit|unitIsInch|readOnly|unique)\s*:=\s*"
            rf"\"?(?:{_NUMBER}|mm|inch|INT|LENGTH|ANGLE|TRUE|FALSE)?\"?\s*,?"
        ),
        rf"MP[0-9]{{1,5}}(?:\.[0-9]{{1,3}}){{0,2}}\s*[:=]?\s*[%$]?{_NUMBER}",
    ),
    "lists_by_axis": (rf"zahl_(?:kw|mp)\s+{_NUMBER}",),
    "wrapped_counts": (
        rf"(?:I[0-9]{{1,5}}\s*=\s*(?:\$[0-9A-F]+|{_NUMBER})\s*)+",
        r"#[0-9]{1,2}\s*DEF(?:INE)?\s+(?:BL|T)?COMP\s+[0-9#D,\s]+",
        r"OPEN\s+[A-Z]*|CLOSE|CLEAR|DELETE\s+(?:BL|T)?COMP|(?:#[0-9]{1,2}\s*)?(?:K|A|J/|\$\$\$)",
    ),
}

#: Whole lines of numbers, marks and names of tables and axes.
_NAMING: Final[Mapping[str, str]] = {
    "user_tables": (
        r"END\s+\S+?\s*\.(?:COM|CMA)|[0-9]{1,4}(?:\s+(?:[A-Z][A-Z0-9_-]*(?:\s*\.COM)?|\*))+"
    ),
}

#: First lines that tell of a shape by themselves, whatever else stands on them.
_FIRST: Final[Mapping[str, re.Pattern[str]]] = {
    "user_tables": re.compile(r"\s*BEGIN\s+\S+?\s*\.(?:COM|CMA)\b", re.IGNORECASE),
}


def begins(definition: Definition, content: bytes) -> bool:
    """Return whether the first line of a file tells that it is of this control's shape."""
    first = _FIRST.get(definition.layout.shape)
    return first is not None and first.match(content[:1000].decode("latin-1")) is not None


@cache
def kept_lines(definition: Definition) -> re.Pattern[str]:
    """Return what matches a whole line that may stay as it is, blanks around it left out."""
    lines = _LINES[definition.layout.shape]
    return re.compile("|".join(f"(?:{line})" for line in lines), re.IGNORECASE | re.ASCII)


@cache
def naming_lines(definition: Definition) -> re.Pattern[str]:
    """Return what matches a whole line that holds nothing but numbers, marks of the shape, and
    names, which are somebody's where they are none of an axis.
    """
    return re.compile(_NAMING.get(definition.layout.shape, r"(?!)"), re.IGNORECASE | re.ASCII)
