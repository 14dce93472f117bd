#!/usr/bin/env bash
# Installs what is missing, builds the release programs into build/release/bin and runs the first example:
# ./run.sh [number of points [seed]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

tools/setup.sh
tools/build.sh release
build/release/bin/triangulate_points "$@"
