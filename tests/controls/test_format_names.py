"""What a control is called and what it needs of an axis: further names of formats, the nearest one
of a slip, and all questions at once, each with the option that answers it.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from compwright.cli import run as compwright

pytestmark = pytest.mark.short_estimate

ROWS = "".join(
    f"{x},{sign},{run},{0.03 * x + (2 if sign == '-' else 0) + 0.1 * run}\n"
    for run in (1, 2, 3)
    for sign in "+-"
    for x in range(0, 401, 40)
)


@pytest.fixture
def test_file(tmp_path: Path) -> str:
    path = tmp_path / "x.csv"
    path.write_text(f"# axis: X\ntarget_mm,direction,run,deviation_um\n{ROWS}")
    return str(path)


def asked(capsys: pytest.CaptureFixture[str]) -> set[str]:
    """The options and keys that error lines name."""
    lines = capsys.readouterr().err.splitlines()
    assert all(line.startswith("error: ") for line in lines)
    return {line.split(": ")[1] for line in lines}


@pytest.mark.parametrize(
    ("words", "names"),
    [
        (
            ["--format", "fanuc-30i", "--travel", "0:400", "--state", "none"],
            {"address", "detection_unit", "first_point"},
        ),
        (
            ["--format", "fanuc-30i"],
            {"address", "detection_unit", "first_point", "travel", "state"},
        ),
        # without a state there is no table, and no number of its first point
        (
            ["--format", "fanuc-30i", "--travel", "0:400", "--option", "address=1"],
            {"detection_unit"},
        ),
        (
            [
                *("--format", "fanuc-15i", "--travel", "0:400", "--state", "none"),
                *("--option", "reference=100"),
            ],
            {"address", "detection_unit", "first_point", "points_from"},
        ),
        (
            ["--format", "pmac", "--travel", "0:400", "--state", "none"],
            {"address", "counts_per_unit"},
        ),
        (["--format", "isg-kernel", "--travel", "0:400", "--state", "none"], {"address"}),
    ],
)
def test_everything_is_asked_for_at_once(
    words: list[str], names: set[str], test_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright(["run", test_file, "--axis", "X", *words]) == 2
    expected = {
        f"--{name}" if name in {"travel", "state"} else f"--option {name}" for name in names
    }
    assert asked(capsys) == expected


def test_a_job_file_is_asked_the_same(
    tmp_path: Path, test_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "job.yaml").write_text(
        "compwright: 1\ncontroller: {format: fanuc-30i}\nstates: {as_found: none}\n"
        f"axes: {{X: {{travel: [0, 400], before: [{test_file}]}}}}\n"
    )
    assert compwright(["run", str(tmp_path / "job.yaml")]) == 2
    said = capsys.readouterr().err
    for key in ("axes.X.address", "options.detection_unit", "options.first_point"):
        assert key in said


def test_the_answers_are_all_that_was_missing(test_file: str, tmp_path: Path) -> None:
    words = ["--format", "fanuc-30i", "--axis", "X", "--travel", "0:400", "--state", "none"]
    given = ("address=1", "detection_unit=0.001", "first_point=10")
    options = [f"--option={answer}" for answer in given]
    assert compwright(["run", test_file, *words, *options, "--out", str(tmp_path / "o")]) == 0


@pytest.mark.parametrize(
    ("name", "found"),
    [
        ("tnc7", "heidenhain-nck"),
        ("TNC 640", "heidenhain-nck"),
        ("itnc530", "heidenhain-itnc530"),
        ("beckhoff", "isg-kernel"),
        ("twincat", "isg-kernel"),
        ("emc2", "linuxcnc"),
        ("828D", "siemens-828d"),
        ("Fanuc 31i", "fanuc-30i"),
    ],
)
def test_a_name_of_one_format_is_that_format(
    name: str, found: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright(["formats", "show", name]) == 0
    assert capsys.readouterr().out.startswith(f"{found}: ")


@pytest.mark.parametrize(
    ("name", "fit"),
    [
        ("fanuc", {"fanuc-30i", "fanuc-0i-d", "fanuc-0i-f", "fanuc-0i-16i", "fanuc-15i"}),
        ("840d", {"siemens-840d-sl", "siemens-840d-pl"}),
        ("sinumerik", {"siemens-840d-sl", "siemens-840d-pl", "siemens-828d", "siemens-one"}),
        ("HEIDENHAIN", {"heidenhain-itnc530", "heidenhain-nck"}),
    ],
)
def test_a_name_of_several_formats_lists_them(
    name: str, fit: set[str], test_file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["run", test_file, "--format", name, "--axis", "X", "--travel", "0:400"]
    assert compwright(words) == 2
    said = capsys.readouterr().err
    listed = said.split("expected ")[1].split(", found")[0]
    assert {part.split(" (")[0] for part in listed.split(" or ")} == fit


@pytest.mark.parametrize(
    ("slip", "nearest"),
    [
        ("beckhof", "isg-kernel"),
        ("fanuc-31", "fanuc-30i"),
        ("linuxcnk", "linuxcnc"),
        ("tnc641", "heidenhain-nck"),
    ],
)
def test_a_slip_names_the_nearest(
    slip: str, nearest: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compwright(["formats", "show", slip]) == 2
    assert f"expected {nearest}, the nearest" in capsys.readouterr().err


def test_the_format_that_was_taken_is_said(
    test_file: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["--format", "emc2", "--axis", "X", "--travel", "0:400", "--state", "none"]
    assert compwright(["run", test_file, *words, "--out", str(tmp_path / "o")]) == 0
    assert "CW-S062" in capsys.readouterr().out
    assert (tmp_path / "o" / "tables" / "linuxcnc").is_dir()
