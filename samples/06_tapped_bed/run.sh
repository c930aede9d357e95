#!/usr/bin/env bash
# Sample 06 and how its fraction grows: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/06_tapped_bed}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" plot "$folder" --what packing -o "$folder/packing.png"
"$packstone" render "$folder" -o "$folder/tapped.png"
