"""Words of table headers in six languages, for contents, unit and direction of a column.

A word such as "forward" gives the contents of a column but no sign: the user states whether forward
means +.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable
from itertools import pairwise
from typing import Final, Literal

from compwright.instruments.csv_table import plain_signs

Role = Literal["target", "measured", "deviation", "direction", "run", "axis"]

#: Beginnings of words (small letters, no accents) by what the column holds.
_ROLES: Final[dict[Role, tuple[str, ...]]] = {
    "deviation": (
        *("deviation", "dev", "error", "err", "abweich", "fehler", "ecart", "erreur", "отклон"),
        *("ошибк", "погрешн", "scostam", "errore", "deviazion", "desviac", "differ", "differenz"),
    ),
    "measured": (
        *("measured", "actual", "reading", "ist", "istwert", "istposition", "messwert", "gemess"),
        *(
            "mesure",
            "reel",
            "reelle",
            "измерен",
            "факт",
            "действит",
            "misurat",
            "effettiv",
            "reale",
        ),
        *("medid", "medicion", "laser"),
    ),
    "target": (
        *("target", "nominal", "nom", "command", "position", "pos", "soll", "sollwert", "ziel"),
        *(
            "sollposition",
            "nennwert",
            "cible",
            "consigne",
            "theorique",
            "задан",
            "целев",
            "номинал",
        ),
        *("позици", "координат", "posizion", "nominale", "quota", "teoric", "objetivo", "posicion"),
        *("consigna", "punto"),
    ),
    "direction": (
        *("direction", "dir", "approach", "richtung", "anfahr", "sens", "approche", "направлен"),
        *("подход", "direzion", "verso", "senso", "sentido", "direccion"),
    ),
    "run": (
        *("run", "cycle", "traverse", "pass", "lauf", "zyklus", "messung", "durchgang", "reihe"),
        *("messreihe", "passage", "serie", "прогон", "цикл", "проход", "серия", "ciclo", "corsa"),
        *(
            "prova",
            "passata",
            "pasada",
            "ensayo",
            "nr",
            "no",
            "repeat",
            "repetition",
            "wiederholung",
        ),
        *("ripetizione", "repeticion", "повтор"),
    ),
    "axis": ("axis", "achse", "axe", "ось", "asse", "eje"),
}
#: Words that are a sign by themselves: + is up, towards larger positions.
_UP: Final = frozenset(
    {
        *("+", "pos", "positive", "positiv", "positif", "positivo", "plus", "up", "↑", "auf"),
        *("aufwarts", "steigend", "montee", "montant", "вверх", "плюс", "положительное"),
        *("salita", "su", "subida", "piu", "mas", "+1", "положит", "rising", "ascending"),
    }
)
_DOWN: Final = frozenset(
    {
        *("-", "neg", "negative", "negativ", "negatif", "negativo", "minus", "down", "↓", "ab"),
        *("abwarts", "fallend", "descente", "descendant", "вниз", "минус", "отрицательное"),
        *("discesa", "giu", "bajada", "meno", "menos", "-1", "moins", "отрицат", "falling"),
        "descending",
    }
)
#: Words of a way out or back: which of them is + the table does not say.
_OUT: Final = frozenset(
    {
        *("forward", "fwd", "fw", "f", "vor", "vorwarts", "hin", "hinfahrt", "hinweg", "avant"),
        *("aller", "вперед", "прямой", "прямое", "прямо", "туда", "avanti", "andata", "adelante"),
        *("ida", "out", "vorlauf", "прям"),
    }
)
_BACK: Final = frozenset(
    {
        *("reverse", "rev", "backward", "back", "bwd", "bw", "r", "b", "ruck", "ruckwarts", "her"),
        *("zuruck", "ruckfahrt", "ruckweg", "arriere", "retour", "назад", "обратный", "обратное"),
        *("обратно", "indietro", "ritorno", "atras", "vuelta", "rucklauf", "обрат"),
    }
)
_UNITS: Final[dict[str, str]] = {
    **dict.fromkeys(("um", "µm", "μm", "мкм", "micron", "microns", "mikron", "mikrometer"), "um"),
    **dict.fromkeys(("mm", "мм"), "mm"),
    **dict.fromkeys(("nm", "нм"), "nm"),
    **dict.fromkeys(("deg", "°", "grad", "degree", "degrees", "град", "gradi", "grados"), "deg"),
    **dict.fromkeys(("arcsec", "arc-sec", "arcsecond", "arcseconds", "угл.с"), "arcsec"),
    **dict.fromkeys(("arcmin", "arc-min"), "arcmin"),
    **dict.fromkeys(("urad", "µrad", "μrad", "мкрад"), "urad"),
    **dict.fromkeys(("mrad", "мрад"), "mrad"),
    **dict.fromkeys(("in", "inch", "inches", "zoll", "дюйм"), "in"),
}
#: Words before a unit in a line above a table.
_UNIT_WORDS: Final = re.compile(r"\b(?:units?|einheit|unite|ед|единица|единицы|unita|unidad)\b")
#: A unit behind the word ``in`` (German, English, Italian) or ``en`` (French, Spanish), or in
#: brackets.
_IN_UNIT: Final = re.compile(r"(?:\b(?:in|en|в)\s+|[\[(])\s*([^\s;,\])]+)", re.IGNORECASE)
_BRACKETS: Final = re.compile(r"[\[({/]\s*([^\])}]+?)\s*[\])}]?\s*$")
#: No header of a column and no line above a table tells anything beyond so many characters.
_LONGEST: Final = 500
_WORD: Final = re.compile(r"[^\W\d_]+", re.UNICODE)
#: Words that say which way round a deviation is taken: what is first less what is second.
_DIFFERENCE: Final = re.compile(
    r"(?P<first>[^\W\d_]+)\.?\s*(?:position|wert|value|pos)?\s*"
    r"(?:-|minus|moins|меньше|минус|meno|menos)\s*(?P<second>[^\W\d_]+)"
)


#: A name of an axis in free text; two letters may as well be a word.
_AXIS: Final = re.compile(r"[A-Z][0-9]{0,2}")


def axis_above(lines: Iterable[str]) -> str:
    """Return the axis in a line above a table, such as ``Achse: X``, else ""."""
    for line in lines:
        words = [word for word in line.replace(";", " ").replace(":", " ").split() if word]
        for one, other in pairwise(words):
            name = other.strip('",.')
            if role_of(one) == "axis" and _AXIS.fullmatch(name):
                return name
    return ""


def plain(text: str) -> str:
    """Return ``text`` in lower case, without accents, with plain signs and single blanks."""
    flat = unicodedata.normalize("NFKD", plain_signs(text[:_LONGEST]).casefold().replace("й", "и"))
    bare = "".join(mark for mark in flat if not unicodedata.combining(mark))
    return " ".join(bare.replace("ß", "ss").split())


def role_of(header: str) -> Role | None:
    """Return the kind of contents of a column (such as target or run) by the words in its header,
    or None if no word is known.
    """
    words = _WORD.findall(plain(without_unit(header)))
    for role, beginnings in _ROLES.items():
        for word in words:
            if any(
                word == start or (len(start) > 3 and word.startswith(plain(start)))
                for start in map(plain, beginnings)
            ):
                return role
    return None


def without_unit(header: str) -> str:
    """Return a header without the unit in brackets at its end."""
    match = _BRACKETS.search(header[:_LONGEST])
    return header[: match.start()] if match and unit_of(match[1]) else header


def unit_of(text: str) -> str:
    """Return the unit at the end of a text, in brackets, or as the whole text; else ""."""
    text = text[:_LONGEST]
    inside = re.findall(r"[\[({]\s*([^\])}]+?)\s*[\])}]", text)
    for part in (text, *inside, text.rpartition(" ")[2], text.rpartition("_")[2]):
        unit = _UNITS.get(part.strip(" .[](){}").casefold())
        if unit:
            return unit
    return ""


def is_unit(text: str) -> bool:
    """Return whether a text is only a unit."""
    return text.strip(" .[](){}").casefold() in _UNITS


def stated_unit(line: str) -> str:
    """Return the unit that a line above a table states, such as ``Einheit: µm`` or ``Abweichungen
    in µm``; "" if it states none.
    """
    titled = {unit for match in _IN_UNIT.finditer(line) if (unit := unit_of(match[1]))}
    if not _UNIT_WORDS.search(plain(line)):
        # a line with a number speaks of a limit or a result
        title = role_of(line) == "deviation" and not any(map(str.isdigit, line))
        return titled.pop() if title and len(titled) == 1 else ""
    found = {unit for word in re.split(r"[\s:;,=]+", line) if (unit := unit_of(word))}
    found -= {"in"} if titled else set()  # a preposition, no inch
    return found.pop() if len(found) == 1 else ""


def sign_word(text: str) -> str:
    """Return the direction that a word means: ``+`` or ``-``; ``out`` or ``back`` if the word does
    not state the sign; "" for any other word.
    """
    found = {
        sign
        for word in re.findall(r"[^\W\d_]+|[+-](?![0-9])|[↑↓]|(?<![0-9])[+-]1$", plain(text))
        for sign, known in (("+", _UP), ("-", _DOWN), ("out", _OUT), ("back", _BACK))
        if word in known
    }
    return found.pop() if len(found) == 1 else ""


def difference_of(text: str) -> str:
    """Return the sign convention that a text such as ``Ist - Soll`` states ("measured minus target"
    or "target minus measured"), or "" if it states none.
    """
    for match in _DIFFERENCE.finditer(plain(text)):
        roles = (role_of(match["first"]), role_of(match["second"]))
        if roles == ("measured", "target"):
            return "measured minus target"
        if roles == ("target", "measured"):
            return "target minus measured"
    return ""
