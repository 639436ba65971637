# The two commands of the README, and the developer's habits. Needs Debian 12 (or the same packages elsewhere).
#
#   make demo       install what is missing, build, triangulate the real data sets into out/
#   make test       install what is missing, build, run all tests, and a part of them under sanitizers
#   make sanitize   all tests under the address and undefined-behaviour sanitizers
#   make tsan       all tests under the thread sanitizer
#   make wide       all tests with 64-bit ids
#   make fuzz       every fuzz target for FUZZ_SECONDS (60)
#   make bench      measure against CGAL, Qhull and nanoflann, write bench/*.md
#   make bench-worker   what `delone bench peers` runs: Delone, CGAL and Qhull in one program, tuned for this machine
#   make coverage   lines that the tests reach, as build-coverage/coverage.txt
#   make lint       clang-tidy over the sources that changed since BASE (all when BASE is empty)
#   make format     clang-format over the sources;  make clean removes every build directory

JOBS ?= $(shell scripts/jobs)
FUZZ_SECONDS ?= 60
BASE ?= origin/main

build = cmake --preset $(1) --log-level=WARNING && cmake --build --preset $(1) -j $(JOBS) $(if $(2),--target $(2))

.PHONY: all demo test sanitize tsan wide fuzz bench bench-worker coverage lint format clean
all:
	@scripts/setup build
	@$(call build,release,delone_app)

demo: all
	@scripts/demo build/delone

test:
	@scripts/setup build test
	@$(call build,dev)
	@$(call build,asan-ubsan-quick,delone_tests)
	@scripts/run_tests build-dev build-asan-ubsan-quick:-L,fast

sanitize:
	@scripts/setup build test
	@$(call build,asan-ubsan)
	@scripts/run_tests build-asan-ubsan

tsan:
	@scripts/setup build test
	@$(call build,tsan)
	@setarch --addr-no-randomize scripts/run_tests build-tsan

wide:
	@scripts/setup build test
	@$(call build,wide)
	@scripts/run_tests build-wide

fuzz:
	@scripts/setup build fuzz
	@$(call build,fuzz)
	@scripts/fuzz build-fuzz $(FUZZ_SECONDS)

bench:
	@scripts/setup build bench
	@$(call build,bench)
	@$(call build,bench-portable)
	@scripts/bench

bench-worker:
	@scripts/setup build bench
	@$(call build,bench,bench_worker)

coverage:
	@scripts/setup build test tools
	@$(call build,coverage)
	@scripts/run_tests build-coverage
	@gcovr --root . --object-directory build-coverage --filter include/ --filter src/ --filter app/ \
	  --gcov-executable gcov --output build-coverage/coverage.txt
	@tail -n 3 build-coverage/coverage.txt

lint:
	@scripts/setup build test tools
	@cmake --preset dev --log-level=WARNING
	@scripts/lint build-dev $(BASE)

format:
	@scripts/setup tools
	@git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format-14 -i

clean:
	@rm -rf build build-*
