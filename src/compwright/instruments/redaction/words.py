"""Decide which words stay in a redacted file: numbers, units, dates, axes, and a fixed list."""

from __future__ import annotations

import re
from typing import Final

from compwright.instruments.header_words import plain

_NUMBER: Final = r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?"
_NUMBERS: Final = re.compile(rf"\s*{_NUMBER}(?:(?:\s*[,;]\s*|\s+){_NUMBER})*\s*")
_ONE_NUMBER: Final = re.compile(rf"\s*{_NUMBER}\s*")
_MONTHS: Final = (
    r"(?:jan(?:uary|uar|vier)?|feb(?:ruary|ruar)?|mar(?:ch|s)?|märz|apr(?:il)?|may|mai|june?|juni|"
    r"july?|juli|aug(?:ust)?|sep(?:t|tember)?|o[ck]t(?:ober)?|nov(?:ember)?|de[cz](?:ember)?)\.?"
)
_TIME: Final = r"[0-9]{1,2}[:.][0-9]{2}(?:[:.][0-9]{2}(?:[.,][0-9]{1,6})?)?(?:\s*(?:[ap]m|uhr|h))?"
_DAY: Final = (
    r"(?:[0-9]{1,4}[-./ ][0-9]{1,2}[-./ ][0-9]{1,4}|(?:19|20)[0-9]{6}"
    rf"|[0-9]{{1,2}}\.?[ -]{_MONTHS}[ -][0-9]{{2,4}}|{_MONTHS} [0-9]{{1,2}},? [0-9]{{2,4}})"
)
_ZONE: Final = r"(?:\s*(?:Z|[+-][0-9]{2}:?[0-9]{2}))?"
_DATE: Final = re.compile(
    rf"{_DAY}(?:[T ,_-]*(?:{_TIME}|[0-9]{{6}}|[0-9]{{4}}))?{_ZONE}|{_TIME}{_ZONE}(?:,?\s+{_DAY})?",
    re.IGNORECASE,
)
#: What people call the date of a measurement.
DATE_WORDS: Final = (
    *(
        "date",
        "datum",
        "messdatum",
        "prüfdatum",
        "uhrzeit",
        "zeit",
        "time",
        "fecha",
        "data",
        "дата",
    ),
    *("date/time", "date time", "datum/uhrzeit", "test date", "measured on", "gemessen am"),
)
_DATED: Final = re.compile(
    rf"""(?:^|(?<=[;,\t|"#]))\s*(?P<key>{"|".join(DATE_WORDS)})\s*[:=;,\t|"]+\s*"""
    rf"""(?P<date>{_DATE.pattern})\s*(?=$|[;,\t|"])""",
    re.IGNORECASE,
)
#: A name of an axis as controls have them.
_AXIS: Final = re.compile(r"(?:[A-Z]{1,2}|AX|MA_[A-Z]|CA_[A-Z])[0-9]{0,2}", re.IGNORECASE)
_UNITS: Final = (
    *("nm", "um", "µm", "μm", "mm", "cm", "m", "mkm", "мкм", "мм", "нм", "in", "inch", "inches"),
    *("micron", "microns", "metric", "deg", "degree", "degrees", "grad", "град", "°", "arcsec"),
    *("arcmin", "arcsecond", "arcseconds", "urad", "µrad", "μrad", "mrad", "rad", "mkrad", "мкрад"),
    *("mrad", "c", "°c", "k", "ppm", "ms", "s", "min", "hz", "%", "um/m", "mm/min", "um/(m", "k)"),
)
_WORDS: Final = (
    # key lines and their values
    *("measured", "minus", "target", "standard", "step", "yes", "no", "true", "false", "none"),
    *("material", "temperature", "expansion", "scale", "machine", "workpiece", "air", "pressure"),
    *("humidity", "compensation", "positioning", "circular", "linear", "angular", "rotary"),
    *("virtual", "ballbar", "na", "n/a", "as", "errors", "error", "corrections", "correction"),
    *("absolute", "incremental", "combined", "forward", "reverse", "separate", "and", "tables"),
    *("table", "bidirectional", "unidirectional", "backward", "rtl", "rta", "iso", "ccw", "cw"),
    # headers of columns, in the languages in which they are understood
    *("targets", "nominal", "nom", "command", "commanded", "position", "positions", "pos"),
    *("soll", "sollwert", "sollposition", "ziel", "zielposition", "nennwert", "cible", "consigne"),
    *("theorique", "задано", "заданная", "заданное", "целевая", "номинал", "позиция", "координата"),
    *("posizione", "nominale", "quota", "teorica", "objetivo", "posicion", "consigna", "punto"),
    *("deviation", "deviations", "dev", "err", "abweichung", "abweichungen", "fehler", "ecart"),
    *("erreur", "отклонение", "отклонения", "ошибка", "погрешность", "scostamento", "errore"),
    *("deviazione", "desviacion", "difference", "differenz", "actual", "reading", "readings"),
    *("ist", "istwert", "istposition", "messwert", "gemessen", "mesure", "reel", "reelle"),
    *("измерено", "измеренная", "измеренное", "факт", "фактическая", "действительная", "misurato"),
    *("misurata", "effettiva", "reale", "medida", "medido", "medicion", "laser", "direction"),
    *("dir", "approach", "richtung", "anfahrrichtung", "sens", "approche", "направление"),
    *("подход", "direzione", "verso", "senso", "sentido", "direccion", "run", "runs", "cycle"),
    *("cycles", "traverse", "pass", "lauf", "zyklus", "messung", "durchgang", "reihe"),
    *("messreihe", "passage", "serie", "прогон", "цикл", "проход", "серия", "ciclo", "corsa"),
    *("prova", "passata", "pasada", "ensayo", "nr", "repeat", "repetition", "wiederholung"),
    *("ripetizione", "repeticion", "повтор", "axis", "achse", "axe", "ось", "asse", "eje"),
    *("point", "punkt", "value", "wert", "mean", "mittelwert", "unit", "units", "einheit"),
    *("unite", "единица", "единицы", "unita", "unidad", "time", "zeit", "temperatur", "delta"),
    *("angle", "radius", "count", "start", "end", "spacing", "column", "of", "the", "in", "to"),
    # directions
    *("positive", "positiv", "positif", "positivo", "plus", "up", "auf", "aufwarts", "steigend"),
    *("montee", "montant", "вверх", "плюс", "salita", "su", "subida", "piu", "mas", "rising"),
    *("ascending", "neg", "negative", "negativ", "negatif", "negativo", "down", "ab", "abwarts"),
    *("fallend", "descente", "descendant", "вниз", "минус", "discesa", "giu", "bajada", "meno"),
    *("menos", "moins", "falling", "descending", "fwd", "fw", "vor", "vorwarts", "hin", "hinfahrt"),
    *("hinweg", "avant", "aller", "вперед", "прямой", "прямое", "прямо", "туда", "avanti"),
    *("andata", "adelante", "ida", "out", "vorlauf", "rev", "back", "bwd", "bw", "ruck"),
    *("ruckwarts", "her", "zuruck", "ruckfahrt", "ruckweg", "arriere", "retour", "назад"),
    *("обратный", "обратное", "обратно", "indietro", "ritorno", "atras", "vuelta", "rucklauf"),
)
#: Words that may stay in a measurement file, in lower case without accents.
KEPT_WORDS: Final = frozenset(
    {plain(word) for word in (*_WORDS, *_UNITS)}
    | {plain(word) for words in DATE_WORDS for word in re.findall(r"[^\W\d_]+", words)}
    | {"angle", "radius", "time"}
)
#: Pieces of the names that the instrument's software gives its results.
RESULT_WORDS: Final = frozenset(
    {
        *("4", "5", "54", "57", "1996", "2005", "A", "AF", "ANSI", "B", "BACKLASH"),
        *("BEST", "BIDIRECTIONAL", "CALCULATED", "CCW", "CENTRE", "CHANGE", "CIRCULAR"),
        *("CIRCULARITY", "COMMENT", "CW", "CYCLIC", "DEVIATION", "DIAGNOSTICS", "ERROR"),
        *("ERRORS", "FAILED", "FEEDRATE", "FWD", "GLOBAL", "HYSTERESIS", "IC", "ISO230"),
        *("JIS", "LATERAL", "LENGTH", "LOCATION", "LOWER", "MAX", "MEAN", "MIN"),
        *("MISMATCH", "MM", "NEG", "NON", "OFFSET", "OK", "PERC", "PERCENT", "PHASE"),
        *("PITCH", "PLAY", "POS", "POSITIONAL", "PRE", "POST", "RADIAL", "RADIUS"),
        *("RANK", "RANKING", "READINGS", "RENISHAW", "REV", "REVERSAL", "RMS"),
        *("ROUNDNESS", "SCALE", "SERVO", "SHIFT", "SIMULATED", "SIN", "SPIKES"),
        *("SQUARENESS", "STRAIGHTNESS", "TEST", "THETA", "TOLERANCE", "UM", "UPPER"),
        *("UT", "ANGLE", "VOLUMETRIC", "WARNING"),
    }
)
_TOKEN: Final = re.compile(r"[^\W\d_]+|[0-9]+|\s+|.", re.DOTALL)
_MARKS: Final = frozenset("+-*/=.,:;()[]{}<>%°#_±↑↓|'\"")


