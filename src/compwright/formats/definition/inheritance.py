"""Merge a definition that states only differences with the definition that it extends; the result
is checked later.

The rules are in docs/formats.md. Mappings are merged key by key. Everything else, lists included,
is replaced as a whole. ``without`` removes keys of the extended definition before the merge.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, reduce
from typing import Any

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.key_faults import KeyPath, key_path_text, nearest, usual_hint
from compwright.foundations.yaml_reader import read_yaml
from compwright.records.plan import Texts

EXTENDS = "extends"
WITHOUT = "without"
#: What ships under such a name is extended by others and is no control by itself.
BASE_ENDING = ".base.yaml"

#: From the word after ``extends`` to the file that it means; None where there is none.
Find = Callable[[str], tuple[str, bytes] | None]


@dataclass(frozen=True, slots=True)
class DefinitionText:
    """The YAML data of a definition, merged with the definitions that it extends, with the file and
    line (from 1) of each key.
    """

    file: str
    data: Any
    places: Mapping[KeyPath, tuple[str, int]]

    def fault(
        self,
        path: KeyPath,
        message: str,
        *,
        expected: str = "",
        found: str = "",
        place: str = "",
        hint: str = "",
    ) -> Fault:
        """Return a fault at a key of the definition, with file and line.

        The line is that of the key. If the key is missing, it is the line of the nearest existing
        key that should contain it. ``place``: text that is shown instead of the key path.
        """
        probe = path
        while probe and probe not in self.places:
            probe = probe[:-1]
        file, line = self.places.get(probe, (self.file, 0))
        name = place or key_path_text(path)
        where = ", ".join(part for part in (f"line {line}" if line else "", name) if part)
        return Fault(
            message=message,
            file=file,
            place=where,
            expected=expected,
            found=found,
            hint=hint or usual_hint(path, message, expected, found),
        )


def found_in(files: Mapping[str, bytes]) -> Find:
    """Return a function that looks up a definition in ``files`` by its file name or by its id."""
    return lambda name: next(
        ((each, files[each]) for each in (name, f"{name}.yaml") if each in files), None
    )


#: A definition that stands for itself.
NOTHING_ELSE: Find = found_in({})


def texts_of(content: bytes, file: str, find: Find) -> Texts:
    """Return a definition's YAML text, then the texts of all definitions that it extends. ``find``:
    a function that returns the file with a name or id.

    Raises InputError for invalid YAML, for a name that ``find`` does not know, and for a text that
    extends itself.
    """
    texts = [(file, content)]
    while True:
        text = _text(*texts[-1])
        if not isinstance(text.data, dict) or EXTENDS not in text.data:
            return tuple(texts)
        name = text.data[EXTENDS]
        found = find(name) if isinstance(name, str) else None
        if found is None:
            message = "extends a definition that is not there"
            expected = "a file next to it, or the id or file name of one that ships"
            raise InputError(
                text.fault((EXTENDS,), message, expected=expected, found=str(name)[:60])
            )
        if found in texts:
            raise InputError(text.fault((EXTENDS,), "extends itself", found=name))
        texts.append(found)


def merged(texts: Texts) -> DefinitionText:
    """Merge a definition with the definitions that it extends. Raises InputError for a key in
    ``without`` that they do not have.
    """
    return reduce(_over, [_text(*each) for each in reversed(texts)])


@cache  # by content: a base is read once for all that extend it
def _text(file: str, content: bytes) -> DefinitionText:
    document = read_yaml(content, file)
    return DefinitionText(
        file, document.data, {path: (file, line) for path, line in document.lines.items()}
    )


def _over(under: DefinitionText, over: DefinitionText) -> DefinitionText:
    """Return the data ``under`` with the keys of ``over`` added or replaced."""
    gone = _omitted(under, over)
    own = {key: value for key, value in over.data.items() if key not in (EXTENDS, WITHOUT)}
    replaced = set(gone)
    data = _merge(_less(under.data, gone, ()), own, (), replaced)
    kept = {
        path: place
        for path, place in under.places.items()
        if not any(path[:size] in replaced for size in range(1, len(path) + 1))
    }
    own_places = {path: place for path, place in over.places.items() if path[0] in own}
    return DefinitionText(over.file, data, {**kept, **own_places})


def _omitted(under: DefinitionText, over: DefinitionText) -> set[KeyPath]:
    """Return the key paths that ``over`` removes from ``under`` by ``without``. Raises InputError
    for a path that ``under`` does not have.
    """
    listed = over.data.get(WITHOUT, [])
    if not isinstance(listed, list):
        raise InputError(
            over.fault((WITHOUT,), "has the wrong form", expected="a list of key paths")
        )
    names = {
        key_path_text(path): path
        for path in under.places
        if not any(isinstance(part, int) for part in path)
    }
    faults = [
        over.fault(
            (WITHOUT, index),
            f"{under.file} has no such key",
            expected=nearest(str(name), names) or "a key path (a.b)",
            found=str(name)[:60],
        )
        for index, name in enumerate(listed)
        if str(name) not in names
    ]
    if faults:
        raise InputError(*faults)
    return {names[name] for name in listed}


def _less(data: Any, gone: set[KeyPath], path: KeyPath) -> Any:
    if not gone or not isinstance(data, dict):
        return data
    return {
        key: _less(value, gone, (*path, key))
        for key, value in data.items()
        if (*path, key) not in gone
    }


def _merge(under: Any, over: Any, path: KeyPath, replaced: set[KeyPath]) -> Any:
    if not isinstance(under, dict) or not isinstance(over, dict):
        replaced.add(path)
        return over
    return {
        **under,
        **{
            key: _merge(under[key], value, (*path, key), replaced) if key in under else value
            for key, value in over.items()
        },
    }
