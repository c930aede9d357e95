#!/usr/bin/env bash
# Sample 02, one mixture: run.sh [PACKSTONE [RUN_FOLDER [SMALL_PER_BIG [BIG]]]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
ratio=${3:-300}
big=${4:-100}
run=${2:-runs/02_binary_packing/ratio_$ratio}

"$packstone" run "$here/scene.toml" -o "$run" --overwrite \
  --set "particles[0].count=$big" --set "particles[1].count=$((ratio * big))"
"$packstone" analyze "$run" --only packing --json "$run/measures.json" --csv "$run/tables" > "$run/measures.txt"
head -n 8 "$run/measures.txt"

cat <<END

Results in $run:
  measures.txt .json tables/   the packing, for people and programs
  snapshots/                   for ParaView (5.10 on): open snapshots.vtkhdf.series
END
