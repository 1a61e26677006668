# mipgen: one specification of the MIP protocol, bindings in several languages.
# `make` alone prints what there is to do.

PYTHON ?= python3
SPEC ?= spec
OUT ?= generated
BUILD ?= build
VENV := .venv
RUN := $(VENV)/bin/python
# What is compiled of the generator is kept, even where Python is told to keep nothing: it is a third of a short run.
MIPGEN := PYTHONDONTWRITEBYTECODE= PYTHONPATH=generator $(RUN) -m mipgen
AUDIT := PYTHONPATH=generator:tools $(RUN) -m audit
# Processes of tests: some tests wait, so one more than processors; each also collects the tests, so no more than nine.
JOBS ?= $(shell n=$$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2); [ $$n -lt 8 ] || n=8; echo $$((n + 1)))
TESTS ?= tests

.DEFAULT_GOAL := help

.PHONY: help
help: ## print this help
	@awk 'BEGIN {FS = ":.*## "} /^[a-z-]+:.*## / {printf "  make %-20s %s\n", $$1, $$2}' $(firstword $(MAKEFILE_LIST))

# ----------------------------------------------------------------- environment

# A stamp for each lock, so that nothing installs more than it needs. Modules are compiled when they are imported: to
# compile all of them takes as long as the rest, and most are never used.
PIP_INSTALL := $(RUN) -m pip install --quiet --disable-pip-version-check --no-compile --require-hashes -r

$(VENV)/bin/python:
	@command -v $(PYTHON) >/dev/null 2>&1 || { echo "make: $(PYTHON) is missing; install Python 3.10 or later (Debian: apt-get install python3 python3-venv), or name it: make PYTHON=..." >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 10))' || { echo "make: $(PYTHON) is too old; Python 3.10 or later is needed: make PYTHON=..." >&2; exit 1; }
	@$(PYTHON) -c 'import venv, ensurepip' 2>/dev/null || { echo "make: Python's venv is missing (Debian: apt-get install python3-venv)" >&2; exit 1; }
	@echo "making $(VENV)"
	@$(PYTHON) -m venv $(VENV)

$(VENV)/generator.stamp: requirements/generator.txt | $(VENV)/bin/python
	@echo "installing what the generator needs"
	@$(PIP_INSTALL) requirements/generator.txt
	@touch $@

$(VENV)/development.stamp: requirements/development.txt | $(VENV)/generator.stamp
	@echo "installing what tests and checks need"
	@$(PIP_INSTALL) requirements/development.txt
	@touch $@

$(VENV)/all.stamp: requirements/all.txt | $(VENV)/development.stamp
	@echo "installing what long tests and measurements need"
	@$(PIP_INSTALL) requirements/all.txt
	@touch $@

# What formats, bundles and tests JavaScript. Only `make check` goes without it where npm is missing.
NPM := $(shell command -v npm)

$(BUILD)/npm/stamp: requirements/npm/package-lock.json
	@command -v npm >/dev/null 2>&1 || { echo "make: npm is missing; install it (Debian: apt-get install npm)" >&2; exit 1; }
	@echo "installing what JavaScript needs"
	@mkdir -p $(@D) && cp $(<D)/package*.json $(@D) && cd $(@D) && npm ci --silent --no-audit --no-fund --ignore-scripts
	@touch $@

# For all Pythons alike: what the oldest one needs is in the lock too. Folders of this machine have no place in it.
PIP_COMPILE := env -u PIP_FIND_LINKS -u PIP_INDEX_URL $(BUILD)/lock/bin/pip-compile --quiet --upgrade --generate-hashes \
  --strip-extras --allow-unsafe --no-emit-index-url --no-emit-find-links --no-emit-trusted-host --no-header
OLDEST ?= python3.10

