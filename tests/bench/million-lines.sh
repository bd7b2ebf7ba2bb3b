#!/bin/sh
# How long `ladderc check` takes for a list of a million instructions, and how much memory.
set -eu
ladderc=${1:-build/bin/ladderc}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
awk 'BEGIN {
  for (i = 0; i < 166666; ++i) {
    printf "LD X%X\nOR Y%X\nANI M%d\nOUT M%d\n", i % 6144, i % 6144, (i * 7) % 6144, i % 6144
    printf "LD> D%d K%d\nMOV K%d D%d\n", i % 6000, i % 1000, i % 30000, (i * 3) % 6000
  }
  print "LD SM400\nOUT Y0\nNOP\nEND"
}' > "$folder/million.il"
wc -l < "$folder/million.il"
start=$(date +%s.%N)
"$ladderc" check -Wno-double-coil --stats "$folder/million.il"
end=$(date +%s.%N)
awk "BEGIN { printf \"%.2f s\\n\", $end - $start }"
python3 - "$ladderc" "$folder/million.il" <<'PY' 2>/dev/null || true
import resource, subprocess, sys
subprocess.run([sys.argv[1], "check", "-Wno-double-coil", sys.argv[2]], stderr=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024, "MiB at most")
PY
