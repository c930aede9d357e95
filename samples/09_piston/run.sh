#!/usr/bin/env bash
# Sample 09 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/09_piston}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" --at t=0.55 -o "$folder/pressed.png"
