# Completion of anteroom-info for bash.
_anteroom_info() {
  COMPREPLY=($(compgen -W "--brief --json --version --help" -- "${COMP_WORDS[COMP_CWORD]}"))
}
complete -F _anteroom_info anteroom-info
