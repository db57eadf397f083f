"""Sentences in several languages: a sentence is stored as the name of a template and its values,
and becomes text by the template of a language.

A template is text with fields. ``{name}`` inserts a value, in the form behind a colon:

- a number format of Python (``.2f``, ``+.1f``, ``g``, ``.0%``), or ``2sig``: significant digits,
  never an exponent; ``+2sig``: with its sign
- ``key``: a number as the value of a key in the job, with a decimal point in every language
- ``odds``: odds to 1, one significant digit; no number beyond a million
- ``and``, ``join|; ``: the text between the items of a list; by default commas, each item in the
  number format that is given
- ``plural|target|targets``: the form for this number; a language may have more than two forms
- ``if|text|other text``: the first text if the value is not zero or empty, else the other
- ``capital``: a text with its first letter as a capital
- ``choose|key=text|other key=text|=text``: the text of the key that equals the value; the text
  without a key is for any other value. Each text may contain fields
"""

from __future__ import annotations

import re
import string
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from decimal import Decimal
from functools import cache
from typing import Any, Final, Literal, Self, TypeAlias

Language = Literal["en", "de", "fr", "ru"]

_PARSED: Final = string.Formatter()
#: Digits of a number: more than any instrument has, fewer than the arithmetic.
_DIGITS: Final = 9
_OUTSIDE: Final = {"µm": "um"}
#: A field of a control's text.
_FIELD: Final = re.compile(r"\{([a-z_][a-z0-9_]*)\}")
#: Odds beyond which no number is given; capped ones may lie a rounding below.
_MOST_ODDS: Final = 0.999e6


def _russian_plural(number: float) -> int:
    """Return which of the three Russian plural forms a number needs: 0 for 1, 1 for 2, 2 for 5."""
    if number != int(number):
        return 1
    tens, ones = int(abs(number)) % 100, int(abs(number)) % 10
    if 10 < tens < 20:
        return 2
    return 0 if ones == 1 else 1 if 2 <= ones <= 4 else 2


#: Which form of a word goes with a number: as many forms as the language has.
_PLURAL: Final[dict[Language, Callable[[float], int]]] = {
    "en": lambda number: int(number != 1),
    "de": lambda number: int(number != 1),
    "fr": lambda number: int(abs(number) >= 2),
    "ru": _russian_plural,
}
_DECIMAL_MARK: Final[dict[Language, str]] = {"en": ".", "de": ",", "fr": ",", "ru": ","}
#: A date and time as an instrument writes them: 20251206-071745.
_COMPACT_DATE: Final = re.compile(r"\b(\d{4})(\d\d)(\d\d)-(\d\d)(\d\d)(\d\d)\b")
_ISO_DATE: Final = re.compile(r"\b(\d{4})-(\d{2})-(\d{2})")
_DATE: Final[dict[Language, str]] = {
    "en": r"\g<0>",
    "de": r"\3.\2.\1",
    "fr": r"\3/\2/\1",
    "ru": r"\3.\2.\1",
}
_AND: Final[dict[Language, str]] = {"en": " and ", "de": " und ", "fr": " et ", "ru": " и "}
#: Units and symbols that a language writes in its own way, where English has words in them.
_SYMBOLS: Final = {
    "mean B": "B̄", "Ps mean": "P̄s", "U mean": "Ū", "Ps max": "Ps,max", "U max": "Umax",
    "arcsec": "″", "deg": "°", "ccw": "↺", "cw": "↻",
    "arcsec/m": "″/m", "µm/deg": "µm/°", "arcsec/deg": "″/°",
}  # fmt: skip
_RUSSIAN_UNITS: Final = {
    "µm": "мкм", "mm": "мм", "m": "м", "µm/m": "мкм/м", "µm/(m K)": "мкм/(м·К)",
    "mm/min": "мм/мин", "ms": "мс", "K": "К", "Hz": "Гц", "arcsec/m": "″/м", "µm/deg": "мкм/°",
}  # fmt: skip
_OWN_NAMES: Final[dict[Language, dict[str, str]]] = {
    "en": {},
    "de": _SYMBOLS,
    "fr": _SYMBOLS,
    "ru": {**_SYMBOLS, **_RUSSIAN_UNITS},
}
#: Units that follow their number without a blank.
_CLOSE: Final = frozenset("°″")
_MORE_THAN: Final[dict[Language, str]] = {
    "en": "more than",
    "de": "mehr als",
    "fr": "plus de",
    "ru": "более",
}


