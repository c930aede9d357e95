#!/usr/bin/env bash
# Sample 13, its measures and the force chains of the bed at rest: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" analyze "$folder" --only packing,structure,time,forces --json "$folder/measures.json" --quiet
"$packstone" render "$folder" --chains -o "$folder/chains.png"
