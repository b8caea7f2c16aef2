# shellcheck shell=sh
# ranks PROGRAM [ARGUMENTS]: a program of MPI on all cores, for ./dev.
#
# Open MPI's mpirun ends its ranks a second after Ctrl-C or SIGTERM (from 5 on half a second, and their words are lost)
# and says 1 whatever they say; SIGUSR1 it hands on, and then its code is theirs. So it gets a session of its own, which
# Ctrl-C does not reach, and SIGUSR1 from us; whoever asks twice does not want to wait.
ranks() {
    $(command -v setsid) mpirun -n "${RANKS:-$(nproc)}" "$@" &
    launched=$!
    number=USR1
    trap 'kill -$number "$launched"; number=TERM' INT TERM HUP
    code=0
    wait "$launched" || code=$?
    while kill -0 "$launched" 2>/dev/null; do # that was one of the signals
        code=0
        wait "$launched" || code=$?
    done
    trap - INT TERM HUP
    return $code
}
