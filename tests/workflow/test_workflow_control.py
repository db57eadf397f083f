"""Opening a control: its definition is found by its own file, and an unknown one is told with those
that exist.
"""

import re
from collections.abc import Mapping

import pytest

from compwright.controls.control import open_control
from compwright.foundations import storage
from compwright.foundations.errors import UsageError
from compwright.foundations.session import Session
from format_samples import DEFINITIONS


def extended(files: Mapping[str, bytes], name: str) -> list[str]:
    """Return the file and those that it extends, one after the other."""
    found = re.search(rb"^extends: (\S+)", files[name], re.MULTILINE)
    if found is None:
        return [name]
    base = found[1].decode()
    return [name, *extended(files, base if base.endswith(".yaml") else f"{base}.yaml")]


@pytest.mark.parametrize("format_id", DEFINITIONS)
def test_a_control_is_opened_from_the_file_of_its_name(
    format_id: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # The other files may be damaged: they are not read, which is also what keeps the start of a run
    # short.
    there = dict(storage.definition_files(Session()))
    needed = extended(there, f"{format_id}.yaml")
    files = {name: content if name in needed else b"id: [" for name, content in there.items()}
    monkeypatch.setattr(storage, "definition_files", lambda _: iter(files.items()))
    control = open_control(Session(), format_id, {})
    assert control.definition == DEFINITIONS[format_id]


def test_a_definition_in_a_file_of_another_name_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    there = dict(storage.definition_files(Session()))
    bases = {base for name in there for base in extended(there, name)[1:]}
    files = {name if name in bases else f"my-{name}": content for name, content in there.items()}
    monkeypatch.setattr(storage, "definition_files", lambda _: iter(files.items()))
    assert open_control(Session(), "linuxcnc", {}).definition.file == "my-linuxcnc.yaml"


def test_an_unknown_control_is_told_with_all_that_exist() -> None:
    with pytest.raises(UsageError) as caught:
        open_control(Session(), "linux", {})
    assert all(format_id in str(caught.value) for format_id in DEFINITIONS)
