#!/usr/bin/env bash
# A source of more than 500 lines or a shader of more than 150 is more than one thing.
source "$(dirname "$0")/common.sh"

count=0
check() { # WARN_ABOVE LIMIT PATTERN...
    local lines file
    while read -r lines file; do
        count=$((count + 1))
        if ((lines > $2)); then
            problem "$file: $lines lines, more than $2"
        elif ((lines > $1)); then
            echo "warning: $file: $lines lines, aim for $1"
        fi
    done < <(sources "${@:3}" | xargs -r wc -l | grep -v ' total$')
}
check 300 500 '*.hpp' '*.cpp' '*.h'
check 150 150 '*.vert' '*.frag' '*.geom' '*.comp' '*.glsl'
finish "files" $count
