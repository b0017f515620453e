#!/bin/sh
# Makes one folder that runs from anywhere on x86-64 Linux with glibc 2.36 or newer and nothing installed but drivers:
# the program (its kernels are inside), the shared libraries it needs, samples, and gpu-check.sh.
#
#   scripts/package.sh [FOLDER]     FOLDER is made anew; default out/package/tessera
#
# FOLDER/tessera starts it. Loaders of Vulkan and OpenCL are those of the machine, opened at run time.
set -eu
cd "$(dirname "$0")/.."

folder=${1:-out/package/tessera}
limit=40960  # KiB

cmake --preset release
cmake --build --preset release --target tessera
rm -rf "$folder"
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
cmake --install build/release --prefix "$folder" --strip

# All but glibc. Those of the compiler lie apart: where the machine has them they are newer, and its drivers may need
# that.
mkdir -p "$folder/lib/compiler"
ldd "$folder/bin/tessera" | sed -n 's/^[[:space:]]*\([^ ]*\) => \([^ ]*\) .*/\1 \2/p' | while read -r name path; do
    case $name in
        libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libmvec.so.*) ;;
        libstdc++.so.* | libgcc_s.so.* | libgomp.so.*) cp -L "$path" "$folder/lib/compiler/$name" ;;
        *) cp -L "$path" "$folder/lib/$name" ;;
    esac
done
if ldd "$folder/bin/tessera" | grep -q "not found"; then
    echo "package.sh: the program needs libraries that this machine does not have:" >&2
    ldd "$folder/bin/tessera" | grep "not found" >&2
    exit 3
fi

mkdir "$folder/assets"
cp assets/*.glb "$folder/assets"
cp LICENSE "$folder"
cp scripts/gpu-check.sh "$folder"
cat >"$folder/tessera" <<'START'
#!/bin/sh
# Starts the program; with the compiler's libraries of this folder where the machine lacks them.
here=$(dirname "$(readlink -f "$0")")
if ! "$here/bin/tessera" --version >/dev/null 2>&1; then
    LD_LIBRARY_PATH="$here/lib/compiler${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
    export LD_LIBRARY_PATH
fi
exec "$here/bin/tessera" "$@"
START
chmod +x "$folder/tessera"

size=$(du -sk "$folder" | cut -f1)
echo "$folder: $size KiB"
if [ "$size" -gt "$limit" ]; then
    echo "package.sh: that is more than $limit KiB." >&2
    exit 1
fi
