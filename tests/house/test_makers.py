"""Makers, formats and parameters by name or number stand only where controls are known: in
``controller_formats``, ``formats/families``, ``controllers`` and ``docs``, and in the sentences of
the families. Comments and docstrings count.
"""

from __future__ import annotations

import io
import re
import tokenize
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from format_samples import DEFINITIONS
from places import PROJECT

SOURCE = PROJECT / "src" / "compwright"
KNOW_CONTROLS = (SOURCE / "formats" / "families", SOURCE / "controllers")

_LETTER = "A-Za-z"
MAKERS = (
    *("fanuc", "siemens", "sinumerik", "heidenhain", r"i?tnc\d*", "linuxcnc", "matrixkins", "emc2"),
    *("beckhoff", "twincat", "isg", "delta ?tau", r"(?:turbo ?)?u?pmac", "mitsubishi", "meldas"),
    *("fagor", "mazak", "mazatrol", "okuma", "haas", "fidia", "rexroth", "bosch", "brother"),
)
#: The words of one maker each, and parameters that only its controls have.
FAMILIES = (
    r"fanuc|1815|1851|3620",
    r"siemens|sinumerik|md\d{5}|sd\d{5}",
    r"heidenhain|i?tnc\d*|mp ?\d{3,4}",
    r"linuxcnc|emc2",
    r"isg|beckhoff|twincat|ssfk",
    r"(?:turbo ?)?u?pmac|delta ?tau",
)
NAMES = re.compile(
    rf"(?<![{_LETTER}])(?:{'|'.join((*MAKERS, *map(re.escape, DEFINITIONS)))})(?![{_LETTER}])",
    re.IGNORECASE,
)
#: Machine and setting data, variables, machine parameters, and tables by their makers' words.
PARAMETERS = re.compile(
    r"(?<![A-Za-z])(?:MD|SD) ?\d{5}(?!\d)|(?<![A-Za-z])N0?[1-9]\d{3}(?!\d)|(?<![A-Za-z])MP ?\d{3,4}"
    r"|\$(?:M|S|A)[NACM]+_[A-Z]|(?<![A-Za-z])(?:CEC|EEC|ENC_COMP|BLCOMP|CROSSCOMP|ssfk|cec_)"
)
#: A number of four or five digits in text is a parameter, unless it is one of these.
EXPLAINED = re.compile(
    r"(?:ISO|VDI(?:/DGQ)?|GOST|ГОСТ|DIN)[\s\d./:-]*\d"  # standards and their editions
    r"|\b(?:19|20)\d\d\b(?!#)"  # years
    r"|\b\d*(?:[05]00|[27]50)\b|\b65536\b"  # round
)
#: No parameter has fewer; most texts have none.
FOUR_DIGITS = re.compile(r"\d{4}")
#: Not a part of a word, a decimal number or a date; the second of a list or a range is one too.
NUMBER = re.compile(
    r"(?:(?<![\w.,:+-])|(?<=\b\d{4}[,-])|(?<=\b\d{5}[,-]))\d{4,5}(?!\w|\.\d|,\d\d?(?!\d)|-\d\d?(?!\d))"
)


@cache
def _numbers_of_controls() -> frozenset[str]:
    """Every number of four or five digits that a definition or a family speaks of, no round one."""
    round_ones = re.compile(r"0.*|.*(?:00|50)|9+|32767")
    files = (*(PROJECT / "controller_formats").rglob("*.yaml"), *KNOW_CONTROLS[0].rglob("*.py"))
    found = {n for file in files for n in NUMBER.findall(file.read_text(encoding="utf-8"))}
    return frozenset(number for number in found if not round_ones.fullmatch(number))


def leaks(source: str, numbers: frozenset[str] = frozenset()) -> Iterator[tuple[int, str]]:
    """Yield line and word of everything in Python source that only a control knows."""
    yield from named(source)
    if not FOUR_DIGITS.search(source):
        return
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        line = token.start[0]
        if token.type == tokenize.NUMBER:
            if token.string in numbers:
                yield line, token.string
        elif token.type not in (tokenize.NAME, tokenize.OP):
            yield from numbered(token.string, line)


def named(text: str) -> Iterator[tuple[int, str]]:
    """Yield line and word of every name and parameter that only a control knows."""
    for line, row in enumerate(text.splitlines(), start=1):
        for pattern in (NAMES, PARAMETERS):
            yield from ((line, found[0]) for found in pattern.finditer(row))


def numbered(text: str, first: int = 1) -> Iterator[tuple[int, str]]:
    """Yield line and number of what may be a parameter; ``first``: the line where text begins."""
    if not FOUR_DIGITS.search(text):
        return
    text = EXPLAINED.sub(lambda found: re.sub(r"\d", " ", found[0]), text)
    for found in NUMBER.finditer(text):
        yield first + text.count("\n", 0, found.start()), found[0]


def template_leaks(text: str) -> list[tuple[int, str]]:
    """Return line and word of everything in a template that only a control knows."""
    return [*named(text), *numbered(text)]


