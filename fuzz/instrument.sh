#!/bin/sh
# Compiles the workspace's own crates so that the fuzzer sees which code has run; for RUSTC_WORKSPACE_WRAPPER. Dependencies stay as they are,
# and a stable compiler is enough. Less optimised and without lines, it compiles in a third of the time.
exec "$@" -Copt-level=1 -Cdebuginfo=0 -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares
