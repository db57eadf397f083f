"""The only code that accesses the file system. It writes files completely or not at all.

The files that a command writes replace the old ones all together (`transaction`). If this fails,
the old files are restored. If the process itself was stopped, the next command that reads or writes
there restores them (`recovery`).

A file that a command has read is never overwritten or deleted by it, under whatever name. The
`Session` records these files; every function that reads, writes or restores files takes it.
"""

from compwright.foundations.storage.file_status import (
    is_folder,
    named_from,
    relative,
    resolved,
    size_of,
    way_to,
)
from compwright.foundations.storage.hindrances import refuse_overwriting
from compwright.foundations.storage.listing import (
    folders_holding,
    folders_in,
    in_folders_of,
    is_there,
    list_files,
    matching,
)
from compwright.foundations.storage.package_data import (
    definition_files,
    demo_files,
    reference_files,
)
from compwright.foundations.storage.reading import (
    bytes_as_they_are,
    earlier_bytes,
    read_bytes,
    state_of,
    was_read,
)
from compwright.foundations.storage.writing import Known, write_file, write_files

__all__ = [
    "Known",
    "bytes_as_they_are",
    "definition_files",
    "demo_files",
    "earlier_bytes",
    "folders_holding",
    "folders_in",
    "in_folders_of",
    "is_folder",
    "is_there",
    "list_files",
    "matching",
    "named_from",
    "read_bytes",
    "reference_files",
    "refuse_overwriting",
    "relative",
    "resolved",
    "size_of",
    "state_of",
    "was_read",
    "way_to",
    "write_file",
    "write_files",
]
