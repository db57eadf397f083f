"""Pair two files of one circular test, one for each direction.

Codes made here:

- ``CW-R038`` info: two files were taken as the two directions of one test
- ``CW-R039`` warning: a file of one direction fits several of the other, and was left alone
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import PurePath
from typing import Final

from compwright.foundations.errors import InputError
from compwright.foundations.findings import Finding
from compwright.instruments.circular_reading import merge_circular
from compwright.records.circular import CircularTest, Sense

#: ``ccw`` or ``cw`` as a word of its own in a file's name, with the marks before it.
_SENSE_IN_NAME: Final = re.compile(r"[-_. ]?(?<![a-z])(?:ccw|cw)(?![a-z])", re.IGNORECASE)
#: What the files say of the machine must not differ where both say it.
_SAME_MACHINE: Final = ("machine", "serial")
_ENOUGH: Final = 2  # partners that make a file doubtful; more need not be sought


def paired(tests: Sequence[CircularTest]) -> tuple[CircularTest, ...]:
    """Return the tests in their order. A ccw file and a cw file are joined if they certainly belong
    together.

    Two files fit each other if one has only ccw runs and the other only cw runs, and if their
    plane, axes, radius, feed and arc are the same. Centre and machine must also be the same if both
    files state them (`merge_circular`). Two files of one folder whose names differ only by the
    words ccw and cw are joined first. Then a file is joined if it fits exactly one other file. A
    file that fits several others stays alone and gets a finding.

    The name of a joined test is that of its files without the word ccw or cw, or both names. The
    joined test takes the place of the first of its files.
    """
    found = dict(enumerate(tests))
    for by_name in (True, False):
        partners = _partners(found, by_name=by_name)
        for index in sorted(partners):
            other = partners[index][0] if len(partners[index]) == 1 else index
            if index < other and partners[other] == [index]:
                found[index] = _joined(found[index], found.pop(other))
    for index, others in _partners(found, by_name=False).items():
        if others:
            found[index] = _doubtful(found[index], [found[other] for other in others])
    return tuple(found[index] for index in sorted(found))


def _partners(tests: Mapping[int, CircularTest], *, by_name: bool) -> dict[int, list[int]]:
    """Return, by the index of each test that has only one direction, the indices of at most two
    tests that can be the other direction of the same test. ``by_name``: these must also have the
    same folder and file name, apart from ``ccw`` and ``cw``.
    """
    ways: dict[tuple[Sense, Hashable], list[int]] = defaultdict(list)
    mine: dict[int, tuple[Sense, Hashable]] = {}
    for index, test in tests.items():
        sense = _only(test)
        if sense is not None:
            # Only tests with these in common can fit: this keeps the number of comparisons small.
            where = _place(test) if by_name else None
            mine[index] = sense, (test.axes, test.nominal_radius, where)
            ways[mine[index]].append(index)
    known: dict[frozenset[int], bool] = {}

    def fit(one: int, other: int) -> bool:
        pair = frozenset((one, other))
        if pair not in known:
            known[pair] = _belong(tests[one], tests[other])
        return known[pair]

    partners: dict[int, list[int]] = {}
    for way in ("ccw", "cw"):
        for index, (sense, alike) in mine.items():
            if sense == way:
                theirs = ways.get(("cw" if way == "ccw" else "ccw", alike), [])
                fitting = (other for other in theirs if fit(index, other))
                partners[index] = list(islice(fitting, _ENOUGH))
    return partners


def _only(test: CircularTest) -> Sense | None:
    """Return the direction (ccw or cw) of a test whose runs all have that direction, None if it has
    both.
    """
    senses = {run.sense for run in test.runs}
    return senses.pop() if len(senses) == 1 else None


def _belong(one: CircularTest, other: CircularTest) -> bool:
    """Return whether nothing in two files excludes that they are the two directions of one test."""
    if any(
        one.header.get(key) and other.header.get(key) and one.header[key] != other.header[key]
        for key in _SAME_MACHINE
    ):
        return False
    try:
        merge_circular((one, other), one.name)
    except InputError:
        return False
    return True


def _joined(one: CircularTest, other: CircularTest) -> CircularTest:
    bare = _bare(one.name)
    name = (
        bare
        if bare and bare.lower() == _bare(other.name).lower()
        else " + ".join(dict.fromkeys((one.name, other.name)))
    )
    joined = merge_circular((one, other), name)
    files = [f"{_file_of(test)} ({_only(test)})" for test in (one, other)]
    return replace(joined, findings=(*joined.findings, Finding.of("CW-R038", "info", files=files)))


def _bare(name: str) -> str:
    """Return a file name without the words ``ccw`` and ``cw``."""
    return _SENSE_IN_NAME.sub("", name).strip("-_. ")


def _place(test: CircularTest) -> tuple[str, str]:
    """Return the folder of a test's file, and the file name without ``ccw`` or ``cw``."""
    folder = str(PurePath(test.sources[0].file).parent) if test.sources else ""
    return folder, _bare(test.name).lower()


def _file_of(test: CircularTest) -> str:
    return PurePath(test.sources[0].file).name if test.sources else test.name


def _doubtful(test: CircularTest, others: Sequence[CircularTest]) -> CircularTest:
    """Return the test with the finding that several files are possible as its runs in the other
    direction, so that none was joined.
    """
    return replace(
        test,
        findings=(*test.findings, Finding.of("CW-R039", "warning", files=map(_file_of, others))),
    )
