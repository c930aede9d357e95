#!/usr/bin/env bash
# Sample 05 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" --at t=1.0 -o "$folder/discharge.png"
"$packstone" slice "$folder" --plane y=0 --at t=1.0 --color speed -o "$folder/cut.png"
