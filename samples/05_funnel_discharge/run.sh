#!/usr/bin/env bash
# Sample 05 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/05_funnel_discharge}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" --at t=1.0 -o "$folder/discharge.png"
"$packstone" slice "$folder" --plane y=0 --at t=1.0 --color speed -o "$folder/cut.png"
