#!/usr/bin/env bash
# Sample 04, with attraction and without: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/04_cohesive_powder}

"$packstone" check "$here/scene.toml"
"$packstone" run "$here/scene.toml" -o "$folder/cohesive" --overwrite
"$packstone" run "$here/scene.toml" -o "$folder/free" --overwrite --set contact.van_der_waals.hamaker=1e-30 \
  --set title="The same without cohesion"
for run in "$folder/cohesive" "$folder/free"; do
  "$packstone" analyze "$run" --only packing,structure --json "$run/measures.json" > "$run/measures.txt"
done
"$packstone" analyze "$folder/cohesive" "$folder/free" --only packing,structure
