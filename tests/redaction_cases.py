"""One secret at one place of one sample, by a number: what becomes of it in the copy.

Used by the tests for some cases and by `benchmarks/bench_redaction.py` for many.
"""

from __future__ import annotations

import random
import re
import traceback
from collections.abc import Mapping

from compwright.controls.control_copies import control_copies
from compwright.formats.definitions import definitions_from
from compwright.foundations.errors import CompwrightError
from compwright.foundations.redaction import Cuts, Names
from compwright.foundations.session import Session
from compwright.foundations.storage import definition_files
from compwright.records.correction import ControlFile
from compwright.workflow.redact.redacted_measurements import measurement_copy
from redaction_samples import BALLBAR, CONTROLS, FOREIGN, PLAIN

SECRETS = ("Muehlbauer", "Mühlbauer GmbH", "SN7731905", "77319052", "Halle Nord 7731905")
_FOUND = re.compile(r"m(?:ue|ü)hlbauer|gmbh|7731905|halle nord", re.IGNORECASE)
_PIECE = re.compile(r"[^\W_]+|[^\w\s]")


def samples() -> dict[str, Mapping[str, str]]:
    """Every sample without a secret: a set of files, by the kind that it is of."""
    bare = {"{S}": "", "{W}": "", "{T}": ""}

    def clean(text: str) -> str:
        for mark, nothing in bare.items():
            text = text.replace(mark, nothing)
        return text

    texts: dict[str, Mapping[str, str]] = {
        f"measurement {name}": {f"{name}.csv": clean(text)} for name, text in PLAIN.items()
    }
    texts["measurement foreign"] = {"foreign.csv": clean(FOREIGN)}
    texts["measurement b5r"] = {"b.b5r": re.sub(r"<[?!/]?[\s>][^<]*", "", clean(BALLBAR))}
    texts |= {
        f"control {name}": {file: clean(text) for file, text in files.items()}
        for name, files in CONTROLS.items()
    }
    for name, definition in definitions_from(definition_files(Session())).items():
        texts[f"control {name}"] = definition.sample_files
    return texts


def with_secret(text: str, secret: str, dice: random.Random) -> str:
    """Return a text with the secret at a place that the dice choose."""
    lines = text.split("\n")
    at = dice.randrange(len(lines))
    line = lines[at]
    pieces = list(_PIECE.finditer(line))
    if secret.isdigit():  # a number among numbers is one of them
        secret = f"{dice.choice(['tel ', 'no. ', 'order '])}{secret}"
    how = dice.randrange(6)
    if how == 0 or not pieces:
        lines.insert(at, dice.choice(["", "# ", "; ", "(", "<!-- ", "/* "]) + secret)
    elif how == 1:
        lines[at] = f"{line}{dice.choice([' ', ' ', ';', ' ; ', ' # ', ' ('])}{secret}"
    elif how == 2:
        lines[at] = f"{secret}{dice.choice([' ', ': ', ' = '])}{line}"
    else:
        piece = dice.choice(pieces)
        new = (secret, f"{piece[0]}{secret}", f"{secret}{piece[0]}")[how - 3]
        lines[at] = line[: piece.start()] + new + line[piece.end() :]
    return "\n".join(lines)


def copies(kind: str, files: Mapping[str, bytes]) -> list[bytes]:
    """Return the copies that are made of a set of files; none where all are refused."""
    names = Names()
    if kind.startswith("measurement"):
        ((name, content),) = files.items()
        made = measurement_copy(content, name, Cuts(names), None)
        return [made.content, made.profile.encode()]
    given = [ControlFile(name, content) for name, content in files.items()]
    found = control_copies(Session(), given, {name: Cuts(names) for name in files}, None)
    return [copy.content for copy in found.made.values()]


def case(sets: Mapping[str, Mapping[str, str]], number: int) -> tuple[str, str]:
    """Return the outcome of one case, and the case itself where it went wrong."""
    dice = random.Random(number)  # noqa: S311 - places in a text
    kind = dice.choice(sorted(sets))
    texts = dict(sets[kind])
    name = dice.choice(sorted(texts))
    secret = dice.choice(SECRETS)
    texts[name] = with_secret(texts[name], secret, dice)
    encoding = dice.choice(["utf-8", "utf-8", "latin-1"])
    files = {name: text.encode(encoding, "replace") for name, text in texts.items()}
    try:
        made = copies(kind, files)
    except CompwrightError:
        return "refused", ""
    except Exception:  # noqa: BLE001 - every other one is counted
        return "exception", f"{number} {kind} {secret}\n{traceback.format_exc()}"
    for content in made:
        for form in ("utf-8", "latin-1"):
            found = _FOUND.search(content.decode(form, "replace"))
            if found:
                text = content.decode(form, "replace")
                line = next((line for line in text.splitlines() if _FOUND.search(line)), "")
                return "leak", f"{number} {kind} {name}: {line[:160]}"
    return ("clean" if made else "refused"), ""
