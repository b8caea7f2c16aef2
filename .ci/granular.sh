# shellcheck shell=sh
# Beads that flow and come to rest: columns, angles of repose, the drum, rebounds. Sourced by ./dev, behind figures.sh.

# beads FOLDER [vti-run options]: the scene of the column with other numbers, its first and its last frame.
beads() {
    into=$1
    shift
    mkdir -p "$into"
    echo "dev: $into"
    build/drivers/vti-run --no-dump scenes/column.yaml "$@" --threads 1 --record 500 --frames 1e6 \
        -o "$into/out.h5" >"$into/run.txt" 2>&1 ||
        { tail -n 1 "$into/run.txt" >&2; return 1; }
}

# pour FOLDER WIDTH BEADS SEED: beads settled in a box of so many diameters; their table is FOLDER/beads.csv.
pour() {
    mkdir -p "$1"
    python3 bench/granular/packing.py loose "$2" "$3" "$4" "$1/loose.csv"
    beads "$1" --set bodies.table="$(realpath "$1/loose.csv")" --set dashpot.restitution=0.2 --h 2e-5 --t-end 0.4 \
        --set wall.planes="[[0,0,1,0],[1,0,0,0],[-1,0,0,-$(awk "BEGIN {print 0.00303 * $2}")]]" \
        --set friction.wall_sliding=[0.8,0,0]
    python3 bench/granular/packing.py settled "$1/out.h5" "$1/beads.csv"
}

# columns FOLDER: run-out against height, of three packings each; high ones take longer.
columns() {
    for seed in 1 2 3; do
        for count in 50 75 100 150 200 300 450 700 1000; do
            pour "$1/poured-$count-$seed" 10 $count $seed
            beads "$1/column-$count-$seed" --set bodies.table="$(realpath "$1/poured-$count-$seed/beads.csv")" \
                --h 2e-5 --t-end "$([ $count -gt 300 ] && echo 1 || echo 0.7)"
        done
    done
}

# slopes FOLDER: angles of repose against friction, for two lengths of rolling resistance and four packings.
slopes() {
    for seed in 1 2 3 4; do
        pour "$1/box-$seed" 25 250 $seed
        for rolling in 0.00003 0.0003; do
            for mu in 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8; do
                beads "$1/repose-$mu-$rolling-$seed" --set bodies.table="$(realpath "$1/box-$seed/beads.csv")" \
                    --h 2e-5 --t-end 0.6 --set friction.sliding=$mu --set friction.rolling=$rolling
            done
        done
    done
}

# granular FOLDER [INTO]: all of it by two processes, and the page. Nothing of an earlier run stays, which may have had
# other packings.
granular() {
    rm -f "$1"/column-*/out.h5 "$1"/repose-*/out.h5
    columns "$1" &
    beside=$!
    # What runs beside is deaf to Ctrl-C, as sh has it, and would go on for minutes; a run that has begun ends by
    # itself.
    trap 'kill "$beside" 2>/dev/null || true' EXIT
    trap 'exit 1' INT TERM HUP
    slopes "$1"
    wait "$beside"
    trap - EXIT INT TERM HUP
    run "$1/drum" drum --t-end 12 --frames 500    # 0.01 s: the bed swings with a period of 0.4
    run "$1/billiards" billiards
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.granular "$1" ${2:+--into "$2"}
}