.PHONY: lock
lock: ## pin the newest versions of the Python tools
	@$(OLDEST) -c 'import sys; sys.exit(sys.version_info[:2] != (3, 10))' || { echo "make: the lock is made with Python 3.10, the oldest that is supported: make lock OLDEST=..." >&2; exit 1; }
	@$(OLDEST) -m venv --clear $(BUILD)/lock
	@$(BUILD)/lock/bin/python -m pip install --quiet pip-tools
	@$(PIP_COMPILE) -o requirements/generator.txt pyproject.toml
	@$(PIP_COMPILE) -o requirements/development.txt requirements/development.in
	@$(PIP_COMPILE) -o requirements/all.txt requirements/all.in
	@$(OLDEST) tests/locks.py $(patsubst %,requirements/%.txt,generator development all)

# ----------------------------------------------------------------- what it is for

.PHONY: validate
validate: $(VENV)/generator.stamp ## check the specification
	@$(MIPGEN) validate --spec $(SPEC)

.PHONY: generate
generate: $(VENV)/generator.stamp ## check the specification and write generated/
	@$(MIPGEN) generate --spec $(SPEC) --out $(OUT)

.PHONY: golden
golden: $(VENV)/generator.stamp ## write the snapshot of the invented specification, tests/invented/golden
	@PYTHONPATH=generator $(RUN) tests/golden.py

.PHONY: first-page
first-page: generate ## write the field that README.md shows, as it is generated
	@$(RUN) tests/first_page.py

.PHONY: status
status: generate ## write docs/status.md and the figures of README.md, from committed results
	@$(RUN) tests/status.py

.PHONY: keys
keys: $(VENV)/generator.stamp ## write generated/keys.md, the index of the keys of a specification
	@$(RUN) tests/keys.py

# The commit's generator runs in a copy of that commit; both outputs have the same place within their folder.
.PHONY: golden-diff
golden-diff: $(VENV)/generator.stamp ## show what changed in that output since a commit: make golden-diff SINCE=HEAD~3
	@rm -rf $(BUILD)/golden && mkdir -p $(BUILD)/golden/commit
	@git archive $(or $(SINCE),HEAD) | tar -x -C $(BUILD)/golden/commit
	@cd $(BUILD)/golden/commit && PYTHONPATH=generator $(abspath $(RUN)) -m mipgen generate --spec tests/invented/spec --out ../invented >/dev/null
	@$(MIPGEN) generate --spec tests/invented/spec --out $(BUILD)/invented >/dev/null
	@git --no-pager diff --no-index --stat -p $(BUILD)/golden/invented $(BUILD)/invented || true

.PHONY: audit
audit: $(VENV)/generator.stamp ## compare the specification with facts of other sources, or with the vendor's SDK: make audit SDK=FOLDER, EXTRACT=1 writes its facts
	@$(AUDIT) --spec $(SPEC) $(addprefix --sdk ,$(SDK)) $(if $(EXTRACT),--extract)

# Each ends with a line that says what was run and what was left out; nothing is skipped in between.
# Tests start many programs in Python: what is compiled is kept, even where Python is told to keep nothing.
PYTEST = PYTHONDONTWRITEBYTECODE= SEED=$(SEED) $(RUN) -m pytest -n $(JOBS) --dist loadgroup --no-loadscope-reorder

.PHONY: test
test: tools $(VENV)/development.stamp ## run the tests of all languages, of those whose compiler is there: make test SEED=2, make test STRICT=1
	@$(PYTEST) -m "not (heavy or packaging or cross or nightly)" $(TESTS)

.PHONY: test-packaging
test-packaging: tools-packaging $(VENV)/all.stamp ## build packages, install them, and use C in build systems
	@$(PYTEST) -m "packaging and not nightly" $(TESTS)

