#!/usr/bin/env bash
# usage: tidy.sh --changed|--all BUILD_FOLDER
# clang-tidy on the sources of BUILD_FOLDER's compile_commands.json: on all of them, or for at most
# three minutes on those that differ from the main branch (on main itself: from 30 commits ago) or
# include a header that does. Too slow for a lint of every ctest run: 2 to 14 s a file.
source "$(dirname "$0")/common.sh"
need clang-tidy
[[ ${1:-} == --@(all|changed) && -f ${2:-}/compile_commands.json ]] ||
    { sed -n '2s/^# //p' tests/lint/tidy.sh; exit 2; }
build=$2

# What changes are measured against; the empty tree where history is too short to tell.
base() {
    local branch commit
    for branch in origin/main main; do
        commit=$(git merge-base HEAD "$branch" 2>/dev/null) || continue
        [[ $commit == "$(git rev-parse HEAD)" ]] || { echo "$commit"; return; }
    done
    commit=$(git rev-list --skip=30 -n 1 HEAD)
    echo "${commit:-$(git hash-object -t tree /dev/null)}"
}

changed_sources() {
    local file
    { git diff --name-only "$(base)"; git ls-files -o --exclude-standard; } | while read -r file; do
        case $file in
        *.cpp) echo "$file" ;;
        *.hpp) grep -rlF --include='*.cpp' "#include \"$file\"" "${rooms[@]}" || true ;;
        esac
    done | sort -u
}

tidy_one() {
    if ((EPOCHSECONDS < deadline)); then
        clang-tidy -p "$build" --quiet "$1" 2>/dev/null || { echo "found in $1"; exit 1; }
    else
        echo "$1" >>"$left_out"
    fi
}

if [[ $1 == --all ]]; then
    candidates=$(sources '*.cpp') deadline=$((EPOCHSECONDS + 86400))
else
    candidates=$(changed_sources) deadline=$((EPOCHSECONDS + 180))
fi
mapfile -t files < <(for file in $candidates; do
    ! grep -qF "\"$PWD/$file\"" "$build/compile_commands.json" || echo "$file"
done)
echo "clang-tidy on ${#files[@]} sources"
((${#files[@]})) || exit 0
left_out=$(mktemp)
trap 'rm -f "$left_out"' EXIT
export -f tidy_one
export build deadline left_out
# shellcheck disable=SC2016 # the inner bash expands it
status=0
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 bash -c 'tidy_one "$1"' tidy_one || status=1
[[ ! -s $left_out ]] || echo "no time left for $(wc -l <"$left_out") of them"
exit $status
