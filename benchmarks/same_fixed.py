"""What needs no random job: the examples, the definitions, evaluations of the examples' tests."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import yaml

STANDARDS = (
    "iso230-2:1988", "iso230-2:1997", "iso230-2:2006", "iso230-2:2014", "gost27843:2006", "vdi3441",
)  # fmt: skip


def write_fixed(root: Path, old: Path) -> list[str]:
    """Write the fixed jobs below ``root``; return their folders."""
    names = []
    examples = sorted(path.parent for path in (old / "examples").glob("*/job.yaml"))
    for example in examples:
        names.append(f"fixed/example-{example.name}")
        folder = root / names[-1]
        shutil.copytree(example, folder)
        _put(folder, _example(folder))
    definitions = sorted((old / "controller_formats").glob("*.yaml"))
    folder = root / "fixed/formats"
    names.append("fixed/formats")
    shutil.copytree(old / "controller_formats", folder / "definitions")
    _put(folder, _formats(folder, definitions))
    names.append("fixed/evaluate")
    folder = root / "fixed/evaluate"
    for example in examples:
        for test in example.glob("*/*.csv"):
            (folder / "tests").mkdir(parents=True, exist_ok=True)
            shutil.copy(test, folder / "tests" / f"{example.name}-{test.name}")
    one = min((folder / "tests").iterdir()).relative_to(folder)
    commands = [["evaluate", "tests", "--standard", name] for name in STANDARDS]
    commands += [["evaluate", "tests", "--json", f"{n}.json"] for n in range(1)]
    commands += [["evaluate", str(one), "--targets", "--plot", "plot.svg"]]
    commands += [["evaluate", str(one), "--spread", "range", "--standard", "iso230-2:1988"]]
    commands += [["evaluate", "missing.csv", str(one), "--json", "-"], ["demo", "--out", "demo"]]
    _put(folder, commands)
    return names


def _put(folder: Path, commands: list[list[str]]) -> None:
    (folder / "commands.json").write_text(json.dumps(commands))
    (folder / "truth.json").write_text("{}")


def _example(folder: Path) -> list[list[str]]:
    """As its page tells, with the virtual machine where there is one."""
    job = yaml.safe_load((folder / "job.yaml").read_text(encoding="utf-8"))
    tables = f"job/tables/{job['controller']['format']}"
    commands = [
        ["run", "job.yaml"],
        ["run", "job.yaml"],
        ["run", "job.yaml", "--force", "--json", "-"],
        ["decode", tables, "--format", job["controller"]["format"]],
    ]
    if (folder / "machine.yaml").is_file():
        after = [f"after/{name.lower()}.csv" for name in job["axes"]]
        verify = ["verify", "job.yaml", *(word for path in after for word in ("--after", path))]
        commands += [
            ["simulate", "machine.yaml", "--out", "after", "--seed", "2", "--with-tables", tables],
            verify,
            [*verify, "--loaded", tables, "--out", "loaded", "--json", "-"],
        ]
    return commands


def _formats(folder: Path, definitions: list[Path]) -> list[list[str]]:
    """List, show and check; definitions of one's own that are right, and that are faulty."""
    commands = [["formats", "list"], ["formats", "check"], ["formats", "check", "definitions"]]
    commands += [["formats", "show", path.stem] for path in definitions]
    commands += [["formats", "show", "no-such"], ["formats"], ["--help"], ["run", "--help"]]
    for path in definitions:
        text = path.read_text(encoding="utf-8")
        for number, (before, after) in enumerate(
            (
                ("sign: error", "sign: correction"),
                ("sign: lost_motion", "sign: error"),
                ("digits: 0", "digits: -1"),
                ("repeated: same", "repeated: never"),
                ("form: ", "from: "),
                ("limits:", "limit:"),
                ("state: confirmed", "state: sure"),
                ("below: hold", "below: zero"),
                ("position: ", "position: x"),
            )
        ):
            name = f"mine/{path.stem}-{number}.yaml"
            (folder / "mine").mkdir(exist_ok=True)
            (folder / name).write_text(text.replace(before, after, 1), encoding="utf-8")
            commands.append(["formats", "check", name])
    return commands
