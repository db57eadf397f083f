"""A commissioning card, followed sentence by sentence on the judge's own SINUMERIK."""

from __future__ import annotations

import re
from collections.abc import Mapping

from harm_sinumerik import Control

_STEP = re.compile(
    r"(?P<file>\b[A-Z0-9_]+\.(?:INI|MPF|SPF)\b)"
    r"|(?P<name>\$[A-Z]{2}_[A-Z_0-9]+\[[^\]]+\])\s*=\s*(?P<value>-?[\d.]+\d|\d)",
)


def for_each_axis(step: str) -> str:
    """Repeat the sentences of a step for each row of its list, with what the row says of ‹word›."""
    lines = step.split("\n")
    table = [
        [cell.strip() for cell in line.strip().strip("|").split("|")]
        for line in lines
        if line.strip().startswith("|") and "---" not in line
    ]
    if len(table) < 2 or "‹" not in step:
        return step
    said = [line for line in lines if not line.strip().startswith("|")]
    repeated: list[str] = []
    for line in said:
        rows = table[1:] if "‹" in line else table[1:2]
        for row in rows:
            filled = line
            for name, cell in zip(table[0], row, strict=True):
                filled = filled.replace(f"‹{name}›", cell)
            repeated.append(filled)
    return "\n".join(repeated)


def follow(card: str, files: Mapping[str, str], control: Control) -> list[str]:
    """Do what the card's steps say, in their order; give the files that it names and nobody has.

    "or by hand" names the same values a second time: whoever loads the file leaves them. A sentence
    about what must be reserved, looked at, or is only mentioned assigns nothing: an assignment counts
    in sentences that begin with Set or set, or name several switches to set.
    """
    missing: list[str] = []
    loaded: set[str] = set()
    found_steps = re.search(r"^## Steps$(.*?)^## ", card, re.MULTILINE | re.DOTALL)
    steps = (found_steps[1] if found_steps else card).split("\n- [ ] **")
    too = re.search(r"Axis \w+ leads a gantry: do every step for the synchronised axis (\w+)", card)
    sentences = [
        sentence
        for step in steps
        for sentence in re.split(r"(?<=[.;:])\s+(?=[A-Z])|\n", for_each_axis(step))
    ]
    for sentence in sentences:
        part = sentence.split("or by hand")[0]
        setting = re.search(r"\b[Ss]et\b", part) is not None
        for found in _STEP.finditer(part):
            if found["file"] and re.search(r"\b[Ll]oad\b", part):
                if found["file"] in loaded:
                    continue
                loaded.add(found["file"])
                if found["file"] in files:
                    control.load(files[found["file"]])
                else:
                    missing.append(found["file"])
            elif found["name"] and setting:
                control.write(found["name"], float(found["value"]))
                if too and too[1] not in found["name"]:
                    twin = re.sub(r"\w+\]$", too[1] + "]", found["name"])
                    control.write(twin, float(found["value"]))
        if "NEW CONF" in part or "power on" in part or "reset" in part:
            control.reset()
    control.reset()
    return missing
