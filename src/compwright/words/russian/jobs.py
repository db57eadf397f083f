"""Sentences about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": (
        "В задании под `states` есть записи {states}, но нет as_found. Запись as_found указывает,"
        " что сейчас в УЧПУ. Без неё таблица не записывается. Добавьте `as_found: none` или"
        " `as_found: [файлы УЧПУ]` под `states`"
    ),
    "CW-J003": "axes.{axis}.modulo не имеет смысла для линейной оси и не используется",
    "CW-J004": (
        "{place} не действует, потому что оси {axis} нет среди осей задания. Добавьте ось с её"
        " ходом и адресом (и с `before: []`, если у неё нет проверки позиционирования)"
    ),
    "CW-J020": "{key} не действует на этом УЧПУ ({format})",
    "CW-J021": (
        "Ключ acknowledged.{code} задания не нужен, потому что сообщения {code}{axis:if| на оси"
        " {axis}} нет. Удалите ключ."
    ),
}
