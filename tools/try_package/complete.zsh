# zsh tools/try_package/complete.zsh TYPED EXPECTED: types into an interactive zsh, presses Tab, and waits
# for the line that is expected then. zsh completes nothing without a terminal, so this makes one.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'autoload -Uz compinit && compinit -u -D; PS1=READY:'
zpty -r shell answer '*READY:*READY:' # first the echo of the assignment
zpty -w -n shell "$1"$'\t'
zpty -r shell answer "*$2*"
print -r -- "zsh: '$1' completes to '$2'"
zpty -d shell
