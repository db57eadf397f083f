"""Safe output on the terminal: control characters in names and comments are made visible.

Documents contain names from files: of programs, axes, sheets, and of files themselves. A control
character in such a name could colour, erase or rename what the user reads. A character that changes
the direction of writing could show another name.

The cells of a table are `Text` or plain strings. Both are made visible before their width is
measured, and again when the line is printed. This module loads rich.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import rich.text
from rich.console import Console, ConsoleOptions, RenderableType
from rich.rule import Rule
from rich.segment import Segment
from rich.style import Style
from rich.table import Table

from compwright.foundations.utf8 import visible, visible_lines

_WIDEST = 100_000
#: What a rule keeps free of its title.
_RULE_MARGIN = 6


class Text(rich.text.Text):
    """One line of text that is safe for a terminal."""

    def __init__(self, text: str = "", style: str | Style = "", **words: Any) -> None:
        super().__init__(visible(text), style, **words)

    def append(
        self, text: rich.text.Text | str, style: str | Style | None = None
    ) -> rich.text.Text:
        """Append a text with its control characters made visible."""
        return super().append(visible(text) if isinstance(text, str) else text, style)


class _PlainConsole(Console):
    """A rich console that prints text literally, without markup or control characters."""

    def __init__(self, **words: Any) -> None:
        super().__init__(highlight=False, markup=False, emoji=False, **words)
        self._rendering = False

    def render_str(self, text: str, **words: Any) -> rich.text.Text:
        return super().render_str(visible(text), **words)

    def render(
        self, renderable: RenderableType, options: ConsoleOptions | None = None
    ) -> Iterable[Segment]:
        segments = super().render(renderable, options)
        return segments if self._rendering else self._made_visible(segments)

    def _made_visible(self, segments: Iterable[Segment]) -> Iterator[Segment]:
        """Yield the segments of a renderable with its control characters made visible."""
        self._rendering = True
        try:
            for segment in segments:
                if segment.control:  # moves of the cursor that rich makes itself, for a bar
                    yield segment
                else:
                    yield Segment(visible_lines(segment.text), segment.style)
        finally:
            self._rendering = False


def print_renderables(renderables: Sequence[RenderableType]) -> None:
    """Print renderables on standard output: on a terminal in colour, in a file or pipe as plain
    text with uncut lines.
    """
    console = _PlainConsole()
    if console.is_terminal:
        for renderable in renderables:
            console.print(renderable)
        return
    width = max(console.width, 100)
    for renderable in renderables:
        _PlainConsole(width=max(width, _uncut_width(renderable, console))).print(renderable)


def _uncut_width(renderable: RenderableType, console: Console) -> int:
    """Return the width at which a table or text is printed without breaking a word."""
    wide = console.options.update(width=_WIDEST)
    if isinstance(renderable, Rule):
        return console.measure(renderable.title, options=wide).maximum + _RULE_MARGIN
    if not isinstance(renderable, Table):
        text = renderable.plain if isinstance(renderable, rich.text.Text) else ""
        indent = len(text) - len(text.lstrip())
        return console.measure(renderable, options=wide).minimum + indent
    _, right, _, left = renderable.padding
    width = 0
    for column in renderable.columns:
        cells = [console.measure(cell, options=wide) for cell in (column.header, *column.cells)]
        sizes = [cell.maximum if column.no_wrap else cell.minimum for cell in cells]
        width += max(*sizes, column.min_width or 0) + left + right
    return width


def messages_console() -> Console:
    """Return a console on standard error, for messages that are not a command's result."""
    return _PlainConsole(stderr=True)
