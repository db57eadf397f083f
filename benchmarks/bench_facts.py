"""Every fact of the SINUMERIK and FANUC definitions removed or turned: some check of the tests must
notice.

python benchmarks/bench_facts.py

The tests turn one fact in eighteen (tests/formats/test_siemens_facts.py) or twelve
(test_fanuc_facts.py).
Prints the facts that nothing notices; exit 1 where there is one.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "formats"))

import test_fanuc_facts as fanuc
import test_siemens_facts as siemens


def main() -> int:
    silent = siemens.silent_facts(0, 1)
    count = len(siemens.turned_facts())
    for format_id in fanuc.BESIDE:
        silent += [f"{format_id}: {name}" for name in fanuc.silent_facts(format_id, 0, 1)]
        count += len(fanuc.turned_facts(format_id))
    for name in silent:
        print(name)
    print(f"{count} facts turned, {len(silent)} unnoticed")
    return int(bool(silent))


if __name__ == "__main__":
    sys.exit(main())
