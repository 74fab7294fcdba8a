# SPDX-License-Identifier: BSD-3-Clause
# What bash proposes for fca-io: the command itself says it.
_fca_io() {
  local i typed=("${COMP_WORDS[@]:1:COMP_CWORD}")
  ((${#typed[@]})) || typed=("")
  for i in "${!typed[@]}"; do  # as they are typed: with quotes and backslashes
    typed[i]=${typed[i]//[\\\'\"]/}
  done
  mapfile -t COMPREPLY < <("${COMP_WORDS[0]}" complete "${typed[@]}" 2>/dev/null)
  [[ ${COMPREPLY[-1]-} == :files ]] || return
  unset 'COMPREPLY[-1]'
  ((${#COMPREPLY[@]})) || compopt -o default
}
complete -F _fca_io fca-io
