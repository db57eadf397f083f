"""How a sentence is made of a template and values, and what of it is in JSON."""

from __future__ import annotations

import json
import math
import pickle

import numpy as np
import pytest

from compwright.foundations.findings import Finding
from compwright.words.sentences import Amount, Language, Sentence, filled, placeholders, say


@pytest.mark.parametrize(
    ("template", "values", "text"),
    [
        ("{n} {n:plural|target|targets}", {"n": 1}, "1 target"),
        ("{n} {n:plural|target|targets}", {"n": 0}, "0 targets"),
        ("{n} {n:plural|target|targets}", {"n": 11}, "11 targets"),
        ("{size:.2f} µm", {"size": 2 / 3}, "0.67 µm"),
        ("{size:+.1f}", {"size": 0.04}, "+0.0"),
        ("{odds:2sig} to 1", {"odds": 1234567.0}, "1200000 to 1"),
        ("{share:.0%}", {"share": 0.173}, "17 %"),
        ("{shift:+3sig}", {"shift": 0.0001234}, "+0.000123"),
        ("{axes:and}", {"axes": ("X", "Y", "Z")}, "X and Y and Z"),
        ("{axes}", {"axes": ("X", "Y")}, "X, Y"),
        ("{why:join|; }.", {"why": ("a", "b")}, "a; b."),
        ("{files}{more:if| and {more} more}", {"files": ("a",), "more": 0}, "a"),
        ("{files}{more:if| and {more} more}", {"files": ("a",), "more": 3}, "a and 3 more"),
        ("{on:if|active|not active}", {"on": False}, "not active"),
        ("{way:choose|up=rises by {by:.1f}|down=falls}", {"way": "up", "by": 1.25}, "rises by 1.2"),
        ("{x}", {"x": Amount(1.5, "µm")}, "1.50 µm"),
        ("({left})", {"left": Sentence("as_written", (("text", "a | b {c}"),))}, "(a | b {c})"),
        ("{{X: reason}}", {}, "{X: reason}"),
    ],
)
def test_a_template_gives_its_text(template: str, values: dict[str, object], text: str) -> None:
    assert filled(template, values, "en") == text


def test_what_is_not_shown_needs_no_value_that_can_be_shown() -> None:
    assert filled("{most:if| up to {most:.2f} mm}", {"most": None}, "en") == ""


@pytest.mark.parametrize(
    ("template", "values"),
    [("{a} {b}", {"a": 1}), ("{way:choose|up=rises}", {"way": "down"}), ("{n:.1f}", {"n": "1"})],
)
def test_a_value_that_is_missing_or_of_another_kind_is_no_text(
    template: str, values: dict[str, object]
) -> None:
    with pytest.raises((KeyError, ValueError)):
        filled(template, values, "en")


@pytest.mark.parametrize("language", ["en", "de", "fr", "ru"])
def test_a_value_for_the_job_has_a_decimal_point_in_every_language(language: Language) -> None:
    table = say(
        "CW-P144",
        axis="X",
        few="",
        mine="",
        many="",
        other="",
        start=-0.5,
        end=700.25,
        spacing=12.5,
    )
    assert "`start: -0.5, end: 700.25, spacing: 12.5`" in table.text(language)
    pitch = say("CW-S049.none", suggested="", lead=12.7)
    assert "`screw_pitch: 12.7`" in pitch.text(language)


def test_placeholders_are_found_inside_of_alternatives_too() -> None:
    assert placeholders("{a:if|{b:.1f}|{c:choose|x={d}|y=}} {{e}}") == {"a", "b", "c", "d"}


def test_equal_values_make_one_finding_and_it_crosses_to_another_process() -> None:
    def made() -> Finding:
        where = np.array([1.0, 2.5])
        return Finding.of("CW-T015", "warning", targets=where, axes=("X",))

    assert len({made(), made()}) == 1
    assert pickle.loads(pickle.dumps(made())) == made()  # noqa: S301
    assert made().message == "Targets without any reading are left out: 1.0, 2.5."


def test_values_in_json_are_numbers_texts_lists_and_amounts() -> None:
    inner = say("as_written", text="in words")
    values = say(
        "paragraph",
        sentences=[inner],
        drift=Amount(1 / 3, "µm"),
        unit="µm",
        odds=np.float64(2.0),
        runs=np.int64(5),
        all=np.bool_(True),
        none=None,
        endless=math.inf,
    ).outside()
    assert json.loads(json.dumps(values, allow_nan=False)) == {
        "sentences": [{"text": "in words"}],
        "drift": {"value": 0.333333333, "unit": "um"},
        "unit": "um",
        "odds": 2.0,
        "runs": 5,
        "all": True,
        "none": None,
        "endless": None,
    }
