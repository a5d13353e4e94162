# The main targets. Each one does its whole set-up: packages, configuration, build.
#   make run      drives the shipped line with the on-board unit; report in out/run/
#   make test     all tests
#   make cab      a driver's cab as one page for the browser: out/cab/cab.html
#   make test-cab the tests of that page: node, and whole journeys by presses in headless Chromium and Firefox
#   make bench-cab  what that page costs: size, times real time, the main thread for each frame
#   make python   the Python package: build/python/python, for PYTHONPATH; `make test-python` tests it
#   make pictures the pictures of the display and of the cab in docs/images/
#   make cluster  evc-mpi, the sweep by the ranks of a cluster (Open MPI): build/cluster/evc-mpi
#   make test-cluster  its tests: mpirun on this machine, and a Slurm of one node that the test starts and ends
#   make bench    benchmarks and instruction counts
#   make reactions  reaction times in simulated and in real time, with their margins to SUBSET-041
#   make real-time  a run by the clock beside a busy core: SECONDS_EACH=600 at CYCLES="100 10" ms; no cycle of 100 ms missed
#   make fuzz     every fuzz target for a minute
#   make clean    removes build/ and out/
# Longer campaigns, minutes to hours: make campaign-fuzz, make campaign-lines, make campaign-journeys, make campaign-properties, make campaign-exploration, make campaign-mutants, make campaign-cab
# LINE=file.json RUN_ARGS="--driver reckless" are passed to `evc run`, LINE=file.json CAB_ARGS="--train file.json" to `evc cab`.

SHELL := /bin/bash
JOBS ?= $(shell nproc)
LINE ?=
RUN_ARGS ?=
export JOBS

.PHONY: help run cab test-cab pictures bench-cab campaign-cab python test-python cluster test-cluster test bench reactions real-time fuzz clean evc campaign-fuzz campaign-lines campaign-journeys campaign-properties campaign-exploration campaign-mutants

help:
	@sed -n '2,/^$$/s/^# \{0,1\}//p' Makefile

evc:
	@tools/setup build
	@tools/build release evc

run: evc
	@mkdir -p out/run
	build/release/evc run $(LINE) $(RUN_ARGS) -o out/run
	@echo "report: $(CURDIR)/out/run/report.html"

cab: evc
	@tools/setup cab
	@tools/build_cab
	@mkdir -p out/cab
	build/release/evc cab $(LINE) $(CAB_ARGS) -o out/cab/cab.html
	@echo "page: $(CURDIR)/out/cab/cab.html"

test-cab: evc
	@tools/setup cab
	@tools/build_cab test
	node --test build/web/test

bench-cab: evc
	@tools/setup cab
	@tools/build_cab test
	node --test build/web/bench/*.mjs

cluster:
	@tools/setup build cluster
	@tools/build cluster evc evc-mpi

test-cluster:
	@tools/setup build test cluster
	@tools/build cluster evc evc-mpi cluster_test
	ctest --preset cluster

python:
	@tools/setup build python
	@tools/build python evc openevc_python
	@echo "package: PYTHONPATH=$(CURDIR)/build/python/python; cmake --install build/python --component python installs it"

test-python: python
	@tools/test_python

pictures: cab
	@tools/setup report
	@tools/make_pictures

test:
	@tools/setup build test
	@tools/build dev
	ctest --preset dev -j $(JOBS)

bench:
	@tools/setup build bench
	@tools/build release evc benches
	@tools/run_benches

reactions:
	@tools/setup build
	@tools/build release evc reactions
	@build/release/benches/reactions $(or $(TIMES),20)

real-time: evc
	@tools/measure_real_time $(or $(SECONDS_EACH),600) $(or $(CYCLES),100 10)

fuzz:
	@tools/setup build fuzz
	@tools/check_fuzz $(or $(SECONDS_EACH),60)

# Each fuzz target with RUNS inputs.
campaign-fuzz:
	@tools/setup build fuzz
	@RUNS=$(or $(RUNS),20000000) tools/check_fuzz 0

# Reckless drivers on a line with the last authority at every place in turn, and many seeds.
campaign-lines: evc
	@tools/campaign_lines $(LINE) --runs $(or $(RUNS),1000)

# Random journeys: drivers, odometers at their limits, missing balises.
campaign-journeys: evc
	@tools/campaign_journeys.py --journeys $(or $(RUNS),3000)

# Properties of braking curves and limits over CASES random trains, tracks and targets; the track description against a
# model of every metre over DATABASES random sequences of messages.
campaign-properties:
	@tools/setup build test
	@tools/build dev sdm_test track_test
	EVC_CASES=$(or $(DATABASES),10000) build/dev/src/track/track_test --gtest_filter='Metres.*'
	EVC_CASES=$(or $(CASES),100000) build/dev/src/sdm/sdm_test --gtest_filter='Properties.*'

# All orders of DEPTH abstract inputs from power-up, then STATES states of each edition (docs/exploration.md).
campaign-exploration:
	@tools/setup build test
	@tools/build dev exploration_test
	EVC_DEPTH=$(or $(DEPTH),2) EVC_STATES=$(or $(STATES),10000) build/dev/tests/exploration/exploration_test

# Mutation test of a ROOM. MUTANTS="--rows" or "--sample 500" instead of all.
campaign-mutants:
	@tools/setup build test
	@tools/mutate.py $(or $(ROOM),sdm) $(MUTANTS)

# The page of `evc cab`: the passage of the recorded line by presses, and SECONDS_EACH of pressing at random with SEED.
campaign-cab: evc
	@tools/setup cab
	@tools/build_cab test
	SECONDS_EACH=$(or $(SECONDS_EACH),60) SEED=$(or $(SEED),1) node --test build/web/campaign/*.mjs build/web/test/random.test.mjs

clean:
	rm -rf build out
