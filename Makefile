# Two commands on a fresh machine with Python 3.11 or newer: make demo, make test.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
# Small matrices: threads of the linear algebra only get in each other's way.
export OPENBLAS_NUM_THREADS ?= 1

.PHONY: demo test lint real-linuxcnc bench clean

$(VENV)/.report: pyproject.toml
	$(PYTHON) -c 'import sys; sys.exit("Python 3.11 or newer is needed, this is " + sys.version.split()[0] if sys.version_info < (3, 11) else 0)'
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --editable '.[report]'
	touch $@

$(VENV)/.test: pyproject.toml $(VENV)/.report
	$(BIN)/python -m pip install --quiet --editable '.[test]'
	touch $@

demo: $(VENV)/.report  ## the whole loop on a virtual machine, into demo/
	$(BIN)/compwright demo --out demo --force

test: $(VENV)/.test  ## all tests; the last line says what was skipped and why
	$(BIN)/python -m pytest -n auto --dist worksteal -p no:cacheprovider

lint: $(VENV)/.test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

real-linuxcnc: $(VENV)/.test  ## only the tests on the real controller
	$(BIN)/python -m pytest -m real_linuxcnc -rs

bench: $(VENV)/.test
	for file in benchmarks/bench_*.py; do $(BIN)/python $$file || exit 1; done

clean:
	rm -rf $(VENV) demo build dist
