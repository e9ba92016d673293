#!/bin/sh
# PrairieLearn runs this for each submission and reads results/results.json. It must exit with 0, or
# PrairieLearn discards the results. If the grader failed, the submission is "not gradable", which
# uses up no attempt.
set -u
grade=${GRADE:-/grade}
ticker=$(dirname "$(readlink -f "$0")")/ticker/bin/ticker
out=$(mktemp -d)
mkdir -p "$grade/results"

"$ticker" grade "$grade/student" --single --format prairielearn -o "$out" >&2
if [ -f "$out/student/prairielearn.json" ]; then
  cp "$out/student/prairielearn.json" "$grade/results/.results.part"
else
  printf '{"gradable": false, "message": "%s"}\n' \
    'The grader itself failed; your attempt does not count. Please tell the course staff.' \
    >"$grade/results/.results.part"
fi
mv "$grade/results/.results.part" "$grade/results/results.json"
rm -rf "$out"
exit 0
