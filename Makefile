# Two commands do everything on a machine that has Python 3.11+ and make:
#   make run    opens the window on sample_data/ (without a display: evaluates, exports and draws it)
#   make test   runs the tests, without the slowest quarter (make soak)
SHELL := /bin/sh
UV_VERSION := 0.13.8
STAMP := .venv/.ready
BIN := .venv/bin

.PHONY: help run test soak installed clients bundle setup lint format check bench screenshots example docs sample languages clean

help:
	@echo "make run          open the window on sample_data/"
	@echo "make test         run the tests, without those of tests/slow.txt"
	@echo "make soak         slow tests, whole real sets, random use and damaged files, for ten minutes"
	@echo "make installed    build, install in an empty environment elsewhere, and try it there"
	@echo "make clients      try exports with the programs of others that read them"
	@echo "make bundle       make dist/procc-annotator, which needs no Python, and try it"
	@echo "make setup        create .venv from the lock, and nothing else"
	@echo "make check        lint, format check, types and import contracts"
	@echo "make format       format the code"
	@echo "make bench        print the benchmark figures"
	@echo "make screenshots  take the README's pictures again"
	@echo "make example      make the example report again (DATA=folder of the World Cup 2014 data)"
	@echo "make languages    collect the window's texts, compile the translations, say what is missing"
	@echo "make docs         build the documentation as a site in out/site/, which opens from there"
	@echo "make sample       draw sample_data/ again"
	@echo "make clean        remove .venv and everything built"

setup: $(STAMP)

# The lock decides every version; uv itself lives in the environment and is not expected outside.
$(STAMP): pyproject.toml uv.lock .ci/setup_system.py
	@python=$$(sh .ci/find_python) && \
	"$$python" .ci/setup_system.py && \
	{ test -x $(BIN)/python || "$$python" -m venv .venv; } && \
	{ $(BIN)/python -c 'import importlib.metadata as m, sys; sys.exit(m.version("uv") != "$(UV_VERSION)")' 2>/dev/null || \
	  $(BIN)/python -m pip install --quiet --disable-pip-version-check uv==$(UV_VERSION); } && \
	VIRTUAL_ENV="$$PWD/.venv" $(BIN)/uv sync --frozen --inexact --quiet --compile-bytecode && \
	touch $(STAMP)

run: setup
	@if [ -n "$$DISPLAY$$WAYLAND_DISPLAY" ] || [ "$$(uname)" = Darwin ]; then \
	  $(BIN)/procc-annotator open sample_data; \
	else \
	  echo "No display here: evaluating, exporting and drawing sample_data/ into out/."; \
	  mkdir -p out && \
	  $(BIN)/procc-annotator evaluate sample_data --cameras true=sample_data/cameras/true --cameras bad=sample_data/cameras/bad --output out/scores.json && \
	  $(BIN)/procc-annotator export sample_data out/export --cameras sample_data/cameras/true && \
	  $(BIN)/procc-annotator render sample_data out/overlays --cameras sample_data/cameras/true --overwrite; \
	fi

# Tests start the program hundreds of times: compiled once, it starts three times as fast. A process
# that ends midway (a test that hangs) is not started again: it would begin with the same test. What
# pytest makes of the tests is kept, whatever is set outside: each process would make it anew.
PYTEST := PYTHONDONTWRITEBYTECODE= QT_QPA_PLATFORM=offscreen $(BIN)/pytest --numprocesses auto --maxprocesses 4
FILES := $(PYTEST) --max-worker-restart 0 --dist loadfile

# The window's tests, those of commands and of whole data, and those of parts by processes of their
# own: together they hold several times the memory, by what they load and what they keep.
test: setup
	@$(BIN)/python -m compileall -q procc_annotator
ifdef ARGS
	$(FILES) $(ARGS)
else
	failed=0; \
	$(FILES) tests/gui || failed=1; \
	$(FILES) tests --ignore tests/gui --ignore tests/unit || failed=1; \
	$(FILES) tests/unit || failed=1; \
	exit $$failed
endif

lint: setup
	$(BIN)/ruff check .
	$(BIN)/lint-imports

check: lint
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# The tests of tests/slow.txt; statistics over whole real sets, storms of kills; and random use and
# damaged files, SOAK times over. After BUDGET seconds no further test begins.
SOAK := 40
BUDGET := 600
soak: setup
	SOAK=$(SOAK) $(PYTEST) -m soak --budget $(BUDGET) --maxschedchunk 1 $(ARGS)

# As a user has it: the wheel from the sdist, an environment with nothing else, no checkout in sight.
installed: setup
	$(BIN)/python .ci/try_installed.py

# Programs of others, in an environment of their own: they read what is written here, and are read.
clients: setup
	@$(BIN)/uv venv --quiet --allow-existing --python $(BIN)/python out/clients
	@$(BIN)/uv pip sync --quiet --python out/clients tests/clients/requirements.txt
	PROCC_CLIENTS="$$PWD/out/clients" $(BIN)/pytest tests/cli/test_other_programs.py $(ARGS)

# One folder with everything inside, by PyInstaller in an environment of its own.
bundle: setup
	$(BIN)/python packaging/build_bundle.py

languages: setup
	$(BIN)/python packaging/languages.py collect
	$(BIN)/python packaging/languages.py compile
	$(BIN)/python packaging/languages.py missing

format: setup
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

bench: setup
	QT_QPA_PLATFORM=offscreen $(BIN)/pytest tests/bench --benchmark-only -s $(ARGS)

screenshots: setup
	QT_QPA_PLATFORM=offscreen $(BIN)/python docs/make_screenshots.py
	MPLBACKEND=agg $(BIN)/python docs/make_figures.py

example: setup
	$(BIN)/python docs/make_wc14_report.py "$(DATA)"

# Whatever the site would show wrongly is an error: a broken link, a page that the menu leaves out, a
# docstring that tells of other arguments than there are.
docs: setup
	@VIRTUAL_ENV="$$PWD/.venv" $(BIN)/uv sync --frozen --inexact --quiet --group docs
	NO_MKDOCS_2_WARNING=1 PYTHONPATH="$$PWD" $(BIN)/mkdocs build --strict
	@echo "out/site/index.html"

sample: setup
	$(BIN)/python sample_data/make_sample_data.py

clean:
	rm -rf .venv out build dist .pytest_cache .ruff_cache .mypy_cache .hypothesis .import_linter_cache .benchmarks
