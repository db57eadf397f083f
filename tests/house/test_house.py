"""The house rules that no single test sees: who may import whom, who touches the disk, what
start-up loads, finding codes.

Everything is read from the syntax trees of ``src/compwright``; the table of edges repeats
``docs/architecture.md`` on purpose, and a test compares the two.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeGuard

import pytest

from places import PROJECT
from source_trees import nodes_below, trees

ROOMS = (
    *(
        "foundations",
        "records",
        "instruments",
        "evaluation",
        "estimation",
        "fitting",
        "formats",
        "controllers",
        "prediction",
        "planning",
    ),
    *("verification", "simulation", "documents", "reporting", "jobs", "controls", "workflow"),
    *("library", "words"),
)
MAY_IMPORT: dict[str, set[str]] = {
    "words": set(),
    "foundations": {"words"},
    "records": {"words", "foundations"},
    "instruments": {"words", "foundations", "records"},
    "evaluation": {"words", "foundations", "records"},
    "estimation": {"words", "foundations", "records"},
    "fitting": {"words", "foundations", "records"},
    "formats": {"words", "foundations", "records"},
    "controllers": {"words", "foundations", "records"},
    "prediction": {"words", "foundations", "records", "evaluation"},
    "planning": {
        *("words", "foundations", "records", "evaluation", "estimation", "fitting", "prediction"),
    },
    "verification": {"words", "foundations", "records", "evaluation", "estimation"},
    "simulation": {"words", "foundations", "records"},
    "documents": {"words", "foundations", "records"},
    "reporting": {"words", "foundations"},
    "jobs": {"words", "foundations", "records"},
    "controls": {
        *("words", "foundations", "records", "formats", "controllers", "prediction", "planning"),
        *("evaluation", "verification", "documents"),
    },
    "workflow": set(ROOMS) - {"workflow", "library"},
    "library": {
        *("words", "foundations", "records", "evaluation", "estimation", "planning", "documents"),
        *("reporting", "controls", "workflow"),
    },
    "cli": {"foundations", "workflow"},
    "__main__": {"cli"},
    "__init__": {"foundations", "records", "library"},
}

#: Packages of others -> rooms that may import them anywhere. What is not listed here needs an
#: entry, and so a thought.
OTHERS: dict[str, set[str]] = {
    "numpy": set(ROOMS) - {"foundations", "jobs"},
    "scipy": {"fitting", "estimation"},
    "osqp": {"fitting"},
    "cvxpy": {"fitting"},
    "yaml": {"foundations"},
    "pydantic": {"jobs"},
    "pydantic_core": {"jobs", "foundations", "documents", "simulation", "instruments", "formats"},
    "click": {"cli"},
    "rich": {"reporting"},
    "matplotlib": {"reporting"},
    "jinja2": {"reporting"},
    "typst": {"reporting"},
    "openpyxl": {"instruments", "reporting"},
}
SLOW_TO_IMPORT = {
    *("scipy", "osqp", "cvxpy", "matplotlib", "pydantic", "pydantic_core", "rich", "jinja2"),
    "numpy",
}

# What reaches the file system, other programs or the network.
REACHING_MODULES = {
    *(
        "os",
        "shutil",
        "tempfile",
        "glob",
        "fileinput",
        "subprocess",
        "socket",
        "ssl",
        "http",
        "ftplib",
        "sqlite3",
        "dbm",
        "shelve",
    ),
    *("urllib.request", "webbrowser", "mmap", "fcntl", "multiprocessing", "requests", "linecache"),
}
REACHING_CALLS = {
    *(
        "read_text",
        "read_bytes",
        "write_text",
        "write_bytes",
        "mkdir",
        "rmdir",
        "unlink",
        "touch",
        "rename",
        "exists",
        "is_file",
    ),
    *(
        "is_dir",
        "is_symlink",
        "iterdir",
        "rglob",
        "hardlink_to",
        "symlink_to",
        "chmod",
        "lstat",
        "expanduser",
        "resolve",
        "cwd",
        "home",
    ),
    *("savetxt", "loadtxt", "genfromtxt", "fromfile", "tofile", "open_memmap", "savez", "open"),
}


@dataclass(frozen=True, slots=True)
class Import:
    """One imported name: by which module (dotted, without compwright), from where, and whether when
    that module is loaded.
    """

    by: str
    target: str
    name: str
    at_load: bool
    line: int

    @property
    def room(self) -> str:
        return self.by.partition(".")[0]

    def __str__(self) -> str:
        return (
            f"{self.by} line {self.line} imports"
            f" {self.target}{f'.{self.name}' if self.name else ''}"
        )


def statements_of(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the statements, handlers and cases that stand directly in another one or a module."""
    for field in ("body", "handlers", "orelse", "finalbody", "cases"):
        yield from getattr(node, field, ())


