# Completion of `evc` for bash: source this file, or put it into /usr/share/bash-completion/completions/evc.
_evc() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} kind=${COMP_WORDS[2]}
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 ]]; then
    mapfile -t COMPREPLY < <(compgen -W "run replay serve curves decode encode describe make-line check track explain dmi cab sweep brakes --help --version" -- "$word")
    return
  fi
  case $before in
    --sv) mapfile -t COMPREPLY < <(compgen -W "1.0 1.1 2.0 2.1" -- "$word"); return ;;
    -o | --output | --pcapng | --config) mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
  esac
  if [[ $COMP_CWORD -eq 2 ]]; then
    case $command in
      decode | encode) mapfile -t COMPREPLY < <(compgen -W "balise airgap radio packet" -- "$word"); return ;;
      describe) mapfile -t COMPREPLY < <(compgen -W "packets variables messages schema modes" -- "$word"); return ;;
    esac
  fi
  if [[ $word == -* ]]; then
    # Every command lists its own options.
    local options
    options=$("${COMP_WORDS[0]}" "$command" $([[ $command == decode || $command == encode || $command == describe ]] && echo "$kind") --help 2>/dev/null |
      grep -oE -- '(^|[ ,])--?[a-z][a-z-]*' | tr -d ' ,')
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
    return
  fi
  if [[ $command == describe && $COMP_CWORD -eq 3 ]]; then
    case $kind in
      packets | messages) mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" describe "$kind" 2>/dev/null | grep -oE ' +[0-9]+ ' | sort -un)" -- "$word") ;;
      variables) mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" describe variables 2>/dev/null | cut -d' ' -f1)" -- "$word") ;;
    esac
    return
  fi
  mapfile -t COMPREPLY < <(compgen -f -- "$word")
}
complete -o filenames -F _evc evc
