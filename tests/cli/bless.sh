#!/bin/sh
# pulloff bless writes and renews the pins of a case. It needs a reason and refuses if a check against an oracle does not
# pass. Altered pins are detected.
# shellcheck disable=SC1091,SC2016,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
. "$here/data.sh"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null USER=tester
file=$PULLOFF_DATA/cases/good.yaml
table=$PULLOFF_DATA/reference/table.csv
pins=$PULLOFF_DATA/cases/pins/good.csv

says() { # WHAT PATTERN
  check "$1" grep -q -e "$2" "$work/stdout"
}

# refused CODE PATTERN ARGUMENT...: tests that bless refuses after it has solved the case. Standard error also has a line
# of progress.
refused() { # CODE PATTERN ARGUMENT...
  wanted=$1
  pattern=$2
  shift 2
  "$program" "$@" --output run >"$work/stdout" 2>"$work/stderr"
  got=$?
  check "exit code of pulloff $*" test "$got" -eq "$wanted"
  check "refused: $pattern" grep -q -e "^pulloff: $pattern" "$work/stderr"
}

# The arguments are wrong.
expect 2 'pulloff: bless needs --reason TEXT (see pulloff bless --help)' bless good --output run
expect 2 'pulloff: the reason is empty: expected one line that states the reason' bless good --reason ' '
expect 2 'pulloff: the reason is of several lines, *' bless good --reason 'one
two'
expect 2 'pulloff: bless needs the name of a case (see pulloff bless --help)' bless --reason why
expect 2 'pulloff: no case is named best: expected one of good' bless best --reason why
check 'nothing was solved for these' test ! -e run

# The first pins are written; what does not change is not written again.
expect 0 '*' bless good --reason 'the first, of a closed form' --output run
says 'how many' '^cases/pins/good.csv: 1 result, 1 new$'
check 'the pins state date, author, program and reason' grep -q \
  '^# accepted: 20[0-9][0-9]-[01][0-9]-[0-3][0-9], tester, pulloff [0-9.]*: the first, of a closed form$' "$pins"
check 'the row has digest, force and five counters' grep -qE '^0,[0-9a-f]{16},2(,[0-9]+){5}$' "$pins"
cp "$pins" first.csv
expect 0 '*' bless good --reason 'again' --output run
says 'nothing moved' '^cases/pins/good.csv: 1 result, 0 new; nothing is written$'
check 'nothing is written' cmp first.csv "$pins"

# An altered pin is detected by its checksum, or, if the checksum was corrected, by its value.
sed -i 's/^0,\(.*\),2,/0,\1,2.1,/' "$pins"
expect 4 'pulloff: cases/pins/good.csv:*: sha256 is *: expected *, the digest of all other lines*' verify good
expect 4 'pulloff: cases/pins/good.csv:*: sha256 is *' bless good --reason why
sed -i '/^# sha256/d' "$pins"
expect 4 'pulloff: cases/pins/good.csv:*: the header sha256 is missing' verify good
sed -i 's/^0,[^,]*/0,0123456789abcdef/' "$pins" && seal "$pins"
expect 0 '*' bless good --reason 'the paper rounds' --output run
says 'by how much' '^good: 1 of 1 result is not the stored ones; the pull-off force of scene differs most, by 0.048 of 2.1: table can judge it$'
check 'the last reason is kept' grep -q '^# accepted: .*: the paper rounds$' "$pins"
check 'and no other' test 1 -eq "$(grep -c '^# accepted' "$pins")"

# bless refuses if a check against an oracle does not pass, but not if one against a published value does not.
cp "$pins" first.csv
write_table "$table" tabor,force,approach 0,2.1,0
refused 1 'good is not blessed: pull_off_force/table/scene is outside (see pulloff explain good)$' bless good --reason why
write_table "$table" tabor,force,approach 7,2.1,0
refused 1 'good is not blessed: pull_off_force/table/scene is missing_reference ' bless good --reason why
write_table "$table" tabor,force,approach 0,2.1,0
sed -i 's/^# kind: oracle/# kind: published/' "$table" && seal "$table"
expect 0 '*' bless good --reason why --output run
check 'the pins are unchanged' cmp first.csv "$pins"
write_table "$table" tabor,force,approach 0,2,0

# Nor if a solve failed, unless the stated fraction of solves may fail; the table has no numbers of it.
sed -i 's/^  radius: 100/&\n  approach_end: 5/' "$file"
refused 3 'good is not blessed: the solve of scene failed: ' bless good --reason why
check 'after a failed solve the pins are unchanged' cmp first.csv "$pins"
restore
sed -i 's/^want/sweep: [{key: approach_end, values: [0.1, 0.2, 5]}]\nwant/; s/quantity: pull_off_force/quantity: solved_share/;
  s/reference: .*/reference: every_scene/; s/tolerance: 1e-9/tolerance: 0.6/;
  s/^    because.*/&\n    when: [{key: approach_end, values: [0.2, 5]}]/' "$file"
expect 0 '*' bless good --reason 'one of two may fail' --output run
check 'a failed solve has a digest only' grep -qE '^2,[0-9a-f]{16},-,-,-,-,-,-$' "$pins"
expect 0 '*' verify good --output run --identical
says 'it is compared' '^3 of 3 results are identical'
sed -i 's/tolerance: 0.6/tolerance: 0.4/' "$file"
refused 3 'good is not blessed: the solve of approach_end=5 failed: ' bless good --reason why

# The pins of a case are in the folder of the case file. The author is user.name of git, for which a program stands here:
# a machine need not have git. A file in place of the folder is an error.
restore
mkdir -p my
write_case my/own.yaml
sed -i 's/^name: good/name: own/' my/own.yaml
mkdir -p bin
printf '#!/bin/sh\n[ "$*" = "config user.name" ] && echo "A. Smith"\n' >bin/git
chmod +x bin/git
PATH=$PWD/bin:$PATH expect 0 '*' bless my/own.yaml --reason 'mine' --output run
check 'the pins are in the folder of the case' grep -q '^# accepted: .*, A. Smith, ' my/pins/own.csv
rm -r my/pins
: >my/pins
refused 4 'the folder my/pins cannot be created: ' bless my/own.yaml --reason 'mine'
finish
