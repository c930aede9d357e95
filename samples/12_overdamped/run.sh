#!/usr/bin/env bash
# Sample 12: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" analyze "$folder" --only packing --json "$folder/measures.json"