class NumberText(str):
    """A number as English text, which can be written with another language's decimal mark."""

    __slots__ = ()

    def text(self, language: Language) -> str:
        """Return the number with the decimal mark of the language."""
        return str(self).replace(".", _DECIMAL_MARK[language])


class DateText(str):
    """A text with an ISO 8601 date, which can be written as another language writes dates."""

    __slots__ = ()

    def text(self, language: Language) -> str:
        """Return the text with its date as the language writes it."""
        text = _COMPACT_DATE.sub(r"\1-\2-\3 \4:\5:\6", self)
        return _ISO_DATE.sub(_DATE[language], text)


@dataclass(frozen=True, slots=True)
class Amount:
    """A number with its unit (µm, arcsec, mm, deg) and the format in which it is printed."""

    value: float
    unit: str
    form: str = ".2f"

    def __str__(self) -> str:
        """Return the text in English."""
        return self.text("en")

    def text(self, language: Language) -> str:
        """Return number and unit as text in a language."""
        unit = in_language(self.unit, language)
        between = "" if unit in _CLOSE else " "
        return f"{number_text(self.value, self.form, language)}{between}{unit}".rstrip()


@dataclass(frozen=True, slots=True)
class Sentence:
    """The name of a template in the catalogue, with the values to fill in.

    A value is a number, a text, an `Amount`, another sentence, None, or a tuple of these.
    """

    name: str
    values: tuple[tuple[str, Any], ...] = ()

    def __str__(self) -> str:
        """Return the text in English."""
        return self.text("en")

    def text(self, language: Language) -> str:
        """Return the sentence as text in a language."""
        return filled(catalogue(language)[self.name], dict(self.values), language)

    def outside(self) -> dict[str, Any]:
        """Return the values as plain data for JSON."""
        return {name: _outside(value) for name, value in self.values}


class SentenceText(str):
    """An English text that keeps its `Sentence`, so that a page can translate it."""

    __slots__ = ("sentence",)
    sentence: Sentence

    def __new__(cls, sentence: Sentence) -> Self:
        """Return the English text of a sentence, which it keeps for translation."""
        written = super().__new__(cls, str(sentence))
        written.sentence = sentence
        return written

    def __reduce__(self) -> tuple[type[SentenceText], tuple[Sentence]]:
        """Return how to rebuild the text when copied or pickled: its class and its sentence."""
        return SentenceText, (self.sentence,)

    def text(self, language: Language) -> str:
        """Return the sentence as text in a language."""
        return self.sentence.text(language)


#: What can be inserted in a control's text; a tuple becomes a list with commas.
TextValue: TypeAlias = str | Sentence | tuple[str, ...]


class ControlText(str):
    """An English text about a control that keeps its template, so that a page can translate it."""

    __slots__ = ("template", "values")
    template: str
    values: Mapping[str, TextValue]

    def __new__(cls, template: str, values: Mapping[str, TextValue]) -> Self:
        """Return an English text that keeps its template for translation."""
        written = super().__new__(cls, _inserted(template, values, "en"))
        written.template, written.values = template, dict(values)
        return written

    def __reduce__(self) -> tuple[type[ControlText], tuple[str, Mapping[str, TextValue]]]:
        """Return how to rebuild the text when copied or pickled: its class, template and values."""
        return ControlText, (self.template, self.values)

    def text(self, language: Language) -> str:
        """Return the text in a language, or in English if there is no translation."""
        template = control_texts(language).get(self.template, self.template)
        return _inserted(template, self.values, language)

    def translated(self, language: Language) -> bool:
        """Return whether the language has a translation of this text."""
        return language == "en" or self.template in control_texts(language)


def control_text(template: str, /, **values: TextValue) -> ControlText:
    """Return the English ``template`` with its values as a text that can be translated."""
    return ControlText(template, values)


def unconfirmed(what: str) -> ControlText:
    """Return the text "unconfirmed: ``what``", the evidence of a fact that is not confirmed."""
    return control_text("unconfirmed: {what}", what=what)


def _inserted(template: str, values: Mapping[str, TextValue], language: Language) -> str:
    return _FIELD.sub(lambda field: in_language(values.get(field[1], field[0]), language), template)


def say(name: str, /, **values: object) -> Sentence:
    """Return the sentence ``name`` of the catalogue with its values."""
    return Sentence(name, tuple((key, _kept(value)) for key, value in values.items()))


