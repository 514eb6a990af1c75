# Completion of anteroom-cache for bash.
_anteroom_cache() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb= i
  local verbs="list show diff explain stats report verify prune warm export import merge"
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i - 1]} != -f && ${COMP_WORDS[i - 1]} != --file && " ${verbs} " == *" ${COMP_WORDS[i]} "* ]] &&
      verb=${COMP_WORDS[i]} && break
  done
  case ${before} in
    -f | --file) COMPREPLY=($(compgen -f -- "${word}")) && return ;;
    --sort) COMPREPLY=($(compgen -W "uses compile size age" -- "${word}")) && return ;;
    --color) COMPREPLY=($(compgen -W "auto always never" -- "${word}")) && return ;;
    -n | --limit | --unused | --program | --device) return ;;
  esac
  local options="--file --json --help"
  case ${verb} in
    "") COMPREPLY=($(compgen -W "${verbs} ${options} --version" -- "${word}")) && return ;;
    list) options+=" --sort -n --pipelines" ;;
    show | diff) options+=" --color" ;;
    explain) options+=" --program" ;;
    verify) options+=" --repair" ;;
    prune) options+=" --limit --unused" ;;
    warm) options+=" --device" ;;
  esac
  if [[ ${word} == -* ]]; then
    COMPREPLY=($(compgen -W "${options}" -- "${word}"))
  elif [[ ${verb} == show || ${verb} == diff ]]; then
    local given=() keys
    for ((i = 1; i < COMP_CWORD; ++i)); do
      [[ ${COMP_WORDS[i]} == -f || ${COMP_WORDS[i]} == --file ]] && given=(--file "${COMP_WORDS[i + 1]}")
    done
    keys=$({ "${COMP_WORDS[0]}" "${given[@]}" list; "${COMP_WORDS[0]}" "${given[@]}" list --pipelines; } 2>/dev/null |
      grep -oE '^[0-9a-f]{16}')
    COMPREPLY=($(compgen -W "${keys}" -- "${word}"))
  elif [[ ${verb} == report || ${verb} == export || ${verb} == import || ${verb} == merge ]]; then
    COMPREPLY=($(compgen -f -- "${word}"))
  fi
}
complete -o filenames -F _anteroom_cache anteroom-cache
