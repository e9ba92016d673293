# EQUIVALENT SAMPLE RESULTS: what came of the sample, by folder, and what was not noticed. With
# `markdown` as the README has it. Exit status: 0 at least `least` percent, 1 less, 2 nothing was tried.
function key(file, old, nth, code) { return file SUBSEP old SUBSEP nth SUBSEP code }
function folder(file) {
  sub(/^grader\//, "", file)
  if (file ~ /^tasks\/[^\/]*\//) { match(file, /^tasks\/[^\/]*/); return substr(file, 1, RLENGTH) }
  sub(/\/.*/, "", file)
  return file
}
function shortly(code) { gsub(/`/, "'", code); return length(code) > 72 ? substr(code, 1, 69) "..." : code }
function add(list, row, why) { return list "- `" row[1] ":" row[2] "` `" trimmed(row[4]) "` in `" shortly(row[6]) "`" why "\n" }
function trimmed(text) { gsub(/^ +| +$/, "", text); return shortly(text) }
BEGIN { FS = "\t" }
FILENAME == ARGV[1] { if (FNR > 1) reason[key($1, $2, $3, $4)] = $5; next }
FILENAME == ARGV[2] { wanted[key($2, $5, $6, $7)] = 1; ++sample; next }
{
  id = key($1, $4, $5, $6)
  if (!(id in wanted)) next
  split($0, row, "\t")
  where = folder($1)
  ++tried[where]
  if ($9 == "caught") { ++noticed[where]; ++allNoticed }
  else if (id in reason) { ++same[where]; ++allSame; equal = add(equal, row, ": " reason[id]) }
  else rest = add(rest, row, $9 == "never-run" ? ": no test comes here" : "")
  ++allTried
}
END {
  if (allTried == 0) exit 2
  share = 100 * allNoticed / (allTried - allSame)
  if (markdown) {
    printf "Seed %d, %d of %d flips tried:\n\n", seed, allTried, sample
    print "| folder | tried | equivalent | noticed | not noticed |\n|---|---|---|---|---|"
    sort = "LC_ALL=C sort"
    for (where in tried) printf "| `%s` | %d | %d | %d | %d |\n", where, tried[where], same[where],
      noticed[where], tried[where] - same[where] - noticed[where] | sort
    close(sort)
    printf "| **all** | %d | %d | %d | %d |\n", allTried, allSame, allNoticed, allTried - allSame - allNoticed
    printf "\n%d of %d that are not equivalent are noticed: %.1f %%.\n", allNoticed, allTried - allSame, share
    printf "\nNot noticed:\n%s\nEquivalent:\n%s", rest == "" ? "nothing\n" : rest, equal == "" ? "nothing\n" : equal
  } else {
    printf "\nNot noticed:\n%s\n%d of %d noticed: %.1f %%, without %d that are equivalent\n", rest,
      allNoticed, allTried - allSame, share, allSame
  }
  exit share < least
}
