#!/bin/sh
# Installs the Debian packages that are needed to build and test ladderc, as far as they are missing. Sourced by test.sh and
# quickstart.sh, or run by itself. Needs root or sudo only where something is missing.
set -eu

# The C++ compiler is g++; clang++ compiles the generated programs in the tests. zstd, curl and zlib are what LLVM's CMake package asks
# for.
packages="
  g++ clang binutils make cmake ninja-build
  llvm-19-dev libzstd-dev libcurl4-openssl-dev zlib1g-dev
  libfmt-dev nlohmann-json3-dev
  libgtest-dev libgmock-dev
"

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

if ! command -v dpkg-query >/dev/null; then
  echo "This is no Debian: see to it yourself that these are there, by whatever names:" $packages >&2
else
  missing=
  for package in $packages; do
    is_installed "$package" || missing="$missing $package"
  done
  if [ -n "$missing" ]; then
    echo "Installing:$missing"
    as_root=
    if [ "$(id -u)" -ne 0 ]; then
      command -v sudo >/dev/null || { echo "Run this as root, or install sudo: packages are missing." >&2; exit 1; }
      as_root=sudo
    fi
    $as_root apt-get update -q
    # shellcheck disable=SC2086  # a list of words
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing
  fi
fi
