#!/bin/sh
# Installs the Debian 12 packages that the project needs, and nothing where they are all there: then it needs no root
# and takes no time.
#
#   scripts/setup.sh [--with-swiftshader] [--with-clang]
#
#   --with-swiftshader  Chromium's Vulkan driver too: a device without a tessellation stage, for the tests
#   --with-clang        clang, its sanitizers, clang-format and clang-tidy too: what .ci/run checks the sources with
#
# Exit code 3: packages are missing and there is no way to install them here.
set -eu

# The one list. Build, libraries, kernels, devices, tests.
packages="
g++ cmake ninja-build
libfmt-dev libglm-dev nlohmann-json3-dev libtbb-dev libtinygltf-dev libtinyobjloader-dev libstb-dev libcli11-dev
libnanoflann-dev zlib1g-dev
glslang-tools glslang-dev spirv-tools libvulkan-dev opencl-c-headers
mesa-vulkan-drivers vulkan-validationlayers pocl-opencl-icd ocl-icd-libopencl1
libgtest-dev librapidcheck-dev libbenchmark-dev libosd-dev
"

for argument in "$@"; do
    case $argument in
        --with-swiftshader) packages="$packages chromium" ;;
        --with-clang) packages="$packages clang libclang-rt-dev clang-format clang-tidy" ;;
        *)
            echo "setup.sh: '$argument' is not known; it takes --with-swiftshader and --with-clang." >&2
            exit 2
            ;;
    esac
done

missing=""
for package in $packages; do
    status=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
    case $status in
        *not-installed* | *config-files* | "") missing="$missing $package" ;;
    esac
done
if [ -z "$missing" ]; then
    exit 0
fi

as_root=""
if [ "$(id -u)" -ne 0 ]; then
    as_root=sudo
fi
if ! command -v apt-get >/dev/null || { [ -n "$as_root" ] && ! command -v sudo >/dev/null; }; then
    echo "setup.sh: these Debian 12 packages are missing, and installing them takes apt-get and root:$missing" >&2
    exit 3
fi

echo "Installing:$missing" >&2
$as_root apt-get update -qq
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
