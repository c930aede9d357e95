#!/usr/bin/env bash
# Sample 11 and its floor load beside Janssen's: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/11_silo}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" -o "$folder/silo.png"
/usr/bin/python3 "$here/janssen.py" "$folder"
