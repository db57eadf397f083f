"""Options that take several values at once: which words are theirs, and which are the files of the
command.

From the outside contract: an option whose value ends in ``...`` is repeated, once per value, or
takes several values at once.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from compwright import cli
from compwright.cli import run as compwright
from compwright.cli.words import Invocation
from compwright.foundations.parallel_work import alone
from compwright.foundations.session import Session


def told(words: str) -> dict[str, object]:
    """What a command line means to its command."""
    name, *rest = words.split()
    command = cli.compwright.commands[name]
    return {
        key: value
        for key, value in command.make_context(
            name, rest, obj=Invocation(Session(), alone)
        ).params.items()
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
        ("verify --after a b job.yaml --loaded c d", "after", ["a", "b"]),
        ("verify --after a b job.yaml --loaded c d", "loaded", ["c", "d"]),
        ("verify --loaded=c d --after=x=a y=b job.yaml", "after", ["x=a", "y=b"]),
        ("verify --loaded=c d --after=x=a y=b job.yaml", "loaded", ["c", "d"]),
        ("new --from=a b --format f --out j", "files", ["a", "b"]),
        ("diff --with n1 n2 --format f -- o1 o2", "new", ["n1", "n2"]),
        ("diff o1 o2 --with=n1 n2 --format f", "old", ["o1", "o2"]),
        ("export --state a b plan.json --option k=1 l=2 --format f --out o", "states", ["a", "b"]),
        ("export --option=k=1 l=2 plan.json --format f --out o", "options", ["k=1", "l=2"]),
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


@pytest.fixture
def hall(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("x 1.csv", "x 2.csv", "y[1].csv", ".x.csv", "B1.INI", "B2.INI"):
        (tmp_path / name).write_text("")
    (tmp_path / "Süd").mkdir()
    (tmp_path / "Süd" / "x.csv").write_text("")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ("command", "values", "key", "expected"),
    [
        ("evaluate", ["x*.csv"], "paths", ["x 1.csv", "x 2.csv"]),
        ("evaluate", ["x ?.csv", "S*/x.csv"], "paths", ["x 1.csv", "x 2.csv", "Süd/x.csv"]),
        ("evaluate", ["y[1].*"], "paths", ["y[1].csv"]),
        ("evaluate", ["no*.csv"], "paths", ["no*.csv"]),
        (
            "verify",
            ["job.yaml", "--after", "vorn=x*.csv"],
            "after",
            ["vorn=x 1.csv", "vorn=x 2.csv"],
        ),
        (
            "verify",
            ["job.yaml", "--after", "a", "--loaded", "B?.INI"],
            "loaded",
            ["B1.INI", "B2.INI"],
        ),
        (
            "run",
            ["x.csv", "--format", "f", "--state", "B*.INI", "none"],
            "states",
            ["B1.INI", "B2.INI", "none"],
        ),
        ("new", ["--from", "B*", "--format", "f", "--out", "j*"], "files", ["B1.INI", "B2.INI"]),
    ],
)
def test_wildcards_that_the_shell_leaves_are_the_files_that_fit(
    command: str, values: list[str], key: str, expected: list[str], hall: Path
) -> None:
    context = cli.compwright.commands[command].make_context(
        command, values, obj=Invocation(Session(), alone)
    )
    found = [str(one).replace(os.sep, "/") for one in context.params[key]]
    assert found == expected
    if command == "new":
        assert str(context.params["out"]) == "j*"


@pytest.mark.skipif(os.name == "nt", reason="no file can have such a name")
def test_a_name_that_is_there_wins_over_what_it_fits(hall: Path) -> None:
    (hall / "x*.csv").write_text("")
    context = cli.compwright.commands["evaluate"].make_context(
        "evaluate", ["x*.csv"], obj=Invocation(Session(), alone)
    )
    assert names(context.params["paths"]) == ["x*.csv"]


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
