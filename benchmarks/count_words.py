"""Count the words that the project's guide to plain English replaces, room by room: in messages
(texts with a space in them), docstrings, comments and names of `src/compwright`, and in `docs/`.

    python benchmarks/count_words.py            a line for each room
    python benchmarks/count_words.py --list messages [ROOM]     every place, to work through
    python benchmarks/count_words.py --pages [COMMIT]    words of the hand-written pages by kind
                                                         (prose, samples), today or at a commit
"""

from __future__ import annotations

import ast
import io
import re
import subprocess
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]
SOURCE = PROJECT / "src" / "compwright"
KINDS = ("messages", "docstrings", "comments", "names")
#: What a text should not say, and parts of names.
WORDS = re.compile(
    r"\b(?:told|said|acts|acting|acted|beside|another than|as such|for sure|so is|nobody"
    r"|stands? (?:in|beside|there|here)|hangs? on|settled? first|what you saw|a test in which"
    r"|(?:lies?|far) off|(?:holds?|held) (?:\w+ ){0,4}against)\b",
    re.IGNORECASE,
)
PARTS = {
    *("told", "said", "asked", "acted", "acts", "acting", "beside", "settled", "settle"),
    *("stands", "standing", "nobody"),
}
#: Names that stay, by module: why.
EXCEPTIONS = {
    ("formats/definition/schema.py", "settled_by"): "a key of the YAML of a definition",
    ("formats/definition/schema.py", "asked"): "a key of the YAML of a definition",
}


def _names(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Yield each name where it is defined: functions, classes, arguments, variables, fields."""
    seen = set()
    for node in ast.walk(tree):
        name = None
        if not isinstance(node, ast.stmt | ast.expr | ast.arg):
            continue
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef):
            name = node.name
        elif isinstance(node, ast.arg):
            name = node.arg
        elif isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
            name = node.id if isinstance(node, ast.Name) else node.attr
        if name is not None and name not in seen:
            seen.add(name)
            yield node.lineno, name


def parts(name: str) -> set[str]:
    """Return the words of a name, in small letters."""
    return set(re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower().split("_"))


def _texts(tree: ast.AST) -> Iterator[tuple[str, int, str]]:
    """Yield kind, line and text of docstrings and of constants with a space in them."""
    documents = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            first = node.body[0] if node.body else None
            if isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant):
                documents.add(id(first.value))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            if id(node) in documents:
                yield "docstrings", node.lineno, node.value
            elif " " in node.value.strip():
                yield "messages", node.lineno, node.value


def places(path: Path) -> Iterator[tuple[str, int, str]]:
    """Yield kind, line and text of every hit in a module."""
    text = path.read_text(encoding="utf-8")
    tree = ast.parse(text)
    comments = [
        ("comments", token.start[0], token.string)
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type == tokenize.COMMENT
    ]
    for kind, line, words in [*_texts(tree), *comments]:
        for _ in WORDS.findall(words):
            yield kind, line, " ".join(words.split())
    module = path.relative_to(SOURCE).as_posix()
    for line, name in [(1, path.stem), *_names(tree)]:
        if parts(name) & PARTS and (module, name) not in EXCEPTIONS:
            yield "names", line, name


def room(path: Path) -> str:
    """Return the first folder below the source."""
    inside = path.relative_to(SOURCE).parts
    return inside[0] if len(inside) > 1 else "(top)"


#: Pages that are made from code, definitions or saved results.
GENERATED = {
    *("options.md", "job-keys.md", "json-keys.md", "definition-keys.md", "findings.md"),
    *("control-facts.md", "open-facts.md", "quality.md"),
}


#: Blocks of code, fenced or indented.
_SAMPLES = re.compile(r"^```.*?^```|(?<=\n\n)(?:[ ]{4}[^\n]*\n+)+", re.DOTALL | re.MULTILINE)


def page_kind(place: str) -> str:
    """Return the kind of a hand-written page."""
    first, _, rest = place.partition("/")
    if first in ("README.md", "CONTRIBUTING.md", "examples"):
        return first
    folder = rest.partition("/")[0]
    return folder if folder in ("tutorials", "how-to", "explanation") else "reference"


def pages_at(commit: str) -> Iterator[tuple[str, str]]:
    """Yield path and text of the hand-written pages, of the working tree or of a commit."""
    shown = subprocess.run(
        ["git", "ls-tree", "-r", "--name-only", commit or "HEAD"],
        cwd=PROJECT,
        capture_output=True,
        text=True,
        check=True,
    )
    for place in shown.stdout.splitlines():
        page = Path(place)
        if page.suffix != ".md" or page.name in GENERATED or "reference" in page.parts:
            continue
        top = place in ("README.md", "CONTRIBUTING.md")
        if not (top or page.parts[0] in ("docs", "examples")):
            continue
        if not commit:
            yield place, (PROJECT / page).read_text(encoding="utf-8")
            continue
        text = subprocess.run(
            ["git", "show", f"{commit}:{place}"],
            cwd=PROJECT,
            capture_output=True,
            encoding="utf-8",
            check=True,
        )
        yield place, text.stdout


def words_of(text: str) -> tuple[int, int]:
    """Return how many words (with a letter or digit) a page has, and how many outside of blocks of
    code.
    """
    whole, prose = (
        sum(bool(re.search(r"\w", word)) for word in part.split())
        for part in (text, _SAMPLES.sub("", text))
    )
    return whole, prose


def count_pages(commit: str) -> None:
    """Print how many words each kind of hand-written page has, outside and inside of blocks of
    code.
    """
    counts: Counter[tuple[str, str]] = Counter()
    for place, text in pages_at(commit):
        whole, outside = words_of(text)
        for kind in (page_kind(place), "all"):
            counts[kind, "prose"] += outside
            counts[kind, "samples"] += whole - outside
    for kind in sorted({kind for kind, _ in counts}):
        print(f"{kind:<22}{counts[kind, 'prose']:>8}{counts[kind, 'samples']:>8}")


def main() -> None:
    """Print the counts, or every place of one kind."""
    if sys.argv[1:2] == ["--pages"]:
        count_pages("".join(sys.argv[2:]))
        return
    wanted = sys.argv[2:] if sys.argv[1:2] == ["--list"] else []
    counts: Counter[tuple[str, str]] = Counter()
    for path in sorted(SOURCE.rglob("*.py")):
        for kind, line, text in places(path):
            counts[room(path), kind] += 1
            if wanted and kind == wanted[0] and room(path) in (wanted[1:] or [room(path)]):
                print(f"{path.relative_to(SOURCE)}:{line}: {text}")
    if wanted:
        return
    print(f"{'room':<14}" + "".join(f"{kind:>12}" for kind in KINDS))
    for one in sorted({where for where, _ in counts}):
        print(f"{one:<14}" + "".join(f"{counts[one, kind]:>12}" for kind in KINDS))
    whole = [sum(n for (_, of), n in counts.items() if of == kind) for kind in KINDS]
    print(f"{'all':<14}" + "".join(f"{n:>12}" for n in whole))
    pages = [PROJECT / "README.md", *sorted((PROJECT / "docs").rglob("*.md"))]
    print("docs", sum(len(WORDS.findall(page.read_text(encoding="utf-8"))) for page in pages))


if __name__ == "__main__":
    main()
