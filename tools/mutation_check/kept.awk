# BLOBS NOW RESULTS: the rows of the results that still hold. The flipped file has to be the same; a flip that
# was noticed needs the test that noticed it, unchanged; another one needs all tests unchanged (`tests`).
BEGIN { FS = "\t" }
FILENAME == ARGV[1] { blob[$1] = $2; next }
FILENAME == ARGV[2] { test[$1 " " $2] = $3; next }
blob[$1] == $7 && ($9 == "caught" ? ($10 in test) && test[$10] == $11 : $8 == tests)
