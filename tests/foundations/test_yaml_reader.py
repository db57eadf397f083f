"""YAML as people mean it: what YAML 1.1 would turn into something else stays text, and every key
knows its line.
"""

from __future__ import annotations

import math
from typing import Any

import pytest
import yaml
from hypothesis import example, given, settings
from hypothesis import strategies as st

from compwright.foundations.errors import InputError
from compwright.foundations.key_faults import key_path_text
from compwright.foundations.session import Session
from compwright.foundations.storage import definition_files
from compwright.foundations.yaml_reader import read_yaml, read_yaml_with_faults


def value_of(text: str) -> Any:
    return read_yaml(f"key: {text}\n".encode(), "f.yaml").data["key"]


def faults_of(content: bytes) -> list[str]:
    with pytest.raises(InputError) as caught:
        read_yaml(content, "f.yaml")
    assert caught.value.exit_code == 3
    return [str(fault) for fault in caught.value.faults]


@pytest.mark.parametrize(
    "text",
    [
        *(
            "010",
            "0o10",
            "0x10",
            "0b1",
            "1:30",
            "1:30:00",
            "1_000",
            "yes",
            "no",
            "on",
            "off",
            "y",
            "True",
            "NULL",
            "Null",
        ),
        *(
            ".inf",
            "-.inf",
            ".nan",
            "inf",
            "nan",
            "2024-05-17",
            "2024-05-17 10:00:00",
            "1,5",
            "+",
            "=",
            "<<",
            "1e",
            ".",
            "e5",
            "--1",
        ),
    ],
)
def test_these_stay_text(text: str) -> None:
    """YAML 1.1 (https://yaml.org/type/) reads many of them as octal, base 60, truth values, dates
    or infinity.
    """
    assert value_of(text) == text


@pytest.mark.parametrize(
    ("text", "value"),
    [
        *(("0", 0), ("-7", -7), ("+7", 7), ("12345678901234567890", 12345678901234567890)),
        *(
            ("1.5", 1.5),
            ("-0.5", -0.5),
            (".5", 0.5),
            ("5.", 5.0),
            ("1e3", 1000.0),
            ("1.5E-3", 0.0015),
            ("+1e+2", 100.0),
        ),
        *(
            ("true", True),
            ("false", False),
            ("null", None),
            ("~", None),
            ("", None),
            ('"010"', "010"),
            ("'7'", "7"),
        ),
    ],
)
def test_these_are_values(text: str, value: object) -> None:
    read = value_of(text)
    assert read == value
    assert type(read) is type(value)


def test_keys_are_text_and_know_their_line() -> None:
    document = read_yaml(
        b"\xef\xbb\xbf# comment\n1: a\ntrue: b\nlist:\n  - x\n  - {deep: 1,\n     deeper: 2}\n",
        "f.yaml",
    )
    assert document.data == {"1": "a", "true": "b", "list": ["x", {"deep": 1, "deeper": 2}]}
    assert document.place(("1",)) == "line 2, 1"
    assert document.place(("list", 1, "deeper")) == "line 7, list[1].deeper"
    assert document.place(("list", 1, "missing", "below")) == "line 6, list[1].missing.below"
    assert document.place(("elsewhere",)) == "elsewhere"
    assert document.place(()) == ""


def test_key_path_text() -> None:
    assert key_path_text(("axes", "X", "before", 0, "files", 1)) == "axes.X.before[0].files[1]"
    assert key_path_text((0, "a")) == "[0].a"


