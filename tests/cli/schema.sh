#!/bin/sh
# Compares the JSON documents with their JSON Schema, and the schema with doc/json.md as it is built; see schema.py.
exec /usr/bin/python3 "$(dirname "$0")/schema.py" "$1" "$(dirname "$0")/../.." "$(dirname "$1")/../../doc/json.md"
