# `make` alone lists the commands of every day; CONTRIBUTING.md lists the others. Everything is set up on the way: nothing needs to be activated.
PORT ?= 8000
DATA ?= data
PYTHON ?= python3
WORKERS ?= 2
PARALLEL_JOBS ?= 2
# The longest first; what is short fills the gap at the end.
PARTS := unit e2e frontend-test unit-postgres
SLOW_PARTS := slow-unit slow-e2e slow-unit-postgres slow-frontend-test
FAST := not slow and not lint
BIN := .venv/bin
UV := $(BIN)/uv --quiet --no-python-downloads
SHELL := /bin/bash
export PYTHONPATH := $(CURDIR)
# Where images and shells set it, each of the thousand processes of a test run would compile all it imports again: 3.5 s.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help setup run dev hooks quick test test-slow check coverage fix unit unit-postgres frontend-test e2e slow-unit slow-unit-postgres slow-frontend-test slow-e2e firefox kill planted-bugs attack large-zip false-alarms audit audit-levels fuzz parity bench weights docs docs-site pictures migration openapi completions lock audit-dependencies pins wheels sbom clean

help:  ## List these commands
	@grep -hE '^[a-z0-9-]+:.*##' $(MAKEFILE_LIST) | awk -F':.*## ' '{printf "  make %-14s %s\n", $$1, $$2}'

setup: .make/python .make/kernel .make/node .make/page .make/help frontend/src/api/schema.gen.ts  ## Set up everything that running and testing need

run: setup  ## Serve the product with a demo project (PORT=8000, DATA=data)
	@exec env SOUNDLIST_DATA_DIR="$(DATA)" $(BIN)/soundlist demo --port $(PORT)

dev: setup  ## Serve the demo project and follow every change: open port 5173 (PORT=8000 is the server's)
	@trap 'kill 0' EXIT; \
	  SOUNDLIST_DATA_DIR="$(DATA)" $(BIN)/watchfiles --filter python --sigint-timeout 30 "$(BIN)/soundlist demo --port $(PORT)" app audio_checks migrations & \
	  cd frontend && SOUNDLIST_SERVER=http://127.0.0.1:$(PORT) npm run --silent dev

hooks: setup  # Check what you commit before it is committed
	@$(BIN)/pre-commit install

quick: setup .make/postgresql .make/librosa  ## Pass the test files nearest to what is not committed (SINCE=main: nearest to a branch's changes)
	@files=$$($(BIN)/python -m tests.affected --since '$(SINCE)') || exit 1; \
	  test -z "$$files" || $(BIN)/pytest -q -n $(WORKERS) --dist loadfile -m 'not slow' $$files || test $$? = 5
	@cd frontend && npx vitest run --tags-filter='!slow' --changed $(SINCE) --passWithNoTests

test: .make/kernel  ## Set up and pass the fast tests, two parts at a time: about 15 minutes on two cores
	@$(call in_parallel,$(PARTS))

test-slow: .make/s3  ## Pass every other test: PostgreSQL, kills, attacks, timing, long walks in the browser
	@$(call in_parallel,$(SLOW_PARTS))
	@if command -v firefox-esr >/dev/null; then $(MAKE) --no-print-directory firefox; else echo "firefox-esr is not installed: make firefox installs it"; fi

