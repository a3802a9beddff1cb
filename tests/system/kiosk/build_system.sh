#!/usr/bin/env bash
# usage: build_system.sh PACKAGE.deb
# A Debian system with nothing but what the package asks for, systemd, a bare X server and a bare
# compositor: prints its folder. It is built once for a list of packages (two minutes, 700 MB; root and a package mirror
# needed) into the cache; the package itself is not in it. Exit code 77: cannot be built here, why.
set -euo pipefail
skip() { echo "skipped: no system to boot: $*" >&2; exit 77; }

packages=(systemd-sysv udev dbus xserver-xorg-core x11-xserver-utils x11-apps
    cage seatd xwayland grim)
mapfile -t depends < <(dpkg-deb -f "$1" Depends | sed 's/([^)]*)//g; s/|[^,]*//g; s/ //g; s/,/\n/g')
packages+=("${depends[@]}")
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
list=$(printf '%s\n' "$suite" "${packages[@]}" | sort -u | sha256sum)
folder=${XDG_CACHE_HOME:-$HOME/.cache}/autostereo
system=$folder/debian-${list:0:8}

((EUID == 0)) || skip "only root can make one"
mkdir -p "$folder"
exec 9>"$folder/lock"
flock 9 # of two who want it one builds it
if [[ ! -d $system ]]; then
    command -v mmdebstrap >/dev/null || skip "no mmdebstrap"
    echo "installing a Debian system, two minutes, once" >&2
    rm -rf "$folder"/debian-*
    sources=(/etc/apt/sources.list.d/*.sources)
    [[ -e ${sources[0]} ]] || sources=(/etc/apt/sources.list)
    log=$(mktemp)
    # What no kiosk's program reads stays away.
    mmdebstrap --variant=minbase --include="$(IFS=,; echo "${packages[*]}")" \
        --dpkgopt='path-exclude=/usr/share/doc/*' --dpkgopt='path-include=/usr/share/doc/autostereo/*' \
        --dpkgopt='path-exclude=/usr/share/man/*' --dpkgopt='path-exclude=/usr/share/locale/*' \
        "$suite" "$system.new" "${sources[@]}" >"$log" 2>&1 ||
        { tail -n 20 "$log" >&2; rm -rf "$system.new"; exit 1; }
    mv "$system.new" "$system"
fi
echo "$system"
