#!/usr/bin/env bash
# Installs what the tests need, builds everything and runs all tests. Idempotent; quick the second time.
#   deploy/test.sh [CTEST OPTIONS…]     for example: deploy/test.sh -R replay
set -euo pipefail
cd "$(dirname "$0")/.."
deploy/setup.sh --tests
cmake --preset release -DRONDA_BUILD_TESTS=ON -DRONDA_BUILD_BENCH=ON >/dev/null
echo "Building (build/release) …"
cmake --build --preset release
ctest --preset release "$@"
