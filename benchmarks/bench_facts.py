"""Every fact of the SINUMERIK definition removed or turned: some check of the tests must notice.

python benchmarks/bench_facts.py

The tests turn one fact in six (tests/formats/test_siemens_facts.py). Prints the facts that nothing
notices; exit 1 where there is one.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "formats"))

from test_siemens_facts import silent_facts, turned_facts


def main() -> int:
    silent = silent_facts(0, 1)
    for name in silent:
        print(name)
    print(f"{len(turned_facts())} facts turned, {len(silent)} unnoticed")
    return int(bool(silent))


if __name__ == "__main__":
    sys.exit(main())
