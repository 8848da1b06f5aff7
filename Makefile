# Everything that the project offers from a fresh checkout. Each target sets up the
# virtual environment that it needs; PYTHON=python3.12 chooses the interpreter.

BIN := .venv/bin
PYTHON ?=
export PYTHON
# Bytecode is kept, whatever the shell says: each worker of the tests would make it anew.
export PYTHONDONTWRITEBYTECODE :=

.DEFAULT_GOAL := help
.PHONY: help demo test verify golden bench browser docs plotly release runtime dev docs-tools clean
.PHONY: kernels types layers rewritten

help:
	@echo "make demo    solve the shipped example: a 218 bearing at 10 000 rpm, combined load"
	@echo "make test    check everything: style, types, layers, tests"
	@echo "make verify  the longer sweeps, the golden runs, the published numbers, the documentation"
	@echo "make golden  compare what all commands answer with what they answered before"
	@echo "make bench   measure the speed"
	@echo "make browser try the app in Chromium, as people use it; skipped where there is none"
	@echo "make docs    build the documentation site, docs/_build/html"
	@echo "make release build sdist and wheel, and try them on every Python that is here; no upload"
	@echo "make plotly  bundle the part of Plotly.js that the app draws with; needs Node.js"
	@echo "make clean   remove the virtual environment and all caches"

demo: runtime
	@$(BIN)/rolamento demo

test: dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/python scripts/words.py --check
	@# what each worker of the tests would do for itself: once, beside the slow checks
	@$(MAKE) --no-print-directory -j2 kernels types layers rewritten
	$(BIN)/pytest -n auto --dist worksteal -m "not sweep"

kernels: dev
	$(BIN)/rolamento warm

types: dev
	$(BIN)/mypy

layers: dev
	$(BIN)/lint-imports --no-cache

rewritten: dev  # the assertions; what is wrong the tests themselves tell
	@$(BIN)/pytest --collect-only -qq >/dev/null || true

verify: dev
	$(BIN)/pytest -n auto --dist worksteal -m sweep
	HYPOTHESIS_PROFILE=verify $(BIN)/pytest -n auto --dist worksteal tests/properties
	@$(BIN)/python -m tests.regression.golden --check --elsewhere
	@$(BIN)/python -m tests.regression.pages --check
	@$(BIN)/rolamento verify
	@$(MAKE) docs

golden: dev
	@$(BIN)/python -m tests.regression.golden --check
	@$(BIN)/python -m tests.regression.pages --check

bench: dev
	@$(BIN)/python -m benchmarks

docs: docs-tools
	@$(BIN)/python scripts/gallery.py docs/gallery/examples
	@$(BIN)/python -m sphinx --fail-on-warning --keep-going --quiet --jobs auto \
	    --doctree-dir docs/_build/doctrees --builder html docs docs/_build/html
	@echo "The site is docs/_build/html/index.html"

plotly:
	@cd scripts/plotly && npm install --ignore-scripts --no-audit --no-fund --no-package-lock
	@node scripts/plotly/build.mjs

release: dev
	@$(BIN)/python -m pip install --disable-pip-version-check --quiet --constraint constraints.txt build twine
	@$(BIN)/python scripts/release.py

browser:
	@sh scripts/setup.sh browser
	@$(BIN)/pytest -rs tests/browser

runtime:
	@sh scripts/setup.sh runtime

dev:
	@sh scripts/setup.sh dev

docs-tools:
	@sh scripts/setup.sh docs

clean:
	rm -rf .venv .mypy_cache .pytest_cache .ruff_cache .hypothesis docs/_build \
	    docs/reference/api docs/gallery/examples
	find src reproductions tests benchmarks docs -name __pycache__ -type d -prune -exec rm -rf {} +
