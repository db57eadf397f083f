"""Ctrl-C while other processes start: one word of the first process, no traceback of the others."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from time import sleep

import pytest

PROGRAM = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # also where a shell had it ignored
from time import sleep
from compwright.foundations.processes import side_by_side
def ready(): pass
if __name__ == "__main__":
    try:
        with side_by_side(4, ready):
            print("started", flush=True)
            sleep(20)
    except KeyboardInterrupt:
        print("stopped", flush=True)
"""


@pytest.mark.skipif(os.name == "nt", reason="a group of processes is told otherwise there")
@pytest.mark.parametrize("wait", [0.03, 0.05, 0.08])  # s: in the midst of their imports
def test_processes_that_are_starting_end_without_a_word(tmp_path: Path, wait: float) -> None:
    file = tmp_path / "program.py"
    file.write_text(PROGRAM)
    with subprocess.Popen(
        [sys.executable, str(file)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
        text=True,
    ) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == "started\n"
        sleep(wait)
        os.killpg(running.pid, signal.SIGINT)
        assert running.communicate(timeout=30)[0] == "stopped\n"
