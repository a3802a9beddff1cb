#!/usr/bin/env bash
# The unit is understood by systemd, and its sandbox stays as tight as it is.
source "$(dirname "$0")/common.sh"

if ! command -v systemd-analyze >/dev/null; then
    echo "skipped: no systemd-analyze here (package systemd)"
    exit 77
fi
copies=$(mktemp -d)
trap 'rm -rf "$copies"' EXIT

# Tenths of systemd's exposure score, 0 (sealed) to 100; lower it when the unit gets tighter. An X
# server is root, at the hardware.
declare -A exposure=([autostereo]=17 [autostereo-xorg]=65)
count=0
for unit in systemd/*.service; do
    count=$((count + 1))
    copy=$copies/${unit##*/}
    # The program is not installed where the tests run.
    sed 's|^ExecStart=[^ ]*|ExecStart=/bin/true|' "$unit" >"$copy"
    # An unknown key is only a warning to systemd, and it warns about other units too.
    complaints=$(systemd-analyze verify --man=no "$copy" 2>&1 | grep -F "$copy") || true
    [[ -z $complaints ]] || problem "${complaints//"$copy"/"$unit"}"
    most=${exposure[$(basename "$unit" .service)]}
    systemd-analyze security --offline=true --threshold="$most" "$copy" >"$copies/report" ||
        problem "$unit: $(tail -n 1 "$copies/report"), more than $most tenths"
done
finish "units" $count