# Locked versions are old ones for some users: what `pip` installs today must work as well.
.PHONY: test-newest
test-newest: ## run the tests of logs as columns with the newest NumPy, pandas, Polars, pyarrow, mcap and rosbags
	@$(PYTHON) -m venv $(BUILD)/newest
	@$(BUILD)/newest/bin/python -m pip install --quiet --require-hashes -r requirements/all.txt
	@$(BUILD)/newest/bin/python -m pip install --quiet --upgrade numpy pandas polars pyarrow mcap rosbags
	@PATH=$(abspath $(BUILD)/newest/bin):$$PATH python -m pytest -n $(JOBS) -k "not wheels" \
		tests/tools/test_columns.py tests/tools/test_log_tables.py tests/tools/cli/test_logs.py tests/tools/cli/test_robots.py

.PHONY: test-all
test-all: tools-all test test-packaging ## these, and those that take long, or need other compilers, browsers and Pythons
	@$(PYTEST) --durations=20 --durations-min=30 -m "heavy and not (packaging or nightly)" $(TESTS)

.PHONY: nightly
nightly: SEED ?= $(shell date +%s)
nightly: tools-all tools-cross tools-fuzz tools-miri tools-semver tools-workflows $(VENV)/all.stamp ## all tests, random ones with a seed of their own and many more rounds, and fuzzing: make nightly SEED=2 TIME=300
	@NIGHTLY=1 $(PYTEST) $(TESTS)
	@$(MAKE) --no-print-directory fuzz TIME=$(or $(TIME),300)
	@$(MAKE) --no-print-directory prove

.PHONY: test-cross
test-cross: tools-cross $(VENV)/development.stamp ## run C on other machines, in emulators: big-endian, strict alignment, 32 bits, Cortex-M, AVR
	@$(PYTEST) -m "cross and not nightly" tests/cross

# Of the generator, what runs in its process; and every printed packet in Python.
SLOW := cli discovery mutations output targets
.PHONY: quick
quick: $(VENV)/development.stamp ## run the quick tests of the generator, and Python with every printed packet, in one to two minutes
	@$(PYTEST) -m "not (heavy or packaging or nightly)" tests/generator $(SLOW:%=--ignore=tests/generator/test_%.py) \
	  $(foreach spec,real invented,$(foreach way,decode_to_their_values encode_to_their_bytes,"tests/conformance/test_conformance.py::test_examples_$(way)[python-$(spec)]"))

.PHONY: semver
semver: tools-semver $(VENV)/development.stamp ## of nightly: compare the Rust crate with the last release, and with itself and an addition
	@$(PYTEST) tests/rust/test_rust_semver.py

.PHONY: mutate
mutate: $(VENV)/development.stamp ## change the project at random and report what no test sees: make mutate COUNT=60 SEED=2 PART=c
	@$(RUN) tests/mutate.py $(addprefix --count ,$(COUNT)) $(addprefix --part ,$(PART)) $(addprefix --seed ,$(SEED)) $(addprefix --path ,$(FILE))

.PHONY: fuzz
fuzz: tools-fuzz $(VENV)/development.stamp ## search for inputs that break a language or tell two apart, and keep those that reach new code: make fuzz TIME=60 TARGETS="parser fields-random" SEED=2; RECORD=1 notes the counts in docs/proofs.md
	@$(RUN) tests/fuzz/fuzz.py $(if $(RECORD),--record) $(addprefix --time ,$(TIME)) $(addprefix --seed ,$(SEED)) $(if $(TARGETS),--targets $(TARGETS))

.PHONY: prove
prove: tools-prove $(VENV)/development.stamp ## prove properties of C for all inputs: make prove PROOF=walk SECONDS=300, make prove PLANT=1
	@$(RUN) tests/prove/proofs.py $(addprefix --proof ,$(PROOF)) $(addprefix --seconds ,$(SECONDS)) $(if $(PLANT),--plant)

# Formatters that `make check` uses where they are there; with STRICT=1, it fails if one is missing.
RUSTFMT = $(shell rustfmt --version 2>/dev/null)
NO_FORMATTER = $(strip $(if $(RUSTFMT),,rustfmt (rustup component add rustfmt)) $(if $(NPM),,biome (Debian: apt-get install npm)))

