#!/bin/sh
# Measures the parity table of README.md on this machine and writes it between its markers: every scheme, kind of normals
# and partitioning, random factors per edge, on the project's own models and shapes.
set -eu
cd "$(dirname "$0")/.."

tessera=${1:-build/release/tessera}
swiftshader=/usr/lib/chromium/vk_swiftshader_icd.json
if [ -f "$swiftshader" ]; then
    export VK_ADD_DRIVER_FILES="$swiftshader"
fi
table=$(mktemp)
trap 'rm -f "$table"' EXIT
models="assets/rabbit.glb assets/figure.glb assets/pawn.glb assets/ball.glb assets/parrot.glb shape:torus shape:icosahedron"
{
    printf 'Measured by `tessera verify %s --all --factor random:1..9 --markdown`:\n\n' "$models"
    # shellcheck disable=SC2086  # a list of words
    "$tessera" --quiet verify $models --all --factor random:1..9 --markdown
} >"$table"
sed -i -e "/<!-- parity: /r $table" -e '/<!-- parity: /,/<!-- \/parity -->/{/<!-- .*parity/!d}' README.md
