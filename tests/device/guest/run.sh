#!/usr/bin/env bash
# usage: run.sh PROGRAM [arguments]
# Runs a program as root inside a guest: a user-mode Linux kernel (see build_kernel.sh) with vivid,
# uvcvideo, USB/IP and vgem, whose files are the host's and whose writes vanish. Exit code: the
# program's; 77: no guest can be had here, why. AUTOSTEREO_GUEST_SECONDS bounds it (300);
# AUTOSTEREO_GUEST_URGENT=1: it runs before all else on this machine (a processor of its own for frames
# that must be on time). Of the environment the program gets what is named below.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
passed_on='^(AUTOSTEREO_|GTEST_|ASAN_|UBSAN_|TSAN_|LIBGL_|XDG_CACHE_HOME)'

program=$(command -v "${1:-}") || { echo "usage: run.sh PROGRAM [arguments]: no program '${1:-}'"; exit 2; }

kernel=$("$here/build_kernel.sh") || {
    code=$?
    # Where the kernel can be built a test has no excuse to skip.
    [[ $code != 77 || ,${AUTOSTEREO_REQUIRE:-}, != *,device,* ]] || code=1
    exit $code
}
command -v busybox >/dev/null || { echo "skipped: no busybox here (package busybox)"; exit 77; }

# The guest's memory is a file; one in memory is faster where there is room for it.
memory_mib=2048 memory_folder=${TMPDIR:-/tmp}
if (($(df --output=avail -m /dev/shm 2>/dev/null | tail -n 1 || echo 0) > memory_mib)); then
    memory_folder=/dev/shm
fi
exchange=$(mktemp -d -p "$memory_folder")
trap 'rm -rf "$exchange"' EXIT
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
TMPDIR=$memory_folder timeout --foreground -k 5 "${AUTOSTEREO_GUEST_SECONDS:-300}" \
    "${urgent[@]}" "$kernel" mem=${memory_mib}M root=/dev/root rootfstype=hostfs rootflags=/ ro init="$here/init.sh" \
    exchange="$exchange" uml_dir="$exchange/" con=null con0=fd:0,fd:1 console=tty0 quiet \
    vivid.n_devs=1 vivid.node_types=0x1 vivid.num_inputs=1 vivid.input_types=0 \
    </dev/null 2>&1 | grep -v --line-buffered \
    -e '^Failed to initialize ubd' -e '^reboot: System halted' || true
if [[ ! -s $exchange/status ]]; then
    echo "the guest ended without a status (killed after ${AUTOSTEREO_GUEST_SECONDS:-300} s?)"
    exit 1
fi
exit "$(<"$exchange/status")"
