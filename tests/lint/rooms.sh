#!/usr/bin/env bash
# Holds every #include of the project against rooms.rules.
source "$(dirname "$0")/common.sh"

mapfile -t rules < <(grep -v -e '^#' -e '^$' tests/lint/rooms.rules)

allowed() { # FILE INCLUDE
    local rule pattern patterns
    for rule in "${rules[@]}"; do
        read -ra patterns <<<"$rule"
        # shellcheck disable=SC2053 # the right sides are patterns
        [[ $1 == ${patterns[0]} ]] || continue
        for pattern in "${patterns[@]:1}"; do
            # shellcheck disable=SC2053
            [[ $2 != $pattern ]] || return 0
        done
    done
    return 1
}

count=0
while IFS=: read -r file line include; do
    include=${include#"${include%%[<\"]*}"} include=${include%%[[:space:]]*}
    count=$((count + 1))
    [[ ! $include =~ ^\<[a-z0-9_]+\>$ ]] || continue # <vector>
    allowed "$file" "$include" || problem "$file:$line: ${file%%/*} must not include $include here (tests/lint/rooms.rules)"
done < <(sources '*.hpp' '*.cpp' '*.h' | xargs grep -HnE '^[[:space:]]*#[[:space:]]*include')
finish "includes" $count
