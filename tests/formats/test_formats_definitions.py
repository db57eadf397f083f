"""Definitions: complete or refused with every fault, and the gate that compares hand-worked
corrections.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from card_files import card_values
from compwright.formats.card import card_steps, look_at
from compwright.formats.definition.inheritance import DefinitionText, found_in, merged, texts_of
from compwright.formats.definition.options import describe_options, resolve_options
from compwright.formats.definition.schema import Definition
from compwright.formats.definition.vocabulary import LOOKED_AT
from compwright.formats.definitions import definition_in, definitions_from, load_definition
from compwright.formats.families.card_texts import UNKNOWN
from compwright.formats.families.shapes import control_format
from compwright.formats.gate import check_definition
from compwright.formats.text.patching import BytesChange, apply_changes, set_field
from compwright.formats.text.texts import TextReader
from compwright.foundations.errors import InputError, UsageError
from compwright.foundations.session import Session
from compwright.records.correction import ControlFile
from compwright.records.facts import AxisFacts
from compwright.records.plan import Texts
from compwright.workflow.commands.formats import check_formats, list_formats, show_format
from format_samples import CONTENT, CONTROLS, DEFINITIONS, LINUXCNC, SIEMENS, axis_of, table

TEXT = {name: content.decode() for name, content in CONTENT.items()}
NAMES = CONTROLS


@pytest.mark.parametrize("definition", DEFINITIONS.values(), ids=list(DEFINITIONS))
def test_the_installed_definitions_pass_the_gate(definition) -> None:  # type: ignore[no-untyped-def]
    assert check_definition(definition) == ()


def key_paths(data: object, path: tuple[str, ...] = ()) -> list[tuple[str, ...]]:
    """Every key whose set of neighbours is fixed by the schema (not names of statements, options,
    files ...).
    """
    free = {(), ("statements",), ("bindings",), ("texts",), ("options",)}
    found = []
    if isinstance(data, dict):
        for key, value in data.items():
            here = (*path, key)
            if path not in free or path == ():
                found.append(here)
            if len(here) < 3 and key not in {"sources", "sample", "expect"}:
                found += key_paths(value, here)
    return found


def merged_named(name: str) -> tuple[Texts, DefinitionText]:
    texts = texts_of(CONTENT[name], name, found_in(CONTENT))
    return texts, merged(texts)


@cache
def lines_before(name: str) -> frozenset[tuple[str, int]]:
    """The lines of all definitions before one: relatives share the keys that they inherit."""
    earlier = NAMES[: NAMES.index(name)]
    return frozenset(line for each in earlier for line in merged_named(each)[1].places.values())


@pytest.mark.parametrize("name", NAMES)
def test_every_missing_key_is_named_with_its_place(name: str) -> None:
    texts, whole = merged_named(name)
    paths = _one_of_each(key_paths(whole.data))
    for key in ("look_at", "aliases", "maker", "restore"):  # may be missing as a whole
        paths.remove((key,))
        definition_in(replace(whole, data=_without(whole.data, (key,))))
    assert len(paths) > 60
    for path in paths:
        if whole.places[path] in lines_before(name):
            continue
        with pytest.raises(InputError) as caught:
            definition_in(replace(whole, data=_without(whole.data, path)))
        assert any(
            fault.file in dict(texts) and path[-1] in fault.place for fault in caught.value.faults
        ), path


def _one_of_each(paths: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """One statement, text and option, and one binding of each class: the others have the same keys."""
    kept = {"statements": {"point", "row"}, "bindings": {"value", "value_positive", "rotary", "max_points", "table_file"},
            "options": {"points", "units"}, "texts": {"control", "table"}}  # fmt: skip
    return [
        path for path in paths if len(path) < 2 or path[0] not in kept or path[1] in kept[path[0]]
    ]


def _without(data: Any, path: tuple[str, ...]) -> Any:
    """Return a copy of nested mappings in which one key is missing."""
    if len(path) == 1:
        return {key: value for key, value in data.items() if key != path[0]}
    return {**data, path[0]: _without(data[path[0]], path[1:])}


@pytest.mark.parametrize(
    ("what", "file", "old", "new", "says"),
    [
        (
            "unknown key",
            "linuxcnc.yaml",
            "  encoding: ascii",
            "  encoding: ascii\n  colour: blue",
            "unknown key",
        ),
        (
            "misspelt key",
            "linuxcnc.yaml",
            "  pairing: two_columns",
            "  paring: two_columns",
            "pairing",
        ),
        (
            "key twice",
            "linuxcnc.yaml",
            "  encoding: ascii",
            "  encoding: ascii\n  encoding: ascii",
            "twice",
        ),
        (
            "unknown shape",
            "linuxcnc.yaml",
            "shape: rows_by_position",
            "shape: rows_by_magic",
            "rows_by_magic",
        ),
        (
            "unknown predicate",
            "linuxcnc.yaml",
            "predicate: max_points",
            "predicate: most_points",
            "most_points",
        ),
        (
            "limit without its number",
            "linuxcnc.yaml",
            "number: 256",
            "number: null",
            "needs a number",
        ),
        ("unknown evidence", "linuxcnc.yaml", "state: confirmed", "state: certain", "certain"),
        ("number as text", "linuxcnc.yaml", "digits: 7", "digits: seven", "whole number"),
        ("base 60", "linuxcnc.yaml", "digits: 7", "digits: 1:30", "whole number"),
        (
            "range upside down",
            "linuxcnc.yaml",
            "range: [-10, 10]",
            "range: [10, -10]",
            "smaller one first",
        ),
        ("unknown quantity", "linuxcnc.yaml", "  node_position:", "  node_place:", "node_place"),
        (
            "sign of the wrong kind",
            "linuxcnc.yaml",
            "sign: position",
            "sign: error",
            "does not suit",
        ),
        (
            "a sign for an unknown form",
            "linuxcnc.yaml",
            "trim: correction}",
            "trimm: correction}",
            "one sign for each",
        ),
        (
            "unknown statement",
            "linuxcnc.yaml",
            "    statement: row",
            "    statement: line",
            "no statement",
        ),
        ("unknown field", "linuxcnc.yaml", "    field: positive", "    field: forward", "no field"),
        (
            "form without its fields",
            "linuxcnc.yaml",
            '"{position} {positive} {negative}"',
            '"{position} {positive}"',
            "fields",
        ),
        (
            "unknown option",
            "linuxcnc.yaml",
            "writes: {option: units}",
            "writes: {option: unit}",
            "no option",
        ),
        (
            "a choice the file cannot say",
            "linuxcnc.yaml",
            'choices: ["0", "1"]',
            'choices: ["0", "1", "2"]',
            "not one of the values",
        ),
        (
            "a default outside the choices",
            "linuxcnc.yaml",
            "default: mm",
            "default: cm",
            "does not suit",
        ),
        (
            "no file for the table",
            "linuxcnc.yaml",
            "    rows: row",
            "    rows: null",
            "exactly one file",
        ),
        (
            "file name with a folder",
            "linuxcnc.yaml",
            '"joint_{axis}.comp"\n    text',
            '"a/joint_{axis}.comp"\n    text',
            "plain file name",
        ),
        (
            "a single value without a place",
            "linuxcnc.yaml",
            "singles: [table_file, ",
            "singles: [",
            "no place",
        ),
        (
            "too few positions",
            "linuxcnc.yaml",
            "      - {position: -7, positive: 254, negative: -254}\n",
            "",
            "at least three",
        ),
        (
            "a newer schema",
            "siemens-840d-sl.yaml",
            "compwright_format: 2",
            "compwright_format: 3",
            "newer version",
        ),
        (
            "an older schema",
            "siemens-840d-sl.yaml",
            "compwright_format: 2",
            "compwright_format: 1",
            "older form of definitions",
        ),
        ("no index", "siemens-840d-sl.yaml", "index: integer", "index: decimal", "index: integer"),
        (
            "address of another type",
            "siemens-840d-sl.yaml",
            "  type: name",
            "  type: integer",
            "type of the addresses",
        ),
        (
            "a verdict of which it does not say where to look",
            "linuxcnc.yaml",
            "  mirrored:\n",
            "  asleep:\n",
            "look_at.mirrored is missing",
        ),
        (
            "an unknown field in what to look at",
            "linuxcnc.yaml",
            "The HAL pin joint.{address}",
            "The HAL pin joint.{joint}",
            "has no field joint",
        ),
        (
            "an unknown field in the alternative to a cross-axis table",
            "linuxcnc.yaml",
            "add {squareness} to",
            "add {angle} to",
            "between_axes.instead has no field angle",
        ),
        (
            "an unknown field in a typed parameter",
            "linuxcnc.yaml",
            "BACKLASH of [JOINT_{address}]",
            "BACKLASH of [JOINT_{joint}]",
            "bindings.backlash.typed has no field joint",
        ),
        ("alias", "siemens-840d-sl.yaml", "proven: []", "proven: &a []\nagain: *a", "alias"),
    ],
)
def test_a_damaged_definition_is_refused_with_its_place(
    what: str, file: str, old: str, new: str, says: str
) -> None:
    assert old in TEXT[file]
    with pytest.raises(InputError, match=says) as caught:
        load_definition(TEXT[file].replace(old, new, 1).encode(), "mine.yaml")
    assert all(fault.file == "mine.yaml" and "line" in fault.place for fault in caught.value.faults)


def test_all_faults_at_once() -> None:
    text = (
        TEXT["linuxcnc.yaml"]
        .replace("digits: 7", "digits: x", 1)
        .replace("pairing: two_columns", "pairing: three", 1)
    )
    with pytest.raises(InputError) as caught:
        load_definition(text.replace("  encoding: ascii\n", "", 1).encode(), "mine.yaml")
    assert len(caught.value.faults) == 3
    assert sorted(fault.place.split(", ")[1] for fault in caught.value.faults) == [
        "bindings.node_position.digits",
        "dialect.encoding",
        "layout.pairing",
    ]


@pytest.mark.parametrize(
    ("what", "file", "old", "new"),
    [
        ("flipped sign", "siemens-840d-sl.yaml", "    sign: error", "    sign: correction"),
        ("other end", "siemens-840d-sl.yaml", "below: hold, above: hold", "below: hold, above: zero"),
        ("start and end exchanged", "siemens-840d-sl.yaml", "_COMP_MIN[{system},{axis}]={v", "_COMP_MAX[{system},{axis}]={v"),
        ("unit inch", "siemens-840d-sl.yaml", "{option: units}, rotary: deg}\n    sign: error", "inch, rotary: deg}\n    sign: error"),
        ("first value counts", "siemens-840d-sl.yaml", 'writes: "1"\n    repeated: last', 'writes: "1"\n    repeated: first'),
        ("wrong hand-worked number", "siemens-840d-sl.yaml", "positive: -2, negative", "positive: -2.001, negative"),
        ("broken sample", "siemens-840d-sl.yaml", "$AA_ENC_COMP[0,2,AX1]=0.0\n", "\n"),
        ("forms exchanged", "linuxcnc.yaml", '{"0": actual, "1": trim}', '{"0": trim, "1": actual}'),
        ("columns exchanged", "linuxcnc.yaml", "{position} {positive} {negative}", "{position} {negative} {positive}"),
        ("whole backlash", "linuxcnc.yaml", "sign: half_each_way", "sign: lost_motion"),
        ("form lost on writing", "linuxcnc.yaml", '"COMP_FILE_TYPE = 0", ', ""),
        ("an unknown field on the card", "linuxcnc.yaml", "section [JOINT_{address}]", "section [JOINT_{joint}]"),
    ],
)  # fmt: skip
def test_the_gate_catches_a_definition_that_means_something_else(
    what: str, file: str, old: str, new: str
) -> None:
    text = TEXT[file]
    assert old in text
    damaged = text.replace(old, new, 1)
    if what == "form lost on writing":
        damaged = damaged.replace(
            'default: "0"', 'default: "1"', 1
        )  # then the lost key no longer says what the table is
    definition = load_definition(damaged.encode(), "mine.yaml")
    faults = check_definition(definition)
    assert faults
    assert all(fault.file == "mine.yaml" for fault in faults)


def test_two_files_of_one_id() -> None:
    with pytest.raises(InputError, match="given twice"):
        definitions_from(
            [("a.yaml", CONTENT["linuxcnc.yaml"]), ("b.yaml", CONTENT["linuxcnc.yaml"])]
        )


# Options
# -----------------------------------------------------------------------------------------------------------------------


def test_options_have_defaults_and_are_converted() -> None:
    assert resolve_options(LINUXCNC, {})["comp_file_type"] == "0"
    assert resolve_options(LINUXCNC, {"comp_file_type": 1})["comp_file_type"] == "1"
    values = resolve_options(SIEMENS, {"points": "26", "cec_tables": "3,4", "reference": "0.001"})
    assert (values["points"], values["cec_tables"], values["reference"]) == (26, (3, 4), 0.001)
    assert resolve_options(SIEMENS, values) == values
    assert any(line.startswith("points (default not given)") for line in describe_options(SIEMENS))


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"pionts": 3}, "points"),
        ({"points": "many"}, "whole number"),
        ({"points": 2.5}, "whole number"),
        ({"points": True}, "whole number"),
        ({"points": "-1"}, "whole number"),
        ({"points": "nan"}, "whole number"),
        ({"cec": "perhaps"}, "absent, available"),
        ({"cec_tables": [1, "x"]}, "whole number"),
        ({"encoder_system": 3}, "auto, 1, 2"),
        ({"reference": "0,5"}, "decimal point"),
        ({"reference_return": "up"}, "\\+ or -"),
    ],
)
def test_wrong_options_are_refused(given: dict[str, object], says: str) -> None:
    with pytest.raises(UsageError, match=says):
        resolve_options(SIEMENS, given)
    with pytest.raises(UsageError) as caught:
        resolve_options(SIEMENS, {**given, "nonsense": 1})
    assert len(caught.value.faults) >= 2


# Patches
# -----------------------------------------------------------------------------------------------------------------------


def test_a_patch_leaves_everything_else_alone() -> None:
    original = "; Größe\r\nN32450 $MA_BACKLASH[1, AX2] = +0.0005 '1A2F\r\n$MA_KP[0,AX2]=1\r\nM17\r\n".encode(
        "latin-1"
    )
    faults: list = []  # type: ignore[type-arg]
    read = TextReader(SIEMENS).read(ControlFile("a.ini", original), faults)
    assert read is not None
    assert not faults
    (place,) = read.occurrences
    assert original[place.tokens["value"].start : place.tokens["value"].end] == b"+0.0005"
    assert original[place.tokens["axis"].start : place.tokens["axis"].end] == b"AX2"
    changed = apply_changes(original, set_field(place, "value", "0.001200"))
    # the new value, and no line checksum, which would no longer fit
    assert changed == original.replace(b"+0.0005 '1A2F", b"0.001200")


def test_spans_of_a_section_and_of_insertions() -> None:
    text = b"[JOINT_12]\n  BACKLASH = 0.5\n"
    read = TextReader(LINUXCNC).read(ControlFile("a.ini", text), [])
    assert read is not None
    (place,) = read.occurrences
    axis = place.tokens["axis"]
    assert text[axis.start : axis.end] == b"12"
    assert (
        apply_changes(
            b"abc", [BytesChange(1, 1, b"x"), BytesChange(1, 1, b"y"), BytesChange(2, 3, b"")]
        )
        == b"axyb"
    )
    with pytest.raises(ValueError, match="overlaps"):
        apply_changes(b"abc", [BytesChange(0, 2, b""), BytesChange(1, 3, b"")])
    with pytest.raises(ValueError, match="outside"):
        apply_changes(b"abc", [BytesChange(2, 4, b"")])


# The card and the commands
# -----------------------------------------------------------------------------------------------------


def test_the_card_is_filled_in_with_its_evidence() -> None:
    axis = axis_of("AX1", system=2)
    compensation = table(
        "AX1",
        [-100.0, -50.0, 0.0, 50.0, 100.0],
        [-0.003, -0.001, 0.0, 0.002, 0.0045],
        backlash=0.0125,
    )
    steps = card_steps(
        SIEMENS,
        axis,
        card_values(
            control_format(SIEMENS, {}), axis, compensation, AxisFacts(), compensation.positions
        ),
    )
    text = "\n".join(step.text for step in steps)
    assert UNKNOWN not in text
    for words in (
        "MD38000 $MA_MM_ENC_COMP_MAX_POINTS[1,AX1] must be at least 5",
        "from -100 to 100 mm every 50 mm",
        "AX1_EEC.INI",
        "$MA_BACKLASH[1,AX1] = 0.0125",
        "at the check positions",
        "measuring system 2",
    ):
        assert words in text
    assert {step.evidence for step in steps} <= {"confirmed", "inferred", "unconfirmed"}
    assert UNKNOWN in "".join(step.text for step in card_steps(SIEMENS, axis, {}))


@pytest.mark.parametrize("definition", DEFINITIONS.values(), ids=list(DEFINITIONS))
def test_every_control_says_where_to_look_for_every_verdict(definition: Definition) -> None:
    axis = axis_of("3" if definition.addresses.type == "integer" else "AX3")
    one = table(axis.address, [0.0, 100.0], [0.0, 1e-3])
    for compensation in (one, replace(one, negative=-one.negative)):
        said = look_at(control_format(definition, {}), axis, compensation)
        assert set(said) == set(LOOKED_AT)
        for verdict, sentences in said.items():
            assert all(sentences), verdict
            assert not any(mark in sentence for sentence in sentences for mark in "{}"), verdict
            told = [sentence.endswith("(unconfirmed)") for sentence in sentences]
            rules = definition.look_at[verdict]
            assert told == [rule.evidence.state == "unconfirmed" for rule in rules]
    assert any(axis.address in sentence for rules in said.values() for sentence in rules)


def test_a_pair_of_tables_has_switches_of_its_own() -> None:
    axis = axis_of("AX3")
    one = table(axis.address, [0.0, 100.0], [0.0, 1e-3])
    control = control_format(DEFINITIONS["siemens-840d-sl"], {})
    (single, *_), (pair, *_) = (
        look_at(control, axis, each)["not_active"]
        for each in (one, replace(one, negative=-one.negative))
    )
    assert "MD32700 $MA_ENC_COMP_ENABLE[0,AX3]" in single
    assert "MD32710 $MA_CEC_ENABLE[AX3]" in pair


def test_where_to_look_is_said_for_all_verdicts_or_for_none() -> None:
    whole = merged(texts_of(CONTENT["linuxcnc.yaml"], "mine.yaml", found_in(CONTENT)))
    silent = definition_in(replace(whole, data=_without(whole.data, ("look_at",))))
    table_of_x = table("0", [0.0, 100.0], [0.0, 1e-3])
    assert look_at(control_format(silent, {}), axis_of("0"), table_of_x) == {}
    empty = {**whole.data, "look_at": {**whole.data["look_at"], "partial": []}}
    with pytest.raises(InputError, match=r"look_at\.partial: says nothing"):
        definition_in(replace(whole, data=empty))


def test_list_show_and_check(tmp_path: Path) -> None:
    listed = [line[2:22].strip() for line in list_formats(Session()) if line.startswith("  ")]
    assert sorted(filter(None, listed)) == sorted(DEFINITIONS)
    shown = "\n".join(show_format(Session(), "siemens-840d-sl"))
    for words in (
        "error, the opposite of the correction",
        "What is unconfirmed",
        "max points: upper limit",
        "cec (default absent",
        "S1 p240",
        "verdict not active: one table: MD32700 $MA_ENC_COMP_ENABLE[<index>,<address>] must be 1",
        "look at, partial: ",
    ):
        assert words in shown
    with pytest.raises(UsageError, match=r"linuxcnc or pmac or .*siemens-840d-sl"):
        show_format(Session(), "nonesuch")
    with pytest.raises(UsageError, match=r"expected siemens-828d .*siemens-840d-sl") as several:
        show_format(Session(), "siemens")  # the name of several
    assert "linuxcnc" not in str(several.value)
    assert len(check_formats(Session(), [])) == len(DEFINITIONS)
    good = tmp_path / "good.yaml"
    good.write_bytes(CONTENT["linuxcnc.yaml"])
    assert len(check_formats(Session(), [tmp_path])) == 1
    (tmp_path / "bad.yaml").write_text(
        TEXT["siemens-840d-sl.yaml"].replace("    sign: error", "    sign: correction"),
        encoding="utf-8",
    )
    (tmp_path / "worse.yaml").write_text("id: 3\n", encoding="utf-8")
    with pytest.raises(InputError) as bad:
        check_formats(Session(), [tmp_path])
    assert {Path(fault.file).name for fault in bad.value.faults} == {"bad.yaml", "worse.yaml"}
    with pytest.raises(InputError, match="does not exist"):
        check_formats(Session(), [tmp_path / "missing.yaml"])
    empty = tmp_path / "empty"
    empty.mkdir()
    with pytest.raises(InputError, match="no definition"):
        check_formats(Session(), [empty])
