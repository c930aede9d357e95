#!/usr/bin/env bash
# Sample 07 and a cut through it: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/07_wavy_floor}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" -o "$folder/waves.png"
"$packstone" slice "$folder" --plane y=0.001 -o "$folder/cut.png"
