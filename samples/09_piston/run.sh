#!/usr/bin/env bash
# Sample 09 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" --at t=0.55 -o "$folder/pressed.png"
