#!/bin/sh
# Everything that must pass before a change lands: installs what is missing, builds, and runs all tests, once with the sanitizers and
# once as users build. Works from any folder and in a fresh clone. LADDERC_JOBS: compilers and tests side by side, default 2.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
jobs=${LADDERC_JOBS:-2}
started=$(date +%s)

# Where ccache is installed, objects of another clone count too.
export CCACHE_BASEDIR="$root" CCACHE_NOHASHDIR=1

step() {
  echo
  echo "== $(($(date +%s) - started)) s: $*"
}

step "Packages"
sh cmake/packages.sh

step "Building with AddressSanitizer and UndefinedBehaviorSanitizer"
cmake --preset sanitize
cmake --build --preset sanitize -j "$jobs"

step "Building as users do"
cmake --preset default
cmake --build --preset default -j "$jobs"

step "Tests with the sanitizers"
ctest --preset sanitize -j "$jobs"

# Last, so that the run closes with the count of all tests.
step "Tests"
ctest --preset default -j "$jobs"
