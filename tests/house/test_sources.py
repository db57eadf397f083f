"""Every module of estimation and fitting that computes says whose formula it is: paper, book or
clause, in its own docstring or in that of one of its functions or classes.

Read from the syntax trees. What is listed as exempt gives its reason.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from places import PROJECT

SOURCE = PROJECT / "src" / "compwright"
ROOMS = ("estimation", "fitting")

#: A year that stands as one does in a reference (``Boyd and Vandenberghe 2004``, ``(1985)``), or a
#: standard with its clause, annex or equation.
YEAR = re.compile(r"(?:, |\(|ed\. |[A-Z][\w-]+ )(?:1[89]|20)\d\d[),;]")
CLAUSE = re.compile(
    r"\b(?:ISO 230-\d|GOST 27843|VDI 3441|JCGM 10\d)(?::\d{4})?,\s(?:clause |annex |eq\. )?[A-Z\d]"
)

#: Modules that compute without a formula of others, and why.
EXEMPT = {
    "estimation.__init__": "no code",
    "estimation.circle_findings": "words what was computed elsewhere",
    "estimation.circle_path": "which causes have the same shape, of those whose formulas stand elsewhere",
    "estimation.circle_solution": "the record of a fit whose formulas are elsewhere",
    "fitting.__init__": "no code",
    "fitting.reference_grids": "counts whole spacings from the reference; what it refuses is the control's",
    "fitting.truncation": "compares a loss with the noise and words a fault",
    "fitting.endless_axis": "a plain mean of the turns",
    "fitting.grid": "takes one of the grids that are made elsewhere, and says why not",
    "fitting.requested_spacing": "counts quanta of the position between the ends of the table",
    "fitting.table_findings": "words what was computed elsewhere",
    "fitting.existing_grid": "compares the existing nodes with the limits of the control",
    "fitting.grid_steps": "counts quanta of the position",
}


def modules() -> dict[str, Path]:
    return {
        f"{room}.{path.stem}": path
        for room in ROOMS
        for path in sorted((SOURCE / room).rglob("*.py"))
    }


def docstrings(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            yield " ".join((ast.get_docstring(node) or "").split())


def named(tree: ast.Module) -> bool:
    return any(YEAR.search(text) or CLAUSE.search(text) for text in docstrings(tree))


@pytest.mark.parametrize("name", sorted(set(modules()) - set(EXEMPT)))
def test_a_module_that_computes_names_its_source(name: str) -> None:
    assert named(ast.parse(modules()[name].read_text(encoding="utf-8"))), (
        f"{name}: name author, title and year, or standard and clause, in the docstring of the"
        " module or of the function; or list the module in EXEMPT with the reason"
    )


@pytest.mark.parametrize("name", sorted(EXEMPT))
def test_an_exempt_module_is_there_and_names_none(name: str) -> None:
    assert not named(ast.parse(modules()[name].read_text(encoding="utf-8")))


@pytest.mark.parametrize(
    ("text", "is_source"),
    [
        ("Weak duality (Boyd and Vandenberghe, Convex Optimization, 2004, section 5.2.2).", True),
        ("Dynamic programming: Bellman, Dynamic Programming (1957).", True),
        ("Reversal value (ISO 230-2:1997, 2.12).", True),
        ("What each cause does to a circle: ISO 230-4:1996, annex B.", True),
        ("Pooled spread (JCGM 100:2008, eq. 13).", True),
        ("Return the mean square of 2000 samples of ISO 230-2.", False),
        ("An axis of 2 000 mm, x = 1997.5 mm.", False),
        ("Minimise x'Px/2 + q'x.", False),
    ],
)
def test_what_counts_as_a_source(text: str, is_source: bool) -> None:
    assert named(ast.parse(f'"""{text}"""')) is is_source
