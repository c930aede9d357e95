#!/usr/bin/env bash
# Sample 06 and how its fraction grows: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" plot "$folder" --what packing -o "$folder/packing.png"
"$packstone" render "$folder" -o "$folder/tapped.png"
