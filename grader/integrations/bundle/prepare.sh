#!/bin/sh
# Gets the compiler that the kit was made with and lets it precompile the kit's header. To be run
# once, as root, while the platform builds its image: Debian or Ubuntu.
set -eu
cd "$(dirname "$0")"

if [ ! -x '@COMPILER@' ] || [ ! -x /usr/bin/ld.lld ] || [ ! -x /usr/bin/bwrap ]; then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -q
  apt-get install -y -q --no-install-recommends 'g++-@MAJOR@' libc6-dev lld bubblewrap
fi

cd lib/ticker/kit/@EXERCISE@
'@COMPILER@' @COMPILE@ -Iinclude -x c++-header pch/Framework.h -o pch/Framework.h.gch

# Does the kit fit this system's C library? The image must not be built if not.
trial=$(mktemp)
'@COMPILER@' template/*.o lib/probe.o \
  -Wl,--whole-archive lib/libkit.a -Wl,--no-whole-archive -o "$trial" @LINK@
rm -f "$trial"

cd ../../../..
chmod -R a+rX .
# For the log: which sandbox levels there are. The one that counts is that of the running container.
bin/ticker doctor || true
