#!/usr/bin/env bash
# usage: run.sh BUILD_FOLDER FUZZER [libFuzzer options]
# One fuzzer from fresh seeds; what breaks it is kept as BUILD_FOLDER/FUZZER-crash-*.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$1 fuzzer=$2
corpus=$(mktemp -d)
trap 'rm -rf "$corpus"' EXIT
"$build/tests/fuzz/fuzz_seeds" "$corpus" "$root" "${AUTOSTEREO_DATA:-$root/../shared/data}"
"$build/tests/fuzz/${fuzzer}_fuzz" -seed=1 -max_len=8192 -rss_limit_mb=2048 -timeout=20 \
    -verbosity=0 -print_funcs=0 -print_final_stats=1 -artifact_prefix="$build/$fuzzer-" \
    "${@:3}" "$corpus/$fuzzer" 2>&1 | grep -vE '^"|^#{6} ' || # the words it found, a hundred lines
    { echo "$fuzzer: see above, and $build/$fuzzer-*"; exit 1; }
