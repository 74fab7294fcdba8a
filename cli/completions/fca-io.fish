# SPDX-License-Identifier: BSD-3-Clause
# What fish proposes for fca-io: the command itself says it.
function __fca_io_proposals
    set -l typed (commandline -opc)[2..] (commandline -ct)
    for word in (fca-io complete $typed 2>/dev/null)
        if test "$word" = :files
            __fish_complete_path (commandline -ct)
        else
            echo $word
        end
    end
end
complete -c fca-io -f -a '(__fca_io_proposals)'
