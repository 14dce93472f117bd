#!/usr/bin/env bash
# Builds the release programs into build/release/bin, installing what is missing first.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

tools/setup.sh
tools/build.sh release
echo "run: built the programs in build/release/bin"
