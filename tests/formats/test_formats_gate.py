"""The gate over the definitions that ship: it passes them, and it notices a limit that nobody keeps
and a judge that disagrees.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from compwright.formats import gate
from compwright.formats.definition.inheritance import found_in
from compwright.formats.definitions import load_definition
from compwright.formats.families.family import Family
from compwright.formats.gate import check_definition
from compwright.foundations import storage
from compwright.foundations.errors import Fault, InputError
from compwright.foundations.session import Session
from compwright.workflow.commands.formats import check_formats

SHIPPED: Mapping[str, bytes] = dict(storage.definition_files(Session()))
CONTROLS = [name for name in SHIPPED if not name.endswith(".base.yaml")]


@pytest.mark.parametrize("name", CONTROLS)
def test_every_definition_that_ships_passes(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(SHIPPED[name])
    (line,) = check_formats(Session(), [tmp_path])
    assert "by the virtual control too" in line
    assert "every limit is kept" in line


@pytest.mark.parametrize("name", CONTROLS)
def test_a_writer_that_takes_everything_is_noticed(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    limits_of = gate.unenforced_limits

    def unenforced(control: Family, *table: Any) -> Iterator[Fault]:
        monkeypatch.setattr(control, "write", lambda *_: ())
        return limits_of(control, *table)

    monkeypatch.setattr(gate, "unenforced_limits", unenforced)
    faults = check_definition(load_definition(SHIPPED[name], name, found_in(SHIPPED)))
    assert len(faults) >= 4
    assert all("is written all the same" in fault.message for fault in faults)


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        # Definition and hand-worked value are wrong in the same way: only the virtual control knows
        # better.
        (
            "fanuc-0i-d.yaml",
            "{position: 90, positive: -1, negative: -3}",
            "{position: 90, positive: -1, negative: 1}",
        ),
        (
            "siemens-840d-sl.yaml",
            "{position: 50, positive: 2, negative: 1.5}",
            "{position: 50, positive: -2, negative: 1.5}",
        ),
    ],
)
def test_a_hand_worked_value_that_does_not_come_out_is_told(
    name: str, old: str, new: str, tmp_path: Path
) -> None:
    text = SHIPPED[name].decode()
    assert old in text
    (tmp_path / name).write_text(text.replace(old, new, 1))
    with pytest.raises(InputError, match="is not the one worked by hand"):
        check_formats(Session(), [tmp_path])


def test_a_definition_whose_sign_is_wrong_in_both_places_is_caught_by_the_virtual_control(
    tmp_path: Path,
) -> None:
    text = (
        SHIPPED["siemens-840d-sl.yaml"]
        .decode()
        .replace("    sign: error", "    sign: correction", 1)
    )
    # The sample's values 3, 1, 0, -2, -4.5 µm at -100 to 100 taken as corrections, backlash 0.5 µm
    # arriving in -.
    wrong = """
expect:
  - name: worked with the wrong meaning
    files: sample
    options: {}
    axis: AX1
    kind: linear
    reference_return: "+"
    unit: um
    at:
      - {position: -75, positive: 2, negative: 1.5}
      - {position: -50, positive: 1, negative: 0.5}
      - {position: 50, positive: -2, negative: -2.5}
"""
    (tmp_path / "siemens-840d-sl.yaml").write_text(text[: text.index("\nexpect:")] + wrong)
    with pytest.raises(InputError, match="the virtual control does not agree"):
        check_formats(Session(), [tmp_path])
