# SPDX-FileCopyrightText: 2026 The survtrack developers
# SPDX-License-Identifier: Apache-2.0
# Short names for scripts/. Each target sets up what it needs: a fresh Debian 12 with Python 3.11
# and make is enough. PYTHON=... names another Python.
.DEFAULT_GOAL := help
.PHONY: help setup demo test bench docs stubs lint clean

help: ## Show these targets
	@grep -E '^[a-z]+:.*##' Makefile | sed -E 's/:.*## /\t/' | expand -t 10

setup: ## Install Debian's packages, make .venv, build survtrack
	@bash scripts/setup.sh

demo: ## Track people in real footage; leaves a video and a contact sheet in demo/out
	@bash scripts/demo.sh

test: ## Lint, types, C++ and Python tests, sanitizers, documentation
	@bash scripts/test.sh

bench: ## Measure against OpenCV's way of doing it
	@bash scripts/bench.sh $(ARGS)

docs: ## Build the documentation into site/
	@bash scripts/docs.sh

stubs: setup ## Write what is made from the code: type stubs and the options reference
	@.venv/bin/python scripts/make_stubs.py
	@.venv/bin/python scripts/make_reference.py

lint: ## Check style and types only
	@bash scripts/lint.sh

clean: ## Remove what was built (keeps .venv and the demo's footage)
	rm -rf build site demo/out .mypy_cache .pytest_cache .ruff_cache .hypothesis