def imports_in(node: ast.AST, by: str, *, at_load: bool = True) -> Iterator[Import]:
    for child in statements_of(node):
        if isinstance(child, ast.Import):
            for alias in child.names:
                yield Import(by, alias.name, "", at_load, child.lineno)
        elif isinstance(child, ast.ImportFrom):
            assert child.level == 0, f"{by} line {child.lineno}: relative import"
            for alias in child.names:
                yield Import(by, child.module or "", alias.name, at_load, child.lineno)
        else:
            inside = isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef)
            for_names = isinstance(child, ast.If) and last_name(child.test) == "TYPE_CHECKING"
            yield from imports_in(child, by, at_load=at_load and not (inside or for_names))


@cache
def all_imports() -> tuple[Import, ...]:
    return tuple(found for name in trees() for found in all_imports_of(name))


@cache
def all_imports_of(module: str) -> tuple[Import, ...]:
    return tuple(imports_in(trees()[module], module))


def inside(found: Import) -> str | None:
    """Return the module of the house that is imported, None for a module of others."""
    package, _, below = found.target.partition(".")
    if package != "compwright":
        return None
    deeper = f"{below}.{found.name}" if below else found.name
    return deeper if deeper in trees() else below or "__init__"


def test_source_was_found_with_every_room_known() -> None:
    assert len(trees()) > 20
    assert {name.partition(".")[0] for name in trees()} <= set(MAY_IMPORT)


def test_each_class_has_a_name_of_its_own() -> None:
    names = Counter(
        node.name
        for tree in trees().values()
        for node in nodes_below(tree)
        if isinstance(node, ast.ClassDef)
    )
    assert [name for name, count in names.items() if count > 1] == []


def test_controls_is_the_door_to_formats_and_controllers() -> None:
    past = {
        found.by
        for found in all_imports()
        if (inside(found) or "").partition(".")[0] in ("formats", "controllers")
        and found.room not in ("formats", "controllers", "controls")
    }
    assert past == set()


def test_table_of_edges_is_that_of_the_page() -> None:
    page = (PROJECT / "docs" / "architecture.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([\w.]+)` \|[^|]*\|([^|]*)\|$", page, re.MULTILINE)
    by_page: dict[str, set[str]] = {}
    for room, allowed in rows:
        words = set() if "nothing" in allowed else {word.strip() for word in allowed.split(",")}
        by_page[room.removesuffix(".py")] = set(ROOMS) - {room} if words == {"all"} else words
    assert by_page == {
        room: allowed for room, allowed in MAY_IMPORT.items() if not room.startswith("__")
    }


#: A file and a function of it, as the page names them.
PLACE = re.compile(r"`([\w/]+)\.py` `([\w.]+)`")


def walk() -> list[list[tuple[str, str]]]:
    """Return the places of each step of a job through `run`, as the page has them (module,
    function): its own first, then those that it asks.
    """
    page = (PROJECT / "docs" / "architecture.md").read_text(encoding="utf-8")
    _, _, rest = page.partition("## The walk of a job through `run`")
    steps = re.findall(r"^[0-9]+\. (.*)$", rest.partition("\n## ")[0], re.MULTILINE)
    return [
        [
            (file.removesuffix("/__init__").replace("/", "."), name)
            for file, name in PLACE.findall(step)
        ]
        for step in steps
    ]


def test_each_module_on_the_page_exists() -> None:
    page = (PROJECT / "docs" / "architecture.md").read_text(encoding="utf-8")
    places = [PROJECT / room for room in ("src", "tests", "benchmarks")]
    there = [f"/{path.as_posix()}" for place in places for path in place.rglob("*.py")]
    named = re.findall(r"`([\w/]+\.py)`", page)
    assert len(named) > 60
    assert [one for one in named if not any(path.endswith(f"/{one}") for path in there)] == []


