# Completion of the command line of pulloff in bash. Verbs, closed forms, options and cases are read from the program, so
# that they are those of the installed version.
# shellcheck shell=bash

# _pulloff_names PROGRAM [VERB]: prints the names that the help lists on lines "  NAME   text".
_pulloff_names() { "$1" ${2:+"$2"} --help 2>/dev/null | sed -n 's/^  \([a-z][a-z-]*\)  *[A-Za-z].*/\1/p'; }

# _pulloff_options PROGRAM VERB: prints the options that the help lists on lines "  --NAME VALUE   text".
_pulloff_options() { "$1" "$2" --help 2>/dev/null | sed -n '/^  -/{s/^  //; s/   *.*//; p;}' | grep -o -e '--[a-z][a-z0-9-]*'; }

# _pulloff_values PROGRAM VERB OPTION: prints the words that the message lists with which the program refuses the value "?";
# that of another verb where this one refuses something else first.
_pulloff_values() {
  local verb
  for verb in "$2" solve 'solve --from-physical' list; do
    # shellcheck disable=SC2086 # words
    "$1" $verb "$3" '?' 2>&1 </dev/null
  done | sed "/^pulloff: \($3 is\|no theory is named\|no case belongs to the suite\) ?: expected /!d; s///; s/;.*//
    s/^\(one\|any\) of //; s/or in SI units //; s/, or \| or \|, /\n/g" | sed 's/:.*/:/' | grep -x '[a-z][a-z0-9_-]*:\?' | sort -u
}

# The lengths that --from-physical takes in metres, as --NAME-m.
_pulloff_lengths=' --profile-approach --approach --contact-radius '

_pulloff() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]}
  local words='' action=() option
  case $COMP_CWORD:$before in
  1:*) words="$(_pulloff_names "$program") --help --version" ;;
  *:--case)
    words=$("$program" list 2>/dev/null | awk 'NR > 1 { print $1 }')
    action=(-f -X '!*.yaml')
    ;;
  *:--output | *:-o | *:--run) case $verb in contact-law | profile) action=(-f) ;; *) action=(-d) ;; esac ;;
  *:--curve | *:--profile-csv | *:--profile-file | *:--smoothed | *:--staircase | *:--loop | *:--history | *:--sets | *:--summary | *:--plot | *:--junit)
    action=(-f)
    ;;
  *:--*) words=$(_pulloff_values "$program" "$verb" "$before") ;;
  esac
  if [ -z "$words" ] && [ ${#action[@]} -eq 0 ]; then
    case $word:$verb in
    -*)
      for option in $(_pulloff_options "$program" "$verb"); do
        words="$words $option"
        [[ " ${COMP_WORDS[*]} " != *' --from-physical '* || $_pulloff_lengths != *" $option "* ]] || words="$words $option-m"
      done
      ;;
    *:plan | *:run | *:verify | *:explain | *:bless)
      words=$("$program" list 2>/dev/null | awk 'NR > 1 { print $1 }')
      action=(-f -X '!*.yaml')
      ;;
    *:plot | *:fit | *:profile | *:seal) action=(-f) ;;
    *:conform) action=(-f -X '!*.yaml') ;;
    *:merge) action=(-d) ;;
    *:theory) words=$(_pulloff_names "$program" theory) ;;
    esac
  fi
  mapfile -t COMPREPLY < <(
    {
      [ -z "$words" ] || compgen -W "$words" -- "$word"
      [ ${#action[@]} -eq 0 ] || compgen "${action[@]}" -- "$word"
    } | sort -u
  )
}

complete -o filenames -F _pulloff pulloff
