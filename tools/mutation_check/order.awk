# Puts before each row a number that depends on the seed and on the row's FILE, OLD, NTH and CODE alone, the
# same on every machine: a polynomial of the characters, mixed by Lehmer's generator.
function hash(text,   i, h) {
  h = seed * 7919 + 1
  for (i = 1; i <= length(text); ++i) h = (h * 131 + index(alphabet, substr(text, i, 1))) % 2147483647
  for (i = 0; i < 20; ++i) h = h * 16807 % 2147483647
  return h
}
BEGIN { FS = "\t"; for (i = 32; i < 127; ++i) alphabet = alphabet sprintf("%c", i) }
{ print hash($2 FS $5 FS $6 FS $7) "\t" $0 }
