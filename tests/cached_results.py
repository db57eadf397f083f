"""What a function of the estimate or the fit returned for the same readings, returned once more.

Many tests of a module run a command on one measurement with other files of the control: the same
readings give the same estimate, from whichever file they were read. That they do so when they are
worked out anew is tested where nothing is cached (the fixture ``afresh``; test_same_bytes.py).
"""

from __future__ import annotations

import hashlib
import io
import pickle
from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar

from compwright.foundations.provenance import Source

P = ParamSpec("P")
R = TypeVar("R")

#: As many results of one function are kept.
_KEPT = 256


class _Content(pickle.Pickler):
    """Arguments as bytes, without the names of the files in which they stood."""

    def reducer_override(self, obj: Any) -> Any:
        return (str, ()) if type(obj) is Source else NotImplemented


def cached(function: Callable[P, R]) -> Callable[P, R]:
    """Return a pure ``function`` that works once on the same arguments, by their content."""
    known: OrderedDict[bytes, R] = OrderedDict()

    @wraps(function)
    def again(*args: P.args, **kwargs: P.kwargs) -> R:
        content = io.BytesIO()
        _Content(content).dump((args, sorted(kwargs.items())))
        key = hashlib.sha256(content.getvalue()).digest()
        if key not in known:
            known[key] = function(*args, **kwargs)
        known.move_to_end(key)
        while len(known) > _KEPT:
            known.popitem(last=False)
        return known[key]

    return again
