"""Write the table of docs/findings.md anew from the catalogue of sentences.

``python benchmarks/findings_page.py``: codes, what each means for a decision, and its sentences
come from the source; severities stay as the page has them. `tests/house/test_words.py` compares.
"""

from __future__ import annotations

import re
import string
import sys
from collections.abc import Iterator
from pathlib import Path

from compwright.foundations.findings import DOUBTS, REMARKS, RESULTS
from compwright.words.sentences import catalogue, parts

PAGE = Path(__file__).resolve().parents[1] / "docs" / "findings.md"
HEAD = "| code | severity | doubt | sentence |\n|---|---|---|---|\n"
#: Families of codes in the order of the page.
FAMILIES = "RTCJSEDFXPV"
ROW = re.compile(r"^\| `(CW-[A-Z]+\d+)` \| ([^|]*) \| .*$\n?", re.MULTILINE)


def page(text: str) -> str:
    """Return the page with its table made anew; a code that is new gets ``?`` as severity."""
    severities = dict(ROW.findall(text))
    before, _, rest = text.partition("| code | severity |")
    after = ROW.sub("", rest.split("|---|---|---|---|\n", 1)[1])
    codes = sorted(
        DOUBTS | RESULTS | REMARKS, key=lambda code: ("RTCJSEDFXPV".index(code[3]), code)
    )
    return (
        f"{before}{HEAD}{''.join(_row(code, severities.get(code, '?')) for code in codes)}{after}"
    )


def _row(code: str, severity: str) -> str:
    doubt = "yes" if code in DOUBTS else "first" if code in RESULTS else "no"
    return f"| `{code}` | {severity} | {doubt} | {'<br>'.join(_sentences(code))} |\n"


def _sentences(code: str) -> Iterator[str]:
    for name, template in catalogue("en").items():
        if name.partition(".")[0] == code:
            variant = name.partition(".")[2]
            shown = _shown(template).replace("|", "\\|")
            yield f"`{variant}`: {shown}" if variant else shown


def _shown(template: str) -> str:
    """Return a template as people read it: values in braces, alternatives in brackets."""
    return "".join(
        text + ("" if field is None else _field(field, form or ""))
        for text, field, form, _ in string.Formatter().parse(template)
    )


def _field(field: str, form: str) -> str:
    how, *texts = parts(form)
    if how == "choose":
        texts = [text.partition("=")[2] for text in texts]
    if how not in ("if", "choose", "plural"):
        return f"{{{field}}}"
    return f"[{' / '.join(_shown(text) for text in texts)}]"


if __name__ == "__main__":
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    sys.stdout.write(f"{PAGE}\n")
