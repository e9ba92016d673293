#!/bin/sh
# Gradescope runs this once, when it builds the assignment's image.
set -eu
exec "${AUTOGRADER:-/autograder}/source/ticker/prepare.sh"
