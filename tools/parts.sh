# shellcheck shell=sh
# Sourced by ./reproduce: the parts that --only accepts. Case files are read with sed, because nothing is installed or
# built yet. Each top-level key of a case must be at the start of a line.

# key_of FILE KEY: prints the value of the key, without quotes, brackets and comment
key_of() { sed -n "s/^$2: *//p" "$1" | sed 's/ *#.*//; s/[]["]//g; s/,/ /g' | head -n 1; }

# has_word WORD WORD...: whether the first word is among the others
has_word() {
  sought=$1
  shift
  for word in "$@"; do [ "$word" != "$sought" ] || return 0; done
  return 1
}

# cases_of_part PART: prints the names of its cases. A figure that needs no run has none.
# shellcheck disable=SC2046 # the value is split into words on purpose
cases_of_part() {
  for file in cases/*.yaml; do
    name=$(key_of "$file" name)
    number=$(expr "x$1" : 'xfig0*\([0-9][0-9]*\)$')
    if [ "$name" = "$1" ] || has_word "$1" $(key_of "$file" suites) ||
      { [ -n "$number" ] && has_word "$number" $(key_of "$file" figure); }; then
      printf '%s ' "$name"
    fi
  done
}

is_part() { [ -f "reports/figures/$1.gp" ] || [ -n "$(cases_of_part "$1")" ]; }

# cases_of_claims: prints the cases whose results the claims of the paper use
cases_of_claims() { grep -o 'case = "[^"]*"' reports/papers/wavy_sphere/claims.toml | cut -d '"' -f 2 | sort -u | tr '\n' ' '; }

# all_parts: prints all parts on one line
all_parts() {
  {
    for file in cases/*.yaml; do
      key_of "$file" name
      key_of "$file" suites | tr ' ' '\n'
    done
    for figure in reports/figures/fig*.gp; do basename "$figure" .gp; done
  } | grep . | sort -u | tr '\n' ' ' | sed 's/ $//; s/ /, /g'
}
