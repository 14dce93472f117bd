#!/usr/bin/env bash
# Installs what is missing, builds the release programs into build/release/bin, meshes a model and draws it.
#   ./run.sh                       the solid bracket and the plane gasket of Resources/demos, then the Delaunay kernel alone
#   ./run.sh MODEL [options]       a model of one's own; options of `mesher mesh`, see build/release/bin/mesher --help
#   ./run.sh --gui                 the bracket in FreeCAD, with the workbench
# Meshes (.msh, .vtu, .inp), report (.json) and picture (.png) go to build/demo.
set -euo pipefail

usage() {
    sed -n '2,6s/^# //p' run.sh
}

# mesh_and_draw MODEL [option…]
mesh_and_draw() {
    local model=$1 name mesh
    shift
    name=$(basename "${model%.*}")
    mesh=build/demo/$name
    mkdir -p build/demo
    echo "meshing $model $*"
    build/release/bin/mesher mesh "$model" "$@" -o "$mesh.msh" -o "$mesh.vtu" -o "$mesh.inp" --report "$mesh.json"
    build/release/bin/mesher draw "$mesh.vtu" -o "$mesh.png"
    /usr/bin/python3 tools/show_report.py "$mesh.json"
    echo
}

open_workbench() {
    if [[ -z ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
        echo "run.sh: there is no display to open FreeCAD on; log in to a desktop or set DISPLAY" >&2
        exit 1
    fi
    tools/setup.sh build workbench --optional solver
    tools/build.sh release mesher_bindings mesher_gui
    echo "the bracket is selected: menu Mesher, Mesh solid"
    MESHER_MODEL="$PWD/Resources/demos/bracket.step" exec freecad "$PWD/tools/open_in_workbench.FCMacro" \
        -M "$PWD/build/release/Mod/Mesher"
}

# A model is named from where the user stands.
model=
if [[ $# -gt 0 && $1 != -* ]]; then
    model=$(realpath -- "$1")
    shift
fi
cd "$(dirname "${BASH_SOURCE[0]}")"

if [[ -z $model ]]; then
    case "${1:-}" in
        "") ;;
        --gui) open_workbench ;;
        --help | -h)
            usage
            exit 0
            ;;
        *)
            usage >&2
            exit 2
            ;;
    esac
fi

if [[ -n $model ]]; then
    tools/setup.sh build workbench
    tools/build.sh release mesher
    mesh_and_draw "$model" "$@"
    exit 0
fi
tools/setup.sh build workbench --optional solver
tools/build.sh release mesher mesher_bindings mesher_gui triangulate_points
mesh_and_draw Resources/demos/bracket.step --size 4 --curvature 16 --check
mesh_and_draw Resources/demos/gasket.brep --dimension 2 --size 4 --curvature 48 --local-size Face2=1.2 --check
echo "the Delaunay kernel alone, on random points:"
build/release/bin/triangulate_points
echo
echo "meshes, reports and pictures are in build/demo; next: ./run.sh --gui for FreeCAD, tools/package.sh for a package to install"
