#!/bin/sh
# Checks that includes point one way: each room includes itself and rooms named before it, never one named after it.
# Prints each offence with its line; exit code 1 where there is one.
set -eu
cd "$(dirname "$0")/.."

# room: what it may include besides itself, each a room on an earlier line. Rooms of src/ never see backends/, but for
# the command line and the header of the whole library, which ask the registry for devices; only registry.cpp names a
# backend; tests and benchmarks may look into everything.
rooms="
kernels:
base:
gpu:                base
kernels/build:      base kernels gpu
image:              base
compare:            base image
scene:              base image
patches:            base kernels scene
tessellate:         base kernels gpu patches
export:             base scene tessellate
render:             base gpu image scene tessellate
views:              base kernels gpu image patches scene tessellate render
raster:             base kernels gpu image scene tessellate render
measure:            base gpu image patches scene tessellate render
verify:             base gpu image compare patches scene tessellate render raster
bench:              base kernels gpu image patches scene tessellate render
backends:           base gpu render verify bench
backends/reference: base kernels gpu backends
backends/opencl:    base kernels gpu backends
backends/vulkan:    base kernels gpu image scene tessellate render verify bench backends
registry.cpp:       base gpu render verify bench backends backends/reference backends/opencl backends/vulkan
peers:
tessera.hpp:        base gpu image compare scene patches tessellate export render raster verify backends
cli:                base gpu image compare scene patches tessellate export render views raster verify bench backends peers
"

# <header>, by its first folder or name: the rooms that may include it.
outside="
vulkan:      backends/vulkan
CL:          backends/opencl
oneapi:      backends/reference bench compare measure
CLI:         cli
tiny_gltf.h: scene
stb:         image
zlib.h:      image
"

find . \( -path ./build -o -path ./out -o -path ./.git \) -prune -o \( -name '*.hpp' -o -name '*.cpp' -o -name '*.h' \) -print |
    sed 's|^\./||' | sort |
    awk -v rooms="$rooms" -v outside="$outside" '
    function exists(path,    line, found) {
        if (!(path in known)) {
            found = (getline line < path) >= 0
            close(path)
            known[path] = found
        }
        return known[path]
    }
    function room_of(path,    part) {
        if (path == "backends/registry.cpp") return "registry.cpp"
        split(path, part, "/")
        if (part[1] == "src") return part[2]
        if (part[1] == "bench") return "peers"  # src/bench is the room of that name
        if (part[1] == "kernels") return part[2] == "build" ? "kernels/build" : "kernels"
        if (part[1] == "backends") return part[2] ~ /\./ ? "backends" : "backends/" part[2]
        return part[1]
    }
    # The file that the compiler finds for #include "name": beside the file, then in the include folders.
    function resolve(file, name,    folder, roots, count, i) {
        folder = file
        sub(/[^\/]*$/, "", folder)
        count = split(folder " tests/ src/ . kernels/ kernels/build/", roots, " ")
        for (i = 1; i <= count; ++i) {
            if (roots[i] == "tests/" && file !~ /^tests\//) continue
            if (exists((roots[i] == "." ? "" : roots[i]) name)) return (roots[i] == "." ? "" : roots[i]) name
        }
        return ""
    }
    function offence(sentence) {
        printf "%s:%d: %s\n", file, line_number, sentence
        ++offences
    }
    function check_table(    lines, count, i, part, names, n, j) {
        count = split(rooms, lines, "\n")
        for (i = 1; i <= count; ++i) {
            if (split(lines[i], part, ":") < 2) continue
            n = split(part[2], names, " ")
            for (j = 1; j <= n; ++j) {
                if (!(names[j] in room)) {
                    printf "The table names %s for %s, which is not above it.\n", names[j], part[1]
                    ++offences
                }
                allowed[part[1], names[j]] = 1
            }
            room[part[1]] = 1
        }
        count = split(outside, lines, "\n")
        for (i = 1; i <= count; ++i) {
            if (split(lines[i], part, ":") < 2) continue
            owner[part[1]] = part[2] " "
        }
    }
    function check_project_header(from, name,    target, to) {
        if (name ~ /\.inc$/) return  # made by the build for the room itself
        target = resolve(file, name)
        if (target == "") return offence("\"" name "\" is nowhere in the project")
        to = room_of(target)
        if (from ~ free || from == to) return
        if (from == "registry.cpp" && to == "backends") return
        if (!(from in room)) return offence("the room " from " is not in the table of scripts/check_includes.sh")
        if ((from == "cli" || from == "tessera.hpp") && to == "backends" && target != "backends/registry.hpp")
            return offence(from " sees the registry only, not " target)
        if (!((from, to) in allowed)) offence(from " must not include " to " (" target ")")
    }
    function check_outside_header(from, name,    first) {
        first = name
        sub(/\/.*/, "", first)
        if (from == "kernels" && file != "kernels/dialect.h")
            offence("kernels include nothing from outside but through kernels/dialect.h: <" name ">")
        if (first in owner && !index(owner[first], " " from " ") && from !~ free)
            offence("<" name "> belongs to" owner[first])
    }
    BEGIN {
        free = "^(tests|peers|docs)$"  # may include everything
        check_table()
    }
    {
        file = $0
        from = room_of(file)
        line_number = 0
        ++files
        while ((getline text < file) > 0) {
            ++line_number
            if (text !~ /^[ \t]*#[ \t]*include[ \t]*["<]/) continue
            name = text
            sub(/^[^"<]*["<]/, "", name)
            sub(/[">].*$/, "", name)
            if (text ~ /include[ \t]*"/) check_project_header(from, name)
            else check_outside_header(from, name)
        }
        close(file)
    }
    END {
        if (files == 0) {
            print "No sources were found."
            exit 1
        }
        printf "%d files, %d offences\n", files, offences
        exit offences > 0
    }'
