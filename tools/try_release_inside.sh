#!/usr/bin/env bash
# What tools/try_release.sh does in the system of the other release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

apt-get --quiet=2 update
apt-get --quiet=2 install --yes --no-install-recommends ccache >/dev/null
tools/setup.sh build workbench package tests --optional solver
if ! command -v ccx >/dev/null; then
    tools/calculix.sh /opt/calculix
    ln -sf /opt/calculix/bin/ccx /usr/local/bin/
fi
cmake --preset release -DMESHER_WARNINGS_AS_ERRORS=ON >/dev/null
./run.sh
tools/build.sh release mesher mesher_bindings mesher_gui window_hands
echo "try_release: $(. /etc/os-release && echo "$PRETTY_NAME"), $(g++ --version | head -n 1), Python $(python3 -V | cut -d' ' -f2)," \
    "$(dpkg-query --show --showformat='${Package} ${Version}, ' freecad libocct-foundation-dev pybind11-dev)"
ctest --test-dir build/release --output-on-failure --no-tests=error --tests-regex '^(python|workbench|packaging)[.]'
