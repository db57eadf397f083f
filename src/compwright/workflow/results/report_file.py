"""The report of a command, written to the file of the option ``--report``."""

from __future__ import annotations

from pathlib import Path

from compwright.foundations.errors import Fault, UsageError
from compwright.foundations.utf8 import shown_path


def require_report_form(path: Path | None, *forms: str) -> None:
    """Raise UsageError for a report name with a wrong ending, or for a PDF without the pdf
    extra.
    """
    if path is None:
        return
    if path.suffix.lower() not in forms:
        raise UsageError(
            Fault(
                message="the name of the report has an unknown ending",
                file=shown_path(path),
                place="--report",
                expected=f"a name that ends in {' or '.join(forms)}",
                found=path.suffix or path.name,
                hint=f"give `--report {shown_path(path.with_suffix(forms[0]))}`",
            )
        )
    if path.suffix.lower() == ".pdf":
        from compwright.reporting.pdf import require_pdf

        require_pdf()


def as_named(page: bytes, path: Path) -> bytes:
    """Return a report as PDF if the file name ends in ``.pdf``, else as HTML."""
    if path.suffix.lower() != ".pdf":
        return page
    from compwright.reporting.pdf import pdf_of_page

    return pdf_of_page(page)


def answer_files(
    document: bytes,
    json_path: Path | None,
    page: bytes | None,
    report: Path | None,
    card: bytes | None = None,
) -> dict[Path, bytes]:
    """Return the contents of the files of ``--json`` and ``--report`` by path. Raises UsageError if
    both have the same name.

    ``page``: the report as HTML; None if it could not be made. ``card``: the commissioning card,
    which is written next to the report: ``out-card.pdf`` for the report ``out.pdf``.
    """
    files: dict[Path, bytes] = {} if json_path is None else {json_path: document}
    if report is None or page is None:
        return files
    pages = {report: page}
    if card is not None:
        pages[report.with_stem(f"{report.stem}-card")] = card
    if json_path in pages:
        raise UsageError(
            Fault(
                message="this file name is already used for --json",
                file=shown_path(report),
                place="--report",
                expected="another file",
                hint="give two different files",
            )
        )
    return {**files, **{path: as_named(one, path) for path, one in pages.items()}}
