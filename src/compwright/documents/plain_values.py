"""Pydantic schemas for values in plans and records: numbers, texts, arrays, bytes."""

from __future__ import annotations

import base64
import binascii
from collections.abc import Iterator, Mapping
from typing import Any, Final

import numpy as np
from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, KeyPath, shown
from compwright.foundations.validation import refuse

#: No position, correction or feed of a machine tool is larger, mm, deg, mm/min.
LARGEST: Final = 1e9
_NUMBER: Final = f"a number, not larger than {LARGEST:g}"


def is_number(value: Any) -> bool:
    """Return whether a value is a finite number of plausible size."""
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) <= LARGEST


def _array(value: Any) -> Any:
    """Return the schema of an array of numbers, which reports a damaged row as one fault."""
    odd = value if not isinstance(value, list) else [one for one in value if not is_number(one)]
    if odd or not isinstance(value, list):
        expected = f"a list of numbers, none larger than {LARGEST:g}"
        found = shown(odd[0] if isinstance(value, list) else value)
        refuse(KeyFault((), "is not a list of numbers", expected, found))
    return np.array(value, dtype=np.float64)


def _bytes(value: Any) -> bytes:
    try:
        return base64.b64decode(value, validate=True)
    except (TypeError, ValueError, binascii.Error):
        return refuse(KeyFault((), "are no bytes", "bytes in base64", shown(value)))


def _anything(value: Any) -> Any:
    """Accept any value, such as an option of a control, which is checked elsewhere."""
    faults = list(_odd(value, ()))
    if faults:
        refuse(*faults)
    return value


def _odd(value: Any, path: KeyPath) -> Iterator[KeyFault]:
    if isinstance(value, list):
        for index, one in enumerate(value):
            yield from _odd(one, (*path, index))
    elif not (value is None or isinstance(value, str | bool) or is_number(value)):
        expected = f"text, true or false, null or {_NUMBER}, or a list"
        yield KeyFault(path, "is not an accepted value", expected, shown(value))


#: By type, for `RecordSchemas`. Text may hold what no encoding has: the name of a file.
PLAIN: Final[Mapping[Any, cs.CoreSchema]] = {
    str: cs.is_instance_schema(str),
    bool: cs.bool_schema(strict=True),
    int: cs.int_schema(strict=True, ge=-int(LARGEST), le=int(LARGEST)),
    float: cs.float_schema(strict=True, ge=-LARGEST, le=LARGEST, allow_inf_nan=False),
    bytes: cs.no_info_plain_validator_function(_bytes),
    object: cs.no_info_plain_validator_function(_anything),
    np.ndarray: cs.no_info_plain_validator_function(_array),
}
