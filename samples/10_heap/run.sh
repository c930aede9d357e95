#!/usr/bin/env bash
# Sample 10, its picture and its slope: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" -o "$folder/heap.png"
/usr/bin/python3 "$here/slope.py" "$folder"
