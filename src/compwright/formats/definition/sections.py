"""The sections of a definition -> records, one function for each kind of entry."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import cast, get_args

from compwright.formats.definition.bindings import binding_of, evidence_of
from compwright.formats.definition.extends import DefinitionText
from compwright.formats.definition.required import Required
from compwright.formats.definition.schema import (
    Addresses,
    BetweenAxes,
    CardRule,
    Definition,
    Dialect,
    DiameterRule,
    Expectation,
    Expected,
    Layout,
    LimitRule,
    LookRule,
    OptionRule,
    ParameterRule,
    Statement,
    TextKind,
    WrittenFile,
)
from compwright.formats.definition.vocabulary import (
    LOOKED_AT,
    AddressType,
    Case,
    DiameterTables,
    FieldType,
    Here,
    OptionType,
    Pairing,
    Predicate,
    Rest,
    When,
)
from compwright.formats.definition.yaml_fields import Node
from compwright.records.axis import AxisKind, Direction
from compwright.records.correction import Beyond
from compwright.records.plan import Texts
from compwright.records.verification import LoadingName

_NEWLINES = {"lf": "\n", "crlf": "\r\n", "lfcrcr": "\n\r\r"}


def definition_of_sections(
    part: Mapping[str, Node], text: DefinitionText, own: Texts
) -> Definition:
    """Return the record of a definition from its top sections; faults go to the nodes."""
    file = text.file
    sample = part["sample"].keys("options", "files")
    sample_files = {name: node.text() for name, node in sample["files"].entries()}
    return Definition(
        id=part["id"].text(),
        title=part["title"].text(),
        aliases=part["aliases"].texts() if "aliases" in part else (),
        file=file,
        sources={name: node.text() for name, node in part["sources"].entries()},
        proven=tuple(
            {
                key: field.text()
                for key, field in node.keys("control", "machine", "date", "how").items()
            }
            for node in part["proven"].items()
        ),
        addresses=_addresses(part["addresses"]),
        dialect=_dialect(part["dialect"]),
        texts=Required(
            {name: _text(name, node) for name, node in part["texts"].entries()},
            section="texts",
            file=file,
        ),
        statements=Required(
            {name: _statement(name, node) for name, node in part["statements"].entries()},
            section="statements",
            file=file,
        ),
        layout=_layout(part["layout"]),
        bindings=Required(
            {
                name: binding
                for name, node in part["bindings"].entries()
                if (binding := binding_of(name, node)) is not None
            },
            section="bindings",
            file=file,
        ),
        between_axes=_between_axes(part["between_axes"]),
        diameter=_diameter(part["diameter"]),
        parameters=dict(_parameters(part["parameters"])) if "parameters" in part else {},
        limits=tuple(_limit(node) for node in part["limits"].items()),
        options=Required(
            {name: _option(name, node) for name, node in part["options"].entries()},
            section="options",
            file=file,
        ),
        writing=tuple(_written(node) for node in part["writing"].items()),
        card=tuple(_card(node) for node in part["card"].items()),
        look_at=_look_at(part["look_at"]) if "look_at" in part else {},
        sample_files=sample_files,
        sample_options={name: node.data for name, node in sample["options"].entries()},
        expect=tuple(_expectation(node, sample_files) for node in part["expect"].items()),
        text=text,
        own=own,
    )


def _addresses(node: Node) -> Addresses:
    part = node.keys("type", "case", "letters", "evidence")
    return Addresses(
        type=part["type"].literal(AddressType),
        case=part["case"].literal(Case),
        letters=part["letters"].optional_text(),
        evidence=evidence_of(part["evidence"]),
    )


def _dialect(node: Node) -> Dialect:
    part = node.keys(
        "encoding",
        "newline",
        "newlines_read",
        "case",
        "block_number",
        "line_checksum",
        "blanks",
        "evidence",
    )
    part["encoding"].one_of(("ascii",))
    return Dialect(
        newline=_NEWLINES[part["newline"].one_of(tuple(_NEWLINES))],
        newlines_read=tuple(
            _NEWLINES[item.one_of(tuple(_NEWLINES))] for item in part["newlines_read"].items()
        ),
        case=part["case"].literal(Case),
        block_number=part["block_number"].optional_text(),
        line_checksum=part["line_checksum"].optional_text(),
        blanks_anywhere=part["blanks"].one_of(("beside_marks", "anywhere")) == "anywhere",
        evidence=evidence_of(part["evidence"]),
    )


def _text(name: str, node: Node) -> TextKind:
    part = node.keys(
        "recognised_by",
        "sections",
        "comments",
        "blank_lines",
        "claims",
        "other_lines",
        "ends_with",
        "evidence",
    )
    comments = part["comments"].keys("marks", "where")
    claims = part["claims"].keys("at_start", "anywhere")
    others = part["other_lines"].keys("are", "because")
    return TextKind(
        name=name,
        recognised_by=part["recognised_by"].optional_text(),
        sections=part["sections"].optional_text(),
        comment_marks=comments["marks"].texts(),
        comments_anywhere=comments["where"].one_of(("anywhere", "line_start")) == "anywhere",
        blank_lines_anywhere=part["blank_lines"].one_of(("anywhere", "at_end")) == "anywhere",
        claims_at_start=claims["at_start"].texts(),
        claims_anywhere=claims["anywhere"].texts(),
        other_lines_refused=others["are"].one_of(("ignored", "refused")) == "refused",
        because=others["because"].text(),
        ends_with=part["ends_with"].texts(),
        evidence=evidence_of(part["evidence"]),
    )


def _statement(name: str, node: Node) -> Statement:
    part = node.keys("text", "form", "also_read", "fields", "within", "rest", "evidence")
    return Statement(
        name=name,
        text=part["text"].text(),
        form=part["form"].text(),
        also_read=part["also_read"].texts(),
        fields={field: kind.literal(FieldType) for field, kind in part["fields"].entries()},
        within=part["within"].optional_text(),
        rest=part["rest"].literal(Rest),
        evidence=evidence_of(part["evidence"]),
    )


def _layout(node: Node) -> Layout:
    part = node.keys("shape", "pairing", "ends", "singles", "evidence")
    ends = part["ends"].keys("below", "above")
    return Layout(
        shape=part["shape"].text(),
        pairing=part["pairing"].literal(Pairing),
        below=ends["below"].literal(Beyond),
        above=ends["above"].literal(Beyond),
        singles=part["singles"].texts(),
        evidence=evidence_of(part["evidence"]),
    )


def _limit(node: Node) -> LimitRule:
    part = node.keys("predicate", "number", "evidence")
    number = None if part["number"].is_null else part["number"].integer(1, 10**6)
    return LimitRule(
        predicate=part["predicate"].literal(Predicate),
        number=number,
        evidence=evidence_of(part["evidence"]),
    )


def _between_axes(node: Node) -> BetweenAxes:
    part = node.keys("instead", "evidence")
    return BetweenAxes(
        instead=part["instead"].optional_text() or "", evidence=evidence_of(part["evidence"])
    )


def _diameter(node: Node) -> DiameterRule:
    part = node.keys("tables", "card", "evidence")
    return DiameterRule(
        tables=part["tables"].literal(DiameterTables),
        card=part["card"].text(),
        evidence=evidence_of(part["evidence"]),
    )


def _parameters(node: Node) -> Iterator[tuple[str, ParameterRule]]:
    for name, each in node.entries():
        part = each.keys("here", "evidence")
        yield name, ParameterRule(part["here"].literal(Here), evidence_of(part["evidence"]))


def _option(name: str, node: Node) -> OptionRule:
    part = node.keys(
        "type", "default", "choices", "settled_by", "belongs_to", "asked", "help", "evidence"
    )
    settled = (
        None if part["settled_by"].is_null else part["settled_by"].keys("quantity", "contradiction")
    )
    contradiction = (
        "refused"
        if settled is None
        else settled["contradiction"].one_of(("refused", "option_wins"))
    )
    return OptionRule(
        name=name,
        type=part["type"].literal(OptionType),
        default=(
            tuple(part["default"].data)
            if isinstance(part["default"].data, list)
            else part["default"].data
        ),
        choices=() if part["choices"].is_null else part["choices"].texts(),
        settled_by=None if settled is None else settled["quantity"].text(),
        option_wins=contradiction == "option_wins",
        whole_control=part["belongs_to"].one_of(("axis", "control")) == "control",
        asked=part["asked"].optional_text(),
        help=part["help"].text(),
        evidence=evidence_of(part["evidence"]),
    )


def _written(node: Node) -> WrittenFile:
    part = node.keys("name", "text", "header", "rows", "footer", "set", "evidence")
    belongs = part["set"].one_of(
        ("complete", "optional", *(word for word in get_args(When) if word != "always"))
    )
    return WrittenFile(
        name=part["name"].text(),
        text=part["text"].text(),
        header=part["header"].texts(),
        rows=part["rows"].optional_text(),
        footer=part["footer"].texts(),
        optional=belongs == "optional",
        when="always" if belongs in ("complete", "optional") else cast("When", belongs),
        evidence=evidence_of(part["evidence"]),
    )


def _card(node: Node) -> CardRule:
    part = node.keys("title", "text", "evidence")
    one_curve, two_curves = _by_curves(part["text"])
    return CardRule(
        title=part["title"].text(),
        text=one_curve,
        two_curves=two_curves,
        evidence=evidence_of(part["evidence"]),
    )


def _by_curves(node: Node) -> tuple[str, str]:
    """Return a text for one table and for one of each direction: the same, unless it names both."""
    if not isinstance(node.data, dict):
        return (text := node.text()), text
    part = node.keys("one_curve", "two_curves")
    return part["one_curve"].text(), part["two_curves"].text()


def _look_at(node: Node) -> dict[LoadingName, tuple[LookRule, ...]]:
    part = node.keys(*LOOKED_AT)
    return {name: tuple(_look(each) for each in part[name].items()) for name in LOOKED_AT}


def _look(node: Node) -> LookRule:
    part = node.keys("text", "evidence")
    return LookRule(*_by_curves(part["text"]), evidence_of(part["evidence"]))


def _expectation(node: Node, sample: Mapping[str, str]) -> Expectation:
    part = node.keys("name", "files", "options", "axis", "kind", "reference_return", "unit", "at")
    points = []
    for item in part["at"].items():
        at = item.keys("position", "positive", "negative")
        points.append(
            Expected(at["position"].number(), at["positive"].number(), at["negative"].number())
        )
    if len(points) < 3 and isinstance(part["at"].data, list):
        part["at"].fault(
            "has too few positions",
            expected="at least three, worked by hand",
            found=str(len(points)),
        )
    files = (
        sample
        if part["files"].data == "sample"
        else {name: text.text() for name, text in part["files"].entries()}
    )
    return Expectation(
        name=part["name"].text(),
        files=files,
        options={name: option.data for name, option in part["options"].entries()},
        axis=part["axis"].text(),
        kind=AxisKind(part["kind"].one_of(tuple(AxisKind))),
        reference_return=Direction(part["reference_return"].one_of(tuple(Direction))),
        unit=part["unit"].one_of(("um", "mm", "arcsec", "deg")),
        at=tuple(points),
    )
