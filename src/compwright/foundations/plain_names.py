"""Names that are valid as part of a file name on every system."""

from __future__ import annotations

from typing import Final

#: What a plain name is, for messages.
PLAIN_NAME: Final = 'a plain name: characters that can be printed, none of / \\ : * ? " < > |'
#: What Windows, and with it a memory card, allows in no file name.
_FORBIDDEN: Final = frozenset('/\\:*?"<>|')


def is_plain_name(text: str) -> bool:
    """Return whether a text is valid as a file name everywhere, without a folder or drive."""
    return (
        bool(text.strip())
        and text == text.rstrip(". ")
        and text.isprintable()
        and not _FORBIDDEN.intersection(text)
    )
