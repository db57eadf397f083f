"""The reference pages of keys name every key that the source can write or read, and no other: keys
by the source, and by documents that commands have written.
"""

from __future__ import annotations

import ast
import json
import re
import shutil
from collections.abc import Iterator
from dataclasses import fields
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from compwright.cli import run as compwright
from compwright.formats.definition import forms
from compwright.formats.definition import vocabulary as words
from compwright.foundations import record_schemas
from compwright.foundations.yaml_reader import read_yaml
from places import PROJECT

SOURCE = PROJECT / "src" / "compwright"
JSON = read_yaml((PROJECT / "docs" / "json-keys.yaml").read_bytes(), "json-keys.yaml").data
DEFINITION = read_yaml(
    (PROJECT / "docs" / "definition-keys.yaml").read_bytes(), "definition-keys.yaml"
).data
SCHEMAS = [name for name in JSON if name != "shared"]
#: Literal keys that are in no document: names of checks, kinds of tests, and a set of files that is
#: handed on.
NOT_WRITTEN = {
    "selftest": {"x", "y", "diameter"},
    "record": {"tables"},
    "history": {"positioning", "circular"},
}


def parts(path: str) -> set[str]:
    return set(re.split(r"[.\[\]]+", path)) - {""}


def listed(schema: str) -> set[str]:
    """Return every word of the paths of a document, those that several documents share too."""
    paths = [*JSON[schema]["keys"], *JSON["shared"]["keys"]]
    return {"schema", *(part for path in paths for part in parts(path))}


def literal_keys(module: str) -> Iterator[str]:
    for node in ast.walk(ast.parse((SOURCE / module).read_text(encoding="utf-8"))):
        keys = node.keys if isinstance(node, ast.Dict) else []
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Subscript):
            keys = [node.targets[0].slice]
        for key in keys:
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                yield key.value


@pytest.mark.parametrize("schema", SCHEMAS)
def test_every_key_that_the_source_writes_is_listed(schema: str) -> None:
    section = JSON[schema]
    keys = {key for module in section["modules"] for key in literal_keys(module)}
    assert len(keys) > 5
    for record in section["records"]:
        module, _, name = f"compwright.{record}".rpartition(".")
        keys |= {field.name for field in fields(getattr(import_module(module), name))}
    assert keys - listed(schema) - NOT_WRITTEN.get(schema, set()) == set()


def test_every_schema_of_an_answer_has_its_section() -> None:
    found = set()
    for path in SOURCE.rglob("*.py"):
        found |= set(re.findall(r'"compwright/(\w+)/1"', path.read_text(encoding="utf-8")))
    assert found - {"card", "unfinished", "files"} == set(SCHEMAS)


def paths_of(value: Any, path: str = "") -> Iterator[str]:
    """Return the paths of a document; of a list those of all its entries."""
    if isinstance(value, dict) and value:
        for key, inner in value.items():
            yield from paths_of(inner, f"{path}.{key}" if path else key)
    elif isinstance(value, list) and any(isinstance(one, dict) for one in value):
        for one in value:
            yield from paths_of(one, f"{path}[]")
    else:
        yield path


def known(path: str, schema: str) -> bool:
    """Whether a listed path is this one, or stands for it as a whole."""
    if path == "schema":
        return True
    for entry in JSON[schema]["keys"]:
        pattern = re.escape(entry).replace("NAME", r"[^.\[\]]+")
        pattern = re.sub(r"(?<=\\\.)(A|ccw|R)(?=\\|$)", r"[^.\\[\\]]+", pattern)
        if re.fullmatch(pattern, path):
            return True
        # below a leaf that stands for the keys of another entry; above one that is empty or null
        if re.match(pattern + r"[.\[]", path) or entry.startswith((f"{path}.", f"{path}[")):
            return True
    tail = re.search(r"(findings|doubts|acknowledged|sources|errors)(\[\].*)?$", path)
    return tail is not None


def unknown(document: dict[str, Any]) -> set[str]:
    schema = document["schema"].split("/")[1]
    return {path for path in paths_of(document) if not known(anonymous(path), schema)}


