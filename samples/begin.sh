# Sourced by run.sh of samples 05 and on, with its arguments [PACKSTONE [FOLDER]]: sets here, packstone and folder, and
# runs the scene.
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd)
packstone=${1:-packstone}
folder=${2:-runs/$(basename "$here")}
"$packstone" run "$here/scene.toml" -o "$folder" --overwrite