.PHONY: check
check: $(if $(NPM),$(BUILD)/npm/stamp) tools-check $(VENV)/development.stamp ## validate, compare generated/ with the specification, run formatters and linters
	@$(MIPGEN) check --spec $(SPEC) --out $(OUT)
	@$(if $(wildcard $(SPEC)/witness),$(AUDIT) --spec $(SPEC) --witness $(SPEC)/witness)
	@PYTHONPATH=generator $(RUN) tests/golden.py --check
	@$(RUN) tests/keys.py --check
	@$(RUN) tests/first_page.py --check
	@$(RUN) tests/status.py --check
	@$(RUN) tests/wording.py $(SPEC)
	@$(RUN) tools/release/interface.py --check --out $(OUT)
	@$(VENV)/bin/ruff check --quiet .
	@$(VENV)/bin/ruff format --quiet --check .
	@cd $(OUT)/python && $(abspath $(VENV))/bin/ruff check --quiet . && $(abspath $(VENV))/bin/ruff format --quiet --check .
	@$(VENV)/bin/mypy --no-error-summary
	@PYTHONPATH=generator:generated/python $(VENV)/bin/lint-imports --no-logo --no-cache >$(BUILD)/imports.txt || { cat $(BUILD)/imports.txt; false; }
	@cd $(OUT)/python && $(abspath $(VENV))/bin/mypy --no-error-summary mip_protocol
	@cd tools && $(abspath $(VENV))/bin/mypy --no-error-summary
	@cd tools && PYTHONPATH=. $(abspath $(VENV))/bin/lint-imports --no-logo --no-cache >$(abspath $(BUILD))/imports.txt || { cat $(abspath $(BUILD))/imports.txt; false; }
	@find $(OUT)/c runtime/c tests/c tests/cross \( -name '*.c' -o -name '*.h' -o -name '*.hpp' \) -print0 | xargs -0 $(VENV)/bin/clang-format --dry-run -Werror
	$(if $(RUSTFMT),@find $(OUT)/rust/src tests/rust -name '*.rs' -not -path '*/target/*' -print0 | xargs -0 rustfmt --check --edition 2021 --config-path $(OUT)/rust)
	$(if $(NPM),@$(BUILD)/npm/node_modules/.bin/biome check --error-on-warnings --log-level=warn .)
	@echo "checked: specification, words, generated files, ruff, mypy, imports, clang-format$(if $(RUSTFMT), and rustfmt)$(if $(NPM), and biome); left out: $(or $(NO_FORMATTER),nothing)"
	$(if $(STRICT),@test -z "$(NO_FORMATTER)")

.PHONY: workbench
workbench: $(BUILD)/npm/stamp ## build the tools for the browser in build/workbench, of any output: make workbench OUT=FOLDER
	@NODE_PATH=$(abspath $(BUILD))/npm/node_modules node tools/workbench/bundle.mjs $(OUT)/javascript $(BUILD)/workbench

# The site gets its tools, and a search that knows descriptors, from the workbench.
MKDOCS = NO_MKDOCS_2_WARNING=1 MIP_WORKBENCH=$(abspath $(BUILD))/workbench $(if $(filter generated,$(OUT)),MIP_PAGES=$(abspath $(BUILD))/pages) $(abspath $(RUN)) -m mkdocs

.PHONY: docs
docs: workbench $(VENV)/development.stamp ## build the reference as a searchable site in build/site
	@$(RUN) docs/pages.py $(BUILD)/pages
	@cd $(OUT)/markdown && $(MKDOCS) build --quiet --strict --site-dir $(abspath $(BUILD))/site
	@$(RUN) docs/everything.py $(BUILD)/site
	@echo "$(BUILD)/site/index.html"