def defined_in(module: str) -> set[str]:
    """Return the functions of a module, methods as Class.method, and what a package hands on."""
    found = {found.name for found in all_imports_of(module)} if module == STORAGE else set()
    for node in trees()[module].body:
        if isinstance(node, ast.FunctionDef):
            found.add(node.name)
        elif isinstance(node, ast.ClassDef):
            found |= {f"{node.name}.{n.name}" for n in node.body if isinstance(n, ast.FunctionDef)}
    return found


def test_each_place_of_the_walk_exists() -> None:
    places = [place for step in walk() for place in step]
    assert (len(walk()), len(places) > 24) == (12, True)
    assert [place for place in places if place[1] not in defined_in(place[0])] == []


def test_no_room_of_the_walk_comes_twice() -> None:
    """The rooms of `workflow` count by themselves."""
    rooms = [step[0][0].split(".")[: 1 + in_workflow(step[0][0])] for step in walk()]
    changes = [room for room, before in zip(rooms, [[], *rooms], strict=False) if room != before]
    assert [changes.count(room) for room in changes] == [1] * 5


def test_each_step_of_the_walk_is_called_from_one_before() -> None:
    first, *others = [step[0] for step in walk()]
    known = {found.name for found in all_imports_of(first[0])}
    for module, name in others:
        assert name in known, module
        known |= {found.name for found in all_imports_of(module)}


def test_rooms_import_only_what_the_table_allows() -> None:
    wrong = []
    for found in all_imports():
        target = inside(found)
        room = (target or "").partition(".")[0]
        # the version in compwright/__init__.py is everybody's
        if (
            target is None
            or room in ("", found.room)
            or (target == "__init__" and found.name == "__version__")
        ):
            continue
        if room not in MAY_IMPORT[found.room]:
            wrong.append(str(found))
    assert wrong == []


#: The rooms of `workflow` and which of them each may import.
ROOMS_OF_WORKFLOW: dict[str, set[str]] = {
    "inputs": set(),
    "run": {"inputs"},
    "results": {"inputs", "run"},
    "verify": {"inputs", "run", "results"},
    "history": {"results"},
    "redact": set(),
    "commands": {"inputs", "run", "results", "verify", "history", "redact"},
}


def test_rooms_of_workflow_import_only_what_their_table_allows() -> None:
    assert {
        name.split(".")[1] for name in trees() if name.count(".") > 1 and in_workflow(name)
    } == set(ROOMS_OF_WORKFLOW)
    wrong = []
    for found in all_imports():
        target = inside(found) or ""
        if not (in_workflow(found.by) and in_workflow(target)) or target == START:
            continue
        by, to = found.by.split(".")[1], target.split(".")[1]
        if by != to and to not in ROOMS_OF_WORKFLOW[by]:
            wrong.append(str(found))
    assert wrong == []


#: What another process loads first; it stands beside the rooms.
START = "workflow.preloading"


def in_workflow(module: str) -> bool:
    return module.startswith("workflow.")


#: Knows every family, and so no family knows it.
LIST_OF_FAMILIES = "formats.families.shapes"
#: The one family that extends another.
EXTENDS = {"pairs": "grid"}


def floors_of_formats(module: str) -> set[str]:
    """Return what a module of ``formats`` may import there: definition, then text, then what the
    families share, then one family; None of these: all (the list of families, the door, the
    card, the gate).
    """
    if module == LIST_OF_FAMILIES:
        return set()
    part, _, rest = module.removeprefix("formats.").partition(".")
    floors = {"definition": {"definition"}, "text": {"definition", "text"}}
    if part != "families":
        return floors.get(part, set())
    family = rest.partition(".")[0] if family_rooms() & {rest.partition(".")[0]} else ""
    return {"definition", "text", "families", family, EXTENDS.get(family, "")} - {""}


@cache
def family_rooms() -> set[str]:
    found = (name.removeprefix("formats.families.") for name in trees() if "families." in name)
    return {name.partition(".")[0] for name in found if "." in name}


def test_families_of_controls_stand_on_what_they_share_and_not_on_each_other() -> None:
    assert family_rooms() >= {"grid", "pairs", "increments", "columns"}
    wrong = []
    for found in all_imports():
        target, allowed = inside(found) or "", floors_of_formats(found.by)
        if not (found.by.startswith("formats.") and target.startswith("formats.")) or not allowed:
            continue
        part, _, rest = target.removeprefix("formats.").partition(".")
        family = rest.partition(".")[0]
        if part == "families" and family in family_rooms():
            part = family
        if part not in allowed or target == LIST_OF_FAMILIES:
            wrong.append(str(found))
    assert wrong == []


def test_packages_of_others_are_imported_only_where_they_belong() -> None:
    wrong = []
    for found in all_imports():
        package = found.target.partition(".")[0]
        if package == "compwright" or package in sys.stdlib_module_names:
            continue
        if found.room not in OTHERS.get(package, set()):
            wrong.append(str(found))
    assert wrong == []


def test_the_nearest_name_is_found_in_one_place() -> None:
    users = {found.by for found in all_imports() if found.target == "difflib"}
    assert users == {"foundations.key_faults"}


def test_estimation_uses_of_scipy_only_linear_algebra_and_minimisers() -> None:
    targets = {
        found.target if found.target != "scipy" else f"scipy.{found.name}"
        for found in all_imports()
        if found.room == "estimation"
    }
    parts = {
        ".".join(target.split(".")[:2]) for target in targets if target.partition(".")[0] == "scipy"
    }
    assert parts <= {"scipy.linalg", "scipy.optimize"}


def test_modules_by_name_are_imported_only_for_the_extras() -> None:
    users = {
        found.by
        for found in all_imports()
        if found.target.partition(".")[0] in ("importlib", "pkgutil", "runpy")
    }
    assert users <= {"__init__", "foundations.extras"}  # the public names are loaded when used


def test_no_import_cycles() -> None:
    edges: dict[str, set[str]] = {name: set() for name in trees()}
    for found in all_imports():
        target = inside(found)
        if target is not None and target in edges and target != found.by:
            if found.name == "__version__":  # in the package itself, which loads nothing else
                continue
            edges[found.by].add(target)
    # an import of a package's own __init__ by a module inside it is how packages work, not a cycle
    # of meaning
    finished: set[str] = set()

    def visit(name: str, way: tuple[str, ...]) -> None:
        assert name not in way, " -> ".join((*way[way.index(name) :], name))
        if name in finished:
            return
        for target in sorted(edges[name]):
            visit(target, (*way, name))
        finished.add(name)

    for name in edges:
        visit(name, ())


def test_only_storage_reaches_the_file_system() -> None:
    wrong = []
    for name, tree in trees().items():
        if is_storage(name):
            continue
        for node in nodes_below(tree):
            if isinstance(node, ast.Call):
                wrong += [f"{name} line {node.lineno}: {call}" for call in reaching(node.func)]
    for found in all_imports():
        environment = (
            # for the environment and the number of processors alone, see the next lines
            (found.by == "foundations.processors" and found.target == "os")
            # processes that do the same work, which is handed to them and comes back
            or (found.by == "foundations.processes" and found.target == "multiprocessing")
            # a database in memory alone, see the next test
            or (found.by == DATABASE and found.target == "sqlite3")
        )
        if not is_storage(found.by) and not environment and reached(found):
            wrong.append(str(found))
    uses = {
        node.attr
        for node in ast.walk(trees().get("foundations.processors", ast.Module([], [])))
        if is_of_os(node)
    }
    assert uses <= {"environ", "sched_getaffinity", "cpu_count"}
    assert wrong == []


STORAGE = "foundations.storage"


def is_storage(module: str) -> bool:
    return module == STORAGE or module.startswith(f"{STORAGE}.")


DATABASE = "workflow.history.history_index"


def test_the_database_lives_in_memory() -> None:
    """Its bytes are read and written by `storage`, whole or not at all."""
    calls = [
        [ast.unparse(word) for word in node.args]
        for node in ast.walk(trees()[DATABASE])
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "sqlite3.connect"
    ]
    assert calls == [["':memory:'"]]
    assert "attach" not in ast.unparse(trees()[DATABASE]).lower()


def reached(found: Import) -> bool:
    return bool(
        {found.target, found.target.partition(".")[0], f"{found.target}.{found.name}"}
        & REACHING_MODULES
    )


def is_of_os(node: ast.AST) -> TypeGuard[ast.Attribute]:
    return (
        isinstance(node, ast.Attribute)
        and isinstance(node.value, ast.Name)
        and node.value.id == "os"
    )


