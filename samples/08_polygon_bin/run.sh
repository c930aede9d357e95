#!/usr/bin/env bash
# Sample 08 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/08_polygon_bin}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" -o "$folder/bin.png"
"$packstone" slice "$folder" --plane y=0 -o "$folder/cut.png"
