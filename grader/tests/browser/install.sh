#!/usr/bin/env bash
# install.sh FOLDER: puts the browser tests and the packages that they need into FOLDER, where they run.
# The registry is asked only where package-lock.json changed.
set -euo pipefail
source="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
mkdir -p "$1"
cd "$1"
cp "$source"/*.mjs "$source"/package.json "$source"/package-lock.json .
cmp -s package-lock.json node_modules/installed.json && exit 0
npm ci --ignore-scripts --no-audit --no-fund
cp package-lock.json node_modules/installed.json
