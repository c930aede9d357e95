#!/usr/bin/env bash
# The pictures of gallery.md: gallery.sh [PACKSTONE [FOLDER]]. Runs the samples that the folder lacks.
set -euo pipefail
packstone=$(realpath "${1:-build/packstone}")
folder=$(realpath -m "${2:-runs}")
here=$(realpath "$(dirname "$0")")
samples=$here/../samples
pictures=$here/pictures

run() {
  [ -e "$folder/$1/run.json" ] || "$packstone" run "$samples/$1/scene.toml" -o "$folder/$1"
}
draw() {
  "$packstone" render "$folder/$1" -o "$pictures/gallery_$2.png" --size 800x640 --quiet "${@:3}"
}

run 01_density_segregation
run 05_funnel_discharge
run 09_piston
run 10_heap
draw 01_density_segregation bed --preset paper --cut "x>0.3,y<0.3" --cut-through
snapshots=$folder/01_density_segregation/snapshots
"$packstone" render "$snapshots/snapshot_000010.vtkhdf" "$snapshots/snapshot_000025.vtkhdf" \
  "$snapshots/snapshot_000150.vtkhdf" --titles "grown,falling,at rest" --occlusion 0.7 --size 1200x520 --quiet \
  -o "$pictures/gallery_panels.png"
draw 01_density_segregation chains --preset paper --chains
draw 05_funnel_discharge outflow --preset paper --at t=1.0 --camera front --zoom 6 --focus 0,0,0.115 \
  --arrows velocity --arrow-scale 1 --cut "y<-2 mm"
draw 05_funnel_discharge paths --preset paper --at t=1.0 --camera 30,12 --zoom 4 --focus 0,0,0.11 \
  --trajectories random:150 --tail 20 --color speed
draw 09_piston contacts --preset paper --at t=0.55 --contacts
draw 10_heap dark --preset dark --camera 20,25 --zoom 1.6 --color speed
