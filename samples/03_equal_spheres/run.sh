#!/usr/bin/env bash
# Sample 03: run.sh [PACKSTONE [RUN_FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
run=${2:-runs/03_equal_spheres}

"$packstone" run "$here/scene.toml" -o "$run" --overwrite
"$packstone" analyze "$run" --only packing --json "$run/measures.json" --csv "$run/tables" > "$run/measures.txt"
head -n 8 "$run/measures.txt"

cat <<END

Results in $run:
  measures.txt .json tables/   the packing, for people and programs
  snapshots/                   for ParaView (5.10 on): open snapshots.vtkhdf.series
END
