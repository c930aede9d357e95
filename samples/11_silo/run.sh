#!/usr/bin/env bash
# Sample 11 and its floor load beside Janssen's: run.sh [PACKSTONE [FOLDER]]
set -euo pipefail
. "$(dirname "$0")/../begin.sh"
"$packstone" render "$folder" -o "$folder/silo.png"
/usr/bin/python3 "$here/janssen.py" "$folder"
