#!/bin/sh
# Sets up, builds and draws a sample before and after, the refined one on every device of this machine; then compares
# what the devices made, byte by byte. The pictures lie in out/demo.
set -eu
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release
cmake --build --preset release --target tessera

# SwiftShader, where Chromium is installed, joins the Vulkan drivers of the machine; Mesa wants the second folder.
swiftshader=/usr/lib/chromium/vk_swiftshader_icd.json
if [ -e "$swiftshader" ]; then
    export VK_ADD_DRIVER_FILES="$swiftshader"
fi
export XDG_RUNTIME_DIR="${XDG_RUNTIME_DIR:-$PWD/build/release}"
export POCL_CACHE_DIR="$PWD/build/release/pocl-cache"

tessera=build/release/tessera
sample=assets/rabbit.glb
look="--camera 40,15 --size 1024x1024"
refined="--scheme pn --factor 8"
out=out/demo
rm -rf "$out"
mkdir -p "$out"

echo
$tessera render "$sample" -o "$out/before.png" --scheme linear --factor 1 $look
$tessera devices | grep "is not usable" || true
devices=$($tessera devices --json | sed -n '/"unusable"/q; s/.*"id": "\(.*\)".*/\1/p')
for device in $devices; do
    folder=$out/$(echo "$device" | tr : -)
    mkdir "$folder"
    $tessera render "$sample" -o "$folder/after.png" --device "$device" $refined $look
    $tessera tessellate "$sample" -o "$folder/after.glb" --device "$device" $refined 2>/dev/null
done

# Every device must have made the same mesh. Pictures are the same where the same rasteriser drew them: a Vulkan device
# draws its own, everything else is drawn by the first of them.
status=0
echo
for device in $devices; do
    folder=$out/$(echo "$device" | tr : -)
    mesh="the mesh of the reference, byte by byte"
    if ! cmp "$out/reference/after.glb" "$folder/after.glb"; then
        mesh="ANOTHER MESH than the reference"
        status=1
    fi
    picture="and its picture"
    if ! cmp -s "$out/reference/after.png" "$folder/after.png"; then
        case $device in
            vulkan:*) picture="in a picture by a rasteriser of its own" ;;
            *)
                picture="in ANOTHER PICTURE, though by the same rasteriser"
                status=1
                ;;
        esac
    fi
    echo "$device: $mesh, $picture"
done

echo
echo "The model as it is, and refined on each device:"
ls -1 "$out"/*.png "$out"/*/*.png
exit $status
