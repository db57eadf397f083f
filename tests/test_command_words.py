"""Options that take several values at once: which words are theirs, and which are the files of the
command.

From the outside contract: an option whose value ends in ``...`` is repeated, once per value, or
takes several values at once.
"""

from __future__ import annotations

import pytest

from compwright import cli
from compwright.cli import run as compwright


def told(words: str) -> dict[str, object]:
    """What a command line means to its command."""
    name, *rest = words.split()
    command = cli.compwright.commands[name]
    return {
        key: value
        for key, value in command.make_context(name, rest).params.items()
        if value not in (None, (), False)
    }


def names(value: object) -> list[str]:
    assert isinstance(value, tuple)
    return [str(one) for one in value]


@pytest.mark.parametrize(
    "words",
    [
        "compare plan.json --loaded a b c",
        "compare plan.json --loaded a --loaded b --loaded c",
        "compare plan.json --loaded a b --loaded c --json -",
        "compare plan.json --force --loaded=a --loaded b c",
        "compare --loaded a b c plan.json",
        "compare --loaded a b c --json - plan.json",
        "compare --loaded a b c --force plan.json",
        "compare --loaded a b c -- plan.json",
    ],
)
def test_loaded_takes_several_files_at_once(words: str) -> None:
    meant = told(words)
    assert (str(meant["plan"]), names(meant["loaded"])) == ("plan.json", ["a", "b", "c"])


@pytest.mark.parametrize(
    ("words", "key", "expected"),
    [
        ("new --from a b --format f --out j", "files", ["a", "b"]),
        ("verify job.yaml --after x=a y=b --loaded c d --out o", "after", ["x=a", "y=b"]),
        ("verify job.yaml --after x=a y=b --loaded c d --out o", "loaded", ["c", "d"]),
        ("verify --after a b job.yaml", "after", ["a", "b"]),
        ("export plan.json --format f --state a b --out o --option k=1 l=2", "states", ["a", "b"]),
        (
            "export plan.json --format f --state a b --out o --option k=1 l=2",
            "options",
            ["k=1", "l=2"],
        ),
        ("run x.csv --format f --axis X --travel 0:1 --state a b c", "states", ["a", "b", "c"]),
        ("run --state a b --format f x.csv y.csv", "states", ["a", "b"]),
        ("run --state a b --format f x.csv y.csv", "inputs", ["x.csv", "y.csv"]),
        (
            "evaluate a b --standard iso230-2:1988 iso230-4:1996",
            "standards",
            ["iso230-2:1988", "iso230-4:1996"],
        ),
    ],
)
def test_each_option_with_dots_takes_several_values(
    words: str, key: str, expected: list[str]
) -> None:
    assert names(told(words)[key]) == expected


@pytest.mark.parametrize(
    ("words", "key", "expected"),
    [
        ("run --state none x.csv y.csv", "inputs", ["x.csv", "y.csv"]),
        ("run x.csv --state none y.csv", "inputs", ["x.csv", "y.csv"]),
        ("run --state a.ini x.csv", "inputs", ["x.csv"]),
        ("run --option k=v x.csv", "inputs", ["x.csv"]),
        ("run x.csv --option k=v y.csv --out o z.csv", "inputs", ["x.csv", "y.csv", "z.csv"]),
        ("evaluate --standard vdi3441 a.csv b.csv", "paths", ["a.csv", "b.csv"]),
        ("evaluate a.csv --standard vdi3441 b.csv", "paths", ["a.csv", "b.csv"]),
        ("decode --format f a b --option k=v c", "paths", ["a", "b", "c"]),
    ],
)
def test_files_of_the_command_stay_its_own(words: str, key: str, expected: list[str]) -> None:
    assert names(told(words)[key]) == expected


def test_the_help_shows_which_options_take_several_values(
    capsys: pytest.CaptureFixture[str],
) -> None:
    shown = {
        "compare": "--loaded FILE...",
        "verify": "--after [TEST=]FILE...",
        "new": "--from FILE...",
        "run": "--state none|FILE...",
        "export": "--option K=V...",
        "evaluate": "--standard ID...",
    }
    for command, form in shown.items():
        compwright([command, "--help"])
        assert form in capsys.readouterr().out


def test_a_word_too_many_is_still_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert compwright(["compare", "plan.json", "other.json", "--loaded", "a"]) == 2
    assert "unexpected extra argument" in capsys.readouterr().err
