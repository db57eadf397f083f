"""Pages about the controls that are made from `controller_formats/`: what each definition knows,
and what it marks unconfirmed, with the experiments of `open-facts.yaml`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

from compwright.controls.definitions import shipped_definitions
from compwright.formats.definition.options import describe_options
from compwright.formats.definition.schema import Definition, Measure, OptionValue
from compwright.foundations.session import Session
from compwright.foundations.yaml_reader import read_yaml

DOCS = Path(__file__).parent
DEFINITIONS = DOCS.parent / "controller_formats"
EXPERIMENTS = DOCS / "open-facts.yaml"
MADE = "Made from the definitions of the controls by `make pages`."
ABOUT_FACTS = f"""{MADE} Everything about one control: `compwright formats show ID`.
How to work with it: [controls](controls.md)."""
ABOUT_OPEN_FACTS = f"""{MADE} What the definitions mark unconfirmed: no manual at hand decides it.
Each entry has the experiment of ten minutes for your own machine. Before it: save the control's
data, record the old values, use an axis that stands free and a dial gauge of 1 µm or the laser;
after it, put the old values back. Send the result with control, software version and date: then
the mark changes."""
#: Meaning of ``here`` of a parameter in a definition.
HERE = {"read": "read", "another": "has another meaning", "unknown": "meaning unknown"}


def facts_page() -> str:
    """Return limits, numbers, options and parameters of each control, with their evidence. What
    several definitions have alike is one row.
    """
    definitions = list(shipped_definitions(Session()).values())
    tables = (
        ("Limits", ("limit", "controls", "how sure"), _limits),
        ("Numbers in the files", ("quantity", "controls", "how sure"), _numbers),
        ("Options", ("option", "controls", "meaning, default, how sure"), _options),
        ("Parameters next to the table", ("parameter", "controls", "how sure"), _parameters),
    )
    parts = ["# Control facts", ABOUT_FACTS]
    for heading, columns, rows in tables:
        found: dict[tuple[str, str], list[str]] = {}
        for definition in definitions:
            for what, source in rows(definition):
                found.setdefault((what, source), []).append(f"`{definition.id}`")
        lines = [f"| {' | '.join(columns)} |", "|---|---|---|"]
        lines += [
            f"| {_cell(what)} | {', '.join(ids)} | {_cell(source)} |"
            for (what, source), ids in found.items()
        ]
        parts += [f"## {heading}", "\n".join(lines)]
    sources: dict[str, list[str]] = {}
    for definition in definitions:
        lines = [f"{name}: {_cell(text)}" for name, text in definition.sources.items()]
        sources.setdefault("\n- ".join(lines), []).append(f"`{definition.id}`")
    parts.append("## Sources")
    parts += [f"{', '.join(ids)}:\n\n- {text}" for text, ids in sources.items()]
    return "\n\n".join(parts) + "\n"


def _cell(text: str) -> str:
    """Return text as Markdown shows it in a cell: no rows, no tags, no emphasis of its own."""
    marks = {"|": r"\|", "<": "&lt;", "*": r"\*", "_": r"\_", "\n": " "}
    return "".join(marks.get(letter, letter) for letter in text)


def _limits(definition: Definition) -> Iterator[tuple[str, str]]:
    for rule in definition.limits:
        number = "" if rule.number is None else f": {rule.number}"
        yield f"{rule.predicate.replace('_', ' ')}{number}", str(rule.evidence)


def _numbers(definition: Definition) -> Iterator[tuple[str, str]]:
    for name, binding in definition.bindings.items():
        if isinstance(binding, Measure):
            unit = binding.linear_unit
            linear = f"option {unit.option}" if isinstance(unit, OptionValue) else unit
            low, high = binding.range
            size = f"{low:g} to {high:g}, {binding.digits} decimals"
            yield f"{_words(name)}: {linear}, {binding.rotary_unit}; {size}", str(binding.evidence)


def _options(definition: Definition) -> Iterator[tuple[str, str]]:
    for line in describe_options(definition):
        name, _, meaning = line.partition(" (")
        yield name, f"({meaning}"


def _parameters(definition: Definition) -> Iterator[tuple[str, str]]:
    for name, rule in definition.parameters.items():
        yield f"{_words(name)}: {HERE[rule.here]}", str(rule.evidence)


def _words(name: str) -> str:
    return name.replace("_", " ")


def open_facts_page() -> str:
    """Return what the definitions mark unconfirmed, below the experiment that decides it. Raises
    ValueError for a place that has no experiment, or an experiment without a place.
    """
    sources = dict(_unconfirmed_places())
    left = set(sources)
    parts = ["# Open facts", ABOUT_OPEN_FACTS]
    last = ""
    for entry in read_yaml(EXPERIMENTS.read_bytes(), EXPERIMENTS.name).data:
        if entry["control"] != last:
            last = entry["control"]
            parts.append(f"## {last}")
        places = [place for place in sources if _covers(entry["places"], place)]
        if not places or not left.issuperset(places):
            raise ValueError(f"{entry['title']}: mend its places in {EXPERIMENTS.name}")
        left.difference_update(places)
        known = dict.fromkeys(text for place in places for text in sources[place])
        parts.append(
            f"### {entry['title']}\n"
            f"- Decides: {entry['decides']}\n"
            f"- Ten minutes: {entry['experiment']}\n"
            f"- Known so far: {_cell('; '.join(known)).replace('`', '')}\n"
            f"- In: {', '.join(f'`{one}`' for place in places for one in _each(place, sources))}"
        )
    if left:
        raise ValueError(f"{sorted(left)}: add an experiment to {EXPERIMENTS.name}")
    return "\n\n".join(parts) + "\n"


def _each(place: str, sources: Mapping[str, list[str]]) -> list[str]:
    """Return a place as often as it is there: rules of a list may have no name of their own."""
    return [place] * len(sources[place])


def _covers(patterns: Iterable[str], place: str) -> bool:
    return any(
        place.startswith(pattern[:-1]) if pattern.endswith("*") else place == pattern
        for pattern in patterns
    )


def _unconfirmed_places() -> Iterator[tuple[str, list[str]]]:
    """Yield each place of a definition's own text that is marked unconfirmed, with its sources."""
    for path in sorted(DEFINITIONS.glob("*.yaml")):
        found: dict[str, list[str]] = {}
        for place, source in _marked(read_yaml(path.read_bytes(), path.name).data, ""):
            found.setdefault(f"{path.stem}: {place}", []).append(source)
        yield from found.items()


def _marked(node: object, place: str) -> Iterator[tuple[str, str]]:
    if isinstance(node, list):
        for item in node:
            yield from _marked(item, place + _label(item))
    elif isinstance(node, dict):
        note = node.get("evidence")
        if "unconfirmed" in str(note):
            yield place, note["source"] if isinstance(note, dict) else str(note)
        for key, value in node.items():
            yield from _marked(value, f"{place}.{key}" if place else str(key))


def _label(item: object) -> str:
    names = ("name", "title", "predicate", "set")
    words = [str(item[name]) for name in names if name in item] if isinstance(item, dict) else []
    return f"[{' '.join(words)}]"
