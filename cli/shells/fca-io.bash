# SPDX-License-Identifier: BSD-3-Clause
# What bash proposes for fca-io: the command itself says it.
_fca_io() {
  local word proposals
  local typed=("${COMP_WORDS[@]:1:COMP_CWORD}")
  ((${#typed[@]})) || typed=("")
  mapfile -t proposals < <("${COMP_WORDS[0]}" complete "${typed[@]}" 2>/dev/null)
  COMPREPLY=()
  for word in "${proposals[@]}"; do
    if [[ $word == :files ]]; then
      mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "${typed[-1]}")
      compopt -o filenames
    else
      COMPREPLY+=("$word")
    fi
  done
}
complete -F _fca_io fca-io
