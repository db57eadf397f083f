"""Write a document as JSON text: the same bytes for equal documents, no NaN and no minus zero."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from typing import Any, Final

from compwright.foundations.errors import Fault, InputError
from compwright.foundations.utf8 import encoded

_PLAIN: Final = json.JSONEncoder(allow_nan=False, ensure_ascii=False).encode
#: Control characters that JSON allows as they are, characters that turn the direction of writing
#: and those that cannot be seen: a terminal would obey or hide them (``--json -``).
_UNSEEN: Final = re.compile(
    "[\x7f-\x9f\u00ad\u061c\u180e\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb]"
)

#: The next step after a file that compwright wrote and that was changed.
AS_WRITTEN: Final = "give the file as compwright wrote it, or make it again with the same command"


def to_json(document: Mapping[str, Any]) -> str:
    """Return ``document`` as JSON text with an indentation of two blanks and a final newline.

    Keys keep their order. Control characters, and characters that UTF-8 cannot encode, are written
    as escapes; a file name can contain such characters. Raises ValueError for NaN or infinity,
    because an unknown value must be null.
    """
    text = encoded("".join(_pieces(document, "\n"))).decode("utf-8")
    return _UNSEEN.sub(lambda found: f"\\u{ord(found[0]):04x}", text) + "\n"


def _pieces(value: Any, line: str) -> Iterator[str]:
    """Yield the JSON text of a value piece by piece. ``line``: line break and indentation.

    With an indentation, the standard library writes each number separately, which is slow. So a row
    of numbers is written by its fast encoder without indentation, and the line breaks are inserted
    afterwards.
    """
    inside = f"{line}  "
    if isinstance(value, dict) and value:
        before = "{" + inside
        for key, one in value.items():
            yield f"{before}{_PLAIN(str(key))}: "
            yield from _pieces(one, inside)
            before = f",{inside}"
        yield line + "}"
    elif isinstance(value, list | tuple) and value:
        if set(map(type, value)) <= {float, type(None)}:
            row = _PLAIN([None if one is None else one + 0.0 for one in value])
            yield f"[{inside}{row[1:-1].replace(', ', f',{inside}')}{line}]"
            return
        before = f"[{inside}"
        for one in value:
            yield before
            yield from _pieces(one, inside)
            before = f",{inside}"
        yield line + "]"
    else:
        yield _PLAIN(value + 0.0 if isinstance(value, float) else value)


def no_number(word: str) -> float:
    """Raise ValueError for NaN and infinite numbers, which JSON does not allow."""
    raise ValueError(f"{word} in the place of a number")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return a JSON object as a mapping. Raises ValueError for a key given twice."""
    data = dict(pairs)
    if len(data) < len(pairs):
        names = [key for key, _ in pairs]
        twice = next(name for name in names if names.count(name) > 1)
        raise ValueError(f"the key {twice!a} twice in one object")
    return data


def read_json(content: bytes, file: str, schema: str, name: str, expected: str) -> dict[str, Any]:
    """Return a document of the given ``schema``. Raises InputError for any other contents, with
    ``name`` and ``expected`` in its text: what such a document and its file are called.
    """
    try:
        data = json.loads(
            content.decode("utf-8"), object_pairs_hook=_once, parse_constant=no_number
        )
    except (ValueError, RecursionError) as error:
        raise InputError(
            Fault(
                message="the file is not JSON",
                file=file,
                expected=expected,
                found=str(error),
                hint=AS_WRITTEN,
            )
        ) from error
    found = data.get("schema") if isinstance(data, dict) else None
    if found != schema:
        raise InputError(
            Fault(
                message=f"the file is not a {name} that this version of compwright reads",
                file=file,
                place="schema",
                expected=schema,
                found=repr(found),
                hint="make the file again with this version of compwright",
            )
        )
    return dict(data)
