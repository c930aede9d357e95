#!/usr/bin/env bash
# Sample 07 and a cut through it: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" -o "$folder/waves.png"
"$packstone" slice "$folder" --plane y=0.001 -o "$folder/cut.png"
