"""Read the definition of a control from YAML. All faults are reported at once, with file, line and
key path.

A missing key is an error and never replaced by a default. An unknown key is an error too. The keys
are explained in docs/definition-keys.md.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cache

from compwright.formats.definition.consistency import contradictions
from compwright.formats.definition.forms import definition_validator
from compwright.formats.definition.inheritance import (
    BASE_ENDING,
    NOTHING_ELSE,
    DefinitionText,
    Find,
    found_in,
    merged,
    texts_of,
)
from compwright.formats.definition.options import Required
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.vocabulary import SCHEMA_VERSION
from compwright.formats.families.shapes import RULES
from compwright.foundations.errors import Fault, InputError, collect, raise_all
from compwright.foundations.validation import checked
from compwright.records.plan import Texts


def load_definition(
    content: bytes,
    file: str,
    find: Find = NOTHING_ELSE,
    *,
    own: bool = False,
) -> Definition:
    """Return the definition in a YAML file, merged with the definition that it ``extends``, which
    ``find`` looks up. ``own``: the file belongs to the user, not to compwright.

    ``file``: the file name for messages. Raises InputError with every fault: not YAML, newer
    schema, missing or unknown key, wrong type, a value outside its closed list, parts that do not
    fit together. Each fault names the file that contains it.
    """
    return definition_of(texts_of(content, file, find), own=own)


@cache  # by content: a job is checked before it is done, and reading a definition takes a while
def definition_of(texts: Texts, *, own: bool = False) -> Definition:
    """Return the definition made of ``texts``: first its own YAML text, then the texts that it
    extends. ``own``: the files belong to the user, not to compwright.

    Raises the same errors as `load_definition`.
    """
    return definition_in(merged(texts), texts if own else ())


def definition_in(text: DefinitionText, own: Texts = ()) -> Definition:
    """Build a definition from merged YAML data. ``own``: its YAML texts if they belong to the user,
    else nothing. Raises InputError with every fault of the data.
    """
    _check_version(text)
    quantities = tuple(name for rules in RULES.values() for name in rules.quantities)
    read, wrong = checked(definition_validator(quantities), text.data)
    faults = [
        text.fault(
            each.path, each.message, expected=each.expected, found=each.found, hint=each.hint
        )
        for each in wrong
    ]
    raise_all(InputError, faults)
    sections = {
        name: Required(getattr(read, name), section=name, file=text.file)
        for name in ("texts", "statements", "bindings", "options")
    }
    definition: Definition = replace(read, file=text.file, text=text, own=own, **sections)
    raise_all(InputError, contradictions(definition, RULES))
    return definition


def definitions_from(files: Iterable[tuple[str, bytes]]) -> dict[str, Definition]:
    """Return the definitions in ``files`` (name, bytes) by id, except definitions that only serve
    as a base for others.

    Raises InputError with the faults of all files, and if two files give the same id.
    """
    given = dict(files)
    found: dict[str, Definition] = {}
    errors: list[InputError] = []
    for name, content in given.items():
        if name.endswith(BASE_ENDING):
            continue
        try:
            definition = load_definition(content, name, found_in(given))
        except InputError as error:
            errors.append(error)
            continue
        if definition.id in found:
            errors.append(InputError(duplicate_id(definition, found[definition.id].file)))
        found[definition.id] = definition
    raise_all(InputError, collect(errors))
    return found


def duplicate_id(definition: Definition, first: str) -> Fault:
    """Return the fault that a definition has the same id as the one in the file ``first``."""
    found = f"{definition.id} in {first}"
    return definition.text.fault(("id",), "the id is given twice", found=found)


def _check_version(text: DefinitionText) -> None:
    version = text.data.get("compwright_format") if isinstance(text.data, dict) else None
    if isinstance(version, int) and not isinstance(version, bool) and version != SCHEMA_VERSION:
        message = (
            "is written for a newer version of compwright"
            if version > SCHEMA_VERSION
            else "is for an older form of definitions; docs/definition-keys.md lists its keys"
        )
        expected, found = str(SCHEMA_VERSION), str(version)
        path = ("compwright_format",)
        raise InputError(text.fault(path, message, expected=expected, found=found))
