#!/bin/sh
# Compares the protocol of external solvers with its page, its JSON Schema and the example solvers; see protocol.py.
exec /usr/bin/python3 "$(dirname "$0")/protocol.py" "$1" "$(dirname "$0")/../.."
