#!/bin/sh
# The installed program by its own name: hands over to stiction-engine beside it.
here=$(readlink -f "$0")
here=${here%/*}
[ "${1:-}" != new ] || set -- help "$(printf '%s\n' "$@" .)" # the library reads the words of `new`, a line each
exec "$here/stiction-engine" "$@"
