#!/usr/bin/env bash
# Installs what is missing, builds the release programs into build/release/bin, runs the first example and times the kernel
# beside CGAL on a demonstration point set: ./run.sh [number of points [seed]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

tools/setup.sh
tools/build.sh release
build/release/bin/triangulate_points "$@"
echo "the same kernel beside CGAL, on 200,000 points of a cube and of a torus (user CPU seconds):"
build/release/bin/compare_delaunay --points 200000 --dimension 3 --programs mesher,cgal --repeats 1
