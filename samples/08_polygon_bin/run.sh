#!/usr/bin/env bash
# Sample 08 and its pictures: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" -o "$folder/bin.png"
"$packstone" slice "$folder" --plane y=0 -o "$folder/cut.png"
