#!/usr/bin/env bash
# From a bare Debian 12 to a trained policy: installs packages, builds, trains 10 robots on the Cumberland map with
# separate processes over Fast DDS, compares the result with the classical strategies, and draws two pictures.
# A second call finds all that done and only shows the result. State: runs/quickstart (remove it to train anew).
set -euo pipefail
cd "$(dirname "$0")/.."
run=runs/quickstart
step() { printf '\n== %s\n' "$*"; }

step "Packages"
deploy/setup.sh && echo "All there."

step "Build"
[ -e build/release/build.ninja ] || cmake --preset release -DRONDA_BUILD_TESTS=OFF -DRONDA_BUILD_BENCH=OFF >/dev/null
cmake --build --preset release --target ronda ronda-actor ronda-replay ronda-learner

step "Train: Cumberland, 10 robots, 2 actors, 60 s (Ctrl-C stops it with a checkpoint; call again to go on)"
build/release/bin/ronda train --map cumberland --agents 10 --actors 2 --for 60s --run "$run"

step "Compare with the classical strategies: steady protocol, 20 seeds that training never saw"
build/release/bin/ronda compare --map cumberland --agents 10 --policy "$run" --strategies all --json "$run/compare.json"
build/release/bin/ronda evaluate --map cumberland --agents 10 --policy "$run" --episodes 1 --trace "$run/trace.csv" >/dev/null

step "Pictures"
python3 python/figures.py learning-curve "$run" --out "$run/learning_curve.svg"
build/release/bin/ronda map show cumberland --colour traffic --trace "$run/trace.csv" --svg "$run/traffic.svg" --force

step "Next"
cat <<END
  build/release/bin/ronda train --map maps/grid.json --agents 4     train on another map
  build/release/bin/ronda evaluate --help                           judge a policy or a strategy
  $run/learning_curve.svg, $run/traffic.svg                         the pictures
END