def reaching(function: ast.expr) -> Iterator[str]:
    if isinstance(function, ast.Name) and function.id in (
        "open",
        "exec",
        "eval",
        "__import__",
        "input",
        "print",
    ):
        yield function.id
    if isinstance(function, ast.Attribute) and function.attr in REACHING_CALLS:
        owner = function.value
        if not (isinstance(owner, ast.Name) and owner.id == "storage"):
            yield ast.unparse(function)


def test_only_workflow_and_controls_call_storage_and_only_by_its_door() -> None:
    calls = [found for found in all_imports() if is_storage(inside(found) or "")]
    outside = [found for found in calls if not is_storage(found.by)]
    assert {found.room for found in outside} <= {"workflow", "controls"}
    assert {inside(found) for found in outside} == {STORAGE}


def test_judge_shares_nothing_with_the_judged() -> None:
    """``controllers`` know bytes and assumptions, not the records that the writing side computes
    with.
    """
    allowed = {"ControlFile", "Assumption"}
    wrong = [
        str(found)
        for found in all_imports()
        if found.room == "controllers"
        and inside(found) == "records.correction"
        and found.name not in allowed
    ]
    assert wrong == []
    for one, other in (("controllers", "formats"), ("formats", "controllers")):
        assert [
            str(f)
            for f in all_imports()
            if f.room == one and (inside(f) or "").partition(".")[0] == other
        ] == []


# ---------------------------------------------------------------- no hidden state

#: What is made to be changed, or to answer differently the next time.
CHANGING = {
    *("dict", "list", "set", "bytearray", "defaultdict", "deque", "OrderedDict", "Counter"),
    *("WeakKeyDictionary", "WeakValueDictionary", "WeakSet", "SimpleNamespace", "count", "cycle"),
    *("iter", "local", "ContextVar", "Lock", "RLock", "Condition", "Event", "Semaphore"),
    *("default_rng", "Generator", "Random", "RandomState", "StringIO", "BytesIO", "Session"),
}
CHANGES = {
    *("append", "add", "update", "clear", "pop", "popitem", "popleft", "setdefault", "extend"),
    *("appendleft", "insert", "remove", "discard", "sort", "reverse", "subtract", "set", "reset"),
    *("intersection_update", "difference_update", "symmetric_difference_update", "send", "write"),
}
#: What Python or a library keeps once for a process -> the modules that may change it.
OF_THE_PROCESS: dict[str, set[str]] = {
    # the command line owns the process: its streams, and nobody else does
    "reconfigure": {"cli.shell"},
    "sys.stdout": {"cli.shell", "cli.saying"},
    "sys.stderr": {"cli.saying"},
    # set before numpy is loaded, in each process that is ours
    "environ": {"foundations.processors"},
    "set_threshold": {"foundations.processors"},
    "mallopt": {"foundations.processors"},
    "signal": {"foundations.processes"},
    "raise_signal": {"foundations.processes"},
    "pthread_sigmask": {"foundations.processes"},
    # one thread at a time, see SHARED
    "catch_warnings": {"foundations.one_thread"},
    "filterwarnings": {"foundations.one_thread"},
    "rc_context": {"reporting.panels"},
}
#: The same, which no module may change.
OF_THE_PROCESS_ALONE = {
    *("chdir", "fchdir", "umask", "putenv", "unsetenv", "nice", "setlocale", "tzset"),
    *("simplefilter", "resetwarnings", "showwarning", "seterr", "seterrcall", "setbufsize"),
    *("set_printoptions", "set_state", "getcontext", "setcontext", "basicConfig"),
    *("setrecursionlimit", "setswitchinterval", "settrace", "setprofile", "excepthook"),
    *("rcParams", "rcdefaults", "set_start_method", "set_int_max_str_digits", "addaudithook"),
}
#: What makes random numbers that belong to whoever makes it.
OWN_NUMBERS = {"default_rng", "Generator", "SeedSequence"}
#: Names of modules that hold what changes, with the reason.
SHARED = {
    "foundations.one_thread._TURN": "lets one thread at a time change what a process has once",
}
#: Caches without arguments, with the reason.
KEPT_ONCE = {
    "documents.record_reading._validator": "what a record has to be, made from its classes",
}


