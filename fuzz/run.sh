#!/usr/bin/env bash
# Fuzzes the readers: fuzz/run.sh [--keep] SECONDS [TARGET...]; see docs/fuzzing.md.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_INCREMENTAL=0

keep=no
[ "${1:-}" = --keep ] && { keep=yes; shift; }
seconds=${1:-10}
shift || true
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(spec golden rom scene mesh netlist sweep results tables reflectance)

RUSTC_WORKSPACE_WRAPPER=$PWD/fuzz/instrument.sh cargo build --locked --profile test --features fuzz --example fuzz
mkdir -p target/fuzz
cp target/debug/examples/fuzz target/fuzz/fuzzer

# Inputs of more than 4 kB are slow and find nothing that a smaller one does not.
limits="-timeout=10 -rss_limit_mb=1024 -max_len=4096 -print_final_stats=1 -verbosity=0"

fuzz() {
    work=target/fuzz/$1
    mkdir -p "$work/corpus" "fuzz/regressions/$1"
    # shellcheck disable=SC2086
    if BRDFGEN_FUZZ=$1 target/fuzz/fuzzer $limits -max_total_time="$2" -artifact_prefix="$work/" \
        "$work/corpus" "fuzz/corpus/$1" "fuzz/regressions/$1" >"$work/log" 2>&1; then
        echo "$1: $(sed -n 's/^stat::number_of_executed_units: *//p' "$work/log") inputs, none fails"
    else
        tail -40 "$work/log"
        echo "$1: an input fails, kept in $work"
        return 1
    fi
    if [ "$3" = yes ]; then
        BRDFGEN_FUZZ=$1 target/fuzz/fuzzer -timeout=10 -max_len=4096 -merge=1 "fuzz/corpus/$1" "$work/corpus" >>"$work/log" 2>&1
    fi
}
export -f fuzz
export limits

printf '%s\n' "${targets[@]}" | xargs -P 2 -I {} bash -c "fuzz {} $seconds $keep"
