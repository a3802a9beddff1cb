#!/usr/bin/env bash
# Every source reads as clang-format writes it.
source "$(dirname "$0")/common.sh"
need clang-format

mapfile -t files < <(sources '*.hpp' '*.cpp' '*.h')
while read -r file; do
    problem "clang-format -i $file"
done < <(printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -I{} \
    sh -c 'clang-format --dry-run -Werror {} 2>/dev/null || echo {}')
finish "files" ${#files[@]}
