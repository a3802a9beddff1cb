#!/usr/bin/env bash
# usage: kiosk.sh BUILD_FOLDER xorg|cage [PICTURE]
# The package in a Debian system of its own that boots under systemd in a virtual machine (a user-mode
# kernel with a virtual monitor), with an X server or a Wayland compositor: see inspection.sh. PICTURE
# gets what the monitor showed (PNG). Exit code 77: no machine can be had here, why.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
build=$(realpath "$1")
fail() { echo "kiosk: $*" >&2; exit 1; }
guest=$here/../../device/guest
source "$guest/boot.sh"

AUTOSTEREO_GUEST=uml prepare_guest # a packaged kernel without KVM would boot for an hour
for version in 1.0.0 1.1.0; do
    (cd "$exchange" && cpack --config "$build/CPackConfig.cmake" -G DEB -R $version >cpack.log 2>&1) ||
        { cat "$exchange/cpack.log"; fail "cpack makes no package"; }
done
system=$("$here/build_system.sh" "$exchange/autostereo_1.0.0_amd64.deb") || required $?
echo "$2" >"$exchange/server"
cp "$build/tests/device/plugged_kinect2" "$here"/{install.sh,inspection.sh,autostereo.toml,small.toml} "$exchange"
install -m 755 "$here/init.sh" "$system/kiosk-init"
install -m 644 "$guest/overlay.sh" "$system/overlay.sh"

boot_guest 600 "$system" /kiosk-init >"$exchange/console.log" || true
cat "$exchange/inspection.log" 2>/dev/null || { cat "$exchange"/{install,console}.log; fail "it did not boot"; }
[[ $(tail -n 1 "$exchange/inspection.log") == passed ]] || fail "see above"

# What the monitor showed is, pixel for pixel, what is drawn where there is no monitor.
cd "$here"
"$build/daemon/autostereo" run --config autostereo.toml --output offscreen --frames 9 --speed max \
    --snapshot "$exchange/panel.png" >/dev/null 2>&1 || fail "does not draw off-screen"
raw() { ffmpeg -v error -i "$1" -f rawvideo -pix_fmt rgb24 -; }
for shot in "$exchange"/{boot,opened}.{xwd,png}; do
    [[ ! -e $shot ]] || cmp <(raw "$exchange/panel.png") <(raw "$shot") ||
        fail "the monitor showed another picture ($(basename "$shot"))"
done
[[ -z ${3:-} ]] || ffmpeg -v error -y -i "$exchange"/boot.* "$3"
echo "kiosk: the monitor showed the right picture"
