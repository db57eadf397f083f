"""Lines of tables and parameter lists without private names: columns, their descriptions, rows, and
parameters by number.
"""

from __future__ import annotations

from typing import Final

from compwright.formats.definition.kept_lines import AXIS, NUMBER, KeptLines

_COLUMN: Final = r"(?:AXISPOS|BACKLASH|ACTIVE|[A-Z]{1,2}[0-9]?|[0-9]{1,2}=F\([A-Z]?[0-9]?\))"

KEPT: Final = KeptLines(
    whole=(
        r"\[END\]",
        rf"NR(?:\s+(?:{_COLUMN}|[0-9]{{1,2}}))+",
        rf"[0-9]{{1,4}}(?:\s+(?:\*|{NUMBER}|[A-Z]{{1,2}}[0-9]?\s*\.COM))*",
        (
            rf"(?:BEGIN|END)\s+(?:{AXIS}|CONFIG)\s*\.(?:COM|CMA)(?:\s+(?:MM|INCH))?"
            rf"(?:\s+DATUM:\s*{NUMBER})?(?:\s+DIST:\s*{NUMBER})?"
            r"(?:\s+Version:\s*'Update:[0-9.]+(?:\s+Date:[0-9-]+)?')?"
            r"(?:\s+U)?"
        ),
        (
            r"#STRUCT(?:BEGIN|END)|TableDescription\s*\(|columns\s*:=\s*\[|CfgColumnDescription\s*\("
            r"|[)\]]\s*,?"
        ),
        rf"NAME\s*=\s*{_COLUMN}|key\s*:=\s*\"(?:NR|{_COLUMN})\"\s*,?|TYPE\s*=\s*[A-Z]",
        rf"(?:WIDTH|DEC|POS)\s*=\s*{NUMBER}",
        r"primaryKey\s*:=\s*\"(?:NR)?\"\s*,?",
        (
            r"(?:width|initial|minimum|maximum|decimals|unit|unitIsInch|readOnly|unique)\s*:=\s*"
            rf"\"?(?:{NUMBER}|mm|inch|INT|LENGTH|ANGLE|TRUE|FALSE)?\"?\s*,?"
        ),
        rf"MP[0-9]{{1,5}}(?:\.[0-9]{{1,3}}){{0,2}}\s*[:=]?\s*[%$]?{NUMBER}",
    ),
    naming=(r"END\s+\S+?\s*\.(?:COM|CMA)|[0-9]{1,4}(?:\s+(?:[A-Z][A-Z0-9_-]*(?:\s*\.COM)?|\*))+"),
    first=r"\s*BEGIN\s+\S+?\s*\.(?:COM|CMA)\b",
)
