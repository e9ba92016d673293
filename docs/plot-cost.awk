# Lines "main SECONDS" and "SHADOW_RAYS LENS_RAYS SECONDS" -> a plot of the slow-down, as SVG.
function px(rays) { return 60 + rays * 9.2 }
function py(times) { return 300 - times * 270 / top }
$1 == "main" { main = $2; next }
{ n++; shadow[n] = $1; lens[n] = $2; slower[n] = $3 / main; if (slower[n] > most) most = slower[n] }
END {
  step = most > 60 ? 20 : most > 25 ? 10 : 5
  top = step * (int(most / step) + 1)
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 680 350\" font-family=\"sans-serif\" font-size=\"13\" role=\"img\" aria-label=\"How many times slower than the main tick, for 1 to 50 lens rays\">"
  print "<rect width=\"680\" height=\"350\" fill=\"#ffffff\"/>"
  for (t = 0; t <= top; t += step) {
    printf "<line x1=\"60\" x2=\"520\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#d8d8d8\"/>\n", py(t), py(t)
    printf "<text x=\"52\" y=\"%.1f\" text-anchor=\"end\">%d</text>\n", py(t) + 4, t
  }
  for (r = 0; r <= 50; r += 10) printf "<text x=\"%.1f\" y=\"318\" text-anchor=\"middle\">%d</text>\n", px(r), r
  print "<text x=\"290\" y=\"340\" text-anchor=\"middle\">lens rays for each pixel (dofRayCount)</text>"
  print "<text x=\"16\" y=\"165\" text-anchor=\"middle\" transform=\"rotate(-90 16 165)\">times slower than the main tick</text>"
  split("#b05a00 #2f7d32 #1a5fb4", colour, " ")
  for (i = 1; i <= n; i++) {
    if (shadow[i] != shadow[i - 1]) {
      if (i > 1) print "\"/>"
      lines++
      printf "<polyline fill=\"none\" stroke-width=\"2.5\" stroke=\"%s\" points=\"", colour[lines]
    }
    printf "%.1f,%.1f ", px(lens[i]), py(slower[i])
    last[lines] = i
  }
  print "\"/>"
  for (i = 1; i <= n; i++) printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\"/>\n", px(lens[i]), py(slower[i])
  for (l = 1; l <= lines; l++) {
    i = last[l]
    printf "<text x=\"%.1f\" y=\"%.1f\" fill=\"%s\">%d shadow ray%s: x%.0f</text>\n", px(lens[i]) - 2 + 8, py(slower[i]) + 4, colour[l], shadow[i], (shadow[i] > 1 ? "s" : ""), slower[i]
  }
  print "</svg>"
}
