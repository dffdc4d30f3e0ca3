# SPDX-License-Identifier: Apache-2.0
# The front door: each target works as the first command in a clean checkout and installs what is
# missing (tools/install-packages). The build itself is CMake's, in build/.
#
#     make run      runs scenes/pilot-mill.yaml; figures and pictures in out/pilot-mill/;
#                   one that was stopped goes on
#     make test     runs the tests
#     make validate runs the validation cases and writes docs/validation.md; half an hour at most
#     make validate-mills  runs slices of the reference document's mills and writes
#                   docs/validation-mills.md; an hour on two free cores
#     make build    builds build/quern
#     make install  [PREFIX=/usr/local] [DESTDIR=]
#     make bench    runs the benchmarks
#     make format   formats the sources
#     make clean    removes build/
MAKEFLAGS += --no-print-directory
BUILD := build
JOBS ?= $(shell nproc)
CONFIGURE = cmake -S . -B $(BUILD) $(CMAKE_FLAGS)
PILOT := out/pilot-mill
RUN_PILOT = $(BUILD)/quern run scenes/pilot-mill.yaml -o $(PILOT)
COMPILE = cmake --build $(BUILD) --parallel $(JOBS)

.PHONY: build run test validate validate-mills install bench format clean configure

configure:
	@tools/install-packages build
	@$(CONFIGURE)

build: configure
	@$(COMPILE) --target quern

run: build
	@if grep -qs '"finished": false' $(PILOT)/summary.json; then \
	    echo "$(PILOT)/ holds a run that was stopped: going on with it."; $(RUN_PILOT) --resume; \
	else \
	    test ! -e $(PILOT) || echo "$(PILOT)/ exists: this run replaces it."; $(RUN_PILOT) --force; \
	fi

test: configure
	@$(COMPILE)
	ctest --test-dir $(BUILD) --parallel $(JOBS) --output-on-failure --no-label-summary \
	      --no-tests=error --label-exclude validation-long

validate: configure
	@$(COMPILE)
	@/usr/bin/python3 validation/report.py $(BUILD) --jobs $(JOBS)

validate-mills: build
	@/usr/bin/python3 validation/mills.py $(BUILD)

install: build
	@cmake --install $(BUILD) $(if $(PREFIX),--prefix $(PREFIX))

bench: configure
	@$(COMPILE) --target bench

format:
	@tools/install-packages format
	@tools/check-format --fix

clean:
	rm -rf $(BUILD)
