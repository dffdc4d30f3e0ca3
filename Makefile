# SPDX-License-Identifier: Apache-2.0
# The front door: each target works as the first command in a clean checkout and installs what is
# missing (tools/install-packages). The build itself is CMake's, in build/.
#
#     make run      runs scenes/pilot-mill.yaml; figures and pictures in out/pilot-mill/
#     make test     runs the tests
#     make build    builds build/quern
#     make install  [PREFIX=/usr/local] [DESTDIR=]
#     make bench    runs the benchmarks
#     make format   formats the sources
#     make clean    removes build/
MAKEFLAGS += --no-print-directory
BUILD := build
JOBS ?= $(shell nproc)
CONFIGURE = cmake -S . -B $(BUILD) $(CMAKE_FLAGS)
COMPILE = cmake --build $(BUILD) --parallel $(JOBS)

.PHONY: build run test install bench format clean configure

configure:
	@tools/install-packages build
	@$(CONFIGURE)

build: configure
	@$(COMPILE) --target quern

run: build
	@test ! -e out/pilot-mill || echo "out/pilot-mill/ exists: this run replaces it."
	$(BUILD)/quern run scenes/pilot-mill.yaml -o out/pilot-mill --force

test: configure
	@$(COMPILE)
	ctest --test-dir $(BUILD) --parallel $(JOBS) --output-on-failure --no-label-summary \
	      --no-tests=error --label-exclude validation-long

install: build
	@cmake --install $(BUILD) $(if $(PREFIX),--prefix $(PREFIX))

bench: configure
	@$(COMPILE) --target bench

format:
	@tools/install-packages format
	@tools/check-format --fix

clean:
	rm -rf $(BUILD)