# Run parts beside each other; afterwards repeat what each passed.
define in_parallel
mkdir -p .make && rm -f .make/*.failed; \
$(MAKE) --no-print-directory --keep-going --jobs=$(PARALLEL_JOBS) $(1:%=parallel-%) || { cat .make/*.failed 2>/dev/null; exit 1; }; \
for part in $(1); do echo "$$part: $$(grep -E '[0-9]+ passed' .make/$$part.log | tail -n 1)"; done
endef

parallel-%: setup .make/postgresql .make/browser
	@.ci/part $* $(MAKE) --no-print-directory $*

check: setup  ## Lint, types, import contracts, code that nobody calls, OpenAPI drift
	$(BIN)/ruff check . && $(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-cache
	$(BIN)/pytest -q -n $(WORKERS) --dist loadfile -m lint tests/house tests/audio_checks/test_pages.py
	@! $(BIN)/vulture | grep -E 'unused (class|function|import|method)|unreachable' || { echo "nobody calls these: remove them"; exit 1; }
	$(BIN)/soundlist openapi .make/openapi.json && diff -u frontend/openapi.json .make/openapi.json >/dev/null || \
	  { echo "frontend/openapi.json is not what the server says: run make openapi"; exit 1; }
	cd frontend && npm run --silent typecheck && npm run --silent lint

unit: setup .make/postgresql  # Fast Python tests, on SQLite and a folder of sounds
	@$(BIN)/pytest -n $(WORKERS) --dist loadfile -m '$(FAST)' --record=.make/statements $(ARGS)

slow-unit: setup .make/postgresql .make/s3 .make/librosa .make/caddy  # Slow Python tests, on SQLite and a folder of sounds
	@$(BIN)/pytest -n $(WORKERS) --dist loadfile -m slow $(ARGS)

coverage: setup .make/postgresql .make/s3 .make/librosa  # Lines and branches that the tests of rooms and journeys run; 95 % in rules, services and queries
	@$(BIN)/pytest -n $(WORKERS) --dist loadfile --cov --cov-report= tests/app tests/journeys $(ARGS)
	@$(BIN)/coverage report --include='app/*' --format=total | sed 's/^/app, percent: /'
	@$(BIN)/coverage report --include='app/*/rules.py,app/*/*_rules.py,app/*/service.py,app/*/queries.py,app/*/*_queries.py' --fail-under=95

unit-postgres: setup .make/postgresql  # Fast tests of what differs on PostgreSQL
	@$(BIN)/pytest -n $(WORKERS) --dist loadfile -m 'both_databases and $(FAST)' --database postgres $$(grep -rlw --include='test_*.py' both_databases tests/app) $(ARGS)

slow-unit-postgres: setup .make/postgresql .make/s3 .make/librosa  # On PostgreSQL and S3, the slow tests and every statement that make unit recorded
	@$(BIN)/pytest -n $(WORKERS) --dist loadfile --database postgres --store s3 --recorded=.make/statements tests/app tests/journeys $(ARGS)

frontend-test: setup  # Fast tests of the frontend's parts
	@cd frontend && npm run --silent test

slow-frontend-test: setup  # Slow tests of the frontend's parts
	@cd frontend && npm run --silent --if-present test:slow

e2e: setup .make/browser .make/postgresql .make/librosa  # Walk the product in a real browser as its users
	@cd frontend && npm run --silent e2e

slow-e2e: setup .make/browser .make/postgresql .make/s3 .make/librosa  # Long walks in a real browser, and those that take time
	@cd frontend && npm run --silent e2e:slow

firefox: setup .make/browser .make/postgresql .make/librosa  # Walk the first minute of each role in Firefox too
	@command -v firefox-esr >/dev/null && command -v pulseaudio >/dev/null || sh .ci/install firefox-esr pulseaudio
	@cd frontend && FIREFOX=$$(command -v firefox-esr) npm run --silent e2e:firefox

kill: setup .make/postgresql .make/caddy  # Kill real processes at every named point, 20 times each
	$(BIN)/pytest -n 3 tests/kill --kill-runs 20

planted-bugs: setup  # Plant bugs in every room, one at a time, and say which tests catch each (EACH=2, SEED=1)
	@$(BIN)/python -m tests.planted_bugs --each $(or $(EACH),2) --seed $(or $(SEED),1)

attack: setup .make/postgresql  # Attack a real server and name what broke it (SECONDS=300, DATABASE=sqlite or postgres)
	$(BIN)/python -m tests.attack --seconds $(or $(SECONDS),300) --database $(or $(DATABASE),sqlite)

large-zip: setup  # Send a ZIP of 5 GiB through a real server, and look at time, memory and disk (BYTES=)
	$(BIN)/python -m tests.attack.large_zip --bytes $(or $(BYTES),5368709120)

false-alarms: setup  # Count false alarms and injected faults; SOUNDS_DIR names the folder of real sounds
	$(BIN)/python -m benchmarks.faults