def number_text(value: float, form: str, language: Language = "en") -> str:
    """Return a number as text in a template's ``form``, with the decimal mark of a language."""
    if form == "key":
        return format(value, ".10g")
    if form == "odds":
        if value > _MOST_ODDS:
            return f"{_MORE_THAN[language]} 1000000"
        form = "1sig"
    if form.endswith("%"):
        text = f"{format(value, form)[:-1]} %"
    elif form.endswith("sig"):
        digits, sign = form.removesuffix("sig").lstrip("+"), "+" if form[0] == "+" else ""
        text = format(Decimal(f"{value:.{digits}g}"), f"{sign}f")
    else:
        text = format(value, form)
    if not text.strip("-0."):  # no minus zero
        text = text.replace("-", "+" if form.startswith("+") else "")
    return text.replace(".", _DECIMAL_MARK[language])


#: What has a text of its own in each language.
_WORDED: Final = (Amount, Sentence, NumberText, DateText, SentenceText, ControlText)


def in_language(value: object, language: Language) -> str:
    """Return a sentence, number, unit or symbol, or a tuple of these, as text in a language."""
    if isinstance(value, tuple):
        return ", ".join(in_language(item, language) for item in value)
    if isinstance(value, _WORDED):
        return value.text(language)
    text = str(value)
    return _OWN_NAMES[language].get(text, text)


def catalogue(language: Language) -> Mapping[str, str]:
    """Return the templates of a language by name, loaded at the first use."""
    if language == "en":
        from compwright.words import english

        return english.SENTENCES
    from compwright.words import french, german, russian

    return {"de": german.SENTENCES, "fr": french.SENTENCES, "ru": russian.SENTENCES}[language]


def control_texts(language: Language) -> Mapping[str, str]:
    """Return a language's texts about controls by English template; none for English."""
    if language == "en":
        return {}
    from compwright.words import french, german, russian

    return {"de": german.TEXTS, "fr": french.TEXTS, "ru": russian.TEXTS}[language]


def placeholders(template: str) -> frozenset[str]:
    """Return the names of all values that occur in a template."""
    return frozenset(_names(template))


def _names(template: str) -> Iterator[str]:
    for _, field, form, _ in _PARSED.parse(template):
        if field:
            yield field
            yield from _names(form or "")


def _kept(value: Any) -> Any:
    """Return a value of a sentence with its numbers rounded, so that it is equal on every
    processor.
    """
    if value is None or isinstance(value, str | bool | int | Sentence):
        return value
    if isinstance(value, float | Decimal):
        return float(f"{value:.{_DIGITS}g}")
    if isinstance(value, Amount):
        return replace(value, value=_kept(float(value.value)))
    if isinstance(value, Iterable):
        return tuple(map(_kept, value))
    return value.item() if hasattr(value, "item") else str(value)


def filled(template: str, values: Mapping[str, Any], language: Language) -> str:
    """Return a template with its values filled in. Raises KeyError for a missing value."""
    return "".join(
        text + ("" if field is None else _field(values[field], form or "", values, language))
        for text, field, form, _ in _PARSED.parse(template)
    )


def _field(value: Any, form: str, values: Mapping[str, Any], language: Language) -> str:
    how, *texts = parts(form)
    if how == "plural":
        return filled(texts[_PLURAL[language](value)], values, language)
    if how == "if":
        return filled((*texts, "")[0 if value else 1], values, language)
    if how == "capital":
        text = in_language(value, language)
        return text[:1].upper() + text[1:]
    if how == "choose":
        keyed = dict(text.split("=", 1) for text in texts)
        key = str(value)
        return filled(keyed[key if key in keyed else ""], values, language)
    if isinstance(value, tuple):
        between = _AND[language] if how == "and" else texts[0] if how == "join" else ", "
        each = "" if how in ("and", "join") else form
        return between.join(_field(item, each, values, language) for item in value)
    return number_text(value, form, language) if form else in_language(value, language)


@cache
def parts(form: str) -> tuple[str, ...]:
    """Return the parts of a template format between bars (``|``), except bars inside fields."""
    parts, depth = [""], 0
    for character in form:
        depth += (character == "{") - (character == "}")
        if character == "|" and not depth:
            parts.append("")
        else:
            parts[-1] += character
    return tuple(parts)


def _outside(value: Any) -> Any:
    if isinstance(value, Sentence):
        return value.outside() or str(value)
    if isinstance(value, Amount):
        return {"value": _outside(value.value), "unit": _OUTSIDE.get(value.unit, value.unit)}
    if isinstance(value, tuple):
        return [_outside(item) for item in value]
    if isinstance(value, str):
        return _OUTSIDE.get(value, value)
    if isinstance(value, float):
        return value if abs(value) < float("inf") else None
    return value
