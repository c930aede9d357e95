#!/usr/bin/env bash
# Sample 02 over the mixture, the paper's figure 4: curve.sh [PACKSTONE [FOLDER [BIG]]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/02_binary_packing}
big=${3:-100}

for ratio in 10 100 200 300 500; do
  "$here/run.sh" "$packstone" "$folder/ratio_$ratio" "$ratio" "$big"
done
"$packstone" plot "$folder"/ratio_* --what mixture -o "$folder/mixture.png"
echo "The curve: $folder/mixture.png"
