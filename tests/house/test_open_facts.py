"""The page of what is still open: every place that a definition marks unconfirmed, and no other."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from compwright.foundations.yaml_reader import read_yaml

PROJECT = Path(__file__).resolve().parents[2]
DEFINITIONS = sorted((PROJECT / "controller_formats").glob("*.yaml"))
PAGE = (PROJECT / "docs" / "open-facts.md").read_text(encoding="utf-8")
NAMED_BY = ("name", "title", "predicate")  # what tells the members of a list apart


def open_places(node: object, place: str = "") -> list[str]:
    """Return the key path of every mapping whose evidence says unconfirmed, in state or words."""
    if isinstance(node, list):
        return [found for item in node for found in open_places(item, place + _label(item))]
    if not isinstance(node, dict):
        return []
    here = [place] if "unconfirmed" in str(node.get("evidence", "")) else []
    below = ((f"{place}.{key}" if place else key, value) for key, value in node.items())
    return here + [found for where, value in below for found in open_places(value, where)]


def _label(item: object) -> str:
    words = (
        [str(item[key]) for key in (*NAMED_BY, "set") if key in item]
        if isinstance(item, dict)
        else []
    )
    return f"[{' '.join(words)}]"


def entries() -> list[str]:
    """Return the text of each entry: what stands below a heading of the third level."""
    return re.split(r"^### ", PAGE, flags=re.MULTILINE)[1:]


def listed(entry: str) -> list[str]:
    line = next((line for line in entry.splitlines() if line.startswith("- In: ")), "")
    return re.findall(r"`([^`]+)`", line)


@pytest.mark.parametrize("path", DEFINITIONS, ids=lambda path: path.stem)
def test_every_open_fact_of_a_definition_has_its_line_and_no_line_is_left_over(path: Path) -> None:
    data = read_yaml(path.read_bytes(), path.name).data
    open_now = sorted(f"{path.stem}: {place}" for place in open_places(data))
    on_page = sorted(p for e in entries() for p in listed(e) if p.startswith(f"{path.stem}: "))
    assert open_now == on_page


def test_no_place_belongs_to_a_definition_that_is_not_there() -> None:
    names = {path.stem for path in DEFINITIONS}
    assert {p.partition(": ")[0] for e in entries() for p in listed(e)} <= names


def test_every_entry_says_what_it_decides_and_how_it_is_settled() -> None:
    for entry in entries():
        heading = entry.splitlines()[0]
        for part in ("- Decides: ", "- Ten minutes: ", "- In: "):
            assert len(re.findall(f"^{part}\\S", entry, flags=re.MULTILINE)) == 1, (heading, part)
        assert listed(entry), heading


def test_the_page_is_linked() -> None:
    assert "open-facts.md" in (PROJECT / "docs" / "README.md").read_text(encoding="utf-8")


def test_a_fact_is_found_in_state_and_in_words_in_lists_and_below_a_key() -> None:
    data = {
        "bindings": {
            "a": {"evidence": {"state": "confirmed", "source": "p1; range: unconfirmed"}},
            "b": {"when_absent": {"evidence": {"state": "unconfirmed", "source": "memory"}}},
        },
        "card": [{"title": "Sign", "evidence": {"state": "unconfirmed", "source": "no page"}}],
        "limits": [{"predicate": "most", "evidence": {"state": "inferred", "source": "p2"}}],
    }
    assert open_places(data) == ["bindings.a", "bindings.b.when_absent", "card[Sign]"]
