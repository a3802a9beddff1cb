#!/usr/bin/env bash
# Every source reads as clang-format writes it.
source "$(dirname "$0")/common.sh"
need clang-format

mapfile -t files < <(sources '*.hpp' '*.cpp' '*.h')
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 20 clang-format --dry-run -Werror ||
    problem "run clang-format -i on the files above"
finish "files" ${#files[@]}
