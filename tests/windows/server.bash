# What with_x11 and with_wayland share. A server lives as long as the script that started it: it ends with the script's
# exit, with its signals, and by the kernel's word (pdeathsig) when the script is killed.

server=
command=

end_server() {
  trap '' INT TERM HUP
  [[ -z ${command} ]] || kill -TERM "${command}" 2>/dev/null || true
  if [[ -n ${server} ]]; then
    kill -TERM "${server}" 2>/dev/null || true
    wait "${server}" 2>/dev/null || true
  fi
  [[ -z ${folder} ]] || rm -rf -- "${folder}"
}

die() {
  echo "${0##*/}: $1" >&2
  [[ ! -s ${folder}/log ]] || cat -- "${folder}/log" >&2
  exit 125
}

# A temporary folder that goes with the server; the server's words are in its file log.
begin_server() {
  folder=$(mktemp -d)
  trap end_server EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM
  trap 'exit 129' HUP
}

# Runs the command and exits with its status, 128 and the signal's number if one ended it.
run_command() {
  local status=0
  setpriv --pdeathsig KILL -- "$@" <&0 &
  command=$!
  wait "${command}" || status=$?
  command=
  exit "${status}"
}