def module_level(body: list[ast.stmt]) -> Iterator[tuple[str, ast.expr, int]]:
    """Yield name, value and line of what a module, or a class in it, binds when it is loaded."""
    for node in body:
        if isinstance(node, ast.Assign | ast.AnnAssign) and node.value is not None:
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            for name in (one for target in targets for one in getattr(target, "elts", [target])):
                if isinstance(name, ast.Name):
                    yield name.id, node.value, node.lineno
        elif isinstance(node, ast.ClassDef | ast.If | ast.Try | ast.With):
            yield from module_level(node.body)


def last_name(node: ast.expr) -> str:
    return node.attr if isinstance(node, ast.Attribute) else getattr(node, "id", "")


def is_empty(value: ast.expr) -> bool:
    return ast.unparse(value) in ("{}", "[]")


def is_changing(value: ast.expr) -> bool:
    """Whether a value at module level can only be there to be changed: an empty container, or an
    object that keeps something.
    """
    if is_empty(value):
        return True
    called = value.func if isinstance(value, ast.Call) else None
    called = called.value if isinstance(called, ast.Subscript) else called
    return called is not None and last_name(called) in CHANGING


def test_no_module_or_class_holds_what_is_there_to_be_changed() -> None:
    """What is empty in a schema of pydantic is copied for each record."""
    schemas = {found.by for found in all_imports() if found.target == "pydantic"}
    found = {
        f"{module}.{name}"
        for module, tree in trees().items()
        for name, value, _ in module_level(tree.body)
        if is_changing(value) and not (module in schemas and is_empty(value))
    }
    assert found == set(SHARED)


def owner_of(node: ast.expr) -> ast.expr:
    """Return what an attribute or an item is of, at last."""
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return node


def changed_in(function: ast.AST) -> Iterator[tuple[str, ast.expr]]:
    """Yield what a function changes: name of the change, and what it is done to."""
    for node in nodes_below(function):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr in CHANGES:
                yield node.func.attr, node.func.value
        elif isinstance(node, ast.Assign | ast.Delete | ast.AugAssign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign | ast.Delete) else [node.target]
            for target in targets:
                if isinstance(target, ast.Attribute | ast.Subscript):
                    yield "=", target


def local_names(function: ast.AST) -> set[str]:
    """Return the names that a function, and those in it, bind themselves."""
    return {
        name
        for node in nodes_below(function)
        for name in (
            [node.arg]
            if isinstance(node, ast.arg)
            else [node.id]
            if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load)
            else [node.name]
            if isinstance(node, ast.FunctionDef | ast.ExceptHandler) and node.name
            else []
        )
    }


def test_no_function_changes_a_module_a_class_or_what_they_hold() -> None:
    """A `global` is an assignment to a module; a name that a module imports may be a module."""
    wrong = []
    for module, tree in trees().items():
        own = {name for name, _, _ in module_level(tree.body)}
        classes = {node.name for node in nodes_below(tree) if isinstance(node, ast.ClassDef)}
        imported = {found.name or found.target for found in all_imports_of(module)} | {"np"}
        modules = {found.target for found in all_imports_of(module) if not found.name} | {"np"}
        modules |= {
            found.name
            for found in all_imports_of(module)
            if (inside(found) or "").endswith(f".{found.name}")
        }
        for function in outer_functions(tree):
            wrong += [
                f"{module} line {node.lineno}: {', '.join(node.names)}"
                for node in nodes_below(function)
                if isinstance(node, ast.Global)
            ]
            known = ((own | imported) - local_names(function)) | classes | {"cls"}
            for how, what in changed_in(function):
                owner = owner_of(what)
                name = owner.id if isinstance(owner, ast.Name) else ""
                if how != "=" and what is owner and name in modules:
                    continue  # `np.sort(...)`, `disk.remove(...)`
                place = ast.unparse(what)
                if name in known and not {module} & allowed(place):
                    wrong.append(f"{module} line {what.lineno}: {how} {place}")
    assert wrong == []


def allowed(place: str) -> set[str]:
    """Return the modules that may change ``place``, such as `sys.stdout` or `os.environ`."""
    return OF_THE_PROCESS.get(place, OF_THE_PROCESS.get(place.rpartition(".")[2], set()))


