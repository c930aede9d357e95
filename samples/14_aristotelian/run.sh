#!/usr/bin/env bash
# Sample 14, all mixtures with and without inertia, their measures, heights and pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/14_aristotelian}
/usr/bin/python3 "$here/study.py" "$packstone" "$folder"
"$packstone" plot "$folder/aristotelian_equal" "$folder/newtonian_equal" --what height -o "$folder/height.png"
snapshots() { for k in "${@:2}"; do printf '%s/snapshots/snapshot_%06d.vtkhdf\n' "$folder/$1" "$k"; done; }
look=(--camera front --cut "y<0" --color speed --columns 4 --size 1040x370)
"$packstone" render $(snapshots aristotelian_equal 2 4 6 8) -o "$folder/front.png" "${look[@]}" --range 0:1.05 \
  --titles "no inertia,no inertia,no inertia,no inertia"
"$packstone" render $(snapshots newtonian_equal 4 7 8 9) -o "$folder/bounce.png" "${look[@]}" --range 0:3 \
  --titles "inertia,inertia,inertia,inertia"
