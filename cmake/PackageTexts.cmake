# cmake -DTICKER=PROGRAM -DTEXTS=FOLDER -DSOURCE=FOLDER -DVERSION=V -P: writes what lies below
# /usr/share in a package: the manual page, the completions, the licence, the changelog.
foreach(folder man/man1 bash-completion/completions zsh/vendor-completions
    fish/vendor_completions.d doc/ticker lintian/overrides)
  file(MAKE_DIRECTORY "${TEXTS}/${folder}")
endforeach()

function(write_text file)
  execute_process(COMMAND "${TICKER}" ${ARGN} OUTPUT_FILE "${TEXTS}/${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(compress file)
  execute_process(COMMAND gzip -9nf "${TEXTS}/${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
write_text(man/man1/ticker.1 --manual)
compress(man/man1/ticker.1)
write_text(bash-completion/completions/ticker --completion bash)
write_text(zsh/vendor-completions/_ticker --completion zsh)
write_text(fish/vendor_completions.d/ticker.fish --completion fish)

# Manual pages of the programs that render: their --help, unchanged.
string(REPLACE "|" ";" renderers "${RENDERERS}")
foreach(program ${renderers})
  cmake_path(GET program FILENAME name)
  execute_process(COMMAND "${program}" --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\\" "\\e" help "${help}")
  string(REPLACE "-" "\\-" help "${help}")
  string(TOUPPER "${name}" title)
  string(REPLACE "-" "\\-" shown "${name}")
  file(WRITE "${TEXTS}/man/man1/${name}.1"
    ".TH ${title} 1 \"\" \"ticker ${VERSION}\" \"User Commands\"\n.SH NAME\n${shown} \\- renders a scene\n"
    ".SH DESCRIPTION\n.nf\n${help}.fi\n")
  compress(man/man1/${name}.1)
endforeach()

file(READ "${SOURCE}/LICENSE" licence)
file(WRITE "${TEXTS}/doc/ticker/copyright" "${licence}")
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE "${TEXTS}/doc/ticker/changelog"
  "ticker (${VERSION}) unstable; urgency=medium\n\n  * See /usr/share/ticker/CHANGELOG.md.\n\n"
  " -- ${CONTACT}  ${now}\n")
compress(doc/ticker/changelog)

# These two run in the sandbox, where there is no library to load.
file(WRITE "${TEXTS}/lintian/overrides/ticker"
  "ticker: statically-linked-binary [usr/libexec/ticker/ticker-decode]\n"
  "ticker: statically-linked-binary [usr/libexec/ticker/ticker-jail]\n"
  "ticker: embedded-library libpng [usr/libexec/ticker/ticker-decode]\n"
  "ticker: embedded-library zlib [usr/libexec/ticker/ticker-decode]\n")
