# insert.awk SITES DROPPED FILE: the text of FILE with its flips, those of DROPPED left out.
FILENAME == ARGV[1] { split($0, f, "\t"); if (f[2] == ARGV[3]) { lines[f[3]] = lines[f[3]] " " f[1]; site[f[1]] = $0 } next }
FILENAME == ARGV[2] { dropped[$1] = 1; next }
FNR == 1 { print "#include <tools/mutation_check/Flips.h>"; print "#line 1" }
{
  text = $0
  n = split(lines[FNR], here, " ")
  # The last column first, so that the others stay where they are.
  for (i = 1; i <= n; ++i)
    for (j = i + 1; j <= n; ++j) {
      split(site[here[i]], a, "\t"); split(site[here[j]], b, "\t")
      if (b[4] + 0 > a[4] + 0) { swap = here[i]; here[i] = here[j]; here[j] = swap }
    }
  for (i = 1; i <= n; ++i) {
    if (here[i] in dropped) continue
    split(site[here[i]], f, "\t")
    text = substr(text, 1, f[4] - 1) f[6] substr(text, f[4] + length(f[5]))
  }
  print text
}
