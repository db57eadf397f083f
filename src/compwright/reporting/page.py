"""Self-contained HTML pages: templates and style sheet inside the package, figures inline, no
script, nothing fetched.

Everything that a document says is escaped by the template engine; control characters, and those
that turn the direction of writing, stand as their escapes. The pages are well-formed XML as well,
so that any tool can read them.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Mapping
from typing import Any, Final
from urllib.parse import quote

from compwright.foundations.extras import need
from compwright.foundations.utf8 import encoded, visible_lines
from compwright.reporting.numbers import MISSING, number, plain, unit_text

# What XML 1.0 does not allow in text; half surrogates cannot be written as UTF-8 either.
_NOT_TEXT: Final = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def render_page(template: str, content: Mapping[str, Any]) -> bytes:
    """Return the page of a template in ``templates/`` as UTF-8 bytes. Raises UsageError when the
    report extra is missing.
    """
    need("jinja2")
    text: str = _environment().get_template(template).render(**content)
    return encoded(text)


def template_text(name: str) -> str:
    """Return a file of ``templates/`` as it is. Raises UsageError when the report extra is
    missing.
    """
    environment = _environment()
    text: str = environment.loader.get_source(environment, name)[0]
    return text


@functools.cache
def _environment() -> Any:
    """Return the template engine, which keeps the templates that it has compiled."""
    jinja2 = need("jinja2")
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("compwright.reporting"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        finalize=_clean,
    )
    environment.filters.update(number=number, plain=plain, unit=unit_text, link=_link)
    environment.globals["missing"] = MISSING
    return environment


def inline_figure(svg: bytes, *, prefix: str, description: str) -> Any:
    """Return an SVG file of `plots` as markup to stand inside a page.

    ``prefix`` makes its ids its own (figures on one page must not use each other's clips and
    letters), name spaces and metadata go (HTML needs none), ``description`` is what a screen reader
    says.
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
    label = markupsafe.escape(_clean(description))
    text = re.sub(
        r'<svg [^>]*?(viewBox="[^"]*")[^>]*>',
        rf'<svg \1 role="img" aria-label="{label}">',
        text,
        count=1,
    )
    return markupsafe.Markup(re.sub(r"\n\s*", "\n", text))


def _clean(value: Any) -> Any:
    """Show what no page may hold, in plain text only: markup is ours and clean."""
    return visible_lines(value) if type(value) is str else value


def _link(name: object) -> str:
    """Return a relative link to a file beside the page; a colon cannot make it a scheme."""
    return quote(_NOT_TEXT.sub(" ", str(name)).replace("\\", "/").lstrip("/"), safe="/")
