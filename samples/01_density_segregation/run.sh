#!/usr/bin/env bash
# Sample 01 from the scene to the report: run.sh [PACKSTONE [RUN_FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
run=${2:-runs/01_density_segregation}

"$packstone" run "$here/scene.toml" -o "$run" --overwrite
"$packstone" analyze "$run" --json "$run/measures.json" --csv "$run/tables" > "$run/measures.txt"
"$packstone" render "$run" -o "$run/packing.mp4" --size 1280x720
"$packstone" render "$run" --at last --camera iso -o "$run/final.png"
"$packstone" render "$run" --at last --camera top --size 1200x1200 -o "$run/top.png"
"$packstone" render "$run" --at last --camera bottom --size 1200x1200 -o "$run/bottom.png"
"$packstone" slice "$run" --plane "y=0.293 m" -o "$run/slice.png"
"$packstone" plot "$run" --what energy,account,packing,coordination,composition,profile -o "$run/plots"
"$packstone" report "$run" -o "$run/report.html"

cat <<END

Results in $run:
  packing.mp4                  the run as an animation
  final.png top.png bottom.png the bed at the end, from the side, above and below
  slice.png                    vertical cut
  plots/                       energies, packing fraction, contacts, composition and profile
  measures.txt .json tables/   every number, for people and programs
  report.html                  all of it on one page
  snapshots/                   for ParaView (5.10 on): open snapshots.vtkhdf.series
END
