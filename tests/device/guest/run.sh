#!/usr/bin/env bash
# usage: run.sh PROGRAM [arguments]
# Runs a program as root inside a guest: a user-mode Linux kernel (see build_kernel.sh) with vivid,
# uvcvideo, USB/IP and vgem, whose files are the host's and whose writes vanish. Exit code: the
# program's; 77: no guest can be had here, why. AUTOSTEREO_GUEST_SECONDS bounds it (300);
# AUTOSTEREO_GUEST_URGENT=1: it runs before all else on this machine (a processor of its own for frames
# that must be on time). Of the environment the program gets what is named below.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source "$here/boot.sh"
passed_on='^(AUTOSTEREO_|GTEST_|ASAN_|UBSAN_|TSAN_|LIBGL_|XDG_CACHE_HOME)'

program=$(command -v "${1:-}") || { echo "usage: run.sh PROGRAM [arguments]: no program '${1:-}'"; exit 2; }

command -v busybox >/dev/null || { echo "skipped: no busybox here (package busybox)"; exit 77; }
prepare_guest
{
    while read -r name; do
        [[ ! $name =~ $passed_on ]] || printf 'export %s=%q\n' "$name" "${!name}"
    done < <(compgen -e)
    # One processor: threads of llvmpipe would only wait for each other, four times as long in all.
    echo 'export LP_NUM_THREADS=0'
    # A page's first touch costs a guest 0.2 ms, a colour picture's 0.5 s: what was freed is kept.
    echo 'export GLIBC_TUNABLES=glibc.malloc.arena_max=1:glibc.malloc.mmap_threshold=33554432:glibc.malloc.trim_threshold=2147483647'
    printf 'cd %q\n' "$PWD"
    printf '%q ' exec "$program" "${@:2}"
} >"$exchange/command"

urgent=()
[[ ${AUTOSTEREO_GUEST_URGENT:-0} != 1 ]] || urgent=(chrt --rr 1)
boot_guest 300 / "$here/init.sh" "${urgent[@]}" | grep -v --line-buffered \
    -e '^Failed to initialize ubd' -e 'reboot: ' || true
if [[ ! -s $exchange/status ]]; then
    echo "the guest ended without a status (killed after ${AUTOSTEREO_GUEST_SECONDS:-300} s?)"
    exit 1
fi
exit "$(<"$exchange/status")"
