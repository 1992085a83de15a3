# Completion of the command line of pulloff in bash. Verbs, closed forms, options and cases are read from the program, so
# that they are those of the installed version.
# shellcheck shell=bash

# _pulloff_names PROGRAM [VERB]: prints the names that the help lists on lines "  NAME   text".
_pulloff_names() { "$1" ${2:+"$2"} --help 2>/dev/null | sed -n 's/^  \([a-z][a-z-]*\)  *[A-Za-z].*/\1/p'; }

# _pulloff_options PROGRAM VERB: prints the options that the help lists on lines "  --NAME VALUE   text".
_pulloff_options() { "$1" "$2" --help 2>/dev/null | sed -n '/^  -/{s/^  //; s/   *.*//; p;}' | grep -o -e '--[a-z][a-z0-9-]*'; }

# _pulloff_values OPTION PROGRAM: prints the values of an option that are names.
_pulloff_values() {
  case $1 in
  --scheme) echo ring triangle panel ;;
  --grading) echo uniform graded ;;
  --law) echo lennard-jones mie: morse: ;;
  --profile) echo sphere power: cone: punch: truncated: ;;
  --scale) echo log linear ;;
  --of) echo pull-off folds ;;
  --want) echo curve profile hysteresis preload diagnostics theories ;;
  --theory) echo rigid dmt jkr maugis carpick-ogletree-salmeron pietrement-troyon schwarz guduru kesari-lew persson-tosatti rumpf-rabinowicz ;;
  --suite) echo smoke paper extreme general precision random solvers theories ;;
  --key) "$2" follow --help 2>/dev/null | sed -n '/^  --key /,/^  --from /{/--/d; p;}' | grep -o '[a-z][a-z0-9-]*' | grep -vx -e or -e in -e units ;;
  --preload | --outer-radius | --modulus-pa) echo inf ;;
  esac
}

# The lengths that --from-physical takes in metres, as --NAME-m.
_pulloff_lengths=' --profile-approach --approach --contact-radius '

_pulloff() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb=${COMP_WORDS[1]}
  local words='' action=() option
  case $COMP_CWORD:$before in
  1:*) words="$(_pulloff_names "$program") --help --version" ;;
  *:--output | *:--run) action=(-d) ;;
  *:--curve | *:--profile-csv | *:--profile-file | *:--staircase | *:--plot | *:--junit) action=(-f) ;;
  *:--*) words=$(_pulloff_values "$before" "$program") ;;
  esac
  if [ -z "$words" ] && [ ${#action[@]} -eq 0 ]; then
    case $word:$verb in
    -*)
      for option in $(_pulloff_options "$program" "$verb"); do
        words="$words $option"
        [[ " ${COMP_WORDS[*]} " != *' --from-physical '* || $_pulloff_lengths != *" $option "* ]] || words="$words $option-m"
      done
      ;;
    *:plan | *:plot | *:run | *:verify | *:explain | *:bless)
      words=$("$program" list 2>/dev/null | awk 'NR > 1 { print $1 }')
      action=(-f -X '!*.yaml')
      ;;
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
