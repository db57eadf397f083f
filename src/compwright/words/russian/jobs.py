"""What is noticed about a job."""

from __future__ import annotations

from typing import Final

SENTENCES: Final[dict[str, str]] = {
    "CW-J002": "states называет {states}, но не as_found: без него таблица не записывается",
    "CW-J003": "axes.{axis}.modulo не имеет смысла для линейной оси и не используется",
    "CW-J004": (
        "{place} ничего не делает: оси {axis} нет среди осей задания, где указаны её ход и адрес"
        " (before: [], если у неё нет проверки позиционирования)"
    ),
    "CW-J020": "{key} не действует на этом УЧПУ ({format})",
    "CW-J021": (
        "acknowledged.{code} не нужно: ничего такого не найдено{axis:if| на оси {axis}}. Удалите из"
        " задания."
    ),
}