audit: setup  # Look for changed sounds among approved ones; SOUNDS_DIR names the folder of real sounds
	$(BIN)/python -m benchmarks.audits

audit-levels: setup  # Plant gains in projects of every engine and look for them; MIDDLEWARE_DIR names a folder of real ones
	$(BIN)/python -m benchmarks.audits.levels

fuzz: setup  # Feed the readers damaged sounds and projects, and everything 200,000 sounds of every shape (PROJECTS=, SOUNDS=, FIRST=)
	$(BIN)/python -m tests.audio_checks.fuzz --mutants 1000000
	$(BIN)/python -m tests.audio_checks.project_fuzz --mutants $(or $(PROJECTS),200000) --seed $(or $(FIRST),0)
	$(BIN)/python -m tests.audio_checks.sound_fuzz --count $(or $(SOUNDS),200000) --first $(or $(FIRST),0)

parity: setup  # Ask server, command line and Python about 1,000 sounds by 6 specs
	$(BIN)/python -m tests.app.conformance.parity

bench: setup .make/peers  # Measure speed and quality against peers
	$(BIN)/python -m benchmarks

weights: setup  # Train the weights of judgements (needs ffmpeg; SOUNDS_DIR= adds real recordings, RECORDED_DIR= adds others in measured rooms; an hour)
	$(UV) sync --frozen --inexact --no-install-workspace --group training
	$(BIN)/python -m training.reverb
	test -z "$(RECORDED_DIR)" || { $(BIN)/python -m training.reverb_recorded && $(BIN)/python -m training.reverb --tables-only; }
	$(BIN)/python -m training.reversed
	$(BIN)/python -m training.upsampled
	$(BIN)/python -m training.lossy
	$(BIN)/python -m training.padded

fix: setup  ## Format and fix what can be fixed by itself
	$(BIN)/ruff check --fix . ; $(BIN)/ruff format .
	cd frontend && npm run --silent format

docs: setup  ## Write the generated pages
	$(BIN)/python -m audio_checks.cli.pages docs/checks
	$(BIN)/python -m tests.support.architecture docs/pictures/architecture.svg
	$(BIN)/python -m tests.support.keys docs/reference/keys.md

docs-site: .make/python  # Build the guides as a site, which the server has at /help
	@$(BIN)/python .ci/docs_site.py

pictures: setup .make/browser  # Take the pictures of the guides from the demo project, in light and dark
	@cd frontend && PICTURES=1 npx playwright test --project=slow pictures

migration: setup  ## Write the migration that makes every table of the models
	$(BIN)/python -m migrations.write_initial

openapi: .make/kernel .make/node  ## Write the OpenAPI document and the frontend's types
	$(BIN)/soundlist openapi frontend/openapi.json
	$(BIN)/python -m tests.support.described_checks frontend/src/test/checks.json
	$(BIN)/python -m tests.support.browser_vectors frontend/src/precheck/vectors.json
	cd frontend && npm run --silent gen

completions: .make/kernel  # Write the completion scripts of audio-checks
	$(BIN)/python -m audio_checks.cli.completion

audit-dependencies: .make/python  # Look for known vulnerabilities in what is locked, where advisories can be reached
	@REQUIRED=$(REQUIRED) .ci/audit-dependencies

pins:  # Pin images and actions by digest (needs docker, gh and their registries)
	@$(PYTHON) deploy/pin_digests.py

lock: .make/python  ## Lock what pyproject.toml asks for (UPGRADE=1 takes the newest versions)
	@$(UV) lock $(if $(UPGRADE),--upgrade)

wheels: setup  ## Build the wheels of audio-checks and soundlist, with the page (OUT=dist)
	@$(UV) build --wheel --no-build-isolation --python $(BIN)/python --package audio-checks --out-dir $(or $(OUT),dist)
	@$(UV) build --wheel --no-build-isolation --python $(BIN)/python --package soundlist --out-dir $(or $(OUT),dist)

