# shellcheck shell=sh
# Bodies of three moments: errors, orders and prices of ours and of what others use. Sourced by ./dev, behind
# figures.sh.

# Every method for such bodies but those that only differ in their order from another here.
GENERAL=exact,vti1,vti2,suzuki4,srkn6,srkn11,kl8,no-squish,lammps-asphere,fincham,yade-aspherical,buss
GENERAL=$GENERAL,moser-veselov,moser-veselov-newton
GENERAL=$GENERAL,implicit-midpoint,spiral-aspherical,rk4,dop853

# measure FOLDER SCENE [vti-study options]: a study with all of these.
measure() {
    into=$1
    scene=$2
    shift 2
    echo "dev: $into"
    build/drivers/vti-study --no-plot --force --steppers "$GENERAL" -o "$into" "$@" "$scene" \
        >"$into.txt" 2>&1 || [ $? = 3 ] ||
        { tail -n 1 "$into.txt" >&2; return 1; }
}

# free NAME MOMENTS: a free body as a scene.
free() {
    printf 'name: %s\nbodies: {moments: %s, alpha: [0, 0, 0], omega: [0.3, 1.1, -0.4]}\nh: 0.1\nt_end: 20\n' "$1" "$2"
}

# heavy FOLDER: a top without symmetry, and two such bodies on a bond, made of scenes/pair.yaml.
heavy() {
    cat >"$1/heavy-top.yaml" <<SCENE
name: heavy-top
bodies:
  moments: [0.6, 1, 1.5]
  alpha: [0.7725883941, 0.7725883941, 0]        # turned by 1 about the diagonal of x and y
  omega: [-0.0550355846, -0.1615684232, 1.1965986510]
pendulum: {weight: 1, rho0: [-0.3, -0.2, -0.9]}
h: 0.05
t_end: 8
SCENE
    sed -e 's/^name: .*/name: bonded-pair/' -e 's/^  mass: 1 .*/  mass: 1\n  moments: [0.06, 0.1, 0.15]/' \
        scenes/pair.yaml >"$1/bonded-pair.yaml"
}

# inertia FOLDER [INTO]: all of it, and the page.
inertia() {
    mkdir -p "$1"
    free free-body '[1, 1.7, 2.3]' >"$1/free-body.yaml"
    free slender-body '[1.7231, 0.0658, 1.7243]' >"$1/slender-body.yaml"
    heavy "$1"
    measure "$1/table-free-body" "$1/free-body.yaml" --h 0.1 --t-end 20
    measure "$1/table-slender-body" "$1/slender-body.yaml" --h 0.1 --t-end 20
    measure "$1/table-heavy-top" "$1/heavy-top.yaml" --h 0.05 --t-end 8
    measure "$1/table-bonded-pair" "$1/bonded-pair.yaml" --h 1/160 --t-end 4
    measure "$1/orders-free-body" "$1/free-body.yaml" --h 0.1,0.05,0.025,0.0125 --t-end 10
    measure "$1/orders-heavy-top" "$1/heavy-top.yaml" --h 0.1,0.05,0.025,0.0125 --t-end 4
    measure "$1/orders-bonded-pair" "$1/bonded-pair.yaml" --h 1/128:1/1024 --t-end 2
    echo "dev: $1/cost"
    build/drivers/vti-study --cost --no-plot --force --repeats 5 -o "$1/cost" "$1/free-body.yaml" "$1/heavy-top.yaml" \
        >"$1/cost.txt"
    PYTHONPATH=drivers PYTHONDONTWRITEBYTECODE=1 python3 -m plot.pages.inertia "$1" ${2:+--into "$2"}
}
