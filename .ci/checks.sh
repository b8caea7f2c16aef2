# shellcheck shell=sh
# The tests, and what looks at the code besides them. Sourced by ./dev.

# vtk: ParaView's readers for the one test that asks them, by pip into a folder that outlives build/. Where that cannot
# be had the test says that it is skipped.
vtk() {
    [ -f build-vtk/complete ] && return 0
    echo "dev: fetching VTK into build-vtk (450 MB, once)"
    {
        (need_packages python3-venv) && python3 -m venv --clear --system-site-packages build-vtk &&
            build-vtk/bin/pip install --retries 1 --timeout 20 --disable-pip-version-check vtk==9.5.2 &&
            touch build-vtk/complete
    } >build/vtk.log 2>&1 || echo "dev: VTK cannot be had (see build/vtk.log); the test vtk is skipped" >&2
}

# fuzz SECONDS: libFuzzer, each target for its share of the time and on from what it had found before.
fuzz() {
    need study tests more
    need_clang
    CC=clang configure build-fuzz -Dfuzz=true -Dfortran=disabled -Dtests=enabled -Dbuildtype=debugoptimized \
        -Db_sanitize=address,undefined -Db_lundef=false \
        -Dc_args='-fsanitize=fuzzer-no-link -fsanitize=float-cast-overflow'
    for target in scene table set; do
        seeds=tests/hard/fuzz/corpus/$target
        [ $target = scene ] && seeds="$seeds scenes"
        mkdir -p build-fuzz/inputs/$target
        ninja -C build-fuzz --quiet tests/hard/fuzz/fuzz_$target
        echo "dev: any bytes as a $target for $(($1 / 3)) s"
        # shellcheck disable=SC2086
        UBSAN_OPTIONS=halt_on_error=1 nice build-fuzz/tests/hard/fuzz/fuzz_$target -max_total_time=$(($1 / 3)) \
            -max_len=4096 -timeout=20 -dict=tests/hard/fuzz/scene.dict -artifact_prefix=build-fuzz/found-$target- \
            -verbosity=0 -print_final_stats=1 build-fuzz/inputs/$target $seeds
    done
}

# Compilers take minutes under their sanitizers for the kernels of each wider vector unit, which are the same source:
# these builds do without them. Valgrind sees those of the machine.

# core [meson test options]: the core's tests by clang, under its sanitizers (divisions by zero among them, which gcc
# cannot do without the one that is meant), and what they reach: clang counts branches as they are written, not as they
# are compiled.
core() {
    export LLVM_PROFILE_FILE="$PWD/build-core/raw/%m.profraw" # of what configuring runs as well
    CC=clang configure build-core -Ddrivers=disabled -Dcheck=disabled -Dfortran=disabled -Dtests=enabled \
        -Dvectors=baseline -Dbuildtype=debugoptimized -Db_sanitize=address,undefined -Db_lundef=false \
        -Dc_args="-fprofile-instr-generate -fcoverage-mapping -fsanitize=float-divide-by-zero,float-cast-overflow \
        -fno-sanitize-recover=all -fsanitize-ignorelist=$PWD/tests/hard/divides.txt" \
        -Dc_link_args=-fprofile-instr-generate
    rm -rf build-core/raw
    ASAN_OPTIONS=detect_leaks=0 run_tests build-core --suite unit --suite property --no-suite slow --no-suite cost \
        --no-suite builds --no-suite runs "$@"
    python3 tests/hard/coverage.py build-core
}

# sanitize [meson test options]: by gcc, which goes on after undefined behaviour unless it is told not to.
sanitize() {
    configure build-sanitize -Dvectors=baseline -Db_sanitize=address,undefined -Db_lundef=false \
        -Dbuildtype=debugoptimized \
        -Dc_args='-fsanitize=float-cast-overflow -fno-sanitize-recover=undefined,float-cast-overflow'
    # Open MPI and HDF5 keep memory to the end of the process: valgrind looks for leaks, in the core's tests, which use
    # neither.
    ASAN_OPTIONS=detect_leaks=0 run_tests build-sanitize --timeout-multiplier 4 --no-suite slow --no-suite bits "$@"
}

# memory: the core's tests as they are, and those of its Fortran interfaces, under valgrind
memory() {
    build
    meson test -C build --suite unit --suite lists --suite fortran --print-errorlogs --timeout-multiplier 4 \
        --wrapper "sh $PWD/tests/hard/memcheck.sh"
}

# test_names FOLDER [meson test options]: names among them that are no test's, which meson passes over without a word.
test_names() {
    names=$(meson test -C "$1" --list 2>/dev/null | sed -n 's|^.* / ||p')
    shift
    value=no
    for name; do
        case $value$name in
        no--suite | no--no-suite | no-j | no--num-processes | no-t | no--timeout-multiplier | no--maxfail | \
            no--repeat | no--wrap* | no--setup | no--test-args | no--logbase | no--gdb-path) value=yes ;;
        yes* | no-* | no*:*) value=no ;;
        *)
            echo "$names" | (
                while read -r known; do
                    # shellcheck disable=SC2254 # names may be patterns
                    case $known in $name) exit 0 ;; esac
                done
                exit 1
            ) || {
                near=$(echo "$names" | grep -F -- "$name" | head -n 3 | sed "s/.*/'&'/" | paste -sd ,)
                echo "dev: '$name' is not a test; meson test -C build --list has them all${near:+, among them $near}" \
                    >&2
                return 1
            }
            ;;
        esac
    done
}

# run_tests FOLDER [meson test options]: the runner's own lines, then its counts in one.
run_tests() {
    folder=$1
    shift
    code=0
    meson test -C "$folder" --print-errorlogs "$@" || code=$?
    awk '/^Ok:/ { ok = $2 } /^(Fail|Unexpected Pass|Timeout):/ { bad += $NF } /^Skipped:/ { skipped = $2 }
         END { printf "%d passed, %d failed, %d skipped\n", ok, bad, skipped }' "$folder/meson-logs/testlog.txt"
    return "$code"
}
