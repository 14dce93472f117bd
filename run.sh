#!/usr/bin/env bash
# Installs what is missing, builds the release programs into build/release/bin, meshes a plane model and draws it.
#   ./run.sh                       the gasket of Resources/demos, then the Delaunay kernel beside CGAL on point sets
#   ./run.sh MODEL [options]       a model of one's own; options of `mesher mesh`, see build/release/bin/mesher --help
# Mesh (.msh, .vtu), report (.json) and picture (.png) go to build/demo.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

if [[ $# -gt 0 ]]; then
    model=$1
    options=("${@:2}")
else
    model=Resources/demos/gasket.brep
    options=(--size 4 --curvature 48 --local-size Face2=1.2 --check)
fi

tools/setup.sh
tools/build.sh release

name=$(basename "${model%.*}")
mkdir -p build/demo
mesh=build/demo/$name
echo "meshing $model ${options[*]}"
build/release/bin/mesher mesh "$model" --dimension 2 "${options[@]}" -o "$mesh.msh" -o "$mesh.vtu" --report "$mesh.json"
build/release/bin/mesher draw "$mesh.vtu" -o "$mesh.png"
/usr/bin/python3 tools/show_report.py "$mesh.json"

[[ $# -eq 0 ]] || exit 0
echo
echo "the Delaunay kernel alone, on random points:"
build/release/bin/triangulate_points
echo "the same kernel beside CGAL, on 200,000 points of a cube and of a torus (user CPU seconds):"
build/release/bin/compare_delaunay --points 200000 --dimension 3 --programs mesher,cgal --repeats 1
