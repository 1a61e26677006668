# mipgen: one specification of the MIP protocol, bindings in several languages.
# `make` alone prints what there is to do.

PYTHON ?= python3
SPEC ?= spec
OUT ?= generated
BUILD ?= build
VENV := .venv
RUN := $(VENV)/bin/python
MIPGEN := PYTHONPATH=generator $(RUN) -m mipgen
JOBS ?= 2
TESTS ?= tests

.DEFAULT_GOAL := help

.PHONY: help
help: ## print this help
	@awk 'BEGIN {FS = ":.*## "} /^[a-z-]+:.*## / {printf "  make %-20s %s\n", $$1, $$2}' $(firstword $(MAKEFILE_LIST))

# ----------------------------------------------------------------- environment

# Two stamps, so that `make generate` installs no more than it needs.
$(VENV)/bin/python:
	@command -v $(PYTHON) >/dev/null 2>&1 || { echo "make: $(PYTHON) is missing; install Python 3.10 or later (Debian: apt-get install python3 python3-venv), or name it: make PYTHON=..." >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 10))' || { echo "make: $(PYTHON) is too old; Python 3.10 or later is needed: make PYTHON=..." >&2; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || { echo "make: Python's venv is missing (Debian: apt-get install python3-venv)" >&2; exit 1; }
	@echo "making $(VENV)"
	@$(PYTHON) -m venv $(VENV)

$(VENV)/generator.stamp: requirements.txt | $(VENV)/bin/python
	@echo "installing what the generator needs"
	@$(RUN) -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.txt
	@touch $@

$(VENV)/development.stamp: requirements-dev.txt | $(VENV)/generator.stamp
	@echo "installing what tests and checks need"
	@$(RUN) -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-dev.txt
	@touch $@

.PHONY: lock
lock: $(VENV)/development.stamp ## pin the newest versions of the Python tools (run it with the oldest Python)
	@for f in requirements requirements-dev; do \
	  $(VENV)/bin/pip-compile --quiet --upgrade --generate-hashes --strip-extras --allow-unsafe --no-emit-index-url --no-header -o $$f.txt $$f.in; \
	done

# ----------------------------------------------------------------- what it is for

.PHONY: validate
validate: $(VENV)/generator.stamp ## check the specification
	@$(MIPGEN) validate --spec $(SPEC)

.PHONY: generate
generate: $(VENV)/generator.stamp ## check the specification and write generated/
	@$(MIPGEN) generate --spec $(SPEC) --out $(OUT)

.PHONY: golden
golden: $(VENV)/generator.stamp ## write the snapshot of the invented specification, tests/invented/golden
	@$(MIPGEN) generate --spec tests/invented/spec --out tests/invented/golden

.PHONY: audit
audit: $(VENV)/generator.stamp ## compare the specification with the manuals: make audit MANUALS="ID=FILE ID=FILE"
	@$(MIPGEN) audit --spec $(SPEC) $(addprefix --manual ,$(MANUALS))

.PHONY: test
test: tools $(VENV)/development.stamp ## run all tests, in every language
	@$(RUN) -m pytest -n $(JOBS) $(TESTS)

.PHONY: quick
quick: $(VENV)/development.stamp ## run the tests of the generator alone
	@$(RUN) -m pytest -n $(JOBS) tests/generator tests/bad_specs

.PHONY: mutate
mutate: $(VENV)/development.stamp ## change the project at random and report what no test sees: make mutate COUNT=5 PART=c SEED=2
	@$(RUN) tests/mutate.py $(addprefix --count ,$(COUNT)) $(addprefix --part ,$(PART)) $(addprefix --seed ,$(SEED)) $(addprefix --path ,$(FILE))

.PHONY: check
check: tools $(VENV)/development.stamp ## validate, compare generated/ with the specification, run formatters and linters
	@$(MIPGEN) check --spec $(SPEC) --out $(OUT)
	@$(MIPGEN) check --spec tests/invented/spec --out tests/invented/golden
	@$(VENV)/bin/ruff check .
	@$(VENV)/bin/ruff format --check .
	@cd $(OUT)/python && $(abspath $(VENV))/bin/ruff check --quiet . && $(abspath $(VENV))/bin/ruff format --quiet --check .
	@$(VENV)/bin/mypy
	@cd $(OUT)/python && $(abspath $(VENV))/bin/mypy mip_protocol
	@find $(OUT)/c tests/c \( -name '*.c' -o -name '*.h' \) -print0 | xargs -0 $(VENV)/bin/clang-format --dry-run -Werror
	@find $(OUT)/rust/src tests/rust -name '*.rs' -not -path '*/target/*' -print0 | xargs -0 rustfmt --check --edition 2021 --config-path $(OUT)/rust
	@echo "all in order"

.PHONY: docs
docs: $(VENV)/development.stamp ## build the reference as a searchable site in build/site
	@mkdir -p $(BUILD)
	@cd $(OUT)/markdown && NO_MKDOCS_2_WARNING=1 $(abspath $(RUN)) -m mkdocs build --quiet --strict --site-dir $(abspath $(BUILD))/site
	@echo "$(BUILD)/site/index.html"

.PHONY: bench
bench: tools $(VENV)/development.stamp ## measure the languages side by side
	@$(RUN) tests/bench/bench.py

.PHONY: conformance-driver
conformance-driver: $(VENV)/generator.stamp ## build a driver and print its command: make -s conformance-driver TARGET=c
	@test -x tests/$(TARGET)/build_driver.sh || { echo "make: TARGET must be one of: $(patsubst tests/%/build_driver.sh,%,$(wildcard tests/*/build_driver.sh))" >&2; exit 1; }
	@PYTHON=$(abspath $(RUN)) tests/$(TARGET)/build_driver.sh $(OUT)/$(TARGET) $(BUILD)/driver-$(TARGET)

# ----------------------------------------------------------------- tools and dirt

.PHONY: tools
tools:
	@missing=0; need() { command -v "$$1" >/dev/null 2>&1 || { echo "make: $$1 is missing; $$2" >&2; missing=1; }; }; \
	need gcc "install it (Debian: apt-get install gcc)"; \
	need g++ "install it (Debian: apt-get install g++)"; \
	need clang "install it (Debian: apt-get install clang)"; \
	need cmake "install it (Debian: apt-get install cmake)"; \
	need pkg-config "install it (Debian: apt-get install pkg-config)"; \
	need cargo "install Rust by rustup, see https://rustup.rs"; \
	need rustup "install Rust by rustup: a test builds for a bare-metal target"; \
	need rustfmt "rustup component add rustfmt"; \
	need cargo-clippy "rustup component add clippy"; \
	exit $$missing

.PHONY: clean
clean: ## remove what was built; generated/ stays
	@rm -rf $(BUILD) .mypy_cache .ruff_cache .pytest_cache .hypothesis
	@find . -name __pycache__ -type d -not -path './.venv/*' -prune -exec rm -rf {} +