def anonymous(path: str) -> str:
    """Put NAME in the place of the names of axes, circles and parameters."""
    path = re.sub(r"\b(axes|circles|diagnosis|plain|planes|states)\.[^.\[\]]*", r"\1.NAME", path)
    inner = r"(before|after|predicted|predicted_new_targets|within_prediction|accept|parameters)"
    path = re.sub(rf"\b{inner}\.[^.\[\]]+", r"\1.A", path)
    return re.sub(
        r"(\bmachines\[\]\.axes\.NAME\.tests\[\])\.(E|M|R|B|B_mean|s|slope)$", r"\1.A", path
    )


@pytest.mark.short_estimate
def test_documents_hold_no_key_that_is_not_listed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "machine"
    shutil.copytree(PROJECT / "examples" / "sinumerik-old-table", folder)
    monkeypatch.chdir(folder)
    tables, sinumerik = "job/tables/siemens-840d-sl", ["--format", "siemens-840d-sl"]
    (folder / "circle.yaml").write_text(
        "virtual_machine: 1\ncircles: {xy: {format: b5r, sample_rate_hz: 20, "
        "error: {noise_um: 0.2, squareness_um_per_m: 30}}}\n"
    )
    after = ["simulate", "machine.yaml", "--out", "after", "--seed", "2", "--with-tables", tables]
    answers = [
        (["run", "job.yaml"], ["prediction.json", "evaluation.json"]),
        (after, []),
        (["verify", "job.yaml", "--after", "after/y.csv"], ["verification.json", "record.json"]),
        (["simulate", "circle.yaml", "--out", "circle"], []),
        (["evaluate", "before", "circle/xy.b5r", "--json", "job/e.json"], ["e.json"]),
        (["compare", "job/plan.json", "--loaded", tables, "--json", "job/c.json"], ["c.json"]),
        (["diff", "control", "--with", tables, *sinumerik, "--json", "job/d.json"], ["d.json"]),
        (["decode", "control", *sinumerik, "--json", "job/de.json"], ["de.json"]),
        (["history", "job", "--json", "h.json"], ["../h.json"]),
        (["redact", "before", "--out", "red", "--json", "r.json"], ["../r.json"]),
    ]
    seen = set()
    for command, documents in answers:
        assert compwright(command) in (0, 1), capsys.readouterr().err
        for name in documents:
            document = json.loads((folder / "job" / name).read_text(encoding="utf-8"))
            seen.add(document["schema"].split("/")[1])
            assert unknown(document) == set(), name
    assert seen == set(SCHEMAS) - {"plan", "selftest"}


def test_the_page_of_definitions_has_the_keys_that_are_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(record_schemas, "SchemaValidator", lambda schema: schema)
    schema = forms.definition_validator.__wrapped__(())
    paths = [
        f"{name} {key}" if name.islower() else key
        for name, section in DEFINITION.items()
        for key in section["keys"]
    ]
    page = {part for path in paths for part in re.findall(r"\w+", path)}
    page |= {"control", "machine", "date", "how"}  # of proven
    page |= {"option", "value", "say", "one_curve", "two_curves"}  # of values that are mappings
    page |= {"position", "positive", "negative"}  # of expect
    quantities = {*words.MEASURES, *words.CHOICES, *words.PLAIN}
    read = set(typed_keys(schema))
    assert len(read) > 80
    assert read - quantities - set(words.LOOKED_AT) - page == set()
    own = {
        part
        for section in DEFINITION.values()
        for path in section["keys"]
        for part in path.split(".")
    }
    assert own - read == set()


def typed_keys(schema: Any) -> Iterator[str]:
    """Return the keys of every mapping of a schema of pydantic."""
    if isinstance(schema, dict):
        if schema.get("type") == "typed-dict":
            yield from schema["fields"]
        for inner in schema.values():
            yield from typed_keys(inner)
    elif isinstance(schema, list | tuple):
        for inner in schema:
            yield from typed_keys(inner)
