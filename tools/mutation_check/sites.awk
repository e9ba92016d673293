# Of each source: NUMBER, FILE, LINE, COLUMN, OLD and NEW text, NTH and CODE of every flip: it is the
# NTH of its file with this OLD text in this line's CODE, however lines are numbered. Left out, because they
# have no visible effect or no value at run time: comments, and lines with texts, includes, templates,
# infinities (1e9 and above, where a minimum begins) or a seed that is added to.
BEGIN { count = 0 }
function site(old, new,   from, at, end) {
  from = 1
  while ((at = index(substr(code, from), old)) > 0) {
    end = from + at - 1
    add(end, old, new)
    from += at + length(old) - 1
  }
}
function add(column, old, new,   text, line) {
  text = new
  gsub(/NUMBER/, count, text)
  line = code
  gsub(/^[ \t]+|[ \t]+$/, "", line)
  print count++ "\t" FILENAME "\t" FNR "\t" column "\t" old "\t" text "\t" ++times[FILENAME, line, old] "\t" line
}
function constant(from, to, before) {
  add(from, substr(code, from, to - from), before "flips::constant(NUMBER, " value ");")
}
function pairs(op) { site(" " op " ", " " op " flips::Flip{NUMBER} " op " ") }
/"|#|template|<<|operator|numeric_limits|static_assert|requires|if constexpr|= 1e(9|[1-9][0-9]+);|seed \+ / { next }
{
  code = $0
  sub(/[ ]*\/\/.*/, "", code)
  if (match(code, /^ *constexpr double [A-Za-z]+ = .*;$/)) {
    start = index(code, "constexpr")
    from = index(code, " = ")
    value = substr(code, from + 3, length(code) - from - 3)
    constant(start, length(code) + 1, "static const double " substr(code, start + 17, from - start - 14))
    next
  }
  if (code !~ /constexpr|static/ && match(code, / = ([0-9]+\.[0-9]+(e-?[0-9]+)?|[0-9]+e-?[0-9]+);$/)) {
    value = substr(code, RSTART + 3, RLENGTH - 4)
    constant(RSTART, RSTART + RLENGTH, " = ")
    next
  }
  pairs("<"); pairs(">"); pairs("<="); pairs(">="); pairs("=="); pairs("!="); pairs("+"); pairs("-")
  if (code ~ /\) && \{/) next
  site(" && ", " && !flips::isOn(NUMBER) && ")
  site(" || ", " || flips::isOn(NUMBER) || ")
  if (code ~ / &&$/) add(length(code) - 2, " &&", " && !flips::isOn(NUMBER) &&")
  if (code ~ / \|\|$/) add(length(code) - 2, " ||", " || flips::isOn(NUMBER) ||")
}
