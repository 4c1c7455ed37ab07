#!/bin/sh
# Makes the pictures of the README and of these pages anew: from the root of the tree, with furnas built, in half an hour.
# The runs stay in runs/; one that is there already, and at rest, is not made again.
set -e

run() { # folder case settings...
  folder=$1 case=$2
  shift 2
  [ -f "$folder/packing.png" ] || ./furnas run "cases/$case.toml" --out "$folder" "$@"
}

run runs/bidisperse_5 bidisperse_5
run runs/first_packing first_packing
run runs/mixed first_packing --set mixture.size_ratio=5.0 --set mixture.small_fraction=0.45 --set mixture.large=10

./furnas render runs/bidisperse_5 --size 900 --out docs/guide/images/bidisperse_5.png
./furnas render runs/first_packing --style chains --size 600 --out docs/guide/images/chains.png
./furnas render runs/mixed --colour rattlers --slice z=0.3:0.7 --size 600 --out docs/guide/images/rattlers.png
./furnas analyze runs/first_packing
cp runs/first_packing/pair_correlation.png docs/guide/images/