def is_numbers(text: str) -> bool:
    """Return whether a text consists of one or several numbers."""
    return _NUMBERS.fullmatch(text) is not None


def is_one_number(text: str) -> bool:
    """Return whether a text is only a number."""
    return _ONE_NUMBER.fullmatch(text) is not None


def is_date(text: str) -> bool:
    """Return whether a text is a date, a time, or both."""
    return _DATE.fullmatch(text.strip()) is not None


def without_dates(text: str) -> tuple[list[str], str]:
    """Return the dates in a text that are marked as dates of the measurement, and the text without
    them.

    Each date is returned with the word that marks it. Any other date stays in the text, because it
    may be private.
    """
    dated = [f"{found['key']}: {found['date']}" for found in _DATED.finditer(text)]
    return dated, _DATED.sub("", text)


def is_axis(text: str) -> bool:
    """Return whether a text is the name of an axis (``X``, ``X1``, ``AX12``), not a word."""
    return _AXIS.fullmatch(text.strip()) is not None


def is_keywords(text: str, *, digits: int = 2) -> bool:
    """Return whether a text has only permitted words, units, letters, punctuation and numbers of at
    most ``digits`` digits.
    """
    for token in _TOKEN.findall(text):
        if token.isspace() or token in _MARKS:
            continue
        if token.isdigit():
            if len(token) > digits:
                return False
        elif plain(token) not in KEPT_WORDS and not (len(token) == 1 and token.isalpha()):
            return False
    return True


def is_quantity(text: str) -> bool:
    """Return whether a text consists only of numbers, of a number with its unit (``25 mm``), or of
    permitted words such as ``As errors``.
    """
    number, _, unit = text.strip().partition(" ")
    return is_numbers(text) or (is_one_number(number) and is_keywords(unit)) or is_keywords(text)


def is_result(text: str) -> bool:
    """Return whether a text is a name or a unit that the instrument's software gives to results."""
    return all(piece in RESULT_WORDS for piece in text.upper().replace("-", "_").split("_"))
