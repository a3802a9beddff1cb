#!/usr/bin/env bash
# usage: package.sh BUILD_FOLDER
# The Debian package on a copy of this system (an overlay that vanishes): it installs, runs, keeps its
# configuration over an upgrade, and leaves nothing when it is purged.
set -euo pipefail
build=$(realpath "$1")
fail() { echo "package: $*" >&2; exit 1; }
skip() { echo "skipped: $*"; exit 77; }

if [[ ${2:-} != inside ]]; then
    ((EUID == 0)) || skip "only root can mount an overlay"
    command -v dpkg-shlibdeps >/dev/null || skip "no dpkg-dev here"
    unshare -m true 2>/dev/null || skip "no mount namespaces here"
    exec unshare -m "$0" "$1" inside
fi

base=$(mktemp -d)
trap 'umount -R "$base" 2>/dev/null; rmdir "$base"' EXIT
mount -t tmpfs autostereo-package "$base"
mkdir "$base"/{upper,work,root,debs}
for version in 1.0.0 1.1.0; do
    (cd "$base/debs" && cpack --config "$build/CPackConfig.cmake" -G DEB -R $version >"$base/cpack.log" 2>&1) ||
        { cat "$base/cpack.log"; fail "cpack makes none"; }
done
mount -t overlay overlay -o "lowerdir=/,upperdir=$base/upper,workdir=$base/work" "$base/root" ||
    skip "no overlay file system here"
mkdir -p "$base/root/debs"
cp "$base"/debs/*.deb "$base/root/debs/"
mount -t proc proc "$base/root/proc"
in_root() { chroot "$base/root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive "$@"; }
old=/debs/autostereo_1.0.0_amd64.deb new=/debs/autostereo_1.1.0_amd64.deb
settings=/etc/autostereo/autostereo.toml

in_root dpkg -i $old >/dev/null || fail "does not install"
for file in usr/bin/autostereo usr/lib/systemd/system/autostereo.service \
    usr/lib/udev/rules.d/70-autostereo.rules etc/autostereo/autostereo.toml \
    usr/libexec/autostereo/autostereo-oni-reader; do
    [[ -e $base/root/$file ]] || fail "no $file in it"
done
in_root systemctl is-enabled --quiet autostereo || fail "the service is not enabled"
in_root autostereo check $settings >/dev/null || fail "its configuration does not check"
in_root autostereo run --output offscreen --frames 3 --speed max --input 'sim:room?depth=176x144&color=320x240' \
    --snapshot /panel.png || fail "does not run"
[[ -s $base/root/panel.png ]] || fail "no picture"

printf '[picture]\nclear_color = [0, 0, 0.5]\n' >>"$base/root$settings"
in_root dpkg -i $new >/dev/null || fail "does not upgrade"
grep -q 'clear_color' "$base/root$settings" || fail "an upgrade loses the configuration"
[[ $(in_root dpkg-query -W -f '${Version}' autostereo) == 1.1.0 ]] || fail "the old version stays"
mkdir -p "$base/root/var/lib/private/autostereo"
in_root dpkg --purge autostereo >/dev/null || fail "cannot be purged"
left=$(find "$base/upper" -name '*autostereo*' ! -type c ! -path '*/debs/*' -printf '%P ')
[[ -z $left ]] || fail "a purge leaves $left"
echo "package: $(du -k "$base/root$old" | cut -f1) KiB; installed, ran, upgraded, purged"
