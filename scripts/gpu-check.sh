#!/bin/sh
# Everything that is to be known of a machine's devices, as one JSON file: whether they give the bits of the reference,
# the golden cases, and the bench. Runs in the folder that package.sh makes, or in the project after a build.
#
#   gpu-check.sh [--golden FILE] [--output FILE.json] [--quick]
#
#   --golden  tessellator.csv or another file of golden patterns; without it they are left out
#   --output  default gpu-check.json
#   --quick   small workloads in the bench: shows that it works, not how fast
#
# Exit code 0: all the same; 1: a difference; 3: no device but the reference.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
if [ -x "$here/tessera" ]; then
    tessera=$here/tessera
    assets=$here/assets
else
    tessera=$here/../build/release/tessera
    assets=$here/../assets
fi

golden=
output=gpu-check.json
quick=
while [ $# -gt 0 ]; do
    case $1 in
        --golden) golden=$2 && shift 2 ;;
        --output) output=$2 && shift 2 ;;
        --quick) quick=--quick && shift ;;
        *)
            echo "gpu-check.sh: '$1' is not known; it takes --golden FILE, --output FILE and --quick." >&2
            exit 2
            ;;
    esac
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

"$tessera" devices --json >"$work/devices.json"
"$tessera" devices
if ! grep -q '"backend": "\(vulkan\|opencl\)"' "$work/devices.json"; then
    echo "gpu-check.sh: this machine has no device but the reference." >&2
    status=3
fi

echo "verify: every device against the reference, bit by bit" >&2
"$tessera" -q verify "$assets"/*.glb shape:torus shape:icosahedron shape:sphere:10 --all --factor random:1..17 --json \
    >"$work/verify.json" || status=1

if [ -n "$golden" ]; then
    echo "golden cases" >&2
    golden_same=true
    "$tessera" pattern --check "$golden" --device all >"$work/golden.txt" || { golden_same=false && status=1; }
    cat "$work/golden.txt"
    summary=$(tail -n 1 "$work/golden.txt")
    printf '{"same": %s, "summary": "%s"}\n' "$golden_same" "$summary" >"$work/golden.json"
else
    echo null >"$work/golden.json"
fi

"$tessera" bench $quick --json "$work/bench.json" || status=1

{
    printf '{"devices": '
    cat "$work/devices.json"
    printf ', "verify": '
    cat "$work/verify.json"
    printf ', "golden": '
    cat "$work/golden.json"
    printf ', "bench": '
    cat "$work/bench.json"
    printf ', "same": %s}\n' "$([ $status -eq 1 ] && echo false || echo true)"
} >"$output"
echo "$output: exit code $status" >&2
exit $status
