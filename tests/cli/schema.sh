#!/bin/sh
# Documents beside their JSON Schema, and the schema beside doc/json.md; see schema.py.
exec /usr/bin/python3 "$(dirname "$0")/schema.py" "$1" "$(dirname "$0")/../.."
