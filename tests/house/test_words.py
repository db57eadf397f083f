"""The catalogue of sentences against the source: each sentence that is asked for is there with all
its values, and each that is there is asked for.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter

import jinja2.nodes
import pytest

from compwright.formats.definition.schema import CardRule, Definition, LookRule
from compwright.words.sentences import (
    Language,
    catalogue,
    control_texts,
    filled,
    parts,
    placeholders,
)
from format_samples import DEFINITIONS
from places import PROJECT
from source_trees import nodes_below, trees

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "benchmarks"))

from findings_page import page

TEMPLATES = PROJECT / "src" / "compwright" / "reporting" / "templates"
PAGE = PROJECT / "docs" / "findings.md"

#: What a choice without a key stands for.
ANY = {key for text in catalogue("en").values() for key in re.findall(r"[|]([\w -]+)=", text)}
OTHERS: tuple[Language, ...] = ("de", "fr", "ru")

#: Methods that hand the name of a sentence on.
HANDED_ON = {"foundations.findings", "formats.text.notes", "planning.cross"}


@cache
def asked() -> tuple[tuple[str, str, frozenset[str]], ...]:
    """Return place, name and given values of each sentence that the source or a template asks
    for.
    """
    return (*_asked_in_templates(), *_asked_in_source())


def _asked_in_templates() -> Iterator[tuple[str, str, frozenset[str]]]:
    for path in sorted(TEMPLATES.glob("*.html")):
        tree = jinja2.Environment(autoescape=True).parse(path.read_text(encoding="utf-8"))
        for call in tree.find_all(jinja2.nodes.Call):
            if isinstance(call.node, jinja2.nodes.Name) and call.node.name == "say":
                (name,) = call.args
                assert isinstance(name, jinja2.nodes.Const), path.name
                given = frozenset(word.key for word in call.kwargs)
                yield f"{path.name}:{call.lineno}", name.value, given


def _asked_in_source() -> tuple[tuple[str, str, frozenset[str]], ...]:
    return tuple(
        (f"{module}:{node.lineno}", name, frozenset(word.arg or "**" for word in node.keywords))
        for module, tree in trees().items()
        for node in nodes_below(tree)
        if isinstance(node, ast.Call) and _says(node)
        for name in _names(node.args[0])
    )


def _says(call: ast.Call) -> bool:
    function = call.func
    last = function.attr if isinstance(function, ast.Attribute) else getattr(function, "id", "")
    if not call.args or last not in ("say", "of", "find"):
        return False
    called = ast.unparse(function)
    if called in ("say", "Finding.of"):
        return True
    return called.endswith(".find") and any(name.startswith("CW-") for name in _names(call.args[0]))


def _names(node: ast.expr) -> Iterator[str]:
    """Yield the names that an argument may be; one that is computed has none."""
    if isinstance(node, ast.IfExp):
        yield from _names(node.body)
        yield from _names(node.orelse)
    elif isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.Name) and node.id.isupper():
        yield f"constant {node.id}"


def test_each_sentence_that_is_asked_for_is_in_the_catalogue() -> None:
    missing = {(place, name) for place, name, _ in asked() if name not in catalogue("en")}
    assert missing == set()


def test_each_sentence_of_the_catalogue_is_asked_for() -> None:
    assert set(catalogue("en")) - {name for _, name, _ in asked()} == set()


def test_each_value_of_a_sentence_is_given() -> None:
    lacking = {
        (place, name): wanted
        for place, name, given in asked()
        if (wanted := placeholders(catalogue("en").get(name, "")) - given)
    }
    assert lacking == {}


def test_each_name_of_a_sentence_is_written_out_where_it_is_asked_for() -> None:
    computed = {
        module
        for module, tree in trees().items()
        for node in nodes_below(tree)
        if isinstance(node, ast.Call) and _says(node) and not list(_names(node.args[0]))
    }
    assert computed == HANDED_ON


@pytest.mark.parametrize("language", OTHERS)
def test_each_language_has_every_sentence_and_no_name_of_its_own(language: Language) -> None:
    assert set(catalogue(language)) == set(catalogue("en"))


@cache
def texts_of_controls() -> frozenset[str]:
    """Return the English templates of the families and of every definition that ships."""
    asked = (
        node.args[0]
        for tree in trees().values()
        for node in nodes_below(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Name)
        and node.func.id == "control_text"
    )
    of_source = {ast.literal_eval(template) for template in asked}
    return frozenset(of_source.union(*map(_texts_of, DEFINITIONS.values())) - {""})


def _texts_of(definition: Definition) -> set[str]:
    steps = (*definition.card, *definition.restore)
    looks = [rule for rules in definition.look_at.values() for rule in rules]
    shown: list[CardRule | LookRule] = [*steps, *looks]
    bindings = definition.bindings.values()
    typed = {getattr(rule, "typed", "") or "" for rule in bindings}
    return {
        definition.title,
        *_sources_on_pages(definition),
        *(default for option in definition.options.values() if (default := _word(option.default))),
        *(text.strip() and text for one in shown for text in (one.text, one.two_curves)),
        *(step.title for step in steps),
        definition.diameter.card,
        definition.between_axes.instead or "",
        *typed,
    }


def _sources_on_pages(definition: Definition) -> set[str]:
    """Return the sources of the facts that a run may have to assume."""
    absent = [rule.when_absent for rule in definition.bindings.values() if rule.when_absent]
    notes = [
        *(rule.evidence for rule in absent if rule.say != "nothing"),
        *(
            one.evidence
            for one in definition.options.values()
            if one.evidence.state == "unconfirmed"
        ),
        *(one.evidence for one in definition.limits if one.predicate == "feed_per_spacing"),
        *([definition.addresses.evidence] if definition.addresses.letters else []),
        *(
            [definition.layout.evidence]
            if definition.layout.evidence.state == "unconfirmed"
            else []
        ),
    ]
    return {note.source for note in notes}


def _word(default: object) -> str:
    return default if isinstance(default, str) and re.fullmatch("[a-z_]{3,}|no", default) else ""


@pytest.mark.parametrize("language", OTHERS)
def test_each_language_has_every_text_of_the_controls_with_its_fields(language: Language) -> None:
    texts = control_texts(language)
    assert set(texts) == texts_of_controls()
    fields = re.compile(r"[{][a-z_0-9]+[}]")
    differing = {
        text for text, own in texts.items() if {*fields.findall(text)} != {*fields.findall(own)}
    }
    assert differing == set()


#: Words that a language may have of its own.
COMMON = {"NC", "PC"}
#: Names in a text that no language translates: parameters, options, files, commands.
NAMES = re.compile(
    r"`[^`]+`|[$#]?\b\w*(?:[A-Z]{2}|\d{3}|_)\w*\b|\b\w+\[|\b[a-z]+[A-Z]\w+|(?<!\w)[/.]\w+"
)


@pytest.mark.parametrize("language", OTHERS)
def test_each_text_of_the_controls_keeps_its_names_and_numbers(language: Language) -> None:
    """A parameter that a translation lost, or changed, is typed wrong at a machine."""
    lost = {
        text: names
        for text, own in control_texts(language).items()
        if (names := {name for name in NAMES.findall(text) if name not in own} - COMMON)
    }
    assert lost == {}


FORMS: dict[Language, int] = {"en": 2, "de": 2, "fr": 2, "ru": 3}


@pytest.mark.parametrize("language", FORMS)
def test_each_sentence_has_every_form_of_its_words(language: Language) -> None:
    """As many plurals as the language has, a text for each choice of the English sentence."""
    english = catalogue("en")
    wrong = {
        name: (field, texts)
        for name, template in catalogue(language).items()
        for field, how, texts in _fields(template)
        if (how == "plural" and len(texts) != FORMS[language])
        or (how == "if" and len(texts) not in (1, 2))
        or (how == "choose" and not _keys(texts) >= _choices(english[name], field))
    }
    assert wrong == {}


def _fields(template: str) -> Iterator[tuple[str, str, list[str]]]:
    for _, field, form, _ in Formatter().parse(template):
        if field:
            how, *texts = parts(form or "")
            yield field, how, texts
            for text in texts:
                yield from _fields(text)


def _keys(texts: list[str]) -> set[str]:
    keys = {text.partition("=")[0] for text in texts}
    return keys | ANY if "" in keys else keys


def _choices(template: str, field: str) -> set[str]:
    """Return the keys of a field that all choices of the English sentence have."""
    every = [
        _keys(texts) - {""}
        for one, how, texts in _fields(template)
        if one == field and how == "choose"
    ]
    return set.intersection(*every) if every else set()


@pytest.mark.parametrize("language", OTHERS)
def test_each_sentence_has_only_values_of_the_english_one(language: Language) -> None:
    differing = {
        name: sorted((placeholders(text) ^ placeholders(catalogue("en")[name])) - {"term"})
        for name, text in catalogue(language).items()
    }
    assert {name: values for name, values in differing.items() if values} == {}


# Unicode CLDR 45, language plural rules (cardinal): de and en one: i = 1; fr one: i = 0, 1; ru one:
# 1, 21, 31, 101; few: 2-4, 22-24; many: 0, 5-20, 111; a fraction goes with the genitive singular.
@pytest.mark.parametrize(
    ("language", "forms"),
    [
        ("en", {0: "b", 1: "a", 2: "b"}),
        ("de", {0: "b", 1: "a", 2: "b"}),
        ("fr", {0: "a", 1: "a", 1.5: "a", 2: "b"}),
        (
            "ru",
            {0: "c", 1: "a", 2: "b", 4: "b", 5: "c", 11: "c", 12: "c", 14: "c", 20: "c", 21: "a"}
            | {22: "b", 25: "c", 101: "a", 111: "c", 112: "c", 1.5: "b"},
        ),
    ],
)
def test_the_form_of_a_word_goes_with_its_number(
    language: Language, forms: dict[float, str]
) -> None:
    template = "{n:plural|a|b|c}"
    assert {number: filled(template, {"n": number}, language) for number in forms} == forms


def test_the_page_of_findings_is_that_of_the_catalogue() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert page(text) == text
    assert not re.search(r"^\| `CW-[A-Z]+\d+` \| \?", text, re.MULTILINE), "a severity is missing"
