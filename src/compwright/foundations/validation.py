"""Check a user's files with pydantic. Each of its errors becomes a fault with a key path.

Models of pydantic and the schemas of `record_schemas` give the same faults. This module is slow to
import, so only commands that check such a file import it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NoReturn

from pydantic_core import (
    ErrorDetails,
    InitErrorDetails,
    PydanticCustomError,
    SchemaValidator,
    ValidationError,
)
from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, KeyPath, number_hint, shown, suggestion

#: Complaints of our own: in plain words, and about a key that is not known.
_STATED = "stated"
_WORDED = "worded"
_UNKNOWN = "unknown_key"
_TAGS = ("union_tag_invalid", "union_tag_not_found")

#: What is expected under a key that is missing, by its name.
Missing = Mapping[str, str]
#: The keys of the mapping at a location of a schema.
Known = Callable[[KeyPath], list[str]]


def refuse(*faults: KeyFault) -> NoReturn:
    """Raise the faults found in a value as one pydantic error. Their key paths are relative to that
    value, which a validator is checking.
    """
    raise ValidationError.from_exception_data(
        "",
        [
            InitErrorDetails(
                type=PydanticCustomError(
                    _STATED,
                    "{message}",
                    {"message": each.message, "expected": each.expected, "below": bool(each.path)},
                ),
                loc=each.path,
                input=each.found,
            )
            for each in faults
        ],
    )


def worded(schema: cs.CoreSchema, message: str, expected: str) -> cs.CoreSchema:
    """Return a schema that reports an invalid value with a given message and expected value."""
    return cs.custom_error_schema(
        schema,
        _WORDED,
        custom_error_message=message,
        custom_error_context={"message": message, "expected": expected},
    )


def unknown_key(known: list[str]) -> cs.CoreSchema:
    """Return a schema that refuses unknown keys. ``known``: the allowed ones."""

    def refuse_key(_value: Any) -> NoReturn:
        raise PydanticCustomError(_UNKNOWN, "unknown key", {"known": known})

    return cs.no_info_plain_validator_function(refuse_key)


def checked(validator: SchemaValidator, data: Any) -> tuple[Any, list[KeyFault]]:
    """Return two values: what the schema makes from ``data`` (None if there are faults), and the
    faults.
    """
    try:
        return validator.validate_python(data), []
    except ValidationError as error:
        return None, list(key_faults(error, data, again=validator.validate_python))


def key_faults(
    error: ValidationError,
    data: Any,
    known: Known = lambda _location: [],
    missing: Missing = {},  # noqa: B006  # only read
    again: Callable[[Any], object] | None = None,
) -> Iterator[KeyFault]:
    """Yield a `KeyFault` for each error that pydantic found in ``data``. ``known``: gives the
    allowed keys of a mapping; ``missing``: what is expected at a missing key; ``again``: the
    function that validated ``data``.
    """
    for complaint in error.errors(include_url=False):
        path = _path_in(data, complaint)
        if complaint["type"] in ("missing", "union_tag_not_found"):
            expected = missing.get(str(path[-1])) or _expected_at(path, data, again)
            yield KeyFault(path, "is missing", expected)
        elif complaint["type"] in ("extra_forbidden", _UNKNOWN):
            names = complaint.get("ctx", {}).get("known") or known(complaint["loc"][:-1])
            yield KeyFault(path, "unknown key", suggestion(str(complaint["loc"][-1]), names))
        elif complaint["type"] in (_STATED, _WORDED):
            stated, found = complaint.get("ctx", {}), complaint["input"]
            found = found if complaint["type"] == _STATED else shown(found)
            yield KeyFault(path, stated["message"], stated["expected"], found)
        else:
            message, expected = _words(complaint)
            if complaint["type"].endswith("_type") and path:
                expected = missing.get(str(path[-1]), expected)
            yield KeyFault(path, message, expected, shown(complaint["input"]))


def _expected_at(path: KeyPath, data: Any, again: Callable[[Any], object] | None) -> str:
    """Return what is expected at a missing key: put a wrong value there, validate with ``again``,
    and take the words of the fault.
    """
    if again is None:
        return "a value"
    filled = _with(data, path, object())
    try:
        again(filled)
    except ValidationError as error:
        words = [each.expected for each in key_faults(error, filled) if each.path == path]
        return " or ".join(dict.fromkeys(filter(None, words))) or "a value"
    return "a value"


def _with(data: Any, path: KeyPath, value: object) -> Any:
    """Return a copy of ``data`` with ``value`` at a key path."""
    if not path:
        return value
    first, *rest = path
    copy: Any = list(data) if isinstance(data, list) else dict(data)
    copy[first] = _with(copy[first], tuple(rest), value) if rest else value
    return copy


def _path_in(data: Any, complaint: ErrorDetails) -> KeyPath:
    """Return the key path of a pydantic error as in the user's file, without levels of the path
    that only the schema has.

    The schema has more levels where the file uses a short form. The path also contains a key that
    is missing in the file.
    """
    location, context = complaint["loc"], complaint.get("ctx", {})
    path: list[str | int] = []
    here, written = data, False
    for part in location:
        written = (isinstance(here, dict) and part in here) or (
            isinstance(here, list) and isinstance(part, int) and part < len(here)
        )
        if written:
            here = here[part]
            path.append(part)
    named = complaint["type"] == "missing" or context.get("below")
    if named and not written and isinstance(here, dict):
        path.append(location[-1])
    if complaint["type"] in _TAGS and isinstance(here, dict):
        path.append(context["discriminator"].strip("'"))
    return tuple(path)


def _words(complaint: ErrorDetails) -> tuple[str, str]:
    """Return the message and the expected value for a pydantic error."""
    kind, found, context = complaint["type"], complaint["input"], complaint.get("ctx", {})
    if kind in ("float_type", "int_type", "int_from_float"):
        number = "a number" if kind == "float_type" else "a whole number"
        hint = number_hint(found) if isinstance(found, str) else ""
        return (f"is text, not a number ({hint})" if hint else "is not a number"), number
    mapping = ("is not a mapping", "a mapping: {key: value}")
    fixed = {
        "literal_error": ("is not an accepted value", str(context.get("expected", ""))),
        "union_tag_invalid": ("is not an accepted value", str(context.get("expected_tags", ""))),
        "greater_than": ("is too small", f"more than {context.get('gt', 0):g}"),
        "greater_than_equal": ("is too small", f"{context.get('ge', 0):g} or more"),
        "less_than": ("is too large", f"less than {context.get('lt', 0):g}"),
        "less_than_equal": ("is too large", f"{context.get('le', 0):g} or less"),
        "too_short": ("is too short", f"at least {context.get('min_length')} in the list"),
        "too_long": ("is too long", f"at most {context.get('max_length')} in the list"),
        "list_type": ("is not a list", "a list: [.., ..]"),
        "tuple_type": ("is not a list", "a list: [.., ..]"),
        "dict_type": mapping,
        "model_type": mapping,
        "model_attributes_type": mapping,
        "finite_number": ("is not finite", "a finite number"),
        "bool_type": ("is neither true nor false", "true or false"),
        "is_instance_of": ("is not text", "text, in quotes where it looks like a number"),
        "string_type": ("is not text", "text, in quotes where it looks like a number"),
        "string_too_short": ("is empty", "text"),
        "text_in_quotes": ("is not text", "a word, or text in quotes"),
        "one_line": ("is blank or contains control characters", "text on one line"),
        "truth_value": ("is a truth value", "a number"),
    }
    return fixed.get(kind, (complaint["msg"].lower(), ""))