def all_leaks(source: Path) -> list[str]:
    words = source / "words"  # a module and a folder of each language
    sentences = (*sorted(words.glob("*/states.py")), *sorted(words.glob("*/controls")))
    know = (source / "formats" / "families", source / "controllers", *sentences)
    numbers = _numbers_of_controls()
    return [
        f"{path.relative_to(source)} line {line}: {word}"
        for path in sorted(source.rglob("*.py"))
        if not any(path.is_relative_to(folder) for folder in know)
        for line, word in leaks(path.read_text(encoding="utf-8"), numbers)
    ]


def test_only_the_rooms_of_controls_know_controls() -> None:
    assert all_leaks(SOURCE) == []


def test_templates_know_no_controls() -> None:
    files = sorted((SOURCE / "reporting" / "templates").iterdir())
    assert files
    found = [
        (file.name, *leak) for file in files for leak in template_leaks(file.read_text("utf-8"))
    ]
    assert found == []


def test_cards_of_several_families_share_no_word_of_one_control() -> None:
    source = (KNOW_CONTROLS[0] / "card_texts.py").read_text(encoding="utf-8")
    assert list(named(source)) == []
    assert [number for _, number in numbered(source)] == []


@pytest.mark.parametrize("control", DEFINITIONS)
def test_the_card_of_a_control_names_no_other_maker(control: str) -> None:
    """The texts of a definition's card, whatever its evidence speaks of."""
    maker = next(words for words in FAMILIES if re.search(words, control))
    others = "|".join(words for words in FAMILIES if words != maker)
    text = repr(DEFINITIONS[control].card)
    assert re.findall(rf"(?i)(?<![a-z])(?:{others})(?![a-z])", text) == []


def test_a_leak_in_a_template_is_found() -> None:
    assert template_leaks("<p>\nset 1851 in the FANUC") == [(2, "FANUC"), (2, "1851")]


def test_shapes_of_tables_are_asked_for_where_families_are_chosen() -> None:
    may = (*KNOW_CONTROLS, SOURCE / "formats" / "definition", SOURCE / "formats/families/shapes.py")
    words = re.compile("values_by_index|rows_by_position|section_increments|user_tables")
    asked = [
        str(path.relative_to(SOURCE))
        for path in sorted(SOURCE.rglob("*.py"))
        if not any(path.is_relative_to(place) for place in may)
        and words.search(path.read_text(encoding="utf-8"))
    ]
    assert asked == []


@pytest.mark.parametrize(
    "line",
    [
        'if control.id.startswith("linuxcnc"):',
        'CONTROL = "siemens-840d-sl"',
        "# FANUC counts otherwise",
        '"""Read a TNC\'s table."""',
        "def beckhoff_list() -> None: ...",
        'text = "a Turbo PMAC wraps"',
        "first = 5711",
        'rows = [("5711", "moving axis")]',
        'note = f"3605#0 = {int(two)}"',
        '"a parameter file with 1820 and 1013 (1004)"',
        '"""Bit 0 of 1815, whatever the job says."""',
        'enable = f"MD32710 $MA_CEC_ENABLE[{axis}]"',
        'switch = "SD41300"',
        '# "N03620Q1A1P0"',
        '"MP 730 selects"',
        '"The backlash is 1851."',
        '"""What 3620-3627 say."""',
        '"MD 38000 reserves"',
        "MP720 = 1",
        "from compwright.formats.families.pairs.reading import CEC_TABLES",
        'options["cec_sign"]',
    ],
)
def test_what_leaked_before_is_found(line: str) -> None:
    assert list(leaks(line + "\n", _numbers_of_controls()))


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("1851/1852", ["1851", "1852"]),
        ("3620-3627.", ["3620", "3627"]),
        ("5711,5712, 5713", ["5711", "5712", "5713"]),
        ("38010-38020", ["38010", "38020"]),
        ("on 1851-05-12, 1851.5, -1851, +1851, 0,1851, 0.1851, a1851, 1851st", []),
    ],
)
def test_each_number_of_a_list_or_a_range_is_found(text: str, numbers: list[str]) -> None:
    assert [number for _, number in numbered(text)] == numbers


@pytest.mark.parametrize(
    "line",
    [
        "WHERE = np.linspace(-5000.0, 5000.0, 2001)",
        "factor = 1000 if unit == 'm' else 3600",
        '"""ISO 230-2:1988, GOST 27843-2006 and VDI/DGQ 3441; ISO\n230-4:1996, 3.3."""',
        "# Makhoul 1980; at 1500 samples per turn; 1 of 1000; 12000 mm; 65536 pixels",
        'message = "1000 times too small, such as 1250.5 or 0.0012"',
        '"""A missing gauge."""',
        "# U+2212, Windows-1252, vdi3441",
    ],
)
def test_numbers_and_words_of_others_are_no_leak(line: str) -> None:
    assert list(leaks(line + "\n", _numbers_of_controls())) == []
