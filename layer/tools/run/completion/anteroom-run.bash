# Completion of anteroom-run for bash: its options, then a program and what that program completes.
_anteroom_run() {
  local word=${COMP_WORDS[COMP_CWORD]} i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    if [[ ${COMP_WORDS[i]} != --* ]]; then
      # Of bash-completion, which loads this file.
      declare -F _command_offset >/dev/null && _command_offset "${i}"
      return
    fi
  done
  if [[ ${word} == -* ]]; then
    COMPREPLY=($(compgen -W "--drop-in --glvnd --version --help" -- "${word}"))
  else
    COMPREPLY=($(compgen -c -- "${word}") $(compgen -f -- "${word}"))
  fi
}
complete -o filenames -F _anteroom_run anteroom-run
