"""Copies of all input files in a result folder, so that the folder is complete."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from compwright.controls.control_files import control_entries
from compwright.foundations import storage
from compwright.foundations.provenance import fingerprint
from compwright.foundations.session import Session
from compwright.foundations.utf8 import shown_path
from compwright.records.input_record import InputRole, RecordedInput
from compwright.records.job import Job
from compwright.records.plan import Texts
from compwright.workflow.inputs.measurement_files import measurement_files

INPUTS = "inputs"
#: Copies of what ``verify`` was given, and of files that lie outside the folder of the job.
BY_VERIFY, ELSEWHERE = "verify", "elsewhere"


@dataclass(frozen=True, slots=True, kw_only=True)
class GivenFile:
    """An input file of a command. ``of``: the test, circle or state that uses the file."""

    role: InputRole
    of: str
    name: str
    path: Path | None
    content: bytes


def files_of_job(session: Session, job: Job, folder: Path, definition: Texts) -> list[GivenFile]:
    """Return every input file of a job, the job file first. Raises InputError for an unreadable
    file.

    ``definition``: the texts of the user's own control definition, by file.
    """
    found = (
        [] if not job.file else [_given(session, "job", "", Path(job.file).name, Path(job.file))]
    )
    found += [_text_of_definition(session, Path(name), content) for name, content in definition]
    for name, entry in job.axes.items():
        for request in entry.before:
            of = f"{name} {request.name}"
            found += _measured(session, "test", of, request.files, folder)
            if request.profile:
                found.append(
                    _given(
                        session,
                        "profile",
                        of,
                        request.profile,
                        storage.named_from(folder, request.profile),
                    )
                )
    for circle in job.circles:
        found += _measured(session, "circle", circle.name, circle.files, folder)
    for drift in job.drifts.values():
        found.append(
            _given(session, "drift", "", drift.file, storage.named_from(folder, drift.file))
        )
    for text in job.environment.files if job.environment is not None else ():
        found.append(_given(session, "environment", "", text, storage.named_from(folder, text)))
    if job.report.logo is not None:
        found.append(
            _given(
                session, "logo", "", job.report.logo, storage.named_from(folder, job.report.logo)
            )
        )
    for state, texts in job.states.items():
        found += [
            file for text in texts for file in files_at(session, "state", state, text, folder)
        ]
    return found


def _text_of_definition(session: Session, path: Path, content: bytes) -> GivenFile:
    """Return a control definition as an input file. If its text is from a plan and no file has the
    same contents, the result has no path.
    """
    there = storage.is_there(session, path) and storage.read_bytes(session, path) == content
    return GivenFile(
        role="definition", of="", name=path.name, path=path if there else None, content=content
    )


def given_job(name: str, path: Path, content: bytes) -> GivenFile:
    """Return the job file as an input that may be copied into the result folder."""
    return GivenFile(role="job", of="", name=name, path=path, content=content)


def _measured(
    session: Session, role: InputRole, of: str, texts: Iterable[str], folder: Path
) -> Iterator[GivenFile]:
    for text in texts:
        start = storage.named_from(folder, text)
        for path in measurement_files(session, start).files:
            yield _given(session, role, of, _named(text, path, start), path)


def files_of_verify(
    session: Session,
    job: Job,
    after: Sequence[str],
    circles: Mapping[str, Sequence[Path]],
    loaded: Sequence[Path],
    profile: Path | None = None,
) -> list[GivenFile]:
    """Return every input file of ``verify``. Raises InputError for an unreadable file.

    ``after``: the positioning tests after loading, as ``FILE`` or ``TEST=FILE``. ``circles``: the
    files of each circular test, by its name. ``loaded``: the files read back from the control.
    ``profile``: the mapping profile of the positioning tests.
    """
    names = {request.name for entry in job.axes.values() for request in entry.before}
    found: list[GivenFile] = []
    for spec in after:
        head, mark, tail = spec.partition("=")
        named = bool(mark) and head in names
        found += _measured(
            session, "after", head if named else "", [tail if named else spec], Path()
        )
    for name, paths in circles.items():
        found += _measured(session, "after", name, [str(path) for path in paths], Path())
    for path in loaded:
        found += files_at(session, "loaded", "", str(path), Path())
    if profile is not None:
        found.append(_given(session, "profile", "", str(profile), profile))
    return found


def files_at(
    session: Session, role: InputRole, of: str, text: str, folder: Path
) -> Iterator[GivenFile]:
    """Yield the file with the path ``text`` (relative to ``folder``); if the path is that of a
    folder, every file in that folder. ``role``: the kind of input; ``of``: the test, circle or
    state that uses the files.
    """
    start = storage.named_from(folder, text)
    for path in control_entries(session, start):
        yield _given(session, role, of, _named(text, path, start), path)


def _named(text: str, path: Path, start: Path) -> str:
    """Return the name that the file ``path`` has in the job. ``text``: the path as the job states
    it, of the file itself or of its folder; ``start``: the file or folder to which ``text`` leads.
    """
    name = Path(text).as_posix()
    return name if path == start else f"{name}/{path.relative_to(start).as_posix()}"


def _given(session: Session, role: InputRole, of: str, name: str, path: Path) -> GivenFile:
    return GivenFile(
        role=role,
        of=of,
        name=shown_path(Path(name)),
        path=path,
        content=storage.read_bytes(session, path),
    )


def kept(
    given: Iterable[GivenFile],
    out: Path,
    *,
    by: str,
    there: Mapping[str, bytes],
    written: Collection[str],
) -> tuple[tuple[RecordedInput, ...], dict[str, bytes]]:
    """Return the input files of the command ``by``, each with its place in the result folder
    ``out``, and the copies to be written there. A file is not copied if the same contents are in
    the folder already.

    ``there``: the files of the result folder that the run itself writes (relative name -> bytes),
    such as the old contents of the control. ``written``: the names of files that this command
    writes. An input that is already in ``out`` and is not one of ``written`` stays where it is,
    such as the inputs of a next round. In all these cases the result names the existing file.
    """
    places = {fingerprint(content): name for name, content in there.items()}
    copies: dict[str, bytes] = {}
    recorded = []
    for file in given:
        digest = fingerprint(file.content)
        place = _inside(file.path, out, written) or places.get(digest)
        if place is None:
            place = _unused(_place(file.name, by), copies)
            copies[place] = file.content
        places[digest] = place
        recorded.append(
            RecordedInput(
                role=file.role,
                of=file.of,
                file=file.name,
                sha256=digest,
                size=len(file.content),
                copy=place,
                by=by,
            )
        )
    return tuple(dict.fromkeys(recorded)), copies


def _inside(path: Path | None, out: Path, written: Collection[str]) -> str | None:
    """Return the path of an input file relative to the result folder if the file is already there
    and will not be replaced, else None.
    """
    if path is None:
        return None
    whole, root = storage.resolved(path), storage.resolved(out)
    if root not in whole.parents:
        return None
    name = shown_path(Path(storage.relative(whole, root)))
    return None if name in written else name


def _place(name: str, by: str) -> str:
    """Return the place in the result folder to which a file is copied, chosen so that the copied
    job finds the copied file. ``by``: the command that was given the file (run, verify).
    """
    parts = PurePosixPath(name).parts
    if by == BY_VERIFY:
        return f"{INPUTS}/{BY_VERIFY}/{parts[-1]}"
    own = not Path(name).is_absolute() and ".." not in parts and "\\" not in name
    if own and parts[0] not in (BY_VERIFY, ELSEWHERE):
        return "/".join((INPUTS, *parts))
    return f"{INPUTS}/{ELSEWHERE}/{Path(name).name}"


def _unused(name: str, taken: Mapping[str, bytes]) -> str:
    """Return ``name``, or ``name`` with a number added if it is already taken (even in upper or
    lower case).
    """
    names = {other.casefold() for other in taken}
    path, number, chosen = PurePosixPath(name), 1, name
    while chosen.casefold() in names:
        number += 1
        chosen = str(path.with_name(f"{path.stem}-{number}{path.suffix}"))
    return chosen