@pytest.mark.parametrize(
    "content",
    [
        *(content for _, content in definition_files(Session())),
        *(b"a:\t1\n", b"a: [b?c, 1]\n", b"a: {b ? : c}\n", b"a: >#b\n", b"\n\xef\xbb\xbfa: 1\n"),
        *(b'a: "is it?"\n', b"a: 'is it?'\n", b"a: is it?\n", b"# is it?\na: >-\n  b # c\n"),
    ],
)
def test_the_parser_of_libyaml_changes_nothing(
    content: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is not in every installation of PyYAML, and reads some texts that the other refuses."""

    def outcome() -> object:
        try:
            return read_yaml_with_faults(content, "f.yaml")
        except InputError as error:
            return [str(fault) for fault in error.faults]

    here = outcome()
    monkeypatch.setattr(yaml, "__with_libyaml__", False)
    assert outcome() == here


def test_duplicate_keys_are_all_listed_with_both_lines() -> None:
    assert faults_of(b"a: 1\nb:\n  c: 1\n  c: 2\na: 3\n") == [
        "f.yaml: line 4, b.c: key given twice (first on line 3). Next: remove one of the two lines",
        "f.yaml: line 5, a: key given twice (first on line 1). Next: remove one of the two lines",
    ]


def test_faults_of_single_keys_leave_the_rest_readable() -> None:
    document, faults = read_yaml_with_faults(b"a: 1\na: 2\nb: 3\n", "f.yaml")
    assert document.data == {"a": 1, "b": 3}
    assert len(faults) == 1


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"# only a comment\n", "is empty"),
        (b"a: \xff", "byte 4: the file is not UTF-8"),
        ("a: ä".encode("utf-16"), "is not UTF-8"),
        (b"a: [1, 2\nb: 3\n", "line 2"),
        (b"a:\n\t- 1\n", "line 2, column 1"),
        (b"a: 1\n---\nb: 2\n", "line 2"),
        (b"a: &x [1]\nb: *x\n", "line 2: aliases"),
        (b"a: !!python/object/apply:os.system [ls]\n", "line 1: tags"),
        (b"a: !!timestamp x\n", "line 1: tags"),
        (b"a: !!int ''\n", "line 1: tags"),
        (b"a: !!set {b}\n", "line 1: tags"),
        (b"? [a, b]\n: 1\n", "single word"),
        (b'a: "\\UFFFFFFFF"\n', "an escape sequence that is not a character"),
        (b'a: "\\ud800"\n', "line 1, a contains an escape that is not a character"),
        (b"a: " + b"9" * 5000, "line 1, a cannot be read as a value"),
        (b"a: \x00", "is not valid YAML"),
        (b"[" * 50000, "nested too deeply"),
        (b"{a: " * 5000, "nested too deeply"),
    ],
)
def test_faults_name_their_place(content: bytes, words: str) -> None:
    (fault,) = faults_of(content)
    assert fault.startswith("f.yaml: ")
    assert words in fault


def is_plain(value: object) -> bool:
    if isinstance(value, dict):
        return all(type(key) is str and is_plain(inner) for key, inner in value.items())
    if isinstance(value, list):
        return all(is_plain(inner) for inner in value)
    return value is None or type(value) in (str, int, float, bool)


@given(
    st.binary(max_size=80)
    | st.text(alphabet="ab: -[]{}!&*?|>'\"\\#%@`,\n\t0123u.e", max_size=60).map(str.encode)
)
@example(b"a: !<tag:yaml.org,2002:binary> x")
@example(b"--- !!omap\n- a: 1")
@settings(max_examples=100, deadline=None)
def test_any_bytes_give_plain_data_or_an_input_error(content: bytes) -> None:
    try:
        data = read_yaml(content, "f.yaml").data
    except InputError:
        return
    assert is_plain(data)


PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**30), 10**30) | st.floats(allow_nan=False,
    allow_infinity=False)
    | st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=10),
    lambda inner: st.lists(inner, max_size=4)
    | st.dictionaries(st.text(st.characters(exclude_categories=["Cs", "Cc"]), min_size=1,
    max_size=8), inner, max_size=4),
    max_leaves=12,
)  # fmt: skip


def quoted(value: Any) -> str:
    """Return YAML in which every text stands in quotes, so that it can mean nothing else."""
    if isinstance(value, dict):
        return (
            "{" + ", ".join(f"{quoted(key)}: {quoted(inner)}" for key, inner in value.items()) + "}"
        )
    if isinstance(value, list):
        return "[" + ", ".join(quoted(inner) for inner in value) + "]"
    if isinstance(value, str):
        return yaml.dump(value, default_style='"', allow_unicode=True, width=math.inf).strip()
    return (
        {True: "true", False: "false", None: "null"}[value]
        if value is None or isinstance(value, bool)
        else repr(value)
    )


@given(PLAIN)
@settings(max_examples=60, deadline=None)
def test_what_was_written_is_read(value: Any) -> None:
    assert read_yaml(f"[{quoted(value)}]".encode(), "f.yaml").data == [value]
