"""Draw texts at random for a reader who does not know the project: messages and docstrings.

    python benchmarks/draw_texts.py [SEED] [TREE]

60 messages (sentences of findings and labels with their fields, errors with their next step, help
texts) and 20 docstrings behind the name, or behind the function's line as it is in the code. The
reader marks each: understood at first reading. A message without a subject is drawn behind the
place that is printed before it. An error whose sentence a helper gets from its caller is drawn
where the caller gives the next step too.
"""

from __future__ import annotations

import ast
import random
import sys
from collections.abc import Iterator
from pathlib import Path

from compwright.foundations.errors import _PREDICATE

MESSAGES, DOCSTRINGS = 60, 20
#: Shorter texts are labels.
FEWEST_WORDS = 5


def text_of(node: ast.AST | None) -> str:
    """Return the text of a constant or an f-string, each value as its expression in braces."""
    if isinstance(node, ast.Constant):
        return str(node.value)
    if isinstance(node, ast.JoinedStr):
        return "".join(map(text_of, node.values))
    return "" if node is None else "{" + ast.unparse(node).strip("{}") + "}"


def error_text(words: dict[str, str]) -> str:
    """Return an error as it is printed, from the texts of its fields."""
    message = words["message"]
    message = f"{{place}} {message}" if _PREDICATE.match(message) else message
    details = "".join(f"; {key} {words[key]}" for key in ("expected", "found") if words.get(key))
    return f"error: {message}{details}. Next: {words['hint']}"


def messages(tree: ast.AST, path: Path) -> Iterator[str]:
    """Yield the sentences, errors and help texts of a module."""
    named: dict[str, ast.AST] = {}
    for node in sorted(ast.walk(tree), key=lambda node: getattr(node, "lineno", 0)):
        if isinstance(node, ast.Assign):
            named[ast.unparse(node.targets[0])] = node.value
        elif isinstance(node, ast.Dict) and "english" in path.parts:
            yield from (text_of(value) for value in node.values)
        elif isinstance(node, ast.Call):
            words = {word.arg or "": text_of(word.value) for word in node.keywords}
            if "hint" in words and node.args and " " in text_of(node.args[0]):
                texts = [text_of(named.get(ast.unparse(one), one)) for one in node.args[:2]]
                words.setdefault("message", ": ".join(filter(None, texts)))
            if {"message", "hint"} <= set(words) and words["message"] != "{message}":
                yield error_text(words)
            elif "help" in words and "cli" in path.parts:
                yield words["help"]


def docstrings(tree: ast.AST, path: Path) -> Iterator[str]:
    """Yield each docstring of a module, behind what it belongs to."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Module):
            head = "/".join(path.parts[-2:])
        elif isinstance(node, ast.ClassDef):
            head = f"class {node.name}"
        elif isinstance(node, ast.FunctionDef):
            returned = f" -> {ast.unparse(node.returns)}" if node.returns else ""
            head = f"def {node.name}({ast.unparse(node.args)}){returned}"
        else:
            continue
        text = ast.get_docstring(node)
        if text:
            yield f"{head}: {text}"


def main() -> None:
    """Print the draw."""
    seed, tree = (*sys.argv[1:], "240", ".")[:2] if len(sys.argv) != 2 else (sys.argv[1], ".")
    modules = [
        (path, ast.parse(path.read_text(encoding="utf-8")))
        for path in sorted((Path(tree) / "src" / "compwright").rglob("*.py"))
    ]
    drawn = random.Random(int(seed))  # noqa: S311 - a draw of texts
    sentences = sorted(
        {
            text
            for path, module in modules
            for text in messages(module, path)
            if len(text.split()) >= FEWEST_WORDS
        }
    )
    documented = sorted({text for path, module in modules for text in docstrings(module, path)})
    for kind, texts, count in (
        ("message", sentences, MESSAGES),
        ("docstring", documented, DOCSTRINGS),
    ):
        for number, text in enumerate(drawn.sample(texts, count), start=1):
            print(f"{kind} {number}: {' '.join(text.split())}")


if __name__ == "__main__":
    main()
