"""Find the definition of a control: supplied by compwright, in a user's file, or in a plan."""

from __future__ import annotations

from functools import cache
from pathlib import Path, PureWindowsPath

from compwright.formats.definition.inheritance import BASE_ENDING, EXTENDS, Find, found_in
from compwright.formats.definition.schema import Definition
from compwright.formats.definitions import (
    definition_of,
    definitions_from,
    load_definition,
)
from compwright.formats.gate import check_definition
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError, UsageError, raise_all
from compwright.foundations.input_sizes import DEFINITION
from compwright.foundations.key_faults import nearest
from compwright.foundations.session import Session
from compwright.foundations.yaml_reader import read_yaml
from compwright.records.plan import Texts

_YAML = (".yaml", ".yml")
#: The largest definition that ships has a tenth of it; YAML of 256 MiB would be read for hours.


def is_path(name: str) -> bool:
    """Return whether the name of a control is a file path and not an id."""
    return name.lower().endswith(_YAML) or "/" in name or "\\" in name


def definition_named(session: Session, name: str, folder: Path) -> Definition:
    """Return the definition that ``name`` states: a supplied one by its id, or a user's own by its
    path after its checks. ``folder``: the folder to which this path is relative.

    Raises UsageError for an unknown id, with the known ids. Raises UsageError with every fault of
    the user's file.
    """
    if not is_path(name):
        return _shipped(session, name)
    try:
        definition = own_definition(session, storage.named_from(folder, name))
        raise_all(InputError, _gate(definition.own))
    except InputError as error:
        raise UsageError(*error.faults) from error
    return definition


def own_definition(session: Session, path: Path) -> Definition:
    """Return the definition in a user's file, with its keys checked.

    The definition that it extends must be in the same folder or be supplied with compwright. Raises
    InputError with every fault. The id of a supplied definition is a fault too, because results and
    folders are named by the id.
    """
    definition = load_definition(
        _content(session, path), str(path), _neighbour_files(session, path.parent), own=True
    )
    raise_all(InputError, name_conflicts(session, definition))
    return definition


def shipped_definitions(session: Session) -> dict[str, Definition]:
    """Return all definitions supplied with compwright, by id. Raises InputError if unreadable."""
    return definitions_from(storage.definition_files(session))


def name_conflicts(session: Session, definition: Definition) -> tuple[Fault, ...]:
    """Return a fault if a definition has the id of a supplied definition, in any letter case; else
    no faults.
    """
    stems = (Path(name).stem for name, _ in storage.definition_files(session))
    shipped = {stem.casefold(): stem for stem in stems}.get(definition.id.casefold())
    if shipped is None:
        return ()
    return (
        definition.text.fault(
            ("id",),
            "this is the id of a control that ships, which no other definition can have",
            expected="an id of its own",
            found=definition.id,
            hint=f"write `id: my-{shipped}`, or use the control that ships by its name {shipped}",
        ),
    )


def carried_definition(session: Session, texts: Texts) -> Definition:
    """Return the definition that is copied into a plan. Raises InputError with every fault."""
    raise_all(InputError, _gate(texts))
    definition = definition_of(texts, own=True)
    raise_all(InputError, name_conflicts(session, definition))
    return definition


def files_of_definition(texts: Texts) -> dict[str, bytes]:
    """Return the user's own files of a definition in a plan, without supplied definitions.

    ``texts``: file names and contents of the definition. Raises InputError if a file is outside of
    the definition's folder.
    """
    name = PureWindowsPath(texts[0][0]).name
    found = {}
    for file, content in texts:
        found[name] = content
        name = str(read_yaml(content, file).data.get(EXTENDS, ""))
        if not is_path(name):  # one that ships
            break
        if PureWindowsPath(name).anchor or ".." in PureWindowsPath(name).parts:
            raise InputError(
                Fault(
                    message="the definition extends a file outside of its own folder, but a run "
                    "copies only files of this folder to its results",
                    file=file,
                    place=EXTENDS,
                    found=name,
                    hint=(
                        "write a file of the same folder, or an id from `compwright formats "
                        "list`, as `extends`"
                    ),
                )
            )
    return found


def definitions_at(session: Session, path: Path) -> list[tuple[str, bytes, Find]]:
    """Return the definitions in a file or folder. Raises InputError for unreadable files, and if
    ``path`` is a base for other definitions.
    """
    if is_base(path):
        raise InputError(
            Fault(
                message="this definition is only the base of others and describes no control "
                "by itself",
                file=str(path),
                expected="a definition that extends it",
                hint="give the path of the definition that extends it",
            )
        )
    return [
        (str(entry), _content(session, entry), _neighbour_files(session, entry.parent))
        for entry in storage.list_files(session, path)
        if entry == path or (entry.name.lower().endswith(_YAML) and not is_base(entry))
    ]


def is_base(path: Path) -> bool:
    """Return whether a file is a base for other definitions and does not describe a control."""
    return path.name.endswith(BASE_ENDING)


@cache  # by content: a job is checked before it is done
def _gate(texts: Texts) -> tuple[Fault, ...]:
    return check_definition(definition_of(texts, own=True))


def _content(session: Session, path: Path) -> bytes:
    return storage.read_bytes(session, path, DEFINITION)


def _neighbour_files(session: Session, folder: Path) -> Find:
    """Return a function that finds a base definition by name: in a file of ``folder``, or supplied
    with compwright.
    """

    def find(name: str) -> tuple[str, bytes] | None:
        path = folder / name
        if is_path(name) and storage.is_there(session, path):
            return str(path), _content(session, path)
        return found_in(dict(storage.definition_files(session)))(name)

    return find


def _shipped(session: Session, format_id: str) -> Definition:
    """Return a supplied definition by its id, reading only its own file if possible."""
    files = dict(storage.definition_files(session))
    own = f"{format_id}.yaml"
    if own in files and not own.endswith(BASE_ENDING):
        named = load_definition(files[own], own, found_in(files))
        if named.id == format_id:
            return named
    definitions = shipped_definitions(session)
    if format_id in definitions:
        return definitions[format_id]
    meant = [one for one in definitions.values() if _plain(format_id) in _names(one)]
    if len(meant) == 1:
        return meant[0]
    if meant:
        message = "several control formats have this name: give the id of one"
        expected = " or ".join(f"{one.id} ({_short(one.title)})" for one in meant)
    else:
        names = {name for one in definitions.values() for name in _names(one)}
        near = nearest(_plain(format_id), sorted(names))
        alike = [one.id for one in definitions.values() if near in _names(one)]
        message = "no such control format"
        expected = " or ".join([*definitions, "the path of a file *.yaml"])
        if alike:
            expected = f"{' or '.join(alike)}, the nearest; all are {expected}"
    raise UsageError(
        Fault(
            message=message,
            place="format",
            expected=expected,
            found=format_id,
            hint=("use an id of `compwright formats list`, or the path of a definition"),
        )
    )


def _names(definition: Definition) -> set[str]:
    """Return the names of a control in lower case, letters and digits only, for comparison."""
    return {_plain(name) for name in (definition.id, *definition.aliases)}


def _short(title: str) -> str:
    """Return a control's title up to its first comma that is not inside brackets."""
    depth = 0
    for place, letter in enumerate(title):
        depth += (letter == "(") - (letter == ")")
        if letter == "," and not depth:
            return title[:place]
    return title


def _plain(name: str) -> str:
    """Return only the letters and digits of a name, in lower case."""
    return "".join(letter for letter in name.casefold() if letter.isalnum())
