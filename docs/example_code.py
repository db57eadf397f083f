"""Write the Python of the notebook and of the library's page as scripts, for mypy (`make lint`).

python docs/example_code.py FOLDER
"""

from __future__ import annotations

import doctest
import json
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]


def main() -> None:
    """Write `notebook.py` and `page.py` into a folder."""
    folder = Path(sys.argv[1])
    notebook = PROJECT / "examples" / "linuxcnc-two-axes" / "from_python.ipynb"
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    page = (PROJECT / "docs" / "tutorials" / "library.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", page, re.DOTALL | re.MULTILINE)
    parser = doctest.DocTestParser()
    typed = [one.source for block in blocks for one in parser.get_examples(block)]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "notebook.py").write_text("\n".join(code) + "\n", encoding="utf-8")
    (folder / "page.py").write_text("".join(typed), encoding="utf-8")


if __name__ == "__main__":
    main()
