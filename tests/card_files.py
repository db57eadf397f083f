"""The files that a commissioning card names: each is there, and each written one is in a step."""

from __future__ import annotations

import re
from pathlib import Path

_FILE = re.compile(r"(?<![\w/.-])[\w-]+\.(?:INI|TXT|NC|MPF|SPF|COM|CMA|comp|ini|pmc|lis|csv)\b")


def wrong_files(results: Path) -> list[str]:
    """Give what is wrong with the files that the steps of the card in a folder of results name."""
    card = (results / "card" / "card.md").read_text(encoding="utf-8").replace("\\", "")
    begin = card.index("## Steps")
    steps = card[begin : card.index("\n## ", begin)]
    tables = [path for path in (results / "tables").rglob("*") if path.is_file()]
    there = {path.name for path in results.rglob("*") if path.is_file()}
    named = set(_FILE.findall(steps))
    whole = any(f"tables/{path.parent.name}" in steps for path in tables)
    idle = set() if whole else {path.name for path in tables} - named
    return [
        *(f"{name} is named and not there" for name in sorted(named - there)),
        *(f"{name} is in no step" for name in sorted(idle)),
    ]
