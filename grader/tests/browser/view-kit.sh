#!/usr/bin/env bash
# view-kit.sh SOURCE KIT: builds the students' package with the model answer in KIT, for tests that save its
# files.
# Later calls build only what changed.
set -euo pipefail
source="$1"
kit="$2"
mkdir -p "$kit/scenes" "$kit/assets"
cp -a --update "$source/student_template/." "$kit"
cp -a --update "$source"/scenes/*.xml "$kit/scenes"
cp -a --update "$source"/assets/*.png "$kit/assets"
for file in "$source"/reference_solution/exercise/*.cpp; do
  cmp -s "$file" "$kit/exercise/${file##*/}" || cp "$file" "$kit/exercise"
done
cd "$kit"
# With this ccache uses paths relative to the kit, so that a kit in another folder is not compiled again.
export CCACHE_BASEDIR="$PWD"
launcher="$(command -v ccache || true)"
[[ -f build/release/build.ninja ]] || # a configure that failed leaves a cache
  cmake --preset release -G Ninja -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"
cmake --build --preset release --parallel 2
