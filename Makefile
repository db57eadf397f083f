# Two commands on a fresh machine with Python 3.11 or newer: make demo, make test.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
# Small matrices: threads of the linear algebra only get in each other's way.
export OPENBLAS_NUM_THREADS ?= 1
# Compiled modules are kept: each command and each test process starts a second sooner.
export PYTHONDONTWRITEBYTECODE :=

# Onto a stick: make wheelhouse FOR=windows PY=3.12 (also linux, macos), into wheelhouse/.
FOR ?= windows
PY ?= 3.12
EXTRAS ?= all
TAGS_windows := win_amd64
TAGS_macos := $(foreach v,11 12 13 14,macosx_$(v)_0_arm64)
TAGS_linux := manylinux2014_x86_64 $(foreach v,17 24 27 28,manylinux_2_$(v)_x86_64)
WHEELS = --only-binary=:all: --python-version $(PY) $(addprefix --platform ,$(TAGS_$(FOR)))
STICK = compwright$(if $(EXTRAS),[$(EXTRAS)])

.PHONY: demo test site pages quality lint real-linuxcnc bench wheelhouse stick stick-windows stick-macos stick-linux picture clean

$(VENV)/.report: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit("Python 3.11 or newer is needed, this is " + sys.version.split()[0] if sys.version_info < (3, 11) else 0)'
	@echo 'Installing into $(VENV): about a minute.'
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@$(BIN)/python -m pip install --quiet --editable '.[report]'
	@touch $@

$(VENV)/.test: pyproject.toml $(VENV)/.report
	$(BIN)/python -m pip install --quiet --editable '.[test]'
	touch $@

demo: $(VENV)/.report  ## the whole loop on a virtual machine, into demo/
	@echo 'The whole loop on a virtual machine: about 20 seconds.'
	@$(BIN)/compwright demo --out demo --force
	@echo 'To type compwright in this shell: source $(VENV)/bin/activate'

test: $(VENV)/.test  ## all tests, or with ROOM=fitting those of a room; the last line says what was skipped and why
	@echo $(if $(ROOM),'The tests of $(ROOM).','All tests: about 20 minutes on two cores. One room alone: make test ROOM=fitting.')
	$(BIN)/python -m pytest -n auto --dist worksteal -p no:cacheprovider $(if $(ROOM),tests/$(ROOM))

lint: $(VENV)/.test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/python docs/example_code.py $(VENV)/examples
	$(BIN)/mypy $(VENV)/examples/notebook.py $(VENV)/examples/page.py examples

$(VENV)/.site: pyproject.toml $(VENV)/.report
	$(BIN)/python -m pip install --quiet --editable '.[site]'
	touch $@

site: $(VENV)/.site  ## the documentation as a folder of pages with search, into site/
	$(BIN)/python -m sphinx --quiet --write-all --fail-on-warning --keep-going -b html docs site
	@echo 'Open site/index.html'

pages: $(VENV)/.report  ## the pages of docs/ that are made from the code and the definitions, anew
	$(BIN)/python docs/generate.py docs

quality: $(VENV)/.report  ## docs/quality.md and its figures; with TABLES= and FAULTS= from results that the benchmarks have saved
	$(BIN)/python docs/quality_page.py $(if $(TABLES),--tables $(TABLES)) $(if $(FAULTS),--faults $(FAULTS))

real-linuxcnc: $(VENV)/.test  ## only the tests on the real controller
	$(BIN)/python -m pytest -m real_linuxcnc -rs

bench: $(VENV)/.test
	for file in benchmarks/bench_*.py; do $(BIN)/python $$file || exit 1; done

wheelhouse: $(VENV)/.report  ## compwright and all it needs, to be installed without a network
	$(if $(TAGS_$(FOR)),,$(error FOR=$(FOR) is unknown: use windows, macos or linux))
	$(if $(filter 3.11 3.12 3.13 3.14,$(PY)),,$(error PY=$(PY) does not work: use 3.11 to 3.14))
	rm -rf wheelhouse/$(FOR)
	$(BIN)/python -m pip wheel --quiet --no-deps --wheel-dir wheelhouse/$(FOR) .
	$(BIN)/python -m pip download --quiet --dest wheelhouse/$(FOR) $(WHEELS) --find-links wheelhouse/$(FOR) '$(STICK)'
	@du -sh wheelhouse/$(FOR)
	@echo 'There: python -m pip install --no-index --find-links wheelhouse/$(FOR) "$(STICK)"'

stick: stick-windows stick-macos stick-linux  ## every platform has its wheels; the demo runs from those for Linux, without a network

stick-windows stick-macos: stick-%: $(VENV)/.report
	$(BIN)/python -m pip install --quiet --dry-run --target build/$* $(WHEELS) '.[all]'
stick-windows: FOR = windows
stick-macos: FOR = macos

stick-linux: FOR = linux
stick-linux: PY = $(shell $(BIN)/python -c 'import sys; print("%d.%d" % sys.version_info[:2])')
stick-linux: CUT = $(shell unshare --map-root-user --net true 2>/dev/null && echo unshare --map-root-user --net)
stick-linux: wheelhouse
	rm -rf build/stick
	$(BIN)/python -m venv build/stick
	@echo $(if $(CUT),'The network is cut from here.','The network cannot be cut here: only --no-index holds.')
	$(CUT) sh -c 'build/stick/bin/python -m pip --isolated install --quiet --no-index --find-links wheelhouse/linux "$(STICK)" \
		&& build/stick/bin/compwright demo --out build/stick/demo'

picture: demo  ## the README's picture of the demo's report; needs chromium
	chromium --headless --no-sandbox --hide-scrollbars --window-size=1100,1250 \
		--screenshot=docs/report.png file://$(CURDIR)/demo/job/report.html

clean:
	rm -rf $(VENV) demo build dist wheelhouse site docs/reference