def outer_functions(tree: ast.Module) -> Iterator[ast.AST]:
    """Yield the functions of a module and of its classes, those inside others with them."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.FunctionDef):
            yield node
        elif isinstance(node, ast.ClassDef):
            yield from outer_functions(ast.Module(node.body, []))


def takes_a_session() -> set[tuple[str, str]]:
    """Return the functions of modules, by module and name, whose first argument is the session."""
    return {
        (module, node.name)
        for module, tree in trees().items()
        for node in tree.body
        if isinstance(node, ast.FunctionDef)
        and [one.arg for one in (*node.args.posonlyargs, *node.args.args)][:1] == ["session"]
    }


def test_whoever_reads_or_writes_hands_its_session_on() -> None:
    """Also where a function is handed on by `partial`."""
    functions, wrong = takes_a_session(), []
    door = {name for module, name in functions if is_storage(module)}
    for module, tree in trees().items():
        known = {name for where, name in functions if where == module}
        known |= {
            found.name
            for found in all_imports_of(module)
            if ((inside(found) or ""), found.name) in functions
        }
        for node in nodes_below(tree):
            if not isinstance(node, ast.Call):
                continue
            words = node.args
            is_partial = last_name(node.func) == "partial" and bool(words)
            function, words = (words[0], words[1:]) if is_partial else (node.func, words)
            named = isinstance(function, ast.Name) and function.id in known
            by_door = (
                isinstance(function, ast.Attribute)
                and last_name(function.value) == "storage"
                and function.attr in door
            )
            if (named or by_door) and not (words and last_name(words[0]).endswith("session")):
                wrong.append(f"{module} line {node.lineno}: {ast.unparse(function)}")
    assert len(functions) > 100
    assert wrong == []


def test_what_a_process_has_once_is_changed_only_where_it_may_be() -> None:
    found: dict[str, set[str]] = {}
    for module, tree in trees().items():
        for node in nodes_below(tree):
            if isinstance(node, ast.Attribute):
                written = not isinstance(node.ctx, ast.Load)
                name = ast.unparse(node) if written else node.attr
                is_random = isinstance(node.value, ast.Attribute) and node.value.attr == "random"
                assert not is_random or node.attr in OWN_NUMBERS, f"{module} line {node.lineno}"
                if name in {*OF_THE_PROCESS, *OF_THE_PROCESS_ALONE}:
                    found.setdefault(name, set()).add(module)
    assert found == OF_THE_PROCESS
    imported = {found.target for found in all_imports()}
    assert not imported & {"contextvars", "random", "logging", "locale", "atexit", "tempfile"}
    names = {found.name for found in all_imports()}
    assert not names & {"local", "ContextVar", *OF_THE_PROCESS, *OF_THE_PROCESS_ALONE}


def test_what_is_kept_depends_on_its_arguments_alone() -> None:
    """A cache of contents is no state; one of paths, or of a session, would be."""
    unexplained, wrong = [], []
    for module, tree in trees().items():
        for function in nodes_below(tree):
            if not isinstance(function, ast.FunctionDef):
                continue
            kinds = {
                last_name(one.func if isinstance(one, ast.Call) else one)
                for one in function.decorator_list
            }
            arguments = [*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs]
            if not kinds & {"cache", "lru_cache"}:
                continue
            if not arguments:
                unexplained.append(f"{module}.{function.name}")
            wrong += [
                f"{module}.{function.name}: {one.arg}"
                for one in arguments
                if one.annotation is None
                or re.search(r"\b(Path|Session|self|Callable)\b", ast.unparse(one.annotation))
            ]
    assert wrong == []
    assert sorted(unexplained) == list(KEPT_ONCE)


def test_starting_loads_nothing_slow_by_the_source() -> None:
    """Follow the imports that happen when ``compwright.cli`` is loaded."""
    if "cli" not in trees():
        pytest.skip("there is no command line yet")
    by_module: dict[str, list[Import]] = {name: [] for name in trees()}
    for found in all_imports():
        if found.at_load:
            by_module[found.by].append(found)
    waiting, loaded, slow = ["cli"], set[str](), []
    while waiting:
        name = waiting.pop()
        if name in loaded or name not in by_module:
            continue
        loaded.add(name)
        waiting += [
            ".".join(name.split(".")[:count]) for count in range(1, name.count(".") + 1)
        ]  # packages above
        for found in by_module[name]:
            target = inside(found)
            if target is not None:
                waiting.append(target)
            elif found.target.partition(".")[0] in SLOW_TO_IMPORT:
                slow.append(str(found))
    assert slow == []


def loaded_by(*arguments: str) -> set[str]:
    """Return the top-level packages that a fresh interpreter has loaded after running compwright
    with ``arguments``.
    """
    command = [sys.executable, "-X", "importtime", "-m", "compwright", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=600)
    assert done.returncode in (0, 1), done.stderr[-2000:]
    names = re.findall(r"^import time:[^|]*\|[^|]*\| +(\S+)$", done.stderr, re.MULTILINE)
    assert "compwright" in {name.partition(".")[0] for name in names}
    return {name.partition(".")[0] for name in names}


CSV = """# axis: X
target_mm,direction,run,deviation_um
0,+,1,0.0
0,-,1,-1.0
0,+,2,0.5
0,-,2,-1.5
100,+,1,2.0
100,-,1,1.0
100,+,2,2.5
100,-,2,0.5
"""


def test_help_and_version_load_nothing_slow() -> None:
    if "cli" not in trees():
        pytest.skip("there is no command line yet")
    assert loaded_by("--help") & SLOW_TO_IMPORT == set()
    assert loaded_by("--version") & SLOW_TO_IMPORT == set()


def test_evaluating_loads_no_solver_no_schema_and_no_plotting(tmp_path: Path) -> None:
    if "cli" not in trees():
        pytest.skip("there is no command line yet")
    file = tmp_path / "x.csv"
    file.write_text(CSV, encoding="utf-8")
    loaded = loaded_by("evaluate", str(file), "--json", str(tmp_path / "x.json"))
    assert "numpy" in loaded  # it was evaluated at all
    assert loaded & (SLOW_TO_IMPORT - {"numpy", "rich"}) == set()


CODE = re.compile(r"CW-[A-Z]+\d+")
FAMILIES = {
    "R": {"instruments"},
    "T": {"evaluation"},
    "C": {"evaluation"},
    "J": {"jobs"},
    "S": {"workflow", "controls", "formats", "controllers"},
    "D": {"estimation"},
    "E": {"estimation"},
    "F": {"fitting"},
    "X": {"formats", "controllers", "controls", "workflow"},
    "P": {"planning", "prediction", "controls", "workflow"},
    "V": {"verification", "workflow"},
}


@cache
def codes() -> dict[str, set[str]]:
    """Return each finding code that stands alone in a text of the source -> modules in which it
    stands.
    """
    found: dict[str, set[str]] = {}
    for name, tree in trees().items():
        for node in nodes_below(tree):
            if (
                isinstance(node, ast.Constant)
                and isinstance(node.value, str)
                and CODE.fullmatch(node.value.partition(".")[0])
                and not name.startswith("words.")
            ):
                found.setdefault(node.value.partition(".")[0], set()).add(name)
    return found


@cache
def made() -> dict[str, set[str]]:
    """Return each sentence of a finding -> modules that make a finding with it (others only look
    for its code).
    """
    found: dict[str, set[str]] = {}
    for name, tree in trees().items():
        for node in nodes_below(tree):
            if not isinstance(node, ast.Call) or last_name(node.func) not in (
                *("Finding", "of", "find"),
            ):
                continue
            word = getattr(node.args[0], "value", None) if node.args else None
            if isinstance(word, str) and CODE.fullmatch(word.partition(".")[0]):
                found.setdefault(word, set()).add(name)  # str.find is no finding
    return found


def listed() -> Counter[str]:
    """Return how often each code heads a row of ``docs/findings.md``."""
    page = (PROJECT / "docs" / "findings.md").read_text(encoding="utf-8")
    return Counter(re.findall(rf"^\| `({CODE.pattern})` \|", page, re.MULTILINE))


def test_each_finding_is_made_in_one_place() -> None:
    assert {name: modules for name, modules in made().items() if len(modules) > 1} == {}


def test_finding_codes_belong_to_the_room_that_makes_them() -> None:
    for name, modules in made().items():
        rooms = {module.partition(".")[0] for module in modules}
        assert rooms <= FAMILIES[name[3]], f"{name} in {rooms}"


def test_every_finding_code_is_explained_once() -> None:
    assert {code: count for code, count in listed().items() if count != 1} == {}
    assert set(codes()) - set(listed()) == set(), "not in docs/findings.md"
    assert set(listed()) - set(codes()) == set(), "in docs/findings.md, but not in the source"
