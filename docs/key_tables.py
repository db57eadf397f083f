"""Reference pages of keys: those of the JSON documents (`json-keys.yaml`) and of the definitions of
controls (`definition-keys.yaml`, with the words and predicates of the code).
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, get_args

from compwright.formats.definition import vocabulary as words
from compwright.foundations.yaml_reader import read_yaml

DOCS = Path(__file__).parent
JSON_KEYS = DOCS / "json-keys.yaml"
DEFINITION_KEYS = DOCS / "definition-keys.yaml"
ABOUT_JSON = """Made from `json-keys.yaml` by `make pages`; a test compares it with the source.

Every document has the key `schema`: `compwright/NAME/1`. Keys are added, never renamed. `NAME`
stands for a name of the job, `A` for any parameter, `[]` for each entry of a list. There is no NaN:
what does not exist is null. Signs: deviation = measured minus target; correction = what the
control adds to the command."""
ABOUT_DEFINITIONS = """Made from `definition-keys.yaml` and the code by `make pages`; a test
compares it with the schema.

All keys have to be there but those marked optional; `null` says "there is none". How to write a
definition: [formats.md](formats.md)."""
#: Names that a definition takes from closed lists.
WORDS: dict[str, object] = {
    "Lengths and angles": words.MEASURES,
    "Choices": words.CHOICES,
    "Taken as they stand": words.PLAIN,
    "Types of fields": words.FieldType,
    "Signs": words.Sign,
    "Limits": words.Predicate,
    "Types of options": words.OptionType,
    "Verdicts under `look_at`": words.LOOKED_AT,
}


def sections(path: Path) -> Mapping[str, Any]:
    """Return the sections of a table of keys: `about` and `keys` of each."""
    return read_yaml(path.read_bytes(), path.name).data


def json_page() -> str:
    """Return the keys of every JSON document."""
    parts = ["# Keys of the JSON documents", ABOUT_JSON]
    for name, section in sections(JSON_KEYS).items():
        title = "In several documents" if name == "shared" else f"`compwright/{name}/1`"
        parts += [f"## {title}", section["about"], _rows(section["keys"])]
    return "\n\n".join(parts) + "\n"


def definition_page() -> str:
    """Return the keys of a definition, and the closed lists of names that it may use."""
    parts = ["# Keys of a definition", ABOUT_DEFINITIONS]
    for name, section in sections(DEFINITION_KEYS).items():
        parts += [f"## {name}", section["about"], _rows(section["keys"])]
    parts.append("## Closed lists")
    for name, names in WORDS.items():
        each = names if isinstance(names, tuple) else get_args(names)
        parts.append(f"**{name}:** " + ", ".join(f"`{word}`" for word in each))
    return "\n\n".join(parts) + "\n"


def _rows(keys: Mapping[str, str]) -> str:
    rows = [f"| `{key}` | {meaning.replace('|', chr(92) + '|')} |" for key, meaning in keys.items()]
    return "\n".join(["| key | meaning |", "|---|---|", *rows])
