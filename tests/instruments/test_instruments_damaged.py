"""Damaged files of every form: an error with its place or a test, never a fault of our own."""

from __future__ import annotations

import random

import pytest

from compwright.foundations.errors import CompwrightError
from compwright.instruments.profile_of_file import proposed_profile
from compwright.instruments.profile_reading import read_profile
from compwright.instruments.reading import read_tests
from laser_files import compensation_file, laser_file, mean_file
from profile_samples import LONG, LONG_PROFILE, WIDE, WIDE_PROFILE

TARGETS = ["0.0000", "100.2500", "200.0000", "300.1250"]
RUNS = {
    (run, index): f"{index - run % 2 * 2}.{run}" for run in (1, 2, 3, 4) for index in range(1, 5)
}
ANGLES = {key: "7" + value.lstrip("-") for key, value in RUNS.items()}
MEANS = [("0.000", "0.0000"), ("100.000", "0.0021"), ("200.000", "0.0030")]
TABLE = [["1", "-250", "0", "-0.0002"], ["2", "-225", "0.0013", "0.0008"]]
FILES = {
    "rtl": (laser_file(TARGETS, RUNS), ""),
    "rta": (laser_file(TARGETS, ANGLES, file_type="rta"), ""),
    "pos": (mean_file({"Forward Directional": MEANS, "Reverse Directional": MEANS}), ""),
    "ren": (compensation_file(TABLE, end="-225 mm"), ""),
    "long": (LONG, LONG_PROFILE),
    "wide": (WIDE, WIDE_PROFILE),
}
JUNK: tuple[str, ...] = (
    "\x00",
    ",",
    ";",
    "\t",
    "\n",
    "-",
    ".",
    "9" * 30,
    "1e400",
    "nan",
    '"',
    "::",
    "EOF::",
    "↑",
)
JUNK += ("Run-count: 999999999\r\n", "Target-count: 0\r\n", "\ufeff", "header_line: 99999\n", "{")


def damaged(text: str, chance: random.Random) -> str:
    for _ in range(chance.choice((1, 1, 2, 5))):
        at = chance.randrange(len(text) + 1)
        kind = chance.randrange(4)
        if kind == 0:
            text = text[:at] + chance.choice(JUNK) + text[at:]
        elif kind == 1:
            text = text[:at] + text[at + chance.randrange(1, 9) :]
        elif kind == 2:
            lines = text.split("\n")
            lines.insert(chance.randrange(len(lines)), lines.pop(chance.randrange(len(lines))))
            text = "\n".join(lines)
        else:
            text = text[:at] or text
    return text


@pytest.mark.parametrize("form", FILES)
def test_only_errors_on_purpose(form: str) -> None:
    chance = random.Random(form)  # noqa: S311 - the same damage in every run
    whole, profile = FILES[form]
    outcomes = set()
    for _ in range(150):
        spoiled = chance.random() < 0.3
        content = (whole if spoiled and profile else damaged(whole, chance)).encode()
        words = damaged(profile, chance) if spoiled else profile
        try:
            read_tests(content, "f", read_profile(words.encode(), "P.yaml") if words else None)
            outcomes.add("read")
        except CompwrightError:
            outcomes.add("refused")
        try:
            proposed_profile(content, "f")
        except CompwrightError:
            outcomes.add("no profile")
    assert {"read", "refused"} <= outcomes
