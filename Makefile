# SPDX-License-Identifier: BSD-3-Clause
# One-word commands over CMakePresets.json and scripts/; `make help` lists them.

PREFIX ?= /usr/local
JOBS ?= $(shell nproc)
FUZZ_SECONDS ?= 600
BOXPLUS_DATA ?= ../shared/data

.DEFAULT_GOAL := help
.PHONY: help setup build python demo test bench dev asan ubsan tsan sanitize arm64 arm64-light libcxx sanitize-changes tidy tidy-changes format check house fuzz page page-check ci ci-full install packages clean

help: ## this list
	@sed -n 's/^\([a-z0-9]*\):.*## \(.*\)/make \1\t\2/p' $(MAKEFILE_LIST) | expand -t 16

setup: ## installs the Debian packages that are missing (root or sudo)
	@scripts/install_dependencies.sh

build: setup ## builds the programs into build/release/bin
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS) --target programs

python: setup ## builds the Python module into build/release/python
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS) --target boxplus_python
	@echo "to use it: export PYTHONPATH=$(CURDIR)/build/release/python"

demo: setup ## simulates a sphere of 2500 poses, optimizes it, draws it before and after
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS) --target boxplus_command
	@scripts/demo.sh

test: setup ## builds everything and runs all tests
	@scripts/page_tools.sh || echo "boxplus: the tests of the viewer's page in a browser will be skipped"
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS)
	@ctest --preset release --parallel $(JOBS)

bench: setup ## measures boxplus, CHOLMOD and Ceres, and writes bench/RESULTS.md
	@scripts/install_dependencies.sh scripts/debian-packages-bench.txt
	@cmake --preset bench
	@cmake --build --preset bench --parallel $(JOBS) --target benchmarks boxplus_command boxplus_python
	@build/bench/bin/graph_file_bench
	@build/bench/bin/dense_kernels_bench
	@build/bench/bin/inertial_bench
	@build/bench/bin/live_step_bench
	@OMP_THREAD_LIMIT=1 OPENBLAS_NUM_THREADS=1 build/bench/bin/dataset_bench "$(BOXPLUS_DATA)" \
	  "$$(git describe --always --dirty)" > build/bench/RESULTS.md
	@build/bench/bin/smoother_bench "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@build/bench/bin/covariance_bench "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@build/bench/bin/outlier_bench "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@OMP_THREAD_LIMIT=1 OPENBLAS_NUM_THREADS=1 build/bench/bin/edge_bench >> build/bench/RESULTS.md
	@OMP_THREAD_LIMIT=1 OPENBLAS_NUM_THREADS=1 build/bench/bin/bundle_bench "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@build/bench/bin/g2o_api_bench >> build/bench/RESULTS.md
	@scripts/page_tools.sh
	@node bench/viewer/viewer_bench.mjs build/bench/bin/boxplus "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@PYTHONPATH=build/bench/python OMP_THREAD_LIMIT=1 OPENBLAS_NUM_THREADS=1 /usr/bin/python3 bench/python/python_bench.py \
	  build/bench/bin/boxplus "$(BOXPLUS_DATA)" >> build/bench/RESULTS.md
	@mv build/bench/RESULTS.md bench/RESULTS.md

dev asan ubsan tsan: setup
	@cmake --preset $@
	@cmake --build --preset $@ --parallel $(JOBS)
	@ctest --preset $@ --parallel $(JOBS)

dev: ## runs the tests with asserts
asan: ## runs the tests under AddressSanitizer
ubsan: ## runs the tests under UndefinedBehaviorSanitizer
tsan: ## runs the tests under ThreadSanitizer

sanitize: setup ## builds the library and the core suites with clang++, ASan and UBSan, and runs them
	@cmake --preset sanitize
	@cmake --build --preset sanitize --parallel $(JOBS) --target core_suites
	@ctest --preset sanitize-core --parallel $(JOBS)

sanitize-changes: setup ## the same for the core suites that the changes since SINCE (the main branch) may have touched
	@JOBS=$(JOBS) scripts/sanitize_changes.sh $(SINCE)

arm64: setup ## builds for 64-bit ARM, and runs the core suites and the command on the public graphs under qemu
	@scripts/install_dependencies.sh scripts/debian-packages-arm64.txt
	@cmake --preset arm64
	@cmake --build --preset arm64 --parallel $(JOBS) --target core_suites boxplus_command
	@ctest --preset arm64 --parallel $(JOBS)

arm64-light: setup ## builds the library for 64-bit ARM, and runs the tests of the kernels and the public pose graphs under qemu
	@scripts/install_dependencies.sh scripts/debian-packages-arm64.txt
	@cmake --preset arm64-light
	@cmake --build --preset arm64-light --parallel $(JOBS) --target kernels_test graph_optimum
	@ctest --preset arm64-light --parallel $(JOBS)

libcxx: setup ## builds with clang++ and libc++, and runs the core suites and the command on the public graphs
	@scripts/install_dependencies.sh scripts/debian-packages-libcxx.txt
	@cmake --preset libcxx
	@cmake --build --preset libcxx --parallel $(JOBS) --target core_suites boxplus_command examples
	@ctest --preset libcxx --parallel $(JOBS)

tidy: setup ## builds with clang++ and runs clang-tidy over every source
	@cmake --preset tidy
	@cmake --build --preset tidy --parallel $(JOBS)

tidy-changes: ## runs clang-tidy over the sources that changed since SINCE (the main branch); after make sanitize
	@scripts/tidy_changes.sh $(SINCE)

format: ## formats all C++ files
	@scripts/check_format.sh --fix

check: ## checks the format, the direction of includes, the tests of the guarantees, and words in comments and documents
	@scripts/check_format.sh
	@scripts/check_includes.py
	@scripts/check_sources.py
	@scripts/check_guarantees.py
	@scripts/count_words.py --check

house: ## measures the sources: lengths of files and functions, circles of includes, types, literals, casts
	@scripts/house.py

fuzz: setup ## feeds the readers mutated files for FUZZ_SECONDS (600) each
	@cmake --preset sanitize
	@cmake --build --preset sanitize --parallel $(JOBS) --target fuzzers
	@fuzz/run.sh $(FUZZ_SECONDS)

page: ## builds the viewer's page anew
	@scripts/page_tools.sh
	@npm --prefix viewer/page run --silent build

page-check: ## checks the types of the viewer's page, and that its file is what the sources give
	@scripts/page_tools.sh
	@npm --prefix viewer/page run --silent check

ci: ## everything that a change must pass
	@.ci/run

ci-full: export CI_SECONDS = 1000000
ci-full: ci ## and all suites under each sanitizer, and clang-tidy over every source
	@cmake --build --preset sanitize --parallel $(JOBS)
	@ctest --preset sanitize --parallel $(JOBS)
	@$(MAKE) tsan tidy

install: build ## installs headers, library, programs and CMake package under PREFIX (/usr/local)
	@cmake --install build/release --prefix $(PREFIX)

packages: setup ## makes Debian packages in build/release/packages; with ARCH=arm64, for 64-bit ARM in build/arm64/packages
	@$(if $(ARCH),scripts/install_dependencies.sh scripts/debian-packages-$(ARCH).txt)
	@cmake --preset $(or $(ARCH),release)
	@cmake --build --preset $(or $(ARCH),release) --parallel $(JOBS) --target packaged
	@cpack --config build/$(or $(ARCH),release)/CPackConfig.cmake
	@ls build/$(or $(ARCH),release)/packages/*.deb

clean: ## removes build/
	@rm -rf build