.PHONY: pdf
pdf: docs ## print the reference on one page, which takes minutes: build/site/everything.html, and mip-reference.pdf beside it
	@$(RUN) docs/everything.py $(BUILD)/site $(BUILD)/site/mip-reference.pdf
	@echo "$(BUILD)/site/mip-reference.pdf"

.PHONY: release
release: export SOURCE_DATE_EPOCH = 315532800
release: tools-release pdf $(VENV)/all.stamp ## build what people install in dist/, with checksums, an SBOM and notes: make release, make release REHEARSE=1
	@$(RUN) tools/release/build.py --site $(BUILD)/site
	$(if $(REHEARSE),@$(RUN) tools/release/publish.py --rehearse)

.PHONY: interface
interface: ## of a release: write what programs see of this version, interface/, with which make check compares
	@$(PYTHON) tools/release/interface.py

.PHONY: docs-serve
docs-serve: workbench $(VENV)/development.stamp ## show that site at http://127.0.0.1:8000, and follow changes: make docs-serve ADDRESS=HOST:PORT
	@$(RUN) docs/pages.py $(BUILD)/pages
	@cd $(OUT)/markdown && $(MKDOCS) serve $(addprefix --dev-addr ,$(ADDRESS))

.PHONY: pictures
pictures: docs $(VENV)/all.stamp ## make the pictures of the README anew, and in build/pictures those of the site
	@$(RUN) docs/pictures/session.py docs/pictures/session.svg
	@PYTHONPATH=generator:tests $(RUN) docs/pictures/pages.py $(BUILD)/site $(BUILD)/pictures
	@cp $(BUILD)/pictures/field.png docs/pictures/field.png
	@$(RUN) tests/first_page.py --pictures

.PHONY: bench
bench: tools $(VENV)/all.stamp ## measure size and speed; README=1 writes the tables of the READMEs, PART=generate measures the generator only, PART=columns logs, PART=javascript the JavaScript package, PART=rust the crate, PEER=FOLDER compares with the vendor's SDK
	@PYTHONPATH=generator $(RUN) tests/bench/bench.py $(if $(README),--readme) $(addprefix --part ,$(PART)) $(if $(PEER),--peer $(PEER))

.PHONY: interop
interop: $(VENV)/development.stamp ## run the vendor's example programs on virtual devices: make interop PEER=FOLDER
	@$(RUN) tests/interop/interop.py $(addprefix --peer ,$(PEER))

.PHONY: conformance-driver
conformance-driver: $(VENV)/generator.stamp ## build a driver and print its command: make -s conformance-driver TARGET=c
	@test -x tests/$(TARGET)/build_driver.sh || { echo "make: TARGET must be one of: $(patsubst tests/%/build_driver.sh,%,$(wildcard tests/*/build_driver.sh))" >&2; exit 1; }
	@PYTHON=$(abspath $(RUN)) tests/$(TARGET)/build_driver.sh $(OUT)/$(patsubst cpp,c,$(TARGET)) $(BUILD)/driver-$(TARGET)

# ----------------------------------------------------------------- tools and dirt

.PHONY: tools tools-check tools-packaging tools-release tools-all tools-cross tools-fuzz tools-miri tools-prove tools-semver tools-workflows
tools:
	@tests/tools.sh test

tools-check:
	@tests/tools.sh check

tools-packaging:
	@tests/tools.sh packaging

tools-release:
	@tests/tools.sh release

tools-all:
	@tests/tools.sh all

tools-cross:
	@tests/tools.sh cross

tools-fuzz:
	@tests/tools.sh fuzz

tools-miri:
	@tests/tools.sh miri

tools-prove:
	@tests/tools.sh prove

tools-semver:
	@tests/tools.sh semver

tools-workflows:
	@tests/tools.sh workflows

.PHONY: clean
clean: ## remove what was built; generated/ stays
	@rm -rf $(BUILD) dist .mypy_cache .ruff_cache .pytest_cache
	@find . -name __pycache__ -type d -not -path './.venv/*' -prune -exec rm -rf {} +