# npm leaves React out with --omit dev; what only builds the page is marked as such in the bill.
sbom: .make/python .make/node  # Write the bills of materials of what is locked, as CycloneDX (OUT=dist)
	@mkdir -p $(or $(OUT),dist)
	@for package in audio-checks soundlist; do \
	  $(UV) export --frozen --no-dev --preview-features sbom-export --format cyclonedx1.5 --package $$package \
	    --output-file $(or $(OUT),dist)/$$package.cdx.json >/dev/null || exit 1; \
	done
	@cd frontend && npm sbom --sbom-format cyclonedx > "$(abspath $(or $(OUT),dist))/page.cdx.json"

clean:  ## Remove what set-up made; data stays
	rm -rf .venv .make frontend/node_modules frontend/dist frontend/src/api/schema.gen.ts

.make/python: pyproject.toml packages/soundlist/pyproject.toml uv.lock
	@mkdir -p .make
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "Python 3.11 or newer is needed: PYTHON=/path/to/python make"; exit 1; }
	@$(PYTHON) -m venv .venv || { echo "Python lacks venv: apt-get install python3-venv"; exit 1; }
	@echo "Installing Python packages" && $(BIN)/python .ci/locked.py uv >.make/uv.txt
	@$(BIN)/pip install --quiet --disable-pip-version-check --require-hashes --only-binary :all: --requirement .make/uv.txt
	@$(UV) sync --frozen --no-build --no-install-workspace --all-packages
	@printf '#!/bin/sh\nPYTHONPATH="%s" exec "%s/.venv/bin/python" -P -m app "$$@"\n' "$(CURDIR)" "$(CURDIR)" > $(BIN)/soundlist
	@chmod +x $(BIN)/soundlist
	@touch $@

.make/librosa: .make/kernel
	@echo "Compiling librosa's loops"  # once: each process that found none would take half a minute for its own
	@$(BIN)/python -c 'import librosa.core.spectrum, librosa.feature.spectral'
	@touch $@

.make/peers: .make/python
	@$(UV) sync --frozen --inexact --no-install-workspace --group bench || echo "some peers cannot be installed; the tables say which"
	@for peer in sox loudgain; do command -v $$peer >/dev/null || sh .ci/install $$peer || true; done
	@touch $@

.make/kernel: .make/python setup.py $(wildcard audio_checks/kernel/*.c audio_checks/kernel/*.h)
	@echo "Compiling the kernel" && $(UV) pip install --python $(BIN)/python --no-deps --no-build-isolation --editable .
	@touch $@

.make/node: frontend/package-lock.json
	@mkdir -p .make
	@command -v node >/dev/null || { echo "Node 20.19 or newer is needed"; exit 1; }
	@echo "Installing frontend packages" && cd frontend && npm ci --silent --no-audit --no-fund
	@touch $@

.make/page: .make/node frontend/index.html frontend/vite.config.ts $(shell find frontend/src frontend/public -type f -not -name '*.gen.ts' 2>/dev/null)
	@echo "Building the frontend" && cd frontend && npm run --silent build -- --logLevel error
	@touch $@

.make/help: .make/python .make/page zensical.toml .ci/docs_site.py $(shell find docs -type f)
	@echo "Building the guides" && $(BIN)/python .ci/docs_site.py
	@touch $@

frontend/src/api/schema.gen.ts: .make/node frontend/openapi.json frontend/scripts/gen.mjs
	@echo "Writing the frontend's types" && cd frontend && npm run --silent gen

.make/postgresql:
	@mkdir -p .make
	@ls /usr/lib/postgresql/*/bin/postgres >/dev/null 2>&1 || command -v postgres >/dev/null || \
	  { echo "Installing PostgreSQL" && sh .ci/install postgresql; }
	@touch $@

.make/s3: .ci/s3 .ci/go-program
	@mkdir -p .make
	@PYTHON=$(PYTHON) nohup .ci/s3 >$@ 2>.make/s3.log </dev/null &  # takes minutes the first time; the tests that need it wait

.make/caddy: .ci/caddy .ci/go-program
	@mkdir -p .make
	@PYTHON=$(PYTHON) .ci/caddy >$@

.make/browser: | .make/postgresql  # not at once: the system installs for one at a time
	@mkdir -p .make
	@command -v chromium >/dev/null || { echo "Installing Chromium" && sh .ci/install chromium; }
	@touch $@
