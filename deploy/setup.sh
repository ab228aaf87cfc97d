#!/usr/bin/env bash
# Installs every Debian package that building, testing and running Ronda needs (Debian 12). Asks apt only for what is missing.
#   deploy/setup.sh          what building and running needs
#   deploy/setup.sh --tests  and what the tests need
#   deploy/setup.sh --bench  and what the benchmarks compare with
set -euo pipefail
packages=(g++ cmake ninja-build ccache
  libfastrtps-dev libfastcdr-dev fastddsgen libeigen3-dev libcereal-dev
  libcli11-dev libfccp-dev libtomlplusplus-dev libspdlog-dev libfmt-dev nlohmann-json3-dev libglpk-dev zlib1g-dev
  python3 python3-matplotlib)
[ "${1:-}" != --tests ] ||
  packages+=(catch2 clang-14 clang-format git libclang-rt-14-dev procps python3-networkx)
[ "${1:-}" != --bench ] || packages+=(libopenblas-dev)
missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0
if [ "$(id -u)" != 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "deploy/setup.sh: these packages are missing and installing them needs root: ${missing[*]}" >&2
    exit 1
  fi
  exec sudo "$0" "$@"
fi
echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt-get update -qq
apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
