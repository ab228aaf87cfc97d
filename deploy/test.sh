#!/usr/bin/env bash
# Installs what the tests need, builds everything and runs all tests. Idempotent; quick the second time.
#   deploy/test.sh [CTEST OPTIONS…]     for example: deploy/test.sh -R replay
set -euo pipefail
cd "$(dirname "$0")/.."
deploy/setup.sh --tests
cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
rm -f build-configure.log
echo "Building (build/release) …"
cmake --build --preset release
ctest --preset release "$@"
