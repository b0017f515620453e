#!/bin/sh
# Draws the pictures of README and docs/gallery again. Needs the shared models (TESSERA_SHARED, default ../shared) and
# ImageMagick, to put panels side by side.
set -eu
cd "$(dirname "$0")/.."

tessera=${1:-build/release/tessera}
models=${TESSERA_SHARED:-../shared}/models
panels=$(mktemp -d)
trap 'rm -rf "$panels"' EXIT

panel() { # NAME MODEL OPTIONS...
    name=$1
    model=$2
    shift 2
    "$tessera" --quiet render "$model" -o "$panels/$name.png" "$@"
}
beside() { # OUTPUT PANEL...
    output=$1
    shift
    convert "$@" +append -strip -define png:compression-level=9 "PNG24:docs/gallery/$output"
}

rabbit="assets/rabbit.glb --camera -38,14 --size 420x600"
panel coarse $rabbit --scheme linear --factor 1
panel wires $rabbit --scheme pn --factor 3 --shading wireframe
panel smooth $rabbit --scheme pn --factor 12
beside rabbit.png "$panels/coarse.png" "$panels/wires.png" "$panels/smooth.png"

parrot="assets/parrot.glb --orbit=-35,8 --size 420x560"
panel painted_coarse $parrot --scheme linear --factor 1
panel painted_wires $parrot --partitioning integer --factor 2 --view wireframe
panel painted $parrot --factor 12
beside parrot.png "$panels/painted_coarse.png" "$panels/painted_wires.png" "$panels/painted.png"

fur="assets/furball.glb --camera 18,6 --size 460x500"
panel guides $fur --factor 8 --hairs 1 --hair-width 0.02
panel ribbons $fur --factor 2 --hairs 1 --hair-segments 5 --hair-width 0.07 --shading wireframe
panel fur $fur --factor 8 --hairs 40 --hair-variation 0.5
beside hair.png "$panels/guides.png" "$panels/ribbons.png" "$panels/fur.png"

pair() { # OUTPUT MODEL CAMERA
    panel before "$2" --camera "$3" --size 460x460 --scheme linear --factor 1
    panel after "$2" --camera "$3" --size 460x460 --scheme pn --factor 8
    beside "$1" "$panels/before.png" "$panels/after.png"
}
pair fox.png "$models/Fox/Fox.glb" -40,12
pair avocado.png "$models/Avocado/Avocado.gltf" -25,15
pair suzanne.png "$models/SuzanneBlender/02_suzanne.gltf" 25,10
panel split "$models/RiggedFigure/RiggedFigure.glb" --camera 30,8 --size 310x460 --scheme linear --factor 1
panel cracks "$models/RiggedFigure/RiggedFigure.glb" --camera 30,8 --size 310x460 --scheme pn --factor 8
panel round "$models/RiggedFigure/RiggedFigure.glb" --camera 30,8 --size 310x460 --scheme pn --factor 8 --smooth-normals
beside figure.png "$panels/split.png" "$panels/cracks.png" "$panels/round.png"
pair spot.png "$models/spot/spot_control_mesh.obj" 150,10
pair rook.png "$models/opensubdiv/catmark_rook.obj" 30,15
pair teapot.png "$models/obj/max6_teapot.obj" 30,20
pair ufo.png "$models/RetroUFO/retroufo.glb" 30,22

panel avocado_pbr "$models/Avocado/Avocado.gltf" --orbit=-25,15 --size 310x460 --factor 8 --shading pbr --tonemap aces
panel fox_pbr "$models/Fox/Fox.glb" --orbit=-40,12 --size 460x460 --factor 8 --shading pbr --tonemap aces
beside pbr.png "$panels/avocado_pbr.png" "$panels/fox_pbr.png"
panel literature assets/figure.glb --size 310x460 --factor 8 --preset van-veen
panel wires_over assets/rabbit.glb --orbit=-38,14 --size 310x460 --factor 3 --view wireframe
panel far assets/rabbit.glb --orbit=-38,14 --size 310x460 --factor 8 --view depth
panel coordinates assets/rabbit.glb --orbit=-38,14 --size 310x460 --factor 8 --view uv
beside views.png "$panels/literature.png" "$panels/wires_over.png" "$panels/far.png" "$panels/coordinates.png"

# A second picture of Spot needs its texture, which the file does not name.
cp "$models/spot/spot_texture.png" "$panels/"
printf 'newmtl spot\nmap_Kd spot_texture.png\n' >"$panels/spot.mtl"
{ printf 'mtllib spot.mtl\nusemtl spot\n' && cat "$models/spot/spot_control_mesh.obj"; } >"$panels/spot.obj"
textured="--size 420x460 --shading pbr --tonemap aces"
panel spot_coarse "$panels/spot.obj" $textured --orbit 150,10 --scheme linear --factor 1
panel spot_smooth "$panels/spot.obj" $textured --orbit 150,10 --factor 8
panel suzanne_pbr "$models/SuzanneBlender/02_suzanne.gltf" $textured --orbit 25,10 --factor 4
beside textured.png "$panels/spot_coarse.png" "$panels/spot_smooth.png" "$panels/suzanne_pbr.png"

panel literature4 assets/figure.glb --size 420x460 --factor 12 --preset van-veen \
    --compare linear:true,phong,pn:linear,pn:quadratic
beside literature.png "$panels/literature4.png"
factors="--size 460x520 --view factors --factor random:1..9 --range 1..9"
panel factors_triangles assets/rabbit.glb $factors --orbit=-38,14
panel factors_quads "$models/spot/spot_control_mesh.obj" $factors --orbit 150,10
beside factors.png "$panels/factors_triangles.png" "$panels/factors_quads.png"
panel difference assets/figure.glb --size 460x460 --factor 12 --view scheme-difference --compare phong,pn
beside difference.png "$panels/difference.png"
panel silhouette "$models/Fox/Fox.glb" --orbit=-40,12 --size 500x420 --factor 12 --view silhouette --compare phong,pn
beside silhouette.png "$panels/silhouette.png"

"$tessera" --quiet render assets/figure.glb -o "$panels/compare.png" --compare linear,phong,pn --size 420x460 --factor 8
beside compare.png "$panels/compare.png"
"$tessera" --quiet render assets/rabbit.glb -o "$panels/turn.png" --turntable 6 --orbit -38,14 --size 210x300 --factor 8
beside turntable.png "$panels"/turn-00[0-5].png
"$tessera" --quiet diff "$panels/coarse.png" "$panels/smooth.png" -o "$panels/heat.png" >/dev/null || [ $? -eq 1 ]
beside diff.png "$panels/coarse.png" "$panels/smooth.png" "$panels/heat.png"
