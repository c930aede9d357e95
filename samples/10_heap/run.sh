#!/usr/bin/env bash
# Sample 10, its picture and its slope: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/10_heap}

"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
"$packstone" render "$folder" -o "$folder/heap.png"
/usr/bin/python3 "$here/slope.py" "$folder"
