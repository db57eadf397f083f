"""Make pydantic schemas from the field types of records, to read records from mappings.

A `RecordForm` states where a mapping in a file differs from the fields of its record. A list is
read as a tuple, and a word as a member of an enumeration. No other value is converted.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from functools import partial
from typing import Any, Literal, Union, cast, get_args, get_origin, get_type_hints

from pydantic_core import SchemaValidator
from pydantic_core import core_schema as cs

from compwright.foundations.key_faults import KeyFault, shown
from compwright.foundations.validation import refuse, unknown_key, worded

#: By class: the violated conditions of a record, beyond the types of its fields.
Rules = Mapping[type, Callable[[Any], Iterator[str]]]


@dataclass(frozen=True, slots=True, kw_only=True)
class RecordForm:
    """How a mapping in a file differs from the fields of its record class, such as in key names.

    - ``keys``: by field, its key, if the names differ.
    - ``absent``: fields whose keys may be missing.
    - ``constant``: values of fields that the mapping does not contain, or may lack (``absent``).
    - ``named``: the field whose value is the key above the mapping.
    - ``inline``: the field that is a record, whose keys are in this mapping.
    - ``nested``: fields that are in a mapping of their own: by its key, the field of each key in
      it.
    - ``types``: by field, a type or schema that differs from that of the record.
    - ``more``: types or schemas of keys that belong to no field.
    - ``others``: whether all other keys are allowed and ignored.
    - ``build``: a function from the values by field, and by key of ``more``, to the record's
      values.
    """

    keys: Mapping[str, str] = field(default_factory=dict)
    absent: frozenset[str] = frozenset()
    constant: Mapping[str, object] = field(default_factory=dict)
    named: str = ""
    inline: str = ""
    nested: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    types: Mapping[str, Any] = field(default_factory=dict)
    more: Mapping[str, Any] = field(default_factory=dict)
    others: bool = False
    build: Callable[[dict[str, Any]], Mapping[str, Any]] = dict


def listed(item: cs.CoreSchema) -> cs.CoreSchema:
    """Return the schema of a list of any length, read as a tuple."""
    return cs.tuple_schema([item], variadic_item_index=0, strict=False)


def mapping(
    keys: Mapping[str, cs.CoreSchema],
    build: Callable[[dict[str, Any]], Any],
    *,
    optional: Collection[str] = (),
    others: bool = False,
    ref: str | None = None,
) -> cs.CoreSchema:
    """Return the schema of a mapping with given ``keys``. ``build``: makes the result from the
    validated values; ``others``: whether other keys are allowed, and ignored; ``ref``: a name by
    which other schemas refer to this one.
    """
    known = cs.typed_dict_schema(
        {
            key: cs.typed_dict_field(schema, required=key not in optional)
            for key, schema in keys.items()
        },
        strict=True,
        extra_behavior="ignore" if others else "allow",
        extras_schema=None if others else unknown_key(list(keys)),
    )
    return cs.no_info_after_validator_function(build, known, ref=ref)


class RecordSchemas:
    """Makes the pydantic schemas of record classes, and stores them. ``plain``: the schemas of
    types that are no records.
    """

    def __init__(
        self, forms: Mapping[type, RecordForm], rules: Rules, plain: Mapping[Any, cs.CoreSchema]
    ) -> None:
        self._forms, self._rules, self._plain = forms, rules, plain
        self._records: dict[str, cs.CoreSchema | None] = {}

    def validator(self, cls: type) -> SchemaValidator:
        """Return the validator that makes a record of ``cls`` from a mapping."""
        top = self.of(cls)
        records = [schema for schema in self._records.values() if schema is not None]
        return SchemaValidator(cs.definitions_schema(top, records))

    def of(self, hint: Any) -> cs.CoreSchema:
        """Return the pydantic schema of a type. A schema is returned unchanged."""
        if isinstance(hint, dict):
            return cast("cs.CoreSchema", hint)
        origin, inner = get_origin(hint) or hint, get_args(hint)
        if origin in self._plain:
            return self._plain[origin]
        if origin is Literal:
            return cs.literal_schema(list(inner))
        if origin in {Union, types.UnionType}:
            return self._union(inner)
        if origin is tuple and inner[-1] is Ellipsis:
            return listed(self.of(inner[0]))
        if origin is tuple:
            return _of_length(len(inner), cs.tuple_schema([self.of(one) for one in inner]))
        if inner:
            return self._by_name(*inner)
        if is_dataclass(hint):
            return self._record(hint)
        return _word(hint)

    def _union(self, options: tuple[Any, ...]) -> cs.CoreSchema:
        """Return the schema of a value that may be missing or have one of several types.

        If all types are records, the key ``kind`` selects one of them. Otherwise any type that fits
        is accepted.
        """
        kinds = [one for one in options if one is not types.NoneType]
        if len(kinds) == 1:
            schema = self.of(kinds[0])
        elif all(is_dataclass(one) for one in kinds):
            by_kind = {get_args(get_type_hints(one)["kind"])[0]: self.of(one) for one in kinds}
            schema = cs.tagged_union_schema(by_kind, discriminator="kind")
        else:
            names = ("a number" if one is float else str(*get_args(one)) for one in kinds)
            either = cs.union_schema([self.of(one) for one in kinds])
            schema = worded(either, "is not an accepted value", " or ".join(names))
        return cs.nullable_schema(schema) if types.NoneType in options else schema

    def _record(self, cls: Any) -> cs.CoreSchema:
        ref = f"{cls.__module__}.{cls.__qualname__}"
        if ref not in self._records:
            self._records[ref] = None  # a record may hold others of its class
            self._records[ref] = self._mapping(cls, self._forms.get(cls, RecordForm()), ref)
        return cs.definition_reference_schema(ref)

    def _by_name(self, key: Any, value: Any) -> cs.CoreSchema:
        keys = None if key is str else self.of(key)
        return self.named(value, cs.dict_schema(keys, self.of(value), strict=True))

    def named(self, cls: Any, schema: cs.CoreSchema) -> cs.CoreSchema:
        """Return the schema of a mapping from names to records. If the class ``cls`` has a field
        for the name, each record gets its key as its name.
        """
        name = self._forms.get(cls, RecordForm()).named if isinstance(cls, type) else ""
        if not name:
            return schema
        return cs.no_info_after_validator_function(
            lambda found: {key: replace(one, **{name: key}) for key, one in found.items()}, schema
        )

    def _mapping(self, cls: Any, form: RecordForm, ref: str) -> cs.CoreSchema:
        types_of = get_type_hints(cls)
        hints = {one.name: types_of[one.name] for one in fields(cls)} | dict(form.types)
        apart = {one for keys in form.nested.values() for one in keys.values()}
        apart |= {form.named, *form.constant.keys() - form.absent}
        names = {form.keys.get(name, name): name for name in hints if name not in apart}
        schemas = {key: self.of(hints[name]) for key, name in names.items()}
        for key, inner in form.nested.items():
            schemas[key] = mapping(
                {one: self.of(hints[name]) for one, name in inner.items()}, partial(_renamed, inner)
            )
        schemas |= {key: self.of(more) for key, more in form.more.items()}
        rule = self._rules.get(cls)

        def record(values: dict[str, Any]) -> Any:
            given = {names.get(key, key): value for key, value in values.items()}
            for key in form.nested:
                given |= given.pop(key)
            own = {name: value for name, value in form.build(given).items() if name in hints}
            made = cls(**{**form.constant, **({form.named: ""} if form.named else {})} | own)
            broken = [] if rule is None else list(rule(made))
            if broken:
                refuse(*(KeyFault((), "contradicts itself", expected) for expected in broken))
            return made

        whole = mapping(
            schemas,
            record,
            optional={form.keys.get(name, name) for name in form.absent},
            others=form.others,
            ref=None if form.inline else ref,
        )
        if not form.inline:
            return whole
        own = {*names, *form.more} - {form.inline}

        def nested(data: Any) -> Any:
            if not isinstance(data, dict):
                return data
            return {key: value for key, value in data.items() if key in own} | {
                form.inline: {key: value for key, value in data.items() if key not in own}
            }

        return cs.no_info_before_validator_function(nested, whole, ref=ref)


def _renamed(names: Mapping[str, str], values: Mapping[str, Any]) -> dict[str, Any]:
    return {names[key]: value for key, value in values.items()}


def _of_length(length: int, schema: cs.CoreSchema) -> cs.CoreSchema:
    def same_length(data: Any) -> Any:
        if not isinstance(data, list) or len(data) != length:
            refuse(KeyFault((), "has the wrong form", f"a list of {length}", shown(data)))
        return tuple(data)

    return cs.no_info_before_validator_function(same_length, schema)


def _word(enumeration: type[Enum]) -> cs.CoreSchema:
    words = cs.literal_schema([member.value for member in enumeration])
    return cs.no_info_after_validator_function(enumeration, words)
