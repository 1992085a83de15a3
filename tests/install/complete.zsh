# Starts a zsh on a terminal, types the first argument and a tab, and tests that the line is completed by the second one.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1=; fpath=($COMPLETIONS \$fpath); autoload -U compinit; compinit -u -D; bindkey '^I' complete-word; print rea''dy"
typeset chunk seen=
repeat 200; do
  while zpty -r -t shell chunk 2>/dev/null; do seen+=$chunk; done
  [[ $seen == *ready* ]] && break
  sleep 0.05
done
zpty -w -n shell "$1"$'\t'
seen=
repeat 100; do
  while zpty -r -t shell chunk 2>/dev/null; do seen+=$chunk; done
  [[ $seen == *$1$2* || -n $2 && $seen == *$1*$2* ]] && exit 0
  sleep 0.05
done
print -r -- "${(V)seen}"
exit 1
