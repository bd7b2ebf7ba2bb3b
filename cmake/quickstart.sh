#!/bin/sh
# From a fresh Debian 12 to a mnemonic list that runs: installs what is missing, builds ladderc, compiles a sample to a native program
# and runs it for some seconds of its own clock with buttons pressed. Works from any folder. LADDERC_JOBS: compilers side by side,
# default 2.
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

echo "== Packages"
sh cmake/packages.sh

echo "== Building ladderc"
cmake --preset default
cmake --build --preset default -j "${LADDERC_JOBS:-2}" --target ladderc ladderc_bin_link

list=samples/conveyor/conveyor.il
program=build/quickstart/conveyor
mkdir -p build/quickstart

echo
echo "== What is suspicious in $list?"
build/bin/ladderc check "$list"

echo
echo "== $list as a native program"
build/bin/ladderc build "$list" -o "$program"
ls -l "$program"

# X1 stop (normally closed), X2 emergency stop chain, X5 motor protection; X0 start is pressed in scan 5 and X8, a bottle, comes with it;
# the stop button opens X1 in scan 60. Y44 horn, Y40 belt motor, Y46 run lamp, M1 line is on, T0 the horn's timer.
inputs=X1=1,X2=1,X5=1,X0=1@5,X8=1@5,X0=0@6,X1=0@60
echo
echo "== Running it with --set=$inputs"
"$program" --virtual --scan-time=100ms --scans=80 --set="$inputs" --watch=X0,X1,M1,T0,Y44,Y40,Y46

echo
echo "It works. Next: build/bin/ladderc run $list --stimulus=random:1 --watch=Y40,D100"
