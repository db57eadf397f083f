"""A whole recalibration of a virtual machine, each command as one types it.

See docs/tutorials/linuxcnc.md.

Run it in a copy of this folder: python recalibrate.py
"""

from __future__ import annotations

import shutil
import subprocess
import sys

COMMANDS = """
compwright simulate machine.yaml --out before --seed 1
compwright evaluate before/x.csv
compwright run job.yaml
cp -r job/tables/linuxcnc control
compwright compare job --loaded control
compwright simulate closer.yaml --out after --seed 2 --with-tables control
compwright verify job.yaml --after after/x.csv --loaded control --update
cp -r job/next/tables/linuxcnc control2
compwright compare job/next --loaded control2
compwright simulate closer.yaml --out after2 --seed 3 --with-tables control2
compwright verify job/next/job.yaml --after after2/x.csv --loaded control2 --update
compwright history job --plot history.svg
"""


def main() -> None:
    """Do every command; a verdict that is not good (exit 1) is an answer, anything above an end."""
    for line in COMMANDS.split("\n"):
        words = line.split()
        if not words:
            continue
        print(f"$ {line}", flush=True)
        if words[0] == "cp":  # loading: the virtual control reads what lies in this folder
            shutil.copytree(words[2], words[3])
            continue
        code = subprocess.run([sys.executable, "-m", *words], check=False).returncode
        if code > 1:
            sys.exit(code)


if __name__ == "__main__":
    main()
