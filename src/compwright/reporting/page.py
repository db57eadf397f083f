"""Self-contained HTML pages from templates, with inline figures, no script and no download.

The template engine escapes all text of a document. Control characters, and characters that change
the direction of writing, are shown as escapes. The pages are also well-formed XML, so that any tool
can read them.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Mapping
from typing import Any, Final, Protocol
from urllib.parse import quote

from compwright.foundations.extras import need
from compwright.foundations.utf8 import encoded, visible_lines
from compwright.reporting.numbers import MISSING, number, plain, unit_text
from compwright.words.sentences import Language, Sentence, in_language, say

#: Letters of the report number that fit in a footer.
_MOST_IN_FOOTER: Final = 60
_CODE: Final = re.compile(r"`([^`]+)`")
#: A hyphen that is the sign of a number: not that of a range, a date or the name of a standard.
_SIGN: Final = re.compile(r"(?<![^\s(\[/±])-(?=\d)")
# What XML 1.0 does not allow in text; half surrogates cannot be written as UTF-8 either.
_NOT_TEXT: Final = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def render_page(template: str, content: Mapping[str, Any], language: Language = "en") -> bytes:
    """Return a filled template as UTF-8. Raises UsageError without the pip extra ``report``."""
    need("jinja2")
    text: str = _environment(language).get_template(template).render(**content)
    return encoded(text)


def template_text(name: str) -> str:
    """Return a file in ``templates/``. Raises UsageError without the pip extra ``report``."""
    environment = _environment("en")
    text: str = environment.loader.get_source(environment, name)[0]
    return text


@functools.cache
def _environment(language: Language) -> Any:
    """Return the Jinja template engine for a language."""
    jinja2 = need("jinja2")
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("compwright.reporting"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        finalize=functools.partial(_clean, language=language),
    )
    environment.filters.update(number=number, plain=plain, unit=unit_text, link=_link)
    environment.filters["css"] = functools.partial(_css, language=language)
    environment.filters["coded"] = functools.partial(_coded, language=language)
    environment.filters["drawn"] = functools.partial(_drawn, language=language)
    environment.globals.update(missing=MISSING, say=say, language=language)
    return environment


class Figure(Protocol):
    """A drawing in an HTML page, with labels in the language of the page."""

    def svg(self, language: Language) -> str:
        """Return the figure as SVG markup inside a page."""


def inline_figure(svg: bytes, *, prefix: str, description: str) -> Any:
    """Return an SVG file (from the module `plots`) as markup that can be inserted into an HTML
    page.

    ``prefix``: the start of all its element ids, which makes them unique in the page.
    ``description``: the text for screen readers. Name spaces and metadata are removed, because HTML
    needs none.
    """
    markupsafe = need("markupsafe")
    text = svg.decode("utf-8")
    text = text[text.index("<svg") :]
    text = re.sub(
        r"<metadata>.*?</metadata>|<style .*?</style>|<!--.*?-->", "", text, flags=re.DOTALL
    )
    text = re.sub(r' xmlns(?::\w+)?="[^"]*"', "", text)
    text = text.replace("xlink:href=", "href=")
    for before in (' id="', ' href="#', "url(#"):
        text = text.replace(before, f"{before}{prefix}-")
    label = markupsafe.escape(visible_lines(description))
    text = re.sub(
        r'<svg [^>]*?(viewBox="[^"]*")[^>]*>',
        rf'<svg \1 role="img" aria-label="{label}">',
        text,
        count=1,
    )
    return markupsafe.Markup(re.sub(r"\n\s*", "\n", text))


def _clean(value: Any, language: Language) -> Any:
    """Return a value as page text: translated, with true minus signs except in code.

    In plain text, characters that a page must not contain are shown as escapes. Markup is made by
    compwright and needs no such change.
    """
    if isinstance(value, Sentence | str) and not hasattr(value, "__html__"):
        worded = type(value) is not str
        value = in_language(value, language)
        if worded:
            value = "`".join(
                text if code % 2 else _SIGN.sub("−", text)
                for code, text in enumerate(value.split("`"))
            )
    return visible_lines(value) if type(value) is str else value


def _coded(value: Any, language: Language) -> Any:
    """Return a text as HTML, in which text between backticks is marked as code."""
    markup = need("markupsafe")
    escaped = str(markup.escape(_clean(value, language)))
    return markup.Markup(_CODE.sub(r"<code>\1</code>", escaped))


def _drawn(figure: Figure, language: Language) -> Any:
    """Return a figure as SVG markup, with its texts translated."""
    return need("markupsafe").Markup(figure.svg(language))


def _css(value: str | Sentence, language: Language) -> Any:
    """Return a text or sentence as a CSS string for a style sheet of the page."""
    text = value.text(language) if isinstance(value, Sentence) else value
    return need("markupsafe").Markup(css_string(text))


def css_string(text: str) -> str:
    """Return ``text`` as a safe CSS string, which cannot end the string or the style sheet."""
    line = " ".join(visible_lines(text).split())[:_MOST_IN_FOOTER]
    return '"' + "".join(c if c.isalnum() or c in " .-" else f"\\{ord(c):x} " for c in line) + '"'


def _link(name: object) -> str:
    """Return a relative link to a file next to the page. A colon in the file name is escaped, so
    that the browser does not read a URL.
    """
    return quote(_NOT_TEXT.sub(" ", str(name)).replace("\\", "/").lstrip("/"), safe="/")
