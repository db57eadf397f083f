"""Check that the parts of a definition agree: every name used in one part exists in another."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping

from compwright.formats.definition.schema import (
    Choice,
    Definition,
    Measure,
    OptionRule,
    OptionValue,
)
from compwright.formats.definition.shape_rules import ShapeRules
from compwright.formats.definition.statements import field_names
from compwright.formats.definition.vocabulary import CHOICES, CROSS, LOOKED_AT, PLAIN
from compwright.foundations.errors import Fault
from compwright.foundations.key_faults import KeyPath

#: Quantities that stand alone, one value each.
SINGLES = tuple(name for name in ("backlash", "slope", *CHOICES, *PLAIN) if name not in CROSS)
#: The neutral words that the engine knows for a choice; `table_form` has its own.
WORDS = {
    "rotary": {"linear", "rotary"},
    "length_unit": {"mm", "inch"},
    "unit_word": {"mm", "inch"},
    "angle_unit": {"deg"},
    **{
        name: {"yes", "no"}
        for name in CHOICES
        if name not in ("rotary", "length_unit", "unit_word", "angle_unit", "table_form")
    },
}
_SIGNS = {
    "backlash": {"lost_motion", "half_each_way"},
    "slope": {"error", "correction"},
    "value": {"error", "correction", "actual_position"},
    "value_positive": {"error", "correction", "actual_position"},
    "value_negative": {"error", "correction", "actual_position"},
    "cross_value": {"error", "correction"},
}
_NUMBERED = (
    "min_points",
    "max_points",
    "line_length",
    "line_length_read",
    "max_number",
    "max_magnification",
    "feed_per_spacing",
    "spacing_per_step",
    "cross_tables",
    "cross_points",
)
#: What sentences on where to look may say of an axis.
_LOOK_FIELDS = frozenset(
    {"name", "address", "system", "index", "reference", "reference_return", "unit"}
)
#: What the backlash as the control's parameter may say, with the fields of the shape.
_TYPED_FIELDS = _LOOK_FIELDS | {"backlash", "backlash_unit"}
#: What the alternative to a cross-axis table may say.
_INSTEAD_FIELDS = frozenset({"squareness", "input", "output", "shift"})
_FILE_NAME = re.compile(r"[A-Za-z0-9_.{}-]+")
_ID = re.compile(r"(?!(?:con|prn|aux|nul|com\d|lpt\d)$)[a-z0-9][a-z0-9_-]{0,63}", re.IGNORECASE)


def curves(definition: Definition) -> tuple[str, ...]:
    """Return the names of the quantities that hold a table's corrections: one for both directions,
    or one for + and one for - approach.
    """
    return (
        ("value",) if definition.layout.pairing == "none" else ("value_positive", "value_negative")
    )


def has_cross(definition: Definition) -> bool:
    """Return whether the definition describes cross-axis tables, in which the position of one axis
    corrects another axis or the same one.
    """
    return any(name in definition.bindings for name in CROSS)


def contradictions(definition: Definition, shapes: Mapping[str, ShapeRules]) -> tuple[Fault, ...]:
    """Return a fault for each contradiction within a definition whose keys are all valid.
    ``shapes``: the rules for definitions, by the shape of their tables.
    """
    rules = shapes.get(definition.layout.shape)
    if rules is None:
        expected, found = f"one of {', '.join(shapes)}", definition.layout.shape
        path: KeyPath = ("layout", "shape")
        message = "is not known here"
        return (definition.text.fault(path, message, expected=expected, found=found),)
    return tuple(
        definition.text.fault(path, message)
        for found_by in (
            _id(definition),
            _texts(definition),
            _statements(definition),
            _layout(definition, rules),
            _between_axes(definition, rules),
            _bindings(definition, rules),
            _options(definition),
            _limits(definition, rules),
            _parameters(definition, rules),
            _writing(definition, rules),
            _card(definition),
            _look_at(definition),
        )
        for path, message in found_by
    )


def _id(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    if not _ID.fullmatch(definition.id):
        yield (
            ("id",),
            (
                "must be a plain name for a folder: at most 64 letters a to z, digits, - and _, and"
                " no device of Windows such as con"
            ),
        )


def _texts(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    for text in definition.texts.values():
        for key, name in (("recognised_by", text.recognised_by), ("sections", text.sections)):
            if name is not None and (
                name not in definition.statements or definition.statements[name].text != text.name
            ):
                yield ("texts", text.name, key), f"no statement {name} in this kind of text"
        if (
            text.sections in definition.statements
            and "section" not in definition.statements[str(text.sections)].fields
        ):
            yield ("texts", text.name, "sections"), "the statement has no field section"
    if not any(text.recognised_by is None for text in definition.texts.values()):
        yield (
            ("texts",),
            (
                "one kind of text must take the files that no other one recognises (recognised_by:"
                " null)"
            ),
        )


def _statements(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    for name, statement in definition.statements.items():
        path = ("statements", name)
        if statement.text not in definition.texts:
            yield (*path, "text"), f"no kind of text is called {statement.text}"
        for form in (statement.form, *statement.also_read):
            if sorted(field_names(form)) != sorted(statement.fields):
                yield (*path, "form"), f"the fields of {form} are not those under fields"
        if statement.within is not None:
            kind = definition.texts.get(statement.text)
            if kind is not None and kind.sections is None:
                yield (*path, "within"), "this kind of text has no sections"
            if set(field_names(statement.within)) - {"axis"}:
                yield (*path, "within"), "only {axis} is allowed in the name of a section"
        if statement.fields.get("axis", definition.addresses.type) != definition.addresses.type:
            yield (*path, "fields"), "the field axis must have the type of the addresses"


def _layout(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    singles, known = definition.layout.singles, (*SINGLES, *rules.quantities)
    for single in singles:
        if single not in known:
            yield (
                (
                    "layout",
                    "singles",
                ),
                f"{single} cannot stand alone; known are {', '.join(known)}",
            )
    needed = {*rules.grid, *curves(definition), *singles}
    if has_cross(definition):  # cross-axis tables come with all that they need, or not at all
        needed |= set(CROSS)
    for name in sorted(needed - set(definition.bindings)):
        yield ("bindings",), f"the layout needs the quantity {name}"
    for name in sorted(set(definition.bindings) - needed):
        yield ("bindings", name), "the layout has no place for this quantity"
    parts = [
        definition.bindings[name].statement
        for name in curves(definition)
        if name in definition.bindings
    ]
    if rules.row == "position" and "node_position" in definition.bindings:
        parts.append(definition.bindings["node_position"].statement)
    if len(set(parts)) > 1 and rules.row is not None:
        yield ("bindings",), "position and values of a row must be in one statement"
    row = definition.statements.get(parts[0]) if parts else None
    if rules.row == "index" and row is not None and row.fields.get("index") != "integer":
        yield ("statements", row.name, "fields"), "a value by index needs the field index: integer"


def _between_axes(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    if not definition.between_axes.instead and not rules.columns:
        yield (
            ("between_axes", "instead"),
            "only where every table has columns for other axes nothing else is needed",
        )
    instead = definition.between_axes.instead or ""
    yield from _unknown_fields(("between_axes", "instead"), instead, _INSTEAD_FIELDS)


def _unknown_fields(
    path: KeyPath, text: str, known: frozenset[str]
) -> Iterator[tuple[KeyPath, str]]:
    for name in sorted({*field_names(text)} - known):
        yield path, f"has no field {name}; known are {', '.join(sorted(known))}"


def _bindings(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    for name, binding in definition.bindings.items():
        path = ("bindings", name)
        statement = definition.statements.get(binding.statement)
        if statement is None:
            yield (*path, "statement"), f"no statement is called {binding.statement}"
        elif binding.field not in statement.fields:
            yield (*path, "field"), f"the statement {statement.name} has no field {binding.field}"
        if isinstance(binding, Measure):
            yield from _measure(definition, rules, binding, path)
            known = _TYPED_FIELDS | rules.typed
            yield from _unknown_fields((*path, "typed"), binding.typed, known)
        if isinstance(binding, Choice):
            yield from _choice(definition, binding, path)


def _choice(
    definition: Definition, binding: Choice, path: KeyPath
) -> Iterator[tuple[KeyPath, str]]:
    words = WORDS.get(binding.quantity, set(binding.values.values()))
    for word in sorted(set(binding.values.values()) - words):
        yield (*path, "values"), f"{word} is not one of {', '.join(sorted(words))}"
    if binding.when_absent is not None and binding.when_absent.value not in binding.values.values():
        yield (*path, "when_absent"), f"{binding.when_absent.value} is not one of the values"
    if isinstance(binding.writes, OptionValue):
        option = definition.options.get(binding.writes.option)
        if option is None:
            yield (*path, "writes"), f"no option is called {binding.writes.option}"
        elif set(option.choices) - set(binding.values):
            yield (
                (
                    *path,
                    "writes",
                ),
                f"the option {option.name} has a choice that is not one of the values",
            )
    elif binding.writes not in binding.values:
        yield (*path, "writes"), f"{binding.writes} is not one of the values"


def _measure(
    definition: Definition, rules: ShapeRules, binding: Measure, path: KeyPath
) -> Iterator[tuple[KeyPath, str]]:
    if (
        isinstance(binding.linear_unit, OptionValue)
        and binding.linear_unit.option not in definition.options
    ):
        yield (*path, "unit"), f"no option is called {binding.linear_unit.option}"
    allowed = rules.signs.get(
        binding.quantity, _SIGNS.get(binding.quantity, frozenset({"position"}))
    )
    signs: list[str] = [binding.sign] if binding.sign is not None else list(binding.signs.values())
    if binding.sign_option is not None:
        option = definition.options.get(binding.sign_option)
        signs = list(option.choices) if option is not None else []
        if not signs:
            yield (*path, "sign"), f"no option with choices is called {binding.sign_option}"
    for sign in signs:
        if sign not in allowed:
            yield (
                (
                    *path,
                    "sign",
                ),
                f"{sign} does not suit this quantity; it can be {', '.join(sorted(allowed))}",
            )
    if binding.sign_by is not None:
        choice = definition.bindings.get(binding.sign_by)
        if not isinstance(choice, Choice) or set(choice.values.values()) != set(binding.signs):
            yield (*path, "sign"), f"there must be one sign for each value of {binding.sign_by}"
    if "actual_position" in signs:
        position = definition.bindings.get("node_position")
        if (
            not isinstance(position, Measure)
            or position.digits != binding.digits
            or position.linear_unit != binding.linear_unit
        ):
            yield (*path, "digits"), "actual positions need the digits and the unit of the position"


def _options(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    for name, option in definition.options.items():
        path = ("options", name)
        if option.type == "choice" and not option.choices:
            yield (*path, "choices"), "a choice needs its choices"
        if option.type != "choice" and option.choices:
            yield (*path, "choices"), "only a choice has choices"
        if not _default_suits(option):
            yield (*path, "default"), f"the default does not suit the type {option.type}"
        if option.asked is not None and option.type != "number":
            yield (*path, "asked"), "only a number is asked for"
        if option.settled_by is not None and option.settled_by not in definition.bindings:
            yield (*path, "settled_by"), f"no quantity is called {option.settled_by}"


def _default_suits(option: OptionRule) -> bool:
    value = option.default
    if option.type == "choice":
        return value is None or value in option.choices
    if option.type == "integers":
        return isinstance(value, tuple) and all(isinstance(item, int) for item in value)
    if option.type == "text":
        return value is None or isinstance(value, str)
    return value is None or (
        isinstance(value, int if option.type == "integer" else (int, float))
        and not isinstance(value, bool)
    )


def _limits(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    if rules.afresh and definition.limit("no_patching") is None:
        yield ("limits",), "rows by position are written afresh: this needs no_patching"
    for predicate, count in Counter(rule.predicate for rule in definition.limits).items():
        if count > 1:
            yield ("limits",), f"{predicate} is given {count} times"
    for index, rule in enumerate(definition.limits):
        if (rule.number is not None) != (rule.predicate in _NUMBERED):
            yield (
                (
                    "limits",
                    index,
                    "number",
                ),
                f"{rule.predicate} needs {'a number' if rule.number is None else 'null'}",
            )
        if rule.predicate == "points_reserved" and not any(
            o.settled_by == "max_points" for o in definition.options.values()
        ):
            yield ("limits", index), "needs an option that is settled by max_points"


def _parameters(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    for name in sorted(rules.parameters - definition.parameters.keys()):
        yield ("parameters", name), "key is missing"
    for name in sorted(definition.parameters.keys() - rules.parameters):
        yield ("parameters", name), "is not known here"


def _writing(definition: Definition, rules: ShapeRules) -> Iterator[tuple[KeyPath, str]]:
    table = definition.bindings.get(curves(definition)[0])
    tables = [
        file
        for file in definition.writing
        if file.rows is not None and file.when in ("always", "one_curve")
    ]
    if len(tables) != 1 or (table is not None and tables[0].rows != table.statement):
        yield ("writing",), "exactly one file must contain the rows of the table"
    for when in ("two_curves", "cross"):
        rows = [
            file.rows for file in definition.writing if file.when == when and file.rows is not None
        ]
        wanted = (
            [definition.bindings["cross_value"].statement]
            if "cross_value" in definition.bindings
            else []
        )
        if rows != wanted:
            yield (
                ("writing",),
                (
                    f"one file of the set {when} must contain the rows of the cross-axis tables,"
                    " where the control has them"
                ),
            )
    for index, file in enumerate(definition.writing):
        path = ("writing", index)
        if file.text not in definition.texts:
            yield (*path, "text"), f"no kind of text is called {file.text}"
        if (rules.by_axis and "{axis}" not in file.name) or not _FILE_NAME.fullmatch(file.name):
            yield (*path, "name"), "must be a plain file name that contains {axis}"
        for line in (file.name, *file.header, *file.footer):
            if set(field_names(line)) - {"axis", "system", "program"}:
                yield path, f"only {{axis}}, {{system}} and {{program}} are allowed in {line}"


def _card(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    for index, rule in enumerate(definition.card):
        for name in field_names(rule.title):
            yield ("card", index, "title"), f"has no field {name}: use it in the text of the step"
    for name in field_names(definition.diameter.card):
        if name != "name":
            yield ("diameter", "card"), f"has no field {name}; known is name"


def _look_at(definition: Definition) -> Iterator[tuple[KeyPath, str]]:
    for verdict in LOOKED_AT if definition.look_at else ():
        rules = definition.look_at[verdict]
        if not rules:
            yield ("look_at", verdict), "says nothing: at least one sentence"
        for index, rule in enumerate(rules):
            texts = rule.text + rule.two_curves
            yield from _unknown_fields(("look_at", verdict, index), texts, _LOOK_FIELDS)
