#!/bin/sh
# Sets up, builds and runs every test; ends with the test runner's summary. Arguments go to ctest: scripts/test.sh -R scene
#
# Tests of real models take them from the folder TESSERA_SHARED (default ../shared) and skip where it is not there.
# SwiftShader is tested where it is installed (scripts/setup.sh --with-swiftshader). With TESSERA_REQUIRE_ALL set,
# nothing is skipped: what is missing fails.
set -eu
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release
cmake --build --preset release
ctest --preset release --parallel "$(nproc)" "$@"
