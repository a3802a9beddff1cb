# Shared by the lints, which run in the project's root; sourced by bash, never run.
# shellcheck shell=bash
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly rooms=(calib devices gpu config daemon tests)

# sources PATTERN...: files of the rooms whose name matches one of the patterns, sorted.
sources() {
    local names=()
    for pattern; do names+=(-o -name "$pattern"); done
    find "${rooms[@]}" -type f \( "${names[@]:1}" \) | sort
}

# need TOOL: every lint tool is a package of tests/run, so a missing one is a failure.
need() { command -v "$1" >/dev/null || { echo "$1 is not installed (tests/run does that)"; exit 1; }; }

problems=0
problem() { echo "$*"; problems=$((problems + 1)); }
# finish WHAT COUNT: a lint that looked at nothing must not be green.
finish() {
    echo "$2 $1, $problems problems"
    exit $((problems > 0 || $2 == 0))
}
