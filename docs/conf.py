"""The site made of these pages: `make site` writes it to `site/`, without a network; it works from
a folder, with search. Sphinx, because its search needs no server (mkdocs-material's loads a worker
from a network address where pages are opened as files), and autodoc reads the docstrings.
"""

import os
import re
import sys
from pathlib import Path

DOCS = Path(__file__).parent
sys.path.insert(0, str(DOCS))

from generate import pages, write_pages  # noqa: E402 - the line above makes it findable

project = "compwright"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "index"
html_theme = "furo"
html_title = "compwright"
html_show_sourcelink = False
html_copy_source = False
exclude_patterns = ["README.md"]
default_role = "code"
myst_heading_anchors = 4
suppress_warnings = ["misc.highlighting_failure", "config.cache"]
autodoc_typehints = "signature"
autodoc_member_order = "bysource"


def _fit(_app, page, source):
    """Turn links that leave this folder into text, and name a lexer that exists."""

    def text_of(found):
        target = os.path.normpath(Path(page).parent / found[2].partition("#")[0])
        return found[0] if not target.startswith("..") and target != "." else f"{found[1]}"

    text = re.sub(r"\[([^\]]+)\]\((?![a-z]+:|#)([^)]+)\)", text_of, source[0])
    text = re.sub(r"\]\(((?:\.\./)*)README\.md\)", r"](\1index.md)", text)
    source[0] = re.sub(r"^```(csv|text)\b.*$", "```text", text, flags=re.MULTILINE)


def setup(app):
    """Write the pages that are made from the code, then read all pages."""
    app.connect("builder-inited", lambda _app: write_pages(DOCS / "reference", pages()))
    app.connect("source-read", _fit)
