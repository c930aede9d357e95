#!/usr/bin/env bash
# The studies of docs/tradeoff.md, an hour and a half on one core: tradeoff.sh [PACKSTONE [FOLDER [NAME...]]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-$here/../build/packstone}
folder=${2:-$here/../build/tradeoff}
wanted=" ${*:3} "
export GOMP_SPINCOUNT=2000

study() {  # NAME ARGUMENTS...
  local name=$1
  shift
  if [ "$wanted" != "  " ] && [[ "$wanted" != *" $name "* ]]; then return; fi
  echo "== $name"
  "$packstone" tradeoff "$@" --quiet --threads 1 --seeds "${seeds:-3}" -o "$folder/$name" && cat "$folder/$name/tradeoff.md"
}

samples=$here/../samples
# Takes longer on a busy machine; fewer seeds: seeds=2 tradeoff.sh. Frictionless steel spheres from a dilute start: the bed at rest.
study rest "$here/studies/equal.toml" --title "Steel spheres without friction" --reference "as is" --vary 'dynamics.goal="rest"' \
  --vary 'way 5e-4: dynamics.goal="rest"; dynamics.way_overlap=5e-4' --vary 'way 1e-2: dynamics.goal="rest"; dynamics.way_overlap=1e-2' \
  --vary 'balance 0.05: dynamics.goal="rest"; dynamics.unbalanced_force=0.05' --vary 'balance 0.01: dynamics.goal="rest"; dynamics.unbalanced_force=0.01' \
  --vary stiffness=0.1,0.01 --vary step=2 --tolerance packing_fraction=0.002
# The same with friction.
friction=(--set 'contact.tangential="cundall-strack"' --set material[0].friction=0.5 --set material[0].tangential_stiffness=1e7
  --set dynamics.duration=1.2 --set particles[0].count=2000 --set 'domain.max=[0.104,0.104,0.312]')
study friction "$here/studies/equal.toml" "${friction[@]}" --title "Steel spheres with friction" --vary 'dynamics.goal="rest"' --vary stiffness=0.1,0.01,0.001 \
  --vary step=0.5,2 --vary 'dynamics.precision="mixed"' --tolerance packing_fraction=0.002
# The first paper's steps and laws, sample 01.
study segregation "$samples/01_density_segregation/scene.toml" --measure packing_fraction,coordination,lacey --reference "time_step 5 us" \
  --vary 'dynamics.time_step="5 us","10 us","20 us","100 us"' --vary stiffness=0.1,0.01 --vary 'dynamics.precision="mixed"' \
  --vary 'dynamics.goal="rest"' \
  --vary 'linear: contact.normal="linear"; material[0].normal_damping=239; material[1].normal_damping=609' \
  --tolerance packing_fraction=0.002
# Sample 02 at a reduced size: 20 big spheres, 6000 small ones; five minutes with seeds=2.
study binary "$samples/02_binary_packing/scene.toml" --set particles[0].count=20 --set particles[1].count=6000 --set dynamics.duration=1.2 \
  --reference "time_step 5 us" --vary 'dynamics.time_step="5 us","20 us"' --vary stiffness=0.1,0.01 --vary 'dynamics.goal="rest"' \
  --tolerance packing_fraction=0.005
# A frictional heap, sample 10 with a third of its beads; its height.
study heap "$samples/10_heap/scene.toml" --set particles[0].count=2000 --set dynamics.duration=1.5 --measure surface.surface_highest \
  --vary 'dynamics.time_step="7.5 us","30 us"' --vary stiffness=10,0.1 --vary 'dynamics.precision="mixed"' \
  --vary 'haff-werner: contact.tangential="haff-werner"; material[0].tangential_damping=0.5' --vary 'friction 0.3: material[0].friction=0.3'
# The second paper's cylinder, sample 12 with a quarter of its spheres, ten times softer, to a balance of 1e-3.
study cylinder "$samples/12_overdamped/scene.toml" --set particles[0].count=500 --set material[0].normal_stiffness=1e3 --set dynamics.rest_force=1e-3 \
  --set dynamics.duration=200 --set monitor.overlap_limit=0.5 --set output.interval=100 --reference "integrator euler" \
  --vary 'dynamics.integrator="euler","implicit"' --vary dynamics.tolerance=0.001,0.1 --vary 'dynamics.viscosity=0.37' \
  --tolerance packing_fraction=0.002
# Margins of neighbour lists.
study margin "$here/studies/equal.toml" --set particles[0].count=1000 --set 'domain.max=[0.0833,0.0833,0.25]' --set dynamics.duration=0.5 \
  --set output.interval=0.5 --title "Margins of neighbour lists" --reference "as is" --vary dynamics.list_margin=0.01,0.03,0.1,0.2,0.4,0.8
# Pictures and measures of sample 01's bed at rest.
bed=$folder/bed
of_bed() {  # NAME SEEDS ARGUMENTS...
  if [ "$wanted" != "  " ] && [[ "$wanted" != *" $1 "* ]]; then return; fi
  if [ ! -e "$bed/run.json" ]; then "$packstone" run "$samples/01_density_segregation/scene.toml" -o "$bed" --quiet; fi
  seeds=$2 study "$1" "$bed" "${@:3}"
}
of_bed picture 3 --picture --tolerance difference=0.6
of_bed fraction 16 --title "Bulk fraction of sample 01" --tolerance packing_fraction=0.001
of_bed surface 2 --measure surface.surface_volume
